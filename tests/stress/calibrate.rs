//! How often the intervals of a calibration hold the truth. Each repetition has a test of its own: a motion of slipgap by steps of dt/8
//! with normal noise of 1 %, so that the errors of the step of the fit and of the test are not the same.

use indicatif::ProgressBar;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use rayon::prelude::*;
use slipgap::calibrate::{Verdict, calibrate, sentences, write};
use slipgap::recommend::Stop;
use slipgap::recommend::calibrate::{
    Best, Between, Determined, End, Objective, Stopped, determine,
};
use slipgap::run::Source;
use slipgap::statistics::{CONFIDENCE, fisher, normal};
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

/// Times and forces of the law with a restitution, by steps of dt/8.
fn force(restitution: f64) -> Vec<[f64; 2]> {
    let text = text(&[LAW], DT / 8.0, r#""metrics": ["peak(stop.S)"],"#);
    let replacement = format!("\"restitution\": {restitution}");
    let text = text.replace("\"restitution\": 0.6", &replacement);
    let study = study::parse("truth.json", &text).unwrap_or_else(|e| panic!("{e}"));
    let case = study.case(0).unwrap();
    let columns = study.problem.history_columns(&case);
    let column = columns
        .iter()
        .find(|channel| channel.column.name == "stop.S");
    let solution = study.problem.solve(&case, &[]).unwrap();
    let values = solution.computed.channel(column.unwrap().index);
    let steps = (DURATION / DT * 8.0).round();
    let at = |i: usize| {
        let time = i as f64 * EVERY;
        let at = time / DURATION * steps;
        let (step, part) = (at as usize, at.fract());
        [
            time,
            values[step] + part * (values[step + 1] - values[step]),
        ]
    };
    (1..(DURATION / EVERY) as usize).map(at).collect()
}

/// The test with noise of 1 % of its rms, as a study that calibrates these laws.
fn noisy(folder: &TempDir, force: &[[f64; 2]], seed: u64, laws: &[&str]) -> String {
    write_noisy(folder, force, seed);
    let free = TRUTH.map(|(name, _, ends)| format!("\"{name}\": {ends:?}"));
    of_file(&format!("\"test-{seed}.csv\""), &free.join(", "), laws)
}

/// Independent values of the standard normal distribution.
fn normals(seed: u64) -> impl FnMut() -> f64 {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    move || normal::quantile((random.next_u64() as f64 + 0.5) / 2f64.powi(64)).clamp(-9.0, 9.0)
}

/// Writes the test with noise of 1 % of its rms as test-SEED.csv.
fn write_noisy(folder: &TempDir, force: &[[f64; 2]], seed: u64) {
    let squares: f64 = force.iter().map(|point| point[1] * point[1]).sum();
    let sigma = 0.01 * (squares / force.len() as f64).sqrt();
    let mut noise = normals(seed);
    let line = |[t, s]: &[f64; 2]| format!("{t},{}\n", s + sigma * noise());
    let lines: String = force.iter().map(line).collect();
    let file = folder.path().join(format!("test-{seed}.csv"));
    fs::write(file, format!("t,force\n{lines}")).unwrap();
}

/// The study that calibrates these laws to a file by these free parameters.
fn of_file(file: &str, free: &str, laws: &[&str]) -> String {
    let more = format!(
        r#""measured": {{ "file": {file}, "time": "t", "columns": {{ "stop.S": "force" }} }},
        "calibrate": {{ {free}, "minimise": "rms_error(stop.S, measured)" }},
        "metrics": ["rms_error(stop.S, measured)"],"#
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

/// The profiles of the first free parameters from their true values, from 0 to 1 in their ranges.
fn profiles(path: &str, text: &str, at: &[f64], points: usize) -> Determined {
    let study = study::parse(path, text).unwrap_or_else(|e| panic!("{e}"));
    let alternatives = study.alternatives();
    let free = study.free_of(&alternatives[0]);
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
    determine(&start, &mut misfit, Some(points as f64)).unwrap()
}

/// Whether the interval of each parameter holds the truth, by profiles from the true point.
fn hits(path: &str, text: &str, points: usize) -> [bool; 3] {
    let at = TRUTH.map(|(_, value, [from, to])| (value - from) / (to - from));
    let found = profiles(path, text, &at, points);
    let holds = |k: usize| match found.profiles[k].interval.unwrap() {
        [End::At(from), End::At(to)] => from <= at[k] && at[k] <= to,
        ends => panic!("{}: {ends:?}", TRUTH[k].0),
    };
    [0, 1, 2].map(holds)
}

#[test]
fn intervals_hold_the_truth_in_95_of_100_tests() {
    let (folder, force) = (tempfile::tempdir().unwrap(), force(0.6));
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
    let (folder, force) = (tempfile::tempdir().unwrap(), force(0.6));
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

/// Restitutions of the tests of a set: their mean, their scatter and their number.
const MEAN: f64 = 0.6;
const SCATTER: f64 = 0.04;
const TESTS: u64 = 5;

/// Writes the tests of a set, each with a restitution of its own; gives these.
fn write_set(folder: &TempDir, set: u64) -> Vec<f64> {
    let mut random = normals(set);
    let restitutions: Vec<f64> = (0..TESTS).map(|_| MEAN + SCATTER * random()).collect();
    for (restitution, seed) in restitutions.iter().zip(set * 10..) {
        write_noisy(folder, &force(*restitution), seed);
    }
    restitutions
}

const RESTITUTION: &str = "\"restitution\": [0.2, 0.95]";

#[test]
fn mean_and_scatter_between_tests_are_held_in_95_of_100_sets() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("study.json").display().to_string();
    let holds = |[low, high]: [f64; 2], x: f64| usize::from(low <= x && x <= high);
    let of_set = |set: u64| {
        let of_test = |(truth, seed): (&f64, u64)| {
            let text = of_file(&format!("\"test-{seed}.csv\""), RESTITUTION, &[LAW]);
            let points = (DURATION / EVERY) as usize - 1;
            let found = profiles(&path, &text, &[(truth - 0.2) / 0.75], points);
            let Some([End::At(low), End::At(high)]) = found.profiles[0].interval else {
                panic!("{found:?}");
            };
            // The interval is t standard errors to both sides.
            let t = fisher::quantile(CONFIDENCE, 1.0, points as f64 - 1.0).sqrt();
            (
                0.2 + 0.75 * found.best.at[0],
                0.75 * (high - low) / (2.0 * t),
            )
        };
        let restitutions = write_set(&folder, set);
        let tests = restitutions.iter().zip(set * 10..).map(of_test);
        let (values, errors): (Vec<f64>, Vec<f64>) = tests.unzip();
        let found = Between::of(&values, &errors, true).unwrap();
        [
            holds(found.mean_interval, MEAN),
            holds(found.scatter_interval, SCATTER),
        ]
    };
    let held: Vec<[usize; 2]> = (1..=REPETITIONS).into_par_iter().map(of_set).collect();
    let count = [0, 1].map(|k| held.iter().map(|of_test| of_test[k]).sum::<usize>());
    println!("{count:?}");
    assert!(count.iter().all(|count| *count >= FEWEST), "{count:?}");
}

#[test]
fn a_restitution_that_varies_has_a_mean_and_a_scatter() {
    let folder = tempfile::tempdir().unwrap();
    let truth = write_set(&folder, 1);
    let varies = format!("{RESTITUTION}, \"gap\": [0.01, 0.03], \"varies\": \"restitution\"");
    let files = "{\"files\": \"test-*.csv\"}";
    let path = folder.path().join("study.json");
    fs::write(&path, of_file(files, &varies, &[LAW])).unwrap();
    let source = Source::read(&path, &[], 100).unwrap_or_else(|e| panic!("{e}"));
    let found = calibrate(&source, &ProgressBar::hidden(), &Stop::default())
        .unwrap_or_else(|e| panic!("{e}"));
    let fit = &found.fits[0];
    assert_eq!(fit.each.len(), truth.len());
    for (test, truth) in fit.each.iter().zip(&truth) {
        // Four standard errors of a test.
        assert!(
            (test.values[0] - truth).abs() < 0.05,
            "{:?} {truth}",
            test.values
        );
    }
    let [restitution, gap] = [0, 1].map(|index| fit.scatter(&found, &fit.free[index]).unwrap());
    assert!(restitution.varies && !gap.varies);
    let [low, high] = restitution.between.scatter_interval;
    assert!(0.0 < low && low < SCATTER && SCATTER < high);
    let [mean, low, high] = restitution.mean();
    assert!(low < MEAN && MEAN < high && low < mean && mean < high);
    // The gap is the same in all tests: no scatter, and a mean as sharp as five tests make it.
    let [mean, low, high] = gap.mean();
    assert!(
        (mean - 0.02).abs() < high - low && high - low < 1e-3,
        "{gap:?}"
    );
    let words = sentences(&found).join("\n");
    let expected = "restitution varies between 5 tests: mean 0.";
    assert!(words.contains(expected), "{words}");
    let out = folder.path().join("out");
    write(&found, &source, &out, 100).unwrap();
    let table = fs::read_to_string(out.join("scatter.csv")).unwrap();
    let rows: Vec<Vec<&str>> = table
        .lines()
        .map(|line| line.split(',').collect())
        .collect();
    assert_eq!(rows[1][1..4], ["restitution", "true", "5"]);
    assert_eq!(rows[1][7].parse(), Ok(restitution.between.scatter));
    assert_eq!(rows[2][1..4], ["gap", "false", "5"]);
    assert_eq!(rows[2][7..10], ["", "", ""]);
    let each = fs::read_to_string(out.join("each-test.csv")).unwrap();
    assert_eq!(each.lines().count(), 1 + 2 * truth.len());
    assert!(
        each.lines()
            .nth(1)
            .unwrap()
            .contains(",test-10.csv,restitution,")
    );
}
