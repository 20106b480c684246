//! A rectangular block, touching with the middle of its top.

use super::axis::{Axis, Fading, places};
use super::builder::Builder;
use super::contact::{self, Contact, Divisions, ENOUGH, Layout, MOST_ELEMENTS};
use super::free::{self, SupportedSurfaces};
use super::tensor::{self, SIDES};
use super::{ContactMesh, MeshError, Shape, Zone};
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
        contact::DIVISIONS_OF_EDGES,
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

/// The sides across each axis.
const ACROSS: [[&str; 2]; 3] = [["left", "right"], ["front", "back"], ["bottom", "top"]];
/// Elements beyond which the default mesh is as coarse as bending allows.
const MANY: usize = 1000;
/// Width of coarse elements over the distance from the zone. A choice of cost: what half of it changes is the stated error of an image
/// field, and halving it once more takes 64 times as long.
const SHARE: f64 = 0.8;

impl Shape for Block {
    fn mesh(
        &self,
        mirrored: [bool; 2],
        held: &SupportedSurfaces,
    ) -> Result<ContactMesh, MeshError> {
        self.check(mirrored, held)?;
        let [x, y, depths] = self.axes(mirrored, held);
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
        Ok(ContactMesh { mesh: builder.finish(), zone, placed: false, ..ContactMesh::default() })
    }

    fn at_least(&self, mirrored: [bool; 2], held: &SupportedSurfaces) -> usize {
        // What cannot be made has no elements.
        if self.check(mirrored, held).is_err() {
            return 0;
        }
        elements(self.axes(mirrored, held).map(|axis| axis.places.len() - 1), mirrored)
    }

    fn slenderness(
        &self,
        _: &ContactMesh,
        mirrored: [bool; 2],
        held: &SupportedSurfaces,
    ) -> Option<f64> {
        let widths = self.axes(mirrored, held).map(|axis| axis.widest());
        let beside = |axis: usize| {
            let along = (0..3).filter(|&other| other != axis).map(|other| widths[other]);
            along.fold(0.0, f64::max) / self.size[axis]
        };
        (0..3).filter(|&axis| self.bends(axis, held)).map(beside).reduce(f64::max)
    }

    fn coarse(
        &self,
        rectangle: Option<[[f64; 2]; 2]>,
        mirrored: [bool; 2],
        held: &SupportedSurfaces,
    ) -> Option<ContactMesh> {
        let [centre, size] = rectangle.unwrap_or_default();
        let size = [0, 1].map(|axis| 2.0 * centre[axis].abs() + size[axis]);
        let [beside_x, beside_y] = [0, 1].map(|axis| 0.5 * (self.size[axis] - size[axis]));
        if beside_x <= 0.0 || beside_y <= 0.0 {
            return None;
        }
        let distances =
            [beside_y.min(self.size[2]), beside_x.min(self.size[2]), beside_x.min(beside_y)];
        // Half as long, elements bend as they have to.
        let longest = self.longest(held).map(|longest| 2.0 * longest);
        let field = |axis: usize, middle: f64| Fading {
            middle: 0.5 * middle,
            distance: distances[axis],
            share: SHARE,
            widest: longest[axis],
        };
        let fields = [field(0, size[0]), field(1, size[1]), field(2, 0.0)];
        let [along, across] =
            [0, 1].map(|axis| fields[axis].count(self.size[axis], mirrored[axis]));
        let down = fields[2].count(2.0 * self.size[2], true);
        // Edges so close are as good as those of the rectangle.
        if along * across + (along + across) * down > MOST_ELEMENTS as f64 {
            return None;
        }
        let [x, y] = [0, 1].map(|axis| Axis::fading(self.size[axis], fields[axis], mirrored[axis]));
        let depths = Axis::fading_from_zero(self.size[2], fields[2]);
        let z: Vec<f64> = depths.places.iter().rev().map(|depth| -depth).collect();
        let mut builder = Builder::new(self.size.into_iter().fold(0.0, f64::max));
        let axes = [&x.places[..], &y.places, &z];
        tensor::block(&mut builder, axes, mirrored, SIDES, |place| place);
        Some(ContactMesh { mesh: builder.finish(), placed: false, ..ContactMesh::default() })
    }

    fn curvatures(&self) -> Option<[f64; 2]> {
        Some([0.0; 2])
    }
}

/// Elements on the sides of a block that keeps so many along x, y and z.
fn elements([x, y, z]: [usize; 3], mirrored: [bool; 2]) -> usize {
    let [across_x, across_y] = mirrored.map(|mirrored| if mirrored { 1 } else { 2 });
    2 * x * y + across_x * y * z + across_y * x * z
}

impl Block {
    /// An error where a plane of symmetry would halve elements.
    fn check(&self, mirrored: [bool; 2], held: &SupportedSurfaces) -> Result<(), MeshError> {
        let Layout::Even(Divisions::Along(count)) = self.layout else {
            return self.layout.check(mirrored);
        };
        // Edges that follow another take even numbers by themselves.
        let counted = self.counted(held).1;
        for (place, axis) in ['x', 'y'].into_iter().enumerate() {
            if mirrored[place] && counted[place] && count % 2 == 1 {
                return Err(MeshError::OddDivisions { axis, count });
            }
        }
        Ok(())
    }

