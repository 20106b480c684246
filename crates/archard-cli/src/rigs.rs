//! Tests as rigs run them, each with the built-in case to start from.

/// A rig.
#[derive(Debug)]
pub struct Rig {
    /// Its name.
    pub name: &'static str,
    /// What moves, in a line.
    pub meaning: &'static str,
    /// The name of its case.
    pub case: &'static str,
}

/// All of them.
pub const RIGS: &[Rig] = &[
    rig("ball_on_flat", "hertz", "a ball pressed on a flat: contact alone"),
    rig("ball_on_disc", "pin_on_disc_track", "a ball or a pin on a disc that turns"),
    rig("block_on_ring", "block_on_ring", "a block pressed on a ring that turns"),
    rig("reciprocating", "reciprocating_ball", "a ball to and fro on a flat, by long strokes"),
    rig("fretting", "fretting_sphere", "a ball on a flat, shifted by less than the contact"),
    rig("cylinder_fretting", "mccoll_fretting", "a cylinder on a flat, a line of contact"),
    rig("twin_disc", "twin_disc", "two discs that roll with creepage"),
    rig("punch_on_block", "punch_indentation_block", "a punch on a block of finite size"),
];

const fn rig(name: &'static str, case: &'static str, meaning: &'static str) -> Rig {
    Rig { name, meaning, case }
}
