//! The cases that come with the program.

/// A case to start from.
#[derive(Debug)]
pub struct Builtin {
    /// Its name.
    pub name: &'static str,
    /// Its case file.
    pub text: &'static str,
}

/// All of them.
pub const CASES: &[Builtin] = &[
    Builtin { name: "hertz", text: include_str!("../../../cases/hertz/case.toml") },
    Builtin { name: "pin_on_disc", text: include_str!("../../../cases/pin_on_disc/case.toml") },
    Builtin {
        name: "pin_on_disc_both",
        text: include_str!("../../../cases/pin_on_disc_both/case.toml"),
    },
    Builtin { name: "carter", text: include_str!("../../../cases/carter/case.toml") },
    Builtin {
        name: "kalker_creepage",
        text: include_str!("../../../cases/kalker_creepage/case.toml"),
    },
    Builtin {
        name: "free_rolling_unlike",
        text: include_str!("../../../cases/free_rolling_unlike/case.toml"),
    },
    Builtin { name: "twin_disc", text: include_str!("../../../cases/twin_disc/case.toml") },
    Builtin {
        name: "twin_disc_accelerated",
        text: include_str!("../../../cases/twin_disc_accelerated/case.toml"),
    },
    Builtin {
        name: "cattaneo_mindlin",
        text: include_str!("../../../cases/cattaneo_mindlin/case.toml"),
    },
    Builtin { name: "spence", text: include_str!("../../../cases/spence/case.toml") },
    Builtin {
        name: "punch_indentation",
        text: include_str!("../../../cases/punch_indentation/case.toml"),
    },
    Builtin {
        name: "punch_indentation_block",
        text: include_str!("../../../cases/punch_indentation_block/case.toml"),
    },
    Builtin {
        name: "punch_fretting",
        text: include_str!("../../../cases/punch_fretting/case.toml"),
    },
    Builtin {
        name: "fretting_sphere",
        text: include_str!("../../../cases/fretting_sphere/case.toml"),
    },
    Builtin {
        name: "running_in_flat_punch",
        text: include_str!("../../../cases/running_in_flat_punch/case.toml"),
    },
];

impl Builtin {
    /// What it is about: the title in its file.
    pub fn title(&self) -> &str {
        let title = self.text.lines().find_map(|line| line.strip_prefix("title = "));
        title.unwrap_or_default().trim_matches('"')
    }
}
