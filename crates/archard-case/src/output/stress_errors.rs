//! What can be believed of the largest stresses below a contact.

use archard::body::Body;
use archard::elastic::{Interface, Maxima, Maximum};
use archard::stress::MEASURES;

use crate::verdict;

/// Whether the body yields, and how far off its largest stresses and those at its interfaces may be.
pub(super) fn judged(
    (body, strengths): (&Body, &[Option<f64>]),
    maxima: &Maxima,
) -> Vec<verdict::Line> {
    let largest = maxima.largest(0);
    let used = maxima.pieces.iter().filter_map(|piece| {
        let share = maxima.largest_in(piece, 0)?.value / strengths[piece.index]?;
        Some((share, piece.index))
    });
    let most = used.max_by(|one, other| one.0.total_cmp(&other.0));
    let yields = most.map(|(share, index)| {
        let layers = body.layers.len();
        let name = if index < layers {
            format!("{}, layer {}", body.name, index + 1)
        } else {
            body.name.clone()
        };
        verdict::yields(share, &name)
    });
    let of = format!("largest equivalent stress of `{}`", body.name);
    let stated = largest.filter(|own| own.value > 0.0);
    let stated = stated.map(|own| verdict::measured(own.error / own.value, &of));
    let kinds = (0..MEASURES.len()).map(|measure| off_by_kind(maxima, measure));
    let worst = kinds.max_by(f64::total_cmp);
    let of = format!(
        "stresses on and below the surface of `{}`, over the largest of their kind",
        body.name
    );
    let of_kinds = worst.map(|error| verdict::measured(error, &of));
    let faces = maxima.interfaces.iter().map(off);
    let worst = faces.max_by(f64::total_cmp);
    let of = format!("stresses at an interface of `{}`, over the largest there", body.name);
    let at_faces = worst.map(|error| verdict::measured(error, &of));
    yields.into_iter().chain(stated).chain(of_kinds).chain(at_faces).collect()
}

/// The largest error of a kind of stress, below the surface and on it, over the largest of that kind.
fn off_by_kind(maxima: &Maxima, measure: usize) -> f64 {
    let all = [Some(&maxima.inside[measure]), maxima.surface[measure].as_ref()];
    off_of(all.into_iter().flatten())
}

/// The largest error of the stresses at an interface, over the largest of them.
fn off(face: &Interface) -> f64 {
    let sides = [Some(&face.above), face.below.as_ref()].into_iter().flatten();
    let along = sides.flat_map(|side| [&side.most, &side.least]);
    off_of([&face.pull, &face.press, &face.shear].into_iter().chain(along))
}

fn off_of<'a>(all: impl Iterator<Item = &'a Maximum>) -> f64 {
    let both = all.map(|own| [own.value.abs(), own.error]);
    let [largest, error] =
        both.fold([0.0_f64; 2], |most, own| [0, 1].map(|at| most[at].max(own[at])));
    if largest > 0.0 { error / largest } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use archard::elastic::{Interface, Maximum, Side};

    use super::off;

    /// A shear that is not known counts over what presses the interface together.
    #[test]
    fn the_worst_error_at_an_interface_counts() {
        let known = |value: f64, error: f64| Maximum { value, error, order: 2.0, place: [0.0; 3] };
        let side = || Side { most: known(200.0, 3.0), least: known(-800.0, 5.0) };
        let face = Interface {
            depth: 3e-6,
            pull: known(2.0, 1.0),
            press: known(-1000.0, 10.0),
            shear: known(144.0, 220.0),
            above: side(),
            below: Some(side()),
        };
        assert_eq!(off(&face), 0.22);
        assert_eq!(off(&Interface { shear: known(144.0, 4.0), below: None, ..face }), 0.01);
    }
}
