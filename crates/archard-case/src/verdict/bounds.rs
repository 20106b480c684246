//! The lines there are, each with its bounds and what these were measured on.

use serde::{Deserialize, Serialize};

use super::words::share;
use super::{Bound, Line, Word, four};

/// The load, or approach, against the one prescribed: how far off it is, relative to it.
///
/// Solvers end at residuals of 1e-8 (pressures) and 1e-6 (friction with pressures); a lost contact is off by 1.
pub fn load(off: f64) -> Line {
    let text = "off what was prescribed; a tighter `solver.tolerance` brings it nearer";
    Line::new("load", off, Bound::AtMost([1e-5, 1e-3]), text)
}

/// The subject of what lies at the edge of the frame.
pub const EDGES: &str = "edges";

/// The share of the load on the edge of the frame, and how many pairs bear it.
///
/// A contact that goes on beyond its frame is cut off there, and nothing says how much of it is missing; so any
/// pressure at the edge is doubtful. The case `hertz` on a frame of 0.3 mm, whose outermost ring of 30 elements a side the
/// contact just reaches, has 1 % of its load there.
pub fn edges(share: f64, pairs: usize) -> Line {
    let text = match pairs {
        0 => "of the load at the edge of the frame".to_owned(),
        _ => format!(
            "of the load at the edge of the frame, on {pairs} elements: enlarge `frame.size`, or the zone of the mesh"
        ),
    };
    Line::new(EDGES, share, Bound::AtMost([0.0, 0.03]), text)
}

/// Elements across the contact when it first bears a load: coarse ones spoil the first outputs, and fade.
pub fn first_contact(across: f64) -> Line {
    let text = "elements across the contact at first; below 8 the first outputs are coarse";
    Line::new("elements", across, Bound::AtLeast([8.0, 0.0]), text)
}

/// Elements across the contact where it is largest.
///
/// With N elements across, the depth worn off a pin is off by about 2/N^2 (`cargo run --release --example accuracy`):
/// 6 % at 6 elements, and 22 % at 3. Two elements say nothing: any contact on an even number of elements presses the two in
/// the middle, however much smaller it is.
pub fn contact(across: f64) -> Line {
    let text = "elements across the contact at its largest; take more elements or a smaller frame";
    Line::new("contact", across, Bound::AtLeast([6.0, 3.0]), text)
}

/// Elements across the stick zone, where a part of the contact slips. Its area counts whole elements, so that few of
/// them are a warning and never an error.
pub fn stick_zone(across: f64) -> Line {
    let text = "elements across the stick zone; its area is that of whole elements";
    Line::new("stick zone", across, Bound::AtLeast([4.0, 0.0]), text)
}

/// The estimated error of the worn depth that steps or jumps make, against the tolerance asked for: chosen bounds. What is
/// stated has a margin, of 1.8 where all of the contact slides and of one and a half for jumps; without it, it ends below the
/// tolerance unless ripples, or the fewest or the most steps allowed, bind.
pub fn time(error: f64, tolerance: f64) -> Line {
    let text =
        format!("estimated error of the worn depth by steps in time, {} asked", share(tolerance));
    Line::new("time", error, Bound::AtMost([2.0 * tolerance, (10.0 * tolerance).max(0.1)]), text)
}

/// What a run with an accuracy says of its errors, all relative.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Accuracy {
    /// That of the worst of the quantities that count, at the end.
    pub error: f64,
    /// Its largest at an output.
    pub largest: f64,
    /// What was asked for.
    pub asked: f64,
    /// The column of the worst that counts, at the end.
    pub worst: Option<String>,
    /// The column of a larger error, and that: of a quantity that does not count.
    pub other: Option<(String, f64)>,
}

/// The estimated error of the worst quantity at the end, against the accuracy asked for, and its largest at an output. Companions
/// foresee that it is met where the search for a grid succeeds; the run itself may show more.
pub fn accuracy(accuracy: &Accuracy) -> Line {
    let Accuracy { error, largest, asked, worst, other } = accuracy;
    let of = worst.as_ref().map(|column| format!("of `{column}` ")).unwrap_or_default();
    let mut text = format!("estimated error {of}at the end, {} asked", share(*asked));
    if largest > error {
        text += &format!("; up to {} at outputs before it", share(*largest));
    }
    if let Some((column, error)) = other {
        text += &format!("; `{column}`, which does not count, has {}", share(*error));
    }
    Line::new("accuracy", *error, Bound::AtMost([*asked, (10.0 * asked).max(0.1)]), text)
}

