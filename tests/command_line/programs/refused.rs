//! No verb starts a program without `--allow-programs`.

use super::{bench, fake, towers};

const LEDGER: &str = r#"{ "paper": "A test", "studies": "..", "claims": [{ "id": "T1", "where": "here", "says": "It moves.", "quantity": "its peak",
  "readings": [{ "reading": "as run", "study": "s", "holds": true,
    "expect": [{ "metric": "peak(a)", "min": 0 }] }] }] }"#;

/// Every verb that computes, with what it computes.
const VERBS: [&[&str]; 11] = [
    &["run", "s.json"],
    &["run", "s.json", "--shard", "1/2"],
    &["merge", "s.json"],
    &["check", "s.json"],
    &["report", "s.json"],
    &["animate", "s.json"],
    &["recommend", "s.json"],
    &["calibrate", "s.json"],
    &["claims", "claims"],
    &["sbatch", "s.json", "--shards", "2"],
    &["run", "s.json", "--set", "gap=0.01"],
];

#[test]
fn no_verb_starts_a_program_without_being_asked() {
    let bench = bench();
    let check = r#", "metrics": ["peak(a)"], "checks": [{ "metric": "peak(a)", "max": 1 }]"#;
    let parameters = r#""method": "fake", "gap": [0.01, 0.02]"#;
    bench.file("s.json", towers(&fake("banner"), parameters, check));
    bench.file("claims/c.json", LEDGER);
    for words in VERBS {
        let mut command = bench.command();
        // A variable of the environment allows nothing.
        command.env("SLIPGAP_ALLOW_PROGRAMS", "1").args(words);
        let output = command.output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{words:?}: {said}");
        let parts = ["fake.py banner", "--allow-programs", "s.json: not run"];
        for part in parts {
            assert!(said.contains(part), "{words:?}: {said}");
        }
    }
    // These show the command.
    for words in [&["list", "s.json"][..], &["explain", "s.json", "1"]] {
        let done = bench.expect(0, words);
        assert!(done.out.contains("fake.py banner (not started"), "{done:?}");
    }
    bench.expect(0, &["explain", "s.json", "--request"]);
    bench.expect(0, &["status", "s.json"]);
    assert!(!bench.path("started").exists());
    // No key of a study allows it.
    let parameters = r#""method": "fake", "gap": 0.01"#;
    let key = r#", "allow_programs": true"#;
    bench.file("t.json", towers(&fake("banner"), parameters, key));
    let done = bench.expect(2, &["run", "t.json"]);
    assert!(done.err.contains("unknown key"), "{done:?}");
    assert!(!bench.path("started").exists());
}

#[test]
fn studies_of_a_folder_with_programs_are_left_out_with_a_word() {
    let bench = bench();
    let check = r#", "metrics": ["peak(a)"], "checks": [{ "metric": "peak(a)", "max": 1 }]"#;
    let of_program = towers(&fake("banner"), r#""method": "fake", "gap": 0.01"#, check);
    let parameters = r#""method": "average-acceleration", "gap": 0.01"#;
    let without = towers("", parameters, check).replace("\"programs\": {  },", "");
    bench.file("studies/a.json", without);
    bench.file("studies/p.json", of_program);
    bench.file(
        "claims/c.json",
        LEDGER
            .replace("\"..\"", "\"../studies\"")
            .replace("\"s\"", "\"p\""),
    );
    let ledger = LEDGER
        .replace("\"..\"", "\"../studies\"")
        .replace("\"s\"", "\"a\"");
    bench.file("claims/d.json", ledger.replace("T1", "T2"));
    for words in [
        &["run"][..],
        &["check", "studies"],
        &["report", "studies"],
        &["claims"],
    ] {
        let done = bench.expect(0, words);
        for part in ["p.json: left out", "fake.py banner", "--allow-programs"] {
            assert!(done.err.contains(part), "{words:?}: {done:?}");
        }
    }
    assert!(!bench.path("started").exists());
    // One that is named is refused.
    let done = bench.expect(2, &["run", "studies/a.json", "studies/p.json"]);
    assert!(done.err.contains("p.json: not run"), "{done:?}");
    bench.expect(2, &["claims", "claims/c.json"]);
    bench.file("studies/fake.py", super::FAKE);
    bench.expect(0, &["run", "studies", "--allow-programs"]);
    assert!(bench.path("studies/started").exists());
}

#[test]
fn verbs_that_are_asked_start_it() {
    let check = r#", "metrics": ["peak(a)"], "checks": [{ "metric": "peak(a)", "max": 1 }]"#;
    let parameters = r#""method": "fake", "gap": [0.01, 0.02]"#;
    let study = towers(&fake("banner"), parameters, check);
    for words in [
        &["run", "s.json"][..],
        &["run", "s.json", "--shard", "1/1"],
        &["check", "s.json"],
        &["report", "s.json"],
        &["animate", "s.json"],
        &["claims", "claims"],
    ] {
        let bench = bench();
        bench.file("s.json", &study);
        bench.file("claims/c.json", LEDGER);
        bench.expect(0, &[words, &["--allow-programs"]].concat());
        assert!(bench.path("started").exists(), "{words:?}");
    }
    let bench = bench();
    bench.file("s.json", &study);
    let words = ["sbatch", "s.json", "--shards", "2", "--allow-programs"];
    let script = bench.expect(0, &words).out;
    assert!(script.contains("'--allow-programs'"), "{script}");
    assert!(!bench.path("started").exists());
}
