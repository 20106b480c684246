//! What looks wrong about the points of a profile.
//!
//! An oddity is no error: the profile can be used, and the user should look at it first. A loop is the exception that no
//! smoothing repairs.

use std::fmt;

use crate::curve::{distance, turn};
use crate::profile::{Part, Profile};

/// Points nearer than this (m) are one point twice.
pub const DOUBLED: f64 = 1e-9;
/// A way that turns by more than this angle (rad) at a point goes back on itself: 150 degrees.
pub const ZIGZAG: f64 = 5.0 / 6.0 * std::f64::consts::PI;
/// Widths (m) between which a profile is believed to be in the unit it was said to be in. No wheel is narrower than its flange
/// and no rail than its head, which have 28 mm and more; the widest wheel, of 140 mm in inches, is 5.5 mm wide.
pub const WIDTHS: [f64; 2] = [10e-3, 0.5];

/// What looks wrong.
#[derive(Debug, Clone, PartialEq)]
pub enum Oddity {
    /// The point lies within a nanometre of the one before.
    Doubled,
    /// The way after the point crosses the way after that other point (numbered from 1).
    Loop {
        /// The other point.
        with: usize,
    },
    /// The way goes back on itself at the point, as where two measurements were stitched.
    ZigZag {
        /// The turn (rad).
        turn: f64,
    },
    /// The material lies on the left hand: the order of the points is to be turned round.
    WrongHand,
    /// Most points lie far from the top of the profile and near its foot: z probably points upwards.
    UpsideDown,
    /// The flange is on the side of positive y: y is to be mirrored.
    Flange,
    /// The profile is too small or too large.
    Size {
        /// Largest of its width and its height (m).
        width: f64,
    },
    /// Something in the file that is not used.
    Ignored {
        /// Its name in the file.
        key: String,
    },
    /// The file states another number of points than it holds.
    Count {
        /// The number it states.
        stated: usize,
        /// The number it holds.
        found: usize,
    },
}

impl fmt::Display for Oddity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Doubled => write!(f, "the same point as the one before"),
            Self::Loop { with } => write!(f, "the profile crosses itself after point {with}"),
            Self::ZigZag { turn } => {
                write!(f, "the profile turns back by {:.0} degrees", turn.to_degrees())
            }
            Self::WrongHand => {
                write!(f, "the material lies on the left hand: turn the order round")
            }
            Self::UpsideDown => write!(f, "the profile seems to stand upside down: mirror z"),
            Self::Flange => write!(f, "the flange lies on the field side: mirror y"),
            Self::Size { width } => {
                let unit = match *width {
                    width if width > WIDTHS[1] => "millimetres read as metres",
                    // From 20 to 127 mm that were written in inches.
                    width if width > 20e-3 / 25.4 => "inches read as millimetres",
                    _ => "metres read as millimetres",
                };
                write!(f, "the profile is {:.3} mm wide: probably {unit}", width * 1e3)
            }
            Self::Ignored { key } => write!(f, "`{key}` is not used"),
            Self::Count { stated, found } => {
                write!(f, "the file states {stated} points and holds {found}")
            }
        }
    }
}

/// An oddity and where it is.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// The point, numbered from 1; `None` if all of the profile is meant.
    pub point: Option<usize>,
    /// The line of the file, numbered from 1, if there is a file.
    pub line: Option<usize>,
    /// What looks wrong.
    pub oddity: Oddity,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(line) = self.line {
            write!(f, "line {line}: ")?;
        }
        if let Some(point) = self.point {
            write!(f, "point {point}: ")?;
        }
        write!(f, "{}", self.oddity)
    }
}

impl Profile {
    /// All that looks wrong about the profile of that part.
    pub fn oddities(&self, part: Part) -> Vec<Finding> {
        let whole = [self.hand(part), self.upside_down(), self.flange(part), self.size()];
        let whole =
            whole.into_iter().flatten().map(|oddity| Finding { point: None, line: None, oddity });
        let at =
            |(at, oddity): (usize, Oddity)| Finding { point: Some(at + 1), line: None, oddity };
        whole
            .chain(self.doubled().map(at))
            .chain(self.zigzags().map(at))
            .chain(self.loops().into_iter().map(at))
            .collect()
    }

    fn hand(&self, part: Part) -> Option<Oddity> {
        let (first, last) = (self.points.first()?, self.points.last()?);
        ((last[0] - first[0]) * part.direction() < 0.0).then_some(Oddity::WrongHand)
    }

    /// The running surface holds most of the points, and the sides of a rail or the flange of a wheel reach far down.
    fn upside_down(&self) -> Option<Oddity> {
        let mut heights: Vec<f64> = self.points.iter().map(|point| point[1]).collect();
        heights.sort_by(f64::total_cmp);
        let (middle, last) = (heights.get(heights.len() / 2)?, heights.last()?);
        (middle - heights[0] > last - middle).then_some(Oddity::UpsideDown)
    }

    fn flange(&self, part: Part) -> Option<Oddity> {
        let lowest = self.points.iter().max_by(|a, b| a[1].total_cmp(&b[1]))?;
        let (first, last) = (self.points.first()?, self.points.last()?);
        let middle = 0.5 * (first[0] + last[0]);
        (part == Part::Wheel && self.upside_down().is_none() && lowest[0] > middle)
            .then_some(Oddity::Flange)
    }

    fn size(&self) -> Option<Oddity> {
        let extent = |axis: usize| {
            let values = self.points.iter().map(|point| point[axis]);
            values.clone().fold(f64::MIN, f64::max) - values.fold(f64::MAX, f64::min)
        };
        let width = extent(0).max(extent(1));
        (!(WIDTHS[0]..=WIDTHS[1]).contains(&width)).then_some(Oddity::Size { width })
    }