/// The work of the motion over a cycle against what friction dissipates in it, relative to the latter.
///
/// The case `cattaneo_mindlin` has up to 1e-5 with 4 to 20 increments a cycle; `fretting_sphere`, which wears, 0.8 % with
/// 20, and 1.1, 1.4 and 2.2 % with 12, 8 and 4 on 32 x 32 elements.
pub fn energy(off: f64) -> Line {
    let text = "between the work of a cycle and what friction dissipates; take more increments";
    Line::new("energy", off, Bound::AtMost([0.02, 0.1]), text)
}

/// The share of contact solves after which what closing pairs slide before they touch had still not settled: a chosen bound.
///
/// The case `punch_fretting` has 13 of 11,628.
pub fn touch(share: f64) -> Line {
    let text =
        "of the solves did not settle on what pairs slide before they touch; take more increments";
    Line::new("touch", share, Bound::AtMost([0.02, f64::INFINITY]), text)
}

/// Worn volume or section against what the prescribed load, the creepage or the dissipated energy wears.
///
/// The case `fretting_sphere` on 32 x 32 elements has 0.9 % at 20 increments a cycle, 4.6 % at 12, 9 % at 8 and 51 %
/// at 4: pairs that begin to slip within an increment.
pub fn volume(off: f64) -> Line {
    let text = "between the worn volume and what was prescribed wears; cycles need more increments";
    Line::new("volume", off, Bound::AtMost([0.02, 0.1]), text)
}

/// The smallest Peclet number of the contact, where flash temperatures are put out. Laws that go by the temperature
/// refuse a doubtful one, so that few of them are a warning and never an error.
///
/// The largest flash temperature of a uniform band is 4 % too high at 5, 8 % at 2 and 14 % at 1; see
/// `closed_form::flash_temperature`.
pub fn heat(peclet: f64) -> Line {
    let text =
        "is the smallest Peclet number; flash temperatures are those of fast surfaces, from 5 on";
    Line::new("heat", peclet, Bound::AtLeast([5.0, 0.0]), text)
}

/// The largest alternation or spike of the pressures from element to element, relative to the peak.
///
/// The case `pin_on_disc` has 0.8 %. At the edge of a stick zone that has been worn around, where the pressure of the
/// bodies themselves has a singularity, `punch_fretting` has 28 % and `fretting_sphere` 45 %. Where tetrahedra bear the contact it is
/// [what single pairs stand off](archard::problem::ContactProblem::alone), and with the line of the mesh it covers the error of the peak.
pub fn roughness(off: f64) -> Line {
    let text =
        "of the peak pressure alternates or stands on single elements, which do not resolve it";
    Line::new("pressures", off, Bound::AtMost([0.05, 0.5]), text)
}

/// The largest pressure over the hardness of a body, and its name.
///
/// Hardness is the mean pressure of a contact that yields throughout, three yield stresses (D. Tabor, *The Hardness of
/// Metals*, 1951; K. L. Johnson, *Contact Mechanics*, section 6.3): no place of a surface bears much more than it. Beyond it
/// the contact is larger and softer than computed; threefold, nothing of its pressures is left for a law of wear to go by.
pub fn hardness(over: f64, body: &str) -> Line {
    let text = format!(
        "times the hardness of `{body}` is the largest pressure: the body yields where the computed one stays elastic"
    );
    Line::new("hardness", over, Bound::AtMost([1.0, 3.0]), text)
}

/// Young's modulus (Pa) below which bodies are of elastomers, which do not yield (M. F. Ashby, *Materials Selection in
/// Mechanical Design*, chart of modulus over density).
pub const ELASTOMERS: f64 = 0.1e9;

/// How much stiffer or softer layers are than what is below them where their wear counts.
pub const BY_HALF: f64 = 0.5;

/// The part of a layer that is worn off where it is thinnest, and the name of its body. The elasticity stays that of the unworn
/// layers, which is off in that proportion.
pub fn layers(gone: f64, body: &str) -> Line {
    let text = format!(
        "of a layer of `{body}` is worn off where it is thinnest, and the computed one is as stiff as before"
    );
    Line::new("layers", gone, Bound::AtMost([0.1, f64::INFINITY]), text)
}

