//! The report: what stands on the page, and, where there is a Chromium, what the page does.

use serde_json::Value as Json;
use std::fs;
use std::path::Path;
use std::process::Command;
use tempfile::TempDir;

/// 108 cases with one that is stranger than the others, a figure of each kind of hover, and a check that is not met.
const STUDY: &str = r#"{ "title": "Springs & <meshes>", "problem": "bar-impact", "parameters": {
  "gamma": { "linspace": [0.25, 3, 12] }, "n": [2, 4, 8], "mass": ["lumped", "consistent"], "gap": [0], "dt": "0.1/n", "duration": 1.5,
  "right": "wall", "L": [10], "E": [100, 101, 102], "V0": 0.1 },
  "zip": [], "when": "E == 100 or n > 2 and E < 102 or n == 8",
  "figures": [
    { "name": "map", "kind": "map", "x": "n", "y": "gamma", "z": "peak_force", "where": { "mass": "lumped", "E": 100 } },
    { "name": "curves", "kind": "metric", "x": "gamma", "y": "peak_force", "by": "n", "where": { "mass": "lumped", "E": 100 } } ],
  "checks": [ { "metric": "peak_force", "where": { "n": 8, "mass": "lumped", "E": 100, "gamma": 0.25 }, "max": 0.5 } ] }
"#;

fn report() -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("s.json"), STUDY).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_slipgap"))
        .args(["report", "s.json", "--out", "out"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{said}");
    assert_eq!(String::from_utf8_lossy(&output.stdout), "out/report.html\n");
    let page = fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    (folder, page)
}

#[test]
fn the_page_has_everything_in_it_and_asks_for_nothing() {
    let (_folder, page) = report();
    // The name of the SVG namespace is no address that is asked.
    let rest = page.replace("http://www.w3.org/2000/svg", "");
    for beside in ["http:", "https:", "src=", "@import", "url(", "<link"] {
        assert!(!rest.contains(beside), "{beside}");
    }
    assert!(page.contains("Springs &amp; &lt;meshes&gt;"));
    assert!(
        page.contains("&quot;when&quot;: &quot;E == 100"),
        "the study as given"
    );
    assert!(page.contains("Checks: 0 of 1 met") && page.contains("not met</td>"));
    assert!(page.contains(env!("CARGO_PKG_VERSION")));
    let data = page
        .split_once("application/json\">")
        .unwrap()
        .1
        .split_once("</script>")
        .unwrap()
        .0;
    let data: Json = serde_json::from_str(data).unwrap();
    assert_eq!(data["rows"].as_array().unwrap().len(), cases());
    // A point to point at for each case of the map and of the curves.
    assert_eq!(page.matches("role=\"img\" aria-label=").count(), 2 * 36);
    assert!(
        page.contains("aria-label=\"n = 4, γ = 0.25: peak of F/F0 = "),
        "what a point says"
    );
}

/// 12 gammas, 2 mass matrices, and for n = 2, 4, 8 one, two and three values of E.
fn cases() -> usize {
    12 * 2 * (1 + 2 + 3)
}

/// What a reader does, and what comes of it.
const PROBE: &str = r#"<script>
const root = document.querySelector(".results");
const heads = () => [...root.querySelectorAll("thead th")];
const column = name => heads().findIndex(th => th.textContent === name);
const cells = name => [...root.querySelectorAll("tbody tr")].map(tr => tr.cells[column(name)].textContent);
const type = text => { const s = root.querySelector("[type=search]"); s.value = text; s.dispatchEvent(new Event("input")); };
const sort = name => heads()[column(name)].querySelector("button").click();
const count = () => root.querySelector("output").textContent;
const probe = {};
probe.begun = count();
probe.hidden = column("L");
root.querySelector(".next").click();
probe.next = count();
sort("peak_force");
probe.rising = cells("peak_force");
probe.sorted = heads()[column("peak_force")].getAttribute("aria-sort");
sort("peak_force");
probe.falling = cells("peak_force");
type("n=8 gamma>=2.75 consistent");
probe.filtered = [count(), cells("n"), cells("gamma"), cells("mass")];
type("nothing-like-it");
probe.none = count();
type("");
root.querySelector("[type=checkbox]").click();
probe.shown = column("L") >= 0;
const point = document.querySelector(".hover circle");
point.focus();
probe.tip = document.getElementById("tip").textContent;
point.dispatchEvent(new KeyboardEvent("keydown", { key: "ArrowRight", bubbles: true }));
probe.moved = document.activeElement === point.nextElementSibling;
document.body.dataset.errors = JSON.stringify(window.faults);
document.body.dataset.probe = JSON.stringify(probe);
</script></body>"#;

/// A Chromium of the usual names.
fn chromium() -> Option<String> {
    let names = [
        "chromium",
        "chromium-browser",
        "google-chrome",
        "google-chrome-stable",
    ];
    let there = |name: &&str| {
        let version = Command::new(name).arg("--version").output();
        version.is_ok_and(|output| output.status.success())
    };
    names.into_iter().find(there).map(String::from)
}

fn browse(program: &str, folder: &Path, words: &[&str]) -> String {
    let output = Command::new(program)
        .args([
            "--headless",
            "--no-sandbox",
            "--disable-gpu",
            "--enable-logging=stderr",
        ])
        .arg(format!(
            "--user-data-dir={}",
            folder.join("profile").display()
        ))
        .args(words)
        .current_dir(folder)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!said.contains("CONSOLE"), "{said}");
    assert!(output.status.success(), "{said}");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

#[test]
fn in_a_browser_it_loads_sorts_filters_and_prints() {
    let Some(program) = chromium() else {
        eprintln!("no Chromium is installed: the report was not tried in a browser");
        return;
    };
    let (folder, page) = report();
    let faults = "<head>\n<script>window.faults = []; addEventListener('error', e => faults.push(e.message));</script>";
    let page = page.replacen("<head>", faults, 1).replace("</body>", PROBE);
    let file = folder.path().join("out/probe.html");
    fs::write(&file, page).unwrap();
    let address = format!("file://{}", file.display());
    let dom = browse(&program, folder.path(), &["--dump-dom", &address]);
    let attribute = |name: &str| -> Json {
        let start = dom
            .split_once(&format!("data-{name}=\""))
            .expect("the probe ran to its end")
            .1;
        let text = start.split_once('"').unwrap().0;
        serde_json::from_str(&text.replace("&quot;", "\"").replace("&gt;", ">")).unwrap()
    };
    assert_eq!(attribute("errors"), Json::Array(Vec::new()));
    let probe = attribute("probe");
    let all = cases();
    assert_eq!(probe["begun"], format!("1 to 100 of {all} cases"));
    assert_eq!(probe["next"], format!("101 to {all} of {all} cases"));
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
