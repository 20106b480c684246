//! The files of a result folder, read back.

use std::path::{Path, PathBuf};

use anyhow::{Context, bail, ensure};
use archard::closed_form::Hertz;
use archard::closed_form::cattaneo_mindlin::PartialSlip;
use archard::closed_form::twin_discs::TwinDiscs;
use archard::frame::Direction;
use archard::motion::{Drives, Progress};
use archard::simulation::history::{
    BODY_DEPTH, CREEPAGE, FORCE, SHIFT, WEAR_DEPTH, of_body, stated,
};
use archard_case::files;
use archard_case::output::{Collection, Image, Manifest, Sheet, Surface};
use archard_case::{Case, CaseFile};
use serde_json::{Map, Value};

use super::scale::Unit;
use super::tables::{
    Axis, Profile, Table, largest, last_profile, read_history, read_loops, read_outputs,
    read_profiles, size,
};
use super::{LINE, below};

/// What a result folder holds.
pub(crate) struct Results {
    /// A value a step and column.
    pub(crate) history: Table,
    /// The sections of all outputs, in the order of time.
    pub(crate) profiles: Vec<Profile>,
    /// The transverse profiles of bodies that roll, at the last output.
    pub(crate) worn_profile: Option<Profile>,
    /// Force over shift of bodies that are shifted against each other, a table a cycle.
    pub(crate) loops: Vec<Table>,
    /// The fields of the last output, if there is one.
    pub(crate) image: Option<Image>,
    /// The same on the elements of a mesh, where bodies are meshed.
    pub(crate) surface: Option<Surface>,
    /// The names of the bodies; body 1 first.
    pub(crate) bodies: Vec<String>,
    /// The case, where it can still be read.
    pub(crate) case: Option<Case>,
    /// Surfaces that swing, from end to end, at the last output.
    pub(crate) lengths: Option<Profile>,
    /// What shares of rough surfaces reach, a table an output.
    pub(crate) distributions: Vec<Table>,
    /// Sections through the bodies, by their names.
    pub(crate) sheets: Vec<(String, Sheet)>,
    /// What the run ended with; null until it has.
    pub(crate) summary: Value,
    /// What closed forms start from; null until a run has ended.
    pub(crate) closed_form: Value,
    /// What pictures have to say of a run that is incomplete, doubtful or wrong.
    pub(crate) mark: Option<String>,
}

/// Share of the width of a contact that is shown on either side of it.
const MARGIN: f64 = 0.125;

/// The ends of what holds a place too.
fn with([low, high]: [f64; 2], place: f64) -> [f64; 2] {
    [low.min(place), high.max(place)]
}

/// Whether a place lies in a window.
pub(crate) fn within([low, high]: [f64; 2], place: f64) -> bool {
    (low..=high).contains(&place)
}

/// How far a window reaches from the centre.
pub(crate) fn reach([low, high]: [f64; 2]) -> f64 {
    low.abs().max(high.abs())
}

/// A sphere worn on a flat, as eq. 55 takes it.
pub(crate) struct WornSphere {
    /// Radius (m).
    pub(crate) radius: f64,
    /// Wear coefficient of both bodies together (1/Pa).
    pub(crate) coefficient: f64,
}

