//! Records that are chosen from a folder because their spectra come nearest to a target.

use crate::parse;
use slipgap_problem::problem::structure::GroundMotion;
use slipgap_system::system::loads::spectrum::spectrum;
use std::f64::consts::PI;
use std::path::{Path, PathBuf};

const PERIODS: [f64; 4] = [0.25, 0.5, 1.0, 2.0];
const COUNT: usize = 24;

/// A folder with records in x and y by a rule: decaying waves of several frequencies, sizes and phases.
fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("slipgap-chosen-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    for k in 0..COUNT {
        for (i, direction) in ["x", "y"].into_iter().enumerate() {
            let part = |step: usize| ((k * step + i) % COUNT) as f64 / COUNT as f64;
            let [size, omega, late] = [0.5 + 2.0 * part(7), 4.0 + 20.0 * part(5), 2.0 * part(11)];
            let mut text = "Time (s), Acc. (m/s2)\n".to_owned();
            for step in 0..=300 {
                let t = f64::from(step) * 0.02;
                let a = size * (omega * t + late).sin() * (-0.6 * t).exp();
                text += &format!("{t}, {a:.9}\n");
            }
            std::fs::write(folder.join(format!("r{k:02}-{direction}.csv")), text).unwrap();
        }
    }
    folder
}

/// A study of a mass that moves in x and y on records of the folder.
fn text(choose: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"rx": {{"files": "*-x.csv"{choose}}}, "ry": {{"files": "*-y.csv"}}, "dt": 0.01, "duration": 1}},
          "metrics": ["peak(m.x)"],
          "structure": {{"units": "kg, N, m, s", "masses": {{"m": {{"mass": 1, "direction": ["x", "y"]}}}},
            "springs": [{{"between": ["ground", "m"], "directions": ["x", "y"], "k": 1}}],
            "ground": {{"x": {{"record": "rx"}}, "y": {{"record": "ry"}}}}}}}}"#
    )
}

fn choose(n: usize, more: &str) -> String {
    format!(
        r#", "choose": {{"n": {n}, "T": [0.25, 0.5, 1, 2], "median": [0.2, 0.3, 0.2, 0.05], "sigma": [0.5, 0.3, 0.4, 0.6], "unit": "g"{more}}}"#
    )
}

/// The files in x and y of each case, and the motion in x.
fn chosen(folder: &Path, text: &str) -> Result<Vec<([String; 2], GroundMotion)>, String> {
    let file = folder.join("s.json").display().to_string();
    let study = parse(&file, text).map_err(|why| why.to_string())?;
    let of = |case| {
        let case = study.case(case).unwrap();
        let names = ["rx", "ry"].map(|name| case.choice(name).to_owned());
        (
            names,
            study
                .problem
                .as_structure()
                .unwrap()
                .ground_motion(&case)
                .unwrap(),
        )
    };
    Ok((0..study.len()).map(of).collect())
}

/// The squared errors of mean and deviation of logarithms, with each spectrum times the factor to 0.2 g at 1 s if `scaled`.
fn misfit(logarithms: &[Vec<f64>], scaled: bool) -> f64 {
    let (median, sigma) = ([0.2, 0.3, 0.2, 0.05], [0.5, 0.3, 0.4, 0.6]);
    let mean = median.map(|a: f64| (a * 9.80665).ln());
    let n = logarithms.len() as f64;
    let at = |i: usize| {
        let value = |logs: &Vec<f64>| logs[i] + if scaled { mean[2] - logs[2] } else { 0.0 };
        let values: Vec<f64> = logarithms.iter().map(value).collect();
        let average = values.iter().sum::<f64>() / n;
        let squares: f64 = values.iter().map(|x| (x - average) * (x - average)).sum();
        (average - mean[i]).powi(2) + ((squares / (n - 1.0)).sqrt() - sigma[i]).powi(2)
    };
    (0..4).map(at).sum()
}

/// The logarithms of the pseudo-accelerations.
fn logarithms(motion: &GroundMotion) -> Vec<f64> {
    let ordinates = spectrum(&motion.acceleration, &PERIODS, 0.05).unwrap();
    let omega = |t: f64| 2.0 * PI / t;
    let square = |u: f64, t: f64| (u * omega(t) * omega(t)).ln();
    let values = ordinates
        .iter()
        .map(|ordinate| square(ordinate.displacement, ordinate.period));
    values.collect()
}

/// No exchange of one chosen record for another comes nearer to the target.
fn assert_best(places: &[usize], of_all: &[Vec<f64>], scaled: bool) {
    let of = |places: &[usize]| {
        let spectra: Vec<Vec<f64>> = places.iter().map(|i| of_all[*i].clone()).collect();
        misfit(&spectra, scaled)
    };
    let reached = of(places);
    for k in 0..places.len() {
        for other in (0..COUNT).filter(|i| !places.contains(i)) {
            let mut exchanged = places.to_vec();
            exchanged[k] = other;
            // Round-off.
            assert!(of(&exchanged) >= reached * (1.0 - 1e-9));
        }
    }
}

