//! `archard new`: writes a case to start from, of a rig or a built-in one; asks for the rig and its values, or lists all.

mod ask;

use std::fs::{self, OpenOptions};
use std::io::{self, BufRead, IsTerminal, Write};
use std::path::{Path, PathBuf};

use archard_case::{CaseFile, nearest};

use crate::arguments::New;
use crate::builtin::{Builtin, CASES, Files, named};
use crate::failure::Failure;
use crate::rigs::{RIGS, Rig};
use crate::say::say;
use ask::Talk;

/// Where the pictures of the cases are.
const PICTURES: &str = "book/src/gallery";

/// Writes a case of a rig, or a built-in one; without a name asks on a terminal, or lists all. Where it is asked to, or has asked
/// for the rig, asks for the values of the rig, too.
pub fn new(arguments: &New) -> Result<(), Failure> {
    let on_terminal = io::stdin().is_terminal() && io::stdout().is_terminal();
    let mut talk = Talk { reader: io::stdin().lock(), writer: io::stdout() };
    let asks = arguments.ask || arguments.name.is_none();
    let asked = match &arguments.name {
        _ if arguments.list => return list(),
        Some(name) => name.clone(),
        None if arguments.ask || on_terminal => rig(&mut talk)?,
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
    let refused = |error: io::Error| {
        let next = match error.kind() {
            io::ErrorKind::AlreadyExists => "; it is kept: choose another folder with -o",
            _ => "",
        };
        Failure::wrong(format!("cannot write `{}`: {error}{next}", path.display()))
    };
    let rig = RIGS.iter().find(|rig| rig.case == builtin.name).filter(|_| asks);
    let text = match rig {
        // Nobody answers for nothing.
        Some(_) if path.exists() => return Err(refused(io::ErrorKind::AlreadyExists.into())),
        Some(rig) => answered(&mut talk, rig, builtin)?,
        None if arguments.ask => {
            return Err(Failure::wrong(format!(
                "nothing is asked about `{asked}`, which is no rig"
            )));
        }
        None => builtin.text.to_owned(),
    };
    write(&dir, &path, (&text, builtin.files)).map_err(refused)?;
    say(&format!("{} written; next: archard run {}", path.display(), dir.display()))
}

/// Asks which rig it is.
fn rig(talk: &mut Talk<impl BufRead, impl Write>) -> Result<String, Failure> {
    for (index, rig) in RIGS.iter().enumerate() {
        say(&format!("{}  {:18} {}", index + 1, rig.name, rig.meaning))?;
    }
    let answer = talk.answer("Which rig? Its number or its name").map_err(unanswered)?;
    let answer = answer.unwrap_or_default();
    let number = answer.parse::<usize>().ok().and_then(|number| number.checked_sub(1));
    let rig = number.and_then(|index| RIGS.get(index));
    match rig {
        Some(rig) => Ok(rig.name.to_owned()),
        None if answer.is_empty() => Err(Failure::wrong("no rig was chosen; nothing is written")),
        None => Ok(answer),
    }
}

/// The text of a rig's case with the answers in it.
fn answered(
    talk: &mut Talk<impl BufRead, impl Write>,
    rig: &Rig,
    builtin: &Builtin,
) -> Result<String, Failure> {
    let case = CaseFile::from_text(builtin.name, builtin.text, builtin.folder()?);
    let filled = talk.fill(case, rig.asks).map_err(unanswered)?;
    let ended = || Failure::wrong("the answers ended before the questions; nothing is written");
    filled.map(|case| case.to_text().to_owned()).ok_or_else(ended)
}

fn unanswered(error: io::Error) -> Failure {
    Failure::wrong(format!("cannot read the answer: {error}"))
}

fn list() -> Result<(), Failure> {
    say("Rigs, and the case each starts from\n")?;
    for rig in RIGS {
        say(&format!("  {:18} {:24} {}", rig.name, rig.case, rig.meaning))?;
    }
    say(&format!("\nBuilt-in cases, with the picture in the repository under {PICTURES}\n"))?;
    let width = CASES.iter().map(|builtin| builtin.name.len()).max().unwrap_or(0);
    for builtin in CASES {
        let picture = format!("{}.png", builtin.name);
        let wide = width + 4;
        say(&format!("  {:width$}  {picture:wide$}  {}", builtin.name, builtin.title()))?;
    }
    say("\narchard new NAME writes one out to start from")
}

/// Writes the case and the files it reads, never over a file that is there.
fn write(dir: &Path, path: &Path, (text, files): (&str, Files)) -> io::Result<()> {
    fs::create_dir_all(dir)?;
    let write = |path: &Path, bytes: &[u8]| {
        OpenOptions::new().write(true).create_new(true).open(path)?.write_all(bytes)
    };
    write(path, text.as_bytes())?;
    files.iter().try_for_each(|(name, bytes)| write(&dir.join(name), bytes))
}
