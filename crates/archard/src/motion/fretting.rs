//! Small tangential oscillations under load (the paper's section 6.1; Cattaneo and Mindlin).

use super::shift::{CYCLE_COUNT, Cycles, JUMP, JUMP_TOLERANCE, Shift, Station, wave};
use super::{
    APPROACH, Control, Drive, INCREMENTS, LOAD, Lever, Motion, Passage, Planned, Progress,
    Schedule, Sequence, Slip, Stepping, control, counted, pressing,
};
use crate::frame::Direction;
use crate::parameters::{Bound, Choice, Invalid, Parameter, Quantity, Values};

pub(super) const CHOICE: Choice<Planned> = Choice {
    name: "fretting",
    meaning: "tangential oscillation of given displacement or force under constant or varying load",
    parameters: &[
        LOAD,
        APPROACH,
        AMPLITUDE,
        FORCE_AMPLITUDE,
        PHASE,
        LOAD_AMPLITUDE,
        LOAD_PHASE,
        CYCLE_COUNT,
        COUNT,
        JUMP,
        JUMP_TOLERANCE,
        Parameter::optional(
            "surfaces",
            Quantity::Word(&["stay", "swing"]),
            "whether the same points stay opposite each other (stay), or the surfaces swing past each other (swing); chosen by the amplitude if not given",
        ),
    ],
    build: |values| {
        if values.word("surfaces") == Some("swing") {
            return swinging(values);
        }
        let fretting = match values.one_pair_of("amplitude", "force_amplitude")? {
            (Some(amplitude), _) => Fretting::shifted(amplitude),
            (None, amplitude) => Fretting::pushed(amplitude.unwrap_or_default()),
        };
        let number = |name| values.number(name).unwrap_or(0.0);
        fretting
            .phase(number("phase"))
            .varying_load(number("load_amplitude"), number("load_phase"))
            .increments(values.number("increments").unwrap_or(20.0) as usize)
            .cycles(Cycles::read(values)?)
            .under(control(values)?)
    },
};

/// Gross slip: the surfaces swing past each other along one axis.
fn swinging(values: &Values) -> Result<Planned, Invalid> {
    const OTHERS: [&str; 5] =
        ["force_amplitude", "phase", "load_amplitude", "load_phase", "increments"];
    if let Some(other) = OTHERS.into_iter().find(|name| values.get(name).is_some()) {
        let message =
            format!("surfaces that swing are in gross slip by an `amplitude`, without `{other}`");
        return Err(Invalid::new(other, message).beside("surfaces"));
    }
    let amplitude = values
        .pair("amplitude")
        .ok_or_else(|| Invalid::new("amplitude", "`amplitude` is missing"))?;
    let (axis, amplitude) = match amplitude {
        // Which way they set out does not matter.
        [x, 0.0] if x != 0.0 => (0, x.abs()),
        [0.0, y] if y != 0.0 => (1, y.abs()),
        _ => {
            let message = "surfaces swing along x or along y: give an amplitude along one of them";
            return Err(Invalid::new("amplitude", message));
        }
    };
    let (extent, stepping) = Cycles::read(values)?.divided(1.0)?;
    let stepping = match stepping {
        Stepping::Jumps(cycles) => Stepping::Implicit(cycles as f64),
        other => other,
    };
    let motion = Motion {
        progress: Progress::CYCLES,
        direction: Direction { axis, reversed: false },
        surfaces: [Passage::Swings(amplitude, None); 2],
        slip: Slip::Given(4.0 * amplitude, Lever::Even),
        sequence: Sequence::Steady,
        speed: None,
    };
    let control = pressing(control(values)?)?;
    Ok((motion, Schedule::steady(control, extent, stepping)))
}

const AMPLITUDE: Parameter = Parameter::optional(
    "amplitude",
    Quantity::Pair(&Quantity::Length),
    "amplitudes of the displacement of body 2 over body 1 along x and y; one with a minus sets out the other way",
)
.bound(Bound::Any);
const FORCE_AMPLITUDE: Parameter = Parameter::optional(
    "force_amplitude",
    Quantity::Pair(&Quantity::Force),
    "amplitudes of the tangential force on body 1 along x and y, instead; one with a minus sets out the other way",
)
.bound(Bound::Any);

