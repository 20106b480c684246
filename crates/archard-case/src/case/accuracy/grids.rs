//! The grids that are tried for an accuracy: coarser ones and finer ones.

use super::companions::Unsettled;
use super::{counted, increments, locate};
use crate::case::check::Parts;
use crate::case::definition::{Case, MOST, Output};
use crate::case::file::Resolved;
use archard::parameters::Value;

/// The key of the tolerance of the steps.
pub(super) const TOLERANCE: &str = "tolerance";

impl Resolved {
    /// The case made so many times coarser in the same frame, its grid moved by half an element along the motion and across. One
    /// element more or less does that, and the centre of the frame, where values are read, stays.
    pub(super) fn coarser(&self, ratio: f64, moved: [bool; 2]) -> Result<Case, Unsettled> {
        let mut case = self.case.clone();
        let own = self.case.frame;
        let parts = Parts::of(&self.case).map_err(Box::new)?;
        // Frames that become wider or repeat themselves have an even number of elements: they are moved as a whole.
        let widens = !case.doubles.is_empty() || own.periodic;
        let known = locate::known(&parts);
        for axis in 0..if own.line { 1 } else { 2 } {
            let elements = own.elements[axis];
            let moved = [moved, [moved[1], moved[0]]][parts.motion.direction.axis];
            let other = usize::from(moved[axis] && !widens);
            case.frame.elements[axis] = nearest(elements as f64 / ratio, elements + other);
            // As far as the surfaces are known: measured ones end with their readings.
            let last = own.centre[axis] + 0.5 * own.size[axis];
            if widens && moved[axis] && last <= known[axis][1] {
                case.frame.centre[axis] += 0.5 * case.frame.spacing()[axis];
            }
        }
        if let Some(tolerance) = case.motion.values.number(TOLERANCE) {
            case.motion.values.insert(TOLERANCE, Value::Number(tolerance * ratio * ratio));
        }
        if let Some(count) = increments::of_rubbing(&case) {
            increments::set(&mut case, increments::fewer(count, ratio));
        }
        // Steps that end at outputs become no longer unless outputs become fewer.
        let outputs = case.output.places(parts.schedule.extent);
        let fewer = outputs.iter().rev().step_by(ratio.ceil() as usize).rev();
        case.output = Output::At(fewer.copied().collect());
        Ok(case)
    }

    /// Makes all that was chosen so many times finer, and the tolerance smaller by that power of it, the order of the error;
    /// whether so many elements are allowed.
    pub(super) fn refine(&mut self, finer: f64, order: f64) -> Result<bool, Unsettled> {
        if self.chose.elements {
            let refined = |n: usize| if n == 1 { 1 } else { counted(finer * n as f64, n) };
            let refined = self.case.frame.elements.map(refined);
            if refined.iter().any(|&n| n > MOST) {
                return Ok(false);
            }
            self.case.frame.elements = refined;
        }
        if self.chose.increments {
            increments::refine(&mut self.case, finer);
        }
        if let Some(tolerance) =
            self.case.motion.values.number(TOLERANCE).filter(|_| self.chose.tolerance)
        {
            let finer = Value::Number(tolerance / finer.powf(order));
            self.case.motion.values.insert(TOLERANCE, finer);
        }
        self.settle_again()?;
        Ok(true)
    }

    /// Elements across the first contact, or across the frame where no closed form tells it.
    pub(super) fn across(&self) -> f64 {
        let frame = self.case.frame;
        let contact = self.forecast.estimate.contact;
        let axes = if frame.line { 1 } else { 2 };
        let elements = (0..axes).map(|axis| {
            let element = frame.spacing()[axis];
            contact.map_or(frame.size[axis], |contact| 2.0 * contact.semi_axes[axis]) / element
        });
        elements.fold(f64::INFINITY, f64::min)
    }
}

/// The number of elements next to some number that is even or odd as another is.
fn nearest(wanted: f64, as_another: usize) -> usize {
    let odd = as_another % 2;
    odd + 2 * ((0.5 * (wanted - odd as f64)).round() as usize).max(1)
}
