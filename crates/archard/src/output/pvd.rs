//! The collection file that gives ParaView the progress of each output.

use std::fmt::Write;

/// The collection of these outputs, each a progress and a file relative to the collection.
pub(super) fn collection(outputs: &[(f64, String)]) -> String {
    let mut text = String::from(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n  <Collection>\n",
    );
    for (progress, file) in outputs {
        // Writing to a String cannot fail.
        let _ = writeln!(text, "    <DataSet timestep=\"{progress:?}\" file=\"{file}\"/>");
    }
    text + "  </Collection>\n</VTKFile>\n"
}
