//! Half-spaces under rectangles of unequal sizes, maybe on a quarter of a symmetric frame: a dense matrix, as
//! meshed bodies have one.

use std::sync::Arc;

use archard::body::Material;
use archard::compliance::{Compliance, Preconditioner};
use archard::frame::{ContactFrame, Pairs, VectorField};
use archard::numerics::dense::Cholesky;
use archard::problem::ContactProblem;
use archard::simulation::Simulation;

/// A grid of rectangles of unequal sizes, symmetric about its centre.
#[derive(Debug, Clone, Copy)]
pub struct Uneven {
    /// Size of the whole frame (m).
    pub size: [f64; 2],
    /// Even numbers of elements of the whole frame.
    pub elements: [usize; 2],
    /// How much sizes differ from their mean at most, relative to it.
    pub unevenness: f64,
    /// Planes of symmetry with only the positive side there.
    pub mirrored: [bool; 2],
    /// Whether the matrix is made symmetric; collocation leaves it a little unsymmetric.
    pub symmetric: bool,
    /// Angle (rad) by which t1 is turned from x towards y.
    pub turned: f64,
    /// Angle (rad) by which n is tilted from z towards x.
    pub tilted: f64,
}

impl Uneven {
    pub fn new(side: f64, elements: usize) -> Self {
        Self {
            size: [side; 2],
            elements: [elements; 2],
            unevenness: 0.3,
            mirrored: [false; 2],
            symmetric: true,
            turned: 0.0,
            tilted: 0.0,
        }
    }

    /// Lower and upper edges (m) of the elements along an axis.
    fn edges(&self, axis: usize) -> Vec<[f64; 2]> {
        let half = self.elements[axis] / 2;
        let width = |index: usize| 1.0 + self.unevenness * (2.1 * index as f64).cos();
        let total: f64 = (0..half).map(width).sum();
        let mut edges = vec![];
        let mut low = 0.0;
        for index in 0..half {
            let high = low + 0.5 * self.size[axis] * width(index) / total;
            edges.push([low, high]);
            low = high;
        }
        if self.mirrored[axis] {
            return edges;
        }
        let below = edges.iter().rev().map(|[low, high]| [-high, -low]);
        below.chain(edges.iter().copied()).collect()
    }

    /// Edges of every element along x and along y.
    fn rectangles(&self) -> Vec<[[f64; 2]; 2]> {
        let [along_x, along_y] = [0, 1].map(|axis| self.edges(axis));
        along_y.iter().flat_map(|y| along_x.iter().map(|x| [*x, *y])).collect()
    }

    /// The frame between two profiles.
    pub fn frame(&self, problem: &ContactProblem) -> ContactFrame {
        let rectangles = self.rectangles();
        let middle = |[x, y]: &[[f64; 2]; 2]| [0.5 * (x[0] + x[1]), 0.5 * (y[0] + y[1]), 0.0];
        let images: f64 =
            self.mirrored.map(|mirrored| if mirrored { 2.0 } else { 1.0 }).iter().product();
        let places: Vec<[f64; 3]> = rectangles.iter().map(middle).collect();
        let gap = places
            .iter()
            .map(|[x, y, _]| problem.bodies.iter().map(|body| body.profile.recess(*x, *y)).sum());
        let outline = |[x, y]: &[[f64; 2]; 2]| {
            [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]]
                .map(|[x, y]| [x, y, 0.0])
                .to_vec()
        };
        let (sine, cosine) = self.turned.sin_cos();
        let (low, high) = self.tilted.sin_cos();
        let tilt = |[x, y, _]: [f64; 3]| [high * x, y, -low * x];
        let basis = [tilt([cosine, sine, 0.0]), tilt([-sine, cosine, 0.0]), [low, 0.0, high]];
        let bases = if self.turned == 0.0 && self.tilted == 0.0 {
            vec![]
        } else {
            vec![basis; places.len()]
        };
        let pairs = Pairs {
            areas: rectangles.iter().map(|[x, y]| images * (x[1] - x[0]) * (y[1] - y[0])).collect(),
            gap: gap.collect(),
            bases,
            outlines: rectangles.iter().map(outline).collect(),
            elements: Some([0, 1].map(|axis| self.edges(axis).len())),
            mirrored: self.mirrored,
            closed: false,
            places: places.iter().map(|&place| tilt(place)).collect(),
        };
        ContactFrame::described(pairs).expect("a sound description")
    }

    /// The half-spaces of two bodies under it.
    pub fn compliance(&self, problem: &ContactProblem) -> Dense {
        let materials = problem.bodies.each_ref().map(|body| body.material.as_ref());
        Dense::new(self, materials)
    }

    /// Puts a simulation on these pairs.
    pub fn take_over(&self, simulation: &mut Simulation) {
        let problem = &mut simulation.problem;
        (problem.frame, problem.compliance) =
            (self.frame(problem), Arc::new(self.compliance(problem)));
    }
}

