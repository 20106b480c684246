//! `archard report`: the page, read as text and in a browser.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use tempfile::TempDir;

use super::browser::Page;
use super::{archard, case, hostile, printed, said};

/// Runs a case with settings, and more options.
fn run(dir: &TempDir, name: &str, settings: &[&str], more: &[&str]) {
    let case = case(name);
    let mut arguments = vec!["run", case.to_str().unwrap(), "-o", name];
    settings.iter().for_each(|setting| arguments.extend(["--set", setting]));
    archard(dir, &[&arguments[..], more].concat()).success();
}

/// Runs a case with settings and reports it; the page.
fn reported(dir: &TempDir, name: &str, settings: &[&str]) -> PathBuf {
    run(dir, name, settings, &["--report"]);
    dir.path().join(name).join("report.html")
}

const PIN: [&str; 2] = ["frame.elements=[24, 24]", "motion.sliding.step=10 mm"];

#[test]
fn the_page_has_case_verdict_theory_and_command() {
    let dir = TempDir::new().unwrap();
    let page = fs::read_to_string(reported(&dir, "pin_on_disc", &PIN)).unwrap();
    assert!(page.len() < 5_000_000, "{} bytes", page.len());
    for part in [
        "<html lang=\"en\">",
        "<h1>Pin on disc: the pin wears</h1>",
        "profile</b>: sphere, radius 50 mm",
        "elements across the contact",
        "Content-Security-Policy",
        "sphere worn flat, no elasticity",
        "Worn volume of pin",
        "archard run",
        "--report",
        "<caption>",
    ] {
        assert!(page.contains(part), "{part}");
    }
    for source in ["<script src", "<link", "@import", "url("] {
        let words = page.split("<script type=\"text/plain\"").next().unwrap();
        assert!(!words.contains(source), "{source}");
    }
}

#[test]
fn folders_without_results_are_refused() {
    let dir = TempDir::new().unwrap();
    fs::create_dir(dir.path().join("empty")).unwrap();
    let refused = archard(&dir, &["report", "empty"]).code(2);
    assert!(said(&refused).contains("`empty` is not a result folder"), "{}", said(&refused));
    archard(&dir, &["report"]).code(2);
}

#[test]
#[ignore = "long: in .ci/long"]
fn a_page_replaces_no_other_file() {
    let dir = TempDir::new().unwrap();
    run(&dir, "pin_on_disc", &PIN, &["--report"]);
    archard(&dir, &["report", "pin_on_disc"]).success();
    for mine in ["notes", "<!DOCTYPE html>\n<title>Notes</title>", ""] {
        let file = dir.path().join("notes.html");
        fs::write(&file, mine).unwrap();
        let refused = archard(&dir, &["report", "pin_on_disc", "-o", "notes.html"]).code(2);
        let words = said(&refused);
        assert!(words.contains("`notes.html` is there, and is no page of this program"), "{words}");
        assert_eq!(fs::read_to_string(file).unwrap(), mine);
    }
}

#[test]
fn an_incomplete_run_says_so_at_the_top() {
    let dir = TempDir::new().unwrap();
    run(&dir, "pin_on_disc", &PIN, &[]);
    fs::remove_file(dir.path().join("pin_on_disc/summary.json")).unwrap();
    let said = archard(&dir, &["report", "pin_on_disc", "-o", "page.html"]).success();
    assert_eq!(printed(&said).trim(), "page.html");
    let page = fs::read_to_string(dir.path().join("page.html")).unwrap();
    let header = page.split("</header>").next().unwrap();
    assert!(header.contains("Incomplete: the run has not ended"));
    assert!(header.contains("Verdict: <strong>incomplete</strong>"));
}

#[test]
fn other_runs_stand_beside_the_first() {
    let dir = TempDir::new().unwrap();
    run(&dir, "pin_on_disc", &PIN, &[]);
    run(&dir, "pin_on_disc_both", &PIN, &[]);
    archard(&dir, &["report", "pin_on_disc", "pin_on_disc_both"]).success();
    let page = fs::read_to_string(dir.path().join("pin_on_disc/report.html")).unwrap();
    assert!(page.contains("compared with other runs"));
}

