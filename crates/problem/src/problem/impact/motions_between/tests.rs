use super::super::BarImpact;
use super::*;
use crate::metrics::budget::Norm;
use crate::metrics::convergence::difference;
use crate::metrics::impact::Track;
use crate::metrics::structure::rms_error;
use crate::problem::Case;
use crate::problem::impact::case;
use crate::problem::numbers::parameter::Value;
use crate::solve::{self, ToSystem};

fn given(law: &'static str, pairs: &[(&'static str, f64)]) -> ImpactCase {
    let common = [("gamma", 1.0), ("n", 10.0), ("dt", 0.01), ("duration", 1.5)];
    let numbers = common.iter().chain(pairs);
    let mut given: Vec<_> = numbers
        .map(|(name, x)| (*name, Value::Number(*x)))
        .collect();
    given.push(("law", Value::Name(law)));
    let (case, broken) = Case::given(&BarImpact, &given);
    assert_eq!(broken, []);
    ImpactCase::new(&case).unwrap()
}

#[test]
fn a_mesh_that_starts_at_another_gap_is_seen() {
    let damped = [("restitution", 0.5)];
    for (law, extra) in [
        ("hertz", &[][..]),
        ("hunt-crossley", &damped),
        ("kelvin-voigt", &damped),
    ] {
        let case = given(law, extra);
        let mut track = solve::run::<Track<1>>(&case.system()).unwrap().track;
        case::condense(&[case], &mut track);
        let computed = track.history(case.dt);
        let of = |other: &ImpactCase| {
            let budget = between(other, &computed.time, true).unwrap();
            let norm = Norm {
                channels: 2,
                size: 1.0,
                sum: &|_, _| f64::NAN,
                count: 1.0,
            };
            let found = budget.errors(&case.preset(), &computed, &norm);
            let by_tolerance = [0, 1].map(|channel| {
                let pairs = budget.motions.iter().zip(&budget.coarse);
                let each =
                    pairs.map(|(a, b)| difference(a.channel(channel), b.channel(channel), 1.0));
                each.fold(0.0, f64::max)
            });
            let mesh = budget.motions[1].clone();
            (
                mesh,
                [0, 1].map(|channel| found[channel].unwrap()),
                by_tolerance,
            )
        };
        let (right, found, by_tolerance) = of(&case);
        assert_eq!(found, by_tolerance, "{law}");
        let mut other = case;
        other.scaled.bars.gap += 0.05;
        let (wrong, found, by_tolerance) = of(&other);
        for channel in [0, 1] {
            assert!(by_tolerance[channel] < 1e-7, "{law}: {by_tolerance:?}");
            let fault = rms_error(right.channel(channel), wrong.channel(channel));
            assert!(fault > 0.02, "{law}: {fault}");
            let part = found[channel] / fault;
            assert!(
                (0.85..1.01).contains(&part),
                "{law} {channel}: {part} {fault}"
            );
        }
    }
}
