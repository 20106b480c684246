//! From the tree as written to a case: every key read and checked by itself.

mod body;
mod cam;
mod elastic;
mod elasticity;
mod finite;
mod frame;
mod gear;
mod image;
mod material;
mod output;
mod stress;
mod wheel_rail;

use super::chosen::ChosenPart;
use super::definition::{BodyCase, Case, FrameCase};
use super::problem::Problem;
use super::reader::{Reader, Section};
use super::surface::{MAPS, PreparedSurface};
use super::tree::Item;
use archard::accuracy;
use archard::friction::{FRICTION, Friction};
use archard::motion::{MOTIONS, Planned};
use archard::parameters::{Choice, Quantity, Values};
use archard::solve::SOLVERS;
use archard::solve::tangential::{FRICTION_SOLVERS, FrictionSolver};
use finite::zone;

/// The tables of a case.
const TABLES: &[&str] = &[
    "title",
    "accuracy",
    "body",
    "frame",
    "friction",
    "motion",
    "solver",
    "friction_solver",
    "output",
    "until",
];

impl Reader<'_> {
    /// The case, if nothing is wrong with it.
    pub fn case(&mut self, root: &Section<'_>) -> Option<Case> {
        self.unknown(root, "key", TABLES);
        let title = self.title(root);
        self.framed = root.get("frame").is_some() || root.get("accuracy").is_some();
        let bodies = self.bodies(root);
        let image = |bodies: &[BodyCase; 2]| bodies.iter().any(BodyCase::has_image);
        let meshed = names_a_mesh(root) && !bodies.as_ref().is_some_and(image);
        let accuracy = self.accuracy(root, meshed);
        let measured = bodies.as_ref().and_then(frame::measured);
        let frame = match (root.get("frame"), &bodies) {
            (None, Some(bodies)) if meshed || image(bodies) && !self.framed => zone(bodies),
            (None, None) if meshed => None,
            (Some((key, _)), Some(bodies)) if meshed => {
                let message = "the pairs are the nodes of the mesh: leave the frame out";
                let mut why = bodies.iter().filter_map(|body| body.finite.as_ref()?.why);
                let problem = Problem::error(key, message).at_name();
                self.push(match why.next() {
                    Some(why) => problem.help(format!("no image field: {why}")),
                    None => problem,
                });
                None
            }
            (None, _) if root.get("accuracy").is_some() => Some(FrameCase::to_be_chosen()),
            (None, _) if measured.is_some() => measured,
            _ => {
                let meaning = "how fine the contact is computed: the size of an element, `frame.element = \"10 um\"`, or `accuracy = 0.05` in its place";
                self.table(root, "frame", meaning).and_then(|section| {
                    self.frame(&section, root.get("accuracy").is_some(), measured)
                })
            }
        };
        let frame = frame.filter(|frame| self.is_the_zone(bodies.as_ref(), frame));
        let motion = self.motion(root);
        let doubles = motion.as_ref().and_then(|(_, motion)| self.doubles(root, frame, motion));
        let friction = self.friction(root);
        let solver = self.solver(root, "solver", SOLVERS);
        let friction_solver = self.friction_solver(root);
        let output = motion.as_ref().and_then(|(_, motion)| self.output(root, motion));
        let until = bodies.as_ref().and_then(|bodies| self.until(root, bodies));
        let points = bodies.as_ref().and_then(|bodies| self.points_of_bodies(root, bodies));
        let sections = bodies.as_ref().and_then(|bodies| self.sections_of_bodies(root, bodies));
        let stresses = bodies.as_ref().and_then(|bodies| self.stresses_of_bodies(root, bodies));
        Some(Case {
            title: title?,
            accuracy: accuracy?,
            bodies: bodies?,
            frame: frame?,
            doubles: doubles?,
            motion: motion?.0,
            friction: friction?,
            solver: solver?,
            friction_solver: friction_solver?,
            output: output?,
            until: until?,
            points: points?,
            sections: sections?,
            stresses: stresses?,
        })
    }

    /// A measured surface by itself.
    pub fn surface(&mut self, root: &Section<'_>) -> Option<ChosenPart<PreparedSurface>> {
        self.unknown(root, "key", &["profile"]);
        let section = self.table(root, "profile", "a `profile.surface`")?;
        self.required(&section, "profile", MAPS)
    }

    /// The title if there is one; `None` if it is wrong.
    fn title(&mut self, root: &Section<'_>) -> Option<Option<String>> {
        let Some((key, entry)) = root.get("title") else { return Some(None) };
        match &entry.node.item {
            Item::Text(text) => Some(Some(text.clone())),
            other => {
                self.push(Problem::error(key, format!("expected a text, found {}", other.kind())));
                None
            }
        }
    }

    /// The accuracy if one is asked for; `None` if it is wrong.
    fn accuracy(&mut self, root: &Section<'_>, meshed: bool) -> Option<Option<f64>> {
        let Some((key, entry)) = root.get("accuracy") else { return Some(None) };
        let value = self.number(key.clone(), &entry.node, Quantity::Number)?;
        if !accuracy::admitted(value) {
            self.push(Problem::error(key, accuracy::refusal()));
            return None;
        }
        if meshed {
            let message = "the elements of a mesh are those of its zone: they are not chosen";
            self.push(Problem::error(key, message).at_name().help("leave it out"));
            return None;
        }
        Some(Some(value))
    }

    fn motion(&mut self, root: &Section<'_>) -> Option<(ChosenPart<Planned>, Planned)> {
        let section =
            self.table(root, "motion", "what the bodies do, for example `[motion.sliding]`")?;
        self.require_one(&section, "motion", MOTIONS);
        self.choice(&section, "motion", MOTIONS)
    }

    /// The friction law, `Some(None)` where none exists; `None` if it is wrong.
    fn friction(&mut self, root: &Section<'_>) -> Option<Option<ChosenPart<Box<dyn Friction>>>> {
        let Some((key, entry)) = root.get("friction") else { return Some(None) };
        let section = self.as_table(key, &entry.node)?;
        self.required(&section, "friction law", FRICTION).map(Some)
    }

    /// The solver of friction; the first of the list where there is no friction to be solved for.
    fn friction_solver(
        &mut self,
        root: &Section<'_>,
    ) -> Option<ChosenPart<Box<dyn FrictionSolver>>> {
        let chosen = self.solver(root, "friction_solver", FRICTION_SOLVERS);
        let Some((key, _)) = root.get("friction_solver") else { return chosen };
        if root.get("friction").is_some() {
            return chosen;
        }
        let message = "has no effect without a `friction` table";
        self.push(Problem::warning(key, message).at_name());
        chosen.and_then(|_| first(FRICTION_SOLVERS))
    }

    /// The solver chosen, or the first of the list.
    fn solver<T>(
        &mut self,
        root: &Section<'_>,
        table: &str,
        solvers: &'static [Choice<T>],
    ) -> Option<ChosenPart<T>> {
        let Some((key, entry)) = root.get(table) else { return first(solvers) };
        let section = self.as_table(key, &entry.node)?;
        if section.table.0.is_empty() {
            return first(solvers);
        }
        self.choice(&section, "solver", solvers).map(|(chosen, _)| chosen)
    }

    /// A choice that has to be made.
    fn required<T>(
        &mut self,
        section: &Section<'_>,
        what: &str,
        choices: &'static [Choice<T>],
    ) -> Option<ChosenPart<T>> {
        self.require_one(section, what, choices);
        self.choice(section, what, choices).map(|(chosen, _)| chosen)
    }

    fn require_one<T>(&mut self, section: &Section<'_>, what: &str, choices: &'static [Choice<T>]) {
        if section.table.0.is_empty() {
            let names: Vec<&str> = choices.iter().map(|choice| choice.name).collect();
            let problem = Problem::error(section.key.clone(), format!("names no {what}"));
            self.push(problem.help(format!("known here: {}", names.join(", "))));
        }
    }
}

/// Whether a body has a `mesh`, sound or not.
fn names_a_mesh(root: &Section<'_>) -> bool {
    let Some((_, bodies)) = root.get("body") else { return false };
    let Item::Table(bodies) = &bodies.node.item else { return false };
    bodies.0.iter().any(|body| match &body.node.item {
        Item::Table(body) => body.get("mesh").is_some(),
        _ => false,
    })
}

/// The first of a list with nothing said about it.
fn first<T>(choices: &'static [Choice<T>]) -> Option<ChosenPart<T>> {
    choices.first().map(|choice| ChosenPart { choice, values: Values::default(), files: vec![] })
}
