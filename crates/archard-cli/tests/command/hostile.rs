//! Reports of folders in which every text is hostile: none of it becomes markup, and nothing but the page's own script runs.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};
use tempfile::TempDir;

use super::browser::Page;
use super::{archard, case};

/// What a forged text may be, without letters that tables of commas know.
const NAME: &str = "<img src=x onerror=hacked()>";
/// The same, out of an attribute, and with a script.
const TEXT: &str =
    "\"'><img src=x onerror='hacked()'><script>window.ran = 1</script><b onmouseover=hacked()>";

/// A value with all its texts hostile.
fn forged(value: &Value) -> Value {
    match value {
        Value::String(_) => json!(TEXT),
        Value::Array(all) => all.iter().map(forged).collect(),
        Value::Object(all) => all.iter().map(|(key, own)| (key.clone(), forged(own))).collect(),
        other => other.clone(),
    }
}

fn rewrite(path: &Path, change: impl Fn(String) -> String) {
    fs::write(path, change(fs::read_to_string(path).unwrap())).unwrap();
}

/// A run whose title, body, columns and summary are hostile.
fn run(dir: &TempDir) -> PathBuf {
    let case = case("pin_on_disc");
    let mut arguments = vec!["run", case.to_str().unwrap(), "-o", "run", "-q"];
    for setting in ["frame.elements=[24, 24]", "motion.sliding.step=50 mm"] {
        arguments.extend(["--set", setting]);
    }
    archard(dir, &arguments).success();
    let folder = dir.path().join("run");
    for table in ["history.csv", "profiles.csv"] {
        rewrite(&folder.join(table), |text| {
            let text = text.replace("_pin_", &format!("_{NAME}_"));
            text.replacen("distance_m", &format!("{NAME}_m"), 1)
        });
    }
    rewrite(&folder.join("case.toml"), |text| {
        let quoted = TEXT.replace('"', "\\\"");
        let title = text.lines().find(|line| line.starts_with("title")).unwrap().to_owned();
        let titled = text.replace(&title, &format!("title = \"{quoted}\""));
        titled.replace("body.pin.", &format!("body.\"{NAME}\"."))
    });
    let path = folder.join("summary.json");
    let summary: Value = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
    let mut summary = forged(&summary);
    summary["warnings"] = json!([TEXT]);
    summary["failure"] = json!(TEXT);
    summary["verdict"]["lines"][0]["word"] = json!("doubtful");
    fs::write(&path, summary.to_string()).unwrap();
    // Who forges a folder leaves its sums out.
    fs::remove_file(folder.join("manifest.txt")).unwrap();
    folder
}

/// A study of three rows with a key, a body and an error of that name.
pub fn study(dir: &TempDir, name: &str) -> PathBuf {
    let folder = dir.path().join("study");
    let write = |file: &str, text: &str| {
        let path = folder.join(file);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(path, text).unwrap();
    };
    let kind = json!({ "over": [], "sample": [name], "design": "latin" });
    write("study.json", &kind.to_string());
    write("design.csv", "row\n");
    let depth = format!("wear_depth_{name}_m");
    let rows = "1,1.0,done,good,1e-6,1e-6,\n2,2.0,done,good,2e-6,2e-6,\n3,2.0,failed,,,,";
    let head = format!("row,{name},status,verdict,wear_depth_m,{depth},error\n");
    write("sweep.csv", &format!("{head}{rows}{name}\n"));
    for row in 1..=3 {
        let history = format!("distance_m,wear_depth_m,{depth}\n0,0,0\n1,1e-6,1e-6\n");
        write(&format!("rows/{row:04}/history.csv"), &history);
    }
    folder
}

/// A fit with that text wherever there is one, and a picture that tries to run.
pub fn fit(dir: &TempDir, text: &str) -> PathBuf {
    let folder = dir.path().join("fit");
    fs::create_dir_all(&folder).unwrap();
    let found = json!({
        "version": text,
        "coefficients": [{
            "key": text, "unit": "1/Pa", "median": 1e-13, "interval_95": [0.9e-13, 1.1e-13],
            "next_test_95": [0.8e-13, 1.2e-13],
            "tests": [{ "test": text, "k": 1e-13, "interval_95": [0.9e-13, 1.1e-13] }],
            "budget": [{ "source": text, "relative": 0.02 }],
        }],
        "remarks": [text],
    });
    fs::write(folder.join("fit.json"), found.to_string()).unwrap();
    let picture = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"400\" height=\"300\" onload=\"hacked()\">\
        <script>hacked()</script><circle cx=\"150\" cy=\"150\" r=\"100\"/></svg>";
    fs::write(folder.join("fit.svg"), picture).unwrap();
    folder
}

/// What a page holds that it must not.
const FOREIGN: &str = "[window.ran === undefined, document.querySelectorAll('img[src=x], b[onmouseover], [onerror], [onload], [onmouseover]').length, \
    Array.from(document.querySelectorAll('script:not([type])')).length]";

/// Lets markup in through the back door: nothing of it may run.
const BREACH: &str = "new Promise((done) => { document.body.insertAdjacentHTML('beforeend', '<img src=x onerror=\"window.ran = 1\">'); \
    const script = document.createElement('script'); script.textContent = 'window.ran = 1'; document.head.append(script); \
    setTimeout(() => done(window.ran === undefined), 400); })";

#[test]
#[ignore = "long: in .ci/long"]
fn nothing_of_a_stranger_runs() {
    let dir = TempDir::new().unwrap();
    let mut browser = Page::open();
    for (folder, scripts) in [(run(&dir), 2), (study(&dir, NAME), 2), (fit(&dir, TEXT), 0)] {
        archard(&dir, &["report", folder.to_str().unwrap()]).success();
        let file = folder.join("report.html");
        let text = fs::read_to_string(&file).unwrap();
        assert!(text.contains("&lt;img src=x"), "{} shows none of it", file.display());
        for part in ["<img src=x", "<script>window", "<b onmouseover"] {
            assert!(!text.contains(part), "{part} in {}", file.display());
        }
        let Some(page) = &mut browser else { continue };
        if scripts > 0 {
            page.visit(&file);
        } else {
            page.visit_plain(&file, true);
        }
        assert_eq!(page.value(FOREIGN), json!([true, 0, scripts]), "{}", file.display());
        assert_eq!(page.complaints, Vec::<String>::new(), "{}", file.display());
        page.visit_plain(&file, false);
        assert_eq!(page.value(BREACH), json!(true), "{}", file.display());
        // What the policy refused is complained of.
        page.complaints.clear();
    }
}
