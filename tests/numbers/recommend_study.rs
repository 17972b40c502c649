//! `slipgap recommend STUDY`: its errors are those of cases solved one by one, its answers those of formulas, of all candidates the
//! cheapest.

use slipgap::problem::Case;
use slipgap::recommend::study::{Advice, Choice, From, Mesh, State, advise};
use slipgap::recommend::{Stop, cost, with_finer_step};
use slipgap::solve::Warning;
use slipgap::study::{Input, parse};
use std::f64::consts::PI;
use std::process::{Command, Output};

fn advice(text: &str) -> Advice {
    let advice = advise(&Input::new("s.json", text), &Stop::default());
    advice.unwrap_or_else(|why| panic!("{why}"))
}

fn number(advice: &Advice, choice: &Choice, name: &str) -> f64 {
    let mut table = advice.study.problem.parameters().iter();
    let row = table.position(|parameter| parameter.name == name).unwrap();
    let chosen = choice
        .values
        .iter()
        .find(|(row_of_value, _)| *row_of_value == row)
        .unwrap();
    chosen.1.as_f64().unwrap()
}

/// A mass on a spring of frequency 1 that is released at u = 1, with these numbers of steps up to this time.
fn free_vibration(steps: &[u32], end: f64, within: &str) -> String {
    let fractions: Vec<String> = steps.iter().map(|n| format!("\"{end:?}/{n}\"")).collect();
    let steps = fractions.join(", ");
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": [{steps}], "duration": {end:?}}},
           "structure": {{"masses": {{"a": 1}}, "springs": [{{"between": ["ground", "a"], "k": 1}}], "start": {{"a": {{"u": 1}}}},
                          "contacts_reference": "softened"}},
           "recommend": {{"over": "dt", "within": {{{within}}}}}}}"#
    )
}

/// The motion of average acceleration is that of the frequency (2/dt) atan(dt/2) (Newmark 1959).
fn last(steps: f64, end: f64) -> f64 {
    let dt = end / steps;
    libm::cos(2.0 / dt * libm::atan(0.5 * dt) * end)
}

#[test]
fn the_step_is_the_one_that_the_error_of_the_period_allows() {
    let end = 10.2 * 2.0 * PI;
    let steps = [40, 80, 120, 160, 240, 320, 640, 1280, 2560];
    for tolerance in [0.5, 0.1, 0.02, 0.004] {
        let within = format!(
            r#""last_error(a)": {tolerance}, "last(a)": {}"#,
            4.0 * tolerance
        );
        let advice = advice(&free_vibration(&steps, end, &within));
        let exact = libm::cos(end);
        assert_eq!(advice.choices.len(), steps.len());
        for (choice, n) in advice.choices.iter().zip(steps) {
            let error = (last(f64::from(n), end) - exact).abs();
            for (found, wanted) in choice.errors.iter().zip([error, error / exact.abs()]) {
                assert!((found - wanted).abs() < 1e-9, "{n}: {found}, not {wanted}");
            }
        }
        let keeps = |n: &u32| {
            let keeps = |n: f64| {
                let error = (last(n, end) - exact).abs();
                error <= tolerance && error <= 4.0 * tolerance * exact.abs()
            };
            keeps(f64::from(*n)) && keeps(2.0 * f64::from(*n))
        };
        let wanted = steps.iter().position(keeps);
        assert!(wanted.is_some());
        assert_eq!(advice.chosen, wanted, "{tolerance}");
        assert_eq!(
            advice.reference.as_ref().unwrap().from,
            [From::Zero, From::Exact]
        );
    }
}

