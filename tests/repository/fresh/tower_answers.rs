//! Numbers of docs/answers.md, and of the claim E6, on the forty pairs of towers of studies/evidence, compared with the table of that study.

use super::answers::{Row, number, same};
use super::bridge_answers::{median, read, says, within};
use std::collections::BTreeMap;

const PAGE: &str = include_str!("../../../docs/answers.md");
const CLAIMS: &str = include_str!("../../../claims/evidence.json");

/// Sample and mass of the first tower, as the table has them: a pair of towers.
type Pair = (String, String);

/// What a pair of towers does in a motion, which is named by its seed.
type Motions<'a> = BTreeMap<(Pair, String), &'a Row>;

/// The motions with impact, of a law and a number of steps in a contact.
fn motions<'a>(rows: &'a [Row], law: &str, steps: &str) -> Motions<'a> {
    let chosen = rows
        .iter()
        .filter(|row| row["law"] == law && same(&row["steps"], steps))
        .filter(|row| number(row, "impacts(joint)") > 0.0);
    let named = chosen.map(|row| {
        let pair = (row["sample"].clone(), row["m1"].clone());
        ((pair, row["seed"].clone()), row)
    });
    named.collect()
}

/// Each motion and that with 80 steps, which has an impact, too.
fn with_base<'a>(rows: &'a [Row], law: &str, steps: &str) -> Vec<(&'a Row, &'a Row)> {
    let base = motions(rows, law, "80");
    let of_steps = motions(rows, law, steps);
    let found = of_steps
        .into_iter()
        .filter_map(|(motion, row)| Some((row, *base.get(&motion)?)));
    found.collect()
}

fn ratios(pairs: &[(&Row, &Row)], column: &str) -> Vec<f64> {
    let of = pairs
        .iter()
        .map(|(row, base)| number(row, column) / number(base, column));
    of.collect()
}

/// The motions with an opening and with a force within these parts, and all.
fn counts(rows: &[Row], law: &str, steps: &str, [opening, force]: [f64; 2]) -> [usize; 3] {
    let pairs = with_base(rows, law, steps);
    [
        within(&ratios(&pairs, "opening"), opening),
        within(&ratios(&pairs, "force"), force),
        pairs.len(),
    ]
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn steps_of_towers() {
    let rows = read("towers");
    let of = |steps| counts(&rows, "impact", steps, [0.01, 0.02]);
    let [opening, force, all] = of("20");
    says(
        PAGE,
        &format!(
            "Openings stay within 1 % in {opening} of {all} motions of forty tower pairs, forces within 2 % in {force};"
        ),
    );
    let coarse = ["12", "6", "3"].map(of);
    let [twelve, six, three] =
        coarse.map(|[opening, force, all]| format!("in {opening} and {force} of {all}"));
    says(PAGE, &format!("12 steps: {twelve}; 6: {six}; 3: {three},"));
    let gain = |steps| {
        let all = motions(&rows, "impact", steps).into_values();
        all.map(|row| number(row, "gain")).fold(0.0, f64::max)
    };
    says(
        PAGE,
        &format!(
            "contacts make up to {:.0} % of the energy",
            100.0 * gain("3")
        ),
    );
    // The claim: at most 0.5 % with twenty steps.
    assert!(gain("20") <= 0.005, "{}", gain("20"));
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn range_of_towers() {
    says(
        PAGE,
        "(0.2…2.5 s, 50…2000 t, contacts of 8…200 ms, undamped;",
    );
    let rows = read("towers");
    let ends = |columns: &[&str]| {
        let all = || {
            rows.iter()
                .flat_map(|row| columns.iter().map(move |column| number(row, column)))
        };
        [
            all().fold(f64::INFINITY, f64::min),
            all().fold(f64::NEG_INFINITY, f64::max),
        ]
    };
    for (columns, page) in [
        (&["T1", "T2"][..], [0.2, 2.5]),
        (&["m1", "m2"][..], [50.0, 2000.0]),
        (&["contact"][..], [0.008, 0.2]),
    ] {
        for (found, page) in ends(columns).into_iter().zip(page) {
            assert!(
                (found / page - 1.0).abs() < 0.1,
                "{columns:?}: {found}, not {page}"
            );
        }
    }
    let longest = ends(&["dt"])[1];
    assert!(longest <= 0.01, "{longest}");
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn what_marks_the_exceptions_of_towers() {
    let rows = read("towers");
    let pairs = with_base(&rows, "impact", "20");
    let count = |pairs: &[(&Row, &Row)], column: &str, part: f64, group: &dyn Fn(&Row) -> bool| {
        let chosen: Vec<(&Row, &Row)> = pairs
            .iter()
            .copied()
            .filter(|(_, base)| group(base))
            .collect();
        let ratios = ratios(&chosen, column);
        [ratios.len() - within(&ratios, part), ratios.len()]
    };
    let periods_differ = |row: &Row| {
        let [first, second] = ["T1", "T2"].map(|column| number(row, column));
        first.max(second) >= 2.0 * first.min(second)
    };
    let of = |group: &dyn Fn(&Row) -> bool| count(&pairs, "opening", 0.005, group);
    let [differ, of_differ] = of(&periods_differ);
    let [others, of_others] = of(&|row| !periods_differ(row));
    says(
        CLAIMS,
        &format!(
            "more than 0.5 % in {differ} of {of_differ} motions of towers whose periods differ by twice or more, in {others} of {of_others} of others"
        ),
    );
    let [few, of_few] = of(&|row| number(row, "impacts(joint)") <= 3.0);
    assert_eq!(few, 0);
    says(
        CLAIMS,
        &format!("with up to three impacts in none of {of_few}."),
    );
    let touch = |row: &Row| number(row, "overlap") < 0.001;
    let twelve = with_base(&rows, "impact", "12");
    let [force, of_force] = count(&twelve, "force", 0.02, &touch);
    says(
        CLAIMS,
        &format!("12 steps change it by more than 2 % in {force} of {of_force} motions"),
    );
    assert_eq!(count(&twelve, "opening", 0.01, &touch), [0, of_force]);
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn medians_of_towers() {
    // The medians over the motions with impact of each pair of towers, of the claim.
    let rows = read("towers");
    for (column, part, share) in [("opening", 0.01, 0.95), ("force", 0.01, 0.9)] {
        let middles = |steps| {
            let mut of_pair: BTreeMap<Pair, Vec<f64>> = BTreeMap::new();
            for ((pair, _), row) in motions(&rows, "impact", steps) {
                of_pair.entry(pair).or_default().push(number(row, column));
            }
            of_pair
                .into_iter()
                .map(|(pair, values)| (pair, median(values.into_iter())))
                .collect::<BTreeMap<Pair, f64>>()
        };
        let (found, base) = (middles("20"), middles("80"));
        for sample in ["1", "2"] {
            let of_sample = found.iter().filter(|((name, _), _)| same(name, sample));
            let ratios: Vec<f64> = of_sample.map(|(pair, x)| x / base[pair]).collect();
            let inside = within(&ratios, part) as f64;
            assert!(
                inside >= share * ratios.len() as f64,
                "{column}: {inside} of {}",
                ratios.len()
            );
        }
    }
}
