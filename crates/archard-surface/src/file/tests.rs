use approx::assert_relative_eq;

use super::{Format, ReadError, Scale, read};

const MICRO: Scale = Scale { pixel: Some([2e-6, 3e-6]), unit: Some(1e-6) };

/// Three rows of four heights (um), one of them not measured.
const ROWS: [[f64; 4]; 3] =
    [[1.0, 2.0, 3.0, 4.0], [5.0, f64::NAN, 7.0, 8.0], [-9.0, 10.0, 11.0, 12.0]];

fn held(bytes: &[u8], format: Format, scale: Scale) {
    let map = read(bytes, format, scale).unwrap();
    assert_eq!((map.elements(), map.missing()), ([4, 3], 1), "{format:?}");
    for (axis, size) in [2e-6, 3e-6].into_iter().enumerate() {
        assert_relative_eq!(map.pixel()[axis], size, max_relative = 1e-6);
    }
    for (y, row) in ROWS.iter().enumerate() {
        for (x, height) in row.iter().enumerate() {
            let found = map.at(x, y);
            let same = found.is_nan() && height.is_nan() || (found - 1e-6 * height).abs() < 1e-12;
            assert!(same, "{format:?} at {x}, {y}: {found}");
        }
    }
}

/// A field of so many bytes that begins with a text.
fn field(text: &[u8], length: usize) -> Vec<u8> {
    let mut bytes = text.to_vec();
    bytes.resize(length, b' ');
    bytes
}

/// A `.sur` of those rows in nanometres.
///
/// Programs write a micrometre in Latin-1 or in UTF-8.
fn sur(bits: u16, inversion: u16) -> Vec<u8> {
    let unit = if bits == 16 { &b"\xb5m"[..] } else { "\u{b5}m".as_bytes() };
    let mut all = b"DIGITAL SURF".to_vec();
    for word in [0u16, 1, 1, 2] {
        all.extend(word.to_le_bytes());
    }
    all.extend(field(b"a surface", 30));
    all.extend(field(b"no instrument", 30));
    for word in [0u16, 1, 1, 1, 1] {
        all.extend(word.to_le_bytes());
    }
    all.extend([0; 8]);
    all.extend(bits.to_le_bytes());
    for number in [-12_000i32, 12_000, 4, 3, 12] {
        all.extend(number.to_le_bytes());
    }
    for step in [2f32, 3e-3, 1.0] {
        all.extend(step.to_le_bytes());
    }
    all.extend(["X", "Y", "Z"].iter().flat_map(|name| field(name.as_bytes(), 16)));
    all.extend([unit, b"mm", b"nm"].iter().flat_map(|unit| field(unit, 16)));
    all.extend(vec![b' '; 48]);
    for ratio in [1f32; 3] {
        all.extend(ratio.to_le_bytes());
    }
    for word in [0u16, inversion, 0] {
        all.extend(word.to_le_bytes());
    }
    all.extend([0; 12 + 14 + 4 + 10]);
    for word in [5u16, 0] {
        all.extend(word.to_le_bytes());
    }
    all.extend(vec![0; 128 + 12 + 34]);
    assert_eq!(all.len(), 512);
    all.extend(b"words");
    let sign = if inversion == 0 { 1.0 } else { -1.0 };
    let rows: Vec<[f64; 4]> = match inversion {
        2 => ROWS.iter().map(|[a, b, c, d]| [*d, *c, *b, *a]).collect(),
        3 => ROWS.iter().rev().copied().collect(),
        _ => ROWS.to_vec(),
    };
    for height in rows.iter().flatten() {
        let value = if height.is_nan() { -12_002 } else { (sign * 1e3 * height) as i32 };
        match bits {
            16 => all.extend((value as i16).to_le_bytes()),
            _ => all.extend(value.to_le_bytes()),
        }
    }
    all
}

fn sdf(kind: u8) -> Vec<u8> {
    let mut all = b"bISO-1.0".to_vec();
    all.extend(field(b"nobody", 10));
    all.extend(field(b"010120260000", 12));
    all.extend(field(b"010120260000", 12));
    for count in [4u16, 3] {
        all.extend(count.to_le_bytes());
    }
    for scale in [2e-6f64, 3e-6, 1e-6, 0.0] {
        all.extend(scale.to_le_bytes());
    }
    all.extend([0, kind, 0]);
    for height in ROWS.iter().flatten() {
        match kind {
            5 if height.is_nan() => all.extend(i16::MIN.to_le_bytes()),
            5 => all.extend((*height as i16).to_le_bytes()),
            6 if height.is_nan() => all.extend(i32::MIN.to_le_bytes()),
            6 => all.extend((*height as i32).to_le_bytes()),
            3 => all.extend((*height as f32).to_le_bytes()),
            _ => all.extend(height.to_le_bytes()),
        }
    }
    all
}

