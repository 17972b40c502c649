//! Damping in proportion to M and K.

use crate::system::structure::Symmetric;
use std::collections::BTreeMap;

/// Largest difference between C and its form, over the largest number of the row and the column: that of numbers in a file.
const ROUND_OFF: f64 = 1e-13;

/// The factors of M and K in C = mass M + stiffness K; `None` if C is another matrix.
///
/// The modes stay independent with such a damping, where products with all modes would leave round-off between them.
pub(super) fn rayleigh(c: &Symmetric, m: &Symmetric, k: &Symmetric) -> Option<[f64; 2]> {
    let mut entries: BTreeMap<(usize, usize), [f64; 3]> = BTreeMap::new();
    for (which, matrix) in [c, m, k].into_iter().enumerate() {
        for (entry, value) in matrix.entries() {
            entries.entry(entry).or_default()[which] += value;
        }
    }
    // The factor of K from the entry without mass in which K is largest; that of M from the largest mass.
    let largest = |of: &dyn Fn(&[f64; 3]) -> f64| {
        let numbers = entries
            .values()
            .filter(|numbers_of_entry| of(numbers_of_entry) > 0.0);
        numbers.max_by(|a, b| of(a).total_cmp(&of(b))).copied()
    };
    let [c, _, k] = largest(&|[_, m, k]| if *m == 0.0 { k.abs() } else { 0.0 })?;
    let stiffness = c / k;
    let [c, m, k] = largest(&|[_, m, _]| m.abs())?;
    let mass = (c - stiffness * k) / m;
    let mut sizes = vec![0.0_f64; entries.keys().map(|(i, _)| i + 1).max()?];
    for ((i, j), [c, _, k]) in &entries {
        let size = c.abs().max((stiffness * k).abs());
        sizes[*i] = sizes[*i].max(size);
        sizes[*j] = sizes[*j].max(size);
    }
    let fits = |((i, j), [c, m, k]): (&(usize, usize), &[f64; 3])| {
        let rest = c - mass * m - stiffness * k;
        rest.abs() <= ROUND_OFF * sizes[*i].max(sizes[*j])
    };
    entries.iter().all(fits).then_some([mass, stiffness])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_found_where_damping_has_the_form() {
        let (mut m, mut k) = (Symmetric::zeros(3), Symmetric::zeros(3));
        m.add(0, 0, 2.0);
        m.add(1, 1, 3.0);
        k.add_spring([None, Some(0)], 100.0);
        k.add_spring([Some(0), Some(1)], 70.0);
        k.add_spring([Some(1), Some(2)], 30.0);
        for factors in [[0.4, 0.0], [0.0, 0.01], [0.3, 0.002]] {
            let mut c = Symmetric::zeros(3);
            c.add_matrix(&m, factors[0]);
            c.add_matrix(&k, factors[1]);
            let found = rayleigh(&c, &m, &k).unwrap();
            // Round-off of numbers up to 1.
            for (found_factor, factor) in found.iter().zip(factors) {
                assert!((found_factor - factor).abs() < 1e-14, "{found:?}");
            }
            c.add(1, 1, 1e-9);
            assert_eq!(rayleigh(&c, &m, &k), None);
        }
    }
}
