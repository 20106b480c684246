//! What is told of a patch: one table for names, units and values.

/// Declares the quantities: each with its meaning, its name and its name with the unit.
macro_rules! quantities {
    ($($(#[$meaning:meta])* $name:ident as $column:literal,)*) => {
        /// What is known of a patch, in SI units, or the errors of that.
        #[derive(Debug, Clone, Copy, PartialEq)]
        pub struct Quantities {
            $($(#[$meaning])* pub $name: f64,)*
        }

        impl Quantities {
            /// The names of the quantities, each with its unit.
            pub const COLUMNS: &[&str] = &[$($column),*];

            /// The values in the order of [`Self::COLUMNS`].
            pub fn values(&self) -> Vec<f64> {
                vec![$(self.$name),*]
            }

            /// Each value combined with that of another patch.
            pub(super) fn with(&self, other: &Self, combine: impl Fn(f64, f64) -> f64) -> Self {
                Self { $($name: combine(self.$name, other.$name)),* }
            }
        }
    };
}

quantities! {
    /// Height (m) of the wheelset at which the wheel begins to touch, downwards.
    onset as "onset_m",
    /// Height (m) of the wheelset under its load, downwards.
    z_wheel as "z_wheel_m",
    /// y (m) of the reference point in the track, to the field side.
    y_track as "y_track_m",
    /// y (m) of the reference point in the coordinates of the rail's profile.
    y_rail as "y_rail_m",
    /// y (m) of the reference point in the coordinates of the wheel's profile.
    y_wheel as "y_wheel_m",
    /// Contact angle (rad), about x; negative towards the flange.
    contact_angle as "contact_angle_rad",
    /// Longitudinal creepage (-), positive where the wheel is driven.
    creepage as "creepage",
    /// Lateral creepage (-), along s.
    lateral_creepage as "lateral_creepage",
    /// Spin (1/m), about n.
    spin as "spin_1_per_m",
    /// Normal force (N).
    normal_force as "normal_force_N",
    /// Tangential force (N) on the rail along x.
    force_x as "force_x_N",
    /// Tangential force (N) on the rail along s, to the field side in the tangent plane.
    force_s as "force_s_N",
    /// Moment (N m) on the rail about n through the reference point.
    moment as "moment_Nm",
    /// Largest overlap (m) along n.
    approach as "approach_m",
    /// Largest pressure (Pa).
    peak_pressure as "peak_pressure_Pa",
    /// Area (m^2) in contact.
    contact_area as "contact_area_m2",
    /// Power (W) that friction dissipates.
    frictional_power as "frictional_power_W",
    /// Work (N) of friction on each metre of rolling by its forces, without that of the spin: T gamma.
    t_gamma as "t_gamma_N",
    /// Friction used, tangential over normal force, less the yield stress in shear over the largest pressure: above 0 the surface flows
    /// at every passage (A. Ekberg, E. Kabo and H. Andersson, 2002). Not a number of a patch that bears nothing.
    surface_fatigue as "surface_fatigue_index",
}
