use super::super::BarImpact;
use super::*;
use crate::metrics::structure::rms_error;
use crate::problem::Case;
use crate::problem::numbers::parameter::Value;

fn case(law: &'static str, own: &[(&'static str, f64)]) -> ImpactCase {
    let all = [("gamma", 1.0), ("n", 10.0), ("dt", 0.01), ("duration", 1.5)];
    let numbers = all.iter().chain(own);
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
    for (law, own) in [
        ("hertz", &[][..]),
        ("hunt-crossley", &damped),
        ("kelvin-voigt", &damped),
    ] {
        let case = case(law, own);
        let mut track = solve::run::<Track<1>>(&case.system()).unwrap().track;
        case::condense(&[case], &mut track);
        let computed = track.history(case.dt);
        let of = |scaled: &Scaled| {
            let own = references(scaled, &computed.time, true).unwrap();
            let coarse = own.coarse.unwrap();
            let found = reference_errors(&case, &computed, &own.motions, &coarse);
            let by_tolerance = metrics::impact::reference_errors(&own.motions, &coarse);
            let [_, mesh] = own.motions;
            (
                mesh,
                found.map(Option::unwrap),
                by_tolerance.map(Option::unwrap),
            )
        };
        let (right, found, by_tolerance) = of(&case.scaled);
        assert_eq!(found, by_tolerance, "{law}");
        let mut other = case.scaled;
        other.bars.gap += 0.05;
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
