//! A run: from the initial contact to the end of the motion, state by state.

use super::effort::Effort;
use super::error::{Error, ResumeError};
use super::march::March;
use super::report::Observer;
use super::report::{Kept, Report};
use super::setup::Simulation;
use crate::numerics::vector::in_pool;

/// A simulation under way. It goes on when it is asked to and shows where it is.
///
/// ```
/// # use archard::body::{Body, Material, profile::{Flat, Sphere}};
/// # use archard::motion::{Control, Sliding, Stepping};
/// # use archard::simulation::{Run, Simulation};
/// # use archard::wear::Archard;
/// # let steel = Material::new(210e9, 0.3)?;
/// # let pin = Body::new("pin", Sphere::new(50e-3)?).material(steel).wear(Archard::new(1.33e-13)?);
/// # let disc = Body::new("disc", Flat).material(steel);
/// # let sliding = Sliding::new().over(10e-3, Control::Load(10.2), Stepping::Implicit(5e-3))?;
/// # let simulation = Simulation::builder([pin, disc], sliding).frame([1.2e-3; 2], [20; 2]).build()?;
/// let mut run = Run::begin(simulation)?;
/// while run.step()? {
///     let report = run.report();
///     assert!((report.state.load - 10.2).abs() < 1e-6);
/// }
/// # assert_eq!(run.report().effort.steps, 2);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Run {
    simulation: Simulation,
    march: March,
}

impl Run {
    /// Brings the bodies into the initial contact.
    ///
    /// # Errors
    /// As [`Run::step`], and if the frame does not suit the motion or a wear law lacks what it asks for.
    pub fn begin(simulation: Simulation) -> Result<Self, Error> {
        let march = in_pool(|| March::begin(&simulation))?;
        Ok(Self { simulation, march })
    }

    /// Goes on to the next state; `false` at the end of the motion.
    ///
    /// # Errors
    /// If a contact does not converge or fills the frame; the run cannot go on then.
    pub fn step(&mut self) -> Result<bool, Error> {
        let Self { simulation, march } = self;
        in_pool(|| march.step(simulation))
    }

    /// Goes on with a run that was kept, to the same bits as if it had not been interrupted.
    ///
    /// # Errors
    /// If it was another one, or cannot be read.
    pub fn resume(simulation: Simulation, checkpoint: &[u8]) -> Result<Self, ResumeError> {
        let march = March::from_bytes(checkpoint, &simulation)?;
        Ok(Self { simulation, march })
    }

    /// All that its further steps follow from.
    pub fn checkpoint(&self) -> Vec<u8> {
        self.march.to_bytes()
    }

    /// Where it is.
    pub fn report(&self) -> Report<'_> {
        self.march.report(&self.simulation)
    }

    /// The problem, its solvers and what it is put through.
    pub fn simulation(&self) -> &Simulation {
        &self.simulation
    }
}

impl Simulation {
    /// Carries the motion through, or until an observer ends it, showing the initial contact and every step to the observers.
    ///
    /// # Errors
    /// If the frame does not suit the motion, a wear law lacks what it asks for, a contact does not converge or fills
    /// the frame, or an observer cannot go on.
    pub fn run(&self, observers: &mut [&mut dyn Observer]) -> Result<Effort, Error> {
        // Within the pool once, not anew for each of many small solves.
        in_pool(|| {
            let march = March::begin(self)?;
            show(&march.report(self), observers)?;
            self.carry_on(march, observers)
        })
    }

    /// Goes on with a run that was kept, showing the state it was kept in [again](Report::again), then every further
    /// step.
    ///
    /// # Errors
    /// As [`Simulation::run`], and if it was another run, or cannot be read.
    pub fn resume(
        &self,
        checkpoint: &[u8],
        observers: &mut [&mut dyn Observer],
    ) -> Result<Effort, Error> {
        in_pool(|| {
            let march = March::from_bytes(checkpoint, self)?;
            show(&Report { again: true, ..march.report(self) }, observers)?;
            self.carry_on(march, observers)
        })
    }

    /// Says whether what was kept is of a run of this simulation.
    ///
    /// # Errors
    /// If it was another run, or cannot be read.
    pub fn recognise(&self, checkpoint: &[u8]) -> Result<(), ResumeError> {
        March::from_bytes(checkpoint, self).map(|_| ())
    }

    fn carry_on(
        &self,
        mut march: March,
        observers: &mut [&mut dyn Observer],
    ) -> Result<Effort, Error> {
        let ends = |observers: &[&mut dyn Observer]| observers.iter().any(|one| one.ends());
        while !ends(observers) && march.step(self)? {
            show(&march.report(self), observers)?;
        }
        Ok(march.effort())
    }
}

fn show(report: &Report<'_>, observers: &mut [&mut dyn Observer]) -> Result<(), Error> {
    observers.iter_mut().try_for_each(|observer| observer.observe(report).map_err(Error::Observer))
}
