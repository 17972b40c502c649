//! The kinds of figure and the keys that each takes: the one table that decoding, schema and documentation read.

/// One kind of figure.
pub(in crate::study) struct Kind {
    pub name: &'static str,
    pub meaning: &'static str,
    /// Keys beyond those that every figure takes.
    pub keys: &'static [Key],
}

/// One key of a figure.
pub(in crate::study) struct Key {
    pub name: &'static str,
    pub takes: Takes,
    pub required: bool,
    pub meaning: &'static str,
}

/// What stands under a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::study) enum Takes {
    /// A name that becomes a file name.
    FileName,
    /// The name of a kind.
    Kind,
    /// Any string.
    Text,
    /// Parameters with the values that the cases shown have.
    Filter,
    /// A parameter.
    Parameter,
    /// A parameter that is a number.
    NumericParameter,
    /// One or several of the problem's quantities over time.
    Quantities,
    /// One of the problem's quantities along the structure.
    Profile,
    /// One or several of the problem's quantities along the structure.
    Profiles,
    /// A metric.
    Metric,
    /// One or several metrics.
    Metrics,
    /// One or several times, not negative.
    Times,
    /// One or several of the problem's budgets.
    Budgets,
    /// Places on a map and their name.
    Marks,
    /// `linear` or `log`.
    Scale,
}

/// Names of the scales, as `Scale` has them.
pub(in crate::study) const SCALES: [&str; 2] = ["linear", "log"];

const fn key(name: &'static str, takes: Takes, required: bool, meaning: &'static str) -> Key {
    Key {
        name,
        takes,
        required,
        meaning,
    }
}

/// The keys of every figure.
pub(in crate::study) static COMMON: [Key; 5] = [
    key(
        "name",
        Takes::FileName,
        true,
        "file name without ending: letters, digits, - and _; each figure of a study has its own",
    ),
    key("kind", Takes::Kind, true, "what is drawn"),
    key("title", Takes::Text, false, "heading; none if left out"),
    key(
        "note",
        Takes::Text,
        false,
        "what a reader must know beside it, small under the panels; none if left out",
    ),
    key(
        "where",
        Takes::Filter,
        false,
        "the cases to show: those that have all these values; all cases if left out",
    ),
];

/// Every kind of figure.
pub(in crate::study) static KINDS: [Kind; 9] = [
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
            key(
                "panels",
                Takes::Parameter,
                false,
                "parameter whose values get panels of their own",
            ),
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
        keys: &[
            key(
                "x",
                Takes::NumericParameter,
                true,
                "parameter along the horizontal axis",
            ),
            key("y", Takes::Metrics, true, "metrics, one panel each"),
            key(
                "by",
                Takes::Parameter,
                false,
                "parameter whose values are told apart by line style; all others that vary if left out",
            ),
            key(
                "x_scale",
                Takes::Scale,
                false,
                "horizontal scale, linear if left out",
            ),
            key(
                "y_scale",
                Takes::Scale,
                false,
                "vertical scale, linear if left out",
            ),
        ],
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
            key("y", Takes::Metrics, true, "metrics, one panel each"),
            key(
                "by",
                Takes::Parameter,
                false,
                "parameter whose values are told apart by line style; all others that vary if left out",
            ),
        ],
    },
    Kind {
        name: "budget",
        meaning: "the error and its parts against a parameter, both scales logarithmic, with the slope where a curve is straight",
        keys: &[
            key(
                "x",
                Takes::NumericParameter,
                true,
                "parameter along the horizontal axis",
            ),
            key(
                "y",
                Takes::Budgets,
                false,
                "whose error, one row of panels each; all that the problem has if left out",
            ),
            key(
                "panels",
                Takes::Parameter,
                false,
                "parameter whose values get panels of their own",
            ),
        ],
    },
    Kind {
        name: "map",
        meaning: "one metric over two parameters, as filled contours with a colour bar and a line where it is least for each x",
        keys: &[
            key(
                "x",
                Takes::NumericParameter,
                true,
                "parameter along the horizontal axis",
            ),
            key(
                "y",
                Takes::NumericParameter,
                true,
                "parameter up the vertical axis",
            ),
            key("z", Takes::Metric, true, "metric shown as shades"),
            key(
                "x_scale",
                Takes::Scale,
                false,
                "horizontal scale, linear if left out",
            ),
            key(
                "y_scale",
                Takes::Scale,
                false,
                "vertical scale, linear if left out",
            ),
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
        ],
    },
    Kind {
        name: "sobol",
        meaning: "Sobol' indices from a saltelli design, as bars with their 95 % intervals",
        keys: &[key("y", Takes::Metrics, true, "metrics, one panel each")],
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
