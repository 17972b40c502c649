//! Metrics at positions along the structure, such as the largest drift of each storey.

use crate::Scale;
use crate::field::{field, fields, needed};
use crate::figure::checker::Checker;
use crate::figure::keys::{BAND, BY_OUTSIDE, COLOUR, MARKERS, Takes, USUAL, X_RANGE, Y_RANGE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use crate::figure::{ensembles, vary};
use slipgap_problem::problem::Problem;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "envelope",
    needs: Needs::Nothing,
    meaning: "metrics at positions along the structure, such as the largest drift of each storey: a curve for each case, or of an ensemble the median and a band",
    keys: &fields![
        /// metrics from the first position to the last; several times as many are further curves, as all max, then all min
        needed("x", Takes::Metrics),
        /// positions, rising; default: 1, 2, 3, ..
        field("at", Takes::Times),
        /// title of the horizontal axis; default: what the titles of the metrics share
        field("x_title", Takes::Text),
        /// title of the vertical axis; default Position
        field("at_title", Takes::Text),
        BY_OUTSIDE,
        BAND,
        X_RANGE,
        Y_RANGE,
        COLOUR,
        MARKERS,
    ],
    decode: |values, _| {
        let x = values.rows("x")?;
        let numbers = || (1..=x.len()).map(|number| number as f64).collect();
        let at = Some(values.numbers("at")).filter(|at| !at.is_empty());
        Some(FigureKind::Envelope(Envelope {
            at: at.unwrap_or_else(numbers),
            x,
            titles: ["x_title", "at_title"].map(|key| values.text(key)),
            by: values.row("by"),
            band: values.range("band").unwrap_or(USUAL),
        }))
    },
};

/// Metrics at positions along the structure.
#[derive(Debug)]
pub struct Envelope {
    /// Rows of the study's measures, as many as positions, or several times as many.
    pub x: Vec<usize>,
    /// Positions, rising.
    pub at: Vec<f64>,
    /// Titles of the two axes, in markup.
    pub titles: [Option<String>; 2],
    /// Parameter with one line style for each value; `None`: all outside of the ensemble that vary.
    pub by: Option<usize>,
    /// Probabilities of the quantiles at the edges of the band.
    pub band: [f64; 2],
}

impl Decoded for Envelope {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([Scale::Linear; 2], 1))
    }

    fn check_keys(&self, checker: &mut Checker) {
        let [metrics, positions] = [self.x.len(), self.at.len()];
        if metrics % positions != 0 {
            let message = format!("{metrics} metrics, but {positions} positions in \"at\"");
            checker.fault("x", message);
        }
        if let Some(i) = self.at.windows(2).position(|pair| pair[1] <= pair[0]) {
            checker.fault_of_item("at", i + 1, "must be larger than the position before");
        }
        if checker.scope.ensemble.is_none() && checker.values.has("band") {
            checker.fault("band", "needs the key \"ensemble\" of the study");
        }
    }

    fn check_cases(&self, checker: &mut Checker) {
        ensembles::check(checker, None, self.by, KIND.name);
        if let (None, Some(by)) = (&checker.scope.ensemble, self.by) {
            checker.has_values("by", by);
            let what = format!(
                "an {} figure with \"by\" shows one case for each curve",
                KIND.name
            );
            vary::check(checker, &[by], &what, vary::OR_WITHOUT_BY);
        }
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        self.x.clone()
    }
}

#[cfg(test)]
mod tests {
    use crate::parse;

    #[test]
    fn faults_name_the_key_and_what_is_allowed() {
        for (figure, message) in [
            (
                r#""x": ["peak(a)", "peak(b)"], "by": "k", "where": {"c": 1}"#,
                "",
            ),
            (
                r#""x": ["max(a)", "max(b)", "min(a)", "min(b)"], "at": [3, 6]"#,
                "",
            ),
            (
                r#""x": ["max(a)", "max(b)", "min(a)"], "at": [3, 6]"#,
                "figures[0].x: 3 metrics, but 2 positions in \"at\"",
            ),
            (
                r#""x": ["max(a)", "max(b)"], "at": [3, 3]"#,
                "figures[0].at[1]: must be larger than the position before",
            ),
            (
                r#""x": ["max(a)", "max(b)"], "band": [0, 1]"#,
                "figures[0].band: needs the key \"ensemble\" of the study",
            ),
            (
                r#""x": ["max(a)", "max(b)"], "by": "c""#,
                "figures[0].where: an envelope figure with \"by\" shows one case for each curve, but k varies",
            ),
        ] {
            let text = format!(
                r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1, "k": [10, 20], "c": [1, 2]}},
                  "metrics": ["peak(a)"],
                  "structure": {{"masses": {{"a|b": 1}}, "springs": [{{"between": ["ground", "a"], "k": "k", "c": "c"}}, {{"between": ["a", "b"], "k": 1}}]}},
                  "figures": [{{"name": "f", "kind": "envelope", {figure}}}]}}"#
            );
            let found = parse("s", &text).err().map(|e| e.to_string());
            let wrong = found.unwrap_or_default();
            assert!(
                wrong.contains(message) && message.is_empty() == wrong.is_empty(),
                "{figure}: {wrong}"
            );
        }
    }
}
