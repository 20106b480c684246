//! The page about a fit: each coefficient with its interval, and what the next test will show.

use std::path::Path;

use anyhow::{Context, Result};
use archard_case::files::{self, Contents};
use serde_json::Value;

use super::figures::Figure;
use super::html::Html;
use super::page::{Header, Page, Sections, Table, list};
use super::words::{facts, plain, quantity, range, title_of};
use super::{name_of, tables};
use crate::number::percent;

/// What was found, and its picture.
const FOUND: &str = "fit.json";
const PICTURES: [(&str, &str); 2] = [("fit.svg", "image/svg+xml"), ("fit.png", "image/png")];

/// Whether a folder is that of a fit.
pub(super) fn is_one(dir: &Path) -> bool {
    dir.join(FOUND).is_file()
}

/// The page of a fit.
pub(super) fn page(dir: &Path) -> Result<Page> {
    let path = dir.join(FOUND);
    let context = || format!("cannot read `{}`", path.display());
    let text = files::read(&path, Contents::Text).with_context(context)?;
    let found: Value = serde_json::from_slice(&text).with_context(context)?;
    let coefficients: Vec<Coefficient<'_>> =
        found["coefficients"].as_array().into_iter().flatten().map(Coefficient).collect();
    let case = found["case"].as_str().unwrap_or_default();
    let title = match title_of(case) {
        Some(title) => format!("Wear coefficients from measured tests: {title}"),
        None => name_of(dir),
    };
    let picture = picture(dir);
    let mut all = Sections::default();
    let tables: Html = coefficients.iter().map(|own| own.outcome().html()).collect();
    all.add("outcome", "What the tests say", &tables);
    let alone = picture.as_ref().map_or_else(Html::default, Figure::alone);
    all.add("picture", "Readings and fit", &alone);
    let tests: Html =
        coefficients.iter().map(|own| own.tests().html() + own.budget().html()).collect();
    all.add("tests", "Test by test", &tests);
    let remarks = found["remarks"].as_array().into_iter().flatten();
    let remarks: Vec<String> = remarks.filter_map(|one| one.as_str().map(str::to_owned)).collect();
    all.add("remarks", "Remarks", &list(&remarks));
    all.add("verdict", "Verdict", &tables::verdict(&found).html());
    let header = Header {
        about: "a fit",
        version: found["version"].as_str().unwrap_or(env!("CARGO_PKG_VERSION")),
        title: &title,
        facts: facts(case),
        verdict: verdict(&found),
        mark: None,
        lead: coefficients.iter().flat_map(Coefficient::lead).collect(),
        tiles: coefficients.iter().map(Coefficient::tile).collect(),
        picture: picture.as_ref().map_or_else(Html::default, Figure::small),
    };
    let header = header.html(&all.there);
    Ok(Page { title, header, body: all.html, drawings: None })
}

/// The picture of the folder.
fn picture(dir: &Path) -> Option<Figure> {
    let title = "Readings, the case at the median, and both intervals";
    let words = "Points are readings, the line the case at the median; the dark band is its 95 % interval, the pale one that of the next test.";
    Figure::in_folder(dir, &PICTURES, [title, words])
}

/// The colour of the verdict and its words: those of what is worst.
fn verdict(found: &Value) -> (&'static str, String) {
    let lines = found["verdict"]["lines"].as_array().map_or(&[][..], Vec::as_slice);
    let of = |word: &str| -> Vec<&str> {
        let these = lines.iter().filter(|line| line["word"] == word);
        these.filter_map(|line| line["words"].as_str()).collect()
    };
    match found["verdict"]["word"].as_str() {
        Some("good") => ("good", "the tests agree with the law".to_owned()),
        Some("doubtful") => ("doubtful", format!("doubtful: {}", of("doubtful").join("; "))),
        Some("wrong") => ("wrong", format!("wrong: {}", of("wrong").join("; "))),
        _ => ("doubtful", "not judged: fit again".to_owned()),
    }
}

/// What readings say of the law that tell no exponent.
const UNTOLD: &str = "the readings cannot tell whether the law's shape fits";

/// A coefficient as the file has it.
struct Coefficient<'a>(&'a Value);

