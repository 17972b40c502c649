//! The guide promises that its studies and commands work as they stand.

use std::fs;
use std::process::Command;

/// The fenced pieces of a page: language and text, with the words before each.
fn pieces(page: &str) -> Vec<(&str, &str, &str)> {
    let parts: Vec<&str> = page.split("```").collect();
    let fenced = parts.chunks_exact(2).map(|pair| {
        let (language, text) = pair[1].split_once('\n').unwrap();
        (language, text, pair[0])
    });
    fenced.collect()
}

#[test]
fn every_command_of_the_guide_works_in_its_order() {
    let folder = tempfile::tempdir().unwrap();
    let (mut commands, mut studies) = (0, 0);
    for (language, text, before) in pieces(include_str!("../docs/guide.md")) {
        if language == "json" {
            // The file is the last that the words before name.
            let name = before
                .split('`')
                .rfind(|word| word.ends_with(".json"))
                .unwrap();
            fs::write(folder.path().join(name), text).unwrap();
            studies += 1;
            continue;
        }
        assert_eq!(language, "sh");
        for line in text.lines() {
            let words: Vec<&str> = line
                .strip_prefix("slipgap ")
                .unwrap()
                .split_whitespace()
                .collect();
            let output = Command::new(env!("CARGO_BIN_EXE_slipgap"))
                .args(&words)
                .current_dir(folder.path())
                .output()
                .unwrap();
            let said = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{line}: {said}");
            commands += 1;
        }
    }
    assert_eq!((commands, studies), (12, 2));
    for name in ["force.png", "histories.png"] {
        assert!(
            folder.path().join("figures/knock").join(name).is_file(),
            "{name}"
        );
    }
    assert!(
        folder
            .path()
            .join("figures/what-matters/sobol.csv")
            .is_file()
    );
    assert!(folder.path().join("figures/report.html").is_file());
}

/// Numbers that the guide works out from the girder's data, and what the table says.
#[test]
fn the_numbers_of_the_guide_are_right() {
    let impedance = 0.6 * (2.1e11_f64 * 7850.0).sqrt();
    let force = 0.5 * impedance / 2.0;
    assert!((impedance / 1e6 - 24.4).abs() < 0.05 && (force / 1e6 - 6.09).abs() < 0.01);
    assert!((1.45 * force / 1e6 - 8.8).abs() < 0.05);
}
