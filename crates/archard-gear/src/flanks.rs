//! Flanks that wear over many meshes.

use crate::march::{Depths, Limit, Marched, Moment, Wearing, deepest, march};
use crate::mesh::{Mesh, Node};
use crate::station::Station;

/// Flanks that are worn.
#[derive(Debug, Clone, PartialEq)]
pub struct WornFlanks {
    /// The stations with what they bear at the end.
    pub stations: Vec<Station>,
    /// From the new flanks to the worn ones.
    pub course: Vec<Moment>,
    /// Error (m) of the depths at the end.
    pub errors: [Vec<f64>; 2],
    /// Worn volume (m^3) of a flank of each gear, and its error.
    pub volumes: [[f64; 2]; 2],
    /// The limit that is reached first, and the error of the number of meshes; `None` where none is.
    pub life: Option<(Limit, f64)>,
}

impl WornFlanks {
    /// The end of the course.
    pub fn last(&self) -> &Moment {
        &self.course[self.course.len() - 1]
    }

    /// The station where a flank is deepest, the depth (m) there and its error.
    pub fn deepest(&self, gear: usize) -> (usize, [f64; 2]) {
        deepest(&self.last().depths[gear], &self.errors[gear])
    }
}

impl Mesh {
    /// How far (m) wear displaces the contact on the flanks at most: where they slope against the involutes, the contact lies as far from
    /// the computed place as both flanks together need to turn, the slope times their radius of curvature against each other.
    pub fn displaced(&self, worn: &WornFlanks) -> f64 {
        let nodes = self.nodes();
        let displaced = |flank: usize, node: usize| {
            let [here, next] = [node, node + 1].map(|node| nodes[node].place);
            let [one, two] = self.pair.radii(0.5 * (here + next));
            let along = [one, two][flank] / self.pair.gears[flank].base_radius() * (next - here);
            let depths = &worn.last().depths[flank];
            (depths[node + 1] - depths[node]).abs() / along * one * two / self.pair.length
        };
        let inner = Self::parts(&nodes).flat_map(|part| part.start..part.end - 1);
        inner.flat_map(|node| [displaced(0, node), displaced(1, node)]).fold(0.0, f64::max)
    }
}

/// Flanks on their way.
struct Flanks<'a> {
    mesh: &'a Mesh,
    nodes: &'a [Node],
    /// Meshes of a flank of each gear for one of gear 1.
    meshes: [f64; 2],
}

impl Wearing for Flanks<'_> {
    fn nodes(&self) -> [usize; 2] {
        [self.nodes.len(); 2]
    }

    fn rates(&self, depths: &Depths) -> Depths {
        let both: Vec<f64> = depths[0].iter().zip(&depths[1]).map(|(one, two)| one + two).collect();
        let stations = self.mesh.at_nodes(self.nodes, &self.mesh.loads(self.nodes, &both));
        let friction = self.mesh.friction.as_deref();
        [0, 1].map(|flank| {
            let Some(law) = &self.mesh.laws[flank] else { return vec![0.0; stations.len()] };
            let of = |(station, before): (&Station, &f64)| {
                self.meshes[flank] * station.wear(flank, (&**law, friction), *before)
            };
            stations.iter().zip(&depths[flank]).map(of).collect()
        })
    }
}

impl Mesh {
    /// Wears the flanks over so many meshes of a flank of gear 1, and as many times that of gear 2 as said, or until a limit is reached.
    pub fn wear(&self, meshes: f64, of_gear_two: f64, limits: &[Limit]) -> WornFlanks {
        let nodes = self.nodes();
        let flanks = Flanks { mesh: self, nodes: &nodes, meshes: [1.0, of_gear_two] };
        let Marched { course, errors, life } = march(&flanks, meshes, limits);
        let last = &course[course.len() - 1];
        let both: Vec<f64> =
            last.depths[0].iter().zip(&last.depths[1]).map(|(one, two)| one + two).collect();
        let stations = self.at_nodes(&nodes, &self.loads(&nodes, &both));
        let volumes = [0, 1].map(|flank| {
            let [fine, coarse] =
                [1, 2].map(|every| self.volume(&nodes, (flank, &last.depths[flank]), every));
            let missed = self.volume(&nodes, (flank, &errors[flank]), 1);
            [fine, (fine - coarse).abs() + missed]
        });
        WornFlanks { stations, course, errors, volumes, life }
    }

