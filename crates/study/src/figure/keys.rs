//! The keys of figures, and the types of their values.

use crate::field::{Field, field, fields, needed};

/// One key of a figure.
pub(crate) type Key = Field<Takes>;

/// The type of the value of a key.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Takes {
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
    /// One or several parameters.
    Parameters,
    /// A parameter that is a number.
    NumericParameter,
    /// One of the problem's quantities over time.
    Quantity,
    /// One or several of the problem's quantities over time.
    Quantities,
    /// A parameter that is a number, or a metric.
    Column,
    /// One or several of them.
    Columns,
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
    /// A width in mm.
    Width,
    /// The first and last value of an axis.
    Range,
    /// Places on a map and their name.
    Marks,
    /// `linear` or `log`.
    Scale,
    /// The same; default `log`.
    ScaleOrLog,
    /// Which value a line follows.
    Ridge,
    /// How a fragility function is found.
    Fit,
    /// What is drawn of each cycle.
    Each,
    /// Whether axes are in the units of the study.
    InUnits,
    /// `true` or `false`.
    Switch,
    /// One or several ordinates of response spectra.
    Ordinates,
    /// One or several damping ratios, from 0 to less than 1.
    Ratios,
    /// The first and last period of a spectrum.
    Periods,
    /// A number.
    Number,
    /// Two probabilities, rising.
    Probabilities,
    /// Points of a hazard curve.
    Hazard,
}

/// Names of the ordinates of spectra, as `Ordinate` has them, each with its formula.
pub(crate) const ORDINATES: [(&str, &str); 3] = [
    (
        "displacement",
        "spectral displacement S_d: largest displacement of an oscillator relative to the ground",
    ),
    ("pseudo-velocity", "2 pi/T times S_d"),
    ("pseudo-acceleration", "(2 pi/T)^2 times S_d"),
];

/// Names of the scales, as `Scale` has them.
pub(crate) const SCALES: [&str; 2] = ["linear", "log"];

/// Names of the ways to find a fragility function, as `Fit` has them.
pub(crate) const FITS: [&str; 3] = ["likelihood", "incremental", "cloud"];

/// Names of what is drawn of each cycle, as `Each` has them.
pub(crate) const EACH: [&str; 4] = ["peak", "max", "min", "start"];

/// Names of the lines along a map, as `Ridge` has them.
pub(crate) const RIDGES: [&str; 3] = ["least", "greatest", "nearest to 1"];

/// The keys of every figure.
pub(crate) static COMMON: [Key; 6] = fields![
    /// file name without extension: letters, digits, - and _
    needed("name", Takes::FileName),
    /// what is drawn
    needed("kind", Takes::Kind),
    /// heading
    field("title", Takes::Text),
    /// remark in small type under the panels
    field("note", Takes::Text),
    /// width in mm, 70 to 400 (a column 90, a page 190); letters keep their size
    field("width", Takes::Width),
    /// which cases to show: a value or a list for parameters
    field("where", Takes::Filter),
];

/// Keys of several kinds.
pub(super) const X: Key =
    needed("x", Takes::NumericParameter).means("parameter along the horizontal axis");
pub(super) const METRICS: Key = needed("y", Takes::Metrics).means("metrics, one panel each");
pub(super) const BY_OTHERS: Key = field("by", Takes::Parameter)
    .means("parameter with one line style for each value; default: all others that vary, outside of an ensemble");
pub(super) const IN_UNITS: Key =
    field("in_units", Takes::InUnits).means("true: axes in the units of the study");
pub(super) const BY: Key = field("by", Takes::Parameter)
    .means("parameter with one line style for each value; default: all others that vary, outside of an ensemble");
pub(super) const BY_OUTSIDE: Key = field("by", Takes::Parameter).means(
    "parameter with one line style for each value; default: all others that vary, outside of an ensemble",
);
/// The probabilities of the edges of a band if the study gives none: those of one standard deviation of a normal
/// distribution.
pub(super) const USUAL: [f64; 2] = [0.16, 0.84];
pub(super) const BAND: Key = field("band", Takes::Probabilities)
    .means("probabilities at the edges of the band; default [0.16, 0.84]");
pub(super) const PANELS: Key =
    field("panels", Takes::Parameter).means("parameter with one panel for each value");
pub(super) const X_SCALE: Key =
    field("x_scale", Takes::Scale).means("horizontal scale; default linear");
pub(super) const Y_SCALE: Key =
    field("y_scale", Takes::Scale).means("vertical scale; default linear");
pub(super) const X_RANGE: Key = field("x_range", Takes::Range)
    .means("first and last value of the horizontal axis, as in [0, 10]");
pub(super) const Y_RANGE: Key = field("y_range", Takes::Range)
    .means("first and last value of the vertical axis, for one quantity in y");
pub(super) const COLOUR: Key = field("colour", Takes::Switch)
    .means("false: black curves with dashes and markers, and hatched bands; default: colours for any colour vision, from the seventh curve on with markers");
pub(super) const MARKERS: Key =
    field("markers", Takes::Switch).means("true: curves in colour have markers, too");
