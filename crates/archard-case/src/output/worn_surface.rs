//! The worn surface of a body as ParaView's filters want it: points with data, shared by the cells between them, in mm.

use std::collections::HashMap;

use super::surface::{reflected, sign};
use super::{Error, Field, Image, Place, Sheet, Surface, vtk};
use archard::numerics::SAME;

/// The worn surface of a body at one output, with point data: `wear_um`, `pressure_MPa` and whatever else the output has. It is
/// kept in a `.vtu` file (VTK's XML unstructured grids).
#[derive(Debug, Clone, Default, PartialEq)]
pub struct WornSurface {
    /// Points (mm).
    pub points: Vec<[f64; 3]>,
    /// The points of each cell, around it.
    pub cells: Vec<Vec<usize>>,
    /// Data of the points, their units in the names.
    pub fields: Vec<Field>,
    /// Vectors of the points by their names. `relief_mm` is what exaggerates the surface when it is added: the height of a
    /// surface over the plane of contact, the wear of a meshed one along its normal.
    pub vectors: Vec<(String, Vec<[f64; 3]>)>,
}

/// The parts that meet at each corner, each with whether it is reflected along x and y.
type Corners = Vec<Vec<(usize, [bool; 2])>>;

/// The vector that exaggerates the surface.
pub const RELIEF: &str = "relief_mm";

/// The bodies of an output, body 1 first, by its fields.
pub fn bodies(fields: &[Field]) -> Vec<&str> {
    fields
        .iter()
        .filter_map(|field| field.name.strip_prefix("height_")?.strip_suffix("_m"))
        .collect()
}

impl WornSurface {
    /// The surface of a body on a uniform grid: a point an element, at its centre, as high as the body is there. A line of
    /// elements becomes a strip.
    pub fn of_image(image: &Image, body: &str) -> Option<Self> {
        let [nx, ny] = image.elements;
        let own: Vec<(String, &[f64])> = own(&image.fields, body);
        let height = image.field(&format!("height_{body}_m"))?;
        // Of one row both edges are shown, no farther apart than the row is long.
        let rows: Vec<(usize, f64)> = if ny > 1 {
            (0..ny).map(|row| (row, image.centre(1, row))).collect()
        } else {
            let half = 0.5 * image.spacing[1].min(0.5 * nx as f64 * image.spacing[0]);
            [-half, half].map(|away| (0, image.centre(1, 0) + away)).to_vec()
        };
        let places = rows.iter().flat_map(|(row, y)| (0..nx).map(move |x| (x + nx * row, x, *y)));
        let pairs: Vec<usize> = places.clone().map(|(pair, ..)| pair).collect();
        let points = places.map(|(pair, x, y)| {
            [image.centre(0, x), y, height[pair]].map(|metres| MILLIMETRES * metres)
        });
        let corner = |row: usize, x: usize| x + nx * row;
        let cells = (1..rows.len()).flat_map(|row| {
            (1..nx).map(move |x| {
                vec![corner(row - 1, x - 1), corner(row - 1, x), corner(row, x), corner(row, x - 1)]
            })
        });
        let mut surface =
            Self { points: points.collect(), cells: cells.collect(), ..Self::default() };
        for (name, values) in own {
            surface.push(&name, pairs.iter().map(|&pair| values[pair]).collect());
        }
        let relief = surface.points.iter().map(|point| [0.0, 0.0, point[2]]).collect();
        surface.vectors.push((RELIEF.to_owned(), relief));
        surface.join_components();
        Some(surface)
    }

