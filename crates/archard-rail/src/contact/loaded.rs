//! A wheel under its load, on a grid.

use archard::body::contact_modulus;
use archard::parameters::Invalid;

use super::pressed::{Pressed, Site};
use super::{Bodies, ContactError, Operation, Quantities, Resolution, apart, counterpart, height};
use crate::bounds;
use crate::search::Search;
use crate::setup::Setup;

/// A wheel over its rail with what it carries.
#[derive(Debug)]
pub(crate) struct Loaded<'a> {
    search: Search<'a>,
    /// Height (m) at which it begins to touch.
    onset: f64,
    bodies: &'a Bodies,
    operation: &'a Operation,
    /// Which stretches of overlap share a grid, and whether patches curve.
    resolution: Resolution,
}

impl<'a> Loaded<'a> {
    /// # Errors
    /// If a value cannot be used, or the wheel does not stand over the rail.
    pub fn new(
        setup: &'a Setup,
        bodies: &'a Bodies,
        operation: &'a Operation,
        resolution: &Resolution,
    ) -> Result<Self, ContactError> {
        bounds::positive("load", operation.load)?;
        let velocity = &operation.velocity;
        if velocity.translation().length() == 0.0 && velocity.pitch == 0.0 {
            let message = "a wheelset that stands still does not roll";
            return Err(Invalid::new("velocity", message).into());
        }
        let search = Search::new(setup, operation.attitude)?;
        let onset = search.onset().ok_or(ContactError::NoContact)?.height;
        Ok(Self { search, onset, bodies, operation, resolution: *resolution })
    }

    /// What it is searched with.
    pub fn search(&self) -> &Search<'a> {
        &self.search
    }

    /// How far (m) it goes down from where it begins to touch, nearly: as a ball of its radius sinks into a plane.
    pub fn guess(&self) -> f64 {
        let modulus = contact_modulus([Some(&self.bodies.wheel), Some(&self.bodies.rail)]);
        let setup = self.search.setup();
        let radius =
            (setup.wheelset().nominal_radius.recip() + setup.roller().curvature(0.0)).recip();
        let force = 4.0 / 3.0 * modulus * radius.sqrt();
        (self.operation.load / force).cbrt().powi(2)
    }

    /// How far (m) it goes down until its contacts bear the load, on so many elements and from a guess (m), and the patches.
    pub fn on(&self, elements: usize, guess: f64) -> Result<(f64, Vec<Pressed>), ContactError> {
        let bears = |height: f64| {
            let patches = self.at(elements, height)?;
            let borne = patches.iter().map(Pressed::vertical).sum::<f64>();
            Ok((patches, borne))
        };
        let guess = self.onset + guess;
        let (height, patches) = height::find(self.operation.load, self.onset, guess, bears)?;
        Ok((height - self.onset, patches))
    }

    /// The patches on so many elements with the wheel at that height (m).
    pub fn at(&self, elements: usize, height: f64) -> Result<Vec<Pressed>, ContactError> {
        let Self { search, bodies, operation, .. } = self;
        let patches = search.patches(height, self.resolution.join)?.into_iter();
        let sites = patches.map(|patch| Site::new(search, patch, elements));
        let sites = sites.collect::<Result<Vec<Site>, _>>()?;
        let apart = apart::by_the_others(&sites, bodies)?;
        let with = (*operation, *bodies, self.resolution.curved);
        let sites = sites.into_iter().zip(apart);
        sites.map(|(site, apart)| site.press(search, with, apart)).collect()
    }

    /// The height (m) of the wheelset so far (m) below where it begins to touch.
    pub fn height(&self, down: f64) -> f64 {
        self.onset + down
    }

    /// The same patch among those of another grid with the wheel at that height (m).
    pub fn counterpart(&self, pressed: &Pressed, grid: &[Pressed], height: f64) -> Pressed {
        counterpart::on(grid, pressed).cloned().unwrap_or_else(|| {
            Pressed::missed(&self.search, &pressed.patch, height, self.operation)
        })
    }

    /// How far what patches bear is off the load, relative to it: it may jump over the load.
    pub fn off(&self, patches: &[Pressed]) -> f64 {
        let borne: f64 = patches.iter().map(Pressed::vertical).sum();
        (borne / self.operation.load - 1.0).abs()
    }

    /// What is known of a patch.
    pub fn tell(&self, pressed: &Pressed) -> Quantities {
        let Pressed { patch, creepage, .. } = pressed;
        Quantities {
            onset: self.onset,
            z_wheel: patch.height,
            y_track: patch.reference.y,
            y_rail: self
                .search
                .setup()
                .placing()
                .in_rail(patch.reference.with_z(patch.on_profile))
                .y,
            y_wheel: self.search.in_wheel(patch.reference, patch.height).y,
            contact_angle: patch.angle,
            creepage: creepage.longitudinal,
            lateral_creepage: creepage.lateral,
            spin: creepage.spin,
            normal_force: pressed.normal,
            force_x: pressed.tangential[0],
            force_s: pressed.tangential[1],
            moment: pressed.moment,
            approach: pressed.approach,
            peak_pressure: pressed.peak,
            contact_area: pressed.area,
            frictional_power: pressed.power,
            // Forces on the rail, against the creepage of the wheel over it.
            t_gamma: -(pressed.tangential[0] * creepage.longitudinal
                + pressed.tangential[1] * creepage.lateral),
            surface_fatigue: match pressed.normal > 0.0 {
                true => {
                    let [x, s] = pressed.tangential;
                    x.hypot(s) / pressed.normal - self.bodies.shear_yield / pressed.peak
                }
                false => f64::NAN,
            },
        }
    }
}
