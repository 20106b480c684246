//! Published cases with the frames and steps that tests count on: what is published takes an accuracy in their place.

use std::path::{Path, PathBuf};

/// The folder of a case: with a frame, where the published one has none.
pub fn folder(name: &str) -> PathBuf {
    let crates = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let framed = crates.join("archard-case/tests/framed").join(name);
    if framed.is_dir() { framed } else { crates.join("../cases").join(name) }
}
