//! One row of numbers a step, by the columns of one table.
//!
//! [`COLUMNS`] is that table: a column is one entry of it. The names that others read by are constants,
//! in which `BODY` stands for the name of a body and arrays hold the names along x and y.

use super::companion::Companions;
use super::report::{Report, maximum};
use super::scar::{scar, track_width};
use super::worn::{exposed_area, layer_volume, mass_loss, wear_rate, worn_section, worn_volume};
use crate::body::Body;
use crate::motion::{Drives, Progress, Shift};
use crate::problem::{ContactState, Tangential};

/// What stands for the name of a body.
const BODY: &str = "BODY";

/// Normal force (N).
pub const LOAD: &str = "load_N";
/// Approach of the bodies from first touch (m).
pub const APPROACH: &str = "approach_m";
/// Largest pressure (Pa).
pub const PEAK_PRESSURE: &str = "peak_pressure_Pa";
/// Pressure at the centre of the frame (Pa).
pub const CENTRE_PRESSURE: &str = "centre_pressure_Pa";
/// Moment on body 1 about the normal (N m).
pub(super) const MOMENT: &str = "moment_z_Nm";
/// Energy dissipated in a cycle so far (J).
pub(super) const DISSIPATED: &str = "dissipated_J";
/// Area in contact (m^2).
pub const CONTACT_AREA: &str = "contact_area_m2";
/// Angle from the pole to the edge of the contact of bodies that fit into each other (deg).
pub const EDGE_ANGLE: &str = "edge_angle_deg";
/// Deepest imprint of each body that yields (m).
pub const IMPRINT: &str = "imprint_BODY_m";
/// Volume of its imprint (m^3).
pub const IMPRINT_VOLUME: &str = "imprint_volume_BODY_m3";
/// Worn volume of a body that does not roll (m^3).
pub const WORN_VOLUME: &str = "worn_volume_BODY_m3";
/// Worn volume of the layers of a body that does not roll (m^3).
pub const LAYER_VOLUME: &str = "worn_layers_BODY_m3";
/// Area where all layers of a body are worn off (m^2).
pub const EXPOSED_AREA: &str = "exposed_area_BODY_m2";
/// Mass worn off a body of known density (kg).
pub const MASS_LOSS: &str = "mass_loss_BODY_kg";
/// Worn section of a body that rolls, across the direction of rolling (m^2).
pub const WORN_SECTION: &str = "worn_section_BODY_m2";
/// Deepest wear of a body (m).
pub const BODY_DEPTH: &str = "wear_depth_BODY_m";
/// Deepest wear of both bodies together (m).
pub const WEAR_DEPTH: &str = "wear_depth_m";
/// Cycles gone through, as its own column or as the progress.
pub const CYCLE: &str = Progress::CYCLES.column;
/// Creepages along and across the direction of rolling, positive where body 1 is faster.
pub const CREEPAGE: [&str; 2] = ["creepage", "lateral_creepage"];
/// Displacements of body 2 over body 1 (m).
pub const SHIFT: [&str; 2] = ["shift_x_m", "shift_y_m"];
/// Tangential forces on body 1 (N).
pub const FORCE: [&str; 2] = ["force_x_N", "force_y_N"];
/// Worn volume of a body over load and distance (m^3/(N m)).
pub const WEAR_RATE: &str = "wear_rate_BODY_m3_per_Nm";
/// Extent of the scar on the body that stays, along the track and across (m).
pub const SCAR: [&str; 2] = ["scar_length_m", "scar_width_m"];
/// Width of the track on the body that passes (m).
pub const TRACK_WIDTH: &str = "track_width_m";
/// Turns, or strokes to and fro, so far.
const TURNS: &str = "turns";
/// Time so far (s).
const TIME: &str = Progress::TIME.column;
/// Area that sticks (m^2).
pub const STICK_AREA: &str = "stick_area_m2";
/// Column of the power of friction over the speed of rolling (N): T gamma.
pub const FRICTIONAL_POWER: &str = "frictional_power_per_speed_N";
/// Largest rise of the temperature by friction (K).
pub const FLASH_TEMPERATURE: &str = "flash_temperature_K";
/// Mean of that rise over the contact (K).
pub const MEAN_FLASH_TEMPERATURE: &str = "mean_flash_temperature_K";
/// Relative residual of a step's last solve.
pub(super) const RESIDUAL: &str = "residual";
/// Relative error of the depth from the division into steps; the only number that may be missing (NaN).
pub const TIME_ERROR: &str = "time_error";

