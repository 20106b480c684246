//! What the last tractions of a contact make of the inside of bodies.

use std::collections::VecDeque;
use std::error::Error as StdError;
use std::path::Path;

use super::damage::Tired;
use super::elastic::{POINTS, depth, section_file, write_points, write_sections};
use super::stress::{self, Passing, Stresses, WantedStresses, prefix};
use super::table::Table;
use super::{Error, Manifest, Store, Surface};
use archard::body::{Body, Finite, Material};
use archard::compliance::SolveError;
use archard::compliance::bem::Boundary;
use archard::compliance::bem::contact::Job;
use archard::compliance::half_space::Periodic;
use archard::elastic::{self, Cycle, DeformedBody, ElasticError, Point, PressedHalfSpace, Section};
use archard::frame::{ContactFrame, VectorField};
use archard::motion::Shift;
use archard::numerics::SAME;
use archard::problem::ContactProblem;
use archard::simulation::{Observer, Report, offsets};

/// The files of displacements, tractions and stresses on the surfaces of body 1 and body 2, where they lie in contact.
pub(super) const SURFACES: [&str; 2] = ["surface_1.vtu", "surface_2.vtu"];

/// Keeps the last tractions and the wear of a run, for the stresses inside where these are asked for.
#[derive(Debug)]
pub struct Inside {
    points: [Vec<Point>; 2],
    sections: [Vec<Section>; 2],
    stresses: [Option<WantedStresses>; 2],
    store: Option<Store>,
    last: Option<(VectorField, [Vec<f64>; 2])>,
    /// The frame of the last tractions, which may have grown.
    frame: Option<ContactFrame>,
    /// Whether the surfaces repeat themselves with the frame.
    repeats: bool,
    /// The tractions of the last cycle, each with how far the motion had gone, where fatigue along it is asked for.
    cycle: VecDeque<(f64, VectorField)>,
    /// The damage of body 1 and body 2, where that is asked for.
    tired: [Tired; 2],
}

/// Why stresses inside are not there.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum InsideError {
    /// The body cannot be computed.
    #[error("stresses in `{body}`: {cause}")]
    Body {
        /// The body's name.
        body: String,
        /// What is wrong.
        cause: ElasticError,
    },
    /// A file cannot be written.
    #[error(transparent)]
    Write(#[from] Error),
}

impl Inside {
    /// Stresses at points of body 1 and body 2 (m, in their own coordinates).
    pub fn at(points: [Vec<Point>; 2]) -> Self {
        Self {
            points,
            sections: [vec![], vec![]],
            stresses: [None, None],
            store: None,
            last: None,
            frame: None,
            repeats: false,
            cycle: VecDeque::new(),
            tired: Default::default(),
        }
    }

    /// Stresses on sections of body 1 and body 2 as well.
    #[must_use]
    pub fn on(self, sections: [Vec<Section>; 2]) -> Self {
        Self { sections, ..self }
    }

    /// The largest stresses in body 1 and body 2 as well, where they are half-spaces.
    #[must_use]
    pub fn largest(self, stresses: [Option<WantedStresses>; 2]) -> Self {
        Self { stresses, ..self }
    }

    /// The same of surfaces that repeat themselves with the frame, or do not.
    #[must_use]
    pub fn repeating(self, repeats: bool) -> Self {
        Self { repeats, ..self }
    }

    /// The same with a store: equations are solved for all tractions of the contact once, and what comes out is kept
    /// there, so that no later run of the body solves them.
    #[must_use]
    pub fn keeping(self, store: Option<Store>) -> Self {
        Self { store, ..self }
    }

    /// The files that [`Inside::write`] may write for bodies of these names, by their names in the folder.
    pub fn files(&self, bodies: [&str; 2]) -> Vec<String> {
        let table = self.points.iter().any(|points| !points.is_empty());
        let mut files: Vec<String> = table.then(|| POINTS.to_owned()).into_iter().collect();
        for (which, body) in bodies.into_iter().enumerate().filter(|(which, _)| self.wants(*which))
        {
            files.push(SURFACES[which].to_owned());
            let sections = &self.sections[which];
            files.extend(sections.iter().map(|one| section_file(&prefix(body), &one.name)));
            files.extend(self.stresses[which].iter().flat_map(|wanted| wanted.files(body)));
        }
        files
    }

