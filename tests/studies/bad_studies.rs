//! Faulty studies: every fault is reported at its line and column, and none leads to a panic.

use proptest::prelude::*;
use slipgap::error::Error;
use slipgap::study::{parse, read};

/// The faults of a text, one line each, without the name of the file.
fn faults(text: &str) -> Vec<String> {
    match parse("s.json", text) {
        Ok(_) => Vec::new(),
        Err(Error::Faults(faults)) => {
            let messages = faults.iter().map(ToString::to_string);
            messages
                .map(|line| line.replacen("s.json:", "", 1))
                .collect()
        }
        Err(other) => vec![format!("another error: {other}")],
    }
}

/// A study of displacement-control with these parameters on its fourth line, and these further keys.
fn with(parameters: &str, more: &str) -> String {
    format!(
        "{{\n\"problem\": \"friction-oscillator\",\n\"parameters\": {{\n{parameters}\n}}{more}\n}}\n"
    )
}

const GOOD: &str = "\"law\": \"displacement-control\", \"alpha\": [0.1, 1], \"dT\": \"pi/10\", \"duration\": \"8*pi\"";

#[track_caller]
fn assert_faults(text: &str, expected: &[&str]) {
    let found = faults(text);
    let fit = found.len() == expected.len()
        && found
            .iter()
            .zip(expected)
            .all(|(found, start)| found.starts_with(start));
    assert!(fit, "{text}\nfound {found:#?}\nexpected {expected:#?}");
}

/// One parameter on the fourth line in addition to the required ones.
#[track_caller]
fn assert_parameter(given: &str, expected: &str) {
    let rest = "\"law\": \"displacement-control\", \"dT\": 0.1, \"duration\": 9";
    assert_faults(&with(&format!("{given}, {rest}"), ""), &[expected]);
}

#[test]
fn an_expression_of_parameters_is_a_value_or_in_a_list() {
    let alone = "names n; an expression with names of parameters is allowed as the value of a parameter, and in a list that has \
                 as many values";
    let bars = |dt: &str| {
        format!(
            "{{\n\"problem\": \"bar-impact\",\n\"parameters\": {{\n\"dt\": {dt}, \"gamma\": 1, \"n\": 4, \"duration\": 2\n}}\n}}"
        )
    };
    let in_rule = "4:26: parameters.dt.linspace[1]: \"0.3/n\": ";
    let rule = "{\"linspace\": [0.1, \"0.3/n\", 3]}";
    assert_faults(&bars(rule), &[&format!("{in_rule}{alone}")]);
    for dt in ["\"0.3/n\"", "[\"0.3/n\"]", "[0.1, \"0.3/n\"]"] {
        assert_faults(&bars(dt), &[]);
    }
    // A misspelt name stays a fault.
    let found = faults(&bars("[\"0.3/sqr(2)\"]"));
    assert!(
        found[0].contains("unknown name \"sqr\", did you mean \"sqrt\"?"),
        "{found:?}"
    );
}

#[test]
fn characters_that_would_not_be_shown_are_refused() {
    let refused = [
        ("\\u0000", "U+0000"),
        ("\\u0007", "U+0007"),
        ("\\u001b[31m", "U+001B"),
        ("a\\nb", "U+000A"),
        ("\u{7f}", "U+007F"),
        ("\u{9b}31m", "U+009B"),
        ("\u{fffe}", "U+FFFE"),
        ("\u{ffff}", "U+FFFF"),
        ("\u{fdd0}", "U+FDD0"),
        ("\u{10ffff}", "U+10FFFF"),
        ("\u{2028}", "U+2028"),
        ("\u{202e}evil", "U+202E"),
        ("\u{2066}", "U+2066"),
    ];
    for (text, name) in refused {
        let what = format!("must be a string of printable characters, got {name}");
        let title = with(GOOD, &format!(",\n\"title\": \"{text}\""));
        assert_faults(&title, &[&format!("6:10: title: {what}")]);
        let figure = |key: &str| {
            with(
                GOOD,
                &format!(
                    ",\n\"figures\": [{{\"name\": \"f\", \"kind\": \"law\",\n\"{key}\": \"{text}\"}}]"
                ),
            )
        };
        for key in ["title", "note"] {
            let at = if key == "title" { "7:10" } else { "7:9" };
            assert_faults(&figure(key), &[&format!("{at}: figures[0].{key}: {what}")]);
        }
        // In a key or a name, the message shows the character as an escape.
        for found in faults(&with(
            &format!("{GOOD}, \"{text}\": 1"),
            &format!(", \"problem\": \"{text}\""),
        )) {
            assert_eq!(slipgap::study::unprintable(&found), None, "{found:?}");
        }
    }
    for text in [
        "漢字 αβ é",
        "\u{200f}עברית",
        "👩\u{200d}🔬",
        "*k*_I_ < & > '",
    ] {
        assert_faults(&with(GOOD, &format!(", \"title\": \"{text}\"")), &[]);
    }
}

#[test]
fn a_condition_is_tried_for_every_combination() {
    // 1100 x 1000 combinations, more than are tabulated: one of them, in the middle, has no root.
    let axes = "\"law\": \"velocity-control\", \"beta\": {\"range\": [1, 1100, 1]}, \"x0\": {\"linspace\": [1, 1000, 1000]}, \"dT\": 0.1, \"duration\": 1";
    let when = "sqrt(abs(beta - 500) + abs(x0 - 500) - 0.5) > 1490";
    let text = with(axes, &format!(",\n\"when\": \"{when}\""));
    assert_faults(
        &text,
        &[
            "6:9: when: \"sqrt(abs(beta - 500) + abs(x0 - 500) - 0.5) > 1490\" with beta = 500, x0 = 500: must be finite",
        ],
    );
    // Of more than 10^8 combinations none is tested. The one without a value is a case that cannot be solved.
    let text = text
        .replace("\"range\": [1, 1100, 1]", "\"linspace\": [1, 1e6, 1000000]")
        .replace("1000, 1000]", "1e6, 1000000]");
    let file = tempfile::NamedTempFile::new().unwrap();
    std::fs::write(file.path(), text).unwrap();
    let input = slipgap::study::Input::of_file(file.path()).unwrap();
    let study = input.study(u64::MAX).unwrap();
    assert!(!study.enumeration().is_counted());
    assert_eq!(study.len(), 1_000_000_000_000);
    let number = |beta: u64, x0: u64| (beta - 1) * 1_000_000 + x0 - 1;
    assert!(study.case(number(500, 501)).is_none());
    assert_eq!(study.violations(number(500, 2000)), []);
    let (first, cases) = study.columns(number(500, 500), number(500, 2001));
    let refused: Vec<(usize, &str)> = cases.refused().collect();
    let message = format!("when: \"{when}\" with beta = 500, x0 = 500: must be finite, got NaN");
    assert_eq!(
        (first, &refused[..]),
        (number(500, 500), &[(0, &*message)][..])
    );
    let broken = &study.violations(first)[..];
    assert_eq!(slipgap::problem::Violation::all(broken), Some(message));
}

#[test]
fn ends_that_no_double_lies_between_are_refused() {
    let sampled = |kind: &str, ends: &str| {
        with(
            &format!(
                "\"law\": \"velocity-control\", \"dT\": 0.1, \"duration\": 9, \"beta\": 1,\n\"x0\": {{\"{kind}\": {ends}}}"
            ),
            ", \"design\": {\"kind\": \"sobol\", \"n\": 4}",
        )
    };
    for (kind, ends, message) in [
        (
            "loguniform",
            "[1e-200, 1e200]",
            "b/a must be within the range of double precision",
        ),
        (
            "uniform",
            "[-1e308, 1e308]",
            "b - a must be within the range of double precision",
        ),
    ] {
        let at = 5 + 8 + kind.len() + ends.find(' ').unwrap();
        let expected = format!("5:{at}: parameters.x0.{kind}[1]: {message}");
        assert_faults(&sampled(kind, ends), &[&expected]);
    }
}

#[test]
fn many_faults_are_counted_and_not_all_reported() {
    let many = vec!["-1"; 10_100].join(", ");
    let text = with(
        &format!(
            "\"law\": \"displacement-control\", \"alpha\": [{many}], \"dT\": 0.1, \"duration\": 9"
        ),
        "",
    );
    let found = faults(&text);
    assert_eq!(found.len(), 10_001);
    assert!(
        found[10_000].ends_with(": and 100 more faults"),
        "{}",
        found[10_000]
    );
}

