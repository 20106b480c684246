//! Surfaces that wear over many passages.
//!
//! The depths at the nodes are ordinary differential equations in the number of passages, by the classical method of Runge and Kutta. The
//! same with half as many steps says how far off they are.

/// Steps to begin with; half of them are the first to compare with.
const FEWEST: usize = 16;
/// Most steps. A budget: what is not met by then is in the error.
const MOST: usize = 1 << 12;
/// Error, relative to the deepest, from which on steps are not halved further. A choice well below all else that is known of machine parts.
const ENOUGH: f64 = 1e-6;

/// A depth (m) of a body that ends its life.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limit {
    /// The body, 0 or 1.
    pub body: usize,
    /// The depth (m).
    pub depth: f64,
}

/// Two bodies after a number of passages.
#[derive(Debug, Clone, PartialEq)]
pub struct Moment {
    /// Passages: meshes of a flank of gear 1, turns of a cam.
    pub passages: f64,
    /// Worn depths (m) of both bodies, node by node.
    pub depths: [Vec<f64>; 2],
}

/// Depths of both bodies, node by node.
pub(crate) type Depths = [Vec<f64>; 2];

/// The node that has lost most, the depth (m) there and its error.
pub(crate) fn deepest(depths: &[f64], errors: &[f64]) -> (usize, [f64; 2]) {
    let deeper = |most: usize, at: usize| if depths[at] > depths[most] { at } else { most };
    let at = (0..depths.len()).fold(0, deeper);
    (at, [depths[at], errors[at]])
}

/// Two bodies that wear.
pub(crate) trait Wearing {
    /// Nodes of both bodies.
    fn nodes(&self) -> [usize; 2];

    /// Depths (m) a passage, of bodies that have lost so much before.
    fn rates(&self, depths: &Depths) -> Depths;
}

/// How two bodies have worn.
pub(crate) struct Marched {
    /// From new to worn.
    pub course: Vec<Moment>,
    /// Error (m) by steps of the depths at the end.
    pub errors: Depths,
    /// The limit that ended it, and the error by steps of the number of passages.
    pub life: Option<(Limit, f64)>,
}

/// Depths after so many more passages.
pub(crate) fn step(bodies: &dyn Wearing, depths: &Depths, passages: f64) -> Depths {
    let after = |rates: &Depths, share: f64| {
        [0, 1].map(|body| {
            let both = depths[body].iter().zip(&rates[body]);
            both.map(|(depth, rate)| depth + share * passages * rate).collect::<Vec<_>>()
        })
    };
    let first = bodies.rates(depths);
    let second = bodies.rates(&after(&first, 0.5));
    let third = bodies.rates(&after(&second, 0.5));
    let fourth = bodies.rates(&after(&third, 1.0));
    let mean = [0, 1].map(|body| {
        (0..first[body].len())
            .map(|node| {
                let middle = second[body][node] + third[body][node];
                (first[body][node] + 2.0 * middle + fourth[body][node]) / 6.0
            })
            .collect()
    });
    after(&mean, 1.0)
}

/// All of it in that many steps, and the limit that ended it.
fn steps(
    bodies: &dyn Wearing,
    passages: f64,
    steps: usize,
    limits: &[Limit],
) -> (Vec<Moment>, Option<Limit>) {
    let depths = bodies.nodes().map(|count| vec![0.0; count]);
    let mut course = vec![Moment { passages: 0.0, depths }];
    let length = passages / steps as f64;
    for index in 0..steps {
        let from = &course[index];
        let next = step(bodies, &from.depths, length);
        let Some(limit) = first_beyond(limits, &next) else {
            course.push(Moment { passages: length * (index + 1) as f64, depths: next });
            continue;
        };
        // The part of the step after which it is met, by halves; another limit may be met before.
        let (mut least, mut most, mut met) = (0.0, 1.0, limit);
        while most - least > f64::EPSILON {
            let share = 0.5 * (least + most);
            match first_beyond(limits, &step(bodies, &from.depths, share * length)) {
                Some(limit) => (most, met) = (share, limit),
                None => least = share,
            }
        }
        let depths = step(bodies, &from.depths, most * length);
        course.push(Moment { passages: from.passages + most * length, depths });
        return (course, Some(met));
    }
    (course, None)
}

/// The limit that is passed by most, relative to it.
fn first_beyond(limits: &[Limit], depths: &Depths) -> Option<Limit> {
    let over = |limit: &Limit| depths[limit.body].iter().copied().fold(0.0, f64::max) / limit.depth;
    let passed = limits.iter().filter(|limit| over(limit) >= 1.0);
    passed.max_by(|one, other| over(one).total_cmp(&over(other))).copied()
}

/// Wears two bodies over so many passages, or until a limit is reached.
pub(crate) fn march(bodies: &dyn Wearing, passages: f64, limits: &[Limit]) -> Marched {
    let mut count = FEWEST;
    let mut coarse = steps(bodies, passages, count / 2, limits).0;
    loop {
        let (course, met) = steps(bodies, passages, count, limits);
        // Both at the same number of passages: the finer one goes on to the end of the coarser.
        let [fine, rough] = [&course, &coarse].map(|course| &course[course.len() - 1]);
        let there = step(bodies, &fine.depths, rough.passages - fine.passages);
        let errors = [0, 1].map(|body| {
            let both = there[body].iter().zip(&rough.depths[body]);
            both.map(|(fine, rough)| (fine - rough).abs()).collect::<Vec<_>>()
        });
        let most = |fields: &Depths| fields.iter().flatten().copied().fold(0.0, f64::max);
        let until = (rough.passages - fine.passages).abs();
        if most(&errors) <= ENOUGH * most(&fine.depths) || count >= MOST {
            return Marched { course, errors, life: met.map(|limit| (limit, until)) };
        }
        coarse = course;
        count *= 2;
    }
}
