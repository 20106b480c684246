//! The height of the wheel at which its contacts bear the load.

use super::ContactError;

/// How far what is borne may be from the load, relative to it: tractions are found to 1e-6 of their limits, and friction bears a
/// part of the load in an inclined plane, so that what is borne is known to little more.
const MET: f64 = 1e-5;
/// Heights that are tried. Every fourth halves the bracket, which leaves no digit of it.
const MOST: usize = 240;

/// Finds it below the onset (m), first at a guess (m), for contacts that bear what `bears` says (N).
///
/// The force of a contact of Hertz grows with the overlap to the power 3/2, so that its power 2/3 is a line: secants are
/// taken of that, within a bracket. Heights at which a contact comes to the end of a profile are too low. Where stretches of
/// overlap become one patch what is borne jumps; if it jumps over the load, the state nearer to it is given.
pub(super) fn find<T>(
    load: f64,
    onset: f64,
    guess: f64,
    mut bears: impl FnMut(f64) -> Result<(T, f64), ContactError>,
) -> Result<(f64, T), ContactError> {
    let (mut low, mut high) = (onset, f64::INFINITY);
    let (mut last, mut height) = ([onset, -1.0], guess);
    let (mut borne, mut end) = (0.0, None);
    let mut nearest: Option<(f64, f64, T)> = None;
    for at in 0..MOST {
        let mut secant = f64::NAN;
        match bears(height) {
            Ok((state, found)) if (found / load - 1.0).abs() <= MET => return Ok((height, state)),
            Ok((state, found)) => {
                let short = (found / load - 1.0).abs();
                if nearest.as_ref().is_none_or(|(least, ..)| short < *least) {
                    nearest = Some((short, height, state));
                }
                let off = (found / load).max(0.0).cbrt().powi(2) - 1.0;
                secant = height - off * (height - last[0]) / (off - last[1]);
                last = [height, off];
                if off < 0.0 {
                    low = height;
                } else {
                    (high, end) = (height, None);
                }
                borne = found;
            }
            Err(short @ ContactError::Short { .. }) => (high, end) = (height, Some(short)),
            Err(error) => return Err(error),
        }
        // Twice as deep as before at most, so that no step leaves the profiles by accident.
        let deepest = high.min(onset + 2.0 * (height - onset));
        height = match secant {
            secant if secant > low && secant < deepest && at % 4 < 3 => secant,
            _ if high.is_finite() => 0.5 * (low + high),
            _ => deepest,
        };
        if height <= low || height >= high {
            break;
        }
    }
    match nearest {
        Some((_, height, state)) if end.is_none() && high.is_finite() => Ok((height, state)),
        _ => Err(end.unwrap_or(ContactError::Unbearable { load, found: borne })),
    }
}

#[cfg(test)]
mod tests {
    use super::{ContactError, find};

    fn heights(
        bears: impl Fn(f64) -> Result<f64, ContactError>,
    ) -> (Result<f64, ContactError>, usize) {
        let mut count = 0;
        let found = find(8.0, 1.0, 1.1, |height| {
            count += 1;
            bears(height).map(|borne| ((), borne))
        });
        (found.map(|(height, ())| height), count)
    }

    /// 8 = (5 - 1)^1.5, which two secants find; the same where profiles end below it, and just above it.
    #[test]
    fn a_contact_of_hertz_is_found_at_once() {
        let hertz = |height: f64| (height - 1.0).powf(1.5);
        let (found, count) = heights(|height| Ok(hertz(height)));
        assert!((found.unwrap() - 5.0).abs() < 1e-5 && count < 10, "{count}");
        let short = |end: f64| {
            move |height| {
                if height > end { Err(ContactError::Short { y: 0.0 }) } else { Ok(hertz(height)) }
            }
        };
        assert!((heights(short(5.01)).0.unwrap() - 5.0).abs() < 1e-5);
        assert!(matches!(heights(short(4.99)).0, Err(ContactError::Short { .. })));
    }

    /// The load lies in a jump from 7.04 to 9.5: the lower end is nearer.
    #[test]
    fn a_jump_over_the_load_gives_the_nearer_end() {
        let (found, _) = heights(|height| Ok(if height < 4.0 { 7.0 + 0.01 * height } else { 9.5 }));
        let height = found.unwrap();
        assert!(height < 4.0 && height > 4.0 - 1e-9, "{height}");
    }

    #[test]
    fn a_wedge_bears_nothing() {
        let (found, _) = heights(|height| Ok(-height));
        assert!(matches!(found, Err(ContactError::Unbearable { .. })));
        let (found, _) = heights(|height| Ok(7.0 * (height - 1.0).min(1.0)));
        assert!(matches!(found, Err(ContactError::Unbearable { .. })));
    }
}
