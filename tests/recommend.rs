//! `slipgap recommend`: no cheaper candidate reaches the target, neighbours reach it too, no case gains energy, and the printed
//! numbers are those of a study. Most searches here have one law and one method; `recommend_laws.rs` has many.

mod common;

use serde_json::json;
use slipgap::problem::friction::FrictionOscillator;
use slipgap::problem::impact::BarImpact;
use slipgap::problem::numbers::parameter::Value;
use slipgap::problem::{Case, Problem, Solution};
use slipgap::recommend::friction::{Friction, Releases};
use slipgap::recommend::impact::{FixedParameters, Impact, energy_change};
use slipgap::recommend::{
    Answer, Candidate, CostLevel, EnergyChange, Fixed, Outcome, Request, SearchSpace, Stop, Target,
    metric, refine, robustness, search, with_finer_step,
};
use std::collections::BTreeSet;
use std::f64::consts::PI;
use std::path::Path;
use std::process::{Command, Output};

const LIMIT: f64 = 0.01;

fn target(problem: &dyn Problem, name: &'static str, limit: f64) -> Target {
    Target {
        name,
        metric: metric(problem, name),
        ideal: if name == "peak_force" { 1.0 } else { 0.0 },
        limit,
    }
}

fn rms(limit: f64) -> Request {
    Request {
        targets: vec![target(&FrictionOscillator, "rms_error", limit)],
        // No limit: the laws of the papers only dissipate.
        energy_gain: f64::INFINITY,
        energy_loss: f64::INFINITY,
        stop: Stop::default(),
    }
}

