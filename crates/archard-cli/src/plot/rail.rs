//! Pictures of a wheel on its rail: the wheel in the track, its patches, and what a route wears off.

use std::path::Path;

use anyhow::Result;
use archard_case::{CaseFile, Task};
use serde_json::{Map, Value};

use super::figure::{COLOURS, Curves, LegendPosition, OTHERS, PALE, Panel, Pen, Points};
use super::results::{mark, read_summary};
use super::rows::Rows;
use super::{OVERVIEW, Picture};

/// How many times a worn depth is drawn, at most, so that it is seen next to its profile: the largest of these that leaves it below
/// a tenth of the height.
const MAGNIFIED: [f64; 7] = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0];

/// What the folder of a wheel on a rail holds.
pub(crate) struct Rail {
    contacts: Rows,
    /// Depths over the profiles, and dimensions over the route; empty where nothing wears.
    wear: Rows,
    dimensions: Rows,
    pub(crate) summary: Value,
    pub(crate) mark: Option<String>,
    /// Points (y and z, m) of the rail and of the wheel in the track, for each side.
    outlines: Vec<[Points; 2]>,
}

/// Whether a folder is that of a wheel on a rail.
pub(crate) fn is_one(dir: &Path) -> bool {
    dir.join("contacts.csv").is_file() && !dir.join("history.csv").is_file()
}

impl Rail {
    /// Reads a folder.
    pub(crate) fn read(dir: &Path) -> Result<Self> {
        let summary = dir.join("summary.json");
        let summary: Option<Map<String, Value>> =
            if summary.is_file() { Some(read_summary(&summary)?) } else { None };
        let case = CaseFile::read(dir).ok().and_then(|file| file.task().ok());
        let outlines = match case {
            Some(Task::WheelRail(resolved)) => resolved.case.outlines().unwrap_or_default(),
            _ => vec![],
        };
        Ok(Self {
            contacts: Rows::read(&dir.join("contacts.csv"))?,
            wear: Rows::read(&dir.join("wear.csv"))?,
            dimensions: Rows::read(&dir.join("dimensions.csv"))?,
            mark: mark(summary.as_ref()),
            summary: summary.map_or(Value::Null, Value::Object),
            outlines,
        })
    }

    /// All pictures.
    pub(super) fn pictures(&self) -> Vec<Picture> {
        let mut pictures = vec![Picture::new("contact", self.contact()).sized(OVERVIEW)];
        if !self.wear.is_empty() {
            pictures.push(Picture::new("wear", self.worn()).sized(OVERVIEW));
            pictures.push(Picture::new("dimensions", self.course()).sized(OVERVIEW));
        }
        pictures
    }

    /// The wheel over its rail at the first point, and where patches lie on the wheel.
    pub(crate) fn contact(&self) -> Vec<Panel> {
        let mut panels = vec![];
        let sides = self.contacts.words("side");
        for (side, [rail, wheel]) in sides.iter().zip(&self.outlines) {
            let mut curves = Curves::new();
            curves.add(shown(rail), Pen::line(COLOURS[2]), Some("rail"));
            curves.add(shown(wheel), Pen::line(COLOURS[1]), Some("wheel"));
            let mut own = self.contacts.with("side", side);
            // Of a route the first point, of new profiles.
            for column in ["profiles", "point"] {
                if let Some(first) = own.words(column).first() {
                    own = own.with(column, first);
                }
            }
            let places = own.numbers("y_track_m", if side == "left" { -1.0 } else { 1.0 });
            let at = |y: f64| (1e3 * y, -1e3 * height(rail, y));
            curves.mark(places.into_iter().map(at), COLOURS[0], Some("contact"));
            let title = format!("The {side} wheel on its rail, as it touches first");
            let labels = [&*title, "y in the track (mm)", "Height (mm)"];
            let legend = LegendPosition::InsideBottomRight;
            panels.push(curves.panel(labels, |mut view| {
                view.to_scale = true;
                view.legend(legend)
            }));
        }
        let mut curves = Curves::new();
        let colours = [COLOURS[1], COLOURS[2]];
        let states = self.contacts.words("profiles");
        let states = if states.is_empty() { vec![String::new()] } else { states };
        for (state, colour) in states.iter().zip(colours) {
            let own =
                if state.is_empty() { None } else { Some(self.contacts.with("profiles", state)) };
            let own = own.as_ref().unwrap_or(&self.contacts);
            let points = own.numbers("y_wheel_m", 1e3).into_iter();
            let points = points.zip(own.numbers("peak_pressure_Pa", 1e-6));
            let legend = (!state.is_empty()).then(|| format!("{state} profiles"));
            curves.mark(points, colour, legend.as_deref());
        }
        let labels =
            ["Peak pressures of all patches", "y on the wheel (mm)", "Peak pressure (MPa)"];
        panels.push(curves.panel(labels, |view| view.above_y(0.0)));
        panels.push(self.shakedown(&states));
        panels
    }

