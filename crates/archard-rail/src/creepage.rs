//! The creepages: how fast the wheel slides over the rail for each metre that it rolls.
//!
//! The wheel is a rigid body. Its point Q at the contact moves with v = v0 + w x (Q - C), v0 the velocity of the middle C
//! of the axle and w the rotation. The rolling speed is V = (|v0| + |w x (Q - C)|)/2. In the frame of the contact the
//! creepages are xi = -v_x/V and eta = -v_s/V, the spin creepage is phi = -w_n/V. Q lies on the undeformed wheel: below the
//! reference point by the overlap along the normal. Without that, xi would be off by the overlap over the radius. On a roller the velocity
//! of its surface takes the place of -v0 along the track, and its rotation is taken from w.

use glam::DVec3;

use crate::search::{Patch, Search};
use crate::setup::Velocity;

/// The creepages at a contact, the wheel's over the rail, in the frame of the contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Creepage {
    /// xi (-), along x: positive if the wheel is driven.
    pub longitudinal: f64,
    /// eta (-), along s.
    pub lateral: f64,
    /// phi (1/m), about n.
    pub spin: f64,
    /// Rolling speed V (m/s).
    pub speed: f64,
}

impl Creepage {
    /// The creepages of that patch with that velocity, as its side sees it, at Q `approach` (m) along n below the
    /// reference point.
    ///
    /// They are not numbers if the wheelset stands still.
    pub fn new(search: &Search, patch: &Patch, velocity: &Velocity, approach: f64) -> Self {
        let attitude = search.attitude();
        let centre = search.setup().centre(attitude, patch.height);
        let frame = patch.frame();
        let rotation = velocity.rotation(attitude);
        let point = patch.reference + frame.z_axis * approach;
        let turning = rotation.cross(point - centre);
        // Over a straight rail that passes backwards below it the wheelset itself goes no way forwards.
        let [rail, turns] = search.setup().roller().moves(point, velocity.forward);
        let over = velocity.translation() - DVec3::X * velocity.forward - rail;
        let speed = 0.5 * (over.length() + turning.length());
        let DVec3 { x, y, .. } = frame.transpose() * (over + turning);
        let spin = -frame.z_axis.dot(rotation - turns) / speed;
        Self { longitudinal: -x / speed, lateral: -y / speed, spin, speed }
    }

    /// The same with creepage, lateral creepage and spin (1/m) that are prescribed.
    #[must_use]
    pub fn prescribed(self, [longitudinal, lateral, spin]: [Option<f64>; 3]) -> Self {
        Self {
            longitudinal: longitudinal.unwrap_or(self.longitudinal),
            lateral: lateral.unwrap_or(self.lateral),
            spin: spin.unwrap_or(self.spin),
            speed: self.speed,
        }
    }
}
