//! What can be said on paper of a problem: its contact, its friction and its wear after closed forms.
//!
//! An [`Estimate`] starts from the bodies, the frame's size, the friction law and the motion (a [`Subject`]), and from
//! what is prescribed (a [`Course`]). It does not look at pressures that were computed, so that it can be told before a
//! run and be held against its result. All of it is about smooth bodies with known curvatures ([`Body::curvatures`]).

mod conforming;
mod heat;
mod laws;
mod rolling;
mod shifted;
mod sliding;
mod track;

use std::cell::OnceCell;

pub use conforming::ConformingEdge;
pub use heat::Warmth;
pub use rolling::{RollingEstimate, Saturation, Track};
pub use shifted::{Fretting, FrettingWear, SphereWithFriction};
pub use sliding::WornCap;
pub use track::OnTrack;

use crate::body::{Body, Material, contact_modulus};
use crate::closed_form::hertz::{Hertz, Line};
use crate::closed_form::spence::{Indentation, coupling};
use crate::friction::Friction;
use crate::motion::{Control, Motion};
use crate::problem::ContactProblem;

/// How little Dundurs' constant has to be for bodies to count as equal, and in rolling the creepage it is worth.
///
/// At 0.009 spheres that fret as in the case `cattaneo_mindlin`, or with a fifth of its amplitude, lose 0.2 % more
/// energy at most and stick on 1 % less; at 0.05 they lose 4 % more.
const ALIKE: f64 = 0.01;

/// What closed forms look at: a problem without its pairs and how they deform.
#[derive(Debug, Clone, Copy)]
pub struct Subject<'a> {
    /// The bodies; body 1 first.
    pub bodies: &'a [Body; 2],
    /// Size of the frame along x and y (m).
    pub size: [f64; 2],
    /// Whether the bodies touch along a line in plane strain.
    pub line: bool,
    /// Whether surfaces end or repeat themselves with the frame.
    pub closed: bool,
    /// How much tangential traction the pairs bear; `None` without friction.
    pub friction: Option<&'a dyn Friction>,
    /// How the pairs rub.
    pub motion: &'a Motion,
}

/// What a problem is put through, up to some moment.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Course {
    /// The load or approach prescribed.
    pub control: Control,
    /// How far the motion has gone (its own unit).
    pub progress: f64,
    /// Integral of the load over the distance slid (N m); `None` where the load is not known before.
    pub load_distance: Option<f64>,
}

/// What closed forms say of a problem; `None` where none exists.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Estimate {
    /// Curvatures of both bodies together along x and y (1/m).
    pub curvatures: Option<[f64; 2]>,
    /// Contact modulus E* (Pa).
    pub contact_modulus: f64,
    /// The contact of the unworn bodies.
    pub contact: Option<Contact>,
    /// The scar of bodies that slide.
    pub cap: Option<WornCap>,
    /// Scar and groove of bodies that slide on a track.
    pub track: Option<OnTrack>,
    /// Creep forces, stick and wear of bodies that roll.
    pub rolled: Option<RollingEstimate>,
    /// How warm the contact of surfaces that stream through it gets.
    pub warmth: Option<Warmth>,
    /// Partial slip of a sphere that is shifted to and fro, and its wear.
    pub fretting: Option<Fretting>,
    /// The stick zone of a sphere that is pressed on a body of other elasticity.
    pub pressed: Option<SphereWithFriction>,
}

/// The contact of the unworn bodies after Hertz.
#[non_exhaustive]
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Half of its extent along x and y (m); infinite along the line where cylinders touch.
    pub semi_axes: [f64; 2],
    /// Pressure at its centre (Pa).
    pub peak_pressure: f64,
    /// Approach of the bodies (m); none for a line contact.
    pub approach: Option<f64>,
    /// Normal force (N).
    pub load: f64,
}

/// Estimates of one problem at different moments; what is the same at all of them is found once.
#[derive(Debug, Default)]
pub struct Estimator {
    /// Spence's sphere, which takes long to find.
    spence: OnceCell<Option<Indentation>>,
}

impl Estimator {
    /// What closed forms say of a subject at some moment.
    pub fn of(&self, subject: &Subject<'_>, course: &Course) -> Estimate {
        let contact = subject.contact(course.control);
        let rolled = contact.and_then(|contact| RollingEstimate::of(subject, course, contact));
        Estimate {
            curvatures: subject.curvatures(),
            contact_modulus: subject.contact_modulus(),
            contact,
            cap: WornCap::of(subject, course),
            track: OnTrack::of(subject, course),
            rolled,
            warmth: contact.and_then(|contact| Warmth::of(subject, course, (contact, rolled))),
            fretting: Fretting::of(subject, course),
            pressed: SphereWithFriction::of(subject, course.control, &self.spence),
        }
    }
}

