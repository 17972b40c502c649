//! `slipgap recommend`: no candidate is cheaper, the front falls, and what is printed is what a study computes.

use slipgap::problem::Problem;
use slipgap::recommend::{Candidate, Space, Target, friction::Friction, impact::Impact, search};
use std::process::{Command, Output};

/// Whether a candidate and all its neighbours reach the targets, by their metrics alone.
fn reaches(problem: &dyn Problem, candidate: &Candidate, targets: &[Target]) -> bool {
    candidate.tried.iter().all(|case| {
        let metrics = problem.solve(case, &[]).unwrap().metrics;
        let within = |t: &Target| metrics[t.metric].is_some_and(|x| (x - t.ideal).abs() <= t.limit);
        targets.iter().all(within)
    })
}

fn cheapest_by_trying_all(space: &dyn Space, targets: &[Target]) {
    let answer = search(space, targets);
    let chosen = &answer.front[answer.chosen.unwrap()];
    assert!(chosen.worst <= 1.0);
    for pair in answer.front.windows(2) {
        assert!(pair[0].cost < pair[1].cost && pair[0].worst > pair[1].worst);
    }
    let mut found = false;
    for rung in space.rungs() {
        if rung.cost > chosen.cost {
            break;
        }
        let any = rung
            .candidates
            .iter()
            .any(|c| reaches(space.problem(), c, targets));
        assert_eq!(any, rung.cost == chosen.cost, "cost {}", rung.cost);
        found |= any;
    }
    assert!(found);
}

#[test]
fn nothing_cheaper_reaches_the_target() {
    let rms = Target {
        name: "rms_error",
        metric: 0,
        ideal: 0.0,
        limit: 0.03,
    };
    for (law, x0) in [("velocity-control", 12.0), ("displacement-control", -12.5)] {
        cheapest_by_trying_all(&Friction { law, x0 }, std::slice::from_ref(&rms));
    }
    let target = |name, metric, ideal, limit| Target {
        name,
        metric,
        ideal,
        limit,
    };
    let targets = [target("peak", 5, 1.0, 0.1), target("overlap", 3, 0.0, 0.15)];
    assert_eq!(Impact.problem().metrics()[5].name, "peak_force");
    assert_eq!(Impact.problem().metrics()[3].name, "max_overlap");
    cheapest_by_trying_all(&Impact, &targets);
}

#[test]
fn the_answer_lies_where_the_maps_have_it() {
    // 0.01 of x0 = 12: pi/10 at its best width has 0.0103, pi/20 0.0035 (docs/findings-friction.md).
    let rms = Target {
        name: "rms_error",
        metric: 0,
        ideal: 0.0,
        limit: 0.01,
    };
    let space = Friction {
        law: "velocity-control",
        x0: 12.0,
    };
    let answer = search(&space, &[rms]);
    let steps = answer.front[answer.chosen.unwrap()].cost;
    assert!((80.0..=160.0).contains(&steps), "{steps}");
}

fn slipgap(folder: &std::path::Path, words: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_slipgap"));
    command.args(words).current_dir(folder).output().unwrap()
}

#[test]
fn what_is_printed_is_what_a_study_computes() {
    let folder = tempfile::tempdir().unwrap();
    let words = "recommend friction-oscillator --law velocity-control --x0 12 --rms 0.02 --jobs";
    let asked = |jobs| words.split(' ').chain([jobs]).collect::<Vec<&str>>();
    let one = slipgap(folder.path(), &asked("1"));
    assert_eq!(one.status.code(), Some(0), "{one:?}");
    assert_eq!(one.stdout, slipgap(folder.path(), &asked("2")).stdout);
    let text = String::from_utf8(one.stdout).unwrap();
    let pasted = text
        .lines()
        .find_map(|l| l.strip_prefix("in a study: "))
        .unwrap();
    let study = format!("{{ \"problem\": \"friction-oscillator\", {pasted} }}");
    std::fs::write(folder.path().join("study.json"), study).unwrap();
    assert!(
        slipgap(folder.path(), &["run", "study.json"])
            .status
            .success()
    );
    let mut table =
        csv::Reader::from_path(folder.path().join("figures/study/results.csv")).unwrap();
    let column = table
        .headers()
        .unwrap()
        .iter()
        .position(|h| h == "rms_error")
        .unwrap();
    let computed: f64 = table.records().next().unwrap().unwrap()[column]
        .parse()
        .unwrap();
    let row = text.lines().find(|l| l.starts_with("recommended")).unwrap();
    let printed: f64 = row.split_whitespace().nth(4).unwrap().parse().unwrap();
    // Four digits are printed.
    assert!(
        (printed / computed - 1.0).abs() < 5e-4 && computed <= 0.02,
        "{printed} {computed}"
    );
    for file in ["front.csv", "front.png", "front.svg"] {
        let path = folder
            .path()
            .join("figures/recommend-friction-oscillator")
            .join(file);
        assert!(path.is_file(), "{file}");
    }
}

#[test]
fn targets_out_of_reach_and_bad_words_end_as_they_should() {
    let folder = tempfile::tempdir().unwrap();
    let run = |words: &str| slipgap(folder.path(), &words.split(' ').collect::<Vec<_>>());
    let far = run("recommend friction-oscillator --law displacement-control --rms 1e-9");
    assert_eq!(far.status.code(), Some(5));
    let told = String::from_utf8(far.stdout).unwrap();
    assert!(
        told.contains("nearest") && !told.contains("recommended"),
        "{told}"
    );
    for bad in [
        "recommend bar-impact",
        "recommend bar-impact --overlap 0",
        "recommend bar-impact --overlap nan",
        "recommend friction-oscillator --rms 0.1",
        "recommend friction-oscillator --law coulomb --rms 0.1",
        "recommend friction-oscillator --law velocity-control --rms 0.1 --x0 0",
    ] {
        assert_eq!(run(bad).status.code(), Some(2), "{bad}");
    }
}
