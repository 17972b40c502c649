//! The page of a small study, and the actions of a reader.

use super::browser::{browse, chromium, probe};
use super::data::data;
use super::packed::unpacked;
use super::page_of;
use serde_json::Value as Json;
use std::fs;
use std::process::Command;

/// 108 cases, figures with each kind of hover text, and a check that is not met.
const STUDY: &str = r#"{ "title": "Springs & <meshes>", "problem": "bar-impact", "parameters": {
  "gamma": { "linspace": [0.25, 3, 12] }, "n": [2, 4, 8], "mass": ["lumped", "consistent"], "gap": [0], "dt": "0.1/n", "duration": 1.5,
  "right": "wall", "L": [10], "E": [100, 101, 102], "V0": 0.1 },
  "zip": [], "when": "E == 100 or n > 2 and E < 102 or n == 8",
  "figures": [
    { "name": "map", "kind": "map", "x": "n", "y": "gamma", "z": "peak_force", "where": { "mass": "lumped", "E": 100 } },
    { "name": "curves", "title": "Peaks & n", "kind": "metric", "x": "gamma", "y": "peak_force", "by": "n", "where": { "mass": "lumped", "E": 100 } } ],
  "checks": [ { "metric": "peak_force", "where": { "n": 8, "mass": "lumped", "E": 100, "gamma": 0.25 }, "max": 0.5 } ] }
"#;

/// What the figures show, in words: the quantities over the parameters, the curves, and the cases.
const CAPTIONS: [&str; 2] = [
    "Stiffness of the impact spring over that of an element γ over number of elements of a bar n, coloured by peak of F/F0. \
     For mass = lumped, E = 100.",
    "Peaks &amp; n. Peak of F/F0 over stiffness of the impact spring over that of an element γ. Shown: n = 2; n = 4; n = 8. \
     For mass = lumped, E = 100.",
];

#[test]
fn the_page_needs_no_other_file() {
    let (folder, packed) = page_of(STUDY, &["report"]);
    let page = unpacked(&packed);
    // The name of the SVG namespace is not an address to load.
    let rest = page.replace("http://www.w3.org/2000/svg", "");
    for address in ["http:", "https:", "src=", "@import", "url(", "<link"] {
        assert!(!rest.contains(address), "{address}");
    }
    assert!(page.contains("Springs &amp; &lt;meshes&gt;"));
    assert!(
        page.contains("&quot;when&quot;: &quot;E == 100"),
        "the study as given"
    );
    assert!(page.contains("Checks: 0 of 1 met") && page.contains("not met</td>"));
    assert!(page.contains(env!("CARGO_PKG_VERSION")));
    let solver = format!("solver {}", slipgap::batch::store::key::SOLVER_VERSION);
    assert!(page.contains(&solver));
    // From `sha256sum`.
    let study = folder.path().join("s.json");
    if let Ok(sum) = Command::new("sha256sum").arg(study).output() {
        let sum = String::from_utf8(sum.stdout).unwrap();
        assert!(page.contains(sum.split(' ').next().unwrap()), "{sum}");
    }
    assert!(page.contains("<dt>F0</dt>") && page.contains("<dt>T_I</dt>"));
    assert!(!page.contains("Sobol'"), "no design");
    assert_eq!(data(&packed).head["rows"], cases());
    for caption in CAPTIONS {
        let caption = format!("<figcaption>{caption}</figcaption>");
        assert!(page.contains(&caption), "{caption}");
    }
    // A point with hover text for each case of the map and of the curves.
    assert_eq!(page.matches("role=\"img\" aria-label=").count(), 2 * 36);
    assert!(
        page.contains("aria-label=\"n = 4, γ = 0.25: peak of F/F0 = "),
        "what a point says"
    );
}

#[test]
fn indices_on_the_page_are_those_of_the_table() {
    let study = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control",
        "beta": {"uniform": [0.5, 2]}, "x0": {"uniform": [5, 15]}, "dT": 0.5, "duration": 10},
        "design": {"kind": "saltelli", "n": 32}}"#;
    let (folder, page) = page_of(study, &["run", "report"]);
    let page = unpacked(&page);
    let table = fs::read_to_string(folder.path().join("out/s/sobol.csv")).unwrap();
    let mut with_numbers = 0;
    for row in table.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let index = |from: usize| -> String {
            let numbers: Vec<f64> = cells[from..from + 3]
                .iter()
                .flat_map(|x| x.parse())
                .collect();
            match numbers[..] {
                [value, low, high] => format!("{value:.3} ({low:.3} to {high:.3})"),
                _ => String::new(),
            }
        };
        let (first, total) = (index(3), index(6));
        with_numbers += usize::from(!first.is_empty());
        let words = format!("{}</td><td class=\"words\">{}", cells[1], cells[2]);
        let expected = format!("<td class=\"words\">{words}</td><td>{first}</td><td>{total}</td>");
        assert!(page.contains(&expected), "{expected}");
    }
    assert!(with_numbers > 3);
    assert!(page.contains("<dt>Δ</dt>"));
}

