//! What drives bodies whose slip is sought: creepages or displacements, forces, and spin.

use super::Axis;
use crate::frame::Flow;

/// What drives the bodies along one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drive {
    /// The rigid slip of body 2 over body 1: in rolling the creepage, in increments the displacement (m). The force follows.
    Slip(f64),
    /// The force on body 1 (N); the slip follows.
    Force(f64),
}

impl Drive {
    /// That share of it.
    #[must_use]
    pub fn share(self, share: f64) -> Self {
        match self {
            Self::Slip(slip) => Self::Slip(share * slip),
            Self::Force(force) => Self::Force(share * force),
        }
    }

    /// Its slip, if it is given; zero where a force is.
    pub fn slip(self) -> f64 {
        if let Self::Slip(slip) = self { slip } else { 0.0 }
    }

    /// The slip or the force.
    pub fn value(self) -> f64 {
        let (Self::Slip(value) | Self::Force(value)) = self;
        value
    }

    /// Whether it neither slips nor pushes.
    pub fn is_still(self) -> bool {
        self.value() == 0.0
    }
}

/// What drives bodies that roll.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Drives {
    /// Along the direction of the motion.
    pub longitudinal: Drive,
    /// Across it, a quarter turn on from t1 to t2.
    pub lateral: Drive,
    /// Spin about n (1/m), positive where the surface of body 2 turns from t1 to t2 beneath body 1.
    pub spin: f64,
    /// What the longitudinal creepage gains with the square of the place across (1/m^2): the rolling radius differs over a curved contact
    /// (H. L. Heathcote, *Proc. Inst. Automobile Engineers* 15 (1921) 569).
    pub bow: f64,
    /// The axes of the bodies, from which spin and bow follow; `None` where these are given.
    pub axes: Option<[Axis; 2]>,
    /// Whether the longitudinal creepage follows the worn radii of the bodies.
    pub worn_radius: bool,
}

impl Drives {
    /// Neither creepage nor force nor spin.
    pub const FREE: Self = Self {
        longitudinal: Drive::Slip(0.0),
        lateral: Drive::Slip(0.0),
        spin: 0.0,
        bow: 0.0,
        axes: None,
        worn_radius: false,
    };

    /// All of them raised to that share.
    #[must_use]
    pub fn raised(&self, share: f64) -> Self {
        let [longitudinal, lateral] = self.both().map(|drive| drive.share(share));
        Self { longitudinal, lateral, spin: share * self.spin, bow: share * self.bow, ..*self }
    }

    /// Whether the rigid bodies slip by the same all over the contact.
    pub fn is_even(&self) -> bool {
        self.spin == 0.0 && self.bow == 0.0
    }

    /// Those along the direction and across it.
    pub fn both(&self) -> [Drive; 2] {
        [self.longitudinal, self.lateral]
    }

    /// Of creepages along the direction and across it, those that forces make.
    pub fn by_force(&self, [forward, lateral]: [f64; 2]) -> [f64; 2] {
        let found = |drive, creepage| if matches!(drive, Drive::Force(_)) { creepage } else { 0.0 };
        [found(self.longitudinal, forward), found(self.lateral, lateral)]
    }

    /// Slip (m) of the rigid bodies, body 2 over body 1 along t1 and t2, of particles on their passage to each pair,
    /// one value a pair; without what drives by force.
    pub fn rigid_slip(&self, flow: Flow<'_>) -> [Vec<f64>; 2] {
        let direction = flow.direction();
        let (forward, lateral) = (direction.forward(), direction.lateral());
        let pairs = flow.frame().len();
        let advances = flow.advances().unwrap_or_else(|| vec![flow.advance(); pairs]);
        // The displacement by spin of a particle, counted from x = 0. Its gain from pair to pair is the slip. The
        // difference has the same error as that of the elastic displacements.
        let turned = |pair: usize| {
            let place = flow.frame().place(pair);
            let along = |unit: [f64; 2]| place[0] * unit[0] + place[1] * unit[1];
            let (x, y) = (along(forward), along(lateral));
            [0, 1].map(|axis| self.spin * (x * y * forward[axis] - 0.5 * x * x * lateral[axis]))
        };
        let turned: Vec<[f64; 2]> = (0..pairs).map(turned).collect();
        let [one, two] =
            [0, 1].map(|axis| turned.iter().map(|both| both[axis]).collect::<Vec<_>>());
        let mut slip = flow.gained([&one, &two]);
        let bowed = |pair: usize| {
            let place = flow.frame().place(pair);
            let across = place[0] * lateral[0] + place[1] * lateral[1];
            self.bow * across * across
        };
        for (axis, slip) in slip.iter_mut().enumerate() {
            let creepage =
                self.longitudinal.slip() * forward[axis] + self.lateral.slip() * lateral[axis];
            slip.iter_mut().zip(&advances).for_each(|(slip, advance)| *slip += advance * creepage);
            if self.bow != 0.0 {
                let bowed = (0..pairs).map(|pair| advances[pair] * bowed(pair) * forward[axis]);
                slip.iter_mut().zip(bowed).for_each(|(slip, bowed)| *slip += bowed);
            }
        }
        slip
    }
}
