//! A page in HTML: its document, and the pieces it is made of.

use std::io::{Read, Write};
use std::path::Path;
use std::time::Duration;

use anyhow::{Result, anyhow};
use archard_case::output::{Error, Place};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::read::GzDecoder;
use flate2::write::GzEncoder;
use serde_json::Value;
use sha2::{Digest, Sha256};

use super::html::{Html, fill};

/// plotly.js as its package has it, packed.
const PLOTLY: &[u8] = include_bytes!("../../assets/plotly.min.js.gz");
const STYLE: &str = include_str!("../../assets/report.css");
const SCRIPT: &str = include_str!("../../assets/report.js");

/// What every page begins with, and nothing else does.
const START: &str = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
                     <meta name=\"generator\" content=\"Archard\">\n";

/// Most columns of a table: more cannot be read on a telephone.
const COLUMNS: usize = 3;

/// A page.
pub(super) struct Page {
    pub(super) title: String,
    pub(super) header: Html,
    pub(super) body: Html,
    /// What the script draws, where there is anything to draw.
    pub(super) drawings: Option<Value>,
}

/// A table: what it shows, the heads of its columns, and its rows; the first cell of a row names it.
#[derive(Debug, Clone)]
pub(super) struct Table {
    pub(super) caption: String,
    pub(super) heads: Vec<&'static str>,
    pub(super) rows: Vec<Vec<String>>,
}

impl Page {
    /// The whole document. Its policy runs the program's own two scripts, known by their digests, and nothing else; it fetches
    /// nothing from anywhere. Where a time is given, the browser reads it again after that.
    fn document(&self, reload: Option<Duration>) -> String {
        let reload = reload.map_or_else(Html::default, |time| {
            let seconds = time.as_secs_f64().ceil() as usize;
            fill("<meta http-equiv=\"refresh\" content=\"{}\">\n", &[&seconds])
        });
        let scripts = match &self.drawings {
            Some(drawings) => fill(
                "<script type=\"text/plain\" id=\"data\">{}</script>\n\
                 <script type=\"text/plain\" id=\"plotly\">{}</script>\n<script>{}</script>\n",
                &[
                    &Html::packed(&packed(drawings.to_string().as_bytes())),
                    &Html::packed(PLOTLY),
                    &Html::constant(SCRIPT),
                ],
            ),
            None => Html::default(),
        };
        let document = fill(
            "<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n{}\
             <title>{} \u{2013} Archard</title>\n<style>\n{}</style>\n</head>\n<body>\n\
             <a class=\"skip\" href=\"#main\">To the results</a>\n{}\n<main id=\"main\">\n\
             <p id=\"trouble\" class=\"mark\" role=\"alert\" hidden></p>\n{}</main>\n{}</body>\n</html>\n",
            &[
                &policy(self.drawings.is_some()),
                &reload,
                &self.title,
                &Html::constant(STYLE),
                &self.header,
                &self.body,
                &scripts,
            ],
        );
        format!("{START}{}", document.as_str())
    }

    /// Writes the document, in the place of nothing or of another page of this program.
    ///
    /// # Errors
    /// If something else is there, or it cannot be written.
    pub(super) fn write(&self, path: &Path, reload: Option<Duration>) -> Result<()> {
        let place = Place::free_or(path, |known| known.starts_with(START.as_bytes()));
        let place = place.map_err(|error| match error {
            Error::NotOurs { path, .. } => anyhow!(
                "`{}` is there, and is no page of this program: choose another file, or remove it",
                path.display()
            ),
            error => error.into(),
        })?;
        Ok(place.write(self.document(reload).as_bytes())?)
    }
}

/// What the browser may do with the page. Plotly places its parts by `style` attributes, which run nothing, and shows its maps
/// and pictures as `data:` and `blob:` images.
fn policy(draws: bool) -> String {
    let mut plotly = Vec::new();
    // A packed file of the program itself.
    let _ = GzDecoder::new(PLOTLY).read_to_end(&mut plotly);
    let digest = |text: &[u8]| format!("'sha256-{}'", STANDARD.encode(Sha256::digest(text)));
    let scripts = match draws {
        true => format!("{} {}", digest(SCRIPT.as_bytes()), digest(&plotly)),
        false => "'none'".to_owned(),
    };
    format!(
        "default-src 'none'; script-src {scripts}; style-src 'unsafe-inline'; img-src data: blob:; \
         base-uri 'none'; form-action 'none'"
    )
}

