//! All fields of one output on their grid.

use std::path::Path;

use super::{Error, Field, Place, Surface, fields, vtk};
use archard::numerics::WRITTEN;
use archard::problem::{ContactProblem, ContactState};

/// Fields on a uniform grid of elements, as kept in a `.vti` file (VTK's XML image data).
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    /// The lowest corner along x and y (m).
    pub origin: [f64; 2],
    /// Size of an element along x and y (m).
    pub spacing: [f64; 2],
    /// Number of elements along x and y.
    pub elements: [usize; 2],
    /// The fields, one value an element, x running fastest.
    pub fields: Vec<Field>,
}

impl Image {
    /// The image of a state on a uniform frame; see [`fields()`] for what is on it.
    pub fn of(problem: &ContactProblem, state: &ContactState) -> Self {
        Self {
            origin: problem.frame.rectangle().corner(),
            spacing: problem.frame.spacing(),
            elements: problem.frame.elements(),
            fields: fields(problem, state),
        }
    }

    /// All that is worn off the surface of a body that roams from station to station, or of a ball that turns in its socket, in the
    /// coordinates of the body; `None` of any other.
    pub fn of_roaming(problem: &ContactProblem, state: &ContactState, body: usize) -> Option<Self> {
        let (frame, surface) = (&problem.frame, &state.surfaces[body]);
        surface.grid.swings()?;
        let shown = problem.motion.shown_offset(body)?;
        let (spacing, corner) = (frame.spacing(), frame.rectangle().corner());
        let before = surface.grid.before();
        let first = |axis: usize| shown[axis] + corner[axis] - before[axis] as f64 * spacing[axis];
        let name = format!("wear_{}_m", problem.bodies[body].name);
        Some(Self {
            origin: [first(0), first(1)],
            spacing,
            elements: surface.grid.elements(),
            fields: vec![Field::new(name, surface.depth.clone())],
        })
    }

    /// The values of the field of that name, if there is one.
    pub fn field(&self, name: &str) -> Option<&[f64]> {
        let field = self.fields.iter().find(|field| field.name == name)?;
        Some(&field.values)
    }

    /// Centre (m) of the element of that index along an axis (0: x, 1: y).
    pub fn centre(&self, axis: usize, index: usize) -> f64 {
        self.origin[axis] + (index as f64 + 0.5) * self.spacing[axis]
    }

    /// Whether another one has the same elements.
    pub fn is_on(&self, grid: &Self) -> bool {
        (self.origin, self.spacing, self.elements) == (grid.origin, grid.spacing, grid.elements)
    }

    /// The same on the elements of another one: means over each of them, not a number where none of this one's lie.
    #[must_use]
    pub fn resampled(&self, grid: &Self) -> Self {
        if self.is_on(grid) {
            return self.clone();
        }
        let [columns, rows] = [0, 1].map(|axis| self.shares(grid, axis));
        let on_grid = |field: &Field| {
            let at = |row: &[(usize, f64)], column: &[(usize, f64)]| {
                let mut sum = [0.0; 2];
                for (y, high) in row {
                    for (x, wide) in column {
                        let area = high * wide;
                        sum[0] += area * field.values[x + self.elements[0] * y];
                        sum[1] += area;
                    }
                }
                if sum[1] > 0.0 { sum[0] / sum[1] } else { f64::NAN }
            };
            let row = |row| columns.iter().map(move |column| at(row, column)).collect::<Vec<_>>();
            Field::new(field.name.clone(), rows.iter().flat_map(|one| row(one)).collect())
        };
        let fields = self.fields.iter().map(on_grid).collect();
        Self { origin: grid.origin, spacing: grid.spacing, elements: grid.elements, fields }
    }

    /// Of each element of another one along an axis, those of this one that lie in it, and how long (m) they do.
    fn shares(&self, grid: &Self, axis: usize) -> Vec<Vec<(usize, f64)>> {
        let edge = |one: &Self, index: usize| one.origin[axis] + index as f64 * one.spacing[axis];
        let share = |index: usize| {
            let [low, high] = [index, index + 1].map(|index| edge(grid, index));
            let inside = |own: usize| {
                let length = edge(self, own + 1).min(high) - edge(self, own).max(low);
                (length > WRITTEN * self.spacing[axis]).then_some((own, length))
            };
            (0..self.elements[axis]).filter_map(inside).collect()
        };
        (0..grid.elements[axis]).map(share).collect()
    }

    /// Writes a `.vti` file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, place: &Place) -> Result<(), Error> {
        vtk::write(self, place)
    }

    /// Reads a `.vti` file that [`Image::write`] wrote; it does not read those of other programs.
    ///
    /// # Errors
    /// If the file cannot be read, is damaged or is written in another way.
    pub fn read(path: &Path) -> Result<Self, Error> {
        vtk::read(path)
    }

    /// The image in the bytes of a `.vti` file that [`Image::write`] wrote.
    ///
    /// # Errors
    /// What is wrong with them.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, String> {
        vtk::decode(bytes)
    }

    /// Reads an output of either kind: a `.vti` file, or a `.vtu` file as its surface looks along z.
    ///
    /// # Errors
    /// As [`Image::read`] and [`Surface::read`].
    pub fn of_output(path: &Path) -> Result<Self, Error> {
        let surface = path.extension().is_some_and(|extension| extension == "vtu");
        if surface { Ok(Surface::read(path)?.image()) } else { Self::read(path) }
    }
}

#[cfg(test)]
mod tests {
    use super::{Field, Image};

    fn image(size: f64, value: impl Fn(usize, usize) -> f64) -> Image {
        let values = (0..48).map(|cell| value(cell % 8, cell / 8)).collect();
        let spacing = [size / 8.0, size / 6.0];
        let origin = [-0.5 * size; 2];
        Image { origin, spacing, elements: [8, 6], fields: vec![Field::new("one", values)] }
    }

    /// Means over four elements, and nothing next to them.
    #[test]
    fn on_elements_twice_as_large() {
        let fine = image(1.0, |x, y| (x * x + 3 * y) as f64);
        let wide = fine.resampled(&image(2.0, |_, _| 0.0));
        assert!(!fine.is_on(&wide));
        let at = |x: usize, y: usize| wide.fields[0].values[x + 8 * y];
        // It takes the place of the first two along x, and of one along y, the first: the frame begins in the middle of it.
        assert!((at(2, 1) - 0.5).abs() < 1e-12, "{}", at(2, 1));
        assert!((at(3, 2) - (6.5 + 4.5)).abs() < 1e-12, "{}", at(3, 2));
        assert!(at(1, 1).is_nan() && at(2, 0).is_nan() && at(6, 3).is_nan());
        let same = fine.resampled(&fine);
        for (one, other) in same.fields[0].values.iter().zip(&fine.fields[0].values) {
            assert!((one - other).abs() < 1e-12);
        }
    }
}
