//! Numbers of docs/findings-structures.md on the indices of a population of bridges, and on further samples.

use super::answers::{Row, table};
use super::bridge_answers::{PAGE, median, read, says};
use std::collections::BTreeMap;

/// The 95 % intervals of the total index of a factor of a metric, in both samples.
fn totals(rows: &[Row], metric: &str, factor: &str) -> [[f64; 2]; 2] {
    ["0", "1"].map(|block| {
        let is_chosen = |row: &&Row| {
            row["block"] == block && row["metric"] == metric && row["parameter"] == factor
        };
        let row = rows.iter().find(is_chosen).unwrap();
        ["total_low", "total_high"].map(|column| row[column].parse().unwrap())
    })
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn what_decides_in_the_population() {
    const METRICS: [&str; 4] = ["largest", "first", "force", "impacts"];
    let rows = table("evidence/evidence-sobol/sobol.csv");
    for (name, factor) in [
        ("bridge", "bridge"),
        ("motion", "ground"),
        ("gap", "gap"),
        ("k", "kappa"),
    ] {
        let cell = |metric| {
            let ends = totals(&rows, metric, factor).map(|[low, high]| {
                let digits = if high < 0.1 { 3 } else { 2 };
                format!("{low:.digits$}–{high:.digits$}")
            });
            ends.join("; ")
        };
        says(
            PAGE,
            &format!("| {name} | {} |", METRICS.map(cell).join(" | ")),
        );
    }
    for (name, factors) in [("e", &["e"][..]), ("step, N", &["finer", "vertical"])] {
        let cell = |metric| {
            let of = factors
                .iter()
                .flat_map(|factor| totals(&rows, metric, factor));
            format!("≤ {:.3}", of.map(|ends| ends[1]).fold(0.0, f64::max))
        };
        says(
            PAGE,
            &format!("| {name} | {} |", METRICS.map(cell).join(" | ")),
        );
    }
    let index = |block: &str, metric: &str, factor: &str, column: &str| -> f64 {
        let found = rows.iter().find(|row| {
            row["block"] == block && row["metric"] == metric && row["parameter"] == factor
        });
        found.unwrap()[column].parse().unwrap()
    };
    // The order of motion and gap for the first seat was another one in the second sample, and with 64 points of another design.
    says(
        PAGE,
        "**The bridge decides seats most, then the motion, for the first seat also the gap; bridge, motion and k the force.**",
    );
    let (mut bridge, mut gap) = (Vec::new(), Vec::new());
    for block in ["0", "1"] {
        let total = |metric, factor| index(block, metric, factor, "total");
        let largest = ["bridge", "ground", "gap", "kappa"].map(|factor| total("largest", factor));
        assert!(largest.is_sorted_by(|a, b| a > b), "{block}: {largest:?}");
        for seat in ["largest", "first"] {
            for factor in ["ground", "gap"] {
                assert!(
                    total(seat, "bridge") > total(seat, factor),
                    "{block}: {factor}"
                );
                assert!(
                    total(seat, factor) > total(seat, "kappa"),
                    "{block}: {factor}"
                );
            }
            assert!(total(seat, "kappa") < 0.02, "{block}: {seat}");
            for factor in ["finer", "e", "vertical"] {
                assert!(total(seat, factor) < 0.01, "{block}: {factor}");
            }
            bridge.push(index(block, seat, "bridge", "first_order"));
            gap.push(index(block, seat, "gap", "first_order"));
        }
        for factor in ["bridge", "ground", "kappa"] {
            assert!(
                total("force", factor) > total("force", "gap"),
                "{block}: {factor}"
            );
        }
    }
    bridge.sort_by(f64::total_cmp);
    let most = gap.into_iter().fold(0.0, f64::max);
    says(
        PAGE,
        &format!(
            "explains {:.2} to {:.2} of seats, the gap at most {most:.2}.",
            bridge[0], bridge[3]
        ),
    );
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn further_samples_of_the_law_of_joints() {
    // The fourth sample, and bridges under recorded motions, by sample and length of the first girder.
    let mut counts = [[0, 0]; 2];
    for (rows, sample, motion) in [
        (read("bridges"), 4.0, "seed"),
        (read("recorded"), 1.0, "record"),
    ] {
        for (count, metric, range) in [(0, "force", 0.8..=1.05), (1, "impacts", 0.9..=1.1)] {
            let medians = |model: &str| {
                let mut found: BTreeMap<&str, BTreeMap<&str, f64>> = BTreeMap::new();
                for row in &rows {
                    let of: f64 = row["sample"].parse().unwrap();
                    if of == sample && row["model"] == model {
                        let values = found.entry(&row["L"]).or_default();
                        values.insert(&row[motion], row[metric].parse().unwrap());
                    }
                }
                let medians = found
                    .into_iter()
                    .map(|(bridge, values)| (bridge, median(values.into_values())));
                medians.collect::<BTreeMap<&str, f64>>()
            };
            let base = medians("base");
            for (bridge, x) in medians("e = 0.65") {
                let ratio = x / base[bridge];
                counts[count][0] += usize::from(range.contains(&ratio));
                counts[count][1] += usize::from(ratio.is_finite());
            }
        }
    }
    let [[force, of_force], [impacts, of_impacts]] = counts;
    assert_eq!(of_force, of_impacts);
    says(
        PAGE,
        &format!(
            "and {force} of {of_force} further ones, its number of impacts within 10 % in 36 and {impacts}."
        ),
    );
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn a_curved_bridge() {
    let rows = read("curved");
    let number = |row: &Row, metric: &str| row[metric].parse::<f64>().unwrap();
    // The smallest and the largest value of a metric over that of the base with the same motion.
    let ends = |model: &str, metric: &str| {
        let ratios = rows.iter().filter(|row| row["model"] == model).map(|row| {
            let is_base = |base: &&Row| base["model"] == "base" && base["motion"] == row["motion"];
            number(row, metric) / number(rows.iter().find(is_base).unwrap(), metric)
        });
        let ratios: Vec<f64> = ratios.collect();
        assert_eq!(ratios.len(), 6);
        let [least, largest] = [f64::INFINITY, f64::NEG_INFINITY];
        ratios
            .iter()
            .fold([least, largest], |[a, b], x| [a.min(*x), b.max(*x)])
    };
    says(
        PAGE,
        "ten times k keeps its bearings within 5 % and openings within 25 %, e = 0.65 within 10 and 20 %,",
    );
    for (model, metric, part) in [
        ("10 k", "seat", 0.05),
        ("10 k", "opening", 0.25),
        ("e = 0.65", "seat", 0.1),
        ("e = 0.65", "opening", 0.2),
    ] {
        let [least, largest] = ends(model, metric);
        assert!(
            least >= 1.0 - part && largest <= 1.0 + part,
            "{model}, {metric}"
        );
    }
    let [[a, b], [c, d]] = ["10 k", "e = 0.65"].map(|model| ends(model, "force"));
    says(
        PAGE,
        &format!("forces at {a:.1} to {b:.1} and {c:.1} to {d:.1} times."),
    );
}