impl Results {
    /// Reads a result folder.
    pub(crate) fn read(dir: &Path) -> anyhow::Result<Self> {
        let history = dir.join("history.csv");
        ensure!(
            !dir.join("surface.vtu").is_file(),
            "`{}` holds an elastic body, of which no pictures are drawn: open its surface.vtu in ParaView",
            dir.display()
        );
        ensure!(
            history.exists() || !dir.join("fit.json").is_file(),
            "`{0}` holds a fit: its picture is `{0}/fit.png`, and `archard report {0}` makes a page of it",
            dir.display()
        );
        ensure!(
            history.exists() || !dir.join("checkpoint").is_file(),
            "`{0}` holds a route that was interrupted: go on with `archard run --resume {0}`",
            dir.display()
        );
        ensure!(
            history.exists(),
            "`{}` is not a result folder: it has no history.csv",
            dir.display()
        );
        Manifest::read(dir)?.verify()?;
        let history = read_history(&history)?;
        if history.rows() == 0 {
            bail!("`{}` has no results yet: its history.csv has no rows", dir.display());
        }
        let profiles = dir.join("profiles.csv");
        let worn_profiles = dir.join("worn_profiles.csv");
        let loops = dir.join("fretting_loop.csv");
        let summary = dir.join("summary.json");
        let summary = if summary.exists() { Some(read_summary(&summary)?) } else { None };
        let lengths = dir.join("length_profiles.csv");
        let distributions = dir.join("distributions.csv");
        Ok(Self {
            bodies: history.bodies(),
            profiles: if profiles.exists() { read_profiles(&profiles)? } else { Vec::new() },
            worn_profile: match worn_profiles.exists() {
                // The one place of a line of contact shows no shape.
                true => last_profile(&worn_profiles)?.filter(|profile| profile.table.rows() > 1),
                false => None,
            },
            loops: if loops.exists() { read_loops(&loops)? } else { Vec::new() },
            case: CaseFile::read(dir).ok().and_then(|file| Some(file.resolve().ok()?.case)),
            image: last_image(dir)?,
            surface: last_surface(dir)?,
            mark: mark(summary.as_ref()),
            distributions: match distributions.exists() {
                true => read_outputs(&distributions)?,
                false => Vec::new(),
            },
            lengths: if lengths.exists() { last_profile(&lengths)? } else { None },
            closed_form: summary
                .as_ref()
                .and_then(|summary| summary.get("closed_form").cloned())
                .unwrap_or_default(),
            summary: summary.map_or(Value::Null, Value::Object),
            sheets: below::sheets(dir)?,
            history,
        })
    }

    /// Whether any body has worn.
    pub(crate) fn wears(&self) -> bool {
        self.history.column(WEAR_DEPTH).is_ok_and(|depths| largest(depths) > 0.0)
    }

    /// The error that a run states for a column, in the unit of the column; `None` where it states none.
    pub(crate) fn error(&self, column: &str) -> Option<Vec<f64>> {
        let rows = 0..self.history.first().1.len();
        let number =
            |row: usize| move |name: &str| self.history.column(name).ok().map(|column| column[row]);
        rows.map(|row| stated(column, number(row))).collect()
    }

    /// The column that measures how far the motion has gone.
    pub(crate) fn progress(&self) -> (&str, &[f64]) {
        self.history.first()
    }

    /// The unit to show the progress in.
    pub(crate) fn progress_unit(&self) -> Unit {
        let (column, values) = self.progress();
        Unit::of_column(column, largest(values))
    }

    /// Whether there is one element along an axis only, so that a section shows nothing.
    pub(crate) fn is_one_element(&self, axis: Axis) -> bool {
        self.image.as_ref().is_some_and(|image| image.elements[axis.index()] == 1)
    }

    /// The axes whose sections show something: all of them, or that across a line of contact.
    pub(crate) fn shown_axes(&self) -> Vec<Axis> {
        [Axis::X, Axis::Y].into_iter().filter(|axis| !self.is_one_element(*axis)).collect()
    }

    /// What places along an axis of the frame are called: on bodies that fit into each other they lie on a round surface.
    pub(crate) fn place(&self, axis: Axis) -> String {
        let on = self.summary.get("coordinates").and_then(|own| own.get("on")?.as_str());
        match (on, axis) {
            (Some("sphere"), _) => format!("{} on the equal-area map", axis.name()),
            (Some("cylinder"), Axis::X) => "Arc x".to_owned(),
            _ => axis.name().to_owned(),
        }
    }

    /// The axis along which a surface passes on a track.
    fn track(&self) -> Option<Axis> {
        let (motion, _) = self.case.as_ref()?.motion.build().ok()?;
        motion.track()?;
        Some(if motion.direction.axis == 1 { Axis::Y } else { Axis::X })
    }

