//! Walls that lie between points.

use crate::map::HeightMap;

/// Standard deviations of a point beyond which a jump is no noise: those of the first fit.
const CLEAR: f64 = 4.0;

/// The variance (m^6) of a volume over a region by walls. Between two points a wall of height D lies anywhere: an even distribution, of variance
/// D^2/12 in pixels. Walls in line with the points have one place, and their jumps in a row or column are added; those of a curved wall
/// lie in several. Changes (m) are known everywhere; points scatter by so much (m).
pub(super) fn variance(map: &HeightMap, region: &[bool], scatter: f64) -> f64 {
    let [nx, ny] = map.elements();
    let cell = map.pixel()[0] * map.pixel()[1];
    let mut squares = 0.0;
    for (along, across) in [([1, nx], [nx, ny]), ([nx, 1], [ny, nx])]
        .map(|([step, line], [length, lines])| ((step, length), (line, lines)))
    {
        let ((step, length), (line, lines)) = (along, across);
        let jump = |at: usize| map.heights()[at + step] - map.heights()[at];
        for place in 0..length - 1 {
            let excess = |index: usize| {
                let at = place * step + index * line;
                if !region[at] && !region[at + step] {
                    return 0.0;
                }
                let own = jump(at);
                let before = if place > 0 { jump(at - step).abs() } else { 0.0 };
                let after = if place + 2 < length { jump(at + step).abs() } else { 0.0 };
                let more = own.abs() - before.max(after) - CLEAR * scatter;
                if more > 0.0 { own.signum() * more } else { 0.0 }
            };
            let sum: f64 = (0..lines).map(excess).sum();
            squares += sum * sum / 12.0;
        }
    }
    squares * cell * cell
}

#[cfg(test)]
mod tests {
    use super::variance;
    use crate::map::HeightMap;

    /// A pit with walls in line has an uncertain length of both walls: D L/sqrt 12 for each. A slope of the same depth has no walls.
    #[test]
    fn walls_in_line_have_one_place() {
        let made = |depth: fn(f64, f64) -> f64| {
            let own = |at: usize| depth((at % 40) as f64, (at / 40) as f64);
            HeightMap::new([40, 30], [2.0, 3.0], (0..1200).map(own).collect()).unwrap()
        };
        let pit =
            made(
                |x, y| {
                    if (10.0..30.0).contains(&x) && (8.0..20.0).contains(&y) { -5.0 } else { 0.0 }
                },
            );
        let expected = 36.0 * 25.0 * (2.0 * 144.0 + 2.0 * 400.0) / 12.0;
        let found = variance(&pit, &[true; 1200], 0.0);
        assert!((found / expected - 1.0).abs() < 1e-12, "{found} {expected}");
        assert_eq!(variance(&made(|x, _| -0.5 * x), &[true; 1200], 0.0), 0.0);
    }
}
