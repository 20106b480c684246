//! The next set: pairs whose pressures may change, and those that are held at none or at the hardness.

use super::Iteration;
use crate::numerics::vector::{sum_with, sweep, sweep_with, update};
use crate::solve::contact_set::settle;

impl Iteration<'_> {
    /// Takes the pairs whose pressures may change as the set and holds those of others; returns whether it is another set.
    pub fn change_set(&mut self) -> bool {
        let (own, hardness) = (self.step.compliance.normal_self_term(), self.step.hardness);
        let [changed, cut] = sweep(
            [&mut self.pressure, &mut self.contact],
            [&self.gap, self.step.addition],
            |[pressure, before], [gap, addition]| {
                let next = settle(pressure, gap, own + addition, hardness);
                let changed = next != [pressure, before];
                (next, [f64::from(changed), f64::from(next[0] != pressure)])
            },
        );
        if changed == 0.0 {
            return false;
        }
        self.start_set(cut > 0.0);
        true
    }

    /// Holds what is left of pressures below zero and above the hardness there, and takes their pairs from the set; returns
    /// whether there were any.
    pub fn cut_off(&mut self) -> bool {
        let hardness = self.step.hardness;
        let [cut] =
            sweep([&mut self.pressure, &mut self.contact], [], |[pressure, contact], []| {
                let kept = pressure.max(0.0).min(hardness);
                let beyond = f64::from(kept != pressure);
                ([kept, contact * (1.0 - beyond)], [beyond])
            });
        if cut > 0.0 {
            self.start_set(true);
        }
        cut > 0.0
    }

    /// Begins the iteration on the set, after pressures were cut or not. Those of the set bear what the others leave of the load;
    /// where they cannot, a projection chooses the set.
    fn start_set(&mut self, cut: bool) {
        if let (Some(load), true) = (self.load(), cut) {
            let hardness = self.step.hardness;
            let fields: [&[f64]; 2] = [&self.pressure, &self.contact];
            let term = |[weight, closing]: [f64; 2], [pressure, contact]: [f64; 2]| {
                let borne = weight * closing * pressure;
                let most = if contact > 0.0 { weight * closing * hardness } else { 0.0 };
                [contact * borne, (1.0 - contact) * borne, most]
            };
            let [open, held, most] =
                sum_with(self.beside(), fields, term).map(|sum| sum * self.step.measure.area);
            let left = load - held;
            if open > 0.0 && 0.0 < left && left < most {
                let factor = left / open;
                update(&mut self.pressure, [&self.contact], |pressure, [contact]| {
                    if contact > 0.0 { factor * pressure } else { pressure }
                });
            } else {
                self.project(load);
            }
        }
        if cut {
            self.refresh();
        }
        self.begin_set();
    }

    /// Moves the bodies so that the pressures which the gaps ask of the pairs, between none and the hardness, bear the load (N).
    fn project(&mut self, load: f64) {
        let (own, hardness) = (self.step.compliance.normal_self_term(), self.step.hardness);
        let asked = |[pressure, gap, addition]: [f64; 3], closed: f64| {
            (pressure - (gap - closed) / (own + addition)).max(0.0).min(hardness)
        };
        let fields = [&self.pressure, &self.gap, self.step.addition];
        let short = |approach: f64| {
            let [sum] = sum_with(self.beside(), fields, |[weight, closing], values| {
                [weight * closing * asked(values, closing * approach)]
            });
            load - sum * self.step.measure.area
        };
        let mut reach = own * load / self.step.measure.area / self.pressure.len() as f64;
        let [mut far, mut near] = loop {
            match [-reach, reach] {
                [far, near] if short(far) >= 0.0 && short(near) <= 0.0 => break [far, near],
                _ if reach.is_finite() => reach *= 2.0,
                _ => return,
            }
        };
        let mut middle = 0.5 * (near + far);
        while far < middle && middle < near {
            if short(middle) > 0.0 {
                far = middle
            } else {
                near = middle
            }
            middle = 0.5 * (near + far);
        }
        let [] = sweep_with(
            [self.step.measure.closing],
            [&mut self.pressure, &mut self.contact],
            [&self.gap, self.step.addition],
            |[closing], [pressure, _], [gap, addition]| {
                let pressure = asked([pressure, gap, addition], closing * near);
                ([pressure, f64::from(0.0 < pressure && pressure < hardness)], [])
            },
        );
    }
}
