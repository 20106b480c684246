//! Planes of rolling: the parts of a frame in which bodies that roll wear evenly.
//!
//! Where pairs form rows, each row is a line. Otherwise the frame is cut into strips along the direction, as wide
//! as a mean pair, and a pair takes part in those across which its part of the surface lies. Whatever its pairs
//! lose then keeps its volume: a field that is spread over lines and taken back to the pairs has the same integral.

use super::pairs::Pairs;
use super::{ContactFrame, Direction};

/// A strip of a frame along the direction of rolling.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// The place of its middle across the direction, along the other axis (m).
    pub place: f64,
    /// Its width (m), without mirror images.
    pub width: f64,
    /// The pairs that particles pass in it; in rows, in that order.
    pub passages: Vec<Passage>,
}

/// A pair that particles pass in a line of rolling.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Passage {
    /// The pair.
    pub pair: usize,
    /// How much of the pair lies in the line: 1 in rows.
    pub share: f64,
    /// How often a particle passes to the pair, the mean over the width of the line: 1 in rows.
    pub times: f64,
}

impl Line {
    /// The mean of a field over the line.
    pub fn mean(&self, field: &[f64]) -> f64 {
        let sum: f64 = self.passages.iter().map(|one| one.times * field[one.pair]).sum();
        let times: f64 = self.passages.iter().map(|one| one.times).sum();
        if times > 0.0 { sum / times } else { 0.0 }
    }
}

/// The rows of a grid.
pub(super) fn rows(frame: &ContactFrame, direction: Direction) -> Vec<Line> {
    let across = 1 - direction.axis;
    let line = |pairs: Vec<usize>| {
        let first = pairs.first().copied().unwrap_or_default();
        let corners = frame.outline(first).into_iter().map(|corner| corner[across]);
        let lowest = corners.clone().fold(f64::INFINITY, f64::min);
        Line {
            place: frame.place(first)[across],
            width: corners.fold(f64::NEG_INFINITY, f64::max) - lowest,
            passages: pairs
                .into_iter()
                .map(|pair| Passage { pair, share: 1.0, times: 1.0 })
                .collect(),
        }
    };
    direction.lines(frame.elements()).map(|pairs| line(pairs.collect())).collect()
}

/// Strips about as wide as the side (m) of a mean pair, over which a contact rolls in one passage.
pub(super) fn strips(direction: Direction, pairs: &Pairs, side: f64) -> Vec<Line> {
    let across = 1 - direction.axis;
    let corners = pairs.outlines.iter().flatten().map(|corner| corner[across]);
    let lowest = corners.clone().fold(f64::INFINITY, f64::min);
    let highest = corners.fold(f64::NEG_INFINITY, f64::max);
    let count = ((highest - lowest) / side).round().max(1.0);
    let width = (highest - lowest) / count;
    let strip = |index: usize| [lowest + index as f64 * width, lowest + (index + 1) as f64 * width];
    let line = |index: usize| {
        let [low, high] = strip(index);
        Line { place: 0.5 * (low + high), width, passages: vec![] }
    };
    let mut lines: Vec<Line> = (0..count as usize).map(line).collect();
    for (pair, outline) in pairs.outlines.iter().enumerate() {
        let parts: Vec<f64> =
            (0..lines.len()).map(|index| area_within(outline, across, strip(index))).collect();
        let whole: f64 = parts.iter().sum();
        for (line, part) in lines.iter_mut().zip(parts).filter(|(_, part)| *part != 0.0) {
            let times = part.abs() / (width * side);
            line.passages.push(Passage { pair, share: part / whole, times });
        }
    }
    lines
}

/// The area of a polygon seen along z between two values of a coordinate, positive in one sense of its corners.
fn area_within(corners: &[[f64; 3]], axis: usize, [low, high]: [f64; 2]) -> f64 {
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    let beside = |(a, b): (&[f64; 3], &[f64; 3])| {
        let [from, to] = [a[axis].clamp(low, high), b[axis].clamp(low, high)];
        if from == to {
            return 0.0;
        }
        let at = |place: f64| {
            let share = (place - a[axis]) / (b[axis] - a[axis]);
            a[1 - axis] + share * (b[1 - axis] - a[1 - axis])
        };
        0.5 * (at(from) + at(to)) * (to - from)
    };
    edges.map(beside).sum()
}

#[cfg(test)]
mod tests {
    use approx::assert_relative_eq;

    use super::super::{ContactFrame, Direction, Pairs};

