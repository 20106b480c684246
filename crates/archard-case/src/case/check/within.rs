//! How many elements end within times that people wait.

use std::fmt;

use super::Forecast;
use super::memory::{available_to_equations, free_memory};
use super::pace::Pace;
use super::runtime::{Runtime, work};
use crate::case::definition::{BodyCase, Case};
use archard::body::Elasticity;
use archard::compliance::bem::{self, Size};
use archard::parameters::Value;

/// The times (s), and what they are called.
const TIMES: [(f64, &str); 2] = [(60.0, "a minute"), (600.0, "ten minutes")];
/// Elements along a side beyond which nobody asks. A choice of effort.
const MOST: usize = 1 << 14;

/// The elements along x and y that end within each of the times, as far as the memory that is free holds them.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::case) struct Within {
    /// Whose they are, in words.
    of: String,
    elements: [Option<[usize; 2]>; 2],
}

impl Within {
    /// Of the first body whose zone is divided by its mesh, at a pace of equations.
    pub fn of_meshes(case: &Case, pace: &Pace) -> Option<Self> {
        let size = |body: &BodyCase, elements: Option<[usize; 2]>| -> Option<Size> {
            let finite = body.finite.as_ref().filter(|own| own.elasticity.is_own())?;
            let mut finite = finite.clone();
            if let Some(elements) = elements {
                let mut contact = finite.mesh.values.section("contact")?.clone();
                contact.insert("elements", Value::Pair(elements.map(|count| count as f64)));
                finite.mesh.values.insert("contact", Value::Section(contact));
            }
            Some(Size::of(&finite.meshed().ok()?, finite.interpolation))
        };
        let divided = |body: &BodyCase| {
            let finite = body.finite.as_ref()?;
            let own = finite.elasticity == Elasticity::BoundaryElements;
            let contact = finite.mesh.values.section("contact").filter(|_| own)?;
            Some(contact.pair("elements")?.map(|count| count as usize))
        };
        let (which, elements) =
            case.bodies.iter().enumerate().find_map(|(at, body)| Some((at, divided(body)?)))?;
        let other = size(&case.bodies[1 - which], None);
        let cost = |elements: [usize; 2]| {
            let sizes = [size(&case.bodies[which], Some(elements)), other];
            let operations: f64 = sizes.iter().flatten().map(|own| own.operations()).sum();
            let fits = sizes[0].is_some() && bem::memory(sizes) <= available_to_equations();
            if fits { pace.seconds(operations) } else { f64::INFINITY }
        };
        let of = format!(", of `{}`", case.bodies[which].name);
        Self::by(of, elements, cost)
    }

    /// Of a frame, whose runtime was measured on the elements that the case has.
    pub fn of_frame(case: &Case, forecast: &Forecast, runtime: &Runtime) -> Option<Self> {
        let Runtime::Measured { seconds, .. } = runtime else { return None };
        // A mesh divides its zone in elements of two pairs along each axis.
        let by_mesh =
            |body: &BodyCase| body.finite.as_ref().is_some_and(|own| own.zone().is_some());
        let along = if case.bodies.iter().any(by_mesh) { 2 } else { 1 };
        let own = case.frame.elements.iter().product::<usize>();
        let elements = case.frame.elements.map(|count| count / along);
        let cost = |elements: [usize; 2]| {
            let pairs = elements.iter().map(|count| along * count).product::<usize>();
            let fits = forecast.memory * pairs as f64 / own as f64 <= free_memory();
            if fits { seconds * work(pairs) / work(own) } else { f64::INFINITY }
        };
        Self::by(String::new(), elements, cost)
    }

    fn by(of: String, elements: [usize; 2], cost: impl Fn([usize; 2]) -> f64) -> Option<Self> {
        let elements = TIMES.map(|(seconds, _)| most(elements, seconds, &cost));
        elements.iter().any(Option::is_some).then_some(Self { of, elements })
    }
}

