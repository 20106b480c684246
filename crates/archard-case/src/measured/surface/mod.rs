//! Measured surfaces: profiles along an axis, and height maps, as instruments write them.
//!
//! A profile has columns `x` or `y` and `z`, a height map all three, its readings on a grid along the axes. Heights rise out
//! of the material. An empty cell is a place without a reading; a reading far off those around it counts as none. Files of
//! instruments that tell their scale (`.sur`, `.sdf`, `.x3p`, `.gwy`) are height maps too.

mod integral;
mod no_scar;
mod noise;
mod piece;
mod rough;
mod scar;
mod spikes;
mod track;

pub use no_scar::NoScar;
pub use scar::{Scar, UnwornSurface};

use super::heading::Heading;
use super::plane::Height;
use super::{Error, Table};
use archard::numerics::WRITTEN;
use archard::units::Measure;
use archard_surface::file::{Format, ReadError, Scale, read_up_to};

/// A measured surface, on the places of a grid.
#[derive(Debug, Clone, PartialEq)]
pub struct Surface {
    source: String,
    /// The axis of a profile; `None` of a height map.
    axis: Option<usize>,
    /// Rising places (m) along x and y.
    places: [Vec<f64>; 2],
    /// Heights (m), x running fastest; not a number where nothing was measured.
    heights: Vec<f64>,
}

/// Why a table is no surface.
#[non_exhaustive]
#[derive(Debug, thiserror::Error)]
pub enum NoSurface {
    /// The table cannot be read, or a column.
    #[error(transparent)]
    Table(#[from] Error),
    /// No places.
    #[error(
        "{table}: a profile has columns `x` (or `y`) and `z`, a height map `x`, `y` and `z`; there are {titles} (to use one of \
         them: --column x=\"its header\")"
    )]
    NoPlaces {
        /// What the table is called.
        table: String,
        /// The titles there are.
        titles: String,
    },
    /// The file of an instrument that cannot be read.
    #[error("{file}: {why}")]
    File {
        /// The file.
        file: String,
        /// Why.
        why: ReadError,
    },
    /// Places alone.
    #[error("{table}: no place has a height: the column `z` is empty")]
    NoHeight {
        /// What the table is called.
        table: String,
    },
    /// Readings anywhere.
    #[error(
        "{table}: of a grid of {} by {} places {readings} have a reading: give a height map on a grid along x and y, as \
         instruments export it",
        .places[0], .places[1]
    )]
    NoGrid {
        /// What the table is called.
        table: String,
        /// Different places along x and y.
        places: [usize; 2],
        /// Readings.
        readings: usize,
    },
}

/// The columns of surfaces.
const COLUMNS: [&str; 3] = ["x", "y", "z"];
/// Memory (bytes) for a point of a height map: its height as it was read, as it is kept and without spikes, and its reading.
const BYTES_OF_A_POINT: f64 = (3 * size_of::<f64>() + size_of::<Height>()) as f64;
/// The least share of a grid that has readings.
const FILLED: f64 = 0.5;

impl Surface {
    /// Whether a column of that name, with a unit or not, is one of surfaces: `x`, `Y` or `z [um]`.
    pub fn has_column(name: &str) -> bool {
        COLUMNS.contains(&Heading::of(name).name.as_str())
    }

    /// The surface in a table. Several readings at one place are averaged.
    ///
    /// # Errors
    /// If a column is missing or cannot be read, or the readings of a map are not on a grid.
    pub fn of(table: &Table) -> Result<Self, NoSurface> {
        let source = table.source().to_owned();
        let has = |name: &str| table.names().any(|known| known == name);
        let axis = match (has("x"), has("y")) {
            (true, true) => None,
            (true, false) => Some(0),
            (false, true) => Some(1),
            (false, false) => {
                return Err(NoSurface::NoPlaces { table: source, titles: table.titles() });
            }
        };
        let along = |of: usize| match axis {
            Some(own) if own != of => Ok(vec![0.0; table.len()]),
            _ => table.all_numbers(["x", "y"][of], &Measure::LENGTH),
        };
        let [x, y] = [along(0)?, along(1)?];
        let heights = match table.numbers("z", &Measure::LENGTH)? {
            Some(heights) => heights,
            // Says which column is missing.
            None => table.all_numbers("z", &Measure::LENGTH)?.into_iter().map(Some).collect(),
        };
        let readings: Vec<Height> = (x.into_iter().zip(y).zip(heights))
            .filter_map(|((x, y), z)| Some([x, y, z?]))
            .collect();
        let count = readings.len();
        if count == 0 {
            return Err(NoSurface::NoHeight { table: source });
        }
        let surface = Self::on_a_grid((source, axis), &readings);
        let places = [0, 1].map(|axis| surface.places[axis].len());
        if (count as f64) < FILLED * (places[0] * places[1]) as f64 {
            return Err(NoSurface::NoGrid { table: surface.source, places, readings: count });
        }
        Ok(surface.without_spikes())
    }

