//! Formulas at random, computed by another program too.

use approx::assert_relative_eq;
use exmex::Express;

use super::{one, tape};
use crate::wear::Rubbing;

/// SplitMix64, as in `tests/common/random.rs`.
struct Random(u64);

impl Random {
    fn below(&mut self, count: u64) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)) % count
    }

    /// A formula of positive parts, as deep as that; here and as `exmex` writes it.
    fn formula(&mut self, depth: u32) -> [String; 2] {
        if depth == 0 {
            let name = ["p", "s", "v", "distance", "worn", "rolled"][self.below(6) as usize];
            return [name; 2].map(str::to_owned);
        }
        let parts = [(); 3].map(|()| self.formula(depth - 1));
        let (template, other) = TEMPLATES[self.below(TEMPLATES.len() as u64) as usize];
        let fill = |template: &str, which: usize| {
            let [a, b, c] = &parts;
            let fill = |letter| match letter {
                'A' => a[which].clone(),
                'B' => b[which].clone(),
                'C' => c[which].clone(),
                letter => letter.to_string(),
            };
            template.chars().map(fill).collect()
        };
        [fill(template, 0), fill(if other.is_empty() { template } else { other }, 1)]
    }
}

/// Formulas of parts A, B and C, and what `exmex` calls them where it is something else.
const TEMPLATES: &[(&str, &str)] = &[
    ("A + B*C", ""),
    ("(A + B)*C", ""),
    ("A/(B)/(C)", ""),
    ("(A - B - C)^2", ""),
    ("(A)^0.7 + B", ""),
    ("abs(A - B)*C", ""),
    ("min(A, B) + C", "((A) min (B)) + C"),
    ("max(A, B)*(C)", "((A) max (B))*(C)"),
    ("exp(-(A))*(B + C)", ""),
    ("ln(1 + A) + B/(1 + C)", ""),
    ("sqrt(A) + tanh(B)*C", ""),
    ("(1 + sin(A))*(B)*C", ""),
    ("2 + cos(A + B) - (C)/(2 + C)", ""),
    ("(A)^(1/(1 + B)) + C", ""),
];

/// The crate `exmex` reads and computes the same formulas. In longer ones its version 0.21 loses terms: of 200 formulas a
/// level deeper one differs, where Python gives what is found here.
#[test]
fn another_program_computes_the_same() {
    let mut random = Random(7);
    let mut rubbing = Rubbing::new(0.7, 0.4).at_speed(1.3).rolling(0.9).after(0.2, 0.6);
    for _ in 0..200 {
        let [formula, theirs] = random.formula(2);
        rubbing.pressure = 0.1 + random.below(100) as f64 / 50.0;
        let other = exmex::parse::<f64>(&theirs).unwrap();
        let values = other.var_names().iter().map(|name| match &**name {
            "p" => rubbing.pressure,
            "s" => rubbing.slip,
            "v" => rubbing.speed,
            "distance" => rubbing.distance,
            "worn" => rubbing.depth,
            _ => rubbing.rolled,
        });
        let expected = other.eval(&values.collect::<Vec<_>>()).unwrap();
        let found = tape(&formula).at(&one(&rubbing)).0;
        assert_relative_eq!(found, expected, max_relative = 1e-12);
    }
}
