//! The page about a study: what came out of its rows as a whole, and by what it was varied.

use std::path::Path;

use anyhow::{Context, Result};
use archard::simulation::history::{
    BODY_DEPTH, MASS_LOSS, PEAK_PRESSURE, SCAR, TRACK_WIDTH, WORN_SECTION, WORN_VOLUME, body_of,
    of_body,
};
use archard_case::files::{self, Contents};
use serde_json::{Value, json};

use super::figures::{Figure, drawn};
use super::html::{Html, fill};
use super::page::{Header, Page, Sections, Table};
use super::words::{facts, plain, quantity, range, title_of};
use super::{name_of, tables};
use crate::plot::{self, Key, quantile};

/// Most rows that are not good, and most values that are no numbers, that are listed.
const LISTED: usize = 20;
/// Shares of the samples that lie below the ends of the interval.
const ENDS: [f64; 2] = [0.05, 0.95];

/// A study, read back.
struct Study {
    /// The case of its first row (SI).
    case: String,
    /// Keys by column: those gone over, then those sampled.
    over: Vec<String>,
    sampled: Vec<String>,
    heads: Vec<String>,
    rows: Vec<Vec<String>>,
}

/// The page of a study.
pub(super) fn page(dir: &Path) -> Result<Page> {
    let study = Study::read(dir)?;
    let (pictures, mark) = plot::panels_of_study(dir)?;
    let title = study.title().unwrap_or_else(|| name_of(dir));
    let mut all = Sections::default();
    all.add("outcome", "What came out", &study.outcome().html());
    let mut figures = Vec::new();
    for (name, panels) in pictures {
        let of: Vec<Figure> = panels.iter().map(Figure::of).collect::<Result<_>>()?;
        let (id, heading) = section(name);
        let first = figures.len() + 1;
        let places = of.iter().enumerate();
        let places: Html =
            places.map(|(i, figure)| drawn(&format!("figure-{}", first + i), figure)).collect();
        all.add(id, heading, &fill("<div class=\"figures\">\n{}</div>\n", &[&places]));
        figures.extend(of);
    }
    all.add("varied", "What was varied", &study.varied().html());
    all.add("rows", "Rows", &(study.standing().html() + study.complaints().html()));
    let header = Header {
        about: "a study",
        version: env!("CARGO_PKG_VERSION"),
        title: &title,
        facts: study.facts(),
        verdict: study.verdict(),
        mark: mark.clone(),
        lead: study.lead(),
        tiles: study.tiles(),
        picture: figures.first().map_or_else(Html::default, Figure::small),
    };
    let header = header.html(&all.there);
    let drawings: Vec<Value> = figures.iter().map(Figure::json).collect();
    let drawings = Some(json!({ "figures": drawings, "maps": null, "mark": mark }));
    Ok(Page { title, header, body: all.html, drawings })
}

/// The section of a picture.
fn section(name: &str) -> (&'static str, &'static str) {
    match name {
        "bands" => ("bands", "Over the motion"),
        "main_effects" => ("effects", "What each value does"),
        "map" => ("map", "Map"),
        "sobol_indices" => ("indices", "What the variance comes from"),
        _ => ("more", "More pictures"),
    }
}

impl Study {
    fn read(dir: &Path) -> Result<Self> {
        let path = dir.join("study.json");
        let context = || format!("cannot read `{}`", path.display());
        let text = files::read(&path, Contents::Text).with_context(context)?;
        let kind: Value = serde_json::from_slice(&text).with_context(context)?;
        let names = |key: &str| -> Vec<String> {
            let list = kind[key].as_array().map_or(&[][..], Vec::as_slice);
            list.iter().filter_map(|name| name.as_str().map(str::to_owned)).collect()
        };
        let path = dir.join("sweep.csv");
        let context = || format!("cannot read `{}`: run the study first", path.display());
        let text = files::read(&path, Contents::Text).with_context(context)?;
        let mut reader = csv::Reader::from_reader(text.as_slice());
        let text = |record: &csv::StringRecord| record.iter().map(str::to_owned).collect();
        let heads = text(reader.headers().with_context(context)?);
        let rows = reader.records().map(|record| record.map(|record| text(&record)));
        let rows = rows.collect::<Result<_, _>>().with_context(context)?;
        let case = files::read_text(&dir.join("rows/0001/case.toml")).unwrap_or_default();
        Ok(Self { case, over: names("over"), sampled: names("sample"), heads, rows })
    }

