//! The gallery of the book: the picture of every case, under the question that it answers.

use std::fs;
use std::path::{Path, PathBuf};

use toml::de::{DeTable, DeValue};

/// What the page begins with.
const HEAD: &str = "\
# Gallery

Every case of the repository. A picture leads to itself in full, a title to the page of the case, *numbers* to its source. `archard new NAME` writes a case
out to start from; NAME is in the address of its page. `just pages` writes this page, `just gallery` the pictures.
";

fn book() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../book/src")
}

/// The text of a list next to the pictures.
fn list(name: &str) -> String {
    fs::read_to_string(book().join("gallery").join(name)).expect("a list")
}

/// The elements of a list in a table.
fn elements<'a>(table: &'a DeTable<'_>, key: &str) -> Vec<&'a DeValue<'a>> {
    let list = table.get(key).and_then(|own| own.get_ref().as_array());
    let list = list.unwrap_or_else(|| panic!("questions.toml has no list `{key}`"));
    list.iter().map(|own| own.get_ref()).collect()
}

/// The questions, each with its cases.
fn questions() -> Vec<(String, Vec<String>)> {
    let list = list("questions.toml");
    let all = DeTable::parse(&list).expect("a list in TOML");
    let text = |own: &DeValue<'_>| own.as_str().expect("a text").to_owned();
    let one = |own: &DeValue<'_>| {
        let own = own.as_table().expect("a question");
        let asks = text(own.get("asks").expect("what it asks").get_ref());
        (asks, elements(own, "cases").into_iter().map(text).collect())
    };
    elements(all.get_ref(), "question").into_iter().map(one).collect()
}

/// A case: a small picture, its title, and where its numbers are.
fn thumbnail(name: &str, seen: &DeTable<'_>) -> String {
    let path = format!("../../cases/{name}/README.md");
    let about = fs::read_to_string(book().join(&path)).expect("a README.md");
    let title = about.lines().next().and_then(|line| line.strip_prefix("# ")).expect("a title");
    let case = seen.get(name).and_then(|case| case.get_ref().as_table());
    let text = case.and_then(|case| case.get("seen")?.get_ref().as_str());
    let text = text.unwrap_or_else(|| {
        panic!("gallery/seen.toml has to say what is seen in the picture of `{name}`")
    });
    let text = text.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    format!(
        "- <a href=\"gallery/{name}.png\"><img src=\"gallery/{name}.png\" width=\"260\" alt=\"{text}\"></a>\n  \
         [{title}]({path}), [numbers](validation.md#{name})\n"
    )
}

/// The page of these cases.
fn page(folders: &[PathBuf]) -> String {
    let (questions, seen) = (questions(), list("seen.toml"));
    let seen = DeTable::parse(&seen).expect("a list in TOML");
    let mut asked: Vec<&String> = questions.iter().flat_map(|(_, cases)| cases).collect();
    asked.sort();
    let known: Vec<_> =
        folders.iter().map(|own| own.file_name().unwrap().to_str().unwrap()).collect();
    assert_eq!(asked, known, "gallery/questions.toml has each case once");
    let part = |(asks, cases): &(String, Vec<String>)| {
        let shown: String = cases.iter().map(|name| thumbnail(name, seen.get_ref())).collect();
        format!("\n## {asks}\n\n{shown}")
    };
    [HEAD.to_owned()].into_iter().chain(questions.iter().map(part)).collect()
}

/// Writes the page where `ARCHARD_PAGES` is set; otherwise says whether it is not current.
pub fn held(folders: &[PathBuf]) -> Option<String> {
    let (place, text) = (book().join("gallery.md"), page(folders));
    if std::env::var_os("ARCHARD_PAGES").is_some() {
        fs::write(&place, text).expect("a page that can be written");
        return None;
    }
    let known = fs::read_to_string(&place).unwrap_or_default();
    (known != text).then(|| "book/src/gallery.md is not current; `just pages`".to_owned())
}
