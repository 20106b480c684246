//! The rows of a study: what is put at which keys, and the checked case of each row.

use archard_case::{Problem, RunnableCase, Severity, Task, ValueAt};
use serde_json::json;

use super::points::{MOST, points, together};
use super::values::{Distribution, distribution, few, list};
use crate::arguments::{Design as Laid, Layout, Sweep};
use crate::diagnose;
use crate::failure::Failure;
use crate::say::tell;

/// A study: its keys and rows.
#[derive(Debug)]
pub struct Design {
    /// The keys, those of `--over` first.
    pub keys: Vec<String>,
    /// The columns of the keys: each key with the unit of its values (SI), where all are numbers of one unit.
    pub columns: Vec<String>,
    /// How many of the columns are gone over; the others are sampled.
    pub over: usize,
    /// How samples are laid; `None` where there are none.
    pub layout: Option<Layout>,
    /// The rows, in the order of `design.csv`.
    pub rows: Vec<Row>,
}

/// A row of a study.
#[derive(Debug, Clone)]
pub struct Row {
    /// The values of its keys as they were given, or drawn.
    pub given: Vec<String>,
    /// The values of its keys (SI), as tables have them: numbers without their unit, and lists, tables and texts as a case
    /// has them.
    pub cells: Vec<String>,
    /// Its case.
    pub resolved: Box<RunnableCase>,
}

/// The study of the arguments, every row of it checked; nothing is written.
///
/// # Errors
/// If an option or the case of a row is wrong.
pub fn design(arguments: &Sweep) -> Result<Design, Failure> {
    let (keys, settings) = settings(arguments).map_err(Failure::wrong)?;
    let file = diagnose::read(&arguments.case())?;
    let mut warned: Vec<(String, usize)> = vec![];
    let mut values: Vec<Vec<Option<ValueAt>>> = vec![];
    let mut rows = vec![];
    for (index, settings) in settings.into_iter().enumerate() {
        let options = keys.iter().zip(&settings);
        let file = options.fold(file.clone(), |file, (key, value)| file.set(setting(key, value)));
        let resolved = match file.task() {
            Ok(Task::Contact(resolved)) => resolved,
            Ok(Task::Cam(_) | Task::Elastic(_) | Task::Gear(_) | Task::WheelRail(_)) => {
                let why = "a study is one of two bodies in contact; `archard run` computes this case by itself";
                return Err(Failure::wrong(why));
            }
            Err(problems) => {
                let errors: Vec<Problem> = problems
                    .into_iter()
                    .filter(|problem| problem.severity == Severity::Error)
                    .collect();
                diagnose::show(&file, &errors);
                let what: Vec<String> =
                    keys.iter().zip(&settings).map(|(key, value)| setting(key, value)).collect();
                let row = index + 1;
                return Err(Failure::wrong(format!(
                    "row {row} of the study cannot be run: {}",
                    what.join(", ")
                )));
            }
        };
        for problem in &resolved.warnings {
            let kind = problem.key.to_string();
            match warned.iter_mut().find(|(known, _)| *known == kind) {
                Some((_, rows)) => *rows += 1,
                None => {
                    if !arguments.quiet {
                        tell(&format!("row {}: {}", index + 1, file.describe(problem)));
                    }
                    warned.push((kind, 1));
                }
            }
        }
        values.push(keys.iter().map(|key| resolved.case.value_at(key)).collect());
        rows.push(Row { given: settings, cells: vec![], resolved });
    }
    for (key, count) in warned.iter().filter(|(_, count)| *count > 1 && !arguments.quiet) {
        tell(&format!("{count} rows have warnings of `{key}`, of which the first is shown"));
    }
    let columns =
        keys.iter().enumerate().map(|(place, key)| fill(&mut rows, &values, (place, key)));
    let columns = columns.collect();
    let layout = layout(arguments).map_err(Failure::wrong)?;
    Ok(Design { keys, columns, over: arguments.over.len(), layout, rows })
}

/// Fills the cells of a key, and returns its column.
fn fill(rows: &mut [Row], values: &[Vec<Option<ValueAt>>], (place, key): (usize, &str)) -> String {
    let unit = |row: &Vec<Option<ValueAt>>| match &row[place] {
        Some(ValueAt::Number(_, unit)) => Some(unit.clone()),
        _ => None,
    };
    let first = values.first().and_then(unit);
    let common = first.filter(|first| values.iter().all(|row| unit(row).as_ref() == Some(first)));
    for (row, values) in rows.iter_mut().zip(values) {
        row.cells.push(match &values[place] {
            Some(ValueAt::Number(value, _)) if common.is_some() => format!("{value:?}"),
            Some(ValueAt::Number(value, unit)) => format!("{value:?} {unit}").trim_end().to_owned(),
            Some(ValueAt::Text(text) | ValueAt::List(text)) => text.clone(),
            None => row.given[place].clone(),
        });
    }
    key.to_owned() + &common.map_or_else(String::new, |unit| suffix(&unit))
}

impl Design {
    /// As `study.json` has it: what the columns are, for pictures.
    pub fn json(&self) -> String {
        let (over, sample) = self.columns.split_at(self.over);
        let design = match self.layout {
            None => "grid",
            Some(Layout::Latin) => "latin",
            Some(Layout::Sobol) => "sobol",
            Some(Layout::Saltelli) => "saltelli",
        };
        format!("{:#}\n", json!({ "over": over, "sample": sample, "design": design }))
    }