    /// The axis along which the surface of a body passes, and is worn equally.
    pub(crate) fn passes(&self, body: usize) -> Option<Axis> {
        let (motion, _) = self.case.as_ref()?.motion.build().ok()?;
        let (along, _) = motion.grooves().filter(|(_, bodies)| bodies[body])?;
        Some(if along.axis == 1 { Axis::Y } else { Axis::X })
    }

    /// The axis along which the worn shapes say most: across a track, along the motion else.
    pub(crate) fn shape_axis(&self) -> Axis {
        match self.track() {
            Some(Axis::X) => Axis::Y,
            Some(Axis::Y) => Axis::X,
            None => self.axes()[0],
        }
    }

    /// Whether the bodies roll.
    pub(crate) fn rolls(&self) -> bool {
        self.history.column(CREEPAGE[0]).is_ok()
    }

    /// Whether friction acts between bodies that are pressed and shifted against each other.
    pub(crate) fn rubs(&self) -> bool {
        !self.rolls() && self.history.column(FORCE[0]).is_ok()
    }

    /// The axis along which they are shifted most; x where they are not.
    pub(crate) fn shift_axis(&self) -> Axis {
        let reach = |column: &str| size(self.history.column(column).unwrap_or_default());
        if reach(SHIFT[1]) > reach(SHIFT[0]) { Axis::Y } else { Axis::X }
    }

    /// Whether they roll at creepages raised step by step.
    pub(crate) fn sweeps(&self) -> bool {
        self.rolls() && self.progress().0 == Progress::SHARE.column
    }

    /// Where they roll to, and what drives them at the end.
    pub(crate) fn rolling(&self) -> Option<(Direction, Drives)> {
        let (motion, schedule) = self.case.as_ref()?.motion.build().ok()?;
        Some((motion.direction, motion.driven(schedule.extent)?))
    }

    /// The axis along which they roll or are shifted and the one across.
    pub(crate) fn axes(&self) -> [Axis; 2] {
        let along = match self.rolling() {
            Some((direction, _)) if direction.axis == 1 => Axis::Y,
            Some(_) => Axis::X,
            None => self.shift_axis(),
        };
        if along == Axis::Y { [Axis::Y, Axis::X] } else { [Axis::X, Axis::Y] }
    }

    /// The largest tractions (Pa) along an axis under these pressures (Pa), where the law of friction is known.
    pub(crate) fn friction_limits(&self, pressures: &[f64], axis: Axis) -> Option<Vec<f64>> {
        let law = self.case.as_ref()?.friction.as_ref()?.build().ok()?;
        let direction = if axis == Axis::X { [1.0, 0.0] } else { [0.0, 1.0] };
        let resistance = law.map().resistance(direction);
        Some(pressures.iter().map(|pressure| resistance * law.limit(*pressure)).collect())
    }

    /// Whether the body of that index has worn.
    pub(crate) fn has_worn(&self, body: usize) -> bool {
        let column = self.bodies.get(body).map(|body| of_body(BODY_DEPTH, body));
        let depths = column.and_then(|name| self.history.column(&name).ok());
        depths.is_some_and(|depths| largest(depths) > 0.0)
    }

    /// Whether body 2 has worn.
    pub(crate) fn worn_below(&self) -> bool {
        self.has_worn(1)
    }

    /// The outputs to show along an axis: at most `count`, spread over the run with its first and
    /// last, without those before the bodies touch.
    pub(crate) fn sections(&self, axis: Axis, count: usize) -> Vec<&Profile> {
        let touches = |profile: &Profile| {
            profile.table.column("pressure_Pa").is_ok_and(|values| largest(values) > 0.0)
        };
        let all: Vec<&Profile> = self
            .profiles
            .iter()
            .filter(|profile| profile.axis == axis && touches(profile))
            .collect();
        let shown = all.len().min(count);
        (0..shown).map(|i| all[i * (all.len() - 1) / (shown - 1).max(1)]).collect()
    }

