//! How fast profiles lose volume over the whole of a route.

use archard::simulation::WornLine;
use archard::wear::Input;
use rayon::prelude::*;

use super::worn_profile::{Before, Lost, Strip};
use super::{Journey, OperatingPoint, WearError, WornSide};
use crate::contact::{self, Bodies, ContactError, Loaded, Operation, Pressed, Resolution, Wear};
use crate::setup::{Setup, Side};

/// What each point of the wheel and of the rail loses over the whole distance, for each side.
pub(super) type Rates = Vec<[Lost; 2]>;

/// How far (m) wheels went down at each point of the route and each side, to begin with the next time.
pub(super) type Depths = Vec<Vec<Option<f64>>>;

/// What is lost at a point of the route, on each side, and how far what is borne is off the load, relative to it.
type AtPoint = (Vec<Strips>, f64);

/// What patches take of the wheel and of the rail.
type Strips = [Taken; 2];

/// What patches take of a profile.
#[derive(Debug, Default)]
struct Taken {
    /// Volumes (m^3, of a rail m^2) of lines.
    volumes: Vec<Strip>,
    /// Distances (m) that lines slide, in all.
    slid: Vec<Strip>,
    /// Damage under patches.
    damage: Vec<Strip>,
}

impl OperatingPoint {
    /// Those bodies with the friction of this point.
    pub fn between(&self, bodies: &Bodies) -> Bodies {
        let Self { friction, flange, .. } = self.clone();
        Bodies { friction, flange, ..bodies.clone() }
    }

    /// How the wheelset stands and runs, as the right side sees it: the roll at which both wheels begin to touch at one height, and
    /// the pitch at which they bear the moment, where they are asked for.
    ///
    /// # Errors
    /// If there is no such roll or pitch.
    pub fn operation(
        &self,
        [right, left]: [&Setup; 2],
        bodies: &Bodies,
        resolution: &Resolution,
    ) -> Result<Operation, ContactError> {
        let Self { mut attitude, velocity, load, transfer, creepages, .. } = *self;
        if !self.rolls {
            attitude.roll = right.roll(left, attitude.shift, attitude.yaw)?;
        }
        let mut operation = Operation { attitude, velocity, load, transfer, creepages };
        if let Some(moment) = self.moment {
            // Without wear laws, which have no say.
            let bodies = Bodies { wear: [None, None], ..bodies.clone() };
            operation.velocity.pitch =
                contact::pitch([right, left], &bodies, &operation, resolution, moment)?;
        }
        Ok(operation)
    }
}

impl Journey {
    /// The rates with the profiles as they are, at a share of the distance, and how far loads are off, the mean over the route.
    pub(super) fn rates(
        &self,
        worn: &[WornSide],
        progress: f64,
        depths: &mut Depths,
    ) -> Result<(Rates, f64), WearError> {
        let setups = worn.iter().map(|one| self.setup.worn(one.rail.curve(), one.wheel.curve()));
        let setups: Vec<Setup> = setups.collect();
        let before = worn.iter().map(|one| one.profiles().map(|profile| profile.before()));
        let before: Vec<[Before; 2]> = before.collect();
        let points = self.route.points.par_iter().zip(depths.par_iter_mut()).enumerate();
        let strips = points.map(|(at, (point, depths))| {
            let found = self.strips((&setups, &before), point, depths);
            found.map_err(|cause| WearError::Contact {
                point: at + 1,
                progress,
                cause: Box::new(cause),
            })
        });
        let strips = strips.collect::<Vec<Result<AtPoint, _>>>();
        let none = |one: &WornSide| {
            [&one.wheel, &one.rail].map(|profile| {
                let nothing = vec![0.0; profile.len()];
                Lost { volume: nothing.clone(), slid: nothing.clone(), damage: nothing }
            })
        };
        let mut rates: Rates = worn.iter().map(none).collect();
        let mut off = 0.0;
        for (point, strips) in self.route.points.iter().zip(strips) {
            let (strips, of_point) = strips?;
            off += point.share * of_point;
            for ((one, strips), rates) in worn.iter().zip(strips).zip(&mut rates) {
                for ((profile, taken), lost) in one.profiles().into_iter().zip(&strips).zip(rates) {
                    profile.lay(&taken.volumes, &mut lost.volume);
                    profile.cover(&taken.slid, &mut lost.slid);
                    profile.cover(&taken.damage, &mut lost.damage);
                }
            }
        }
        for (one, rates) in worn.iter().zip(&mut rates) {
            for (profile, lost) in one.profiles().into_iter().zip(rates) {
                lost.volume = profile.smoothed(std::mem::take(&mut lost.volume));
                lost.slid = profile.smoothed_depths(&lost.slid);
            }
        }
        Ok((rates, off))
    }