fn impact(targets: &[(&'static str, f64)]) -> Request {
    let targets = targets.iter();
    Request {
        targets: targets
            .map(|(name, limit)| target(&BarImpact, name, *limit))
            .collect(),
        energy_gain: LIMIT,
        energy_loss: f64::INFINITY,
        stop: Stop::default(),
    }
}

/// Law and release.
fn friction(law: &'static str, x0: f64) -> Friction {
    Friction::new(papers(law), x0)
}

/// A law with the method of the papers.
fn papers(law: &'static str) -> Fixed {
    Fixed {
        law: Some(law),
        method: Some("average-acceleration"),
    }
}

/// The spring and the method of the papers; nothing else is given.
fn spring() -> FixedParameters {
    FixedParameters {
        choice: papers("impact-spring"),
        ..FixedParameters::default()
    }
}

fn chosen(answer: &Answer) -> &Candidate {
    &answer.front[answer.chosen().unwrap()]
}

/// Whether a case reaches the targets, by its own metrics alone.
fn reaches(problem: &dyn Problem, case: &Case, request: &Request) -> bool {
    let solution = problem.solve(case, &[]).unwrap();
    let within =
        |t: &Target| solution.metrics[t.metric].is_some_and(|x| (x - t.ideal).abs() <= t.limit);
    let gain = match problem.name() {
        "bar-impact" => energy_change(case, &solution.computed).unwrap().gain,
        _ => 0.0,
    };
    request.targets.iter().all(within) && gain <= request.energy_gain
}

/// Whether a case also reaches the targets, apart from the energy, with 1/2, 1/4 .. 1/1024 of its step, as far as its metrics change.
fn converged(problem: &dyn Problem, case: &Case, request: &Request) -> bool {
    let mut values: Vec<Vec<f64>> = Vec::new();
    for halving in 1..=10 {
        let finer = with_finer_step(problem, case, 1 << halving);
        let metrics = problem.solve(&finer, &[]).unwrap().metrics;
        let of = |t: &Target| metrics[t.metric].map_or(f64::NAN, |x| (x - t.ideal) / t.limit);
        values.push(request.targets.iter().map(of).collect());
        let last = &values[values.len() - 1];
        if last.iter().any(|x| x.is_nan() || x.abs() > 1.0) {
            return false;
        }
        if halving < 4 {
            continue;
        }
        // The last three values of every target differ little, and what may still follow is within the limit.
        let [.., a, b, c] = values.as_slice() else {
            return false;
        };
        if (0..last.len()).all(|t| {
            let [first, second] = [b[t] - a[t], c[t] - b[t]].map(f64::abs);
            first <= 0.02 && second <= 0.02 && c[t].abs() + second <= 1.0
        }) {
            return true;
        }
    }
    false
}

fn cheapest_by_trying_all(space: &dyn SearchSpace, request: &Request) {
    let answer = search(space, request);
    let chosen = chosen(&answer);
    assert!(chosen.worst <= 1.0);
    for pair in answer.front.windows(2) {
        assert!(pair[0].cost < pair[1].cost && pair[0].worst > pair[1].worst);
    }
    let mut costs = BTreeSet::new();
    for (at, cost) in space.costs().into_iter().enumerate() {
        if cost > chosen.cost {
            continue;
        }
        let level = space.level(at);
        let good: Vec<bool> = level
            .cases
            .iter()
            .map(|case| reaches(space.problem(), case, request))
            .collect();
        let mut good = level
            .candidates
            .iter()
            .filter(|c| c.iter().all(|i| good[*i]));
        if good.any(|c| converged(space.problem(), &level.cases[c[0]], request)) {
            costs.insert(cost);
        }
    }
    assert_eq!(costs.into_iter().collect::<Vec<_>>(), [chosen.cost]);
}

#[test]
fn nothing_cheaper_reaches_the_target() {
    for (law, x0) in [("velocity-control", 12.0), ("displacement-control", -12.5)] {
        cheapest_by_trying_all(&friction(law, x0), &rms(0.03));
    }
    let request = impact(&[("peak_force", 0.2), ("max_overlap", 0.15)]);
    cheapest_by_trying_all(&Impact::new(spring()).unwrap(), &request);
}

#[test]
fn the_answer_agrees_with_the_maps() {
    // 0.01 of x0 = 12: pi/10 at its best width has 0.0103, pi/20 0.0035 (docs/findings-friction.md).
    let answer = search(&friction("velocity-control", 12.0), &rms(0.01));
    let steps = chosen(&answer).cost;
    assert!((80..=160).contains(&steps), "{steps}");
}

#[test]
fn narrow_widths_are_searched() {
    // alpha 1e-4 reaches 0.003 at pi/112, in 896 steps: computed once.
    let known = json!({"law": "displacement-control", "alpha": 1e-4, "dT": PI / 112.0, "duration": 8.0 * PI});
    assert!(reaches(
        &FrictionOscillator,
        &common::case(&FrictionOscillator, &known),
        &rms(0.003)
    ));
    let answer = search(&friction("displacement-control", 12.0), &rms(0.003));
    assert!(chosen(&answer).cost <= 896, "{:?}", chosen(&answer));
}

#[test]
fn impacts_are_found_as_cheap_as_known_ones() {
    // Computed once. The cost is steps times modes, over 1.5 T_I.
    let request = impact(&[("peak_force", 0.05), ("max_overlap", 0.02)]);
    for (mass, n, gamma, cost) in [
        ("consistent", 66, 0.447, 13_266),
        ("lumped", 104, 0.282, 32_760),
    ] {
        let known = json!({"gamma": gamma, "n": n, "dt": 1.0 / f64::from(n), "duration": 1.5, "mass": mass});
        let known = common::case(&BarImpact, &known);
        assert_eq!(BarImpact.work(&known), cost);
        assert!(reaches(&BarImpact, &known, &request));
        let fixed = FixedParameters {
            mass: Some(mass),
            ..spring()
        };
        let answer = search(&Impact::new(fixed).unwrap(), &request);
        let cheapest = answer.own_step.as_ref().unwrap_or(chosen(&answer));
        assert!(cheapest.cost <= cost, "{cheapest:?}");
    }
}

#[test]
fn an_answer_holds_with_a_finer_step_if_one_does() {
    // Steps of consistent mass that do not resolve the contact mode reach the target, and cost less than lumped mass.
    let request = impact(&[("peak_force", 0.1), ("max_overlap", 0.05)]);
    let answer = search(&Impact::new(spring()).unwrap(), &request);
    let best = chosen(&answer);
    let own = answer.own_step.as_ref().unwrap();
    let holds = |candidate: &Candidate, request: &Request| {
        converged(&BarImpact, &candidate.cases[0], request)
    };
    assert!(best.converged && holds(best, &request));
    assert!(own.cost < best.cost && own.worst <= 1.0 && !own.converged && !holds(own, &request));
    // With twelve elements an overlap of 0.1 needs gamma above 0.4, and the resolved peak is above 1.3.
    let fixed = FixedParameters {
        n: Some(12),
        mass: Some("consistent"),
        ..spring()
    };
    let request = impact(&[("peak_force", 0.1), ("max_overlap", 0.1)]);
    let answer = search(&Impact::new(fixed).unwrap(), &request);
    let best = chosen(&answer);
    assert!(best.worst <= 1.0 && !best.converged && !holds(best, &request));
    assert!(answer.own_step.is_none());
}

#[test]
fn metrics_are_refined_until_they_settle() {
    let of = |given: &serde_json::Value, targets: &[(&'static str, f64)]| {
        let case = common::case(&BarImpact, given);
        let request = impact(targets);
        assert!(reaches(
            &BarImpact,
            &case,
            &Request {
                energy_gain: f64::INFINITY,
                ..request.clone()
            }
        ));
        let refined = refine(
            &BarImpact,
            &request.targets,
            std::slice::from_ref(&case),
            &mut 0,
        );
        // The outcome again, by solving with the last step.
        let last = with_finer_step(&BarImpact, &case, refined[0].factor);
        let free = Request {
            energy_gain: f64::INFINITY,
            ..request
        };
        assert_eq!(
            reaches(&BarImpact, &last, &free),
            refined[0].outcome != Outcome::Misses
        );
        (refined[0].outcome, refined[0].factor)
    };
    // The peak force of a damped spring grows with every halving: 1.0935 at a 16th of the step, 1.111 at a 32nd, 1.133 in the limit.
    let damped = json!({"law": "kelvin-voigt", "restitution": 0.9, "method": "moreau-jean", "theta": 0.5, "mass": "lumped", "n": 15,
        "gamma": 0.891, "dt": 1.0 / 12.0, "duration": 1.5});
    let (outcome, factor) = of(&damped, &[("peak_force", 0.1)]);
    assert!(
        outcome == Outcome::Misses && factor > 16,
        "{outcome:?} {factor}"
    );
    // In steps of nearly one element errors of mesh and step cancel: 0.154 becomes 0.225.
    let cancels = json!({"law": "impact-spring", "method": "central-difference", "mass": "massless-contact", "n": 8, "gamma": 3.55,
        "dt": 0.47 / 8.0, "duration": 1.5});
    assert_eq!(
        of(&cancels, &[("rms_error_rdot", 0.2)]),
        (Outcome::Misses, 2)
    );
    assert_eq!(of(&cancels, &[("rms_error_rdot", 0.25)]).0, Outcome::Holds);
}

#[test]
fn steps_of_nearly_one_element_are_searched() {
    let fixed = FixedParameters {
        choice: Fixed {
            law: Some("impact-spring"),
            method: Some("central-difference"),
        },
        mass: Some("massless-contact"),
        ..FixedParameters::default()
    };
    let space = Impact::new(fixed).unwrap();
    // Cases that are known to reach the target with their own step, where they gain up to 3 % of the energy.
    for (name, limit, n, gamma, passes) in [
        ("rms_error_rdot", 0.2, 8, 3.55, 0.94),
        ("rms_error_r", 0.02, 13, 5.6, 0.96),
    ] {
        let dt = passes / f64::from(2 * n);
        let known = json!({"law": "impact-spring", "method": "central-difference", "mass": "massless-contact", "n": n,
            "gamma": gamma, "dt": dt, "duration": 1.5});
        let known = common::case(&BarImpact, &known);
        let request = Request {
            energy_gain: 0.03,
            ..impact(&[(name, limit)])
        };
        assert!(reaches(&BarImpact, &known, &request));
        let answer = search(&space, &request);
        let own = answer.own_step.as_ref().unwrap();
        assert!(
            own.cost <= BarImpact.work(&known) && !own.converged,
            "{own:?}"
        );
        let best = chosen(&answer);
        assert!(best.converged && converged(&BarImpact, &best.cases[0], &request));
    }
}

/// The exact motion of a release and one cycle more.
fn released(case: &Case, x0: f64) -> Case {
    let mut case = case.clone();
    let rows = FrictionOscillator.parameters().iter();
    for (row, parameter) in rows.enumerate() {
        match &*parameter.name {
            "x0" => case.values[row] = Some(Value::Number(x0)),
            "duration" => {
                let half_cycles = ((x0 - 1.0) / 2.0).ceil();
                case.values[row] = Some(Value::Number((half_cycles + 2.0) * PI));
            }
            _ => {}
        }
    }
    case
}

#[test]
fn an_answer_for_a_range_of_releases_holds_between_them() {
    let error = |case: &Case| {
        let metrics = FrictionOscillator.solve(case, &[]).unwrap().metrics;
        metrics[metric(&FrictionOscillator, "rms_error")].unwrap()
    };
    // A fixed set in which no number of the search is, and both sides of the odd numbers, where the errors have cusps.
    let dense = |from: f64, to: f64| {
        let odd = (0..20).map(|k| f64::from(2 * k + 1));
        let cusps = odd.flat_map(|odd| [odd - 1e-9, odd, odd + 1e-9]);
        let count = ((to - from) / 0.0137) as u32;
        let all = (0..count).map(move |i| from + 0.0137 * (f64::from(i) + 0.31));
        all.chain(cusps.filter(move |x0| (from..=to).contains(x0)))
            .collect::<Vec<f64>>()
    };
    for (law, method, limit, from, to) in [
        ("tanh", "central-difference", 0.01, 8.0, 20.0),
        (
            "displacement-control",
            "average-acceleration",
            0.05,
            8.0,
            20.0,
        ),
        ("coulomb", "central-difference", 0.02, 2.0, 7.5),
    ] {
        let fixed = Fixed {
            law: Some(law),
            method: Some(method),
        };
        let space = Friction::new(fixed, Releases::Range(from, to));
        let answer = search(&space, &rms(limit));
        let best = chosen(&answer);
        assert!(best.converged);
        for x0 in dense(from, to) {
            let case = released(&best.cases[0], x0);
            assert!(error(&case) <= limit, "{law} at {x0}: {}", error(&case));
            let half = with_finer_step(&FrictionOscillator, &case, 2);
            assert!(
                error(&half) <= limit,
                "{law} at {x0} with half the step: {}",
                error(&half)
            );
        }
        let found = robustness(&space, &rms(limit), best).unwrap();
        assert_eq!((found.ends, found.missed), ([from, to], 0));
        // The case shown is the release with the largest error of those searched.
        let shown = error(&best.cases[0]);
        assert!(
            shown >= found.error * 0.98 && shown <= best.worst * limit,
            "{found:?} {shown}"
        );
    }
}

#[test]
fn an_answer_for_one_release_says_what_it_misses() {
    let fixed = Fixed {
        law: Some("tanh"),
        method: Some("central-difference"),
    };
    let space = Friction::new(fixed, 12.0);
    let answer = search(&space, &rms(0.01));
    let best = chosen(&answer);
    let found = robustness(&space, &rms(0.01), best).unwrap();
    assert_eq!((found.ends, found.count), ([8.0, 20.0], 1201));
    let error = |x0: f64| {
        let metrics = FrictionOscillator
            .solve(&released(&best.cases[0], x0), &[])
            .unwrap()
            .metrics;
        metrics[metric(&FrictionOscillator, "rms_error")].unwrap()
    };
    let errors: Vec<f64> = (0..=1200)
        .map(|i| error(8.0 + f64::from(i) * 0.01))
        .collect();
    let missed = errors.iter().filter(|error| **error > 0.01).count();
    let largest = errors.iter().copied().fold(0.0, f64::max);
    assert_eq!(found.missed, missed);
    assert!(missed > 200 && (found.error - largest).abs() < 1e-12);
    // The printed sentence has the same numbers.
    let folder = tempfile::tempdir().unwrap();
    let output = slipgap(
        folder.path(),
        "recommend friction-oscillator --rms 0.01 --law tanh --method central-difference --x0 12",
    );
    let share = 100.0 * missed as f64 / 1201.0;
    let sentence = format!(
        "Of 1201 releases from 8 to 20, {share:.0} % miss the target; the largest rms_error is "
    );
    assert!(text(&output).contains(&sentence), "{}", text(&output));
}

/// (E_i - E_0)/E_0 at every step after the first: the end of a run with this duration.
fn energies(case: &Case) -> Vec<f64> {
    let row = |name| BarImpact.parameters().iter().position(|p| p.name == name);
    let (dt, last) = (case.number("dt").unwrap(), BarImpact.steps(case));
    let at_step = |i: u64| {
        let mut cut = case.clone();
        cut.values[row("duration").unwrap()] = Some(Value::Number(i as f64 * dt));
        let solution = BarImpact.solve(&cut, &[]).unwrap();
        solution.metrics[metric(&BarImpact, "energy_drift_final")].unwrap()
    };
    (1..=last).map(at_step).collect()
}

#[test]
fn a_gain_before_a_larger_loss_is_computed() {
    let case = |gamma: f64, n: u32, dt: f64, gap: f64| {
        let given = json!({"gamma": gamma, "n": n, "dt": dt, "duration": 1.5, "gap": gap});
        common::case(&BarImpact, &given)
    };
    let mut hidden = false;
    for (gamma, n, dt, gap) in [
        (8.0, 10, 0.23, 0.1),
        (8.0, 4, 0.23, 0.06),
        (5.0, 6, 0.13, 0.06),
        (1.0, 10, 0.025, 0.0),
    ] {
        let case = case(gamma, n, dt, gap);
        let solution = BarImpact.solve(&case, &[]).unwrap();
        let gain = energy_change(&case, &solution.computed).unwrap().gain;
        let wanted = energies(&case).into_iter().fold(0.0, f64::max);
        // Round-off of sums over some hundred steps and modes.
        assert!(
            (gain - wanted).abs() < 1e-12 * (1.0 + wanted),
            "{gain}, not {wanted}"
        );
        let largest = solution.metrics[metric(&BarImpact, "energy_drift_max")].unwrap();
        hidden |= largest < 0.0 && gain > LIMIT;
    }
    assert!(hidden);
}

#[test]
fn no_answer_gains_energy() {
    let n = |n| FixedParameters {
        n: Some(n),
        ..spring()
    };
    let unlike = FixedParameters {
        bars: vec![
            ("right.A".into(), Value::Number(0.4)),
            ("right.L".into(), Value::Number(20.0)),
        ],
        n: Some(8),
        ..spring()
    };
    let wall = FixedParameters {
        bars: vec![("right".into(), Value::Name("wall"))],
        n: Some(12),
        ..spring()
    };
    for (fixed, targets) in [
        (n(40), &[("max_overlap", 0.01)][..]),
        (n(10), &[("max_overlap", 0.03)]),
        (n(6), &[("max_overlap", 0.1)]),
        (n(20), &[("peak_force", 0.1)]),
        (n(20), &[("peak_force", 0.1), ("max_overlap", 0.05)]),
        (n(16), &[("rms_error_rdot", 0.3)]),
        (n(16), &[("rms_error_r", 0.05)]),
        (unlike, &[("max_overlap", 0.1)]),
        (wall, &[("max_overlap", 0.05)]),
    ] {
        let space = Impact::new(fixed).unwrap();
        let answer = search(&space, &impact(targets));
        assert!(!answer.front.is_empty(), "{targets:?}");
        for case in answer.front.iter().flat_map(|candidate| &candidate.cases) {
            // All steps of short runs, the ends and the largest change of long ones.
            let metrics = BarImpact.solve(case, &[]).unwrap().metrics;
            let ends = ["energy_drift_max", "energy_drift_final"];
            let mut gains = ends
                .map(|name| metrics[metric(&BarImpact, name)].unwrap())
                .to_vec();
            if BarImpact.steps(case) <= 100 {
                gains.extend(energies(case));
            }
            let most = gains.into_iter().fold(0.0, f64::max);
            // Round-off of the two ways to sum.
            assert!(most <= LIMIT + 1e-12, "{targets:?} {case:?} {most}");
        }
    }
}

#[test]
fn a_case_that_gains_much_energy_is_not_recommended() {
    let fixed = FixedParameters {
        n: Some(40),
        mass: Some("lumped"),
        ..spring()
    };
    let space = Impact::new(fixed).unwrap();
    let mut request = impact(&[("max_overlap", 0.01)]);
    // gamma 7.92, dt 1/80 reaches the target, but gains 11 times its energy.
    let known = json!({"gamma": 7.92, "n": 40, "dt": 1.0 / 80.0, "duration": 1.5});
    let known = common::case(&BarImpact, &known);
    assert!(!reaches(&BarImpact, &known, &request));
    let limited = search(&space, &request);
    request.energy_gain = 100.0;
    assert!(reaches(&BarImpact, &known, &request));
    let unlimited = search(&space, &request);
    assert!(chosen(&unlimited).cost < chosen(&limited).cost);
    let gain = |candidate: &Candidate| {
        energies(&candidate.cases[0])
            .into_iter()
            .fold(0.0, f64::max)
    };
    assert!(gain(chosen(&limited)) <= LIMIT && gain(chosen(&unlimited)) > LIMIT);
}

#[test]
fn neighbours_reach_the_target_too() {
    // With 20 per decade neighbours differ by 12 %, rounded to three digits.
    let ratio = libm::pow(10.0, 0.05);
    for limit in [0.03, 0.01] {
        let answer = search(&friction("velocity-control", 12.0), &rms(limit));
        let found = &chosen(&answer).cases[0];
        let (beta, step) = (found.number("beta").unwrap(), found.number("dT").unwrap());
        for (width, x0) in [
            (1.0, 12.0),
            (1.0 / ratio, 12.0),
            (ratio, 12.0),
            (1.0, 11.76),
            (1.0, 12.24),
        ] {
            let beta: f64 = format!("{:.2e}", beta * width).parse().unwrap();
            let given = json!({"law": "velocity-control", "beta": beta, "dT": step, "duration": 8.0 * PI, "x0": x0});
            let case = common::case(&FrictionOscillator, &given);
            // A width written with three digits may differ by one of the last.
            let near = rms(limit * 1.01);
            assert!(reaches(&FrictionOscillator, &case, &near), "{given}");
        }
    }
    // Without neighbours a cheaper case reaches the target.
    let alone = |space: &dyn SearchSpace, request: &Request| {
        let own = |at: &usize| {
            let level = space.level(*at);
            let mut own = level.candidates.iter().map(|c| &level.cases[c[0]]);
            own.any(|case| reaches(space.problem(), case, request))
        };
        let costs = space.costs();
        let mut order: Vec<usize> = (0..costs.len()).collect();
        order.sort_by_key(|at| costs[*at]);
        costs[order.into_iter().find(own).unwrap()]
    };
    let space = friction("velocity-control", 12.0);
    let answer = search(&space, &rms(0.01));
    assert!(alone(&space, &rms(0.01)) < chosen(&answer).cost);

    let request = impact(&[("peak_force", 0.2), ("max_overlap", 0.15)]);
    let space = Impact::new(spring()).unwrap();
    let answer = search(&space, &request);
    let found = chosen(&answer).cases[0].clone();
    let number = |name| found.number(name).unwrap();
    for (spring, into) in [(1.0, 0.0), (1.0 / ratio, 0.0), (ratio, 0.0), (1.0, 0.37)] {
        let given = json!({"gamma": number("gamma") * spring, "n": number("n") as u64, "dt": number("dt"),
            "duration": 1.5, "gap": 2.0 * into * number("dt"), "mass": found.choice("mass")});
        let case = common::case(&BarImpact, &given);
        let mut near = request.clone();
        for target in &mut near.targets {
            target.limit *= 1.01;
        }
        assert!(reaches(&BarImpact, &case, &near), "{given}");
    }
    assert!(alone(&space, &request) < chosen(&answer).cost);
}

#[test]
fn given_values_are_not_searched() {
    let fixed = FixedParameters {
        spring: Some(("k_I", 100.0)),
        bars: vec![("right.L".into(), Value::Number(20.0))],
        ..spring()
    };
    let space = Impact::new(fixed).unwrap();
    let answer = search(&space, &impact(&[("peak_force", 0.2)]));
    for case in answer.front.iter().flat_map(|candidate| &candidate.cases) {
        // E A/L = 10 by default, so gamma n = 10; the right bar is twice as long, with as many elements for the same length.
        let number = |name| case.number(name).unwrap();
        assert_eq!([number("k_I"), number("right.L")], [100.0, 20.0]);
        assert!((number("gamma") * number("n") - 10.0).abs() < 1e-14 * 10.0);
        assert_eq!(number("right.n"), 2.0 * number("n"));
        // Bars of one impedance and lengths 1 : 2 touch until 2 T_I; the duration is half longer.
        assert_eq!(number("duration"), 3.0);
    }
}

/// Levels with one candidate and its neighbours each.
struct Levels(Vec<Vec<Case>>);

impl SearchSpace for Levels {
    fn problem(&self) -> &'static dyn Problem {
        &BarImpact
    }

    fn table_parameters(&self) -> Vec<&'static str> {
        Vec::new()
    }

    fn study_parameters(&self) -> Vec<&'static str> {
        Vec::new()
    }

    fn study_value(&self, _: &Case, _: &str) -> String {
        String::new()
    }

    fn notes(&self) -> Vec<String> {
        Vec::new()
    }

    fn cost_title(&self) -> &'static str {
        "level"
    }

    fn costs(&self) -> Vec<u64> {
        (0..self.0.len() as u64).collect()
    }

    fn level(&self, index: usize) -> CostLevel {
        CostLevel {
            cases: self.0[index].clone(),
            candidates: vec![(0..self.0[index].len()).collect()],
        }
    }

    fn energy_change(&self, case: &Case, solution: &Solution) -> EnergyChange {
        energy_change(case, &solution.computed).unwrap()
    }
}

