//! Which parameters distinguish the ensembles of a study.

use super::scope::Scope;
use crate::Study;
use crate::source::faults::Faults;
use slipgap_cases::alike::unaffected;
use slipgap_cases::{Block, Filter};
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::numbers::parameter::Value;

impl Study {
    /// The parameters whose values distinguish ensembles: all that may vary, but those of the key `ensemble`, those in `also`,
    /// and what changes with one of them.
    pub fn outside_ensemble(&self, also: &[usize]) -> Vec<usize> {
        let rows: Vec<usize> = self.ensemble.iter().chain(also).copied().collect();
        outside(&*self.problem, &self.blocks, &rows)
    }

    /// A measure in each test that is compared as one of a sample, by rising value; `None` if the tests do not have it.
    pub fn in_tests(&self, measure: usize) -> Option<Vec<f64>> {
        let of_row = &self.measures[measure];
        let plain = of_row.dimension.is_none() && of_row.reduction.is_none();
        let mut values = self
            .problem
            .as_structure()
            .and_then(|structure| structure.in_tests(of_row.metric.filter(|_| plain)?))?;
        values.sort_unstable_by(f64::total_cmp);
        Some(values)
    }

    /// The parameters whose values distinguish physical cases if those in `chosen` are numerical choices.
    pub fn outside_choice(&self, chosen: &[usize]) -> Vec<usize> {
        outside(&*self.problem, &self.blocks, chosen)
    }
}

/// The parameters that may vary and do not change with those in `rows`.
pub(crate) fn outside(problem: &dyn Problem, blocks: &[Block], rows: &[usize]) -> Vec<usize> {
    let mut outside = unaffected(problem, blocks, rows);
    outside.retain(|row| may_vary(blocks, *row));
    outside
}

/// Whether cases may have different values of a parameter. One that several blocks give may differ between them.
fn may_vary(blocks: &[Block], row: usize) -> bool {
    if blocks.len() > 1 {
        return blocks.iter().any(|block| block.gives(row));
    }
    blocks.iter().any(|block| {
        let mut axes = block.axes().filter(|axis| axis.parameter == row);
        axes.any(|axis| axis.values.len() > 1) || block.derived.iter().any(|d| d.parameter == row)
    })
}

/// Reports at an offset and path a parameter that has no several values of its own, which `what` needs.
pub(crate) fn refuse_constant(
    scope: &Scope,
    row: usize,
    what: &str,
    (at, path): (usize, String),
    faults: &mut Faults,
) {
    let name = &scope.problem.parameters()[row].name;
    let mut derived = scope.blocks.iter().flat_map(|block| &block.derived);
    let is_derived = derived.any(|derived| derived.parameter == row);
    if !is_derived && differs_at_ends(scope, row) {
        return;
    }
    let why = match is_derived {
        true => "is given by an expression; name the parameters that it follows from".to_owned(),
        false => match scope.levels(&Filter::default(), row).as_slice() {
            [] => "is given in none of the cases".to_owned(),
            [one] => format!("is {one} in all cases; {what} needs a parameter with several values"),
            _ => return,
        },
    };
    faults.add(at, &path, format!("{name} {why}"));
}

/// Whether the first and the last case of a block have different values of a parameter, so that not all cases must be made.
fn differs_at_ends(scope: &Scope, row: usize) -> bool {
    let problem = &*scope.problem;
    scope.blocks.iter().any(|block| {
        let is_case = |raw: &u64| block.is_case(problem, *raw);
        let value = |raw: u64| block.raw_case(problem, raw).values[row];
        let first = (0..block.raw_len()).find(is_case).and_then(value);
        let last = (0..block.raw_len()).rev().find(is_case).and_then(value);
        first
            .zip(last)
            .is_some_and(|(first, last)| !Value::identical(Some(first), Some(last)))
    })
}

#[cfg(test)]
mod tests {
    use crate::parse;

    /// Names of the parameters that distinguish the ensembles of a study of bars.
    fn outside(text: &str) -> Vec<String> {
        let text = format!(r#"{{"problem": "bar-impact", {text}}}"#);
        let study = parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
        let rows = study.outside_ensemble(&[]).into_iter();
        let name = |row: usize| study.problem.parameters()[row].name.to_string();
        rows.map(name).collect()
    }

    #[test]
    fn what_varies_and_does_not_change_with_the_ensemble_distinguishes() {
        let rest = r#""dt": "0.1/n", "duration": 1"#;
        // dt follows from n; the gap advances with gamma.
        let one = format!(
            r#""parameters": {{"gamma": [1, 2], "n": [4, 8], "gap": [0, 0.1], {rest}}}, "zip": [["gamma", "gap"]]"#
        );
        assert_eq!(
            outside(&format!(r#"{one}, "ensemble": "gap""#)),
            ["n", "dt"]
        );
        assert_eq!(
            outside(&format!(r#"{one}, "ensemble": "n""#)),
            ["gamma", "gap"]
        );
        assert_eq!(
            outside(&format!(r#"{one}, "ensemble": ["n", "gap"]"#)).len(),
            0
        );
        // All that a design samples changes together.
        let sampled = format!(
            r#""parameters": {{"gamma": {{"uniform": [1, 2]}}, "gap": {{"uniform": [0, 0.1]}}, "n": [4, 8], {rest}}},
               "design": {{"kind": "sobol", "n": 8}}, "ensemble": "gap""#
        );
        assert_eq!(outside(&sampled), ["n", "dt"]);
        // Between blocks a single value may differ.
        let blocks = r#""blocks": [
            {"parameters": {"gamma": 1, "n": 4, "gap": [0, 0.1], "dt": 0.01, "duration": 1}},
            {"parameters": {"gamma": 2, "n": 4, "gap": [0, 0.1], "dt": 0.01, "duration": 1}}], "ensemble": "gap""#;
        assert_eq!(outside(blocks), ["gamma", "n", "dt", "duration"]);
    }
}
