//! The results of an elastic body: fields on its surface, and a row for each point inside.

use serde_json::{Map, Value, json};

use super::summary;
use super::table::{Table, number};
use super::{CASE, Claim, Error, Field, Manifest, SUMMARY, Sheet, Surface, Totals};
use crate::verdict::{self, Verdict, Warning};
use archard::compliance::Balance;
use archard::elastic::{DeformedBody, ElasticBody, Point, Response, Section, SectionResponse, row};

/// Writes `case.toml`, `surface.vtu`, `points.csv` and files in `sections` where points and sections were asked for, and
/// `summary.json` into a folder; what earlier runs wrote there is removed. Returns what can be believed, warnings included.
///
/// # Errors
/// If a file cannot be removed or written.
pub fn write_elastic(
    claim: &mut Claim,
    case_toml: &str,
    (body, deformed): (&ElasticBody, &DeformedBody),
    totals: &Totals,
) -> Result<Verdict, Error> {
    claim.admit()?;
    let manifest = &mut claim.manifest;
    manifest.begin([CASE, SURFACE])?;
    manifest.write(CASE, case_toml.as_bytes())?;
    Surface::of_elastic(deformed).write(&manifest.claim(SURFACE)?)?;
    if !body.points.is_empty() {
        let mut table = Table::create(manifest.claim(POINTS)?)?;
        write_points(&mut table, &[], (&body.points, &deformed.points), |place| {
            depth(deformed, place)
        })?;
        table.flush()?;
        table.sync()?;
    }
    write_sections(manifest, "", &deformed.sections, false)?;
    let verdict = elastic_verdict(body, deformed, &totals.warnings);
    let verdict = verdict.ended(totals.failure.as_deref());
    let summary = format!("{:#}\n", summary((body, deformed), &verdict, totals));
    manifest.write(SUMMARY, summary.as_bytes())?;
    manifest.settle()?;
    Ok(verdict)
}

/// What can be believed of a result, with what the user was warned of.
pub fn elastic_verdict(
    body: &ElasticBody,
    deformed: &DeformedBody,
    warnings: &[Warning],
) -> Verdict {
    let Balance { force, moment } = deformed.balance;
    let mut lines = verdict::balance(force, moment).to_vec();
    lines.extend(body.slenderness.map(verdict::slenderness));
    Verdict { lines }.warned_of(warnings)
}

/// The files that [`write_elastic`] adds to the case and the summary, by their names in the folder.
pub fn elastic_files(points: &[Point], sections: &[Section]) -> Vec<String> {
    let table = (!points.is_empty()).then(|| POINTS.to_owned());
    let sections = sections.iter().map(|section| section_file("", &section.name));
    [SURFACE.to_owned()].into_iter().chain(table).chain(sections).collect()
}

/// The file of the fields on a body's surface.
pub(super) const SURFACE: &str = "surface.vtu";
/// The file of what is found at points.
pub(super) const POINTS: &str = "points.csv";

/// The folder of sections.
const SECTIONS: &str = "sections";

/// The file of a section, its name behind a prefix.
pub(super) fn section_file(prefix: &str, name: &str) -> String {
    format!("{SECTIONS}/{prefix}{name}.vtu")
}

/// Writes a file a section, its name behind a prefix; of a body that is turned over in its place.
pub(super) fn write_sections(
    manifest: &mut Manifest,
    prefix: &str,
    sections: &[SectionResponse],
    turned: bool,
) -> Result<(), Error> {
    sections.iter().try_for_each(|sampled| {
        let sheet = Sheet::of_section(sampled);
        let sheet = if turned { sheet.turned_over() } else { sheet };
        sheet.write(&manifest.claim(&section_file(prefix, &sampled.name))?)
    })
}

/// How deep (m) a place lies in a body.
pub(super) fn depth(deformed: &DeformedBody, place: [f64; 3]) -> Option<f64> {
    deformed.surface.depth(place.into())
}

