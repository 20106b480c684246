//! The steps of a run that histories derived from it keep.
//!
//! A run that gives many rows ends a step where each of them ends. Histories of all these steps would take the square of the
//! number of rows on disk. A row keeps the steps at its outputs, its end, and those that the course of the wear depth takes:
//! straight lines between the steps that are kept tell the depth in between to a share that no picture shows.

use crate::plot::LINE;

/// Progress and wear depth of the steps of a run, and which of them its course takes.
#[derive(Debug, Default)]
pub struct Course {
    /// The progress at the end of each step, rising.
    progress: Vec<f64>,
    depth: Vec<f64>,
    /// The steps that are kept.
    bends: Vec<usize>,
    /// The slopes from the last of these that pass all steps since closely enough.
    slopes: [f64; 2],
}

impl Course {
    /// Goes on to the end of a step.
    pub fn push(&mut self, progress: f64, depth: f64) {
        let step = self.progress.len();
        self.progress.push(progress);
        self.depth.push(depth);
        if step == 0 {
            return self.bend_at(0);
        }
        let [low, high] = self.slopes;
        let [slope, least, most] = self.slopes_to(step);
        if slope < low || slope > high {
            self.bend_at(step - 1);
            let [_, least, most] = self.slopes_to(step);
            self.slopes = [least, most];
        } else {
            self.slopes = [low.max(least), high.min(most)];
        }
    }

    fn bend_at(&mut self, step: usize) {
        self.bends.push(step);
        self.slopes = [f64::NEG_INFINITY, f64::INFINITY];
    }

    /// The slope from the last bend to a step, and those that pass as far below and above it as lines may be off.
    fn slopes_to(&self, step: usize) -> [f64; 3] {
        let from = self.bends.last().copied().unwrap_or_default();
        let along = self.progress[step] - self.progress[from];
        let depth = self.depth[step];
        [0.0, -LINE, LINE].map(|off| (depth * (1.0 + off) - self.depth[from]) / along)
    }

    /// The steps that a row keeps which ends with a step and has outputs where the run first reaches these places.
    pub fn kept(&self, last: usize, outputs: impl Iterator<Item = f64>) -> Vec<usize> {
        let reached = |place: f64| self.progress.partition_point(|known| *known < place);
        let mut kept: Vec<usize> = self.bends.iter().copied().chain(outputs.map(reached)).collect();
        kept.retain(|step| *step < last);
        kept.push(last);
        kept.sort_unstable();
        kept.dedup();
        kept
    }
}

#[cfg(test)]
mod tests {
    use super::{Course, LINE};

    /// A course like that of a ball on a flat, depth = sqrt s, in more and more steps.
    fn course(steps: usize) -> Course {
        let mut course = Course::default();
        for step in 0..=steps {
            let place = step as f64 / steps as f64;
            course.push(place, place.sqrt());
        }
        course
    }

    #[test]
    fn what_is_kept_does_not_grow_with_the_steps() {
        let kept = |steps| course(steps).kept(steps, [0.25, 0.5].into_iter()).len();
        let [few, many] = [1000, 100_000].map(kept);
        // More small steps at the start only, where the course goes over more decades.
        assert!(few > 10 && many < 3 * few, "{few} and {many}");
    }

    #[test]
    fn lines_between_kept_steps_tell_the_depth() {
        let course = course(1000);
        let kept = course.kept(800, [0.25].into_iter());
        assert!(kept.contains(&250) && kept.contains(&800) && kept[0] == 0, "{kept:?}");
        for ends in kept.windows(2) {
            let [from, to] = [ends[0], ends[1]];
            for step in from..to {
                let share = (step - from) as f64 / (to - from) as f64;
                let line = course.depth[from] + share * (course.depth[to] - course.depth[from]);
                let depth = course.depth[step];
                assert!((line - depth).abs() <= 1.001 * LINE * depth.max(1e-300), "{step}");
            }
        }
    }
}
