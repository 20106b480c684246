//! `archard validate`: measured tests next to what is predicted of them.

use std::path::{Path, PathBuf};

use archard_case::output::{Place, Store};
use archard_lab::validate::{Set, Validation, in_markdown, validate};

use crate::arguments::Validate as Arguments;
use crate::failure::Failure;
use crate::fit::{Follow, failed};
use crate::say::say;

/// The first words of the page.
const HEAD: &str = "# Measured wear

Each test is predicted by the coefficient of the other tests of its set, or by that of its authors; the error is the prediction less the measured value, after ASME
V&V 20. The 95 % interval has the scatter of the tests, the uncertainty of the measured value and that of the numbers in it. Depths and widths at
the test's own section judge the shape alone. `archard validate FOLDER -o PAGE` makes this page; `validation/README.md` says how to add a set.
";

/// Predicts the tests of sets, and writes a page of them if a file is named.
pub fn run(arguments: &Arguments) -> Result<(), Failure> {
    let sets = Set::all(&arguments.folder).map_err(Failure::wrong)?;
    // Before the runs: they may take long.
    let wrong = |error: archard_case::output::Error| Failure::wrong(error.to_string());
    let own = |known: &[u8]| known.starts_with(HEAD.as_bytes());
    let page = arguments.output.as_ref().map(|page| Place::free_or(page, own)).transpose();
    let page = page.map_err(wrong)?;
    let store = arguments.cache.clone().map(Store::new).or_else(Store::of_user);
    let mut all: Vec<Validation> = vec![];
    for set in &sets {
        let mut follow = Follow::new(arguments.quiet);
        let found = validate(set, (&runs(set), store.as_ref()), &mut follow);
        follow.end();
        let found = found.map_err(|error| failed(&error))?;
        if !arguments.json && !arguments.quiet {
            say(found.to_string().trim_end())?;
        }
        all.push(found);
    }
    if arguments.json {
        let sets: Vec<_> = all.iter().map(Validation::json).collect();
        say(&format!(
            "{:#}",
            serde_json::json!({ "program": "archard", "version": env!("CARGO_PKG_VERSION"), "sets": sets })
        ))?;
    }
    let text = format!("{HEAD}\n{}\n", in_markdown(&all).trim_end());
    page.map_or(Ok(()), |page| page.write(text.as_bytes())).map_err(wrong)
}

/// The folder of the runs of a set.
fn runs(set: &Set) -> PathBuf {
    let whole = set.dir.canonicalize().unwrap_or_else(|_| set.dir.clone());
    Path::new("results/validate").join(whole.file_name().unwrap_or_default())
}
