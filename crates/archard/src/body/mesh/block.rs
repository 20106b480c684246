//! A rectangular block, touching with the middle of its top.

use super::axis::{Axis, places};
use super::builder::Builder;
use super::contact::{self, Contact, Layout};
use super::tensor::{self, SIDES};
use super::{MeshError, Meshed, Shape, Zone};
use crate::parameters::{Choice, Invalid, Parameter, Quantity};

pub(super) const CHOICE: Choice<Box<dyn Shape>> = Choice {
    name: "box",
    meaning: "a rectangular block; its sides are top, bottom, left, right, front and back",
    parameters: &[
        Parameter::required(
            "size",
            Quantity::Triple(&Quantity::Length),
            "lengths along x, y and z",
        ),
        contact::parameter(&[
            Parameter::optional("face", Quantity::Word(&["top"]), "the side that touches: top"),
            contact::SIZE,
            contact::ELEMENTS,
            contact::GROWTH,
        ]),
        contact::DIVISIONS,
    ],
    build: |values| {
        let size = values.triple("size").ok_or_else(|| Invalid::new("size", "is missing"))?;
        let layout = Layout::read(values, [size[0], size[1]])?;
        Ok(Box::new(Block { size, layout }))
    },
};

/// A block below z = 0, its top centred on the origin.
#[derive(Debug)]
struct Block {
    /// Lengths along x, y and z (m).
    size: [f64; 3],
    layout: Layout,
}

impl Shape for Block {
    fn mesh(&self, mirrored: [bool; 2]) -> Result<Meshed, MeshError> {
        self.layout.check(mirrored)?;
        let [x, y, depths] = match self.layout {
            Layout::Contact(contact) => self.graded(&contact, mirrored),
            Layout::Even(count) => self.even(count, mirrored),
        };
        let z: Vec<f64> = depths.places.iter().rev().map(|depth| -depth).collect();
        let mut builder = Builder::new(self.size.into_iter().fold(0.0, f64::max));
        let axes = [&x.places[..], &y.places, &z];
        tensor::block(&mut builder, axes, mirrored, SIDES, |place| place);
        let zone = match self.layout {
            Layout::Contact(contact) => {
                Zone { faces: tensor::middle(0, &x, &y), grid: Some(contact.kept(mirrored)) }
            }
            Layout::Even(_) => Zone::default(),
        };
        Ok(Meshed { mesh: builder.finish(), zone, placed: false })
    }

    fn at_least(&self, mirrored: [bool; 2]) -> usize {
        // What cannot be made has no elements.
        if self.layout.check(mirrored).is_err() {
            return 0;
        }
        let axes = match self.layout {
            Layout::Contact(contact) => self.graded(&contact, mirrored),
            Layout::Even(count) => self.even(count, mirrored),
        };
        let [x, y, z] = axes.map(|axis| axis.places.len() - 1);
        let [across_x, across_y] = mirrored.map(|mirrored| if mirrored { 1 } else { 2 });
        2 * x * y + across_x * y * z + across_y * x * z
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some([0.0; 2])
    }
}

impl Block {
    /// Divisions along x and y, and downwards, that grow away from the zone.
    fn graded(&self, contact: &Contact, mirrored: [bool; 2]) -> [Axis; 3] {
        let growth = contact.growth(f64::INFINITY);
        let [x, y] = [0, 1].map(|axis| {
            Axis::graded(contact.middle(axis), self.size[axis], growth, mirrored[axis])
        });
        // Elements along the edges are narrow across the zone: the first row down is narrower than the
        // last one on top, so that neither is drawn out much.
        let first = x.last_width().min(y.last_width()) / contact.growth;
        let depths = places(&growth.from(first, self.size[2]), self.size[2]);
        [x, y, Axis { places: depths, zone: 0..0 }]
    }

    /// Equal divisions of every edge.
    fn even(&self, count: usize, mirrored: [bool; 2]) -> [Axis; 3] {
        let [x, y] = [0, 1].map(|axis| Axis::even(self.size[axis], count, mirrored[axis]));
        let depth = |k: usize| self.size[2] * k as f64 / count as f64;
        [x, y, Axis { places: (0..=count).map(depth).collect(), zone: 0..0 }]
    }
}
