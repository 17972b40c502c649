//! The studies that `make figures` runs, judged by the program.

use std::process::Command;

/// The folder in which `make fresh` computed all studies, and to which `make test` copies what `make figures` computed. Stores of this
/// version are used, those of another version are not.
const FRESH: &str = concat!(env!("CARGO_TARGET_TMPDIR"), "/fresh");

#[test]
#[ignore = "computes what `make figures` has not computed; run by `make test`"]
fn the_studies_meet_their_checks() {
    let given = std::env::var("SLIPGAP_STUDIES");
    let studies = given.expect("SLIPGAP_STUDIES, the studies of `make figures`; run `make test`");
    let output = Command::new(env!("CARGO_BIN_EXE_slipgap-tested"))
        .arg("run")
        .args(studies.split_whitespace())
        .args(["--out", FRESH])
        .current_dir(env!("SLIPGAP_ROOT"))
        .output()
        .unwrap();
    let [out, err] = [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap());
    assert!(output.status.success(), "{studies}: {out}{err}");
    assert!(!err.contains("check-not-met"), "{err}");
    // The last study has been run, too: "28 of 28 studies".
    let is_last = |line: &str| {
        let count = line.split(" studies").next();
        let counts = count.and_then(|count| count.split_once(" of "));
        counts.is_some_and(|(done, total)| done == total)
    };
    assert!(err.lines().any(is_last), "{err}");
}
