//! A page about several studies: the summary, the index with its search, figures that are drawn when they come into view, and tables of
//! the metrics that are used.

use super::browser::{chromium, probe};
use super::data::{Cell, data};
use super::packed::unpacked;
use std::fs;
use std::process::Command;
use std::sync::LazyLock;
use tempfile::TempDir;

/// Studies by file: two of a tag and problem, one with a check that is not met and a warning, one in a folder.
const STUDIES: [(&str, &str); 4] = [
    (
        "laws-alpha.json",
        r#"{ "title": "Width of a law", "problem": "friction-oscillator", "parameters": { "law": "displacement-control",
          "alpha": { "linspace": [0.1, 1, 40] }, "dT": 0.1, "duration": 3 },
          "figures": [ { "name": "error", "kind": "metric", "x": "alpha", "y": "rms_error" } ],
          "checks": [ { "metric": "rms_error", "max": 10 } ] }"#,
    ),
    (
        "laws-beta.json",
        r#"{ "title": "Damping of a law", "problem": "friction-oscillator", "parameters": { "law": "velocity-control",
          "beta": { "linspace": [0.1, 1, 30] }, "dT": 0.1, "duration": 3 },
          "figures": [ { "name": "error", "kind": "metric", "x": "beta", "y": "rms_error" },
            { "name": "last", "title": "The far end", "kind": "metric", "x": "beta", "y": "max_error" } ],
          "checks": [ { "metric": "rms_error", "where": { "beta": 0.1 }, "max": 1e-9 } ] }"#,
    ),
    (
        "bars.json",
        r#"{ "problem": "bar-impact", "parameters": { "gamma": 1, "n": 2, "dt": 0.25, "gap": [0, 2, 3], "duration": 1,
          "L": 10, "E": 100, "V0": 0.1 } }"#,
    ),
    (
        "old/laws-short.json",
        r#"{ "title": "An old law", "problem": "friction-oscillator", "parameters": { "law": "displacement-control", "alpha": 0.1,
          "dT": 0.1, "duration": 3 } }"#,
    ),
];

/// The folder and the page.
static REPORT: LazyLock<(TempDir, String)> = LazyLock::new(|| {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir_all(folder.path().join("studies/old")).unwrap();
    for (file, text) in STUDIES {
        fs::write(folder.path().join("studies").join(file), text).unwrap();
    }
    for verb in ["run", "report"] {
        let output = Command::new(env!("CARGO_BIN_EXE_slipgap-tested"))
            .args([verb, "--out", "out"])
            .current_dir(folder.path())
            .output()
            .unwrap();
        assert!(output.status.success(), "{output:?}");
    }
    let page = fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    (folder, page)
});