const PHASE: Parameter = Parameter::optional(
    "phase",
    Quantity::Angle,
    "by how much the oscillation along y is ahead of that along x; 0 if not given",
)
.bound(Bound::Any);
const LOAD_AMPLITUDE: Parameter =
    Parameter::optional("load_amplitude", Quantity::Force, "amplitude of the load; 0 if not given")
        .bound(Bound::Any);
const LOAD_PHASE: Parameter = Parameter::optional(
    "load_phase",
    Quantity::Angle,
    "by how much the load is ahead of the oscillation along x; 0 if not given",
)
.bound(Bound::Any);
const COUNT: Parameter = Parameter::optional(
    "increments",
    Quantity::Count,
    "increments a cycle, a multiple of four; 20 if not given",
)
.bound(INCREMENTS);

/// Cycles of sines: tangential displacements or forces, under a load or approach that is constant or a load that
/// varies as well.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fretting {
    /// Amplitudes along x and y (m or N), and by which angle (rad) that along y is ahead.
    amplitude: [f64; 2],
    phase: f64,
    /// Whether the amplitudes are forces.
    forces: bool,
    /// Amplitude of the load (N) and by which angle (rad) it is ahead.
    load: [f64; 2],
    increments: usize,
    cycles: Cycles,
}

impl Fretting {
    /// One cycle of 20 increments; these are the amplitudes (m) of the displacement of body 2 over body 1 along x
    /// and y.
    pub fn shifted(amplitude: [f64; 2]) -> Self {
        let cycles = Cycles::new(1);
        Self { amplitude, phase: 0.0, forces: false, load: [0.0; 2], increments: 20, cycles }
    }

    /// One cycle of 20 increments; these are the amplitudes (N) of the tangential force on body 1 along x and y.
    pub fn pushed(amplitude: [f64; 2]) -> Self {
        Self { forces: true, ..Self::shifted(amplitude) }
    }

    /// The same, the oscillation along y ahead of that along x by this angle (rad).
    #[must_use]
    pub fn phase(self, phase: f64) -> Self {
        Self { phase, ..self }
    }

    /// The same, the load oscillating with an amplitude (N), ahead of the oscillation along x by an angle (rad).
    #[must_use]
    pub fn varying_load(self, amplitude: f64, phase: f64) -> Self {
        Self { load: [amplitude, phase], ..self }
    }

    /// The same with that number of increments a cycle, a multiple of four.
    #[must_use]
    pub fn increments(self, increments: usize) -> Self {
        Self { increments, ..self }
    }

    /// The same with these cycles.
    #[must_use]
    pub fn cycles(self, cycles: Cycles) -> Self {
        Self { cycles, ..self }
    }

    /// Under that load, the mean of one that varies, or approach.
    ///
    /// # Errors
    /// If a value is not one to compute with, the increments are no multiple of four or too many, or the load
    /// fades.
    pub fn under(self, control: Control) -> Result<Planned, Invalid> {
        self.check(control)?;
        let count = self.increments;
        let station = |index| self.station(control, index);
        let (extent, stepping) = self.cycles.divided(1.0 / count as f64)?;
        let shift = Shift {
            lead: station(0).lead(count),
            cycle: (1..=count).map(station).collect(),
            places: (1..=count).map(|index| index as f64 / count as f64).collect(),
            released: false,
            end_pressure: false,
        };
        let motion = Motion::cycle_of(shift, Progress::CYCLES);
        Ok((motion, Schedule::steady(control, extent, stepping)))
    }

    fn check(&self, control: Control) -> Result<(), Invalid> {
        let amplitude = if self.forces { FORCE_AMPLITUDE } else { AMPLITUDE };
        self.amplitude.iter().try_for_each(|&one| amplitude.admit(one).map(|_| ()))?;
        PHASE.admit(self.phase)?;
        LOAD_PHASE.admit(self.load[1])?;
        if !counted(COUNT, self.increments)?.is_multiple_of(4) {
            let message = "must be a multiple of four: the oscillation turns at its quarters";
            return Err(Invalid::new("increments", message));
        }
        let load = LOAD_AMPLITUDE.admit(self.load[0])?;
        match pressing(control)? {
            Control::Load(mean) if load.abs() >= mean => {
                let message = "`load_amplitude` is not less than `load`: the bodies would part";
                Err(Invalid::new("load_amplitude", message).beside("load"))
            }
            Control::Approach(_) if load != 0.0 => {
                let message = "`load_amplitude` needs a `load`, not an `approach`";
                Err(Invalid::new("load_amplitude", message).beside("approach"))
            }
            _ => Ok(()),
        }
    }

