//! Contacts of many patches: a wavy and a random surface, far from the convex shapes the rest of the
//! suite lives on.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use archard::frame::Part;
use archard::motion::Control;
use archard::solve::{Outcome, SOLVERS, Start, Status, Step, press};

use archard_case::CaseFile;

use crate::common::{Ball, Rows, at_rest, case, solver, states};
use crate::surfaces::OnAFlat;

/// Roughness without pattern between -1 and 1, one value a pair.
fn scattered(pairs: usize) -> Vec<f64> {
    (0..pairs).map(|i| ((12.9898 * i as f64 + 4.1).sin() * 43_758.545_3) % 1.0).collect()
}

/// The ball's gap with waves or scatter of some height (m) on it.
fn rough_gap(ball: &Ball, height: f64, waves: bool) -> Vec<f64> {
    let frame = ball.problem().frame;
    let scatter = scattered(frame.len());
    let bump = |pair: usize| {
        let [x, y] = frame.place(pair);
        let wave = (40.0 * x / frame.size()[0]).cos() * (52.0 * y / frame.size()[1]).sin();
        height * if waves { wave } else { scatter[pair] }
    };
    let gap: Vec<f64> =
        frame.gap().iter().enumerate().map(|(pair, gap)| gap + bump(pair)).collect();
    let lowest = gap.iter().copied().fold(f64::INFINITY, f64::min);
    gap.iter().map(|gap| gap - lowest).collect()
}

/// The fast solver converges on surfaces from smooth to rougher than the approach is deep, in a number
/// of iterations that stays moderate, and so does a wear step on them.
#[test]
fn many_patches_converge() {
    let ball = Ball { size: [0.6e-3; 2], ..Ball::pin_on_disc(96) };
    let problem = ball.problem();
    for height in [0.02e-6, 0.2e-6, 1e-6] {
        for waves in [true, false] {
            let gap = rough_gap(&ball, height, waves);
            for added in [0.0, 1e-16, 1e-15] {
                let addition = vec![added; gap.len()];
                let step = Step { gap: &gap, ..at_rest(&problem, &addition, Control::Load(10.2)) };
                let outcome = solver("conjugate_gradient", 1e-8).solve(&step, None);
                assert_eq!(outcome.status, Status::Converged, "{height:e} {waves} {added:e}");
                assert!(
                    outcome.iterations <= 40,
                    "{} at {height:e} {waves} {added:e}",
                    outcome.iterations
                );
            }
        }
    }
}

/// On a rough surface too, every solver finds the same pressures.
#[test]
fn solvers_agree_on_a_rough_surface() {
    let ball = Ball { size: [0.6e-3; 2], ..Ball::pin_on_disc(20) };
    let problem = ball.problem();
    let gap = rough_gap(&ball, 0.2e-6, false);
    let addition = vec![0.0; gap.len()];
    let step = Step { gap: &gap, ..at_rest(&problem, &addition, Control::Load(10.2)) };
    let outcomes: Vec<_> =
        SOLVERS.iter().map(|choice| solver(choice.name, 1e-9).solve(&step, None)).collect();
    let scale = crate::common::peak(&outcomes[0].pressure);
    for outcome in &outcomes[1..] {
        for (a, b) in outcome.pressure.iter().zip(&outcomes[0].pressure) {
            assert!((a - b).abs() < 1e-6 * scale, "{a:e} and {b:e}");
        }
    }
}

/// A self-affine surface of `n` by `n` elements on a flat, rms slope 0.1, pressed by 0.04 of that times E*, alone or
/// repeating itself: a twelfth or so touches. From pressures all over the frame or from nothing.
fn self_affine_contact(n: usize, repeats: bool, start: Option<&[f64]>) -> Outcome {
    let surface = OnAFlat::new(n, repeats);
    let step = surface.pressed(0.04);
    let start = start.map(|pressure| Start {
        pressure,
        displacement: &[],
        part: Some(Part::none([n; 2])),
        approach: 0.0,
    });
    let outcome = press(&*solver("conjugate_gradient", 1e-8), &step, start);
    assert_eq!(outcome.status, Status::Converged);
    outcome
}

/// What coarser elements say is a start and no more: the pressures are those that even ones lead to. On a frame that
/// divides into coarser elements, on one that does not, and on surfaces that repeat themselves.
#[test]
fn the_solution_does_not_depend_on_coarser_elements() {
    for (n, repeats) in [(128, false), (99, false), (128, true)] {
        let coarse = self_affine_contact(n, repeats, None);
        let even = self_affine_contact(n, repeats, Some(&vec![1.0; n * n]));
        let square = |values: &mut dyn Iterator<Item = f64>| values.map(|v| v * v).sum::<f64>();
        let pairs = coarse.pressure.iter().zip(&even.pressure);
        let off = square(&mut pairs.map(|(one, other)| one - other));
        let off = (off / square(&mut even.pressure.iter().copied())).sqrt();
        // Residuals of 1e-8 times what the condition makes of them.
        assert!(off < 2e-7, "{n} {repeats}: {off:e}");
        assert!(coarse.applications < even.applications, "{n} {repeats}");
    }
}

/// Counts of this program: from a first guess of Hertz's form, 50 and 46.
#[test]
fn rough_contact_takes_few_applications() {
    for (repeats, most) in [(false, 42), (true, 40)] {
        let outcome = self_affine_contact(256, repeats, None);
        assert!(outcome.applications <= most, "{} applications", outcome.applications);
    }
}

