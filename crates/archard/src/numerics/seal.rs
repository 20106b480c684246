//! Bytes that end with a hash of themselves (BLAKE3), so that damage shows.

/// Adds the hash of all bytes behind them.
pub fn seal(bytes: &mut Vec<u8>) {
    let hash = blake3::hash(bytes);
    bytes.extend_from_slice(hash.as_bytes());
}

/// The bytes before the hash; `None` where it is not theirs.
pub fn unseal(bytes: &[u8]) -> Option<&[u8]> {
    let (content, hash) = bytes.split_last_chunk::<{ blake3::OUT_LEN }>()?;
    (blake3::hash(content) == *hash).then_some(content)
}

#[cfg(test)]
mod tests {
    use super::{seal, unseal};

    #[test]
    fn what_is_damaged_is_not_unsealed() {
        let mut bytes = b"numbers".to_vec();
        seal(&mut bytes);
        assert_eq!(unseal(&bytes), Some(&b"numbers"[..]));
        for at in 0..bytes.len() {
            assert_eq!(unseal(&bytes[..at]), None, "{at} bytes");
            let mut damaged = bytes.clone();
            damaged[at] ^= 1;
            assert_eq!(unseal(&damaged), None, "byte {at}");
        }
    }
}
