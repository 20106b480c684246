//! `archard surface`: a ball with a wave and a spike, prepared, said and drawn.

use std::f64::consts::TAU;
use std::fs;

use tempfile::TempDir;

use super::{archard, printed, said};

#[test]
fn a_measured_ball_is_prepared_said_and_drawn() {
    let dir = TempDir::new().unwrap();
    // A ball of 20 mm with waves of 40 um and 0.1 um amplitude along x, on points 5 um apart; heights in um.
    let height = |x: usize, y: usize| {
        let [x, y] = [x, y].map(|index| 5.0 * (index as f64 - 63.5));
        -(x * x + y * y) / 40e3 + 0.1 * (TAU * x / 40.0).sin()
    };
    let row = |y| (0..128).map(|x| height(x, y).to_string()).collect::<Vec<_>>().join(" ");
    let rows: Vec<String> = (0..128).map(row).collect();
    fs::write(dir.path().join("ball.txt"), rows.join("\n")).unwrap();
    let scale = ["surface", "ball.txt", "--set", "unit=um", "--set", "pixel=5 um"];
    let whole = printed(&archard(&dir, &scale).success());
    assert!(whole.contains("convex, radius 20.0"), "{whole}");
    assert!(whole.contains("verdict   good (2 checks)"), "{whole}");
    // A hole is one whether it is filled or not.
    let holes = rows.join("\n").replacen(&rows[9][..rows[9].find(' ').unwrap()], "nan", 1);
    fs::write(dir.path().join("holes.txt"), holes).unwrap();
    for filled in [&[][..], &["--set", "holes=fill"]] {
        let holed = [&["surface", "holes.txt"], &scale[2..], filled].concat();
        let holed = printed(&archard(&dir, &holed).success());
        assert!(holed.contains("verdict   doubtful (1 of 2 checks)"), "{holed}");
        assert!(holed.contains("of the points have no height"), "{holed}");
    }
    let prepared = [&scale[..], &["--set", "form=sphere", "-o", "ball.png"]].concat();
    let rough = printed(&archard(&dir, &prepared).success());
    assert!(rough.contains("form      convex sphere off, radius 20.0"), "{rough}");
    // Sq is 0.1 um/sqrt 2, Sdq 2 pi/40 of it.
    assert!(rough.contains("Sq        0.07") && rough.contains("Sdq       0.011"), "{rough}");
    // Points of 8 pixels, 40 um, do not resolve the waves.
    let left_out = rough.lines().find(|line| line.starts_with("40.00 um")).unwrap();
    let share = left_out.split_whitespace().nth(2).unwrap().parse::<f64>().unwrap();
    assert!(share > 99.0, "{rough}");
    let picture = fs::read(dir.path().join("ball.png")).unwrap();
    assert!(picture.starts_with(b"\x89PNG"));
    let refused = [&scale[..], &["-o", "ball.gif"]].concat();
    assert!(said(&archard(&dir, &refused).code(2)).contains(".png, .svg or .pdf"));
}