    /// As `design.csv` has it: a row a run, values in SI.
    pub fn csv(&self) -> String {
        let mut table = csv::Writer::from_writer(vec![]);
        let head = ["row"].into_iter().chain(self.columns.iter().map(String::as_str));
        // Into memory, by rows of one length: nothing can fail.
        let _ = table.write_record(head);
        for (index, row) in self.rows.iter().enumerate() {
            let _ = table.write_record([&(index + 1).to_string()].into_iter().chain(&row.cells));
        }
        String::from_utf8(table.into_inner().unwrap_or_default()).unwrap_or_default()
    }
}

fn setting(key: &str, value: &str) -> String {
    format!("{key}={value}")
}

/// How the columns of files name a unit: `_N`, `_m2`, `_per_Pa`.
fn suffix(unit: &str) -> String {
    match unit.strip_prefix("1/") {
        _ if unit.is_empty() => String::new(),
        Some(below) => format!("_per_{}", suffix(below).trim_start_matches('_')),
        None => format!("_{}", unit.replace('/', "_per_").replace(['^', ' ', '(', ')'], "")),
    }
}

/// The keys, and for each row their values as a case takes them.
type Settings = (Vec<String>, Vec<Vec<String>>);

fn settings(arguments: &Sweep) -> Result<Settings, String> {
    let mut keys: Vec<String> = vec![];
    let mut split = |option: &str, like: &str| -> Result<String, String> {
        let (key, values) = option.split_once('=').ok_or(format!("`{option}`: write {like}"))?;
        let key = key.trim().to_owned();
        if keys.contains(&key) {
            return Err(format!("`{key}` is given twice"));
        }
        keys.push(key);
        Ok(values.trim().to_owned())
    };
    let mut rows: Vec<Vec<String>> = vec![vec![]];
    let key = |values: &str, why: String| format!("{values}: {why}");
    for option in &arguments.over {
        let values = split(option, "--over KEY=a,b,c or --over KEY=first:last:number")?;
        let values = list(&values).map_err(|why| key(option, why))?;
        let extended = |row: &Vec<String>| {
            let with = |value: &String| [&row[..], std::slice::from_ref(value)].concat();
            values.iter().map(with).collect::<Vec<_>>()
        };
        few(rows.len().saturating_mul(values.len()))?;
        rows = rows.iter().flat_map(extended).collect();
    }
    let mut distributions: Vec<Distribution> = vec![];
    for option in &arguments.sample {
        let text = split(option, "--sample KEY=normal(mean, deviation)")?;
        distributions.push(distribution(&text).map_err(|why| key(option, why))?);
    }
    if keys.is_empty() {
        return Err("a study goes over something: give --over KEY=VALUES or --sample".to_owned());
    }
    let Some(layout) = layout(arguments)? else { return Ok((keys, rows)) };
    let count = arguments.samples.map_or(1, |samples| samples.get());
    if layout != Layout::Latin && count > MOST {
        return Err(format!("a Sobol sequence has {MOST} points, fewer than the {count} samples"));
    }
    let dimensions = distributions.len();
    let each = if layout == Layout::Saltelli { dimensions + 2 } else { 1 };
    few(rows.len().saturating_mul(count).saturating_mul(each))?;
    let mut points = points(layout, (count, dimensions), arguments.seed);
    if let Some(correlation) = arguments.together {
        if layout == Layout::Saltelli {
            return Err("the coefficients of --from go together, and --design saltelli takes keys that do not: leave the \
                        design out, or give --sample with scatters of your own"
                .to_owned());
        }
        together(&mut points, correlation);
    }
    let drawn = |point: &Vec<f64>| -> Vec<String> {
        point.iter().zip(&distributions).map(|(share, known)| known.quantile(*share)).collect()
    };
    let samples: Vec<Vec<String>> = points.iter().map(drawn).collect();
    let with = |row: &Vec<String>| {
        samples.iter().map(|sample| [&row[..], sample].concat()).collect::<Vec<_>>()
    };
    Ok((keys, rows.iter().flat_map(with).collect()))
}

/// How samples are laid; `None` where there are none.
fn layout(arguments: &Sweep) -> Result<Option<Layout>, String> {
    match (arguments.sample.is_empty(), arguments.design) {
        (true, None | Some(Laid::Grid)) => Ok(None),
        (true, Some(_)) => {
            Err("this --design is one of samples: give --sample KEY=DISTRIBUTION".to_owned())
        }
        (false, Some(Laid::Grid)) => {
            Err("--design grid has no samples: leave it out, or --sample".to_owned())
        }
        (false, None | Some(Laid::Latin)) => Ok(Some(Layout::Latin)),
        (false, Some(Laid::Sobol)) => Ok(Some(Layout::Sobol)),
        (false, Some(Laid::Saltelli)) if !arguments.over.is_empty() => {
            Err("--design saltelli goes over samples alone: leave out --over".to_owned())
        }
        (false, Some(Laid::Saltelli)) => Ok(Some(Layout::Saltelli)),
    }
}

#[cfg(test)]
mod tests {
    use super::suffix;

    #[test]
    fn columns_name_their_units() {
        let units = ["", "N", "1/Pa", "m^3/(N m)", "W/(m K)", "m^2/s"].map(suffix);
        assert_eq!(units, ["", "_N", "_per_Pa", "_m3_per_Nm", "_W_per_mK", "_m2_per_s"]);
    }
}
