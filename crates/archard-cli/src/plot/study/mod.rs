//! Pictures of a study: bands of its histories, what each parameter does, and Sobol indices.

mod keys;
mod map;
mod statistics;

use std::io::Cursor;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail, ensure};
use archard::numerics::SAME;
use archard::simulation::history::{BODY_DEPTH, PEAK_PRESSURE};
use archard_case::files::{self, Contents};
use serde_json::Value;

use super::CELLS;
use super::SHOWN;
use super::draw::Paper;
use super::figure::{COLOURS, Curves, LegendPosition, PALE, Panel, Pen, View};
use super::scale::{Unit, phrase};
use super::tables::{Table, largest, read_history, size};
use super::{MAP, Picture, write};
pub(crate) use keys::Key;
pub(crate) use statistics::quantile;
use statistics::{Indices, effect, indices};

/// Most classes that samples are divided into.
const CLASSES: usize = 10;

/// A study, read back.
struct Study {
    /// Keys that were gone over, and keys that were sampled, by column.
    over: Vec<Key>,
    sampled: Vec<Key>,
    /// Whether the rows are those that Sobol indices take.
    saltelli: bool,
    /// The values of all keys and the results, a row a run.
    rows: Vec<Row>,
    /// What the pictures show: a column of the history, in words, and its unit.
    column: String,
    name: String,
    unit: Unit,
    dir: PathBuf,
}

/// A row of a study.
struct Row {
    number: usize,
    /// The values of all keys (SI) as axes have them, those gone over first.
    values: Vec<f64>,
    /// What fretting was.
    regime: Option<String>,
    /// What is doubtful about the result, if anything is.
    doubt: Option<Vec<String>>,
    /// The result (SI); `None` if the row failed, is wrong or has not run.
    result: Option<f64>,
}

/// Whether a folder is that of a study.
pub(super) fn is_one(dir: &Path) -> bool {
    dir.join("study.json").is_file() && dir.join("design.csv").is_file()
}

/// Draws the pictures of a study, of columns of the history or, where there are none, of the wear of each body; returns their
/// files.
pub(super) fn run(dir: &Path, quantities: &[String], paper: &Paper) -> Result<Vec<PathBuf>> {
    let (pictures, mark) = pictures(dir, quantities)?;
    write(dir, pictures, (mark.as_deref(), paper))
}

/// The pictures of a study, and what they have to say of rows that are left out.
pub(super) fn pictures(
    dir: &Path,
    quantities: &[String],
) -> Result<(Vec<Picture>, Option<String>)> {
    let columns = match quantities {
        [] => worn(dir)?,
        named => named.to_vec(),
    };
    let studies: Vec<Study> =
        columns.iter().map(|column| Study::read(dir, column)).collect::<Result<_>>()?;
    let studies = merged(studies);
    let [study, ..] = &studies[..] else { bail!("the study shows nothing") };
    let mut pictures = vec![];
    if !study.sampled.is_empty() {
        let panels: Vec<_> = studies.iter().map(Study::bands).collect::<Result<_>>()?;
        pictures.push(tiled("bands", panels.into_iter().flatten().collect()));
    }
    pictures.push(tiled("main_effects", studies.iter().flat_map(Study::effects).collect()));
    let maps: Vec<Panel> = studies.iter().filter_map(Study::map).collect();
    if !maps.is_empty() {
        pictures.push(Picture::new("map", maps).sized(MAP));
    }
    if study.saltelli {
        let height = 160.0 + 100.0 * study.sampled.len() as f64;
        let panels = studies.iter().map(Study::indices).collect::<Result<Vec<_>>>()?;
        let picture = Picture { columns: 1, ..Picture::new("sobol_indices", panels) };
        pictures.push(picture.sized([1000.0, height]));
    }
    let whole = study.rows.iter().filter(|row| row.result.is_some()).count();
    let all = study.rows.len();
    let narrow = if study.sampled.is_empty() { "" } else { "; bands may be too narrow by them" };
    let left_out = (whole < all).then(|| {
        format!("{} of {all} rows are left out: failed, wrong or not run{narrow}", all - whole)
    });
    let said: Vec<String> = left_out.into_iter().chain(doubtful(&study.rows)).collect();
    Ok((pictures, (!said.is_empty()).then(|| said.join("; "))))
}

/// How many rows are doubtful, and about what.
fn doubtful(rows: &[Row]) -> Option<String> {
    let doubts: Vec<&Vec<String>> = rows.iter().filter_map(|row| row.doubt.as_ref()).collect();
    let mut subjects: Vec<&str> =
        doubts.iter().flat_map(|all| all.iter().map(String::as_str)).collect();
    subjects.sort_unstable();
    subjects.dedup();
    let about =
        if subjects.is_empty() { String::new() } else { format!(": {}", subjects.join(", ")) };
    let (count, all) = (doubts.len(), rows.len());
    (count > 0).then(|| format!("? doubtful, {count} of {all} rows{about}"))
}

