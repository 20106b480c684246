//! Wheels in service: when they reach limits, and when they are turned.

use archard_rail::setup::Side;
use archard_rail::wear::{Economy, Limit, Plan, Reprofiling, RouteResult, Thicknesses};

/// When a wheel reaches a limit in service.
#[derive(Debug, Clone, PartialEq)]
pub struct RailLife {
    /// The limit.
    pub limit: Limit,
    /// The side.
    pub side: Side,
    /// The share of the distance at which it is reached, and its error; `None` where it is not.
    pub at: Option<[f64; 2]>,
}

impl RailLife {
    /// When the wheels of these sides reach limits, the first first.
    pub fn of(limits: &[Limit], sides: &[Side], travelled: &RouteResult) -> Vec<Self> {
        let of_side = |&side: &Side| {
            let of = move |&limit: &Limit| Self { limit, side, at: travelled.life(&limit, side) };
            limits.iter().map(of)
        };
        let mut lives: Vec<Self> = sides.iter().flat_map(of_side).collect();
        let share = |life: &Self| life.at.map_or(f64::INFINITY, |[share, _]| share);
        lives.sort_by(|one, other| share(one).total_cmp(&share(other)));
        lives
    }
}

/// How often a wheel is turned again, and how far it runs in all.
#[derive(Debug, Clone, PartialEq)]
pub struct RailPlan {
    /// The side.
    pub side: Side,
    /// When it is turned: at the limit that it reaches first, at the end of the distance, or where that costs the least of its radius.
    pub when: &'static str,
    /// The plan; `None` where the wheel does not last till then.
    pub plan: Option<Plan>,
}

impl RailPlan {
    /// The plans of wheels of these sides: at the first limit, or at the end where none exists, and where a metre costs least.
    pub fn of(
        turning: &Reprofiling,
        limits: &[Limit],
        sides: &[Side],
        travelled: &RouteResult,
    ) -> Vec<Self> {
        let of_side = |&side: &Side| {
            let first = first_reached(limits.iter(), travelled, side);
            let limited = first[0].is_finite();
            let until = if limited { first } else { [1.0; 3] };
            let when = if limited { "limit" } else { "end" };
            let plan = travelled.plan(turning, side, until);
            let cheapest = travelled.cheapest_plan(turning, side, until[0]);
            [(when, plan), ("cheapest", cheapest)].map(|(when, plan)| Self { side, when, plan })
        };
        sides.iter().flat_map(of_side).collect()
    }
}

/// How a wheel runs farthest that may be turned to thinner flanges.
#[derive(Debug, Clone, PartialEq)]
pub struct RailEconomy {
    /// The side.
    pub side: Side,
    /// Its turnings, and how far it runs; `None` where it cannot run.
    pub economy: Option<Economy>,
}

impl RailEconomy {
    /// Of wheels of these sides.
    pub fn of(
        (turning, thicknesses): (&Reprofiling, &Thicknesses),
        limits: &[Limit],
        sides: &[Side],
        travelled: &RouteResult,
    ) -> Vec<Self> {
        let of_side = |&side: &Side| {
            // The thickness is one of its own.
            let others = limits.iter().filter(|limit| limit.column != "flange_thickness_m");
            let until = first_reached(others, travelled, side);
            Self { side, economy: travelled.economy(turning, thicknesses, side, until) }
        };
        sides.iter().map(of_side).collect()
    }
}

/// The share of the distance at which the first of some limits is reached in each of the three runs; without bound where none is.
fn first_reached<'l>(
    limits: impl Iterator<Item = &'l Limit>,
    travelled: &RouteResult,
    side: Side,
) -> [f64; 3] {
    let reached = limits.map(|limit| travelled.reached(limit, side));
    reached.fold([f64::INFINITY; 3], |least, own| [0, 1, 2].map(|run| least[run].min(own[run])))
}
