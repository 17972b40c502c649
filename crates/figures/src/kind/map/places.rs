//! The places of the cases of a map along an axis, and the edges of cells.

use crate::DrawnCase;
use slipgap_study::Scale;
use std::collections::HashSet;

/// Whether two values are one place.
pub fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-12 * a.abs().max(b.abs())
}

/// The different values of a parameter that have a place on the scale, rising.
pub fn places(
    cases: &[DrawnCase],
    scale: Scale,
    value: impl Fn(&DrawnCase) -> Option<f64>,
) -> Vec<f64> {
    let has_place = |x: &f64| scale == Scale::Linear || *x > 0.0;
    let positions = cases.iter().filter_map(value).filter(has_place);
    // There are far fewer places than cases.
    let different: HashSet<u64> = positions.map(f64::to_bits).collect();
    let mut places: Vec<f64> = different.into_iter().map(f64::from_bits).collect();
    places.sort_by(f64::total_cmp);
    places.dedup_by(|a, b| same(*a, *b));
    places
}

/// Edges of the cells round rising places: half-way between neighbours on the scale, and the same distance outside of the ends.
pub fn edges(places: &[f64], scale: Scale) -> Vec<f64> {
    let to = |x: f64| match scale {
        Scale::Linear => x,
        Scale::Log => libm::log(x),
    };
    let back = |x: f64| match scale {
        Scale::Linear => x,
        Scale::Log => libm::exp(x),
    };
    let at: Vec<f64> = places.iter().map(|x| to(*x)).collect();
    match at.as_slice() {
        [] => vec![back(0.0), back(1.0)],
        [one] => vec![back(one - 0.5), back(one + 0.5)],
        _ => {
            let n = at.len();
            let mut edges = vec![back(1.5 * at[0] - 0.5 * at[1])];
            edges.extend(
                at.windows(2)
                    .map(|pair| back(pair[0] / 2.0 + pair[1] / 2.0)),
            );
            edges.push(back(1.5 * at[n - 1] - 0.5 * at[n - 2]));
            // The axis ends at the range of double precision.
            let finite = |x: f64| x.clamp(-f64::MAX, f64::MAX);
            edges.into_iter().map(finite).collect()
        }
    }
}