#[test]
fn numbers() {
    let number = "4:10: parameters.alpha: must be a number or an expression in quotes";
    for (alpha, expected) in [
        ("-0.1", "4:10: parameters.alpha: must be > 0, got -0.1"),
        ("0", "4:10: parameters.alpha: must be > 0, got 0"),
        (
            "\"1-pi\"",
            "4:10: parameters.alpha: must be > 0, got \"1-pi\" = -2.14",
        ),
        (
            "1e999",
            "4:10: parameters.alpha: must be a finite number, got 1e999",
        ),
        ("1e-999", "4:10: parameters.alpha: must be > 0, got 1e-999"),
        (
            "\"1/0\"",
            "4:10: parameters.alpha: \"1/0\": must be finite, got inf",
        ),
        (
            "\"pi/\"",
            "4:10: parameters.alpha: \"pi/\": expected a number, a name or '(' after '/'",
        ),
        (
            "\"NaN\"",
            "4:10: parameters.alpha: \"NaN\": unknown name \"NaN\"",
        ),
        ("\"\"", "4:10: parameters.alpha: \"\": expected a number"),
        ("true", number),
        ("null", number),
        (
            "[]",
            "4:10: parameters.alpha: must be a value or a non-empty list, got []",
        ),
        (
            "[[0.1]]",
            "4:11: parameters.alpha[0]: must be a number or an expression in quotes",
        ),
        (
            "[1, 2, -0.1]",
            "4:17: parameters.alpha[2]: must be > 0, got -0.1",
        ),
        (
            "[\"αβ\", 2]",
            "4:11: parameters.alpha[0]: \"αβ\": unknown name \"αβ\"",
        ),
        (
            "{\"linspace\": [0, 1, 5]}",
            "4:23: parameters.alpha.linspace: must be > 0, got 0",
        ),
        (
            "{\"linspace\": [1, 2]}",
            "4:23: parameters.alpha.linspace: must be [a, b, n]",
        ),
        (
            "{\"linspace\": [1, 2, 2.5]}",
            "4:30: parameters.alpha.linspace[2]: must be a whole number >= 2",
        ),
        (
            "{\"geomspace\": [-1, 2, 5]}",
            "4:29: parameters.alpha.geomspace[1]: must have the sign of a",
        ),
        (
            "{\"range\": [1, 2, -1]}",
            "4:27: parameters.alpha.range[2]: must be a step that leads from a to b",
        ),
        (
            "{\"range\": [1, 2, 1e-9]}",
            "4:27: parameters.alpha.range[2]: gives 1",
        ),
        (
            "{}",
            "4:10: parameters.alpha: must have exactly one of linspace, geomspace, range",
        ),
        (
            "{\"linspac\": [1, 2, 3]}",
            "4:22: parameters.alpha.linspac: unknown key",
        ),
    ] {
        assert_parameter(&format!("\"alpha\": {alpha}"), expected);
    }
    assert_parameter(
        "\"alpha\": 1, \"x0\": 0",
        "4:19: parameters.x0: must be not 0, got 0",
    );
    assert_parameter(
        "\"alpha\": 1, \"x0\": -0.0",
        "4:19: parameters.x0: must be not 0, got -0.0",
    );
}

#[test]
fn names_and_keys() {
    assert_parameter(
        "\"alpha\": 1, \"initial_slip\": \"pull\"",
        "4:29: parameters.initial_slip: unknown initial_slip \"pull\", did you mean \"pulled\"?; allowed: unloaded, pulled, sliding",
    );
    assert_parameter(
        "\"alpha\": 1, \"X0\": 3",
        "4:19: parameters.X0: unknown key \"X0\", did you mean \"x0\"?; allowed: law, alpha",
    );
    assert_parameter(
        "\"alpha\": 1, \"beta\": 3",
        "4:21: parameters.beta: does not apply to law displacement-control, only to velocity-control, tanh, stribeck or stribeck-hyperbolic; allowed: law, alpha, dT, duration, x0, initial_slip, method",
    );
    assert_parameter(
        "\"alpha\": 1, \"alpha\": 3",
        "4:13: parameters.alpha: key \"alpha\" is given twice",
    );
    assert_parameter(
        "\"//\": 1, \"//\": 2",
        "3:15: parameters.alpha: missing: elastic displacement",
    );
    assert_parameter(
        "\"alpha\": 1, \"zip\": []",
        "4:20: parameters.zip: unknown key \"zip\"; allowed: law, alpha",
    );
    let law = |law: &str| with(&GOOD.replace("displacement-control", law), "");
    assert_faults(
        &law("displacment-control"),
        &[
            "4:8: parameters.law: unknown law \"displacment-control\", did you mean \"displacement-control\"?",
        ],
    );
    assert_faults(
        &law("viscous"),
        &[
            "4:8: parameters.law: unknown law \"viscous\"; allowed: displacement-control, velocity-control, coulomb, tanh",
        ],
    );
    assert_faults(
        &with(GOOD, "").replace("oscillator", "oscilator"),
        &[
            "2:12: problem: unknown problem \"friction-oscilator\", did you mean \"friction-oscillator\"?",
        ],
    );
    assert_faults(
        &with(GOOD, "").replace("\"friction-oscillator\"", "7"),
        &["2:12: problem: must be a name in quotes, one of friction-oscillator"],
    );
}

#[test]
fn numbers_with_units() {
    let unit = "a number is written without a unit; alpha is dimensionless: elastic displacement";
    for (given, at) in [
        ("\"0.05 s\"", "4:10: parameters.alpha: \"0.05 s\": "),
        ("[1, \"2mm\"]", "4:14: parameters.alpha[1]: \"2mm\": "),
        (
            "{\"linspace\": [1, \"2 m/s^2\", 3]}",
            "4:27: parameters.alpha.linspace[1]: \"2 m/s^2\": ",
        ),
    ] {
        assert_parameter(&format!("\"alpha\": {given}"), &format!("{at}{unit}"));
    }
    let parameters = "\"dt\": \"1 ms\", \"gamma\": 1, \"n\": \"4 m\", \"duration\": 2, \"right\": {\"E\": \"210 GPa\"}";
    let bars = format!("{{\n\"problem\": \"bar-impact\", \"parameters\": {{\n{parameters}\n}}\n}}");
    assert_faults(
        &bars,
        &[
            "3:7: parameters.dt: \"1 ms\": a number is written without a unit; dt is in T_I: time step, over the contact duration",
            "3:32: parameters.n: \"4 m\": a number is written without a unit; n is dimensionless: number of elements of a bar",
            "3:69: parameters.right.E: \"210 GPa\": a number is written without a unit; right.E is in force/length^2: ",
        ],
    );
    // Of no parameter, but a number all the same.
    assert_faults(
        &with(
            GOOD,
            ",\n\"checks\": [{\"metric\": \"rms_error\", \"max\": \"5 %\"}]",
        ),
        &["6:43: checks[0].max: \"5 %\": a number is written without a unit"],
    );
}

#[test]
fn names_of_what_is_not_modelled() {
    let rest = "\"law\": \"displacement-control\", \"alpha\": 1, \"dT\": 0.1, \"duration\": 9";
    for (name, says) in [
        (
            "zeta",
            ": only studies with \"problem\": \"structure\" have damping; see docs/structures.md; allowed: law, alpha",
        ),
        (
            "ground_motion",
            ": only studies with \"problem\": \"structure\" have ground motion; see docs/structures.md",
        ),
        (
            "mu",
            ": the equations are scaled: lengths are over Delta = nu N/k, times over 1/omega_n; see docs/scope.md; allowed",
        ),
        (
            "integrator",
            ", did you mean \"method\"?; allowed: law, alpha",
        ),
        ("time_step", ", did you mean \"dT\"?; allowed: law, alpha"),
    ] {
        let column = 4 + name.len();
        let expected = format!(
            "4:{}: parameters.{name}: unknown key \"{name}\"{says}",
            column + 1
        );
        assert_faults(&with(&format!("\"{name}\": 1, {rest}"), ""), &[&expected]);
    }
    assert_parameter(
        "\"alpha\": {\"logspace\": [1, 2, 3]}",
        "4:23: parameters.alpha.logspace: unknown key \"logspace\", did you mean \"geomspace\"?; allowed: linspace, geomspace, range",
    );
}

