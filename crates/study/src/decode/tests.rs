//! Tests with a small problem: parameters of an object, values that follow from others, rules across parameters.

use super::resolve::resolve;
use super::validate::validate;
use crate::axes::draft::BlockDraft;
use crate::axes::parameters::parameters;
use crate::source::faults::Faults;
use crate::source::place::Texts;
use crate::source::tree;
use crate::{Axis, AxisGroup, Block, Filter};
use slipgap_cases::Enumeration;
use slipgap_cases::alike::{self, unaffected};
use slipgap_cases::formulas::formula_table::FormulaTable;
use slipgap_motion::history::History;
use slipgap_motion::solve::{MetricTable, Unsolvable, Warning};
use slipgap_problem::problem::friction::FrictionOscillator;
use slipgap_problem::problem::numbers::parameter::{Default, Kind, Parameter, Range, Value};
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::table::schema::{Text, TimeAxis};
use slipgap_problem::problem::{
    Case, Jumps, Problem, ProblemKind, Schema, Solution, Violation, Work,
};
use std::borrow::Cow::{self, Borrowed};
use std::sync::{Arc, LazyLock};

#[derive(Debug)]
struct Bars;

const fn row(name: &'static str, kind: Kind, default: Default) -> Parameter {
    Parameter::new([name, name, "1"], kind, default, "a test")
}

static TABLE: [Parameter; 6] = [
    row(
        "n",
        Kind::Whole {
            min: 1,
            max: 1_000_000,
        },
        Default::Required,
    ),
    row("dt", Kind::Number(Range::Positive), Default::Required),
    row(
        "duration",
        Kind::Number(Range::Positive),
        Default::Is(Value::Number(2.0)),
    ),
    row(
        "twice_dt",
        Kind::Number(Range::Positive),
        Default::Follows(Borrowed("twice dt")),
    ),
    row(
        "right",
        Kind::Choice(&[("bar", "a bar"), ("wall", "a wall")]),
        Default::Is(Value::Name("bar")),
    ),
    Parameter::only_for(
        ["right.L", "right.L", "1"],
        Kind::Number(Range::Positive),
        Default::Is(Value::Number(10.0)),
        ("right", &["bar"]),
        "a test",
    ),
];

static SCHEMA: LazyLock<Arc<Schema>> = LazyLock::new(|| {
    Arc::new(Schema {
        name: Borrowed("bars"),
        meaning: Borrowed("a test"),
        described: false,
        parameters: Borrowed(&TABLE),
        metrics: Cow::default(),
        contact_metric: None,
        channels: Cow::default(),
        quantities: Cow::default(),
        profiles: Cow::default(),
        budgets: Cow::default(),
        step: 1,
        duration: 2,
        time: TimeAxis {
            column: Borrowed("t"),
            title: Borrowed("t"),
            in_pi: false,
        },
        place_title: Cow::default(),
        later: Cow::default(),
        scales: Cow::default(),
        units: Cow::default(),
        alternatives: Cow::default(),
    })
});

impl Problem for Bars {
    fn schema(&self) -> &Arc<Schema> {
        &SCHEMA
    }

    fn kind(&self) -> ProblemKind<'_> {
        FrictionOscillator.kind()
    }
    fn sweep(&self, _: &Cases, _: &[u32]) -> MetricTable {
        MetricTable::default()
    }
    fn doubts(&self, _: &Case) -> Vec<(Warning, String)> {
        Vec::new()
    }
    fn exact(&self, _: &Case, _: &[f64], _: Jumps) -> Option<History> {
        None
    }
    fn complete(&self, case: &mut Case) -> Vec<Violation> {
        let (Some(dt), Some(duration)) = (case.number("dt"), case.number("duration")) else {
            return Vec::new();
        };
        if case.values[3].is_none() {
            case.values[3] = Some(Value::Number(2.0 * dt));
        }
        let rule = |parameter: Text, broken: bool, message: String| {
            broken.then_some(Violation {
                parameter,
                message,
                at: None,
            })
        };
        let late = rule(
            "dt".into(),
            dt > duration,
            format!("must be at most duration = {duration}, got {dt}"),
        );
        let long = rule("duration".into(), duration > 100.0, "is too long".into());
        late.into_iter().chain(long).collect()
    }
    fn work(&self, _: &Case, _: &[usize]) -> Work {
        Work {
            steps: 0,
            references: 0,
        }
    }
    fn solve(&self, _case: &Case, _wanted: &[usize]) -> Result<Solution, Unsolvable> {
        Err(Unsolvable::ParameterMissing)
    }
}

