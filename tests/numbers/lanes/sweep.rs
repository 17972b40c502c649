//! Cases in lanes with the widest instructions have the same bits as single cases, in any order and group.

use indicatif::ProgressBar;
use slipgap::batch::{self, RunOptions};
use slipgap::problem::Case;
use slipgap::study::{Study, parse};

/// Both laws, different steps and amplitudes, runs that end before rest, and a motion that leaves the range of double precision.
const FRICTION: &str = r#"{"problem": "friction-oscillator", "blocks": [
  {"parameters": {"law": "displacement-control", "x0": 12, "dT": ["pi/10", "pi/3", 0.3], "duration": "8*pi",
                  "initial_slip": ["unloaded", "pulled", "sliding"], "alpha": {"geomspace": [0.01, 10, 40]}}},
  {"parameters": {"law": "displacement-control", "duration": 20, "x0": {"uniform": [-15, 15]},
                  "dT": {"loguniform": [0.01, 1]}, "alpha": {"loguniform": [0.001, 5]}},
   "design": {"kind": "sobol", "n": 128, "seed": 1}},
  {"parameters": {"law": "velocity-control", "x0": [0.4, 12, -1e6], "dT": 0.1, "duration": [3, 40, 60],
                  "beta": {"geomspace": [0.001, 10, 30]}}}]}"#;

/// Equal and different bars, walls, all mass matrices (with 9 and 10 modes of different ones together), various gaps, steps and durations.
const IMPACT: &str = r#"{"problem": "bar-impact", "blocks": [
  {"parameters": {"gamma": {"geomspace": [0.1, 10, 20]}, "n": [1, 9, 10], "dt": 0.01, "duration": 1.5, "gap": [0, 0.25],
                  "mass": ["lumped", "consistent", "massless-contact"]}},
  {"parameters": {"gamma": 0.5, "n": 7, "dt": {"loguniform": [0.001, 0.1]}, "duration": {"uniform": [0.2, 3]},
                  "gap": {"uniform": [0, 0.5]}}, "design": {"kind": "latin-hypercube", "n": 100, "seed": 2}},
  {"parameters": {"gamma": {"linspace": [0.2, 4, 9]}, "n": 5, "dt": 0.02, "duration": 3, "right": {"L": 14, "A": 2, "n": 8}}},
  {"parameters": {"gamma": {"linspace": [0.2, 4, 9]}, "n": 5, "dt": 0.02, "duration": 2, "right": "wall"}}]}"#;

/// Every friction law with every method.
const FRICTION_LAWS: &str = r#"{"problem": "friction-oscillator", "blocks": [
  {"parameters": {"law": ["displacement-control", "bouc-wen", "dahl"], "alpha": {"geomspace": [0.05, 2, 5]},
                  "method": ["average-acceleration", "linear-acceleration", "newmark", "hht", "generalized-alpha", "bathe",
                             "central-difference", "moreau-jean"], "dT": [0.2, 0.07], "duration": [9, 12]}},
  {"parameters": {"law": "bouc-wen", "alpha": [0.1, 0.3], "exponent": [2, 5], "dT": 0.1, "duration": 9}},
  {"parameters": {"law": ["velocity-control", "tanh"], "beta": {"geomspace": [0.01, 1, 5]}, "nu_ratio": [0.5, 1],
                  "method": ["average-acceleration", "hht", "bathe", "central-difference", "moreau-jean"],
                  "dT": [0.2, 0.07], "duration": 9}},
  {"parameters": {"law": "coulomb", "method": ["average-acceleration", "newmark", "bathe", "moreau-jean"],
                  "dT": [0.2, 0.1, 0.07], "duration": 9, "x0": [7.3, 12]}},
  {"parameters": {"law": "stribeck", "beta": [0.1, 0.2, 0.3], "static_ratio": 1.3, "stribeck_velocity": [0.5, 1],
                  "method": ["average-acceleration", "hht", "bathe"], "dT": 0.1, "duration": 9}},
  {"parameters": {"law": "lugre", "sigma0": [5, 20, 30], "sigma1": [0, 1], "sigma2": 0.1, "static_ratio": [1, 1.2],
                  "method": ["average-acceleration", "generalized-alpha", "moreau-jean"], "dT": 0.05, "duration": 9}}]}"#;

/// Every impact law with every method.
const IMPACT_LAWS: &str = r#"{"problem": "bar-impact", "blocks": [
  {"parameters": {"gamma": [0.3, 1, 2.7], "n": [6, 7], "dt": 0.01, "duration": 1.5, "gap": [0, 0.25],
                  "mass": ["lumped", "massless-contact"],
                  "method": ["average-acceleration", "linear-acceleration", "newmark", "hht", "generalized-alpha", "bathe",
                             "central-difference"]}},
  {"parameters": {"law": ["kelvin-voigt", "hertz-damp", "hunt-crossley", "ye", "jankowski"], "restitution": [0.5, 0.9],
                  "method": ["average-acceleration", "hht", "bathe", "moreau-jean"], "gamma": [0.3, 1, 2.7], "n": 6,
                  "dt": 0.01, "duration": 1.5, "gap": [0, 0.25]}},
  {"parameters": {"law": "hertz", "k_h": [20, 100, 300], "n": 6, "dt": 0.01, "duration": [1.4, 1.5], "right": "wall"}},
  {"parameters": {"law": "rigid", "restitution": [0, 0.5], "theta": [0.5, 1], "method": "moreau-jean", "n": [6, 7],
                  "dt": 0.01, "duration": 1.5, "gap": 0.1}},
  {"parameters": {"law": "rigid", "method": ["generalized-alpha", "bathe"], "mass": ["lumped", "massless-contact"], "n": [6, 7],
                  "dt": 0.01, "duration": 1.5, "gap": 0.1}}]}"#;