/// The largest pressure over Young's modulus of a body whose hardness is not given, and its name.
///
/// The hardness of engineering solids ends at about E/20: bearing steel of 62 HRC has 7.5 GPa at 208 GPa (1/28), alumina 18 GPa
/// at 380 GPa (1/21), silicon nitride 15.5 GPa at 310 GPa (1/20); others are softer for their moduli (M. F. Ashby, *Materials
/// Selection in Mechanical Design*, chart of strength over modulus: yield strains of 2 % and less, a third of the hardness).
pub fn modulus(over: f64, body: &str) -> Line {
    let text = format!(
        "of Young's modulus of `{body}` is the largest pressure: metals and ceramics yield there; give the `hardness` of its material if it is harder"
    );
    Line::new("strain", over, Bound::AtMost([0.05, f64::INFINITY]), text)
}

/// Share of a body's radius that a contact may reach from its middle while a half-space stands for the body.
///
/// At a third a circle lies 3 % lower than the paraboloid and the half-space that stand for it, and Hertz's pressure over the
/// contact modulus, 2 a/(pi R), is 0.21: a large strain.
pub const HALF_SPACE: f64 = 1.0 / 3.0;

/// How far the contact reaches from its middle, over the smallest radius of a body, and its name.
pub fn radius(share: f64, body: &str) -> Line {
    let text = format!(
        "of the smallest radius of `{body}` is how far the contact reaches: a half-space does not stand for it; give it a mesh"
    );
    Line::new("half-space", share, Bound::AtMost([HALF_SPACE, f64::INFINITY]), text)
}

/// What profiles of bodies that conform differ from circles by at the edge of the contact, over the gap there.
///
/// As much as at the [limit of a half-space](HALF_SPACE) for a ball on a plane: a circle lies r^2/(4 R^2) off its paraboloid.
pub fn form(share: f64) -> Line {
    let text = "of the gap at the edge of the contact is by what the profiles differ from circles: write the hollow one as `sphere`, `cylinder` or `disc` with a negative radius";
    let bound = Bound::AtMost([0.25 * HALF_SPACE * HALF_SPACE, f64::INFINITY]);
    Line::new("form", share, bound, text)
}

/// Slope of the surfaces of bodies that conform at the edge of their contact, which plane frames neglect with its square.
///
/// As much as at the [limit of a half-space](HALF_SPACE) for a ball on a plane, halfway between them: r/(2 R).
pub fn slope(slope: f64) -> Line {
    let text = "is the slope of the bodies at the edge of their contact, where they conform: a plane does not stand for it, and pressures come out too low; write `ball` and `socket`, or `shaft` and `bush`, or give both a mesh";
    Line::new("slope", slope, Bound::AtMost([0.5 * HALF_SPACE, f64::INFINITY]), text)
}

/// Angle (degrees) from the pole to the edge of a contact that is drawn on a round surface.
///
/// Ten balls in layered sockets were held against axisymmetric finite elements, up to an edge at 66 degrees of a layer that ends at 90
/// (`tests/verification/fitted.rs`). Nearer to the rim none was.
pub fn angle(degrees: f64) -> Line {
    let text = "degrees from the pole is the edge of the contact on the round surface: beyond 70 the rim, which the model does not have, is near";
    Line::new("angle", degrees, Bound::AtMost([70.0, f64::INFINITY]), text)
}

/// Way from the edge of a contact to the rim of a layered socket, over the thickness of its layers.
///
/// In axisymmetric finite elements of layers of Poisson's ratio 0.4 and 0.46 that end all around at 35, 45 and 60 degrees, pressures were
/// 0.3 % and approaches 1.1 % larger at one thickness, 1.3 and 4 % at half of one, 5 to 11 and 7 to 23 % where the contact reaches the rim.
pub fn rim(thicknesses: f64) -> Line {
    let text = "thicknesses of the layers are between the contact and the rim, which the model does not have: pressures are up to 0.3 % too low at one, 1.3 % at half of one, 11 % at none";
    Line::new("rim", thicknesses, Bound::AtLeast([1.0, 0.0]), text)
}

/// What the chords of a sphere leave of pressures and approaches of an elastic ball, by the angle (degrees) to the edge; the bound is a choice.
///
/// Chords count to the first order in s = sin^2(theta/2), the second has 3 s^2/8 of an influence, and a mean over the contact a third of
/// that at its edge. Eight balls were off harmonics by less (`tests/verification/fitted.rs`).
pub fn map(degrees: f64) -> Line {
    let share = 0.125 * (0.5 * degrees.to_radians()).sin().powi(4);
    let text = "of pressures and of the approach may be missed, as an elastic ball is drawn on a map: give both bodies meshes";
    Line::new("map", share, Bound::AtMost([0.005, f64::INFINITY]), text)
}