    fn cell<'a>(&self, row: &'a [String], name: &str) -> &'a str {
        let place = self.heads.iter().position(|head| head == name);
        place.and_then(|place| row.get(place)).map_or("", String::as_str)
    }

    /// What became of a row: its verdict if it is done, its status if not.
    fn word<'a>(&self, row: &'a [String]) -> &'a str {
        match self.cell(row, "status") {
            "done" => self.cell(row, "verdict"),
            other => other,
        }
    }

    /// The values of a column in the rows that count, in order.
    fn sorted(&self, name: &str) -> Vec<f64> {
        let counts = |row: &&Vec<String>| {
            self.cell(row, "status") == "done" && self.cell(row, "verdict") != "wrong"
        };
        let rows = self.rows.iter().filter(counts);
        let mut values: Vec<f64> =
            rows.filter_map(|row| self.cell(row, name).parse().ok()).collect();
        values.sort_by(f64::total_cmp);
        values
    }

    fn bodies(&self) -> Vec<String> {
        let of = |head: &String| body_of(BODY_DEPTH, head).map(str::to_owned);
        self.heads.iter().filter_map(of).collect()
    }

    /// The columns that are read first and are not zero in all rows.
    fn columns(&self) -> Vec<String> {
        let of = |body: &String| {
            [BODY_DEPTH, WORN_VOLUME, WORN_SECTION, MASS_LOSS].map(|name| of_body(name, body))
        };
        let bodies = self.bodies();
        let all = bodies.iter().flat_map(of);
        let all = all.chain([PEAK_PRESSURE, SCAR[0], SCAR[1], TRACK_WIDTH].map(str::to_owned));
        all.filter(|name| self.sorted(name).iter().any(|value| *value != 0.0)).collect()
    }

    /// The middle of a column, and the ends between which its samples lie: nine in ten of them, or all values of a grid.
    fn spread(&self, name: &str) -> [f64; 3] {
        let values = self.sorted(name);
        let ends = if self.sampled.is_empty() { [0.0, 1.0] } else { ENDS };
        [quantile(&values, 0.5), quantile(&values, ends[0]), quantile(&values, ends[1])]
    }

    fn heads(&self) -> Vec<&'static str> {
        match self.sampled.is_empty() {
            true => vec!["Quantity", "Middle value", "Lowest to highest"],
            false => vec!["Quantity", "Median", "Nine in ten lie within"],
        }
    }

    fn outcome(&self) -> Table {
        let bodies = self.bodies();
        let row = |name: &String| {
            let (label, unit) = tables::label(&bodies, name);
            let [middle, low, high] = self.spread(name);
            vec![label, quantity(middle, unit), range(low, high, unit)]
        };
        let rows = self.columns().iter().map(row).collect();
        let caption = "At the end of the rows".to_owned();
        Table { caption, heads: self.heads(), rows }
    }

    fn tiles(&self) -> Vec<[String; 3]> {
        let rows = self.outcome().rows.into_iter().take(4);
        rows.map(|row| [row[0].clone(), row[1].clone(), row[2].clone()]).collect()
    }

    /// The outcome in words.
    fn lead(&self) -> Vec<String> {
        let bodies = self.bodies();
        let columns = self.columns();
        let Some(name) = columns.first() else { return vec![] };
        let (label, unit) = tables::label(&bodies, name);
        let [middle, low, high] = self.spread(name);
        let (middle, ends) = (quantity(middle, unit), range(low, high, unit));
        let count = self.sorted(name).len();
        let label = label.to_lowercase();
        match self.sampled.is_empty() {
            true => vec![format!("Over the {count} rows the {label} goes from {ends}.")],
            false => vec![
                format!("In half of the {count} samples the {label} stays below {middle}."),
                format!(
                    "The next test, if its values lie as the samples do, ends within {ends} with a probability of nine in ten."
                ),
            ],
        }
    }

    /// The colour of the verdict and its words.
    fn verdict(&self) -> (&'static str, String) {
        let all = self.rows.len();
        let of = |word: &str| self.rows.iter().filter(|row| self.word(row) == word).count();
        let (good, doubtful) = (of("good"), of("doubtful"));
        let open = of("open") + of("interrupted");
        let words = match doubtful {
            0 => format!("{good} of {all} rows are good"),
            doubtful => format!("{good} of {all} rows are good, {doubtful} doubtful"),
        };
        match () {
            () if good == all => ("good", words),
            () if open > 0 => ("incomplete", format!("incomplete, {words}")),
            () if good + doubtful == all => ("doubtful", words),
            () => ("wrong", words),
        }
    }

    /// What a key is in words, and its values in the unit they are usually written in.
    fn values(&self, key: &str) -> [String; 2] {
        let cells = self.rows.iter().map(|row| self.cell(row, key).to_owned()).collect();
        let (known, values) = Key::read(key, cells);
        let low = values.iter().copied().fold(f64::INFINITY, f64::min);
        let high = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let (words, unit) = known.axis(low.abs().max(high.abs()));
        match known.levels.len() {
            0 => {
                let ends = [low, high].map(|end| plain(end * unit.factor));
                [words, format!("{} to {} {}", ends[0], ends[1], unit.name).trim_end().to_owned()]
            }
            1..=LISTED => [words, known.levels.join(", ")],
            many => [words, format!("{many} values")],
        }
    }

    fn keys(&self) -> impl Iterator<Item = &String> {
        self.over.iter().chain(&self.sampled)
    }

    /// The title of its case, and what was varied.
    fn title(&self) -> Option<String> {
        let words: Vec<String> =
            self.keys().map(|key| self.values(key)[0].to_lowercase()).collect();
        Some(format!("{}: study of {}", title_of(&self.case)?, words.join(", ")))
    }

    /// What was varied, and what all rows have in common.
    fn facts(&self) -> Vec<(String, String)> {
        let is_varied = |line: &&str| {
            let key = line.split(" = ").next().unwrap_or_default();
            self.keys().any(|column| {
                let rest = column.strip_prefix(key);
                rest.is_some_and(|rest| rest.is_empty() || rest.starts_with('_'))
            })
        };
        let common: String = self
            .case
            .lines()
            .filter(|line| !is_varied(line))
            .map(|line| format!("{line}\n"))
            .collect();
        self.keys().map(|key| self.values(key).into()).chain(facts(&common)).collect()
    }

    fn varied(&self) -> Table {
        let row = |(how, key): (&str, &String)| {
            let [_, values] = self.values(key);
            vec![key.clone(), how.to_owned(), values]
        };
        let over = self.over.iter().map(|key| ("gone over", key));
        let sampled = self.sampled.iter().map(|key| ("sampled", key));
        Table {
            caption: "Keys and their values".to_owned(),
            heads: vec!["Key", "How", "Values"],
            rows: over.chain(sampled).map(row).collect(),
        }
    }

    fn standing(&self) -> Table {
        let words = ["good", "doubtful", "wrong", "failed", "interrupted", "open"];
        let count = |word: &str| self.rows.iter().filter(|row| self.word(row) == word).count();
        let rows = words.into_iter().map(|word| (word, count(word)));
        let rows = rows.filter(|(_, count)| *count > 0);
        Table {
            caption: "How the rows ended".to_owned(),
            heads: vec!["Verdict", "Rows"],
            rows: rows.map(|(word, count)| vec![word.to_owned(), count.to_string()]).collect(),
        }
    }

    /// The rows that are not good.
    fn complaints(&self) -> Table {
        let of = |row: &&Vec<String>| self.word(row) != "good";
        let row = |row: &Vec<String>| {
            let cell = |name: &str| self.cell(row, name).to_owned();
            let why = if cell("error").is_empty() { cell("reason") } else { cell("error") };
            vec![cell("row"), self.word(row).to_owned(), why]
        };
        Table {
            caption: format!("Rows that stopped, are wrong or doubtful, {LISTED} at most"),
            heads: vec!["Row", "Verdict", "Why"],
            rows: self.rows.iter().filter(of).take(LISTED).map(row).collect(),
        }
    }
}