    /// Volume (m^3) off a flank by Simpson's rule over every so many nodes.
    fn volume(&self, nodes: &[Node], (flank, depths): (usize, &[f64]), every: usize) -> f64 {
        let base = self.pair.gears[flank].base_radius();
        // The length of a flank for that of the path: how far it is from where the involute begins, over the base radius.
        let along = |node: usize| depths[node] * self.pair.radii(nodes[node].place)[flank] / base;
        let part = |part: std::ops::Range<usize>| {
            let (first, last) = (part.start, part.end - 1);
            let step =
                (nodes[last].place - nodes[first].place) * every as f64 / (part.len() - 1) as f64;
            let inner = (first + every..last).step_by(every).enumerate();
            let inner = inner.map(|(index, node)| [4.0, 2.0][index % 2] * along(node));
            (along(first) + along(last) + inner.sum::<f64>()) * step / 3.0
        };
        self.width * Self::parts(nodes).map(part).sum::<f64>()
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use approx::assert_relative_eq;
    use archard::body::Material;
    use archard::friction::Tresca;
    use archard::wear::{Archard, Energy, Power, WearLaw};

    use super::{Limit, Mesh};
    use crate::involute::tests::pair;
    use crate::sharing::Sharing;

    /// Test gears of type C under 302 N m, k = 1e-7 mm^3/(N m).
    fn mesh(sharing: Sharing, wears: [bool; 2]) -> Mesh {
        let law: Arc<dyn WearLaw> = Arc::new(Archard::new(1e-16).unwrap());
        let laws = wears.map(|wears| wears.then(|| law.clone()));
        let steel = Material::new(206e9, 0.3).unwrap();
        Mesh::new(pair(), [302.0, 14e-3], [&steel; 2], sharing, (None, laws)).unwrap()
    }

    /// Places of the path (mm) with the side from which they are come to, and loads over the whole.
    const PLACES: [(f64, bool); 9] = [
        (4.472298, false),
        (7.378548, true),
        (10.284798, true),
        (10.284798, false),
        (13.970082, true),
        (17.756889, true),
        (17.756889, false),
        (20.663139, true),
        (23.569389, true),
    ];

    /// The node at a place.
    fn at(mesh: &Mesh, (place, from_below): (f64, bool)) -> usize {
        let nodes = mesh.nodes();
        let near = |node: &crate::mesh::Node| {
            (node.place - 1e-3 * place).abs() < 2e-9 && (from_below == node.from_below)
        };
        let found = nodes.iter().position(near);
        found
            .or_else(|| nodes.iter().position(|node| (node.place - 1e-3 * place).abs() < 2e-9))
            .unwrap()
    }

    /// Flodin & Andersson's closed form: share, a (mm), p0 (MPa), depth a mesh of pinion and wheel (nm), by a program of its own.
    #[test]
    fn a_mesh_wears_what_the_closed_form_says() {
        let known = [
            [1.0 / 3.0, 0.0965611, 1401.35, 0.0752332, 0.0165731],
            [0.5, 0.144473, 1404.92, 0.0474706, 0.0190730],
            [2.0 / 3.0, 0.186277, 1452.85, 0.0253877, 0.0158951],
            [1.0, 0.228142, 1779.37, 0.0380816, 0.0238426],
            [1.0, 0.245204, 1655.55, 0.0, 0.0],
            [1.0, 0.250225, 1622.33, 0.0226645, 0.0351622],
            [2.0 / 3.0, 0.204308, 1324.63, 0.0151096, 0.0234415],
            [0.5, 0.173963, 1166.76, 0.0172122, 0.0374061],
            [1.0 / 3.0, 0.135365, 999.640, 0.0144281, 0.0449191],
        ];
        let mesh = mesh(Sharing::Thirds, [true; 2]);
        assert_relative_eq!(mesh.load, 637.66208e3, max_relative = 1e-7);
        let (worn, stations) = (mesh.wear(1.0, 1.0, &[]), mesh.stations());
        for (place, [share, a, p0, one, two]) in PLACES.into_iter().zip(known) {
            let node = at(&mesh, place);
            let station = stations[node];
            assert_relative_eq!(station.load / mesh.load, share, max_relative = 1e-6);
            assert_relative_eq!(1e3 * station.half_width, a, max_relative = 1e-5);
            assert_relative_eq!(1e-6 * station.peak_pressure, p0, max_relative = 1e-5);
            for (flank, known) in [one, two].into_iter().enumerate() {
                let depth = 1e9 * worn.last().depths[flank][node];
                assert!((depth - known).abs() < 1e-5 * known + 1e-7, "{place:?}: {depth} {known}");
            }
        }
        // Both flanks lose k times the load times the way, which the trapezoidal rule has to 2e-6 across the jumps of the load.
        let volumes = worn.volumes.map(|[volume, error]| {
            assert_relative_eq!(1e9 * volume, 2.229553e-6, max_relative = 3e-6);
            assert!(error < 1e-6 * volume);
            volume
        });
        assert_relative_eq!(volumes[0], volumes[1], max_relative = 1e-9);
    }

    /// Two pairs of teeth as springs of 14 N/(mm um), by a program of its own (Heun's method, 400 steps on 800 points).
    #[test]
    fn wear_shifts_the_load_from_pair_to_pair() {
        let known = [
            [58.788, 12.950],
            [44.432, 17.852],
            [25.008, 15.657],
            [38.082, 23.843],
            [0.0, 0.0],
            [22.664, 35.162],
            [16.761, 26.004],
            [18.314, 39.801],
            [14.860, 46.263],
        ];
        let mesh = mesh(Sharing::Springs(14e9), [true; 2]);
        let worn = mesh.wear(1e6, 1.0, &[]);
        for (place, known) in PLACES.into_iter().zip(known) {
            let node = at(&mesh, place);
            for (flank, known) in known.into_iter().enumerate() {
                let depth = 1e6 * worn.last().depths[flank][node];
                assert!((depth - known).abs() < 2e-5 * known + 1e-3, "{place:?}: {depth} {known}");
                assert!(worn.errors[flank][node] < 1e-4 * depth + 1e-12);
            }
        }
        let share = |place| worn.stations[at(&mesh, place)].load / mesh.load;
        for (place, known) in
            [PLACES[0], PLACES[1], PLACES[2]].into_iter().zip([0.18194, 0.45423, 0.72458])
        {
            assert_relative_eq!(share(place), known, max_relative = 1e-4);
        }
    }

    #[test]
    fn a_life_ends_where_the_depth_is_reached() {
        let mesh = mesh(Sharing::Springs(14e9), [true; 2]);
        for (gear, depth, known) in [(0, 50e-6, 790_858.0), (1, 40e-6, 833_911.0)] {
            let worn = mesh.wear(1e6, 1.0, &[Limit { body: gear, depth }]);
            let (met, error) = worn.life.unwrap();
            assert_eq!(met.body, gear);
            let life = worn.last().passages;
            assert!((life - known).abs() < 3.0 + error, "{life} +- {error}");
            assert_relative_eq!(worn.deepest(gear).1[0], depth, max_relative = 1e-12);
        }
        let both = [Limit { body: 1, depth: 40e-6 }, Limit { body: 0, depth: 50e-6 }];
        assert_eq!(mesh.wear(1e6, 1.0, &both).life.unwrap().0.body, 0);
        assert_eq!(mesh.wear(1e5, 1.0, &both).life, None);
        // Twice the coefficient of wear, half the life.
        let mut faster = mesh.clone();
        let law: Arc<dyn WearLaw> = Arc::new(Archard::new(2e-16).unwrap());
        faster.laws = [Some(law.clone()), Some(law)];
        let lives = [&mesh, &faster].map(|mesh| mesh.wear(1e6, 1.0, &both).last().passages);
        assert_relative_eq!(lives[0], 2.0 * lives[1], max_relative = 1e-6);
    }

    /// A power of the pressure, h = K p^2 s, wears by the integral of Hertz's pressure squared: K p0^2 4/3 a |v1 - v2|/v.
    #[test]
    fn other_laws_see_the_pressure_across_the_contact() {
        let mut mesh = mesh(Sharing::Thirds, [true, false]);
        let coefficient = 1e-25;
        mesh.laws[0] = Some(Arc::new(Power::new(coefficient, 2.0, 1.0).unwrap()));
        let worn = mesh.wear(1.0, 1.0, &[]);
        for (station, depth) in mesh.stations().iter().zip(&worn.last().depths[0]) {
            let width = 4.0 / 3.0 * station.half_width * station.sliding().abs();
            let known = coefficient * station.peak_pressure.powi(2) * width / station.speeds[0];
            assert!((depth - known).abs() <= 1e-5 * known, "{depth} {known}");
        }
        assert!(worn.last().depths[1].iter().all(|depth| *depth == 0.0));
    }

    /// Under Tresca's friction, whatever the pressure, a law by the work of friction takes alpha tau 2 a |v1 - v2|/v.
    #[test]
    fn work_of_friction_follows_its_law() {
        let (alpha, tau) = (1e-16, 50e6);
        let mut mesh = mesh(Sharing::Thirds, [true, false]);
        mesh.laws[0] = Some(Arc::new(Energy::new(alpha, 0.0).unwrap()));
        mesh.friction = Some(Arc::new(Tresca::new(1.0, tau).unwrap()));
        let worn = mesh.wear(1.0, 1.0, &[]);
        for (station, depth) in mesh.stations().iter().zip(&worn.last().depths[0]) {
            let known = alpha * tau * station.slide(0);
            // At the ends of the contact pressures fall below tau.
            assert!((depth - known).abs() <= 2e-3 * known, "{depth} {known}");
        }
    }

    /// Shares of pairs that touch at once bear the load, but for those of a table that do not add up.
    #[test]
    fn shares_that_do_not_add_up_are_seen() {
        for sharing in [Sharing::Thirds, Sharing::Springs(14e9)] {
            assert!(mesh(sharing, [true; 2]).unshared() < 1e-12);
        }
        let even = Sharing::table(vec![[4e-3, 0.6], [24e-3, 0.6]]).unwrap();
        assert_relative_eq!(mesh(even, [true; 2]).unshared(), 0.4, max_relative = 1e-12);
    }
}
