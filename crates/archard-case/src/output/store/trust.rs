//! Whose files are read: a compliance that somebody else has written may be anything.
//!
//! A folder, and a file in it, is trusted if it belongs to the user or to the system's administrator and nobody else may
//! write to it. Where files have no owners and modes, all are.

use std::fs::{File, Metadata};
use std::io::{self, Read};
use std::path::Path;

/// Why a file or folder is not trusted.
pub(super) type Doubt = &'static str;

/// The content of a file of that length (bytes), if there is one; or why it is not trusted.
pub(super) fn read(path: &Path, length: usize) -> Result<Option<Vec<u8>>, Doubt> {
    if !std::fs::symlink_metadata(path).is_ok_and(|known| known.is_file()) {
        return Ok(None);
    }
    let Ok(mut file) = File::open(path) else { return Ok(None) };
    let Ok(known) = file.metadata() else { return Ok(None) };
    if !known.is_file() || known.len() != length as u64 {
        return Ok(None);
    }
    doubt(&known)?;
    let mut bytes = Vec::with_capacity(length);
    // It may still grow while it is read.
    let whole = file.by_ref().take(length as u64).read_to_end(&mut bytes);
    Ok(whole.is_ok_and(|read| read == length).then_some(bytes))
}

/// Says whether a folder is trusted; one that is not there yet is.
pub(super) fn folder(path: &Path) -> Result<(), Doubt> {
    match std::fs::metadata(path) {
        Ok(known) => doubt(&known),
        Err(_) => Ok(()),
    }
}

/// Makes a folder for the user alone.
pub(super) fn make(path: &Path) -> io::Result<()> {
    let mut builder = std::fs::DirBuilder::new();
    builder.recursive(true);
    #[cfg(unix)]
    std::os::unix::fs::DirBuilderExt::mode(&mut builder, 0o700);
    builder.create(path)
}

/// Whether a process is known to be gone.
pub(super) fn gone(process: u32) -> bool {
    let processes = Path::new("/proc");
    processes.join("self").exists() && !processes.join(process.to_string()).exists()
}

#[cfg(unix)]
fn doubt(known: &Metadata) -> Result<(), Doubt> {
    use std::os::unix::fs::MetadataExt;
    let foreign = |user: u32| known.uid() != user && known.uid() != 0;
    if user().is_some_and(foreign) {
        Err("belongs to another user")
    } else if known.mode() & 0o022 != 0 {
        Err("may be written by other users (`chmod go-w` changes that)")
    } else {
        Ok(())
    }
}

#[cfg(not(unix))]
fn doubt(_known: &Metadata) -> Result<(), Doubt> {
    Ok(())
}

/// The user this process acts for, where the system shows processes as files.
#[cfg(unix)]
fn user() -> Option<u32> {
    std::fs::metadata("/proc/self").ok().map(|known| std::os::unix::fs::MetadataExt::uid(&known))
}

#[cfg(all(test, unix))]
mod tests {
    use std::fs::{self, Permissions};
    use std::os::unix::fs::PermissionsExt;

    use super::{folder, make, read};

    #[test]
    fn what_others_may_write_is_not_read() {
        let dir = tempfile::tempdir().unwrap();
        let [kept, path] = [dir.path().join("kept"), dir.path().join("kept/file")];
        assert!(folder(&kept).is_ok());
        make(&kept).unwrap();
        assert_eq!(fs::metadata(&kept).unwrap().permissions().mode() & 0o777, 0o700);
        fs::write(&path, "four").unwrap();
        for (mode, trusted) in [(0o644, true), (0o600, true), (0o664, false), (0o602, false)] {
            fs::set_permissions(&path, Permissions::from_mode(mode)).unwrap();
            assert_eq!(read(&path, 4).is_ok(), trusted, "{mode:o}");
        }
        fs::set_permissions(&path, Permissions::from_mode(0o600)).unwrap();
        assert_eq!(read(&path, 4), Ok(Some(b"four".to_vec())));
        assert_eq!(read(&path, 5), Ok(None));
        fs::set_permissions(&kept, Permissions::from_mode(0o770)).unwrap();
        assert!(folder(&kept).is_err());
    }

    #[test]
    fn a_link_is_not_read() {
        let dir = tempfile::tempdir().unwrap();
        let [file, link] = ["file", "link"].map(|name| dir.path().join(name));
        fs::write(&file, "four").unwrap();
        std::os::unix::fs::symlink(&file, &link).unwrap();
        assert_eq!(read(&link, 4), Ok(None));
    }
}
