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
];

impl Builtin {
    /// What it is about: the title in its file.
    pub fn title(&self) -> &str {
        let title = self.text.lines().find_map(|line| line.strip_prefix("title = "));
        title.unwrap_or_default().trim_matches('"')
    }
}