#[test]
fn one_bad_neighbour_at_any_index_is_enough() {
    let case = |gamma: f64, n: u32, dt: f64, gap: f64| {
        let given = json!({"gamma": gamma, "n": n, "dt": dt, "duration": 1.5, "gap": gap});
        common::case(&BarImpact, &given)
    };
    let good = case(1.0, 10, 0.025, 0.0);
    let request = impact(&[("max_overlap", 0.2)]);
    assert!(reaches(&BarImpact, &good, &request));
    // A missed target; a gain of energy; a gain of 13 % before a loss of 16 %.
    for bad in [
        case(0.01, 10, 0.025, 0.0),
        case(7.92, 40, 0.0125, 0.0),
        case(8.0, 10, 0.23, 0.1),
    ] {
        assert!(!reaches(&BarImpact, &bad, &request));
        for place in 0..4 {
            let mut cases = vec![good.clone(); 4];
            cases[place] = bad.clone();
            let answer = search(&Levels(vec![cases, vec![good.clone(); 4]]), &request);
            assert_eq!(chosen(&answer).cost, 1, "{bad:?} at {place}");
        }
    }
}

fn slipgap(folder: &Path, words: &str) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_slipgap-tested"));
    let words = words.split(' ').collect::<Vec<&str>>();
    command.args(words).current_dir(folder).output().unwrap()
}

