//! Two metrics of many cases against each other, and the best cases of each value of a parameter.

use crate::Scale;
use crate::field::{field, fields, needed};
use crate::figure::checker::{Checker, NARROW};
use crate::figure::keys::{COLOUR, MARKERS, Takes, X_RANGE, Y_RANGE};
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};
use slipgap_cases::alike;
use slipgap_problem::problem::{Case, Problem};

/// Most lines of a panel: as many as a reader can distinguish where they are close.
const MOST_LINES: usize = 12;

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "front",
    needs: Needs::Nothing,
    meaning: "two metrics of which less is better: for each value of a parameter a line through its best cases, which no other surpasses in both; the best of all are on a light band",
    keys: &fields![
        /// metric along the horizontal axis, such as the cost
        needed("x", Takes::Metric),
        /// metric along the vertical axis, such as an error
        needed("y", Takes::Metric),
        /// parameters, one panel each, a line for each value, at most 12
        needed("by", Takes::Parameters),
        /// parameter over which x is a mean, y a root mean square
        field("mean_over", Takes::Parameter),
        /// horizontal scale; default log
        field("x_scale", Takes::ScaleOrLog),
        /// vertical scale; default log
        field("y_scale", Takes::ScaleOrLog),
        X_RANGE,
        Y_RANGE,
        COLOUR,
        MARKERS,
    ],
    decode: |values, _| {
        Some(FigureKind::Front(Front {
            x: values.row("x")?,
            y: values.row("y")?,
            by: values.rows("by")?,
            mean_over: values.row("mean_over"),
            scales: ["x_scale", "y_scale"].map(|key| values.scale_or(key, Scale::Log)),
        }))
    },
};

/// Two metrics of many cases, and the best cases of each value of a parameter.
#[derive(Debug)]
pub struct Front {
    /// Row of the study's measures along the horizontal axis.
    pub x: usize,
    /// Row of the study's measures along the vertical axis.
    pub y: usize,
    /// Parameters, one panel each, with one line for each value.
    pub by: Vec<usize>,
    /// Parameter over which cases that are otherwise the same are averaged.
    pub mean_over: Option<usize>,
    /// Scales of the axes.
    pub scales: [Scale; 2],
}

impl Decoded for Front {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        Some((self.scales, 1))
    }

    fn check_keys(&self, checker: &mut Checker) {
        if self.x == self.y {
            checker.fault("y", "must be a metric other than x");
        }
    }

    fn check_cases(&self, checker: &mut Checker) {
        for (i, row) in self.by.iter().enumerate() {
            let name = checker.scope.problem.parameters()[*row].name.clone();
            let count = checker.levels(*row).len();
            if let Some(message) = checker.hidden(*row) {
                checker.fault_of_item("by", i, message);
            } else if count == 0 {
                let message = format!("{name} is given in none of the cases shown");
                checker.fault_of_item("by", i, message);
            } else if count > MOST_LINES {
                let message =
                    format!("{name} has {count} values; allowed: at most {MOST_LINES}; {NARROW}");
                checker.fault_of_item("by", i, message);
            }
        }
        if let Some(row) = self.mean_over {
            self.check_means(row, checker);
        }
    }

    fn measures(&self, _: &dyn Problem) -> Vec<usize> {
        vec![self.x, self.y]
    }
}

impl Front {
    /// Reports lines by what the means are over, and cases without their partners.
    fn check_means(&self, over: usize, checker: &mut Checker) {
        let scope = checker.scope;
        let table = scope.problem.parameters();
        let name = &table[over].name;
        let levels = checker.levels(over);
        if levels.is_empty() {
            let message = format!("{name} is given in none of the cases shown");
            checker.fault("mean_over", message);
            return;
        }
        let shared = alike::unaffected(&*scope.problem, &scope.blocks, &[over]);
        for (i, row) in self.by.iter().enumerate() {
            if !shared.contains(row) {
                let message = match *row == over {
                    true => format!("the figure shows means over {name}"),
                    false => format!(
                        "{} changes with {name}, which the figure shows means over",
                        table[*row].name
                    ),
                };
                checker.fault_of_item("by", i, message);
            }
        }
        // The first case of each mean, and how many cases have each value.
        let mut groups = alike::Groups::new(&shared);
        let mut means: Vec<(Case, Vec<usize>)> = Vec::new();
        for case in checker.cases() {
            let level = case.values[over]
                .and_then(|value| levels.iter().position(|level| level.matches(value)));
            let (group, is_new) = groups.place(&case);
            if is_new {
                means.push((case, vec![0; levels.len()]));
            }
            if let Some(level) = level {
                means[group].1[level] += 1;
            }
        }
        let uneven = means.iter().find_map(|(case, counts)| {
            let level = counts.iter().position(|count| *count != 1)?;
            Some((case, levels[level], counts[level]))
        });
        let Some((case, level, count)) = uneven else {
            return;
        };
        let varies = |row: &usize| checker.levels(*row).len() > 1;
        let varying: Vec<usize> = shared.iter().copied().filter(varies).collect();
        let number = match count {
            0 => "no case has".to_owned(),
            count => format!("{count} cases have"),
        };
        let message = format!(
            "needs one case with each value of {name} and the other parameters the same, but {number} {name} = {level} and {}; {NARROW}",
            alike::values(case, &varying)
        );
        checker.fault("mean_over", message);
    }
}

