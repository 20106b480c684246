//! A cylinder that touches with its end: rings go from the rim of the zone to the edge, down the side
//! and back to the middle of the bottom.

use std::f64::consts::{FRAC_PI_8, PI};

use super::Standing;
use crate::body::mesh::axis::{Axis, places};
use crate::body::mesh::builder::Builder;
use crate::body::mesh::rings::{Ray, Rings, distance};
use crate::body::mesh::tensor::patch;
use crate::body::mesh::{ContactMesh, Zone};

impl Standing {
    pub(super) fn divide(&self, mirrored: [bool; 2], longest: [f64; 2]) -> ContactMesh {
        let mut builder = Builder::new(self.radius.max(self.length));
        let top = builder.surface("top");
        let growth = self.contact.growth(f64::INFINITY);
        let [x, y] = [0, 1].map(|axis| {
            let length = self.contact.size[axis];
            Axis::graded(self.contact.middle(axis), length, growth, mirrored[axis])
        });
        patch(&mut builder, top, [&x.places, &y.places], |x, y| [x, y, 0.0]);
        let (rays, pinned) = Ray::around(&x, &y, mirrored);
        let rim =
            rays.iter().map(|ray| builder.vertex([ray.start[0], ray.start[1], 0.0])).collect();
        let mut rings = Rings::new(&mut builder, top, rim, pinned);
        let last = self.across(&mut rings, &rays, longest[0]);
        rings.surface = rings.builder.surface("side");
        let last = self.down(&mut rings, &rays, [last, longest[1]]);
        rings.surface = rings.builder.surface("bottom");
        self.inwards(rings, &rays, [last, longest[0]]);
        let [nx, ny] = self.contact.kept(mirrored);
        let zone = Zone { faces: (0..nx * ny).collect(), grid: Some([nx, ny]) };
        ContactMesh { mesh: builder.finish(), zone, placed: false, ..ContactMesh::default() }
    }

    /// From the rim of the zone to the edge; returns the width of the last ring (m).
    fn across(&self, rings: &mut Rings<'_>, rays: &[Ray], longest: f64) -> f64 {
        let edge = |ray: Ray| ray.direction.map(|component| component * self.radius);
        let way = rays.iter().map(|&ray| distance(ray.start, edge(ray))).fold(0.0, f64::max);
        let widths = self.contact.growth(longest).beside(self.contact.width(), way);
        for (width, along) in widths.iter().zip(&places(&widths, way)[1..]) {
            let t = along / way;
            let place = |ray: usize| {
                let (start, end) = (rays[ray].start, edge(rays[ray]));
                let [x, y] = [0, 1].map(|i| (1.0 - t) * start[i] + t * end[i]);
                [x, y, 0.0]
            };
            rings.advance(place, |a, b| {
                distance(place(a), place(b)) <= 1.2 * width && rays[a].within(rays[b], FRAC_PI_8)
            });
        }
        widths[widths.len() - 1]
    }

    /// From the edge of the top to that of the bottom.
    fn down(&self, rings: &mut Rings<'_>, rays: &[Ray], [last, longest]: [f64; 2]) -> f64 {
        let growth = self.contact.growth(longest.min(0.5 * PI * self.radius));
        let widths = growth.from(last / self.contact.growth, self.length);
        for (width, depth) in widths.iter().zip(&places(&widths, self.length)[1..]) {
            let place = |ray: usize| {
                let [x, y] = rays[ray].direction.map(|component| component * self.radius);
                [x, y, -depth]
            };
            rings.advance(place, |a, b| {
                distance(place(a), place(b)) <= 1.2 * width && rays[a].within(rays[b], FRAC_PI_8)
            });
        }
        widths[widths.len() - 1]
    }

    /// From the edge of the bottom to its middle.
    fn inwards(&self, mut rings: Rings<'_>, rays: &[Ray], [last, longest]: [f64; 2]) {
        let growth = self.contact.growth(longest.min(0.5 * self.radius));
        let widths = growth.from(last / self.contact.growth, self.radius);
        let steps = places(&widths, self.radius);
        for (width, step) in widths.iter().zip(&steps[1..steps.len() - 1]) {
            let place = |ray: usize| {
                let [x, y] = rays[ray].direction.map(|component| component * (self.radius - step));
                [x, y, -self.length]
            };
            rings.advance(place, |a, b| distance(place(a), place(b)) <= 1.2 * width);
        }
        rings.close([0.0, 0.0, -self.length]);
    }
}
