//! Files that are written while the run goes on.

use std::thread::{self, JoinHandle};

use super::Error;

/// At most one file on its way, packed and written by a thread of its own.
#[derive(Debug, Default)]
pub(super) struct Behind(Option<JoinHandle<Result<(), Error>>>);

impl Behind {
    /// Begins to write a file, once the one before it is there.
    ///
    /// # Errors
    /// If the one before could not be written.
    pub(super) fn write(
        &mut self,
        file: impl FnOnce() -> Result<(), Error> + Send + 'static,
    ) -> Result<(), Error> {
        self.wait()?;
        self.0 = Some(thread::spawn(file));
        Ok(())
    }

    /// Waits until the file is there.
    ///
    /// # Errors
    /// If it could not be written.
    pub(super) fn wait(&mut self) -> Result<(), Error> {
        match self.0.take().map(JoinHandle::join) {
            None => Ok(()),
            Some(Ok(written)) => written,
            Some(Err(panic)) => std::panic::resume_unwind(panic),
        }
    }
}

impl Drop for Behind {
    /// A folder that is given up keeps what it began to write.
    fn drop(&mut self) {
        if let Some(file) = self.0.take() {
            // Whoever gives it up has an error of its own.
            let _ = file.join();
        }
    }
}

#[cfg(test)]
mod tests {
    use std::path::PathBuf;

    use super::{Behind, Error};
    use crate::output::file;

    fn refused() -> Error {
        let why = "a disk that is full";
        Error::NoCheckpoint { dir: PathBuf::from("somewhere"), why }
    }

    /// One that cannot be written is told to who writes the next one, or waits; files come in turn.
    #[test]
    fn what_fails_is_told_to_whoever_comes_next() {
        let mut behind = Behind::default();
        behind.wait().unwrap();
        behind.write(|| Err(refused())).unwrap();
        assert!(behind.write(|| panic!("it is not begun")).is_err());
        behind.write(|| Err(refused())).unwrap();
        assert!(behind.wait().is_err());
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("one");
        let (first, second) = (path.clone(), path.clone());
        behind.write(move || file::write_whole(&first, b"1")).unwrap();
        behind.write(move || file::write_whole(&second, b"2")).unwrap();
        drop(behind);
        assert_eq!(std::fs::read_to_string(path).unwrap(), "2");
    }
}
