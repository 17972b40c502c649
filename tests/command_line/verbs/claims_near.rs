//! `slipgap claims`: the verdicts near a limit, and the conditions of the page.

use crate::Bench;

const STUDY: &str = r#"{ "problem": "friction-oscillator",
  "parameters": { "law": "displacement-control", "alpha": 0.1, "dT": "pi/10", "duration": "8*pi" },
  "figures": [{ "name": "history", "kind": "history" }] }"#;

fn reading(name: &str, limits: [f64; 2], holds: bool, near: &str) -> String {
    let [min, max] = limits;
    format!(
        r#"{{ "reading": "{name}", "study": "fig", "holds": {holds}{near},
            "expect": [{{ "metric": "rms_error", "min": {min}, "max": {max} }}] }}"#
    )
}

fn ledger(readings: &[String]) -> String {
    format!(
        r#"{{ "paper": "A paper", "studies": "../studies", "claims": [
  {{ "id": "A1", "where": "section 1", "says": "Small alpha is good.", "quantity": "the error",
    "readings": [{}], "because": "It depends." }} ] }}"#,
        readings.join(", ")
    )
}

#[test]
fn a_verdict_near_a_limit_needs_a_reason() {
    let bench = Bench::new();
    bench.file("studies/fig.json", STUDY);
    assert_eq!(bench.run(&["run", "studies/fig.json"]).code, Some(0));
    let table = bench.text("figures/fig/results.csv");
    let mut lines = table
        .lines()
        .map(|line| line.split(',').collect::<Vec<_>>());
    let column = lines.next().unwrap().iter().position(|c| *c == "rms_error");
    let x: f64 = lines.next().unwrap()[column.unwrap()].parse().unwrap();
    let reason = r#", "near": "A round number.""#;
    // Half the range is about 0.5, so that limits move by 0.05.
    for (limits, holds, near) in [
        ([x - 1.0, x + 1.0], true, false),
        ([x - 1.0, x + 0.04], true, true),
        ([x - 1.0, x + 0.06], true, false),
        ([x - 1.0, x - 0.04], false, true),
        ([x - 1.0, x - 0.06], false, false),
    ] {
        for given in ["", reason] {
            bench.file(
                "claims/a.json",
                ledger(&[reading("one", limits, holds, given)]),
            );
            let done = bench.run(&["claims"]);
            assert_eq!(done.code, Some(0), "{}", done.err);
            let wrong = near == given.is_empty();
            let told = format!(
                "readings near a limit: {}, without a reason or with one that is not needed: {}",
                i32::from(near),
                i32::from(wrong)
            );
            assert!(done.err.contains(&told), "{limits:?}: {}", done.err);
            let page = bench.text("figures/claims.md");
            let (_, list) = page.split_once("## Verdicts near a limit").unwrap();
            assert_eq!(
                list.contains("| [A1](#a1) | one | "),
                near || !given.is_empty()
            );
            assert_eq!(
                list.contains("**no reason given**"),
                near && given.is_empty()
            );
            assert_eq!(
                list.contains("is not near its limit**"),
                !near && !given.is_empty()
            );
        }
    }
}

#[test]
fn the_page_shows_the_condition_of_a_verdict() {
    let bench = Bench::new();
    bench.file("studies/fig.json", STUDY);
    let readings = [
        reading("with | one", [0.0, 1.0], true, ""),
        reading("with two", [2.0, 3.0], false, ""),
        reading("with three", [0.0, 2.0], true, ""),
    ];
    bench.file("claims/a.json", ledger(&readings));
    let done = bench.run(&["claims"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    assert!(
        done.out.contains("[if: with | one; with three]"),
        "{}",
        done.out
    );
    let page = bench.text("figures/claims.md");
    assert!(
        page.contains("| holds if: with \\| one; with three |"),
        "{page}"
    );
    assert!(
        page.contains("**Holds if:** with | one; with three."),
        "{page}"
    );
}
