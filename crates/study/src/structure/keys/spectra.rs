//! The keys of motions that are scaled to a spectrum, and the rules of codes for sets of them.

use super::Keys;
use slipgap_problem::problem::structure::given::motion_set::Statistic;
use slipgap_system::system::loads::pair::Component;

/// Keys of `scale_to`; one of the first four is given.
pub(crate) const SCALE_TO: Keys = &[
    ("pga", "largest acceleration"),
    ("Sa", "pseudo-acceleration of an oscillator"),
    (
        "spectrum",
        "target spectrum, by least squares at 101 periods from \"from\" to \"to\"",
    ),
    (
        "factor",
        "factor of each motion of a set, such as a parameter zipped with the record",
    ),
    ("T", "period of the oscillator of \"Sa\""),
    ("from", "the shorter period of \"spectrum\""),
    ("to", "the longer period of \"spectrum\""),
    (
        "fit",
        "least squares of \"spectrum\": \"linear\" (if left out), of the ordinates at evenly spaced periods; \"logarithmic\", of their logarithms at periods with evenly spaced logarithms, as PEER does",
    ),
    (
        "component",
        "of \"scale_to\" of a ground in x and y, which gives x, y and z one factor: \"geometric-mean\", \"srss\", \"rotd50\" or \"rotd100\" (Boore 2010, 180 angles) of x and y; of one in each direction: \"each\", a factor for each, and no note about it",
    ),
    (
        "ratio",
        "damping ratio of \"Sa\", \"spectrum\" and \"set\"; 0.05 if left out",
    ),
    (
        "unit",
        "unit of the accelerations, as of a record; that of the study if left out",
    ),
    (
        "set",
        "one factor on top for all motions of the axis of records, or of seeds",
    ),
];

/// Number of the keys of [`SCALE_TO`] of which one is needed.
pub(crate) const GOALS: usize = 4;

/// The strength that both horizontal motions get together.
pub(crate) const OF_GROUND: (&str, &str) = (
    "scale_to",
    "strength that x and y get together, by one factor, which z gets, too",
);

/// `scale_to` of a motion that gets the factor of the ground.
pub(crate) const AS_GROUND: &str = "ground";

/// Keys of `set`.
pub(crate) const SET: Keys = &[
    (
        "rule",
        "rule of a code, whose numbers the other keys replace",
    ),
    (
        "period",
        "period of the structure, or a list of them: the rule begins at its share of the least one and ends at that of the largest one",
    ),
    ("from", "first period, if not by \"rule\" and \"period\""),
    ("to", "last period"),
    (
        "statistic",
        "\"mean\" (if left out) or \"envelope\" of the spectra at each of 101 periods with evenly spaced logarithms",
    ),
    (
        "component",
        "of a ground in x and y; if left out, that of the rule, or of \"scale_to\"",
    ),
    ("least", "least ratio to the target, such as 0.9"),
    (
        "least_at_zero",
        "least ratio of the largest accelerations to the target at T = 0",
    ),
    (
        "spectrum",
        "target spectrum; if left out, that of \"scale_to\"",
    ),
    (
        "factor",
        "factor of the set; if left out, the one with which the least ratio is the one asked for",
    ),
];

/// Keys of `choose`.
pub(crate) const CHOOSE: Keys = &[
    ("n", "number of records"),
    ("T", "periods, rising"),
    ("median", "median of the target at these periods"),
    (
        "sigma",
        "standard deviations of the logarithms there, such as those of a conditional spectrum",
    ),
    ("unit", "unit of \"median\": g, m/s2, cm/s2 or mm/s2"),
    (
        "at",
        "period in \"T\" at which all records are scaled to the median first, as \"scale_to\" then does; if left out, none is scaled",
    ),
    (
        "factor",
        "with \"at\": largest factor, and one over the smallest; if left out, any",
    ),
    ("ratio", "damping ratio; 0.05 if left out"),
    (
        "pair",
        "pattern of the files in the other direction: those with the same text for * are chosen as pairs",
    ),
    (
        "component",
        "with \"pair\": of what of a pair the spectrum is",
    ),
];