    /// The shakedown map: the largest pressure of each patch, over the yield stress in shear, and the friction that it uses.
    fn shakedown(&self, states: &[String]) -> Panel {
        let mut curves = Curves::new();
        let limit = (0..=50).map(|step| 1e-2 * f64::from(step));
        let limit = limit.map(|friction| (friction, 1.0 / friction.max(0.25)));
        curves.add(limit, Pen::line(COLOURS[0]), Some("limit"));
        for (state, colour) in states.iter().zip([COLOURS[1], COLOURS[2]]) {
            let own =
                if state.is_empty() { None } else { Some(self.contacts.with("profiles", state)) };
            let own = own.as_ref().unwrap_or(&self.contacts);
            let column = |name: &str| own.numbers(name, 1.0).into_iter();
            let forces = column("force_x_N").zip(column("force_s_N")).zip(column("normal_force_N"));
            let used = forces.map(|((x, s), normal)| x.hypot(s) / normal);
            // The index is the friction used less the yield stress over the pressure.
            let points = used.zip(column("surface_fatigue_index"));
            let points = points.map(|(used, index)| (used, 1.0 / (used - index)));
            let points = points.filter(|(used, over)| used.is_finite() && over.is_finite());
            let legend = (!state.is_empty()).then(|| format!("{state} profiles"));
            curves.mark(points, colour, legend.as_deref());
        }
        let labels = [
            "Shakedown: above the line the steel flows at every passage",
            "Tangential over normal force",
            "Peak pressure over yield stress in shear",
        ];
        curves.panel(labels, |view| view.above_y(0.0))
    }

    /// Depths over the profiles with their errors, and the profiles with their wear magnified.
    pub(crate) fn worn(&self) -> Vec<Panel> {
        let mut panels = vec![];
        for body in self.wear.words("body") {
            let of_body = self.wear.with("body", &body);
            let mut depths = Curves::new();
            let mut damage = Curves::new();
            let mut shapes = Curves::new();
            let mut factor = 1.0;
            for (index, side) in of_body.words("side").iter().enumerate() {
                let own = of_body.with("side", side);
                let y = own.numbers("y_m", 1e3);
                let [depth, error] =
                    ["depth_m", "error_of_depth_m"].map(|name| own.numbers(name, 1e3));
                let places = y.iter().zip(depth.iter().zip(&error));
                let band = places.map(|(y, (depth, error))| [*y, depth - error, depth + error]);
                depths.band(band, PALE[1 + index % 2], 0.6, Some(&format!("{side}, error")));
                let line = y.iter().copied().zip(depth.iter().copied());
                depths.add(line, Pen::line(COLOURS[1 + index % 2]), Some(side));
                let cracked = own.numbers("crack_damage", 1.0);
                if cracked.iter().any(|value| !value.is_nan()) {
                    let errors = own.numbers("error_of_crack_damage", 1.0);
                    let band = y.iter().zip(cracked.iter().zip(&errors));
                    let band = band.map(|(y, (value, error))| [*y, value - error, value + error]);
                    damage.band(band, PALE[1 + index % 2], 0.6, Some(&format!("{side}, error")));
                    let line = y.iter().copied().zip(cracked);
                    damage.add(line, Pen::line(COLOURS[1 + index % 2]), Some(side));
                }
                let z = own.numbers("z_m", -1e3);
                let [y_worn, z_worn] =
                    [("y_worn_m", 1e3), ("z_worn_m", -1e3)].map(|(name, by)| own.numbers(name, by));
                let range = |values: &[f64]| {
                    let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
                    most - values.iter().copied().fold(f64::INFINITY, f64::min)
                };
                let deepest = depth.iter().copied().fold(0.0, f64::max);
                if index == 0 {
                    let fits = |by: &&f64| **by * deepest <= 0.1 * range(&z);
                    factor = MAGNIFIED.iter().rev().find(fits).copied().unwrap_or(1.0);
                    let new = y.iter().copied().zip(z.iter().copied());
                    shapes.add(new, Pen::broad(PALE[0]), Some("new"));
                }
                let moved = |at: usize| {
                    (y[at] + factor * (y_worn[at] - y[at]), z[at] + factor * (z_worn[at] - z[at]))
                };
                let worn = (0..y.len()).map(moved);
                shapes.add(worn, Pen::line(COLOURS[1 + index % 2]), Some(&format!("{side}, worn")));
            }
            let across = format!("y on the {body} (mm)");
            let title = format!("Depth worn off the {body}");
            panels.push(depths.panel([&title, &across, "Depth (mm)"], |view| view.above_y(0.0)));
            let title = format!("Damage of the {body} by cracks: at 1 one is expected");
            let damage = damage.panel([&title, &across, "Damage"], |view| view.above_y(0.0));
            panels.extend((!damage.marks.is_empty()).then_some(damage));
            let title = match factor {
                1.0 => format!("The {body}, new and worn"),
                _ => format!("The {body}, new and worn, its wear {factor} times as large"),
            };
            panels.push(shapes.panel([&title, &across, "Height (mm)"], |mut view| {
                view.to_scale = true;
                view
            }));
        }
        panels
    }

