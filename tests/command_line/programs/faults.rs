//! What goes wrong with a program is a fault of the case, and never holds up the run.

use super::{bench, fake, towers};

/// Runs three cases; returns the exit code and what was said.
fn said(way: &str) -> (i32, String) {
    let bench = bench();
    let parameters = r#""method": "fake", "gap": [0.01, 0.02, 0.03]"#;
    let metrics = r#", "metrics": ["peak(a)", "rms_error(a)"]"#;
    bench.file("s.json", towers(&fake(way), parameters, metrics));
    let done = bench.run(&["run", "s.json", "--allow-programs", "--jobs", "1"]);
    (done.code.unwrap(), done.err)
}

#[test]
fn faults_are_those_of_cases() {
    for (way, part) in [
        (
            "error",
            "case 2 could not be solved: fake: did not converge at t = 3.21",
        ),
        (
            "short",
            "case 0 could not be solved: fake: channel a of its answer has 1 values; needed: 501",
        ),
        (
            "missing",
            "case 1 could not be solved: fake: its answer has no channel a",
        ),
        (
            "nan",
            "case 0 could not be solved: fake: its answer is not JSON; NaN and Infinity are none, null is no value",
        ),
        (
            "broken",
            "case 0 could not be solved: fake: its answer is not JSON",
        ),
        (
            "lawless",
            "case 0 could not be solved: fake: it does not have the law impact-spring; it has none",
        ),
        (
            "ends once",
            "case 1 could not be solved: fake: it ended without an answer (exit status: 7)",
        ),
        // The process that it started still has its output.
        (
            "orphan",
            "case 1 could not be solved: fake: it ended without an answer (exit status: 7)",
        ),
        (
            "slow",
            "case 1 could not be solved: fake: no answer within 2 s",
        ),
    ] {
        let (code, said) = said(way);
        assert_eq!(code, 3, "{way}: {said}");
        assert!(said.contains(part), "{way}: {said}");
        let unsolved = said.matches("could not be solved").count();
        let is_one = ["ends once", "orphan", "slow"].contains(&way);
        assert_eq!(unsolved, if is_one { 1 } else { 3 }, "{way}: {said}");
    }
}

#[test]
fn a_program_of_no_use_ends_the_run_with_what_it_said() {
    for (way, parts) in [
        (
            "dead",
            [
                "it ended before its first line (exit status: 1)",
                "cannot import the engine",
            ],
        ),
        ("late", ["no first line within 5 s", "fake.py late"]),
        (
            "ends",
            [
                "abort: matrix is singular",
                "at its first request in every worker",
            ],
        ),
        (
            "stuck",
            [
                "no answer within 2 s",
                "at its first request in every worker",
            ],
        ),
    ] {
        let (code, said) = said(way);
        assert_eq!(code, 3, "{way}: {said}");
        assert!(
            parts.iter().all(|part| said.contains(part)),
            "{way}: {said}"
        );
    }
    let bench = bench();
    let none = r#""fake": { "command": ["./no-such-program"] }"#;
    let study = towers(
        none,
        r#""method": "fake", "gap": 0.01"#,
        r#", "metrics": ["peak(a)"]"#,
    );
    bench.file("s.json", &study);
    let done = bench.expect(3, &["run", "s.json", "--allow-programs"]);
    assert!(
        done.err.contains("cannot start ./no-such-program"),
        "{done:?}"
    );
}

#[test]
fn nonsense_is_a_warning_and_other_lines_are_no_answers() {
    let warnings = |way: &str| {
        let bench = bench();
        let parameters = r#""method": "fake", "gap": 0.01"#;
        let metrics = r#", "metrics": ["peak(a)", "rms_error(a)", "energy_error"]"#;
        bench.file("s.json", towers(&fake(way), parameters, metrics));
        bench.expect(0, &["run", "s.json", "--allow-programs"]).err
    };
    assert!(warnings("huge").contains("(warning program-size"));
    assert!(warnings("gain").contains("(warning program-gain"));
    // The load pushes a body that rests, and no force is there.
    assert!(warnings("banner").contains("(warning program-unheld"));
    assert!(warnings("null").contains("program-null"));
    // One that is silent for longer than it is looked at.
    assert!(warnings("quiet").contains("(warning program-unheld"));
}

#[test]
fn mistakes_of_programs_are_faults_of_the_study() {
    let bench = bench();
    let fault = |programs: &str, parameters: &str| {
        bench.file("s.json", towers(programs, parameters, ""));
        bench.expect(2, &["list", "s.json"]).err
    };
    let gap = r#""gap": 0.01"#;
    for (programs, part) in [
        (
            r#""average-acceleration": { "command": ["x"] }"#,
            "is a method of slipgap",
        ),
        (r#""a b": { "command": ["x"] }"#, "cannot name a program"),
        (
            r#""p": { "command": [] }"#,
            "must be a list of the program and its arguments",
        ),
        (r#""p": { "command": "x -y" }"#, "must be a list"),
        (r#""p": {}"#, "missing"),
        (
            r#""p": { "command": ["x"], "files": ["none.py"] }"#,
            "none.py",
        ),
        (r#""p": { "command": ["x"], "timeout": 0 }"#, "must be"),
        (
            r#""p": { "command": ["x"], "parameters": { "t": "tol" } }"#,
            "tol",
        ),
        (r#""p": { "command": ["x"], "shell": true }"#, "unknown key"),
    ] {
        let said = fault(programs, gap);
        assert!(said.contains(part), "{programs}: {said}");
    }
    // The error of one that chooses its own steps is not over dt.
    let figure = r#", "metrics": ["rms_error(a)"], "figures": [{ "name": "c", "kind": "convergence", "x": "dt", "y": ["rms_error(a)"] }]"#;
    for (adaptive, code) in [("true", 2), ("false", 0)] {
        let program = format!(r#""p": {{ "command": ["x"], "adaptive": {adaptive} }}"#);
        let one_step = towers(&program, r#""gap": 0.01, "method": "p""#, figure);
        bench.file(
            "s.json",
            one_step.replace("\"dt\": 0.01", "\"dt\": [0.01, 0.02]"),
        );
        let done = bench.expect(code, &["list", "s.json"]);
        assert_eq!(done.err.contains("p is adaptive"), code == 2, "{done:?}");
    }
    let said = fault(
        r#""p": { "command": ["x"] }"#,
        r#""gap": 0.01, "method": "q""#,
    );
    assert!(said.contains("method") && said.contains("q"), "{said}");
}
