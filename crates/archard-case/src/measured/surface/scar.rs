//! The scar on a measured surface, found by the readings alone: levelled by what lies next to it, and measured.
//!
//! The level is first found roughly ([`rough`](super::rough)). What lies below it by more than chance, in one piece, is the
//! scar; the plane is fitted anew to the readings next to it, and so on until the scar stays where it is. The middle of what
//! is worn off counts as the middle of the contact, where the body had its apex.

use super::super::plane::{BEYOND_CHANCE, DEBRIS, FEWEST, Height, Plane, ROUNDS};
use super::integral::Zone;
use super::noise::{repeats, step};
use super::{NoScar, Surface, rough};

/// What a surface was before it was worn.
#[derive(Clone, Copy)]
pub struct UnwornSurface<'a> {
    /// Height (m) out of the material at a place (m) from the middle of the contact; not a number beyond the body.
    pub height: &'a dyn Fn([f64; 2]) -> f64,
    /// Axes along which the scar runs on beyond a map, as a track does.
    pub through: [bool; 2],
}

impl<'a> UnwornSurface<'a> {
    /// Of a body of that shape that passes along an axis (0: x, 1: y), or along none.
    pub fn passing(height: &'a dyn Fn([f64; 2]) -> f64, axis: Option<usize>) -> Self {
        Self { height, through: [0, 1].map(|own| axis == Some(own)) }
    }
}

/// A scar, in the coordinates of the instrument.
#[derive(Debug, Clone, PartialEq)]
pub struct Scar {
    /// The plane that the surface lay on next to its shape.
    pub plane: Plane,
    /// The middle of the scar (m).
    pub middle: [f64; 2],
    /// From where to where it reaches along x and y (m).
    pub extent: [[f64; 2]; 2],
    /// What is worn off: the section of a profile, or on average of the map of a track, square to it (m^2); the volume of a
    /// map (m^3).
    pub worn: f64,
    /// Its standard uncertainty by the scatter next to the scar, the level, the step that heights are rounded to, and what
    /// may lie between readings and in gaps (the same unit). Form error is not in it.
    pub uncertainty: f64,
    /// The greatest depth, averaged over a fiftieth of the surface along each axis (m).
    pub deepest: f64,
    /// The angle (rad) from the axis that a track runs along to the track in its map, towards the other axis; zero of others.
    pub angle: f64,
    /// Places in the scar without a reading that could be used.
    pub gaps: usize,
}

/// Share of its width that the scar is measured beyond its edges, and beyond which readings lie next to it.
const MARGIN: f64 = 0.1;
const BESIDE: f64 = 0.15;
/// Scatter, relative to the step that heights are rounded to, from which on rounding spreads as noise does: half a step of
/// noise, and the rounding itself.
const DITHERED: f64 = 0.58;
/// Most that may be uncertain.
const UNCERTAIN: f64 = 0.3;

impl Scar {
    /// The scar on a surface.
    ///
    /// # Errors
    /// If none stands out, nothing lies next to it, or it is not told well enough.
    pub fn find(surface: &Surface, unworn: UnwornSurface<'_>) -> Result<Self, NoScar> {
        let mut middle = [0, 1].map(|axis| surface.extent(axis).iter().sum::<f64>() / 2.0);
        let mut level = surface.rough_level(&surface.less(unworn, middle))?;
        let rounding = step(&surface.heights) / 12f64.sqrt();
        let mut last: Option<[[usize; 2]; 2]> = None;
        for _ in 0..ROUNDS {
            let depths = surface.depths(unworn, middle, &level);
            let found = surface
                .largest_piece(&depths, [level.scatter().max(rounding), level.repeats])
                .ok_or(NoScar::Nothing)?;
            let extent = surface.with_through(found, unworn.through)?;
            middle = surface.middle_of(&depths, extent, unworn.through);
            let beside = surface.beside(&surface.less(unworn, middle), extent, unworn.through)?;
            level = Level::of(surface, &beside).ok_or(NoScar::Nothing)?;
            if last == Some(found) {
                break;
            }
            last = Some(found);
        }
        surface.measure(unworn, (middle, level), last.ok_or(NoScar::Nothing)?)
    }

    /// What is worn off at each reading (m), and its place from the middle of the scar.
    pub fn depths(&self, surface: &Surface, unworn: UnwornSurface<'_>) -> Vec<Height> {
        let [x, y] = self.middle;
        let less = surface.less(unworn, self.middle).into_iter();
        let depth = |own: Height| [own[0] - x, own[1] - y, -self.plane.above(&own)];
        less.map(depth).filter(|own| own[2].is_finite()).collect()
    }
}

/// The plane next to a scar, and in how many readings there is one that is independent.
#[derive(Debug, Clone, Copy)]
struct Level {
    plane: Plane,
    repeats: f64,
}

