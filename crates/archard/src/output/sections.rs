//! Sections of the fields along x and y through the centre of the frame.

use super::table::{Table, number};
use super::{Error, Field, Image, Surface};

/// Adds the sections of an image to a long table: for each axis, a row an element.
pub(super) fn write(table: &mut Table, progress: (&str, f64), image: &Image) -> Result<(), Error> {
    for axis in 0..2 {
        let sections: Vec<Vec<f64>> =
            image.fields.iter().map(|field| section(image, &field.values, axis)).collect();
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
) -> Result<(), Error> {
    for axis in 0..2 {
        write_axis(table, progress, axis, &surface.fields, &surface.section(axis))?;
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

/// Values along an axis on the centre line: those of the middle row or, where the line runs between
/// two rows, their mean.
fn section(image: &Image, values: &[f64], axis: usize) -> Vec<f64> {
    let [nx, _] = image.elements;
    let across = image.elements[1 - axis];
    let rows = [(across - 1) / 2, across / 2];
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

    use super::section;
    use crate::output::Image;

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
            for (i, value) in section(&image, &values, 0).into_iter().enumerate() {
                assert_relative_eq!(value, linear(image.centre(0, i), middle[1]), epsilon = 1e-13);
            }
            for (i, value) in section(&image, &values, 1).into_iter().enumerate() {
                assert_relative_eq!(value, linear(middle[0], image.centre(1, i)), epsilon = 1e-13);
            }
        }
    }
}