#[test]
fn laws_that_meet_in_one_block() {
    let both = "\"law\": [\"displacement-control\", \"velocity-control\"], \"alpha\": 1, \"dT\": 0.1, \"duration\": 9";
    assert_faults(
        &with(both, ""),
        &[
            "3:15: parameters.beta: missing; it applies only to law velocity-control, tanh, stribeck or stribeck-hyperbolic",
            "4:63: parameters.alpha: applies only to law displacement-control, bouc-wen or dahl, but law is also velocity-control here; give each law its own block in \"blocks\"",
        ],
    );
}

#[test]
fn the_whole() {
    assert_faults(
        "[]",
        &["1:1: must be an object with keys from $schema, title"],
    );
    assert_faults("3", &["1:1: must be an object"]);
    assert_faults(
        "{}",
        &[
            "1:1: problem: missing: one of friction-oscillator",
            "1:1: parameters: missing",
        ],
    );
    assert_faults("", &["1:1: the file is empty"]);
    assert_faults("{\n \"problem\": \"α\", }", &["2:18: not valid JSON"]);
    assert_faults(
        &with(
            GOOD,
            ",\n\"blocks\": [],\n\"title\": 3,\n\"$schema\": null,\n\"design\": {}",
        ),
        &[
            "6:11: blocks: cannot be given together with \"parameters\"",
            "7:10: title: must be a string, got 3",
            "8:12: $schema: must be a string, got null",
            "9:11: design.kind: missing: one of latin-hypercube, sobol, saltelli",
            "9:11: design.n: missing: the number of points",
            "9:11: design: samples nothing",
        ],
    );
    let blocks =
        |blocks: &str| format!("{{\"problem\": \"friction-oscillator\",\n\"blocks\": {blocks}}}");
    assert_faults(
        &blocks("[]"),
        &["2:11: blocks: must be a non-empty list of blocks, got []"],
    );
    assert_faults(
        &blocks("{}"),
        &["2:11: blocks: must be a list, got an object"],
    );
    assert_faults(
        &blocks("[{}, {\"when\": 1}]"),
        &[
            "2:12: blocks[0].parameters: missing",
            "2:16: blocks[1].parameters: missing",
        ],
    );
    assert_faults(
        &blocks(&format!(
            "[{{\"parameters\": {{{GOOD}}}}},\n{{\"parameters\": {{{GOOD}, \"x0\": 0}}}}]"
        )),
        &["3:108: blocks[1].parameters.x0: must be not 0, got 0"],
    );
}

/// A study of bars with these parameters and other keys.
fn bars(parameters: &str, other_keys: &str) -> String {
    format!(
        "{{\"problem\": \"bar-impact\", \"parameters\":\n{{\"gamma\": 1, \"duration\": 1.5, {parameters}}}{other_keys}}}"
    )
}

/// Each `§` is before a value with a fault, in the order of the expected ones.
#[track_caller]
fn assert_marked(text: &str, expected: &[&str]) {
    let (mut line, mut column, mut marks) = (1, 1, Vec::new());
    for c in text.chars() {
        match c {
            '§' => marks.push(format!("{line}:{column}")),
            '\n' => (line, column) = (line + 1, 1),
            _ => column += 1,
        }
    }
    assert_eq!(marks.len(), expected.len(), "{text}");
    let marked: Vec<String> = marks
        .iter()
        .zip(expected)
        .map(|(mark, message)| format!("{mark}: {message}"))
        .collect();
    let expected: Vec<&str> = marked.iter().map(String::as_str).collect();
    assert_faults(&text.replace('§', ""), &expected);
}

#[test]
fn expressions_of_parameters() {
    for (parameters, expected) in [
        (
            r#""n": 5, "dt": §"0.5/m""#,
            r#"parameters.dt: "0.5/m": unknown name "m"; allowed: pi, e, sqrt"#,
        ),
        (
            r#""n": 5, "dt": §"0.5/k_I""#,
            r#"parameters.dt: "0.5/k_I": k_I is not given in this block"#,
        ),
        (
            r#""n": [5, 10], "dt": §"1/(n - 10.5)""#,
            r#"parameters.dt: must be > 0, got "1/(n - 10.5)" = -0.18181818181818182 with n = 5"#,
        ),
        (
            r#""n": [11, 10], "dt": §"1/(n - 10)""#,
            r#"parameters.dt: "1/(n - 10)" with n = 10: must be finite, got inf"#,
        ),
        (
            r#""n": §"3/gamma + 0.5", "dt": 0.1"#,
            r#"parameters.n: must be a whole number from 1 to 1000000, got "3/gamma + 0.5" = 3.5 with gamma = 1"#,
        ),
        (
            r#""n": §"50*dt", "dt": "gap", "gap": "1/n""#,
            r#"parameters.n: circular reference: n -> dt -> gap -> n"#,
        ),
        (
            r#""n": 5, "dt": §"duration > 1""#,
            r#"parameters.dt: "duration > 1": must be a number"#,
        ),
        (
            r#""n": {"range": [5, §"2*gamma", 1]}, "dt": 0.1"#,
            r#"parameters.n.range[1]: "2*gamma": names gamma; an expression with names of parameters is allowed as the value"#,
        ),
        (
            r#""n": 10, "dt": 0.1, "k_I": §"50 * gamma""#,
            r#"parameters.k_I: gives 50, but 100 follows from the other parameters"#,
        ),
        (
            r#""n": 10, "dt": 0.1, "k_I": §"10 * n""#,
            r#"parameters.k_I: cannot be given together with gamma"#,
        ),
        (
            r#""n": [2, 4], "dt": §"0.4*n""#,
            r#"parameters.dt: must be at most duration = 1.5, got 1.6"#,
        ),
    ] {
        assert_marked(&bars(parameters, ""), &[expected]);
    }
}

