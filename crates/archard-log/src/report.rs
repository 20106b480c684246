//! A log in words, as JSON and as rows for `archard fit`.

use serde_json::{Value, json};

use crate::{Log, Rate, Step};

fn four(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if (1e-3..1e5).contains(&size) => {
            let digits = (3 - size.log10().floor() as i32).max(0) as usize;
            format!("{value:.digits$}")
        }
        _ => format!("{value:.3e}"),
    }
}

fn words(rate: &Rate) -> String {
    let [low, high] = rate.interval.map(|end| four(1e6 * end));
    format!("{} um/m, 95 % interval {low} .. {high}", four(1e6 * rate.rate))
}

impl Log {
    /// Lines of a name and words, in units of the field.
    pub fn lines(&self) -> Vec<String> {
        let line = |name: &str, words: &str| format!("  {name:<15} {words}");
        let mut lines = vec![self.source.clone()];
        lines.extend(self.said.iter().map(|(name, words)| line(name, words)));
        for step in &self.steps {
            let [first, last] = step.lines;
            let load = step
                .load
                .map_or("of unknown load".to_owned(), |load| format!("at {} N", four(load)));
            lines.push(line(
                "step",
                &format!(
                    "lines {first} to {last}: {} readings over {} m {load}; {} before load and motion or after",
                    step.readings, four(step.distance), step.idle
                ),
            ));
            for (at, height) in &step.jumps {
                lines.push(line(
                    "jump",
                    &format!(
                        "of {} um at {} m, taken as one of the transducer",
                        four(1e6 * height),
                        four(*at)
                    ),
                ));
            }
            if let Some(rate) = &step.steady {
                let [from, to] = rate.part.map(four);
                lines.push(line(
                    "steady part",
                    &format!("{from} .. {to} m, the depth wanders over {} m", four(rate.wander)),
                ));
                lines.push(line("depth rate", &words(rate)));
            }
            if let Some(rate) = &step.second_half {
                lines.push(line("second half", &words(rate)));
            }
            if let (Some(k), Some(rate), Some(load)) = (step.k_over_area(), step.steady, step.load)
            {
                let [low, high] = rate.interval.map(|end| four(1e3 * end / load));
                lines.push(line(
                    "k / area",
                    &format!("{} mm3/(N m) per mm2, 95 % interval {low} .. {high}", four(1e3 * k)),
                ));
            }
            if let Some((mean, [low, high])) = &step.friction {
                lines.push(line(
                    "friction",
                    &format!("{} ({} .. {})", four(*mean), four(*low), four(*high)),
                ));
            }
            if let Some(why) = &step.refused {
                lines.push(line("no k / area", why));
            }
        }
        lines
    }

    /// All results in SI; those of the main step at the top, all under `steps`.
    pub fn json(&self) -> Value {
        let mut top = self.main_step().map_or(json!({}), of_step);
        top["log"] = self.source.clone().into();
        top["said"] = self.said.iter().map(|(name, words)| json!([name, words])).collect();
        top["steps"] = self.steps.iter().map(of_step).collect();
        top
    }

    /// Rows that `archard fit` reads: one a step, the wear over its steady part, without the heading [`ROWS`].
    pub fn rows(&self) -> Vec<String> {
        let name = self.source.rsplit(['/', '\\']).next().unwrap_or_default();
        let name = name.split_once('.').map_or(name, |(stem, _)| stem).replace([',', '"'], "_");
        let told = self.steps.iter().filter(|step| step.k_over_area().is_some());
        told.enumerate()
            .filter_map(|(index, step)| {
                let (rate, load) = (step.steady?, step.load?);
                let far = rate.part[1] - rate.part[0];
                let name = if index == 0 { name.clone() } else { format!("{name}_{}", index + 1) };
                // The 95 % interval of a normal distribution is 3.92 standard deviations wide.
                let error = (rate.interval[1] - rate.interval[0]) * far / 3.92;
                Some(format!(
                    "{name},{far:.6e},{:.6e},{:.6e},{load:.6e}",
                    1e6 * rate.rate * far,
                    1e6 * error
                ))
            })
            .collect()
    }
}

/// The heading of the rows.
pub const ROWS: &str = "test,distance [m],depth [um],u_depth [um],load [N]";

fn of_step(step: &Step) -> Value {
    let rate = step.steady;
    json!({
        "lines": step.lines,
        "load_N": step.load,
        "distance_m": step.distance,
        "readings": step.readings,
        "idle_readings": step.idle,
        "depth_rate": rate.map(|rate| rate.rate),
        "depth_rate_interval": rate.map(|rate| rate.interval),
        "from_m": rate.map(|rate| rate.part[0]),
        "to_m": rate.map(|rate| rate.part[1]),
        "second_half": step.second_half.map(|rate| json!({"depth_rate": rate.rate, "depth_rate_interval": rate.interval})),
        "k_over_area_1_per_N": step.k_over_area(),
        "friction": step.friction.map(|friction| friction.0),
        "friction_interval": step.friction.map(|friction| friction.1),
        "jumps": step.jumps.iter().map(|(at, height)| json!({"at_m": at, "height_m": height})).collect::<Vec<_>>(),
        "refused": step.refused,
    })
}
