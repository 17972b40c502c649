//! The range of the delays of a study, from which the points that are compared follow: they are the same for all of its delays.

use crate::axes::draft::BlockDraft;
use crate::axes::parameters::parameters;
use crate::source::faults::Faults;
use crate::source::tree::{Node, Tree};
use crate::structure::reading::given::{member, members};
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::numbers::parameter::{Parameter, Value};
use slipgap_problem::problem::structure::channels::measured_channels::Measured;
use slipgap_problem::problem::structure::given::amount::Source;

/// Most parameters of a formula whose ends are all combined.
const MOST: usize = 12;

/// Deepest formula of formulas. Faults of circles are reported elsewhere.
const DEEPEST: usize = 20;

/// A measurement with the range of its delays.
pub(super) fn known(measured: Measured, root: &Node, table: &[Parameter]) -> Measured {
    let delays = match measured.delay.as_ref().map(|delay| &delay.source) {
        None => [0.0; 2],
        Some(Source::Number(x)) => [*x; 2],
        Some(Source::Expression(expression)) => {
            let free = Free::of(root, table);
            let of = |draft: BlockDraft| Ranges { draft, free: &free }.of(&expression.formula, 0);
            let ranges = blocks(root, table).into_iter().filter_map(of);
            ranges.reduce(joined).unwrap_or_default()
        }
    };
    Measured { delays, ..measured }
}

fn joined(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0].min(b[0]), a[1].max(b[1])]
}

/// The parameters of every block. Their faults are reported where cases are made.
fn blocks(root: &Node, table: &[Parameter]) -> Vec<BlockDraft> {
    let first = [root].into_iter();
    let more = match member(root, "blocks").map(|node| &node.tree) {
        Some(Tree::List(blocks)) => &blocks[..],
        _ => &[],
    };
    let nodes = first
        .chain(more)
        .filter_map(|node| member(node, "parameters"));
    let draft = |node: &Node| parameters(node, "", table, &mut Faults::default());
    nodes.filter_map(draft).collect()
}

/// The ranges of the parameters that a calibration changes, by their rows.
struct Free(Vec<(usize, [f64; 2])>);

impl Free {
    fn of(root: &Node, table: &[Parameter]) -> Free {
        let calibrated = member(root, "calibrate").map_or(&[][..], members).iter();
        let range = calibrated.filter_map(|entry| {
            let row = table.iter().position(|known| known.name == entry.key)?;
            // With a scale, the ends are the value of its key.
            let ends = match members(&entry.node) {
                [scale] => &scale.node,
                _ => &entry.node,
            };
            match &ends.tree {
                Tree::List(ends) => match &ends[..] {
                    [from, to] => Some((row, [number(from)?, number(to)?])),
                    _ => None,
                },
                Tree::Object(_) | Tree::Text(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {
                    None
                }
            }
        });
        Free(range.collect())
    }
}

fn number(node: &Node) -> Option<f64> {
    match &node.tree {
        Tree::Number(written) => written.parse().ok(),
        Tree::Text(text) => Formula::number(text, &[]).ok()?.value(&|_| None).ok(),
        Tree::Object(_) | Tree::List(_) | Tree::Bool(_) | Tree::Null => None,
    }
}

/// The ranges of the parameters of a block.
struct Ranges<'a> {
    draft: BlockDraft,
    free: &'a Free,
}

