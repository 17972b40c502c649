//! Numbers of docs/findings-structures.md on the forty bridges of studies/evidence, compared with the tables of these studies.

use super::answers::{Row, same, table};
use std::collections::BTreeMap;

pub(super) const PAGE: &str = include_str!("../../../docs/findings-structures.md");
pub(super) const ANSWERS: &str = include_str!("../../../docs/answers.md");

/// Sample and length of the first girder, as the table has them: a bridge.
type Bridge = (String, String);

/// A metric of a model over that of another one: of motions, and of medians of bridges.
struct Ratios {
    motions: Vec<f64>,
    bridges: Vec<f64>,
}

pub(super) fn read(study: &str) -> Vec<Row> {
    table(&format!("evidence/evidence-{study}/results.csv"))
}

/// The values of a metric by bridge and motion, of the first two samples.
fn by_bridge(
    rows: &[Row],
    at: (&str, &str),
    metric: &str,
) -> BTreeMap<Bridge, BTreeMap<String, f64>> {
    let mut found: BTreeMap<Bridge, BTreeMap<String, f64>> = BTreeMap::new();
    for row in rows {
        let sample: f64 = row["sample"].parse().unwrap();
        if same(&row[at.0], at.1) && sample < 3.0 {
            let name = if row.contains_key("L") { "L" } else { "T1" };
            let bridge = (row["sample"].clone(), row[name].clone());
            let value = row[metric].parse().unwrap();
            let of_bridge = found.entry(bridge).or_default();
            of_bridge.insert(row["seed"].clone(), value);
        }
    }
    found
}

pub(super) fn median(values: impl Iterator<Item = f64>) -> f64 {
    let mut rising: Vec<f64> = values.collect();
    rising.sort_by(f64::total_cmp);
    let middle = rising.len() / 2;
    (rising[middle] + rising[(rising.len() - 1) / 2]) / 2.0
}

fn ratios(rows: &[Row], [key, value, base]: [&str; 3], metric: &str) -> Ratios {
    let [changed, unchanged] = [value, base].map(|value| by_bridge(rows, (key, value), metric));
    let (mut motions, mut bridges) = (Vec::new(), Vec::new());
    for (bridge, of_changed) in &changed {
        let of_base = &unchanged[bridge];
        // The finest step has some of the motions.
        let pairs = of_changed
            .iter()
            .filter_map(|(seed, x)| Some((*x, *of_base.get(seed)?)));
        let pairs: Vec<(f64, f64)> = pairs.collect();
        motions.extend(pairs.iter().map(|(x, base)| x / base));
        let middle = median(pairs.iter().map(|(x, _)| *x));
        bridges.push(middle / median(pairs.iter().map(|(_, base)| *base)));
    }
    // Without impact there is no force to divide by.
    motions.retain(|x| x.is_finite());
    bridges.retain(|x| x.is_finite());
    Ratios { motions, bridges }
}

pub(super) fn within(ratios: &[f64], part: f64) -> usize {
    let near = ratios.iter().filter(|x| (**x - 1.0).abs() <= part);
    near.count()
}

/// The value below which a part of the changes is, in per cent as the page writes it.
fn percent(ratios: &[f64], part: f64) -> String {
    let mut changes: Vec<f64> = ratios.iter().map(|x| 100.0 * (x - 1.0).abs()).collect();
    changes.sort_by(f64::total_cmp);
    let at = part * (changes.len() - 1) as f64;
    let (low, share) = (at.floor() as usize, at.fract());
    let high = changes[(low + 1).min(changes.len() - 1)];
    let x = changes[low] + share * (high - changes[low]);
    if x >= 1.0 {
        format!("{x:.0}")
    } else {
        format!("{x:.1}")
    }
}

