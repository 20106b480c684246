//! What came out of a run, in words.

use std::path::{Path, PathBuf};

use archard::frame::Direction;
use archard::motion::{Control, Progress, Shift};
use archard::simulation::history::{
    self, BODY_DEPTH, CREEPAGE, ERROR, EXPOSED_AREA, FORCE, FRICTIONAL_POWER, IMPRINT,
    IMPRINT_VOLUME, LAYER_VOLUME, MASS_LOSS, SCAR, STICK_AREA, TRACK_WIDTH, WEAR_DEPTH, WEAR_RATE,
    WORN_SECTION, WORN_VOLUME, of_body, stated,
};
use archard::simulation::{Effort, Simulation};
use archard_case::Forecast;
use archard_case::output::{Life, Totals};
use archard_case::verdict::Verdict;
use serde_json::Value;

use crate::below;
use crate::failure::Failure;
use crate::lines::Lines;
use crate::lives;
use crate::number::{count, energy, four, length, mass, of_a_line, percent, progress};
use crate::progress::Follower;
use crate::standards;
use crate::verdict;
use archard::numerics::{SAME, WRITTEN};

/// How a number (SI) is written.
type Shown = fn(f64) -> String;

/// What came of a run.
pub struct Outcome<'a> {
    pub simulation: &'a Simulation,
    /// Where a limit was reached.
    pub life: &'a Life,
    pub forecast: &'a Forecast,
    pub follower: &'a Follower,
    pub totals: &'a Totals,
    /// The stresses below the surfaces, as the summary has them.
    pub stresses: &'a Value,
    pub effort: Effort,
    pub verdict: &'a Verdict,
    /// Whether checks that are good are listed too.
    pub verbose: bool,
    pub dir: &'a Path,
    /// The page about it, if there is one.
    pub page: Option<PathBuf>,
}