/// Adds a row a point, with what is found there, the same cells in front of each.
pub(super) fn write_points(
    table: &mut Table,
    first: &[(&str, String)],
    (points, responses): (&[Point], &[Response]),
    depth: impl Fn([f64; 3]) -> Option<f64>,
) -> Result<(), Error> {
    for (point, response) in points.iter().zip(responses) {
        let [x, y, z] = point.place.map(number);
        let depth = depth(point.place).map_or(String::new(), number);
        let place = [("x_m", x), ("y_m", y), ("z_m", z), ("depth_m", depth)];
        let row = row(response);
        let values = row.iter().map(|(column, value)| (column.as_str(), number(*value)));
        let name = [("point", point.name.clone())];
        let cells: Vec<(&str, String)> =
            first.iter().cloned().chain(name).chain(place).chain(values).collect();
        table.row(&cells)?;
    }
    Ok(())
}

fn summary(
    (body, deformed): (&ElasticBody, &DeformedBody),
    verdict: &Verdict,
    totals: &Totals,
) -> Value {
    let names = deformed.surface.names().iter();
    let forces: Map<String, Value> =
        names.zip(deformed.forces()).map(|(name, force)| (name.clone(), json!(force))).collect();
    json!({
        "program": "archard",
        "version": env!("CARGO_PKG_VERSION"),
        "complete": totals.failure.is_none(),
        "failure": totals.failure,
        "body": body.name,
        "elements": body.finite.meshed.mesh.faces.len(),
        "unknowns": deformed.unknowns(),
        "largest_displacement_m": deformed.largest_displacement(),
        "force_on_surfaces_N": forces,
        "verdict": summary::json_of(verdict),
        "seconds": totals.seconds,
        "threads": totals.threads,
        "warnings": totals.warnings.iter().map(|warning| &warning.text).collect::<Vec<_>>(),
    })
}

impl Surface {
    /// The surface of an elastic body: displacement, traction and stress at the nodes of every element.
    pub fn of_elastic(deformed: &DeformedBody) -> Self {
        let mut surface = Self { mirrored: deformed.surface.mirrored(), ..Self::default() };
        let (mut responses, mut tractions, mut worn) = (vec![], vec![], vec![]);
        let nodes = deformed.surface.traction_nodes();
        for face in 0..deformed.surface.elements() {
            let parts = deformed.surface.parts_of(face);
            for (node, part) in deformed.surface.tractions_of(face).zip(parts) {
                let displacement = deformed.displacement[nodes[node].node];
                surface.places.push(nodes[node].place.to_array());
                surface.outlines.push(part.map(|corner| corner.to_array()).to_vec());
                responses.push(Response { displacement, stress: deformed.stress[node] });
                tractions.push(deformed.traction[node]);
                worn.extend(deformed.worn.get(node));
            }
        }
        surface.fields = fields(&responses);
        if !worn.is_empty() {
            surface.fields.push(Field { name: "wear_m".to_owned(), values: worn });
        }
        let displacements = responses.iter().map(|response| response.displacement).collect();
        surface.vectors = vec![
            ("displacement_m".to_owned(), displacements),
            ("traction_Pa".to_owned(), tractions),
        ];
        surface
    }
}

impl Sheet {
    /// A section of a body: displacement and stress at its places.
    pub fn of_section(sampled: &SectionResponse) -> Self {
        let displacements = sampled.responses.iter().map(|response| response.displacement);
        Self {
            points: sampled.places.clone(),
            cells: sampled.cells.iter().map(|cell| cell.to_vec()).collect(),
            fields: fields(&sampled.responses),
            vectors: vec![("displacement_m".to_owned(), displacements.collect())],
        }
    }
}

/// Displacements, stresses and the equivalent stress as fields.
fn fields(responses: &[Response]) -> Vec<Field> {
    let mut fields: Vec<Field> = vec![];
    for response in responses {
        let row = row(response);
        fields.resize_with(row.len(), || Field { name: String::new(), values: vec![] });
        for (field, (name, value)) in fields.iter_mut().zip(row) {
            field.name = name;
            field.values.push(value);
        }
    }
    fields
}