fn text(output: &Output) -> String {
    String::from_utf8(output.stdout.clone()).unwrap()
}

/// The cells of a printed row, separated by at least two spaces.
fn cells(line: &str) -> Vec<&str> {
    let cells = line.split("  ").map(str::trim);
    cells.filter(|cell| !cell.is_empty()).collect()
}

#[test]
fn printed_metrics_are_those_of_a_study() {
    let folder = tempfile::tempdir().unwrap();
    for (problem, words) in [
        (
            "friction-oscillator",
            "--rms 0.05 --law tanh --method central-difference",
        ),
        (
            "bar-impact",
            "--overlap 0.15 --peak-force-error 0.3 --method hht --law hunt-crossley",
        ),
        (
            "bar-impact",
            "--rdot 0.4 --k-I 80 --bars right.L=20,E=200 --method average-acceleration",
        ),
        (
            "bar-impact",
            "--r 0.2 --mass lumped --bars right=wall --energy-gain 0.02 --law rigid --method moreau-jean",
        ),
    ] {
        let call = format!("recommend {problem} {words}");
        let one = slipgap(folder.path(), &format!("{call} --jobs 1"));
        assert_eq!(one.status.code(), Some(0), "{one:?}");
        assert_eq!(
            one.stdout,
            slipgap(folder.path(), &format!("{call} --jobs 2")).stdout
        );
        let text = text(&one);
        let parameters = text.lines().find_map(|l| l.strip_prefix("in a study: "));
        let study = format!("{{ \"problem\": \"{problem}\", {} }}", parameters.unwrap());
        std::fs::write(folder.path().join("study.json"), study).unwrap();
        assert!(slipgap(folder.path(), "run study.json").status.success());
        let mut table =
            csv::Reader::from_path(folder.path().join("figures/study/results.csv")).unwrap();
        let header = table.headers().unwrap().clone();
        let computed = table.records().next().unwrap().unwrap();
        let problem = slipgap::problem::find(problem).unwrap();
        let all = problem.metrics().iter();
        let names = all.filter(|m| m.default).map(|m| &*m.name);
        for name in names {
            // The last: a parameter and a metric may have one name (restitution).
            let mut columns = (0..header.len()).rev();
            let column = columns.find(|at| header[*at] == *name).unwrap();
            let line = text
                .lines()
                .find(|l| l.starts_with(&format!("{name} ")))
                .unwrap();
            let printed = cells(line)[1];
            match computed[column].parse::<f64>() {
                // Four digits are printed.
                Ok(x) => {
                    let printed: f64 = printed.parse().unwrap();
                    assert!(
                        (printed - x).abs() <= 5.1e-4 * x.abs(),
                        "{name} {printed} {x}"
                    );
                }
                Err(_) => assert_eq!(printed, "undefined"),
            }
        }
    }
}

