//! Gears under load: the places of the path, and who bears what there.

use std::sync::Arc;

use archard::body::Material;
use archard::friction::Friction;
use archard::wear::WearLaw;

use crate::involute::Pair;
use crate::laws::{Laws, Misfit, checked, contact_modulus};
use crate::sharing::Sharing;
use crate::station::Station;

/// Parts of the path between two of its points, twice over: halved, they say how far off what is summed over them is. A choice.
const PARTS: usize = 32;

/// Two gears under load.
#[derive(Debug, Clone)]
pub struct Mesh {
    /// The gears and their path of contact.
    pub pair: Pair,
    /// Contact modulus (Pa), E* of Hertz.
    pub modulus: f64,
    /// Load (N/m) over the width, along the path.
    pub load: f64,
    /// Width (m) of the teeth that touch.
    pub width: f64,
    /// How pairs of teeth share the load.
    pub sharing: Sharing,
    /// Friction, for laws that ask for it.
    pub friction: Option<Arc<dyn Friction>>,
    /// How the flanks of both gears wear; `None` if they do not.
    pub laws: [Option<Arc<dyn WearLaw>>; 2],
}

/// A node of the path.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Node {
    /// Distance (m) from T1.
    pub place: f64,
    /// Whether it is the end of the part before it rather than the start of the next.
    pub from_below: bool,
    /// Nodes of all pairs of teeth that touch at once, itself among them, those ahead last.
    pub together: Vec<usize>,
}

impl Mesh {
    /// Gears that a torque (N m) on gear 1 drives.
    ///
    /// # Errors
    /// If a wear law, or friction, asks for what is not known of a flank.
    pub fn new(
        pair: Pair,
        [torque, width]: [f64; 2],
        materials: [&Material; 2],
        sharing: Sharing,
        laws: Laws,
    ) -> Result<Self, Misfit> {
        checked(&laws)?;
        let (friction, laws) = laws;
        let modulus = contact_modulus(materials);
        let load = torque / (pair.gears[0].base_radius() * width);
        Ok(Self { pair, modulus, load, width, sharing, friction, laws })
    }

    /// The nodes of the path: parts between all places where a pair of teeth begins or ceases to touch or to slide, there or a pitch away,
    /// so that pairs that touch at once are at nodes at once. Ends of parts are nodes of their own.
    pub(crate) fn nodes(&self) -> Vec<Node> {
        let Pair { start, end, pitch, pitch_point, .. } = self.pair;
        let turns = ((end - start) / pitch).ceil() as i32;
        let near = |one: f64, other: f64| (one - other).abs() < 1e-9 * pitch;
        let mut points: Vec<f64> = vec![];
        for turn in -turns..=turns {
            for from in [start, end, pitch_point] {
                let place = from + f64::from(turn) * pitch;
                let inside = place > start && place < end || near(place, start) || near(place, end);
                if inside && !points.iter().any(|point| near(*point, place)) {
                    points.push(place);
                }
            }
        }
        points.sort_by(f64::total_cmp);
        let parts = points.len() - 1;
        let count = 2 * PARTS;
        let node = |part: usize, step: usize| {
            let [from, to] = [points[part], points[part + 1]];
            let place = from + (to - from) * step as f64 / count as f64;
            // Parts a pitch apart have their nodes a pitch apart.
            let ahead = |other: &usize| {
                let apart = (points[*other] - from) / pitch;
                (apart - apart.round()).abs() < 1e-9
                    && near(points[*other + 1] - to, points[*other] - from)
            };
            let together = (0..parts).filter(ahead).map(|other| other * (count + 1) + step);
            Node { place, from_below: step == count, together: together.collect() }
        };
        (0..parts)
            .flat_map(|part| (0..=count).map(move |step| (part, step)))
            .map(|(part, step)| node(part, step))
            .collect()
    }

    /// Nodes of a part, first to last, and parts in turn.
    pub(crate) fn parts(nodes: &[Node]) -> impl Iterator<Item = std::ops::Range<usize>> {
        let count = 2 * PARTS + 1;
        (0..nodes.len() / count).map(move |part| part * count..(part + 1) * count)
    }

    /// The load (N/m) of each node, where flanks have worn by so much (m) in sum.
    pub(crate) fn loads(&self, nodes: &[Node], worn: &[f64]) -> Vec<f64> {
        let share = |(index, node): (usize, &Node)| match &self.sharing {
            Sharing::Springs(stiffness) => {
                let together: Vec<f64> = node.together.iter().map(|node| worn[*node]).collect();
                let own = node.together.iter().position(|node| *node == index).unwrap_or_default();
                Sharing::by_springs(*stiffness, self.load, &together)[own]
            }
            Sharing::Table(rows) => self.load * Sharing::at(rows, node.place, node.from_below),
            Sharing::Thirds => self.load * self.thirds((index, node)),
        };
        nodes.iter().enumerate().map(share).collect()
    }

    /// How far what pairs of teeth that touch at once share is off the load, relative to it; a table may share out more or less.
    pub fn unshared(&self) -> f64 {
        let nodes = self.nodes();
        let loads = self.loads(&nodes, &vec![0.0; nodes.len()]);
        let borne = |node: &Node| node.together.iter().map(|node| loads[*node]).sum::<f64>();
        let off = nodes.iter().map(|node| (borne(node) / self.load - 1.0).abs());
        off.fold(0.0, f64::max)
    }

    /// The share by thirds; pairs of three and more share evenly.
    fn thirds(&self, (index, node): (usize, &Node)) -> f64 {
        let Pair { start, end, pitch, .. } = self.pair;
        let (joined, left) = (start + pitch, end - pitch);
        match node.together.len() {
            1 => 1.0,
            2 if node.together[0] == index => (1.0 + (node.place - start) / (left - start)) / 3.0,
            2 => (1.0 + (end - node.place) / (end - joined)) / 3.0,
            count => 1.0 / count as f64,
        }
    }

    /// The stations of flanks that have not worn, node by node.
    pub fn stations(&self) -> Vec<Station> {
        let nodes = self.nodes();
        self.at_nodes(&nodes, &self.loads(&nodes, &vec![0.0; nodes.len()]))
    }

    /// Stations at nodes under loads (N/m).
    pub(crate) fn at_nodes(&self, nodes: &[Node], loads: &[f64]) -> Vec<Station> {
        let both = nodes.iter().zip(loads);
        both.map(|(node, load)| Station::new(&self.pair, node.place, *load, self.modulus)).collect()
    }
}
