//! The collection that gives ParaView the progress of each output.

use std::fmt::Write;
use std::io;
use std::path::Path;

use super::Kept;
use super::arrays::{END, attribute, elements, escape, number, opening, unescape};
use crate::output::manifest::is_within;
use crate::output::{Error, Place};

/// The outputs of a run, as kept in `fields.pvd` (a VTK collection).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Collection {
    /// How far the motion had come (SI) and the file of the fields, relative to the collection.
    pub outputs: Vec<(f64, String)>,
}

impl Collection {
    /// Writes a `.pvd` file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, place: &Place) -> Result<(), Error> {
        super::write(self, place)
    }

    /// Reads a `.pvd` file that [`Collection::write`] wrote.
    ///
    /// # Errors
    /// If the file cannot be read, is damaged or is written in another way.
    pub fn read(path: &Path) -> Result<Self, Error> {
        super::read(path)
    }
}

/// What VTK calls these files.
const KIND: &str = "Collection";
/// How the element of an output begins.
const OUTPUT: &str = "<DataSet ";

impl Kept for Collection {
    fn encode(&self) -> io::Result<Vec<u8>> {
        let mut text = opening(KIND, "") + &format!("  <{KIND}>\n");
        for (progress, file) in &self.outputs {
            let file = escape(file);
            // Writing to a String cannot fail.
            let _ = writeln!(text, "    {OUTPUT}timestep=\"{progress:?}\" file=\"{file}\"/>");
        }
        Ok((text + &format!("  </{KIND}>\n{END}")).into_bytes())
    }

    fn decode(bytes: &[u8]) -> Result<Self, String> {
        let text = str::from_utf8(bytes).map_err(|_| "it is not text")?;
        if !text.ends_with(END) {
            return Err("its end is missing".to_owned());
        }
        let output = |element: &str| {
            Ok((number(element, "timestep")?, unescape(attribute(element, "file")?)))
        };
        let outputs: Vec<(f64, String)> =
            elements(text, OUTPUT).map(output).collect::<Result<_, String>>()?;
        match outputs.iter().find(|(_, file)| !is_within(file)) {
            Some((_, file)) => Err(format!("`{file}` lies outside of its folder")),
            None => Ok(Self { outputs }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Collection, Kept};

    #[test]
    fn what_is_written_is_read() {
        let outputs = [(0.0, "fields/0000.vti"), (1.0 / 3.0, "a \"b\" & <c>/0001.vtu")];
        let collection =
            Collection { outputs: outputs.map(|(at, file)| (at, file.to_owned())).to_vec() };
        let whole = collection.encode().unwrap();
        assert_eq!(Collection::decode(&whole).unwrap(), collection);
        for length in 0..whole.len() {
            assert!(Collection::decode(&whole[..length]).is_err(), "{length} of {}", whole.len());
        }
    }

    #[test]
    fn outputs_lie_within_the_folder() {
        for file in ["../0000.vti", "/tmp/0000.vti", "fields/../../0000.vti", ""] {
            let collection = Collection { outputs: vec![(0.0, file.to_owned())] };
            let error = Collection::decode(&collection.encode().unwrap()).unwrap_err();
            assert!(error.contains("outside of its folder"), "{error}");
        }
    }
}
