//! Rows whose contact outgrows the frame: they run again on a larger one.
//!
//! A study that leaves them out has bands that are too narrow, since it is the rows that wear most. The case of a row in its
//! folder says which frame it has.

use std::path::Path;

use archard::case::Resolved;

use super::design::{Design, Row};
use super::row;

/// Times a frame is enlarged.
const MOST: usize = 4;

impl Design {
    /// Takes some of the rows to the frames that they have in their folders.
    ///
    /// # Errors
    /// If a folder holds another case.
    pub fn take_up(&mut self, study: &Path, rows: &[usize]) -> Result<(), String> {
        let grows = self.grows();
        for &index in rows {
            let row = &mut self.rows[index];
            let dir = row::folder(study, index);
            let is_own = |row: &Row| !row::holds_another(&dir, &row.resolved);
            if is_own(row) {
                continue;
            }
            let mut larger = row.clone();
            let found = grows && (0..MOST).any(|_| larger.enlarge() && is_own(&larger));
            if !found {
                return Err(format!("`{}` holds another case", dir.display()));
            }
            *row = larger;
        }
        Ok(())
    }

    /// Enlarges the frames of those of the rows whose contact outgrew theirs, and returns them.
    pub fn enlarge(&mut self, study: &Path, rows: &[usize]) -> Vec<usize> {
        if !self.grows() {
            return vec![];
        }
        let outgrown = |index: &usize| {
            let row = &mut self.rows[*index];
            let dir = row::folder(study, *index);
            outgrew(&dir, &row.resolved) && row.frames < MOST && row.enlarge()
        };
        rows.iter().copied().filter(outgrown).collect()
    }

    /// Whether rows may have other frames than the case says: a study of frames has the frames it asks for.
    fn grows(&self) -> bool {
        !self.keys.iter().any(|key| key == "frame" || key.starts_with("frame."))
    }
}

impl Row {
    /// Puts the row on a larger frame, where it can be.
    fn enlarge(&mut self) -> bool {
        let larger = self.resolved.on_a_larger_frame();
        if let Some(larger) = larger {
            (*self.resolved, self.frames) = (larger, self.frames + 1);
            return true;
        }
        false
    }
}

/// Whether the results of a case were pressed against the edge of its frame.
fn outgrew(dir: &Path, resolved: &Resolved) -> bool {
    if row::holds_another(dir, resolved) {
        return false;
    }
    let summary = row::summary(dir).unwrap_or_default();
    summary["verdict"]["outgrown"] == true
}
