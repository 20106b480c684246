//! The largest file this process may write.
//!
//! A system that limits the size of files ends a process that writes beyond it by a signal (`SIGXFSZ`, setrlimit(2)),
//! before it can say what was lost. So the limit is read once, from `/proc/self/limits` where there is one, and
//! a write beyond it is an error like that of a full disk.

use std::fs;
use std::io;
use std::sync::OnceLock;

/// Says whether a file may become that long (bytes).
pub(super) fn admit(length: u64) -> io::Result<()> {
    static LARGEST: OnceLock<u64> = OnceLock::new();
    let largest = *LARGEST.get_or_init(|| {
        let limits = fs::read_to_string("/proc/self/limits").unwrap_or_default();
        soft(&limits).unwrap_or(u64::MAX)
    });
    if length <= largest {
        return Ok(());
    }
    let message = format!("files may have {largest} bytes here (`ulimit -f`)");
    Err(io::Error::new(io::ErrorKind::FileTooLarge, message))
}

/// The soft limit (bytes) in a table of limits; `None` where there is no limit.
fn soft(limits: &str) -> Option<u64> {
    let line = limits.lines().find_map(|line| line.strip_prefix("Max file size"))?;
    line.split_whitespace().next()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::soft;

    /// As proc(5) shows the table.
    #[test]
    fn the_soft_limit_is_read() {
        let table = |size: &str| {
            format!(
                "Limit          Soft Limit   Hard Limit   Units\n\
                 Max cpu time   unlimited    unlimited    seconds\n\
                 Max file size  {size}       unlimited    bytes\n"
            )
        };
        assert_eq!(soft(&table("51200")), Some(51200));
        assert_eq!(soft(&table("unlimited")), None);
        assert_eq!(soft(""), None);
    }
}
