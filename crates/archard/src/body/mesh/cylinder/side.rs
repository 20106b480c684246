//! A cylinder that touches with its side.
//!
//! Side and bore are grids. The fronts of the ends advance inwards on the image of a disc under the
//! Moebius transformation that spreads the fine elements below the zone evenly; since it keeps
//! angles, elements stay well shaped.

use std::f64::consts::{FRAC_PI_2, PI};

use super::Lying;
use crate::body::mesh::axis::{Axis, Growth, places};
use crate::body::mesh::builder::Builder;
use crate::body::mesh::contact::Layout;
use crate::body::mesh::rings::{Rings, distance, widest_angle};
use crate::body::mesh::tensor::{middle, patch};
use crate::body::mesh::{ContactMesh, Mesh, Zone};

/// Radius of a polygon with vertices at these angles (rad) relative to that of the circle of its area.
fn of_equal_area(angles: &[f64]) -> f64 {
    let widths = angles.windows(2).map(|pair| pair[1] - pair[0]);
    let (round, plane) =
        widths.fold((0.0, 0.0), |(round, plane), width| (round + width, plane + width.sin()));
    f64::sqrt(round / plane)
}

/// Places along the circumference, as angles from the highest line.
struct Turn {
    angles: Vec<f64>,
    /// Whether fronts may not leave them out.
    pinned: Vec<bool>,
    /// How much wider the angles of the undistorted disc are near the top.
    spread: f64,
}

impl Lying {
    pub(super) fn divide(&self, mirrored: [bool; 2], longest: f64) -> ContactMesh {
        let [arcs, along] = self.axes(mirrored, longest);
        let mut builder = Builder::new(self.radius.max(self.length));
        let angles: Vec<f64> = arcs.places.iter().map(|arc| arc / self.radius).collect();
        let side = builder.surface("side");
        let at = |radius: f64, angle: f64, y: f64| self.at(radius, angle, y);
        patch(&mut builder, side, [&angles, &along.places], |angle, y| at(self.radius, angle, y));
        let turn = self.turn(&arcs, angles);
        let ends = [along.places[0], along.places[along.places.len() - 1]];
        let mut bore = turn.angles.clone();
        for (name, y) in ["front", "back"].into_iter().zip(ends) {
            if name == "front" && mirrored[1] {
                continue;
            }
            let first = builder.faces();
            let surface = builder.surface(name);
            let vertices =
                turn.angles.iter().map(|&angle| builder.vertex(at(self.radius, angle, y)));
            let vertices = vertices.collect();
            let rings = Rings::new(&mut builder, surface, vertices, turn.pinned.clone());
            match self.bore {
                None => self.disc(rings, &turn, y),
                Some(radius) => bore = self.annulus(rings, &turn, along.last_width(), [radius, y]),
            }
            if name == "back" {
                builder.turn(first);
            }
        }
        if let Some(radius) = self.bore {
            let first = builder.faces();
            let surface = builder.surface("bore");
            patch(&mut builder, surface, [&bore, &along.places], |angle, y| at(radius, angle, y));
            builder.turn(first);
        }
        let zone = match self.layout {
            Layout::Contact(contact) => {
                Zone { faces: middle(0, &arcs, &along), grid: Some(contact.kept(mirrored)) }
            }
            Layout::Even(_) => Zone::default(),
        };
        let mut mesh = builder.finish();
        if let Layout::Even(_) = self.layout {
            self.round_out(&mut mesh, [&turn.angles, &bore]);
        }
        ContactMesh { mesh, zone, placed: false, ..ContactMesh::default() }
    }

    /// Moves vertices away from the axis until the sections within side and bore, polygons with these angles, have the
    /// areas of the circles: with their vertices on the circles tubes of 8 and 16 elements around bend 9 and 2 % too far.
    fn round_out(&self, mesh: &mut Mesh, [side, bore]: [&[f64]; 2]) {
        let [outer, inner] = [side, bore].map(of_equal_area);
        let start = self.bore.unwrap_or(0.0);
        for [x, _, z] in &mut mesh.vertices {
            let radius = x.hypot(*z + self.radius);
            let through = (radius - start) / (self.radius - start);
            let scale = if self.bore.is_some() { inner + through * (outer - inner) } else { outer };
            *x *= scale;
            *z = scale * (*z + self.radius) - self.radius;
        }
    }

    /// The place (m) at a distance (m) from the axis, an angle from the top and a place along it (m).
    fn at(&self, radius: f64, angle: f64, y: f64) -> [f64; 3] {
        [radius * angle.sin(), y, radius * angle.cos() - self.radius]
    }

    /// The widest angle of an element (rad).
    fn angle(&self) -> f64 {
        widest_angle(self.radius, self.radius - self.bore.unwrap_or(0.0))
    }

