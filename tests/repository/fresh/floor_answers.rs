//! Numbers of docs/answers.md on the sixty pairs of buildings of studies/evidence, compared with the table of this study.

use super::answers::{Row, number};
use super::bridge_answers::{ANSWERS, median, read, says, within};
use std::collections::BTreeMap;

/// The displacements of the tops of both buildings.
const TOPS: [&str; 2] = ["peak(a3)", "peak(b3)"];

/// Sample and first period of the first building, as the table has them: a pair.
type Pair = (String, String);

/// Rows by their motion.
type Motions<'a> = BTreeMap<&'a str, &'a Row>;

/// A model over the base, of motions in which the buildings meet: both tops and the largest force of motions, and both tops of the
/// medians of pairs.
#[derive(Default)]
struct Changes {
    tops: Vec<[f64; 2]>,
    forces: Vec<f64>,
    medians: Vec<[f64; 2]>,
}

fn by_pair<'a>(rows: &'a [Row], model: &str) -> BTreeMap<Pair, Motions<'a>> {
    let mut found: BTreeMap<Pair, Motions> = BTreeMap::new();
    for row in rows.iter().filter(|row| row["model"] == model) {
        let pair = (row["sample"].clone(), row["T1"].clone());
        let motions = found.entry(pair).or_default();
        motions.insert(row["seed"].as_str(), row);
    }
    found
}

fn changes(rows: &[Row], model: &str) -> Changes {
    let (changed, unchanged) = (by_pair(rows, model), by_pair(rows, "base"));
    let mut changes = Changes::default();
    for (pair, motions) in &changed {
        let of_base = &unchanged[pair];
        let both = motions.iter().map(|(seed, row)| (*row, of_base[seed]));
        let meet: Vec<(&Row, &Row)> = both
            .filter(|(_, base)| number(base, "impulse") > 0.0)
            .collect();
        if meet.is_empty() {
            continue;
        }
        for (row, base) in &meet {
            let over = |column| number(row, column) / number(base, column);
            changes.tops.push(TOPS.map(over));
            changes.forces.push(over("force"));
        }
        let of_medians = |top| {
            let middle = median(meet.iter().map(|(row, _)| number(row, top)));
            middle / median(meet.iter().map(|(_, base)| number(base, top)))
        };
        changes.medians.push(TOPS.map(of_medians));
    }
    changes
}

/// How many have both tops within a part of the base.
fn both_within(tops: &[[f64; 2]], part: f64) -> usize {
    let near = tops.iter().filter(|tops| within(*tops, part) == 2);
    near.count()
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn stiffness_between_floors() {
    let rows = read("floors");
    let (stiff, soft) = (changes(&rows, "10 k"), changes(&rows, "k/10"));
    let [motions, pairs] = [stiff.tops.len(), stiff.medians.len()];
    assert_eq!([soft.tops.len(), soft.medians.len()], [motions, pairs]);
    let single = both_within(&stiff.tops, 0.2);
    let medians = both_within(&stiff.medians, 0.1);
    let softer = both_within(&soft.tops, 0.2);
    says(
        ANSWERS,
        &format!(
            "ten times as much changes both top displacements by at most 20 % in {single} of {motions} motions, medians by 10 % in {medians} of {pairs} pairs; a tenth by 20 % in {softer} ("
        ),
    );
    let forces = stiff.forces.iter();
    let inside = forces.filter(|x| (2.5..=4.0).contains(*x)).count();
    says(
        ANSWERS,
        &format!("for floors tenfold k gives 2.5…4 times the force in {inside} motions"),
    );
}