/// Every place of a plot, and whether something was drawn in it.
const PLOTS: &str = "Array.from(document.querySelectorAll('.plot')).map((place) => \
    [place.id, place.querySelectorAll('.plotly svg, .plotly canvas').length > 0 && place.getBoundingClientRect().width > 0])";

/// What a screen reader, a keyboard and a reader of small screens need; what is missing, in words.
const ACCESS: &str = "(() => { const missing = []; \
    const all = (what) => Array.from(document.querySelectorAll(what)); \
    const luminance = (colour) => { const parts = colour.match(/[\\d.]+/g).slice(0, 3).map((part) => { const c = part / 255; \
      return c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4; }); return 0.2126 * parts[0] + 0.7152 * parts[1] + 0.0722 * parts[2]; }; \
    const ground = (place) => { for (let up = place; up; up = up.parentElement) { const colour = getComputedStyle(up).backgroundColor; \
      if (!/rgba\\(.*, 0\\)/.test(colour)) return colour; } return 'rgb(255, 255, 255)'; }; \
    for (const place of all('main *, header *')) { if (place.closest('.plot') || !Array.from(place.childNodes).some((one) => one.nodeType === 3 && one.textContent.trim())) continue; \
      const [one, other] = [luminance(getComputedStyle(place).color), luminance(ground(place))]; \
      const contrast = (Math.max(one, other) + 0.05) / (Math.min(one, other) + 0.05); \
      if (contrast < 4.5) missing.push('contrast ' + contrast.toFixed(2) + ' of ' + place.outerHTML.slice(0, 80)); } \
    if (!document.documentElement.lang) missing.push('lang'); if (!document.title) missing.push('title'); \
    if (all('h1').length !== 1 || all('main').length !== 1) missing.push('one h1, one main'); \
    let level = 1; for (const heading of all('h1, h2, h3, h4')) { const next = Number(heading.tagName[1]); if (next > level + 1) missing.push('level of ' + heading.textContent); level = next; } \
    for (const table of all('table')) { if (!table.caption || !table.querySelector('th[scope=col]')) missing.push('caption or heads of a table'); } \
    for (const control of all('input, select')) { if (!control.labels.length) missing.push('label of ' + control.id); } \
    for (const picture of all('.plot')) { if ((picture.getAttribute('aria-label') || '').length < 20) missing.push('words for ' + picture.id); } \
    for (const picture of all('img')) { if (!picture.alt) missing.push('alt of an img'); } \
    const ids = all('[id]').filter((one) => !one.closest('.plot .plotly')).map((one) => one.id); if (new Set(ids).size !== ids.length) missing.push('an id twice'); \
    return missing; })()";

/// What is wider than the page.
const WIDE: &str = "Array.from(document.querySelectorAll('body *')).filter((one) => !one.closest('.wide, pre, .plot') && \
    getComputedStyle(one).position !== 'absolute' && one.getBoundingClientRect().right > document.documentElement.clientWidth + 1).map((one) => one.outerHTML.slice(0, 80))";

/// Moves the slider to an output; what it says and how high the pressures are that are drawn then.
fn slid(page: &mut Page, output: usize) -> Value {
    page.value(&format!(
        "new Promise((done) => {{ const slider = document.getElementById('output'); slider.value = '{output}'; \
         slider.dispatchEvent(new Event('input')); const look = () => document.body.dataset.output === '{output}' ? \
         done([document.getElementById('output-label').textContent, Math.max(...document.getElementById('map-pressure').data[0].z.flat().filter((p) => p !== null))]) : \
         setTimeout(look, 30); look(); }})"
    ))
}

