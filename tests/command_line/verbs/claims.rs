//! `slipgap claims`: the ledger, its page, changed verdicts, and faults with their places.

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
/// The error increases with alpha, so that the smallest of two values is at the smaller alpha.
const TWO_OF_THREE: &str = r#"{ "metric": "rms_error", "where": { "alpha": [1, 5] }, "along": "alpha",
    "least_at": [0.9, 1.1] }"#;
const UNDEFINED: &str = r#"{ "metric": "residual_motion", "max": 1 }"#;

#[test]
fn verdicts_follow_from_the_readings() {
    for (expect, holds) in [
        (RISING.to_owned(), true),
        (FALLING.to_owned(), false),
        (format!("{LEAST}, {WITHIN}"), true),
        (format!("{LEAST}, {FALLING}"), false),
        (TWO_OF_THREE.to_owned(), true),
        (TWO_OF_THREE.replace("[1, 5]", "[0.1, 5]"), false),
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
            assert!(page.contains("`fig/history.png`") && page.contains("Small \\| alpha"));
            assert_eq!(page.contains("**recorded"), recorded != holds, "{page}");
        }
    }
}

#[test]
fn a_study_of_claims_is_found_by_its_name_in_any_folder() {
    let claims = ledger(&reading(RISING, true));
    let bench = bench(&[("studies/a/b/fig.json", STUDY), ("claims/a.json", &claims)]);
    bench.expect(0, &["claims"]);
    assert!(
        bench
            .text("figures/claims.md")
            .contains("`a/b/fig/history.png`")
    );
    bench.file("studies/c/fig.json", STUDY);
    let done = bench.expect(2, &["claims"]);
    assert!(
        done.err.contains("studies/a/b/fig.json and"),
        "{}",
        done.err
    );
    assert!(
        done.err.contains("have this name; give the folder, too"),
        "{}",
        done.err
    );
    bench.file("claims/a.json", claims.replace("\"fig\"", "\"c/fig\""));
    bench.expect(0, &["claims"]);
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
fn a_reading_with_an_undefined_value_fails() {
    let short = STUDY.replace("8*pi", "2*pi");
    let bench = bench(&[
        ("studies/fig.json", &short),
        ("claims/a.json", &ledger(&reading(UNDEFINED, true))),
    ]);
    assert_eq!(bench.run(&["claims"]).code, Some(5));
}

#[test]
fn faults_have_places_and_no_file_is_written() {
    for (from, to, message) in [
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
        (
            "\"A1\"",
            "\"\"",
            "must be letters, digits, - and _, got \"\"",
        ),
        (
            "\"A1\"",
            "\"../x\"",
            "must be letters, digits, - and _, got",
        ),
        (
            RISING,
            r#"{ "metric": "rms_error", "min": 2, "max": 1 }"#,
            "claims[0].readings[0].expect[0].max: must be >= min = 2, got 1",
        ),
        (
            "Small |",
            "<script>",
            "claims[0].says: must not contain HTML",
        ),
        (
            "section 1",
            "</table>",
            "claims[0].where: must not contain HTML",
        ),
        ("A paper", "<!-- a", "paper: must not contain HTML"),
        (
            "It depends.",
            "a\\n# b",
            "claims[0].because: must be a string of printable characters, got U+000A",
        ),
    ] {
        let text = ledger(&reading(RISING, true)).replace(from, to);
        let bench = bench(&[("studies/fig.json", STUDY), ("claims/a.json", &text)]);
        let done = bench.run(&["claims"]);
        assert_eq!(done.code, Some(2), "{to}: {}", done.err);
        assert!(done.err.contains(message), "{to}: {}", done.err);
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

/// Two laws with two widths and two releases each.
const LAWS: &str = r#"{ "problem": "friction-oscillator", "blocks": [
  { "parameters": { "law": "displacement-control", "alpha": [0.1, 1], "dT": "pi/10", "x0": [8, 12], "duration": "x0*pi/2" } },
  { "parameters": { "law": "velocity-control", "beta": [0.1, 0.3], "dT": "pi/10", "x0": [8, 12], "duration": "x0*pi/2" } } ],
  "figures": [{ "name": "history", "kind": "history", "where": { "x0": 8 } }] }"#;

#[test]
fn a_metric_may_be_divided_by_that_of_another_case() {
    let bench = bench(&[("studies/fig.json", LAWS)]);
    assert_eq!(bench.run(&["run", "studies/fig.json"]).code, Some(0));
    let table = bench.text("figures/fig/results.csv");
    let mut lines = table.lines();
    let columns: Vec<&str> = lines.next().unwrap().split(',').collect();
    let rows: Vec<Vec<&str>> = lines.map(|line| line.split(',').collect()).collect();
    let column = |name: &str| columns.iter().position(|c| *c == name).unwrap();
    let [law, beta, x0, error] = ["law", "beta", "x0", "rms_error"].map(column);
    let number = |cell: &str| -> f64 { cell.parse().unwrap() };
    // By hand: each error with alpha over that with beta = 0.1 from the same release.
    let mut quotients = Vec::new();
    for row in rows.iter().filter(|row| row[law] == "displacement-control") {
        let is_other = |other: &&Vec<&str>| {
            other[law] == "velocity-control" && number(other[beta]) == 0.1 && other[x0] == row[x0]
        };
        let other = rows.iter().find(is_other).unwrap();
        quotients.push(number(row[error]) / number(other[error]));
    }
    assert_eq!(quotients.len(), 4);
    let low = quotients.iter().copied().fold(f64::INFINITY, f64::min);
    let high = quotients.iter().copied().fold(0.0, f64::max);
    let over = r#""over": { "law": "velocity-control", "beta": 0.1 }"#;
    let within = |min: f64, max: f64| {
        format!(
            r#"{{ "metric": "rms_error", "where": {{ "law": "displacement-control" }}, {over}, "min": {min}, "max": {max} }}"#
        )
    };
    // The table has all digits.
    let (down, up) = (1.0 - 1e-9, 1.0 + 1e-9);
    assert!(holds(LAWS, &within(low * down, high * up)));
    assert!(!holds(LAWS, &within(low * up, high * up)));
    assert!(!holds(LAWS, &within(low * down, high * down)));
    // Also along a parameter; the case itself gives 1.
    let trend = |trend: &str| {
        format!(
            r#"{{ "metric": "rms_error", "where": {{ "alpha": [0.1, 1], "x0": 8 }}, "over": {{ "alpha": 1 }},
                 "along": "alpha", "trend": "{trend}" }}"#
        )
    };
    assert!(holds(LAWS, &trend("rising")) && !holds(LAWS, &trend("falling")));
    let itself = r#"{ "metric": "rms_error", "where": { "alpha": 1 }, "over": { "alpha": 1 }, "min": 1, "max": 1 }"#;
    assert!(holds(LAWS, itself));
    // x0 decides the duration, which is then another one too.
    let release = r#"{ "metric": "rms_error", "where": { "alpha": 1, "x0": 12 }, "over": { "x0": 8 }, "min": 0 }"#;
    assert!(holds(LAWS, release));
    // The page names the other case.
    bench.file("claims/a.json", ledger(&reading(&within(0.0, 1e9), true)));
    assert_eq!(bench.run(&["claims"]).code, Some(0));
    let page = bench.text("figures/claims.md");
    let words = "`rms_error` over that with law = velocity-control, beta = 0.1: ";
    assert!(page.contains(words), "{page}");
}

