//! Tetrahedra from the input files of CalculiX and Abaqus (`.inp`).
//!
//! Nodes, tetrahedra of four and ten nodes and sets are read, and what names triangles of the surface: surfaces by the sides of
//! elements, shells and membranes by their sets, and sets of nodes. Everything else is passed over.

use std::collections::HashMap;

use super::error::{Fault, MeshFileError, Place};
use super::solid::{self, Solid};

/// Sides of a tetrahedron by its corners (Abaqus Analysis User's Guide, "Three-dimensional solid element library").
const SIDES: [[usize; 3]; 4] = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
/// What tetrahedra are called, behind which further letters stand for variants.
const TETRAHEDRA: [&str; 2] = ["C3D4", "C3D10"];
/// Elements of other volumes.
const VOLUME: &str = "C3D";
/// Triangles: of shells, membranes and plane bodies.
const TRIANGLES: [&str; 10] =
    ["S3", "S6", "STRI3", "STRI65", "M3D3", "M3D6", "SFM3D3", "SFM3D6", "CPS", "CPE"];

/// Whether bytes are such a file: keywords begin with a star.
pub(super) fn is_inp(bytes: &[u8]) -> bool {
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(1 << 16)]).to_ascii_uppercase();
    let keywords = ["*NODE", "*HEADING", "*ELEMENT", "*PART"];
    text.trim_start().starts_with('*') && keywords.iter().any(|word| text.contains(word))
}

/// What a file holds.
#[derive(Default)]
struct Contents {
    nodes: HashMap<u64, [f64; 3]>,
    /// Tetrahedra by their number, and in their order.
    tetrahedra: HashMap<u64, Vec<u64>>,
    order: Vec<u64>,
    /// Triangles by their number.
    triangles: HashMap<u64, [u64; 3]>,
    /// Sets of elements and of nodes by their names in capitals, in their order, with what they hold.
    elements: Sets,
    sets: Sets,
    /// The sets that elements are written in.
    written: Sets,
    /// Surfaces: the name, what is meant by number or set, and the side.
    surfaces: Vec<(String, String, Option<usize>)>,
    others: bool,
}

/// Sets in the order in which they are named.
#[derive(Default)]
struct Sets(Vec<(String, Vec<u64>)>);

impl Sets {
    fn add(&mut self, name: &str, numbers: impl IntoIterator<Item = u64>) {
        match self.0.iter_mut().find(|(known, _)| known.eq_ignore_ascii_case(name)) {
            Some((_, known)) => known.extend(numbers),
            None => self.0.push((name.to_owned(), numbers.into_iter().collect())),
        }
    }

    fn named(&self, name: &str) -> Option<&[u64]> {
        let found = self.0.iter().find(|(known, _)| known.eq_ignore_ascii_case(name));
        found.map(|(_, numbers)| &numbers[..])
    }
}

/// A keyword with its parameters, by names in capitals.
struct Keyword {
    name: String,
    parameters: Vec<(String, String)>,
}

impl Keyword {
    fn read(line: &str) -> Self {
        let mut parts = line.trim_start_matches('*').split(',').map(str::trim);
        let name = parts.next().unwrap_or_default().to_ascii_uppercase();
        let parameter = |part: &str| {
            let (name, value) = part.split_once('=').unwrap_or((part, ""));
            (name.trim().to_ascii_uppercase(), value.trim().trim_matches('"').to_owned())
        };
        Self { name, parameters: parts.map(parameter).collect() }
    }

    fn get(&self, name: &str) -> Option<&str> {
        self.parameters.iter().find(|(own, _)| own == name).map(|(_, value)| value.as_str())
    }
}

