//! The checks of a figure that several kinds need.

use super::reduced;
use super::values::Values;
use crate::faults::{Faults, join};
use crate::scope::Scope;
use crate::{Figure, Reduction, Scale};
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::{Default, Value, shortest};

/// What to do about too many cases.
pub(super) const NARROW: &str = "narrow the cases with \"where\"";

/// Most panels of a figure.
pub(super) const MOST_PANELS: usize = 24;

/// A decoded figure, and where its faults are reported.
pub(crate) struct Checker<'a> {
    pub figure: &'a Figure,
    pub values: &'a Values<'a>,
    pub scope: &'a Scope,
    /// One of the reductions that the figure shows, if it shows any.
    pub reduced: Option<&'a Reduction>,
    pub faults: &'a mut Faults,
    /// Number of faults before the figure.
    pub before: usize,
}

impl<'a> Checker<'a> {
    /// Reports a fault of a key.
    pub fn fault(&mut self, key: &str, message: impl Into<String>) {
        let path = join(self.values.path, key);
        self.faults.add(self.values.at(key), &path, message);
    }

    /// Reports a fault of item `i` of the value of a key.
    pub fn fault_of_item(&mut self, key: &str, i: usize, message: impl Into<String>) {
        let (at, path) = self.values.item(key, i);
        self.faults.add(at, &path, message);
    }

    /// The different values of a parameter in the cases of the figure.
    pub fn levels(&self, row: usize) -> Vec<Value> {
        self.scope.levels(&self.figure.filter, row)
    }

    /// The cases of the figure; one of each group, if it shows reductions.
    pub fn cases(&self) -> impl Iterator<Item = Case> + use<'a> {
        reduced::one_of_each(self.reduced, self.scope.cases(&self.figure.filter))
    }

    /// Whether the figure has more than `most` cases.
    pub fn has_more_cases_than(&self, most: usize) -> bool {
        self.scope.select(&self.figure.filter).nth(most).is_some()
    }

    /// Why the figure cannot show a parameter, because it shows reductions over it; `None` if it can.
    pub fn hidden(&self, row: usize) -> Option<String> {
        let cases = self.scope.cases(&self.figure.filter);
        reduced::hidden(self.reduced?, row, cases, self.scope)
    }

    /// Reports a parameter that none of the cases has, or that the figure cannot show.
    pub fn has_values(&mut self, key: &str, row: usize) {
        if let Some(message) = self.hidden(row) {
            self.fault(key, message);
            return;
        }
        let parameter = &self.scope.problem.parameters()[row];
        let known = !matches!(parameter.default, Default::Follows(_));
        if known && self.levels(row).is_empty() {
            let message = format!("{} applies to none of the cases shown", parameter.name);
            self.fault(key, message);
        }
    }

    /// Reports an axis of `kind` with one value of its parameter, unless the figure has other faults.
    pub fn has_two_values(&mut self, key: &str, row: usize, kind: &str) {
        let mut levels = self.levels(row);
        if levels.is_empty() {
            // The problem works it out.
            levels.extend(self.cases().filter_map(|case| case.values[row]));
            levels.dedup_by(|a, b| a.matches(*b));
        }
        if self.faults.count() == self.before
            && let [one] = levels[..]
        {
            let name = &self.scope.problem.parameters()[row].name;
            let message = format!(
                "a {kind} figure needs two values of {name}, and all cases shown have {name} = {one}"
            );
            self.fault(key, message);
        }
    }

    /// Reports an `x_range` that none of the values of the parameter along the axis lies in, nor between.
    pub fn range_shows_some(&mut self, row: usize) {
        let levels = self.levels(row);
        let numbers = levels.iter().filter_map(|level| level.as_f64());
        let extent = numbers.fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], x| {
            [a.min(x), b.max(x)]
        });
        let name = self.scope.problem.parameters()[row].name.to_string();
        self.range_overlaps(&name, extent);
    }

    /// Reports an `x_range` that has no part of the extent of what is along the axis; nothing if the extent is empty.
    pub fn range_overlaps(&mut self, name: &str, extent: [f64; 2]) {
        self.overlaps("x_range", self.figure.ranges[0], name, extent);
    }

    /// The same for the range of another key.
    pub fn overlaps(
        &mut self,
        key: &str,
        range: Option<[f64; 2]>,
        name: &str,
        [low, high]: [f64; 2],
    ) {
        if let Some([first, last]) = range
            && low <= high
            && (last < low || first > high)
        {
            let (low, high) = (shortest(low), shortest(high));
            let message =
                format!("shows nothing: {name} is from {low} to {high} in the cases shown");
            self.fault(key, message);
        }
    }

    /// Reports a logarithmic scale for a parameter with values that have no logarithm.
    pub fn suits_scale(&mut self, key: &str, row: usize, scale: Scale) {
        let levels = self.levels(row);
        let mut numbers = levels.iter().filter_map(|level| level.as_f64());
        if scale == Scale::Log
            && let Some(bad) = numbers.find(|x| *x <= 0.0)
        {
            let name = &self.scope.problem.parameters()[row].name;
            let bad = Value::Number(bad);
            let message =
                format!("a log scale needs numbers > 0, but {name} is {bad} in a case shown");
            self.fault(&format!("{key}_scale"), message);
        }
    }

    /// Reports a mark outside of the values of a parameter.
    pub fn reaches(&mut self, row: usize, value: f64, mark: usize) {
        let levels = self.levels(row);
        let numbers = levels.iter().filter_map(|level| level.as_f64());
        let (low, high) = numbers.fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), x| {
            (a.min(x), b.max(x))
        });
        let slack = 1e-12 * value.abs();
        if low <= high && !(value >= low - slack && value <= high + slack) {
            let name = &self.scope.problem.parameters()[row].name;
            let (low, high, x) = (shortest(low), shortest(high), shortest(value));
            let message = format!("{name} of mark {mark} must lie within {low}..{high}, got {x}");
            self.fault("marks", message);
        }
    }

    /// Reports more panels than fit on a page: `rows` for each value of the parameter of `panels`. Whether they fit.
    pub fn panels_fit(&mut self, row: usize, rows: usize) -> bool {
        let count = rows * self.levels(row).len();
        if count > MOST_PANELS {
            let message = format!("{count} panels; allowed: at most {MOST_PANELS}; {NARROW}");
            self.fault("panels", message);
        }
        count <= MOST_PANELS
    }
}