    /// The surface of a body on the elements of a mesh, mirror images included: a point has the mean of the elements that
    /// meet there.
    pub fn of_surface(surface: &Surface, body: &str) -> Option<Self> {
        let own = own(&surface.fields, body);
        let wear = surface.field(&format!("wear_{body}_m"))?;
        let side = if bodies(&surface.fields).first() == Some(&body) { -1.0 } else { 1.0 };
        let normals = surface.vectors.iter().find(|(name, _)| name == "normal");
        let (mut worn, meeting) = Self::on_corners(surface);
        let mean = |of: &dyn Fn(usize, [bool; 2]) -> f64| means(&meeting, of);
        for (name, values) in own {
            let values = mean(&|pair, sides| sign(&name, sides) * values[pair]);
            worn.push(&name, values);
        }
        let relief = [0, 1, 2].map(|axis| {
            mean(&|pair, sides| {
                let normal = normals.map_or([0.0, 0.0, 1.0], |(_, normals)| normals[pair]);
                let turned = if axis < 2 && sides[axis] { -1.0 } else { 1.0 };
                MILLIMETRES * side * turned * normal[axis] * wear[pair]
            })
        });
        let [x, y, z] = &relief;
        let relief = (0..x.len()).map(|point| [x[point], y[point], z[point]]).collect();
        worn.vectors.push((RELIEF.to_owned(), relief));
        worn.join_components();
        Some(worn)
    }

    /// The surface of a body with what loads make of it, mirror images included: a point has the mean of the parts of
    /// elements that meet there. `displacement_um` and `traction_MPa` are vectors.
    pub fn of_body(surface: &Surface) -> Self {
        let (mut body, meeting) = Self::on_corners(surface);
        let component = |field: &&Field| !field.name.starts_with("displacement_");
        for Field { name, values } in surface.fields.iter().filter(component) {
            let of = |pair: usize, sides| sign(name, sides) * values[pair];
            body.push(name, means(&meeting, &of));
        }
        for (name, vectors) in &surface.vectors {
            let along = [0, 1, 2].map(|axis| {
                let of = |pair: usize, sides: [bool; 2]| {
                    let turned = axis < 2 && sides[axis];
                    if turned { -vectors[pair][axis] } else { vectors[pair][axis] }
                };
                means(&meeting, &of)
            });
            let [x, y, z] = &along;
            body.push_vectors(name, (0..x.len()).map(|point| [x[point], y[point], z[point]]));
        }
        body
    }

    /// A section of a body.
    pub fn of_sheet(sheet: &Sheet) -> Self {
        let points = sheet.points.iter().map(|place| place.map(|metres| MILLIMETRES * metres));
        let mut own =
            Self { points: points.collect(), cells: sheet.cells.clone(), ..Self::default() };
        let component = |field: &&Field| !field.name.starts_with("displacement_");
        for Field { name, values } in sheet.fields.iter().filter(component) {
            own.push(name, values.clone());
        }
        for (name, vectors) in &sheet.vectors {
            own.push_vectors(name, vectors.iter().copied());
        }
        own
    }

    /// The corners of all parts, those at one place once, and the parts that meet at each, with their mirror images.
    fn on_corners(surface: &Surface) -> (Self, Corners) {
        let places = surface.outlines.iter().flatten().flatten();
        let size = places.fold(0.0, |most: f64, place| most.max(place.abs()));
        let mut known = HashMap::new();
        let (mut points, mut cells, mut meeting) = (vec![], vec![], vec![]);
        for (pair, outline) in surface.outlines.iter().enumerate() {
            for sides in surface.sides() {
                let mut cell = vec![];
                for corner in outline {
                    let [x, y] = reflected(*corner, sides);
                    let key = [x, y, corner[2]].map(|place| (place / (SAME * size)).round() as i64);
                    let index = *known.entry(key).or_insert_with(|| {
                        points.push([x, y, corner[2]].map(|metres| MILLIMETRES * metres));
                        meeting.push(vec![]);
                        points.len() - 1
                    });
                    meeting[index].push((pair, sides));
                    cell.push(index);
                }
                cells.push(cell);
            }
        }
        (Self { points, cells, ..Self::default() }, meeting)
    }

    /// Takes up vectors in SI, in units people read.
    fn push_vectors(&mut self, name: &str, vectors: impl Iterator<Item = [f64; 3]>) {
        let (name, factor) = read_by_people(name);
        let vectors = vectors.map(|vector| vector.map(|value| factor * value)).collect();
        self.vectors.push((name, vectors));
    }