impl Estimate {
    /// Half of the extent (m) of the worn contact along x and y: the scar and the elastic contact, added in squares.
    pub fn reach(&self) -> Option<[f64; 2]> {
        let contact = self.contact?;
        let rolled = self.rolled.and_then(|rolled| Some(rolled.track?.semi_axes));
        let track = self.track.map(|track| track.semi_axes());
        let scar = self.cap.map(|cap| cap.semi_axes).or(track).or(rolled).unwrap_or([0.0; 2]);
        Some([0, 1].map(|axis| contact.semi_axes[axis].hypot(scar[axis])))
    }
}

impl<'a> From<&'a ContactProblem> for Subject<'a> {
    fn from(problem: &'a ContactProblem) -> Self {
        Self {
            bodies: &problem.bodies,
            size: problem.frame.size(),
            line: problem.frame.is_line(),
            closed: problem.frame.measure().closed,
            friction: problem.friction.as_deref(),
            motion: &problem.motion,
        }
    }
}

impl Subject<'_> {
    /// Curvatures of both bodies together along x and y (1/m), where both have them and closed forms know them: not under
    /// layers, nor where surfaces repeat themselves.
    pub fn curvatures(&self) -> Option<[f64; 2]> {
        if self.closed || self.bodies.iter().any(|body| !body.layers.is_empty()) {
            return None;
        }
        let [Some(one), Some(other)] = self.bodies.each_ref().map(Body::curvatures) else {
            return None;
        };
        Some([one[0] + other[0], one[1] + other[1]])
    }

    /// Contact modulus E* (Pa).
    pub fn contact_modulus(&self) -> f64 {
        contact_modulus(self.materials())
    }

    /// Dundurs' constant beta; zero for bodies of one elasticity.
    pub fn dundurs_beta(&self) -> f64 {
        coupling(self.materials())
    }

    /// The contact of the unworn bodies under a load or at an approach; `None` where there is no closed form, or bodies yield.
    pub fn contact(&self, control: Control) -> Option<Contact> {
        let hardness = Body::softest(self.bodies);
        self.elastic_contact(control).filter(|contact| contact.peak_pressure <= hardness)
    }

    /// The same of bodies that stay elastic.
    fn elastic_contact(&self, control: Control) -> Option<Contact> {
        let (curvatures, modulus) = (self.curvatures()?, self.contact_modulus());
        if self.line {
            return self.line(control, curvatures, modulus);
        }
        let hertz = match control {
            Control::Load(load) => Hertz::from_load(curvatures, modulus, load),
            Control::Approach(approach) => Hertz::from_approach(curvatures, modulus, approach),
        };
        hertz.map(Contact::from).or_else(|| self.line(control, curvatures, modulus))
    }

    /// Cylinders that touch along a line as long as the frame.
    fn line(&self, control: Control, curvatures: [f64; 2], modulus: f64) -> Option<Contact> {
        let across = match curvatures {
            [x, 0.0] if x > 0.0 => 0,
            [0.0, y] if y > 0.0 => 1,
            _ => return None,
        };
        let under =
            |load: f64| Line::from_load(curvatures[across], modulus, load / self.size[1 - across]);
        let load = match control {
            Control::Load(load) => load,
            Control::Approach(approach) => self.load_of_a_line(approach, under)?,
        };
        let line = under(load)?;
        let mut semi_axes = [f64::INFINITY; 2];
        semi_axes[across] = line.half_width;
        let approach = self.approach_of_a_line(&line);
        Some(Contact { semi_axes, peak_pressure: line.peak_pressure, approach, load })
    }

    /// The approach (m) of bodies that touch along a line, known in plane strain.
    fn approach_of_a_line(&self, line: &Line) -> Option<f64> {
        let depths = Body::depths(self.bodies.each_ref(), self.size[0]);
        let both = self.materials().into_iter().zip(depths);
        let sinking =
            both.filter_map(|(material, depth)| Some(line.sinking(material?, depth))).sum();
        self.line.then_some(sinking)
    }

    /// The load (N) of bodies that touch along a line at an approach (m), by bisection.
    fn load_of_a_line(&self, approach: f64, under: impl Fn(f64) -> Option<Line>) -> Option<f64> {
        let beyond = |load: f64| Some(self.approach_of_a_line(&under(load)?)? > approach);
        // As far as the contact is narrow against the depth, the approach grows with the load.
        let (mut low, mut high) = (0.0, self.contact_modulus() * approach * self.size[1]);
        for _ in 0..100 {
            let middle = 0.5 * (low + high);
            if beyond(middle)? { high = middle } else { low = middle }
        }
        beyond(1.1 * low)?.then_some(low)
    }

    /// The combined radius (m) of a sphere.
    fn radius(&self) -> Option<f64> {
        let [along_x, along_y] = self.curvatures()?;
        let spherical = along_x > 0.0 && (along_x - along_y).abs() <= 1e-9 * along_x;
        spherical.then(|| 1.0 / along_x)
    }

    fn materials(&self) -> [Option<&Material>; 2] {
        self.bodies.each_ref().map(Body::uppermost)
    }
}

impl From<Hertz> for Contact {
    fn from(Hertz { semi_axes, peak_pressure, approach, load }: Hertz) -> Self {
        Self { semi_axes, peak_pressure, approach: Some(approach), load }
    }
}
