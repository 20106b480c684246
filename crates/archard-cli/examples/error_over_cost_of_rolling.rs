//! What steady rolling costs and how far it is off, by the upwind difference alone and as Archard solves it:
//! `cargo run --example error_over_cost_of_rolling` prints tables and draws `book/src/error_over_cost.svg`.
//!
//! Twin discs of the case of that name, unworn, at 0.5 % creepage and at a spin;
//! seconds are those of one thread, for pressures and friction, the fewest of three runs. Errors are against the limit of fine elements, extrapolated
//! from 240 and 320 across the contact for errors that fall with the square of their size.

#[path = "../../archard-case/tests/framed/mod.rs"]
mod framed;

use std::fs;
use std::path::Path;
use std::time::Instant;

use archard::friction::Map;
use archard::problem::{ContactProblem, ContactState};
use archard::simulation::{Observer, Report};
use archard::solve::tangential::{self, FrictionSolver, Newton, Step};
use archard_case::CaseFile;
use kuva::backend::svg::SvgBackend;
use kuva::plot::{LegendPosition, LinePlot, ScatterPlot};
use kuva::render::figure::Figure;
use kuva::render::layout::Layout;
use kuva::render::plots::Plot;

type Wrong = Box<dyn std::error::Error + Send + Sync>;

/// Coefficient of friction of the case.
const FRICTION: f64 = 0.6;
/// Elements across the contact.
const ACROSS: [usize; 7] = [20, 40, 60, 80, 120, 160, 240];
const FINEST: usize = 320;
/// Times that each is solved, for the seconds.
const TIMES: usize = 3;
/// Width and height of a panel (px).
const PANEL: [f64; 2] = [620.0, 460.0];
/// How it is solved, and the colour of that.
const WAYS: [(&str, &str); 2] = [("upwind alone", "#d55e00"), ("as solved", "#0072b2")];

fn main() -> Result<(), Wrong> {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build()?;
    pool.install(|| {
        let creepage = table("0.5 % creepage", "motion.rolling.creepage=0.005")?;
        let spin = table("spin of 20 / m", "motion.rolling.spin=\"20 1/m\"")?;
        draw([
            ("Force, 0.5 % creepage", &creepage, 0),
            ("Wear, 0.5 % creepage", &creepage, 1),
            ("Force, spin of 20 / m", &spin, 0),
            ("Wear, spin of 20 / m", &spin, 1),
        ])
    })
}

/// Of both ways, for each number of elements: seconds, and the relative errors of force and wear.
type Course = [Vec<(f64, [f64; 2])>; 2];

/// Draws errors over seconds, a panel each.
fn draw(panels: [(&str, &Course, usize); 4]) -> Result<(), Wrong> {
    let drawn = panels.map(|(title, course, which)| {
        let plots: Vec<Plot> = WAYS
            .iter()
            .zip(course)
            .flat_map(|((name, colour), course)| {
                let points: Vec<(f64, f64)> = course
                    .iter()
                    .map(|(seconds, off)| (*seconds, 100.0 * off[which].abs()))
                    .collect();
                let line = LinePlot::new()
                    .with_data(points.iter().copied())
                    .with_color(*colour)
                    .with_legend(*name);
                let dots = ScatterPlot::new().with_data(points).with_color(*colour).with_size(4.0);
                [line.with_stroke_width(2.0).into(), dots.into()]
            })
            .collect();
        let layout = Layout::auto_from_plots(&plots)
            .with_log_scale()
            .with_title(title)
            .with_x_label("Seconds on one thread")
            .with_y_label("Error (%)")
            .with_legend_position(LegendPosition::InsideTopRight)
            .with_legend_box(false);
        (plots, layout)
    });
    let (plots, layouts) = drawn.into_iter().unzip();
    let [width, height] = PANEL;
    let figure =
        Figure::new(2, 2).with_cell_size(width, height).with_plots(plots).with_layouts(layouts);
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src/error_over_cost.svg");
    fs::write(path, SvgBackend::new().render_scene(&figure.render()))?;
    Ok(())
}

/// What is compared, and what it took.
struct Solved {
    /// Force along the direction of rolling or, without any, across it (N); deepest wear of a revolution over k_w (N/m).
    values: [f64; 2],
    applications: usize,
    seconds: f64,
}

fn table(name: &str, drive: &str) -> Result<Course, Wrong> {
    let fine = [ACROSS[ACROSS.len() - 1], FINEST];
    let [coarse, finest] = fine.map(|across| solved(across, drive));
    let (coarse, finest) = (coarse?.values, finest?.values);
    let ratio = (fine[1] as f64 / fine[0] as f64).powi(2);
    let limit = [0, 1].map(|at| finest[at] + (finest[at] - coarse[at]) / (ratio - 1.0));
    println!("## Twin discs, {name}\n");
    println!(
        "| elements across | upwind alone: force | wear | applications | s | as solved: force | wear | applications | s |"
    );
    println!("|---|---|---|---|---|---|---|---|---|");
    let mut course = Course::default();
    for across in ACROSS {
        let both = [fewest(|| upwind(across, drive))?, fewest(|| solved(across, drive))?];
        let mut cells = vec![];
        for (Solved { values, applications, seconds }, course) in both.into_iter().zip(&mut course)
        {
            let off = [0, 1].map(|at| values[at] / limit[at] - 1.0);
            course.push((seconds, off));
            let [force, wear] = off.map(|off| 100.0 * off);
            cells.push(format!("{force:+.2} % | {wear:+.2} % | {applications} | {seconds:.3}"));
        }
        println!("| {across} | {} |", cells.join(" | "));
    }
    println!();
    Ok(course)
}