    fn doubled(&self) -> impl Iterator<Item = (usize, Oddity)> {
        let pairs = self.points.windows(2).enumerate();
        pairs
            .filter(|(_, pair)| distance(pair[0], pair[1]) <= DOUBLED)
            .map(|(at, _)| (at + 1, Oddity::Doubled))
    }

    fn zigzags(&self) -> impl Iterator<Item = (usize, Oddity)> {
        self.points.windows(3).enumerate().filter_map(|(at, three)| {
            let turn = turn(three[0], three[1], three[2]);
            (turn > ZIGZAG).then_some((at + 1, Oddity::ZigZag { turn }))
        })
    }

    /// The first crossing of each step of the way with one that is not next to it.
    fn loops(&self) -> Vec<(usize, Oddity)> {
        let steps: Vec<Step> = self
            .points
            .windows(2)
            .enumerate()
            .map(|(number, pair)| Step::new(number, pair))
            .collect();
        let mut order: Vec<usize> = (0..steps.len()).collect();
        order.sort_by(|&a, &b| steps[a].across[0].total_cmp(&steps[b].across[0]));
        let mut found = vec![];
        for (rank, &one) in order.iter().enumerate() {
            let step = &steps[one];
            let candidates = order[rank + 1..].iter().map(|&other| &steps[other]);
            let near = candidates.take_while(|other| other.across[0] <= step.across[1]);
            if let Some(other) = near.into_iter().find(|other| step.crosses(other)) {
                let [first, second] =
                    [step.number.min(other.number), step.number.max(other.number)];
                found.push((second, Oddity::Loop { with: first + 1 }));
            }
        }
        found.sort_by_key(|(at, _)| *at);
        found
    }
}

/// The straight way from a point to the next.
struct Step {
    number: usize,
    ends: [[f64; 2]; 2],
    /// Least and largest y (m).
    across: [f64; 2],
}

impl Step {
    fn new(number: usize, pair: &[[f64; 2]]) -> Self {
        let (a, b) = (pair[0], pair[1]);
        Self { number, ends: [a, b], across: [a[0].min(b[0]), a[0].max(b[0])] }
    }

    fn crosses(&self, other: &Self) -> bool {
        let side = |[a, b]: [[f64; 2]; 2], c: [f64; 2]| {
            (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        };
        let parted = |line: &Self, by: &Self| {
            side(by.ends, line.ends[0]) * side(by.ends, line.ends[1]) < 0.0
        };
        self.number.abs_diff(other.number) > 1 && parted(self, other) && parted(other, self)
    }
}

#[cfg(test)]
mod tests {
    use super::{Oddity, Part, Profile};

    fn arc() -> Vec<[f64; 2]> {
        (-20..=20)
            .map(|at| f64::from(at) * 0.05)
            .map(|angle: f64| [0.04 * angle.sin(), 0.04 - 0.04 * angle.cos()])
            .collect()
    }

    fn oddities(points: Vec<[f64; 2]>, part: Part) -> Vec<(Option<usize>, Oddity)> {
        let found = Profile::new(points).unwrap().oddities(part);
        found.into_iter().map(|finding| (finding.point, finding.oddity)).collect()
    }

    #[test]
    fn a_sound_profile_has_none() {
        assert_eq!(oddities(arc(), Part::Rail), []);
    }

    #[test]
    fn each_kind_is_found() {
        let reversed = arc().into_iter().rev().collect();
        assert_eq!(oddities(reversed, Part::Rail), [(None, Oddity::WrongHand)]);
        let turned = arc().into_iter().map(|[y, z]| [y, -z]).collect();
        assert_eq!(oddities(turned, Part::Rail), [(None, Oddity::UpsideDown)]);
        let mut doubled = arc();
        doubled.insert(5, doubled[4]);
        assert_eq!(oddities(doubled, Part::Rail), [(Some(6), Oddity::Doubled)]);
        let small = arc().into_iter().map(|[y, z]| [y * 1e-3, z * 1e-3]).collect();
        let found = oddities(small, Part::Rail);
        assert!(found[0].1.to_string().ends_with("metres read as millimetres"), "{found:?}");
        // All of a wheel, 135 mm wide.
        let whole = (0..=40).map(|at| [(f64::from(at) * 3.375 - 67.5) * 1e-3 / 25.4, 0.0]);
        let found = oddities(whole.collect(), Part::Wheel);
        let inches_too = |one: &(_, Oddity)| one.1.to_string().contains("inches");
        assert!(found.iter().any(inches_too), "{found:?}");
        let inches = arc().into_iter().map(|[y, z]| [y / 25.4, z / 25.4]).collect();
        let found = oddities(inches, Part::Rail);
        assert!(found[0].1.to_string().contains("inches"), "{found:?}");
    }

    #[test]
    fn a_step_back_and_a_loop_are_found() {
        let mut back = arc();
        back.swap(20, 21);
        let found = oddities(back, Part::Rail);
        assert!(matches!(found[0], (Some(21), Oddity::ZigZag { .. })), "{found:?}");
        let mut looped = arc();
        looped.splice(20..20, [[3e-3, 2e-3], [3e-3, -4e-3], [-1e-3, -4e-3], [-1e-3, 4e-3]]);
        let found = oddities(looped, Part::Rail);
        assert!(found.iter().any(|(_, oddity)| matches!(oddity, Oddity::Loop { .. })), "{found:?}");
    }
}
