//! Materials by their names, and what follows from them.

use super::super::{CaseFile, RunnableCase, file, reads_back, resolve, with};
use super::rolling::TWIN_DISCS;
use approx::assert_relative_eq;
use archard_case::materials::{HandbookMaterial, MATERIALS};

/// The twin discs with these options.
fn discs(options: &[&str]) -> RunnableCase {
    resolve(&options.iter().fold(file(TWIN_DISCS), |file, option| file.set(*option)))
}

const OF_STEEL: [&str; 2] = ["body.disc1.material=100Cr6", "body.disc2.material=C45"];

#[test]
fn every_material_makes_a_case_that_reads_back() {
    for one in MATERIALS {
        let case = with(&[&format!("body.disc.material=\"{}\"", one.name)]);
        let material = case.bodies[1].material.as_ref().unwrap();
        assert_eq!(material.name.as_deref(), Some(one.name));
        assert_eq!((material.elastic.young, material.hardness), (one.young, one.hardness));
        reads_back(&case);
    }
}

/// The density of the material weighs what is worn off, unless the case has one; its hardness is the body's.
#[test]
fn a_body_has_what_its_material_has_where_the_case_gives_nothing() {
    let named = HandbookMaterial::find("7075").unwrap();
    let [own, given] = [&[][..], &["body.pin.density=2.9 g/cm^3"]].map(|more: &[&str]| {
        let options = [&["body.pin.material=Al 7075-T6"], more].concat();
        with(&options).build().unwrap().problem.bodies[0].clone()
    });
    assert_eq!((own.density, own.indentation_hardness), (Some(named.density), named.hardness));
    assert_relative_eq!(given.density.unwrap(), 2900.0, max_relative = 1e-14);
}

/// Single values replace those of the name; the diffusivity follows from what is given then.
#[test]
fn values_beside_a_name_replace_its_own() {
    let options = ["body.pin.material={name=C45, shear=80 GPa, conductivity=40 W/(m K)}"];
    let case = with(&options);
    let (material, known) =
        (case.bodies[0].material.as_ref().unwrap(), HandbookMaterial::find("C45").unwrap());
    assert_relative_eq!(material.elastic.young, 2.0 * 1.29 * 80e9, max_relative = 1e-14);
    let expected = 40.0 / (known.density * known.heat.unwrap());
    assert_relative_eq!(material.diffusivity.unwrap(), expected, max_relative = 1e-14);
    assert_eq!(material.hardness, known.hardness);
    reads_back(&case);
    let own = with(&["body.pin.material={young=70 GPa, poisson=0.3, hardness=1 GPa}"]);
    assert_eq!(own.build().unwrap().problem.bodies[0].indentation_hardness, Some(1e9));
    reads_back(&own);
}

/// Where friction warms surfaces of known materials that pass fast, the flash temperature follows without a word of heat; too
/// slow for it, or at an unknown speed, nobody asked for it and nothing is said.
#[test]
fn materials_tell_the_heat_where_a_temperature_follows() {
    let warm = |options: &[&str]| {
        let resolved = discs(&[&OF_STEEL, options].concat());
        assert_eq!(resolved.warnings, []);
        reads_back(&resolved.case);
        resolved.case.build().unwrap().problem.bodies.map(|body| body.thermal.is_some())
    };
    assert_eq!(warm(&["motion.rolling.speed=2 m/s"]), [true; 2]);
    assert_eq!(warm(&["motion.rolling.speed=1 cm/s"]), [false; 2]);
    assert_eq!(warm(&[]), [false; 2]);
}

/// A `thermal` table says what is to be said besides the material.
#[test]
fn a_table_of_heat_leaves_out_what_the_material_tells() {
    let thermal = "body.disc1.thermal={temperature=80 degC, diffusivity=10 mm^2/s}";
    let speed = "motion.rolling.speed=2 m/s";
    let case = discs(&[&OF_STEEL[..], &[thermal, speed]].concat()).case;
    let [one, two] = case.build().unwrap().problem.bodies.map(|body| body.thermal.unwrap());
    assert_eq!((one.conductivity, one.temperature), (46.6, Some(353.15)));
    assert_relative_eq!(one.diffusivity, 1e-5, max_relative = 1e-14);
    assert_eq!((two.conductivity, two.temperature), (49.8, None));
    reads_back(&case);
}

/// Steels with numbers for names need no quotes.
#[test]
fn a_name_may_be_a_number() {
    let text = super::super::PIN_ON_DISC.replace("{ young = \"210 GPa\", poisson = 0.3 }", "304");
    let case = resolve(&CaseFile::from_text("case.toml", text, ".")).case;
    assert_eq!(case.bodies[0].material.as_ref().unwrap().name.as_deref(), Some("304"));
}

/// A coating has the elasticity and the hardness of its material, and the body those at its surface.
#[test]
fn layers_are_named_too() {
    let layer = "body.disc.layers=[{thickness=\"3 um\", name=\"DLC\"}]";
    let case = with(&["body.disc.material=C45", layer, "motion.sliding.load=1 N"]);
    let (known, one) = (HandbookMaterial::find("DLC").unwrap(), &case.bodies[1].layers[0]);
    assert_eq!((one.layer.material.young, one.hardness), (known.young, known.hardness));
    let body = case.build().unwrap().problem.bodies[1].clone();
    assert_eq!((body.indentation_hardness, body.density), (known.hardness, None));
    reads_back(&case);
    let own = "body.disc.layers=[{thickness=\"3 um\", name=\"DLC\", young=\"150 GPa\"}]";
    assert_eq!(
        with(&["body.disc.material=C45", own]).bodies[1].layers[0].layer.material.young,
        150e9
    );
}