/// Number of cases: 12 gammas, 2 mass matrices, and for n = 2, 4, 8 one, two and three values of E.
fn cases() -> usize {
    12 * 2 * (1 + 2 + 3)
}

/// The actions of a reader, and their results.
const PROBE: &str = r#"
probe.begun = count();
probe.hidden = column("L");
root.querySelector(".next").click();
probe.next = count();
sort("peak_force");
probe.rising = texts("peak_force");
probe.sorted = heads()[column("peak_force")].getAttribute("aria-sort");
sort("peak_force");
probe.falling = texts("peak_force");
type("n=8 gamma>=2.75 consistent");
probe.filtered = [count(), texts("n"), texts("gamma"), texts("mass")];
probe.none = typed("n=8 gamma>3");
probe.named = typed("nothing-like-it");
type("");
root.querySelector("[type=checkbox]").click();
probe.shown = column("L") >= 0;
await until(() => document.querySelector(".hover circle"));
const point = document.querySelector(".hover circle");
point.focus();
probe.tip = document.getElementById("tip").textContent;
point.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true }));
probe.moved = document.activeElement === point.nextElementSibling;
"#;

#[test]
fn in_a_browser_it_loads_sorts_filters_and_prints() {
    let Some(program) = chromium() else { return };
    let (folder, page) = page_of(STUDY, &["report"]);
    let probe = probe(&program, folder.path(), &page, PROBE);
    let count = cases();
    assert_eq!(probe["begun"], format!("1 to 100 of {count} cases"));
    assert_eq!(probe["next"], format!("101 to {count} of {count} cases"));
    assert_eq!(
        (&probe["hidden"], &probe["shown"]),
        (&Json::from(-1), &Json::from(true))
    );
    let numbers = |name: &str| -> Vec<f64> {
        let list = probe[name].as_array().unwrap().iter();
        list.map(|cell| cell.as_str().unwrap().parse().unwrap())
            .collect()
    };
    let (rising, falling) = (numbers("rising"), numbers("falling"));
    assert!(rising.is_sorted() && falling.iter().rev().is_sorted());
    assert!(rising.len() > 40 && probe["sorted"] == "ascending");
    // gamma = 2.75 and 3, three values of E.
    assert_eq!(probe["filtered"][0], "1 to 6 of 6 cases");
    for (column, allowed) in [(1, &["8"][..]), (2, &["2.75", "3"]), (3, &["consistent"])] {
        let cells = probe["filtered"][column].as_array().unwrap();
        assert!(
            cells
                .iter()
                .all(|cell| allowed.contains(&cell.as_str().unwrap())),
            "{cells:?}"
        );
    }
    assert_eq!(probe["none"], "no case");
    let named = probe["named"].as_str().unwrap();
    assert!(named.starts_with("“nothing-like-it” is neither"), "{named}");
    assert!(
        probe["tip"]
            .as_str()
            .unwrap()
            .starts_with("n = 2, γ = 0.25: peak of F/F0 = ")
    );
    assert_eq!(probe["moved"], true);
    let address = format!("file://{}", folder.path().join("out/report.html").display());
    browse(
        &program,
        folder.path(),
        &["--print-to-pdf=page.pdf", &address],
    );
    let printed = fs::read(folder.path().join("page.pdf")).unwrap();
    assert!(printed.starts_with(b"%PDF") && printed.len() > 10_000);
}

#[test]
fn distributions_on_the_page_are_those_of_the_table() {
    let study = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control",
        "beta": [0.5, 2], "x0": [5, 7, 9, 11, 13, 15], "dT": 0.5, "duration": 10}, "ensemble": "x0"}"#;
    let (folder, page) = page_of(study, &["run", "report"]);
    let page = unpacked(&page);
    let table = fs::read_to_string(folder.path().join("out/s/quantiles.csv")).unwrap();
    let rounded = |cell: &str| -> String {
        let number: f64 = cell.parse().unwrap();
        let x: f64 = format!("{number:.3e}").parse().unwrap();
        slipgap::problem::numbers::parameter::shortest(x)
    };
    let mut with_numbers = 0;
    for row in table.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        if cells[3] != "0" {
            continue;
        }
        with_numbers += 1;
        let range = |a: usize, b: usize| format!("{} to {}", rounded(cells[a]), rounded(cells[b]));
        let expected = format!(
            "<td class=\"words\">{}</td><td class=\"words\">{}</td><td>6</td><td>0</td><td>{} ({})</td><td>{}</td><td>{}</td><td>{}</td>",
            cells[0],
            cells[1],
            rounded(cells[8]),
            range(15, 16),
            range(6, 10),
            range(5, 11),
            range(4, 12)
        );
        assert!(page.contains(&expected), "{expected}");
    }
    assert!(with_numbers > 2, "{table}");
}
