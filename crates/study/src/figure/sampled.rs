//! Parameters that a design samples, and figures that cannot show them.

use super::checker::Checker;
use crate::scope::Scope;
use crate::{Filter, Scale};

/// Most sampled parameters of a matrix: more leave its panels too small.
const MOST_SAMPLED: usize = 8;

/// The parameters that designs sample among the cases that a filter chooses, with their scales; one whose scales differ
/// from block to block has a linear one.
pub(super) fn parameters(scope: &Scope, filter: &Filter) -> Vec<(usize, Scale)> {
    let mut found: Vec<(usize, Scale)> = Vec::new();
    for block in &scope.blocks {
        let Some(design) = &block.design else {
            continue;
        };
        for (row, scale) in design.parameters.iter().zip(&design.scales) {
            if block.levels(&*scope.problem, filter, *row).len() < 2 {
                continue;
            }
            match found.iter_mut().find(|(other, _)| other == row) {
                Some((_, other)) if other != scale => *other = Scale::Linear,
                Some(_) => {}
                None => found.push((*row, *scale)),
            }
        }
    }
    found
}

/// Reports sampled parameters in a figure of curves or of a grid: no two of their points share a value. Whether there
/// are any.
pub(super) fn refused(checker: &mut Checker, kind: &str) -> bool {
    let table = checker.scope.problem.parameters();
    let mut sampled = parameters(checker.scope, &checker.figure.filter);
    // Cases of all samples may be reduced to one value.
    let lost = |row: &usize| {
        checker
            .reduced
            .iter()
            .any(|reduced| reduced.lost.contains(row))
    };
    sampled.retain(|(row, _)| !lost(row));
    let names: Vec<&str> = sampled.iter().map(|(row, _)| &*table[*row].name).collect();
    let are = match names.as_slice() {
        [] => return false,
        [one] => format!("{one} is"),
        several => format!("{} are", several.join(", ")),
    };
    let message = format!(
        "{are} sampled by a design, but a {kind} figure needs lists of values; kinds for samples: scatter, front, samples"
    );
    checker.fault("kind", message);
    true
}

/// Reports cases without sampled parameters, or with more than fit on a page.
pub(super) fn check(count: usize, checker: &mut Checker) {
    let message = match count {
        0 => {
            "a samples figure shows parameters that a design samples, but the cases shown have none"
                .into()
        }
        1..=MOST_SAMPLED => return,
        _ => format!(
            "{count} sampled parameters; allowed: at most {MOST_SAMPLED}; scatter shows two of them"
        ),
    };
    checker.fault("kind", message);
}

#[cfg(test)]
mod tests {
    use crate::parse;

    /// What is wrong with a figure of a block with a design of gamma and dt and a block with lists of them.
    fn wrong(figure: &str) -> String {
        let study = format!(
            r#"{{"problem": "bar-impact", "blocks": [
              {{"parameters": {{"gamma": {{"loguniform": [0.1, 3]}}, "n": 4, "dt": {{"loguniform": [0.001, 0.05]}},
                               "duration": 1.5}}, "design": {{"kind": "latin-hypercube", "n": 50}}}},
              {{"parameters": {{"gamma": [1, 2, 3], "n": 8, "dt": [0.01, 0.02, 0.03], "duration": 1.5}}}}],
              "figures": [{{"name": "f", {figure}}}]}}"#
        );
        parse("s", &study)
            .err()
            .map_or(String::new(), |e| e.to_string())
    }

    #[test]
    fn grids_and_curves_refuse_samples() {
        for (kind, keys) in [
            ("map", r#""x": "gamma", "y": "dt", "z": "peak_force""#),
            ("metric", r#""x": "gamma", "y": "peak_force""#),
            ("convergence", r#""y": "rms_error_r""#),
            ("budget", r#""x": "dt""#),
        ] {
            let figure = |n: u32| {
                wrong(&format!(
                    r#""kind": "{kind}", {keys}, "where": {{"n": {n}}}"#
                ))
            };
            let refused = figure(4);
            let message = format!(
                "figures[0].kind: gamma, dt are sampled by a design, but a {kind} figure needs lists of values; kinds \
                 for samples: scatter, front, samples"
            );
            assert!(refused.contains(&message), "{refused}");
            assert_eq!(
                refused.lines().next().map(|l| l.contains("kind:")),
                Some(true)
            );
            // The block of lists has them, but for the budget, which shows one case a place.
            if kind != "budget" {
                assert_eq!(figure(8), "", "{kind}");
            }
        }
    }

    #[test]
    fn scatters_and_samples_take_what_fits_them() {
        assert_eq!(
            wrong(r#""kind": "scatter", "x": "gamma", "y": "peak_force", "colour": "n""#),
            ""
        );
        assert_eq!(
            wrong(r#""kind": "samples", "y": "peak_force", "where": {"n": 4}"#),
            ""
        );
        for (figure, message) in [
            (
                r#""kind": "samples", "y": "peak_force", "where": {"n": 8}"#,
                "figures[0].kind: a samples figure shows parameters that a design samples, but the cases shown have none",
            ),
            (
                r#""kind": "scatter", "x": "gamma", "y": "gamma""#,
                "figures[0].y: must be a column other than x",
            ),
            (
                r#""kind": "scatter", "x": "gamma", "y": "dt", "colour_scale": "log""#,
                "figures[0].colour_scale: needs the key \"colour\"",
            ),
            (
                r#""kind": "scatter", "x": "gap", "y": "peak_force", "x_scale": "log""#,
                "figures[0].x_scale: a log scale needs numbers > 0, but gap is 0 in a case shown",
            ),
            (
                r#""kind": "scatter", "x": "mass", "y": "peak_force""#,
                "figures[0].x: unknown parameter or metric \"mass\"",
            ),
            (
                r#""kind": "scatter", "x": "gamma", "y": "peek_force""#,
                "did you mean \"peak_force\"?",
            ),
        ] {
            let told = wrong(figure);
            assert!(told.contains(message), "{told}");
        }
    }
}