fn npy(kind: &str, fortran: bool) -> Vec<u8> {
    let order = if fortran { "True" } else { "False" };
    let mut head = format!("{{'descr': '{kind}', 'fortran_order': {order}, 'shape': (3, 4), }}");
    while (10 + head.len() + 1) % 64 != 0 {
        head.push(' ');
    }
    head.push('\n');
    let mut all = b"\x93NUMPY\x01\x00".to_vec();
    all.extend((head.len() as u16).to_le_bytes());
    all.extend(head.as_bytes());
    let place = |at: usize| if fortran { ROWS[at % 3][at / 3] } else { ROWS[at / 4][at % 4] };
    for height in (0..12).map(place) {
        match kind {
            "<f8" => all.extend(height.to_le_bytes()),
            "<f4" => all.extend((height as f32).to_le_bytes()),
            _ => all.extend(height.to_be_bytes()),
        }
    }
    all
}

fn ascii() -> Vec<u8> {
    let head = "aISO-1.0\nManufacID = x\nNumPoints = 4\nNumProfiles = 3\nXscale = 2e-6\nYscale = 3e-6\nZscale = 1e-6\n*\n";
    let rows = ROWS.map(|row| row.map(|one| one.to_string().replace("NaN", "BAD")).join(" "));
    format!("{head}{}\n*\n", rows.join("\n")).into_bytes()
}

#[test]
fn every_format_gives_the_same_map() {
    let own = Scale::default();
    for bits in [16, 32] {
        for inversion in [0, 1, 2, 3] {
            held(&sur(bits, inversion), Format::DigitalSurf, own);
        }
    }
    for kind in [3, 5, 6, 7] {
        held(&sdf(kind), Format::Sdf, own);
    }
    held(&ascii(), Format::Sdf, own);
    for (kind, fortran) in [("<f8", false), ("<f8", true), ("<f4", false), (">f8", false)] {
        held(&npy(kind, fortran), Format::Npy, MICRO);
    }
    for text in [
        "1 2 3 4\n5 nan 7 8\n-9 10 11 12\n",
        "# heights\r\n1,2,3,4\r\n5,,7,8\r\n-9,10,11,12\r\n",
        "1;2;3;4;\n5;***;7;8;\n-9;10;11;12;\n",
        "1,0\t2,0\t3\t4\n5\t\t7\t8\n-9\t10\t11\t12\n",
        "1.0, 2.0, 3.0, 4.0\n5, nan, 7, 8\n-9, 10, 11, 12\n",
    ] {
        held(text.as_bytes(), Format::Text, MICRO);
    }
}

#[test]
fn what_is_wrong_is_told() {
    let said = |bytes: &[u8], format, scale| read(bytes, format, scale).unwrap_err().to_string();
    assert!(said(&sdf(7), Format::DigitalSurf, Scale::default()).contains("it is SDF (.sdf)"));
    assert!(said(b"1 2\n3 4\n", Format::Text, Scale::default()).contains("`pixel`"));
    let pixel = Scale { unit: None, ..MICRO };
    assert!(said(b"1 2\n3 4\n", Format::Text, pixel).contains("`unit`"));
    assert!(said(&sur(16, 0), Format::DigitalSurf, MICRO).contains("leave `unit` out"));
    assert_eq!(said(b"1 2\n3 x\n", Format::Text, MICRO), "line 2: `x` is no number");
    assert!(said(b"1 2\n3\n", Format::Text, MICRO).starts_with("line 2: 1 numbers"));
    assert!(said(b"1 2\n", Format::Text, MICRO).contains("2 x 1 points make no surface"));
    assert!(said(b"nan nan\nnan nan\n", Format::Text, MICRO).contains("no point has a height"));
    assert!(said(&sur(32, 0)[..540], Format::DigitalSurf, Scale::default()).contains("cut off"));
    assert!(said(&npy("<f8", false)[..150], Format::Npy, MICRO).contains("cut off"));
}

/// Bytes left out, changed and cut off: an error or a map, and nothing else.
#[test]
fn damaged_files_do_no_harm() {
    let files: [(Vec<u8>, Format, Scale); 6] = [
        (sur(16, 2), Format::DigitalSurf, Scale::default()),
        (sur(32, 0), Format::DigitalSurf, Scale::default()),
        (sdf(5), Format::Sdf, Scale::default()),
        (ascii(), Format::Sdf, Scale::default()),
        (npy("<f8", true), Format::Npy, MICRO),
        (b"1,2;3,4\n5;6\n7;8\n".to_vec(), Format::Text, MICRO),
    ];
    for seed in 0..12_000 {
        let mut random = fastrand::Rng::with_seed(seed);
        let (bytes, format, scale) = &files[random.usize(..files.len())];
        let mut bytes = bytes.clone();
        for _ in 0..random.usize(1..6) {
            let at = random.usize(..bytes.len());
            match random.u8(..4) {
                0 => bytes.truncate(at.max(1)),
                1 => bytes[at] ^= 1 << random.u8(..8),
                2 => bytes[at] = random.u8(..),
                _ => drop(bytes.drain(at..(at + random.usize(1..30)).min(bytes.len() - 1).max(at))),
            }
        }
        match read(&bytes, *format, *scale) {
            Ok(map) => assert_eq!(map.heights().len(), map.elements().iter().product::<usize>()),
            Err(error) => assert!(!matches!(error, ReadError::Told), "{error}"),
        }
    }
}
