//! `slipgap recommend` with many candidates: no cheaper candidate than the recommended one passes all tests, by trying all, and printed
//! numbers are those of a study. The studies that are part of the program are searched on parts of their grids.

mod common;

use serde_json::{Value as Json, json};
use slipgap::problem::friction::FrictionOscillator;
use slipgap::problem::impact::BarImpact;
use slipgap::problem::numbers::parameter::Value;
use slipgap::problem::{Case, Problem};
use slipgap::recommend::study::{Advice, State, advise};
use slipgap::recommend::{Stop, energy_change, energy_gain, shipped, with_finer_step};
use slipgap::solve::Warning;
use slipgap::study::Input;
use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Command, Output};

/// A study of the program with other values of some parameters, in the blocks with one of these laws.
fn part(name: &str, laws: &[&str], set: &[(&str, Json)]) -> Json {
    let mut study: Json = serde_json::from_str(shipped(name).unwrap()).unwrap();
    let blocks = study["blocks"].as_array_mut().unwrap();
    blocks.retain(|block| {
        let own = block["parameters"]["law"].to_string();
        laws.iter().any(|law| own.contains(&format!("\"{law}\"")))
    });
    for block in blocks {
        for (name, value) in set {
            if block["parameters"].get(*name).is_some() {
                block["parameters"][*name] = value.clone();
            }
        }
    }
    let given = |name: &Json, study: &Json| {
        let mut blocks = study["blocks"].as_array().unwrap().iter();
        blocks.any(|block| block["parameters"][name.as_str().unwrap()].is_array_or_rule())
    };
    let kept = |key: &str| -> Json {
        let names = study["recommend"][key].as_array().unwrap().iter();
        names.filter(|name| given(name, &study)).cloned().collect()
    };
    let (over, neighbours) = (kept("over"), kept("neighbours"));
    study["recommend"]["over"] = over;
    study["recommend"]["neighbours"] = neighbours;
    study
}

trait Several {
    fn is_array_or_rule(&self) -> bool;
}

impl Several for Json {
    fn is_array_or_rule(&self) -> bool {
        self.is_array()
            || self.is_object()
            || self.as_str().is_some_and(|text| text.starts_with("sqrt"))
    }
}

fn advice(study: &Json) -> Advice {
    let input = Input::new("part.json", &study.to_string());
    advise(&input, &Stop::default()).unwrap_or_else(|why| panic!("{why}"))
}

/// The text of a value of a parameter, by name.
type Named = BTreeMap<String, Value>;

fn recommended(advice: &Advice) -> (Named, u64) {
    let choice = &advice.choices[advice.chosen.unwrap()];
    let names = choice.values.iter();
    let named = names.map(|(row, value)| (advice.name(*row).to_owned(), *value));
    (named.collect(), choice.cost)
}

/// A case of a problem with these values.
fn case(problem: &dyn Problem, named: &[(&str, Value)]) -> Option<Case> {
    let (case, broken) = Case::given(problem, named);
    broken.is_empty().then_some(case)
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
        let own = 0.5 * (x[i] * x[i] + v[i] * v[i]);
        worst = worst.max((own - exact) / (0.5 * x0 * x0));
    }
    worst
}

fn metric(problem: &dyn Problem, case: &Case, name: &str) -> Option<f64> {
    let row = problem
        .metrics()
        .iter()
        .position(|metric| metric.name == name);
    problem.solve(case, &[row?]).ok()?.metrics[row?]
}

const RELEASES: [f64; 5] = [8.000001, 9.000001, 11.000001, 15.3, 20.000001];

/// Whether a law with this width, step and method keeps the error and the energy for all releases.
fn keeps_friction(law: &'static str, width: f64, step: f64, method: &'static str) -> bool {
    RELEASES.iter().all(|x0| {
        let half_cycles = ((x0 - 1.0) / 2.0).ceil();
        let given = [
            ("law", Value::Name(law)),
            ("beta", Value::Number(width)),
            ("dT", Value::Number(step)),
            ("method", Value::Name(method)),
            ("x0", Value::Number(*x0)),
            (
                "duration",
                Value::Number((half_cycles + 2.0) * std::f64::consts::PI),
            ),
        ];
        let Some(case) = case(&FrictionOscillator, &given) else {
            return false;
        };
        let error = metric(&FrictionOscillator, &case, "rms_error");
        error.is_some_and(|error| error <= 0.02) && excess(&case) <= 0.05
    })
}