#[test]
fn checks_and_warnings_come_first() {
    let (_, page) = &*REPORT;
    let (summary, rest) = page.split_once("<nav").unwrap();
    assert!(summary.contains("✗ 40 of 41 checks are met."));
    assert!(summary.contains(">Damping of a law</a>: 1 of 1 not met</li>"));
    assert!(summary.contains("✓ 74 of 74 cases are solved."));
    // Bars with a gap of 2 c T_I/2 meet after the duration of 1 T_I, which is a result; those without a gap touch until then.
    assert!(!summary.contains("Warning no-contact"));
    assert!(rest.contains("note no-contact; case ") && !rest.contains("warning no-contact"));
    assert!(summary.contains("Warning ends-in-contact in 1 study"));
    assert!(summary.contains(">bars</a>: 1 of 3 cases</li>"));
    // The studies by problem and by tag: bars shares no tag.
    let headings: Vec<&str> = rest
        .split("</nav>")
        .next()
        .unwrap()
        .split("<h")
        .skip(2)
        .map(|text| &text[2..text.find("</h").unwrap()])
        .collect();
    assert_eq!(
        headings,
        ["bar-impact", "other", "friction-oscillator", "laws"]
    );
    assert!(rest.contains(r#"data-tag="laws">laws 3</button>"#));
    assert!(rest.contains(r#"data-tags="old laws""#));
}

#[test]
fn outlines_of_glyphs_are_in_the_page_once() {
    let (_, page) = &*REPORT;
    let whole = unpacked(page);
    let outlines: Vec<&str> = { whole.split("<path id=\"") }
        .skip(1)
        .map(|text| text.split('"').next().unwrap())
        .collect();
    let mut different = outlines.clone();
    different.sort_unstable();
    different.dedup();
    assert!(outlines.len() > 20 && outlines.len() == different.len());
    let used = whole.split("<use href=\"#").skip(1);
    for id in used.map(|text| text.split('"').next().unwrap()) {
        assert!(different.binary_search(&id).is_ok(), "{id}");
    }
}

#[test]
fn tables_have_the_metrics_that_are_used_to_six_digits() {
    let (folder, page) = &*REPORT;
    let (_, of_beta) = page.split_once(">Damping of a law</h3>").unwrap();
    let data = data(of_beta);
    let csv = fs::read_to_string(folder.path().join("out/laws-beta/results.csv")).unwrap();
    let mut lines = csv.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let names: Vec<&str> = data.columns.iter().map(|column| &*column.0).collect();
    // Of the metrics those of figures and checks, in the order of results.csv.
    let first = header
        .iter()
        .position(|name| name.ends_with("_error"))
        .unwrap();
    let used = ["rms_error", "max_error"];
    let metrics = header[first..].iter().filter(|name| used.contains(name));
    let expected: Vec<&str> = header[1..first].iter().chain(metrics).copied().collect();
    assert_eq!(names, expected);
    assert!(of_beta.contains("results.csv of the study has all digits"));
    for (name, cells) in &data.columns {
        let column = header.iter().position(|known| known == name).unwrap();
        for (cell, row) in cells.iter().zip(&rows) {
            let Some(Cell::Number(x)) = cell else {
                continue;
            };
            let exact: f64 = row[column].parse().unwrap();
            let expected = match used.contains(&&**name) {
                true => format!("{exact:.5e}").parse().unwrap(),
                false => exact,
            };
            assert_eq!(*x, expected, "{name}");
        }
    }
}

/// The actions of a reader.
const PROBE: &str = r#"
const found = () => [...document.querySelectorAll("nav li:not([hidden]) a")].map(a => a.textContent);
const studies = () => [...document.querySelectorAll("section.study:not([hidden]) h3")].map(h => h.textContent);
const box = document.querySelector("nav [type=search]");
const look = text => { box.value = text; box.dispatchEvent(new Event("input")); };
const said = () => document.querySelector("nav output").textContent;
probe.all = [said(), found()];
look("far END");
probe.caption = [said(), found(), studies()];
look("friction law");
probe.words = found();
look("nothing-like-it");
probe.none = [said(), found(), studies(), document.querySelectorAll(".group:not([hidden])").length];
look("");
const tag = document.querySelector("[data-tag=laws]");
tag.click();
probe.tag = [said(), found(), tag.getAttribute("aria-pressed")];
tag.click();
const drawings = [...document.querySelectorAll(".drawing")];
const last = drawings[drawings.length - 1];
// A long way off.
last.closest("section").style.marginTop = "20000px";
probe.far = last.querySelector("svg") === null;
last.scrollIntoView();
await until(() => last.querySelector("svg"));
probe.near = last.querySelectorAll(".hover circle").length;
probe.wide = last.getBoundingClientRect().width > 500 && last.querySelector("svg").getBoundingClientRect().width > 500;
const study = last.closest("section");
const part = study.querySelector(".results").closest("details");
part.open = true;
const shown = () => [...part.querySelectorAll("tbody tr")].map(row => Number(row.lastElementChild.title));
await until(() => shown().length);
[...part.querySelectorAll("thead button")].at(-1).click();
probe.sorted = shown();
"#;

#[test]
fn in_a_browser_search_finds_studies_and_figures_are_drawn_in_view() {
    let Some(program) = chromium() else { return };
    let (folder, page) = &*REPORT;
    let probe = probe(&program, folder.path(), page, PROBE);
    let [bars, alpha, beta, old] = ["bars", "Width of a law", "Damping of a law", "An old law"];
    assert_eq!(
        probe["all"],
        serde_json::json!(["4 studies", [bars, alpha, beta, old]])
    );
    assert_eq!(
        probe["caption"],
        serde_json::json!(["1 of 4 studies", [beta], [beta]])
    );
    assert_eq!(probe["words"], serde_json::json!([alpha, beta, old]));
    assert_eq!(
        probe["none"],
        serde_json::json!(["0 of 4 studies", [], [], 0])
    );
    assert_eq!(
        probe["tag"],
        serde_json::json!(["3 of 4 studies", [alpha, beta, old], "true"])
    );
    assert_eq!(
        (&probe["far"], &probe["wide"]),
        (&true.into(), &true.into())
    );
    // One for each beta.
    assert_eq!(probe["near"], 30);
    let sorted: Vec<f64> = { probe["sorted"].as_array().unwrap().iter() }
        .map(|x| x.as_f64().unwrap())
        .collect();
    assert!(sorted.len() == 30 && sorted.is_sorted());
}
