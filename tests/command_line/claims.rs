//! `slipgap claims`: the ledger, its page, a verdict that has changed, and faults with their places.

use crate::Bench;

/// A folder with these files.
fn bench(files: &[(&str, &str)]) -> Bench {
    let bench = Bench::new();
    for (name, text) in files {
        bench.file(name, text);
    }
    bench
}

const STUDY: &str = r#"{ "problem": "friction-oscillator",
  "parameters": { "law": "displacement-control", "alpha": [0.1, 1, 5], "dT": "pi/10", "duration": "8*pi" },
  "figures": [{ "name": "history", "kind": "history" }] }"#;

fn ledger(readings: &str) -> String {
    format!(
        r#"{{ "paper": "A paper", "studies": "../studies", "claims": [
  {{ "id": "A1", "where": "section 1", "says": "Small | alpha is good.", "quantity": "the error",
    "readings": [{readings}],
    "because": "It depends." }} ] }}"#
    )
}

fn reading(expect: &str, holds: bool) -> String {
    format!(
        r#"{{ "reading": "as printed", "study": "fig", "figure": "history", "expect": [{expect}], "holds": {holds} }}"#
    )
}

const RISING: &str = r#"{ "metric": "rms_error", "along": "alpha", "trend": "rising" }"#;
const FALLING: &str = r#"{ "metric": "rms_error", "along": "alpha", "trend": "falling" }"#;
const LEAST: &str = r#"{ "metric": "rms_error", "along": "alpha", "least_at": [0.05, 0.2] }"#;
const WITHIN: &str =
    r#"{ "metric": "rms_error", "where": { "alpha": 0.1 }, "min": 0.024, "max": 0.025 }"#;
const UNDEFINED: &str = r#"{ "metric": "residual_motion", "max": 1 }"#;

#[test]
fn verdicts_follow_from_the_readings() {
    for (expect, holds) in [
        (RISING.to_owned(), true),
        (FALLING.to_owned(), false),
        (format!("{LEAST}, {WITHIN}"), true),
        (format!("{LEAST}, {FALLING}"), false),
    ] {
        for recorded in [true, false] {
            let bench = bench(&[
                ("studies/fig.json", STUDY),
                ("claims/a.json", &ledger(&reading(&expect, recorded))),
            ]);
            let done = bench.run(&["claims"]);
            assert_eq!(
                done.code,
                Some(if recorded == holds { 0 } else { 5 }),
                "{expect}"
            );
            let verdict = if holds { "holds" } else { "fails" };
            assert!(done.out.contains(verdict), "{}", done.out);
            assert_eq!(done.out.contains("CHANGED"), recorded != holds);
            let page = bench.text("figures/claims.md");
            assert!(page.contains("[fig](fig/history.png)") && page.contains("Small \\| alpha"));
            assert_eq!(page.contains("**recorded"), recorded != holds, "{page}");
        }
    }
}

#[test]
fn one_reading_of_two_is_a_condition() {
    let both = [reading(RISING, true), reading(FALLING, false)].join(", ");
    let bench = bench(&[
        ("studies/fig.json", STUDY),
        ("claims/a.json", &ledger(&both)),
    ]);
    let done = bench.run(&["claims", "--out", "page"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(done.out.contains("holds if") && done.out.contains("[if: as printed]"));
    assert!(bench.path("page/claims.md").is_file());
}

#[test]
fn an_undefined_value_does_not_hold() {
    let short = STUDY.replace("8*pi", "2*pi");
    let bench = bench(&[
        ("studies/fig.json", &short),
        ("claims/a.json", &ledger(&reading(UNDEFINED, true))),
    ]);
    assert_eq!(bench.run(&["claims"]).code, Some(5));
}

#[test]
fn faults_have_their_place_and_nothing_is_written() {
    for (from, to, told) in [
        ("rms_error", "rms_eror", "did you mean \"rms_error\"?"),
        ("\"fig\"", "\"nofig\"", "no study"),
        ("\"history\"", "\"histry\"", "unknown figure"),
        (
            "\"trend\": \"rising\"",
            "\"trend\": \"up\"",
            "unknown trend",
        ),
        (
            "\"along\": \"alpha\"",
            "\"along\": \"x0\"",
            "one case for each x0",
        ),
        ("\"holds\": true", "\"holds\": 1", "must be true or false"),
        ("\"id\": \"A1\", ", "", "missing: a short name"),
    ] {
        let text = ledger(&reading(RISING, true)).replace(from, to);
        let bench = bench(&[("studies/fig.json", STUDY), ("claims/a.json", &text)]);
        let done = bench.run(&["claims"]);
        assert_eq!(done.code, Some(2), "{to}: {}", done.err);
        assert!(done.err.contains(told), "{to}: {}", done.err);
        assert!(done.err.contains("claims/a.json:"), "{}", done.err);
        assert!(!bench.path("figures").exists());
    }
    // A reading that fails needs a reason.
    let bare = ledger(&reading(FALLING, false)).replace(",\n    \"because\": \"It depends.\"", "");
    let bench = bench(&[("studies/fig.json", STUDY), ("claims/a.json", &bare)]);
    assert!(
        bench
            .run(&["claims"])
            .err
            .contains("missing: why it does not hold")
    );
}