/// Clearance over radius of bodies that fit into each other: what the gap between them neglects, and linear elasticity with it.
pub fn clearance(share: f64) -> Line {
    let text = "of the radius is the clearance: as much is neglected of pressures at most";
    Line::new("clearance", share, Bound::AtMost([0.02, f64::INFINITY]), text)
}

/// The force that pressures leave across the axis of the load, over the load, of bodies that fit into each other.
///
/// The inner body is free to move across. In the cup of a hip that wears to one side, 4 % left there, as on a ball that is guided, makes
/// 1.3 % less volume and 1 % less depth (columns, with one balance of forces and with three).
pub fn side(share: f64) -> Line {
    let text = "of the load is left across its axis, where the inner body is free to move: a third of it is missing of what wears";
    Line::new("side", share, Bound::AtMost([1e-3, 3e-2]), text)
}

/// Length of a line of contact over its width: a chosen bound.
///
/// Plane strain, and a line that is cut off with its frame, know nothing of ends. Their effect reaches about a width into the
/// line from either end: of four widths half is left.
pub fn length(widths: f64) -> Line {
    let text = "widths of the contact is the length of the line: its ends reach its middle; a longer frame, or meshes with ends, say more";
    Line::new("line", widths, Bound::AtLeast([4.0, 0.0]), text)
}

/// The temperature of the warmest place (K), or its rise where that of the bodies is not given.
///
/// At 1000 K (727 C, the eutectoid of iron and carbon) steel becomes austenite, which quenches to martensite behind the contact;
/// aluminium and most polymers have molten before. Mild wear ends there (S. C. Lim and M. F. Ashby, *Acta Metallurgica* 35 (1987)
/// 1).
pub fn temperature(kelvin: f64) -> Line {
    let text = "K is the warmest place: steel transforms and other materials melt, and no coefficient of friction or wear holds";
    Line::new("temperature", kelvin, Bound::AtMost([1000.0, f64::INFINITY]), text)
}

/// The creepage, regardless of its direction.
///
/// Rolling is computed for velocities that differ little (J. J. Kalker, *Three-Dimensional Elastic Bodies in Rolling Contact*,
/// 1990, section 1.2). Particles pass the contact at 1 + c/2 and 1 - c/2 of the mean speed c is relative to, so that what they slip
/// on a passage is off by c/2: 5 % at 0.1.
pub fn creepage(creepage: f64) -> Line {
    let text = "is the creepage: the theory of rolling is one of small creepages; such bodies slide, `motion.sliding`";
    Line::new("creepage", creepage, Bound::AtMost([0.1, f64::INFINITY]), text)
}

/// The limit of friction over the pressure.
///
/// Dry metals and ceramics in air have up to about 1.2, and 1.5 with margin (F. P. Bowden and D. Tabor, *The Friction and
/// Lubrication of Solids*, 1950); more is measured on clean metals in vacuum, where they weld, and on soft rubber.
pub fn friction(coefficient: f64) -> Line {
    let text = "is the coefficient of friction: dry metals and ceramics in air have 1.5 at most";
    Line::new("friction", coefficient, Bound::AtMost([1.5, f64::INFINITY]), text)
}

/// Whether a run came to its end: 0 of one that did not.
pub fn complete(failure: &str) -> Line {
    let text =
        format!("the run stopped before its end: {}", failure.lines().next().unwrap_or_default());
    Line::new("complete", 0.0, Bound::AtLeast([1.0, 1.0]), text)
}

/// What is left of the balance of forces and of moments on an elastic body, relative to the load and to the load
/// times half of the body's extent.
///
/// Measured on cantilevers under end shear of 10:1, 5:1 and 3:1, bars and tubes, at Poisson's ratios from 0 to 0.45,
/// and on a ball on a cantilever of 20 x 4 x 2 mm. Results within 3 % left up to 0.20 of the force and 0.33 of the
/// moment, at Poisson's ratios up to 0.3 up to 0.10 and 0.18: most of that comes from the edges of clamps. Tips
/// 30 % off and more left 0.54 of the moment at least; in contact an approach 10 % off left 0.27 and 0.48, one
/// within 1 % 0.04 and 0.08.
pub fn balance(force: f64, moment: f64) -> [Line; 2] {
    let text = |what: &str| {
        format!(
            "of the {what} is not balanced: take shorter elements along the body, two thirds of its thickness at most"
        )
    };
    [
        Line::new("forces", force, Bound::AtMost([0.2, 0.25]), text("load")),
        Line::new("moments", moment, Bound::AtMost([0.25, 0.4]), text("load's moment")),
    ]
}