#[test]
fn groups_and_conditions() {
    let axes = r#""n": [2, 4, 8], "dt": [0.1, 0.2, 0.3], "gap": [0, 1], "mass": "lumped""#;
    for (other_keys, expected) in [
        (
            r#""zip": §3"#,
            &["zip: must be a list of lists of parameters"][..],
        ),
        (
            r#""zip": [§["n"], §["dt", "gap"], ["n", §"mas"], ["n", §"mass"], ["n", §"n"]]"#,
            &[
                "zip[0]: needs at least two parameters",
                "zip[1]: needs the same number of values of each; dt has 3, gap has 2",
                "zip[2][1]: unknown parameter \"mas\", did you mean \"mass\"?",
                "zip[3][1]: \"mass\" has one value, not a list",
                "zip[4][1]: \"n\" is in a group already",
            ],
        ),
        (
            r#""zip": [["n", "dt"], [§"dt", §"E"]]"#,
            &[
                "zip[1][0]: \"dt\" is in a group already",
                "zip[1][1]: \"E\" is not given in this block",
            ],
        ),
        (r#""when": §"n""#, &["when: \"n\": must be a condition"]),
        (
            r#""when": §"n > 100""#,
            &["when: \"n > 100\": no combination meets it"],
        ),
        (
            r#""when": §"gap/k_I > 1""#,
            &["when: \"gap/k_I > 1\": k_I is not given in this block"],
        ),
        (
            r#""when": §"1/gap > 1""#,
            &["when: \"1/gap > 1\" with gap = 0: must be finite, got inf"],
        ),
        (
            r#""blocks": §[], "when": "n > 1""#,
            &["blocks: cannot be given together with \"parameters\""],
        ),
    ] {
        assert_marked(&bars(axes, &format!(",{other_keys}")), expected);
    }
    assert_marked(
        "{\"problem\": \"bar-impact\", \"blocks\": [{\"parameters\": {\"gamma\": 1, \"n\": 2, \"dt\": 0.1, \"duration\": 1}}],\n\"when\": §\"n > 1\"}",
        &["when: must be inside a block, next to its \"parameters\""],
    );
}

#[test]
fn designs() {
    for (parameters, other_keys, expected) in [
        (
            r#""n": §{"uniform": [2, 40]}, "dt": §{"loguniform": [0.01, 0.1]}"#,
            "",
            &[
                "parameters.n: needs a \"design\" next to \"parameters\"",
                "parameters.dt: needs a \"design\" next to \"parameters\"",
            ][..],
        ),
        (
            r#""n": {"uniform": [2, 40]}, "dt": {"loguniform": [0.01, 0.1]}"#,
            r#", "design": {"kind": §"sobel", "n": §0.5, "seed": §-1}"#,
            &[
                "design.kind: unknown kind \"sobel\", did you mean \"sobol\"?",
                "design.n: must be a whole number from 2 to 1000000, got 0.5",
                "design.seed: must be a whole number from 0 to 9007199254740992, got -1",
            ],
        ),
        (
            r#""n": {"uniform": [40, §2]}, "dt": {"loguniform": [§0, 0.1]}"#,
            r#", "design": {"kind": "sobol", "n": 4}"#,
            &[
                "parameters.n.uniform[1]: must be greater than a",
                "parameters.dt.loguniform[0]: must be > 0, got 0",
            ],
        ),
        (
            r#""n": {"uniform": [2, 40], "linspace": §[1, 2, 3]}, "dt": {"uniform": §3}, "mass": §{"uniform": [1, 2]}"#,
            r#", "design": {"kind": "sobol", "n": 4}"#,
            &[
                "parameters.n.linspace: unknown key \"linspace\"; allowed: uniform, loguniform",
                "parameters.dt.uniform: must be [a, b], got 3",
                "parameters.mass.uniform: must be a name or a list of names",
            ],
        ),
        (
            r#""n": {"uniform": [2, 40]}, "dt": [0.1, 0.2]"#,
            r#", "design": §{"kind": "saltelli", "n": 4}"#,
            &["design: a saltelli design allows no other axis"],
        ),
        (
            r#""n": 2, "dt": 0.1"#,
            r#", "design": §{"kind": "sobol", "n": 4}"#,
            &["design: samples nothing"],
        ),
    ] {
        assert_marked(&bars(parameters, other_keys), expected);
    }
    let late = faults(&bars(
        r#""n": {"uniform": [2, 40]}, "dt": {"uniform": [0.1, 2]}"#,
        r#", "design": {"kind": "sobol", "n": 64}"#,
    ));
    assert!(!late.is_empty());
    for fault in late {
        let rule = "2:64: parameters.dt: must be at most duration = 1.5, got ";
        assert!(fault.starts_with(rule), "{fault}");
    }
}

#[test]
fn too_many_cases_are_counted_not_made() {
    let thousand = vec!["1"; 1001].join(",");
    let text = format!(
        "{{\"problem\": \"friction-oscillator\",\n\"parameters\": {{\"law\": \"displacement-control\", \"alpha\": [{thousand}], \"dT\": [{thousand}], \"duration\": [{thousand}]}}}}"
    );
    assert_faults(
        &text,
        &["2:15: parameters: 1003003001 cases; allowed: at most 1000000000"],
    );
}

#[test]
fn figures() {
    let figure = |keys: &str| with(GOOD, &format!(", \"figures\": [\n{{{keys}}}]"));
    for (keys, expected) in [
        (
            "",
            &[
                "6:1: figures[0].kind: missing",
                "6:1: figures[0].name: missing",
            ][..],
        ),
        (
            "\"name\": \"a\", \"kind\": \"histroy\"",
            &[
                "6:23: figures[0].kind: unknown kind \"histroy\", did you mean \"history\"?; allowed: history, curve, orbit, response, profile, wave, metric, convergence, budget, map, scatter, front, envelope, samples, sobol, distribution, quantiles, fragility, law, spectrum, set, scheme",
            ],
        ),
        (
            "\"name\": \"a/b\", \"kind\": \"law\"",
            &["6:10: figures[0].name: must be 1 to 100 letters"],
        ),
        (
            "\"name\": \"-b\", \"kind\": \"law\"",
            &["6:10: figures[0].name: must be"],
        ),
        (
            "\"name\": \"a\", \"kind\": \"law\", \"z\": \"alpha\"",
            &["6:35: figures[0].z: a law figure has no key \"z\"; kinds with this key: map"],
        ),
        (
            "\"name\": \"a\", \"kind\": \"law\", \"wher\": {}",
            &["6:38: figures[0].wher: unknown key \"wher\", did you mean \"where\"?"],
        ),
        (
            "\"name\": \"a\", \"kind\": \"profile\", \"times\": [1]",
            &["6:23: figures[0].kind: friction-oscillator has no profiles"],
        ),
        (
            "\"name\": \"a\", \"kind\": \"wave\"",
            &[
                "6:23: figures[0].kind: friction-oscillator has no profiles; allowed: history, curve, metric, convergence, budget, map, scatter, front, envelope, samples, sobol, distribution, quantiles, fragility, law",
            ],
        ),
        (
            "\"name\": \"a\", \"kind\": \"history\", \"y\": [\"X\", \"Y\"]",
            &["6:45: figures[0].y[1]: unknown quantity \"Y\""],
        ),
        (
            "\"name\": \"a\", \"kind\": \"history\", \"by\": \"beta\"",
            &["6:40: figures[0].by: beta applies to none of the cases shown"],
        ),
        (
            "\"name\": \"a\", \"kind\": \"history\", \"where\": {\"alpha\": 3}",
            &["6:43: figures[0].where: no case has alpha = 3; the values are 0.1, 1"],
        ),
        (
            "\"name\": \"a\", \"kind\": \"history\", \"where\": {\"alpha\": [1, 3, -1, []]}",
            &[
                "6:57: figures[0].where.alpha[1]: no case has alpha = 3; the values are 0.1, 1",
                "6:60: figures[0].where.alpha[2]: must be > 0, got -1",
                "6:64: figures[0].where.alpha[3]: must be a number",
            ],
        ),
        (
            "\"name\": \"a\", \"kind\": \"history\", \"where\": {\"alpha\": []}",
            &["6:53: figures[0].where.alpha: must be a value or a non-empty list, got []"],
        ),
        (
            "\"name\": \"a\", \"kind\": \"metric\"",
            &["6:1: figures[0].x: missing", "6:1: figures[0].y: missing"],
        ),
        (
            "\"name\": \"a\", \"kind\": \"metric\", \"x\": \"law\", \"y\": \"rms\"",
            &[
                "6:38: figures[0].x: must be a parameter that is a number, got \"law\"",
                "6:50: figures[0].y: unknown metric \"rms\", did you mean \"rms_error\"?",
            ],
        ),
        (
            "\"name\": \"a\", \"kind\": \"map\", \"x\": \"x0\", \"y\": \"x0\", \"z\": \"rms_error\"",
            &[
                "6:1: figures[0].where: a map shows one case at each point, but alpha varies",
                "6:46: figures[0].y: must be a parameter other than x",
            ],
        ),
        (
            "\"name\": \"a\", \"kind\": \"budget\"",
            &["6:1: figures[0].x: missing"],
        ),
        (
            "\"name\": \"a\", \"kind\": \"budget\", \"x\": \"law\", \"y\": \"rdot\"",
            &[
                "6:38: figures[0].x: must be a parameter that is a number, got \"law\"",
                "6:50: figures[0].y: unknown budget \"rdot\"; allowed: X",
            ],
        ),
        (
            "\"name\": \"a\", \"kind\": \"law\"}, {\"name\": \"A\", \"kind\": \"law\"",
            &["6:40: figures[1].name: \"A\" is the name of an earlier figure"],
        ),
    ] {
        assert_faults(&figure(keys), expected);
    }
    let many = GOOD.replace("[0.1, 1]", "[1, 2, 3, 4, 5, 6, 7, 8, 9]");
    let history = |more: &str| {
        with(
            &many,
            &format!(", \"figures\": [\n{{\"name\": \"a\", \"kind\": \"history\"{more}}}]"),
        )
    };
    assert_faults(
        &history(""),
        &["6:1: figures[0].where: more than 8 cases in one panel; narrow"],
    );
    assert_faults(&history(", \"panels\": \"alpha\""), &[]);
    let signs = GOOD.to_owned() + ", \"x0\": [-12, 12]";
    let scale = ", \"figures\": [\n{\"name\": \"a\", \"kind\": \"metric\", \"x\": \"x0\", \"y\": \"rms_error\", \"x_scale\": \"log\"}]";
    assert_faults(
        &with(&signs, scale),
        &["6:73: figures[0].x_scale: a log scale needs numbers > 0, but x0 is -12"],
    );
}

#[test]
fn widths_and_limits_of_figures() {
    let metric = r#""kind": "metric", "x": "alpha", "y": "rms_error""#;
    for (keys, expected) in [
        (
            r#""kind": "law", "width": §60"#,
            "figures[0].width: must be a width in mm from 70 to 400, got 60",
        ),
        (
            r#""kind": "law", "width": §"4*200""#,
            "figures[0].width: must be a width in mm from 70 to 400, got",
        ),
        (r#""kind": "law", "width": §"90 mm""#, "figures[0].width: "),
        (
            r#""kind": "law", "x_range": §[0, 1]"#,
            "figures[0].x_range: a law figure has no key \"x_range\"; kinds with this key: history, curve, response, profile, wave, metric, convergence, budget, scatter, front, envelope",
        ),
        (
            r#""kind": "history", "x_range": §[3, 3]"#,
            "figures[0].x_range: the first value must be less than the last, got 3 and 3",
        ),
        (
            r#""kind": "history", "x_range": §["2*pi"]"#,
            "figures[0].x_range: must be a list of two numbers",
        ),
        (
            r#""kind": "history", "y_range": §[0, 1]"#,
            "figures[0].y_range: takes one quantity in \"y\", and the figure has 2",
        ),
        (
            &format!(r#"{metric}, "x_scale": "log", "x_range": [§0, 1]"#),
            "figures[0].x_range[0]: must be > 0 on a log scale, got 0",
        ),
        (
            r#""kind": "convergence", "y": "rms_error", "y_range": [§-1, 1]"#,
            "figures[0].y_range[0]: must be > 0 on a log scale, got -1",
        ),
    ] {
        let figure = format!(", \"figures\": [\n{{\"name\": \"a\", {keys}}}]");
        assert_marked(&with(GOOD, &figure), &[expected]);
    }
    let good = format!(r#"{metric}, "x_range": [0.01, "1/2"], "y_range": [-1, 2], "width": 84.5"#);
    let figure = format!(", \"figures\": [{{\"name\": \"a\", {good}}}]");
    assert_faults(&with(GOOD, &figure), &[]);
    let samples = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control", "duration": 3,
        "beta": {"uniform": [1, 2]}, "dT": {"uniform": [0.1, 0.5]}, "x0": {"uniform": [3, 15]}},
        "design": {"kind": "sobol", "n": 8},
        "figures": [{"name": "a", "kind": "samples", "y": "rms_error", "width": §89}]}"#;
    let least = "figures[0].width: must be at least 90 for 3 sampled parameters, got 89";
    assert_marked(samples, &[least]);
    assert_faults(&samples.replace("§89", "90"), &[]);
}

#[test]
fn figures_along_the_bars() {
    let bars = |keys: &str| {
        format!(
            "{{\"problem\": \"bar-impact\",\n\"parameters\": {{\"gamma\": [1, 2, 3, 4, 5, 6, 7], \"n\": 4, \"dt\": 0.1, \
             \"duration\": [1, 2]}},\n\"figures\": [\n{{\"name\": \"a\", {keys}}}]}}"
        )
    };
    for (keys, expected) in [
        (
            "\"kind\": \"profile\", \"where\": {\"gamma\": 1}, \"times\": [0, 1, 1.5, 3]",
            &[
                "4:73: figures[0].times[2]: must be at most duration = 1, got 1.5",
                "4:78: figures[0].times[3]: must be at most duration = 1, got 3",
            ][..],
        ),
        (
            "\"kind\": \"profile\", \"where\": {\"gamma\": 1, \"duration\": 2}, \"times\": 3",
            &["4:81: figures[0].times: must be at most duration = 2, got 3"],
        ),
        (
            "\"kind\": \"profile\", \"times\": [-1]",
            &["4:44: figures[0].times[0]: must be >= 0, got -1"],
        ),
        (
            "\"kind\": \"profile\", \"times\": 1",
            &["4:1: figures[0].where: more than 6 cases in one panel; narrow"],
        ),
        (
            "\"kind\": \"wave\", \"where\": {\"gamma\": 1}",
            &["4:40: figures[0].where: a wave figure shows one case, but more are chosen; narrow"],
        ),
        (
            "\"kind\": \"wave\", \"where\": {\"gamma\": 1, \"duration\": 2}, \"y\": \"strain\"",
            &["4:74: figures[0].y: unknown profile \"strain\""],
        ),
        (
            "\"kind\": \"wave\", \"where\": {\"gamma\": 1, \"duration\": 2}",
            &[],
        ),
    ] {
        assert_faults(&bars(keys), expected);
    }
}

#[test]
fn checks_and_metrics() {
    let check = |keys: &str| with(GOOD, &format!(", \"checks\": [\n{{{keys}}}]"));
    for (keys, expected) in [
        (
            "",
            &[
                "6:1: checks[0].metric: missing",
                "6:1: checks[0]: missing: \"min\"",
            ][..],
        ),
        (
            "\"metric\": \"rms_eror\", \"max\": 1",
            &["6:12: checks[0].metric: unknown metric \"rms_eror\", did you mean \"rms_error\"?"],
        ),
        (
            "\"metric\": \"rms_error\", \"min\": 2, \"max\": 1",
            &["6:42: checks[0].max: must be >= min = 2, got 1"],
        ),
        (
            "\"metric\": \"rms_error\", \"min\": \"1/0\"",
            &["6:32: checks[0].min: \"1/0\": must be finite"],
        ),
        (
            "\"metric\": \"rms_error\", \"max\": 1, \"where\": {\"alpha\": \"1/5\"}",
            &["6:44: checks[0].where: no case has alpha = 0.2"],
        ),
        (
            "\"metric\": \"rms_error\", \"max\": 1, \"where\": {\"alpha\": -1}",
            &["6:54: checks[0].where.alpha: must be > 0, got -1"],
        ),
        (
            "\"metric\": \"rms_error\", \"max\": 1, \"where\": {\"alpha\": \"1/10\", \"x0\": 12}",
            &[],
        ),
    ] {
        assert_faults(&check(keys), expected);
    }
    assert_faults(
        &with(GOOD, ",\n\"metrics\": [\"x0\"]"),
        &["6:13: metrics[0]: unknown metric \"x0\""],
    );
    assert_faults(
        &with(GOOD, ",\n\"checks\": {}"),
        &["6:11: checks: must be a list, got an object"],
    );
}

#[test]
fn every_fault_comes_at_once_in_file_order() {
    let text = "{\r\n\"title\": \"αβγ\", \"checks\": [{\"metric\": \"rms\", \"max\": 0}],\r\n\
                \"parameters\": {\"law\": \"displacement-control\", \"alpha\": [0.1, \"pi/\", -1], \"dT\": 1e999},\r\n\
                \"problem\": \"friction-oscillator\"}";
    assert_faults(
        text,
        &[
            "2:39: checks[0].metric: unknown metric \"rms\"",
            "3:15: parameters.duration: missing: end of the motion",
            "3:62: parameters.alpha[1]: \"pi/\": expected a number",
            "3:69: parameters.alpha[2]: must be > 0, got -1",
            "3:80: parameters.dT: must be a finite number, got 1e999",
        ],
    );
}

#[test]
fn files() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("s.json");
    assert!(matches!(read(&file), Err(Error::Io { .. })));
    std::fs::write(&file, b"{\n \"title\": \"\xff\"}").unwrap();
    let said = read(&file).unwrap_err();
    assert!(matches!(said, Error::Faults(_)));
    assert!(
        said.to_string()
            .ends_with("s.json:2:12: not UTF-8: byte 0xff; save the file as UTF-8"),
        "{said}"
    );
    std::fs::write(&file, with(GOOD, "")).unwrap();
    let study = read(&file).unwrap();
    assert_eq!(study.len(), 2);
    assert_eq!(study.sha256.len(), 64);
}

/// A study that uses every part of the language.
fn whole_study() -> String {
    with(
        &GOOD.replace("\"pi/10\"", "[\"pi/10\", \"pi/5\"]"),
        ",\n\"title\": \"t\", \"//\": \"remark\", \"metrics\": [\"rms_error\"],\n\"figures\": [\n\
         {\"name\": \"a\", \"kind\": \"history\", \"by\": \"alpha\", \"where\": {\"x0\": \"12\", \"dT\": \"pi/10\"}},\n\
         {\"name\": \"b\", \"kind\": \"metric\", \"x\": \"alpha\", \"y\": [\"rms_error\"], \"x_scale\": \"log\"},\n\
         {\"name\": \"c\", \"kind\": \"map\", \"x\": \"alpha\", \"y\": \"dT\", \"z\": \"max_error\"},\n\
         {\"name\": \"d\", \"kind\": \"law\"}],\n\
         \"checks\": [{\"metric\": \"rms_error\", \"where\": {\"alpha\": 0.1}, \"min\": 0, \"max\": \"1/2\"}]",
    )
}

/// A study with every other key of a block, for mutations as well.
const LANGUAGE: &str = r#"{ "problem": "bar-impact", "blocks": [
  { "parameters": { "gamma": [0.5, 1, 2], "n": [2, 4, 8], "dt": "0.1/max(n, 2)", "gap": {"range": [0, 1, 0.5]}, "duration": "1 + dt",
    "mass": ["lumped", "consistent"] }, "zip": [["gamma", "n"]], "when": "gap < 0.75 and (n != 4 or mass == 'lumped')" },
  { "parameters": { "k_I": {"loguniform": [10, "10^3"]}, "n": {"uniform": [2, 9]}, "dt": 0.01, "duration": 1,
    "right": {"L": "2*L"} }, "design": {"kind": "saltelli", "n": 4, "seed": 7} },
  { "parameters": { "gamma": {"uniform": [1, 2]}, "n": 2, "dt": 0.1, "duration": 1, "V0": [0.1, 0.2] },
    "design": {"kind": "latin-hypercube", "n": 3} } ],
  "figures": [ { "name": "a", "kind": "sobol", "y": "peak_force", "where": {"right.L": 20} },
    { "name": "b", "kind": "metric", "x": "n", "y": "max_overlap", "by": "mass", "where": {"gap": 0.5} } ] }