/// The draft of a `parameters` text and the faults found, rules across parameters included.
fn draft(text: &str) -> (Option<BlockDraft>, Vec<String>) {
    let mut faults = Faults::default();
    let node = tree::parse(text).unwrap_or_else(|e| panic!("{e:?}"));
    let draft = parameters(&node, "parameters", &TABLE, &mut faults);
    if let Some(draft) = &draft
        && let Some(block) = resolve(draft, &Bars, &mut faults)
    {
        validate(&Bars, draft, &block, &mut faults);
    }
    let faults = faults.in_file_order(Texts::new("s", text));
    (draft, faults.iter().map(ToString::to_string).collect())
}

fn block(text: &str) -> Block {
    let (draft, faults) = draft(text);
    assert!(faults.is_empty(), "{faults:?}");
    draft
        .and_then(|draft| resolve(&draft, &Bars, &mut Faults::default()))
        .unwrap_or_else(|| panic!("{text}"))
}

fn values(case: &Case) -> String {
    let values = case
        .values
        .iter()
        .map(|v| v.map_or(String::new(), |v| v.to_string()));
    values.collect::<Vec<_>>().join(",")
}

#[test]
fn a_parameter_may_be_an_object_or_a_name() {
    let of = |right: &str| format!("{{\"n\": 1, \"dt\": 1{right}}}");
    let first = |text: &str| values(&block(text).completed(&Bars, 0));
    assert_eq!(first(&of("")), "1,1,2,2,bar,10");
    assert_eq!(first(&of(", \"right\": {}")), "1,1,2,2,bar,10");
    assert_eq!(
        first(&of(", \"right\": {\"L\": \"2*10\"}")),
        "1,1,2,2,bar,20"
    );
    assert_eq!(first(&of(", \"right\": \"wall\"")), "1,1,2,2,wall,");
    for (right, expected) in [
        (
            "\"wal\"",
            "s:1:28: parameters.right: unknown right \"wal\", did you mean \"wall\"?; allowed: bar, wall",
        ),
        (
            "{\"L\": -1}",
            "s:1:34: parameters.right.L: must be > 0, got -1",
        ),
        (
            "{\"l\": 1}",
            "s:1:34: parameters.right.l: unknown key \"l\", did you mean \"L\"?; allowed: L",
        ),
        (
            "{\"L\": 1, \"L\": 2}",
            "s:1:37: parameters.right.L: key \"L\" is given twice in one object",
        ),
        (
            "3",
            "s:1:28: parameters.right: must be a name in quotes, one of bar, wall, got 3",
        ),
    ] {
        assert_eq!(draft(&of(&format!(", \"right\": {right}"))).1, [expected]);
    }
}

#[test]
fn whole_numbers() {
    for (n, got) in [
        ("2.5", "2.5"),
        ("-3", "-3"),
        ("0", "0"),
        ("1e9", "1e9"),
        ("\"1/2\"", "\"1/2\" = 0.5"),
    ] {
        let expected =
            format!("s:1:7: parameters.n: must be a whole number from 1 to 1000000, got {got}");
        assert_eq!(
            draft(&format!("{{\"n\":{n}, \"dt\": 1}}")).1,
            [expected.replace(":7:", ":6:")]
        );
    }
    let block = block("{\"n\": [10.0, \"2*5\", 1e6], \"dt\": 1}");
    let values: Vec<Value> = block.groups[0].axes[0].values.iter().collect();
    assert_eq!(values, [10, 10, 1_000_000].map(Value::Whole));
}

#[test]
fn a_broken_rule_is_reported_once_at_its_value() {
    let (_, faults) = draft("{\"n\": [1, 2], \"dt\": [1, 3, 1],\n \"duration\": [2, 200]}");
    let expected = [
        "s:1:25: parameters.dt[1]: must be at most duration = 2, got 3",
        "s:2:18: parameters.duration[1]: is too long",
    ];
    assert_eq!(faults, expected);
    let (_, faults) = draft(" {\"n\": 1, \"dt\": 5}");
    assert_eq!(
        faults,
        ["s:1:17: parameters.dt: must be at most duration = 2, got 5"]
    );
}