/// What the summary of a row says is not good, by its subjects; nothing where there is no summary.
fn subjects(dir: &Path, row: usize) -> Vec<String> {
    let path = dir.join(format!("rows/{row:04}/summary.json"));
    let text = files::read(&path, Contents::Text).unwrap_or_default();
    let summary: Value = serde_json::from_slice(&text).unwrap_or_default();
    let lines = summary["verdict"]["lines"].as_array().into_iter().flatten();
    let doubts = lines.filter(|line| line["word"] != "good");
    doubts.filter_map(|line| line["subject"].as_str().map(str::to_owned)).collect()
}

/// The studies, those of the same results as one.
fn merged(studies: Vec<Study>) -> Vec<Study> {
    let same = |one: &Study, other: &Study| {
        one.rows.iter().zip(&other.rows).all(|(one, other)| match (one.result, other.result) {
            (Some(one), Some(other)) => (one - other).abs() <= SAME * one.abs(),
            (one, other) => one.is_none() && other.is_none(),
        })
    };
    let mut apart: Vec<Study> = vec![];
    for study in studies {
        match apart.iter_mut().find(|known| same(known, &study)) {
            Some(known) => known.name = both(&known.name, &study.name),
            None => apart.push(study),
        }
    }
    apart
}

/// Two names as one: "Wear depth ball" and "Wear depth flat" are "Wear depth ball and flat".
fn both(one: &str, other: &str) -> String {
    let pairs = one.split(' ').zip(other.split(' '));
    let same: usize = pairs.take_while(|(a, b)| a == b).map(|(a, _)| a.len() + 1).sum();
    format!("{one} and {}", other.get(same..).unwrap_or(other))
}

fn tiled(name: &'static str, panels: Vec<Panel>) -> Picture {
    let columns = panels.len().clamp(1, 3);
    Picture { columns, ..Picture::new(name, panels) }
}

/// The depth of each body that wears in a study, or the peak pressure.
fn worn(dir: &Path) -> Result<Vec<String>> {
    let path = dir.join("sweep.csv");
    let context = || format!("cannot read `{}`: run the study first", path.display());
    let text = files::read(&path, Contents::Text).with_context(context)?;
    let mut reader = csv::Reader::from_reader(Cursor::new(text));
    let header = reader.headers().with_context(context)?.clone();
    let records: Vec<csv::StringRecord> =
        reader.records().collect::<Result<_, _>>().with_context(context)?;
    let (before, after) = BODY_DEPTH.split_once("BODY").unwrap_or((BODY_DEPTH, ""));
    let depths = header.iter().enumerate().filter(|(_, name)| {
        name.strip_prefix(before)
            .is_some_and(|rest| rest.len() > after.len() && rest.ends_with(after))
    });
    let wears = |place: usize| {
        let cells = records.iter().filter_map(|record| record[place].parse::<f64>().ok());
        cells.into_iter().any(|depth| depth > 0.0)
    };
    let found: Vec<String> =
        depths.filter(|(place, _)| wears(*place)).map(|(_, name)| name.to_owned()).collect();
    Ok(if found.is_empty() { vec![PEAK_PRESSURE.to_owned()] } else { found })
}

