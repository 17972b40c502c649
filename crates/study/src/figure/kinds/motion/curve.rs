//! A quantity over another.

use super::{history, response};
use crate::Scale;
use crate::field::{field, fields, needed};
use crate::figure::checker::Checker;
use crate::figure::keys::{BY, COLOUR, IN_UNITS, MARKERS, PANELS, Takes, X_RANGE, Y_RANGE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "curve",
    needs: Needs::Nothing,
    meaning: "one quantity over another, such as loops of force over displacement; at most 8 cases in a panel",
    keys: &fields![
        /// quantity along the horizontal axis
        needed("x", Takes::Quantity),
        /// quantities, one panel each
        needed("y", Takes::Quantities),
        BY,
        PANELS,
        IN_UNITS,
        /// first and last time; default the whole motion
        field("time_range", Takes::Range),
        /// true: a Poincare section, the points at which the excitation rises through 0
        field("section", Takes::Switch),
        X_RANGE,
        Y_RANGE,
        COLOUR,
        MARKERS,
    ],
    decode: |values, _| {
        Some(FigureKind::Curve(Curve {
            x: values.row("x")?,
            y: values.rows("y")?,
            by: values.row("by"),
            panels: values.row("panels"),
            in_units: values.switch("in_units"),
            times: values.range("time_range"),
            section: values.switch("section"),
        }))
    },
};

/// One quantity over another, the exact solution thin.
#[derive(Debug)]
pub struct Curve {
    /// Row of `problem.schema().quantities` along the horizontal axis.
    pub x: usize,
    /// Rows of `problem.schema().quantities`, one panel each.
    pub y: Vec<usize>,
    /// Parameter with one line style for each value; `None`: all that vary.
    pub by: Option<usize>,
    /// Parameter with one panel for each value.
    pub panels: Option<usize>,
    /// Whether the axes are in the units of the study.
    pub in_units: bool,
    /// First and last time, in the unit of the axes, if the study gives them.
    pub times: Option<[f64; 2]>,
    /// Whether only the points at the start of each cycle of the excitation are shown.
    pub section: bool,
}

impl Decoded for Curve {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some(([Scale::Linear; 2], self.y.len()))
    }

    fn check_keys(&self, checker: &mut Checker) {
        for (i, _) in self.y.iter().enumerate().filter(|(_, row)| **row == self.x) {
            checker.fault_of_item("y", i, "must be a quantity other than x");
        }
    }

    fn check_cases(&self, checker: &mut Checker) {
        history::check(checker, self.by, self.panels, self.y.len(), KIND.name);
        history::check_times(checker, "time_range", self.times, self.in_units);
        if self.section {
            response::check_cycles(checker, "section");
        }
    }

    fn draws_histories(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use crate::parse;

    /// What is wrong with a figure of friction oscillators, by its first line.
    fn wrong(figure: &str) -> String {
        let study = format!(
            "{{\"problem\": \"friction-oscillator\",\n\"parameters\": {{\"law\": \"displacement-control\", \"alpha\": [0.1, 1], \
             \"x0\": [8, 12], \"dT\": 0.1, \"duration\": 9}},\n\"figures\": [{{\"name\": \"f\", \"kind\": \"curve\", {figure}}}]}}"
        );
        let wrong = parse("s", &study).err().map(|e| e.to_string());
        wrong
            .unwrap_or_default()
            .lines()
            .next()
            .unwrap_or_default()
            .to_owned()
    }

    #[test]
    fn faults_name_the_key_and_what_is_allowed() {
        for (figure, message) in [
            (r#""x": "X", "y": "S""#, ""),
            (
                r#""x": "X", "y": ["S", "V"], "by": "alpha", "panels": "x0""#,
                "",
            ),
            (
                r#""x": "X", "y": "S", "x_range": [-1, 1], "y_range": [-2, 2]"#,
                "",
            ),
            (
                r#""y": "S""#,
                "s:3:13: figures[0].x: missing: quantity along the horizontal axis",
            ),
            (
                r#""x": "T", "y": "S""#,
                "s:3:49: figures[0].x: unknown quantity \"T\"",
            ),
            (
                r#""x": "X", "y": ["S", "X"]"#,
                "s:3:65: figures[0].y[1]: must be a quantity other than x",
            ),
            (
                r#""x": "X", "y": "S", "by": "alpha""#,
                "s:3:13: figures[0].where: a curve figure with \"by\" shows one case for each curve, but x0 varies",
            ),
            (
                r#""x": "X", "y": ["S", "V"], "y_range": [0, 1]"#,
                "figures[0].y_range: takes one quantity in \"y\", and the figure has 2",
            ),
            (
                r#""x": "X", "y": "S", "z": 1"#,
                "a curve figure has no key \"z\"",
            ),
        ] {
            let told = wrong(figure);
            assert!(
                told.contains(message) && message.is_empty() == told.is_empty(),
                "{figure}: {told}"
            );
        }
    }

    #[test]
    fn channels_of_structures_may_be_along_both_axes() {
        let study = |x: &str| {
            format!(
                r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}}, "metrics": ["peak(m)"],
                  "structure": {{"masses": {{"m": 1}},
                    "contacts": {{"s": {{"law": "coulomb", "between": ["ground", "m"], "limit": 1}}}}}},
                  "figures": [{{"name": "f", "kind": "curve", "x": "{x}", "y": "s.S"}}]}}"#
            )
        };
        let study_of_slip = parse("s", &study("s.slip")).unwrap_or_else(|e| panic!("{e}"));
        let names: Vec<&str> = study_of_slip
            .problem
            .schema()
            .quantities
            .iter()
            .map(|q| &*q.name)
            .collect();
        assert_eq!(names, ["s.slip", "s.S"]);
        let told = parse("s", &study("s.F")).unwrap_err().to_string();
        assert!(
            told.contains("figures[0].x: \"s.F\": a contact has the channels"),
            "{told}"
        );
    }
}