/// A rule of a code for a set of motions.
pub(crate) struct Rule {
    pub name: &'static str,
    pub meaning: &'static str,
    pub statistic: Statistic,
    /// Of what of a pair; none where the code has a rule for one component.
    pub component: Option<Component>,
    pub least: f64,
    pub at_zero: Option<f64>,
    /// First and last period over that of the structure.
    pub times: [f64; 2],
    /// The smallest number of motions.
    pub motions: usize,
    /// Whether the periods are those of the upper and the lower bound properties of an isolation.
    pub of_bounds: bool,
}

/// The rules, as they are generally quoted.
pub(crate) const RULES: [Rule; 4] = [
    Rule {
        name: "EN 1998-1",
        meaning: "EN 1998-1:2004, 3.2.3.1.2: mean at least 0.9 of the target from 0.2 T to 2 T, and mean of the largest accelerations at least the target at T = 0; at least 3 motions; \"component\" is needed for pairs",
        statistic: Statistic::Mean,
        component: None,
        least: 0.9,
        at_zero: Some(1.0),
        times: [0.2, 2.0],
        motions: 3,
        of_bounds: false,
    },
    Rule {
        name: "EN 1998-2",
        meaning: "EN 1998-2:2005, 3.2.3: mean of the SRSS of pairs at least 1.3 of the target from 0.2 T to 1.5 T; with isolation (7), T are the effective periods with the upper and the lower bound properties; at least 3",
        statistic: Statistic::Mean,
        component: Some(Component::Srss),
        least: 1.3,
        at_zero: None,
        times: [0.2, 1.5],
        motions: 3,
        of_bounds: false,
    },
    Rule {
        name: "ASCE 7-16",
        meaning: "ASCE 7-16, 16.2.3: mean of RotD100 of pairs at least 0.9 of the target from 0.2 of the least to 2 times the largest period; at least 11",
        statistic: Statistic::Mean,
        component: Some(Component::RotD100),
        least: 0.9,
        at_zero: None,
        times: [0.2, 2.0],
        motions: 11,
        of_bounds: false,
    },
    Rule {
        name: "ASCE 7-16 isolation",
        meaning: "ASCE 7-16, 17.3.3: mean of the SRSS of pairs at least the target from 0.2 of the least to 1.25 times the largest period; \"period\" has two, with the upper and the lower bound properties of the isolation; at least 7",
        statistic: Statistic::Mean,
        component: Some(Component::Srss),
        least: 1.0,
        at_zero: None,
        times: [0.2, 1.25],
        motions: 7,
        of_bounds: true,
    },
];

/// Names of the statistics of a set.
pub(crate) const STATISTICS: [(&str, Statistic); 2] =
    [("mean", Statistic::Mean), ("envelope", Statistic::Envelope)];

/// Keys of a target spectrum: one of these, or those of a table.
pub(crate) const SPECTRUM: Keys = &[
    (
        "EN 1998-1",
        "elastic response spectrum of EN 1998-1:2004, (3.2) to (3.6)",
    ),
    ("ASCE 7", "design response spectrum of ASCE 7-16, 11.4.6"),
];

/// Keys of a target spectrum as a table.
pub(crate) const TARGET_TABLE: Keys = &[
    ("T", "periods, rising"),
    ("Sa", "ordinates, straight between, constant beyond"),
];

/// Keys of the spectrum of EN 1998-1.
pub(crate) const EN_1998: Keys = &[
    ("ag", "design ground acceleration on type A ground"),
    ("S", "soil factor"),
    ("TB", "start of the plateau"),
    ("TC", "end of the plateau"),
    ("TD", "start of constant displacement"),
];

/// Keys of the spectrum of ASCE 7.
pub(crate) const ASCE_7: Keys = &[
    ("SDS", "design acceleration at short periods"),
    ("SD1", "design acceleration at 1 s"),
    ("TL", "long-period transition"),
];