/// Relative error of the worst of the quantities that count.
pub const ERROR: &str = "relative_error";
/// What the column of an error begins with; that of the quantity follows.
pub const ERROR_OF: &str = "error_of_";
/// The same in results of earlier versions, for the errors by the steps and by the elements, whose sum it is.
const EARLIER: [&str; 2] = ["time_error_of_", "space_error_of_"];

/// The error stated of a column, by what finds the number in a column.
pub fn stated(column: &str, number: impl Fn(&str) -> Option<f64>) -> Option<f64> {
    let earlier = || {
        let of = EARLIER.map(|prefix| number(&format!("{prefix}{column}")));
        of.into_iter().flatten().reduce(|one, other| one + other)
    };
    number(&format!("{ERROR_OF}{column}")).or_else(earlier)
}

/// Whether a column is the error of another one.
pub fn is_error(column: &str) -> bool {
    column.starts_with(ERROR_OF) || EARLIER.iter().any(|prefix| column.starts_with(prefix))
}

/// The numbers of a step, by column.
pub type Row = Vec<(String, f64)>;

/// What a run is judged by where bodies wear, always, and where they do not.
const OF_WEAR: [&str; 4] = [WORN_VOLUME, WORN_SECTION, BODY_DEPTH, WEAR_DEPTH];
const ALWAYS: [&str; 6] = [LOAD, APPROACH, FORCE[0], FORCE[1], CREEPAGE[0], CREEPAGE[1]];
const UNWORN: [&str; 1] = [CENTRE_PRESSURE];

/// A column of the history, or one for each body.
#[non_exhaustive]
#[derive(Debug)]
pub struct Column {
    /// Its name, which ends in the unit.
    pub name: &'static str,
    /// Its unit; empty for pure numbers.
    pub unit: &'static str,
    /// What it is.
    pub meaning: &'static str,
    /// How it converges.
    pub class: Class,
    value: Value,
}

/// How quantities converge in the size of elements and steps.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Class {
    /// The normal force.
    Load,
    /// Tangential forces, moments and the work that they do.
    Force,
    /// Creepages and shifts.
    Shift,
    /// The approach.
    Approach,
    /// A pressure or a temperature at a place, or a mean.
    Pressure,
    /// The largest of them.
    Peak,
    /// An area up to an edge between elements.
    Area,
    /// An area of whole elements.
    Count,
    /// What is worn in all.
    Volume,
    /// Depths of wear.
    Depth,
    /// What has no error, or one that is not known.
    Uncertain,
}

impl Class {
    /// Whether its errors grow with it as a run goes on; those of others may be as large where it is small.
    pub(super) fn grows(self) -> bool {
        !matches!(self, Self::Force | Self::Shift)
    }
}

