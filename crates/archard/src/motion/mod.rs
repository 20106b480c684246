//! Motions: how the bodies are driven, how slip follows, and how rubbing is collected into wear.
//!
//! A new motion is one file here and one line in [`MOTIONS`].

mod axes;
mod columns;
mod creepage_sweep;
mod drives;
mod fretting;
mod indentation;
mod joint;
mod merged;
mod path;
mod progress;
mod rolling;
mod rotation;
mod schedule;
mod shift;
mod similar;
mod sliding;
mod table;

pub use axes::Axis;
pub use drives::{Drive, Drives};
pub use fretting::Fretting;
pub use indentation::Indentation;
pub use joint::{Joint, Turn};
#[doc(hidden)]
pub use merged::{StationLoss, Within};
pub use path::Path;
#[doc(hidden)]
pub use progress::Progress;
pub use rolling::Rolling;
pub use rotation::Rotation;
pub use schedule::{Control, Planned, Schedule, Stepping};
pub use shift::{Cycles, Shift, Station};
pub use sliding::{Sliding, Track};
pub use table::{Row, Table};

use crate::body::Body;
use crate::frame::{Direction, Rectangle};
use crate::parameters::Choice;
use schedule::{
    APPROACH, INCREMENTS, LOAD, MOST_INCREMENTS, TOLERANCE, control, counted, few_steps, pressing,
};

/// How the bodies move on each other: answers that do not depend on each other.
///
/// The *advance* is the motion's own measure of progress: metres for sliding, revolutions for rolling,
/// cycles or seconds for increments.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// What progress measures, for result columns and messages.
    pub progress: Progress,
    /// Along which axis of the frame the bodies slide or roll; x of increments, which go along both.
    pub direction: Direction,
    /// What the surfaces of body 1 and body 2 do under the contact.
    pub surfaces: [Passage; 2],
    /// Whether the slip of all pairs is given, or friction decides it.
    pub slip: Slip,
    /// What the bodies go through as the motion advances.
    pub sequence: Sequence,
    /// Mean speed (m/s) where it is known: of sliding, or of rolling the mean of both surfaces.
    pub speed: Option<f64>,
}

/// What the surface of a body does under the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Passage {
    /// The same points stay under the contact.
    Stays,
    /// Points come through the contact one after the other, and all on a line along the motion wear by the same depth: on a track,
    /// or once a revolution.
    Passes(Option<Track>),
    /// Points are moved to and fro under the contact by an amplitude (m); on a track by half of its stroke.
    Swings(f64, Option<Track>),
    /// Points slide past those of the other surface for ever: both repeat themselves with the frame.
    Recurs,
    /// Points come under the contact where the stations of a [table](Table) say, in two directions.
    Roams,
}

/// How far pairs in contact slip.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Slip {
    /// All pairs slide (gross sliding): that distance (m) at a unit lever, or angle (rad), while the motion advances by one.
    Given(f64, Lever),
    /// Friction decides which pairs slip, and how far: bodies are driven so, or in a cycle as its stations say.
    Sought(Drives),
}

/// How the slip of a pair depends on its place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Lever {
    /// The same everywhere.
    Even,
    /// In proportion to the distance (m) from x = y = 0, about which one body turns on the other.
    Radius,
    /// As the surface of a ball moves where it turns: by its radius and the distance from the axis.
    Turn,
}

/// What the bodies go through as the motion advances.
#[derive(Debug, Clone, PartialEq)]
pub enum Sequence {
    /// The same all the time, and they wear by it.
    Steady,
    /// Drives that grow in proportion to the progress, from nothing to what they are; nothing wears.
    Raised,
    /// Increments from station to station.
    Cycle(Shift),
    /// Stations on both surfaces, all pairs in contact sliding from one to the next.
    Table(Table),
    /// Turns of a ball in its socket.
    Joint(Joint),
}

/// Surfaces that pass: their points come through the contact along a line, and all of that line wear by the same depth.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassingSurfaces {
    /// Along the motion.
    pub direction: Direction,
    /// Which bodies pass; the others stay.
    pub bodies: [bool; 2],
    /// How often a point passes while the motion advances by one (its own unit).
    pub passages: f64,
    /// How long the surfaces are (m), where they are of one length.
    pub length: Option<f64>,
}

/// Surfaces whose points come through the contact one after the other, at one speed.
#[doc(hidden)]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stream {
    /// Where the contact moves over these surfaces.
    pub direction: Direction,
    /// Which bodies they belong to; the contact stays where it is on the other one.
    pub bodies: [bool; 2],
    /// The speed (m/s): of rolling the mean of both bodies. `None` where it is not known.
    pub speed: Option<f64>,
}

impl Passage {
    /// Whether points come through the contact one after the other, evenly.
    pub fn passes(&self) -> bool {
        matches!(self, Self::Passes(_))
    }