    /// A triangulated rectangle of 8 by 5 (m) in the half plane y >= 0, its inner corners shaken; a pair a triangle.
    fn triangles(mirrored: bool) -> ContactFrame {
        let (nx, ny) = (8, 5);
        let corner = |ix: usize, iy: usize| {
            let inside = ix > 0 && ix < nx && iy > 0 && iy < ny;
            let shake = |factor: f64| {
                if inside { 0.2 * (factor * (ix * 7 + iy * 3) as f64).sin() } else { 0.0 }
            };
            [ix as f64 - 4.0 + shake(1.7), iy as f64 + shake(2.9), 0.0]
        };
        let mut outlines = vec![];
        for iy in 0..ny {
            for ix in 0..nx {
                let [a, b] = [corner(ix, iy), corner(ix + 1, iy)];
                let [c, d] = [corner(ix + 1, iy + 1), corner(ix, iy + 1)];
                outlines.extend([vec![a, b, c], vec![a, c, d]]);
            }
        }
        if !mirrored {
            let image = |outline: &Vec<[f64; 3]>| {
                outline.iter().rev().map(|[x, y, z]| [*x, -y, *z]).collect::<Vec<_>>()
            };
            outlines.extend(outlines.iter().map(image).collect::<Vec<_>>());
        }
        let area = |[a, b, c]: [[f64; 3]; 3]| {
            0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs()
        };
        let images = if mirrored { 2.0 } else { 1.0 };
        let of = |outline: &Vec<[f64; 3]>| [outline[0], outline[1], outline[2]];
        let middle = |[a, b, c]: [[f64; 3]; 3]| [0, 1, 2].map(|i| (a[i] + b[i] + c[i]) / 3.0);
        let pairs = Pairs {
            places: outlines.iter().map(|outline| middle(of(outline))).collect(),
            areas: outlines.iter().map(|outline| images * area(of(outline))).collect(),
            gap: vec![0.0; outlines.len()],
            mirrored: [false, mirrored],
            outlines,
            ..Pairs::default()
        };
        ContactFrame::described(pairs).unwrap()
    }

    /// What is spread over strips keeps its integral, and what is even all over stays even.
    #[test]
    fn strips_keep_volumes_and_evenness() {
        for mirrored in [false, true] {
            let frame = triangles(mirrored);
            for axis in if mirrored { 0..1 } else { 0..2 } {
                let flow = frame.flow(Direction { axis, reversed: false }).unwrap();
                let images = if mirrored { 2.0 } else { 1.0 };
                let spread = |field: &[f64]| {
                    let mut depth = vec![0.0; field.len()];
                    let mut section = 0.0;
                    for line in flow.lines().iter() {
                        let sum: f64 =
                            line.passages.iter().map(|one| one.times * field[one.pair]).sum();
                        section += images * line.width * sum;
                        for one in &line.passages {
                            depth[one.pair] += one.share * sum;
                        }
                    }
                    (depth, section)
                };
                let field: Vec<f64> =
                    (0..frame.len()).map(|pair| 1.0 + (pair as f64).sin()).collect();
                let (depth, section) = spread(&field);
                let volume = frame.integrate(&field) / flow.advance();
                assert_relative_eq!(section, volume, max_relative = 1e-12);
                let length = frame.size()[axis];
                assert_relative_eq!(
                    frame.integrate(&depth),
                    length * section,
                    max_relative = 1e-12
                );
                let (even, _) = spread(&vec![1.0; frame.len()]);
                for depth in even {
                    assert_relative_eq!(depth, length / flow.advance(), max_relative = 1e-12);
                }
            }
        }
    }

    /// Half of a symmetric frame is passed as the whole: by fields along the direction, which are even, and across it,
    /// which are odd.
    #[test]
    fn mirror_images_are_passed_too() {
        let [half, whole] = [true, false].map(triangles);
        for reversed in [false, true] {
            let direction = Direction { axis: 0, reversed };
            let along = |[x, y]: [f64; 2]| (x + 0.3 * y * y).sin();
            let across = |[x, y]: [f64; 2]| y * x.cos();
            let [of_half, of_whole] = [&half, &whole].map(|frame| {
                let flow = frame.flow(direction).unwrap();
                let places = || (0..frame.len()).map(|pair| frame.place(pair));
                let [one, two]: [Vec<f64>; 2] =
                    [places().map(along).collect(), places().map(across).collect()];
                let [gained, lateral] = flow.gained([&one, &two]);
                [gained, lateral, flow.on_the_way(&one)]
            });
            for (of_half, of_whole) in of_half.iter().zip(&of_whole) {
                for (half, whole) in of_half.iter().zip(of_whole) {
                    assert_relative_eq!(half, whole, epsilon = 1e-12);
                }
            }
        }
    }
}
