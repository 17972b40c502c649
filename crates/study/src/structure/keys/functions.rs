//! The keys of functions of time and of loads.

use super::kinds::{ANY_NUMBER, ANY_NUMBERS, BASELINE, NAME, UNIT};
use super::spectra::{CHOOSE, SCALE_TO};
use crate::source::field::Kind::{self, Count, Number, Object, OneOf, Shared, Text, Whole, Words};
use crate::source::field::{Field, Keys, Rule, field, fields, needed};
use slipgap_problem::problem::numbers::parameter::Range::{self, NotNegative, Positive};
use slipgap_problem::problem::structure::given::source::LARGEST_SEED;
use slipgap_system::system::loads::pulse::{PULSES, Pulse};
use slipgap_system::system::loads::record::Mean;
use std::sync::LazyLock;

/// The keys of a function of time of which one is needed.
pub(crate) const FUNCTIONS: [&str; 5] = ["sine", "table", "record", "pulse", "synthetic"];

/// A function of time.
pub(crate) const FUNCTION: Keys = Keys::new(OF_FUNCTION).rules(&OF_ONE);

/// What the keys of a function need of each other.
const OF_ONE: [Rule; 3] = [Rule::One(&FUNCTIONS, &[]), OF_KINDS[0], OF_KINDS[1]];

/// The same of a function of any kind.
pub(super) const OF_KINDS: [Rule; 2] = [
    Rule::With(
        &["sine"],
        &[Rule::No(&["start", "end", "baseline", "scale_to", "delay"])],
    ),
    Rule::With(
        &["unit", "mean", "column", "dt", "component"],
        &[Rule::Has(&["record"])],
    ),
];

/// Most columns and components of a file.
pub(crate) const MOST: u64 = 1_000_000;

/// The number of a column or a component, or a parameter.
const PLACE: Kind = OneOf(&[Count(MOST), NAME]);

/// The keys of a function of time.
pub(super) const OF_FUNCTION: &[Field] = &fields![
    /// amplitude sin(omega t + phase)
    field("sine", Object(&SINE)),
    /// straight lines between points, constant beyond
    field("table", Object(&TABLE)),
    /// file of a recorded acceleration, relative to the study; a parameter that chooses it; or {"files": ...} as an axis
    field("record", OneOf(&[Text, Object(&FILES),
])),
    /// a pulse of acceleration
    field("pulse", Shared("pulse")),
    /// a synthetic acceleration by its seed, or by seed and omega
    field("synthetic", OneOf(&[Object(&SYNTHETIC), SEED])),
    /// unit of a record: g, m/s2, cm/s2 or mm/s2, or a parameter with these; default: that of the file
    field("unit", OneOf(&[UNIT, NAME])),
    /// mean of a record: "removed" (default of K-NET) or "kept" (default of others)
    field("mean", Words("mean", || Mean::ALL.map(Mean::name).to_vec(), None)),
    /// column of a table, or of UNAM, with the accelerations, from 1, or a parameter; default t and a; another file has the column 1
    field("column", PLACE),
    /// time step in s of a table without times, or a parameter; of another file that of its header
    field("dt", Number(Positive)),
    /// component of a file with several, from 1, or a parameter
    field("component", PLACE),
    /// factor of the function, in addition to "scale_to"
    field("scale", ANY_NUMBER),
    /// time that becomes t = 0; this and the keys below not of a sine
    field("start", Number(NotNegative)),
    /// time at which it ends; 0 after
    field("end", Number(NotNegative)),
    /// what is removed: "none"; "mean" of the points; "linear", the mean slope of the velocity, which is then 0 at the end
    field("baseline", BASELINE),
    /// strength of the motion from start to end; "ground": the factor of the ground
    field("scale_to", OneOf(&[Object(&SCALE_TO), Words("scale_to", || vec![AS_GROUND], None),
])),
    /// time by which all is later; 0 before
    field("delay", Number(NotNegative)),
];

/// `scale_to` of a motion that gets the factor of the ground.
pub(crate) const AS_GROUND: &str = "ground";

/// The files of an axis of records.
pub(crate) const FILES: Keys = Keys::new(&fields![
    /// a folder (without .md), or a pattern with one *, such as "records/*.smc"; in the order of names (r_2 before r_10)
    needed("files", Text),
    /// only the records whose spectra come nearest to a target; other files with the same text for * go with them
    field("choose", Object(&CHOOSE)),
]);

/// A sine.
pub(crate) const SINE: Keys = Keys::new(&fields![
    /// amplitude
    needed("amplitude", ANY_NUMBER),
    /// circular frequency
    needed("omega", ANY_NUMBER),
    /// phase; 0 if not given
    field("phase", ANY_NUMBER),
]);

/// Points of a function.
pub(crate) const TABLE: Keys = Keys::new(&fields![
    /// times, rising; two equal times make a jump
    needed("t", ANY_NUMBERS),
    /// values at these times
    needed("f", ANY_NUMBERS),
]);

/// A pulse: one form with its numbers, of which only the amplitude may have any sign.
pub(crate) static PULSE: LazyLock<Keys> = LazyLock::new(|| {
    let number = |(key, meaning): &(&'static str, &'static str)| {
        let range = if *key == "amplitude" {
            Range::Any
        } else {
            Positive
        };
        needed(key, Number(range)).means(meaning)
    };
    let form = |pulse: &Pulse| {
        let numbers = pulse.numbers.iter().map(number).collect::<Vec<_>>();
        let keys = Keys::new(numbers.leak());
        field(pulse.name, Object(Box::leak(Box::new(keys)))).means(pulse.meaning)
    };
    let forms = Keys::new(PULSES.iter().map(form).collect::<Vec<_>>().leak());
    let one = Rule::One(forms.names().leak(), &[]);
    forms.rules(vec![one].leak())
});

/// A synthetic motion.
pub(crate) const SYNTHETIC: Keys = Keys::new(&fields![
    /// a whole number from 0 to 4294967295
    needed("seed", SEED),
    /// circular frequency of the ground filter in rad/s; default 15.6 (firm ground)
    field("omega", Number(Positive)),
]);

/// The seed of a synthetic motion.
const SEED: Kind = Whole([0, LARGEST_SEED as u64]);

/// A load: the node, and a function.
pub(crate) const LOAD: Keys = Keys::new(&fields![
    /// node on which the force acts, a bar, or matrices and a direction such as tower.x; on each node the same force
    needed("at", Text),
])
.and(OF_FUNCTION)
.rules(&OF_ONE);