#[test]
fn names_of_rows_agree_with_their_numbers() {
    let folder = tempfile::tempdir().unwrap();
    for words in [
        "friction-oscillator --rms 0.05 --x0 12",
        "friction-oscillator --rms 0.05 --x0 5..9 --law coulomb",
        "friction-oscillator --rms 0.05 --x0 -8.3 --law displacement-control",
        "bar-impact --overlap 0.1 --law impact-spring --method average-acceleration",
        "bar-impact --overlap 0.15 --peak-force-error 0.2 --law impact-spring --method average-acceleration",
        "bar-impact --rdot 0.3 --n 8",
        "bar-impact --overlap 1e-3 --n 4 --law kelvin-voigt",
    ] {
        let output = slipgap(folder.path(), &format!("recommend {words}"));
        let text = text(&output);
        let lines = text.lines().filter(|line| !line.starts_with("Warning"));
        let lines: Vec<Vec<&str>> = lines.map(cells).collect();
        let end = lines.iter().position(|l| l[0] == "target").unwrap();
        // The first cell of the header is empty.
        let width = lines[0].len();
        let cost = lines[0]
            .iter()
            .position(|c| c.starts_with("steps"))
            .unwrap()
            + 1;
        let limits: Vec<f64> = lines[end][1..]
            .iter()
            .map(|c| c[3..].parse().unwrap())
            .collect();
        let numbers =
            |row: &[&str]| -> Vec<f64> { row[cost..].iter().map(|c| c.parse().unwrap()).collect() };
        let first = numbers(&lines[1]);
        let reached = first[first.len() - 1] <= 1.0;
        assert_eq!(output.status.code(), Some(if reached { 0 } else { 5 }));
        assert_eq!(
            lines[1][0],
            if reached {
                "recommended"
            } else {
                "nearest, misses the target"
            }
        );
        for row in &lines[1..end] {
            assert_eq!(row.len(), width + 1, "{row:?}");
            let numbers = numbers(row);
            let worst = numbers[numbers.len() - 1];
            let quotients = numbers[1..]
                .iter()
                .zip(&limits[..limits.len() - 1])
                .map(|(x, limit)| x / limit);
            let energies = 1 + usize::from(words.starts_with("bar"));
            let targets = limits.len() - 1 - energies;
            let most = quotients.clone().take(targets).fold(0.0, f64::max);
            // Four digits are printed.
            assert!((most / worst - 1.0).abs() < 1.1e-3, "{row:?}");
            assert!(quotients.clone().skip(targets).all(|x| x <= 1.0), "{row:?}");
            match row[0] {
                "recommended" => assert!(worst <= 1.0),
                "nearest, misses the target" => assert!(worst > 1.0),
                "cheaper, only with this step" => {
                    assert!(reached && worst <= 1.0 && numbers[0] < first[0])
                }
                "cheaper, misses the target" => {
                    assert!(reached && worst > 1.0 && numbers[0] < first[0])
                }
                "cheaper, misses the target by more" => {
                    assert!(!reached && worst > first[first.len() - 1] && numbers[0] < first[0]);
                }
                "costs more, smaller error" => {
                    assert!(worst < first[first.len() - 1] && numbers[0] > first[0]);
                }
                other => panic!("{other}"),
            }
        }
    }
}

