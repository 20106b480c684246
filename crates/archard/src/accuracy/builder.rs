//! A simulation from its parts, on the elements that an accuracy takes.

use super::{AccuracyFailure, Grid, SettledRun, TOLERANCE, Watch, admitted, refusal, settle};
use crate::motion::Stepping;
use crate::parameters::Invalid;
use crate::simulation::Builder;

impl Builder {
    /// Puts the parts together on the elements, and with the tolerance of the steps, that an accuracy (a relative error) takes: the
    /// elements of the frame are a first guess. Runs on coarser ones come first, which `watch` is shown; an error of it ends them.
    ///
    /// ```
    /// use archard::body::profile::{Flat, Sphere};
    /// use archard::body::{Body, Material};
    /// use archard::motion::{Control, Sliding, Stepping};
    /// use archard::simulation::history::{ERROR, WEAR_DEPTH, number, row};
    /// use archard::simulation::{Run, Simulation};
    /// use archard::wear::Archard;
    ///
    /// let steel = Material::new(210e9, 0.3)?;
    /// let pin = Body::new("pin", Sphere::new(50e-3)?).material(steel).wear(Archard::new(1.33e-13)?);
    /// let disc = Body::new("disc", Flat).material(steel);
    /// let sliding = Sliding::new().over(0.5, Control::Load(10.2), Stepping::Tolerance(0.01))?;
    /// let builder = Simulation::builder([pin, disc], sliding).frame([1.3e-3; 2], [48; 2]);
    /// let settled = builder.settle(0.05, &mut |_| Ok(()))?;
    /// let mut run = Run::begin(settled.simulation)?;
    /// while run.step()? {}
    /// let row = row(&run.report());
    /// assert!(number(&row, ERROR).is_some_and(|error| error <= 0.05));
    /// # assert!(number(&row, WEAR_DEPTH).is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    /// If parts do not fit together, a coarser run fails, or the builder can not make the parts coarser: pairs that are given, steps
    /// of a given length, the increments of a cycle. [`settle`] takes a function that does.
    pub fn settle(
        self,
        accuracy: f64,
        watch: &mut Watch<'_>,
    ) -> Result<SettledRun, AccuracyFailure> {
        let grid = self.grid(accuracy).map_err(|invalid| AccuracyFailure::Build(invalid.into()))?;
        let mut build = |grid: &Grid| {
            let mut builder = self.clone().on(grid.elements, grid.moved);
            let schedule = &mut builder.planned.1;
            if let Some(tolerance) = grid.tolerance {
                schedule.stepping = Stepping::Tolerance(tolerance);
            }
            schedule.outputs = grid.outputs(&schedule.outputs);
            Ok(builder.build()?)
        };
        settle(accuracy, grid, &mut build, watch)
    }

    /// The first grid.
    fn grid(&self, accuracy: f64) -> Result<Grid, Invalid> {
        let wrong = |message: &str| Err(Invalid::new("accuracy", message));
        if !admitted(accuracy) {
            return Err(Invalid::new("accuracy", refusal()));
        }
        let Some(elements) = self.elements() else {
            return wrong("the elements of a mesh, and pairs that are given, are not chosen");
        };
        let (motion, schedule) = &self.planned;
        if self.friction.is_some() && motion.increments().is_some() {
            return wrong(
                "the increments of a cycle become more with the elements: make the motion in a function that `accuracy::settle` takes",
            );
        }
        let wears = self.bodies.iter().any(|body| body.wear.is_some());
        let tolerance = match schedule.stepping {
            Stepping::Tolerance(tolerance) => Some(tolerance.min(TOLERANCE * accuracy)),
            Stepping::Implicit(_) | Stepping::Explicit(_) | Stepping::Jumps(_) if wears => {
                return wrong(
                    "the error of fixed steps is not known: give a `Stepping::Tolerance`",
                );
            }
            _ => None,
        };
        Ok(Grid { tolerance, ..Grid::new(elements) })
    }
}
