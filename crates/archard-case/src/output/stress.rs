//! The largest stresses in half-spaces, and whether they yield by them.

use std::cmp::Ordering;

use serde_json::{Map, Value, json};

use super::damage::{self, WantedDamage};
use super::elastic::{section_file, write_sections};
use super::stress_errors::judged;
use super::table::{Table, number};
use super::{Error, Manifest, Planes};
use crate::verdict::{self, Word};
use archard::body::{Body, Material};
use archard::elastic::{
    Criterion, Cycle, Interface, Maxima, Maximum, Piece, PressedHalfSpace, Side,
};
use archard::stress::criteria::Elastic;
use archard::stress::{Components, MEASURES, TABOR};

/// The names of components, in their order.
pub const COMPONENTS: [&str; 6] = ["xx", "yy", "zz", "xy", "zx", "yz"];

/// What is wanted of the stresses in a half-space.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct WantedStresses {
    /// Depths (m), rising; by the contact where there are none.
    pub depths: Vec<f64>,
    /// Whether the whole field is put out.
    pub field: bool,
    /// An even stress (Pa) that is added: what is left from manufacture, or what the whole body bears.
    pub initial: Components,
    /// An even stress (Pa) in phase with friction over a cycle of the contact, as it is where friction pushes the body forward by most.
    pub swinging: Components,
    /// Yield stress (Pa) in tension; by the hardness where that is known and this is not.
    pub strength: Option<f64>,
    /// The same of its layers, from the surface down; none where their hardness says it.
    pub layer_strengths: Vec<f64>,
    /// Indentation hardness (Pa) of its layers and of what is below them, where that is known.
    pub hardness: Vec<Option<f64>>,
    /// Criteria of fatigue.
    pub fatigue: WantedFatigue,
    /// The damage by one of these over all cycles.
    pub damage: Option<WantedDamage>,
}

/// Factors of the criteria of fatigue that are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct WantedFatigue {
    /// Crossland's.
    pub crossland: Option<f64>,
    /// Dang Van's.
    pub dang_van: Option<f64>,
    /// Findley's.
    pub findley: Option<f64>,
    /// Fatemi and Socie's.
    pub fatemi_socie: Option<f64>,
    /// Whether that of Smith, Watson and Topper is.
    pub smith_watson_topper: bool,
}

impl WantedFatigue {
    /// Whether any is.
    pub fn is_wanted(&self) -> bool {
        *self != Self::default()
    }

    /// Whether the criterion of that name is.
    pub(crate) fn is_wanted_by(&self, criterion: &str) -> bool {
        let elastic = Material { young: 1.0, poisson: 0.0 };
        self.criteria(&elastic, None).iter().any(|own| own.name() == criterion)
    }

    /// The criteria, of a body of that material and yield strength (Pa).
    fn criteria(&self, material: &Material, strength: Option<f64>) -> Vec<Criterion> {
        let elastic = Elastic { young: material.young, poisson: material.poisson };
        let socie = self.fatemi_socie.zip(strength);
        let topper = self.smith_watson_topper.then_some(Criterion::SmithWatsonTopper(elastic));
        [
            self.crossland.map(Criterion::Crossland),
            self.dang_van.map(Criterion::DangVan),
            self.findley.map(Criterion::Findley),
            socie.map(|(factor, strength)| Criterion::FatemiSocie(elastic, [factor, strength])),
            topper,
        ]
        .into_iter()
        .flatten()
        .collect()
    }
}

/// The largest stresses of bodies, for the summary, and what the verdict says of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Stresses {
    blocks: Map<String, Value>,
    pub(super) lines: Vec<verdict::Line>,
}

/// Where a strength is from.
const GIVEN: &str = "yield_strength";

