//! Scans made with a scar whose volume is known: what is found lies within its interval as often as is said.

mod coverage;
mod made;

use std::f64::consts::PI;

use super::blocks::smoothed;
use super::{Difference, NoDifference, Options, Placement};
use crate::map::HeightMap;

/// Scans of a surface with a scar.
#[derive(Debug, Clone, Copy)]
struct Made {
    points: usize,
    /// Half width and half length (points) of the groove, and its depth (m).
    groove: ([f64; 2], f64),
    /// Height (m) of the texture, and whether it is one of grinding.
    texture: (f64, bool),
    /// Noise (m) of each scan, and its length (points).
    noise: (f64, f64),
}

const PIXEL: f64 = 2e-6;

fn normal(random: &mut fastrand::Rng) -> f64 {
    (-2.0 * (1.0 - random.f64()).ln()).sqrt() * (2.0 * PI * random.f64()).cos()
}

/// Noise of a standard deviation and a length (points).
fn noise(random: &mut fastrand::Rng, n: usize, (size, length): (f64, f64)) -> Vec<f64> {
    let margin = (4.0 * length).ceil() as usize;
    let wide = n + 2 * margin;
    let white: Vec<f64> = (0..wide * wide).map(|_| size * normal(random)).collect();
    let smooth = if length > 0.0 { smoothed([wide; 2], &white, [length; 2]) } else { white };
    let gain = if length > 0.0 { (4.0 * PI).sqrt() * length } else { 1.0 };
    let inner = (0..n * n).map(|at| (at % n + margin) + wide * (at / n + margin));
    inner.map(|at| gain * smooth[at]).collect()
}

/// A texture as a sum of waves, that can be sampled anywhere: self-affine with amplitudes as k^-(1 + H), H = 0.8, or ridges
/// along y.
fn texture(random: &mut fastrand::Rng, made: &Made) -> impl Fn([f64; 2]) -> f64 + use<> {
    let size = made.points as f64 * PIXEL;
    let (height, ground) = made.texture;
    let mut waves = vec![];
    for index in 0..60 {
        let number = 2.0 * (made.points as f64 / 16.0).powf(f64::from(index) / 59.0);
        let angle = if ground { 0.1 * (random.f64() - 0.5) } else { 2.0 * PI * random.f64() };
        let amplitude = if ground { 1.0 } else { number.powf(-0.8) };
        let k = 2.0 * PI * number / size;
        waves.push((k * angle.cos(), k * angle.sin(), 2.0 * PI * random.f64(), amplitude));
    }
    let square: f64 = waves.iter().map(|wave| 0.5 * wave.3 * wave.3).sum();
    let scale = height / square.sqrt();
    move |[x, y]| {
        scale
            * waves
                .iter()
                .map(|(kx, ky, phase, a)| a * (kx * x + ky * y + phase).cos())
                .sum::<f64>()
    }
}

impl Made {
    /// Both scans and the volume (m^3) that was worn off. The groove is a part of a ball along x and y, a paraboloid; the later scan is shifted,
    /// turned and tilted.
    fn scans(&self, seed: u64) -> ([HeightMap; 2], f64, Placement) {
        let mut random = fastrand::Rng::with_seed(seed);
        let ground = texture(&mut random, self);
        let n = self.points;
        let within = |random: &mut fastrand::Rng, most: f64| most * (2.0 * random.f64() - 1.0);
        let shift = [within(&mut random, 4.0 * PIXEL), within(&mut random, 4.0 * PIXEL)];
        let placed = Placement {
            shift,
            turn: within(&mut random, 0.02),
            offset: within(&mut random, 1e-5),
            tilt: [within(&mut random, 2e-3), within(&mut random, 2e-3)],
            form: [0.0; 3],
        };
        let ([wide, long], depth) = self.groove;
        let [wide, long] = [wide * PIXEL, long * PIXEL];
        let middle = [within(&mut random, 3.0 * PIXEL), within(&mut random, 3.0 * PIXEL)];
        let scar = |[x, y]: [f64; 2]| {
            let far = ((x - middle[0]) / wide).powi(2) + ((y - middle[1]) / long).powi(2);
            depth * (1.0 - far).max(0.0)
        };
        let blank = HeightMap::new([n; 2], [PIXEL; 2], vec![0.0; n * n]).unwrap();
        let place = |at: usize| [blank.place(0, at % n), blank.place(1, at / n)];
        let own = noise(&mut random, n, self.noise);
        let before = (0..n * n).map(|at| ground(place(at)) + own[at]).collect();
        let own = noise(&mut random, n, self.noise);
        let later = |at: usize| {
            let earlier = placed.on_the_earlier(place(at));
            ground(earlier) - scar(earlier) + placed.level(place(at)) + own[at]
        };
        let after = (0..n * n).map(later).collect();
        let maps = [blank.of_heights(before), blank.of_heights(after)];
        (maps, 0.5 * PI * wide * long * depth, placed)
    }
}

