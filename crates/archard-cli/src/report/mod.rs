//! `archard report`: a run on one page that opens anywhere.
//!
//! The page holds all it needs: its words and tables as HTML, the panels of [`plot`](crate::plot) and the fields of all
//! outputs as numbers, and plotly.js, which draws them. Everything is read from the files of the result folder.

mod figures;
mod maps;
mod page;
mod tables;
mod words;

use std::io::Write;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result, ensure};
use archard::files;
use archard::output::write_whole;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde_json::{Value, json};

use crate::arguments::Report;
use crate::compare::{self, Comparison};
use crate::plot;
use crate::plot::figure::Panel;
use crate::plot::results::Results;
use figures::Figure;
use maps::Maps;
use page::{Table, escape, list, section};
pub(crate) use words::quantity;

/// plotly.js as its package has it, packed.
const PLOTLY: &[u8] = include_bytes!("../../assets/plotly.min.js.gz");
const STYLE: &str = include_str!("../../assets/report.css");
const SCRIPT: &str = include_str!("../../assets/report.js");

/// The name of the page in its folder.
pub const NAME: &str = "report.html";

/// Writes the page of the run in the first folder, beside the runs in the others; returns its file.
///
/// # Errors
/// If a folder is no result folder, the runs cannot be compared, or the page cannot be written.
pub fn run(arguments: &Report) -> Result<PathBuf> {
    let Report { dirs, output, measured, options } = arguments;
    let (dir, others) = dirs.split_first().context("no result folder is named")?;
    ensure!(
        !plot::is_study(dir),
        "`{}` is a study, of which there is no report: draw it with `archard plot`, or report one of its rows",
        dir.display()
    );
    let results = Results::read(dir)?;
    let mut others = others.to_vec();
    others.extend_from_slice(measured);
    let compared = compare::of(dir, &results, &others, options)?;
    let page = Page::of(dir, &results, compared)?.html();
    let path = output.clone().unwrap_or_else(|| dir.join(NAME));
    write_whole(&path, page.as_bytes())?;
    Ok(path)
}

/// What a page shows.
struct Page<'a> {
    dir: &'a Path,
    results: &'a Results,
    /// The case as it was resolved.
    case: String,
    /// Figures under the sections they stand in.
    figures: Vec<(&'static str, &'static str, Vec<Figure>)>,
    maps: Option<Maps>,
    /// Measurements and other runs beside it.
    compared: Vec<Comparison>,
}

impl<'a> Page<'a> {
    fn of(dir: &'a Path, results: &'a Results, compared: Vec<Comparison>) -> Result<Self> {
        let figures = |panels: Vec<Panel>| panels.iter().map(Figure::of).collect();
        let mut all = Vec::new();
        for (id, heading, panels) in plot::groups(results)? {
            all.push((id, heading, figures(panels)));
        }
        let case = files::read_text(&dir.join("case.toml")).unwrap_or_default();
        Ok(Self { dir, results, case, compared, figures: all, maps: maps::of(dir, results)? })
    }

    fn html(&self) -> String {
        let (title, body) = (self.title(), self.sections());
        let beside: Vec<Figure> =
            self.compared.iter().flat_map(|one| &one.panels).map(Figure::of).collect();
        let own = self.figures.iter().flat_map(|(_, _, figures)| figures);
        let figures: Vec<&Figure> = own.chain(&beside).collect();
        let data = json!({
            "figures": figures.iter().map(|figure| json!({ "data": figure.data, "layout": figure.layout })).collect::<Vec<_>>(),
            "maps": self.maps.as_ref().map(|maps| &maps.value),
            "mark": self.results.mark,
        });
        let (data, plotly) = (packed(data.to_string().as_bytes()), STANDARD.encode(PLOTLY));
        format!(
            "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
             <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
             <title>{} \u{2013} Archard</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n\
             <a class=\"skip\" href=\"#main\">To the results</a>\n{}\n<main id=\"main\">\n\
             <noscript><p class=\"mark\">The pictures of this page need JavaScript; words and tables do not.</p></noscript>\n\
             <p id=\"trouble\" class=\"mark\" role=\"alert\" hidden></p>\n{}</main>\n\
             <script type=\"text/plain\" id=\"data\">{data}</script>\n\
             <script type=\"text/plain\" id=\"plotly\">{plotly}</script>\n<script>\n{SCRIPT}</script>\n</body>\n</html>\n",
            escape(&title),
            self.header(&title, &body),
            body,
        )
    }