#[track_caller]
pub(super) fn says(page: &str, piece: &str) {
    assert!(page.contains(piece), "not on the page: {piece}");
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn what_decides() {
    let rows = read("bridges");
    let impulse = |model| {
        percent(
            &ratios(&rows, ["model", model, "base"], "impulse").motions,
            0.5,
        )
    };
    let [less, more] = ["gap -20 %", "gap +20 %"].map(impulse);
    says(PAGE, &format!("change by {more} to {less} %"));
    // The scatter of the motions of one bridge.
    let scatter = |metric| {
        let of_bridge = by_bridge(&rows, ("model", "base"), metric).into_values();
        let deviations = of_bridge.filter_map(|motions| {
            let logs: Vec<f64> = motions
                .values()
                .filter(|x| **x > 0.0)
                .map(|x| x.ln())
                .collect();
            let count = logs.len() as f64;
            let mean = logs.iter().sum::<f64>() / count;
            let squares: f64 = logs.iter().map(|x| (x - mean).powi(2)).sum();
            (logs.len() > 1).then(|| (squares / (count - 1.0)).sqrt())
        });
        median(deviations)
    };
    let [seat, force] = ["seat", "force"].map(scatter);
    says(PAGE, &format!("scatter by {seat:.2} and {force:.2}"));
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn stiffness_of_the_gap() {
    let rows = read("bridges");
    let of = |model, metric| ratios(&rows, ["model", model, "base"], metric);
    let (seat, first, soft) = (
        of("100 EA/L", "seat"),
        of("100 EA/L", "peak(b1.r)"),
        of("1 EA/L", "seat"),
    );
    says(
        PAGE,
        &format!(
            "at most 10 % in {} of 40 bridges, of the first one in {}; {} of 200 motions stay within 10 %",
            within(&seat.bridges, 0.1),
            within(&first.bridges, 0.1),
            within(&seat.motions, 0.1)
        ),
    );
    let [tenth, fifth] = [0.1, 0.2].map(|part| within(&soft.bridges, part));
    says(
        PAGE,
        &format!("only {tenth} bridges stay within 10 %, {fifth} within 20 %"),
    );
    let [coarse, fine] = ["n = 5", "n = 20"].map(|model| within(&of(model, "seat").bridges, 0.1));
    says(
        PAGE,
        &format!("With n = 5 and 20 instead of 10 within 10 % are {coarse} and {fine}."),
    );
    let largest = within(&seat.bridges, 0.1);
    says(
        ANSWERS,
        &format!("at most 10 % in {largest} of 40 bridges, EA/L in {tenth}"),
    );
    // Nine of ten forces are in these ranges.
    for (model, low, high, piece) in [
        (
            "100 EA/L",
            2.95,
            4.55,
            "100 EA/L give 3.0 to 4.5 times the force in nine of ten motions",
        ),
        ("1 EA/L", 0.55, 1.05, "EA/L 0.6 to 1.0 times"),
    ] {
        says(PAGE, piece);
        let force = of(model, "force").motions;
        let inside = force.iter().filter(|x| (low..=high).contains(*x)).count();
        assert!(
            10 * inside >= 9 * force.len(),
            "{model}: {inside} of {}",
            force.len()
        );
    }
    let impacts = of("100 EA/L", "impacts").motions;
    assert!(impacts.iter().all(|x| *x >= 5.0), "{impacts:?}");
    // Motions whose first seat changes by more than 10 %, by the number of impacts.
    let [changed, base] =
        ["100 EA/L", "base"].map(|model| by_bridge(&rows, ("model", model), "peak(b1.r)"));
    let mut counts = [[0, 0]; 2];
    for (bridge, motions) in by_bridge(&rows, ("model", "base"), "impacts") {
        for (seed, impacts) in motions {
            let ratio = changed[&bridge][&seed] / base[&bridge][&seed];
            let group = &mut counts[usize::from(impacts <= 30.0)];
            group[0] += usize::from((ratio - 1.0).abs() > 0.1);
            group[1] += 1;
        }
    }
    let [[often, of_often], [seldom, of_seldom]] = counts;
    says(
        PAGE,
        &format!("in {often} of {of_often} motions, otherwise in {seldom} of {of_seldom}"),
    );
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn steps() {
    let rows = read("step");
    let of = |m, base, metric| ratios(&rows, ["m", m, base], metric);
    let (seat, first) = (of("40", "160", "seat"), of("40", "160", "peak(b1.r)"));
    let [bridges, motions] = [&seat.bridges, &seat.motions].map(|x| within(x, 0.05));
    let first = within(&first.bridges, 0.05);
    says(
        PAGE,
        &format!(
            "in {bridges} of 40 bridges and {motions} of 200 motions; of the first seat {first} bridges"
        ),
    );
    says(
        ANSWERS,
        &format!("within 5 % in {motions} of 200 motions of forty bridges"),
    );
    let fine = within(&of("160", "320", "force").motions, 0.02);
    let of_fine = of("160", "320", "force").motions.len();
    let force = of("40", "160", "force");
    let [bridges, motions] = [within(&force.bridges, 0.05), within(&force.motions, 0.1)];
    says(
        PAGE,
        &format!(
            "within 2 % of half that step in {fine} of {of_fine} motions; T_I/40 within 5 % in {bridges} of {} bridges, within 10 % in {motions} of {} motions",
            force.bridges.len(),
            force.motions.len()
        ),
    );
    says(
        ANSWERS,
        &format!("forces within 2 % in {fine} of {of_fine}"),
    );
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn histories_that_repeat() {
    let rows = read("repeats");
    for (name, axial) in [("3 %", "0.03"), ("none", "0")] {
        let number = |row: &Row, column: &str| row[column].parse::<f64>().unwrap();
        let count = |chosen: &dyn Fn(&Row) -> bool| {
            let of_damping = rows
                .iter()
                .filter(|row| same(&row["axial"], axial) && chosen(row));
            let repeats = of_damping
                .clone()
                .filter(|row| number(row, "difference(g1.right)") <= 0.01);
            format!("{} of {}", repeats.count(), of_damping.count())
        };
        let cells = [
            count(&|row| number(row, "impacts") <= 100.0),
            count(&|row| number(row, "impacts") > 100.0),
            count(&|row| same(&row["pga"], "0.3")),
            count(&|row| same(&row["pga"], "0.6")),
        ];
        says(PAGE, &format!("| {name} | {} |", cells.join(" | ")));
    }
}

#[test]
#[ignore = "reads the results of the evidence; run by `make fresh` and `make evidence`"]
fn laws_of_joints_and_bearings() {
    let rows = read("bridges");
    let of = |model, metric| ratios(&rows, ["model", model, "base"], metric);
    let (seat, first) = (
        of("velocity-control", "seat"),
        of("velocity-control", "peak(b1.r)"),
    );
    let [bridges, motions] = [within(&seat.bridges, 0.02), within(&first.motions, 0.05)];
    says(
        PAGE,
        &format!(
            "within 2 % in {bridges} of 40 bridges, the first seat within 5 % in {motions} of 200 motions"
        ),
    );
    let [largest, first] =
        ["seat", "peak(b1.r)"].map(|metric| within(&of("r_E = 0.5 mm", metric).bridges, 0.1));
    says(
        PAGE,
        &format!("r^E = 0.5 mm: largest seats within 10 % in {largest}, first seats in {first}."),
    );
    let [largest, first] =
        ["seat", "peak(b1.r)"].map(|metric| within(&of("e = 0.65", metric).bridges, 0.1));
    let motions = within(&of("e = 0.65", "seat").motions, 0.1);
    says(
        PAGE,
        &format!(
            "within 10 % in {largest} and {first} of 40 bridges, the largest seat in {motions} of 200 motions"
        ),
    );
    let force = of("e = 0.65", "force").bridges;
    let inside = force.iter().filter(|x| (0.8..=1.05).contains(*x)).count();
    let impacts = within(&of("e = 0.65", "impacts").bridges, 0.1);
    says(
        PAGE,
        &format!(
            "in {inside} of {} bridges and 30 of 32 further ones, its number of impacts within 10 % in {impacts}",
            force.len()
        ),
    );
    let beyond = |metric, part| {
        ["gap -20 %", "gap +20 %"]
            .map(|model| 40 - within(&of(model, metric).bridges, part))
            .into_iter()
            .max()
            .unwrap()
    };
    let (first, largest) = (beyond("peak(b1.r)", 0.1), beyond("seat", 0.2));
    says(
        PAGE,
        &format!(
            "by more than 10 % in {first} of 40 bridges, of the largest seat by more than 20 % in at most {largest}"
        ),
    );
    let rows = read("friction");
    let (mut small, mut medium, mut medians, mut motions) = (0, 0, 0, 0);
    for metric in ["last_error(bearing1.slip)", "last_error(bearing2.slip)"] {
        let errors = |law| {
            by_bridge(&rows, ("law", law), metric)
                .into_values()
                .flat_map(BTreeMap::into_values)
        };
        small += errors("velocity-control").filter(|x| *x <= 0.04).count();
        medium += errors("displacement-control")
            .filter(|x| *x <= 0.15)
            .count();
        let over = ratios(
            &rows,
            ["law", "displacement-control", "velocity-control"],
            metric,
        );
        motions += over.motions.iter().filter(|x| **x >= 1.0).count();
        medians += over.bridges.iter().filter(|x| **x >= 1.0).count();
    }
    says(PAGE, &format!("at most 4 % of Δ in {small} of 400"));
    says(
        PAGE,
        &format!(
            "by at most 15 % in {medium}; it errs more in {medians} of 80 medians, in {motions} of 400"
        ),
    );
}