/// Small, with much noise; with little; large with correlated noise; large, with ridges; 40 % of the surface.
const SETTINGS: [Made; 5] = [
    Made { points: 64, groove: ([9.0, 12.0], 3e-7), texture: (2e-7, false), noise: (3e-8, 0.0) },
    Made { points: 64, groove: ([9.0, 12.0], 2e-6), texture: (2e-7, false), noise: (3e-9, 0.0) },
    Made { points: 72, groove: ([14.0, 18.0], 1e-6), texture: (3e-7, false), noise: (2e-8, 1.5) },
    Made { points: 64, groove: ([12.0, 20.0], 1e-6), texture: (2e-7, true), noise: (1e-8, 0.0) },
    Made { points: 84, groove: ([30.0, 30.0], 2e-6), texture: (3e-7, false), noise: (1e-8, 0.0) },
];

fn compared(before: &HeightMap, after: &HeightMap) -> Result<Difference, NoDifference> {
    Difference::between(before, after, &Options::default())
}

/// A map with other heights: of its place (m) and height (m).
fn changed(map: &HeightMap, height: impl Fn([f64; 2], f64) -> f64) -> HeightMap {
    let nx = map.elements()[0];
    let place = |at: usize| [map.place(0, at % nx), map.place(1, at / nx)];
    let heights = map.heights().iter().enumerate();
    map.of_heights(heights.map(|(at, own)| height(place(at), *own)).collect())
}

/// Shift, turn, offset and tilts are those that the later scan was made with, within four of their standard uncertainties.
#[test]
fn the_placement_is_found() {
    for (made, seed) in SETTINGS.iter().zip(50..) {
        let ([before, after], _, placed) = made.scans(seed);
        let found = compared(&before, &after).unwrap();
        let numbers = |own: Placement| {
            [own.shift[0], own.shift[1], own.turn, own.offset, own.tilt[0], own.tilt[1]]
        };
        let [own, placed, by] = [found.placement, placed, found.uncertainty].map(numbers);
        for at in 0..6 {
            assert!(
                (own[at] - placed[at]).abs() < 4.0 * by[at],
                "{made:?} {at}: {own:?} {placed:?} {by:?}"
            );
        }
        // Ridges along y tell little of a shift along them.
        assert!(by[0] < 0.1 * PIXEL && found.sought, "{by:?}");
    }
}

/// A rim of half an ellipse's ring is piled up by as much as is known, apart from what is worn off.
#[test]
fn what_is_piled_up_is_told_apart() {
    let made = Made { points: 96, ..SETTINGS[3] };
    let ([before, after], worn, placed) = made.scans(7);
    let (middle, size, height) = ([0.0, 62e-6], [20e-6, 12e-6], 4e-7);
    let ridge = |place: [f64; 2]| {
        let [x, y] = placed.on_the_earlier(place);
        let far = ((x - middle[0]) / size[0]).powi(2) + ((y - middle[1]) / size[1]).powi(2);
        height * (1.0 - far).max(0.0)
    };
    let after = changed(&after, |place, own| own + ridge(place));
    let found = compared(&before, &after).unwrap();
    let piled = 0.5 * PI * size[0] * size[1] * height;
    let own = found.piled.unwrap();
    assert_eq!(found.count, [1, 1]);
    assert!((own.value - piled).abs() < 3.0 * own.standard, "{own:?} {piled}");
    assert!((found.worn.value - worn).abs() < 3.0 * found.worn.standard, "{:?} {worn}", found.worn);
    assert!((found.net.value - (found.worn.value - own.value)).abs() < 1e-9 * worn);
    assert!(found.net.standard < found.worn.standard + own.standard);
}

/// The depth is that of the groove within its uncertainty; the same for its extent, a point at each end.
#[test]
fn the_scar_has_its_size() {
    let ([before, after], _, _) = SETTINGS[1].scans(3);
    let found = compared(&before, &after).unwrap();
    let bowl = 2.0 * 2e-6 * (1.5 / 9.0_f64).powi(2);
    assert!(
        (found.depth.value - 2e-6).abs() < bowl + 4.0 * found.depth.standard,
        "{:?}",
        found.depth
    );
    let [length, width] = [found.scar.length, found.scar.width].map(|size| size / PIXEL);
    assert!((length - 24.0).abs() < 8.0 && (width - 18.0).abs() < 8.0, "{length} {width}");
    assert!(found.scar.direction.abs() > 1.2 && !found.reaches_rim && found.missing == 0);
    // The section is a parabola through the deepest point.
    let section = found.section(&before);
    let half = 9.0 * PIXEL;
    for point in section {
        let depth = 2e-6 * (1.0 - (point.place / half).powi(2)).max(0.0);
        assert!((point.before - point.after - depth).abs() < 5e-7, "{point:?} {depth}");
    }
}

