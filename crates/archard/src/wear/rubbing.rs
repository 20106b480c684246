//! What rubbed points go through.

use serde::{Deserialize, Serialize};

use super::Input;

/// What one point of a body went through during a step.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct Rubbing {
    /// Pressure (Pa), zero or greater.
    pub pressure: f64,
    /// Distance slid while the step lasted (m), zero or greater.
    pub slip: f64,
    /// Work of friction on that slip (J/m^2).
    pub work: f64,
    /// How the largest tangential traction grows with the pressure: Coulomb's mu. Zero without friction.
    pub friction: f64,
    /// Slip of body 2 over body 1 (m) along t1 and t2; of a whole cycle, the sum.
    pub slip_vector: [f64; 2],
    /// Tangential traction on body 1 (Pa) along t1 and t2.
    pub traction: [f64; 2],
    /// Integral of p e e^T over the slip (Pa m), e the direction of slip along t1 and t2: its components 11, 22 and 12.
    pub directions: [f64; 3],
    /// Speed of sliding (m/s); zero where it is not known.
    pub speed: f64,
    /// Temperature of the surfaces (K); zero where it is not known.
    pub temperature: f64,
    /// Distance (m) that the bodies rolled meanwhile; zero where they do not roll.
    pub rolled: f64,
    /// Distance (m) that the point slid before, under pressure.
    pub distance: f64,
    /// Depth (m) worn off this body there before.
    pub depth: f64,
}

impl Rubbing {
    /// Slip (m) under a pressure (Pa), without friction.
    pub fn new(pressure: f64, slip: f64) -> Self {
        Self { pressure, slip, ..Self::default() }
    }

    /// The same with friction: its work (J/m^2), and how its limit grows with the pressure.
    #[must_use]
    pub fn with_friction(self, work: f64, friction: f64) -> Self {
        Self { work, friction, ..self }
    }

    /// The same along t1 and t2: slip of body 2 over body 1 (m), and traction on body 1 (Pa).
    #[must_use]
    #[inline]
    pub fn with_vectors(self, slip_vector: [f64; 2], traction: [f64; 2]) -> Self {
        let [x, y] = slip_vector;
        let length = x.hypot(y);
        let scale = if length > 0.0 { self.pressure * self.slip / (length * length) } else { 0.0 };
        let directions = [x * x, y * y, x * y].map(|product| scale * product);
        Self { slip_vector, traction, directions, ..self }
    }

    /// The same at a speed of sliding (m/s).
    #[must_use]
    pub fn at_speed(self, speed: f64) -> Self {
        Self { speed, ..self }
    }

    /// The same at a temperature of the surfaces (K).
    #[must_use]
    pub fn at_temperature(self, temperature: f64) -> Self {
        Self { temperature, ..self }
    }

    /// The same while the bodies rolled a distance (m).
    #[must_use]
    pub fn rolling(self, rolled: f64) -> Self {
        Self { rolled, ..self }
    }

    /// The same of a point that has slid a distance (m) and worn to a depth (m) before.
    #[must_use]
    pub fn after(self, distance: f64, depth: f64) -> Self {
        Self { distance, depth, ..self }
    }

    /// A share of it: of the slip, under the same pressure.
    #[must_use]
    pub fn share(self, share: f64) -> Self {
        Self {
            slip: share * self.slip,
            work: share * self.work,
            slip_vector: self.slip_vector.map(|part| share * part),
            directions: self.directions.map(|part| share * part),
            rolled: share * self.rolled,
            ..self
        }
    }

    /// The same along axes in which t1 lies along a direction (cosine and sine from their first).
    #[must_use]
    pub fn along(self, [c, s]: [f64; 2]) -> Self {
        let turned = |[x, y]: [f64; 2]| [c * x - s * y, s * x + c * y];
        let [xx, yy, xy] = self.directions;
        let both = 2.0 * c * s * xy;
        Self {
            slip_vector: turned(self.slip_vector),
            traction: turned(self.traction),
            directions: [
                c * c * xx + s * s * yy - both,
                s * s * xx + c * c * yy + both,
                c * s * (xx - yy) + (c * c - s * s) * xy,
            ],
            ..self
        }
    }

    /// Friction over pressure; zero without pressure or slip.
    pub fn coefficient(&self) -> f64 {
        let rubbed = self.pressure * self.slip;
        if rubbed > 0.0 { self.work / rubbed } else { 0.0 }
    }

    /// How much the directions of slip cross each other: the smaller eigenvalue of the [integral](Self::directions) over
    /// its trace, from zero of slip along one line to a half of slip in all directions equally.
    pub fn cross_shear(&self) -> f64 {
        let [x, y, both] = self.directions;
        let trace = x + y;
        let smaller = 0.5 * (trace - (x - y).hypot(2.0 * both));
        // What rounding leaves of slip along a line does not count.
        if smaller > 1e-14 * trace { smaller / trace } else { 0.0 }
    }

    /// The same with friction scaled by a factor.
    #[must_use]
    pub fn gripping(self, factor: f64) -> Self {
        let traction = self.traction.map(|part| factor * part);
        Self { work: factor * self.work, friction: factor * self.friction, traction, ..self }
    }

    /// This and what comes after it, together: pressure, traction, speed and temperature are means over the
    /// slip.
    #[must_use]
    pub fn then(self, next: Self) -> Self {
        let slip = self.slip + next.slip;
        let mean = |one: f64, other: f64| {
            if slip > 0.0 { (one * self.slip + other * next.slip) / slip } else { other }
        };
        let [x, y] = [0, 1].map(|axis| [self, next].map(|one| one.traction[axis]));
        Self {
            pressure: mean(self.pressure, next.pressure),
            slip,
            work: self.work + next.work,
            friction: mean(self.friction, next.friction),
            slip_vector: [0, 1].map(|axis| self.slip_vector[axis] + next.slip_vector[axis]),
            traction: [x, y].map(|[one, other]| mean(one, other)),
            directions: [0, 1, 2].map(|part| self.directions[part] + next.directions[part]),
            speed: mean(self.speed, next.speed),
            temperature: mean(self.temperature, next.temperature),
            rolled: self.rolled + next.rolled,
            ..self
        }
    }

