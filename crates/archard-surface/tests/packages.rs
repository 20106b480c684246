//! Files of other packages, which `files/make.py` wrote: all of one surface, whose heights are a formula.

use std::fs;
use std::io::{Cursor, Read, Write};
use std::path::Path;

use archard_surface::file::{Format, ReadError, Scale, read, read_up_to};
use archard_surface::{HeightMap, NoMap};
use zip::write::SimpleFileOptions;
use zip::{ZipArchive, ZipWriter};

const FILES: [&str; 11] = [
    "gwyfile.gwy",
    "surface_topography.gwy",
    "surface_topography_D.x3p",
    "surface_topography_F.x3p",
    "surface_topography_I.x3p",
    "surface_topography_L.x3p",
    "surfalize.sdf",
    "surfalize.sur",
    "surfalize.x3p",
    "x3pio.x3p",
    "surface_topography.nc",
];

fn bytes(name: &str) -> Vec<u8> {
    fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/files").join(name)).unwrap()
}

fn format(name: &str) -> Format {
    Format::of_extension(name.rsplit_once('.').unwrap().1).unwrap()
}

fn told(bytes: &[u8], format: Format) -> Result<HeightMap, ReadError> {
    read(bytes, format, Scale::default())
}

/// The heights (m) of `make.py`.
fn height(x: usize, y: usize) -> f64 {
    let [x, y] = [x, y].map(|index| index as f64);
    1e-9 * (3.0 * x - 50.0 * y + 7.0 * x * y)
}

#[test]
fn files_of_other_packages_hold_their_surface() {
    for name in FILES {
        let map = told(&bytes(name), format(name)).unwrap_or_else(|error| panic!("{name} {error}"));
        assert_eq!((map.elements(), map.missing()), ([5, 4], 1), "{name}");
        for (own, size) in map.pixel().into_iter().zip([2e-6, 3e-6]) {
            assert!((own / size - 1.0).abs() < 1e-6, "{name}: {own}");
        }
        // Half a step of 16 bits over the range of 162 nm, and seven digits of single precision.
        let step = if name.ends_with("_I.x3p") { 0.5 * 162e-9 / 65535.0 } else { 1e-14 };
        // The middle of the range stands as an offset in the head of a .sur; SurfaceTopography leaves it out too.
        let offset = if name.ends_with(".sur") { map.at(0, 0) - height(0, 0) } else { 0.0 };
        for (x, y) in (0..20).map(|at| (at % 5, at / 5)) {
            let off = map.at(x, y) - height(x, y) - offset;
            assert_eq!(off.is_nan(), (x, y) == (1, 2), "{name} at {x}, {y}");
            assert!(off.is_nan() || off.abs() < 1.1 * step, "{name} at {x}, {y}: {off:e}");
        }
    }
}

#[test]
fn a_wrong_ending_is_told_with_the_right_one() {
    let all = [
        Format::DigitalSurf,
        Format::Sdf,
        Format::X3p,
        Format::Gwyddion,
        Format::NetCdf,
        Format::Text,
    ];
    for name in FILES {
        assert_eq!(Format::of_bytes(&bytes(name)), Some(format(name)), "{name}");
        for other in all.into_iter().filter(|other| *other != format(name)) {
            let error = told(&bytes(name), other).unwrap_err().to_string();
            let wanted = format!("no {} file: it is {}", other.name(), format(name).name());
            assert!(error.contains(&wanted), "{name}: {error}");
        }
    }
    let picture = told(b"\x89PNG\r\n\x1a\n...", Format::X3p).unwrap_err().to_string();
    assert!(picture.contains("picture (PNG)") && picture.contains("save it as"), "{picture}");
    let empty = pack(&[("data.txt", b"1 2")]);
    let error = told(&empty, Format::X3p).unwrap_err().to_string();
    assert!(error.contains("zip archive"), "{error}");
    assert!(told(b"", Format::Gwyddion).unwrap_err().to_string().contains("begins with ``"));
}

/// The files in an archive.
fn unpack(bytes: &[u8]) -> Vec<(String, Vec<u8>)> {
    let mut archive = ZipArchive::new(Cursor::new(bytes)).unwrap();
    let names: Vec<String> = archive.file_names().map(|name| name.unwrap().into_owned()).collect();
    let mut own = |name: String| {
        let mut bytes = vec![];
        archive.by_name(&name).unwrap().read_to_end(&mut bytes).unwrap();
        (name, bytes)
    };
    names.into_iter().map(&mut own).collect()
}