impl Ranges<'_> {
    /// The range of a formula from its values at the ends of its parameters.
    fn of(&self, formula: &Formula, depth: usize) -> Option<[f64; 2]> {
        let rows = formula.uses();
        if depth > DEEPEST || rows.len() > MOST {
            return None;
        }
        let intervals = rows.iter().map(|row| self.of_parameter(*row, depth));
        let ends: Vec<[f64; 2]> = intervals.collect::<Option<_>>()?;
        let value = |corner: usize| {
            let of = |row: usize| {
                let index = rows.iter().position(|known| *known == row)?;
                Some(Value::Number(ends[index][corner >> index & 1]))
            };
            let x = formula.value(&of).ok()?;
            Some([x, x])
        };
        (0..1 << rows.len()).filter_map(value).reduce(joined)
    }

    fn of_parameter(&self, row: usize, depth: usize) -> Option<[f64; 2]> {
        let given = self.draft.get(row)?;
        let numbers = given.values.iter().filter_map(Value::as_f64);
        let values = numbers.map(|x| [x, x]);
        let interval = given.interval.map(|interval| interval.ends());
        let formula = given.formula.as_ref();
        let of_formula = formula.and_then(|(formula, _)| self.of(formula, depth + 1));
        let free = self.free.0.iter().filter(|pair| pair.0 == row);
        let known = values.chain(interval).chain(of_formula);
        known.chain(free.map(|pair| pair.1)).reduce(joined)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::tree::parse;
    use slipgap_problem::problem::ParameterExpression;
    use slipgap_problem::problem::numbers::parameter::Range;
    use slipgap_problem::problem::structure::given::amount::Amount;
    use slipgap_problem::problem::structure::given::chosen::Chosen;
    use slipgap_problem::problem::structure::tables::schema::named;
    use std::sync::Arc;

    /// The delays of a study with these keys, in which this is the delay.
    fn delays(keys: &str, text: &str) -> [f64; 2] {
        let table = ["a", "b", "lag"].map(named);
        let formula = Formula::number(text, &table).unwrap();
        let text = text.to_owned();
        let delay = Amount {
            source: Source::Expression(Arc::new(ParameterExpression { formula, text })),
            range: Range::Any,
            at: 0,
            path: String::new(),
        };
        let measured = Measured {
            file: Chosen::Name("a.csv"),
            tests: Vec::new(),
            channels: Vec::new(),
            delay: Some(delay),
            delays: [f64::NAN; 2],
            place: (0, String::new()),
        };
        let root = parse(&format!("{{{keys}}}")).unwrap();
        known(measured, &root, &table).delays
    }

    #[test]
    fn the_delays_of_all_cases_are_in_the_range() {
        let one = |values: &str| format!("\"parameters\": {{{values}}}");
        assert_eq!(delays(&one(r#""lag": 0.5"#), "lag"), [0.5; 2]);
        assert_eq!(
            delays(&one(r#""lag": ["pi", 2, 3]"#), "-lag"),
            [-std::f64::consts::PI, -2.0]
        );
        assert_eq!(
            delays(&one(r#""lag": {"uniform": [1, 4]}"#), "lag/2"),
            [0.5, 2.0]
        );
        let two = one(r#""a": {"geomspace": [1, 8, 4]}, "b": [-1, 2], "lag": "a*b""#);
        assert_eq!(delays(&two, "lag"), [-8.0, 16.0]);
        let blocks = r#""blocks": [{"parameters": {"lag": 3}}, {"parameters": {"lag": [1, 2]}}]"#;
        assert_eq!(delays(blocks, "lag"), [1.0, 3.0]);
        // Where the formula has no value, there is no case.
        assert_eq!(delays(&one(r#""a": [0, 4]"#), "1/a"), [0.25; 2]);
    }

    #[test]
    fn a_calibration_has_the_delays_of_its_ranges() {
        let with = |calibrate: &str| {
            format!(r#""parameters": {{"a": 2, "lag": 0.5}}, "calibrate": {{{calibrate}}}"#)
        };
        let lag = |calibrate: &str| delays(&with(calibrate), "lag*a");
        assert_eq!(lag(r#""lag": [0.1, 0.7]"#), [0.2, 1.4]);
        assert_eq!(
            lag(r#""lag": {"log": [0.1, "1/4"]}, "minimise": "peak(m)""#),
            [0.2, 1.0]
        );
        assert_eq!(
            lag(r#""lag": [0, 1], "a": [-1, 3], "seed": 1"#),
            [-1.0, 3.0]
        );
        assert_eq!(lag(r#""a": 7, "lag": "x""#), [1.0; 2]);
    }

    #[test]
    fn formulas_in_a_circle_have_no_range() {
        let circle = r#""parameters": {"a": "b", "b": "a"}"#;
        assert_eq!(delays(circle, "a"), [0.0; 2]);
    }
}
