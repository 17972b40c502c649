//! The README promises that its example runs as it stands.

use std::fs;
use std::process::Command;

#[test]
fn the_example_study_runs_and_meets_its_checks() {
    let readme = include_str!("../README.md");
    let example = readme
        .split_once("```json\n")
        .and_then(|(_, rest)| rest.split_once("```"))
        .map(|(example, _)| example)
        .unwrap();
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("ringing.json"), example).unwrap();
    for words in [&["check", "ringing.json"][..], &["run", "ringing.json"]] {
        let output = Command::new(env!("CARGO_BIN_EXE_slipgap"))
            .args(words)
            .current_dir(folder.path())
            .output()
            .unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "slipgap {words:?}: {said}");
    }
    for name in ["results.csv", "history.png", "ringing.png"] {
        assert!(
            folder.path().join("figures/ringing").join(name).is_file(),
            "{name}"
        );
    }
}
