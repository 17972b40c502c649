//! Continuous bars.

use super::*;
use crate::exact::adaptive::bars::continuous;
use crate::exact::spring::Spring;

#[test]
fn bars_on_the_impact_spring_move_as_its_closed_form() {
    let times = times(4.0, 200);
    for (gamma_n, gap) in [(0.5, 0.0), (1.0, 0.3), (5.0, 0.0), (40.0, 0.1)] {
        let law = ContactLaw::ImpactSpring(ImpactSpring {
            stiffness: 2.0 * gamma_n,
        });
        let spring = Spring::new(gamma_n, gap).unwrap();
        let states = continuous(&law, gap, &times, TOLERANCE).unwrap();
        for (time, state) in times.iter().zip(states) {
            let exact = spring.at(*time);
            // The force jumps in no case; r is at most 8 here.
            let differences = [
                state.displacement - exact.displacement,
                state.velocity - exact.velocity,
                state.force - exact.force,
            ];
            let largest = differences
                .iter()
                .fold(0.0, |most: f64, x| most.max(x.abs()));
            assert!(
                largest < 1e-10 * gamma_n.max(1.0),
                "{gamma_n} {time}: {differences:?}"
            );
        }
    }
}

#[test]
fn bars_on_a_dashpot_keep_its_force_while_the_first_wave_travels() {
    // Without stiffness rdot = -2 + 2 F and F = -c rdot: F = 2 c/(1 + 2 c).
    let damping = 0.7;
    let law = ContactLaw::KelvinVoigt(KelvinVoigt {
        stiffness: 1e-12,
        damping,
    });
    let states = continuous(&law, 0.0, &[0.25, 0.75], TOLERANCE).unwrap();
    for state in states {
        let expected = 2.0 * damping / (1.0 + 2.0 * damping);
        assert!((state.force - expected).abs() < 1e-11, "{state:?}");
    }
}
