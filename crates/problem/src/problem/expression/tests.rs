use super::{ExpressionFault, Formula};
use crate::problem::numbers::parameter::{Default, Kind, Parameter, Range, Value};
use std::f64::consts::{E, PI};

const fn row(name: &'static str, kind: Kind) -> Parameter {
    Parameter::new([name, "", "1"], kind, Default::Required, "")
}

static TABLE: [Parameter; 4] = [
    row("right.L", Kind::Number(Range::Any)),
    row("n", Kind::Whole { min: 1, max: 9 }),
    row("law", Kind::Choice(&[("stick", ""), ("slip", "")])),
    row("E", Kind::Number(Range::Any)),
];

fn given(row: usize) -> Option<Value> {
    [
        Some(Value::Number(10.0)),
        Some(Value::Whole(4)),
        Some(Value::Name("slip")),
        None,
    ][row]
}

fn value(text: &str) -> f64 {
    let found = Formula::number(text, &TABLE).and_then(|formula| formula.value(&given));
    found.unwrap_or_else(|e| panic!("{text}: {e:?}"))
}

fn fault(text: &str) -> (usize, String) {
    let fault = Formula::number(text, &[])
        .and_then(|formula| formula.value(&|_| None))
        .expect_err(text);
    (fault.offset, fault.message)
}

#[test]
fn arithmetic_as_in_a_textbook() {
    for (text, expected) in [
        ("12", 12.0),
        (" 1.5e-3 ", 1.5e-3),
        ("1e3", 1000.0),
        (".5", 0.5),
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("2**3**2", 512.0),
        ("2^3^2", 512.0),
        ("(2^3)^2", 64.0),
        ("2^-3^2", 1.0 / 512.0),
        ("2*-3", -6.0),
        ("-2*-3", 6.0),
        ("--2", 2.0),
        ("+5", 5.0),
        ("8-3-2", 3.0),
        ("8/4/2", 1.0),
        ("1+2*3", 7.0),
        ("2*3^2", 18.0),
        ("sqrt(16) + 1", 5.0),
        ("max(1, 2) - min(3, 4)", -1.0),
        ("ln(e)", 1.0),
        ("abs(-3)", 3.0),
        ("pi/10", PI / 10.0),
        ("8*pi", 8.0 * PI),
        ("2*right.L", 20.0),
        ("2 * e", 2.0 * E),
    ] {
        assert_eq!(value(text), expected, "{text}");
    }
}

#[test]
fn faults_say_what_was_expected_and_where() {
    for (text, offset, says) in [
        ("", 0, "expected a number, a name or '('"),
        ("pi/", 3, "expected a number, a name or '(' after '/'"),
        ("pi/*2", 3, "after '/', got '*'"),
        ("2 pi", 2, "expected an operator, got 'p'"),
        ("2e", 1, "expected an operator, got 'e'"),
        ("(1", 2, "')' is missing"),
        ("1)", 1, "')' without '('"),
        ("()", 1, "after '(', got ')'"),
        ("sqrt 4", 5, "expected '(' after sqrt"),
        ("max(1)", 5, "needs two"),
        ("sqrt(-1)", 0, "must be finite, got NaN"),
        ("1/0", 1, "must be finite, got inf"),
        ("1/(1/0)", 4, "must be finite, got inf"),
        ("1e999", 0, "must be finite, got inf"),
        ("1/1e999", 2, "must be finite, got inf"),
        ("NaN", 0, "unknown name \"NaN\""),
        ("sqr(2)", 0, "unknown name \"sqr\"; allowed: pi, e, "),
        ("1,5", 1, "expected an operator, got ','"),
        (".", 0, "not a number"),
        ("1.2.3", 3, "expected an operator, got '.'"),
        ("2π", 1, "expected an operator, got 'π'"),
    ] {
        let (at, message) = fault(text);
        assert!(message.contains(says), "{text}: {message}");
        assert_eq!(at, offset, "{text}: {message}");
    }
}

