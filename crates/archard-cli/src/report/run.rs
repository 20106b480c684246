//! The page about a run.

use std::path::Path;

use anyhow::Result;
use archard_case::files;
use serde_json::{Value, json};

use super::figures::{Figure, drawn};
use super::html::{Html, fill};
use super::maps::{self, Maps};
use super::page::{Header, Page, Sections, Table, definitions, list};
use super::{closed_forms, name_of, stress, tables, words};
use crate::compare::Comparison;
use crate::number::of_a_line;
use crate::plot;
use crate::plot::figure::Panel;
use crate::plot::results::Results;

/// What a page shows.
struct Run<'a> {
    dir: &'a Path,
    results: &'a Results,
    /// The case as it was resolved.
    case: String,
    /// Figures under the sections they stand in.
    figures: Vec<(&'static str, &'static str, Vec<Figure>)>,
    maps: Option<Maps>,
    /// Measurements and other runs, and the figures of each.
    compared: Vec<(Comparison, Vec<Figure>)>,
}

/// The page of a run, compared with measurements and other runs.
pub(super) fn page(dir: &Path, results: &Results, compared: Vec<Comparison>) -> Result<Page> {
    let figures = |panels: &[Panel]| panels.iter().map(Figure::of).collect::<Result<Vec<_>>>();
    let mut all = Vec::new();
    for (id, heading, panels) in plot::groups(results)? {
        all.push((id, heading, figures(&panels)?));
    }
    let with = |one: Comparison| {
        let own = figures(&one.panels)?;
        Ok((one, own))
    };
    let case = files::read_text(&dir.join("case.toml")).unwrap_or_default();
    let compared = compared.into_iter().map(with).collect::<Result<Vec<_>>>()?;
    let run = Run { dir, results, case, figures: all, maps: maps::of(dir, results)?, compared };
    Ok(run.page())
}

impl Run<'_> {
    fn page(&self) -> Page {
        let (title, sections) = (self.title(), self.sections());
        let header = self.header(&title, &sections);
        let of_others = self.compared.iter().flat_map(|(_, figures)| figures);
        let own = self.figures.iter().flat_map(|(_, _, figures)| figures);
        let figures: Vec<Value> = own.chain(of_others).map(Figure::json).collect();
        let maps = self.maps.as_ref().map(|maps| &maps.value);
        let data = json!({ "figures": figures, "maps": maps, "mark": self.results.mark });
        Page { title, header, body: sections.html, drawings: Some(data) }
    }

    /// What the case is called: by its title, or by the folder.
    fn title(&self) -> String {
        let titled = self.results.case.as_ref().and_then(|case| case.title.clone());
        titled.unwrap_or_else(|| name_of(self.dir))
    }

    /// The top of the page: what was run, whether it can be believed, and what came out.
    fn header(&self, title: &str, sections: &Sections) -> Html {
        let summary = &self.results.summary;
        let word = summary["verdict"]["word"].as_str().unwrap_or("not judged");
        let (sign, word) = match (&self.results.mark, word) {
            (Some(mark), _) if mark.starts_with("incomplete") => ("incomplete", "incomplete"),
            (_, "good") => ("good", "good"),
            (_, "doubtful") => ("doubtful", "doubtful"),
            (_, word) => ("wrong", word),
        };
        let header = Header {
            about: "contact and wear",
            version: summary["version"].as_str().unwrap_or(env!("CARGO_PKG_VERSION")),
            title,
            facts: words::facts(&self.case),
            verdict: (sign, word.to_owned()),
            mark: self.results.mark.clone(),
            lead: Vec::new(),
            tiles: tables::first(self.results),
            picture: self.first_picture(),
        };
        header.html(&sections.there)
    }

    /// The figure that is seen first: the first curve, or a map where none exists.
    fn first_picture(&self) -> Html {
        let curves = self.figures.iter().flat_map(|(_, _, figures)| figures);
        let maps = self.maps.iter().flat_map(|maps| maps.pictures.iter().map(|(_, map)| map));
        curves.chain(maps).next().map_or_else(Html::default, Figure::small)
    }

    fn sections(&self) -> Sections {
        let results = self.results;
        let mut all = Sections::default();
        let numbers = tables::results(results);
        let note = match numbers.heads.len() {
            2 => Html::constant(
                "<p>The run states no errors: <code>archard run --accuracy 1%</code> does.</p>\n",
            ),
            _ => Html::default(),
        };
        let line = results.case.as_ref().map(|case| &case.frame).filter(|frame| frame.line);
        let line = line.map_or_else(Html::default, |frame| {
            fill("<p>The contact is a line: {}.</p>\n", &[&of_a_line(frame.size[1])])
        });
        all.add("results", "Results", &(numbers.html() + line + note));
        all.add("stresses", "Stresses below the surface", &stress::table(results).html());
        let judged = tables::verdict(&results.summary).html() + self.warnings();
        all.add("verdict", "Verdict", &judged);
        let mut number = 0;
        let mut put = |figures: &[Figure]| {
            let all: Html = figures
                .iter()
                .map(|figure| {
                    number += 1;
                    drawn(&format!("figure-{number}"), figure)
                })
                .collect();
            match all.is_empty() {
                true => all,
                false => fill("<div class=\"figures\">\n{}</div>\n", &[&all]),
            }
        };
        for (id, heading, figures) in &self.figures {
            all.add(id, heading, &put(figures));
        }
        let theory = closed_forms::closed_forms(results).html();
        all.add("theory", "Compared with theory", &theory);
        let one = |(one, figures): &(Comparison, Vec<_>)| {
            let rows = one.told().iter().map(|line| line.to_vec()).collect();
            let caption = one.title.clone();
            let table = Table { caption, heads: vec!["Quantity", "Result"], rows };
            table.html() + list(&one.remarks()) + put(figures)
        };
        let compared: Html = self.compared.iter().map(one).collect();
        all.add("compared", "Compared with measurements and other runs", &compared);
        if let Some(maps) = &self.maps {
            all.add("maps", "Maps and worn surfaces", &mapped(maps, results));
        }
        all.add("case", "The case", &words::case(&self.case));
        all.add("made", "How it was computed", &self.made());
        all
    }

    /// What the user was warned of.
    fn warnings(&self) -> Html {
        let warnings = self.results.summary["warnings"].as_array().map_or(&[][..], Vec::as_slice);
        let mut words: Vec<String> =
            warnings.iter().filter_map(|one| one.as_str().map(str::to_owned)).collect();
        let failure = self.results.summary["failure"].as_str();
        words.extend(failure.map(|cause| format!("The run stopped: {cause}")));
        match words.is_empty() {
            true if self.results.summary.is_null() => Html::default(),
            true => Html::constant("<p>No warnings.</p>\n"),
            false => Html::constant("<h3>Warnings</h3>\n") + list(&words),
        }
    }

    /// The program, its command and its work.
    fn made(&self) -> Html {
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
        let image = self.results.image.as_ref();
        let size = image.map(|image| format!("{} × {}", image.elements[0], image.elements[1]));
        let page = format!("Archard {}, with plotly.js", env!("CARGO_PKG_VERSION"));
        let rows = [
            ("Program", version),
            ("Command", text("command")),
            ("Work", work),
            ("Time", time),
            ("Elements shown", size),
            ("Page written by", Some(page)),
        ];
        let rows: Vec<_> =
            rows.into_iter().filter_map(|(what, value)| Some((what, value?))).collect();
        let case = match self.case.is_empty() {
            true => Html::default(),
            false => fill(
                "<details><summary>The case in SI, as it runs again to the same bits</summary>\n<pre tabindex=\"0\">{}</pre></details>\n",
                &[&self.case],
            ),
        };
        definitions(&rows) + case
    }
}

