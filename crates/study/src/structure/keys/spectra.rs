//! The keys of motions that are scaled to a spectrum, and the rules of codes for sets of them.

use super::kinds::{ANY_NUMBERS, UNIT};
use crate::source::field::Kind::{self, List, Number, Object, Several, Text, Whole, Words};
use crate::source::field::{ANY, Field, Keys, Rule as KeyRule, field, fields, needed};
use slipgap_problem::problem::numbers::parameter::Range::{NotNegative, Positive, UpToOne};
use slipgap_problem::problem::structure::given::motion_set::Statistic;
use slipgap_system::system::loads::pair::Component;
use slipgap_system::system::loads::target::Fit;

/// The strength of one motion.
pub(crate) const SCALE_TO: Keys =
    Keys::new(&scale_to(Words("component", || vec!["each"], None))).rules(&OF_SCALE_TO);

/// The strength that both horizontal motions get together.
pub(crate) const OF_GROUND: Field = field("scale_to", Object(&TOGETHER))
    .means("strength that x and y get together, by one factor, which z gets, too");

/// The same.
pub(crate) const TOGETHER: Keys = Keys::new(&scale_to(COMPONENT)).rules(&OF_SCALE_TO);

/// Of what of a pair.
const COMPONENT: Kind = Words(
    "component",
    || Component::ALL.map(Component::name).to_vec(),
    None,
);

const fn scale_to(component: Kind) -> [Field; 12] {
    fields![
        /// largest acceleration
        field("pga", Number(Positive)),
        /// pseudo-acceleration of an oscillator
        field("Sa", Number(Positive)),
        /// target spectrum, by least squares at 101 periods from "from" to "to"
        field("spectrum", Object(&TARGET)),
        /// factor of each motion of a set, such as a parameter in `zip` with the record
        field("factor", Number(Positive)),
        /// period of the oscillator of "Sa"
        field("T", Number(Positive)),
        /// the shorter period of "spectrum"
        field("from", Number(Positive)),
        /// the longer period of "spectrum"
        field("to", Number(Positive)),
        /// least squares of "spectrum": "linear" (default), of the ordinates at evenly spaced periods; "logarithmic", of their logarithms at periods with evenly spaced logarithms, as PEER does
        field("fit", Words("fit", || Fit::ALL.map(Fit::name).to_vec(), None)),
        /// of a ground in x and y, with one factor for x, y and z: "geometric-mean", "srss", "rotd50" or "rotd100" (Boore 2010, 180 angles); of one direction: "each", its own factor, without a note about it
        field("component", component),
        /// damping ratio of "Sa", "spectrum" and "set"; default 0.05
        field("ratio", Number(UpToOne)),
        /// unit of the accelerations; default: that of the study
        field("unit", UNIT),
        /// one more factor for all records or seeds
        field("set", Object(&SET)),
    ]
}

/// The keys of a strength of which one is given.
pub(crate) const GOALS: [&str; 4] = ["pga", "Sa", "spectrum", "factor"];

const OF_SCALE_TO: [KeyRule; 7] = [
    KeyRule::One(&GOALS, &[]),
    KeyRule::With(&["T"], &[KeyRule::Has(&["Sa"])]),
    KeyRule::With(&["Sa"], &[KeyRule::Has(&["T"])]),
    KeyRule::With(&["from", "to", "fit"], &[KeyRule::Has(&["spectrum"])]),
    KeyRule::With(&["spectrum"], &[KeyRule::Has(&["from", "to"])]),
    KeyRule::With(&["factor"], &[KeyRule::Has(&["set"])]),
    KeyRule::With(
        &["ratio"],
        &[KeyRule::Any(
            &[],
            &[&[KeyRule::NotAll(&["pga"])], &[KeyRule::Has(&["set"])]],
        )],
    ),
];

