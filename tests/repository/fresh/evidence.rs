//! The checks of all studies, and the claims, judged by the program that users run.

use serde_json::Value as Json;
use std::fs;
use std::path::Path;
use std::process::Command;

#[test]
#[ignore = "reads the results of every study; run by `make fresh` and `make evidence`"]
fn the_studies_meet_their_checks() {
    let results = crate::results();
    let mut not_met = Vec::new();
    for study in crate::studies() {
        let manifest = crate::manifest(&results, &study);
        let warnings = manifest["warnings"].as_array().unwrap().iter();
        let checks_not_met = warnings.filter(|warning| warning["kind"] == "check-not-met");
        not_met.extend(checks_not_met.map(|warning| format!("{study}: {}", warning["message"])));
    }
    assert!(not_met.is_empty(), "{}", not_met.join("\n"));
}

#[test]
#[ignore = "reads the results of every study; run by `make fresh` and `make evidence`"]
fn a_study_that_warns_says_why() {
    let results = crate::results();
    let mut silent = Vec::new();
    for study in crate::studies() {
        let manifest = crate::manifest(&results, &study);
        let text = crate::root().join("studies").join(format!("{study}.json"));
        let remark = json(&text)["//"].to_string();
        for warning in manifest["warnings"].as_array().unwrap() {
            let kind = warning["kind"].as_str().unwrap();
            let is_note = warning["message"]
                .as_str()
                .unwrap()
                .contains(&format!("(note {kind};"));
            if !is_note && !remark.contains(kind) {
                silent.push(format!("{study}: {kind}"));
            }
        }
    }
    assert!(silent.is_empty(), "{}", silent.join("\n"));
}

fn json(path: &Path) -> Json {
    serde_json::from_str(&fs::read_to_string(path).unwrap()).unwrap()
}

#[test]
#[ignore = "reads the results of many studies; run by `make fresh` and `make evidence`"]
fn the_claims_have_their_recorded_verdicts() {
    let output = Command::new(crate::PROGRAM)
        .args(["claims", "--out"])
        .arg(crate::results())
        .current_dir(crate::root())
        .output()
        .unwrap();
    let [out, err] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    assert!(output.status.success(), "{out}{err}");
    assert!(!out.contains("CHANGED"), "{out}");
    let none = "claims, 0 with a verdict other than recorded";
    assert!(err.contains(none), "{err}");
    // Each verdict that depends on the choice of its limit says why the limit is this one.
    let reasons = "without a reason or with one that is not needed: 0\n";
    assert!(err.contains(reasons), "{err}");
}