#[test]
fn no_cheaper_friction_passes_all_tests() {
    let laws = ["velocity-control", "tanh"];
    let methods = ["average-acceleration", "central-difference"];
    let steps: Vec<String> = (4..=14).map(|count| format!("pi/{count}")).collect();
    let set = [
        ("beta", json!({ "geomspace": [1e-4, 10, 51] })),
        ("dT", json!(steps)),
        ("method", json!(methods)),
        ("x0", json!(RELEASES)),
    ];
    let mut study = part("friction-oscillator", &laws, &set);
    study["recommend"]["within"]["rms_error"] = json!(0.02);
    let advice = advice(&study);
    assert_eq!(advice.searched.unwrap()[1], 2 * 51 * 11 * 2);
    let (found, cost) = recommended(&advice);
    let width = |at: i32| 1e-4 * libm::pow(10.0, f64::from(at) / 10.0);
    let count = std::f64::consts::PI / found["dT"].as_f64().unwrap();
    // The cost is that of the step: both methods have no sub-steps.
    let mut cheapest = Vec::new();
    for steps in 4..=count.round() as u32 {
        let step = std::f64::consts::PI / f64::from(steps);
        for law in laws {
            for method in methods {
                let keeps = |at: i32| {
                    !(0..=50).contains(&at) || keeps_friction(law, width(at), step, method)
                };
                for at in 0..=50 {
                    let finer = || {
                        let mut parts = [2.0, 4.0, 8.0, 16.0].into_iter();
                        parts.all(|part| keeps_friction(law, width(at), step / part, method))
                    };
                    if keeps(at) && finer() && keeps(at - 1) && keeps(at + 1) {
                        cheapest.push((steps, law, method, at));
                    }
                }
            }
        }
        if !cheapest.is_empty() {
            break;
        }
    }
    // Among those of the smallest cost.
    let at = cheapest.iter().find(|own| {
        let beta = found["beta"].as_f64().unwrap();
        [own.1, own.2] == [found["law"].name(), found["method"].name()]
            && (width(own.3) / beta - 1.0).abs() < 1e-9
    });
    assert!(
        at.is_some_and(|own| f64::from(own.0) == count.round()),
        "{found:?} {cheapest:?}"
    );
    // Those listed that cost less have larger errors.
    let cheaper = advice.choices.iter().filter(|choice| choice.cost < cost);
    assert!(
        cheaper.clone().count() > 0 && cheaper.clone().all(|choice| choice.state == State::Misses)
    );
}

const GAPS: [f64; 2] = [0.0, 0.013];

/// Whether bars keep peak and overlap within 0.1 and 0.05, and energy within 0.01 and 0.1.
fn keeps_impact(mass: &'static str, gamma: f64, n: u64, step: f64) -> bool {
    GAPS.iter().all(|gap| {
        let given = [
            ("mass", Value::Name(mass)),
            ("gamma", Value::Number(gamma)),
            ("n", Value::Whole(n)),
            ("dt", Value::Number(step)),
            ("gap", Value::Number(*gap)),
            ("duration", Value::Number(1.5 + gap / 2.0)),
        ];
        let Some(case) = case(&BarImpact, &given) else {
            return false;
        };
        let solution = BarImpact.solve(&case, &[]).unwrap();
        let row = |name: &str| {
            let mut metrics = case.schema.metrics.iter();
            metrics.position(|metric| metric.name == name)
        };
        let value = |name: &str| solution.metrics[row(name).unwrap()].unwrap_or(f64::NAN);
        // The exact peak is 1. Another test has the changes of energy.
        let energy = energy_change(&case, &solution.computed).unwrap();
        (value("peak_force") - 1.0).abs() <= 0.1
            && value("max_overlap") <= 0.05
            && energy.gain <= 0.01
            && energy.loss <= 0.1
            && !solution.warnings.iter().any(Warning::is_contact_energy)
    })
}

/// The gain of energy at every step: the drift of the contact minus what the method takes, at the end of a run up to that step.
fn gains(case: &Case) -> f64 {
    let row = case.schema.duration;
    let dt = case.number("dt").unwrap();
    let at_step = |i: u64| {
        let mut cut = case.clone();
        cut.values[row] = Some(Value::Number(i as f64 * dt));
        let value = |name| metric(&BarImpact, &cut, name).unwrap();
        value("energy_drift_final") - value("numerical_dissipation")
    };
    (1..=case.steps()).map(at_step).fold(0.0, f64::max)
}

/// The loss of energy up to the last step: the damping of the contact and the method, and the drift.
fn losses(case: &Case) -> f64 {
    let value = |name| metric(&BarImpact, case, name).unwrap();
    value("contact_dissipation") + value("numerical_dissipation") - value("energy_drift_final")
}