    /// What holds the bodies at an increment of the cycle.
    fn station(&self, control: Control, index: usize) -> Station {
        let count = self.increments;
        let ahead = |angle: f64| {
            let cosine = wave(index + count / 4, count);
            if angle == 0.0 {
                wave(index, count)
            } else {
                wave(index, count) * angle.cos() + cosine * angle.sin()
            }
        };
        let control = match control {
            Control::Load(mean) => Control::Load(mean + self.load[0] * ahead(self.load[1])),
            approach => approach,
        };
        let guide = |amplitude: f64, phase: f64| {
            let value = amplitude * ahead(phase);
            if self.forces { Drive::Force(value) } else { Drive::Slip(value) }
        };
        let guides = [guide(self.amplitude[0], 0.0), guide(self.amplitude[1], self.phase)];
        Station { control, guides }
    }
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Drive, Fretting, Shift};
    use crate::motion::Control;

    fn built(fretting: Fretting) -> Result<Shift, String> {
        let (motion, _) = fretting.under(Control::Load(50.0)).map_err(|invalid| invalid.message)?;
        Ok(motion.increments().expect("increments").clone())
    }

    fn ellipse() -> Fretting {
        Fretting::shifted([1e-6, 2e-6])
    }

    /// Along an ellipse the path begins where it ends, and turns at the amplitudes.
    #[test]
    fn a_path_closes_and_reaches_its_amplitudes() {
        let angle = std::f64::consts::FRAC_PI_2;
        let shift = built(ellipse().phase(angle).increments(8)).unwrap();
        assert_eq!(shift.lead.last(), shift.cycle.last());
        assert_eq!(shift.cycle[1].guides[0], Drive::Slip(1e-6));
        let Drive::Slip(y) = shift.cycle[7].guides[1] else { panic!("a shift") };
        assert_relative_eq!(y, 2e-6);
        assert_eq!(shift.lead[0].control, Control::Load(50.0 / 8.0));
    }

    /// A minus is the same oscillation, half a cycle later.
    #[test]
    fn a_negative_amplitude_sets_out_the_other_way() {
        let there = built(Fretting::shifted([1e-6, 2e-6]).increments(8)).unwrap();
        let back = built(Fretting::shifted([-1e-6, -2e-6]).increments(8)).unwrap();
        for index in 0..8 {
            let pairs =
                back.cycle[index].guides.into_iter().zip(there.cycle[(index + 4) % 8].guides);
            for (one, other) in pairs {
                let (Drive::Slip(one), Drive::Slip(other)) = (one, other) else { panic!("shifts") };
                assert!((one - other).abs() < 1e-20, "{one:e} and {other:e}");
            }
        }
        let [Drive::Slip(x), Drive::Slip(y)] =
            built(Fretting::shifted([-1e-6, 1e-6]).increments(8)).unwrap().cycle[1].guides
        else {
            panic!("a shift")
        };
        assert_eq!([x, y], [-1e-6, 1e-6]);
        let load = built(ellipse().varying_load(-10.0, 0.0).increments(8)).unwrap();
        assert_eq!(load.cycle[1].control, Control::Load(40.0));
        assert!(built(ellipse().varying_load(-50.0, 0.0)).unwrap_err().contains("would part"));
    }

    #[test]
    fn a_load_may_vary_but_not_fade() {
        let shift = built(ellipse().varying_load(10.0, 0.0).increments(8)).unwrap();
        assert_eq!(shift.cycle[1].control, Control::Load(60.0));
        assert_eq!(shift.cycle[5].control, Control::Load(40.0));
        assert_eq!(shift.peak(), 1);
        assert!(built(ellipse().varying_load(50.0, 0.0)).unwrap_err().contains("would part"));
        assert!(built(ellipse().increments(10)).unwrap_err().contains("multiple of four"));
    }
}
