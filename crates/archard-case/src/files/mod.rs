//! Files of the user's, read whole: cases, tables, meshes, measured surfaces, checkpoints, results.
//!
//! Only plain files are read. Reading from a named pipe waits for a writer that may never come, and a device may have
//! no end; both are refused before they are opened, as a folder is. A file that leaves no memory for what is made of it
//! is refused before it is read.

mod free;
mod inputs;

use std::fs::{self, File, FileType};
use std::io::{self, ErrorKind, Read};
use std::path::Path;

pub(crate) use free::available_to_equations;
pub use free::free_memory;
pub use inputs::Inputs;

/// What a file holds, by which it takes more memory than bytes on the disk.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Contents {
    /// A text that is taken apart: a cell of three characters and its comma becomes a `String` of 24 bytes and a piece
    /// of memory for its characters, of 32 bytes at least in common allocators.
    Text,
    /// Numbers as they are in memory, which are there twice while they are taken over.
    Numbers,
}

impl Contents {
    /// Memory that is taken for each byte of the file.
    fn times(self) -> f64 {
        match self {
            Contents::Text => (24.0 + 32.0) / 4.0,
            Contents::Numbers => 2.0,
        }
    }
}

/// The bytes of a file.
///
/// # Errors
/// If there is no such file, it is a folder, a pipe or a device, it is too large for the memory that is free,
/// or the system refuses to read it.
pub fn read(path: &Path, contents: Contents) -> io::Result<Vec<u8>> {
    let file = open(path)?;
    let length = file.metadata()?.len();
    read_up_to(file, length, free_memory() / contents.times())
}

/// A plain file, opened to be read.
pub(crate) fn open(path: &Path) -> io::Result<File> {
    // Opening a pipe would wait already.
    plain(fs::metadata(path)?.file_type())?;
    let file = File::open(path)?;
    plain(file.metadata()?.file_type())?;
    Ok(file)
}

/// The text of a file.
///
/// # Errors
/// As [`read`], and if it is not UTF-8.
pub fn read_text(path: &Path) -> io::Result<String> {
    String::from_utf8(read(path, Contents::Text)?).map_err(|error| {
        let at = error.utf8_error().valid_up_to();
        let message = format!("it is not text: byte {at} is no UTF-8; save it as UTF-8");
        io::Error::new(ErrorKind::InvalidData, message)
    })
}

/// Refuses what is no plain file, by its kind.
fn plain(kind: FileType) -> io::Result<()> {
    if kind.is_file() {
        return Ok(());
    }
    let message = format!("it is {}, and only a plain file is read", name(kind));
    Err(io::Error::new(ErrorKind::InvalidInput, message))
}

/// What people call a kind of file.
fn name(kind: FileType) -> &'static str {
    if kind.is_dir() {
        return "a folder";
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if kind.is_fifo() {
            return "a named pipe (FIFO)";
        }
        if kind.is_socket() {
            return "a socket";
        }
        if kind.is_char_device() || kind.is_block_device() {
            return "a device";
        }
    }
    "no plain file"
}

/// The bytes of a source of that length, which may grow while it is read, unless they are more than that many.
fn read_up_to(source: impl Read, length: u64, most: f64) -> io::Result<Vec<u8>> {
    let refused = || {
        let message = format!(
            "it has more than {:.0} MB, the most that the free memory leaves room for",
            1e-6 * most
        );
        io::Error::new(ErrorKind::FileTooLarge, message)
    };
    if length as f64 > most {
        return Err(refused());
    }
    let mut bytes = vec![];
    bytes.try_reserve_exact(length as usize).map_err(|_| refused())?;
    source.take((most as u64).saturating_add(1)).read_to_end(&mut bytes)?;
    if bytes.len() as f64 > most {
        return Err(refused());
    }
    Ok(bytes)
}

#[cfg(test)]
mod tests {
    use std::fs::{self, File};
    use std::io::ErrorKind;

    use super::{Contents, read, read_text, read_up_to};

    #[test]
    fn files_are_read_whole_and_links_to_them_too() {
        let dir = tempfile::tempdir().unwrap();
        let [file, none] = ["file", "none"].map(|name| dir.path().join(name));
        fs::write(&file, "4 mm\n").unwrap();
        assert_eq!(read(&file, Contents::Numbers).unwrap(), b"4 mm\n");
        assert_eq!(read(&none, Contents::Text).unwrap_err().kind(), ErrorKind::NotFound);
        fs::write(&file, b"4 \xb5m\n").unwrap();
        let error = read_text(&file).unwrap_err().to_string();
        assert!(error.contains("byte 2"), "{error}");
        #[cfg(unix)]
        {
            let link = dir.path().join("link");
            std::os::unix::fs::symlink(&file, &link).unwrap();
            assert_eq!(read(&link, Contents::Text).unwrap(), b"4 \xb5m\n");
        }
    }

    /// Whatever would wait for ever or has no end is refused by what it is.
    #[cfg(unix)]
    #[test]
    fn what_is_no_file_is_refused_by_its_kind() {
        let dir = tempfile::tempdir().unwrap();
        let pipe = dir.path().join("pipe");
        assert!(std::process::Command::new("mkfifo").arg(&pipe).status().unwrap().success());
        let socket = dir.path().join("socket");
        let _open = std::os::unix::net::UnixListener::bind(&socket).unwrap();
        for (path, kind) in [
            (dir.path(), "a folder"),
            (&pipe, "a named pipe"),
            (&socket, "a socket"),
            ("/dev/zero".as_ref(), "a device"),
        ] {
            let error = read(path, Contents::Text).unwrap_err().to_string();
            assert!(error.contains(kind), "{error}");
        }
    }

    /// A file of eight terabytes without content, and one that grows beyond what it was.
    #[test]
    fn what_finds_no_room_is_refused() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("huge");
        // Where the file system has no such files, there is nothing to refuse.
        if File::create(&path).unwrap().set_len(1 << 43).is_ok() {
            let error = read(&path, Contents::Numbers).unwrap_err();
            assert_eq!(error.kind(), ErrorKind::FileTooLarge, "{error}");
        }
        assert_eq!(read_up_to(&b"12345"[..], 3, 5.0).unwrap(), b"12345");
        assert!(read_up_to(&b"12345"[..], 3, 4.0).is_err());
    }
}