    /// Divisions along x and y, and downwards.
    fn axes(&self, mirrored: [bool; 2], held: &SupportedSurfaces) -> [Axis; 3] {
        match self.layout {
            Layout::Contact(contact) => self.graded(&contact, mirrored, held),
            Layout::Even(divisions) => self.even(self.counts(divisions, mirrored, held), mirrored),
        }
    }

    /// Divisions along x and y, and downwards, that grow away from the zone.
    fn graded(
        &self,
        contact: &Contact,
        mirrored: [bool; 2],
        held: &SupportedSurfaces,
    ) -> [Axis; 3] {
        let longest = self.longest(held);
        let [x, y] = [0, 1].map(|axis| {
            let growth = contact.growth(longest[axis]);
            Axis::graded(contact.middle(axis), self.size[axis], growth, mirrored[axis])
        });
        // Elements along the edges are narrow across the zone: the first row down is narrower than the
        // last one on top, so that neither is drawn out much.
        let first = x.last_width().min(y.last_width()) / contact.growth;
        let growth = contact.growth(longest[2]);
        let depths = places(&growth.from(first, self.size[2]), self.size[2]);
        [x, y, Axis { places: depths, zone: 0..0 }]
    }

    /// The longest elements (m) along x, y and z that bending allows.
    fn longest(&self, held: &SupportedSurfaces) -> [f64; 3] {
        let mut longest = [f64::INFINITY; 3];
        for (axis, thickness) in self.size.into_iter().enumerate() {
            if !self.bends(axis, held) {
                continue;
            }
            for (other, longest) in longest.iter_mut().enumerate() {
                let of_thickness =
                    if other == axis { free::across(thickness) } else { free::longest(thickness) };
                *longest = longest.min(of_thickness);
            }
        }
        [0, 1, 2].map(|axis| longest[axis].max(free::LEAST * self.size[axis]))
    }

    /// Whether the thickness along an axis bends.
    fn bends(&self, axis: usize, held: &SupportedSurfaces) -> bool {
        !self.held_across(axis, held) && free::bends(self.size[axis], self.span(axis, held))
    }

    /// Whether a side across an axis is held along it, so that the block cannot bend about the others.
    fn held_across(&self, axis: usize, held: &SupportedSurfaces) -> bool {
        ACROSS[axis].iter().any(|side| held.along(side, axis))
    }

    /// How far (m) the block reaches from sides that are held, along an axis and the thickness of another;
    /// nothing where no side is held.
    fn span(&self, thickness: usize, held: &SupportedSurfaces) -> f64 {
        let sides = (0..3)
            .filter(|&axis| axis != thickness && ACROSS[axis].iter().any(|side| held.at(side)));
        sides.map(|axis| self.size[axis]).reduce(f64::min).unwrap_or(0.0)
    }

    /// The edge (m) that divisions count on, and the axes whose edges are that long, or thin layers held
    /// underneath, which are divided by themselves.
    fn counted(&self, held: &SupportedSurfaces) -> (f64, [bool; 3]) {
        let shortest = self.size.into_iter().fold(f64::INFINITY, f64::min);
        let layer =
            [0, 1, 2].map(|axis| self.size[axis] == shortest && self.held_across(axis, held));
        let others = (0..3).filter(|&axis| !layer[axis]).map(|axis| self.size[axis]);
        let edge = others.reduce(f64::min).unwrap_or(shortest);
        (edge, [0, 1, 2].map(|axis| layer[axis] || self.size[axis] == edge))
    }

    /// Equal elements along x, y and z.
    fn counts(
        &self,
        divisions: Divisions,
        mirrored: [bool; 2],
        held: &SupportedSurfaces,
    ) -> [usize; 3] {
        let (edge, counted) = self.counted(held);
        // As many as make elements no longer than that, an even number where a plane of symmetry halves them.
        let follow = |axis: usize, count: usize, longest: f64| {
            if counted[axis] {
                return count;
            }
            let elements = (self.size[axis] / longest - 1e-9).ceil();
            let elements = (elements.min(MOST_ELEMENTS as f64) as usize).max(count);
            let halved = axis < 2 && mirrored[axis];
            if halved { elements.next_multiple_of(2) } else { elements }
        };
        match divisions {
            Divisions::Each(counts) => counts,
            Divisions::Along(count) => {
                [0, 1, 2].map(|axis| follow(axis, count, edge / count as f64))
            }
            Divisions::Enough => {
                let fine = [0, 1, 2].map(|axis| follow(axis, ENOUGH, 0.5 * edge));
                let coarse = [0, 1, 2].map(|axis| follow(axis, 2, free::longest(edge)));
                let kept = |counts: [usize; 3]| {
                    let [x, y] =
                        [0, 1].map(|axis| counts[axis] / (1 + usize::from(mirrored[axis])));
                    elements([x, y, counts[2]], mirrored)
                };
                if kept(fine) <= MANY { fine } else { coarse }
            }
        }
    }

    /// Equal divisions of every edge.
    fn even(&self, counts: [usize; 3], mirrored: [bool; 2]) -> [Axis; 3] {
        let [x, y] = [0, 1].map(|axis| Axis::even(self.size[axis], counts[axis], mirrored[axis]));
        let depth = |k: usize| self.size[2] * k as f64 / counts[2] as f64;
        [x, y, Axis { places: (0..=counts[2]).map(depth).collect(), zone: 0..0 }]
    }
}