    /// The dimensions over the route: worn area, and how much the flange changes.
    pub(crate) fn course(&self) -> Vec<Panel> {
        let runs = self.dimensions.numbers("distance_m", 1e-3).into_iter().any(|km| km > 0.0);
        let (along, label, factor) =
            if runs { ("distance_m", "Distance (km)", 1e-3) } else { ("axles", "Axles", 1.0) };
        let mut panels = vec![];
        let mut add =
            |title: &str, unit: &str, by: f64, columns: &[(&str, &str)], changes: bool| {
                let mut curves = Curves::new();
                let colours = [COLOURS[1], COLOURS[2], OTHERS[0], OTHERS[1]];
                let mut colours = colours.iter().cycle();
                for side in self.dimensions.words("side") {
                    let own = self.dimensions.with("side", &side);
                    let x = own.numbers(along, factor);
                    for (column, words) in columns {
                        let values = own.numbers(column, by);
                        let errors = own.numbers(&format!("error_of_{column}"), by);
                        let start =
                            if changes { values.first().copied().unwrap_or(0.0) } else { 0.0 };
                        if values.iter().all(|value| value.is_nan() || *value == start) {
                            continue;
                        }
                        let Some(colour) = colours.next() else { continue };
                        let band = x.iter().zip(values.iter().zip(&errors));
                        let band = band.map(|(x, (value, error))| {
                            [*x, value - start - error, value - start + error]
                        });
                        curves.band(band, colour, 0.25, None);
                        let line = x.iter().copied().zip(values.iter().map(|value| value - start));
                        curves.add(line, Pen::line(*colour), Some(&format!("{words}, {side}")));
                    }
                }
                let panel = curves.panel([title, label, unit], |view| view);
                if !panel.marks.is_empty() {
                    panels.push(panel);
                }
            };
        let areas = [("wheel_worn_area_m2", "wheel"), ("rail_worn_area_m2", "rail")];
        add("Area worn off the section, with its error", "Area (mm\u{b2})", 1e6, &areas, false);
        let flange = [
            ("flange_height_m", "height Sh"),
            ("flange_thickness_m", "thickness Sd"),
            ("flange_gradient_m", "gradient qR"),
        ];
        add("Change of the flange, with its error", "Change (mm)", 1e3, &flange, true);
        let depths = [
            ("wheel_depth_m", "wheel, deepest"),
            ("tread_depth_m", "tread"),
            ("turning_depth_m", "to be turned off"),
            ("rail_depth_m", "rail, deepest"),
        ];
        add("Depth of wear, with its error", "Depth (mm)", 1e3, &depths, false);
        let cracks = [("wheel_crack_damage", "wheel"), ("rail_crack_damage", "rail")];
        add("Damage by cracks, with its error", "Damage", 1.0, &cracks, false);
        panels
    }
}

/// Points as they are shown: millimetres, upwards.
fn shown(points: &Points) -> Points {
    points.iter().map(|(y, z)| (1e3 * y, -1e3 * z)).collect()
}

/// z (m) of a rail where it first has that y (m).
fn height(rail: &Points, y: f64) -> f64 {
    let meets = |pair: &&[(f64, f64)]| (pair[0].0 - y) * (pair[1].0 - y) <= 0.0;
    let on_top = rail.windows(2).filter(meets).map(|pair| {
        let width = pair[1].0 - pair[0].0;
        let share = if width == 0.0 { 0.0 } else { (y - pair[0].0) / width };
        pair[0].1 + share * (pair[1].1 - pair[0].1)
    });
    on_top.fold(f64::INFINITY, f64::min)
}