    /// Whether all points on a line along the motion wear by the same depth, at least far from the ends of a stroke.
    pub fn grooves(&self) -> bool {
        matches!(self, Self::Passes(_) | Self::Swings(_, Some(_)))
    }

    /// The track of the surface.
    pub fn track(&self) -> Option<Track> {
        match *self {
            Self::Passes(track) | Self::Swings(_, track) => track,
            Self::Stays | Self::Recurs | Self::Roams => None,
        }
    }

    /// Amplitude (m) by which its points are moved to and fro.
    pub fn amplitude(&self) -> Option<f64> {
        if let Self::Swings(amplitude, _) = *self { Some(amplitude) } else { None }
    }
}

impl Motion {
    /// Along both axes, surfaces staying opposite each other, friction deciding what slips from station to station.
    fn cycle_of(shift: Shift, progress: Progress) -> Self {
        Self {
            progress,
            direction: Direction::X,
            surfaces: [Passage::Stays; 2],
            slip: Slip::Sought(Drives::FREE),
            sequence: Sequence::Cycle(shift),
            speed: None,
        }
    }

    /// The surfaces that stream through the contact; `None` where none does, or not at one speed as on a stroke.
    pub fn stream(&self) -> Option<Stream> {
        let bodies = self.surfaces.each_ref().map(Passage::passes);
        if bodies == [false; 2] || self.track().is_some_and(|track| track.strokes) {
            return None;
        }
        // Body 2 slides along the direction over body 1: over body 2 the contact moves back.
        let back = self.track().is_some_and(|track| track.body == 1);
        let direction = if back { self.direction.back() } else { self.direction };
        Some(Stream { direction, bodies, speed: self.speed })
    }

    /// The surfaces that pass, if any do and may wear.
    pub fn passing(&self) -> Option<PassingSurfaces> {
        let bodies = self.surfaces.each_ref().map(Passage::passes);
        let length = self.track().map(|track| track.length);
        let passages = length.map_or(1.0, |length| 1.0 / length);
        let passing = PassingSurfaces { direction: self.direction, bodies, passages, length };
        (bodies != [false; 2] && self.sequence != Sequence::Raised).then_some(passing)
    }

    /// The track of a surface.
    pub fn track(&self) -> Option<Track> {
        self.surfaces.iter().find_map(Passage::track)
    }

    /// Amplitude (m) by which the surfaces swing past each other, if they do.
    pub fn amplitude(&self) -> Option<f64> {
        self.surfaces.iter().find_map(Passage::amplitude)
    }

    /// Whether a step sees the surfaces in one position after the other.
    pub fn has_positions(&self) -> bool {
        self.amplitude().is_some()
            || self.joint().is_some()
            || [Passage::Recurs, Passage::Roams].iter().any(|one| self.surfaces.contains(one))
    }

    /// Whether the surfaces stay opposite each other.
    pub fn stays(&self) -> bool {
        self.surfaces == [Passage::Stays; 2]
    }

    /// Along which axes it moves the bodies over planes of symmetry: sliding of surfaces that stay is the same on both sides.
    pub fn crosses(&self) -> [bool; 2] {
        let along = self.passing().map(|_| self.direction.axis);
        match (&self.sequence, &self.slip) {
            (Sequence::Cycle(shift), _) => shift.moves_along(),
            (Sequence::Table(_), _) => {
                [0, 1].map(|axis| (0..2).any(|body| self.reach(body).size[axis] > 0.0))
            }
            (_, Slip::Sought(drives)) => {
                let aside = drives.lateral != Drive::Slip(0.0) || drives.spin != 0.0;
                [0, 1].map(|axis| axis == self.direction.axis || aside)
            }
            (_, Slip::Given(..)) => {
                let recurs = self.surfaces.contains(&Passage::Recurs);
                let along = along.or(recurs.then_some(self.direction.axis));
                [0, 1].map(|axis| along == Some(axis))
            }
        }
    }

    /// The offsets (m) by which the surface of a body is moved under the contact: on a stroke, by an amplitude, or as a table says.
    pub fn reach(&self, body: usize) -> Rectangle {
        if let Sequence::Table(table) = &self.sequence {
            let along = [0, 1].map(|axis| table.reach(body, axis));
            let centre = along.map(|[least, most]| 0.5 * (least + most));
            return Rectangle { centre, size: along.map(|[least, most]| most - least) };
        }
        let mut size = [0.0; 2];
        size[self.direction.axis] = match self.surfaces[body] {
            Passage::Swings(amplitude, _) => 2.0 * amplitude,
            Passage::Passes(Some(track)) if track.strokes => track.length,
            _ => 0.0,
        };
        size.into()
    }

