//! How large the stated errors of contacts are.

use std::f64::consts::PI;

use super::contacts::{RailContact, patches};
use crate::verdict;
use archard_rail::contact::Patch;

/// The largest relative stated error of all patches: of pressures and temperatures over the largest on their wheel, areas over all of its
/// contact, forces over its load, places over the root of the patch's area, creepages over all slip in the patch, to which spin adds its
/// part at the radius of a circle as large.
pub(super) fn stated(contacts: &[RailContact]) -> Option<verdict::Line> {
    let relative = |(contact, patch): (&RailContact, &Patch)| {
        let (values, errors) = (&patch.values, &patch.errors);
        let width = values.contact_area.sqrt();
        let of_wheel = contact.patches.iter().map(|patch| patch.values);
        let peak = of_wheel.clone().map(|of| of.peak_pressure).fold(0.0, f64::max);
        let area: f64 = of_wheel.map(|of| of.contact_area).sum();
        [
            ("peak_pressure_Pa", errors.peak_pressure / peak),
            ("contact_area_m2", errors.contact_area / area),
            ("normal_force_N", errors.normal_force / contact.load),
            ("force_x_N", errors.force_x / contact.load),
            ("force_s_N", errors.force_s / contact.load),
            ("y_rail_m", errors.y_rail / width),
            ("y_wheel_m", errors.y_wheel / width),
        ]
    };
    let slipping = |(_, patch): (&RailContact, &Patch)| {
        let (values, errors) = (&patch.values, &patch.errors);
        let radius = (values.contact_area / PI).sqrt();
        let slip = values.creepage.hypot(values.lateral_creepage).hypot(radius * values.spin);
        let creepages = [
            ("creepage", errors.creepage / slip),
            ("lateral_creepage", errors.lateral_creepage / slip),
            ("spin_1_per_m", radius * errors.spin / slip),
        ];
        // A wheel that stands has no creepages.
        creepages.into_iter().filter(move |_| slip > 0.0)
    };
    let warm = patches(contacts).filter_map(|(contact, patch)| {
        let rises = contact.patches.iter().filter_map(|patch| Some(patch.warmth?.rise[0]));
        let largest = rises.fold(0.0, f64::max);
        (largest > 0.0).then_some(("temperature_rise_K", patch.warmth?.rise[1] / largest))
    });
    let all = patches(contacts).flat_map(relative).chain(patches(contacts).flat_map(slipping));
    let all = all.chain(warm);
    let worst = all.max_by(|one, other| one.1.total_cmp(&other.1));
    worst.map(|(column, error)| verdict::stated(error, column))
}