    /// Writes a `.vtu` file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, place: &Place) -> Result<(), Error> {
        vtk::write_points(self, place)
    }

    /// Takes up a field in SI, in units people read.
    fn push(&mut self, name: &str, values: Vec<f64>) {
        let (name, factor) = read_by_people(name);
        let values = values.into_iter().map(|value| factor * value).collect();
        self.fields.push(Field { name, values });
    }

    /// Makes a vector of each two components.
    fn join_components(&mut self) {
        let names: Vec<String> = self.fields.iter().map(|field| field.name.clone()).collect();
        for name in names.iter().filter(|name| name.contains("_x_")) {
            let other = name.replace("_x_", "_y_");
            let take = |fields: &mut Vec<Field>, name: &str| {
                let place = fields.iter().position(|field| field.name == name)?;
                Some(fields.remove(place).values)
            };
            let Some(y) = names.contains(&other).then(|| take(&mut self.fields, &other)).flatten()
            else {
                continue;
            };
            let Some(x) = take(&mut self.fields, name) else { continue };
            let joined = x.iter().zip(&y).map(|(x, y)| [*x, *y, 0.0]).collect();
            self.vectors.push((name.replace("_x_", "_"), joined));
        }
    }
}

/// Millimetres in a metre.
const MILLIMETRES: f64 = 1e3;

/// The name of a field in SI in a unit people read, and by what values are multiplied.
fn read_by_people(name: &str) -> (String, f64) {
    let (stem, unit, factor) = match name.rsplit_once('_') {
        Some((stem, "Pa")) => (stem, "_MPa", 1e-6),
        Some((stem, "m")) if stem == "height" => (stem, "_mm", MILLIMETRES),
        Some((stem, "m")) => (stem, "_um", 1e6),
        _ => (name, "", 1.0),
    };
    (format!("{stem}{unit}"), factor)
}

/// Means at the corners over the parts that meet there.
fn means(meeting: &[Vec<(usize, [bool; 2])>], of: &dyn Fn(usize, [bool; 2]) -> f64) -> Vec<f64> {
    let at = |pairs: &Vec<(usize, [bool; 2])>| {
        let sum: f64 = pairs.iter().map(|&(pair, sides)| of(pair, sides)).sum();
        sum / pairs.len() as f64
    };
    meeting.iter().map(at).collect()
}