/// The number in a report, of a body where there is a column for each; `None` in all reports of a run
/// that has no such column.
type Value = fn(&Report<'_>, usize) -> Option<f64>;
type Text = &'static str;

/// An entry of the table.
const fn column(name: Text, unit: Text, class: Class, meaning: Text, value: Value) -> Column {
    Column { name, unit, meaning, class, value }
}

/// The columns that follow the progress of the motion, in the order of the files.
pub const COLUMNS: &[Column] = &[
    column(LOAD, "N", Class::Load, "normal force", |r, _| Some(r.state.load)),
    column(APPROACH, "m", Class::Approach, "approach from first touch", |r, _| {
        Some(r.state.approach)
    }),
    column(PEAK_PRESSURE, "Pa", Class::Peak, "pressure of the highest element", |r, _| {
        Some(r.peak_pressure())
    }),
    column(
        CENTRE_PRESSURE,
        "Pa",
        Class::Pressure,
        "pressure at the centre of the frame",
        |r, _| Some(r.problem.frame.at_centre(&r.state.pressure) - r.effort.centre_lag),
    ),
    column(CONTACT_AREA, "m2", Class::Area, "area in contact", |r, _| {
        Some(r.state.contact_area(r.problem))
    }),
    column(
        EDGE_ANGLE,
        "deg",
        Class::Area,
        "angle from the pole to the edge of a contact in a socket or a bush",
        |r, _| edge_angle(r).map(f64::to_degrees),
    ),
    column(
        "contact_spots",
        "",
        Class::Uncertain,
        "regions in contact between rough surfaces",
        |r, _| rough(r).map(|r| r.state.spots(r.problem).count as f64),
    ),
    column("largest_spot_m2", "m2", Class::Uncertain, "area of the largest of them", |r, _| {
        rough(r).map(|r| r.state.spots(r.problem).largest)
    }),
    column("mean_gap_m", "m", Class::Uncertain, "mean gap between rough surfaces", |r, _| {
        rough(r).map(|r| r.state.mean_gap(r.problem))
    }),
    column(
        "rms_height_BODY_m",
        "m",
        Class::Uncertain,
        "rms height Sq of each body that is or wears rough",
        |r, i| uneven(r, i).map(|r| r.problem.spread(r.state, i)[0]),
    ),
    column("rms_gradient_BODY", "", Class::Uncertain, "its rms gradient Sdq", |r, i| {
        uneven(r, i).and_then(|r| r.problem.rms_gradient(r.state, i))
    }),
    column("skewness_BODY", "", Class::Uncertain, "its skewness Ssk", |r, i| {
        uneven(r, i).map(|r| r.problem.spread(r.state, i)[1])
    }),
    column(IMPRINT, "m", Class::Depth, "deepest imprint of each body that yields", |r, i| {
        yields(r, i).map(|r| maximum(&r.state.surfaces[i].imprint))
    }),
    column(IMPRINT_VOLUME, "m3", Class::Volume, "volume of that imprint", |r, i| {
        let volume = |r: &Report<'_>| r.problem.frame.integrate(&r.state.surfaces[i].imprint);
        yields(r, i).map(volume)
    }),
    column(
        WORN_VOLUME,
        "m3",
        Class::Volume,
        "worn off each body, off the whole track; not in rolling",
        worn_volume,
    ),
    column(
        WORN_SECTION,
        "m2",
        Class::Volume,
        "worn off the profile of each body that passes",
        worn_section,
    ),
    column(
        LAYER_VOLUME,
        "m3",
        Class::Volume,
        "the part of it that was worn off layers",
        layer_volume,
    ),
    column(
        EXPOSED_AREA,
        "m2",
        Class::Count,
        "area of the whole track where layers are worn off; not in rolling",
        exposed_area,
    ),
    column(
        MASS_LOSS,
        "kg",
        Class::Volume,
        "its mass, where the density is given; not in rolling",
        mass_loss,
    ),
    column(BODY_DEPTH, "m", Class::Depth, "deepest wear of each body", |r, i| {
        Some(r.wear_depth(i))
    }),
    column(WEAR_DEPTH, "m", Class::Depth, "deepest total wear", |r, _| Some(deepest(r.state))),
    column(WEAR_RATE, "m3_per_Nm", Class::Volume, "its volume over load and distance", wear_rate),
    column(
        SCAR[0],
        "m",
        Class::Uncertain,
        "length of the scar on the body that stays, along the track",
        |r, _| scar(r).map(|[along, _]| along),
    ),
    column(SCAR[1], "m", Class::Uncertain, "width of that scar, across the track", |r, _| {
        scar(r).map(|[_, across]| across)
    }),
    column(
        TRACK_WIDTH,
        "m",
        Class::Uncertain,
        "width of the track on the body that passes",
        |r, _| track_width(r),
    ),
    column(TURNS, "", Class::Uncertain, "turns, or strokes to and fro, so far", |r, _| {
        Some(r.state.progress / r.problem.motion.track()?.cycle())
    }),
    column(TIME, "s", Class::Uncertain, "time so far, where a speed is known", |r, _| {
        Some(r.state.progress / r.problem.motion.sliding_speed()?)
    }),
    column(
        CREEPAGE[0],
        "",
        Class::Shift,
        "creepage in rolling, positive where body 1 is faster",
        |r, _| rolling(r, |own, _| own.creepage[0]),
    ),
    column(CREEPAGE[1], "", Class::Shift, "creepage across the direction of rolling", |r, _| {
        rolling(r, |own, _| own.creepage[1])
    }),
    column(
        CYCLE,
        "",
        Class::Uncertain,
        "cycles gone through by bodies that are shifted, in parts",
        cycle,
    ),
    column(SHIFT[0], "m", Class::Shift, "displacement of body 2 over body 1 along x", |r, _| {
        shifted(r).and(friction(r, |own| own.shift[0]))
    }),
    column(SHIFT[1], "m", Class::Shift, "the same along y", |r, _| {
        shifted(r).and(friction(r, |own| own.shift[1]))
    }),
    column(FORCE[0], "N", Class::Force, "force on body 1 along x", |r, _| {
        friction(r, |_| r.force().unwrap_or_default()[0])
    }),
    column(FORCE[1], "N", Class::Force, "the same along y", |r, _| {
        friction(r, |_| r.force().unwrap_or_default()[1])
    }),
    column(
        MOMENT,
        "Nm",
        Class::Force,
        "in rolling: moment on body 1, positive from x to y",
        |r, _| rolling(r, |own, _| own.moment(&r.problem.frame)),
    ),
    column(
        STICK_AREA,
        "m2",
        Class::Count,
        "area of the elements under pressure that stick",
        |r, _| friction(r, |own| own.stick_area(r.problem, &r.state.pressure)),
    ),
    column(FRICTIONAL_POWER, "N", Class::Force, "power of friction over rolling speed", |r, _| {
        rolling(r, |own, rolling| own.creep_power(r.problem, rolling))
    }),
    column(
        FLASH_TEMPERATURE,
        "K",
        Class::Peak,
        "largest rise of the surfaces' temperature by friction",
        |r, _| Some(maximum(&r.problem.flash(r.state)?.rise)),
    ),
    column(
        MEAN_FLASH_TEMPERATURE,
        "K",
        Class::Pressure,
        "mean of that rise over the contact",
        |r, _| {
            let rise = r.problem.flash(r.state)?.rise;
            let touching = |pair: &usize| r.state.pressure[*pair] > 0.0;
            let area = |pair: usize| r.problem.frame.area(pair);
            let whole: f64 = (0..rise.len()).filter(touching).map(area).sum();
            let sum: f64 =
                (0..rise.len()).filter(touching).map(|pair| area(pair) * rise[pair]).sum();
            Some(if whole > 0.0 { sum / whole } else { 0.0 })
        },
    ),
    column(DISSIPATED, "J", Class::Force, "energy dissipated in the cycle so far", |r, _| {
        let swings = r.problem.motion.amplitude().is_some() && r.problem.friction.is_some();
        (swings || shifted(r).is_some()).then_some(r.effort.dissipated[0])
    }),
    column(
        "true_cycles",
        "",
        Class::Uncertain,
        "cycles computed so far, rejected ones included",
        |r, _| shifted(r).map(|_| r.effort.true_cycles as f64),
    ),
    column(
        "iterations",
        "",
        Class::Uncertain,
        "of the step's contact and friction solves",
        |r, _| Some(r.effort.iterations as f64),
    ),
    column(RESIDUAL, "", Class::Uncertain, "of the step's last solve", |r, _| {
        Some(r.effort.residual)
    }),
    column("solves", "", Class::Uncertain, "contact solves so far", |r, _| {
        Some(r.effort.solves as f64)
    }),
    column("rejected", "", Class::Uncertain, "rejected steps so far", |r, _| {
        Some(r.effort.rejected as f64)
    }),
    column(
        TIME_ERROR,
        "",
        Class::Uncertain,
        "relative error of the depth from the division into steps",
        |r, _| Some(r.effort.time_error.unwrap_or(f64::NAN)),
    ),
];

/// Whether a column is one that a run is judged by.
pub fn counts(name: &str, wears: bool) -> bool {
    let of = |columns: &[&str]| columns.iter().any(|column| is_of(column, name));
    of(&ALWAYS) || if wears { of(&OF_WEAR) } else { of(&UNWORN) }
}

/// How the quantity in a column converges.
pub(super) fn class(name: &str) -> Class {
    let known = COLUMNS.iter().find(|column| is_of(column.name, name));
    known.map_or(Class::Uncertain, |column| column.class)
}

/// Whether a column, or that of some body, has the name.
pub(super) fn is_of(column: &str, name: &str) -> bool {
    match column.split_once(BODY) {
        None => column == name,
        Some((start, end)) => name.starts_with(start) && name.ends_with(end),
    }
}

/// The numbers of a step by column: the progress, then [`COLUMNS`]. Steps of one run have the same ones.
pub fn row(report: &Report<'_>) -> Row {
    let Report { problem, state, .. } = report;
    let mut row = vec![(problem.motion.progress.column.to_owned(), state.progress)];
    for Column { name, value, .. } in COLUMNS {
        let bodies = if name.contains(BODY) { &problem.bodies[..] } else { &problem.bodies[..1] };
        let cell = |(i, body): (usize, &Body)| Some((of_body(name, &body.name), value(report, i)?));
        row.extend(bodies.iter().enumerate().filter_map(cell));
    }
    if let Some(companions) = report.companions {
        row.extend(errors(companions, &row));
    }
    row
}

/// The error of the worst quantity in a row, and of each of a class that has one; no number where no companion shows it.
fn errors(companions: &Companions, row: &Row) -> Row {
    let of = |(name, value): &(String, f64)| {
        let error = companions.stated(row, name, *value).unwrap_or(f64::NAN);
        (format!("{ERROR_OF}{name}"), error)
    };
    let stated = row.iter().filter(|(name, _)| companions.states(name));
    let worst = companions.worst(row).map_or(0.0, |(_, error)| error);
    let worst = (ERROR.to_owned(), worst);
    [worst].into_iter().chain(stated.map(of)).collect()
}

/// The row of a run whose wear coefficients are that share of those of the run it is taken from, where both have worn equally:
/// that share of the progress of the one is the progress of the other.
pub fn rescaled(row: &[(String, f64)], share: f64) -> Vec<(String, f64)> {
    let rescale = |(index, (name, value)): (usize, &(String, f64))| {
        let factor = match name.as_str() {
            _ if index == 0 => 1.0 / share,
            TURNS | TIME => 1.0 / share,
            name if body_of(WEAR_RATE, name).is_some() => share,
            _ => 1.0,
        };
        (name.clone(), factor * value)
    };
    row.iter().enumerate().map(rescale).collect()
}

/// The number in a column of a row.
pub fn number(row: &[(String, f64)], column: &str) -> Option<f64> {
    row.iter().find_map(|(known, value)| (known == column).then_some(*value))
}

/// The name of a column of each body for the body of that name.
pub fn of_body(column: &str, body: &str) -> String {
    column.replacen(BODY, body, 1)
}

/// The body whose column this is, if it is one of that name: the inverse of [`of_body`].
pub fn body_of<'a>(column: &str, name: &'a str) -> Option<&'a str> {
    let (start, end) = column.split_once(BODY)?;
    name.strip_prefix(start)?.strip_suffix(end)
}

