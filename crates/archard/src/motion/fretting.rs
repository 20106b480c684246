//! Small tangential oscillations under load (the paper's section 6.1; Cattaneo and Mindlin).

use super::shift::{CYCLE_COUNT, Guide, JUMP, JUMP_TOLERANCE, Shift, Station, wave};
use super::{
    APPROACH, Control, INCREMENTS, LOAD, Motion, Planned, Progress, Schedule, control, jumps,
};
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity, Values};

pub(super) const CHOICE: Choice<Planned> = Choice {
    name: "fretting",
    meaning: "tangential oscillation of given displacement or force under constant or varying load",
    parameters: &[
        LOAD,
        APPROACH,
        AMPLITUDE,
        FORCE_AMPLITUDE,
        Parameter::optional(
            "phase",
            Quantity::Angle,
            "by how much the oscillation along y is ahead of that along x; 0 if not given",
        )
        .bound(Bound::Any),
        Parameter::optional(
            "load_amplitude",
            Quantity::Force,
            "amplitude of the load; 0 if not given",
        ),
        Parameter::optional(
            "load_phase",
            Quantity::Angle,
            "by how much the load is ahead of the oscillation along x; 0 if not given",
        )
        .bound(Bound::Any),
        CYCLE_COUNT,
        Parameter::optional(
            "increments",
            Quantity::Count,
            "increments a cycle, a multiple of four; 20 if not given",
        )
        .bound(INCREMENTS),
        JUMP,
        JUMP_TOLERANCE,
    ],
    build: |values| {
        let wave = Wave::read(values)?;
        let count = wave.increments;
        let shift = Shift {
            lead: wave.lead(),
            cycle: (1..=count).map(|index| wave.station(index)).collect(),
            places: (1..=count).map(|index| index as f64 / count as f64).collect(),
            released: false,
            end_pressure: false,
            progress: Progress::CYCLES,
        };
        let extent = values.number("cycles").unwrap_or(1.0);
        let stepping = jumps(values, 1.0 / count as f64)?;
        Ok((Motion::Shift(shift), Schedule::steady(wave.control, extent, stepping)))
    },
};

const AMPLITUDE: Parameter = Parameter::optional(
    "amplitude",
    Quantity::Pair(&Quantity::Length),
    "amplitudes of the displacement of body 2 over body 1 along x and y",
)
.bound(Bound::NonNegative);
const FORCE_AMPLITUDE: Parameter = Parameter::optional(
    "force_amplitude",
    Quantity::Pair(&Quantity::Force),
    "amplitudes of the tangential force on body 1 along x and y, instead",
)
.bound(Bound::NonNegative);

/// A cycle of sines.
struct Wave {
    control: Control,
    /// Amplitude of the load (N) and by which angle (rad) it is ahead.
    load: [f64; 2],
    /// Amplitudes along x and y (m or N), and by which angle (rad) that along y is ahead.
    amplitude: [f64; 2],
    phase: f64,
    /// Whether the amplitudes are forces.
    forces: bool,
    increments: usize,
}

impl Wave {
    fn read(values: &Values) -> Result<Self, Invalid> {
        let (amplitude, forces) = match values.one_pair_of("amplitude", "force_amplitude")? {
            (Some(amplitude), _) => (amplitude, false),
            (None, amplitude) => (amplitude.unwrap_or_default(), true),
        };
        let increments = values.number("increments").unwrap_or(20.0) as usize;
        if !increments.is_multiple_of(4) {
            let message = "must be a multiple of four: the oscillation turns at its quarters";
            return Err(Invalid::new("increments", message));
        }
        let control = control(values)?;
        let number = |name| values.number(name).unwrap_or(0.0);
        let load = [number("load_amplitude"), number("load_phase")];
        match control {
            Control::Load(mean) if load[0] >= mean => {
                let message = "`load_amplitude` is not less than `load`: the bodies would part";
                return Err(Invalid::new("load_amplitude", message));
            }
            Control::Approach(_) if load[0] > 0.0 => {
                let message = "`load_amplitude` needs a `load`, not an `approach`";
                return Err(Invalid::new("load_amplitude", message));
            }
            _ => {}
        }
        Ok(Self { control, load, amplitude, phase: number("phase"), forces, increments })
    }

    /// What holds the bodies at an increment of the cycle.
    fn station(&self, index: usize) -> Station {
        let count = self.increments;
        let ahead = |angle: f64| {
            let cosine = wave(index + count / 4, count);
            if angle == 0.0 {
                wave(index, count)
            } else {
                wave(index, count) * angle.cos() + cosine * angle.sin()
            }
        };
        let control = match self.control {
            Control::Load(mean) => Control::Load(mean + self.load[0] * ahead(self.load[1])),
            approach => approach,
        };
        let guide = |amplitude: f64, phase: f64| {
            let value = amplitude * ahead(phase);
            if self.forces { Guide::Force(value) } else { Guide::Shift(value) }
        };
        let guides = [guide(self.amplitude[0], 0.0), guide(self.amplitude[1], self.phase)];
        Station { control, guides }
    }

    /// From rest to the beginning of the first cycle: first pressed together, then shifted.
    fn lead(&self) -> Vec<Station> {
        let (count, start) = (self.increments, self.station(0));
        let unmoved = Station { guides: start.share(0.0).guides, ..start };
        let share = |index: usize| index as f64 / count as f64;
        let press = (1..=count).map(|index| unmoved.share(share(index)));
        let moved = if start.guides == unmoved.guides { 0 } else { count };
        let shift =
            (1..=moved).map(|index| Station { guides: start.share(share(index)).guides, ..start });
        press.chain(shift).collect()
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{CHOICE, Guide, Shift};
    use crate::motion::Control;
    use crate::parameters::{Value, Values};

    fn built(numbers: &[(&'static str, f64)]) -> Result<Shift, String> {
        let mut values = Values::default();
        values.insert("amplitude", Value::Pair([1e-6, 2e-6]));
        values.insert("load", Value::Number(50.0));
        numbers.iter().for_each(|(name, value)| values.insert(name, Value::Number(*value)));
        let (motion, _) = (CHOICE.build)(&values).map_err(|invalid| invalid.message)?;
        Ok(motion.shift().expect("increments").clone())
    }

    /// Along an ellipse the path begins where it ends, and turns at the amplitudes.
    #[test]
    fn a_path_closes_and_reaches_its_amplitudes() {
        let angle = std::f64::consts::FRAC_PI_2;
        let shift = built(&[("phase", angle), ("increments", 8.0)]).unwrap();
        assert_eq!(shift.lead.last(), shift.cycle.last());
        assert_eq!(shift.cycle[1].guides[0], Guide::Shift(1e-6));
        let Guide::Shift(y) = shift.cycle[7].guides[1] else { panic!("a shift") };
        assert_relative_eq!(y, 2e-6);
        assert_eq!(shift.lead[0].control, Control::Load(50.0 / 8.0));
    }

    #[test]
    fn a_load_may_vary_but_not_fade() {
        let shift = built(&[("load_amplitude", 10.0), ("increments", 8.0)]).unwrap();
        assert_eq!(shift.cycle[1].control, Control::Load(60.0));
        assert_eq!(shift.cycle[5].control, Control::Load(40.0));
        assert_eq!(shift.peak(), 1);
        assert!(built(&[("load_amplitude", 50.0)]).unwrap_err().contains("would part"));
        assert!(built(&[("increments", 10.0)]).unwrap_err().contains("multiple of four"));
    }
}