#[test]
fn each_request_has_its_own_folder() {
    let folder = tempfile::tempdir().unwrap();
    let call = |words: &str| {
        let one = "--law impact-spring --method average-acceleration";
        let output = slipgap(
            folder.path(),
            &format!("recommend bar-impact {one} {words}"),
        );
        assert_eq!(output.status.code(), Some(0), "{words}");
    };
    call("--overlap 0.15 --n 6");
    let wanted = [
        "recommend-bar-impact-overlap-0.15-impact-spring-average-acceleration-n-6",
        "recommend-bar-impact-overlap-0.2-impact-spring-average-acceleration-n-6",
        "recommend-bar-impact-overlap-0.2-impact-spring-average-acceleration-n-6-L-20-right.L-20",
    ];
    let front =
        |name: &str| std::fs::read(folder.path().join("figures").join(name).join("front.csv"));
    let first = front(wanted[0]).unwrap();
    call("--overlap 0.2 --n 6");
    let long = "--overlap 0.2 --n 6 --bars L=20,right.L=20";
    call(long);
    // The same request in other words.
    call("--n 6 --bars right.L=20.0,L=2e1 --overlap 2e-1 --energy-gain 0.010");
    assert_eq!(front(wanted[0]).unwrap(), first);
    let mut names: Vec<String> = std::fs::read_dir(folder.path().join("figures"))
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    assert_eq!(names, wanted);
    for file in ["front.csv", "front.png", "front.svg", "front.pdf"] {
        assert!(
            folder
                .path()
                .join("figures")
                .join(wanted[0])
                .join(file)
                .is_file()
        );
    }
    // Names that are too long for a file system are shortened and remain different.
    let many = "E=123.4567890123,A=1.23456789012345,rho=0.0123456789012345,V0=0.123456789012345,right.E=99.9876543210123";
    call(&format!("{long},{many}"));
    call(&format!("{long},{many}4"));
    let names = std::fs::read_dir(folder.path().join("figures"))
        .unwrap()
        .count();
    assert_eq!(names, wanted.len() + 2);
}

