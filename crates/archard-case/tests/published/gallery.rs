//! The gallery of the book: every case with its picture and what it is about, from its own files.

use std::fs;
use std::path::{Path, PathBuf};

use toml::de::DeTable;

/// What the page begins with.
const HEAD: &str = "\
# Gallery

Every case of the repository: what it is about, what it looks like, and a link to its own page, with its commands. What its source says and
what Archard gives stands under [validation](validation.md). `archard new NAME` writes a case out to start from. The page is written
by `just pages`, the pictures by `just gallery`.
";

fn book() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src")
}

/// What is seen in the picture of a case, from the list beside the pictures.
fn seen(name: &str) -> String {
    let list = fs::read_to_string(book().join("gallery/seen.toml")).expect("a list");
    let list = DeTable::parse(&list).expect("a list in TOML");
    let case = list.get_ref().get(name).and_then(|case| case.get_ref().as_table());
    let text = case.and_then(|case| case.get("seen")?.get_ref().as_str());
    text.unwrap_or_else(|| {
        panic!("gallery/seen.toml has to say what is seen in the picture of `{name}`")
    })
    .to_owned()
}

/// The part of a case: its title, its picture if it has one, the first paragraph of its own page.
fn part(folder: &Path) -> String {
    let name = folder.file_name().unwrap().to_string_lossy();
    let about = fs::read_to_string(folder.join("README.md")).expect("a README.md");
    let title = about.lines().next().and_then(|line| line.strip_prefix("# ")).expect("a title");
    let paragraph = about.split("\n\n").nth(1).expect("a paragraph").trim_end_matches(':');
    let picture = match book().join(format!("gallery/{name}.png")).is_file() {
        true => format!("![{}](gallery/{name}.png)\n\n", seen(&name)),
        false => String::new(),
    };
    format!(
        "\n## {title}\n\n{picture}{paragraph}\n\n[`{name}`](../../cases/{name}/README.md), [what it gives](validation.md#{name})\n"
    )
}

/// Writes the page where `ARCHARD_PAGES` is set; otherwise says whether it is not current.
pub fn held(folders: &[PathBuf]) -> Option<String> {
    let page = book().join("gallery.md");
    let text: String =
        [HEAD.to_owned()].into_iter().chain(folders.iter().map(|folder| part(folder))).collect();
    if std::env::var_os("ARCHARD_PAGES").is_some() {
        fs::write(&page, text).expect("a page that can be written");
        return None;
    }
    let known = fs::read_to_string(&page).unwrap_or_default();
    (known != text).then(|| "book/src/gallery.md is not current; `just pages`".to_owned())
}