#[test]
fn rules_of_a_large_block_are_checked_at_the_ends_of_its_axes() {
    let list = |numbers: &mut dyn Iterator<Item = u32>| {
        let numbers: Vec<String> = numbers.map(|n| n.to_string()).collect();
        numbers.join(",")
    };
    let long = list(&mut (1..=2000));
    let (_, faults) = draft(&format!(
        "{{\"n\": [{long}], \"dt\": [{long}], \"duration\": 50}}"
    ));
    assert_eq!(faults.len(), 1);
    assert!(
        faults[0].contains("parameters.dt[1999]: must be at most duration = 50, got 2000"),
        "{faults:?}"
    );
}

#[test]
fn the_last_axis_is_the_fastest_in_file_order() {
    let block = block("{\"right\": [\"bar\", \"wall\"], \"dt\": [2, 1, 0.5], \"n\": 7}");
    let cases: Vec<String> = (0..block.len(&Bars))
        .map(|i| values(&block.raw_case(&Bars, i)))
        .collect();
    let expected = [
        "7,2,2,,bar,10",
        "7,1,2,,bar,10",
        "7,0.5,2,,bar,10",
        "7,2,2,,wall,",
        "7,1,2,,wall,",
        "7,0.5,2,,wall,",
    ];
    assert_eq!(cases, expected);
}

#[test]
fn a_filter_selects_the_cases_that_match() {
    let blocks = [
        block("{\"n\": [1, 2, 2], \"dt\": [0.1, 0.2, 0.1], \"right\": [\"bar\", \"wall\"]}"),
        block("{\"dt\": [\"0.3-0.1\", 1], \"n\": [2, 3], \"duration\": [2, 5]}"),
    ];
    let number = |row: usize, x: f64| (row, vec![Value::Number(x)]);
    for terms in [
        vec![],
        vec![(0, vec![Value::Whole(2)])],
        vec![(0, vec![Value::Whole(1), Value::Whole(3)]), number(1, 0.1)],
        vec![(1, vec![Value::Number(0.2), Value::Number(1.0)])],
        vec![(3, vec![Value::Number(0.4), Value::Number(0.5)])],
        vec![number(1, 0.2)],
        vec![number(2, 2.0), number(1, 0.1)],
        vec![number(3, 0.4)],
        vec![(4, vec![Value::Name("bar")]), (0, vec![Value::Whole(2)])],
        vec![number(5, 10.0)],
        vec![number(1, 9.0)],
    ] {
        let filter = Filter(terms);
        let enumeration = Enumeration {
            problem: &Bars,
            blocks: &blocks,
        };
        let selected: Vec<u64> = enumeration.select(&filter).collect();
        let total: u64 = blocks.iter().map(|b| b.len(&Bars)).sum();
        let matching: Vec<u64> = (0..total)
            .filter(|i| {
                let case = enumeration.case(*i);
                case.is_some_and(|case| filter.matches(&case))
            })
            .collect();
        assert_eq!(selected, matching, "{filter:?}");
    }
}

#[test]
fn a_thousand_million_cases_cost_no_memory() {
    let group = |parameter| AxisGroup {
        axes: vec![Axis {
            parameter,
            values: (1..=1000).map(|n| Value::Number(f64::from(n))).collect(),
        }],
    };
    let block = Block::of([1, 2, 3].map(group).into());
    assert_eq!(block.len(&Bars), 1_000_000_000);
    assert_eq!(
        values(&block.raw_case(&Bars, 123_456_789)),
        ",124,457,790,bar,10"
    );
    let one = |row: usize, x: f64| (row, vec![Value::Number(x)]);
    let filter = Filter(vec![one(2, 457.0), one(3, 1000.0)]);
    let selected = block.select(&Bars, &filter);
    assert_eq!(
        selected.skip(999).map(|(raw, _)| raw).collect::<Vec<_>>(),
        [999_456_999]
    );
}