#[test]
fn a_case_to_divide_by_is_one_and_only_one() {
    let laws = LAWS.replace("x0*pi/2", "8*pi");
    let longer = laws.replacen("[8, 12]", "[8, 12, 16]", 1);
    let law = r#""where": { "law": "displacement-control" }"#;
    for (study, expect, message) in [
        (
            &laws,
            format!(
                r#"{{ "metric": "rms_error", {law}, "over": {{ "law": "velocity-control" }}, "max": 1 }}"#
            ),
            "several cases with law = velocity-control are otherwise the same as the case with law = displacement-control, \
             alpha = 0.1, x0 = 8; they differ in beta, which \"over\" must give",
        ),
        (
            &longer,
            format!(
                r#"{{ "metric": "rms_error", {law}, "over": {{ "law": "velocity-control", "beta": 0.3 }}, "max": 1 }}"#
            ),
            "no case with law = velocity-control, beta = 0.3 is otherwise the same as the case with law = displacement-control, \
             alpha = 0.1, x0 = 16; none of them has x0 = 16",
        ),
        (
            &laws,
            format!(
                r#"{{ "metric": "rms_error", {law}, "over": {{ "law": "velocity-control", "beta": 0.2 }}, "max": 1 }}"#
            ),
            "no case has beta = 0.2; the values are 0.1, 0.3",
        ),
        (
            &laws,
            format!(
                r#"{{ "metric": "rms_error", {law}, "over": {{ "alpha": [0.1, 1] }}, "max": 1 }}"#
            ),
            "expect[0].over.alpha: must be one value",
        ),
        (
            &laws,
            format!(r#"{{ "metric": "rms_error", {law}, "over": {{}}, "max": 1 }}"#),
            "expect[0].over: must be an object with at least one parameter",
        ),
        (
            &laws,
            format!(r#"{{ "metric": "rms_error", {law}, "over": {{ "lav": 1 }}, "max": 1 }}"#),
            "did you mean \"law\"?",
        ),
    ] {
        let bench = bench(&[
            ("studies/fig.json", study),
            ("claims/a.json", &ledger(&reading(&expect, true))),
        ]);
        let done = bench.run(&["claims"]);
        assert_eq!(done.code, Some(2), "{expect}: {}", done.err);
        assert!(done.err.contains(message), "{expect}: {}", done.err);
        assert!(!bench.path("figures").exists());
    }
    let profile =
        r#"{ "profile": "velocity", "times": [0.5], "away": 0.1, "max": 1, "over": { "n": 10 } }"#;
    let impact = IMPACT.replace(", \"k_I\": 0", "");
    let bench = bench(&[
        ("studies/fig.json", &impact),
        ("claims/a.json", &ledger(&reading(profile, true))),
    ]);
    let told = bench.run(&["claims"]).err;
    assert!(
        told.contains("a profile and a later event have no \"over\""),
        "{told}"
    );
}

#[test]
fn every_ledger_of_the_folder_is_on_the_page() {
    let literature = ledger(&reading(RISING, true))
        .replace("A paper", "The literature")
        .replace("A1", "L1")
        .replace("section 1", "Author 1999, Journal 1, 2");
    let bench = bench(&[
        ("studies/fig.json", STUDY),
        ("claims/a.json", &ledger(&reading(RISING, true))),
        ("claims/literature.json", &literature),
    ]);
    let done = bench.run(&["claims"]);
    assert_eq!(done.code, Some(0), "{}", done.err);
    let page = bench.text("figures/claims.md");
    let places = [
        "# The statements of the papers and of the literature",
        "\n## A paper\n",
        "\n### A1\n",
        "\n## The literature\n",
        "\n### L1\n\nAuthor 1999, Journal 1, 2: ",
    ];
    let found: Vec<_> = places.map(|text| page.find(text)).into();
    assert!(
        found.iter().all(Option::is_some) && found.is_sorted(),
        "{page}"
    );
}

const IMPACT: &str = r#"{ "problem": "bar-impact",
  "parameters": { "gamma": 1, "n": 10, "dt": 0.05, "duration": 1, "k_I": 0 },
  "figures": [{ "name": "history", "kind": "history" }] }"#;

/// Whether a ledger with this expectation holds.
fn holds(study: &str, expect: &str) -> bool {
    let bench = bench(&[
        ("studies/fig.json", study),
        ("claims/a.json", &ledger(&reading(expect, true))),
    ]);
    let done = bench.run(&["claims"]);
    assert!(matches!(done.code, Some(0 | 5)), "{expect}: {}", done.err);
    done.code == Some(0)
}

#[test]
fn a_profile_is_tested_away_from_every_front() {
    // The profiles are from an independent program (tests/data/impact.json, 50 digits): velocity at the nodes, from the
    // free end of the left bar. Exact: 1 ahead of the front in the left bar, 0 behind it, -1 after the reflection. The
    // front is at |x| = 2 t before the reflection, at 2 - 2 t after it, and at the free end at T_I/2.
    let data: serde_json::Value =
        serde_json::from_str(include_str!("../../data/impact.json")).unwrap();
    let records = data["profiles"].as_array().unwrap();
    let study = IMPACT.replace(", \"k_I\": 0", "");
    for times in [&[0.25][..], &[0.5], &[0.75], &[0.25, 0.5, 0.75]] {
        for away in [0.099, 0.101, 0.199, 0.201, 0.299, 0.301] {
            let (mut sum, mut count) = (0.0, 0);
            for &t in times {
                let record = records.iter().find(|record| {
                    record["parameters"]["duration"] == t && record["parameters"]["dt"] == 0.05
                });
                let velocity = record.unwrap()["velocity"].as_array().unwrap();
                let front = if t <= 0.5 { 2.0 * t } else { 2.0 - 2.0 * t };
                for (i, v) in velocity.iter().enumerate() {
                    let (bar, way) = if i <= 10 {
                        (1.0, 10 - i)
                    } else {
                        (-1.0, i - 11)
                    };
                    let x = way as f64 / 10.0;
                    if (x - front).abs() > away {
                        let ahead = if t <= 0.5 { 1.0 } else { -1.0 };
                        let exact = if x > front { bar * ahead } else { 0.0 };
                        let error = v.as_f64().unwrap() - exact;
                        sum += error * error;
                        count += 1;
                    }
                }
            }
            let expected = (sum / f64::from(count)).sqrt();
            // Round-off of some hundred sums.
            for (factor, within) in [(1.0 + 1e-9, true), (1.0 - 1e-9, false)] {
                let expect = format!(
                    r#"{{ "profile": "velocity", "times": {times:?}, "away": {away}, "max": {} }}"#,
                    expected * factor
                );
                assert_eq!(holds(&study, &expect), within, "{expect}");
            }
        }
    }
}

#[test]
fn a_later_impact_is_tested_by_its_largest_difference_over_the_flights() {
    // tests/reference/claims.py, second_impacts: one bar between two walls, full matrices. Printed to 8 digits.
    let study = IMPACT
        .replace("\"gamma\": 1, ", "")
        .replace("0.05", "0.001")
        .replace("\"k_I\": 0", "\"k_I\": 100");
    let flights: Vec<f64> = (0..22).map(|i| f64::from(50 + 7 * i) / 100.0).collect();
    for (speed, off) in [("closing_speed", 0.18784602), ("rebound_speed", 0.03925153)] {
        for (limits, within) in [
            (format!(r#""max": {}"#, off + 2e-8), true),
            (format!(r#""max": {}"#, off - 2e-8), false),
            (format!(r#""min": {}"#, off - 2e-8), true),
            (format!(r#""min": {}"#, off + 2e-8), false),
        ] {
            let expect = format!(r#"{{ "later": "{speed}", "flights": {flights:?}, {limits} }}"#);
            assert_eq!(holds(&study, &expect), within, "{expect}");
        }
    }
}

#[test]
fn an_unknown_later_event_is_a_fault() {
    let study = IMPACT.replace(", \"k_I\": 0", "");
    for (study, expect, message) in [
        (
            STUDY,
            r#"{ "later": "closing_speed", "flights": [1], "max": 1 }"#,
            "later event",
        ),
        (
            &study,
            r#"{ "later": "closing_sped", "flights": [1], "max": 1 }"#,
            "closing_speed",
        ),
        (
            &study,
            r#"{ "later": "closing_speed", "max": 1 }"#,
            "needs \"flights\"",
        ),
        (
            &study,
            r#"{ "later": "closing_speed", "flights": [1] }"#,
            "needs \"flights\"",
        ),
        (
            &study,
            r#"{ "later": "closing_speed", "flights": [0], "max": 1 }"#,
            "must be > 0",
        ),
        (
            &study,
            r#"{ "later": "closing_speed", "flights": [1e9], "max": 1 }"#,
            "at most 100",
        ),
        (
            &study,
            r#"{ "later": "closing_speed", "profile": "velocity" }"#,
            "needs a \"metric\"",
        ),
    ] {
        let bench = bench(&[
            ("studies/fig.json", study),
            ("claims/a.json", &ledger(&reading(expect, true))),
        ]);
        let done = bench.run(&["claims"]);
        assert_eq!(done.code, Some(2), "{expect}: {}", done.err);
        assert!(done.err.contains(message), "{expect}: {}", done.err);
    }
}

#[test]
fn expectations_of_reductions_apply_to_groups() {
    let study = r#"{ "problem": "friction-oscillator",
      "parameters": { "law": "displacement-control", "alpha": [0.1, 1, 5], "dT": ["pi/10", "pi/20"], "duration": "8*pi" },
      "reductions": ["greatest rms_error over alpha", "least rms_error over alpha"],
      "figures": [{ "name": "history", "kind": "history" }] }"#;
    let judged = |expect: &str| {
        let bench = bench(&[
            ("studies/fig.json", study),
            ("claims/a.json", &ledger(&reading(expect, true))),
        ]);
        let done = bench.run(&["claims"]);
        (done.code, done.err + &done.out + &page(&bench))
    };
    fn page(bench: &Bench) -> String {
        std::fs::read_to_string(bench.path("figures/claims.md")).unwrap_or_default()
    }
    // The smallest error of both steps is that of alpha = 0.1; see WITHIN for that of the larger step.
    let within = r#"{ "metric": "least rms_error over alpha", "where": { "dT": "pi/10" }, "min": 0.024, "max": 0.025 }"#;
    let (code, text) = judged(within);
    assert_eq!(code, Some(0), "{text}");
    // The filter chooses first.
    let (code, text) = judged(&within.replace("\"pi/10\"", "\"pi/10\", \"alpha\": [1, 5]"));
    assert_eq!(code, Some(5), "{text}");
    // A reduction over that of other cases, which `where` does not choose: 0.0245 over 0.0300, each with its last digit.
    let over = within.replace(
        "\"min\": 0.024, \"max\": 0.025",
        "\"over\": { \"dT\": \"pi/20\" }, \"min\": 0.80, \"max\": 0.83",
    );
    let (code, text) = judged(&over);
    assert_eq!(code, Some(0), "{text}");
    // One of three errors is that small.
    let of_three = WITHIN.replace("\"alpha\": 0.1", "\"dT\": \"pi/10\"");
    for (share, expected) in [("0.3", 0), ("0.4", 5)] {
        let expect = of_three.replace("\"min\"", &format!("\"share\": {share}, \"min\""));
        let (code, text) = judged(&expect);
        assert_eq!(code, Some(expected), "{text}");
        assert!(text.contains("in 1 of 3 (0.024..0.025)"), "{text}");
    }
    // 0.0300 at pi/20: the law causes most of the error.
    let along = r#"{ "metric": "least rms_error over alpha", "along": "dT", "trend": "falling" }"#;
    let (code, text) = judged(along);
    assert_eq!(code, Some(0), "{text}");
    for (expect, message) in [
        (
            along.replace("\"dT\"", "\"alpha\""),
            "the metrics are reduced over alpha",
        ),
        (
            along.replace("\"along\"", "\"over\": { \"alpha\": 1 }, \"along\""),
            "the metrics are reduced over alpha",
        ),
        (
            along.replace("\"along\"", "\"share\": 0.5, \"along\""),
            "is for a \"metric\" with \"min\" or \"max\"",
        ),
        (
            along.replace("least rms", "leest rms"),
            "did you mean \"least rms_error over alpha\"?",
        ),
    ] {
        let (code, text) = judged(&expect);
        assert_eq!(code, Some(2), "{expect}: {text}");
        assert!(text.contains(message), "{expect}: {text}");
    }
}

#[test]
fn a_comparison_in_a_statement_is_no_html() {
    let text = ledger(&reading(RISING, true)).replace("Small | alpha", "alpha < 1, alpha <= 2 and");
    let bench = bench(&[("studies/fig.json", STUDY), ("claims/a.json", &text)]);
    assert_eq!(bench.run(&["claims"]).code, Some(0));
    assert!(
        bench
            .text("figures/claims.md")
            .contains("alpha < 1, alpha <= 2 and is good.")
    );
}
