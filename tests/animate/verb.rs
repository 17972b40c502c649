//! The verb: its file, its messages, and the bytes of the page.

use super::{BARS, BRIDGE, OSCILLATOR};
use serde_json::Value as Json;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

fn slipgap(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_slipgap-tested"))
        .args(arguments)
        .current_dir(folder)
        .output()
        .unwrap()
}

fn folder(study: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("s.json"), study).unwrap();
    folder
}

/// Exit code and messages of a command that fails.
fn fails(study: &str, arguments: &[&str]) -> (i32, String) {
    let folder = folder(study);
    let output = slipgap(folder.path(), arguments);
    let errors = String::from_utf8(output.stderr).unwrap();
    (output.status.code().unwrap(), errors)
}

/// The data of a page.
fn data(page: &str) -> Json {
    let begin = r#"<script id="data" type="application/json">"#;
    let text = page.split_once(begin).unwrap().1;
    serde_json::from_str(text.split_once("</script>").unwrap().0).unwrap()
}

#[test]
fn the_page_is_in_the_folder_of_the_study_and_has_the_same_bytes_again() {
    for study in [OSCILLATOR, BARS] {
        let folder = folder(study);
        let page = |arguments: &[&str], file: &str| {
            let output = slipgap(folder.path(), arguments);
            assert!(output.status.success(), "{output:?}");
            assert_eq!(
                String::from_utf8(output.stdout).unwrap(),
                format!("{file}\n")
            );
            fs::read_to_string(folder.path().join(file)).unwrap()
        };
        let first = page(&["animate", "s.json"], "figures/s/animation.html");
        let again = page(&["animate", "s.json", "0", "--out", "a/b.html"], "a/b.html");
        assert_eq!(first, again);
        let other = page(&["animate", "s.json", "1", "--out", "c.html"], "c.html");
        assert_ne!(first, other);
        // Nothing is loaded from elsewhere.
        for mark in ["src=", "href=", "@import", "url(", "fetch("] {
            assert!(!first.contains(mark), "{mark}");
        }
    }
}

#[test]
fn the_usual_case_is_the_one_of_a_history() {
    let folder = folder(BRIDGE);
    let output = slipgap(
        folder.path(),
        &["animate", "s.json", "--set", "duration=0.2"],
    );
    assert!(output.status.success(), "{output:?}");
    let page = fs::read_to_string(folder.path().join("figures/s/animation.html")).unwrap();
    assert_eq!(data(&page)["films"][0]["label"], "case 1: gamma = 4");
}

#[test]
fn mistakes_have_a_message() {
    for (arguments, message) in [
        (
            &["animate", "s.json", "2"][..],
            "case 2: the study has cases 0 to 1",
        ),
        (
            &["animate", "s.json", "0", "9"],
            "case 9: the study has cases 0 to 1",
        ),
        (&["animate", "s.json", "x"], "must be a whole number >= 0"),
        (
            &["animate", "s.json", "0", "1", "--exact"],
            "cannot be used with",
        ),
        (&["animate", "."], ". is a folder; name one study"),
        (
            &["animate", "s.json", "--out", "."],
            ". names no file to write",
        ),
        (&["animate", "absent.json"], "absent.json"),
    ] {
        let (code, errors) = fails(OSCILLATOR, arguments);
        assert_eq!(
            code,
            if arguments.contains(&"absent.json") {
                1
            } else {
                2
            },
            "{errors}"
        );
        assert!(errors.contains(message), "{errors}");
    }
    let arguments = ["animate", "s.json", "0", "--exact", "--set", "duration=0.1"];
    let (code, errors) = fails(BRIDGE, &arguments);
    assert_eq!(code, 2);
    assert!(
        errors.contains("case 0: there is no exact motion")
            && errors.contains("contacts_reference")
    );
}

#[test]
fn names_of_a_study_end_no_element() {
    let title = "</script><script>window.bad = 1</script> {data} & \\\"x\\\"";
    let study = OSCILLATOR.replace("A mass", title);
    let folder = folder(&study);
    let output = slipgap(folder.path(), &["animate", "s.json"]);
    assert!(output.status.success(), "{output:?}");
    let page = fs::read_to_string(folder.path().join("figures/s/animation.html")).unwrap();
    assert_eq!(page.matches("</script>").count(), 2);
    assert_eq!(page.matches("<script").count(), 2);
    assert!(page.contains("<title>&lt;/script&gt;&lt;script&gt;window.bad = 1&lt;/script&gt; {data} &amp; &quot;x&quot;</title>"));
}
