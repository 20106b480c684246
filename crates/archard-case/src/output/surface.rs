//! All fields of one output on pairs that are no uniform grid.

use std::path::Path;

use super::sheet::turn_over;
use super::{Error, Field, Image, Place, fields, vtk};
use archard::frame::ContactFrame;
use archard::numerics::WRITTEN;
use archard::problem::{ContactProblem, ContactState};

/// Most elements along an axis of the image that a surface is seen as.
const MOST: usize = 320;
/// Elements of that image along the side of an average pair.
const FINER: f64 = 4.0;

/// Fields on the parts of a surface that the pairs stand for, as kept in a `.vtu` file (VTK's XML
/// unstructured grids).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Surface {
    /// Where the pairs are (m).
    pub places: Vec<[f64; 3]>,
    /// Corners (m) of the part that each stands for.
    pub outlines: Vec<Vec<[f64; 3]>>,
    /// Whether x = 0 and y = 0 are planes of symmetry with pairs on one side only.
    pub mirrored: [bool; 2],
    /// The fields, one value a pair.
    pub fields: Vec<Field>,
    /// Vectors in the axes of the frame by their names, one a pair.
    pub vectors: Vec<(String, Vec<[f64; 3]>)>,
}

impl Surface {
    /// Turned over, as body 2 is above the plane of contact: z changes its sign.
    #[must_use]
    pub(super) fn turned_over(mut self) -> Self {
        let outlines = self.outlines.iter_mut();
        let outlines = outlines.flat_map(|outline| {
            outline.reverse();
            outline
        });
        self.places.iter_mut().chain(outlines).for_each(|place| place[2] = -place[2]);
        turn_over(&mut self.fields, &mut self.vectors);
        self
    }

    /// The surface of a state; see [`fields()`] for what is on it. Vectors are the whole traction on body 1, the
    /// slip, and the normals of curved surfaces.
    pub fn of(problem: &ContactProblem, state: &ContactState) -> Self {
        let frame = &problem.frame;
        let place = |pair: usize| {
            let [x, y] = frame.place(pair);
            [x, y, frame.height(pair)]
        };
        Self {
            places: (0..frame.len()).map(place).collect(),
            outlines: (0..frame.len()).map(|pair| frame.outline(pair)).collect(),
            mirrored: frame.mirrored(),
            fields: fields(problem, state),
            vectors: vectors(frame, state),
        }
    }

    /// The values of the field of that name, if there is one.
    pub fn field(&self, name: &str) -> Option<&[f64]> {
        let field = self.fields.iter().find(|field| field.name == name)?;
        Some(&field.values)
    }

    /// The outlines (m) of all parts as they look along z, mirror images included, each with the value of the field of that
    /// name; `None` if none exists.
    pub fn parts(&self, name: &str) -> Option<Vec<(Vec<[f64; 2]>, f64)>> {
        let values = self.field(name)?;
        let sides = self.sides();
        let part = |(pair, outline): (usize, &Vec<[f64; 3]>)| -> Vec<(Vec<[f64; 2]>, f64)> {
            let image = |sides: &[bool; 2]| {
                let corners = outline.iter().map(|corner| reflected(*corner, *sides)).collect();
                (corners, sign(name, *sides) * values[pair])
            };
            sides.iter().map(image).collect()
        };
        Some(self.outlines.iter().enumerate().flat_map(part).collect())
    }

    /// The elements of an image of the surface as it looks along z, without fields, and the part that each of them shows, an
    /// index into [`Surface::parts`]; none next to the surface.
    pub fn raster(&self) -> (Image, Vec<Option<usize>>) {
        let image = self.frame(MOST);
        let sides = self.sides();
        let part = |(pair, own): (usize, [bool; 2])| {
            let side = sides.iter().position(|known| *known == own).unwrap_or(0);
            sides.len() * pair + side
        };
        let shown = self.shown(&image).into_iter().map(|shown| shown.map(part));
        let shown = shown.collect();
        (image, shown)
    }

