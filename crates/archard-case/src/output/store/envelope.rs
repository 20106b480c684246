//! Numbers in a file that says what they are.
//!
//! A file is a line that names the format and its version, the key of what is kept, how many numbers follow, the numbers
//! and a checksum of all before it. The key is a hash of all that the numbers follow from.

use archard::numerics::seal::{seal, unseal};
use blake3::OUT_LEN;

/// What a file has to say about itself.
#[derive(Debug, Clone, Copy)]
pub(super) struct Envelope {
    /// The line it begins with.
    pub(super) format: &'static [u8],
    /// The key of what is kept.
    pub(super) key: [u8; OUT_LEN],
    /// How many numbers there are.
    pub(super) count: usize,
}

impl Envelope {
    /// Length of the file (bytes); `None` beyond what can be counted.
    pub(super) fn length(&self) -> Option<usize> {
        self.count.checked_mul(8)?.checked_add(self.format.len() + 2 * OUT_LEN + 8)
    }

    /// A file of these numbers.
    pub(super) fn seal(&self, numbers: impl Iterator<Item = f64>) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(self.length().unwrap_or_default());
        bytes.extend_from_slice(self.format);
        bytes.extend_from_slice(&self.key);
        bytes.extend_from_slice(&(self.count as u64).to_le_bytes());
        numbers.for_each(|number| bytes.extend_from_slice(&number.to_le_bytes()));
        seal(&mut bytes);
        bytes
    }

    /// The numbers in a file, as bytes, if it is sound and says all this.
    pub(super) fn open<'a>(&self, bytes: &'a [u8]) -> Option<&'a [[u8; 8]]> {
        if self.length()? != bytes.len() {
            return None;
        }
        let content = bytes.get(..bytes.len() - OUT_LEN)?;
        let rest = content.strip_prefix(self.format)?.strip_prefix(&self.key)?;
        let (numbers, []) = rest.as_chunks::<8>() else { return None };
        let (count, numbers) = numbers.split_first()?;
        let told = u64::from_le_bytes(*count) == self.count as u64 && numbers.len() == self.count;
        (told && unseal(bytes).is_some()).then_some(numbers)
    }
}

#[cfg(test)]
mod tests {
    use super::{Envelope, OUT_LEN};

    #[test]
    fn what_is_sealed_is_opened_and_nothing_else() {
        let numbers = [1e-7, -2.0 / 3.0, 0.0];
        let envelope = Envelope { format: b"numbers 1\n", key: [7; OUT_LEN], count: 3 };
        let bytes = envelope.seal(numbers.into_iter());
        assert_eq!(Some(bytes.len()), envelope.length());
        let opened: Vec<f64> =
            envelope.open(&bytes).unwrap().iter().map(|bytes| f64::from_le_bytes(*bytes)).collect();
        assert_eq!(opened, numbers);
        for other in [
            Envelope { key: [8; OUT_LEN], ..envelope },
            Envelope { format: b"numbers 2\n", ..envelope },
            Envelope { count: 2, ..envelope },
            Envelope { count: usize::MAX, ..envelope },
        ] {
            assert!(other.open(&bytes).is_none(), "{other:?}");
        }
        for cut in 0..bytes.len() {
            assert!(envelope.open(&bytes[..cut]).is_none(), "{cut} of {} bytes", bytes.len());
        }
        for at in 0..bytes.len() {
            let mut damaged = bytes.clone();
            damaged[at] ^= 1;
            assert!(envelope.open(&damaged).is_none(), "byte {at}");
        }
    }

    /// A file with a sound checksum and another number of numbers, as a forger writes it.
    #[test]
    fn another_size_is_refused_whatever_its_checksum() {
        let envelope = Envelope { format: b"numbers 1\n", key: [7; OUT_LEN], count: 3 };
        for count in [0, 1, 2, 4, 100] {
            let forged = Envelope { count, ..envelope }.seal(std::iter::repeat_n(0.5, count));
            assert!(envelope.open(&forged).is_none(), "{count}");
            let lying = Envelope { count: 3, ..envelope }.seal(std::iter::repeat_n(0.5, count));
            assert!(envelope.open(&lying).is_none(), "{count}");
        }
    }
}