/// Bytes, compressed.
fn packed(bytes: &[u8]) -> Vec<u8> {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    // Memory takes all that is written to it.
    written.unwrap_or_default()
}

/// The top of a page: what it is about, whether it can be believed, what is read first next to a picture, and the contents.
pub(super) struct Header<'a> {
    /// What the page is about: "contact and wear".
    pub(super) about: &'static str,
    pub(super) version: &'a str,
    pub(super) title: &'a str,
    /// What was tested: names and words.
    pub(super) facts: Vec<(String, String)>,
    /// The colour of the verdict and its words.
    pub(super) verdict: (&'static str, String),
    /// What has to be said at once.
    pub(super) mark: Option<String>,
    /// The outcome in a sentence or two.
    pub(super) lead: Vec<String>,
    /// Name, value and error of a few numbers.
    pub(super) tiles: Vec<[String; 3]>,
    pub(super) picture: Html,
}

impl Header<'_> {
    /// The header, with links to the sections that are there.
    pub(super) fn html(&self, sections: &[(&'static str, &'static str)]) -> Html {
        let Self { about, version, title, verdict: (sign, word), .. } = self;
        let mark = |text: &String| {
            fill("<p class=\"mark\" role=\"note\"><strong>{}</strong></p>\n", &[&capital(text)])
        };
        let lead = |text: &String| fill("<p class=\"lead\">{}</p>\n", &[text]);
        let tile = |[name, value, error]: &[String; 3]| {
            let error = match error.is_empty() {
                true => Html::default(),
                false => fill(" <span class=\"error\">{}</span>", &[error]),
            };
            fill("<div><dt>{}</dt><dd>{}{}</dd></div>\n", &[name, value, &error])
        };
        let link = |(id, heading): &(&'static str, &'static str)| {
            fill("<li><a href=\"#{}\">{}</a></li>\n", &[id, heading])
        };
        let words: Html = self.mark.iter().map(mark).chain(self.lead.iter().map(lead)).collect();
        let tiles: Html = self.tiles.iter().map(tile).collect();
        let fact =
            |(name, words): &(String, String)| fill("<dt>{}</dt><dd>{}</dd>\n", &[name, words]);
        let facts: Html = self.facts.iter().map(fact).collect();
        let facts = match self.facts.is_empty() {
            true => Html::default(),
            false => fill("<dl class=\"facts\">\n{}</dl>\n", &[&facts]),
        };
        let links: Html = sections.iter().map(link).collect();
        fill(
            "<header>\n<p class=\"program\">Archard {} \u{00b7} {}</p>\n<h1>{}</h1>\n\
             <p class=\"verdict {}\">Verdict: <strong>{}</strong></p>\n<div class=\"first\"><div>\n{}<dl class=\"tiles\">\n{}</dl>\n{}\
             </div>{}</div>\n<nav aria-label=\"Contents\"><ul>\n{}</ul></nav>\n</header>",
            &[version, about, title, sign, word, &words, &tiles, &facts, &self.picture, &links],
        )
    }
}

/// Sections of a page, each with its heading.
#[derive(Debug, Default)]
pub(super) struct Sections {
    pub(super) html: Html,
    /// The name and the heading of each.
    pub(super) there: Vec<(&'static str, &'static str)>,
}

impl Sections {
    /// Adds a section, unless there is nothing in it.
    pub(super) fn add(&mut self, id: &'static str, heading: &'static str, body: &Html) {
        if body.is_empty() {
            return;
        }
        self.there.push((id, heading));
        self.html += fill(
            "<section id=\"{}\" aria-labelledby=\"{}-h\"><h2 id=\"{}-h\">{}</h2>\n{}</section>\n",
            &[&id, &id, &id, &heading, body],
        );
    }
}

