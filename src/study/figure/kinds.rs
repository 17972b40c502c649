//! The kinds of figure and the keys that each takes: the one table that decoding, schema and documentation read.

use super::keys::{
    BY_OTHERS, COMMON, Key, METRICS, PANELS, Takes, X, X_RANGE, X_SCALE, Y_RANGE, Y_SCALE, key,
};

/// One kind of figure.
pub(in crate::study) struct Kind {
    pub name: &'static str,
    pub meaning: &'static str,
    /// Keys beyond those that every figure takes.
    pub keys: &'static [Key],
}

/// Every kind of figure.
pub(in crate::study) static KINDS: [Kind; 11] = [
    Kind {
        name: "history",
        meaning: "curves over time, with the exact solution as a thin line; at most 8 cases in a panel",
        keys: &[
            key(
                "y",
                Takes::Quantities,
                false,
                "quantities, one panel each; if left out, the response and its error",
            ),
            key(
                "by",
                Takes::Parameter,
                false,
                "parameter with one line style for each value; if left out, all parameters that vary",
            ),
            PANELS,
            key(
                "in_units",
                Takes::InUnits,
                false,
                "true: axes in the units of the study, which it must give; scaled if left out",
            ),
            X_RANGE,
            Y_RANGE,
        ],
    },
    Kind {
        name: "profile",
        meaning: "quantities along the structure at given times, with the exact solution as a thin line; at most 6 cases",
        keys: &[
            key(
                "y",
                Takes::Profiles,
                false,
                "quantities, one column of panels each; if left out, all",
            ),
            key(
                "times",
                Takes::Times,
                true,
                "times in the unit of the problem, one row of panels each; at most the duration of every case",
            ),
            X_RANGE,
            Y_RANGE,
        ],
    },
    Kind {
        name: "wave",
        meaning: "one case over place and time, as shades with a colour bar: the computed motion and the exact one",
        keys: &[key(
            "y",
            Takes::Profile,
            false,
            "quantity along the structure; if left out, the last one of the problem",
        )],
    },
    Kind {
        name: "metric",
        meaning: "metrics over a parameter",
        keys: &[X, METRICS, BY_OTHERS, X_SCALE, Y_SCALE, X_RANGE, Y_RANGE],
    },
    Kind {
        name: "convergence",
        meaning: "errors over the time step on logarithmic scales, with the observed order where a curve is straight",
        keys: &[
            key(
                "x",
                Takes::NumericParameter,
                false,
                "parameter along the horizontal axis; if left out, the time step",
            ),
            METRICS,
            BY_OTHERS,
            X_RANGE,
            Y_RANGE,
        ],
    },
    Kind {
        name: "budget",
        meaning: "the error and its parts over a parameter on logarithmic scales, with the slope where a curve is straight",
        keys: &[
            X,
            key(
                "y",
                Takes::Budgets,
                false,
                "quantities, one row of panels for the error of each; if left out, all of the problem",
            ),
            PANELS,
            X_RANGE,
            Y_RANGE,
        ],
    },
    Kind {
        name: "map",
        meaning: "one metric over two parameters, as filled contours with a colour bar",
        keys: &[
            X,
            key(
                "y",
                Takes::NumericParameter,
                true,
                "parameter along the vertical axis",
            ),
            key("z", Takes::Metric, true, "metric shown as shades"),
            X_SCALE,
            Y_SCALE,
            key(
                "z_scale",
                Takes::Scale,
                false,
                "scale of the shades; if left out, linear",
            ),
            key(
                "marks",
                Takes::Marks,
                false,
                "points to mark: { \"label\": text, \"at\": [[x, y], ...] }",
            ),
            key(
                "ridge",
                Takes::Ridge,
                false,
                "a line through the y with the least or greatest metric, or with the metric nearest to 1, at each x; not drawn at the edge of the map; if left out, no line",
            ),
        ],
    },
    Kind {
        name: "scatter",
        meaning: "one column of the results over another, one dot for each case; more than 2000 dots become one image in SVG and PDF",
        keys: &[
            key(
                "x",
                Takes::Column,
                true,
                "parameter or metric along the horizontal axis",
            ),
            key(
                "y",
                Takes::Column,
                true,
                "parameter or metric along the vertical axis",
            ),
            key(
                "colour",
                Takes::Column,
                false,
                "parameter or metric shown by the colour of the dots, with a colour bar; if left out, one colour",
            ),
            X_SCALE,
            Y_SCALE,
            key(
                "colour_scale",
                Takes::Scale,
                false,
                "scale of the colours; if left out, linear",
            ),
            X_RANGE,
            Y_RANGE,
        ],
    },
    Kind {
        name: "samples",
        meaning: "every pair of the parameters that a design samples, one dot for each case; a metric is the colour of the dots and the last row; at most 8 parameters; each axis has the scale of its distribution",
        keys: &[
            key(
                "y",
                Takes::Metric,
                true,
                "metric of the last row and of the colours",
            ),
            key(
                "y_scale",
                Takes::Scale,
                false,
                "scale of the metric; if left out, linear",
            ),
        ],
    },
    Kind {
        name: "sobol",
        meaning: "Sobol' indices of a saltelli design as bars, with the middle 95 % of bootstrap samples",
        keys: &[METRICS],
    },
    Kind {
        name: "law",
        meaning: "the laws of the cases: force over displacement or velocity",
        keys: &[],
    },
];

impl Kind {
    /// Whether it draws what only a problem with extent has.
    pub fn needs_extent(&self) -> bool {
        let along = |key: &Key| matches!(key.takes, Takes::Profile | Takes::Profiles);
        self.keys.iter().any(along)
    }
}

/// Names of all kinds.
pub(in crate::study) fn names() -> Vec<&'static str> {
    KINDS.iter().map(|kind| kind.name).collect()
}

/// Names of all keys of figures, each once.
pub(in crate::study) fn all_keys() -> Vec<&'static str> {
    let mut names: Vec<&str> = COMMON.iter().map(|key| key.name).collect();
    for key in KINDS.iter().flat_map(|kind| kind.keys) {
        if !names.contains(&key.name) {
            names.push(key.name);
        }
    }
    names
}

/// Names of the kinds that take `key`.
pub(in crate::study) fn takers(key: &str) -> Vec<&'static str> {
    KINDS
        .iter()
        .filter(|kind| kind.keys.iter().any(|k| k.name == key))
        .map(|kind| kind.name)
        .collect()
}