    /// Along which direction the surface of a body is worn by one depth, at least far from the ends of a stroke, and which bodies
    /// are.
    pub fn grooves(&self) -> Option<(Direction, [bool; 2])> {
        let bodies = self.surfaces.each_ref().map(Passage::grooves);
        (bodies != [false; 2] && self.sequence != Sequence::Raised)
            .then_some((self.direction, bodies))
    }

    /// Distance (m) that pairs in contact slide over each other while the motion advances by that much, at a unit
    /// [lever](Self::lever); zero where friction decides it.
    pub fn slip(&self, advance: f64) -> f64 {
        if let Slip::Given(each, _) = self.slip { each * advance } else { 0.0 }
    }

    /// Distance (m) slid up to some progress (the motion's unit), where all pairs slide by one; `None` where they do not.
    pub fn sliding_distance(&self, progress: f64) -> Option<f64> {
        (self.lever_arm() == Some(Lever::Even)).then(|| self.slip(progress))
    }

    /// Lever (1, or in m where bodies turn) of the [slip](Self::slip) at a place (m).
    pub fn lever(&self, [x, y]: [f64; 2]) -> f64 {
        if self.lever_arm() == Some(Lever::Radius) { x.hypot(y) } else { 1.0 }
    }

    /// How the slip of a pair depends on its place; `None` where friction decides it.
    pub fn lever_arm(&self) -> Option<Lever> {
        if let Slip::Given(_, lever) = self.slip { Some(lever) } else { None }
    }

    /// Speed (m/s) of the slip of all pairs, where it is given.
    pub fn sliding_speed(&self) -> Option<f64> {
        self.speed.filter(|_| self.lever_arm().is_some())
    }

    /// Unit vector, or where bodies turn one of another length, along which body 2 slides over body 1 at a place (m), if all pairs
    /// in contact do.
    pub fn heading(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        if self.lever_arm() == Some(Lever::Radius) && [x, y] != [0.0; 2] {
            return [-y, x];
        }
        self.direction.forward()
    }

    /// What drives bodies whose slip is sought, at some progress (the motion's unit); `None` in a cycle, whose stations do.
    pub fn driven(&self, progress: f64) -> Option<Drives> {
        match (&self.slip, &self.sequence) {
            (Slip::Sought(drives), Sequence::Steady) => Some(*drives),
            (Slip::Sought(drives), Sequence::Raised) => Some(drives.raised(progress)),
            _ => None,
        }
    }

    /// The same of these bodies: what follows from their axes and shapes is found.
    #[must_use]
    pub fn of_bodies(self, bodies: &[Body; 2]) -> Self {
        let across = 1 - self.direction.axis;
        let curvature = |body: &Body| body.curvatures().map(|both| both[across]);
        match (&self.slip, bodies.each_ref().map(curvature)) {
            (Slip::Sought(drives), [Some(one), Some(two)]) => {
                Self { slip: Slip::Sought(drives.about_axes([one, two])), ..self }
            }
            _ => self,
        }
    }

    /// The stations of a table.
    pub fn table(&self) -> Option<&Table> {
        if let Sequence::Table(table) = &self.sequence { Some(table) } else { None }
    }

    /// The turns of a ball in its socket.
    pub fn joint(&self) -> Option<&Joint> {
        if let Sequence::Joint(joint) = &self.sequence { Some(joint) } else { None }
    }

    /// The largest angle (rad) between the load and the pole of the socket in which a ball turns.
    pub fn tilt(&self) -> f64 {
        self.joint().map_or(0.0, Joint::tilt)
    }

    /// Where (m) the surface of a body that has elements of its own lies under the frame in the contact that is shown: of a body that
    /// roams, or turns in a joint; `None` of others.
    pub fn shown_offset(&self, body: usize) -> Option<[f64; 2]> {
        match &self.sequence {
            Sequence::Table(table) => {
                self.roams(body).then(|| table.rows()[table.shown()].offsets[body])
            }
            Sequence::Joint(_) => Some([0.0; 2]),
            _ => None,
        }
    }

    /// Whether the surface of a body moves under the contact from station to station of a table.
    pub fn roams(&self, body: usize) -> bool {
        self.surfaces[body] == Passage::Roams
    }

    /// The increments of a motion in cycles.
    pub fn increments(&self) -> Option<&Shift> {
        if let Sequence::Cycle(shift) = &self.sequence { Some(shift) } else { None }
    }
}

/// The motions a case can name.
pub const MOTIONS: &[Choice<Planned>] = &[
    indentation::CHOICE,
    fretting::CHOICE,
    path::CHOICE,
    table::CHOICE,
    joint::CHOICE,
    sliding::CHOICE,
    rotation::CHOICE,
    rolling::CHOICE,
    creepage_sweep::CHOICE,
];
