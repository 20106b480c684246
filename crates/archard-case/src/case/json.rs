//! What a check finds, for programs: problems with their places, the case in SI, what to expect.

use serde_json::{Map, Value, json};

use super::accuracy::GridRange;
use super::cam::CamForecast;
use super::check::{Solves, YieldLimit};
use super::elastic::ElasticForecast;
use super::file::CaseFile;
use super::gear::GearForecast;
use super::problem::{Location, Problem};
use super::resolved::{RunnableCase, Task};
use super::wheel_rail::WheelRailForecast;
use crate::output::{estimate_json, verdict_json};
use archard::body::mesh::MeshSurface;
use archard_gear::Station;
use archard_rail::search::Onset;
use archard_rail::setup::Side;

impl CaseFile {
    /// What a check of the case finds, as the command's `check --json` writes it: whether it is `valid`, its `problems` with
    /// key, file, line and column (from one on), and of a valid one the case in SI and what to expect (SI, units in the names).
    pub fn checked_json(&self) -> Value {
        match self.task() {
            Ok(task) => {
                let mut checked = json!({
                    "program": "archard",
                    "version": env!("CARGO_PKG_VERSION"),
                    "valid": true,
                    "problems": self.problems_json(task.warnings()),
                    "case": task.case_toml(),
                });
                let expected = match &task {
                    Task::Contact(resolved) => contact(resolved),
                    Task::Elastic(resolved) => elastic(&resolved.forecast),
                    Task::Cam(resolved) => cam(&resolved.forecast),
                    Task::Gear(resolved) => gear(&resolved.forecast),
                    Task::WheelRail(resolved) => wheel_rail(&resolved.forecast),
                };
                if let (Value::Object(checked), Value::Object(expected)) = (&mut checked, expected)
                {
                    checked.extend(expected);
                }
                checked
            }
            Err(problems) => json!({
                "program": "archard",
                "version": env!("CARGO_PKG_VERSION"),
                "valid": false,
                "problems": self.problems_json(&problems),
            }),
        }
    }

    fn problems_json(&self, problems: &[Problem]) -> Vec<Value> {
        let one = |problem: &Problem| {
            let mut value = json!({
                "severity": problem.severity.to_string(),
                "key": problem.key.to_string(),
                "message": problem.message,
                "help": problem.help,
            });
            if let Some(Location { source, span }) = &problem.location {
                let before = &self.text(*source)[..span.start];
                value["file"] = json!(self.name(*source));
                value["line"] = json!(before.matches('\n').count() + 1);
                let line = before.rsplit('\n').next().unwrap_or_default();
                value["column"] = json!(line.chars().count() + 1);
            }
            value
        };
        problems.iter().map(one).collect()
    }
}

fn solves_json(solves: Solves) -> Value {
    let (known, solves) = match solves {
        Solves::Exactly(solves) => ("exactly", solves),
        Solves::AtLeast(solves) => ("at least", solves),
        Solves::About(solves) => ("about", solves),
    };
    json!({ "known": known, "count": solves })
}

fn refined(GridRange { begins, elements, solves, memory }: GridRange) -> Value {
    json!({
        "begins": begins,
        "elements": elements,
        "contact_solves": solves_json(solves),
        "memory_bytes": memory,
    })
}

fn contact(resolved: &RunnableCase) -> Value {
    let forecast = &resolved.forecast;
    let unknowns: Map<String, Value> =
        forecast.unknowns.iter().map(|(body, count)| (body.clone(), json!(count))).collect();
    let surfaces: Map<String, Value> =
        forecast.files.iter().map(|(body, list)| (body.clone(), listed(list))).collect();
    let first_yield = |one: &YieldLimit| {
        (one.body.clone(), json!({ "peak_pressure_Pa": one.peak_pressure, "depth_m": one.depth }))
    };
    let first_yield: Map<String, Value> = forecast.yieldings.iter().map(first_yield).collect();
    json!({
        "first_yield": first_yield,
        "closed_form": estimate_json(&forecast.estimate),
        "elements_across": forecast.cells_across,
        "contact_solves": solves_json(forecast.solves),
        "pairs": forecast.pairs,
        "unknowns": unknowns,
        "surfaces": surfaces,
        "memory_bytes": forecast.memory,
        "refined": resolved.refined().map(refined),
        "verdict_foreseen": verdict_json(&forecast.verdict),
    })
}

fn elastic(forecast: &ElasticForecast) -> Value {
    let surfaces = forecast.surfaces.iter();
    let elements: Map<String, Value> =
        surfaces.map(|one| (one.name.clone(), json!(one.elements))).collect();
    json!({
        "elements": elements,
        "surfaces": listed(&forecast.surfaces),
        "unknowns": forecast.unknowns,
        "points": forecast.points,
        "memory_bytes": forecast.memory,
    })
}

fn cam(forecast: &CamForecast) -> Value {
    let station = |station: archard_gear::cam::Station| {
        json!({
            "angle_rad": station.angle,
            "lift_m": station.touch.lift,
            "load_N_per_m": station.load,
            "peak_pressure_Pa": station.peak_pressure,
            "half_width_m": station.half_width,
            "place_m": station.touch.place,
            "speeds_m_per_rad": station.touch.speeds,
        })
    };
    let stations: Vec<Value> = forecast.stations().into_iter().map(station).collect();
    json!({ "stations": stations })
}

fn gear(forecast: &GearForecast) -> Value {
    let Some(mesh) = &forecast.mesh else { return json!({}) };
    let station = |(letter, station): (&str, Station)| {
        json!({
            "letter": letter,
            "path_m": station.place,
            "load_share": station.load / mesh.load,
            "peak_pressure_Pa": station.peak_pressure,
            "half_width_m": station.half_width,
            "slid_m": [station.slide(0), station.slide(1)],
            "diameters_m": mesh.pair.diameters(station.place),
        })
    };
    let stations: Vec<Value> = forecast.stations().into_iter().map(station).collect();
    json!({
        "contact_ratio": mesh.pair.contact_ratio(),
        "working_pressure_angle_rad": mesh.pair.working_angle,
        "backlash_m": mesh.pair.backlash,
        "load_N_per_m": mesh.load,
        "stations": stations,
    })
}

fn wheel_rail(forecast: &WheelRailForecast) -> Value {
    let side = |(side, onset): &(Side, Onset)| {
        json!({
            "side": side.name(),
            "onset_m": onset.height,
            "first_touch_m": onset.at.point.to_array(),
        })
    };
    let sides: Vec<Value> = forecast.sides.iter().map(side).collect();
    json!({
        "roll_rad": forecast.roll,
        "sides": sides,
        "rolling_radius_difference_m": forecast.radius_difference,
        "equivalent_conicity": forecast.conicity,
        "points": forecast.points,
    })
}

/// The surfaces of a mesh, with the boxes around them (m).
fn listed(surfaces: &[MeshSurface]) -> Value {
    let one = |one: &MeshSurface| {
        json!({
            "name": one.name,
            "elements": one.elements,
            "touching": one.touching,
            "middle_m": one.middle,
            "size_m": one.size,
        })
    };
    surfaces.iter().map(one).collect()
}