/// What half the elements of a body, the last degree of polynomials and the way of the body change in the displacements of its image
/// field, relative to the largest displacement of the contact.
///
/// Loads at a given approach of a punch on a cube, a slab, a column and a block five times as high as wide were off by less than this:
/// a tenth of it to nearly all (`loads_of_punched_blocks_are_those_of_fine_meshes`). The bounds are a choice: half of what energies
/// and volumes may be off is good, and what is wrong of these is wrong here.
pub fn image(missed: f64) -> Line {
    let text = "of the displacements are uncertain, by the elements and the degree of an image field and by the way of its body: mesh a part of a file finer, or move the body less; one that stays may take `elasticity = \"boundary_elements\"`";
    Line::new("image", missed, Bound::AtMost([0.01, 0.1]), text)
}

/// What cubic functions would add to the displacements of bodies that bear the contact on their own tetrahedra, or what elements behind a
/// matrix miss of the work of the pressures, relative to the largest
/// displacement of the contact, or to what bends there if that is more.
///
/// Loads of a ball in a socket were off by about this on meshes of three densities
/// (`a_ball_in_a_socket_is_that_of_revolution`), by up to half as much again. The bounds are those of image fields.
pub fn mesh(missed: f64) -> Line {
    let text = "of the displacements are uncertain, by the elements that bear the contact: mesh the bodies finer where they touch and below, and towards edges of what is held";
    Line::new("mesh", missed, Bound::AtMost([0.01, 0.1]), text)
}

/// The longest element along a free span over the thickness that bends there.
///
/// Tips of cantilevers under end shear were 0.2 to 1.7 % off up to 0.83, 3 to 5 % at 1, 11 to 14 % at 1.25, 35 % at
/// 1.5 and worse beyond. It is never wrong by itself: walls of hollow sections bear longer ones.
pub fn slenderness(longest: f64) -> Line {
    let bound = Bound::AtMost([0.85, f64::INFINITY]);
    let text = "of the thickness below it is the length of the longest element where the body can bend: take shorter ones, two thirds of the thickness at most";
    Line::new("bending", longest, bound, text)
}

/// How much the normal of the rail turns (degrees) within a patch of a wheel on a rail, where both conform.
///
/// Each patch lies in a plane, where its bodies are half-spaces. From ten degrees on a conforming contact is stiffer and its
/// spin is not the same all over; by how much is not known here.
pub fn conformity(degrees: f64) -> Line {
    let text = "degrees is how far the normal of the rail turns within a patch: the contact conforms, and is computed in its tangent plane";
    Line::new("conformity", degrees, Bound::AtMost([10.0, f64::INFINITY]), text)
}

/// The error of the area worn off a wheel or a rail, relative to it.
pub fn worn(error: f64) -> Line {
    let text = "is the error of the worn area: `frame.elements` and `motion.wheel_rail.tolerance` make it smaller";
    Line::new("wear", error, Bound::AtMost([0.05, 0.3]), text)
}

/// What the points of a route lose of the history that they stand for, relative to all work of friction.
pub fn gathered(loss: f64) -> Line {
    let text = "of the work of friction is lost where the points of the route stand for a history: a smaller `history.within` takes more of them";
    Line::new("history", loss, Bound::AtMost([0.05, 0.3]), text)
}

/// What stations that a long table leaves out lose of the load by the distance slid: so much of the worn volume, under the bounds of a
/// [history](gathered). `kept` of `rows` stations are gone through, and places of the others are off by that (m) at most.
pub fn stations(loss: f64, [kept, rows]: [usize; 2], displaced: f64) -> Line {
    let text = format!(
        "of the load by the distance slid is lost where {kept} of {rows} stations are gone through, by whose path the others are off by {} um at most: a smaller `motion.table.within` or `apart` takes more of them",
        four(1e6 * displaced)
    );
    Line::new("stations", loss, Bound::AtMost([0.05, 0.3]), text)
}

