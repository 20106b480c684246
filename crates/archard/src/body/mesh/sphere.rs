//! A solid or hollow sphere.
//!
//! The zone is a grid of equal angles on the gnomonic projection; rings of elements go from its rim to
//! the other pole. Without a zone the six sides of a cube are blown up to the sphere.

use std::f64::consts::{FRAC_PI_2, PI};

use super::axis::{Axis, places};
use super::builder::Builder;
use super::contact::{self, Contact, Layout};
use super::free;
use super::rings::{Ray, Rings, distance, widest_angle};
use super::tensor::{block, patch};
use super::{ContactMesh, MeshError, Shape, SupportedSurfaces, Zone};
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Shape>> = Choice {
    name: "sphere",
    meaning: "a sphere, hollow if it has an inner radius; its surfaces are outer and inner",
    parameters: &[
        Parameter::required("radius", Quantity::Length, "radius of the sphere"),
        Parameter::optional(
            "inner",
            Quantity::Length,
            "radius of the hollow; none: a solid sphere",
        ),
        contact::parameter(&[
            Parameter::optional("face", Quantity::Word(&["outer"]), "the side that touches: outer"),
            contact::SIZE,
            contact::ELEMENTS,
            contact::GROWTH,
        ]),
        contact::DIVISIONS,
    ],
    build: |values| {
        let radius = values.require("radius")?;
        let inner = values.number("inner");
        if let Some(inner) = inner
            && inner >= radius
        {
            let message = format!("must be less than the radius of {radius} m");
            return Err(Invalid::new("inner", message));
        }
        // Beyond a quarter of the circumference the projection is no longer even.
        let layout = Layout::read(values, [FRAC_PI_2 * radius; 2])?;
        let wall = 1.0 - inner.unwrap_or(0.0) / radius;
        let layout = layout.around(free::BESIDE_WALL * wall)?;
        Ok(Box::new(Sphere { radius, inner, layout }))
    },
};

/// A sphere below z = 0, its highest point at the origin.
#[derive(Debug)]
struct Sphere {
    /// Radius (m).
    radius: f64,
    /// Radius of the hollow (m).
    inner: Option<f64>,
    layout: Layout,
}

impl Shape for Sphere {
    fn mesh(
        &self,
        mirrored: [bool; 2],
        _held: &SupportedSurfaces,
    ) -> Result<ContactMesh, MeshError> {
        self.layout.check(mirrored)?;
        let mut builder = Builder::new(self.radius);
        let angle = widest_angle(self.radius, self.radius - self.inner.unwrap_or(0.0));
        let mut shell = Shell { radius: self.radius, centre: -self.radius, angle, mirrored };
        let zone = match self.layout {
            Layout::Contact(contact) => {
                shell.around(&mut builder, "outer", &contact);
                let [nx, ny] = contact.kept(mirrored);
                Zone { faces: (0..nx * ny).collect(), grid: Some([nx, ny]) }
            }
            Layout::Even(divisions) => {
                shell.even(&mut builder, "outer", divisions.of_a_quarter());
                Zone::default()
            }
        };
        if let Some(inner) = self.inner {
            let first = builder.faces();
            shell.radius = inner;
            match self.layout {
                Layout::Contact(contact) => {
                    shell.around(&mut builder, "inner", &self.below(&contact, inner));
                }
                Layout::Even(divisions) => {
                    shell.even(&mut builder, "inner", divisions.of_a_quarter());
                }
            }
            builder.turn(first);
        }
        Ok(ContactMesh { mesh: builder.finish(), zone, placed: false, ..ContactMesh::default() })
    }

    fn at_least(&self, mirrored: [bool; 2], _held: &SupportedSurfaces) -> usize {
        match self.layout {
            Layout::Contact(contact) => contact.kept(mirrored).into_iter().product(),
            Layout::Even(divisions) => {
                let count = divisions.of_a_quarter();
                let images: usize =
                    mirrored.map(|mirrored| 1 + usize::from(mirrored)).iter().product();
                6 * count * count / images
            }
        }
    }

    /// Its one or two surfaces leave no free span: what is held is one side of the wall.
    fn slenderness(&self, _: &ContactMesh, _: [bool; 2], _: &SupportedSurfaces) -> Option<f64> {
        None
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some([1.0 / self.radius; 2])
    }
}

impl Sphere {
    /// The elements of the hollow below the zone, coarser by what elements grow through the wall.
    fn below(&self, contact: &Contact, inner: f64) -> Contact {
        let size = contact.size.map(|size| size * inner / self.radius);
        let wall = self.radius - inner;
        let elements = [0, 1].map(|axis| {
            let width = contact.size[axis] / contact.elements[axis] as f64;
            let coarse = width + (contact.growth - 1.0) / contact.growth * wall;
            let pairs = (0.5 * size[axis] / coarse).ceil() as usize;
            // Rays of an eighth of a turn at most.
            (2 * pairs.max(2)).min(contact.elements[axis].max(4).next_multiple_of(2))
        });
        Contact { size, elements, growth: contact.growth }
    }
}