    /// The surface as it looks along z: each element of the image has the value of the pair it shows, or zero
    /// next to the surface. Mirror images are shown.
    pub fn image(&self) -> Image {
        let mut image = self.frame(1);
        let shown = self.shown(&image);
        let values = |field: &Field| {
            let value = |shown: &Option<(usize, [bool; 2])>| {
                shown.map_or(0.0, |(pair, sides)| sign(&field.name, sides) * field.values[pair])
            };
            Field { name: field.name.clone(), values: shown.iter().map(value).collect() }
        };
        image.fields = self.fields.iter().map(values).collect();
        image
    }

    /// An image as large as the surface, fine enough to tell its parts apart, with so many elements along its longer side at
    /// least.
    fn frame(&self, least: usize) -> Image {
        let [x, y] = [0, 1].map(|axis| self.extent(axis));
        let longer = (x[1] - x[0]).max(y[1] - y[0]);
        let side = ((x[1] - x[0]) * (y[1] - y[0]) / self.places.len().max(1) as f64).sqrt();
        let mut image =
            Image { origin: [x[0], y[0]], spacing: [0.0; 2], elements: [0; 2], fields: vec![] };
        for (axis, [low, high]) in [x, y].into_iter().enumerate() {
            let count = (FINER / side).max(least as f64 / longer) * (high - low);
            let count = if count.is_finite() { count.ceil().clamp(1.0, MOST as f64) } else { 1.0 };
            (image.elements[axis], image.spacing[axis]) = (count as usize, (high - low) / count);
        }
        image
    }

    /// The pair that each element of an image shows, and whether it is reflected along x and y.
    fn shown(&self, image: &Image) -> Vec<Option<(usize, [bool; 2])>> {
        let [nx, ny] = image.elements;
        let mut shown = vec![None; nx * ny];
        for (pair, outline) in self.outlines.iter().enumerate() {
            for sides in self.sides() {
                let corners: Vec<[f64; 2]> =
                    outline.iter().map(|corner| reflected(*corner, sides)).collect();
                let [columns, rows] = [0, 1].map(|axis| {
                    let places = corners.iter().map(|corner| corner[axis]);
                    let index = |place: f64| {
                        let index = (place - image.origin[axis]) / image.spacing[axis];
                        (index.max(0.0) as usize).min(image.elements[axis])
                    };
                    let low = index(places.clone().fold(f64::INFINITY, f64::min));
                    let high = index(places.fold(f64::NEG_INFINITY, f64::max)) + 1;
                    low..high.min(image.elements[axis])
                });
                for row in rows {
                    for column in columns.clone() {
                        let place = [image.centre(0, column), image.centre(1, row)];
                        if inside(&corners, place) {
                            shown[column + nx * row] = Some((pair, sides));
                        }
                    }
                }
            }
        }
        shown
    }

    /// Lowest and highest place (m) along an axis, mirror images included.
    fn extent(&self, axis: usize) -> [f64; 2] {
        let corners = self.outlines.iter().flatten().map(|corner| corner[axis]);
        let low = corners.clone().fold(f64::INFINITY, f64::min);
        let high = corners.fold(f64::NEG_INFINITY, f64::max);
        if self.mirrored[axis] {
            let most = low.abs().max(high.abs());
            return [-most, most];
        }
        [low, high]
    }

    /// The pairs and their mirror images: whether they are reflected along x and y.
    pub(super) fn sides(&self) -> Vec<[bool; 2]> {
        let all = [[false, false], [true, false], [false, true], [true, true]];
        let there = |sides: &[bool; 2]| (0..2).all(|axis| self.mirrored[axis] || !sides[axis]);
        all.into_iter().filter(there).collect()
    }

