//! Files that are whole or not there.
//!
//! A file is written next to its place under a name of its own, `NAME.PROCESS.NUMBER.part`, brought to the disk and
//! then moved to its place. No reader finds half of it, also after a power cut, and two writers never share a part.

use std::ffi::OsStr;
use std::fs::{self, File, OpenOptions};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

use super::{Error, limit};

/// How the name of a part ends.
const PART: &str = ".part";
/// Number of the next part of this process.
static NEXT: AtomicUsize = AtomicUsize::new(0);

/// Writes a file so that it is whole or not there; what stands in its place is replaced, a link too.
///
/// # Errors
/// If it cannot be written.
pub(super) fn write_whole(path: &Path, content: &[u8]) -> Result<(), Error> {
    write_by(path, content, OpenOptions::new())
}

/// The same for a file that only the user may read and write.
pub(super) fn write_private(path: &Path, content: &[u8]) -> Result<(), Error> {
    #[allow(unused_mut)]
    let mut options = OpenOptions::new();
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::mode(&mut options, 0o600);
    write_by(path, content, options)
}

/// Removes a file, if it is there.
pub(super) fn remove(path: &Path) -> Result<(), Error> {
    match fs::remove_file(path) {
        Err(source) if source.kind() != io::ErrorKind::NotFound => {
            Err(Error::Write { path: path.to_owned(), source })
        }
        _ => Ok(()),
    }
}

fn write_by(path: &Path, content: &[u8], mut options: OpenOptions) -> Result<(), Error> {
    let part = part(path);
    let written = limit::admit(content.len() as u64)
        .and_then(|()| options.write(true).create_new(true).open(&part))
        .and_then(|file| fill(file, content))
        .and_then(|()| fs::rename(&part, path));
    written.map_err(|source| {
        // What is left of it would only take room; it may never have been made.
        let _ = fs::remove_file(&part);
        Error::Write { path: path.to_owned(), source }
    })
}

fn fill(mut file: File, content: &[u8]) -> io::Result<()> {
    file.write_all(content)?;
    file.sync_all()
}

/// A name besides a path that no other writer has.
fn part(path: &Path) -> PathBuf {
    let mut name = path.as_os_str().to_owned();
    let number = NEXT.fetch_add(1, Ordering::Relaxed);
    name.push(format!(".{}.{number}{PART}", std::process::id()));
    name.into()
}

/// The file that a part is of and the process that wrote it, if that is the name of one.
fn writer(name: &OsStr) -> Option<(&str, u32)> {
    let (rest, number) = name.to_str()?.strip_suffix(PART)?.rsplit_once('.')?;
    let (whole, process) = rest.rsplit_once('.')?;
    number.parse::<usize>().ok()?;
    Some((whole, process.parse().ok()?))
}

/// Removes the parts of some files in a folder whose writer is gone, as far as that can be done.
pub(super) fn remove_parts(folder: &Path, gone: impl Fn(u32) -> bool, of: impl Fn(&str) -> bool) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for entry in entries.flatten() {
        if writer(&entry.file_name()).is_some_and(|(whole, process)| of(whole) && gone(process)) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

#[cfg(test)]
mod tests {
    use std::ffi::OsStr;
    use std::fs;

    use super::{part, remove_parts, write_whole, writer};

    #[test]
    fn parts_have_names_of_their_own_and_are_known_again() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("summary.json");
        let parts = [part(&path), part(&path)];
        assert_ne!(parts[0], parts[1]);
        for part in &parts {
            let own = Some(("summary.json", std::process::id()));
            assert_eq!(writer(part.file_name().unwrap()), own);
            fs::write(part, "half").unwrap();
        }
        for other in ["notes.part", "my.2.part", "summary.json", "a.b.2.part", "a.1.2.parts"] {
            assert_eq!(writer(OsStr::new(other)), None, "{other}");
        }
        fs::write(folder.path().join("notes.part"), "mine").unwrap();
        remove_parts(folder.path(), |_| false, |_| true);
        remove_parts(folder.path(), |_| true, |whole| whole != "summary.json");
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 3);
        remove_parts(folder.path(), |process| process == std::process::id(), |_| true);
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    /// A link in the place of a file is replaced; what it points at is left alone.
    #[cfg(unix)]
    #[test]
    fn links_are_not_followed() {
        let folder = tempfile::tempdir().unwrap();
        let [other, path] = ["other", "summary.json"].map(|name| folder.path().join(name));
        fs::write(&other, "mine").unwrap();
        std::os::unix::fs::symlink(&other, &path).unwrap();
        write_whole(&path, b"new").unwrap();
        assert_eq!(fs::read_to_string(&other).unwrap(), "mine");
        assert_eq!(fs::read_to_string(&path).unwrap(), "new");
        assert!(fs::symlink_metadata(&path).unwrap().is_file());
    }
}
