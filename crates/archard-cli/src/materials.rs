//! `archard materials`: lists the materials that a case can name, or shows one.

use archard_case::materials::{HandbookMaterial, MATERIALS};

use crate::failure::Failure;
use crate::number::four;
use crate::say::say;

/// A gigapascal (Pa).
const GPA: f64 = 1e9;
/// What the values are.
const TYPICAL: &str =
    "Values are typical ones, rounded, at room temperature; those of your batch are measured.";

/// Lists all materials, or shows that of a name.
pub fn materials(name: Option<&str>) -> Result<(), Failure> {
    let Some(name) = name else { return list() };
    let one = HandbookMaterial::find(name)
        .map_err(|unknown| Failure::wrong(format!("{unknown}; {}", unknown.help())))?;
    say(&page(one))
}

fn list() -> Result<(), Failure> {
    say("Materials, each of a body as `material = \"NAME\"`\n")?;
    let width = MATERIALS.iter().map(|one| one.name.len()).max().unwrap_or(0);
    say(&format!("  {:width$}  {:>7}  {:>5}  {:>6}  {:>8}", "", "E", "nu", "rho", "hardness"))?;
    say(&format!("  {:width$}  {:>7}  {:>5}  {:>6}  {:>8}", "", "GPa", "-", "kg/m^3", "GPa"))?;
    for one in MATERIALS {
        let hardness = one
            .hardness
            .map_or_else(|| "-".to_owned(), |hardness| format!("{:.2}", hardness / GPA));
        say(&format!(
            "  {:width$}  {:>7}  {:>5}  {:>6}  {hardness:>8}  {}",
            one.name,
            one.young / GPA,
            one.poisson,
            one.density,
            one.state
        ))?;
    }
    say(&format!("\n{TYPICAL}\narchard materials NAME shows one, with heat and its source"))
}

/// All there is to read of a material.
fn page(one: &HandbookMaterial) -> String {
    let HandbookMaterial {
        name,
        also,
        state,
        young,
        poisson,
        density,
        hardness,
        conductivity,
        heat,
        source,
    } = one;
    let mut page = format!("{name}: {state}\n\n");
    let mut add = |label: &str, value: Option<String>| {
        let value = value.unwrap_or_else(|| "not given".to_owned());
        page += &format!("  {label:22}  {value}\n");
    };
    add("Young's modulus", Some(format!("{} GPa", young / GPA)));
    add("Poisson's ratio", Some(poisson.to_string()));
    add("density", Some(format!("{density} kg/m^3")));
    add("indentation hardness", hardness.map(|one| format!("{} GPa", four(one / GPA))));
    add("thermal conductivity", conductivity.map(|one| format!("{one} W/(m K)")));
    add("specific heat", heat.map(|one| format!("{one} J/(kg K)")));
    add("thermal diffusivity", one.diffusivity().map(|one| format!("{} mm^2/s", four(one * 1e6))));
    page.push('\n');
    if !also.is_empty() {
        page += &format!("Also called {}\n", also.join(", "));
    }
    page += &format!("Source: {source}\n{TYPICAL}\n\nIn a case, in the table of a body\n\n");
    page +=
        &format!("    material = \"{name}\"\n\nor with a value of your own in place of its\n\n");
    page + &format!("    material = {{ name = \"{name}\", young = \"{} GPa\" }}", young / GPA)
}