/// A compliance in nine matrices, rows after one another.
#[derive(Debug)]
pub struct Dense {
    pairs: usize,
    areas: Vec<f64>,
    blocks: [[Vec<f64>; 3]; 3],
    own: f64,
    couples: bool,
}

/// Displacement of a pair at some distance from the centre of a rectangle under unit tractions on it: rows
/// x, y, n, columns of tractions (see `compliance::half_space`).
fn influence([s1, s2, s3]: [f64; 3], [x, y]: [f64; 2], half: [f64; 2]) -> [[f64; 3]; 3] {
    let mut sums = [0.0; 5];
    for (side_x, side_y) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
        let (x, y) = (x + side_x * half[0], y + side_y * half[1]);
        let r = x.hypot(y);
        let limit = |value: f64| if value.is_finite() { value } else { 0.0 };
        let corner = [
            limit(y * (x / y.abs()).asinh()),
            limit(x * (y / x.abs()).asinh()),
            -r,
            limit(y * r.ln()) + limit(x * (y / x).atan()),
            limit(x * r.ln()) + limit(y * (x / y).atan()),
        ];
        (0..5).for_each(|part| sums[part] += side_x * side_y * corner[part]);
    }
    let [fxx, fyy, fxy, fxn, fyn] = sums;
    let nn = s1 * (fxx + fyy);
    let (xn, yn) = (s3 * fxn, s3 * fyn);
    [[nn + s2 * fxx, s2 * fxy, xn], [s2 * fxy, nn + s2 * fyy, yn], [-xn, -yn, nn]]
}

impl Dense {
    fn new(grid: &Uneven, materials: [Option<&Material>; 2]) -> Self {
        use std::f64::consts::PI;
        let sum = |part: fn(&Material) -> f64| -> [f64; 2] {
            materials.map(|material| material.map_or(0.0, part))
        };
        let first = sum(|m| (1.0 - m.poisson * m.poisson) / (PI * m.young));
        let second = sum(|m| m.poisson * (1.0 + m.poisson) / (PI * m.young));
        let third = sum(|m| (1.0 + m.poisson) * (1.0 - 2.0 * m.poisson) / (2.0 * PI * m.young));
        let constants = [first[0] + first[1], second[0] + second[1], third[0] - third[1]];
        let rectangles = grid.rectangles();
        let pairs = rectangles.len();
        let middle = |edges: [f64; 2]| 0.5 * (edges[0] + edges[1]);
        let half = |edges: [f64; 2]| 0.5 * (edges[1] - edges[0]);
        let mut blocks: [[Vec<f64>; 3]; 3] = Default::default();
        blocks.iter_mut().flatten().for_each(|block| block.resize(pairs * pairs, 0.0));
        let sides = grid.mirrored.map(|mirrored| if mirrored { &[1.0, -1.0][..] } else { &[1.0] });
        // Tractions and displacements along turned axes.
        let (sine, cosine) = grid.turned.sin_cos();
        let turn = [[cosine, sine, 0.0], [-sine, cosine, 0.0], [0.0, 0.0, 1.0]];
        for (i, one) in rectangles.iter().enumerate() {
            for (j, other) in rectangles.iter().enumerate() {
                let mut element = [[0.0; 3]; 3];
                for &x in sides[0] {
                    for &y in sides[1] {
                        let offset = [
                            middle(one[0]) - x * middle(other[0]),
                            middle(one[1]) - y * middle(other[1]),
                        ];
                        let image = influence(constants, offset, other.map(half));
                        let signs = [x, y, 1.0];
                        for row in 0..3 {
                            (0..3).for_each(|column| {
                                element[row][column] += signs[column] * image[row][column]
                            });
                        }
                    }
                }
                for row in 0..3 {
                    for column in 0..3 {
                        blocks[row][column][i * pairs + j] = (0..9)
                            .map(|k| turn[row][k / 3] * element[k / 3][k % 3] * turn[column][k % 3])
                            .sum();
                    }
                }
            }
        }
        let areas = rectangles.iter().map(|[x, y]| (x[1] - x[0]) * (y[1] - y[0])).collect();
        let own = |one: &[[f64; 2]; 2]| influence(constants, [0.0; 2], one.map(half))[2][2];
        let own = rectangles.iter().map(own).fold(0.0, f64::max);
        let mut dense = Self { pairs, areas, blocks, own, couples: constants[2] != 0.0 };
        if grid.symmetric {
            dense.symmetrise();
        }
        dense
    }