fn pack<B: AsRef<[u8]>>(files: &[(&str, B)]) -> Vec<u8> {
    let mut archive = ZipWriter::new(Cursor::new(vec![]));
    for (name, bytes) in files {
        archive.start_file(*name, SimpleFileOptions::default()).unwrap();
        archive.write_all(bytes.as_ref()).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

/// The archive with words of its head replaced, and with other points if there are any.
fn changed(name: &str, words: &[[&str; 2]], points: Option<&[u8]>) -> Vec<u8> {
    let mut files = unpack(&bytes(name));
    files.retain(|(name, _)| name != "md5checksum.hex");
    for (name, bytes) in &mut files {
        match (&**name, points) {
            ("main.xml", _) => {
                let text = String::from_utf8(bytes.clone()).unwrap();
                let replaced = words.iter().fold(text, |text, [old, new]| {
                    assert!(text.contains(old), "{old}");
                    text.replace(old, new)
                });
                *bytes = replaced.into_bytes();
            }
            ("bindata/data.bin", Some(points)) => *bytes = points.to_owned(),
            _ => {}
        }
    }
    let files: Vec<_> = files.iter().map(|(name, bytes)| (&**name, bytes)).collect();
    pack(&files)
}

#[test]
fn what_is_wrong_in_an_archive_is_told() {
    let error = |bytes: Vec<u8>| told(&bytes, Format::X3p).unwrap_err().to_string();
    let name = "surfalize.x3p";
    let whole = unpack(&bytes(name));
    let points = &whole.iter().find(|(name, _)| name == "bindata/data.bin").unwrap().1;
    assert!(told(&changed(name, &[], None), Format::X3p).is_ok());
    let mut other = points.clone();
    other[3] ^= 1;
    let said = error(changed(name, &[], Some(&other)));
    assert!(said.contains("checksum of bindata/data.bin"), "{said}");
    for (words, wanted) in [
        (["<FeatureType>SUR", "<FeatureType>PCL"], "PCL, not of a surface"),
        (["<SizeX>5", "<SizeX>1"], "1 x 4 points"),
        (["<SizeX>5", "<SizeX>five"], "SizeX is `five`"),
        (["<SizeZ>1", "<SizeZ>2"], "several layers"),
        (["<AxisType>I", "<AxisType>A"], "CX lists places"),
        (["<DataType>D</DataType>", ""], "no Record1/Axes/CZ/DataType"),
        (["<Increment>2e-06", "<Increment>0"], "a pixel of 0e0 x 3e-6 m"),
        (["bindata/data.bin", "bindata/none.bin"], "bindata/none.bin"),
        (["</p:ISO5436_2>", ""], "is no XML"),
    ] {
        let said = error(changed(name, &[words], None));
        assert!(said.contains(wanted), "{words:?}: {said}");
    }
    // The sum of the head stands in a file of its own.
    let mut files = whole.clone();
    files[0].1.push(b' ');
    assert_eq!(files[0].0, "main.xml");
    let files: Vec<_> = files.iter().map(|(name, bytes)| (&**name, bytes)).collect();
    assert!(error(pack(&files)).contains("checksum of main.xml"));
}

/// Archives that unpack to more than their surface, and heads of surfaces that nobody has the memory for.
#[test]
fn bombs_are_not_unpacked() {
    let error = |bytes: &[u8]| told(bytes, Format::X3p).unwrap_err().to_string();
    let bomb = changed("surfalize.x3p", &[], Some(&vec![0; 1 << 26]));
    assert!(bomb.len() < 100_000);
    let said = error(&bomb);
    assert!(said.contains("67108864 bytes, where at most 160"), "{said}");
    let said = error(&pack(&[("main.xml", vec![b' '; 1 << 26])]));
    assert!(said.contains("main.xml: 67108864 bytes"), "{said}");
    let said = error(&pack(&[("main.xml", "<a>".repeat(300_000))]));
    assert!(said.contains("is no XML"), "{said}");
    let laughs = "<!DOCTYPE a [<!ENTITY a \"ha\"><!ENTITY b \"&a;&a;\">]><a>&b;</a>";
    assert!(error(&pack(&[("main.xml", laughs)])).contains("is no XML"));

    let size = [["<SizeX>5", "<SizeX>20000"], ["<SizeY>4", "<SizeY>20000"]];
    let huge = changed("surfalize.x3p", &size, None);
    assert!(error(&huge).contains("160 bytes, and its points need 3200000000"));
    let said = read_up_to(&huge, Format::X3p, Scale::default(), 1_000_000).unwrap_err();
    let elements = [20_000, 20_000];
    assert_eq!(said, ReadError::Map(NoMap::Room { elements, most: 1_000_000 }));
    let wanted = "20000 x 20000 points take 3.2 GB, and there is room for 1.0 million points";
    assert!(said.to_string().starts_with(wanted), "{said}");
    // Sizes whose product is beyond all numbers.
    let size =
        [["<SizeX>5", "<SizeX>18446744073709551615"], ["<SizeY>4", "<SizeY>18446744073709551615"]];
    assert!(error(&changed("surfalize.x3p", &size, None)).contains("there is room for"));
}

/// What the parser would take minutes for is refused by a count; what is in a text is no attribute.
#[test]
fn attributes_without_end_are_not_parsed() {
    let repeated = |before: &str, one: &dyn Fn(usize) -> String, after: &str| {
        let all: String = (0..20_000).map(one).collect();
        pack(&[("main.xml", format!("{before}{all}{after}"))])
    };
    for hostile in [
        repeated("<a ", &|at| format!("a{at}=\"\" "), "/>"),
        repeated("<a ", &|at| format!("xmlns:a{at} = 'u' "), "/>"),
        repeated("", &|at| format!("<a xmlns:a{at}=\"u\">"), ""),
    ] {
        let error = told(&hostile, Format::X3p).unwrap_err().to_string();
        assert!(error.contains("more than 1000 attributes"), "{error}");
    }
    let comment =
        format!("<FeatureType>SUR</FeatureType><Comment>{}</Comment>", "a = 1 ".repeat(2000));
    let words = [["<FeatureType>SUR</FeatureType>", &*comment]];
    assert!(told(&changed("surfalize.x3p", &words, None), Format::X3p).is_ok());
}

/// NetCDF without what a surface needs, and of the version that is HDF5.
#[test]
fn what_is_wrong_in_a_netcdf_file_is_told() {
    let whole = bytes("surface_topography.nc");
    let error = |bytes: &[u8]| told(bytes, Format::NetCdf).unwrap_err().to_string();
    let replaced = |old: &[u8], new: &[u8]| {
        let at = whole.windows(old.len()).position(|own| own == old).unwrap();
        [&whole[..at], new, &whole[at + old.len()..]].concat()
    };
    assert!(error(&replaced(b"heights", b"weights")).contains("without a variable `heights`"));
    assert!(error(&whole[..700]).contains("it was cut off"));
    assert!(error(&replaced(b"CDF\x02", b"CDF\x05")).contains("NetCDF of version 5"));
    let hdf = error(b"\x89HDF\r\n\x1a\n\0\0\0\0");
    assert!(hdf.contains("NetCDF 4") && hdf.contains(".nc (NetCDF 3)"), "{hdf}");
    // Heights and marks end there; the places along x and y, which are not needed, follow.
    for end in 0..780 {
        assert!(told(&whole[..end], Format::NetCdf).is_err(), "{end}");
    }
}

/// Bytes of a file changed, taken out and cut off.
fn damage(bytes: &mut Vec<u8>, random: &mut fastrand::Rng) {
    for _ in 0..random.usize(1..5) {
        let at = random.usize(..bytes.len());
        match random.u8(..4) {
            0 if random.bool() => bytes.truncate(at.max(1)),
            0 | 1 => bytes[at] ^= 1 << random.u8(..8),
            2 => bytes[at] = random.u8(..),
            _ => drop(bytes.drain(at..(at + random.usize(1..9)).min(bytes.len() - 1).max(at))),
        }
    }
}

/// Each of 2,000 damaged files of a format gives a map of as many heights as it has points, or an error.
#[test]
fn damaged_files_do_no_harm() {
    let held = |bytes: &[u8], format: Format| {
        if let Ok(map) = told(bytes, format) {
            assert_eq!(map.heights().len(), map.elements().iter().product::<usize>());
        }
    };
    let names: [&[&str]; 5] = [&FILES[..2], &FILES[2..6], &FILES[6..7], &FILES[7..8], &FILES[10..]];
    for (seed, names) in (0..).zip(names) {
        let mut random = fastrand::Rng::with_seed(seed);
        for _ in 0..2_000 {
            let name = names[random.usize(..names.len())];
            let mut bytes = bytes(name);
            damage(&mut bytes, &mut random);
            held(&bytes, format(name));
        }
    }
    // What is in an archive is changed before it is packed, and carries no checksum that would tell.
    let whole = unpack(&changed("surface_topography_I.x3p", &[["MD5Checksum", "Sum"]], None));
    let mut random = fastrand::Rng::with_seed(5);
    for _ in 0..2_000 {
        let mut files = whole.clone();
        let at = random.usize(..files.len());
        damage(&mut files[at].1, &mut random);
        let files: Vec<_> = files.iter().map(|(name, bytes)| (&**name, bytes)).collect();
        held(&pack(&files), Format::X3p);
    }
}