    /// What the case is called: by its title, or by the folder.
    fn title(&self) -> String {
        let titled = self.results.case.as_ref().and_then(|case| case.title.clone());
        titled.unwrap_or_else(|| {
            let dir = self.dir.canonicalize().unwrap_or_else(|_| self.dir.to_owned());
            dir.file_name()
                .map_or_else(|| "Run".to_owned(), |name| name.to_string_lossy().into_owned())
        })
    }

    /// The top of the page: what was run, whether it can be believed, and what came out.
    fn header(&self, title: &str, body: &str) -> String {
        let summary = &self.results.summary;
        let word = summary["verdict"]["word"].as_str().unwrap_or("not judged");
        let (sign, word) = match (&self.results.mark, word) {
            (Some(mark), _) if mark.starts_with("incomplete") => ("incomplete", "incomplete"),
            (_, "good") => ("good", "good"),
            (_, "doubtful") => ("doubtful", "doubtful"),
            (_, word) => ("wrong", word),
        };
        let mark = self.results.mark.as_ref().map_or_else(String::new, |mark| {
            format!(
                "<p class=\"mark\" role=\"note\"><strong>{}</strong></p>",
                escape(&capital(mark))
            )
        });
        format!(
            "<header>\n<p class=\"program\">Archard {} \u{00b7} contact and wear</p>\n<h1>{}</h1>\n\
             <p class=\"verdict {sign}\">Verdict: <strong>{word}</strong></p>\n{mark}\n{}{}</header>",
            escape(summary["version"].as_str().unwrap_or(env!("CARGO_PKG_VERSION"))),
            escape(title),
            self.first(),
            self.contents(body),
        )
    }

    /// The numbers that are read first.
    fn first(&self) -> String {
        let tile = |[name, value]: &[String; 2]| {
            format!("<div><dt>{}</dt><dd>{}</dd></div>\n", escape(name), escape(value))
        };
        let tiles: String = tables::first(self.results).iter().map(tile).collect();
        format!("<dl class=\"tiles\">\n{tiles}</dl>\n")
    }

    /// Links to the sections that are there.
    fn contents(&self, body: &str) -> String {
        let mut links = vec![("case", "The case"), ("results", "Results")];
        links.extend([("verdict", "Verdict"), ("theory", "Beside theory")]);
        links.extend(self.figures.iter().map(|(id, heading, _)| (*id, *heading)));
        links.push(("beside", "Beside measurements and other runs"));
        if self.maps.is_some() {
            links.push(("maps", "Maps and worn surfaces"));
        }
        links.push(("made", "How it was computed"));
        let there =
            links.into_iter().filter(|(id, _)| body.contains(&format!("<section id=\"{id}\"")));
        let links: String = there
            .map(|(id, heading)| format!("<li><a href=\"#{id}\">{heading}</a></li>\n"))
            .collect();
        format!("<nav aria-label=\"Contents\"><ul>\n{links}</ul></nav>\n")
    }