#[test]
fn a_step_that_keeps_a_metric_by_chance_is_not_recommended_if_another_does() {
    // The phase is wrong by nearly a whole period, so that the last value is right.
    let end = 20.2 * 2.0 * PI;
    let error = |n: u32| (last(f64::from(n), end) - libm::cos(end)).abs();
    let chance = (60..400)
        .find(|n| error(*n) < 0.02 && error(2 * n) > 0.1)
        .unwrap();
    let within = r#""last_error(a)": 0.05"#;
    let with_better = advice(&free_vibration(&[chance, 4000], end, within));
    assert_eq!(with_better.chosen, Some(1));
    let first = &with_better.choices[0];
    assert_eq!(first.state, State::Keeps);
    let trial = first.trial.unwrap();
    assert!((trial.step - error(2 * chance) / 0.05).abs() < 1e-7 && !trial.holds());
    // Without another it is the answer, with this warning.
    let alone = advice(&free_vibration(&[chance, chance + 1], end, within));
    assert_eq!(alone.chosen, Some(0));
    assert!(!alone.choices[0].trial.unwrap().holds());
}

const TOWERS: &str = r#"{
  "problem": "structure",
  "parameters": { "seed": [1, 2, 3], "law": ["impact", "kelvin-voigt"], "dt": [0.01, 0.004, 0.002], "n": [1, 2, 3], "duration": 4 },
  "structure": {
    "units": "t, kN, m, s",
    "masses": { "a": 100 },
    "bars": { "b": { "L": 10, "EA": 1e5, "mass": 100, "n": "n" } },
    "springs": [
      { "between": ["ground", "a"], "mass": 100, "period": 0.5, "ratio": 0.05 },
      { "between": ["ground", "b.left"], "mass": 100, "period": 0.9, "ratio": 0.05 }
    ],
    "contacts": { "joint": { "law": "law", "between": ["a", "b.left"], "gap": 0.02, "k": 5e4, "restitution": 0.65, "colliding_mass": 50 } },
    "ground": { "synthetic": "seed" }
  },
  "metrics": { "drift": "max(b.left - a)/3" },
  "recommend": { "over": ["law", "dt", "n"], "within": { "drift": 0.1, "peak(joint.S)": 0.6, "impacts(joint)": 0.4 } }
}"#;