#[test]
fn axes_by_rule_end_at_the_given_numbers() {
    let axis = |rule: &str| -> Vec<f64> {
        let text = format!(
            r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control",
               "beta": 1, "dT": 0.1, "duration": 10, "x0": {rule}}}}}"#
        );
        let study = crate::parse("x.json", &text).unwrap();
        study.cases().map(|c| c.number("x0").unwrap()).collect()
    };
    assert_eq!(axis(r#"{"linspace": [0.1, 0.7, 3]}"#), [0.1, 0.4, 0.7]);
    assert_eq!(axis(r#"{"range": [0.1, 0.5, 0.1]}"#).len(), 5);
    assert_eq!(axis(r#"{"range": [0.1, 0.5, 0.1]}"#)[4], 0.5);
    assert_eq!(axis(r#"{"range": [1, 2, 0.4]}"#), [1.0, 1.4, 1.8]);
    let powers = axis(r#"{"geomspace": [0.001, "10^3", 7]}"#);
    assert_eq!((powers[0], powers[6]), (0.001, 1000.0));
    for (i, x) in powers.iter().enumerate() {
        // One rounding each of quotient, power and product.
        assert!((x / 10f64.powi(i as i32 - 3) - 1.0).abs() < 1e-14);
    }
}

#[test]
fn an_axis_of_whole_numbers_has_each_nearest_one_once() {
    let text = r#"{"problem": "bar-impact", "parameters": {"gamma": 1, "dt": 0.1, "duration": 1,
               "n": {"geomspace": [1, 10, 9]}}}"#;
    let study = crate::parse("x.json", text).unwrap();
    let n: Vec<f64> = study.cases().map(|c| c.number("n").unwrap()).collect();
    // 10^(i/8) = 1, 1.33, 1.78, 2.37, 3.16, 4.22, 5.62, 7.499, 10
    assert_eq!(n, [1.0, 2.0, 3.0, 4.0, 6.0, 7.0, 10.0]);
}

#[test]
fn an_expression_is_computed_once_for_each_set_of_its_parameters() {
    // gap depends on dt, which depends on n: three values of each for 3 x 200 combinations; one of a constant.
    let long: Vec<String> = (1..=200).map(|n| n.to_string()).collect();
    let text = format!(
        r#"{{"problem": "bar-impact", "parameters": {{"gamma": [{}], "n": [2, 4, 8], "gap": "2*dt", "dt": "0.1/n",
        "L": "E/10", "duration": 1.5}}, "when": "gap < 1"}}"#,
        long.join(", ")
    );
    let study = crate::parse("x.json", &text).unwrap();
    let block = &study.blocks[0];
    let name = |row: usize| &*study.problem.parameters()[row].name;
    let entries = |formula: &FormulaTable| formula.table.as_ref().map_or(0, Vec::len);
    let tables: Vec<(&str, usize)> = block
        .derived
        .iter()
        .map(|d| (name(d.parameter), entries(&d.formula)))
        .collect();
    assert_eq!(tables, [("dt", 3), ("gap", 3), ("L", 1)]);
    assert_eq!(
        block.when.as_ref().map(|when| entries(&when.formula)),
        Some(3)
    );
}

#[test]
fn what_changes_with_a_parameter_is_affected_and_nothing_else() {
    let study = crate::parse(
        "s",
        r#"{"problem": "bar-impact", "blocks": [
          {"parameters": {"gamma": [1, 2], "n": [4, 8], "dt": "0.1/n", "gap": [0.1, 0.2], "duration": "1.5 + gap"},
           "zip": [["gamma", "gap"]]},
          {"parameters": {"gamma": 3, "n": 16, "dt": 0.01, "gap": 0, "duration": 1.5}}]}"#,
    )
    .unwrap_or_else(|e| panic!("{e}"));
    let table = study.problem.parameters();
    let affected = |name: &str| -> Vec<&str> {
        let row = table.iter().position(|p| p.name == name).unwrap();
        let shared = unaffected(&*study.problem, &study.blocks, &[row]);
        let of_study = ["gamma", "k_I", "n", "dt", "gap", "duration", "mass"];
        let is = |name: &&str| !shared.iter().any(|row| table[*row].name == **name);
        of_study.into_iter().filter(is).collect()
    };
    // No block gives k_I: the problem computes it.
    assert_eq!(affected("n"), ["k_I", "n", "dt"]);
    assert_eq!(affected("gap"), ["gamma", "k_I", "gap", "duration"]);
    assert_eq!(affected("dt"), ["k_I", "dt"]);
    let case = study.case(0).unwrap();
    let rows = unaffected(&*study.problem, &study.blocks, &[]);
    assert!(
        alike::values(&case, &rows).contains("n = 4"),
        "{}",
        alike::values(&case, &rows)
    );
}