    /// Places (m) along an axis, and the values of every field there, on the line at that place (m) across, zero where
    /// there is a plane of symmetry: those of the pairs on it, or the mean of the two between which it runs.
    pub(super) fn section(&self, axis: usize, at: f64) -> Vec<(f64, Vec<f64>)> {
        let [size, across] = [axis, 1 - axis].map(|axis| {
            let [low, high] = self.extent(axis);
            high - low
        });
        let crosses = |outline: &&Vec<[f64; 3]>| {
            let places = outline.iter().map(|corner| corner[1 - axis]);
            let (low, high) = (
                places.clone().fold(f64::INFINITY, f64::min),
                places.fold(f64::NEG_INFINITY, f64::max),
            );
            low - at <= WRITTEN * across && high - at >= -WRITTEN * across
        };
        let mut points: Vec<(f64, Vec<f64>)> = vec![];
        for (pair, _) in self.outlines.iter().enumerate().filter(|(_, outline)| crosses(outline)) {
            for sides in self.sides().into_iter().filter(|sides| !sides[1 - axis]) {
                let place = reflected(self.places[pair], sides)[axis];
                let values = self.fields.iter().map(|f| sign(&f.name, sides) * f.values[pair]);
                points.push((place, values.collect()));
            }
        }
        points.sort_by(|a, b| a.0.total_cmp(&b.0));
        let same = |a: &(f64, Vec<f64>), b: &(f64, Vec<f64>)| b.0 - a.0 <= WRITTEN * size;
        points.chunk_by(same).map(mean).collect()
    }

    /// Writes a `.vtu` file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, place: &Place) -> Result<(), Error> {
        vtk::write(self, place)
    }

    /// Reads a `.vtu` file that [`Surface::write`] wrote; it does not read those of other programs.
    ///
    /// # Errors
    /// If the file cannot be read, is damaged or is written in another way.
    pub fn read(path: &Path) -> Result<Self, Error> {
        vtk::read(path)
    }

    /// The surface in the bytes of a `.vtu` file that [`Surface::write`] wrote.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, String> {
        vtk::decode(bytes)
    }
}

/// The mean of points at one place.
fn mean(points: &[(f64, Vec<f64>)]) -> (f64, Vec<f64>) {
    let share = 1.0 / points.len() as f64;
    let place = points.iter().map(|point| share * point.0).sum();
    let fields = points.first().map_or(0, |point| point.1.len());
    let value = |field: usize| points.iter().map(|point| share * point.1[field]).sum();
    (place, (0..fields).map(value).collect())
}

/// A place reflected along x and y, seen along z.
pub(super) fn reflected([x, y, _]: [f64; 3], sides: [bool; 2]) -> [f64; 2] {
    [if sides[0] { -x } else { x }, if sides[1] { -y } else { y }]
}

/// The sign of a field in a mirror image: components along the axis of reflection turn round, shear stresses with one of
/// their directions along it too.
pub(super) fn sign(name: &str, sides: [bool; 2]) -> f64 {
    let turned = |letter: char| match letter {
        'x' => sides[0],
        'y' => sides[1],
        _ => false,
    };
    let directions = match name.split('_').collect::<Vec<_>>()[..] {
        ["traction" | "slip" | "stress" | "displacement", directions, _] => directions,
        _ => "",
    };
    let turns = directions.chars().filter(|&letter| turned(letter)).count();
    if turns % 2 == 1 { -1.0 } else { 1.0 }
}

/// Whether a place lies within a polygon.
fn inside(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let next = corners.iter().cycle().skip(1);
    let crossed = corners.iter().zip(next).filter(|(a, b)| {
        (a[1] > y) != (b[1] > y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1])
    });
    crossed.count() % 2 == 1
}