impl Coefficient<'_> {
    fn key(&self) -> &str {
        self.0["key"].as_str().unwrap_or("coefficient")
    }

    fn shown(&self, value: f64) -> String {
        quantity(value, self.unit())
    }

    fn unit(&self) -> &str {
        self.0["unit"].as_str().unwrap_or_default()
    }

    fn rejected(&self) -> Option<String> {
        self.0["rejected"].as_str().map(str::to_owned)
    }

    fn median(&self) -> Option<String> {
        Some(self.shown(self.0["median"].as_f64()?))
    }

    /// An interval in words.
    fn range(&self, key: &str) -> Option<String> {
        self.between(&self.0[key])
    }

    fn between(&self, ends: &Value) -> Option<String> {
        Some(range(ends[0].as_f64()?, ends[1].as_f64()?, self.unit()))
    }

    fn tile(&self) -> [String; 3] {
        let within = self.range("interval_95").map(|range| format!("95 %: {range}"));
        let median = self.median().filter(|_| self.rejected().is_none());
        [
            self.key().to_owned(),
            median.unwrap_or_else(|| "none".to_owned()),
            within.unwrap_or_default(),
        ]
    }

    /// The outcome in words.
    fn lead(&self) -> Vec<String> {
        if let Some(why) = self.rejected() {
            return vec![format!("There is no single {}: {why}.", self.key())];
        }
        let count = self.0["tests"].as_array().map_or(0, Vec::len);
        let tests = if count == 1 { "1 test".to_owned() } else { format!("{count} tests") };
        let median = self.median().unwrap_or_else(|| "unknown".to_owned());
        let within = match self.range("interval_95") {
            Some(range) => format!("; with 95 % probability it lies within {range}"),
            None => String::new(),
        };
        let next = match self.range("next_test_95") {
            Some(range) => {
                format!("The next test, read as these, will show {range} with 95 % probability.")
            }
            None => "One test cannot tell how tests scatter: where the next will lie is unknown until there are more."
                .to_owned(),
        };
        vec![format!("The median of {tests} is {median}{within}."), next]
    }

    fn outcome(&self) -> Table {
        let number = |key: &str| self.0[key].as_f64();
        let rows = [
            ("Median", self.median()),
            ("95 % interval of the median", self.range("interval_95")),
            ("95 % interval of the next test", self.range("next_test_95")),
            ("Scatter between tests", number("scatter_between_tests").map(percent)),
            ("In the case", number("in_the_case").map(|value| self.shown(value))),
            (
                "Exponent of the distance (1 by the law)",
                self.exponent("distance").or_else(|| Some(UNTOLD.to_owned())),
            ),
            ("Exponent of the load (0 by the law)", self.exponent("load")),
        ];
        let rows = rows.into_iter().filter_map(|(what, value)| Some(vec![what.to_owned(), value?]));
        let caption = self.key().to_owned();
        Table { caption, heads: vec!["Quantity", "Value"], rows: rows.collect() }
    }

    fn exponent(&self, key: &str) -> Option<String> {
        let found = &self.0[key];
        if let Some(words) = found["words"].as_str() {
            return Some(words.to_owned());
        }
        // Fits of earlier versions have no words of their own.
        let word = if found["rejected"] == true { "rejected" } else { "accepted" };
        Some(format!("{}, {word}", plain(found["exponent"].as_f64()?)))
    }

    fn tests(&self) -> Table {
        let row = |test: &Value| {
            let name = test["test"].as_str().unwrap_or_default();
            let name = match test["load_N"].as_f64() {
                Some(load) => format!("{name}, {} N", plain(load)),
                None => name.to_owned(),
            };
            let k = test["k"].as_f64().map_or_else(String::new, |k| self.shown(k));
            vec![name, k, self.between(&test["interval_95"]).unwrap_or_default()]
        };
        let rows = self.0["tests"].as_array().into_iter().flatten().map(row).collect();
        let caption = format!("{}, test by test", self.key());
        Table { caption, heads: vec!["Test", "Coefficient", "95 % interval"], rows }
    }

    fn budget(&self) -> Table {
        let row = |part: &Value| {
            let source = part["source"].as_str().unwrap_or_default().to_owned();
            vec![source, part["relative"].as_f64().map(percent).unwrap_or_default()]
        };
        let rows = self.0["budget"].as_array().into_iter().flatten().map(row).collect();
        let caption = format!("What {} is uncertain by", self.key());
        Table { caption, heads: vec!["Source", "Relative"], rows }
    }
}