impl Study {
    /// Reads a study whose pictures are to show a column.
    fn read(dir: &Path, column: &str) -> Result<Self> {
        let path = dir.join("study.json");
        let context = || format!("cannot read `{}`", path.display());
        let kind: Value =
            serde_json::from_slice(&files::read(&path, Contents::Text).with_context(context)?)
                .with_context(context)?;
        let names = |key: &str| -> Vec<String> {
            let list = kind[key].as_array().map_or(&[][..], Vec::as_slice);
            list.iter().filter_map(|name| name.as_str().map(str::to_owned)).collect()
        };
        let (over, sampled) = (names("over"), names("sample"));
        let path = dir.join("sweep.csv");
        let context = || format!("cannot read `{}`: run the study first", path.display());
        let table = files::read(&path, Contents::Text).with_context(context)?;
        let mut reader = csv::Reader::from_reader(Cursor::new(table));
        let header = reader.headers().with_context(context)?.clone();
        let at = |name: &str| {
            let place = header.iter().position(|known| known == name);
            place.with_context(|| format!("`{}` has no column `{name}`", path.display()))
        };
        let keys: Vec<usize> =
            over.iter().chain(&sampled).map(|key| at(key)).collect::<Result<_>>()?;
        let records: Vec<csv::StringRecord> =
            reader.records().collect::<Result<_, _>>().with_context(context)?;
        let (status, verdict) = (at("status")?, at("verdict")?);
        let good =
            |record: &&csv::StringRecord| &record[status] == "done" && &record[verdict] != "wrong";
        let number = |record: &csv::StringRecord, place: usize| {
            record[place]
                .parse::<f64>()
                .with_context(|| format!("`{}`: `{}` is no number", path.display(), &record[place]))
        };
        ensure!(records.iter().any(|record| good(&record)), "no row of the study has a result yet");
        let place = at(column)?;
        let regime = header.iter().position(|known| known == "regime");
        let known = keys.iter().zip(over.iter().chain(&sampled)).map(|(key, name)| {
            Key::read(name, records.iter().map(|record| record[*key].to_owned()).collect())
        });
        let known: Vec<(Key, Vec<f64>)> = known.collect();
        let rows: Vec<Row> = records
            .iter()
            .enumerate()
            .map(|(index, record)| {
                let values = known.iter().map(|(_, values)| values[index]).collect();
                let result = good(&record).then(|| number(record, place)).transpose()?;
                let regime = regime.and_then(|place| record.get(place));
                let regime = regime.filter(|word| !word.is_empty()).map(str::to_owned);
                let doubt = (&record[verdict] == "doubtful").then(|| subjects(dir, index + 1));
                Ok(Row { number: index + 1, values, regime, doubt, result })
            })
            .collect::<Result<_>>()?;
        let most = rows.iter().filter_map(|row| row.result).map(f64::abs).fold(0.0, f64::max);
        let (name, unit) = Unit::of_result(column, most);
        let saltelli = kind["design"] == "saltelli";
        let gone_over = over.len();
        let mut over: Vec<Key> = known.into_iter().map(|(key, _)| key).collect();
        let sampled = over.split_off(gone_over);
        let (column, dir) = (column.to_owned(), dir.to_owned());
        Ok(Self { over, sampled, saltelli, rows, column, name, unit, dir })
    }

    /// What the pictures show, as a phrase.
    fn name(&self) -> &str {
        &self.name
    }

    /// The quantiles of the histories of all samples, in a panel for each of the first combinations gone over.
    fn bands(&self) -> Result<Vec<Panel>> {
        let over = self.over.len();
        let groups = self.rows.chunk_by(|one, other| one.values[..over] == other.values[..over]);
        groups.take(SHOWN).map(|rows| self.band(rows)).collect()
    }

    fn band(&self, rows: &[Row]) -> Result<Panel> {
        let read =
            |row: &Row| read_history(&self.dir.join(format!("rows/{:04}/history.csv", row.number)));
        let whole = rows.iter().filter(|row| row.result.is_some());
        let histories: Vec<Table> = whole.map(read).collect::<Result<_>>()?;
        let of = |history: &Table| largest(history.first().1);
        // As far as all of them go.
        let end = histories.iter().map(of).fold(f64::INFINITY, f64::min);
        let name = histories.first().map_or("", |history| history.first().0).to_owned();
        let along = Unit::of_column(&name, end);
        let places = (0..=CELLS).map(|i| end * i as f64 / CELLS as f64);
        let mut columns: Vec<(f64, Vec<f64>)> = vec![];
        for place in places.filter(|place| place.is_finite()) {
            let value = |history: &Table| {
                Ok(value_at(history.first().1, history.column(&self.column)?, place))
            };
            let mut values: Vec<f64> = histories.iter().map(value).collect::<Result<_>>()?;
            values.sort_by(f64::total_cmp);
            columns.push((place * along.factor, values));
        }
        let at = |share: f64| -> Vec<f64> {
            columns.iter().map(|(_, values)| self.unit.factor * quantile(values, share)).collect()
        };
        let x: Vec<f64> = columns.iter().map(|column| column.0).collect();
        let mut curves = Curves::new();
        for ([low, high], opacity) in [([0.05, 0.95], 0.18), ([0.25, 0.75], 0.3)] {
            let ends = at(low).into_iter().zip(at(high));
            let places = x.iter().zip(ends).map(|(x, (low, high))| [*x, low, high]);
            curves.band(places, COLOURS[1], opacity, None);
        }
        let legend = format!("median of {}, with 50 % and 90 % of them", histories.len());
        curves.add(x.iter().copied().zip(at(0.5)), Pen::line(COLOURS[1]), Some(&legend));
        let values = self.over.iter().map(|key| key.with_value(rows[0].number - 1));
        let title: Vec<String> = values.collect();
        let title = if title.is_empty() { self.name().to_owned() } else { title.join(", ") };
        let labels = [&*title, &along.label(&phrase(&name)), &self.unit.label(self.name())];
        let least = columns.iter().filter_map(|column| column.1.first()).fold(0.0, |a, b| b.min(a));
        Ok(curves.panel(labels, |view| {
            view.below_x(end * along.factor)
                .above_y(1.1 * least * self.unit.factor)
                .legend(LegendPosition::InsideTopLeft)
        }))
    }