/// How far the contact moves from a station to the next where others are left out, over its width. Beyond one, places between them are in
/// the contact at no station.
pub fn apart(ratio: f64) -> Line {
    let text = "times the width of the contact is how far it moves where stations are left out, and what is worn between them is not seen: a smaller `motion.table.apart`";
    Line::new("apart", ratio, Bound::AtMost([1.0, f64::INFINITY]), text)
}

/// What strips along a line of contact neglect of the load of one, over the mean, where they press on one another: so much of the depth
/// worn there, under the bounds of a [history](gathered).
pub fn strips(neglected: f64) -> Line {
    let text = "of the load of a strip is what the others would add to it, which strips in plane strain neglect: a crowned roller, or a frame without `length`, has all of it";
    Line::new("strips", neglected, Bound::AtMost([0.05, 0.3]), text)
}

/// What a user is warned of, in its first line: never good.
pub fn warned(warning: &str) -> Line {
    let text = warning.lines().next().unwrap_or_default();
    Line::new("warning", 1.0, Bound::AtMost([0.0, f64::INFINITY]), text)
}

/// The largest stated error of what a user reads, relative, and the column it is of. A value is right to the error stated with it,
/// so that a large one is doubtful; one as large as the value leaves nothing to read.
pub fn stated(error: f64, column: &str) -> Line {
    let text = format!(
        "is the error of `{column}`: smoother profiles (`smoothing`) or more `frame.elements` make it smaller"
    );
    Line::new("stated", error, STATED, text)
}

/// How large a stated error may be.
const STATED: Bound = Bound::AtMost([0.05, 1.0]);

/// The largest equivalent stress in a body over its yield strength, and its name. Beyond one the body is not elastic where it is
/// largest: residual stresses remain there, which change it.
pub fn yields(utilisation: f64, body: &str) -> Line {
    let text = format!(
        "of the yield strength of `{body}` is its largest equivalent stress: it yields there, and stresses are those of a body that stays elastic"
    );
    Line::new("yield", utilisation, Bound::AtMost([1.0, f64::INFINITY]), text)
}

/// How far what pairs of teeth share is off the load of the torque, relative to it. A table of shares is as exact as it is rounded, to a
/// hundredth; beyond a tenth it is another load's.
pub fn shared(off: f64) -> Line {
    let text = "of the load is how far the shares of pairs of teeth that touch at once are off it: those of `share` a pitch apart have to add up to one";
    Line::new("shares", off, Bound::AtMost([0.01, 0.1]), text)
}

/// How far wear displaces the contact of two flanks, over the pitch along the path: loads and sliding are those of the involutes. A
/// tenth is a choice; a pitch away the pair of teeth does not touch.
pub fn flanks(share: f64) -> Line {
    let text = "of the pitch is how far worn flanks displace their contact: they are no involutes any more, and shares and sliding are not those computed";
    Line::new("flanks", share, Bound::AtMost([0.1, 1.0]), text)
}

/// By how much wear changes how a body wears where it is deepest, relative to it, to first order: worn bodies touch elsewhere, over
/// another width and under another load than new ones, which are those computed. A tenth is a choice; as much as the wear itself, and the
/// contact conforms to what is worn.
pub fn reshaped(share: f64, body: &str) -> Line {
    let text = format!(
        "of the deepest wear of `{body}` is how much worn shapes may change it, which are not followed: take fewer passages, or a counterbody that wears less"
    );
    Line::new("worn shape", share, Bound::AtMost([0.1, 1.0]), text)
}

/// A gear that is deepest where the contact ends at a tip, nearer than half of its width.
///
/// What of the width lies beyond the tip bears nothing, and the edge of the tip bears more than Hertz's pressure: depths there are those of
/// a flank that went on.
pub fn tip(gears: &str) -> Line {
    let text = format!(
        "`{gears}`: deepest within a half-width from where the contact ends at a tip, whose edge is not computed: read depths farther in, or relieve the tips by a table of `share`"
    );
    Line::new("tip", 1.0, Bound::AtMost([0.0, f64::INFINITY]), text)
}

/// The largest stated error of what was measured or is compared, relative, and what it is of.
pub fn measured(error: f64, what: &str) -> Line {
    Line::new("stated", error, STATED, format!("is the stated error of the {what}"))
}

/// How far a run can be believed that something is compared with, and why.
pub fn of_run(word: Word, why: &str) -> Line {
    judged("run", word, why)
}

