//! Zones of meshed bodies that conform, as a ball in its socket: paraboloids, and Hertz with them, do not stand for their
//! shape. What the zone holds is judged by the gaps of its mesh.

use super::Parts;
use super::words::{both, three};
use crate::case::problem::Problem;
use crate::verdict::{self, EDGES};
use archard::compliance::bem::contact::BodiesInContact;
use archard::estimate::{Contact, Estimate};
use archard::frame::Pairs;

/// The meshed body whose radius Hertz's contact is wide against, and how wide relative to it.
pub(super) fn conforms<'a>(parts: &'a Parts<'_>, contact: &Contact) -> Option<(&'a str, f64)> {
    let wide = parts.bodies.iter().filter_map(|body| {
        let finite = body.finite.as_ref()?;
        if !finite.elasticity.is_own() {
            return None;
        }
        let curvatures = body.curvatures()?;
        let share = |axis: usize| contact.semi_axes[axis] * curvatures[axis].abs();
        let share =
            [0, 1].map(share).into_iter().filter(|share| share.is_finite()).fold(0.0, f64::max);
        (share > verdict::HALF_SPACE).then_some((body.name.as_str(), share))
    });
    wide.max_by(|one, other| one.1.total_cmp(&other.1))
}

/// What is doubtful about a zone of bodies that conform.
pub(super) fn problems(
    parts: &Parts<'_>,
    estimate: &Estimate,
    (body, share): (&str, f64),
) -> Vec<Problem> {
    let message = format!(
        "the bodies conform: Hertz's contact would reach {} of the radius of `{body}`, where his theory does not hold; what is expected by it is a rough guide",
        three(share)
    );
    let conforming = Problem::warning(parts.frame_key("size"), message)
        .help("the run says by the mesh whether the contact reaches the edge of the zone");
    let worn = estimate.cap.and_then(|cap| worn_through(parts, cap.volume));
    [conforming].into_iter().chain(worn).collect()
}

/// Wear that rigid bodies of these meshes have at the edge of the zone.
fn worn_through(parts: &Parts<'_>, volume: f64) -> Option<Problem> {
    let meeting = BodiesInContact::of(parts.bodies.each_ref()).ok()?;
    let cut = reached(meeting.pairs(), volume);
    (!cut.is_empty()).then(|| {
        let message = format!(
            "the wear will reach the edge of the zone along {} by the end of the motion, by the gaps of the mesh",
            both(&cut)
        );
        Problem::warning(parts.frame_key("size"), message).judged(EDGES).help("make the zone larger, where the body goes on")
    })
}

/// The axes along which a volume (m^3) reaches the end of the pairs, as rigid bodies lose it that move together along z.
fn reached(pairs: &Pairs, volume: f64) -> Vec<&'static str> {
    let closing = |pair: usize| pairs.bases.get(pair).map_or(1.0, |basis| basis[2][2].abs());
    let least = (0..pairs.gap.len()).map(|pair| pairs.gap[pair] / closing(pair).max(f64::EPSILON));
    let least = least.fold(f64::INFINITY, f64::min);
    let depth = |pair: usize, way: f64| (way * closing(pair) - pairs.gap[pair]).max(0.0);
    let lost = |way: f64| {
        (0..pairs.gap.len()).map(|pair| pairs.areas[pair] * depth(pair, way)).sum::<f64>()
    };
    // On the way from the first touch to where all of the volume is lost by a doubled way, halve.
    let mut ways = [least, least + volume / pairs.areas.iter().sum::<f64>()];
    while lost(ways[1]) < volume {
        ways = [ways[1], least + 2.0 * (ways[1] - least)];
    }
    for _ in 0..60 {
        let middle = 0.5 * (ways[0] + ways[1]);
        ways[usize::from(lost(middle) >= volume)] = middle;
    }
    let worn = |pair: &usize| depth(*pair, ways[1]) > 0.0;
    let reach = |axis: usize, of: &dyn Fn(&usize) -> bool| {
        let places = (0..pairs.gap.len()).filter(of).map(|pair| pairs.places[pair][axis]);
        places.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], one| {
            [low.min(one), high.max(one)]
        })
    };
    let element = pairs.areas.iter().fold(0.0_f64, |most, area| most.max(area.sqrt()));
    let meets = |axis: usize| {
        let ([low, high], [least, most]) = (reach(axis, &worn), reach(axis, &|_| true));
        high + element >= most || (!pairs.mirrored[axis] && low - element <= least)
    };
    let axes = [0, 1].into_iter().filter(|&axis| meets(axis));
    axes.map(|axis| ["x", "y"][axis]).collect()
}

#[cfg(test)]
mod tests {
    use super::reached;
    use archard::frame::Pairs;

    /// A bowl of depth r^2 on 21 x 11 pairs a length apart: a cap of height h and volume pi h^2 / 2 reaches sqrt(h).
    #[test]
    fn wear_reaches_as_far_as_its_cap() {
        let grid =
            (0..21 * 11).map(|pair| [f64::from(pair % 21) - 10.0, f64::from(pair / 21) - 5.0]);
        let places: Vec<[f64; 3]> = grid.map(|[x, y]| [x, y, 0.0]).collect();
        let gap = places.iter().map(|[x, y, _]| x * x + y * y).collect();
        let pairs = Pairs {
            areas: vec![1.0; places.len()],
            places,
            bases: vec![],
            gap,
            outlines: vec![],
            elements: None,
            mirrored: [false; 2],
            closed: false,
        };
        let of_height = |height: f64| std::f64::consts::FRAC_PI_2 * height * height;
        assert_eq!(reached(&pairs, of_height(2.5_f64.powi(2))), [""; 0]);
        assert_eq!(reached(&pairs, of_height(4.7_f64.powi(2))), ["y"]);
        assert_eq!(reached(&pairs, of_height(11.0_f64.powi(2))), ["x", "y"]);
    }
}