#[test]
fn the_chosen_pairs_are_the_best_of_a_folder() {
    let folder = folder("pairs");
    let in_x = chosen(&folder, &text("")).unwrap();
    let in_y = chosen(&folder, &text("").replace("*-x.csv", "*-y.csv")).unwrap();
    // The square root of the sum of both squares, from the spectra of the components.
    let both = in_x.iter().zip(&in_y);
    let of_all: Vec<Vec<f64>> = both
        .map(|(x, y)| {
            let pair = logarithms(&x.1).into_iter().zip(logarithms(&y.1));
            pair.map(|(x, y)| x.exp().hypot(y.exp()).ln()).collect()
        })
        .collect();
    let alone = chosen(&folder, &text(&choose(5, ""))).unwrap();
    for (more, scaled) in [("", false), (r#", "at": 1"#, true)] {
        let of_pairs = format!(r#", "pair": "*-y.csv", "component": "srss"{more}"#);
        let found = chosen(&folder, &text(&choose(5, &of_pairs))).unwrap();
        // Read once more: from the cache, which also has the spectra of single files.
        assert_eq!(
            chosen(&folder, &text(&choose(5, &of_pairs))).unwrap(),
            found
        );
        assert_eq!(chosen(&folder, &text(&choose(5, ""))).unwrap(), alone);
        let index_of = |name: &String| in_x.iter().position(|record| record.0[0] == *name);
        let places: Vec<usize> = found
            .iter()
            .filter_map(|record| index_of(&record.0[0]))
            .collect();
        assert_eq!(places.len(), 5);
        assert_best(&places, &of_all, scaled);
        for ([x, y], _) in &found {
            assert_eq!(x.replace("-x", "-y"), *y);
        }
    }
    std::fs::remove_file(folder.join("r03-y.csv")).unwrap();
    for (more, part) in [
        (
            r#", "pair": "*-y.csv", "component": "srss""#,
            "choose.pair: \"*-y.csv\": no file with \"r03\" for *, as \"r03-x.csv\"",
        ),
        (r#", "pair": "*-y.csv""#, "choose.component: missing"),
        (
            r#", "component": "srss""#,
            "choose.component: needs \"pair\"",
        ),
        (
            r#", "pair": "*-y.csv", "component": "x""#,
            "choose.component: unknown component \"x\"",
        ),
    ] {
        let why = chosen(&folder, &text(&choose(5, more))).unwrap_err();
        assert!(why.contains(part), "{why}");
    }
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn the_chosen_records_are_the_best_of_a_folder_and_have_their_partners() {
    let folder = folder("best");
    let records = chosen(&folder, &text("")).unwrap();
    assert_eq!(records.len(), COUNT);
    let of_all: Vec<Vec<f64>> = records.iter().map(|record| logarithms(&record.1)).collect();
    for (more, scaled) in [("", false), (r#", "at": 1"#, true)] {
        let found = chosen(&folder, &text(&choose(5, more))).unwrap();
        assert_eq!(found.len(), 5);
        // Read once more: from the cache.
        assert_eq!(chosen(&folder, &text(&choose(5, more))).unwrap(), found);
        for ([x, y], _) in &found {
            assert_eq!(x.replace("-x", "-y"), *y);
        }
        let index_of = |x: &String| records.iter().position(|record| record.0[0] == *x).unwrap();
        let places: Vec<usize> = found.iter().map(|record| index_of(&record.0[0])).collect();
        assert!(places.windows(2).all(|pair| pair[0] < pair[1]));
        assert_best(&places, &of_all, scaled);
    }
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn faults_of_a_choice_say_what_is_allowed() {
    let folder = folder("faults");
    std::fs::write(folder.join("bad-x.csv"), "no record\n").unwrap();
    std::fs::copy(folder.join("r00-y.csv"), folder.join("bad-y.csv")).unwrap();
    let wrong = |choose: &str| chosen(&folder, &text(choose)).unwrap_err();
    assert!(wrong(&choose(5, "")).contains("parameters.rx.choose: \"bad-x.csv\": line 1"));
    std::fs::remove_file(folder.join("bad-x.csv")).unwrap();
    std::fs::remove_file(folder.join("bad-y.csv")).unwrap();
    for (choose, part) in [
        (
            choose(1, ""),
            "choose.n: must be a whole number from 2 to 10000, got 1",
        ),
        (
            choose(25, ""),
            "25 motions are to be chosen, but only 24 of 24 are suitable",
        ),
        (
            choose(5, r#", "at": 1, "factor": 1.0001"#),
            "5 motions are to be chosen, but only",
        ),
        (
            choose(5, r#", "at": 3"#),
            "choose.at: must be one of the periods in T",
        ),
        (choose(5, r#", "factor": 3"#), "choose.factor: needs \"at\""),
        (
            choose(5, "").replace("[0.5, 0.3, 0.4, 0.6]", "[0.5]"),
            "needs as many numbers in median and sigma as in T",
        ),
        (
            choose(5, "").replace("[0.5, 0.3, 0.4, 0.6]", "[-1, 0, 0, 0]"),
            "choose.sigma[0]: must be >= 0, got -1",
        ),
        (
            choose(5, "").replace(r#", "unit": "g""#, ""),
            "choose.unit: missing: unit of \"median\"",
        ),
    ] {
        let found = wrong(&choose);
        assert!(found.contains(part), "{found}");
    }
    std::fs::remove_dir_all(folder).unwrap();
}