#[test]
fn depth_is_limited_and_length_is_not() {
    for deep in ["(", "-", "2^", "sqrt("] {
        let (_, message) = fault(&deep.repeat(100_000));
        assert!(message.contains("deep"), "{message}");
    }
    assert_eq!(value(&("1".to_owned() + &"+1".repeat(100_000))), 100_001.0);
    assert_eq!(value(&("(".repeat(50) + "1" + &")".repeat(50))), 1.0);
    assert_eq!(value(&vec!["-1"; 300].join("*")), 1.0);
}

#[test]
fn conditions_compare_numbers_and_names() {
    for (text, expected) in [
        ("n < 5", true),
        ("n <= 4 and n >= 4", true),
        ("n != 4 or right.L == 10", true),
        ("not n > 3", false),
        ("!(n > 3) || law == 'slip'", true),
        ("law != \"slip\" && n == 4", false),
        ("'slip' == law", true),
        ("2*n + 1 > right.L - 2 and not law == 'stick'", true),
        ("1 < 2 or 1 < 2 and 2 < 1", true),
    ] {
        let found = Formula::condition(text, &TABLE).and_then(|formula| formula.value(&given));
        assert_eq!(found, Ok(f64::from(u8::from(expected))), "{text}");
    }
}

#[test]
fn kinds_are_told_apart_before_anything_is_computed() {
    let fault = |outcome: Result<Formula, ExpressionFault>| {
        let fault = outcome.expect_err("a fault");
        (fault.offset, fault.message)
    };
    for (text, offset, says) in [
        ("n", 0, "must be a condition, as in \"n > 2\""),
        ("n + (n > 2)", 2, "+ needs numbers"),
        ("law", 0, "must be a condition"),
        (
            "law == 3",
            4,
            "law is compared with a name in single quotes",
        ),
        (
            "law == 'slop'",
            7,
            "unknown law \"slop\"; allowed: stick, slip",
        ),
        ("law < 'slip'", 4, "< needs numbers"),
        ("n == 'slip'", 2, "== needs numbers"),
        ("n > 2 and 3", 6, "and joins conditions"),
        ("not 3", 0, "not needs a condition"),
        ("1 < n < 3", 6, "join two comparisons with and"),
        ("n = 3", 2, "write == to compare"),
        ("m > 3", 0, "unknown name \"m\""),
        ("law == 'slip", 7, "a ' is missing at the end"),
    ] {
        let (at, message) = fault(Formula::condition(text, &TABLE));
        assert!(message.contains(says), "{text}: {message}");
        assert_eq!(at, offset, "{text}: {message}");
    }
    let (_, message) = fault(Formula::number("n > 2", &TABLE));
    assert!(message.contains("must be a number"), "{message}");
    let absent = Formula::number("2*E", &TABLE).unwrap().value(&given);
    assert_eq!(absent.unwrap_err().message, "E has no value here");
    assert_eq!(
        Formula::number("n*right.L + n", &TABLE).unwrap().uses(),
        [1, 0]
    );
}

#[test]
fn names_with_brackets_come_before_functions() {
    let rows = ["max(a - b)", "max(a - b).S", "a"].map(|name| row(name, Kind::Number(Range::Any)));
    let of = |row: usize| Some(Value::Number([3.0, 5.0, 7.0][row]));
    for (text, expected) in [
        ("max(a - b)/2", 1.5),
        ("2*max(a - b).S", 10.0),
        ("max(max(a - b), a)", 7.0),
        ("a - max(a, max(a - b).S)", 0.0),
    ] {
        let formula = Formula::number(text, &rows).unwrap();
        assert_eq!(formula.value(&of), Ok(expected), "{text}");
    }
    let fault = Formula::number("max(a - b)/c", &rows).unwrap_err();
    assert_eq!(fault.offset, 11);
    assert!(fault.message.contains("unknown name \"c\""), "{fault}");
}