/// Waits until every plot is as wide as its place, also after that has changed.
const FITS: &str = "new Promise((done) => { const wide = (one) => one.getBoundingClientRect().width; \
    const look = () => Array.from(document.querySelectorAll('.plot')).every((place) => \
    Math.abs(wide(place.querySelector('.main-svg')) - wide(place)) < 2) ? done(true) : setTimeout(look, 30); look(); })";

/// On a screen and on a telephone (px).
const SCREEN: u32 = 1280;
const NARROW: u32 = 390;

/// Opens a page at a width and makes it another one; the pictures it has, by their number.
fn look(page: &mut Page, file: &Path, name: &str, widths: [u32; 2]) -> usize {
    page.resize(widths[0]);
    page.visit(file);
    let mut count = 0;
    for width in widths {
        page.resize(width);
        assert_eq!(page.value(FITS), json!(true));
        let plots = page.value(PLOTS);
        let plots = plots.as_array().unwrap();
        count = plots.len();
        for plot in plots {
            assert_eq!(plot[1], json!(true), "{name} at {width}: {} is blank", plot[0]);
        }
        assert_eq!(page.value(ACCESS), json!([]), "{name} at {width}");
        assert_eq!(page.value(WIDE), json!([]), "{name} at {width}");
        let columns = "Math.max(0, ...Array.from(document.querySelectorAll('tr')).map((row) => row.children.length))";
        assert!(page.value(columns).as_u64().unwrap() <= 3, "{name} has a table of more columns");
        if width == SCREEN {
            let lowest =
                "Math.round(document.querySelector('.glance img').getBoundingClientRect().bottom)";
            assert!(
                page.value(lowest).as_u64().unwrap() < 900,
                "{name}: no picture on the first screen"
            );
        }
        page.picture(&format!("{name}-{width}"));
    }
    assert_eq!(page.complaints, Vec::<String>::new(), "{name}");
    count
}

#[test]
#[ignore = "long: in .ci/long"]
fn pages_of_all_motions_open_in_a_browser() {
    let Some(mut page) = Page::open() else { return };
    let dir = TempDir::new().unwrap();
    // That of a pin on a disc is opened by `the_slider_goes_through_the_outputs`.
    let runs: [(&str, &[&str], usize); 6] = [
        ("hertz", &["frame.elements=[24, 24]"], 3),
        ("cattaneo_mindlin", &["frame.elements=[24, 24]"], 6),
        ("twin_disc", &["frame.elements=[21, 41]"], 10),
        ("mccoll_fretting", &[], 6),
        ("kalker_creepage", &["frame.elements=[21, 21]"], 5),
        ("pin_in_bush", &[], 6),
    ];
    for (name, settings, least) in runs {
        let file = reported(&dir, name, settings);
        let count = look(&mut page, &file, name, [SCREEN, NARROW]);
        assert!(count >= least, "{name} has {count} pictures");
    }
}

/// The page for the manager: median, interval and the next test in words.
#[test]
fn studies_and_fits_have_a_page() {
    let dir = TempDir::new().unwrap();
    let (study, fit) = (hostile::study(&dir, "pin"), hostile::fit(&dir, "pin"));
    for (folder, words) in [
        (
            &study,
            [
                "In half of the 2 samples the wear depth of pin stays below 1.5 µm.",
                "ends within 1.05 to 1.95 µm with a probability of nine in ten",
                "2 of 3 rows are good",
            ],
        ),
        (
            &fit,
            [
                "The median of 1 test is 1·10⁻⁴ mm³/(N m)",
                "with 95 % probability it lies within (0.9 to 1.1)·10⁻⁴ mm³/(N m).",
                "The next test, read as these, will show (0.8 to 1.2)·10⁻⁴ mm³/(N m)",
            ],
        ),
    ] {
        archard(&dir, &["report", folder.to_str().unwrap()]).success();
        let page = fs::read_to_string(folder.join("report.html")).unwrap();
        words.iter().for_each(|words| assert!(page.contains(words), "{words} is not in\n{page}"));
        assert!(page.contains("<img class=\"still\""), "no picture");
        let refused = archard(&dir, &["report", folder.to_str().unwrap(), "other"]).code(2);
        assert!(said(&refused).contains("which is not compared"), "{}", said(&refused));
    }
    let Some(mut page) = Page::open() else { return };
    look(&mut page, &study.join("report.html"), "study", [SCREEN, NARROW]);
    page.visit_plain(&fit.join("report.html"), true);
    assert_eq!([page.value(ACCESS), page.value(WIDE)], [json!([]), json!([])]);
}