    /// Whether anything of a body is wanted.
    fn wants(&self, which: usize) -> bool {
        !self.points[which].is_empty()
            || !self.sections[which].is_empty()
            || self.stresses[which].is_some()
    }

    /// Writes `points.csv`, a row a point, and a file a section in `sections`; for every body of finite shape with points or sections also
    /// the fields on its surface, `surface_1.vtu` or `surface_2.vtu`. Without a store the equations of these bodies are made and
    /// solved once more. Of half-spaces and image fields whose largest stresses are asked for, `stress_BODY.csv` and `stress_BODY.vtr`; these
    /// stresses are returned.
    ///
    /// # Errors
    /// If a point lies outside of its body, equations have no solution, or a file cannot be written.
    pub fn write(&self, dir: &Path, problem: &ContactProblem) -> Result<Stresses, InsideError> {
        let mut stresses = Stresses::default();
        let (Some((tractions, worn)), Some(frame)) = (&self.last, &self.frame) else {
            return Ok(stresses);
        };
        let bodies = problem.bodies.each_ref();
        let any = self.points.iter().any(|points| !points.is_empty());
        let mut manifest = Manifest::read(dir)?;
        let path = any.then(|| manifest.claim(POINTS)).transpose()?;
        let mut table = path.map(Table::create).transpose()?;
        for which in (0..2).filter(|&which| self.wants(which)) {
            let body = &bodies[which].name;
            let failed = |cause| InsideError::Body { body: body.clone(), cause };
            let first = [("body", body.clone())];
            let (points, sections) = (&self.points[which][..], &self.sections[which][..]);
            let placed = (which, offsets(&problem.bodies, &problem.motion));
            let pressed =
                PressedHalfSpace::with_ends(bodies, placed, frame, tractions).map_err(failed)?;
            let place = (which, frame);
            if let Some(pressed) = pressed.map(|pressed| self.repeated(pressed, bodies, place)) {
                let (points, found) = pressed.both_sides(points).map_err(failed)?;
                if let Some(table) = &mut table {
                    write_points(table, &first, (&points, &found), |place| {
                        pressed.depth_of(place)
                    })?;
                }
                let sections: Vec<_> = sections.iter().map(|one| pressed.section(one)).collect();
                write_sections(&mut manifest, &prefix(body), &sections, which == 1)?;
                let asked = !points.is_empty() || !sections.is_empty();
                if let Some(deformed) = asked.then(|| pressed.on_surface()).flatten() {
                    let surface = Surface::of_elastic(&deformed);
                    let surface = if which == 1 { surface.turned_over() } else { surface };
                    surface.write(&manifest.claim(SURFACES[which])?)?;
                }
                let places = points.iter().map(|point| point.place);
                let places = places.chain(sections.iter().flat_map(|one| one.places.clone()));
                stresses.missed(body, pressed.missed(&places.collect::<Vec<_>>()));
                if let Some(wanted) = &self.stresses[which] {
                    pressed.check(&wanted.depths).map_err(failed)?;
                    let axis = problem.motion.direction.axis;
                    let passing = match problem.motion.increments() {
                        Some(shift) if wanted.fatigue.is_wanted() => {
                            Passing::Cycle(self.whole((shift, axis), bodies, (which, frame)))
                        }
                        _ => Passing::Along(axis),
                    };
                    let (place, axis) = ((&mut manifest, which), (axis, &passing));
                    let (mut block, mut lines) =
                        stress::write(place, axis, bodies[which], (wanted, &pressed))?;
                    if let Some(wanted) = &wanted.damage {
                        let (own, more) = self.tired[which].write(&mut manifest, (body, wanted))?;
                        block["damage"] = own;
                        lines.extend(more);
                    }
                    stresses.add(body, (block, lines));
                }
                continue;
            }
            let solve = |finite: &Finite, material: &Material, job: &Job<'_>, acting: &[f64]| {
                self.solve(finite, material, job, acting)
            };
            let acting = (tractions, &worn[which][..]);
            let deformed =
                DeformedBody::in_contact_by(bodies, which, acting, (points, sections), &solve)
                    .map_err(failed)?;
            let Some(deformed) = deformed else { continue };
            let placed = bodies[which].finite.as_ref().is_none_or(|finite| finite.meshed.placed);
            let turned = which == 1 && !placed;
            let surface = Surface::of_elastic(&deformed);
            let surface = if turned { surface.turned_over() } else { surface };
            surface.write(&manifest.claim(SURFACES[which])?)?;
            if let Some(table) = &mut table {
                let found = (points, &deformed.points[..]);
                write_points(table, &first, found, |place| depth(&deformed, place))?;
            }
            write_sections(&mut manifest, &prefix(body), &deformed.sections, turned)?;
        }
        if let Some(mut table) = table {
            table.flush()?;
            table.sync()?;
        }
        Ok(stresses)
    }

    /// The same where tractions repeat themselves with the frame, if they do.
    fn repeated(
        &self,
        pressed: PressedHalfSpace,
        bodies: [&Body; 2],
        (which, frame): (usize, &ContactFrame),
    ) -> PressedHalfSpace {
        let depth = Periodic::depths(bodies, frame)[which];
        if self.repeats { pressed.repeated(depth) } else { pressed }
    }

    /// The last cycle, if all its increments were seen: a run that goes on within it has not seen those before.
    fn whole(
        &self,
        (shift, axis): (&Shift, usize),
        bodies: [&Body; 2],
        (which, frame): (usize, &ContactFrame),
    ) -> Option<Cycle> {
        let (last, _) = self.cycle.back()?;
        let (begun, period) = (last - shift.period(), shift.period());
        let seen = self.cycle.iter().zip(&shift.places);
        let same = |((progress, _), place): (&(f64, VectorField), &f64)| {
            (progress - begun - place).abs() < SAME * period
        };
        let whole = self.cycle.len() == shift.places.len() && seen.into_iter().all(same);
        let instants = self.cycle.iter();
        let instants = instants.map(|(_, tractions)| {
            let pressed = PressedHalfSpace::in_contact(bodies, which, frame, tractions)?;
            Some(self.repeated(pressed, bodies, (which, frame)))
        });
        let cycle = |instants| Cycle::of(instants, axis);
        whole.then(|| instants.collect::<Option<Vec<_>>>().map(cycle)).flatten()
    }

    /// Adds the damage of a cycle at its end.
    fn tire(&mut self, report: &Report<'_>, shift: &Shift) {
        let problem = report.problem;
        let cycles = report.state.progress / shift.period();
        if cycles < 0.5 || (cycles - cycles.round()).abs() > SAME {
            return;
        }
        let (bodies, axis) = (problem.bodies.each_ref(), problem.motion.direction.axis);
        for which in 0..2 {
            let wanted = self.stresses[which].as_ref().filter(|own| own.damage.is_some());
            let Some(wanted) = wanted else { continue };
            let cycle = self.whole((shift, axis), bodies, (which, &problem.frame));
            let passed = (cycles.round(), &*report.state.worn(which));
            self.tired[which].pass((bodies[which], wanted), cycle.as_ref(), passed);
        }
    }

    /// Displacements and tractions all over a body under tractions of contact.
    fn solve(
        &self,
        finite: &Finite,
        material: &Material,
        job: &Job<'_>,
        acting: &[f64],
    ) -> Result<Boundary, SolveError> {
        let Some(store) = &self.store else { return elastic::solve(finite, material, job, acting) };
        let responses = store.respond(finite, material, job)?;
        Ok(responses.boundary((job.surface, job.conditions), material, acting))
    }
}

impl Observer for Inside {
    fn observe(&mut self, report: &Report<'_>) -> Result<(), Box<dyn StdError + Send + Sync>> {
        if (0..2).any(|which| self.wants(which)) {
            let now = &report.problem.frame;
            let same = |known: &ContactFrame| {
                (known.elements(), known.rectangle()) == (now.elements(), now.rectangle())
            };
            if !self.frame.as_ref().is_some_and(same) {
                self.frame = Some(now.clone());
                self.cycle.clear();
                self.tired.iter_mut().for_each(Tired::moved);
            }
            let tractions = report.problem.tractions(report.state);
            let tires = |one: &Option<WantedStresses>| {
                one.as_ref().is_some_and(|wanted| wanted.fatigue.is_wanted())
            };
            let shift = report.problem.motion.increments();
            if let Some(shift) = shift.filter(|_| !report.again && self.stresses.iter().any(tires))
            {
                self.cycle.push_back((report.state.progress, tractions.clone()));
                while self.cycle.len() > shift.cycle.len() {
                    self.cycle.pop_front();
                }
                self.tire(report, shift);
            }
            self.last = Some((tractions, [0, 1].map(|body| report.state.worn(body).into_owned())));
        }
        Ok(())
    }
}
