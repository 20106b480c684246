//! Normals at the rim of a zone, whose elements do not lie all around a corner there.
//!
//! A chord of a sphere, or across a cylinder, makes the same angle with the normals at both its ends: the normal of a corner at the rim
//! follows from those of corners further in.

use std::collections::HashMap;

use glam::{DMat2, DVec2, DVec3};

/// Turns the outward normals at the corners of elements at the rim; vertex by vertex of each element with their places (m), and whether
/// elements lie all around each.
pub(super) fn turned(
    elements: &[Vec<usize>],
    places: &[[f64; 3]],
    normals: &mut [Vec<DVec3>],
    all_around: &[Vec<bool>],
) {
    let mut known: HashMap<usize, DVec3> = HashMap::new();
    let mut first: HashMap<usize, DVec3> = HashMap::new();
    let mut ends: HashMap<usize, Vec<usize>> = HashMap::new();
    for ((vertices, normals), around) in elements.iter().zip(normals.iter()).zip(all_around) {
        for ((vertex, normal), around) in vertices.iter().zip(normals).zip(around) {
            let of = if *around { &mut known } else { &mut first };
            of.insert(*vertex, *normal);
            ends.entry(*vertex).or_default().extend(vertices.iter().filter(|one| *one != vertex));
        }
    }
    // Corners without any further in wait for those next to them.
    while !first.is_empty() {
        let turn = |(vertex, normal): (&usize, &DVec3)| {
            let further = ends[vertex].iter().filter_map(|end| Some((*end, *known.get(end)?)));
            let at = |vertex: usize| DVec3::from(places[vertex]);
            let chords: Vec<_> = further.map(|(end, own)| (at(*vertex) - at(end), own)).collect();
            (!chords.is_empty()).then(|| (*vertex, by_chords(*normal, &chords)))
        };
        let found: Vec<(usize, DVec3)> = first.iter().filter_map(turn).collect();
        if found.is_empty() {
            break;
        }
        for (vertex, normal) in found {
            first.remove(&vertex);
            known.insert(vertex, normal);
        }
    }
    for (vertices, normals) in elements.iter().zip(normals) {
        for (vertex, normal) in vertices.iter().zip(normals) {
            *normal = known.get(vertex).copied().unwrap_or(*normal);
        }
    }
}

/// The normal next to a first guess that makes the same angles with chords as the normals at their other ends do, by least squares.
fn by_chords(guess: DVec3, chords: &[(DVec3, DVec3)]) -> DVec3 {
    let (t1, t2) = guess.any_orthonormal_pair();
    let (mut matrix, mut right) = (DMat2::ZERO, DVec2::ZERO);
    for (chord, own) in chords {
        let along = DVec2::new(t1.dot(*chord), t2.dot(*chord));
        matrix += DMat2::from_cols(along.x * along, along.y * along);
        right -= (*own + guess).dot(*chord) * along;
    }
    // One chord turns the normal along itself.
    let scale = matrix.x_axis.x + matrix.y_axis.y;
    let tilt = (matrix + crate::numerics::SAME * scale * DMat2::IDENTITY).inverse() * right;
    (guess + tilt.x * t1 + tilt.y * t2).normalize_or(guess)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::turned;

    /// A fan of triangles around the pole of a sphere: at the rim normals that lean inwards become those of the sphere.
    #[test]
    fn normals_at_the_rim_are_those_of_the_sphere() {
        const AROUND: usize = 7;
        let at = |angle: f64, turn: usize| {
            let turn = turn as f64 / AROUND as f64 * std::f64::consts::TAU;
            DVec3::new(angle.sin() * turn.cos(), angle.sin() * turn.sin(), angle.cos())
        };
        let mut places = vec![[0.0, 0.0, 1.0]];
        places.extend((0..AROUND).map(|turn| at(0.2, turn).to_array()));
        places.extend((0..AROUND).map(|turn| at(0.4, turn).to_array()));
        let next = |own: usize| 1 + own % AROUND;
        let mut elements = vec![];
        for own in 1..=AROUND {
            elements.push(vec![0, own, next(own)]);
            elements.push(vec![own, AROUND + own, AROUND + next(own)]);
            elements.push(vec![own, AROUND + next(own), next(own)]);
        }
        let inner = |vertex: &usize| *vertex <= AROUND;
        let guess = |vertex: &usize| {
            let own = DVec3::from(places[*vertex]);
            if inner(vertex) { own } else { (own + 0.1 * DVec3::Z).normalize() }
        };
        let each = |of: &dyn Fn(&usize) -> DVec3| -> Vec<Vec<DVec3>> {
            elements.iter().map(|own| own.iter().map(of).collect()).collect()
        };
        let mut normals = each(&guess);
        let around: Vec<Vec<bool>> =
            elements.iter().map(|own| own.iter().map(inner).collect()).collect();
        turned(&elements, &places, &mut normals, &around);
        let known = each(&|vertex| DVec3::from(places[*vertex]));
        // A tilt that is not small is known to its square.
        for (own, known) in normals.iter().flatten().zip(known.iter().flatten()) {
            assert!(own.distance(*known) < 1e-3, "{own} {known}");
        }
    }
}
