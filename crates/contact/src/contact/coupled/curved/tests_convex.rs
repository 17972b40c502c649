//! What the search takes for granted.

use super::super::tests::{Problem, Random};
use super::CurvedForces;
use nalgebra::DMatrix;

#[test]
fn the_coupling_is_positive_definite() {
    // With N = D^-1/2 (a - H) D^-1/2, D = a - diag(H): if a_i - H_ii is 5/4 of sum_j |H_ij| sqrt(H_ii/H_jj), then N is 1 less a matrix
    // that is similar to one with row sums of at most 4/5. So no eigenvalue is below 1/5.
    for seed in 0..400 {
        let mut random = Random(seed);
        let problem = match seed % 2 {
            0 => Problem::dense(&mut random),
            _ => Problem::chain(&mut random),
        };
        let (h, m) = (&problem.h, problem.contacts());
        let forces = CurvedForces::new(h.as_slice().to_vec(), m);
        let excess = |i: usize| forces.flexibility(i) - h[(i, i)];
        let kept = Vec::from_iter((0..m).filter(|i| excess(*i) > 1e-9 * h[(*i, *i)]));
        if kept.is_empty() {
            continue;
        }
        let n = DMatrix::from_fn(kept.len(), kept.len(), |i, j| {
            let [i, j] = [kept[i], kept[j]];
            match i == j {
                true => 1.0,
                false => -h[(i, j)] / (excess(i) * excess(j)).sqrt(),
            }
        });
        let least = n
            .symmetric_eigenvalues()
            .iter()
            .fold(1.0, |a: f64, b| a.min(*b));
        // Round-off of a - H_ii, at most 1e-16/1e-9 of it.
        assert!(least > 0.2 - 1e-6, "{seed} {least}");
    }
}