    /// The places (m) from which to which pictures need to reach along an axis: the contacts of all outputs and an eighth of
    /// their width on either side, within the frame.
    pub(crate) fn window(&self, axis: Axis) -> anyhow::Result<[f64; 2]> {
        let none = [f64::INFINITY, f64::NEG_INFINITY];
        let (mut contact, mut frame) = (none, none);
        for profile in self.profiles.iter().filter(|profile| profile.axis == axis) {
            let places = profile.table.column("coordinate_m")?;
            let pressures = profile.table.column("pressure_Pa")?;
            for (place, pressure) in places.iter().zip(pressures) {
                frame = with(frame, *place);
                if *pressure > 0.0 {
                    contact = with(contact, *place);
                }
            }
        }
        ensure!(frame[0] <= frame[1], "`profiles.csv` has no places along {axis:?}");
        let [low, high] = contact;
        Ok(match low < high {
            true => [low - MARGIN * (high - low), high + MARGIN * (high - low)],
            false => frame,
        }
        .map(|end| end.clamp(frame[0], frame[1])))
    }

    /// The same of maps, which also hold what touches away from the sections at the last output.
    pub(crate) fn map_window(&self, axis: Axis) -> anyhow::Result<[f64; 2]> {
        let window = self.window(axis)?;
        let Some(image) = &self.image else { return Ok(window) };
        let Some(pressure) = image.field("pressure_Pa") else { return Ok(window) };
        let (axis, columns) = (axis.index(), image.elements[0]);
        let pressed = (0..pressure.len()).filter(|&pair| pressure[pair] > 0.0);
        let places = pressed.map(|pair| image.centre(axis, [pair % columns, pair / columns][axis]));
        let [low, high] = places.fold(window, with);
        let margin = MARGIN * (high - low);
        let ends = [0, image.elements[axis] - 1].map(|index| image.centre(axis, index));
        let wide = [(low - margin).max(ends[0]), (high + margin).min(ends[1])];
        Ok(if [low, high] == window { window } else { wide })
    }

    /// The places (m) from which to which worn shapes need to be shown along an axis: as far as the contact, and a twentieth
    /// of its width beyond the widest scar, which is wider where surfaces swing.
    pub(crate) fn worn_window(&self, axis: Axis) -> anyhow::Result<[f64; 2]> {
        let mut window = self.window(axis)?;
        for profile in self.profiles.iter().filter(|profile| profile.axis == axis) {
            let places = profile.table.column("coordinate_m")?;
            for body in &self.bodies {
                let worn = profile.table.column(&format!("wear_{body}_m"))?;
                let least = LINE * size(worn);
                let scar = || places.iter().zip(worn).filter(|(_, worn)| **worn > least);
                // What passes along the axis is worn all along it.
                if scar().count() < places.len() {
                    let none = [f64::INFINITY, f64::NEG_INFINITY];
                    let [low, high] = scar().fold(none, |ends, (place, _)| with(ends, *place));
                    let ends = places.iter().fold(none, |ends, place| with(ends, *place));
                    let margin = 0.05 * (high - low);
                    if low < high {
                        window[0] = window[0].min((low - margin).max(ends[0]));
                        window[1] = window[1].max((high + margin).min(ends[1]));
                    }
                }
            }
        }
        Ok(window)
    }

    /// The Hertz contact of the unworn bodies under a load (N), where they have one.
    pub(crate) fn hertz(&self, load: f64) -> Option<Hertz> {
        let curvature = |axis: usize| self.closed_form["curvatures_per_m"][axis].as_f64();
        let modulus = self.closed_form["contact_modulus_Pa"].as_f64()?;
        Hertz::from_load([curvature(0)?, curvature(1)?], modulus, load)
    }

    /// The worn sphere of eq. 55, where the run was one.
    pub(crate) fn worn_sphere(&self) -> Option<WornSphere> {
        let block = &self.closed_form["pin_on_disc"];
        Some(WornSphere {
            radius: block["radius_m"].as_f64()?,
            coefficient: block["coefficient_per_Pa"].as_f64()?,
        })
    }