/// Waves along both axes on a frame of two by two wavelengths: crests in its middle, on its sides and at its corners, which are
/// four on surfaces that repeat themselves.
#[test]
fn spots_and_texture_of_waves_are_those_of_a_sine() {
    let text = "frame.size = [\"1 mm\", \"1 mm\"]\nframe.elements = [64, 64]\nframe.periodic = true\n\
        body.wavy.material = { young = \"210 GPa\", poisson = 0.3 }\n\
        body.wavy.profile.wave = { amplitude = \"0.5 um\", length_x = \"0.5 mm\", length_y = \"0.5 mm\" }\n\
        body.wavy.wear.archard.coefficient = \"1e-9 mm^3/(N m)\"\n\
        body.flat.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.flat.profile.flat = {}\n\
        motion.indentation = { load = \"20 MPa\", increments = 2 }\n";
    let mut rows = Rows::default();
    case(text, &[]).run(&mut [&mut rows]).unwrap();
    assert_eq!(rows.column("contact_spots"), [0.0, 4.0, 4.0]);
    let [area, largest] = ["contact_area_m2", "largest_spot_m2"].map(|name| rows.last(name));
    // Of elements, some thirty to a spot.
    assert_relative_eq!(4.0 * largest, area, max_relative = 0.1);
    // a^2 (cos u + cos v)^2 has the mean a^2, and a slope of 2 pi a / l along each axis a mean square of half its square.
    assert_relative_eq!(rows.last("rms_height_wavy_m"), 0.5e-6, max_relative = 1e-12);
    let slope = 2.0 * PI * 0.5e-6 / 0.5e-3;
    // Six neighbours at 32 to a wave: (2 pi / 32)^6 / 140.
    assert_relative_eq!(rows.last("rms_gradient_wavy"), slope, max_relative = 1e-6);
    assert!(rows.last("skewness_wavy").abs() < 1e-9);
    assert!(rows.0.iter().flatten().all(|(name, _)| name != "rms_height_flat_m"));
    // Just touching at the crests, the gap is a (2 - cos u - cos v).
    assert_relative_eq!(rows.column("mean_gap_m")[0], 1e-6, max_relative = 1e-9);
    assert!(rows.last("mean_gap_m") < 1e-6);
}

/// Flattened altogether, nothing is left of the gap.
#[test]
fn flattened_waves_have_one_spot_and_no_gap() {
    let text = "frame.size = [\"1 mm\", \"1 mm\"]\nframe.elements = [32, 32]\nframe.periodic = true\n\
        body.wavy.material = { young = \"210 GPa\", poisson = 0.3 }\n\
        body.wavy.profile.wave = { amplitude = \"0.5 um\", length_x = \"0.5 mm\", length_y = \"0.5 mm\" }\n\
        body.flat.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.flat.profile.flat = {}\n\
        motion.indentation = { load = \"2 GPa\", increments = 1 }\n";
    let mut rows = Rows::default();
    case(text, &[]).run(&mut [&mut rows]).unwrap();
    assert_eq!(rows.last("contact_spots"), 1.0);
    assert_relative_eq!(rows.last("largest_spot_m2"), 1e-6, max_relative = 1e-9);
    assert!(rows.last("mean_gap_m") < 1e-12);
}

/// A made surface on finer elements is the same surface. Its real area up to the edge between elements is near that of four times as
/// many elements to a wave where that of whole elements is not yet.
#[test]
fn the_area_up_to_the_edge_converges_before_that_of_elements() {
    let area = |elements: usize| {
        let text = format!(
            "frame.size = [\"128 um\", \"128 um\"]\nframe.elements = [{elements}, {elements}]\nframe.periodic = true\n\
             body.ground.material = {{ young = \"210 GPa\", poisson = 0.3 }}\n\
             body.ground.profile.self_affine = {{ rms_slope = 0.01, hurst = 0.8, short = \"16 um\", long = \"128 um\", seed = 5 }}\n\
             body.flat.material = {{ young = \"210 GPa\", poisson = 0.3 }}\nbody.flat.profile.flat = {{}}\n\
             motion.indentation = {{ load = \"50 MPa\", increments = 1 }}\n"
        );
        let simulation = case(&text, &[]);
        let (state, ..) = states(&simulation).unwrap().pop().unwrap();
        let touching = state.pressure.iter().filter(|pressure| **pressure > 0.0).count();
        let of_elements = touching as f64 * (128e-6 / elements as f64).powi(2);
        [state.contact_area(&simulation.problem), of_elements]
    };
    let [[edge, counted], [finest, _]] = [64, 512].map(area);
    let off = [edge, counted].map(|area| (area / finest - 1.0).abs());
    assert!(off[0] < 0.03, "{off:?}");
    assert!(off[0] < 0.5 * off[1], "{off:?}");
}

/// Surfaces that repeat themselves have no edge at which a contact could be cut off: no warning says so where crests lie at the sides.
#[test]
fn a_crest_at_the_side_of_a_periodic_frame_is_no_edge() {
    let text = "frame.centre = [\"0.25 mm\", \"0.2 mm\"]\nframe.size = [\"0.5 mm\", \"0.4 mm\"]\n\
        frame.elements = [32, 32]\nframe.periodic = true\n\
        body.wavy.material = { young = \"210 GPa\", poisson = 0.3 }\n\
        body.wavy.profile.wave = { amplitude = \"0.5 um\", length_x = \"0.5 mm\", length_y = \"0.4 mm\" }\n\
        body.flat.material = { young = \"210 GPa\", poisson = 0.3 }\nbody.flat.profile.flat = {}\n\
        motion.indentation = { load = \"20 MPa\", increments = 1 }\n";
    let resolved = CaseFile::from_text("case.toml", text, "").resolve().unwrap();
    let titles: Vec<String> = resolved.warnings.iter().map(|warning| warning.title()).collect();
    assert!(titles.iter().all(|title| !title.contains("at the edge of the frame")), "{titles:?}");
}
