//! A case on a larger frame, for a contact that outgrew its own.

use super::file::Resolved;
use super::problem::Severity;

/// Most elements along an axis that a frame grows to.
const MOST: usize = 1024;

impl Resolved {
    /// The case on a frame half as large again, with elements as large as before, an even or odd number as before; `None`
    /// where a body is meshed, the profiles do not reach so far, or the elements would be too many.
    pub fn on_a_larger_frame(&self) -> Option<Self> {
        let mut larger = self.clone();
        let frame = &mut larger.case.frame;
        if self.case.is_meshed() || frame.periodic || self.case.accuracy.is_some() {
            return None;
        }
        for axis in 0..if frame.line { 1 } else { 2 } {
            let count = frame.elements[axis];
            if count > 1 {
                let more = count + 2 * count.div_ceil(4);
                frame.size[axis] *= more as f64 / count as f64;
                frame.elements[axis] = more;
            }
        }
        let frame = &larger.case.frame;
        let grown = *frame != self.case.frame && frame.elements.iter().all(|&n| n <= MOST);
        let fits = grown && larger.settle_again().is_ok();
        let wrong = |own: &super::Problem| own.severity == Severity::Error;
        (fits && !larger.warnings.iter().any(wrong)).then_some(larger)
    }
}

#[cfg(test)]
mod tests {
    use crate::case::CaseFile;

    fn resolved(frame: &str) -> crate::case::Resolved {
        let text = format!(
            "{frame}
            [body.pin]
            material = {{ young = \"210 GPa\", poisson = 0.3 }}
            profile.sphere = {{ radius = \"50 mm\" }}
            wear.archard = {{ coefficient = \"1.33e-13 1/Pa\" }}
            [body.disc]
            material = {{ young = \"210 GPa\", poisson = 0.3 }}
            profile.flat = {{}}
            [motion.sliding]
            load = \"10.2 N\"
            distance = \"50 mm\"
            step = \"5 mm\""
        );
        CaseFile::from_text("case.toml", text, "").resolve().unwrap()
    }

    #[test]
    fn elements_stay_as_large_and_even_or_odd() {
        for elements in [30, 31, 32, 33] {
            let frame = format!(
                "frame = {{ size = [\"1.2 mm\", \"1 mm\"], elements = [{elements}, {elements}] }}"
            );
            let one = resolved(&frame);
            let larger = one.on_a_larger_frame().unwrap();
            let [before, after] = [&one, &larger].map(|own| own.case.frame);
            for axis in 0..2 {
                let share = after.spacing()[axis] / before.spacing()[axis];
                assert!((share - 1.0).abs() < 1e-12, "{share}");
                assert_eq!(after.elements[axis] % 2, before.elements[axis] % 2);
                assert!((1.4..1.6).contains(&(after.size[axis] / before.size[axis])));
            }
        }
        let fine = "frame = { size = [\"1.2 mm\", \"1.2 mm\"], elements = [700, 8] }";
        assert!(resolved(fine).on_a_larger_frame().is_none());
    }
}
