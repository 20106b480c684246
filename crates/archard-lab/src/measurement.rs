//! What a table has to say of a case: tests, readings, and the coefficients they tell of.

use super::Error;
use super::computed::Shapes;
use super::quantity::{KINDS, Kind, Quantity};
use super::surfaces::{self, Column, ScarReading};
use super::untold;
use super::{Files, MeasuredFile, Reading, Test};
use archard::units::Measure;
use archard_case::Case;
use archard_case::measured::Table;

/// Names of the columns that say how far a reading is, with the columns of the history that may be meant, best first.
const PROGRESS: [(&str, &[&str]); 7] = [
    ("distance", &["distance_m"]),
    ("turns", &["turns", "revolutions"]),
    ("revolutions", &["revolutions", "turns"]),
    ("cycles", &["cycle", "turns"]),
    ("cycle", &["cycle", "turns"]),
    ("time", &["time_s"]),
    ("share", &["share"]),
];

/// Most coefficients that are fitted together: each takes four times as many runs.
const MOST: usize = 3;

/// A coefficient and the tests that tell it.
#[derive(Debug, Clone)]
pub(super) struct Target {
    /// The key of the case.
    pub key: String,
    /// Its value in the case, and its unit in SI.
    pub value: f64,
    pub unit: String,
    /// The tests with what was measured for this coefficient.
    pub tests: Vec<Test>,
}