"#;

#[test]
fn the_studies_that_the_mutations_start_from_are_good() {
    assert_faults(&whole_study(), &[]);
    assert_faults(LANGUAGE, &[]);
}

proptest! {
    #[test]
    fn no_text_makes_it_panic(text in any::<String>()) {
        let _ = parse("s.json", &text);
    }

    #[test]
    fn no_mutation_makes_it_panic(
        edits in prop::collection::vec((0usize..2000, 0usize..40, "[\\[\\]{}\",:0-9a-zα.*/^()\\\\ \n-]{0,6}"), 1..4)
    ) {
        for study in [whole_study(), LANGUAGE.to_owned()] {
        let mut text: Vec<char> = study.chars().collect();
        for (at, cut, put) in edits.clone() {
            let at = at % (text.len() + 1);
            let end = (at + cut % 12).min(text.len());
            text.splice(at..end, put.chars());
        }
        let text: String = text.into_iter().collect();
        every_fault_has_a_place(&text)?;
        }
    }

    #[test]
    fn no_exchange_of_words_makes_it_panic(
        edits in prop::collection::vec((any::<prop::sample::Index>(), prop::sample::select(WORDS)), 1..5)
    ) {
        for study in [whole_study(), LANGUAGE.to_owned()] {
            let mut words = words(&study);
            for (at, word) in &edits {
                let at = at.index(words.len());
                words[at] = (*word).to_owned();
            }
            every_fault_has_a_place(&words.concat())?;
        }
    }
}

