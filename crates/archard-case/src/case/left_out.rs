//! What the theory leaves out, by the keys that someone may look for: the rows of the page on limits (`book/src/limits.md`).

/// Beginnings of keys, and what to do without what they ask for.
const LEFT_OUT: &[(&[&str], &str)] = &[
    (
        &["lubric", "oil", "grease", "viscosity", "film"],
        "no lubricant is computed: give the coefficients of friction and wear of the lubricated pair, and use another program for the \
         pressure of a full film",
    ),
    (
        &["debris", "third_body"],
        "debris disappears: what third bodies do is in k, so fit k to tests of the same kind",
    ),
    (
        &["adhesi", "work_of_adhesion", "surface_energy", "cohesi"],
        "surfaces do not attract each other",
    ),
    (
        &["plastic", "yield"],
        "bodies are elastic: `output.stress.BODY.yield_strength` says how much of the strength is used, and a `hardness` of a body bounds the pressure where surfaces stay opposite each other",
    ),
    (
        &["roughness"],
        "roughness finer than the elements is left out: give a `profile.surface` or `profile.table`, and k of tests with the same finish",
    ),
    (
        &["mass", "inertia", "damping", "vibration", "stick_slip"],
        "every state is in equilibrium: there is no inertia and no vibration",
    ),
    (
        &["expansion", "thermal_expansion", "conductivity_of_contact"],
        "bodies do not expand; the flash temperature of the patch is computed, that of the bodies is given",
    ),
    (
        &["fatigue", "crack", "fracture", "toughness", "spall"],
        "no crack grows: `fatigue` and `damage` of `output.stress.BODY` say where and when one begins",
    ),
    (
        &["visco", "relaxation", "creep_modulus", "loss_factor"],
        "bodies are elastic: take their stiffness at the rate of the motion",
    ),
];

/// What to do without the effect that a key asks for, where the theory leaves that out.
pub(super) fn remedy(key: &str) -> Option<String> {
    let key = key.to_lowercase();
    let asks = |words: &&(&[&str], &str)| words.0.iter().any(|word| key.starts_with(word));
    let (_, remedy) = LEFT_OUT.iter().find(asks)?;
    Some(format!("{remedy} (in the book: What Archard does not know)"))
}
