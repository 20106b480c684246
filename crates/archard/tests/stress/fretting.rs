//! Points of a line of contact in partial slip, by the tractions of Cattaneo and Mindlin: the paths that they go through over a cycle are
//! those of McEwen's field, once for each ellipse of traction.

use std::f64::consts::PI;

use archard::Contact;
use archard::body::profile::Cylinder;
use archard::closed_form::sliding_line;
use archard::elastic::{Criterion, Cycle, Damage, DamageModel, Endurance};
use archard::motion::Control;
use archard::stress::Components;
use archard::stress::criteria::Elastic;

use crate::{bodies, pressed};

/// Half-width of the contact (m), and its friction.
const HALF: f64 = 1e-4;
const FRICTION: f64 = 0.6;
const NONE: Components = [0.0; 6];

/// Ellipses of slip of an instant by their factor and their half-width over that of the contact.
type Ellipses = [(f64, f64); 3];

/// From one end of the cycle, as the zone of backward slip grows inwards, and the same the other way.
fn ellipses() -> Vec<Ellipses> {
    let stick = 0.5;
    let widths = [1.0, 0.9, 0.75, 0.6, stick];
    let there = widths.map(|width| [(1.0 - 2.0, 1.0), (2.0, width), (-1.0, stick)]);
    let back = there.map(|ellipses| ellipses.map(|(factor, width)| (-factor, width)));
    there.into_iter().chain(back).collect()
}

/// The contact, so many elements over the frame of twice its width, and its peak pressure (Pa).
fn line(elements: usize) -> (Contact, f64) {
    let (radius, modulus) = (1e-2, 210e9 / 0.91 / 2.0);
    let load = PI * modulus * HALF * HALF / (4.0 * radius) * 1e-3;
    let profile = Cylinder::along_y(radius).unwrap();
    let solved = Contact::between(bodies(profile), Control::Load(load)).unwrap();
    let contact = solved.line([4.0 * HALF, 1e-3], elements).solve().unwrap();
    (contact, 2.0 * load / 1e-3 / (PI * HALF))
}

/// The cycle of body 1.
fn cycle((contact, peak): &(Contact, f64)) -> Cycle {
    let ellipse = |x: f64, width: f64| width * (1.0 - (x / width).powi(2)).max(0.0).sqrt();
    let instants = ellipses().into_iter().map(|ellipses| {
        pressed(contact, 0, |[x, _], _| {
            let sum = ellipses.iter().map(|(factor, width)| factor * ellipse(x / HALF, *width));
            FRICTION * peak * sum.sum::<f64>()
        })
    });
    Cycle::of(instants.collect(), 0)
}

/// The path of a point by McEwen's field, over the peak pressure; lengths over the half-width.
fn known([x, z]: [f64; 2]) -> Vec<Components> {
    let still = sliding_line::stress([x, z], 0.0, 0.3);
    let instant = |ellipses: &Ellipses| {
        ellipses.iter().fold(still, |sum, (factor, width)| {
            let place = [x / width, z / width];
            let [slid, pressed] = [1.0, 0.0].map(|mu| sliding_line::stress(place, mu, 0.3));
            std::array::from_fn(|i| sum[i] + FRICTION * factor * width * (slid[i] - pressed[i]))
        })
    };
    ellipses().iter().map(instant).collect()
}

#[test]
fn a_point_under_fretting_tires_as_its_path_says() {
    let line = line(256);
    let (peak, found) = (line.1, cycle(&line));
    let depths: Vec<f64> = (2..40).map(|step| f64::from(step) * 0.02 * HALF).collect();
    for criterion in [Criterion::Crossland(0.3), Criterion::DangVan(0.3)] {
        let found = found.fatigue(&criterion, (&depths, (&NONE, &NONE))).unwrap();
        let places = (-150..=150).map(|step| f64::from(step) * 0.01);
        let all = places.flat_map(|x| (2..40).map(move |step| [x, f64::from(step) * 0.02]));
        let known = all.map(|place| criterion.of(&known(place))).fold(0.0, f64::max);
        let (off, error) = ((found.value / peak - known).abs(), found.error / peak);
        assert!(off < error + 5e-3, "{}: {found:?} for {known}", criterion.name());
        assert!(error < 0.05 * known, "{}: {found:?}", criterion.name());
    }
}

