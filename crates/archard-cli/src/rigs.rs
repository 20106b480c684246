//! Tests as rigs run them, each with the built-in case to start from and what is asked about it.

/// A rig.
#[derive(Debug)]
pub struct Rig {
    /// Its name.
    pub name: &'static str,
    /// What moves, in a line.
    pub meaning: &'static str,
    /// The name of its case.
    pub case: &'static str,
    /// What differs from one test to the next: keys that its case has, each with what they are.
    pub asks: &'static [(&'static str, &'static str)],
}

/// All of them.
pub const RIGS: &[Rig] = &[
    Rig {
        name: "ball_on_flat",
        case: "hertz",
        meaning: "a ball pressed on a flat: contact alone",
        asks: &[
            ("body.ball.material", "material of the ball"),
            ("body.ball.profile.sphere.radius", "radius of the ball"),
            ("body.flat.material", "material of the flat"),
            ("motion.indentation.load", "load"),
        ],
    },
    Rig {
        name: "ball_on_disc",
        case: "pin_on_disc_track",
        meaning: "a ball or a pin on a disc that turns",
        asks: &[
            ("body.ball.material", "material of the ball"),
            ("body.ball.profile.sphere.radius", "radius of the ball"),
            ("body.ball.wear.archard.coefficient", "wear coefficient of the ball"),
            ("body.disc.material", "material of the disc"),
            ("body.disc.wear.archard.coefficient", "wear coefficient of the disc"),
            ("motion.sliding.load", "load"),
            ("motion.sliding.track_radius", "radius of the track"),
            ("motion.sliding.distance", "distance slid"),
            ("motion.sliding.speed", "speed"),
        ],
    },
    Rig {
        name: "block_on_ring",
        case: "block_on_ring",
        meaning: "a block pressed on a ring that turns",
        asks: &[
            ("body.block.material", "material of the block"),
            ("body.block.wear.archard.coefficient", "wear coefficient of the block"),
            ("body.ring.material", "material of the ring"),
            ("body.ring.profile.disc.crown", "radius of the ring's crown"),
            ("body.ring.wear.archard.coefficient", "wear coefficient of the ring"),
            ("motion.sliding.load", "load"),
            ("motion.sliding.turns", "turns"),
            ("motion.sliding.frequency", "turns in a time"),
        ],
    },
    Rig {
        name: "gears",
        case: "gear_flanks",
        meaning: "two spur gears under a torque: the FZG test",
        asks: &[
            ("body.pinion.profile.involute.module", "module of the pinion"),
            ("body.pinion.profile.involute.teeth", "teeth of the pinion"),
            ("body.pinion.profile.involute.shift", "profile shift of the pinion"),
            ("body.pinion.profile.involute.tip_diameter", "tip diameter of the pinion"),
            ("body.pinion.wear.archard.coefficient", "wear coefficient of the pinion"),
            ("body.wheel.profile.involute.module", "module of the wheel"),
            ("body.wheel.profile.involute.teeth", "teeth of the wheel"),
            ("body.wheel.profile.involute.shift", "profile shift of the wheel"),
            ("body.wheel.profile.involute.tip_diameter", "tip diameter of the wheel"),
            ("body.wheel.wear.archard.coefficient", "wear coefficient of the wheel"),
            ("motion.mesh.centre_distance", "distance of the axes"),
            ("motion.mesh.width", "width of the teeth"),
            ("motion.mesh.torque", "torque on the pinion"),
            ("motion.mesh.meshes", "meshes of each flank"),
        ],
    },
    Rig {
        name: "reciprocating",
        case: "reciprocating_ball",
        meaning: "a ball to and fro on a flat, by long strokes",
        asks: &[
            ("body.ball.material", "material of the ball"),
            ("body.ball.profile.sphere.radius", "radius of the ball"),
            ("body.ball.wear.archard.coefficient", "wear coefficient of the ball"),
            ("body.flat.material", "material of the flat"),
            ("body.flat.wear.archard.coefficient", "wear coefficient of the flat"),
            ("motion.sliding.load", "load"),
            ("motion.sliding.stroke", "stroke, from one end to the other"),
            ("motion.sliding.distance", "distance slid, of all strokes"),
            ("motion.sliding.frequency", "strokes to and fro in a time"),
        ],
    },
    Rig {
        name: "fretting",
        case: "fretting_sphere",
        meaning: "a ball on a flat, shifted by less than the contact",
        asks: &[
            ("body.ball.material", "material of the ball"),
            ("body.ball.profile.sphere.radius", "radius of the ball"),
            ("body.ball.wear.archard.coefficient", "wear coefficient of the ball"),
            ("body.flat.material", "material of the flat"),
            ("body.flat.wear.archard.coefficient", "wear coefficient of the flat"),
            ("friction.coulomb.coefficient", "coefficient of friction"),
            ("motion.fretting.load", "load"),
            ("motion.fretting.amplitude", "amplitude along x and y, from the middle"),
            ("motion.fretting.cycles", "cycles"),
            ("output.every", "cycles from output to output"),
        ],
    },
    Rig {
        name: "cylinder_fretting",
        case: "mccoll_fretting",
        meaning: "a cylinder on a flat, a line of contact",
        asks: &[
            ("body.cylinder.material", "material of the cylinder"),
            ("body.cylinder.profile.cylinder.radius", "radius of the cylinder"),
            ("body.cylinder.wear.archard.coefficient", "wear coefficient of the cylinder"),
            ("body.flat.material", "material of the flat"),
            ("body.flat.wear.archard.coefficient", "wear coefficient of the flat"),
            ("friction.coulomb.coefficient", "coefficient of friction"),
            ("motion.fretting.load", "load per length of the line"),
            ("motion.fretting.amplitude", "amplitude along x and y, from the middle"),
            ("motion.fretting.cycles", "cycles"),
        ],
    },
    Rig {
        name: "twin_disc",
        case: "twin_disc",
        meaning: "two discs that roll with creepage",
        asks: &[
            ("body.disc1.material", "material of disc 1"),
            ("body.disc1.profile.disc.radius", "radius of disc 1"),
            ("body.disc1.profile.disc.crown", "radius of its crown"),
            ("body.disc1.wear.archard.coefficient", "wear coefficient of disc 1"),
            ("body.disc2.material", "material of disc 2"),
            ("body.disc2.profile.disc.radius", "radius of disc 2"),
            ("body.disc2.wear.archard.coefficient", "wear coefficient of disc 2"),
            ("friction.coulomb.coefficient", "coefficient of friction"),
            ("motion.rolling.load", "load"),
            ("motion.rolling.creepage", "creepage, (v1 - v2) over their mean"),
            ("motion.rolling.revolutions", "revolutions"),
        ],
    },
    Rig {
        name: "punch_on_block",
        case: "punch_indentation_block",
        meaning: "a punch on a block of finite size",
        asks: &[
            ("body.block.material", "material of the block"),
            ("friction.coulomb.coefficient", "coefficient of friction"),
            ("motion.indentation.approach", "how far the punch is pressed in"),
        ],
    },
];