    /// What is lost at a point of the route on each side.
    fn strips(
        &self,
        (setups, before): (&[Setup], &[[Before; 2]]),
        point: &OperatingPoint,
        depths: &mut [Option<f64>],
    ) -> Result<AtPoint, ContactError> {
        let both = Side::both(&self.sides, setups);
        let bodies = point.between(&self.bodies);
        let operation = point.operation(both, &bodies, &self.resolution)?;
        let mut off = 0.0f64;
        let of_side = |(at, setup): (usize, &Setup)| {
            let operation = operation.of_side(self.sides[at]);
            let loaded = Loaded::new(setup, &bodies, &operation, &self.resolution)?;
            let guess = depths[at].unwrap_or_else(|| loaded.guess());
            let (down, patches) = loaded.on(self.resolution.elements, guess)?;
            depths[at] = Some(down);
            off = off.max(loaded.off(&patches));
            let mut strips = Strips::default();
            for patch in &patches {
                self.wear_of((&loaded, &before[at]), patch, point, &mut strips)?;
                self.cracks_of(&loaded, patch, point, &mut strips)?;
            }
            Ok::<Strips, ContactError>(strips)
        };
        let strips = setups.iter().enumerate().map(of_side).collect::<Result<Vec<_>, _>>()?;
        Ok((strips, off))
    }

    /// Adds what the lines of a patch lose.
    fn wear_of(
        &self,
        (loaded, before): (&Loaded<'_>, &[Before; 2]),
        patch: &Pressed,
        point: &OperatingPoint,
        strips: &mut Strips,
    ) -> Result<(), ContactError> {
        let Some(contact) = &patch.contact else { return Ok(()) };
        let told = contact.passage()?;
        let worn =
            |line: &WornLine| line.slid > 0.0 || line.depths.iter().any(|depth| *depth > 0.0);
        let slides: Vec<usize> = (0..told.len()).filter(|&line| worn(&told[line])).collect();
        if slides.is_empty() {
            return Ok(());
        }
        let ends = |&line: &usize| {
            let WornLine { place, width, .. } = told[line];
            [-0.5, 0.5].map(|part| place + part * width)
        };
        let ends: Vec<f64> = slides.iter().flat_map(ends).collect();
        let places = placed(loaded, patch, &ends)?;
        let middle = |body: usize, nth: usize| {
            let places: &Vec<f64> = &places[body];
            0.5 * (places[2 * nth] + places[2 * nth + 1])
        };
        let mut ages = vec![[[0.0; 2]; 2]; told.len()];
        for (nth, &line) in slides.iter().enumerate() {
            ages[line] = [0, 1].map(|body| before[body].at(middle(body, nth)));
        }
        let by = |laws: &Wear| contact.passage_by(laws, |body, line| ages[line][body]);
        let mut lines = if self.remembers() { by(&self.bodies.wear)? } else { told };
        if let Some((from, laws)) = self.bodies.wear_on_the_flange() {
            let on_the_flange = by(&laws)?;
            let wheel = loaded.search().setup().wheel();
            for (nth, &line) in slides.iter().enumerate() {
                if wheel.point(middle(0, nth))[0] <= from {
                    lines[line] = on_the_flange[line];
                }
            }
        }
        // While the wheelset goes a metre the patch rolls over so many.
        let rolled = patch.creepage.speed / point.velocity.forward;
        let metres = [self.route.distance, self.route.axles].map(|all| all * point.share * rolled);
        for body in 0..2 {
            for (&line, ends) in slides.iter().zip(places[body].chunks(2)) {
                let (WornLine { width, depths, slid, .. }, ends) =
                    (lines[line], [ends[0], ends[1]]);
                strips[body].volumes.push((ends, depths[body] * width * metres[body]));
                strips[body].slid.push((ends, slid * metres[body]));
            }
        }
        Ok(())
    }

    /// Whether a law asks for what points went through before.
    fn remembers(&self) -> bool {
        [Input::Distance, Input::Depth].into_iter().any(|input| self.bodies.asks_for(input))
    }

    /// Adds the damage that a patch does over its width, on each metre.
    fn cracks_of(
        &self,
        loaded: &Loaded<'_>,
        patch: &Pressed,
        point: &OperatingPoint,
        strips: &mut Strips,
    ) -> Result<(), ContactError> {
        let Some(ends) = patch.map.width() else { return Ok(()) };
        if self.cracks == [None; 2] {
            return Ok(());
        }
        let told = loaded.tell(patch);
        let rolled = patch.creepage.speed / point.velocity.forward;
        let metres = [self.route.distance * rolled, self.route.axles];
        let places = placed(loaded, patch, &ends)?;
        for body in 0..2 {
            let Some(cracks) = &self.cracks[body] else { continue };
            let damage = cracks.of_passage(told.t_gamma) * point.share * metres[body];
            strips[body].damage.push(([places[body][0], places[body][1]], damage));
        }
        Ok(())
    }
}

/// Where (m along the curves of the wheel and of the rail) a patch has those s (m).
fn placed(
    loaded: &Loaded<'_>,
    patch: &Pressed,
    across: &[f64],
) -> Result<[Vec<f64>; 2], ContactError> {
    let places = loaded.search().gap(&patch.patch).places(across);
    places.ok_or(ContactError::Short { y: patch.patch.reference.y })
}