/// Angle (rad) from the pole to the edge of a contact that is drawn on a round surface; `None` of others.
fn edge_angle(report: &Report<'_>) -> Option<f64> {
    let frame = &report.problem.frame;
    let wrap = frame.wrap()?;
    let length = if frame.is_line() { frame.size()[1] } else { 1.0 };
    Some(wrap.edge(report.state.contact_area(report.problem) / length))
}

/// A number of bodies that roll with friction; `None` of others.
fn rolling(report: &Report<'_>, value: impl Fn(&Tangential, &Drives) -> f64) -> Option<f64> {
    let drives = report.problem.motion.driven(report.state.progress)?;
    report.state.tangential.as_ref().map(|own| value(own, &drives))
}

/// A report of rough surfaces; `None` of others.
fn rough<'a, 'b>(report: &'b Report<'a>) -> Option<&'b Report<'a>> {
    Some(report).filter(|report| report.problem.is_rough())
}

/// A report of rough surfaces, for a body that is one or wears to be.
fn uneven<'a, 'b>(report: &'b Report<'a>, index: usize) -> Option<&'b Report<'a>> {
    let body = &report.problem.bodies[index];
    let measured = body.profile.places().iter().all(|places| !places.is_empty());
    rough(report).filter(|_| measured || body.wear.is_some())
}