fn study(text: &str) -> Study {
    parse("sweep.json", text).unwrap_or_else(|e| panic!("{e}"))
}

/// The bits of the default metrics of a row.
fn bits(study: &Study, row: &[Option<f64>]) -> Vec<Option<u64>> {
    let table = study.problem.metrics();
    let default = row.iter().zip(table).filter(|(_, metric)| metric.default);
    default.map(|(x, _)| x.map(f64::to_bits)).collect()
}

#[test]
fn cases_in_lanes_have_the_bits_of_single_cases() {
    for text in [FRICTION, IMPACT, FRICTION_LAWS, IMPACT_LAWS] {
        let study = study(text);
        let alone: Vec<_> = study
            .cases()
            .map(|case| bits(&study, &study.problem.solve(&case, &[]).unwrap().metrics))
            .collect();
        let (_, cases) = study.columns(0, study.raw_len());
        assert_eq!(cases.len(), alone.len());
        let mut order: Vec<u32> = (0..cases.len() as u32).collect();
        // In order, reversed, every third case, and in slices that do not fill the lanes.
        for (turn, size) in [(0, cases.len()), (1, cases.len()), (2, 3), (3, 37)] {
            match turn {
                1 => order.reverse(),
                2 => order.sort_by_key(|i| i % 3),
                _ => {}
            }
            for slice in order.chunks(size) {
                let swept = study.problem.sweep(&cases, slice);
                assert_eq!((swept.len(), swept.failures().count()), (slice.len(), 0));
                for (row, i) in slice.iter().enumerate() {
                    let found = bits(&study, &swept.row(row).collect::<Vec<_>>());
                    assert_eq!(found, alone[*i as usize], "case {i} of {text}");
                }
            }
        }
    }
}

#[test]
fn a_motion_out_of_range_is_reported_among_others() {
    let study = study(
        r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control", "x0": [12, 1e308, 3], "dT": 3,
            "duration": 3e3, "beta": 1}}"#,
    );
    let (_, cases) = study.columns(0, study.raw_len());
    let swept = study.problem.sweep(&cases, &[0, 1, 2]);
    for (row, case) in study.cases().enumerate() {
        let alone = study.problem.solve(&case, &[]);
        match (swept.failure(row), alone) {
            (None, Ok(alone)) => {
                assert_eq!(
                    bits(&study, &swept.row(row).collect::<Vec<_>>()),
                    bits(&study, &alone.metrics)
                );
            }
            (Some(why), Err(alone)) => assert_eq!(*why, alone),
            (why, alone) => panic!("{why:?} beside others, {} alone", alone.is_ok()),
        }
    }
    assert_eq!(
        swept.failures().map(|(row, _)| row).collect::<Vec<_>>(),
        [1]
    );
}

#[test]
fn a_single_solution_of_a_case_does_not_change_the_sweep() {
    let text = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control", "x0": [12, 1e308, 3],
        "dT": 3, "duration": 3e3, "beta": [0.5, 1, 2]}}"#;
    let study = study(text);
    let outcomes = |options: &RunOptions| {
        let mut outcomes = Vec::new();
        batch::run(&study, &ProgressBar::hidden(), options, |part| {
            outcomes.extend(part.outcomes(&study));
            Ok(())
        })
        .unwrap();
        outcomes
    };
    // One that can be solved, one that cannot, and the last.
    let kept = [1, 4, 8];
    let chosen: Vec<Case> = kept.map(|number| study.case(number).unwrap()).to_vec();
    let options = RunOptions {
        keep_history: Some(&|case| chosen.iter().any(|other| other.values == case.values)),
        ..RunOptions::METRICS
    };
    let (metrics_only, shown) = (outcomes(&RunOptions::METRICS), outcomes(&options));
    assert_eq!((metrics_only.len(), shown.len()), (9, 9));
    for ((number, together), (same, other)) in metrics_only.iter().zip(&shown) {
        assert_eq!(number, same);
        assert_eq!(together.case.values, other.case.values);
        assert_eq!(together.metrics, other.metrics, "case {number}");
        assert_eq!(together.failure, other.failure);
        assert_eq!(together.failure.is_some(), (3..6).contains(number));
        assert!(together.solution.is_none());
        let solved = kept.contains(number) && other.failure.is_none();
        assert_eq!(other.solution.is_some(), solved, "case {number}");
    }
}