    /// Divisions of the circumference and along the axis, no element longer than bending allows (m).
    pub(super) fn axes(&self, mirrored: [bool; 2], longest: f64) -> [Axis; 2] {
        let around = 2.0 * PI * self.radius;
        match self.layout {
            Layout::Contact(contact) => {
                let widest = self.angle() * self.radius;
                let free = contact.growth(longest);
                [
                    Axis::graded(contact.middle(0), around, contact.growth(widest), mirrored[0]),
                    Axis::graded(contact.middle(1), self.length, free, mirrored[1]),
                ]
            }
            Layout::Even(divisions) => {
                let count = divisions.of_a_quarter();
                let around_each = FRAC_PI_2 * self.radius / count as f64;
                let width = around_each.min(longest);
                // Beyond a hundred thousand the length has no share in what makes a good element.
                let pairs = (0.5 * self.length / width).round().clamp(1.0, 1e4) as usize;
                [
                    Axis::even(around, 4 * count, mirrored[0]),
                    Axis::even(self.length, 2 * pairs, mirrored[1]),
                ]
            }
        }
    }

    fn turn(&self, arcs: &Axis, angles: Vec<f64>) -> Turn {
        let count = angles.len() - 1;
        let (pinned, spread) = match self.layout {
            Layout::Contact(_) => {
                let zone = &arcs.zone;
                let pinned = (0..=count)
                    .map(|i| [0, zone.start, zone.end, count].contains(&i) || angles[i] == 0.0);
                // The transformation stretches the top so much and shrinks the other side as much.
                let widths = angles.windows(2).map(|pair| pair[1] - pair[0]);
                let (least, most) = widths
                    .fold((f64::INFINITY, 0.0_f64), |(least, most), width| {
                        (least.min(width), most.max(width))
                    });
                (pinned.collect(), (most / least).sqrt())
            }
            Layout::Even(divisions) => {
                let quarter = divisions.of_a_quarter();
                ((0..=count).map(|i| i % quarter == 0).collect(), 1.0)
            }
        };
        Turn { angles, pinned, spread }
    }

    /// Fills an end as a disc.
    fn disc(&self, mut rings: Rings<'_>, turn: &Turn, y: f64) {
        let spread: Vec<f64> = turn
            .angles
            .iter()
            .map(|angle| 2.0 * (turn.spread * (0.5 * angle).tan()).atan())
            .collect();
        let count = spread.len() - 1;
        let width = (spread[count] - spread[0]) / count as f64;
        let growth = match self.layout {
            // The other half of the growth is the transformation's.
            Layout::Contact(contact) => {
                Growth { ratio: contact.growth.sqrt(), widest: f64::INFINITY }
            }
            Layout::Even(_) => Growth { ratio: 1.5, widest: 1.3 * width },
        };
        let widths = growth.from(width, 1.0);
        let steps = places(&widths, 1.0);
        for (width, step) in widths.iter().zip(&steps[1..steps.len() - 1]) {
            let flat = |ray: usize| {
                let (sin, cos) = spread[ray].sin_cos();
                [(1.0 - step) * cos, (1.0 - step) * sin]
            };
            let place = |ray: usize| self.moebius(turn.spread, flat(ray), y);
            rings.advance(place, |a, b| distance(flat(a), flat(b)) <= 1.2 * width);
        }
        rings.close(self.moebius(turn.spread, [0.0, 0.0], y));
    }

    /// The place (m) on an end whose image, with the top spread so much, is there on the unit disc
    /// (upwards, sideways).
    fn moebius(&self, spread: f64, [up, across]: [f64; 2], y: f64) -> [f64; 3] {
        let c = (spread - 1.0) / (spread + 1.0);
        // (w + c) / (1 + c w) in real numbers.
        let (a, b) = (up + c, across);
        let (d, e) = (1.0 + c * up, c * across);
        let scale = self.radius / (d * d + e * e);
        [(b * d - a * e) * scale, y, (a * d + b * e) * scale - self.radius]
    }

    /// Fills an end as an annulus; returns the angles its inner edge has.
    fn annulus(
        &self,
        mut rings: Rings<'_>,
        turn: &Turn,
        beside: f64,
        [bore, y]: [f64; 2],
    ) -> Vec<f64> {
        let wall = self.radius - bore;
        let widths = match self.layout {
            Layout::Contact(contact) => {
                contact.growth(f64::INFINITY).from(beside / contact.growth, wall)
            }
            Layout::Even(_) => {
                let count = (wall / beside).round().clamp(1.0, 1e4);
                vec![wall / count; count as usize]
            }
        };
        for (width, step) in widths.iter().zip(&places(&widths, wall)[1..]) {
            let radius = if *step == wall { bore } else { self.radius - step };
            let place = |ray: usize| self.at(radius, turn.angles[ray], y);
            rings.advance(place, |a, b| {
                distance(place(a), place(b)) <= 1.2 * width
                    && (turn.angles[b] - turn.angles[a]).abs() <= 1.02 * self.angle()
            });
        }
        rings.rays().iter().map(|&ray| turn.angles[ray]).collect()
    }
}
