//! The lines there are, each with its bounds and what these were measured on.

use super::{Bound, Line};

/// The load that is carried against the one prescribed, relative to it.
///
/// Solvers end at residuals of 1e-8 (pressures) and 1e-6 (friction with pressures); a lost contact is off by 1.
pub fn load(off: f64) -> Line {
    Line::new("load", off, Bound::AtMost([1e-5, 1e-3]), "of the load prescribed is not carried")
}

/// What is left of the balance of forces and of moments on an elastic body, relative to the load and to the load
/// times half of the body's extent.
///
/// Measured on cantilevers under end shear of 10:1, 5:1 and 3:1, bars and tubes, at Poisson's ratios from 0 to 0.45,
/// and on a ball on a cantilever of 20 x 4 x 2 mm. Results within 3 % left up to 0.20 of the force and 0.33 of the
/// moment, at Poisson's ratios up to 0.3 up to 0.10 and 0.18: most of that comes from the edges of clamps. Tips
/// 30 % off and more left 0.54 of the moment at least; in contact an approach 10 % off left 0.27 and 0.48, one
/// within 1 % 0.04 and 0.08.
pub fn balance(force: f64, moment: f64) -> [Line; 2] {
    let text = |what: &str| {
        format!(
            "of the {what} is not balanced: take shorter elements along the body, two thirds of its thickness at most"
        )
    };
    [
        Line::new("forces", force, Bound::AtMost([0.2, 0.25]), text("load")),
        Line::new("moments", moment, Bound::AtMost([0.25, 0.4]), text("load's moment")),
    ]
}

/// The longest element along a free span beside the thickness that bends there.
///
/// Tips of cantilevers under end shear were 0.2 to 1.7 % off up to 0.83, 3 to 5 % at 1, 11 to 14 % at 1.25, 35 % at
/// 1.5 and worse beyond. It is never wrong by itself: walls of hollow sections bear longer ones.
pub fn slenderness(longest: f64) -> Line {
    let bound = Bound::AtMost([0.85, f64::INFINITY]);
    let text = "of the thickness below it is the length of the longest element where the body can bend: take shorter ones, two thirds of the thickness at most";
    Line::new("bending", longest, bound, text)
}
