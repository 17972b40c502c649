use super::super::FrictionOscillator;
use super::*;
use crate::metrics::budget::Norm;
use crate::metrics::convergence::difference;
use crate::metrics::structure::rms_error;
use crate::problem::Case;
use crate::problem::numbers::parameter::Value;
use crate::solve::{self, ContactTrack, ToSystem};
use std::f64::consts::PI;

fn case(law: &'static str, pairs: &[(&'static str, f64)]) -> OscillatorCase {
    let numbers = pairs.iter().map(|(name, x)| (*name, Value::Number(*x)));
    let mut given: Vec<_> = numbers.collect();
    given.push(("law", Value::Name(law)));
    given.push(("dT", Value::Number(PI / 40.0)));
    given.push(("duration", Value::Number(4.0 * PI)));
    let (case, broken) = Case::given(&FrictionOscillator, &given);
    assert_eq!(broken, []);
    OscillatorCase::new(&case).unwrap()
}

#[test]
fn a_wrong_force_at_release_is_seen() {
    let lugre = [("sigma0", 2.0), ("sigma1", 0.5)];
    for (law, pairs) in [
        ("bouc-wen", &[("alpha", 0.5), ("exponent", 2.0)][..]),
        ("dahl", &[("alpha", 0.5), ("exponent", 1.0)]),
        ("lugre", &lugre),
    ] {
        let case = case(law, pairs);
        let track = solve::run::<ContactTrack>(&case.system()).unwrap().track;
        let times: Vec<f64> = (0..=case.last).map(|i| i as f64 * case.step).collect();
        let states = times.iter().zip(&track.0);
        let computed: History = states.map(|(time, state)| (*time, *state)).collect();
        let of = |other: &OscillatorCase| {
            let mut budget = between(other, &times, true).unwrap();
            let norm = Norm {
                channels: 1,
                size: case.x0.abs(),
                sum: &|_, _| f64::NAN,
                count: 1.0,
            };
            let found = budget.errors(&case.preset(), &computed, &norm)[0].unwrap();
            let motion = budget.motions.pop().unwrap();
            let coarse = budget.coarse[0].displacement();
            let by_tolerance = difference(motion.displacement(), coarse, case.x0.abs());
            (motion, found, by_tolerance)
        };
        let (right, found, by_tolerance) = of(&case);
        assert_eq!(found, by_tolerance, "{law}");
        assert!(found < 1e-9, "{law}: {found}");
        // The motion of a bristle that is bent the other way.
        let other = OscillatorCase {
            force: case.force + 1.0,
            ..case
        };
        let (wrong, found, by_tolerance) = of(&other);
        assert!(by_tolerance < 1e-9, "{law}: {by_tolerance}");
        let fault = rms_error(right.displacement(), wrong.displacement()) / case.x0.abs();
        assert!(fault > 1e-3, "{law}: {fault}");
        assert!(
            (0.9..1.01).contains(&(found / fault)),
            "{law}: {found} {fault}"
        );
    }
}