#[test]
fn no_cheaper_impact_passes_all_tests() {
    let masses = ["lumped", "consistent"];
    let meshes = [10, 17, 24, 30, 42, 60];
    let steps = [8, 12, 16, 20, 24, 28, 36];
    let texts: Vec<String> = steps.iter().map(|count| format!("1/{count}")).collect();
    let set = [
        ("law", json!("impact-spring")),
        ("method", json!("average-acceleration")),
        ("mass", json!(masses)),
        ("gamma", json!({ "geomspace": [0.1, 1, 21] })),
        ("n", json!(meshes)),
        ("dt", json!(texts)),
        ("gap", json!(GAPS)),
    ];
    let study = part("bar-impact", &["impact-spring"], &set);
    let advice = advice(&study);
    let (found, _) = recommended(&advice);
    let gamma = |at: i32| 0.1 * libm::pow(10.0, f64::from(at) / 20.0);
    // Steps times modes of both gaps, by a case.
    let mut order = Vec::new();
    for (mesh, n) in meshes.iter().enumerate() {
        for count in steps {
            let gaps = GAPS
                .iter()
                .map(|gap| ((1.5 + gap / 2.0) * f64::from(count) - 1e-9).ceil());
            let total: f64 = gaps.sum();
            order.push((total as u64 * (*n + 1), mesh, count));
        }
    }
    order.sort_unstable();
    let mut cheapest: Vec<(u64, &str, i32, u64, u32)> = Vec::new();
    for (cost, mesh, count) in order {
        if cheapest.first().is_some_and(|first| first.0 < cost) {
            break;
        }
        let (n, step) = (meshes[mesh], 1.0 / f64::from(count));
        for mass in masses {
            let keeps = |at: i32| !(0..=20).contains(&at) || keeps_impact(mass, gamma(at), n, step);
            for at in 0..=20 {
                let finer = || {
                    let next = meshes.get(mesh + 1);
                    let mut parts = [2.0, 4.0, 8.0, 16.0].into_iter();
                    // The study has no finer mesh of which waves pass more than four elements in a step.
                    let next = next.filter(|n| **n as f64 * step <= 2.0);
                    next.is_some_and(|n| keeps_impact(mass, gamma(at), *n, step))
                        && parts.all(|part| keeps_impact(mass, gamma(at), n, step / part))
                };
                if keeps(at) && finer() && keeps(at - 1) && keeps(at + 1) {
                    cheapest.push((cost, mass, at, n, count));
                }
            }
        }
    }
    let at = cheapest.iter().find(|own| {
        found["mass"].name() == own.1
            && (found["gamma"].as_f64().unwrap() / gamma(own.2) - 1.0).abs() < 1e-9
            && found["n"].as_f64().unwrap() == own.3 as f64
            && (found["dt"].as_f64().unwrap() * f64::from(own.4) - 1.0).abs() < 1e-9
    });
    assert!(at.is_some(), "{found:?} {cheapest:?}");
}