/// The surface in the bytes of a file, and what is inside.
pub(super) fn parse(bytes: &[u8]) -> Result<Solid, MeshFileError> {
    let text = String::from_utf8_lossy(bytes);
    let mut contents = Contents::default();
    let mut keyword = Keyword::read("*");
    // Data lines of an element go on where one ends with a comma, or before all of its nodes are there.
    let mut open: Vec<u64> = vec![];
    let mut last = 0;
    for (index, line) in text.lines().enumerate() {
        let line = line.trim();
        last = index + 1;
        if line.is_empty() || line.starts_with("**") {
            continue;
        }
        if line.starts_with('*') {
            keyword = Keyword::read(line);
            open.clear();
            if keyword.name == "INCLUDE" {
                let found = line.chars().take(40).collect();
                let expected = "all nodes and elements in one file";
                return Err(at(last, Fault::Unexpected { expected, found }));
            }
            continue;
        }
        contents.data(&keyword, line, &mut open).map_err(|(expected, found)| {
            let found = found.chars().take(40).collect();
            at(last, Fault::Unexpected { expected, found })
        })?;
    }
    if contents.tetrahedra.is_empty() || contents.others {
        return Err(at(last.max(1), Fault::NoTetrahedra));
    }
    let tetrahedra: Vec<Vec<u64>> =
        contents.order.iter().map(|number| contents.tetrahedra[number].clone()).collect();
    let place = |number: u64| contents.nodes.get(&number).copied();
    let inside = solid::inside(&tetrahedra, place, contents.names(&tetrahedra));
    let inside = inside.map_err(|vertex| at(last, Fault::NoVertex { vertex }))?;
    Ok(Solid { mesh: inside.1.clone(), inside: Some(inside) })
}

fn at(line: usize, fault: Fault) -> MeshFileError {
    MeshFileError { place: Place::Line(line), fault }
}

