//! The shipped studies and claims, judged by the program that users run: the release build, as `make test` starts these tests.

use std::process::Command;

/// The release build that the Makefile names, or else the one of the tests, which is slower.
fn program() -> String {
    std::env::var("SLIPGAP_PROGRAM").unwrap_or_else(|_| env!("CARGO_BIN_EXE_slipgap-tested").into())
}

/// Standard output and standard error of a command that succeeds.
fn slipgap(words: &[&str]) -> (String, String) {
    let output = Command::new(program())
        .args(words)
        .current_dir(env!("SLIPGAP_ROOT"))
        .output()
        .unwrap();
    let [out, err] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    assert!(output.status.success(), "slipgap {words:?}: {out}{err}");
    (out, err)
}

/// The folder in which `make fresh` computed all studies, and to which `make test` copies what `make figures` computed. Stores of this
/// version are used, those of another version are not.
const FRESH: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/fresh");

#[test]
#[ignore = "computes every study; run by `make test`"]
fn the_studies_meet_their_checks() {
    let (_, err) = slipgap(&["run", "studies", "--out", FRESH]);
    assert!(!err.contains("check-not-met"), "{err}");
    // The last study has been run, too: "128 of 128 studies".
    let is_last = |line: &str| {
        let count = line.split(" studies").next();
        let counts = count.and_then(|count| count.split_once(" of "));
        counts.is_some_and(|(done, all)| done == all)
    };
    assert!(err.lines().any(is_last), "{err}");
}

#[test]
#[ignore = "computes many studies; run by `make test`"]
fn the_claims_have_their_recorded_verdicts() {
    let (out, err) = slipgap(&["claims", "--out", FRESH]);
    assert!(!out.contains("CHANGED"), "{out}");
    let none = "claims, 0 with a verdict other than recorded";
    assert!(err.contains(none), "{err}");
    // Each verdict that depends on the choice of its limit says why the limit is this one.
    let reasons = "without a reason or with one that is not needed: 0\n";
    assert!(err.contains(reasons), "{err}");
}
