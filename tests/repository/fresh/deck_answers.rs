//! Numbers of docs/findings-plane.md, and of the claims E8 and E9, on the forty isolated decks of studies/evidence, compared with the tables
//! of these studies.

use super::answers::{Row, number, same};
use super::bridge_answers::{ANSWERS, read, says, within};
use std::collections::BTreeMap;

const PAGE: &str = include_str!("../../../docs/findings-plane.md");
const CLAIMS: &str = include_str!("../../../claims/evidence.json");

/// A deck of a sample, by its period as the table has it, and the seed of a motion.
type Motion = (String, String, String);

/// The values of a metric of a model.
fn values(rows: &[Row], model: &str, metric: &str) -> BTreeMap<Motion, f64> {
    let chosen = rows.iter().filter(|row| row["model"] == model);
    let named = chosen.map(|row| {
        let motion = (row["sample"].clone(), row["T"].clone(), row["seed"].clone());
        (motion, number(row, metric))
    });
    named.collect()
}

/// A model over another one, of the motions of the first.
fn ratios(rows: &[Row], model: &str, base: &str, metric: &str) -> Vec<f64> {
    let base = values(rows, base, metric);
    let of = values(rows, model, metric).into_iter();
    of.map(|(motion, x)| x / base[&motion]).collect()
}

fn column(rows: &[Row], name: &str) -> Vec<f64> {
    rows.iter().map(|row| number(row, name)).collect()
}

fn count(values: &[f64], is: impl Fn(f64) -> bool) -> usize {
    values.iter().filter(|x| is(**x)).count()
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn friction_by_axis_of_decks() {
    let rows = read("axes");
    assert_eq!(rows.len(), 200);
    let [vector, stronger, other, srss, rest] =
        ["vector", "stronger", "other", "srss", "rest"].map(|name| column(&rows, name));
    let near = count(&vector, |x| (0.8..=1.2).contains(&x));
    let weak = count(&other, |x| x < 0.9);
    says(
        PAGE,
        &format!(
            "0.8 to 1.2 times as far as the disc in {near} of 200, less far in {}, in the weaker direction less than 0.9 times as far in {weak}.",
            count(&vector, |x| x < 1.0)
        ),
    );
    says(
        ANSWERS,
        &format!("0.8…1.2 times as far in {near} of 200 motions of forty decks."),
    );
    says(
        PAGE,
        &format!(
            "errs by more than 0.1 of the peak in {}.",
            count(&rest, |x| x > 0.1)
        ),
    );
    says(
        PAGE,
        &format!(
            "below the peak of the disc in {} of 200 motions of the isolated decks, 0.8 to 1.3 times it in {}.",
            count(&srss, |x| x < 1.0),
            count(&srss, |x| (0.8..=1.3).contains(&x))
        ),
    );
    says(
        CLAIMS,
        &format!(
            "less than 0.9 times as far in {weak} of 200 motions, the stronger one in {}.",
            count(&stronger, |x| x < 0.9)
        ),
    );
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn steps_and_softening_of_decks() {
    let rows = read("decks");
    let slip = |model| ratios(&rows, model, "plane", "slip");
    let [twice, half, velocity] = ["twice", "half", "velocity"].map(slip);
    says(
        PAGE,
        &format!(
            "10 ms change the peak slip by at most 2 % in {} of {} motions, 2.5 ms by at most 0.5 % in {} of {}.",
            within(&twice, 0.02),
            twice.len(),
            within(&half, 0.005),
            half.len()
        ),
    );
    assert_eq!(within(&velocity, 0.005), velocity.len());
    says(
        PAGE,
        &format!("agrees within 0.5 % in all {},", velocity.len()),
    );
    let [hundredth, tenth] = ["hundredth", "tenth"].map(slip);
    let largest = tenth.iter().copied().fold(0.0, f64::max);
    says(
        PAGE,
        &format!(
            "by at most 3 % in {} of {} motions, Δ/10 by at most 10 % in {}, once by {:.0} %.",
            within(&hundredth, 0.03),
            hundredth.len(),
            within(&tenth, 0.1),
            100.0 * (largest - 1.0)
        ),
    );
    let vertical = ratios(&rows, "vertical", "hundredth", "slip");
    let of_sample = |sample| {
        let chosen = rows.iter().filter(|row| same(&row["sample"], sample));
        let rows: Vec<Row> = chosen.cloned().collect();
        within(&ratios(&rows, "vertical", "hundredth", "slip"), 0.05)
    };
    let [first, second] = ["1", "2"].map(of_sample);
    says(
        PAGE,
        &format!(
            "changes them by at most 5 % in {} (first twenty decks {first}, others {second} of 100).",
            within(&vertical, 0.05)
        ),
    );
    says(
        CLAIMS,
        &format!(
            "more than 5 % in {} motions of the first sample and {} of the second",
            100 - first,
            100 - second
        ),
    );
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn range_of_decks() {
    says(
        PAGE,
        "R of 0.58 to 6 m, or springs of 1.5 to 4.9 s, ν = 0.02 to 0.12, on piers of 0.2 to 0.79 s; five pairs of synthetic motions each, the stronger of 0.1 to 0.59 g.",
    );
    let rows = read("axes");
    for (name, page) in [
        ("R", [0.58, 6.0]),
        ("T", [1.5, 4.9]),
        ("nu", [0.02, 0.12]),
        ("pga", [0.1, 0.59]),
    ] {
        let found = column(&rows, name);
        let ends = [
            found.iter().copied().fold(f64::INFINITY, f64::min),
            found.iter().copied().fold(0.0, f64::max),
        ];
        for (found, page) in ends.into_iter().zip(page) {
            assert!(
                (found / page - 1.0).abs() < 0.05,
                "{name}: {found}, not {page}"
            );
        }
    }
    let piers = [column(&rows, "Tx"), column(&rows, "Ty")].concat();
    assert!(piers.iter().all(|x| (0.2..0.79).contains(x)), "{piers:?}");
}
