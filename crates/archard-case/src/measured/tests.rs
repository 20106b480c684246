use super::{Error, Table};
use archard::units::Measure;

fn table(text: &str) -> Table {
    Table::read("scars.csv", text.as_bytes()).unwrap()
}

fn refused(text: &str) -> String {
    Table::read("scars.csv", text.as_bytes()).unwrap_err().to_string()
}

/// 10 m and 1.5 um, whatever the notation.
#[test]
fn headers_and_separators_of_all_kinds() {
    for text in [
        "distance_m,depth_um\n10,1.5\n",
        "Distance [m];Depth (um)\r\n10;1,5\r\n",
        "\u{feff}distance / mm\tdepth / \u{b5}m\n10000\t1,5\n",
        "# pin 3\n\n Distance (km) , depth [nm]\n\n0.01,1500\n,\n",
        "distance_m,depth_mm\n10,\"0,0015\"\n",
    ] {
        let table = table(text);
        assert_eq!(table.names().collect::<Vec<_>>(), ["distance", "depth"], "{text}");
        let value = |name| table.all_numbers(name, &Measure::LENGTH).unwrap();
        assert_eq!((value("distance"), value("depth")), (vec![10.0], vec![1.5e-6]), "{text}");
    }
}

/// What spreadsheets write by themselves: Latin-1, where the micro sign is one byte, and UTF-16.
#[test]
fn other_encodings() {
    let latin = Table::read("a.csv", b"Tiefe [\xb5m];Versuch\n1,5;\xe4lter\n").unwrap();
    assert_eq!(latin.all_numbers("tiefe", &Measure::LENGTH).unwrap(), [1.5e-6]);
    assert_eq!(latin.texts("versuch").unwrap(), ["\u{e4}lter"]);
    let text = "depth (\u{b5}m)\ttest\n2\tA\n";
    let wide: Vec<u8> =
        [0xfeff].into_iter().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    let wide = Table::read("wide.csv", &wide).unwrap();
    assert_eq!(wide.all_numbers("depth", &Measure::LENGTH).unwrap(), [2e-6]);
}

#[test]
fn units_behind_an_underscore_are_units() {
    let table = table("wear_rate_mm3_per_Nm,u_depth_um,test_no,load [-]\n1,2,3,4\n");
    let names: Vec<&str> = table.names().collect();
    assert_eq!(names, ["wear_rate", "u_depth", "test_no", "load"]);
    assert_eq!(table.all_numbers("load", &Measure::NUMBER).unwrap(), [4.0]);
    assert_eq!(table.all_numbers("wear_rate", &Measure::WEAR_COEFFICIENT).unwrap(), [1e-9]);
}

#[test]
fn names_are_given_to_foreign_headers() {
    let table = table("Versuch;Tiefe [um];Ort\n1;2,5;x\n2;;x\n");
    let table = table.naming(&[("test", "Versuch"), ("depth", "Tiefe [um]")]).unwrap();
    assert_eq!(table.numbers("depth", &Measure::LENGTH).unwrap(), Some(vec![Some(2.5e-6), None]));
    assert_eq!(table.texts("test").unwrap(), ["1", "2"]);
    assert_eq!(table.others(&["test", "depth"]), ["Ort"]);
    assert_eq!(table.lines(), [2, 3]);
    let other_ends = Table::read("a.csv", b"depth [um]\r\n1\r\n\r\n2\r\n").unwrap();
    assert_eq!(other_ends.lines(), [2, 4]);
    let old_ends = Table::read("a.csv", b"depth [um]\r1\r\r2\r").unwrap();
    assert_eq!(old_ends.lines(), [2, 4]);
    let error = table.clone().naming(&[("width", "Breite")]).unwrap_err();
    assert_eq!(
        error.to_string(),
        "scars.csv: no column is titled `Breite`; there are `Versuch`, `Tiefe [um]`, `Ort`"
    );
    assert!(matches!(table.clone().naming(&[("test", "Ort")]), Err(Error::Twice { .. })));
    // A name with the unit of the title, or with another one, or with one for a title that has none.
    let same = table.clone().naming(&[("depth_um", "depth")]).unwrap();
    assert_eq!(same.numbers("depth", &Measure::LENGTH).unwrap(), Some(vec![Some(2.5e-6), None]));
    let micro = self::table("Tiefe [\u{b5}m]\n2.5\n").naming(&[("depth_um", "Tiefe [\u{b5}m]")]);
    assert_eq!(micro.unwrap().all_numbers("depth", &Measure::LENGTH).unwrap(), [2.5e-6]);
    let other = table.clone().naming(&[("depth_mm", "Tiefe [um]")]);
    assert!(matches!(other, Err(Error::OtherUnit { .. })));
    let bare = table.naming(&[("distance_km", "Versuch")]).unwrap();
    assert_eq!(bare.all_numbers("distance", &Measure::LENGTH).unwrap(), [1e3, 2e3]);
}

#[test]
fn a_column_that_is_needed_is_told_with_the_header_that_would_do() {
    let table = table("depth,width_N,load_N\n1,2,x\n,2,\n");
    let error = |name, measure| table.all_numbers(name, &measure).unwrap_err().to_string();
    assert_eq!(
        error("depth", Measure::LENGTH),
        "scars.csv: the column `depth` has no unit: title it like `depth [mm]`"
    );
    assert!(error("width", Measure::LENGTH).contains("found a force; title it like `width [mm]`"));
    assert_eq!(
        error("load", Measure::FORCE),
        "scars.csv, line 2: `x` in the column `load_N` is not a finite number; leave the cell empty where nothing was measured"
    );
    assert_eq!(
        error("volume", Measure::VOLUME),
        "scars.csv: a column `volume [mm3]` is needed; there are `depth`, `width_N`, `load_N` (to use one of them: \
         --column volume=\"its header\")"
    );
    let error = error("depth", Measure::NUMBER);
    assert_eq!(error, "scars.csv, line 3: the column `depth` needs a value in every row");
}

#[test]
fn tables_that_are_none() {
    for (text, said) in [
        ("", "has to be a header"),
        ("depth_um\n", "nothing below the header"),
        ("depth_um,width_mm\n1\n", "line 2: expected 2 cells, found 1"),
        ("depth_um,width_mm\n1,5,2,5\n", "separate cells by `;`"),
        ("depth_um,Depth [mm]\n1,2\n", "`depth_um` and `Depth [mm]` have one name"),
        ("depth_um;width_mm\n1,5;2.5\n", "`1,5` in line 2 has a comma and `2.5` in line 2 a point"),
        ("depth_um\twidth_mm\n1,500\t2\n", "line 2: `1,500` may be a decimal number"),
        ("depth_um;width_mm\n1.250,5;2\n3,5;x\n", ""),
    ] {
        if said.is_empty() {
            let error = table(text).all_numbers("depth", &Measure::LENGTH).unwrap_err();
            assert!(error.to_string().contains("`1.250,5`"), "{error}");
        } else {
            assert!(refused(text).contains(said), "{text}: {}", refused(text));
        }
    }
}
