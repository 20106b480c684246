//! Meshes of quadrilaterals.

use std::f64::consts::FRAC_PI_4;

use archard::body::mesh::{Corners, Face, Mesh};
use glam::DVec3;

/// A mesh on the way, its vertices merged.
#[derive(Default)]
struct Builder(Mesh);

impl Builder {
    /// Adds `nx` by `ny` elements to a surface at places `at(i, j)`, seen from outside with i to the right
    /// and j upwards.
    fn grid(&mut self, surface: usize, [nx, ny]: [usize; 2], at: impl Fn(usize, usize) -> DVec3) {
        for j in 0..ny {
            for i in 0..nx {
                let corners = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]];
                let corners = corners.map(|[i, j]| self.vertex(at(i, j)));
                self.0.faces.push(Face { corners: Corners::Quad(corners), surface });
            }
        }
    }

    fn vertex(&mut self, place: DVec3) -> usize {
        let vertices = &mut self.0.vertices;
        let known = vertices.iter().position(|known| place.distance((*known).into()) < 1e-9);
        known.unwrap_or_else(|| {
            vertices.push(place.to_array());
            vertices.len() - 1
        })
    }

    fn finish(self, surfaces: &[&str]) -> Mesh {
        let mesh = self.0;
        Mesh { surfaces: surfaces.iter().map(ToString::to_string).collect(), ..mesh }
    }
}

/// A box from one corner to the opposite one, with that many elements along x, y and z.
///
/// Its surfaces are 0 and 1 across x, 2 and 3 across y, 4 and 5 across z; those of `open` are left out.
pub fn cuboid([low, high]: [DVec3; 2], elements: [usize; 3], open: &[usize]) -> Mesh {
    let mut builder = Builder::default();
    for surface in (0..6).filter(|surface| !open.contains(surface)) {
        let axis = surface / 2;
        let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
        // Seen from outside at the low end the axes change places.
        let (first, second) = if surface % 2 == 1 { (first, second) } else { (second, first) };
        builder.grid(surface, [elements[first], elements[second]], |i, j| {
            let mut share = DVec3::ZERO;
            share[axis] = (surface % 2) as f64;
            share[first] = i as f64 / elements[first] as f64;
            share[second] = j as f64 / elements[second] as f64;
            low + share * (high - low)
        });
    }
    builder.finish(&["left", "right", "front", "back", "bottom", "top"])
}

/// Places from one radius to another, in a geometric series.
fn radius([inside, outside]: [f64; 2], layers: usize, layer: usize) -> f64 {
    inside * (outside / inside).powf(layer as f64 / layers as f64)
}

/// The part of a hollow sphere at positive x, y and z, open on x = 0 and y = 0, with `n` elements an eighth of a
/// turn and that many layers: surfaces inside (0), outside (1) and z = 0 (2).
pub fn hollow_sphere(radii: [f64; 2], n: usize, layers: usize) -> Mesh {
    let angle = |i: usize| FRAC_PI_4 * i as f64 / n as f64;
    let mut builder = Builder::default();
    for (surface, radius) in radii.into_iter().enumerate() {
        for axis in 0..3 {
            builder.grid(surface, [n, n], |i, j| {
                let (i, j) = if surface == 1 { (i, j) } else { (j, i) };
                let mut direction = DVec3::ZERO;
                direction[axis] = 1.0;
                direction[(axis + 1) % 3] = angle(i).tan();
                direction[(axis + 2) % 3] = angle(j).tan();
                radius * direction.normalize()
            });
        }
    }
    builder.grid(2, [layers, 2 * n], |layer, i| {
        let (sin, cos) = angle(2 * n - i).sin_cos();
        radius(radii, layers, layer) * DVec3::new(cos, sin, 0.0)
    });
    builder.finish(&["inside", "outside", "z0"])
}

/// The part of a hollow cylinder at positive x and y, open on x = 0 and y = 0, between z = 0 and z = 1, with `n`
/// elements a quarter of a turn and half as many layers: surfaces inside (0), outside (1), z = 0 (2) and
/// z = 1 (3).
pub fn hollow_cylinder(radii: [f64; 2], n: usize) -> Mesh {
    let at = |radius: f64, i: usize, z: f64| {
        let (sin, cos) = (2.0 * FRAC_PI_4 * i as f64 / n as f64).sin_cos();
        DVec3::new(radius * cos, radius * sin, z)
    };
    let mut builder = Builder::default();
    builder.grid(0, [n, 1], |i, z| at(radii[0], n - i, z as f64));
    builder.grid(1, [n, 1], |i, z| at(radii[1], i, z as f64));
    let layers = n / 2;
    builder.grid(2, [n, layers], |i, layer| at(radius(radii, layers, layer), i, 0.0));
    builder.grid(3, [n, layers], |i, layer| at(radius(radii, layers, layer), n - i, 1.0));
    builder.finish(&["inside", "outside", "z0", "z1"])
}
