//! A page in a headless browser.

use serde_json::Value as Json;
use std::fs;
use std::path::Path;
use std::process::Command;

/// Functions for probes: the actions of a reader.
const READER: &str = r#"
const root = document.querySelector(".results");
const heads = () => [...root.querySelectorAll("thead th")];
const column = name => heads().findIndex(th => th.textContent === name);
const cells = name => [...root.querySelectorAll("tbody tr")].map(tr => tr.cells[column(name)]);
const texts = name => cells(name).map(cell => cell.textContent);
const values = name => cells(name).map(cell => cell.title);
const type = text => { const s = root.querySelector("[type=search]"); s.value = text; s.dispatchEvent(new Event("input")); };
const sort = name => heads()[column(name)].querySelector("button").click();
const count = () => root.querySelector("output").textContent;
const typed = text => { type(text); return count(); };
const until = async holds => { while (!holds()) await new Promise(done => setTimeout(done, 20)); };
const probe = {};
"#;

/// An installed Chromium, if any.
pub fn chromium() -> Option<String> {
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
    let found = names.into_iter().find(there).map(String::from);
    if found.is_none() {
        eprintln!("no Chromium is installed: the report was not tried in a browser");
    }
    found
}

/// Runs the browser in `folder`; returns its output.
pub fn browse(program: &str, folder: &Path, words: &[&str]) -> String {
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
    let errors = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!errors.contains("CONSOLE"), "{errors}");
    assert!(output.status.success(), "{errors}");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// Loads the page, waits for its first table, and runs `script`, which fills the object `probe`; returns this object.
pub fn probe(program: &str, folder: &Path, page: &str, script: &str) -> Json {
    let faults = "<head>\n<script>window.faults = []; addEventListener('error', e => faults.push(e.message)); addEventListener('unhandledrejection', e => faults.push(String(e.reason)));</script>";
    // The page itself, which may be large, is not printed.
    let end = format!(
        "<script>(async () => {{{READER}await until(() => !root || root.closest('details:not([open])') || count());\n{script}\n\
         document.body.replaceChildren();\n\
         document.body.dataset.found = encodeURIComponent(JSON.stringify([window.faults, probe]));\n\
         }})().catch(error => {{ document.body.textContent = error.stack; }});</script></body>"
    );
    let page = page.replacen("<head>", faults, 1).replace("</body>", &end);
    let file = folder.join("probe.html");
    fs::write(&file, page).unwrap();
    let address = format!("file://{}", file.display());
    let words = [
        "--virtual-time-budget=60000",
        "--window-size=1200,900",
        "--dump-dom",
        &address,
    ];
    let dom = browse(program, folder, &words);
    let found = dom
        .split_once("data-found=\"")
        .unwrap_or_else(|| panic!("the probe did not end: {dom:.2000}"))
        .1;
    let [faults, probe] = serde_json::from_slice(&plain(found.split_once('"').unwrap().0)).unwrap();
    assert_eq!(faults, Json::Array(Vec::new()));
    probe
}

/// The bytes of a percent-encoded text.
fn plain(text: &str) -> Vec<u8> {
    let mut bytes = text.bytes();
    let mut plain = Vec::new();
    while let Some(byte) = bytes.next() {
        plain.push(match byte {
            b'%' => {
                let digits = [bytes.next().unwrap(), bytes.next().unwrap()];
                u8::from_str_radix(std::str::from_utf8(&digits).unwrap(), 16).unwrap()
            }
            byte => byte,
        });
    }
    plain
}