    /// The same slip under another pressure (Pa); work and traction follow as the limit of friction does.
    #[must_use]
    pub fn under(self, pressure: f64) -> Self {
        let more = self.friction * (pressure - self.pressure) * self.slip;
        let work = self.work + more;
        let ratio = if self.work > 0.0 { work / self.work } else { 1.0 };
        let share = if self.pressure > 0.0 { pressure / self.pressure } else { 1.0 };
        Self {
            pressure,
            work,
            traction: self.traction.map(|traction| ratio * traction),
            directions: self.directions.map(|part| share * part),
            ..self
        }
    }
}

/// What many points went through: the values of [`Rubbing`], one a point. What a law does not [ask for](Input) is empty.
#[non_exhaustive]
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Columns {
    /// Pressure (Pa).
    pub pressure: Vec<f64>,
    /// Distance slid (m).
    pub slip: Vec<f64>,
    /// Work of friction (J/m^2).
    pub work: Vec<f64>,
    /// How the largest tangential traction grows with the pressure.
    pub friction: Vec<f64>,
    /// Slip of body 2 over body 1 (m) along t1 and t2.
    pub slip_vector: [Vec<f64>; 2],
    /// Tangential traction on body 1 (Pa) along t1 and t2.
    pub traction: [Vec<f64>; 2],
    /// How much the directions of slip [cross](Rubbing::cross_shear) each other.
    pub cross_shear: Vec<f64>,
    /// Speed of sliding (m/s).
    pub speed: Vec<f64>,
    /// Temperature of the surfaces (K).
    pub temperature: Vec<f64>,
    /// Distance rolled (m).
    pub rolled: Vec<f64>,
    /// Distance slid before (m).
    pub distance: Vec<f64>,
    /// Depth worn off this body before (m).
    pub depth: Vec<f64>,
}

/// An input that is one number a point: what formulas call it, its unit, and where it stands.
pub(super) struct Number {
    pub input: Input,
    pub name: &'static str,
    pub unit: &'static str,
    pub of: fn(&Rubbing) -> f64,
    column: fn(&Columns) -> &Vec<f64>,
    column_mut: fn(&mut Columns) -> &mut Vec<f64>,
}

/// All of them.
pub(super) const NUMBERS: &[Number] = {
    macro_rules! number {
        ($input:ident, $name:literal, $unit:literal, $column:ident, $of:expr) => {
            Number {
                input: Input::$input,
                name: $name,
                unit: $unit,
                of: $of,
                column: |all| &all.$column,
                column_mut: |all| &mut all.$column,
            }
        };
    }
    &[
        number!(CrossShear, "cs", "", cross_shear, |one| one.cross_shear()),
        number!(Speed, "v", "m/s", speed, |one| one.speed),
        number!(Temperature, "temperature", "K", temperature, |one| one.temperature),
        number!(Rolled, "rolled", "m", rolled, |one| one.rolled),
        number!(Distance, "distance", "m", distance, |one| one.distance),
        number!(Depth, "worn", "m", depth, |one| one.depth),
    ]
};

impl Columns {
    /// What points went through, as far as it is asked for.
    pub fn of(points: impl IntoIterator<Item = Rubbing>, asked: &[Input]) -> Self {
        let asks = |input| asked.contains(&input);
        let (friction, vectors) = (asks(Input::Friction), asks(Input::Vectors));
        let numbers = || NUMBERS.iter().filter(|number| asks(number.input));
        let mut columns = Self::default();
        for point in points {
            columns.pressure.push(point.pressure);
            columns.slip.push(point.slip);
            if friction {
                columns.work.push(point.work);
                columns.friction.push(point.friction);
            }
            if vectors {
                for axis in 0..2 {
                    columns.slip_vector[axis].push(point.slip_vector[axis]);
                    columns.traction[axis].push(point.traction[axis]);
                }
            }
            for number in numbers() {
                (number.column_mut)(&mut columns).push((number.of)(&point));
            }
        }
        columns
    }

    /// The column of what a law may ask for as one number; empty of what is more than that.
    pub(super) fn numbers(&self, input: Input) -> &[f64] {
        NUMBERS
            .iter()
            .find(|number| number.input == input)
            .map_or(&[], |number| (number.column)(self))
    }

    /// Number of points.
    pub fn len(&self) -> usize {
        self.pressure.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.pressure.is_empty()
    }

    /// What one of them went through; zero what is left out. The directions of slip that cross are those of t1 and t2.
    pub fn at(&self, point: usize) -> Rubbing {
        let of = |column: &Vec<f64>| column.get(point).copied().unwrap_or_default();
        let across = of(&self.cross_shear);
        let crossing = [1.0 - across, across, 0.0];
        Rubbing {
            pressure: self.pressure[point],
            slip: self.slip[point],
            work: of(&self.work),
            friction: of(&self.friction),
            slip_vector: self.slip_vector.each_ref().map(of),
            traction: self.traction.each_ref().map(of),
            directions: crossing.map(|part| part * self.pressure[point] * self.slip[point]),
            speed: of(&self.speed),
            temperature: of(&self.temperature),
            rolled: of(&self.rolled),
            distance: of(&self.distance),
            depth: of(&self.depth),
        }
    }
}
