//! Damage of bodies over a run, cycle by cycle.

use serde_json::{Value, json};

use super::table::{Table, number};
use super::{Error, Manifest, WantedStresses};
use crate::verdict::{self, Word};
use archard::body::Body;
use archard::elastic::{Cycle, Damage, DamageModel, Endurance};

/// What is wanted of the damage of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct WantedDamage {
    /// The name of the criterion.
    pub criterion: String,
    /// The life that its values let.
    pub endurance: Endurance,
}

/// What is known of the damage of a body.
#[derive(Debug, Default)]
pub(super) enum Tired {
    /// No cycle went by.
    #[default]
    Fresh,
    /// All of them were seen or jumped over.
    Known(Box<Damage>),
    /// Nothing, and why.
    Lost(&'static str),
}

const UNSEEN: &str =
    "the run was taken up again and did not see its first cycles; run it again, from its start";
const FRAME: &str = "the frame changed on the way, and points of the material were lost: give a larger `frame.size`";
const THROUGH: &str = "a place is worn down to below the last of `depths`, so that points below it were not followed: give deeper ones";

impl Tired {
    /// Adds the cycles up to one that was seen whole, with its number and the depth (m) then worn off each pair.
    pub(super) fn pass(
        &mut self,
        (body, wanted): (&Body, &WantedStresses),
        cycle: Option<&Cycle>,
        (cycles, worn): (f64, &[f64]),
    ) {
        if matches!(self, Self::Fresh) {
            let tiring = cycle.filter(|_| cycles < 1.5).and_then(|own| tiring(body, wanted, own));
            let lost = || Self::Lost(UNSEEN);
            *self = tiring.map_or_else(lost, |own| Self::Known(Box::new(Damage::new(own))));
        }
        match (&mut *self, cycle) {
            (Self::Known(damage), Some(cycle)) => damage.pass(cycle, cycles, worn),
            (Self::Known(_), None) => *self = Self::Lost(UNSEEN),
            _ => {}
        }
    }

    /// Takes notice that points of the frame are other ones from now on.
    pub(super) fn moved(&mut self) {
        if matches!(self, Self::Known(_)) {
            *self = Self::Lost(FRAME);
        }
    }

    /// Writes the table of a body; the block of the summary and the lines of the verdict.
    pub(super) fn write(
        &self,
        manifest: &mut Manifest,
        (body, wanted): (&str, &WantedDamage),
    ) -> Result<(Value, Vec<verdict::Line>), Error> {
        let doubt = |why: &str| {
            verdict::of_run(Word::Doubtful, &format!("damage of `{body}` is not known: {why}"))
        };
        let found = match self {
            Self::Known(damage) => damage.so_far(),
            Self::Fresh => return Ok((Value::Null, vec![doubt(UNSEEN)])),
            Self::Lost(why) => return Ok((Value::Null, vec![doubt(why)])),
        };
        let Some(found) = found else { return Ok((Value::Null, vec![doubt(THROUGH)])) };
        let mut table = Table::create(manifest.claim(&file(body))?)?;
        for [depth, all, left] in &found.rows {
            let cells = [("depth_m", depth), ("damage", all), ("damage_left", left)];
            table.row(&cells.map(|(name, value)| (name, number(*value))))?;
        }
        table.flush()?;
        table.sync()?;
        let [largest, error] = found.largest;
        let of = format!("damage of `{body}` by `{}`", wanted.criterion);
        let stated = (largest > 0.0).then(|| verdict::measured(error / largest, &of));
        let lines = stated.into_iter().chain(found.through.then(|| doubt(THROUGH)));
        let block = json!({
            "criterion": wanted.criterion,
            "largest": largest,
            "largest_error": error,
            "x_m": found.place[0],
            "y_m": found.place[1],
            "depth_m": 0.0 - found.place[2],
            "left": found.left[0],
            "left_error": found.left[1],
            "cycles_to_failure": found.life.map(|[value, _]| value),
            "cycles_to_failure_error": found.life.map(|[_, error]| error),
        });
        Ok((block, lines.collect()))
    }
}

/// What the damage of a body depends on, under the first cycle.
fn tiring(body: &Body, wanted: &WantedStresses, first: &Cycle) -> Option<DamageModel> {
    let WantedDamage { criterion, endurance } = wanted.damage.as_ref()?;
    let criteria = wanted.criteria(body);
    Some(DamageModel {
        criterion: criteria.into_iter().find(|own| own.name() == criterion)?,
        endurance: *endurance,
        depths: if wanted.depths.is_empty() { first.depths() } else { wanted.depths.clone() },
        added: [wanted.initial, wanted.swinging],
    })
}

/// The name of its table.
pub(super) fn file(body: &str) -> String {
    format!("damage_{body}.csv")
}