    fn sections(&self) -> String {
        let results = self.results;
        let mut html = section("case", "The case", &words::case(&self.case));
        let numbers = tables::results(results);
        let note = match numbers.heads.len() {
            2 => "<p>The run states no errors: `archard run --accuracy 1%` does.</p>
"
            .replace('`', ""),
            _ => String::new(),
        };
        html += &section("results", "Results", &(numbers.html() + &note));
        html += &section(
            "verdict",
            "Verdict",
            &(tables::verdict(&results.summary).html() + &self.warnings()),
        );
        html += &section("theory", "Beside theory", &tables::closed_forms(results).html());
        let mut number = 0;
        for (id, heading, figures) in &self.figures {
            let body: String = figures
                .iter()
                .map(|figure| {
                    number += 1;
                    drawn(number, figure)
                })
                .collect();
            html += &section(id, heading, &format!("<div class=\"figures\">\n{body}</div>\n"));
        }
        let mut beside = String::new();
        for Comparison { title, lines, remarks, panels } in &self.compared {
            let rows = lines.iter().map(|line| line.to_vec()).collect();
            let table = Table { caption: title.clone(), heads: vec!["What", "Came out"], rows };
            let figures: String = panels
                .iter()
                .map(|panel| {
                    number += 1;
                    drawn(number, &Figure::of(panel))
                })
                .collect();
            beside += &format!(
                "{}{}<div class=\"figures\">\n{figures}</div>\n",
                table.html(),
                list(remarks)
            );
        }
        html += &section("beside", "Beside measurements and other runs", &beside);
        html += &self.maps.as_ref().map_or_else(String::new, |maps| {
            section("maps", "Maps and worn surfaces", &mapped(maps, results))
        });
        html + &section("made", "How it was computed", &self.made())
    }

    /// What the user was warned of.
    fn warnings(&self) -> String {
        let warnings = self.results.summary["warnings"].as_array().map_or(&[][..], Vec::as_slice);
        let mut words: Vec<String> =
            warnings.iter().filter_map(|one| one.as_str().map(str::to_owned)).collect();
        words.extend(
            self.results.summary["failure"]
                .as_str()
                .map(|cause| format!("The run stopped: {cause}")),
        );
        match words.is_empty() {
            true if self.results.summary.is_null() => String::new(),
            true => "<p>No warnings.</p>\n".to_owned(),
            false => format!("<h3>Warnings</h3>\n{}", list(&words)),
        }
    }

    /// The program, its command and its work.
    fn made(&self) -> String {
        let summary = &self.results.summary;
        let text = |key: &str| summary[key].as_str().map(str::to_owned);
        let number = |key: &str| summary[key].as_f64();
        let version = text("version").map(|version| format!("Archard {version}"));
        let work = number("steps")
            .zip(number("solves"))
            .map(|(steps, solves)| format!("{steps:.0} steps, {solves:.0} contact solves"));
        let time = number("seconds")
            .zip(number("threads"))
            .map(|(seconds, threads)| format!("{seconds:.2} s on {threads:.0} threads"));
        let size = self
            .results
            .image
            .as_ref()
            .map(|image| format!("{} × {}", image.elements[0], image.elements[1]));
        let rows = [
            ("Program", version),
            (
                "Command",
                text("command").map(|command| format!("<code>{}</code>", escape(&command))),
            ),
            ("Work", work),
            ("Time", time),
            ("Elements shown", size),
            (
                "Page written by",
                Some(format!("Archard {}, with plotly.js", env!("CARGO_PKG_VERSION"))),
            ),
        ];
        let rows = rows
            .into_iter()
            .filter_map(|(what, value)| Some(format!("<dt>{what}</dt><dd>{}</dd>\n", value?)));
        let case = match self.case.is_empty() {
            true => String::new(),
            false => format!(
                "<details><summary>The case in SI, as it runs again to the same bits</summary>\n<pre tabindex=\"0\">{}</pre></details>\n",
                escape(&self.case)
            ),
        };
        format!("<dl>\n{}</dl>\n{case}", rows.collect::<String>())
    }
}

/// The place of a figure, with what it shows in words.
fn drawn(number: usize, Figure { title, words, .. }: &Figure) -> String {
    let (title, words) = (escape(title), escape(words));
    format!(
        "<figure>\n<h3>{title}</h3>\n<div class=\"plot\" id=\"figure-{number}\" role=\"img\" aria-label=\"{title}. {words}\"></div>\n\
         <figcaption>{words}</figcaption>\n</figure>\n"
    )
}