/// The fields that a body has of its own or shares, under the names they have for it alone.
fn own<'a>(fields: &'a [Field], body: &str) -> Vec<(String, &'a [f64])> {
    let all = bodies(fields);
    let named = |field: &'a Field| {
        let of = |name: &str| {
            ["height", "wear"].iter().find(|what| field.name == format!("{what}_{name}_m")).copied()
        };
        if let Some(what) = of(body) {
            return Some((format!("{what}_m"), &field.values[..]));
        }
        let others = field.name == "wear_m" || all.iter().any(|other| of(other).is_some());
        (!others).then(|| (field.name.clone(), &field.values[..]))
    };
    fields.iter().filter_map(named).collect()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{RELIEF, WornSurface, bodies};
    use crate::output::{Field, Image, Surface};

    fn field(name: &str, values: &[f64]) -> Field {
        Field { name: name.to_owned(), values: values.to_vec() }
    }

    /// Six elements, on which a pin is 1 um and more high and worn by 2 um and more.
    fn image() -> Image {
        let rising = |first: f64| [0.0, 1.0, 2.0, 3.0, 4.0, 5.0].map(|step| first + 1e-6 * step);
        Image {
            origin: [-1.5e-3, -1e-3],
            spacing: [1e-3, 1e-3],
            elements: [3, 2],
            fields: vec![
                field("pressure_Pa", &[1e6; 6]),
                field("wear_pin_m", &rising(2e-6)),
                field("wear_disc_m", &[0.0; 6]),
                field("wear_m", &rising(2e-6)),
                field("height_pin_m", &rising(1e-6)),
                field("height_disc_m", &[0.0; 6]),
                field("slip_x_m", &rising(0.0)),
                field("slip_y_m", &[0.0; 6]),
            ],
        }
    }

    #[test]
    fn points_are_the_centres_with_the_values_of_their_elements() {
        let image = image();
        assert_eq!(bodies(&image.fields), ["pin", "disc"]);
        let pin = WornSurface::of_image(&image, "pin").unwrap();
        assert_eq!(pin.cells, [vec![0, 1, 4, 3], vec![1, 2, 5, 4]]);
        for (axis, expected) in [1.0, 0.5, 6e-3].into_iter().enumerate() {
            assert_relative_eq!(pin.points[5][axis], expected, max_relative = 1e-12);
        }
        let names: Vec<&str> = pin.fields.iter().map(|field| field.name.as_str()).collect();
        assert_eq!(names, ["pressure_MPa", "wear_um", "height_mm"]);
        assert_relative_eq!(pin.fields[0].values[0], 1.0, max_relative = 1e-12);
        assert_relative_eq!(pin.fields[1].values[5], 7.0, max_relative = 1e-12);
        let [(relief, heights), (slip, slips)] = &pin.vectors[..] else {
            panic!("{:?}", pin.vectors)
        };
        assert_eq!([relief.as_str(), slip.as_str()], [RELIEF, "slip_um"]);
        assert_relative_eq!(heights[5][2], 6e-3, max_relative = 1e-12);
        assert_relative_eq!(slips[5][0], 5.0, max_relative = 1e-12);
        assert_eq!(WornSurface::of_image(&image, "ring"), None);
    }

    #[test]
    fn a_line_of_elements_becomes_a_strip() {
        let mut line = image();
        line.elements = [6, 1];
        let strip = WornSurface::of_image(&line, "pin").unwrap();
        assert_eq!((strip.points.len(), strip.cells.len()), (12, 5));
        assert_relative_eq!(strip.points[6][1] - strip.points[0][1], 1.0, max_relative = 1e-12);
    }

    /// Two squares of a half that is mirrored along x: four, which share their corners.
    #[test]
    fn corners_are_shared_and_mirror_images_shown() {
        let square = |x: f64| {
            [[x, 0.0, 0.0], [x + 1e-3, 0.0, 0.0], [x + 1e-3, 1e-3, 0.0], [x, 1e-3, 0.0]].to_vec()
        };
        let surface = Surface {
            places: vec![[0.5e-3, 0.5e-3, 0.0], [1.5e-3, 0.5e-3, 0.0]],
            outlines: vec![square(0.0), square(1e-3)],
            mirrored: [true, false],
            fields: vec![
                field("wear_punch_m", &[0.0; 2]),
                field("wear_block_m", &[1e-6, 3e-6]),
                field("height_punch_m", &[0.0; 2]),
                field("height_block_m", &[0.0; 2]),
                field("traction_x_Pa", &[1e6, 3e6]),
                field("traction_y_Pa", &[0.0; 2]),
            ],
            vectors: vec![],
        };
        let block = WornSurface::of_surface(&surface, "block").unwrap();
        assert_eq!((block.points.len(), block.cells.len()), (10, 4));
        let at =
            |x: f64| block.points.iter().position(|point| (point[0] - x).abs() < 1e-9).unwrap();
        let wear = &block.fields.iter().find(|field| field.name == "wear_um").unwrap().values;
        for (x, expected) in [(-2.0, 3.0), (-1.0, 2.0), (0.0, 1.0), (1.0, 2.0), (2.0, 3.0)] {
            assert_relative_eq!(wear[at(x)], expected, max_relative = 1e-12);
        }
        let vector = |name: &str| &block.vectors.iter().find(|(known, _)| known == name).unwrap().1;
        // Body 2 lies above: its wear goes up. Components across the plane of symmetry turn round.
        assert_relative_eq!(vector(RELIEF)[at(2.0)][2], 3e-3, max_relative = 1e-12);
        for (x, expected) in [(-2.0, -3.0), (0.0, 0.0), (2.0, 3.0)] {
            assert_relative_eq!(vector("traction_MPa")[at(x)][0], expected, epsilon = 1e-12);
        }
    }
}