/// What was measured.
#[derive(Debug, Clone)]
pub(super) struct Measurement {
    pub quantities: Vec<Quantity>,
    /// The name of the column that says how far a reading is, and those of the history that may be meant.
    pub progress: (&'static str, &'static [&'static str]),
    pub targets: Vec<Target>,
    /// What was taken from profiles and height maps.
    pub surfaces: Vec<MeasuredFile>,
    /// What is to be said of the table.
    pub remarks: Vec<String>,
}

impl Measurement {
    /// Whether profiles are yet to be held against the shapes of runs.
    pub fn waits(&self) -> bool {
        self.surfaces.iter().any(|own| own.scar == ScarReading::Unmeasured)
    }

    /// Of a table, for the case; keys in the place of the coefficients of the bodies. Profiles are held against the shapes of runs; without
    /// them their values are yet to be found.
    pub fn of(
        table: &Table,
        case: &Case,
        (parameters, files): (&[String], Files<'_>),
        shapes: Option<&mut Shapes<'_, '_>>,
    ) -> Result<Self, Error> {
        let wearing: Vec<usize> = (0..2).filter(|&body| case.bodies[body].wear.is_some()).collect();
        let of = |key: &String| {
            let own = |&body: &usize| key.starts_with(&format!("body.{}.", case.bodies[body].name));
            wearing.iter().copied().find(own)
        };
        // Of several keys, where they are all of one body.
        let named = parameters
            .first()
            .and_then(of)
            .filter(|&body| parameters.iter().all(|key| of(key).is_none_or(|other| other == body)));
        let one = named.or_else(|| (wearing.len() == 1).then(|| wearing[0]));
        let progress = progress(table, case)?;
        let mut used: Vec<String> = vec!["test".into(), "load".into(), progress.0.into()];
        let (columns, surfaces) = columns((table, &mut used), (case, one), files, shapes)?;
        let used: Vec<&str> = used.iter().map(String::as_str).collect();
        let mut remarks = vec![];
        let others = table.others(&used);
        if !others.is_empty() {
            remarks.push(format!("columns that are not used: {}", others.join(", ")));
        }
        let (tests, at_start) = tests(table, &columns, progress.0)?;
        let quantities: Vec<Quantity> = columns.into_iter().map(|own| own.quantity).collect();
        if at_start > 0 {
            remarks.push(format!(
                "readings before anything has worn, which tell nothing of it: {at_start}"
            ));
        }
        remarks.extend(repeated(&tests));
        let targets = match parameters {
            [_, ..] => several(case, parameters, &tests)?,
            [] => {
                let own = |&body: &usize| quantities.iter().any(|quantity| quantity.body == body);
                let bodies = wearing.iter().copied().filter(own);
                bodies
                    .map(|body| {
                        let tests = of_body(&tests, &quantities, body);
                        target(case, coefficient(case, body)?, tests)
                    })
                    .collect::<Result<_, _>>()?
            }
        };
        Ok(Self { quantities, progress, targets, surfaces, remarks })
    }
}

/// The columns of readings, and what the files of a column were taken for; the names of columns are added to those used.
fn columns(
    (table, used): (&Table, &mut Vec<String>),
    (case, one): (&Case, Option<usize>),
    files: Files<'_>,
    mut shapes: Option<&mut Shapes<'_, '_>>,
) -> Result<(Vec<Column>, Vec<MeasuredFile>), Error> {
    let (mut found, mut surfaces) = (vec![], vec![]);
    let kinds = KINDS.map(|(column, kind)| (column, Some(kind)));
    for name in table.names() {
        for (column, kind) in kinds.iter().copied().chain([(surfaces::COLUMN, None)]) {
            let Some(body) = body_of((table, name), column, (case, one))? else { continue };
            used.push(name.to_owned());
            let Some(kind) = kind else {
                let (columns, taken) =
                    surfaces::read((table, name), (case, body), files, shapes.as_deref_mut())?;
                found.extend(columns);
                surfaces.extend(taken);
                continue;
            };
            if kind == Kind::Mass && case.bodies[body].density.is_none() {
                return Err(Error::Mismatch(format!(
                    "a mass tells a volume once the density is known: put body.{}.density into the case",
                    case.bodies[body].name
                )));
            }
            used.push(format!("u_{name}"));
            let measure = kind.measure();
            let Some(values) = table.numbers(name, &measure)? else { continue };
            let uncertainties = table.numbers(&format!("u_{name}"), &measure)?;
            let quantity = Quantity { name: name.to_owned(), kind, body };
            found.push(Column { quantity, values, uncertainties });
        }
    }
    // Columns that are empty ask for nothing besides others.
    let read = |column: &Column| column.values.iter().any(Option::is_some);
    if found.iter().any(read) {
        found.retain(read);
    }
    if found.is_empty() {
        let bodies = case.bodies.iter().filter(|body| body.wear.is_some());
        let bodies: Vec<String> = bodies.map(|body| format!("`_{}`", body.name)).collect();
        return Err(Error::Mismatch(format!(
            "{}: nothing that wears was measured: a column like `volume [mm3]`, `depth [um]`, `width [mm]`, `section [mm2]`, \
             `length [mm]`, `diameter [mm]`, `mass [mg]`, or `file` with the names of profiles and height maps is needed, its \
             name followed by {} where both bodies wear; there are {}",
            table.source(),
            bodies.join(" or "),
            table.titles()
        )));
    }
    Ok((found, surfaces))
}

/// The body that a column is of, if it is called so.
fn body_of(
    (table, name): (&Table, &str),
    column: &str,
    (case, one): (&Case, Option<usize>),
) -> Result<Option<usize>, Error> {
    let own = |body: &usize| name == format!("{column}_{}", case.bodies[*body].name.to_lowercase());
    let body = match (0..2).find(own) {
        Some(body) => body,
        None if name == column => one.ok_or_else(|| {
            let [a, b] = [0, 1].map(|body: usize| &case.bodies[body].name);
            Error::Mismatch(format!(
                "{}: both bodies of the case may be meant by the column `{name}`: name it `{name}_{a}` or `{name}_{b}`",
                table.source()
            ))
        })?,
        None => return Ok(None),
    };
    if case.bodies[body].wear.is_none() {
        return Err(Error::Mismatch(format!(
            "{}: the column `{name}` is of `{}`, which does not wear in the case",
            table.source(),
            case.bodies[body].name
        )));
    }
    Ok(Some(body))
}

/// The column that says how far readings are: that of the motion first.
fn progress(table: &Table, case: &Case) -> Result<(&'static str, &'static [&'static str]), Error> {
    let own = case.motion.build().map_err(|error| Error::Mismatch(error.to_string()))?.0.progress;
    let there = PROGRESS.iter().filter(|(name, _)| table.names().any(|known| known == *name));
    let mut there: Vec<_> = there.copied().collect();
    there.sort_by_key(|(_, columns)| {
        columns.iter().position(|column| *column == own.column).unwrap_or(9)
    });
    there.first().copied().ok_or_else(|| {
        let wanted = PROGRESS.iter().find(|(_, columns)| columns[0] == own.column);
        let wanted = match wanted {
            Some(("distance", _)) => "distance [m]",
            Some(("time", _)) => "time [s]",
            Some((name, _)) => name,
            None => own.name,
        };
        Error::Mismatch(format!(
            "{}: a column `{wanted}` is needed, which says how far each reading is; there are {}",
            table.source(),
            table.titles()
        ))
    })
}

/// The tests, and the number of readings at the very start.
fn tests(table: &Table, columns: &[Column], progress: &str) -> Result<(Vec<Test>, usize), Error> {
    let measure = match progress {
        "distance" => Measure::LENGTH,
        "time" => Measure::TIME,
        _ => Measure::NUMBER,
    };
    let far = table.all_numbers(progress, &measure)?;
    let loads = table.numbers("load", &Measure::FORCE)?;
    let names: Vec<String> = match table.texts("test") {
        Some(names) => names.into_iter().map(str::to_owned).collect(),
        None if table.len() == 1 => vec!["1".to_owned()],
        None => {
            return Err(Error::Mismatch(format!(
                "{}: a column `test` is needed, which says which readings are of one test; there are {}",
                table.source(),
                table.titles()
            )));
        }
    };
    let (mut tests, mut at_start): (Vec<Test>, usize) = (vec![], 0);
    for (row, &line) in table.lines().iter().enumerate() {
        let refuse = |why: String| Error::Reading { table: table.source().to_owned(), line, why };
        let name = &names[row];
        if name.is_empty() {
            return Err(refuse("the column `test` needs a name in every row".to_owned()));
        }
        let load = match &loads {
            None => None,
            Some(loads) => match loads[row] {
                Some(load) if load > 0.0 => Some(load),
                _ => return Err(refuse("the load has to be greater than zero".to_owned())),
            },
        };
        if far[row] < 0.0 {
            return Err(refuse(format!("`{progress}` is negative")));
        }
        let place = tests.iter().position(|test| test.name == *name).unwrap_or_else(|| {
            tests.push(Test { name: name.clone(), load, readings: vec![] });
            tests.len() - 1
        });
        let test = &mut tests[place];
        if test.load != load {
            return Err(refuse(format!(
                "test `{name}` has two loads; give tests names of their own"
            )));
        }
        if test.readings.last().is_some_and(|last| last.progress > far[row]) {
            return Err(refuse(format!(
                "`{progress}` goes back within test `{name}`: readings stand in the order they were taken in; if another test \
                 begins here, give it another name"
            )));
        }
        for (quantity, column) in columns.iter().enumerate() {
            let Some(value) = column.values[row] else { continue };
            let name = &column.quantity.name;
            let uncertainty = match column.uncertainties.as_ref().map(|all| all[row]) {
                None => None,
                Some(Some(own)) if own > 0.0 => Some(own / value),
                Some(_) => {
                    return Err(refuse(format!(
                        "`u_{name}` has to be greater than zero where there is a reading"
                    )));
                }
            };
            table.worn(row, (progress, far[row]), (name, value))?;
            if far[row] == 0.0 {
                at_start += 1;
                continue;
            }
            test.readings.push(Reading { line, quantity, progress: far[row], value, uncertainty });
        }
    }
    tests.retain(|test| !test.readings.is_empty());
    if tests.is_empty() {
        return Err(Error::Mismatch(format!("{}: no reading tells any wear", table.source())));
    }
    Ok((tests, at_start))
}

/// Tests and readings that stand in the table twice, as pasted ones do: they count as if they were others.
fn repeated(tests: &[Test]) -> Vec<String> {
    let same = |one: &Reading, other: &Reading| {
        (one.quantity, one.progress, one.value) == (other.quantity, other.progress, other.value)
    };
    let mut remarks = vec![];
    for (index, test) in tests.iter().enumerate() {
        for (place, reading) in test.readings.iter().enumerate() {
            let twin = |other: &&Reading| other.line != reading.line && same(other, reading);
            if let Some(other) = test.readings[..place].iter().find(twin) {
                remarks.push(format!(
                    "the readings of lines {} and {} are the same and count twice: see that none was pasted twice",
                    other.line, reading.line
                ));
            }
        }
        let alike = |other: &&Test| {
            let (one, other) = (&test.readings, &other.readings);
            one.len() > 1
                && one.len() == other.len()
                && one.iter().zip(other).all(|(one, other)| same(one, other))
        };
        if let Some(other) = tests[..index].iter().find(alike) {
            remarks.push(format!(
                "the tests `{}` and `{}` have the same readings and count as two: see that none was pasted twice",
                other.name, test.name
            ));
        }
    }
    remarks
}

/// The tests with the readings of a body alone.
fn of_body(tests: &[Test], quantities: &[Quantity], body: usize) -> Vec<Test> {
    let mut own = tests.to_vec();
    own.iter_mut().for_each(|test| test.readings.retain(|r| quantities[r.quantity].body == body));
    own.retain(|test| !test.readings.is_empty());
    own
}

/// The coefficients of a case, as options that fit them.
fn options(case: &Case) -> String {
    let laws = untold::laws(case).into_iter();
    let keys = laws.map(|(table, law)| format!("{table}.{law}.coefficient"));
    let keys = keys.filter(|key| case.number_at(key).is_some());
    keys.map(|key| format!("--parameter {key}")).collect::<Vec<_>>().join(" or ")
}

/// The key of the coefficient of a body.
fn coefficient(case: &Case, body: usize) -> Result<String, Error> {
    let own = &case.bodies[body];
    let law = own.wear.as_ref().map_or("", |wear| wear.choice.name);
    Ok(format!("body.{}.wear.{law}.coefficient", own.name))
}

/// The keys that are fitted from all tests.
fn several(case: &Case, keys: &[String], tests: &[Test]) -> Result<Vec<Target>, Error> {
    if keys.len() > MOST {
        return Err(Error::Mismatch(format!(
            "--parameter is given {} times: at most {MOST} coefficients are fitted together",
            keys.len()
        )));
    }
    let dotted: Vec<String> = keys.iter().map(|key| untold::dotted(key)).collect();
    if let Some(place) = (1..keys.len()).find(|&place| dotted[..place].contains(&dotted[place])) {
        return Err(Error::Mismatch(format!("--parameter {} is given twice", keys[place])));
    }
    keys.iter().map(|key| target(case, key.clone(), tests.to_vec())).collect()
}

fn target(case: &Case, key: String, tests: Vec<Test>) -> Result<Target, Error> {
    match case.number_at(&key) {
        Some((value, unit)) if value > 0.0 => Ok(Target { key, value, unit, tests }),
        Some(_) => Err(Error::Mismatch(format!(
            "`{key}` is fitted from the value in the case, which has to be greater than zero"
        ))),
        None => Err(Error::Mismatch(format!(
            "`{key}` is no number in the case: name the one to be fitted, like {}",
            options(case)
        ))),
    }
}