/// A report, for a body that yields.
fn yields<'a, 'b>(report: &'b Report<'a>, index: usize) -> Option<&'b Report<'a>> {
    Some(report).filter(|report| report.problem.bodies[index].hardness.is_some())
}

/// How bodies with friction are shifted; `None` of others.
fn shifted<'a>(report: &Report<'a>) -> Option<&'a Shift> {
    let Report { problem, state, .. } = report;
    let rubs = problem.friction.is_some() || state.tangential.is_some();
    problem.motion.increments().filter(|_| rubs)
}

/// A number of bodies that roll or are shifted with friction, zero before it acts; `None` of others.
fn friction(report: &Report<'_>, value: impl Fn(&Tangential) -> f64) -> Option<f64> {
    match &report.state.tangential {
        Some(own) => Some(value(own)),
        None => shifted(report).map(|_| 0.0),
    }
}

/// Cycles gone through, where that is not the progress itself.
fn cycle(report: &Report<'_>, _: usize) -> Option<f64> {
    let counted = report.problem.motion.progress == Progress::CYCLES;
    shifted(report).filter(|_| !counted).map(|shift| report.state.progress / shift.period())
}

/// Deepest total wear (m).
fn deepest(state: &ContactState) -> f64 {
    maximum(&state.total_worn())
}