/// The pictures that are seen, and the figures without one: the surface that is turned has none.
const STILLS: &str = "(() => { const seen = (one) => one.getBoundingClientRect().height > 100; \
    const figures = Array.from(document.querySelectorAll('main figure')).filter((one) => one.id !== 'surface' && !one.querySelector('#surface')); \
    return [figures.length, figures.filter((one) => seen(one.querySelector('img.still'))).length, figures.filter((one) => one.querySelector('img.still').naturalWidth > 100).length]; })()";

#[test]
#[ignore = "long: in .ci/long"]
fn the_slider_goes_through_the_outputs() {
    let Some(mut page) = Page::open() else { return };
    let dir = TempDir::new().unwrap();
    let file = reported(&dir, "pin_on_disc", &PIN);
    assert!(look(&mut page, &file, "pin_on_disc", [NARROW, SCREEN]) >= 10);
    let (last, first) = (slid(&mut page, 10), slid(&mut page, 0));
    assert_eq!((&last[0], &first[0]), (&json!("distance 500 mm"), &json!("distance 0 mm")));
    // Hertz's 219 MPa falls as the pin wears flat.
    let [first, last] = [first, last].map(|one| one[1].as_f64().unwrap());
    assert!(first > 180.0 && last < 30.0, "{first} {last}");
    // All that the maps hold is shown where nothing is worn yet.
    let places = page.value(
        "['map-pressure', 'map-wear-0'].map((id) => document.getElementById(id)._fullLayout.xaxis).map((axis) => \
         [axis._length > 150, ...axis.range.map((end) => Math.round(1e4 * end))])",
    );
    assert_eq!(places, json!([[true, -5500, 5500], [true, -5500, 5500]]));
    // By the keyboard too.
    page.value("document.getElementById('output').focus()");
    let turned = page.value(
        "new Promise((done) => { document.querySelector('button[data-view=above]').click(); \
         setTimeout(() => done(document.getElementById('surface')._fullLayout.scene.camera.eye.z), 500); })",
    );
    assert_eq!(turned, json!(2.1));
    let eye = "document.getElementById('surface')._fullLayout.scene.camera.eye";
    let pressed = page.value(&format!(
        "new Promise((done) => {{ const place = document.getElementById('surface'); place.focus(); const before = {eye}.z; \
         for (const key of ['ArrowDown', 'ArrowRight']) place.dispatchEvent(new KeyboardEvent('keydown', {{ key, cancelable: true }})); \
         setTimeout(() => done([document.activeElement === place, {eye}.z < before - 0.01, Math.abs({eye}.x) > 0.01]), 500); }})"
    ));
    assert_eq!(pressed, json!([true, true, true]));
    assert!(page.printed().starts_with(b"%PDF"));
    pictures_need_no_scripts(&mut page, &file);
    assert_eq!(page.complaints, Vec::<String>::new());
}

/// Pictures are there where the open page is printed, and where scripts are off.
fn pictures_need_no_scripts(page: &mut Page, file: &Path) {
    assert_eq!(page.value(STILLS)[1], 0, "pictures below what is drawn");
    page.in_print(true);
    let printed = page.value(STILLS)[1].clone();
    page.in_print(false);
    page.visit_plain(file, true);
    let stills = page.value(STILLS);
    page.picture("plain");
    let [all, seen, drawn] = [0, 1, 2].map(|i| stills[i].as_u64().unwrap());
    assert!(all >= 10 && seen == all && drawn == all, "{stills}");
    assert_eq!(printed, json!(all));
}
