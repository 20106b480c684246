//! Files of the user's that a command reads, which it must not write over.

use std::fs;
use std::path::{Path, PathBuf};

/// What is the same for all names of a file: device and inode, where the system has them.
#[cfg(unix)]
type Identity = (u64, u64);
#[cfg(not(unix))]
type Identity = PathBuf;

#[cfg(unix)]
fn identity(path: &Path) -> Option<Identity> {
    use std::os::unix::fs::MetadataExt;
    fs::metadata(path).ok().map(|known| (known.dev(), known.ino()))
}

#[cfg(not(unix))]
fn identity(path: &Path) -> Option<Identity> {
    fs::canonicalize(path).ok()
}

/// The inputs of a command.
#[derive(Debug, Clone, Default)]
pub struct Inputs(Vec<(Identity, PathBuf)>);

impl Inputs {
    /// Those of these paths that exist.
    pub fn of(paths: impl IntoIterator<Item = PathBuf>) -> Self {
        Self(paths.into_iter().filter_map(|path| Some((identity(&path)?, path))).collect())
    }

    /// Whether a path leads to one of them, through links and under other names too.
    pub fn has(&self, path: &Path) -> bool {
        !self.0.is_empty()
            && identity(path).is_some_and(|own| self.0.iter().any(|(known, _)| *known == own))
    }

    /// Their paths.
    pub fn paths(&self) -> impl Iterator<Item = &Path> {
        self.0.iter().map(|(_, path)| &**path)
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::Inputs;

    /// A file is known under every name of its own; another one of the same content is not.
    #[test]
    fn an_input_is_known_by_all_its_names() {
        let dir = tempfile::tempdir().unwrap();
        let [one, hard, soft, other, folder] =
            ["one", "hard", "soft", "other", "in"].map(|name| dir.path().join(name));
        fs::write(&one, "1").unwrap();
        fs::write(&other, "1").unwrap();
        fs::create_dir(&folder).unwrap();
        let inputs = Inputs::of([one.clone(), dir.path().join("none")]);
        assert!(inputs.has(&one) && inputs.has(&folder.join("../one")));
        assert!(!inputs.has(&other) && !inputs.has(&dir.path().join("none")));
        assert!(inputs.paths().eq([&*one]));
        #[cfg(unix)]
        {
            fs::hard_link(&one, &hard).unwrap();
            std::os::unix::fs::symlink(&one, &soft).unwrap();
            assert!(inputs.has(&hard) && inputs.has(&soft));
        }
        let _ = (hard, soft);
    }
}