/// The place of the maps, with the slider that goes through the outputs.
fn mapped(maps: &Maps, results: &Results) -> Html {
    let Maps { value, left_out, resampled, .. } = maps;
    let labels = value["outputs"].as_array().map_or(&[][..], Vec::as_slice);
    let last = labels.len().saturating_sub(1);
    let label = labels.last().and_then(Value::as_str).unwrap_or_default();
    let mut html = match left_out {
        0 => Html::default(),
        left_out => fill(
            "<p>{} outputs in between are left out here; the result folder has them.</p>\n",
            &[left_out],
        ),
    };
    if *resampled {
        html += Html::constant(
            "<p>The frame became wider: earlier outputs are shown on the elements of the last, as far as their frame went.</p>\n",
        );
    }
    html += fill(
        "<div class=\"slider scripted\"><label for=\"output\">Output</label>\n\
         <input type=\"range\" id=\"output\" min=\"0\" max=\"{}\" value=\"{}\" step=\"1\" aria-valuetext=\"{}\">\n\
         <output id=\"output-label\" for=\"output\">{}</output></div>\n",
        &[&last, &last, &label, &label],
    );
    let pictures: Html = maps.pictures.iter().map(|(id, map)| drawn(id, map)).collect();
    html += fill("<div class=\"figures\">\n{}</div>\n", &[&pictures]);
    html + solid(results)
}

/// The place of the surface that is turned.
fn solid(results: &Results) -> Html {
    let worn = (0..results.bodies.len()).find(|&body| results.has_worn(body));
    let option = |(index, name): (usize, &String)| {
        let selected = if index == worn.unwrap_or(0) { " selected" } else { "" };
        fill("<option value=\"{}\"{}>{}</option>", &[&index, &selected, name])
    };
    let options: Html = results.bodies.iter().enumerate().map(option).collect();
    let colours =
        if worn.is_none() { "colours are heights" } else { "colours are the depth worn off" };
    let words = format!(
        "The surface of a body at the output chosen, heights enlarged; {colours}. Drag to turn it, or use the arrow keys."
    );
    fill(
        "<div class=\"scripted\">\n<div class=\"slider\"><label for=\"body\">Surface of</label> <select id=\"body\">{}</select>\n\
         <span role=\"group\" aria-label=\"View\"><button type=\"button\" data-view=\"tilted\">Tilted</button>\
         <button type=\"button\" data-view=\"above\">From above</button>\
         <button type=\"button\" data-view=\"side\">From the side</button></span></div>\n\
         <figure class=\"drawn\">\n<h3>Surface</h3>\n\
         <div class=\"plot map\" id=\"surface\" role=\"img\" aria-label=\"Surface. {}\"></div>\n\
         <figcaption>{}</figcaption>\n</figure>\n</div>\n",
        &[&options, &words, &words],
    )
}
