//! How long, wide and deep what is worn is.

use crate::map::HeightMap;

/// The largest worn region.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Scar {
    /// Its middle (m), the centre of what is worn off, on the later map.
    pub middle: [f64; 2],
    /// The direction of its length from the x axis, anticlockwise (rad).
    pub direction: f64,
    /// Its extent along that direction and across (m), as far as it stands out of the noise.
    pub length: f64,
    /// Across.
    pub width: f64,
}

impl Scar {
    /// Of points of a map of changes (m).
    pub(super) fn of(change: &HeightMap, points: &[usize]) -> Self {
        let nx = change.elements()[0];
        let place = |at: usize| [change.place(0, at % nx), change.place(1, at / nx)];
        let worn = |at: usize| {
            let change = change.heights()[at];
            if change.is_nan() { 0.0 } else { (-change).max(0.0) }
        };
        let all: f64 = points.iter().map(|&at| worn(at)).sum();
        let middle = [0, 1]
            .map(|axis| points.iter().map(|&at| worn(at) * place(at)[axis]).sum::<f64>() / all);
        let count = points.len() as f64;
        let mean = [0, 1].map(|axis| points.iter().map(|&at| place(at)[axis]).sum::<f64>() / count);
        let moment = |one: usize, other: usize| -> f64 {
            let product =
                |&at: &usize| (place(at)[one] - mean[one]) * (place(at)[other] - mean[other]);
            points.iter().map(product).sum()
        };
        let direction = 0.5 * (2.0 * moment(0, 1)).atan2(moment(0, 0) - moment(1, 1));
        let extent = |direction: f64| {
            let (sine, cosine) = direction.sin_cos();
            let along = |&at: &usize| cosine * place(at)[0] + sine * place(at)[1];
            let ends =
                points.iter().map(along).fold([f64::INFINITY, f64::NEG_INFINITY], |ends, one| {
                    [ends[0].min(one), ends[1].max(one)]
                });
            let pixel = (cosine * change.pixel()[0]).abs() + (sine * change.pixel()[1]).abs();
            ends[1] - ends[0] + pixel
        };
        let [length, width] = [direction, direction + std::f64::consts::FRAC_PI_2].map(extent);
        Self { middle, direction, length, width }
    }
}

#[cfg(test)]
mod tests {
    use super::Scar;
    use crate::map::HeightMap;

    /// An ellipse with half axes of 12 and 5 um, turned by 30 degrees.
    #[test]
    fn an_ellipse_has_its_axes() {
        let blank = HeightMap::new([81, 81], [0.5e-6; 2], vec![0.0; 81 * 81]).unwrap();
        let turn = 30f64.to_radians();
        let change = |at: usize| {
            let (x, y) = (blank.place(0, at % 81) - 2e-6, blank.place(1, at / 81) + 3e-6);
            let (u, v) = (turn.cos() * x + turn.sin() * y, turn.cos() * y - turn.sin() * x);
            ((u / 12e-6).powi(2) + (v / 5e-6).powi(2) - 1.0).min(0.0) * 1e-7
        };
        let map = blank.of_heights((0..81 * 81).map(change).collect());
        let points: Vec<usize> = (0..81 * 81).filter(|&at| map.heights()[at] < 0.0).collect();
        let scar = Scar::of(&map, &points);
        assert!((scar.middle[0] - 2e-6).abs() < 0.1e-6 && (scar.middle[1] + 3e-6).abs() < 0.1e-6);
        assert!((scar.direction - turn).abs() < 0.02, "{scar:?}");
        assert!(
            (scar.length - 24e-6).abs() < 1e-6 && (scar.width - 10e-6).abs() < 1e-6,
            "{scar:?}"
        );
    }
}