fn vectors(frame: &ContactFrame, state: &ContactState) -> Vec<(String, Vec<[f64; 3]>)> {
    let along = |value: &dyn Fn(usize) -> [f64; 3]| -> Vec<[f64; 3]> {
        (0..frame.len()).map(|pair| frame.compose(pair, value(pair))).collect()
    };
    let tangential = state.tangential.as_ref();
    let traction = |pair: usize| {
        let [t1, t2] = tangential.map_or([0.0; 2], |t| [t.traction[0][pair], t.traction[1][pair]]);
        [t1, t2, -state.pressure[pair]]
    };
    let mut vectors = vec![("traction_Pa".to_owned(), along(&traction))];
    if let Some(tangential) = tangential {
        let slips = |pair: usize| state.pressure[pair] > 0.0;
        let slip = |pair: usize| match slips(pair) {
            true => [tangential.slip[0][pair], tangential.slip[1][pair], 0.0],
            false => [0.0; 3],
        };
        vectors.push(("slip_m".to_owned(), along(&slip)));
    }
    if !frame.is_plane() {
        vectors.push(("normal".to_owned(), along(&|_| [0.0, 0.0, 1.0])));
    }
    vectors
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{Surface, sign};
    use crate::output::Field;

    /// A quarter of a frame of 4 by 4 unequal elements, on which a field is x + 10 y.
    fn quarter() -> Surface {
        let edges = [0.0, 1.0, 3.0];
        let mut surface = Surface { mirrored: [true; 2], ..Surface::default() };
        let mut values = vec![];
        for [y0, y1] in [[edges[0], edges[1]], [edges[1], edges[2]]] {
            for [x0, x1] in [[edges[0], edges[1]], [edges[1], edges[2]]] {
                let (x, y) = (0.5 * (x0 + x1), 0.5 * (y0 + y1));
                surface.places.push([x, y, 0.0]);
                surface.outlines.push(
                    [[x0, y0], [x1, y0], [x1, y1], [x0, y1]].map(|[x, y]| [x, y, 0.0]).to_vec(),
                );
                values.push(x + 10.0 * y);
            }
        }
        surface.fields.push(Field { name: "traction_x_Pa".to_owned(), values });
        surface
    }

    #[test]
    fn images_show_mirror_images() {
        let image = quarter().image();
        let values = image.field("traction_x_Pa").unwrap();
        for (index, value) in values.iter().enumerate() {
            let x = image.centre(0, index % image.elements[0]);
            let y = image.centre(1, index / image.elements[0]);
            let middle = |place: f64| if place.abs() < 1.0 { 0.5 } else { 2.0 };
            assert_relative_eq!(*value, x.signum() * (middle(x) + 10.0 * middle(y)));
        }
    }

    #[test]
    fn components_turn_round_in_mirror_images() {
        let along_x = [true, false];
        for (name, expected) in [
            ("traction_x_Pa", -1.0),
            ("slip_y_m", 1.0),
            ("stress_xx_Pa", 1.0),
            ("stress_xy_Pa", -1.0),
            ("stress_yz_Pa", 1.0),
            ("stress_zx_Pa", -1.0),
            ("displacement_x_m", -1.0),
            ("displacement_z_m", 1.0),
            ("von_mises_Pa", 1.0),
            ("wear_x_m", 1.0),
            ("wear_m", 1.0),
        ] {
            assert_eq!(sign(name, along_x), expected, "{name}");
        }
        assert_eq!(sign("stress_xy_Pa", [true, true]), 1.0);
        assert_eq!(sign("stress_yz_Pa", [false, true]), -1.0);
    }

    #[test]
    fn sections_follow_the_pairs_on_the_line() {
        let surface = quarter();
        let along_x = surface.section(0, 0.0);
        let expected = [(-2.0, -7.0), (-0.5, -5.5), (0.5, 5.5), (2.0, 7.0)];
        assert_eq!(along_x.len(), 4);
        for ((place, values), (x, value)) in along_x.iter().zip(expected) {
            assert_relative_eq!(*place, x);
            assert_relative_eq!(values[0], value);
        }
        // Between two rows of a whole frame their mean.
        let mut whole = surface.clone();
        whole.mirrored = [false; 2];
        for outline in &mut whole.outlines {
            outline.iter_mut().for_each(|corner| corner[1] -= 1.0);
        }
        assert_eq!(whole.section(0, 0.0).len(), 2);
        assert_relative_eq!(whole.section(0, 0.0)[0].1[0], 0.5 * (5.5 + 20.5));
        // Next to the middle the row that lies there.
        assert_relative_eq!(whole.section(0, -0.5)[0].1[0], 5.5);
        assert_relative_eq!(whole.section(0, 1.5)[0].1[0], 20.5);
    }
}
