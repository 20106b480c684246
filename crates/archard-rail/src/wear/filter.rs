//! A low pass for what is worn off a profile, which keeps the volume and takes nothing below zero.
//!
//! Depths diffuse for two implicit steps along the profile, so that a wave of number k keeps 1/(1 + (l k)^2)^2 of its
//! height; l is such that this is a half at the wavelength asked for. The matrix of a step has no positive element besides its
//! diagonal and sums of rows that are the weights: depths stay positive and the sum of volumes is kept.

/// The low pass over the points of a profile.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Filter {
    /// What a unit of depth at each point holds (m^2, of a rail m).
    weights: Vec<f64>,
    /// How much diffuses between neighbours for a unit of difference, times l^2.
    links: Vec<f64>,
}

impl Filter {
    /// Of a wavelength (m), 0 or more; 0 smooths nothing. `links` are girth over distance of neighbours.
    pub fn new(wavelength: f64, weights: Vec<f64>, links: Vec<f64>) -> Self {
        let half = (2f64.sqrt() - 1.0) * (wavelength / std::f64::consts::TAU).powi(2);
        Self { weights, links: links.into_iter().map(|link| half * link).collect() }
    }

    /// The volumes after both steps.
    pub fn smooth(&self, volumes: Vec<f64>) -> Vec<f64> {
        if self.links.iter().all(|&link| link == 0.0) {
            return volumes;
        }
        self.step(self.step(volumes))
    }

    /// One step: (W + K) d = v and back to the volumes W d, by elimination along the profile.
    fn step(&self, volumes: Vec<f64>) -> Vec<f64> {
        let count = volumes.len();
        let link = |at: usize| self.links.get(at).copied().unwrap_or(0.0);
        let mut depths = volumes;
        let mut ahead = vec![0.0; count];
        let mut before = 0.0;
        for at in 0..count {
            let behind = if at > 0 { link(at - 1) } else { 0.0 };
            let pivot = self.weights[at] + behind + link(at) - behind * before;
            let left = if at > 0 { depths[at - 1] } else { 0.0 };
            depths[at] = (depths[at] + behind * left) / pivot;
            before = link(at) / pivot;
            ahead[at] = before;
        }
        for at in (0..count.saturating_sub(1)).rev() {
            depths[at] += ahead[at] * depths[at + 1];
        }
        depths.iter().zip(&self.weights).map(|(depth, weight)| depth * weight).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::Filter;
    use std::f64::consts::TAU;

    /// A wave of the wavelength keeps half, sums are kept, and nothing becomes negative.
    #[test]
    fn a_wave_keeps_half_and_the_whole_is_kept() {
        let (step, length) = (1e-4, 4e-3);
        let filter = Filter::new(length, vec![step; 801], vec![1.0 / step; 800]);
        let wave = |at: usize| 1.0 + (TAU * at as f64 * step / length).cos();
        let smoothed = filter.smooth((0..801).map(|at| step * wave(at)).collect());
        let height = 0.5 * (smoothed[400] - smoothed[380]) / step;
        assert!((height - 0.5).abs() < 1e-3, "{height}");
        let mut spike = vec![0.0; 801];
        spike[3] = 1.0;
        let smoothed = filter.smooth(spike);
        assert!((smoothed.iter().sum::<f64>() - 1.0).abs() < 1e-13);
        assert!(smoothed.iter().all(|&one| one > 0.0));
    }
}