/// What takes the place of words of a good study.
const WORDS: &[&str] = &[
    "{}",
    "[]",
    "[[1]]",
    "[1, 2, 3]",
    "{\"alpha\": 1}",
    "{\"right\": {}}",
    "1e999",
    "-1",
    "0",
    "2.5",
    "true",
    "null",
    "\"\"",
    "\"pi/\"",
    "\"1/0\"",
    "\"(((\"",
    "\"alpha\"",
    "\"beta\"",
    "\"law\"",
    "\"x\"",
    "\"y\"",
    "\"z\"",
    "\"by\"",
    "\"panels\"",
    "\"where\"",
    "\"kind\"",
    "\"map\"",
    "\"law\"",
    "\"profile\"",
    "\"wave\"",
    "\"metric\"",
    "\"history\"",
    "\"log\"",
    "\"blocks\"",
    "\"zip\"",
    "\"when\"",
    "\"design\"",
    "\"n\"",
    "\"gap\"",
    "\"n + gap\"",
    "\"n > 2\"",
    "\"1/gap\"",
    "\"gamma*dt\"",
    "{\"uniform\": [1, 2]}",
    "[[\"n\", \"gap\"]]",
    "\"sobol\"",
    "\"//\"",
    "\"x0\"",
    "\"rms_error\"",
    "\"velocity-control\"",
    "\"αβγ\\n\"",
    "[\"velocity-control\", \"displacement-control\"]",
    "[-1, 1]",
    "[1, 2, 3, 4, 5, 6, 7, 8, 9]",
];

/// Strings, numbers and the text between them.
fn words(text: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let (mut quoted, mut number) = (false, false);
    for c in text.chars() {
        let numeric = !quoted && (c.is_ascii_digit() || c == '.');
        let opens = (c == '"' && !quoted) || (numeric && !number);
        if opens || (number && !numeric) {
            words.push(String::new());
        }
        words.last_mut().unwrap().push(c);
        if c == '"' {
            quoted = !quoted;
            if !quoted {
                words.push(String::new());
            }
        }
        number = numeric;
    }
    words
}

fn every_fault_has_a_place(text: &str) -> Result<(), TestCaseError> {
    let Err(Error::Faults(faults)) = parse("s.json", text) else {
        return Ok(());
    };
    prop_assert!(!faults.is_empty());
    for fault in &faults {
        prop_assert!(!fault.to_string().contains('\n'), "{}", fault);
        let line = text.split('\n').nth(fault.line - 1);
        let columns = line.map(|line| line.chars().count() + 1);
        prop_assert!(
            columns.is_some_and(|columns| (1..=columns).contains(&fault.column)),
            "{}",
            fault
        );
    }
    let in_order = faults.is_sorted_by_key(|fault| (fault.line, fault.column));
    prop_assert!(in_order, "{faults:?}");
    Ok(())
}

#[test]
fn units_are_named_completely_and_in_letters() {
    let bars = |more: &str| {
        format!(
            "{{\n\"problem\": \"bar-impact\",\n\"parameters\": {{\"gamma\": 1, \"n\": 4, \"dt\": 0.1, \"duration\": 2}},\n{more}\n}}"
        )
    };
    let units = "\"length\": \"m\", \"force\": \"kN\", \"time\": \"s\"";
    assert_faults(&bars(&format!("\"units\": {{{units}}}")), &[]);
    assert_faults(
        &bars(&format!("\"units\": {{{}}}", units.replace("kN", "µN2"))),
        &[],
    );
    assert_faults(
        &bars(&format!("\"units\": {{{units}, \"mass\": \"t\"}}")),
        &["4:62: units.mass: unknown key \"mass\""],
    );
    let named =
        "must be the name of a unit: 1 to 16 letters, digits and µ, first a letter or µ, got";
    for (label, shown) in [
        ("", "\"\""),
        ("k N", "\"k N\""),
        ("N/m", "\"N/m\""),
        ("2N", "\"2N\""),
        ("*N*", "\"*N*\""),
        ("kg_m", "\"kg_m\""),
        ("abcdefghijklmnopq", "\"abcdefghijklmnopq\""),
    ] {
        assert_faults(
            &bars(&format!("\"units\": {{{}}}", units.replace("kN", label))),
            &[&format!("4:35: units.force: {named} {shown}")],
        );
    }
    assert_faults(
        &bars("\"units\": {\"force\": 3}"),
        &[
            "4:10: units.length: missing: name of the unit of length",
            "4:10: units.time: missing: name of the unit of time",
            "4:20: units.force: must be a string, got 3",
        ],
    );
    assert_faults(
        &bars("\"units\": \"SI\""),
        &["4:10: units: must be an object with keys from length, force, time, got \"SI\""],
    );
    // The parameters of friction have no units.
    assert_faults(
        &with(GOOD, &format!(",\n\"units\": {{{units}}}")),
        &[
            "6:10: units: friction-oscillator has no units: all its parameters and results are dimensionless",
        ],
    );
}

