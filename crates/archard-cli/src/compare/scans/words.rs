//! What is worn between two scans, in words.

use archard_case::verdict::{self, Verdict, Warning};
use archard_surface::difference::Uncertain;

use super::Compared;
use crate::number::{four, length};

impl Compared<'_> {
    /// A short table.
    pub(super) fn lines(&self) -> Vec<String> {
        let line = |name: &str, value: String| format!("{name:<18}{value}");
        let found = &self.found;
        let (placed, by) = (&found.placement, &found.uncertainty);
        let both = |own: [f64; 2], by: [f64; 2], factor: f64, unit: &str| {
            let [x, y] = [0, 1].map(|axis| with(own[axis] * factor, by[axis] * factor, unit));
            format!("{x} along x, {y} along y")
        };
        let mut lines = vec![];
        if found.sought {
            lines.push(line("shift", both(placed.shift, by.shift, 1e6, "um")));
            lines.push(line("turn", with(1e3 * placed.turn, 1e3 * by.turn, "mrad")));
        }
        if let Some(along) = found.undetermined {
            let degrees = along.to_degrees().round() + 0.0;
            let open = format!(
                "not determined along {degrees:.0} degrees from x, where the texture is the same"
            );
            lines.push(line("shift along lay", open));
        }
        lines.push(line("tilt", both(placed.tilt, by.tilt, 1e3, "mrad")));
        lines.push(line("overlap", format!("{:.0} % of the later scan", 100.0 * found.overlap)));
        let scatter = format!("{}, alike over {}", length(found.scatter), length(found.alike));
        lines.push(line("unworn surface", format!("scatter {scatter}")));
        lines.push(line("worn volume", self.volume(&found.worn)));
        match &found.piled {
            Some(piled) => lines.push(line("piled up", self.volume(piled))),
            None => lines.push(line("piled up", "nothing stands out".to_owned())),
        }
        lines.push(line("net volume", self.volume(&found.net)));
        let depth = &found.depth;
        lines.push(line("greatest depth", with(1e6 * depth.value, 1e6 * depth.standard, "um")));
        let scar = &found.scar;
        let [long, wide] = [scar.length, scar.width].map(|size| four(1e3 * size));
        // The zero turns -0 into 0.
        let turned = scar.direction.to_degrees().round() + 0.0;
        let turned = format!("turned by {turned:.0} degrees from x");
        lines.push(line("scar", format!("{long} x {wide} mm, {turned}")));
        lines.push(line("worn area", format!("{} mm2", four(1e6 * found.area))));
        let verdict = self.verdict();
        lines.push(line("verdict", verdict.in_words()));
        lines.extend(verdict.complaints().map(|one| format!("  {}", one.in_words())));
        lines
    }

    /// A volume with its standard uncertainty and its interval.
    fn volume(&self, own: &Uncertain) -> String {
        let [value, by, half] = [own.value, own.standard, own.expanded].map(|own| 1e9 * own);
        let [low, high] = [four(value - half), four(value + half)];
        format!("{}, 95 %: {low} to {high} mm3", with(value, by, "mm3"))
    }

    /// Whether the result can be believed: what has to be known of it, and the errors of its values, those of volumes relative to the
    /// worn one.
    pub(super) fn verdict(&self) -> Verdict {
        let found = &self.found;
        let of = |own: &Uncertain, whole: &Uncertain, what| {
            verdict::measured(own.expanded / whole.value.abs(), what)
        };
        let errors = [
            Some(of(&found.worn, &found.worn, "worn volume")),
            found.piled.as_ref().map(|piled| of(piled, &found.worn, "volume that is piled up")),
            Some(of(&found.net, &found.worn, "net volume")),
            Some(of(&found.depth, &found.depth, "depth")),
        ];
        let errors = errors.into_iter().flatten();
        let worst = errors.max_by(|one, other| one.value.total_cmp(&other.value));
        let remarks = self.remarks().into_iter().map(Warning::from).collect::<Vec<_>>();
        Verdict::from_iter(worst).warned_of(&remarks)
    }

    /// What has to be known of the result.
    pub(super) fn remarks(&self) -> Vec<String> {
        let found = &self.found;
        let mut remarks = vec![];
        if !found.sought && !self.scans.placed {
            remarks.push("the surface has no features to find a shift by: the scans lie as they were measured, and only the level was found".to_owned());
        }
        if found.placement.form != [0.0; 3] {
            remarks.push(
                "the scans differ in form, and a parabola between them was fitted to what did not wear: a scar as wide as the map would look so, too"
                    .to_owned(),
            );
        }
        if found.at_least {
            remarks.push(
                "the deepest part was not measured: at least this volume is worn, at least as deep"
                    .to_owned(),
            );
        }
        if found.reaches_rim {
            remarks.push(
                "a worn region reaches the end of what both scans show: more may be worn beyond it"
                    .to_owned(),
            );
        }
        if found.missing > 0 {
            remarks.push(format!(
                "points without a height in worn regions: {}; their change was taken from those around them",
                found.missing
            ));
        }
        if found.count[0] > 1 {
            remarks.push(format!("worn regions: {}; their volumes are added", found.count[0]));
        }
        remarks
    }
}

/// A value with its standard uncertainty, which has two digits: "1.234 ± 0.012 um", "(1.23 ± 0.45)e-5 mm3".
fn with(value: f64, by: f64, unit: &str) -> String {
    let size = value.abs().max(by);
    let power = if size > 0.0 { size.log10().floor() as i32 } else { 0 };
    let power = if (-3..6).contains(&power) { 0 } else { power };
    let scale = 10f64.powi(-power);
    let (value, by) = (value * scale, by * scale);
    let decimals = if by > 0.0 { (1.0 - by.log10().floor()).clamp(0.0, 12.0) as usize } else { 3 };
    let both = format!("{value:.decimals$} \u{b1} {by:.decimals$}");
    if power == 0 { format!("{both} {unit}") } else { format!("({both})e{power} {unit}") }
}

#[cfg(test)]
mod tests {
    use super::with;

    #[test]
    fn uncertainties_have_two_digits() {
        assert_eq!(with(1.23456, 0.0123, "um"), "1.235 \u{b1} 0.012 um");
        assert_eq!(with(1.5e-5, 2.5e-7, "mm3"), "(1.500 \u{b1} 0.025)e-5 mm3");
        assert_eq!(with(123.4, 25.0, "um"), "123 \u{b1} 25 um");
        assert_eq!(with(0.0, 0.0, "um"), "0.000 \u{b1} 0.000 um");
    }
}
