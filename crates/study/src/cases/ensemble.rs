//! Which parameters distinguish the ensembles of a study.

use super::alike::unaffected;
use super::block::Block;
use crate::Study;
use slipgap_problem::problem::Problem;

impl Study {
    /// The parameters whose values distinguish ensembles: all that may vary, but those of the key `ensemble`, those in `also`,
    /// and what changes with one of them.
    pub fn outside_ensemble(&self, also: &[usize]) -> Vec<usize> {
        let rows: Vec<usize> = self.ensemble.iter().chain(also).copied().collect();
        outside(&*self.problem, &self.blocks, &rows)
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