#[cfg(test)]
mod tests {
    use crate::parse;

    /// The faults of a study of two widths and three steps with a figure.
    fn faults(figure: &str) -> String {
        let text = format!(
            r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control", "beta": [0.1, 0.2], "dT": [0.1, 0.2, 0.3],
              "x0": 8, "duration": 12}}, "figures": [{{"name": "f", {figure}}}]}}"#
        );
        parse("s", &text)
            .err()
            .map(|e| e.to_string())
            .unwrap_or_default()
    }

    #[test]
    fn an_axis_has_two_values() {
        for (kind, keys, key, name) in [
            (
                "map",
                r#""x": "x0", "y": "dT", "z": "rms_error", "where": {"beta": 0.1}"#,
                "x",
                "x0 = 8",
            ),
            (
                "map",
                r#""x": "dT", "y": "beta", "z": "rms_error", "where": {"beta": 0.1}"#,
                "y",
                "beta = 0.1",
            ),
            (
                "convergence",
                r#""y": "rms_error", "where": {"dT": 0.2}"#,
                "x",
                "dT = 0.2",
            ),
            (
                "budget",
                r#""x": "dT", "where": {"dT": 0.2, "beta": 0.1}"#,
                "x",
                "dT = 0.2",
            ),
        ] {
            let found = faults(&format!(r#""kind": "{kind}", {keys}"#));
            let parameter = name.split(' ').next().unwrap();
            let says = format!(
                "figures[0].{key}: a {kind} figure needs two values of {parameter}, and all cases shown have {name}"
            );
            assert!(found.contains(&says), "{found}");
        }
        assert_eq!(
            faults(r#""kind": "map", "x": "beta", "y": "dT", "z": "rms_error""#),
            ""
        );
        assert_eq!(faults(r#""kind": "convergence", "y": "rms_error""#), "");
    }

    #[test]
    fn a_range_shows_a_part_of_the_axis() {
        let metric = r#""kind": "metric", "x": "dT", "y": "rms_error""#;
        let history = r#""kind": "history", "where": {"dT": 0.1}"#;
        for (figure, range, extent) in [
            (metric, "[0.31, 1]", "dT is from 0.1 to 0.3"),
            (metric, "[0, 0.09]", "dT is from 0.1 to 0.3"),
            (
                r#""kind": "convergence", "y": "rms_error""#,
                "[1, 2]",
                "dT is from 0.1 to 0.3",
            ),
            (
                r#""kind": "scatter", "x": "beta", "y": "rms_error""#,
                "[1, 2]",
                "beta is from 0.1 to 0.2",
            ),
            (history, "[12.5, 13]", "the time is from 0 to 12"),
            (history, "[-2, -1]", "the time is from 0 to 12"),
        ] {
            let found = faults(&format!(r#"{figure}, "x_range": {range}"#));
            let says = format!("figures[0].x_range: shows nothing: {extent} in the cases shown");
            assert!(found.contains(&says), "{found}");
        }
        // Between two points there is a line.
        for (figure, range) in [
            (metric, "[0.11, 0.19]"),
            (metric, "[0.3, 1]"),
            (history, "[11, 20]"),
        ] {
            assert_eq!(faults(&format!(r#"{figure}, "x_range": {range}"#)), "");
        }
    }
}