/// A set of motions.
pub(crate) const SET: Keys = Keys::new(&fields![
    /// rule of a code, whose numbers the other keys replace
    field("rule", Words("rule", || RULES.map(|rule| rule.name).to_vec(), None)),
    /// period of the structure, or a list: the rule goes from its share of the least to that of the largest
    field("period", Several(&Number(Positive), [1, ANY])),
    /// first period, if not by "rule" and "period"
    field("from", Number(Positive)),
    /// last period
    field("to", Number(Positive)),
    /// "mean" (default) or "envelope" of the spectra, at 101 periods with evenly spaced logarithms
    field("statistic", Words("statistic", || STATISTICS.map(|row| row.0).to_vec(), None)),
    /// of a ground in x and y; default: that of the rule, or of "scale_to"
    field("component", COMPONENT),
    /// least ratio to the target, such as 0.9
    field("least", Number(Positive)),
    /// least ratio of the largest accelerations to the target at T = 0
    field("least_at_zero", Number(Positive)),
    /// target spectrum; default that of "scale_to"
    field("spectrum", Object(&TARGET)),
    /// factor of the set; default: the least that keeps the rule
    field("factor", Number(Positive)),
])
.rules(&[KeyRule::With(&["period"], &[KeyRule::Has(&["rule"])])]);

/// A choice among files.
pub(crate) const CHOOSE: Keys = Keys::new(&fields![
    /// number of records
    needed("n", Whole([2, 10_000])),
    /// periods, rising
    needed("T", List(&Number(Positive), [1, ANY])),
    /// median of the target at these periods
    needed("median", List(&Number(Positive), [1, ANY])),
    /// standard deviations of the logarithms there
    needed("sigma", List(&Number(NotNegative), [1, ANY])),
    /// unit of "median": g, m/s2, cm/s2 or mm/s2
    needed("unit", UNIT),
    /// period in "T" at which all records are first scaled to the median, as with "scale_to"; default none
    field("at", Number(Positive)),
    /// with "at": largest factor, and one over the smallest; default any
    field("factor", Number(Positive)),
    /// damping ratio; default 0.05
    field("ratio", Number(UpToOne)),
    /// pattern of the files in the other direction, with the same text for *
    field("pair", Text),
    /// with "pair": of what of a pair the spectrum is
    field("component", COMPONENT),
])
.rules(&[
    KeyRule::With(&["factor"], &[KeyRule::Has(&["at"])]),
    KeyRule::With(&["pair"], &[KeyRule::Has(&["component"])]),
    KeyRule::With(&["component"], &[KeyRule::Has(&["pair"])]),
]);

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

/// The spectra of codes.
pub(crate) const SPECTRUM: Keys = Keys::new(&fields![
    /// elastic response spectrum of EN 1998-1:2004, (3.2) to (3.6)
    field("EN 1998-1", Object(&EN_1998)),
    /// design response spectrum of ASCE 7-16, 11.4.6
    field("ASCE 7", Object(&ASCE_7)),
]);

/// A target spectrum as a table.
pub(crate) const TARGET_TABLE: Keys = Keys::new(POINTS);

const POINTS: &[Field] = &fields![
    /// periods, rising
    field("T", ANY_NUMBERS),
    /// ordinates, straight between, constant beyond
    field("Sa", ANY_NUMBERS),
];

/// A target spectrum: one of a code, or a table.
pub(crate) const TARGET: Keys = SPECTRUM.and(POINTS).rules(&[
    KeyRule::One(&["EN 1998-1", "ASCE 7"], &[&[KeyRule::Has(&["T", "Sa"])]]),
    KeyRule::With(&["T", "Sa"], &[KeyRule::Has(&["T", "Sa"])]),
]);

/// The spectrum of EN 1998-1.
pub(crate) const EN_1998: Keys = Keys::new(&fields![
    /// design ground acceleration on type A ground
    needed("ag", Number(Positive)),
    /// soil factor
    needed("S", Number(Positive)),
    /// start of the plateau
    needed("TB", Number(Positive)),
    /// end of the plateau
    needed("TC", Number(Positive)),
    /// start of constant displacement
    needed("TD", Number(Positive)),
]);

/// The spectrum of ASCE 7.
pub(crate) const ASCE_7: Keys = Keys::new(&fields![
    /// design acceleration at short periods
    needed("SDS", Number(Positive)),
    /// design acceleration at 1 s
    needed("SD1", Number(Positive)),
    /// long-period transition
    needed("TL", Number(Positive)),
]);