impl Table {
    /// The table in HTML; cells are text. Nothing where it has no rows, and no column without any cell that says something.
    pub(super) fn html(&self) -> Html {
        debug_assert!(self.heads.len() <= COLUMNS, "{}", self.caption);
        if self.rows.is_empty() {
            return Html::default();
        }
        let says = |place: usize| {
            let mut cells = self.rows.iter().filter_map(|row| row.get(place));
            place == 0 || cells.any(|cell| !cell.is_empty())
        };
        let head = |head: &&'static str| fill("<th scope=\"col\">{}</th>", &[head]);
        let cell = |(place, cell): (usize, &String)| match place {
            0 => fill("<th scope=\"row\">{}</th>", &[cell]),
            _ => fill("<td>{}</td>", &[cell]),
        };
        let row = |row: &Vec<String>| {
            let shown = row.iter().enumerate().filter(|(place, _)| says(*place));
            let cells: Html = shown.map(cell).collect();
            fill("<tr>{}</tr>\n", &[&cells])
        };
        let shown = self.heads.iter().enumerate().filter(|(place, _)| says(*place));
        let heads: Html = shown.map(|(_, name)| head(name)).collect();
        let rows: Html = self.rows.iter().map(row).collect();
        fill(
            "<div class=\"wide\" tabindex=\"0\" role=\"region\" aria-label=\"{}\"><table><caption>{}</caption><thead><tr>{}</tr></thead>\
             <tbody>\n{}</tbody></table></div>\n",
            &[&self.caption, &self.caption, &heads, &rows],
        )
    }
}

/// A list of paragraphs of text.
pub(super) fn list(items: &[String]) -> Html {
    if items.is_empty() {
        return Html::default();
    }
    let items: Html = items.iter().map(|item| fill("<li>{}</li>\n", &[item])).collect();
    fill("<ul>\n{}</ul>\n", &[&items])
}

/// Names with what they stand for.
pub(super) fn definitions(rows: &[(&'static str, String)]) -> Html {
    let row =
        |(what, value): &(&'static str, String)| fill("<dt>{}</dt><dd>{}</dd>\n", &[what, value]);
    let rows: Html = rows.iter().map(row).collect();
    if rows.is_empty() { rows } else { fill("<dl>\n{}</dl>\n", &[&rows]) }
}

/// Text with a capital at its start.
pub(super) fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|first| first.to_uppercase().to_string()).unwrap_or_default();
    first + letters.as_str()
}

#[cfg(test)]
mod tests {
    use super::{Page, Table};
    use crate::report::html::{Html, fill};

    #[test]
    fn names_cannot_leave_their_cells() {
        let table = Table {
            caption: "a < b".to_owned(),
            heads: vec!["what"],
            rows: vec![vec!["</td><script>".to_owned()]],
        };
        let html = table.html();
        let html = html.as_str();
        assert!(html.contains("<caption>a &lt; b</caption>"), "{html}");
        assert!(html.contains("<th scope=\"row\">&lt;/td&gt;&lt;script&gt;</th>"), "{html}");
        assert_eq!(Table { rows: vec![], ..table }.html(), Html::default());
    }

    #[test]
    fn columns_that_say_nothing_are_left_out() {
        let rows = [["A", "1", ""], ["B", "2", ""]].map(|row| row.map(str::to_owned).to_vec());
        let heads = vec!["Test", "Coefficient", "95 % interval"];
        let html = Table { caption: "all".to_owned(), heads, rows: rows.to_vec() }.html();
        let html = html.as_str();
        assert!(html.contains("Coefficient") && !html.contains("interval"), "{html}");
        assert!(!html.contains("<td></td>"), "{html}");
    }

    #[test]
    fn a_page_without_drawings_allows_no_script() {
        let page = Page {
            title: "</title><script>".to_owned(),
            header: Html::default(),
            body: fill("<p>{}</p>", &[&"<b>"]),
            drawings: None,
        };
        let document = page.document(None);
        assert!(document.contains("script-src &#39;none&#39;"), "{document}");
        assert!(!document.contains("<script"), "{document}");
        assert!(document.contains("<p>&lt;b&gt;</p>"), "{document}");
    }
}