/// The most elements along x and y, even numbers in the ratio of others, whose cost is within a limit; `None` where the fewest are
/// not. The cost rises with the elements.
fn most(ratio: [usize; 2], limit: f64, cost: impl Fn([usize; 2]) -> f64) -> Option<[usize; 2]> {
    let longer = ratio[0].max(ratio[1]) as f64;
    let of = |half: usize| {
        ratio.map(|own| match own {
            1 => 1,
            own => 2 * ((half as f64 * own as f64 / longer).round() as usize).max(1),
        })
    };
    let within = |half: usize| cost(of(half)) <= limit;
    let (mut low, mut high) = (0, 1);
    while high < MOST && within(high) {
        (low, high) = (high, 2 * high);
    }
    while high - low > 1 {
        let middle = (low + high) / 2;
        if within(middle) { low = middle } else { high = middle }
    }
    (low > 0).then(|| of(low))
}

impl fmt::Display for Within {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known = self.elements.iter().zip(TIMES).filter_map(|(own, time)| Some(((*own)?, time)));
        let each = known.map(|([x, y], (_, time))| format!("{x} x {y} in {time}"));
        let each = each.collect::<Vec<_>>().join(", ");
        writeln!(f, "elements in time  {each}{}", self.of)
    }
}

#[cfg(test)]
mod tests {
    use super::super::pace::Pace;
    use super::{TIMES, Within, most};
    use crate::CaseFile;

    const MESHED: &str = "body.ball.rigid = true\nbody.ball.profile.sphere.radius = \"50 mm\"\n\
        body.block.material = { young = \"210 GPa\", poisson = 0.3 }\n\
        body.block.elasticity = \"boundary_elements\"\nbody.block.supports = { bottom = \"clamped\" }\n\
        body.block.symmetry = [\"x\", \"y\"]\n\
        body.block.mesh.box = { size = [\"10 mm\", \"10 mm\", \"10 mm\"], contact = { size = [\"5.2 mm\", \"2.6 mm\"], elements = [12, 6] } }\n\
        motion.indentation.approach = \"0.02 mm\"\n";

    /// As many elements end in a time by the operations that the case with these says, and two more do not.
    #[test]
    fn elements_of_a_mesh_are_those_whose_equations_end_in_time() {
        let of = |[x, y]: [usize; 2]| {
            let file = CaseFile::from_text("case", MESHED, "");
            let set = format!("body.block.mesh.box.contact.elements=[{x}, {y}]");
            file.set(set).resolve().unwrap()
        };
        let pace = Pace::of(1e12).unwrap();
        let within = Within::of_meshes(&of([12, 6]).case, &pace).unwrap();
        for (elements, (seconds, _)) in within.elements.into_iter().zip(TIMES) {
            let Some([x, y]) = elements else { continue };
            let time = |elements: [usize; 2]| pace.seconds(of(elements).forecast.operations);
            assert!(x == 2 * y || x + 2 == 2 * y, "{x} {y}");
            assert!(time([x, y]) <= seconds, "{x} {y}: {}", time([x, y]));
            // The most, or as many as the memory holds.
            assert!(time([x + 2, y + 2]) > 0.5 * seconds, "{x} {y}");
        }
        assert!(within.elements[0].is_some() && within.to_string().ends_with(", of `block`\n"));
    }

    /// Costs as the area, of a square, of a side twice as long as the other and of a line.
    #[test]
    fn the_most_elements_are_those_of_the_limit() {
        let cost = |[x, y]: [usize; 2]| (x * y) as f64;
        assert_eq!(most([10, 10], 400.0, cost), Some([20, 20]));
        assert_eq!(most([10, 10], 483.9, cost), Some([20, 20]));
        assert_eq!(most([10, 5], 200.0, cost), Some([20, 10]));
        assert_eq!(most([64, 1], 1000.0, cost), Some([1000, 1]));
        assert_eq!(most([10, 10], 3.0, cost), None);
        let said = Within { of: ", of `a`".to_owned(), elements: [Some([2, 4]), Some([6, 12])] };
        let line = "elements in time  2 x 4 in a minute, 6 x 12 in ten minutes, of `a`\n";
        assert_eq!(said.to_string(), line);
    }
}