#[test]
fn no_other_candidate_is_cheaper_of_all_solved_one_by_one() {
    let advice = advice(TOWERS);
    assert_eq!((advice.choices.len(), advice.conditions), (18, 3));
    let metrics =
        r#""metrics": ["max(b.left - a)", "peak(joint.S)", "impacts(joint)"], "recommend""#;
    let plain = TOWERS
        .replace(r#""metrics": { "drift": "max(b.left - a)/3" },"#, "")
        .replace(r#""recommend""#, metrics);
    let study = parse("s.json", &plain.replace("drift", "max(b.left - a)")).unwrap();
    let problem = &*study.problem;
    let solve = |case: &Case| -> Vec<f64> {
        let metrics = problem.solve(case, &[]).unwrap().metrics;
        let of = |name: &str| {
            problem
                .metrics()
                .iter()
                .position(|metric| metric.name == name)
                .unwrap()
        };
        let names = ["max(b.left - a)", "peak(joint.S)", "impacts(joint)"];
        names.map(|name| metrics[of(name)].unwrap()).to_vec()
    };
    let cases: Vec<Case> = (0..study.len()).map(|i| study.case(i).unwrap()).collect();
    let key = |case: &Case| {
        (
            case.choice("law"),
            case.number("dt").unwrap(),
            case.number("n").unwrap(),
        )
    };
    let seed = |case: &Case| case.number("seed").unwrap();
    // Of drift and force the exact motion of the last law on the finest mesh, of the number of impacts the finest motion.
    let names = ["max(b.left - a)", "peak(joint.S)"];
    let rows = names.map(|name| {
        problem
            .metrics()
            .iter()
            .position(|metric| metric.name == name)
            .unwrap()
    });
    let reference = |of: f64| {
        let found = cases
            .iter()
            .find(|case| key(case) == ("kelvin-voigt", 0.002, 3.0) && seed(case) == of);
        let finest = found.unwrap();
        let impacts = solve(&with_finer_step(problem, finest, 2))[2];
        let exact = problem.as_structure().unwrap().exact_metrics(finest, &rows);
        [exact[0].unwrap(), exact[1].unwrap(), impacts]
    };
    let references: Vec<(f64, [f64; 3])> = [1.0, 2.0, 3.0].map(|of| (of, reference(of))).to_vec();
    let from = &advice.reference.as_ref().unwrap().from;
    assert_eq!(*from, [From::Exact, From::Exact, From::Finest]);
    let errors = |case: &Case, half: bool| -> Vec<f64> {
        let solved = match half {
            true => solve(&with_finer_step(problem, case, 2)),
            false => solve(case),
        };
        let reference = references
            .iter()
            .find(|(of, _)| *of == seed(case))
            .unwrap()
            .1;
        solved
            .iter()
            .zip(reference)
            .map(|(value, reference)| ((value - reference) / reference).abs())
            .collect()
    };
    let tolerances = [0.1, 0.6, 0.4];
    let largest = |of: (&str, f64, f64), half: bool| -> Vec<f64> {
        let alike = cases.iter().filter(|case| key(case) == of);
        let errors_of_cases: Vec<Vec<f64>> = alike.map(|case| errors(case, half)).collect();
        (0..3)
            .map(|i| {
                errors_of_cases
                    .iter()
                    .map(|of_case| of_case[i])
                    .fold(0.0, f64::max)
            })
            .collect()
    };
    let keeps = |errors: &[f64]| {
        errors
            .iter()
            .zip(tolerances)
            .all(|(error, tolerance)| *error <= tolerance)
    };
    let warned = |of: (&str, f64, f64)| {
        let mut alike = cases.iter().filter(|case| key(case) == of);
        alike.any(|case| {
            let warnings = problem.solve(case, &[]).unwrap().warnings;
            warnings.has(Warning::ShortContact) || warnings.has(Warning::ContactGain)
        })
    };
    let mut costs: Vec<(u64, bool)> = Vec::new();
    for choice in &advice.choices {
        let law = choice.values[0].1.name();
        let of = (
            law,
            number(&advice, choice, "dt"),
            number(&advice, choice, "n"),
        );
        let wanted = largest(of, false);
        for (found, wanted) in choice.errors.iter().zip(&wanted) {
            // Drift is divided by 3 on both sides.
            assert!(
                (found - wanted).abs() <= 1e-12 * (1.0 + wanted),
                "{of:?}: {found}, not {wanted}"
            );
        }
        let alike = cases.iter().filter(|case| key(case) == of);
        assert_eq!(
            choice.cost,
            alike.map(|case| cost(problem, case)).sum::<u64>()
        );
        let finer = (of.0, of.1, of.2 + 1.0);
        // The finest mesh has none that would show its error.
        let holds = of.2 < 3.0 && keeps(&largest(finer, false));
        let energy = warned(of);
        assert_eq!(
            matches!(choice.state, State::ContactEnergy),
            energy && !matches!(choice.state, State::Energy)
        );
        costs.push((
            choice.cost,
            keeps(&wanted) && keeps(&largest(of, true)) && holds && !energy,
        ));
    }
    assert!(costs.is_sorted_by_key(|entry| entry.0));
    let wanted = costs.iter().position(|entry| entry.1);
    assert!(wanted.is_some_and(|at| at > 0), "{costs:?}");
    assert_eq!(advice.chosen, wanted);
    let mesh = |advice: &Advice| advice.choices[advice.chosen.unwrap()].trial.unwrap().mesh;
    assert!(matches!(mesh(&advice), Mesh::Next(_)));
    // Only the finest mesh keeps a smaller tolerance: the answer has a warning.
    let finest = self::advice(&TOWERS.replace(r#"S)": 0.6"#, r#"S)": 0.3"#));
    assert_eq!(mesh(&finest), Mesh::Finest);
    assert!(
        !finest.choices[finest.chosen.unwrap()]
            .trial
            .unwrap()
            .holds()
    );
}

#[test]
fn a_method_that_takes_energy_is_refused_before_its_errors_count() {
    let text = |within: &str| {
        let over_steps = free_vibration(&[100, 200], 60.0, r#""peak(a)": 10"#);
        let over_methods = over_steps.replace(r#""over": "dt""#, r#""over": ["dt", "method"]"#);
        let text = over_methods.replace(r#""peak(a)": 10"#, within);
        text.replace(
            r#""duration""#,
            r#""method": ["newmark", "average-acceleration"], "duration""#,
        )
    };
    let advice = advice(&text(r#""peak(a)": 10"#));
    let states: Vec<&State> = advice.choices.iter().map(|choice| &choice.state).collect();
    assert_eq!(
        states,
        [&State::Energy, &State::Keeps, &State::Energy, &State::Keeps]
    );
    assert!(advice.choices[0].energy.loss > 0.1 && advice.choices[1].energy.loss < 1e-9);
    assert_eq!(advice.chosen, Some(1));
    // A tolerance of the study takes the place of the usual limit.
    let allowed = self::advice(&text(r#""numerical_dissipation": 1"#));
    assert_eq!(allowed.chosen, Some(0));
}

#[test]
fn free_parameters_have_their_best_values() {
    let text = |alpha: &str| {
        format!(
            r#"{{"problem": "friction-oscillator",
               "parameters": {{"law": "displacement-control", "alpha": {alpha}, "dT": ["pi/10", "pi/20"], "x0": [11.76, 12, 12.24], "duration": "8*pi"}},
               "recommend": {{"over": "dT", "within": {{"rms_error": 0.02}}{}}}}}"#,
            if alpha == "1" {
                r#", "alpha": {"log": [0.001, 5]}"#
            } else {
                ""
            }
        )
    };
    let free = advice(&text("1"));
    for width in [
        "0.001", "0.004", "0.0142", "0.03", "0.1", "0.127", "0.3", "1", "5",
    ] {
        let given = advice(&text(width));
        for (free, given) in free.choices.iter().zip(&given.choices) {
            // The starts of a search agree to 1 %.
            assert!(free.worst <= given.worst * 1.01, "{width}");
        }
    }
    // The errors are those of a study with these values.
    for choice in &free.choices {
        let advised = advice(&text(&format!("{:?}", number(&free, choice, "alpha"))));
        let again = advised
            .choices
            .iter()
            .find(|other| other.cost == choice.cost)
            .unwrap();
        assert_eq!((&again.errors, again.worst), (&choice.errors, choice.worst));
    }
}

fn slipgap(folder: &std::path::Path, words: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_slipgap-tested"));
    command.args(words).current_dir(folder).output().unwrap()
}

#[test]
fn the_program_prints_the_same_with_any_number_of_threads_and_ends_as_its_answer() {
    let folder = tempfile::tempdir().unwrap();
    let write = |text: &str| std::fs::write(folder.path().join("s.json"), text).unwrap();
    let csv = || std::fs::read(folder.path().join("figures/recommend-s/candidates.csv")).unwrap();
    write(TOWERS);
    let one = slipgap(folder.path(), &["recommend", "s.json", "--jobs", "1"]);
    assert_eq!(one.status.code(), Some(0), "{one:?}");
    let first = csv();
    let two = slipgap(folder.path(), &["recommend", "s.json", "--jobs", "2"]);
    assert_eq!((two.stdout, csv()), (one.stdout.clone(), first));
    let text = String::from_utf8(one.stdout).unwrap();
    assert!(text.contains("\nRecommended: law = "), "{text}");
    for file in ["front.png", "front.svg", "front.pdf"] {
        assert!(
            folder
                .path()
                .join("figures/recommend-s")
                .join(file)
                .is_file()
        );
    }
    write(&TOWERS.replace(r#""drift": 0.1"#, r#""drift": 1e-9"#));
    let none = slipgap(folder.path(), &["recommend", "s.json"]);
    assert_eq!(none.status.code(), Some(5));
    let text = String::from_utf8(none.stdout).unwrap();
    assert!(
        text.contains("misses drift") && !text.contains("ecommended"),
        "{text}"
    );
}

#[test]
fn the_page_shows_what_is_printed() {
    let page = include_str!("../../docs/recommend.md");
    let block = |start: &str| {
        let (_, rest) = page.split_once(start).unwrap();
        rest.split_once("```").unwrap().0
    };
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("studies")).unwrap();
    std::fs::write(folder.path().join("studies/which.json"), block("```json\n")).unwrap();
    let shown = block("```text\n$ slipgap recommend studies/which.json\n");
    let output = slipgap(folder.path(), &["recommend", "studies/which.json"]);
    let output_text = String::from_utf8(output.stdout).unwrap();
    let printed: Vec<&str> = output_text
        .lines()
        .filter(|line| !line.starts_with("figures/"))
        .collect();
    assert_eq!(shown.lines().collect::<Vec<_>>(), printed);
}

#[test]
fn faults_have_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let start = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control", "beta": [1, 2], "dT": 0.1, "duration": 30},
"#;
    for (key, faults) in [
        (r#""recommend": 3}"#, &["2:14: recommend: must be"][..]),
        (
            r#""recommend": {"over": ["bet"], "within": {"rms_eror": 1, "max_error": 0}, "tol": 1}}"#,
            &[
                "2:24: recommend.over[0]: unknown parameter \"bet\"",
                "2:43: recommend.within.rms_eror: unknown metric \"rms_eror\"",
                "2:71: recommend.within.max_error: must be > 0, got 0",
                "2:82: recommend.tol: unknown key \"tol\"",
            ],
        ),
        (
            r#""recommend": {"over": "dT", "within": {}}}"#,
            &[
                "2:23: recommend.over: dT is 0.1 in all cases",
                "2:39: recommend.within: names no metric",
            ],
        ),
        (
            r#""recommend": {"beta": [1, 2]}}"#,
            &[
                "2:14: recommend.over: missing",
                "2:14: recommend.within: missing",
                "2:15: recommend.beta: \"beta\" is an axis",
            ],
        ),
        (
            r#""reductions": ["least rms_error over beta"], "recommend": {"over": "beta", "within": {"least rms_error over beta": 1}}}"#,
            &[
                "recommend.within.least rms_error over beta: \"least rms_error over beta\" needs several cases; keep",
            ],
        ),
    ] {
        std::fs::write(folder.path().join("s.json"), format!("{start}{key}")).unwrap();
        let output = slipgap(folder.path(), &["recommend", "s.json"]);
        assert_eq!(output.status.code(), Some(2), "{key}");
        let text = String::from_utf8(output.stderr).unwrap();
        for fault in faults {
            assert!(text.contains(fault), "{fault}\n{text}");
        }
    }
    std::fs::write(
        folder.path().join("s.json"),
        format!("{start}\"checks\": []}}"),
    )
    .unwrap();
    for words in [
        &["recommend", "s.json"][..],
        &["recommend"],
        &["recommend", "."],
        &["recommend", "no.json"],
    ] {
        let output = slipgap(folder.path(), words);
        assert!(
            [Some(1), Some(2)].contains(&output.status.code()),
            "{words:?}"
        );
    }
}

#[test]
fn laws_of_several_blocks_are_candidates_for_the_same_physical_cases() {
    let advice = advice(
        r#"{"problem": "friction-oscillator", "blocks": [
             {"parameters": {"law": "displacement-control", "alpha": 0.1, "dT": ["pi/10", "pi/40"], "x0": [12, 12.5], "duration": "8*pi"}},
             {"parameters": {"law": "velocity-control", "beta": [0.5, 1], "dT": ["pi/10", "pi/40"], "x0": [12, 12.5], "duration": "8*pi"}}],
           "recommend": {"over": ["law", "alpha", "beta", "dT"], "within": {"rms_error": 0.025}}}"#,
    );
    assert_eq!((advice.choices.len(), advice.conditions), (6, 2));
    assert!(
        advice
            .choices
            .iter()
            .all(|choice| choice.state != State::Incomplete)
    );
    let chosen = &advice.choices[advice.chosen.unwrap()];
    assert!(chosen.errors[0] <= 0.025 && chosen.trial.unwrap().holds());
    // With half its step the first one misses.
    assert!(advice.chosen == Some(1) && !advice.choices[0].trial.unwrap().holds());
}