/// The place of the maps, with the slider that goes through the outputs.
fn mapped(Maps { value, left_out, resampled }: &Maps, results: &Results) -> String {
    let labels = value["outputs"].as_array().map_or(&[][..], Vec::as_slice);
    let last = labels.len().saturating_sub(1);
    let label = escape(labels.last().and_then(Value::as_str).unwrap_or_default());
    let resampled = match resampled {
        true => {
            "<p>The frame became wider: earlier outputs are shown on the elements of the last, as far as their frame went.</p>\n"
        }
        false => "",
    };
    let left_out = match left_out {
        0 => String::new(),
        left_out => format!(
            "<p>{left_out} outputs in between are left out here; the result folder has them.</p>\n"
        ),
    };
    let slider = format!(
        "<div class=\"slider\"><label for=\"output\">Output</label>\n\
         <input type=\"range\" id=\"output\" min=\"0\" max=\"{last}\" value=\"{last}\" step=\"1\" aria-valuetext=\"{label}\">\n\
         <output id=\"output-label\" for=\"output\">{label}</output></div>\n"
    );
    let figure = |id: &str, title: &str, words: &str| {
        let (title, words) = (escape(title), escape(words));
        format!(
            "<figure>\n<h3>{title}</h3>\n<div class=\"plot map\" id=\"{id}\" role=\"img\" aria-label=\"{title}. {words}\"></div>\n\
             <figcaption>{words}</figcaption>\n</figure>\n"
        )
    };
    let has = |name: &str| !value["fields"][name].is_null();
    let mut stick = String::new();
    if has("stick") {
        stick += " Inside the orange outline the bodies stick, outside it they slip.";
    }
    if has("traction_x_Pa") {
        stick += " Arrows show the traction on body 1, the longest at its largest.";
    }
    let mut html = left_out + resampled + &slider + "<div class=\"figures\">\n";
    html += &figure(
        "map-pressure",
        "Pressure",
        &format!("Pressure over the contact at the output chosen.{stick}"),
    );
    let worn: Vec<usize> =
        (0..results.bodies.len()).filter(|&body| results.has_worn(body)).collect();
    for &body in &worn {
        let name = &results.bodies[body];
        html += &figure(
            &format!("map-wear-{body}"),
            &format!("Wear of {name}"),
            &format!("Depth worn off {name} at the output chosen."),
        );
    }
    html += "</div>\n";
    let shown = worn.first().copied().unwrap_or(0);
    let options: String = results
        .bodies
        .iter()
        .enumerate()
        .map(|(index, name)| {
            let selected = if index == shown { " selected" } else { "" };
            format!("<option value=\"{index}\"{selected}>{}</option>", escape(name))
        })
        .collect();
    html += &format!(
        "<div class=\"slider\"><label for=\"body\">Surface of</label> <select id=\"body\">{options}</select>\n\
         <span role=\"group\" aria-label=\"View\"><button type=\"button\" data-view=\"aslant\">Aslant</button>\
         <button type=\"button\" data-view=\"above\">From above</button>\
         <button type=\"button\" data-view=\"side\">From the side</button></span></div>\n"
    );
    let colours =
        if worn.is_empty() { "colours are heights" } else { "colours are the depth worn off" };
    html + &figure(
        "surface",
        "Surface",
        &format!(
            "The surface of a body at the output chosen, heights enlarged; {colours}. Drag to turn it, or use the arrow keys."
        ),
    )
}

fn capital(text: &str) -> String {
    let mut letters = text.chars();
    let first = letters.next().map(|first| first.to_uppercase().to_string()).unwrap_or_default();
    first + letters.as_str()
}

/// Bytes, compressed, as text.
fn packed(bytes: &[u8]) -> String {
    let mut encoder = GzEncoder::new(Vec::new(), Compression::default());
    let written = encoder.write_all(bytes).and_then(|()| encoder.finish());
    // Memory takes all that is written to it.
    STANDARD.encode(written.unwrap_or_default())
}