/// What was solved some times, with the fewest seconds.
fn fewest(solve: impl Fn() -> Result<Solved, Wrong>) -> Result<Solved, Wrong> {
    let mut best = solve()?;
    for _ in 1..TIMES {
        best.seconds = best.seconds.min(solve()?.seconds);
    }
    Ok(best)
}

/// Keeps the last state.
#[derive(Default)]
struct Last(Option<ContactState>);

impl Observer for Last {
    fn observe(
        &mut self,
        report: &Report<'_>,
    ) -> Result<(), Box<dyn std::error::Error + Send + Sync>> {
        self.0 = Some(report.state.clone());
        Ok(())
    }
}

/// The unworn discs with that many elements across the contact, its state, applications and seconds.
fn contact(
    across: usize,
    options: &[&str],
) -> Result<(ContactProblem, ContactState, usize, f64), Wrong> {
    let path = framed::folder("twin_disc");
    let elements = across + 4;
    let [x, y] =
        [0.2165120, 0.8265901].map(|half: f64| 2.0 * half * elements as f64 / across as f64);
    let frame = [
        format!("frame.size=[\"{x} mm\", \"{y} mm\"]"),
        format!("frame.elements=[{elements}, {elements}]"),
    ];
    let unworn = [
        "motion.rolling.creepage=",
        "motion.rolling.tolerance=",
        "motion.rolling.revolutions=0",
        "output=",
    ];
    let all = frame.iter().map(String::as_str).chain(unworn).chain(options.iter().copied());
    let file = all.fold(CaseFile::read(&path)?, |file, option| file.set(option));
    let wrong = |problems: Vec<archard_case::Problem>| {
        problems.iter().map(|problem| problem.title()).collect::<Vec<_>>().join("\n")
    };
    let simulation = file.resolve().map_err(wrong)?.case.build()?;
    let mut last = Last::default();
    let start = Instant::now();
    let effort = simulation.run(&mut [&mut last])?;
    let seconds = start.elapsed().as_secs_f64();
    let state = last.0.ok_or("no state")?;
    Ok((simulation.problem, state, effort.applications, seconds))
}

/// As Archard solves it.
fn solved(across: usize, drive: &str) -> Result<Solved, Wrong> {
    let (problem, state, applications, seconds) = contact(across, &[drive])?;
    let tangential = state.tangential.ok_or("no friction")?;
    let values = values(&problem, &tangential.traction, &tangential.slip)?;
    Ok(Solved { values, applications, seconds })
}

/// The slip of each passage, and no more, under the pressures of the discs without friction: their slip is that of the rigid
/// bodies.
fn upwind(across: usize, drive: &str) -> Result<Solved, Wrong> {
    let (problem, state, applications, seconds) = contact(across, &[drive, "friction="])?;
    let rigid = state.tangential.ok_or("no slip")?.slip;
    let limit: Vec<f64> = state.pressure.iter().map(|pressure| FRICTION * pressure).collect();
    let start = Instant::now();
    let map = problem.compliance.rolling(problem.frame.flow(problem.motion.direction)?);
    let step = Step {
        map: &*map,
        elements: problem.frame.elements(),
        measure: problem.frame.measure(),
        limit: &limit,
        rigid: [&rigid[0], &rigid[1]],
        prescribed: &[],
    };
    let solver: &dyn FrictionSolver = &Newton::default();
    let outcome = tangential::solve(solver, &step, Map::IDENTITY.into(), None);
    let seconds = seconds + start.elapsed().as_secs_f64();
    let values = values(&problem, &outcome.traction, &outcome.slip)?;
    Ok(Solved { values, applications: applications + outcome.applications, seconds })
}

/// The values compared, of tractions (Pa) and slips (m).
fn values(
    problem: &ContactProblem,
    traction: &[Vec<f64>; 2],
    slip: &[Vec<f64>; 2],
) -> Result<[f64; 2], Wrong> {
    let drives = problem.motion.driven(0.0).ok_or("nothing rolls")?;
    let flow = problem.frame.flow(problem.motion.direction)?;
    let [x, y] = traction.each_ref().map(|traction| problem.frame.integrate(traction));
    let force = if drives.spin == 0.0 { x } else { y };
    let means = traction.each_ref().map(|traction| flow.on_the_way(traction));
    let work = |pair: usize| means[0][pair] * slip[0][pair] + means[1][pair] * slip[1][pair];
    let lines = flow.lines();
    let of_line = lines.iter().map(|line| -> f64 {
        line.passages.iter().map(|one| work(one.pair).max(0.0)).sum::<f64>() / FRICTION
    });
    Ok([force, of_line.fold(0.0, f64::max)])
}
