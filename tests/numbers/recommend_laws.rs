//! `slipgap recommend` over laws and methods: a choice of them restricts the search, no answer costs more than with those of the papers,
//! and no answer gains energy by its contact or its method.

use slipgap::problem::friction::FrictionOscillator;
use slipgap::problem::impact::BarImpact;
use slipgap::problem::numbers::parameter::Value;
use slipgap::problem::{Case, Problem};
use slipgap::recommend::friction::Friction;
use slipgap::recommend::impact::{FixedParameters, Impact, energy_change};
use slipgap::recommend::{
    Answer, Candidate, Fixed, Grid, Request, SearchSpace, Stop, Target, Variants, metric,
    recommend, search, with_finer_step,
};
use std::collections::BTreeSet;

fn request(problem: &dyn Problem, targets: &[(&'static str, f64)], energy_gain: f64) -> Request {
    let target = |(name, limit): &(&'static str, f64)| Target {
        name,
        metric: metric(problem, name),
        ideal: if *name == "peak_force" { 1.0 } else { 0.0 },
        limit: *limit,
    };
    Request {
        targets: targets.iter().map(target).collect(),
        energy_gain,
        energy_loss: 0.1,
        stop: Stop::default(),
    }
}

fn chosen(answer: &Answer) -> &Candidate {
    &answer.front[answer.chosen().unwrap()]
}

fn fixed(law: Option<&'static str>, method: Option<&'static str>) -> Fixed {
    Fixed { law, method }
}

/// The metric of a case solved by itself.
fn solved(problem: &dyn Problem, case: &Case, name: &str) -> f64 {
    let row = metric(problem, name);
    problem.solve(case, &[row]).unwrap().metrics[row].unwrap()
}

/// The mechanical energy beyond that of the exact motion, over that at release: the exact velocity is that of
/// x = s + (a - s) cos T in each half-cycle, so that its energy needs no velocity.
fn excess(case: &Case) -> f64 {
    let x0 = case.number("x0").unwrap();
    let solution = FrictionOscillator.solve(case, &[]).unwrap();
    let (x, v) = (
        solution.computed.displacement(),
        solution.computed.velocity(),
    );
    let mut worst: f64 = 0.0;
    for (i, time) in solution.computed.time.iter().enumerate() {
        let half = (time / std::f64::consts::PI).floor();
        // X goes from a to 2 s - a in a half-cycle, s = +1 or -1 is where friction balances the spring.
        let (mut a, mut s) = (x0, x0.signum());
        let mut within = *time;
        for _ in 0..half as u64 {
            if a.abs() <= 1.0 {
                break;
            }
            (a, s) = (2.0 * s - a, -s);
            within -= std::f64::consts::PI;
        }
        let exact = match a.abs() <= 1.0 {
            true => 0.5 * a * a,
            false => {
                let (cos, sin) = (libm::cos(within), libm::sin(within));
                let (x, v) = (s + (a - s) * cos, (a - s) * sin);
                0.5 * (x * x + v * v)
            }
        };
        let energy = 0.5 * (x[i] * x[i] + v[i] * v[i]);
        worst = worst.max((energy - exact) / (0.5 * x0 * x0));
    }
    worst
}

#[test]
fn friction_with_all_laws_costs_no_more_than_with_those_of_the_papers() {
    for limit in [0.05, 0.02] {
        let request = request(&FrictionOscillator, &[("rms_error", limit)], 0.05);
        let found = recommend(&Friction::new(Fixed::default(), 12.0), &request);
        let best = chosen(&found.answer);
        for law in ["displacement-control", "velocity-control"] {
            let papers = Friction::new(fixed(Some(law), Some("average-acceleration")), 12.0);
            let alone = search(&papers, &request);
            assert!(best.cost <= chosen(&alone).cost, "{law} {best:?}");
        }
        // Case and neighbours, with releases 2 % smaller and larger, solved again one by one.
        let releases = best.cases.iter().map(|case| case.number("x0").unwrap());
        let releases: Vec<f64> = releases.collect();
        assert!(releases.contains(&11.76) && releases.contains(&12.24));
        for case in &best.cases {
            assert!(solved(&FrictionOscillator, case, "rms_error") <= limit);
            // Round-off of the two formulas for the exact motion.
            assert!(excess(case) <= 0.05 + 1e-12, "{case:?}");
        }
        let finer = with_finer_step(&FrictionOscillator, &best.cases[0], 2);
        assert!(solved(&FrictionOscillator, &finer, "rms_error") <= limit);
        // The table of laws has the cheapest of each, on a coarser grid.
        let survey = found.survey.unwrap();
        let costs = survey.variants.iter().filter_map(|variant| variant.cost());
        assert!(costs.min().unwrap() >= best.cost);
    }
}

#[test]
fn a_small_limit_of_energy_excludes_friction_that_keeps_too_much() {
    let of = |energy: f64| {
        let request = request(&FrictionOscillator, &[("rms_error", 0.05)], energy);
        let space = Friction::new(
            fixed(Some("displacement-control"), Some("average-acceleration")),
            12.0,
        );
        let answer = search(&space, &request);
        let best = chosen(&answer);
        (best.cost, excess(&best.cases[0]))
    };
    let (free, limited) = (of(f64::INFINITY), of(0.005));
    assert!(free.1 > 0.005 && limited.1 <= 0.005, "{free:?} {limited:?}");
    assert!(free.0 < limited.0);
}

/// The gain of energy at every step: the drift of the contact minus what the method takes, at the end of a run up to that step.
fn gains(case: &Case) -> f64 {
    let row = BarImpact
        .parameters()
        .iter()
        .position(|p| p.name == "duration");
    let dt = case.number("dt").unwrap();
    let at_step = |i: u64| {
        let mut cut = case.clone();
        cut.values[row.unwrap()] = Some(Value::Number(i as f64 * dt));
        solved(&BarImpact, &cut, "energy_drift_final")
            - solved(&BarImpact, &cut, "numerical_dissipation")
    };
    (1..=BarImpact.steps(case)).map(at_step).fold(0.0, f64::max)
}

/// The loss of energy up to the last step: the damping of the contact and the method, and the drift.
fn losses(case: &Case) -> f64 {
    solved(&BarImpact, case, "contact_dissipation")
        + solved(&BarImpact, case, "numerical_dissipation")
        - solved(&BarImpact, case, "energy_drift_final")
}

/// A search with one law and one method on six elements.
fn small(law: &'static str, method: &'static str) -> Impact {
    let given = FixedParameters {
        choice: fixed(Some(law), Some(method)),
        n: Some(6),
        ..FixedParameters::default()
    };
    Impact::new(given).unwrap()
}

#[test]
fn what_a_method_adds_is_a_gain_of_energy() {
    let mut added = false;
    for method in [
        "average-acceleration",
        "linear-acceleration",
        "newmark",
        "hht",
        "generalized-alpha",
        "bathe",
        "central-difference",
        "moreau-jean",
    ] {
        for law in ["impact-spring", "kelvin-voigt", "jankowski"] {
            let space = small(law, method);
            // Lumped mass, and if the law and the method allow it, contact nodes without mass.
            let some: Vec<usize> = (0..space.variants().len()).step_by(2).take(2).collect();
            let coarse = space.with(&some, Grid::Coarse);
            for level in 0..coarse.costs().len().min(10) {
                for case in coarse.level(level).cases.iter().step_by(7) {
                    let solution = BarImpact.solve(case, &[]).unwrap();
                    let change = energy_change(case, &solution.computed).unwrap();
                    let gain = change.gain;
                    let wanted = gains(case);
                    // Round-off of sums over some hundred steps and modes.
                    assert!(
                        (gain - wanted).abs() < 1e-11 * (1.0 + wanted),
                        "{law} {method}: {gain}, not {wanted}"
                    );
                    let drift = solved(&BarImpact, case, "energy_drift_max");
                    added |= drift <= 0.01 && gain > 0.01;
                    let loss = losses(case);
                    assert!(
                        (change.loss - loss).abs() < 1e-11 * (1.0 + loss.abs()),
                        "{law} {method}: {change:?}, not {loss}"
                    );
                }
            }
        }
    }
    assert!(added);
}

#[test]
fn no_answer_of_any_law_and_method_gains_energy() {
    for targets in [
        &[("max_overlap", 0.1)][..],
        &[("peak_force", 0.2), ("max_overlap", 0.2)],
    ] {
        let given = FixedParameters {
            n: Some(6),
            ..FixedParameters::default()
        };
        let space = Impact::new(given).unwrap();
        let request = request(&BarImpact, targets, 0.01);
        let found = recommend(&space, &request);
        let best = chosen(&found.answer);
        let papers = FixedParameters {
            choice: fixed(Some("impact-spring"), Some("average-acceleration")),
            n: Some(6),
            ..FixedParameters::default()
        };
        let alone = search(&Impact::new(papers).unwrap(), &request);
        assert!(!chosen(&alone).converged || best.cost <= chosen(&alone).cost);
        for case in found.answer.front.iter().flat_map(|c| &c.cases) {
            // Round-off of the two ways to sum.
            assert!(gains(case) <= 0.01 + 1e-12, "{case:?}");
            assert!(losses(case) <= 0.1 + 1e-12, "{case:?}");
        }
        for case in &best.cases {
            for target in &request.targets {
                let solution = BarImpact.solve(case, &[]).unwrap();
                assert!(target.error(&solution.metrics) <= target.limit, "{case:?}");
            }
        }
    }
}

#[test]
fn a_given_law_and_method_are_not_searched() {
    let friction = Friction::new(fixed(Some("bouc-wen"), None), 12.0);
    assert!(friction.variants().iter().all(|v| v.law.name == "bouc-wen"));
    let methods = |space: &dyn Variants| {
        let variants = space.variants().iter();
        let names: BTreeSet<&str> = variants.map(|v| v.method.name).collect();
        names.len()
    };
    assert_eq!(methods(&friction), 9);
    let friction = Friction::new(fixed(None, Some("hht")), 12.0);
    assert!(friction.variants().iter().all(|v| v.method.name == "hht"));
    let space = small("hunt-crossley", "hht");
    let request = request(&BarImpact, &[("max_overlap", 0.2)], 0.01);
    let answer = recommend(&space, &request).answer;
    assert!(!answer.front.is_empty());
    for case in answer.front.iter().flat_map(|c| &c.cases) {
        let choices = [case.choice("law"), case.choice("method")];
        assert_eq!(choices, ["hunt-crossley", "hht"]);
    }
    // Rigid contact has no stable step with explicit methods, unless the contact nodes have no mass.
    let given = |law, method| FixedParameters {
        choice: fixed(Some(law), Some(method)),
        mass: Some("lumped"),
        ..FixedParameters::default()
    };
    assert!(Impact::new(given("rigid", "central-difference")).is_err());
    let rigid = FixedParameters {
        choice: fixed(Some("rigid"), None),
        mass: Some("lumped"),
        ..FixedParameters::default()
    };
    let rigid = Impact::new(rigid).unwrap();
    let explicit = |v: &slipgap::recommend::Variant| v.method.name == "central-difference";
    assert!(!rigid.variants().iter().any(explicit) && methods(&rigid) >= 6);
}

#[test]
fn no_candidate_breaks_a_rule() {
    let mut refused = false;
    for (law, method) in [
        ("impact-spring", "central-difference"),
        ("hertz", "linear-acceleration"),
        ("rigid", "moreau-jean"),
        ("ye", "generalized-alpha"),
    ] {
        let space = small(law, method);
        for index in 0..space.costs().len() {
            let level = space.level(index);
            refused |= level.candidates.is_empty();
            for case in level.cases.iter().step_by(5) {
                // The same case from its parameters, with all rules.
                let names = space.study_parameters();
                let used = names.iter().filter(|name| **name != "k_I");
                let given = used
                    .chain(&["gap"])
                    .filter_map(|name| Some((*name, case.get(name)?)));
                let given: Vec<(&str, Value)> = given.collect();
                let (again, broken) = Case::given(&BarImpact, &given);
                assert_eq!(broken, [], "{law} {method}");
                assert_eq!(again.values, case.values, "{law} {method}");
            }
        }
    }
    assert!(refused);
}