#[test]
fn results_in_units_need_the_units_of_the_study() {
    let bars = |more: &str| {
        format!(
            "{{\n\"problem\": \"bar-impact\",\n\"parameters\": {{\"gamma\": 1, \"n\": 4, \"dt\": 0.1, \"duration\": 2}},\n{more}\n}}"
        )
    };
    let units = "\"units\": {\"length\": \"m\", \"force\": \"kN\", \"time\": \"s\"},\n";
    let check = |metric: &str| format!("\"checks\": [{{\"metric\": \"{metric}\", \"max\": 1}}]");
    let figure = |in_units: &str| {
        format!(
            "\"figures\": [{{\"name\": \"f\", \"kind\": \"history\", \"in_units\": {in_units}}}]"
        )
    };
    let needs = "results in units need the key \"units\" of the study";
    assert_faults(
        &bars(&check("peak_force_in_kN")),
        &[&format!(
            "4:23: checks[0].metric: unknown metric \"peak_force_in_kN\": {needs}; allowed: contact_duration"
        )],
    );
    assert_faults(
        &bars(&figure("true")),
        &[&format!("4:58: figures[0].in_units: {needs}")],
    );
    assert_faults(&bars(&figure("false")), &[]);
    assert_faults(
        &bars(&figure("1")),
        &["4:58: figures[0].in_units: must be true or false, got 1"],
    );
    for good in [check("peak_force_in_kN"), figure("true")] {
        assert_faults(&bars(&format!("{units}{good}")), &[]);
    }
    // Another unit than the one that the study names, and a metric without a dimension.
    assert_faults(
        &bars(&format!("{units}{}", check("peak_force_in_N"))),
        &[
            "5:23: checks[0].metric: unknown metric \"peak_force_in_N\", did you mean \"peak_force_in_kN\"?",
        ],
    );
    let none = faults(&bars(&format!("{units}{}", check("restitution_in_m"))));
    assert!(none[0].starts_with("5:23: checks[0].metric: unknown metric \"restitution_in_m\""));
}

#[test]
fn ensembles() {
    let study = |parameters: &str, keys: &str| {
        format!(
            "{{\n\"problem\": \"bar-impact\",\n\"parameters\": {{ {parameters} }},\n{keys}\n}}\n"
        )
    };
    let plain = r#""gamma": [1, 2], "n": [4, 8], "gap": [0, 0.1], "dt": "0.1/n", "duration": 1"#;
    let sampled = r#""gamma": {"uniform": [1, 2]}, "gap": {"uniform": [0, 0.1]}, "n": [4, 8], "dt": 0.01, "duration": 1"#;
    for (parameters, keys, expected) in [
        (plain, r#""ensemble": "gap""#, &[][..]),
        (plain, r#""ensemble": ["gap", "n"]"#, &[]),
        (
            plain,
            r#""ensemble": §"gop""#,
            &["ensemble: unknown parameter \"gop\", did you mean \"gap\"?"],
        ),
        (
            plain,
            r#""ensemble": ["gap", §"gap", §3]"#,
            &[
                "ensemble[1]: \"gap\" given twice",
                "ensemble[2]: must be a name in quotes",
            ],
        ),
        (
            plain,
            r#""ensemble": §[]"#,
            &["ensemble: must be the name of a parameter or a non-empty list of names, got []"],
        ),
        (
            plain,
            r#""ensemble": [§"duration", §"dt", §"k_I"]"#,
            &[
                "ensemble[0]: duration is 1 in all cases; an ensemble needs a parameter with several values",
                "ensemble[1]: dt is given by an expression; name the parameters that it follows from",
                "ensemble[2]: k_I is given in none of the cases",
            ],
        ),
        (
            r#""gamma": 1, "n": 4, "gap": {"linspace": [0, 0.1, 5000]}, "dt": {"linspace": [0.01, 0.02, 5000]}, "duration": 1"#,
            r#""ensemble": §"gap""#,
            &["ensemble: 25000000 combinations; a study with an ensemble has at most 10000000"],
        ),
        // Figures.
        (
            plain,
            r#""figures": [{"name": "a", "kind": §"distribution", "y": "peak_force"}]"#,
            &[
                "figures[0].kind: a distribution figure needs the key \"ensemble\" of the study, as in \"ensemble\": \"seed\"",
            ],
        ),
        // The fault of the key alone.
        (
            plain,
            r#""ensemble": §"gop", "figures": [{"name": "a", "kind": "quantiles", "x": "gap", "y": "peak_force"}]"#,
            &["ensemble: unknown parameter"],
        ),
        (
            plain,
            r#""ensemble": "gap", "figures": [{"name": "a", "kind": "quantiles", "x": §"gap", "y": "peak_force"}]"#,
            &["figures[0].x: gap is a parameter of the ensemble; choose another one"],
        ),
        (
            plain,
            r#""ensemble": "n", "figures": [{"name": "a", "kind": "fragility", "x": §"dt", "by": §"n", "y": "peak_force", "limit": 1}]"#,
            &[
                "figures[0].x: dt changes with the ensemble over n; choose another one",
                "figures[0].by: n is a parameter of the ensemble; choose another one",
            ],
        ),
        (
            sampled,
            r#""design": {"kind": "sobol", "n": 8}, "ensemble": "gap", "figures": [{"name": "a", "kind": "quantiles", "x": §"gamma", "y": "peak_force"}]"#,
            &["figures[0].x: gamma changes with the ensemble over gap; choose another one"],
        ),
        (
            plain,
            r#""ensemble": "gap", "figures": [§{"name": "a", "kind": "distribution", "by": "n", "y": "peak_force"}]"#,
            &[
                "figures[0].where: a distribution figure with \"by\" shows one ensemble for each value of it, but gamma varies; choose one value in \"where\" or leave out \"by\"",
            ],
        ),
        (
            plain,
            r#""ensemble": "gap", "figures": [{"name": "a", "kind": "distribution", "x_range": §[0, 1], "y": ["peak_force", "max_overlap"]}]"#,
            &["figures[0].x_range: takes one metric in \"y\", and the figure has 2"],
        ),
        (
            plain,
            r#""ensemble": "gap", "figures": [{"name": "a", "kind": "quantiles", "x": "gamma", "y": "peak_force", "band": §[-0.1, 0.5]},
               {"name": "b", "kind": "quantiles", "x": "gamma", "y": "peak_force", "band": §[0.5, 0.5]}]"#,
            &[
                "figures[0].band: must be two probabilities from 0 to 1, got -0.1 and 0.5",
                "figures[1].band: the first value must be less than the last, got 0.5 and 0.5",
            ],
        ),
        (
            plain,
            r#""ensemble": "gap", "figures": [{"name": "a", "kind": "quantiles", "x": "gamma", "by": §"gamma", "y": "peak_force"}]"#,
            &["figures[0].by: must be a parameter other than x"],
        ),
        (
            plain,
            r#""ensemble": "gap", "figures": [§{"name": "a", "kind": "fragility", "x": "gamma", "y": "peak_force"}]"#,
            &["figures[0].limit: missing"],
        ),
        (
            plain,
            r#""ensemble": "gap", "figures": [{"name": "a", "kind": "fragility", "x": "gamma", "y": "peak_force", "limit": 1, "collapse": §0.5, "against": §"gap"}]"#,
            &[
                "figures[0].collapse: must be at least the limit",
                "figures[0].against: needs \"fit\": incremental or cloud; a likelihood has no residuals",
            ],
        ),
        (
            plain,
            r#""ensemble": "gap", "figures": [{"name": "a", "kind": "fragility", "x": "gamma", "y": "peak_force", "limit": 1, "hazard": §[[1, 0.1]]},
               {"name": "b", "kind": "fragility", "x": "gamma", "y": "peak_force", "limit": 1, "hazard": [[1, 0.1], §[2]]},
               {"name": "c", "kind": "fragility", "x": "gamma", "y": "peak_force", "limit": 1, "hazard": [[1, 0.1], [2, §0]]},
               {"name": "d", "kind": "fragility", "x": "gamma", "y": "peak_force", "limit": 1, "hazard": [[1, 0.1], §[2, 0.2]]}]"#,
            &[
                "figures[0].hazard: must be a list of at least two points [x, annual frequency]",
                "figures[1].hazard[1]: must be a point [x, annual frequency]",
                "figures[2].hazard[1][1]: must be > 0, got 0",
                "figures[3].hazard[1]: must have a larger x and a smaller frequency than the point before",
            ],
        ),
    ] {
        assert_marked(&study(parameters, keys), expected);
    }
}

