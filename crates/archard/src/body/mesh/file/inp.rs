//! Tetrahedra from the input files of CalculiX and Abaqus (`.inp`).
//!
//! Nodes, tetrahedra of four and ten nodes and sets are read, and what names triangles of the surface: surfaces by the sides of
//! elements, shells and membranes by their sets, and sets of nodes. Everything else is passed over.

use std::collections::{HashMap, HashSet};

use super::error::{Fault, MeshFileError, Place};
use super::solid::{self, Solid};

/// Sides of a tetrahedron by its corners (Abaqus Analysis User's Guide, "Three-dimensional solid element library").
const SIDES: [[usize; 3]; 4] = [[0, 1, 2], [0, 3, 1], [1, 3, 2], [2, 3, 0]];
/// What tetrahedra are called, behind which further letters stand for variants.
const TETRAHEDRA: [&str; 2] = ["C3D4", "C3D10"];
/// Elements of other volumes.
const VOLUME: &str = "C3D";
/// Elements of shells, membranes and plane bodies, behind which stand their nodes: those with three or six are triangles.
const SURFACES: [&str; 6] = ["S", "STRI", "M3D", "SFM3D", "CPS", "CPE"];
/// Keywords that make or move nodes and elements: they are refused.
const MADE: [&str; 9] =
    ["INCLUDE", "SYSTEM", "NGEN", "NFILL", "NCOPY", "NMAP", "ELGEN", "ELCOPY", "IMPORT"];

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
    /// Triangles with their number, in their order.
    triangles: Vec<(u64, [u64; 3])>,
    /// Sets of elements and of nodes.
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
struct Sets(Vec<(String, Set)>);

/// Numbers, one by one and from a first to a last by steps, which may be more than any file holds.
#[derive(Default, Clone)]
struct Set {
    numbers: HashSet<u64>,
    ranges: Vec<[u64; 3]>,
}

impl Set {
    fn of(number: u64) -> Self {
        Self { numbers: [number].into(), ranges: vec![] }
    }

    fn holds(&self, number: u64) -> bool {
        let within = |&[first, last, step]: &[u64; 3]| {
            (first..=last).contains(&number) && (number - first).is_multiple_of(step)
        };
        self.numbers.contains(&number) || self.ranges.iter().any(within)
    }

    fn extend(&mut self, other: &Self) {
        self.numbers.extend(&other.numbers);
        self.ranges.extend(&other.ranges);
    }
}

impl Sets {
    fn add(&mut self, name: &str, set: &Set) {
        match self.0.iter_mut().find(|(known, _)| known.eq_ignore_ascii_case(name)) {
            Some((_, known)) => known.extend(set),
            None => self.0.push((name.to_owned(), set.clone())),
        }
    }

