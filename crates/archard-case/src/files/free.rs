//! How much memory a process may still take: what the machine has free and what limits leave of it.
//!
//! Linux says so in files: `MemAvailable` of `/proc/meminfo`; the limit and the use of each control group the
//! process is in, of both versions (`memory.max` and `memory.current`, `memory.limit_in_bytes` and
//! `memory.usage_in_bytes`; Linux kernel documentation, "Control Group v2" and "Memory Resource Controller"); and
//! the limit of the address space, `ulimit -v`, in `/proc/self/limits` (proc(5)). The least of them counts.

use std::fs;
use std::num::NonZero;
use std::path::Path;
use std::thread::available_parallelism;

/// Memory (bytes) taken for free where the system does not say.
const UNKNOWN: f64 = 16e9;
/// Share of what a limit leaves that is taken for free: beyond it a process is ended, and estimates are off by up
/// to a tenth.
const SURE: f64 = 0.9;
/// Addresses (bytes) a thread reserves when it starts: its stack of 2 MiB and the 64 MiB of glibc's heap for it.
const OF_A_THREAD: f64 = 66.0 * 1048576.0;

/// Memory (bytes) that this process may still take: of what the machine has free and what its limits leave, the least.
pub fn free_memory() -> f64 {
    free(Path::new("/"), OF_A_THREAD)
}

/// The same for dense equations: each thread of their factorisation reserves twice the size of the processor's last
/// cache (of the products of `faer`): it uses little of it.
pub(crate) fn available_to_equations() -> f64 {
    let root = Path::new("/");
    free(root, OF_A_THREAD + 2.0 * last_cache(root))
}

/// What is free (bytes) where a thread reserves that many addresses.
fn free(root: &Path, of_a_thread: f64) -> f64 {
    let found = [machine(root), groups(root), addresses(root, of_a_thread)];
    found.into_iter().flatten().reduce(f64::min).unwrap_or(UNKNOWN)
}

/// The last cache of the processor (bytes).
fn last_cache(root: &Path) -> f64 {
    const USUAL: f64 = 64e6;
    let size = text(root, "sys/devices/system/cpu/cpu0/cache/index3/size");
    let kilobytes = size.and_then(|size| size.trim().strip_suffix('K')?.parse::<f64>().ok());
    kilobytes.map_or(USUAL, |kilobytes| 1024.0 * kilobytes)
}

/// The text of a file under the root of a file system.
fn text(root: &Path, path: &str) -> Option<String> {
    fs::read_to_string(root.join(path.trim_start_matches('/'))).ok()
}

/// The number (bytes) behind a word of `/proc`, there in kilobytes: "MemAvailable:   12345 kB".
fn kilobytes(text: &str, word: &str) -> Option<f64> {
    let line = text.lines().find_map(|line| line.strip_prefix(word))?;
    let kilobytes: f64 = line.split_whitespace().next()?.parse().ok()?;
    Some(1024.0 * kilobytes)
}

/// What the machine has free (bytes).
fn machine(root: &Path) -> Option<f64> {
    kilobytes(&text(root, "proc/meminfo")?, "MemAvailable:")
}

/// What the limit of the address space leaves (bytes) where a thread reserves that many.
fn addresses(root: &Path, of_a_thread: f64) -> Option<f64> {
    let limits = text(root, "proc/self/limits")?;
    let line = limits.lines().find_map(|line| line.strip_prefix("Max address space"))?;
    let limit: f64 = line.split_whitespace().next()?.parse().ok()?;
    let taken = kilobytes(&text(root, "proc/self/status")?, "VmSize:").unwrap_or(0.0);
    let left = SURE * (limit - taken).max(0.0);
    let threads = available_parallelism().map_or(1, NonZero::get) as f64;
    let heaps = (threads * OF_A_THREAD).min(0.5 * left);
    // A thread that finds no addresses for a heap of its own shares another's; what else it reserves it needs.
    Some((left - heaps - threads * (of_a_thread - OF_A_THREAD)).max(0.0))
}

