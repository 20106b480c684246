//! `archard new`: writes a case to start from, of a rig or a built-in one; asks for the rig, or lists all.

use std::fs::{self, OpenOptions};
use std::io::{self, IsTerminal, Write};
use std::path::{Path, PathBuf};

use archard_case::nearest;

use crate::arguments::New;
use crate::builtin::{Builtin, CASES, named};
use crate::failure::Failure;
use crate::rigs::RIGS;
use crate::say::say;

/// Where the pictures of the cases are.
const PICTURES: &str = "book/src/gallery";

/// Writes a case of a rig, or a built-in one; without a name asks on a terminal, or lists all.
pub fn new(arguments: &New) -> Result<(), Failure> {
    let asked = match &arguments.name {
        _ if arguments.list => return list(),
        Some(name) => name.clone(),
        None if io::stdin().is_terminal() && io::stdout().is_terminal() => ask()?,
        None => return list(),
    };
    let builtin = named(&asked).ok_or_else(|| {
        let rigs: Vec<&str> = RIGS.iter().map(|rig| rig.name).collect();
        let cases = CASES.iter().map(|builtin| builtin.name);
        let known: Vec<&str> = rigs.iter().copied().chain(cases).collect();
        let next = match nearest(&asked, &known) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("rigs are {}", rigs.join(", ")),
        };
        Failure::wrong(format!(
            "there is no rig and no built-in case `{asked}`; {next} `archard new --list` shows all"
        ))
    })?;
    let dir = arguments.output.clone().unwrap_or_else(|| PathBuf::from(builtin.name));
    let path = dir.join("case.toml");
    write(&dir, &path, builtin).map_err(|error| {
        let next = match error.kind() {
            io::ErrorKind::AlreadyExists => "; it is kept: choose another folder with -o",
            _ => "",
        };
        Failure::wrong(format!("cannot write `{}`: {error}{next}", path.display()))
    })?;
    say(&format!("{} written; next: archard run {}", path.display(), dir.display()))
}

/// Asks which rig it is.
fn ask() -> Result<String, Failure> {
    for (index, rig) in RIGS.iter().enumerate() {
        say(&format!("{}  {:18} {}", index + 1, rig.name, rig.meaning))?;
    }
    print!("Which rig? Its number or its name: ");
    let mut answer = String::new();
    let read = io::stdout().flush().and_then(|()| io::stdin().read_line(&mut answer));
    read.map_err(|error| Failure::wrong(format!("cannot read the answer: {error}")))?;
    let answer = answer.trim();
    let number = answer.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
    let rig = number.and_then(|index| RIGS.get(index));
    match rig {
        Some(rig) => Ok(rig.name.to_owned()),
        None if answer.is_empty() => Err(Failure::wrong("no rig was chosen; nothing is written")),
        None => Ok(answer.to_owned()),
    }
}

fn list() -> Result<(), Failure> {
    say("Rigs, and the case each starts from\n")?;
    for rig in RIGS {
        say(&format!("  {:18} {:24} {}", rig.name, rig.case, rig.meaning))?;
    }
    say(&format!("\nBuilt-in cases, with the picture in the repository under {PICTURES}\n"))?;
    let width = CASES.iter().map(|builtin| builtin.name.len()).max().unwrap_or(0);
    for builtin in CASES {
        // A body by itself has results for ParaView, but no picture.
        let moves = builtin.text.contains("[motion.");
        let picture = if moves { format!("{}.png", builtin.name) } else { "-".to_owned() };
        let wide = width + 4;
        say(&format!("  {:width$}  {picture:wide$}  {}", builtin.name, builtin.title()))?;
    }
    say("\narchard new NAME writes one out to start from")
}

/// Writes the case and the files it reads, never over a file that is there.
fn write(dir: &Path, path: &Path, builtin: &Builtin) -> io::Result<()> {
    fs::create_dir_all(dir)?;
    let write = |path: &Path, bytes: &[u8]| {
        OpenOptions::new().write(true).create_new(true).open(path)?.write_all(bytes)
    };
    write(path, builtin.text.as_bytes())?;
    builtin.files.iter().try_for_each(|(name, bytes)| write(&dir.join(name), bytes))
}
