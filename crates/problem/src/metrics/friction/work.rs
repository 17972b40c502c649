//! Work of the friction force over |x0|. A converged run and a run without iteration need different formulas.
//!
//! | Run | Formula | Reason |
//! | --- | --- | --- |
//! | converged | loss of energy until the last step | the method satisfies it to round-off, and it needs only the end of the motion |
//! | without iteration, or by another method than constant average acceleration | sum over the steps | a step solved once is not in equilibrium at its end, and a method may take energy itself, so the energy does not give the work |

use crate::lane::Lane;
use crate::methods::ContactWork;

/// Work in a converged run, from x0 at rest to [X, V] at its end: (x0^2 - X^2 - V^2)/2 over |x0|.
///
/// In each step (S_i + S_{i+1}) (X_{i+1} - X_i)/2 is the loss of (X^2 + V^2)/2, exactly.
pub fn work_by_energy(x0: f64, [x, v]: [f64; 2]) -> f64 {
    let scale = x0.abs();
    0.5 * ((x0 - x) / scale * (x0 + x) - v / scale * v)
}

/// Work step by step over |x0|, from rows [X, V, S].
pub fn work_by_steps(rows: &[[f64; 3]], x0: f64, form: &ContactWork<1>) -> f64 {
    let scale = x0.abs();
    rows.windows(2)
        .map(|ends| {
            let both = |i: usize| [Lane([ends[0][i]]), Lane([ends[1][i]])];
            let Lane([force]) = form.force(both(2));
            let Lane([displacement]) = form.displacement(both(0), both(1));
            force * (displacement / scale)
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_formulas_agree_for_constant_average_acceleration() {
        // One step of X'' + X + S = 0 from X = 3, V = 0 with dT = 1/2, S = -1 at both ends: (16 + 1) X' = (16 - 1) X - 2 S dT^2.
        let (x0, dt, s) = (3.0, 0.5, -1.0);
        let x = (x0 * (4.0 - dt * dt) - 2.0 * s * dt * dt) / (4.0 + dt * dt);
        let v = 2.0 * (x - x0) / dt;
        let by_trapezoids = work_by_steps(&[[x0, 0.0, s], [x, v, s]], x0, &ContactWork::Trapezoids);
        assert!((by_trapezoids - work_by_energy(x0, [x, v])).abs() < 1e-15);
        assert!((by_trapezoids - (x0 - x) / x0).abs() < 1e-15);
    }
}