#[test]
fn exit_codes_of_unreachable_targets_and_wrong_arguments() {
    let folder = tempfile::tempdir().unwrap();
    let far = slipgap(
        folder.path(),
        "recommend bar-impact --overlap 1e-9 --n 5 --law impact-spring --method average-acceleration",
    );
    assert_eq!(far.status.code(), Some(5));
    let shown = text(&far);
    assert!(
        shown.contains("nearest, misses the target") && !shown.contains("recommended"),
        "{shown}"
    );
    // All of these cases gain more energy.
    let none = slipgap(
        folder.path(),
        "recommend bar-impact --overlap 0.1 --n 2 --gamma 5 --energy-gain 1e-300 --law impact-spring --method average-acceleration",
    );
    assert_eq!((none.status.code(), text(&none).as_str()), (Some(5), ""));
    for bad in [
        "recommend bar-impact",
        "recommend bar-impact --overlap 0",
        "recommend bar-impact --overlap nan",
        "recommend bar-impact --overlap 0.1 --energy-gain 0",
        "recommend bar-impact --overlap 0.1 --n 0",
        "recommend bar-impact --overlap 0.1 --gamma 1 --k_I 100",
        "recommend bar-impact --overlap 0.1 --mass heavy",
        "recommend bar-impact --overlap 0.1 --bars L",
        "recommend bar-impact --overlap 0.1 --bars n=3",
        "recommend bar-impact --overlap 0.1 --bars L=-1",
        "recommend bar-impact --overlap 0.1 --bars L=1,L=2",
        "recommend bar-impact --overlap 0.1 --bars right=bar",
        "recommend bar-impact --overlap 0.1 --bars right=wall,right.L=2",
        "recommend bar-impact --overlap 0.1 --bars right.V0=1",
        "recommend bar-impact --overlap 0.1 --bars right.L=1e-9",
        "recommend bar-impact --overlap 0.1 --bars right.L=1e9",
        "recommend friction-oscillator",
        "recommend friction-oscillator --law stribeck --rms 0.1",
        "recommend friction-oscillator --method euler --rms 0.1",
        "recommend friction-oscillator --rms 0.1 --energy-gain 0",
        "recommend bar-impact --overlap 0.1 --energy-loss 0",
        "recommend bar-impact --overlap 0.1 --law hooke",
        "recommend bar-impact --overlap 0.1 --law rigid --gamma 1",
        "recommend bar-impact --overlap 0.1 --law rigid --method central-difference --mass lumped",
        "recommend friction-oscillator --law velocity-control --rms 0.1 --x0 0",
        "recommend friction-oscillator --rms 0.1 --x0 20..8",
        "recommend friction-oscillator --rms 0.1 --x0 8..8",
        "recommend friction-oscillator --rms 0.1 --x0 0..5",
        "recommend friction-oscillator --rms 0.1 --x0 8..",
        "recommend friction-oscillator --rms 0.1 --x0 ..20",
        "recommend friction-oscillator --rms 0.1 --x0 8..inf",
        "recommend friction-oscillator --rms 0.1 --x0 8...20",
        "recommend friction-oscillator --rms 0.1 --x0 1..60",
        "recommend friction-oscillator --rms 0.1 --x0 990..1001",
    ] {
        assert_eq!(slipgap(folder.path(), bad).status.code(), Some(2), "{bad}");
    }
}

