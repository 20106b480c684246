//! Contracts of tied pairs: they bear their share, count in forces that are given, and slip as any do.

use approx::assert_relative_eq;
use archard::closed_form::Hertz;
use archard::compliance::{Compliance, HalfSpace};
use archard::frame::Direction;
use archard::friction::Map;
use archard::solve::Status;
use archard::solve::tangential::{
    self, Admissible, FRICTION_SOLVERS, Newton, Outcome, PrescribedForce, Tie,
};

use super::rolling::norm;
use crate::common::{Ball, STEEL, choose};

/// A contact in a corner of the frame, so that a part of the frame is solved, and one that fills it: all solvers find
/// the same tractions, under forces that are given too.
#[test]
fn tied_pairs_bear_their_share() {
    for (elements, size, middle) in
        [([15, 15], [0.52e-3, 2e-3], [0.0; 2]), ([40, 30], [1.4e-3, 4e-3], [0.3e-3, -0.7e-3])]
    {
        let ball = Ball { size, elements, ..Ball::pin_on_disc(1) };
        let frame = ball.problem().frame;
        let compliance = HalfSpace::new([Some(&STEEL), Some(&STEEL)], &frame);
        let hertz = Hertz::from_load([61.7, 8.0], 115e9, 300.0).unwrap();
        let pressure = |pair: usize| {
            let place = frame.place(pair);
            hertz.pressure([place[0] - middle[0], place[1] - middle[1]])
        };
        let limit: Vec<f64> = (0..frame.len()).map(|pair| 0.6 * pressure(pair)).collect();
        let bears = frame.integrate(&limit);
        for reversed in [false, true] {
            let direction = Direction { axis: 0, reversed };
            let map = compliance.rolling(frame.flow(direction).unwrap());
            let first = |line: Vec<usize>| line.into_iter().position(|pair| limit[pair] > 0.0);
            let lines = direction.lines(elements).map(|line| line.collect::<Vec<_>>());
            let tie = |line: Vec<usize>| {
                let first = first(line.clone())?;
                let [pair, to] = [line[first], *line.get(first + 1)?];
                let share = 0.7 * (limit[pair] / limit[to]).min(1.0);
                (limit[to] > 0.0).then_some(Tie { pair, to, share })
            };
            let ties: Vec<Tie> = lines.filter_map(tie).collect();
            assert!(ties.len() > 5);
            let admissible = Admissible { ties: &ties, ..Map::IDENTITY.into() };
            let unit = map.own() * 0.6 * hertz.peak_pressure;
            let rigid = [0.2, -0.1].map(|slip| vec![slip * unit; frame.len()]);
            for forces in
                [vec![], vec![PrescribedForce { direction: [0.0, 1.0], force: 0.4 * bears }]]
            {
                let step = tangential::Step {
                    map: &*map,
                    elements,
                    measure: frame.measure(),
                    limit: &limit,
                    rigid: [&rigid[0], &rigid[1]],
                    prescribed: &forces,
                };
                let mut known: Option<Outcome> = None;
                for choice in FRICTION_SOLVERS {
                    let name = choice.name;
                    let solver = choose(FRICTION_SOLVERS, name, &[("tolerance", 1e-8)]);
                    let outcome = tangential::solve(&*solver, &step, admissible, None);
                    assert_eq!(outcome.status, Status::Converged, "{name}");
                    let [t1, t2] = &outcome.traction;
                    for Tie { pair, to, share } in &ties {
                        assert_eq!([t1[*pair], t2[*pair]], [share * t1[*to], share * t2[*to]]);
                    }
                    for given in &forces {
                        let force = frame.integrate(t2);
                        assert_relative_eq!(force, given.force, epsilon = 1e-7 * bears);
                    }
                    // The slip is that of all tractions.
                    let mut taken = [vec![0.0; frame.len()], vec![0.0; frame.len()]];
                    let [one, two] = &mut taken;
                    map.apply([t1, t2], [one, two]);
                    for pair in (0..frame.len()).filter(|&pair| limit[pair] > 0.0) {
                        let slip = rigid[0][pair] - taken[0][pair];
                        assert_relative_eq!(outcome.slip[0][pair], slip, epsilon = 1e-9 * unit);
                    }
                    let known = known.get_or_insert_with(|| outcome.clone());
                    let apart = [0, 1].map(|axis| {
                        let pairs = outcome.traction[axis].iter().zip(&known.traction[axis]);
                        pairs.map(|(one, other)| one - other).collect::<Vec<_>>()
                    });
                    let apart = norm([&apart[0], &apart[1]]) / norm([&limit, &[]]);
                    assert!(apart < 1e-4, "{name}: {apart:e} apart along {direction:?}");
                }
            }
        }
    }
}

/// The entries of twin discs tied: hardly more applications than without.
#[test]
fn ties_cost_no_applications() {
    let elements = [84, 84];
    let ball = Ball { size: [0.52e-3, 2e-3], elements, ..Ball::pin_on_disc(1) };
    let frame = ball.problem().frame;
    let compliance = HalfSpace::new([Some(&STEEL), Some(&STEEL)], &frame);
    let hertz = Hertz::from_load([61.7, 8.0], 115e9, 300.0).unwrap();
    let limit: Vec<f64> =
        (0..frame.len()).map(|pair| 0.6 * hertz.pressure(frame.place(pair))).collect();
    let direction = Direction::X;
    let map = compliance.rolling(frame.flow(direction).unwrap());
    let tie = |line: Vec<usize>| {
        let first = line.iter().position(|&pair| limit[pair] > 0.0)?;
        let [pair, to] = [line[first], *line.get(first + 1)?];
        (limit[to] > limit[pair]).then(|| Tie { pair, to, share: limit[pair] / limit[to] })
    };
    let lines = direction.lines(elements).map(|line| line.collect::<Vec<_>>());
    let ties: Vec<Tie> = lines.filter_map(tie).collect();
    let rigid = [vec![0.005 * frame.size()[0] / 84.0; frame.len()], vec![0.0; frame.len()]];
    let step = tangential::Step {
        map: &*map,
        elements,
        measure: frame.measure(),
        limit: &limit,
        rigid: [&rigid[0], &rigid[1]],
        prescribed: &[],
    };
    let [free, tied] = [&[][..], &ties].map(|ties| {
        let admissible = Admissible { ties, ..Map::IDENTITY.into() };
        let outcome = tangential::solve(&Newton::default(), &step, admissible, None);
        assert_eq!(outcome.status, Status::Converged);
        outcome.applications as f64
    });
    assert!(tied <= 1.3 * free, "{free} and {tied} applications");
}
