//! How often the intervals of a calibration hold the truth. Each repetition has a test of its own: a motion of slipgap by steps of dt/8
//! with normal noise of 1 %, so that the errors of the step of the fit and of the test are not the same.

use indicatif::ProgressBar;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rayon::prelude::*;
use slipgap::calibrate::{Verdict, calibrate};
use slipgap::recommend::Stop;
use slipgap::recommend::calibrate::{Best, End, Objective, Stopped, determine};
use slipgap::run::Source;
use slipgap::statistics::normal;
use slipgap::study::{self, PointCases, Study};
use std::fs;
use tempfile::TempDir;

/// The law of the tests, its free parameters with their true values, and a law with as many that is wrong.
const LAW: &str = "hertz-damp";
const WRONG: &str = "kelvin-voigt";
const TRUTH: [(&str, f64, [f64; 2]); 3] = [
    ("k", 400.0, [100.0, 1600.0]),
    ("restitution", 0.6, [0.2, 0.95]),
    ("gap", 0.02, [0.01, 0.03]),
];

/// The step is so short that its error moves values by less than a third of their standard deviations (measured: k by 0.32). The
/// points of the tests are at steps: between them the motion is taken as straight, which is coarser than the step.
const DT: f64 = 0.0025;
const DURATION: f64 = 0.4;
const EVERY: f64 = 0.005;
const REPETITIONS: u64 = 100;

/// Of 100 intervals that hold the truth with a probability of 95 %, fewer than 89 do so with a probability of 0.4 % (binomial).
const FEWEST: usize = 89;

/// Repetitions with the whole search, for both laws: these take most of the time.
const SEARCHES: u64 = 3;

/// A mass on a spring that moves and hits a stop.
fn text(laws: &[&str], dt: f64, more: &str) -> String {
    let values = TRUTH.map(|(name, value, _)| format!("\"{name}\": {value}"));
    format!(
        r#"{{ "title": "A stop", "problem": "structure",
        "parameters": {{ "law": {laws:?}, {}, "dt": {dt}, "duration": {DURATION} }},
        "structure": {{
            "masses": {{ "block": 1 }},
            "springs": [{{ "between": ["ground", "block"], "mass": 1, "period": 1, "ratio": 0.02 }}],
            "contacts": {{ "stop": {{ "law": "law", "between": ["block", "ground"], "gap": "gap", "k": "k", "k_h": "10*k",
                "restitution": "restitution", "colliding_mass": 1 }} }},
            "start": {{ "block": {{ "v": 0.4 }} }} }},
        {more} "figures": [{{ "name": "force", "kind": "history", "y": "stop.S" }}] }}"#,
        values.join(", ")
    )
}

/// Times and forces of the law, by steps of dt/8.
fn force() -> Vec<[f64; 2]> {
    let text = text(&[LAW], DT / 8.0, r#""metrics": ["peak(stop.S)"],"#);
    let study = study::parse("truth.json", &text).unwrap_or_else(|e| panic!("{e}"));
    let case = study.case(0).unwrap();
    let columns = study.problem.history_columns(&case);
    let column = columns.iter().find(|own| own.column.name == "stop.S");
    let solution = study.problem.solve(&case, &[]).unwrap();
    let values = solution.computed.channel(column.unwrap().index);
    let steps = (DURATION / DT * 8.0).round();
    let at = |i: usize| {
        let time = i as f64 * EVERY;
        let place = time / DURATION * steps;
        let (step, part) = (place as usize, place.fract());
        [
            time,
            values[step] + part * (values[step + 1] - values[step]),
        ]
    };
    (1..(DURATION / EVERY) as usize).map(at).collect()
}

/// The test with noise of 1 % of its rms, as a study that calibrates these laws.
fn noisy(folder: &TempDir, force: &[[f64; 2]], seed: u64, laws: &[&str]) -> String {
    let squares: f64 = force.iter().map(|point| point[1] * point[1]).sum();
    let sigma = 0.01 * (squares / force.len() as f64).sqrt();
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    let mut noise =
        || normal::quantile((random.next_u64() as f64 + 0.5) / 2f64.powi(64)).clamp(-9.0, 9.0);
    let line = |[t, s]: &[f64; 2]| format!("{t},{}\n", s + sigma * noise());
    let lines: String = force.iter().map(line).collect();
    let file = folder.path().join(format!("test-{seed}.csv"));
    fs::write(file, format!("t,force\n{lines}")).unwrap();
    let free = TRUTH.map(|(name, _, ends)| format!("\"{name}\": {ends:?}"));
    let more = format!(
        r#""measured": {{ "file": "test-{seed}.csv", "time": "t", "columns": {{ "stop.S": "force" }} }},
        "calibrate": {{ {}, "minimise": "rms_error(stop.S, measured)" }},
        "metrics": ["rms_error(stop.S, measured)"],"#,
        free.join(", ")
    );
    text(laws, DT, &more)
}

struct Misfit<'a> {
    study: &'a Study,
    cases: PointCases<'a>,
}

