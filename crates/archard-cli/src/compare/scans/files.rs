//! What is worn between two scans, in files.

use std::path::Path;

use archard_case::files::Inputs;
use archard_case::output::{Error, Field, Image, Manifest, verdict_json};
use archard_surface::difference::{Placement, Uncertain};
use serde_json::{Value, json};

use super::Compared;
use crate::report::SCANS;

impl Compared<'_> {
    /// Writes `difference.json`, `section.csv`, `tests.csv` and `difference.vti`, none of them in the place of a file of others.
    pub(super) fn write(&self, dir: &Path) -> Result<(), Error> {
        let inputs = [&self.scans.before, &self.scans.after].into_iter().flatten().cloned();
        let mut manifest = Manifest::read(dir)?.sparing(Inputs::of(inputs));
        let names = [SCANS, "section.csv", "tests.csv", "difference.vti"];
        names.iter().try_for_each(|name| manifest.admit(name).map(|_| ()))?;
        let [json, section, tests, image] = names.map(|name| manifest.claim(name));
        json?.write(format!("{:#}\n", self.json()).as_bytes())?;
        section?.write(self.section_csv().as_bytes())?;
        tests?.write(self.tests_csv().as_bytes())?;
        self.image().write(&image?)
    }

    /// All numbers, in SI.
    pub(super) fn json(&self) -> Value {
        let found = &self.found;
        let scar = &found.scar;
        json!({
            "version": env!("CARGO_PKG_VERSION"),
            "before": self.names[0],
            "after": self.names[1],
            "settings": self.scans.set,
            "settings_before": self.scans.set_before,
            "settings_after": self.scans.set_after,
            "aligned": found.sought,
            "placement": placement(&found.placement),
            "placement_standard_uncertainty": placement(&found.uncertainty),
            "shift_undetermined_along_rad": found.undetermined,
            "overlap": found.overlap,
            "scatter_m": found.scatter,
            "alike_m": found.alike,
            "worn_volume_m3": uncertain(&found.worn),
            "piled_volume_m3": found.piled.as_ref().map(uncertain),
            "net_volume_m3": uncertain(&found.net),
            "depth_m": uncertain(&found.depth),
            "deepest_m": found.deepest,
            "worn_area_m2": found.area,
            "scar": {
                "middle_m": scar.middle, "direction_rad": scar.direction, "length_m": scar.length, "width_m": scar.width,
            },
            "regions": { "worn": found.count[0], "piled_up": found.count[1] },
            "missing": found.missing,
            "at_least": found.at_least,
            "remarks": self.remarks(),
            "verdict": verdict_json(&self.verdict()),
        })
    }

    /// The section across the scar.
    fn section_csv(&self) -> String {
        let row = |point: &archard_surface::difference::SectionPoint| {
            format!("{:.6e},{:.6e},{:.6e}\n", point.place, point.before, point.after)
        };
        let rows: String = self.section.iter().map(row).collect();
        format!("place_m,before_m,after_m\n{rows}")
    }

    /// A row of the data of `archard fit`: progress and volume with its standard uncertainty.
    fn tests_csv(&self) -> String {
        // What is no progress was refused before.
        let (column, value) = self.scans.progress().unwrap_or_default();
        let test = self.scans.test.as_deref().unwrap_or("A").replace(['"', ',', '\n'], " ");
        let worn = &self.found.worn;
        let [volume, by] = [worn.value, worn.standard].map(|own| 1e9 * own);
        format!("test,{column},volume_mm3,u_volume_mm3\n{test},{value},{volume:.6e},{by:.3e}\n")
    }

    /// Changes, depths of worn regions and the regions, on the points of the later scan.
    pub(super) fn image(&self) -> Image {
        let change = &self.found.change;
        let origin = change.size().map(|size| -0.5 * size);
        let regions = self.found.regions.iter().map(|own| f64::from(*own)).collect();
        let fields = vec![
            field("change_m", change.heights().to_vec()),
            field("depth_m", self.depths()),
            field("region", regions),
        ];
        Image { origin, spacing: change.pixel(), elements: change.elements(), fields }
    }

    /// Depths (m) in worn regions, zero elsewhere.
    pub(super) fn depths(&self) -> Vec<f64> {
        let depth = |(change, region): (&f64, &i8)| {
            if *region < 0 && change.is_finite() { (-change).max(0.0) } else { 0.0 }
        };
        self.found.change.heights().iter().zip(&self.found.regions).map(depth).collect()
    }
}

fn field(name: &str, values: Vec<f64>) -> Field {
    Field { name: name.to_owned(), values }
}

fn placement(own: &Placement) -> Value {
    json!({
        "shift_m": own.shift, "turn_rad": own.turn, "offset_m": own.offset, "tilt": own.tilt, "form_per_m": own.form,
    })
}

fn uncertain(own: &Uncertain) -> Value {
    json!({
        "value": own.value,
        "standard_uncertainty": own.standard,
        "interval_95": [own.value - own.expanded, own.value + own.expanded],
        "by_noise": own.noise,
        "by_level": own.level,
        "by_shift_and_turn": own.place,
        "by_edge": own.edge,
        "by_missing_points": own.missing,
    })
}
