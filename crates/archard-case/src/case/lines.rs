//! What cases of two bodies that touch along a line which passes have in common: gears, and a cam with its follower.

use std::fmt::{self, Formatter};
use std::sync::Arc;

use archard::friction::Friction;
use archard::wear::WearLaw;
use archard_gear::{Laws, Limit, Misfit};

use super::chosen::ChosenPart;
use super::key::Key;
use super::print::{print_chosen, quoted, si};
use super::problem::Problem;
use super::wheel_rail::ProfiledPart;
use super::wheel_rail::print::print_body;

/// How a body wears.
type Wear = Option<ChosenPart<Box<dyn WearLaw>>>;

/// How two bodies wear, and their friction.
pub(super) fn laws(
    bodies: [(&str, &Wear); 2],
    friction: Option<&ChosenPart<Box<dyn Friction>>>,
) -> Result<Laws, Problem> {
    let law = |(name, wear): (&str, &Wear)| -> Result<Option<Arc<dyn WearLaw>>, Problem> {
        let Some(law) = wear else { return Ok(None) };
        let key = Key::of(["body", name, "wear", law.choice.name]);
        let built = law
            .build()
            .map_err(|invalid| Problem::error(key.child(&invalid.parameter), invalid.message))?;
        Ok(Some(Arc::from(built)))
    };
    let laws = [law(bodies[0])?, law(bodies[1])?];
    let friction = friction.map(|law| -> Result<Arc<dyn Friction>, Problem> {
        let key = Key::of(["friction", law.choice.name]);
        let built = law
            .build()
            .map_err(|invalid| Problem::error(key.child(&invalid.parameter), invalid.message))?;
        Ok(Arc::from(built))
    });
    Ok((friction.transpose()?, laws))
}

/// What is wrong with bodies that do not fit, at the keys of their profiles or of their motion.
pub(super) fn misfit(error: Misfit, bodies: [(&str, &str); 2], motion: &'static str) -> Problem {
    let Misfit { body, cause } = error;
    let key = match body.map(|body| bodies[body]) {
        Some((name, _)) if cause.parameter == "wear" => {
            return Problem::error(Key::of(["body", name, "wear"]), cause.message);
        }
        Some((name, profile)) => Key::of(["body", name, "profile", profile]),
        None if cause.parameter == "friction" => {
            return Problem::error(Key::of(["friction"]), cause.message);
        }
        None => Key::of(["motion", motion]),
    };
    Problem::error(key.child(&cause.parameter), cause.message)
}

/// Refuses passages that wear nothing, and wear of no passages, which `key` of the motion has and `needed` asks for.
pub(super) fn hold(
    names: [&str; 2],
    wears: [bool; 2],
    until: [Option<f64>; 2],
    passages: Option<f64>,
    [motion, key, needed, none]: [&'static str; 4],
) -> Result<(), Problem> {
    let key = Key::of(["motion", motion, key]);
    match (wears[0] || wears[1], passages) {
        (true, None) => return Err(Problem::missing(key, needed)),
        (false, Some(_)) => return Err(Problem::error(key, none)),
        _ => {}
    }
    for (which, limit) in until.iter().enumerate() {
        if limit.is_some() && !wears[which] {
            let message = format!("`{}` has no wear law: it reaches no limit", names[which]);
            return Err(Problem::error(Key::of(["until"]), message));
        }
    }
    Ok(())
}

/// The worn depths that end a case.
pub(super) fn limits(until: [Option<f64>; 2]) -> Vec<Limit> {
    let limit = |body: usize| Some(Limit { body, depth: until[body]? });
    (0..2).filter_map(limit).collect()
}

/// A case as a case file.
pub(super) fn print<A, B, M>(
    f: &mut Formatter<'_>,
    title: Option<&str>,
    (one, two): (&ProfiledPart<A>, &ProfiledPart<B>),
    friction: Option<&ChosenPart<Box<dyn Friction>>>,
    motion: &ChosenPart<M>,
    until: [Option<f64>; 2],
) -> fmt::Result {
    if let Some(title) = title {
        writeln!(f, "title = {}\n", quoted(title))?;
    }
    print_body(f, one)?;
    print_body(f, two)?;
    if let Some(friction) = friction {
        print_chosen(f, "friction", friction)?;
    }
    print_chosen(f, "motion", motion)?;
    for (name, limit) in [&one.name, &two.name].into_iter().zip(until) {
        if let Some(depth) = limit {
            writeln!(f, "until.wear_depth_{name} = {}", si(depth, "m"))?;
        }
    }
    Ok(())
}