#[test]
fn the_changes_of_energy_are_those_of_every_step() {
    let given = |method: &str, gamma: f64, n: u32, dt: f64, gap: f64| {
        let given = json!({"gamma": gamma, "n": n, "dt": dt, "duration": 1.5, "gap": gap, "method": method,
            "law": "kelvin-voigt", "restitution": 0.9});
        common::case(&BarImpact, &given)
    };
    let mut hidden = false;
    for method in [
        "average-acceleration",
        "linear-acceleration",
        "newmark",
        "hht",
        "generalized-alpha",
        "bathe",
        "moreau-jean",
    ] {
        // With the third the drift is a loss of a larger size than the gain before it.
        for (gamma, n, dt, gap) in [
            (1.0, 10, 0.025, 0.0),
            (1.0, 6, 0.02, 0.013),
            (8.0, 4, 0.03, 0.06),
        ] {
            let case = given(method, gamma, n, dt, gap);
            let solution = BarImpact.solve(&case, &[]).unwrap();
            let change = energy_change(&case, &solution.computed).unwrap();
            let (gain, loss) = (gains(&case), losses(&case));
            // Round-off of sums over some hundred steps and modes.
            assert!(
                (change.gain - gain).abs() < 1e-11 * (1.0 + gain),
                "{method}: {change:?}, not {gain}"
            );
            assert!(
                (change.loss - loss).abs() < 1e-11 * (1.0 + loss.abs()),
                "{method}: {change:?}, not {loss}"
            );
        }
    }
    for (gamma, n, dt, gap) in [
        (8.0, 10, 0.23, 0.1),
        (8.0, 4, 0.23, 0.06),
        (5.0, 6, 0.13, 0.06),
    ] {
        let spring = json!({"gamma": gamma, "n": n, "dt": dt, "duration": 1.5, "gap": gap});
        let case = common::case(&BarImpact, &spring);
        let solution = BarImpact.solve(&case, &[]).unwrap();
        let gain = energy_change(&case, &solution.computed).unwrap().gain;
        assert!((gain - gains(&case)).abs() < 1e-12 * (1.0 + gain));
        let largest = metric(&BarImpact, &case, "energy_drift_max").unwrap();
        hidden |= largest < 0.0 && gain > 0.01;
    }
    assert!(hidden);
    for (law, width) in [
        ("displacement-control", "alpha"),
        ("velocity-control", "beta"),
    ] {
        for value in [0.03, 1.0] {
            let given = json!({"law": law, width: value, "dT": 0.3, "duration": 25, "x0": 12.3});
            let case = common::case(&FrictionOscillator, &given);
            let solution = FrictionOscillator.solve(&case, &[]).unwrap();
            let gain = energy_gain(&solution.computed, &solution.exact);
            // Round-off of the two formulas for the exact motion.
            assert!((gain - excess(&case)).abs() < 1e-12, "{law} {value}");
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

/// A part of the friction study that takes a second: 1188 candidates.
fn some_friction() -> Json {
    let set = [
        ("beta", json!({ "geomspace": [1e-3, 1, 11] })),
        ("sigma0", json!({ "geomspace": [1, 1000, 11] })),
        ("dT", json!(["pi/4", "pi/5", "pi/6", "pi/8"])),
        ("x0", json!([9.000001, 12.0])),
    ];
    let laws = ["velocity-control", "coulomb", "lugre"];
    let mut study = part("friction-oscillator", &laws, &set);
    study["recommend"]["within"]["rms_error"] = json!(0.05);
    study
}

#[test]
fn terminal_and_json_have_the_numbers_of_a_study() {
    let folder = tempfile::tempdir().unwrap();
    let study = some_friction();
    std::fs::write(folder.path().join("a.json"), study.to_string()).unwrap();
    let one = slipgap(folder.path(), "recommend a.json --jobs 1 --json");
    assert_eq!(one.status.code(), Some(0), "{one:?}");
    let two = slipgap(folder.path(), "recommend a.json --jobs 2 --json");
    assert_eq!(one.stdout, two.stdout);
    let answer: Json = serde_json::from_str(&text(&one)).unwrap();
    let candidates = answer["candidates"].as_array().unwrap();
    let best = candidates
        .iter()
        .find(|candidate| candidate["verdict"] == "recommended")
        .unwrap();
    assert_eq!(best["parameters"], answer["recommended"]);
    // Listed are those with a smaller error than all cheaper ones, and some that keep all.
    let mut least = f64::INFINITY;
    for own in candidates {
        let worst = own["worst"].as_f64().unwrap();
        assert!(worst < least || worst <= 1.0, "{own}");
        least = least.min(worst);
    }
    let costs = candidates
        .iter()
        .map(|candidate| candidate["cost"].as_u64());
    assert!(costs.is_sorted());
    let printed = text(&slipgap(folder.path(), "recommend a.json"));
    let row = printed
        .lines()
        .find(|line| line.ends_with("recommended"))
        .unwrap();
    for name in ["law", "method"] {
        assert!(
            row.contains(best["parameters"][name].as_str().unwrap()),
            "{row}"
        );
    }
    for sentence in answer["sentences"].as_array().unwrap() {
        assert!(printed.contains(sentence.as_str().unwrap()), "{sentence}");
    }
    let mut parameters = best["parameters"].clone();
    parameters["x0"] = json!([9.000001, 12.0]);
    parameters["duration"] = json!("(ceil((x0 - 1)/2) + 2)*pi");
    let study = json!({"problem": "friction-oscillator", "parameters": parameters});
    std::fs::write(folder.path().join("b.json"), study.to_string()).unwrap();
    assert!(slipgap(folder.path(), "run b.json").status.success());
    let mut table = csv::Reader::from_path(folder.path().join("figures/b/results.csv")).unwrap();
    let column = table
        .headers()
        .unwrap()
        .iter()
        .position(|column| column == "rms_error");
    let errors = table
        .records()
        .map(|row| row.unwrap()[column.unwrap()].parse::<f64>().unwrap());
    // The same bits: 17 digits are written.
    assert_eq!(
        errors.fold(0.0, f64::max),
        best["errors"]["rms_error"].as_f64().unwrap()
    );
}

#[test]
fn a_setting_that_was_known_before_is_recommended() {
    // Searches with three times as many widths, steps to pi/640, and refined to 1/32 of the step found these: beta from 0.0282 to 0.0316
    // with the step pi/5 for an error of 0.05; pi/9, 0.00447 for 0.02.
    for (limit, count) in [(0.05, 5.0), (0.02, 9.0)] {
        let steps: Vec<String> = (2..=9).map(|count| format!("pi/{count}")).collect();
        let set = [
            ("beta", json!({ "geomspace": [1e-6, 10, 29] })),
            ("dT", json!(steps)),
            ("x0", json!({ "linspace": [8.000001, 20.000001, 25] })),
        ];
        let laws = ["velocity-control", "coulomb"];
        let mut study = part("friction-oscillator", &laws, &set);
        study["recommend"]["within"]["rms_error"] = json!(limit);
        let (found, _) = recommended(&advice(&study));
        let step = found["dT"].as_f64().unwrap();
        assert!(
            (std::f64::consts::PI / step - count).abs() < 1e-9,
            "{found:?}"
        );
        assert_eq!(found["method"].name(), "central-difference");
        let finer = {
            let given: Vec<(&str, Value)> = found
                .iter()
                .map(|(name, value)| (name.as_str(), *value))
                .collect();
            let more = [
                ("x0", Value::Number(9.000001)),
                ("duration", Value::Number(25.0)),
            ];
            let case = case(&FrictionOscillator, &[&given[..], &more].concat()).unwrap();
            with_finer_step(&FrictionOscillator, &case, 32)
        };
        assert!(metric(&FrictionOscillator, &finer, "rms_error").unwrap() <= limit);
    }
}

#[test]
fn the_studies_of_the_program_are_found_by_their_names() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["friction-oscillator", "bar-impact"] {
        let study: Json = serde_json::from_str(shipped(name).unwrap()).unwrap();
        assert_eq!(study["problem"], name);
    }
    // One release, and one step for all: a search of some seconds.
    let call = "recommend friction-oscillator --set x0=12 --set duration=8*pi --set dT=[\"pi/8\",\"pi/9\"]";
    let output = slipgap(folder.path(), call);
    assert_eq!(output.status.code(), Some(0), "{output:?}");
    let own = folder.path().join("figures/recommend-friction-oscillator");
    for file in ["candidates.csv", "front.png", "front.svg", "front.pdf"] {
        assert!(own.join(file).is_file());
    }
    // The study itself, to be changed.
    let copy = std::fs::read_to_string(own.join("study.json")).unwrap();
    assert_eq!(copy, shipped("friction-oscillator").unwrap());
}

#[test]
fn exit_codes_of_unreachable_tolerances_and_wrong_arguments() {
    let folder = tempfile::tempdir().unwrap();
    let mut study = some_friction();
    study["recommend"]["within"]["rms_error"] = json!(1e-9);
    std::fs::write(folder.path().join("far.json"), study.to_string()).unwrap();
    let far = slipgap(folder.path(), "recommend far.json");
    assert_eq!(far.status.code(), Some(5));
    assert!(text(&far).contains("Nearest: ") && !text(&far).contains("Recommended"));
    for bad in [
        "recommend",
        "recommend friction-oscillator --rms 0.1",
        "recommend friction-oscillator --set dT=-1",
        "recommend friction-oscillator --set dT=0.1",
        "recommend bar-impact --set right=bar",
        "recommend missing.json",
    ] {
        let code = slipgap(folder.path(), bad).status.code();
        assert!(matches!(code, Some(1 | 2)), "{bad}: {code:?}");
    }
}

#[test]
fn the_guide_shows_what_is_printed() {
    let guide = include_str!("../docs/guide.md");
    let (before, rest) = guide.split_once("$ slipgap recommend ").unwrap();
    let (call, shown) = rest.split_once('\n').unwrap();
    let (shown, _) = shown.split_once("```").unwrap();
    let (_, study) = before.rsplit_once("```json\n").unwrap();
    let (study, _) = study.split_once("```").unwrap();
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("studies")).unwrap();
    std::fs::write(folder.path().join(call), study).unwrap();
    let output = slipgap(folder.path(), &format!("recommend {call}"));
    let printed = text(&output);
    let lines = printed.lines().filter(|line| !line.starts_with("figures/"));
    let lines = Vec::from_iter(lines);
    // The page leaves out the table.
    let end = Vec::from_iter(shown.lines().filter(|line| *line != "..."));
    assert!(!end.is_empty() && lines.ends_with(&end), "{lines:?}");
    let candidates = lines.iter().filter(|line| line.starts_with("0."));
    assert_eq!(candidates.count(), 8);
}