/// Whether the runs of a fit and the readings brought its coefficients together, and what is off if not.
pub fn settled(word: Word, why: &str) -> Line {
    judged("settled", word, why)
}

/// Whether tests wear as the law says, and what they show.
pub fn shape(word: Word, why: &str) -> Line {
    judged("law's shape", word, why)
}

/// Whether a coefficient holds for tests of all loads, and what they show.
pub fn constant(word: Word, why: &str) -> Line {
    judged("constant k", word, why)
}

/// Whether the tests say where the next one will lie.
pub fn next_test(known: bool, key: &str) -> Line {
    let word = if known { Word::Good } else { Word::Doubtful };
    judged("next test", word, &format!("{key}: too few tests to foresee the next"))
}

/// What another judgement has decided.
fn judged(subject: &'static str, word: Word, why: &str) -> Line {
    let worse = [Word::Good, Word::Doubtful, Word::Wrong].iter().position(|one| *one == word);
    Line::new(subject, worse.unwrap_or_default() as f64, Bound::AtMost([0.0, 1.0]), why)
}

/// The share of the points of a measured surface that have no height. Of half of them and less no surface is made.
pub fn missing(share: f64) -> Line {
    let text =
        "of the points have no height: `holes = \"fill\"` puts what lies between the others there";
    Line::new("missing", share, Bound::AtMost([0.0, 0.5]), text)
}

/// Hardness (Pa) of the hardest rail steel, R400HT of EN 13674-1: 440 HBW.
pub const RAIL_STEEL: f64 = 440.0 * 9.80665e6;

/// The yield stress in shear (Pa) of a hardness (Pa), which is three yield stresses (Tabor), each sqrt(3) of those (von Mises).
pub fn shear_yield(hardness: f64) -> f64 {
    hardness / (3.0 * 3.0_f64.sqrt())
}

/// The largest pressure of a contact that rolls, over the hardness, relative to the shakedown limit with that much of the friction used
/// (tangential over normal force).
///
/// With k the yield stress in shear, a line that rolls shakes down to 4 k below the surface (K. L. Johnson, *Contact Mechanics*, 1985,
/// section 9.2; a point to 4.7 k, A. R. S. Ponter et al. 1985), and to k over the friction used on it (A. Ekberg, E. Kabo and H. Andersson,
/// 2002).
pub fn shaken(over_hardness: f64, friction: f64) -> f64 {
    over_hardness / shear_yield(1.0) * friction.max(1.0 / 4.0)
}

/// The largest pressure relative to the shakedown limit, and whose.
pub fn shakedown(over: f64, body: &str) -> Line {
    let text = format!(
        "of the shakedown limit of {body} is the largest pressure with its friction: the surface flows at every passage, and neither its \
         profile nor its hardness stay; look at loads and profiles, or give the `hardness` of the materials"
    );
    Line::new("shakedown", over, Bound::AtMost([1.0, f64::INFINITY]), text)
}

/// Patches that lie between the steepest place of the flange and its tip.
///
/// There the flank no longer guides the wheel, which climbs onto the rail (M. J. Nadal, *Locomotives a vapeur*, 1908): no such
/// wheel runs along its track.
pub fn climbs(patches: usize) -> Line {
    let text = "the wheel stands on its flange, beyond the steepest place of it: it leaves the track there; look at `shift`, gauge and profiles";
    Line::new("flange", patches as f64, Bound::AtMost([0.0, f64::INFINITY]), text)
}

/// The lateral force of a wheel against the one that a history has, relative to its vertical force: a chosen bound, and whose.
///
/// Wear follows what is computed. Forces of a history with other profiles, friction or yaw are those of another contact.
pub fn lateral(off: f64, whose: &str) -> Line {
    let text = format!(
        "of its vertical force is the lateral force of {whose} off that of the history: look at its sign, profiles, friction, `yaw` and `shift`"
    );
    Line::new("lateral", off, Bound::AtMost([0.1, f64::INFINITY]), text)
}

/// The lateral over the vertical force of a wheel, relative to Nadal's limit.
///
/// Above it the flange may climb: the vertical force is less than what friction and the flange's inclination hold up.
pub fn nadal(over: f64) -> Line {
    let text = "of Nadal's limit is the lateral over the vertical force of a wheel: its flange may climb the rail; look at `shift`, `yaw`, gauge and loads";
    Line::new("climb", over, Bound::AtMost([1.0, f64::INFINITY]), text)
}