    /// Cattaneo's sphere between the extremes of its shift (m), and the axis along which it goes.
    pub(crate) fn partial_slip(&self) -> Option<(PartialSlip, f64, Axis)> {
        let block = &self.closed_form["cattaneo_mindlin"];
        let number = |key: &str| block[key].as_f64();
        let contact = PartialSlip {
            contact_radius: number("contact_radius_m")?,
            peak_pressure: number("peak_pressure_Pa")?,
            friction: number("friction_coefficient")?,
            sliding_force: number("sliding_force_N")?,
            sliding_shift: number("sliding_shift_m")?,
        };
        let axis = if block["axis"] == "y" { Axis::Y } else { Axis::X };
        Some((contact, number("shift_amplitude_m")?, axis))
    }

    /// The end of fretting wear: its greatest depth (m) and volume (m^3).
    pub(crate) fn worn_out(&self) -> Option<[f64; 2]> {
        let block = &self.closed_form["fretting_wear"];
        Some([block["wear_depth_m"].as_f64()?, block["worn_volume_m3"].as_f64()?])
    }

    /// The worn discs of the incremental model, where the run was one of those.
    pub(crate) fn worn_discs(&self) -> Option<TwinDiscs> {
        let number = |key: &str| self.closed_form["twin_discs"][key].as_f64();
        Some(TwinDiscs {
            coefficient: number("coefficient_per_Pa")?,
            creepage: number("creepage")?,
            crown: number("crown_m")?,
            half_width: number("half_width_m")?,
        })
    }
}

/// The file of the last output that the collection lists.
fn last_output(dir: &Path) -> anyhow::Result<Option<PathBuf>> {
    let path = dir.join("fields.pvd");
    if !path.exists() {
        return Ok(None);
    }
    Ok(Collection::read(&path)?.outputs.last().map(|(_, file)| dir.join(file)))
}

fn last_image(dir: &Path) -> anyhow::Result<Option<Image>> {
    Ok(last_output(dir)?.map(|file| Image::of_output(&file)).transpose()?)
}

fn last_surface(dir: &Path) -> anyhow::Result<Option<Surface>> {
    let meshed = |file: &PathBuf| file.extension().is_some_and(|extension| extension == "vtu");
    Ok(last_output(dir)?.filter(meshed).map(|file| Surface::read(&file)).transpose()?)
}

/// The summary of a run.
pub(super) fn read_summary(path: &Path) -> anyhow::Result<Map<String, Value>> {
    let context = || format!("cannot read `{}`", path.display());
    let text = files::read_text(path).with_context(context)?;
    match serde_json::from_str(&text).with_context(context)? {
        Value::Object(summary) => Ok(summary),
        _ => bail!("`{}` is not the summary of a run", path.display()),
    }
}

/// What pictures have to say besides what they show: that a run is incomplete or its result doubtful or wrong.
pub(super) fn mark(summary: Option<&Map<String, Value>>) -> Option<String> {
    let Some(summary) = summary else { return Some("incomplete: the run has not ended".into()) };
    let verdict = &summary.get("verdict").unwrap_or(&Value::Null);
    let lines = verdict["lines"].as_array().map_or(&[][..], Vec::as_slice);
    let of = |word: &str| -> Vec<&str> {
        let these = lines.iter().filter(|line| line["word"] == word);
        these.filter_map(|line| line["subject"].as_str()).collect()
    };
    let ended = summary.get("complete") == Some(&Value::Bool(true));
    let parts = [
        (!ended).then(|| "incomplete: the run stopped before its end".to_owned()),
        Some(of("wrong").into_iter().filter(|subject| *subject != "complete").collect::<Vec<_>>())
            .filter(|these| !these.is_empty())
            .map(|w| format!("the result is wrong: {}", w.join(", "))),
        Some(of("doubtful"))
            .filter(|these| !these.is_empty())
            .map(|these| format!("doubtful: {}", these.join(", "))),
    ];
    let parts: Vec<String> = parts.into_iter().flatten().collect();
    (!parts.is_empty()).then(|| parts.join("; "))
}
