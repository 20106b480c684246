use super::{Cause, Flavour, Format, read, write};
use crate::oddity::Oddity;
use crate::profile::{Part, Profile};

/// A rail head: an arc, its own mirror image in neither axis.
fn profile(part: Part) -> Profile {
    let arc = (-19..=20)
        .map(|at| f64::from(at) * 0.05)
        .map(|angle: f64| [0.04 * angle.sin() + 1e-3, 0.04 - 0.04 * angle.cos()]);
    let profile = Profile::new(arc.collect()).unwrap();
    if part == Part::Rail { profile } else { profile.reversed() }
}

fn formats() -> Vec<Format> {
    let mut all = vec![];
    for part in [Part::Rail, Part::Wheel] {
        all.push(Format::Simpack(part));
        for flavour in [Flavour::Keys, Flavour::Free] {
            all.push(Format::MiniProf { part, mirrored: false, flavour });
            all.push(Format::MiniProf { part, mirrored: true, flavour });
        }
        for (unit, comma) in [(1e-3, true), (1.0, false), (25.4e-3, true)] {
            all.push(Format::Columns { part, unit, upwards: comma, mirrored: !comma, comma });
        }
    }
    all
}

#[test]
fn what_is_written_reads_the_same() {
    for format in formats() {
        let profile = profile(format.part());
        let document = read(write(&profile, format).as_bytes(), format).unwrap();
        assert_eq!(document.profile.points.len(), profile.points.len());
        for (a, b) in document.profile.points.iter().zip(&profile.points) {
            assert!((a[0] - b[0]).abs() < 1e-15 && (a[1] - b[1]).abs() < 1e-15, "{format:?}");
        }
        let odd = document.findings.iter().find(|finding| finding.oddity != Oddity::Flange);
        assert_eq!(odd, None, "{format:?}");
    }
}

#[test]
fn simpack_shifts_then_mirrors_then_divides_then_inverts() {
    let text = "header.begin\n type = 1\nheader.end\nspline.begin\n comment = 'a ! b' ! c\n shift.y = 1.0\n mirror.y = 1\n \
        inversion = 1\n units.len.f = 1000\n point.begin\n! 9 9\n10 0\n20 1\n40 2 2.0\n point.end\nspline.end";
    let document = read(text.as_bytes(), Format::Simpack(Part::Wheel)).unwrap();
    let expected = [[-41e-3, 2e-3], [-21e-3, 1e-3], [-11e-3, 0.0]];
    for (a, b) in document.profile.points.iter().zip(&expected) {
        assert!((a[0] - b[0]).abs() < 1e-15 && (a[1] - b[1]).abs() < 1e-15);
    }
    assert_eq!(document.lines, [14, 13, 12]);
    assert!(document.findings.iter().any(|finding| finding.line == Some(14)));
    let error = read(text.as_bytes(), Format::Simpack(Part::Rail)).unwrap_err();
    assert_eq!(
        (error.line, error.cause),
        (2, Cause::Part { found: Part::Wheel, wanted: Part::Rail })
    );
}

#[test]
fn miniprof_heads_may_be_quoted_and_columns_in_any_order() {
    let text = "\"XYPoints=4\"\nColumnDef=A,Y,X\nXOffset=1\n\n\"0 -2 -30\n0 0 -10\n0 0 30\n";
    let format = Format::of_extension("BAN", Part::Wheel, 1.0).unwrap();
    let document = read(text.as_bytes(), format).unwrap();
    assert_eq!(document.profile.points[0], [-0.03, 0.002]);
    let told: Vec<String> = document.findings.iter().map(ToString::to_string).collect();
    assert_eq!(
        told[..2],
        ["line 3: `XOffset` is not used", "line 1: the file states 4 points and holds 3"]
    );
}

#[test]
fn columns_take_any_separator_and_errors_name_the_line() {
    let format = Format::of_extension("csv", Part::Rail, 1e-3).unwrap();
    for text in ["y;z\n-30,5;2\n0;0\n30;2", "# a\n-30.5 2\n0\t0\r\n30,2"] {
        assert_eq!(read(text.as_bytes(), format).unwrap().profile.points[0], [-30.5 * 1e-3, 2e-3]);
    }
    let error = |text: &str| read(text.as_bytes(), format).unwrap_err().to_string();
    assert_eq!(error("1 2\n3 x\n"), "line 2: `x` is not a finite number");
    assert_eq!(error("1 2\n3 nan\n"), "line 2: `nan` is not a finite number");
    assert_eq!(error("1 2\n3\n"), "line 2: 1 values in a row, and 2 are needed");
    assert_eq!(error("1 2\n3 4\n"), "line 2: the file ends after 2 points, and three are needed");
    assert_eq!(error("1 2\n3 4e9\n1 2\n"), "line 2: the point lies beyond a kilometre");
}

/// Bytes left out, changed and cut off: an error or a profile, and a profile can be made a curve.
#[test]
fn damaged_files_do_no_harm() {
    for seed in 0..4000 {
        let mut random = fastrand::Rng::with_seed(seed);
        let all = formats();
        let format = all[random.usize(..all.len())];
        let mut bytes = write(&profile(format.part()), format).into_bytes();
        for _ in 0..random.usize(1..6) {
            let at = random.usize(..bytes.len());
            match random.u8(..4) {
                0 => bytes.truncate(at.max(1)),
                1 => bytes[at] ^= 1 << random.u8(..8),
                2 => bytes[at] = b"0123456789e-+.,;\n!='\""[random.usize(..21)],
                _ => drop(bytes.drain(at..(at + random.usize(1..30)).min(bytes.len() - 1).max(at))),
            }
        }
        if let Ok(document) = read(&bytes, format) {
            assert_eq!(document.lines.len(), document.profile.points.len());
            let curve = document.profile.curve(crate::curve::Smoothing::wavelength(2e-3));
            let _ = curve.map(|curve| curve.place(curve.length() / 2.0));
        }
    }
}