impl WantedStresses {
    /// The yield stress (Pa) of each layer and of what is below all, and where it is from.
    fn strengths(&self, body: &Body) -> Vec<Option<(f64, &'static str)>> {
        let count = body.layers.len();
        let of = |piece: usize| {
            let given = if piece < count {
                self.layer_strengths.get(piece)
            } else {
                self.strength.as_ref()
            };
            let hardness = match count {
                0 => body.known_hardness(),
                _ => self.hardness.get(piece).copied().flatten(),
            };
            let by_hardness = || hardness.map(|hardness| (hardness / TABOR, "hardness / 2.8"));
            given.map(|strength| (*strength, GIVEN)).or_else(by_hardness)
        };
        (0..=count).map(of).collect()
    }

    /// The files of a body of that name.
    pub(super) fn files(&self, body: &str) -> Vec<String> {
        let field = self.field.then(|| field_file(body));
        let damage = self.damage.as_ref().map(|_| damage::file(body));
        let worst = section_file(&prefix(body), WORST);
        [table_file(body), worst].into_iter().chain(field).chain(damage).collect()
    }

    /// Criteria of fatigue of a body of one material.
    pub(super) fn criteria(&self, body: &Body) -> Vec<Criterion> {
        let strength = self.strengths(body).last().copied().flatten().map(|(own, _)| own);
        body.material.map_or(vec![], |material| self.fatigue.criteria(&material, strength))
    }
}

impl Stresses {
    pub(super) fn add(&mut self, body: &str, (value, lines): (Value, Vec<verdict::Line>)) {
        self.blocks.insert(body.to_owned(), value);
        self.lines.extend(lines);
    }

    /// What is off by its ends, over the largest equivalent stress (Pa) at the places asked for, both in that order.
    pub(super) fn missed(&mut self, body: &str, known: Option<[f64; 2]>) {
        let of = format!("equivalent stress at places in `{body}`, by its ends");
        let stated = known.filter(|[_, largest]| *largest > 0.0);
        self.lines.extend(stated.map(|[error, largest]| verdict::measured(error / largest, &of)));
    }

    /// As a block of the summary; null without any.
    pub fn json(&self) -> Value {
        if self.blocks.is_empty() { Value::Null } else { Value::Object(self.blocks.clone()) }
    }
}

/// The section through the place of the largest equivalent stress, along the motion.
pub const WORST: &str = "worst";

/// What the files of a body's sections begin with.
pub(super) fn prefix(body: &str) -> String {
    format!("{body}_")
}

fn table_file(body: &str) -> String {
    format!("stress_{body}.csv")
}

fn field_file(body: &str) -> String {
    format!("stress_{body}.vtr")
}

/// What the points of a body go through.
#[derive(Debug)]
pub(super) enum Passing {
    /// The contact, along an axis.
    Along(usize),
    /// A cycle of it; `None` where the run did not see it whole.
    Cycle(Option<Cycle>),
}

