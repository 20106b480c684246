//! Sections of the fields along x and y through the contact.
//!
//! They run through the centre of the frame, as long as the centre of pressure is next to it; through the elements in which
//! the centre of pressure lies otherwise.

use super::table::{Table, number};
use super::{Error, Field, Image, Surface};
use archard::problem::{ContactProblem, ContactState};

/// How far the centre of pressure may lie from that of the frame, relative to the radius of gyration of the pressure: the
/// chord of a round contact is then shorter than its diameter by a hundredth at most.
const MIDDLE: f64 = 0.25;

/// The place (m) that sections run through: the centre of pressure, with that of the frame along an axis where it is next
/// to it, or nothing is pressed.
pub(super) fn through(problem: &ContactProblem, state: &ContactState) -> [f64; 2] {
    let (frame, pressure) = (&problem.frame, &state.pressure);
    let loaded: Vec<_> = (0..frame.len())
        .filter(|pair| pressure[*pair] > 0.0)
        .map(|pair| (frame.area(pair) * pressure[pair], frame.place(pair)))
        .collect();
    let moment = |axis: usize, power: i32| -> f64 {
        loaded.iter().map(|(force, place)| force * place[axis].powi(power)).sum()
    };
    [0, 1].map(|axis| {
        let load = moment(axis, 0);
        let middle = frame.centre()[axis];
        if load <= 0.0 || frame.mirrored()[axis] {
            return middle;
        }
        let centre = moment(axis, 1) / load;
        let gyration = (moment(axis, 2) / load - centre * centre).max(0.0).sqrt();
        let near = (0.5 * frame.spacing()[axis]).max(MIDDLE * gyration);
        if (centre - middle).abs() > near { centre } else { middle }
    })
}

/// Adds the sections of an image through a place (m) to a long table: for each axis, a row an element.
pub(super) fn write(
    table: &mut Table,
    progress: (&str, f64),
    image: &Image,
    through: [f64; 2],
) -> Result<(), Error> {
    for axis in 0..2 {
        let rows = rows(image, 1 - axis, through[1 - axis]);
        let sections: Vec<Vec<f64>> =
            image.fields.iter().map(|field| section(image, &field.values, axis, rows)).collect();
        let point = |index: usize| {
            let values = sections.iter().map(|values| values[index]).collect();
            (image.centre(axis, index), values)
        };
        let points: Vec<_> = (0..image.elements[axis]).map(point).collect();
        write_axis(table, progress, axis, &image.fields, &points)?;
    }
    table.flush()
}

/// Adds the sections of a surface likewise: a row a pair on the line, its mirror images too.
pub(super) fn write_surface(
    table: &mut Table,
    progress: (&str, f64),
    surface: &Surface,
    through: [f64; 2],
) -> Result<(), Error> {
    for axis in 0..2 {
        let points = surface.section(axis, through[1 - axis]);
        write_axis(table, progress, axis, &surface.fields, &points)?;
    }
    table.flush()
}

/// Adds a section along an axis: places (m) and the values of every field there.
fn write_axis(
    table: &mut Table,
    progress: (&str, f64),
    axis: usize,
    fields: &[Field],
    points: &[(f64, Vec<f64>)],
) -> Result<(), Error> {
    for (place, values) in points {
        let mut row = vec![
            (progress.0, number(progress.1)),
            ("axis", ["x", "y"][axis].to_owned()),
            ("coordinate_m", number(*place)),
        ];
        let values = fields.iter().zip(values);
        row.extend(values.map(|(field, value)| (field.name.as_str(), number(*value))));
        table.row(&row)?;
    }
    Ok(())
}

/// The rows across an axis that a section takes the mean of: that of a place (m); at the centre the middle one or, where
/// the line runs between two rows, both.
fn rows(image: &Image, across: usize, place: f64) -> [usize; 2] {
    let count = image.elements[across];
    if place == 0.0 {
        return [(count - 1) / 2, count / 2];
    }
    let row = (place - image.origin[across]) / image.spacing[across];
    [(row.max(0.0) as usize).min(count - 1); 2]
}

/// Values along an axis, the mean of two rows.
fn section(image: &Image, values: &[f64], axis: usize, rows: [usize; 2]) -> Vec<f64> {
    let [nx, _] = image.elements;
    let value = |along: usize, row: usize| match axis {
        0 => values[along + nx * row],
        _ => values[row + nx * along],
    };
    (0..image.elements[axis])
        .map(|along| 0.5 * (value(along, rows[0]) + value(along, rows[1])))
        .collect()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::{rows, section, through};
    use crate::output::Image;
    use crate::output::fixture::Run;

    #[test]
    fn sections_run_through_the_centre() {
        for elements in [[5, 4], [4, 5], [1, 1], [6, 6]] {
            let image =
                Image { origin: [-1.0, -2.0], spacing: [0.3, 0.7], elements, fields: vec![] };
            let linear = |x: f64, y: f64| 3.0 + 2.0 * x - 5.0 * y;
            let middle = [0, 1]
                .map(|axis| image.origin[axis] + 0.5 * image.spacing[axis] * elements[axis] as f64);
            let values: Vec<f64> = (0..elements[0] * elements[1])
                .map(|i| linear(image.centre(0, i % elements[0]), image.centre(1, i / elements[0])))
                .collect();
            let centre = [0, 1].map(|axis| rows(&image, 1 - axis, 0.0));
            for (i, value) in section(&image, &values, 0, centre[0]).into_iter().enumerate() {
                assert_relative_eq!(value, linear(image.centre(0, i), middle[1]), epsilon = 1e-13);
            }
            for (i, value) in section(&image, &values, 1, centre[1]).into_iter().enumerate() {
                assert_relative_eq!(value, linear(middle[0], image.centre(1, i)), epsilon = 1e-13);
            }
        }
    }
    /// A pressure moved by three elements along x and one along y is cut there; one moved by rounding, at the centre.
    #[test]
    fn sections_follow_the_pressure() {
        for elements in [[17, 18], [18, 17]] {
            let run = Run::pin_on_disc(elements);
            let mut state = run.state(0.0);
            assert_eq!(through(&run.problem, &state), [0.0; 2]);
            let spacing = run.problem.frame.spacing();
            let old = state.pressure.clone();
            state.pressure.rotate_right(3 + elements[0]);
            let place = through(&run.problem, &state);
            assert_relative_eq!(place[0], 3.0 * spacing[0], max_relative = 1e-9);
            assert_relative_eq!(place[1], spacing[1], max_relative = 1e-9);
            let image = Image::of(&run.problem, &state);
            let found = section(&image, &state.pressure, 0, rows(&image, 1, place[1]));
            let before = section(&image, &old, 0, rows(&image, 1, 0.0));
            for (found, before) in found[3..].iter().zip(&before) {
                assert_relative_eq!(found, before, max_relative = 1e-9);
            }
            state.pressure.fill(0.0);
            assert_eq!(through(&run.problem, &state), [0.0; 2]);
        }
    }
}