/// A version of control groups: where groups are, and what their files are called.
struct Version {
    folder: &'static str,
    limit: &'static str,
    usage: &'static str,
    /// Words of `memory.stat` before the bytes of cached files, which the system takes back when it needs them.
    cached: [&'static str; 2],
}

const FIRST: Version = Version {
    folder: "sys/fs/cgroup/memory",
    limit: "memory.limit_in_bytes",
    usage: "memory.usage_in_bytes",
    cached: ["total_inactive_file ", "total_active_file "],
};
const SECOND: Version = Version {
    folder: "sys/fs/cgroup",
    limit: "memory.max",
    usage: "memory.current",
    cached: ["inactive_file ", "active_file "],
};

/// What the control groups of the process leave (bytes), each and those it is in.
fn groups(root: &Path) -> Option<f64> {
    let own = text(root, "proc/self/cgroup")?;
    let left = own.lines().filter_map(|line| {
        let mut parts = line.splitn(3, ':');
        let (number, controllers, path) = (parts.next()?, parts.next()?, parts.next()?);
        let version = match number {
            "0" => SECOND,
            _ if controllers.split(',').any(|one| one == "memory") => FIRST,
            _ => return None,
        };
        // Within a container the path may be that of the host, and its root the group itself.
        let above = Path::new(path).ancestors().filter_map(|group| version.left(root, group));
        above.reduce(f64::min)
    });
    left.reduce(f64::min)
}

impl Version {
    /// What a group leaves (bytes); `None` where it has no limit.
    fn left(&self, root: &Path, group: &Path) -> Option<f64> {
        let group = group.strip_prefix("/").unwrap_or(group);
        let folder = root.join(self.folder).join(group);
        let number = |name: &str| fs::read_to_string(folder.join(name)).ok()?.trim().parse().ok();
        let limit: f64 = number(self.limit)?;
        let usage: f64 = number(self.usage).unwrap_or(0.0);
        let stat = fs::read_to_string(folder.join("memory.stat")).unwrap_or_default();
        let cached = |word: &str| {
            let found = stat.lines().find_map(|line| line.strip_prefix(word));
            found.and_then(|bytes| bytes.trim().parse::<f64>().ok()).unwrap_or(0.0)
        };
        let used = (usage - self.cached.into_iter().map(cached).sum::<f64>()).max(0.0);
        Some(SURE * (limit - used).max(0.0))
    }
}

#[cfg(test)]
mod tests {
    use std::fs;
    use std::path::Path;

    use super::{OF_A_THREAD, addresses, groups, last_cache, machine};

    /// A file system with these files.
    fn system(files: &[(&str, &str)]) -> tempfile::TempDir {
        let root = tempfile::tempdir().unwrap();
        for (path, text) in files {
            let path = root.path().join(path);
            fs::create_dir_all(path.parent().unwrap()).unwrap();
            fs::write(path, text).unwrap();
        }
        root
    }

    #[test]
    fn free_memory_is_read() {
        let text = "MemTotal:       24537084 kB\nMemFree: 1 kB\nMemAvailable:   23000000 kB\n";
        assert_eq!(machine(system(&[("proc/meminfo", text)]).path()), Some(23000000.0 * 1024.0));
        assert_eq!(machine(system(&[("proc/meminfo", "MemTotal: 1 kB\n")]).path()), None);
        assert_eq!(machine(Path::new("/nowhere")), None);
    }

    /// The group above has the tighter limit; what cached files take of it can be had back.
    #[test]
    fn the_tightest_group_counts() {
        let second = system(&[
            ("proc/self/cgroup", "0::/user.slice/job\n"),
            ("sys/fs/cgroup/user.slice/job/memory.max", "max\n"),
            ("sys/fs/cgroup/user.slice/job/memory.current", "1000\n"),
            ("sys/fs/cgroup/user.slice/memory.max", "10000\n"),
            ("sys/fs/cgroup/user.slice/memory.current", "5000\n"),
            (
                "sys/fs/cgroup/user.slice/memory.stat",
                "anon 2\ninactive_file 700\nactive_file 300\n",
            ),
        ]);
        assert_eq!(groups(second.path()), Some(0.9 * 6000.0));
        let first = system(&[
            ("proc/self/cgroup", "9:name=systemd:/\n4:cpu,memory:/docker/1f\n0::/\n"),
            ("sys/fs/cgroup/memory/memory.limit_in_bytes", "8000\n"),
            ("sys/fs/cgroup/memory/memory.usage_in_bytes", "3000\n"),
            ("sys/fs/cgroup/memory/memory.stat", "inactive_file 9\ntotal_inactive_file 1000\n"),
        ]);
        assert_eq!(groups(first.path()), Some(0.9 * 6000.0));
        assert_eq!(groups(system(&[("proc/self/cgroup", "0::/\n")]).path()), None);
    }

    #[test]
    fn the_address_space_is_read() {
        let limits = |limit: &str| {
            let limits =
                format!("Limit   Soft Limit  Hard Limit\nMax address space  {limit}  bytes\n");
            let status = "Name: archard\nVmSize:\t    1000 kB\n";
            let files = [("proc/self/limits", &*limits), ("proc/self/status", status)];
            addresses(system(&files).path(), OF_A_THREAD)
        };
        assert_eq!(limits("unlimited    unlimited"), None);
        let left = limits("1024001024000  unlimited").unwrap();
        assert!(left < 0.9 * 1024e9 && left > 0.4 * 1024e9, "{left}");
        assert_eq!(limits("1000  unlimited"), Some(0.0));
        let cache = system(&[("sys/devices/system/cpu/cpu0/cache/index3/size", "32768K\n")]);
        assert_eq!(last_cache(cache.path()), 32768.0 * 1024.0);
    }
}