/// Writes the table and, if it is wanted, the field of a body; the block of the summary and the lines of the verdict.
pub(super) fn write(
    (manifest, which): (&mut Manifest, usize),
    (axis, passing): (usize, &Passing),
    body: &Body,
    (wanted, pressed): (&WantedStresses, &PressedHalfSpace),
) -> Result<(Value, Vec<verdict::Line>), Error> {
    let depths = if wanted.depths.is_empty() { pressed.depths() } else { wanted.depths.clone() };
    let strengths = wanted.strengths(body);
    let known: Vec<Option<f64>> = strengths.iter().map(|own| own.map(|(own, _)| own)).collect();
    let mut planes = wanted.field.then(|| Planes::below(&pressed.below, which == 1));
    let mut see = |depth: f64, plane: &[Vec<f64>; 6]| {
        planes.iter_mut().for_each(|planes| planes.add(depth, plane));
    };
    let Some(maxima) = pressed.maxima(&depths, (&wanted.initial, &known), &mut see) else {
        return Ok((Value::Null, vec![]));
    };
    write_table(manifest, body, &maxima)?;
    let worst = pressed.section_through(WORST, maxima.inside[0].place, axis);
    let worst: Vec<_> = worst.iter().map(|section| pressed.section(section)).collect();
    write_sections(manifest, &prefix(&body.name), &worst, which == 1)?;
    if let Some(planes) = planes {
        planes.write(&manifest.claim(&field_file(&body.name))?)?;
    }
    let mut lines = judged((body, &known), &maxima);
    let mut block = block(pressed, &maxima, (wanted, &strengths));
    if !body.layers.is_empty() {
        add_layers(&mut block, (&maxima, pressed.peak()));
    }
    if wanted.fatigue.is_wanted() && matches!(passing, Passing::Cycle(None)) {
        let why = format!(
            "fatigue of `{}` is not known: the run did not see its last cycle whole; run it again, from its start",
            body.name
        );
        lines.push(verdict::of_run(Word::Doubtful, &why));
    }
    for criterion in wanted.criteria(body) {
        let found = match passing {
            Passing::Along(axis) => pressed.fatigue(&criterion, (&depths, &wanted.initial), *axis),
            Passing::Cycle(cycle) => cycle.as_ref().and_then(|cycle| {
                cycle.fatigue(&criterion, (&depths, (&wanted.initial, &wanted.swinging)))
            }),
        };
        let of = format!("`{}` of `{}`", criterion.name(), body.name);
        let stated = found.filter(|own| own.value != 0.0);
        lines.extend(stated.map(|own| verdict::measured(own.error / own.value.abs(), &of)));
        block["fatigue"][criterion.name()] = json!(found.map(|own| {
            let mut told = json!({
                "value": own.value,
                "error": own.error,
                "unit": if matches!(criterion, Criterion::FatemiSocie(..)) { "" } else { "Pa" },
            });
            match passing {
                Passing::Along(axis) => told["across_m"] = json!(own.place[1 - axis]),
                Passing::Cycle(_) => {
                    told["x_m"] = json!(own.place[0]);
                    told["y_m"] = json!(own.place[1]);
                }
            }
            told["depth_m"] = json!(0.0 - own.place[2]);
            told
        }));
    }
    Ok((block, lines))
}

/// A row a depth.
fn write_table(manifest: &mut Manifest, body: &Body, maxima: &Maxima) -> Result<(), Error> {
    let mut table = Table::create(manifest.claim(&table_file(&body.name))?)?;
    for layer in &maxima.layers {
        let mut row = vec![("depth_m".to_owned(), number(layer.depth))];
        if !body.layers.is_empty() {
            row.push(("layer".to_owned(), (layer.piece + 1).to_string()));
        }
        for ((name, _), (value, [x, y])) in MEASURES.iter().zip(&layer.largest) {
            let cells = [("Pa", value), ("x_m", x), ("y_m", y)];
            row.extend(cells.map(|(unit, value)| (format!("{name}_{unit}"), number(*value))));
        }
        row.push(("mean_von_mises_Pa".to_owned(), number(layer.mean)));
        for ((name, sign), (value, [x, y])) in FACES.iter().zip(&layer.faces) {
            let cells = [("Pa", sign * value), ("x_m", *x), ("y_m", *y)];
            row.extend(cells.map(|(unit, value)| (format!("{name}_{unit}"), number(value))));
        }
        if maxima.layers.iter().any(|layer| layer.yields.is_some()) {
            let share = layer.yields.map_or(String::new(), number);
            row.push(("yielding_area".to_owned(), share));
        }
        let row: Vec<(&str, String)> =
            row.iter().map(|(name, value)| (name.as_str(), value.clone())).collect();
        table.row(&row)?;
    }
    table.flush()?;
    table.sync()
}

/// Names of what is sought along the surface and across it at faces of layers, and the sign it is kept with.
const FACES: [(&str, f64); 4] = [
    ("along_surface_most", 1.0),
    ("along_surface_least", -1.0),
    ("zz_most", 1.0),
    ("zz_least", -1.0),
];