/// What was expected in a line, and what was found.
type Wrong = (&'static str, String);

fn number<T: std::str::FromStr>(word: &str, expected: &'static str) -> Result<T, Wrong> {
    word.parse().map_err(|_| (expected, word.to_owned()))
}

impl Contents {
    /// Takes a line of data of a keyword.
    fn data(&mut self, keyword: &Keyword, line: &str, open: &mut Vec<u64>) -> Result<(), Wrong> {
        let words = || line.split(',').map(str::trim).filter(|word| !word.is_empty());
        match &*keyword.name {
            "NODE" => {
                let mut words = words();
                let own = number(words.next().unwrap_or_default(), "the number of a node")?;
                let mut place: [f64; 3] = [0.0; 3];
                for value in &mut place {
                    let word = words.next().unwrap_or("0");
                    let read: f64 =
                        number(&word.to_ascii_lowercase().replace('d', "e"), "a coordinate")?;
                    if !read.is_finite() {
                        return Err(("a coordinate", word.to_owned()));
                    }
                    *value = read;
                }
                if self.nodes.insert(own, place).is_some() {
                    return Err(("a node once", format!("node {own} again")));
                }
                if let Some(set) = keyword.get("NSET") {
                    self.sets.add(set, [own]);
                }
            }
            "ELEMENT" => self.element(keyword, words(), open)?,
            "ELSET" | "NSET" => self.set(keyword, words().collect())?,
            "SURFACE" => {
                let mut words = words();
                let what = words.next().unwrap_or_default().to_owned();
                let side =
                    words.next().and_then(|side| side.trim_start_matches(['S', 's']).parse().ok());
                if let Some(name) = keyword.get("NAME") {
                    self.surfaces.push((name.to_owned(), what, side));
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn element<'a>(
        &mut self,
        keyword: &Keyword,
        words: impl Iterator<Item = &'a str>,
        open: &mut Vec<u64>,
    ) -> Result<(), Wrong> {
        let kind = keyword.get("TYPE").unwrap_or_default().to_ascii_uppercase();
        let is = |one: &str| {
            kind.strip_prefix(one)
                .is_some_and(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()))
        };
        let count = if is(TETRAHEDRA[1]) {
            10
        } else if is(TETRAHEDRA[0]) {
            4
        } else if kind.starts_with(VOLUME) {
            self.others = true;
            return Ok(());
        } else if TRIANGLES.iter().any(|one| kind.starts_with(one)) {
            if kind.ends_with('6') || kind.starts_with("STRI65") { 6 } else { 3 }
        } else {
            return Ok(());
        };
        for word in words {
            open.push(number(word, "the number of a node")?);
        }
        if open.len() <= count {
            return Ok(());
        }
        let nodes = std::mem::take(open);
        let (own, nodes) = (nodes[0], &nodes[1..]);
        if nodes.len() != count {
            return Err((
                "as many nodes as the element has",
                format!("{} of element {own}", nodes.len()),
            ));
        }
        if count == 4 || count == 10 {
            self.order.push(own);
            if self.tetrahedra.insert(own, nodes.to_vec()).is_some() {
                return Err(("an element once", format!("element {own} again")));
            }
        } else {
            self.triangles.insert(own, [nodes[0], nodes[1], nodes[2]]);
        }
        if let Some(set) = keyword.get("ELSET") {
            self.written.add(set, [own]);
        }
        Ok(())
    }

    /// The elements of a set.
    fn elements(&self, name: &str) -> Option<&[u64]> {
        self.elements.named(name).or_else(|| self.written.named(name))
    }

    fn set(&mut self, keyword: &Keyword, words: Vec<&str>) -> Result<(), Wrong> {
        let nodes = keyword.name == "NSET";
        let Some(name) = keyword.get(&keyword.name) else { return Ok(()) };
        let expected = "a number or the name of a set";
        let mut numbers = vec![];
        if keyword.get("GENERATE").is_some() {
            let range: Vec<u64> =
                words.iter().map(|word| number(word, expected)).collect::<Result<_, _>>()?;
            if let [first, last, rest @ ..] = &range[..] {
                let step = rest.first().copied().unwrap_or(1).max(1);
                numbers.extend((*first..=*last).step_by(step as usize));
            }
        } else {
            for word in words {
                let known = if nodes { self.sets.named(word) } else { self.elements(word) };
                match (word.parse(), known) {
                    (Ok(one), _) => numbers.push(one),
                    (_, Some(known)) => numbers.extend(known),
                    _ => return Err((expected, word.to_owned())),
                }
            }
        }
        let sets = if nodes { &mut self.sets } else { &mut self.elements };
        sets.add(name, numbers);
        Ok(())
    }

    /// Names of triangles by the numbers of their corners: those of surfaces first, then of sets of triangles, those that triangles are written
    /// in behind others, then of sets of nodes.
    fn names(&self, tetrahedra: &[Vec<u64>]) -> Vec<([u64; 3], String)> {
        let mut named = vec![];
        for (name, what, side) in &self.surfaces {
            let own = [what.parse().unwrap_or(0)];
            let elements = self.elements(what).unwrap_or(&own);
            match side.and_then(|side| SIDES.get(usize::wrapping_sub(side, 1))) {
                Some(side) => {
                    let meant = elements.iter().filter_map(|number| self.tetrahedra.get(number));
                    named.extend(
                        meant.map(|nodes| (side.map(|corner| nodes[corner]), name.clone())),
                    );
                }
                None => self.of_nodes(
                    self.sets.named(what).unwrap_or(&[]),
                    tetrahedra,
                    name,
                    &mut named,
                ),
            }
        }
        for (name, numbers) in self.elements.0.iter().chain(&self.written.0) {
            let own = numbers.iter().filter_map(|number| self.triangles.get(number));
            named.extend(own.map(|corners| (*corners, name.clone())));
        }
        // A set within another one says more.
        let mut sets: Vec<_> = self.sets.0.iter().collect();
        sets.sort_by_key(|(_, numbers)| numbers.len());
        for (name, numbers) in sets.into_iter().filter(|(_, set)| set.len() < self.nodes.len()) {
            self.of_nodes(numbers, tetrahedra, name, &mut named);
        }
        named
    }

    /// The sides of tetrahedra whose corners all lie in a set of nodes.
    fn of_nodes(
        &self,
        numbers: &[u64],
        tetrahedra: &[Vec<u64>],
        name: &str,
        named: &mut Vec<([u64; 3], String)>,
    ) {
        let within: std::collections::HashSet<u64> = numbers.iter().copied().collect();
        for nodes in tetrahedra {
            let sides = SIDES.iter().map(|side| side.map(|corner| nodes[corner]));
            let all = sides.filter(|side| side.iter().all(|node| within.contains(node)));
            named.extend(all.map(|side| (side, name.to_owned())));
        }
    }
}
