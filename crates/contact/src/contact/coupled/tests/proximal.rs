//! Two rigid contacts on one node.

use super::super::CoupledForces;

#[test]
fn the_proximal_point_goes_on_until_the_pattern_is_right() {
    // A = [[1, 1], [1, 1]], 0 <= S <= 1. With d1 > d2 > 1 contact 1 is at its limit, and S2 = d2 - 1: these are the only forces,
    // since q1 = d1 - d2 > 0.
    //
    // Step k of the method has the forces with S1 + S2 = d2 and S1 - S2 = k (d1 - d2)/1e-6, until S1 = 1.
    let forces = |step: f64| {
        let d = [1.2 + step * 1e-6, 1.2];
        let mut force = [0.0; 2];
        let done = CoupledForces::new(vec![1.0; 4], 2)
            .solve(&d, &[0.0; 2], &[1.0; 2], &[1.2; 2], &mut force);
        done.map(|()| force)
    };
    // S1 - S2 = 0.8 needs 1, 2, 3 and 4 steps.
    for step in [0.9, 0.5, 0.3, 0.22] {
        let [one, two] = forces(step).unwrap();
        assert!(
            one == 1.0 && (two - 0.2).abs() < 4e-16,
            "{step} {one} {two}"
        );
    }
}