    fn named(&self, name: &str) -> Option<&Set> {
        self.0.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, set)| set)
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

    /// Whether nodes and elements are what and where the file says.
    fn plain(&self, line: &str) -> Result<(), Wrong> {
        let turned = self.get("SYSTEM").is_some_and(|system| !system.eq_ignore_ascii_case("R"));
        match MADE.contains(&&*self.name) || self.name == "NODE" && turned {
            true => Err(("all nodes and elements, each in its place", line.to_owned())),
            false => Ok(()),
        }
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
    let (mut last, mut goes_on) = (0, false);
    for (index, line) in text.lines().enumerate() {
        let line = line.trim();
        last = index + 1;
        if line.is_empty() || line.starts_with("**") {
            continue;
        }
        let wrong = |(expected, found): Wrong| {
            let found = found.chars().take(40).collect();
            at(last, Fault::Unexpected { expected, found })
        };
        if line.starts_with('*') || goes_on {
            match goes_on {
                true => keyword.parameters.extend(Keyword::read(&format!(",{line}")).parameters),
                false => keyword = Keyword::read(line),
            }
            goes_on = line.ends_with(',');
            open.clear();
            keyword.plain(line).map_err(wrong)?;
        } else {
            contents.data(&keyword, line, &mut open).map_err(wrong)?;
        }
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
                    return Err(("one body, each node once", format!("node {own} again")));
                }
                if let Some(set) = keyword.get("NSET") {
                    self.sets.add(set, &Set::of(own));
                }
            }
            "ELEMENT" => self.element(keyword, words(), open)?,
            "ELSET" | "NSET" => self.set(keyword, words().collect())?,
            "INSTANCE" => return Err(("a part that is not moved", line.to_owned())),
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
        } else if let Some(count @ (3 | 6)) = SURFACES.iter().find_map(|one| {
            let digit = kind.strip_prefix(one)?.chars().next()?.to_digit(10)?;
            Some(digit as usize)
        }) {
            count
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
            self.triangles.push((own, [nodes[0], nodes[1], nodes[2]]));
        }
        if let Some(set) = keyword.get("ELSET") {
            self.written.add(set, &Set::of(own));
        }
        Ok(())
    }

    /// The elements of a set.
    fn elements(&self, name: &str) -> Option<&Set> {
        self.elements.named(name).or_else(|| self.written.named(name))
    }

    fn set(&mut self, keyword: &Keyword, words: Vec<&str>) -> Result<(), Wrong> {
        let nodes = keyword.name == "NSET";
        let Some(name) = keyword.get(&keyword.name) else { return Ok(()) };
        let expected = "a number or the name of a set";
        let mut set = Set::default();
        if keyword.get("GENERATE").is_some() {
            let range: Vec<u64> =
                words.iter().map(|word| number(word, expected)).collect::<Result<_, _>>()?;
            if let [first, last, rest @ ..] = &range[..] {
                set.ranges.push([*first, *last, rest.first().copied().unwrap_or(1).max(1)]);
            }
        } else {
            for word in words {
                let known = if nodes { self.sets.named(word) } else { self.elements(word) };
                match (word.parse(), known) {
                    (Ok(one), _) => set.extend(&Set::of(one)),
                    (_, Some(known)) => set.extend(known),
                    _ => return Err((expected, word.to_owned())),
                }
            }
        }
        let sets = if nodes { &mut self.sets } else { &mut self.elements };
        sets.add(name, &set);
        Ok(())
    }

    /// Names of triangles by the numbers of their corners: those of surfaces first, then of sets of triangles, those that triangles are written
    /// in behind others, then of sets of nodes.
    fn names(&self, tetrahedra: &[Vec<u64>]) -> Vec<([u64; 3], String)> {
        let mut named = vec![];
        for (name, what, side) in &self.surfaces {
            match side.and_then(|side| SIDES.get(usize::wrapping_sub(side, 1))) {
                Some(side) => {
                    let own = what.parse().map(Set::of).unwrap_or_default();
                    let meant = self.elements(what).unwrap_or(&own);
                    let meant = self.order.iter().filter(|number| meant.holds(**number));
                    named.extend(meant.map(|number| {
                        (side.map(|corner| self.tetrahedra[number][corner]), name.clone())
                    }));
                }
                None => {
                    let none = Set::default();
                    let set = self.sets.named(what).unwrap_or(&none);
                    named.extend(within(set, tetrahedra, name));
                }
            }
        }
        for (name, set) in self.elements.0.iter().chain(&self.written.0) {
            let own = self.triangles.iter().filter(|(number, _)| set.holds(*number));
            named.extend(own.map(|(_, corners)| (*corners, name.clone())));
        }
        // A set within another one says more, and one of all nodes nothing.
        let count = |set: &Set| self.nodes.keys().filter(|node| set.holds(**node)).count();
        let mut sets: Vec<_> =
            self.sets.0.iter().map(|(name, set)| (count(set), name, set)).collect();
        sets.sort_by_key(|(count, ..)| *count);
        for (_, name, set) in sets.iter().filter(|(count, ..)| *count < self.nodes.len()) {
            named.extend(within(set, tetrahedra, name));
        }
        named
    }
}

/// The sides of tetrahedra whose corners all lie in a set of nodes, by its name.
fn within(
    set: &Set,
    tetrahedra: &[Vec<u64>],
    name: &str,
) -> impl Iterator<Item = ([u64; 3], String)> {
    let sides = tetrahedra
        .iter()
        .flat_map(|nodes| SIDES.iter().map(|side| side.map(|corner| nodes[corner])));
    let all = sides.filter(|side| side.iter().all(|node| set.holds(*node)));
    all.map(|side| (side, name.to_owned()))
}