impl Level {
    /// Of readings next to a scar; those of gaps and of the scar are not numbers.
    fn of(surface: &Surface, beside: &[Height]) -> Option<Self> {
        let known: Vec<Height> = beside.iter().copied().filter(|own| own[2].is_finite()).collect();
        let plane = Plane::through(&known)?;
        let off = |own: &Height| {
            let above = plane.above(own);
            if above.abs() <= DEBRIS * plane.scatter { above } else { f64::NAN }
        };
        let off: Vec<f64> = beside.iter().map(off).collect();
        Some(Self { plane, repeats: repeats(&off, surface.places[0].len()) })
    }

    /// Standard deviation of a reading (m).
    fn scatter(&self) -> f64 {
        self.plane.scatter
    }
}

impl Surface {
    /// Heights less those of the unworn body around a middle.
    fn less(&self, unworn: UnwornSurface<'_>, middle: [f64; 2]) -> Vec<Height> {
        let one = |cell: usize| {
            let [x, y, z] = self.at(cell);
            [x, y, z - (unworn.height)([x - middle[0], y - middle[1]])]
        };
        (0..self.heights.len()).map(one).collect()
    }

    /// The level without knowing where the scar is.
    fn rough_level(&self, heights: &[Height]) -> Result<Level, NoScar> {
        let known: Vec<Height> = heights.iter().copied().filter(|own| own[2].is_finite()).collect();
        if known.len() < 3 * FEWEST {
            return Err(NoScar::Few { readings: known.len(), least: 3 * FEWEST });
        }
        let mut plane = rough::level(self, &known).ok_or(NoScar::Nothing)?;
        let mut deviation = rough::deviation(&plane, &known);
        for _ in 0..ROUNDS {
            let on = |own: &&Height| plane.above(own).abs() <= BEYOND_CHANCE * deviation;
            let on: Vec<Height> = known.iter().filter(on).copied().collect();
            let Some(found) = Plane::through(&on) else { break };
            (plane, deviation) = (found, found.scatter.max(f64::MIN_POSITIVE));
        }
        Ok(Level { plane, repeats: 1.0 })
    }

    /// The places along an axis (m) that have readings.
    fn seen(&self, axis: usize) -> Vec<f64> {
        let columns = self.places[0].len();
        let mut seen = vec![false; self.places[axis].len()];
        for (cell, height) in self.heights.iter().enumerate() {
            seen[[cell % columns, cell / columns][axis]] |= height.is_finite();
        }
        let places = self.places[axis].iter().zip(seen);
        places.filter(|(_, seen)| *seen).map(|(place, _)| *place).collect()
    }

    /// What is worn off at each cell (m); not a number in gaps.
    fn depths(&self, unworn: UnwornSurface<'_>, middle: [f64; 2], level: &Level) -> Vec<f64> {
        self.less(unworn, middle).iter().map(|own| -level.plane.above(own)).collect()
    }

    /// From where to where a piece reaches (m); all along where it runs through.
    fn with_through(
        &self,
        piece: [[usize; 2]; 2],
        through: [bool; 2],
    ) -> Result<[[f64; 2]; 2], NoScar> {
        let mut extent = [[0.0; 2]; 2];
        for axis in 0..2 {
            let places = &self.places[axis];
            if through[axis] || places.len() == 1 {
                extent[axis] = self.extent(axis);
                continue;
            }
            let [first, last] = piece[axis];
            if first == 0 || last + 1 == places.len() {
                return Err(NoScar::Fills { axis: ["x", "y"][axis] });
            }
            extent[axis] = [places[first], places[last]];
        }
        Ok(extent)
    }

    /// The middle of what is worn off within an extent, and of the map where the scar runs through.
    fn middle_of(&self, depths: &[f64], extent: [[f64; 2]; 2], through: [bool; 2]) -> [f64; 2] {
        let wide = wider(extent, MARGIN);
        let inside = |cell: &usize| depths[*cell].is_finite() && holds(wide, self.at(*cell));
        let cells: Vec<usize> = (0..depths.len()).filter(inside).collect();
        let all: f64 = cells.iter().map(|&cell| depths[cell]).sum();
        [0, 1].map(|axis| {
            let moment: f64 = cells.iter().map(|&cell| depths[cell] * self.at(cell)[axis]).sum();
            let [low, high] = extent[axis];
            let through = through[axis] || low == high || all <= 0.0;
            if through { 0.5 * (low + high) } else { (moment / all).clamp(low, high) }
        })
    }

    /// Heights next to a scar, in the place of the others no number.
    fn beside(
        &self,
        heights: &[Height],
        extent: [[f64; 2]; 2],
        through: [bool; 2],
    ) -> Result<Vec<Height>, NoScar> {
        let wide = wider(extent, BESIDE);
        for axis in 0..2 {
            let places = self.seen(axis);
            let below = places.iter().filter(|place| **place < wide[axis][0]).count();
            let above = places.iter().filter(|place| **place > wide[axis][1]).count();
            if !through[axis] && self.places[axis].len() > 1 && below.min(above) < FEWEST / 2 {
                return Err(NoScar::Fills { axis: ["x", "y"][axis] });
            }
        }
        let left = |own: &Height| {
            if holds(wide, *own) { [own[0], own[1], f64::NAN] } else { *own }
        };
        Ok(heights.iter().map(left).collect())
    }

