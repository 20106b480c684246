//! What a file holds, and what was made of it.

use std::any::Any;
use std::fmt;
use std::ops::Deref;
use std::sync::{Arc, OnceLock};

/// The bytes of a file. Clones share them, and what is parsed from them.
#[derive(Clone)]
pub struct Bytes(Arc<Shared>);

struct Shared {
    bytes: Vec<u8>,
    parsed: OnceLock<Box<dyn Any + Send + Sync>>,
}

impl Bytes {
    /// What something makes of the bytes, made once.
    pub fn parsed<T: Any + Clone + Send + Sync>(&self, make: impl Fn(&[u8]) -> T) -> T {
        let parsed = self.0.parsed.get_or_init(|| Box::new(make(&self.0.bytes)));
        // Made to something else before.
        parsed.downcast_ref().cloned().unwrap_or_else(|| make(&self.0.bytes))
    }
}

impl From<Vec<u8>> for Bytes {
    fn from(bytes: Vec<u8>) -> Self {
        Self(Arc::new(Shared { bytes, parsed: OnceLock::new() }))
    }
}

impl Deref for Bytes {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        &self.0.bytes
    }
}

impl PartialEq for Bytes {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0) || self.0.bytes == other.0.bytes
    }
}

impl fmt::Debug for Bytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.bytes.fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use std::cell::Cell;

    use super::Bytes;

    #[test]
    fn clones_are_parsed_once() {
        let times = Cell::new(0);
        let length = |bytes: &[u8]| {
            times.set(times.get() + 1);
            bytes.len()
        };
        let bytes = Bytes::from(vec![1, 2, 3]);
        assert_eq!([bytes.parsed(length), bytes.clone().parsed(length)], [3, 3]);
        assert_eq!(times.get(), 1);
        assert_eq!(bytes.parsed(|bytes| bytes.to_vec()), [1, 2, 3]);
        assert_eq!(bytes, Bytes::from(vec![1, 2, 3]));
    }
}