/// A later map with half as many points each way, of a smaller part, and with holes gives the same volume.
#[test]
fn other_pixels_and_holes_are_allowed() {
    let made = Made {
        points: 96,
        groove: ([16.0, 20.0], 2e-6),
        texture: (2e-7, false),
        noise: (1e-8, 0.0),
    };
    let ([before, after], volume, _) = made.scans(11);
    let speck = |[x, y]: [f64; 2], own: f64| {
        let far = (x - 5e-6).hypot(y + 3e-6).min((x + 60e-6).hypot(y - 50e-6));
        if far < 5e-6 { f64::NAN } else { own }
    };
    let holed = changed(&after, speck);
    let found = compared(&before, &holed).unwrap();
    assert!(found.missing > 10, "{}", found.missing);
    assert!((found.worn.value - volume).abs() < found.worn.expanded, "{:?} {volume}", found.worn);
    let fewer = super::blocks::means(&after, 3).unwrap();
    let found = compared(&before, &fewer).unwrap();
    assert!(
        (found.net.value - volume).abs() < 2.0 * found.net.expanded,
        "{:?} {volume}",
        found.net
    );
}

/// The part in which wear is to be found may be given; a part that is not worn has nothing within its uncertainty.
#[test]
fn the_worn_part_may_be_given() {
    let ([before, after], volume, _) = SETTINGS[2].scans(5);
    let options = |worn| Options { worn: Some(worn), ..Options::default() };
    let part = [[-44e-6, 44e-6], [-54e-6, 54e-6]];
    let found = Difference::between(&before, &after, &options(part)).unwrap();
    assert!((found.worn.value - volume).abs() < found.worn.expanded, "{:?} {volume}", found.worn);
    let again = changed(&before, |_, own| own);
    let ([other, _], ..) = Made { texture: (0.0, false), ..SETTINGS[2] }.scans(6);
    let noisy = changed(&again, |[x, y], own| {
        own + other.at((x / PIXEL + 35.5).round() as usize, (y / PIXEL + 35.5).round() as usize)
    });
    let none = Difference::between(&before, &noisy, &options(part)).unwrap();
    assert!(none.worn.value.abs() < none.worn.expanded, "{:?}", none.worn);
    assert!(matches!(compared(&before, &noisy), Err(NoDifference::NothingWorn { .. })));
    let everywhere = Difference::between(&before, &after, &options([[-1.0, 1.0]; 2]));
    assert!(matches!(everywhere, Err(NoDifference::Part { outside: 0, .. })), "{everywhere:?}");
}

#[test]
fn what_cannot_be_told_is_refused() {
    let ([_, after], ..) = SETTINGS[2].scans(5);
    let ([other, _], ..) = SETTINGS[2].scans(6);
    let different = compared(&other, &after);
    let refused =
        [NoDifference::Different { kept: 0.0, most: 0.0 }, NoDifference::Turned { turn: 0.0 }];
    let kind = std::mem::discriminant(&different.unwrap_err());
    assert!(refused.iter().any(|own| std::mem::discriminant(own) == kind));
    let ([before, _], ..) = SETTINGS[3].scans(5);
    let ([noise, _], ..) = Made { texture: (0.0, false), ..SETTINGS[3] }.scans(8);
    let place = |along: f64| (along / PIXEL + 31.5).round() as usize;
    let worn = |radius: f64| {
        let deep = changed(&before, |[x, y], own| {
            let bowl = 2e-6 * (1.0 - (x.hypot(y) / radius).powi(2)).max(0.0);
            own + noise.at(place(x), place(y)) - bowl
        });
        Difference::between(&before, &deep, &Options { placed: true, ..Options::default() })
    };
    let half = worn(50e-6).unwrap().worn;
    let volume = 0.5 * PI * 50e-6 * 50e-6 * 2e-6;
    assert!((half.value - volume).abs() < 2.0 * half.expanded, "{half:?} {volume}");
    let all = worn(90e-6);
    assert!(matches!(all, Err(NoDifference::NoReference { .. })), "{all:?}");
    let speck = HeightMap::new([6; 2], [1e-6; 2], vec![0.0; 36]).unwrap();
    let tiny = compared(&before, &speck);
    assert!(tiny.is_err(), "{tiny:?}");
}

/// Without texture no shift is sought, and the volume follows from the level.
#[test]
fn a_surface_without_features_has_no_shift() {
    let made = Made { texture: (0.0, false), noise: (1e-8, 0.0), ..SETTINGS[1] };
    let ([before, after], volume, _) = made.scans(9);
    let found = compared(&before, &after).unwrap();
    assert!(!found.sought && found.placement.shift == [0.0; 2] && found.worn.place == 0.0);
    assert!(
        (found.worn.value - volume).abs() < 2.0 * found.worn.expanded,
        "{:?} {volume}",
        found.worn
    );
}
