//! Logs in words and as JSON.

use serde_json::{Value, json};

use crate::number::four;
use crate::{Group, Log, Rate, Step};

fn words(rate: &Rate) -> String {
    let [low, high] = rate.interval.map(|end| four(1e6 * end));
    format!("{} um/m, 95 % interval {low} .. {high}", four(1e6 * rate.rate))
}

/// The coefficient over worn area with its interval, of a step that has one.
fn coefficient(step: &Step) -> Option<String> {
    let (k, rate, load) = (step.k_over_area()?, step.steady?, step.load?);
    let [low, high] = rate.interval.map(|end| four(1e3 * end / load));
    Some(format!("{} mm3/(N m) per mm2, 95 % interval {low} .. {high}", four(1e3 * k)))
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
                    "lines {first} to {last}: {} readings over {} m {load}; {} without load or motion",
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
            if let Some((first, _)) = step.spikes.first() {
                let share = 1e2 * step.spikes.len() as f64 / step.readings as f64;
                lines.push(line(
                    "spikes",
                    &format!(
                        "{} readings of the transducer, {share:.2} %, are left out of the rates; the first in line {first}",
                        step.spikes.len()
                    ),
                ));
            }
            if let Some(drift) = step.drift {
                lines.push(line(
                    "drift",
                    &format!(
                        "under load before the motion, as much as {} um/m of this test: the interval holds the rate with and without it",
                        four(1e6 * drift)
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
            lines.extend(coefficient(step).map(|words| line("k / area", &words)));
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

    /// One line of the main step: load, distance, and the coefficient or why none exists.
    pub fn line(&self) -> String {
        let name = self.name();
        let Some(step) = self.main_step() else { return format!("{name}: no readings") };
        let load = step.load.map_or("unknown load".to_owned(), |load| format!("{} N", four(load)));
        let words = match coefficient(step) {
            Some(words) => format!("k / area {words}"),
            None => format!("no k / area: {}", step.refused.as_deref().unwrap_or_default()),
        };
        format!("{name}: {load}, {} m: {words}", four(step.distance))
    }

    /// All results in SI; those of the main step at the top, all under `steps`.
    pub fn json(&self) -> Value {
        let mut top = self.main_step().map_or(json!({}), of_step);
        top["log"] = self.source.clone().into();
        top["said"] = self.said.iter().map(|(name, words)| json!([name, words])).collect();
        top["steps"] = self.steps.iter().map(of_step).collect();
        top
    }
}

fn of_step(step: &Step) -> Value {
    let rate = step.steady;
    json!({
        "lines": step.lines,
        "load_N": step.load,
        "radius_m": step.radius,
        "speed_m_s": step.speed,
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
        "spikes": step.spikes.iter().map(|(line, at)| json!({"line": line, "at_m": at})).collect::<Vec<_>>(),
        "drift": step.drift,
        "refused": step.refused,
    })
}

impl Group {
    /// A line of the logs that share a name or a set-up; `names` are those of all logs.
    pub fn line(&self, names: &[String]) -> String {
        let own: Vec<&str> = self.logs.iter().map(|log| &*names[*log]).collect();
        let k: Vec<String> = self.k.iter().map(|k| four(1e3 * k)).collect();
        let radius = self.radius.filter(|[low, high]| self.named && *high > 1.01 * low);
        let radius = radius.map_or(String::new(), |[low, high]| {
            format!(", on radii from {} to {} mm", four(1e3 * low), four(1e3 * high))
        });
        let which = match self.named {
            true => format!("{} at {} N", self.name, four(self.load)),
            false => format!("{} under other names", self.name),
        };
        let verdict = match self.agree {
            true => "their intervals explain the difference",
            false => "more than their intervals explain: tests scatter, not readings",
        };
        format!(
            "{which}: {} ({}){radius}: k / area {} mm3/(N m) per mm2, median {}, standard deviation of the logarithm {:.0} %; {verdict}",
            own.len(),
            own.join(", "),
            k.join(", "),
            four(1e3 * self.median),
            1e2 * self.scatter
        )
    }

    /// The same in SI.
    pub fn json(&self, names: &[String]) -> Value {
        json!({
            "name": self.name,
            "same_name": self.named,
            "logs": self.logs.iter().map(|log| &names[*log]).collect::<Vec<_>>(),
            "load_N": self.load,
            "radius_m": self.radius,
            "k_over_area_1_per_N": self.k,
            "median_1_per_N": self.median,
            "scatter_of_logarithm": self.scatter,
            "agree": self.agree,
        })
    }
}