    /// The height map in the file of an instrument that gives its scale, by the ending of its name; `None` of any other
    /// file, which is a table. The middle of the map is at 0, its first row has the lowest y. It may take so much memory
    /// (bytes).
    pub fn of_file(name: &str, bytes: &[u8], memory: f64) -> Option<Result<Self, NoSurface>> {
        let format = Format::of_extension(name.rsplit_once('.')?.1)?;
        let most = (memory / BYTES_OF_A_POINT) as usize;
        format.tells_its_scale().then(|| {
            let map = read_up_to(bytes, format, Scale::default(), most)
                .map_err(|why| NoSurface::File { file: name.to_owned(), why })?;
            let places = [0, 1].map(|axis| {
                (0..map.elements()[axis]).map(|index| map.place(axis, index)).collect()
            });
            let heights = map.heights().to_vec();
            Ok(Self { source: name.to_owned(), axis: None, places, heights }.without_spikes())
        })
    }

    /// Readings put on the grid of their places; several at one place are averaged.
    fn on_a_grid((source, axis): (String, Option<usize>), readings: &[Height]) -> Self {
        let places = [0, 1].map(|axis| distinct(readings.iter().map(|own| own[axis]).collect()));
        let cells = places[0].len() * places[1].len();
        let (mut sums, mut counts) = (vec![0.0; cells], vec![0.0; cells]);
        for own in readings {
            let [column, row] = [0, 1].map(|axis| nearest(&places[axis], own[axis]));
            sums[row * places[0].len() + column] += own[2];
            counts[row * places[0].len() + column] += 1.0;
        }
        let heights = sums.iter().zip(&counts).map(|(sum, count)| sum / count).collect();
        Self { source, axis, places, heights }
    }

    /// What messages call it.
    pub fn source(&self) -> &str {
        &self.source
    }

    /// The axis of a profile (0: x, 1: y); `None` of a height map.
    pub fn axis(&self) -> Option<usize> {
        self.axis
    }

    /// Rising places (m) along x and y.
    pub fn places(&self) -> &[Vec<f64>; 2] {
        &self.places
    }

    /// All readings.
    pub fn readings(&self) -> Vec<Height> {
        (0..self.heights.len()).map(|cell| self.at(cell)).filter(|own| !own[2].is_nan()).collect()
    }

    /// The reading of a cell; its height is not a number where none exists.
    fn at(&self, cell: usize) -> Height {
        let columns = self.places[0].len();
        [self.places[0][cell % columns], self.places[1][cell / columns], self.heights[cell]]
    }

    /// From where to where it was measured along an axis (m).
    fn extent(&self, axis: usize) -> [f64; 2] {
        let places = &self.places[axis];
        [places[0], places[places.len() - 1]]
    }
}

/// Rising places, those that differ by rounding once.
fn distinct(mut places: Vec<f64>) -> Vec<f64> {
    places.sort_by(f64::total_cmp);
    let extent = places.last().zip(places.first()).map_or(0.0, |(last, first)| last - first);
    places.dedup_by(|next, last| *next - *last <= WRITTEN * extent);
    places
}

/// The index of the nearest of rising places.
fn nearest(places: &[f64], place: f64) -> usize {
    let next = places.partition_point(|known| *known < place).min(places.len() - 1);
    let before = next.saturating_sub(1);
    if place - places[before] < places[next] - place { before } else { next }
}

#[cfg(test)]
mod tests;