#[cfg(test)]
mod tests {
    use super::{BODY_DEPTH, COLUMNS, Progress, body_of, of_body};

    #[test]
    fn names_end_in_their_units() {
        for column in COLUMNS.iter().filter(|column| !column.unit.is_empty()) {
            assert!(column.name.ends_with(&format!("_{}", column.unit)), "{}", column.name);
        }
    }

    #[test]
    fn columns_know_their_bodies() {
        assert_eq!(of_body(BODY_DEPTH, "pin"), "wear_depth_pin_m");
        assert_eq!(body_of(BODY_DEPTH, "wear_depth_pin_m"), Some("pin"));
        assert_eq!(body_of(BODY_DEPTH, "wear_depth_m"), None);
    }

    /// The page on results has this table, and no other name besides it.
    #[test]
    fn the_book_describes_every_column() {
        let page = include_str!("../../../../book/src/results.md");
        let (_, section) = page.split_once("## Columns of the history\n").unwrap();
        let (section, _) = section.split_once("\n## ").unwrap();
        let progress = Progress::ALL.map(|progress| format!("`{}`", progress.column)).join(", ");
        let row = |name: &str, meaning| format!("| {name} | {meaning} |\n");
        let rows = COLUMNS.iter().map(|c| row(&format!("`{}`", c.name), c.meaning));
        let table = row("column", "meaning")
            + "|---|---|\n"
            + &row(&progress, "how far the motion has gone, in one of these columns")
            + &rows.collect::<String>();
        let Some(remarks) = section.strip_prefix(&format!("\n{table}\n")) else {
            panic!("`results.md` has to hold\n{table}");
        };
        let mut names = remarks.split('`').skip(1).step_by(2);
        let wrong = names.find(|name| !table.contains(&format!("`{name}`")));
        assert_eq!(wrong, None, "a name that is in no row of the table");
    }
}