    /// Takes the mean with the transpose, weighted by areas.
    fn symmetrise(&mut self) {
        let Self { pairs, areas, blocks, .. } = self;
        let old = blocks.clone();
        for (row, blocks) in blocks.iter_mut().enumerate() {
            for (column, block) in blocks.iter_mut().enumerate() {
                for i in 0..*pairs {
                    for j in 0..*pairs {
                        let other = old[column][row][j * *pairs + i] * areas[j] / areas[i];
                        let value = &mut block[i * *pairs + j];
                        *value = 0.5 * (*value + other);
                    }
                }
            }
        }
    }

    fn add(&self, row: usize, column: usize, tractions: &[f64], displacement: &mut [f64]) {
        let block = &self.blocks[row][column];
        for (value, row) in displacement.iter_mut().zip(block.chunks(self.pairs)) {
            *value += row.iter().zip(tractions).map(|(a, b)| a * b).sum::<f64>();
        }
    }
}

impl Compliance for Dense {
    fn apply(&self, tractions: &VectorField) -> VectorField {
        let mut result = VectorField::zeros(self.pairs);
        let VectorField { t1, t2, n } = &mut result;
        for (row, part) in [t1, t2, n].into_iter().enumerate() {
            for (column, tractions) in tractions.components().into_iter().enumerate() {
                if tractions.iter().any(|value| *value != 0.0) {
                    self.add(row, column, tractions, part);
                }
            }
        }
        result
    }

    fn apply_normal(&self, pressure: &[f64], displacement: &mut [f64]) {
        displacement.fill(0.0);
        self.add(2, 2, pressure, displacement);
    }

    fn normal_self_term(&self) -> f64 {
        self.own
    }

    fn couples(&self) -> bool {
        self.couples
    }

    /// The inverse of the symmetric part.
    fn normal_preconditioner(&self, addition: f64) -> Box<dyn Preconditioner + '_> {
        let roots: Vec<f64> = self.areas.iter().map(|area| area.sqrt()).collect();
        let nn = &self.blocks[2][2];
        let element = |i: usize, j: usize| {
            let [one, other] = [nn[i * self.pairs + j], nn[j * self.pairs + i]];
            let own = if i == j { addition } else { 0.0 };
            0.5 * (one * roots[i] / roots[j] + other * roots[j] / roots[i]) + own
        };
        let factors = Cholesky::new(self.pairs, element).expect("positive definite");
        Box::new(Inverse { factors, roots })
    }
}

#[derive(Debug)]
struct Inverse {
    factors: Cholesky,
    roots: Vec<f64>,
}

impl Preconditioner for Inverse {
    fn apply(&self, displacement: &[f64], pressure: &mut [f64]) {
        let scaled: Vec<f64> =
            displacement.iter().zip(&self.roots).map(|(d, root)| d * root).collect();
        for ((p, q), root) in pressure.iter_mut().zip(self.factors.solve(&scaled)).zip(&self.roots)
        {
            *p = q / root;
        }
    }
}
