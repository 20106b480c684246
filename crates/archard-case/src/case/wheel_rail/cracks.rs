//! Models of rolling contact fatigue, `cracks` of a wheel or a rail.

use archard::parameters::{Choice, Invalid, Parameter, Quantity, Values};
use archard_rail::wear::Cracks;

/// The models.
pub const CRACKS: &[Choice<Cracks>] = &[Choice {
    name: "t_gamma",
    meaning: "damage by the work of friction on each metre, which more work wears off again",
    parameters: &[
        Parameter::optional(
            "threshold",
            Quantity::Force,
            "work on each metre below which nothing cracks; 15 N if not given, as of rails of R260",
        ),
        Parameter::optional(
            "peak",
            Quantity::Force,
            "work at which a passage does most; 65 N if not given",
        ),
        Parameter::optional(
            "balance",
            Quantity::Force,
            "work at which wear is as fast as cracks; 175 N if not given",
        ),
        Parameter::optional(
            "most",
            Quantity::Number,
            "damage of a passage at the peak; 1e-5 if not given",
        ),
        Parameter::optional(
            "beyond",
            Quantity::Word(&["heals", "rests"]),
            "whether more work than the balance wears cracks off, or does nothing; heals if not given",
        ),
    ],
    build,
}];

fn build(values: &Values) -> Result<Cracks, Invalid> {
    let or = |name, default| values.number(name).unwrap_or(default);
    let Cracks { threshold, peak, balance, most, heals } = Cracks::R260;
    let cracks = Cracks {
        threshold: or("threshold", threshold),
        peak: or("peak", peak),
        balance: or("balance", balance),
        most: or("most", most),
        heals: values.word("beyond").map_or(heals, |word| word == "heals"),
    };
    if !(cracks.threshold < cracks.peak && cracks.peak < cracks.balance) {
        let Cracks { threshold, peak, balance, .. } = cracks;
        let message = format!(
            "the work rises from the threshold, {threshold} N, over the peak, {peak} N, to the balance, {balance} N"
        );
        return Err(Invalid::new("peak", message));
    }
    Ok(cracks)
}
