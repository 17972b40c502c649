//! The ranges of the numbers under the keys, for decoding and schema.

use super::{
    ASCE_7, BAR, CHOOSE, EN_1998, FUNCTION, Keys, MASS, MODAL_DAMPING, RAYLEIGH, REDUCE, SCALE_TO,
    SET, SPRING, STRUCTURE, SUPPORT, SYNTHETIC, WEIGHT,
};
use slipgap_problem::problem::numbers::parameter::Range::{self, NotNegative, Positive, UpToOne};

/// The keys whose numbers are not free, by tables.
const RANGES: [(Keys, Range, &[&str]); 19] = [
    (STRUCTURE, NotNegative, &[MODAL_DAMPING]),
    (MASS, NotNegative, &["mass"]),
    (BAR, Positive, &["L", "EA", "mass", "n"]),
    (BAR, NotNegative, &["stiffness_damping"]),
    (SPRING, Positive, &["mass", "period"]),
    (SPRING, NotNegative, &["c", "ratio"]),
    (RAYLEIGH, NotNegative, &["mass", "stiffness", "ratios"]),
    (RAYLEIGH, Positive, &["modes", "periods"]),
    (REDUCE, NotNegative, &["modes"]),
    (REDUCE, Positive, &["up_to"]),
    (WEIGHT, Positive, &["weight"]),
    (FUNCTION, Positive, &["dt"]),
    (FUNCTION, NotNegative, &["start", "end", "delay"]),
    (SUPPORT, NotNegative, &["delay"]),
    (SYNTHETIC, NotNegative, &["seed"]),
    (SYNTHETIC, Positive, &["omega"]),
    (SCALE_TO, UpToOne, &["ratio"]),
    (CHOOSE, UpToOne, &["ratio"]),
    (CHOOSE, NotNegative, &["sigma"]),
];

/// The range of the number under a key of a table.
pub(crate) fn range(keys: Keys, key: &str) -> Range {
    let all_above_zero = [SCALE_TO, SET, CHOOSE, EN_1998, ASCE_7].contains(&keys);
    let mut rows = RANGES.iter().filter(|row| row.0 == keys);
    match rows.find(|row| row.2.contains(&key)) {
        Some(row) => row.1,
        None if all_above_zero => Positive,
        None => Range::Any,
    }
}

/// The range of a number of a pulse: only its amplitude may have any sign.
pub(crate) fn of_pulse(key: &str) -> Range {
    match key {
        "amplitude" => Range::Any,
        _ => Positive,
    }
}