    /// What is worn off, once it is known where.
    fn measure(
        &self,
        unworn: UnwornSurface<'_>,
        (middle, level): ([f64; 2], Level),
        piece: [[usize; 2]; 2],
    ) -> Result<Scar, NoScar> {
        let extent = self.with_through(piece, unworn.through)?;
        let depths = self.depths(unworn, middle, &level);
        let wide = wider(extent, MARGIN);
        // The next reading next to the worn ones lies outside: as far as there the scar may reach.
        let beside = [0, 1].map(|axis| {
            let places = &self.places[axis];
            match unworn.through[axis] || places.len() == 1 {
                true => extent[axis],
                false => {
                    let [low, high] = extent[axis];
                    let seen = self.seen(axis);
                    [
                        seen.iter().rfind(|place| **place < low).map_or(places[0], |own| *own),
                        seen.iter()
                            .find(|place| **place > high)
                            .map_or(places[places.len() - 1], |own| *own),
                    ]
                }
            }
        });
        let zone = [0, 1].map(|axis| {
            let ([low, high], [first, last]) = (wide[axis], beside[axis]);
            let through = unworn.through[axis];
            let all = if through { extent[axis] } else { [low.min(first), high.max(last)] };
            Zone { scar: extent[axis], all, through }
        });
        let integral = self.integral(&depths, zone)?;
        // Ridges and debris take nothing off what is worn.
        let debris = -DEBRIS * level.scatter();
        let worn = |cell: usize| if depths[cell] < debris { 0.0 } else { depths[cell] };
        let lengths = [0, 1].map(|axis| self.extent(axis)).map(|[low, high]| high - low);
        let along = (0..2).find(|&axis| unworn.through[axis] && self.axis.is_none());
        let noise = level.scatter() * level.repeats.sqrt();
        let [askew, about] = along
            .map_or([0.0; 2], |along| self.askew((&integral, &depths), (along, middle), noise));
        let angle = askew.atan();
        let scale = along.map_or(1.0, |along| angle.cos() / lengths[along]);
        let sum = |part: &dyn Fn(usize, f64) -> f64| -> f64 {
            integral.shares.iter().map(|&(cell, share)| part(cell, share * scale)).sum()
        };
        let (all, whole) = (sum(&|cell, share| share * worn(cell)), sum(&|_, share| share));
        let centre = [0, 1].map(|axis| sum(&|cell, share| share * self.at(cell)[axis]) / whole);
        let readings = sum(&|_, share| share * share);
        let of_level = whole * whole * level.plane.variance_at(centre);
        let smoothed = self.smoothed(&depths);
        let deepest = integral.shares.iter().map(|(cell, _)| smoothed[*cell]).fold(0.0, f64::max);
        // Between readings it is bent as a parabola of its depth and width.
        let bent = |axis: usize| {
            let [worn, all] = [extent[axis], beside[axis]].map(|[low, high]| high - low);
            let skewed = along.map_or(0.0, |along| askew.abs() * lengths[along]);
            let half = 0.25 * (worn + all) - 0.5 * skewed;
            deepest / half.max(0.25 * (all - worn)).powi(2) * integral.between[axis]
        };
        let bent: f64 = (0..2).filter(|&axis| integral.between[axis] > 0.0).map(bent).sum();
        let by_angle = all * askew * about * angle.cos().powi(2);
        // Without noise all of it may be rounded equally.
        let step = step(&self.heights);
        let rounded = level.scatter() < DITHERED * step;
        let of_steps = if rounded { whole * step / 12f64.sqrt() } else { 0.0 };
        let by_noise = noise * (readings + of_level).sqrt();
        let uncertainty = by_noise.hypot(bent * scale).hypot(by_angle).hypot(of_steps);
        let share = uncertainty / all;
        if all <= 0.0 || share.is_nan() || share > UNCERTAIN {
            let (share, scatter) = (share.abs(), level.scatter());
            return Err(NoScar::Uncertain { share, deepest, scatter });
        }
        let (plane, gaps) = (level.plane, integral.gaps);
        Ok(Scar { plane, middle, extent, worn: all, uncertainty, deepest, angle, gaps })
    }
}

/// An extent with a share of its width on either side.
fn wider(extent: [[f64; 2]; 2], share: f64) -> [[f64; 2]; 2] {
    extent.map(|[low, high]| [low - share * (high - low), high + share * (high - low)])
}

/// Whether a place lies in an extent.
fn holds(extent: [[f64; 2]; 2], [x, y, _]: Height) -> bool {
    let within = |[low, high]: [f64; 2], place: f64| (low..=high).contains(&place);
    within(extent[0], x) && within(extent[1], y)
}