/// Far below the contact a stress that swings with friction is all that there is: uniaxial, from -s to s about a mean.
#[test]
fn a_stress_that_swings_with_friction_is_that_of_the_bulk_far_below() {
    let line = line(32);
    let (peak, found) = (line.1, cycle(&line));
    let (young, swing, mean) = (210e9, 100.0 * peak, 30.0 * peak);
    let even = |xx: f64| [xx, 0.0, 0.0, 0.0, 0.0, 0.0];
    let most = swing + mean;
    let topper = Criterion::SmithWatsonTopper(Elastic { young, poisson: 0.3 });
    let uniaxial = [
        (Criterion::Crossland(0.3), swing / 3f64.sqrt() + 0.3 * most / 3.0),
        (Criterion::DangVan(0.3), 0.5 * swing + 0.3 * most / 3.0),
        (Criterion::Findley(0.3), 0.5 * (0.3 * most + (0.3 * most).hypot(swing))),
        (topper, most * swing / young),
    ];
    let deep = [1000.0 * HALF];
    for (criterion, known) in uniaxial {
        let added = (&even(mean), &even(-swing));
        let found = found.fatigue(&criterion, (&deep, added)).unwrap();
        assert!((found.value / known - 1.0).abs() < 1e-4, "{}: {found:?}", criterion.name());
    }
    // Where friction pushes body 1 forward, once, and to nothing: pulled then, or pressed.
    let once = [0.0, 0.3].map(|mu| pressed(&line.0, 0, |_, pressure| mu * pressure));
    let once = Cycle::of(once.into(), 0);
    for (swing, known) in [(swing, 0.5), (-swing, 0.0)] {
        let found = once.fatigue(&topper, (&deep, (&NONE, &even(swing)))).unwrap().value;
        assert!((found * young / (swing * swing) - known).abs() < 1e-4, "{swing}: {found}");
    }
}

/// Crossland's criterion at depths of 0.05 to 0.8 half-widths, with a life that falls with the fifth power of it.
fn tiring(peak: f64) -> DamageModel {
    DamageModel {
        criterion: Criterion::Crossland(0.3),
        endurance: Endurance { strength: 30.0 * peak, exponent: -0.2 },
        depths: (0..16).map(|step| 0.05 * (1.0 + f64::from(step)) * HALF).collect(),
        added: [NONE; 2],
    }
}

/// The largest over places along the contact of something of that place.
fn worst(of: impl Fn(f64) -> f64) -> f64 {
    (-60..=60).map(|step| of(f64::from(step) * 0.02)).fold(0.0, f64::max)
}

/// The share of a life that a cycle takes, with all over the peak pressure: by N cycles of 2 N halves.
fn share(place: [f64; 2]) -> f64 {
    let value = Criterion::Crossland(0.3).of(&known(place));
    2.0 * (value / 30.0).powi(5)
}

#[test]
fn damage_without_wear_is_cycles_over_a_life() {
    let line = line(128);
    let cycle = cycle(&line);
    let mut damage = Damage::new(tiring(line.1));
    assert!(damage.so_far().is_none());
    let none = vec![0.0; 128];
    for cycles in [1.0, 2.0, 100.0, 1e10] {
        damage.pass(&cycle, cycles, &none);
    }
    let found = damage.so_far().unwrap();
    let each = found.rows.iter().filter(|[depth, ..]| *depth < 0.4 * HALF).step_by(4);
    for [depth, all, left] in each {
        let known = 1e10 * worst(|x| share([x, depth / HALF]));
        assert!((all / known - 1.0).abs() < 0.03 && all == left, "{depth}: {all} for {known}");
    }
    let known = worst(|x| share([x, 0.05]));
    let [largest, error] = found.largest;
    assert!((largest - 1e10 * known).abs() < error + 0.03 * largest, "{found:?} for {known}");
    assert!((found.left[0], found.through) == (largest, false) && error < 0.2 * largest);
    assert!((largest > 1.0) && (found.place[2] / HALF + 0.05).abs() < 1e-9);
    let [life, off] = found.life.unwrap();
    assert!((life * known - 1.0).abs() < off / life + 0.03 && off < 0.25 * life, "{found:?}");
}

#[test]
#[ignore = "long: in .ci/long"]
fn damage_under_a_surface_that_wears_evenly_is_an_integral_on_the_way_up() {
    let line = line(128);
    let cycle = cycle(&line);
    let mut damage = Damage::new(tiring(line.1));
    let (cycles, worn) = (1e6, 0.3);
    for station in 1..=30 {
        let passed = f64::from(station) / 30.0;
        damage.pass(&cycle, passed * cycles, &vec![passed * worn * HALF; 128]);
    }
    let found = damage.so_far().unwrap();
    // Simpson's rule over the cycles that a point is there; above the first depth that counts.
    let known = |depth: f64| {
        let steps = 40;
        let there = (depth / worn).min(1.0);
        worst(|x| {
            let sum = (0..=steps).map(|step| {
                let weight = match step {
                    0 => 1.0,
                    _ if step == steps => 1.0,
                    _ => f64::from(2 + 2 * (step % 2)),
                };
                let passed = there * f64::from(step) / f64::from(steps);
                weight * share([x, (depth - passed * worn).max(0.05)])
            });
            cycles * there * sum.sum::<f64>() / 3.0 / f64::from(steps)
        })
    };
    for row in [2, 12, 24, 40] {
        let [depth, all, left] = found.rows[row];
        let known = known(depth / HALF);
        assert!((all / known - 1.0).abs() < 0.05, "{depth}: {all} for {known}");
        assert!(if depth < worn * HALF { left == 0.0 } else { left == all }, "{depth}: {left}");
    }
    let most = found.rows.iter().map(|[_, all, _]| *all).fold(0.0, f64::max);
    assert!(found.largest[0] == most && !found.through);
    // What is worn off takes its damage with it.
    damage.pass(&cycle, 1.5 * cycles, &vec![0.9 * HALF; 128]);
    let found = damage.so_far().unwrap();
    assert!(found.left[0] == 0.0 && found.through && found.largest[0] >= most);
}