    /// The results over each of the first keys, and their mean.
    fn effects(&self) -> Vec<Panel> {
        let keys = self.over.iter().chain(&self.sampled).enumerate();
        keys.take(SHOWN).map(|(place, key)| self.effect(place, key)).collect()
    }

    fn effect(&self, place: usize, key: &Key) -> Panel {
        let pairs = self.rows.iter().filter_map(|row| Some((row.values[place], row.result?)));
        let points: Vec<(f64, f64)> = pairs.collect();
        let values: Vec<f64> = points.iter().map(|point| point.0).collect();
        let (words, scale) = key.axis(size(&values));
        let shown =
            |&(value, result): &(f64, f64)| (value * scale.factor, result * self.unit.factor);
        let classes = match place < self.over.len() {
            true => None,
            false => Some(((points.len() as f64).sqrt() as usize).clamp(2, CLASSES)),
        };
        let effect = effect(&points, classes);
        let mut curves = Curves::new();
        let line = points.len() == effect.means.len();
        let [row, mean] = [Some("a row"), Some("mean")].map(|legend| legend.filter(|_| !line));
        curves.mark(points.iter().map(shown), PALE[1], row);
        curves.add(effect.means.iter().map(shown), Pen::line(COLOURS[0]), mean);
        // Of one key there is no variance to share.
        let title = match self.over.len() + self.sampled.len() {
            1 => self.name().to_owned(),
            _ => format!("{:.0} % of the variance", 100.0 * effect.share),
        };
        let notes = key.levels.iter().zip(&effect.means).map(|(level, mean)| (level, shown(mean)));
        let label = scale.label(&words);
        curves.panel([&title, &label, &self.unit.label(self.name())], |view| {
            notes.fold(view, |view, (level, (x, y))| view.note(level, [x, y]))
        })
    }

    /// The Sobol indices of the sampled keys.
    fn indices(&self) -> Result<Panel> {
        let length = self.sampled.len() + 2;
        let whole = |rows: &[Row]| rows.iter().map(|row| row.result).collect::<Option<Vec<f64>>>();
        let blocks: Vec<Vec<f64>> = self.rows.chunks(length).filter_map(whole).collect();
        ensure!(blocks.len() > 1, "too few whole blocks of {length} rows for Sobol indices");
        let known = indices(&blocks);
        let mut curves = Curves::new();
        let (mut end, mut notes) = (1.0_f64, vec![]);
        let legends = ["alone (first order)", "with others (total)"];
        for (order, (colour, legend)) in
            [COLOURS[0], COLOURS[2]].into_iter().zip(legends).enumerate()
        {
            let of = |known: &Indices| [known.first, known.total][order];
            // From the top down, the total below.
            let height = |place: usize| (known.len() - place) as f64 - 0.2 * order as f64;
            for (place, known) in known.iter().enumerate() {
                let (share, within) = (of(known), known.within[order]);
                let ends = [share - within, share + within].map(|end| (end, height(place)));
                curves.add(ends, Pen::line(colour), None);
                end = end.max(share + within);
            }
            let marks = known.iter().enumerate().map(|(place, known)| (of(known), height(place)));
            curves.mark(marks, colour, Some(legend));
        }
        for (place, (key, known)) in self.sampled.iter().zip(&known).enumerate() {
            let Indices { first, total, within } = known;
            let note = format!(
                "{}: {first:.2} ± {:.2}, {total:.2} ± {:.2}",
                key.name, within[0], within[1]
            );
            let height = (self.sampled.len() - place) as f64 + 0.25;
            notes.push((note, [0.5 * end, height]));
        }
        let title = format!("Sobol indices of the {}", self.name().to_lowercase());
        let labels = [&*title, "share of the variance, with the 95 % interval", ""];
        let top = known.len() as f64 + 0.5;
        Ok(curves.panel(labels, |view| {
            let view = View { named: false, ..view.below_x(end).above_y(0.5).below_y(top) };
            notes.into_iter().fold(view, |view, (words, place)| view.note(words, place))
        }))
    }
}

/// The value at a place between two steps.
fn value_at(progress: &[f64], values: &[f64], place: f64) -> f64 {
    let next = progress.partition_point(|known| *known < place).min(progress.len() - 1);
    let before = next.saturating_sub(1);
    let span = progress[next] - progress[before];
    let share = if span > 0.0 { (place - progress[before]) / span } else { 0.0 };
    values[before] + share * (values[next] - values[before])
}