/// A structure with these parameters and further keys; the mass is on the spring `k`.
fn structure(parameters: &str, more: &str) -> String {
    format!(
        r#"{{ "problem": "structure", "parameters": {{ {parameters}, "dt": 0.01, "duration": 0.1 }},
"structure": {{ "masses": {{ "m": 1 }}, "springs": [{{ "between": ["ground", "m"], "k": "k" }}] }}, "metrics": ["peak(m)"]{more} }}"#
    )
}

#[test]
fn labels_are_texts_that_every_table_can_have() {
    let labelled = |label: &str| {
        structure(
            &format!(r#""soil": ["soft", "{label}"], "k": [1, 2]"#),
            r#", "zip": [["soil", "k"]]"#,
        )
    };
    for good in ["stiff", "a = b", "1-2", "soft + wet", "ü", "\\u00fc"] {
        assert_faults(&labelled(good), &[]);
    }
    for (bad, character) in [
        ("a\\nb", "U+000A"),
        ("a\\tb", "U+0009"),
        ("a\\u0000b", "U+0000"),
        ("a\\u001b[31mb", "U+001B"),
        ("a\\u202eb", "U+202E"),
    ] {
        let expected = format!(
            "1:60: parameters.soil[1]: must be a string of printable characters on one line, got {character}"
        );
        assert_faults(&labelled(bad), &[&expected]);
    }
    for formula in ["=cmd|x", "+1+cmd", "-x", "@SUM(A1)", " =1+1"] {
        let expected = format!(
            "1:60: parameters.soil[1]: must not begin with =, +, - or @, because a spreadsheet takes \"{formula}\" in results.csv for a formula"
        );
        assert_faults(&labelled(formula), &[&expected]);
    }
    // Of a block.
    let one = labelled("=a").replacen(r#""parameters": {"#, r#""blocks": [{ "parameters": {"#, 1);
    let blocks = one.replace(r#", "zip": [["soil", "k"]] }"#, " }").replace(
        r#""duration": 0.1 },"#,
        r#""duration": 0.1 }, "zip": [["soil", "k"]] }],"#,
    );
    assert_faults(
        &blocks,
        &["1:73: blocks[0].parameters.soil[1]: must not begin with"],
    );
}

#[test]
fn one_mistake_gives_one_message() {
    // A parameter whose value is faulty, in expressions of parameters, of the structure, of conditions, in figures and checks.
    let more = r#", "when": "k < 3 and p < 2", "figures": [{ "name": "f", "kind": "metric", "x": "p", "y": "peak(m)" }],
        "checks": [{ "metric": "peak(m)", "where": { "p": 1 }, "max": 9 }]"#;
    for (parameters, expected) in [
        (
            r#""k": "2*p", "p": "1+""#,
            "1:60: parameters.p: \"1+\": expected",
        ),
        (r#""k": "p", "p": [1, "x"]"#, "1:62: parameters.p[1]: "),
        (
            r#""k": "p", "p": "unknown""#,
            "1:58: parameters.p: \"unknown\": unknown name",
        ),
        (
            r#""k": "p", "p": { "k": 1 }"#,
            "1:65: parameters.p.k: unknown key \"k\"",
        ),
        (
            r#""k": { "linspace": [1, 2] }, "p": 1"#,
            "1:62: parameters.k.linspace: must be",
        ),
    ] {
        assert_faults(&structure(parameters, more), &[expected]);
    }
    // A law that is unknown decides which parameters have a value.
    let law = r#""law": "velocity-contrl", "beta": 1, "dT": "beta/2", "duration": "8*pi""#;
    for more in ["", ",\n\"when\": \"beta < 2\""] {
        assert_faults(&with(law, more), &["4:8: parameters.law: unknown law"]);
    }
    // Two mistakes give two.
    let two = r#""law": "velocity-contrl", "beta": 1, "dT": "1+", "duration": "8*pi""#;
    assert_faults(
        &with(two, ""),
        &[
            "4:8: parameters.law: unknown law",
            "4:44: parameters.dT: \"1+\"",
        ],
    );
}

#[test]
fn a_list_of_names_that_is_empty_says_so() {
    let text = structure(
        r#""k": 1"#,
        r#", "checks": [{ "metric": "foo", "max": 1 }, { "max": 1 }, { "metric": 3, "max": 1 }]"#,
    )
    .replace(r#""metrics": ["peak(m)"]"#, r#""metrics": []"#);
    let found = faults(&text);
    assert_eq!(found.len(), 3, "{found:#?}");
    assert!(
        found[0].ends_with("unknown metric \"foo\"; allowed: none"),
        "{found:#?}"
    );
    assert!(found[1].ends_with("missing: one of none"), "{found:#?}");
    assert!(
        found[2].contains("a name in quotes, one of none"),
        "{found:#?}"
    );
}

#[test]
fn a_reduction_says_what_it_lacks() {
    let folder = concat!(env!("SLIPGAP_ROOT"), "/tests/data/own_structure");
    let found = |reduce: &str, rest: &str| {
        let text = format!(
            "{{\n\"problem\": \"structure\", \"parameters\": {{ \"n\": [1, 2], \"x\": 0.5, \"dt\": 0.1, \"duration\": \"n + x\" }},\n\"structure\": {{ \"matrices\": {{ \"f\": {{ \"M\": \"frames.M.mtx\", \"K\": \"frames.K.mtx\", \"dofs\": \"frames.dofs.csv\",\n{reduce} }} }} }},\n{rest}\n}}"
        );
        let faults: Vec<String> = match parse(&format!("{folder}/s.json"), &text) {
            Err(Error::Faults(faults)) => faults.iter().map(ToString::to_string).collect(),
            Ok(_) => Vec::new(),
            Err(other) => vec![other.to_string()],
        };
        faults.concat()
    };
    let metrics = "\"metrics\": [\"peak(f.132.x)\"]";
    let compared = "\"metrics\": [\"reduction_error(f.132.x)\"]";
    for (reduce, rest, expected) in [
        (
            "\"reduce\": { \"modes\": -1 }",
            metrics,
            "reduce.modes: must be",
        ),
        (
            "\"reduce\": { \"modes\": 1.5 }",
            metrics,
            "reduce.modes: must be a whole number",
        ),
        (
            "\"reduce\": { \"modes\": \"x\" }",
            metrics,
            "reduce.modes: must be a whole number",
        ),
        (
            "\"reduce\": { \"up_to\": 0 }",
            metrics,
            "reduce.up_to: must be",
        ),
        (
            "\"reduce\": { \"modes\": 1, \"up_to\": 5 }",
            metrics,
            "give modes or up_to, not both",
        ),
        ("\"reduce\": {}", metrics, "missing: modes, or up_to"),
        ("\"reduce\": 5", metrics, "reduce: must be an object"),
        ("\"reduce\": { \"mode\": 5 }", metrics, "mode"),
        (
            "\"reduce\": { \"modes\": 5 }",
            "\"metrics\": [\"energy_error\"]",
            "no dof of f is kept",
        ),
        (
            "\"C\": \"frames.C.mtx\"",
            compared,
            "needs \"reduce\" in \"matrices\"",
        ),
    ] {
        let found = found(reduce, rest);
        assert!(found.contains(expected), "{reduce}: {found}");
    }
    for reduce in [
        "\"modes\": 1000",
        "\"modes\": \"n\"",
        "\"up_to\": 1e9",
        "\"up_to\": 1e-9",
    ] {
        let found = found(&format!("\"reduce\": {{ {reduce} }}"), compared);
        assert!(found.is_empty(), "{reduce}: {found}");
    }
}