impl Objective for Misfit<'_> {
    fn misfits(&mut self, points: &[Vec<f64>]) -> Result<Vec<f64>, Stopped> {
        let cases = self.cases.cases(points);
        let rows: Vec<u32> = (0..cases.len() as u32).collect();
        let sweep = |rows: &[u32]| {
            let table = self.study.problem.sweep(&cases, rows);
            (0..rows.len())
                .map(|row| table.value(row, 0).unwrap_or(f64::INFINITY))
                .collect()
        };
        let parts: Vec<Vec<f64>> = rows.chunks(16).map(sweep).collect();
        Ok(parts.concat())
    }
}

/// Whether the interval of each parameter holds the truth, by profiles from the true point.
fn hits(path: &str, text: &str, points: usize) -> [bool; 3] {
    let study = study::parse(path, text).unwrap_or_else(|e| panic!("{e}"));
    let alternatives = study.alternatives();
    let free = study.free_of(&alternatives[0]);
    let at = TRUTH.map(|(_, value, [from, to])| (value - from) / (to - from));
    let mut misfit = Misfit {
        study: &study,
        cases: study.point_cases(&alternatives[0], &free),
    };
    let start = Best {
        at: at.to_vec(),
        misfit: misfit.misfits(&[at.to_vec()]).unwrap()[0],
        solved: 1,
        starts: [1, 1],
        spent: false,
    };
    let found = determine(&start, &mut misfit, Some(points as f64)).unwrap();
    let holds = |k: usize| match found.profiles[k].interval.unwrap() {
        [End::At(from), End::At(to)] => from <= at[k] && at[k] <= to,
        ends => panic!("{}: {ends:?}", TRUTH[k].0),
    };
    [0, 1, 2].map(holds)
}

#[test]
fn intervals_hold_the_truth_in_95_of_100_tests() {
    let (folder, force) = (tempfile::tempdir().unwrap(), force());
    let path = folder.path().join("study.json");
    let repetition = |seed| {
        let text = noisy(&folder, &force, seed, &[LAW]);
        hits(&path.to_string_lossy(), &text, force.len()).map(usize::from)
    };
    let sum = |a: [usize; 3], b: [usize; 3]| [0, 1, 2].map(|k| a[k] + b[k]);
    let repetitions = (1..=REPETITIONS).into_par_iter();
    let count = repetitions.map(repetition).reduce(|| [0; 3], sum);
    println!("{count:?}");
    assert!(count.iter().all(|count| *count >= FEWEST), "{count:?}");
}

#[test]
fn whole_searches_choose_the_law_of_the_test() {
    let (folder, force) = (tempfile::tempdir().unwrap(), force());
    for seed in 1..=SEARCHES {
        let text = noisy(&folder, &force, 1000 + seed, &[WRONG, LAW]);
        let path = folder.path().join("study.json");
        fs::write(&path, &text).unwrap();
        let source = Source::read(&path, &[], 100).unwrap_or_else(|e| panic!("{e}"));
        let found = calibrate(&source, &ProgressBar::hidden(), &Stop::default())
            .unwrap_or_else(|e| panic!("{e}"));
        let best = found.best().unwrap();
        assert_eq!(best.alternative.name, LAW);
        assert_eq!(found.comparisons[0].verdict, Verdict::Better);
        // What the right law leaves is noise, what the wrong one leaves is not.
        let [right, wrong] = [best, &found.fits[found.order[1]]];
        assert!(
            right.residuals.unwrap().are_white(),
            "{:?}",
            right.residuals
        );
        assert!(
            !wrong.residuals.unwrap().are_white(),
            "{:?}",
            wrong.residuals
        );
        assert!(wrong.misfit() > 3.0 * right.misfit());
        for (value, (name, truth, _)) in best.values.iter().zip(TRUTH) {
            assert!((value / truth - 1.0).abs() < 0.05, "{name}: {value}");
        }
        println!(
            "{} cases, misfits {} and {}",
            found.solved(),
            right.misfit(),
            wrong.misfit()
        );
    }
}
