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
        meaning: "curves over time, the exact solution as a thin line; at most 8 cases a panel",
        keys: &[
            key(
                "y",
                Takes::Quantities,
                false,
                "quantities, one panel each; the response and its error if left out",
            ),
            key(
                "by",
                Takes::Parameter,
                false,
                "parameter whose values are told apart by line style; all that vary if left out",
            ),
            PANELS,
            X_RANGE,
            Y_RANGE,
        ],
    },
    Kind {
        name: "profile",
        meaning: "quantities along the structure at given times, the exact solution as a thin line; at most 6 cases",
        keys: &[
            key(
                "y",
                Takes::Profiles,
                false,
                "quantities, one column of panels each; all if left out",
            ),
            key(
                "times",
                Takes::Times,
                true,
                "times in the problem's unit, one row of panels each; none beyond the duration of a case",
            ),
            X_RANGE,
            Y_RANGE,
        ],
    },
    Kind {
        name: "wave",
        meaning: "one case over place and time, as shades with a colour bar: computed, and exact beside it",
        keys: &[key(
            "y",
            Takes::Profile,
            false,
            "quantity along the structure; the problem's last if left out",
        )],
    },
    Kind {
        name: "metric",
        meaning: "metrics against a parameter",
        keys: &[X, METRICS, BY_OTHERS, X_SCALE, Y_SCALE, X_RANGE, Y_RANGE],
    },
    Kind {
        name: "convergence",
        meaning: "errors against the step, both scales logarithmic, with the observed order where a curve is straight",
        keys: &[
            key(
                "x",
                Takes::NumericParameter,
                false,
                "parameter along the horizontal axis; the step if left out",
            ),
            METRICS,
            BY_OTHERS,
            X_RANGE,
            Y_RANGE,
        ],
    },
    Kind {
        name: "budget",
        meaning: "the error and its parts against a parameter, both scales logarithmic, with the slope where a curve is straight",
        keys: &[
            X,
            key(
                "y",
                Takes::Budgets,
                false,
                "whose error, one row of panels each; all that the problem has if left out",
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
                "parameter up the vertical axis",
            ),
            key("z", Takes::Metric, true, "metric shown as shades"),
            X_SCALE,
            Y_SCALE,
            key(
                "z_scale",
                Takes::Scale,
                false,
                "scale of the shades, linear if left out",
            ),
            key(
                "marks",
                Takes::Marks,
                false,
                "places to mark: { \"label\": words, \"at\": [[x, y], ...] }",
            ),
            key(
                "ridge",
                Takes::Ridge,
                false,
                "a line through the place of the least or greatest metric at each x, or of that nearest to 1, where it is not at the edge; none if left out",
            ),
        ],
    },
    Kind {
        name: "scatter",
        meaning: "one column of the results against another, a dot a case; more than 2000 dots are one image in SVG and PDF",
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
                "parameter or metric up the vertical axis",
            ),
            key(
                "colour",
                Takes::Column,
                false,
                "parameter or metric shown by the colour of the dots, with a colour bar; one colour if left out",
            ),
            X_SCALE,
            Y_SCALE,
            key(
                "colour_scale",
                Takes::Scale,
                false,
                "scale of the colours, linear if left out",
            ),
            X_RANGE,
            Y_RANGE,
        ],
    },
    Kind {
        name: "samples",
        meaning: "the parameters that a design samples against one another, a dot a case, with a metric as colour and in the last row; at most 8 parameters; each axis has the scale of its distribution",
        keys: &[
            key(
                "y",
                Takes::Metric,
                true,
                "metric in the last row and as colour",
            ),
            key(
                "y_scale",
                Takes::Scale,
                false,
                "scale of the metric, linear if left out",
            ),
        ],
    },
    Kind {
        name: "sobol",
        meaning: "Sobol' indices from a saltelli design, as bars with the middle 95 % of bootstrap samples",
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