/// A whole spherical surface.
struct Shell {
    /// Radius (m).
    radius: f64,
    /// Height of the centre (m).
    centre: f64,
    /// The widest angle of an element (rad).
    angle: f64,
    mirrored: [bool; 2],
}

impl Shell {
    /// The place (m) in that direction from the centre.
    fn at(&self, direction: [f64; 3]) -> [f64; 3] {
        let scale = self.radius / distance(direction, [0.0; 3]);
        let [x, y, z] = direction.map(|component| component * scale);
        [x, y, z + self.centre]
    }

    /// The place (m) on the zone, from lengths along the surface (m).
    fn on_zone(&self, x: f64, y: f64) -> [f64; 3] {
        self.at([(x / self.radius).tan(), (y / self.radius).tan(), 1.0])
    }

    /// Equal elements, `count` along a quarter of the circumference.
    fn even(&self, builder: &mut Builder, name: &str, count: usize) {
        let [x, y] = self.mirrored.map(|mirrored| Axis::even(FRAC_PI_2, count, mirrored));
        let z = Axis::even(FRAC_PI_2, count, false);
        let angles = [&x.places[..], &y.places, &z.places];
        let of = |shell: &Self, builder: &mut Builder| {
            let at = |angles: [f64; 3]| shell.at(angles.map(f64::tan));
            block(builder, angles, self.mirrored, [name; 6], at);
        };
        // Elements with their vertices on the sphere would enclose less: eight around it 15 %.
        let mut inscribed = Builder::new(self.radius);
        of(self, &mut inscribed);
        let enclosed = inscribed.finish().volume(self.mirrored);
        let radius = self.radius * (4.0 / 3.0 * PI * self.radius.powi(3) / enclosed).cbrt();
        of(&Self { radius, ..*self }, builder);
    }

    /// The grid of the zone, then rings down to the other pole.
    fn around(&self, builder: &mut Builder, name: &str, contact: &Contact) {
        let surface = builder.surface(name);
        let growth = contact.growth(self.angle * self.radius);
        let [x, y] = [0, 1].map(|axis| {
            let length = contact.size[axis];
            Axis::graded(contact.middle(axis), length, growth, self.mirrored[axis])
        });
        patch(builder, surface, [&x.places, &y.places], |x, y| self.on_zone(x, y));
        let (rays, pinned) = Ray::around(&x, &y, self.mirrored);
        let rim: Vec<[f64; 3]> =
            rays.iter().map(|ray| self.on_zone(ray.start[0], ray.start[1])).collect();
        let vertices = rim.iter().map(|&place| builder.vertex(place)).collect();
        let paths: Vec<Path> =
            rays.iter().zip(&rim).map(|(ray, &rim)| self.path(*ray, rim)).collect();
        let longest = paths.iter().map(|path| PI - path.polar).fold(0.0, f64::max) * self.radius;
        let widths = growth.beside(contact.width(), longest);
        let distances = places(&widths, longest);
        let mut rings = Rings::new(builder, surface, vertices, pinned);
        for (width, along) in widths.iter().zip(&distances[1..distances.len() - 1]) {
            let t = along / longest;
            let place = |ray: usize| self.along(&paths[ray], t);
            rings.advance(place, |a, b| {
                let polar = paths[a].polar.min(paths[b].polar);
                let beyond_equator = polar + (PI - polar) * t > FRAC_PI_2;
                distance(place(a), place(b)) <= 1.2 * width
                    && (beyond_equator || rays[a].within(rays[b], self.angle))
            });
        }
        rings.close([0.0, 0.0, self.centre - self.radius]);
    }

    /// The way from a place on the rim of the zone to the other pole.
    fn path(&self, ray: Ray, [x, y, z]: [f64; 3]) -> Path {
        let across = x.hypot(y);
        Path {
            polar: across.atan2(z - self.centre),
            from: [x / across, y / across],
            to: ray.direction,
        }
    }

    /// The place (m) after that part of a path.
    fn along(&self, path: &Path, t: f64) -> [f64; 3] {
        let turned = (2.0 * t).min(1.0);
        let [x, y] = [0, 1].map(|i| path.from[i] + (path.to[i] - path.from[i]) * turned);
        let across = x.hypot(y);
        let (sin, cos) = (path.polar + (PI - path.polar) * t).sin_cos();
        self.at([sin * x / across, sin * y / across, cos])
    }
}

/// A way from the rim of the zone to the other pole.
struct Path {
    /// The angle from the pole where it starts.
    polar: f64,
    /// The azimuth where it starts, as its cosine and sine.
    from: [f64; 2],
    /// The azimuth where it ends.
    to: [f64; 2],
}