impl Outcome<'_> {
    /// Says what came out, whether it can be believed, and where it is.
    ///
    /// # Errors
    /// If standard output cannot be written.
    pub fn say(&self) -> Result<(), Failure> {
        let Self { simulation, totals, verdict, .. } = self;
        let mut lines = Lines::default();
        for (what, column, factor, unit) in [
            ("peak pressure", history::PEAK_PRESSURE, 1e-6, "MPa"),
            ("approach", history::APPROACH, 1e6, "um"),
            ("contact area", history::CONTACT_AREA, 1e6, "mm^2"),
        ] {
            let value = format!("{} {unit}", four(self.last(column) * factor));
            match simulation.schedule.control {
                Control::Approach(_) if column == history::APPROACH => {
                    lines.add(what, value, "prescribed".to_owned());
                    let load = format!("{} N", four(self.last(history::LOAD)));
                    lines.add("load", load, self.error(&[history::LOAD]));
                }
                _ => lines.add(what, value, self.error(&[column])),
            }
        }
        let frame = &simulation.problem.frame;
        if frame.is_line() {
            lines.add("line of contact", of_a_line(frame.size()[1]), String::new());
        }
        if let Some(wrap) = frame.wrap() {
            let angle = four(self.last(history::EDGE_ANGLE));
            let value = format!("{angle} deg from the pole; {}", wrap.coordinates());
            lines.add("edge of contact", value, String::new());
        }
        let motion = &simulation.problem.motion;
        if motion.driven(0.0).is_some() {
            self.rolled(motion.direction, &mut lines);
        }
        if let Some(shift) = motion.increments() {
            self.shifted(shift, &mut lines);
        }
        if let Some(largest) = self.follower.number(history::FLASH_TEMPERATURE) {
            let [largest, mean] = [largest, self.last(history::MEAN_FLASH_TEMPERATURE)].map(four);
            let value = format!("{largest} K at most, {mean} K in the mean");
            lines.add("flash temperature", value, String::new());
        }
        self.pressed_in(&mut lines);
        if simulation.problem.wears() {
            self.worn(&mut lines);
        }
        below::add(self.stresses, &mut lines);
        self.lasted(&mut lines);
        let Effort { steps, solves, .. } = self.effort;
        let time = format!("{:.2} s, {steps} steps, {solves} solves", totals.seconds);
        lines.add("time", time, String::new());
        lines.add("results", self.dir.display().to_string(), String::new());
        if let Some(page) = &self.page {
            lines.add("report", page.display().to_string(), String::new());
        }
        lines.add("verdict", verdict::headline(verdict), String::new());
        lines.say()?;
        verdict::say_lines(verdict, self.verbose)
    }

    /// Adds how far it is to the first limit that is reached, or that it is farther than the motion goes.
    fn lasted(&self, lines: &mut Lines) {
        let Self { life, simulation, .. } = self;
        let motion = simulation.problem.motion.progress;
        let scatter = |lines: &mut Lines| {
            let own = life.lives().map(|lives| lives::lines(lives, motion)).unwrap_or_default();
            own.into_iter().for_each(|(name, words)| lines.add(name, words, String::new()));
        };
        let Some(reached) = life.reached() else {
            if !life.limits().is_empty() {
                let whole = progress(motion, simulation.schedule.extent);
                lines.add("life", format!("beyond {whole}: no limit is reached"), String::new());
                scatter(lines);
            }
            return;
        };
        let error = reached.error.map(|error| format!("+- {}", percent(error / reached.progress)));
        let mut value = progress(motion, reached.progress);
        if let Some(time) = reached.time.filter(|_| motion != Progress::TIME) {
            value += &format!(", {} h", four(time / 3600.0));
        }
        value += &format!(", {}", reached.limit);
        lines.add("life", value, error.unwrap_or_default());
        scatter(lines);
    }

    /// A number at the end; zero where none exists.
    fn last(&self, column: &str) -> f64 {
        self.follower.number(column).unwrap_or(0.0)
    }

    /// Adds what is pressed into each body that yields.
    fn pressed_in(&self, lines: &mut Lines) {
        let shown: [(&str, &str, Shown); 2] = [
            ("imprint", IMPRINT, |depth| format!("{} um", four(depth * 1e6))),
            ("pressed in", IMPRINT_VOLUME, |volume| format!("{} mm^3", four(volume * 1e9))),
        ];
        for (what, column, shown) in shown {
            for body in &self.simulation.problem.bodies {
                let column = of_body(column, &body.name);
                if let Some(value) = self.follower.number(&column) {
                    lines.add(
                        format!("{what} ({})", body.name),
                        shown(value),
                        self.error(&[&column]),
                    );
                }
            }
        }
    }

    /// Adds what is worn off each body that wears, what both are worn by together, and how wide it is.
    fn worn(&self, lines: &mut Lines) {
        let problem = &self.simulation.problem;
        let wearing: Vec<&str> = problem
            .bodies
            .iter()
            .filter(|body| body.wear.is_some())
            .map(|body| &*body.name)
            .collect();
        let both = ["both".to_owned(), WEAR_DEPTH.to_owned()];
        let depths = wearing.iter().map(|name| [(*name).to_owned(), of_body(BODY_DEPTH, name)]);
        for [name, column] in depths.chain((wearing.len() > 1).then_some(both)) {
            let depth = format!("{} um", four(self.last(&column) * 1e6));
            lines.add(format!("wear depth ({name})"), depth, self.error(&[&column]));
        }
        let shown: [(&str, &str, Shown); 6] = [
            ("worn volume", WORN_VOLUME, |volume| format!("{} mm^3", four(volume * 1e9))),
            ("off its layers", LAYER_VOLUME, |volume| format!("{} mm^3", four(volume * 1e9))),
            ("worn through", EXPOSED_AREA, |area| format!("{} mm^2", four(area * 1e6))),
            ("worn section", WORN_SECTION, |section| format!("{} mm^2", four(section * 1e6))),
            ("mass loss", MASS_LOSS, mass),
            ("wear rate", WEAR_RATE, |rate| format!("{} mm^3/(N m)", four(rate * 1e9))),
        ];
        for (what, column, shown) in shown {
            // Nothing is worn through, as a rule.
            let told = |value: &f64| column != EXPOSED_AREA || *value > 0.0;
            for name in &wearing {
                let column = of_body(column, name);
                if let Some(value) = self.follower.number(&column).filter(told) {
                    lines.add(format!("{what} ({name})"), shown(value), self.error(&[&column]));
                }
            }
        }
        for (what, column) in
            [("scar length", SCAR[0]), ("scar width", SCAR[1]), ("track width", TRACK_WIDTH)]
        {
            if let Some(extent) = self.follower.number(column) {
                lines.add(what, length(extent), self.error(&[column]));
            }
        }
        self.scars(lines);
        for equivalent in &self.forecast.equivalents {
            let text = equivalent.to_string();
            let (name, value) = text.trim_end().split_once("  ").unwrap_or((text.trim_end(), ""));
            lines.add(name, value.trim_start(), String::new());
        }
        standards::add_all(problem, &self.follower.last, lines);
    }

    /// Adds how far the scars of bodies that stay under the contact reach, where no track names them.
    fn scars(&self, lines: &mut Lines) {
        let bodies = &self.simulation.problem.bodies;
        for (body, extent) in bodies.iter().zip(self.follower.scars) {
            if let (Some([along, across]), None) = (extent, self.follower.number(SCAR[0])) {
                let [along, across] = [along, across].map(length);
                let extent = match self.simulation.problem.frame.is_line() || along == across {
                    true => along,
                    false => format!("{along} along, {across} across"),
                };
                lines.add(format!("scar ({})", body.name), extent, String::new());
            }
        }
    }

    /// Adds how the bodies creep at last and, where there is friction, what they pass on.
    fn rolled(&self, direction: Direction, lines: &mut Lines) {
        let problem = &self.simulation.problem;
        let creepage = along_and_across(CREEPAGE.map(|column| self.last(column)), "");
        lines.add("creepage", creepage, self.error(&CREEPAGE));
        if problem.friction.is_none() {
            return;
        }
        // Where nothing is passed on, what is left of a force is rounding, and so is its error.
        let nothing = SAME * self.last(history::LOAD);
        let force = FORCE.map(|column| self.last(column));
        let [x, y] = force.map(|force| if force.abs() > nothing { force } else { 0.0 });
        let units = [direction.forward(), direction.lateral()];
        let force = along_and_across(units.map(|unit| x * unit[0] + y * unit[1]), " N");
        let error = if [x, y] == [0.0; 2] { String::new() } else { self.error(&FORCE) };
        lines.add(format!("creep force ({})", problem.bodies[0].name), force, error);
        let power = self.last(FRICTIONAL_POWER);
        let power = if power.abs() > nothing { power } else { 0.0 };
        let intensity = power / self.last(history::CONTACT_AREA);
        let intensity = format!("{} N/mm^2, over the contact", four(intensity * 1e-6));
        lines.add("T gamma / A", intensity, String::new());
        self.stuck(lines);
    }

    /// Adds how large an area sticks at last.
    fn stuck(&self, lines: &mut Lines) {
        let area = format!("{} mm^2", four(self.last(STICK_AREA) * 1e6));
        lines.add("stick area", area, self.error(&[STICK_AREA]));
    }

    /// Adds what sticks at last, what friction dissipated, and how many cycles were computed where not all were.
    fn shifted(&self, shift: &Shift, lines: &mut Lines) {
        if self.simulation.problem.friction.is_some() {
            self.stuck(lines);
            let [last, all] = self.effort.dissipated.map(energy);
            let last = if last == all {
                String::new()
            } else {
                format!(", {last} of it in the last cycle")
            };
            lines.add("dissipated", format!("{all}{last}"), String::new());
        }
        let cycles = self.simulation.schedule.extent / shift.period();
        if (self.effort.true_cycles as f64) < cycles - 0.5 {
            let computed =
                format!("{}, {} of them computed", count(cycles), self.effort.true_cycles);
            lines.add("cycles", computed, String::new());
        }
    }

    /// What is stated of a quantity with these components, relative to it, or that nothing is; nothing where no accuracy is asked
    /// for or there is nothing but rounding.
    fn error(&self, columns: &[&str]) -> String {
        let size = |components: Vec<f64>| components.into_iter().fold(0.0, f64::hypot);
        let of = |column: &&str| stated(column, |name| self.follower.number(name));
        let Some(errors) = columns.iter().map(of).collect::<Option<Vec<_>>>() else {
            let estimates = self.follower.number(ERROR).is_some();
            return if estimates { "error not known".to_owned() } else { String::new() };
        };
        let value = size(columns.iter().map(|column| self.last(column)).collect());
        let error = size(errors);
        match error / value {
            _ if error > 0.0 && value == 0.0 => "below its error".to_owned(),
            relative if relative.is_normal() && relative > SAME => {
                format!("+- {}", percent(relative))
            }
            _ => String::new(),
        }
    }
}

/// Two components by the direction of rolling; one that is nothing but rounding next to the other is
/// left out.
fn along_and_across([along, across]: [f64; 2], unit: &str) -> String {
    if across.abs() <= WRITTEN * along.abs() {
        format!("{}{unit} along", four(along))
    } else if along.abs() <= WRITTEN * across.abs() {
        format!("{}{unit} across", four(across))
    } else {
        format!("{}{unit} along, {}{unit} across", four(along), four(across))
    }
}
