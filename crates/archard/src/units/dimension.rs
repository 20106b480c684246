//! What a unit measures.

use std::fmt;

/// Powers of length, mass, time, angle and temperature.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Dimension([f64; 5]);

impl Dimension {
    /// A pure number.
    pub const NUMBER: Self = Self([0.0; 5]);
    /// Length (m).
    pub const LENGTH: Self = Self([1.0, 0.0, 0.0, 0.0, 0.0]);
    /// Area (m^2).
    pub const AREA: Self = Self([2.0, 0.0, 0.0, 0.0, 0.0]);
    /// Volume (m^3).
    pub const VOLUME: Self = Self([3.0, 0.0, 0.0, 0.0, 0.0]);
    /// Mass (kg).
    pub const MASS: Self = Self([0.0, 1.0, 0.0, 0.0, 0.0]);
    /// Time (s).
    pub const TIME: Self = Self([0.0, 0.0, 1.0, 0.0, 0.0]);
    /// Plane angle (rad).
    pub const ANGLE: Self = Self([0.0, 0.0, 0.0, 1.0, 0.0]);
    /// Temperature (K).
    pub const TEMPERATURE: Self = Self([0.0, 0.0, 0.0, 0.0, 1.0]);
    /// Force (N).
    pub const FORCE: Self = Self([1.0, 1.0, -2.0, 0.0, 0.0]);
    /// Load per length (N/m).
    pub const LOAD_PER_LENGTH: Self = Self([0.0, 1.0, -2.0, 0.0, 0.0]);
    /// Pressure (Pa).
    pub const PRESSURE: Self = Self([-1.0, 1.0, -2.0, 0.0, 0.0]);
    /// Energy (J).
    pub const ENERGY: Self = Self([2.0, 1.0, -2.0, 0.0, 0.0]);
    /// Power (W).
    pub const POWER: Self = Self([2.0, 1.0, -3.0, 0.0, 0.0]);
    /// Frequency (Hz).
    pub const FREQUENCY: Self = Self([0.0, 0.0, -1.0, 0.0, 0.0]);
    /// Speed (m/s).
    pub const SPEED: Self = Self([1.0, 0.0, -1.0, 0.0, 0.0]);
    /// Wear coefficient (1/Pa).
    pub const WEAR_COEFFICIENT: Self = Self([1.0, -1.0, 2.0, 0.0, 0.0]);

    /// Names of dimensions people meet, with their articles.
    const NAMES: &[(Self, &str)] = &[
        (Self::NUMBER, "a pure number"),
        (Self::LENGTH, "a length"),
        (Self::AREA, "an area"),
        (Self::VOLUME, "a volume"),
        (Self([-3.0, 1.0, 0.0, 0.0, 0.0]), "a density"),
        (Self([-1.0, 0.0, 0.0, 0.0, 0.0]), "a curvature (1/length)"),
        (Self::MASS, "a mass"),
        (Self::TIME, "a time"),
        (Self::ANGLE, "an angle"),
        (Self::FORCE, "a force"),
        (Self::LOAD_PER_LENGTH, "a load per length"),
        (Self::PRESSURE, "a pressure"),
        (Self::ENERGY, "an energy or a moment"),
        (Self::POWER, "a power"),
        (Self::FREQUENCY, "a frequency"),
        (Self::WEAR_COEFFICIENT, "a wear coefficient (1/pressure)"),
        (Self::SPEED, "a speed"),
        (Self([0.0, 0.0, -1.0, 1.0, 0.0]), "a rotational speed"),
        (Self([0.0, 1.0, -2.0, 0.0, 0.0]), "a force per length"),
        (Self::TEMPERATURE, "a temperature"),
        (Self([1.0, 1.0, -3.0, 0.0, -1.0]), "a thermal conductivity"),
        (Self([2.0, 0.0, -1.0, 0.0, 0.0]), "a thermal diffusivity"),
    ];

    /// The dimension of a product.
    pub fn times(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| self.0[i] + other.0[i]))
    }

    /// The dimension of a power.
    pub fn to_the(self, power: f64) -> Self {
        Self(self.0.map(|exponent| exponent * power))
    }

    /// Whether both are the same but for rounding in broken powers.
    pub fn agrees_with(self, other: Self) -> bool {
        self.0.iter().zip(other.0).all(|(a, b)| (a - b).abs() < 1e-9)
    }
}

impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some((_, name)) = Self::NAMES.iter().find(|(known, _)| self.agrees_with(*known)) {
            return f.write_str(name);
        }
        f.write_str("something in")?;
        for (symbol, exponent) in ["m", "kg", "s", "rad", "K"].iter().zip(self.0) {
            match exponent {
                0.0 => {}
                1.0 => write!(f, " {symbol}")?,
                _ => write!(f, " {symbol}^{exponent}")?,
            }
        }
        Ok(())
    }
}
