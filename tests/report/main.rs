//! The report: the content of the page, and its behaviour if there is a Chromium.

mod browser;
mod data;
mod large;
mod limits;
mod overview;
mod packed;
mod small;

use std::fs;
use std::process::Command;
use tempfile::TempDir;

/// Writes the study `s.json` into a new folder and runs `slipgap VERB s.json --out out` there for each of the verbs; returns
/// the folder and the page.
fn page_of(study: &str, verbs: &[&str]) -> (TempDir, String) {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("s.json"), study).unwrap();
    let mut printed = String::new();
    for verb in verbs {
        let output = Command::new(env!("CARGO_BIN_EXE_slipgap-tested"))
            .args([verb, "s.json", "--out", "out"])
            .current_dir(folder.path())
            .output()
            .unwrap();
        let errors = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{errors}");
        printed = String::from_utf8_lossy(&output.stdout).into_owned();
    }
    assert_eq!(printed, "out/report.html\n");
    let page = fs::read_to_string(folder.path().join("out/report.html")).unwrap();
    (folder, page)
}
