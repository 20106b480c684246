//! The cases that come with the program.

/// A case to start from.
#[derive(Debug)]
pub struct Builtin {
    /// Its name.
    pub name: &'static str,
    /// Its case file.
    pub text: &'static str,
    /// Files the case reads, each with its name.
    pub files: &'static [(&'static str, &'static [u8])],
}

/// All of them.
pub const CASES: &[Builtin] = &[
    without_files("hertz", include_str!("../cases/hertz/case.toml")),
    without_files("pin_on_disc", include_str!("../cases/pin_on_disc/case.toml")),
    without_files("pin_on_disc_both", include_str!("../cases/pin_on_disc_both/case.toml")),
    without_files("pin_on_disc_track", include_str!("../cases/pin_on_disc_track/case.toml")),
    without_files("block_on_ring", include_str!("../cases/block_on_ring/case.toml")),
    without_files("reciprocating_ball", include_str!("../cases/reciprocating_ball/case.toml")),
    without_files("carter", include_str!("../cases/carter/case.toml")),
    without_files("kalker_creepage", include_str!("../cases/kalker_creepage/case.toml")),
    without_files("free_rolling_unlike", include_str!("../cases/free_rolling_unlike/case.toml")),
    without_files("twin_disc", include_str!("../cases/twin_disc/case.toml")),
    without_files(
        "twin_disc_accelerated",
        include_str!("../cases/twin_disc_accelerated/case.toml"),
    ),
    without_files("roller_finite", include_str!("../cases/roller_finite/case.toml")),
    without_files("cattaneo_mindlin", include_str!("../cases/cattaneo_mindlin/case.toml")),
    without_files("spence", include_str!("../cases/spence/case.toml")),
    without_files("punch_indentation", include_str!("../cases/punch_indentation/case.toml")),
    without_files(
        "punch_indentation_block",
        include_str!("../cases/punch_indentation_block/case.toml"),
    ),
    without_files("punch_fretting_block", include_str!("../cases/punch_fretting_block/case.toml")),
    without_files("punch_fretting", include_str!("../cases/punch_fretting/case.toml")),
    without_files("mccoll_fretting", include_str!("../cases/mccoll_fretting/case.toml")),
    without_files("fretting_sphere", include_str!("../cases/fretting_sphere/case.toml")),
    without_files(
        "running_in_flat_punch",
        include_str!("../cases/running_in_flat_punch/case.toml"),
    ),
    without_files("fretting_energy", include_str!("../cases/fretting_energy/case.toml")),
    without_files("running_in_law", include_str!("../cases/running_in_law/case.toml")),
    without_files("custom_expression", include_str!("../cases/custom_expression/case.toml")),
    without_files(
        "wheel_steel_twin_disc",
        include_str!("../cases/wheel_steel_twin_disc/case.toml"),
    ),
    without_files("orthotropic_pin", include_str!("../cases/orthotropic_pin/case.toml")),
    without_files("orthotropic_fretting", include_str!("../cases/orthotropic_fretting/case.toml")),
    without_files(
        "orthotropic_twin_disc",
        include_str!("../cases/orthotropic_twin_disc/case.toml"),
    ),
    Builtin {
        name: "patch_test",
        text: include_str!("../cases/patch_test/case.toml"),
        files: &[("block.msh", include_bytes!("../cases/patch_test/block.msh"))],
    },
    Builtin {
        name: "hollow_sphere",
        text: include_str!("../cases/hollow_sphere/case.toml"),
        files: &[("octant.msh", include_bytes!("../cases/hollow_sphere/octant.msh"))],
    },
    Builtin {
        name: "pin_in_bush",
        text: include_str!("../cases/pin_in_bush/case.toml"),
        files: &[
            ("bush.msh", include_bytes!("../cases/pin_in_bush/bush.msh")),
            ("pin.msh", include_bytes!("../cases/pin_in_bush/pin.msh")),
            ("pin_of_5_degrees.msh", include_bytes!("../cases/pin_in_bush/pin_of_5_degrees.msh")),
        ],
    },
    Builtin {
        name: "warm_twin_disc",
        text: include_str!("../cases/warm_twin_disc/case.toml"),
        files: &[("wear.csv", include_bytes!("../cases/warm_twin_disc/wear.csv"))],
    },
];

const fn without_files(name: &'static str, text: &'static str) -> Builtin {
    Builtin { name, text, files: &[] }
}

impl Builtin {
    /// What it is about: the title in its file.
    pub fn title(&self) -> &str {
        let title = self.text.lines().find_map(|line| line.strip_prefix("title = "));
        title.unwrap_or_default().trim_matches('"')
    }
}