/// Adds what there is in each layer and at each interface.
fn add_layers(block: &mut Value, (maxima, peak): (&Maxima, f64)) {
    let one = |own: &Maximum| one(own, peak);
    let side = |side: &Side| json!({ FACES[0].0: one(&side.most), FACES[1].0: one(&side.least) });
    let interface = |own: &Interface| {
        json!({
            "depth_m": own.depth,
            FACES[2].0: one(&own.pull),
            FACES[3].0: one(&own.press),
            MEASURES[3].0: one(&own.shear),
            "above": side(&own.above),
            "below": own.below.as_ref().map(side),
        })
    };
    block["interfaces"] = maxima.interfaces.iter().map(interface).collect();
    for ((name, _), own) in FACES.iter().zip(&maxima.face) {
        block["surface"][name] = json!(own.as_ref().map(one));
    }
}

fn one(own: &Maximum, peak: f64) -> Value {
    json!({
        "value_Pa": own.value,
        "error_Pa": own.error,
        "order": own.order,
        "over_peak_pressure": own.value / peak,
        "x_m": own.place[0],
        "y_m": own.place[1],
        "depth_m": 0.0 - own.place[2],
    })
}

fn block(
    pressed: &PressedHalfSpace,
    maxima: &Maxima,
    (wanted, strengths): (&WantedStresses, &[Option<(f64, &'static str)>]),
) -> Value {
    let peak = pressed.peak();
    let one = |own: &Maximum| one(own, peak);
    let all = |of: [Option<Maximum>; 4]| -> Value {
        let each = MEASURES.iter().zip(of);
        Value::Object(
            each.map(|((name, _), own)| ((*name).to_owned(), json!(own.as_ref().map(one))))
                .collect(),
        )
    };
    let yields = |piece: &Piece| {
        let (strength, from) = strengths[piece.index]?;
        let largest = maxima.largest_in(piece, 0);
        let utilisation = largest.map(|own| own.value / strength);
        let state = utilisation.map(|utilisation| match utilisation {
            _ if piece.index == 0 && peak > TABOR * strength => "beyond the hardness",
            utilisation if utilisation > 1.0 => "contained plasticity",
            _ => "elastic",
        });
        // What is added does not grow with the pressures.
        let grows = wanted.initial == [0.0; 6];
        let shear = pressed.shakes_down(maxima).filter(|_| grows);
        Some(json!({
            "strength_Pa": strength,
            "strength_from": from,
            "utilisation": utilisation,
            "utilisation_error": largest.map(|own| own.error / strength),
            "depth_m": largest.map(|own| 0.0 - own.place[2]),
            "first_yield_load_factor": utilisation.filter(|_| grows).map(f64::recip),
            "shakedown_load_factor": shear.map(|shear| strength / 3f64.sqrt() / shear),
            "state": state,
        }))
    };
    let used = |piece: &&Piece| {
        let (strength, _) = strengths[piece.index]?;
        Some(maxima.largest_in(piece, 0).map_or(f64::INFINITY, |own| own.value / strength))
    };
    let known = maxima.pieces.iter().filter(|piece| used(piece).is_some());
    let most = known.max_by(|a, b| used(a).partial_cmp(&used(b)).unwrap_or(Ordering::Equal));
    let mut block = json!({
        "inside": all(maxima.inside.map(Some)),
        "surface": all(maxima.surface),
        "yield": most.and_then(yields),
    });
    if strengths.len() > 1 {
        let layer = |piece: &Piece| {
            json!({
                "layer": piece.index + 1,
                "from_m": piece.ends[0],
                "to_m": Some(piece.ends[1]).filter(|end| end.is_finite()),
                "inside": all(piece.inside.map(Some)),
                "yield": yields(piece),
            })
        };
        block["layers"] = maxima.pieces.iter().map(layer).collect();
    }
    block
}