#[cfg(test)]
mod tests {
    use crate::parse;

    /// What is wrong with a figure of friction oscillators of two laws.
    fn wrong(figure: &str) -> String {
        let study = format!(
            r#"{{"problem": "friction-oscillator", "blocks": [
              {{"parameters": {{"law": "displacement-control", "alpha": [0.1, 1], "dT": ["pi/10", "pi/20"], "x0": [8, 12],
                               "duration": "x0*pi"}}}},
              {{"parameters": {{"law": "velocity-control", "beta": {{"geomspace": [0.001, 1, 13]}}, "dT": "pi/10",
                               "x0": [8, 12, 15], "duration": "8*pi"}}}}],
              "figures": [{{"name": "f", "kind": "front", {figure}}}]}}"#
        );
        let wrong = parse("s", &study).err().map(|e| e.to_string());
        wrong.unwrap_or_default()
    }

    #[test]
    fn faults_name_the_key_and_what_is_allowed() {
        let metrics = r#""x": "max_error", "y": "rms_error""#;
        for (figure, message) in [
            (format!(r#"{metrics}, "by": "law""#), ""),
            (
                format!(
                    r#"{metrics}, "by": ["law", "alpha", "dT"], "x_scale": "linear", "y_range": [1e-3, 1]"#
                ),
                "",
            ),
            (
                format!(
                    r#"{metrics}, "by": "law", "mean_over": "x0", "where": {{"law": "displacement-control"}}"#
                ),
                "",
            ),
            (
                format!(r#"{metrics}, "by": "law", "mean_over": "x0", "where": {{"x0": [8, 12]}}"#),
                "",
            ),
            (
                format!(r#"{metrics}, "by": "law", "mean_over": "x0""#),
                "figures[0].mean_over: needs one case with each value of x0 and the other parameters the same, but no case has \
                 x0 = 15 and law = displacement-control, alpha = 0.1, dT = 0.3141592653589793; narrow the cases",
            ),
            (
                format!(
                    r#"{metrics}, "by": ["law", "x0"], "mean_over": "x0", "where": {{"x0": [8, 12]}}"#
                ),
                "figures[0].by[1]: the figure shows means over x0",
            ),
            (
                format!(
                    r#"{metrics}, "by": "duration", "mean_over": "x0", "where": {{"x0": [8, 12]}}"#
                ),
                "figures[0].by: duration changes with x0, which the figure shows means over",
            ),
            (
                format!(
                    r#"{metrics}, "by": "law", "mean_over": "beta", "where": {{"law": "displacement-control"}}"#
                ),
                "figures[0].mean_over: beta is given in none of the cases shown",
            ),
            (
                format!(r#"{metrics}, "by": ["law", "beta"]"#),
                "figures[0].by[1]: beta has 13 values; allowed: at most 12; narrow the cases with \"where\"",
            ),
            (
                format!(r#"{metrics}, "by": "beta", "where": {{"law": "displacement-control"}}"#),
                "figures[0].by: beta is given in none of the cases shown",
            ),
            (
                r#""x": "rms_error", "y": "rms_error", "by": "law""#.into(),
                "figures[0].y: must be a metric other than x",
            ),
            (
                format!(r#"{metrics}, "by": "law", "x_range": [0, 1]"#),
                "figures[0].x_range[0]: must be > 0 on a log scale, got 0",
            ),
            (
                metrics.into(),
                "figures[0].by: missing: parameters, one panel each",
            ),
        ] {
            let told = wrong(&figure);
            assert!(
                told.contains(message) && message.is_empty() == told.is_empty(),
                "{figure}: {told}"
            );
        }
    }
}