#[test]
fn an_answer_that_depends_on_its_step_has_a_warning() {
    let folder = tempfile::tempdir().unwrap();
    let printed = |words: &[&str]| {
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_slipgap-tested"))
            .arg("recommend")
            .args(words)
            .current_dir(folder.path())
            .output()
            .unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    // The step is too long for the contact mode, which raises the peak of the consistent mass.
    let impact = [
        "bar-impact",
        "--peak-force-error",
        "0.1",
        "--overlap",
        "0.1",
        "--n",
        "12",
        "--mass",
        "consistent",
        "--law",
        "impact-spring",
        "--method",
        "average-acceleration",
    ];
    let warning = "Warning: this answer is valid only for its own time step.";
    assert!(printed(&impact).starts_with(warning));
    // A finer step is better for a narrow friction law.
    let friction = ["friction-oscillator", "--rms", "0.05", "--x0", "12"];
    let friction = printed(&friction);
    assert!(friction.contains("the same, step/"), "{friction}");
    assert!(!friction.contains("its own time step"), "{friction}");
}

#[test]
fn the_guide_shows_what_is_printed() {
    let guide = include_str!("../docs/guide.md");
    let (_, call) = guide.split_once("$ slipgap recommend ").unwrap();
    let (call, shown) = call.split_once('\n').unwrap();
    let (shown, _) = shown.split_once("```").unwrap();
    let folder = tempfile::tempdir().unwrap();
    let output = slipgap(folder.path(), &format!("recommend {call}"));
    let printed = text(&output);
    let printed: Vec<&str> = printed
        .lines()
        .filter(|l| !l.starts_with("figures/"))
        .collect();
    let whole = include_str!("data/pages/girders.txt");
    assert_eq!(whole.lines().collect::<Vec<_>>(), printed);
    // The page leaves out what is at `..`.
    let (first, last) = shown.split_once("..\n").unwrap();
    assert!(whole.starts_with(first) && whole.ends_with(last), "{shown}");
}
