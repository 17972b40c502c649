//! Results in the units of a study, compared with physics worked out by hand and with the scaled results.

use indicatif::ProgressBar;
use slipgap::batch::output::failures_and_histories::write_history;
use slipgap::batch::output::results::ResultTable;
use slipgap::batch::{self, GroupResults, Outcome};
use slipgap::figures::sheet::Sheet;
use slipgap::figures::{FigureData, ShownCases, sheet, style};
use slipgap::problem::PROBLEMS;
use slipgap::problem::numbers::unit::Dimension;
use slipgap::study::{Study, parse};

/// Few roundings in a row: scales have at most nine operations, each off by half a unit in the last place.
const ROUND_OFF: f64 = 2e-15;

const SI: &str = r#", "units": {"length": "m", "force": "N", "time": "s"}"#;

const EXACT: &str = r#", "metrics": ["peak_force_exact", "contact_duration_exact"]"#;

/// Two bars of steel, 40 m long, at 1 m/s each.
const STEEL: &str = r#""E": 2.06e11, "A": 0.01, "rho": 7850, "L": 40, "V0": 1"#;

fn bars(parameters: &str, more: &str) -> Study {
    let text = format!(
        r#"{{"problem": "bar-impact", "parameters": {{"n": 10, "dt": 0.05, "duration": 3, {parameters}}}{more}}}"#
    );
    parse("s.json", &text).unwrap()
}

/// results.csv as cells, the header first.
fn table(study: &Study) -> Vec<Vec<String>> {
    let mut table = ResultTable::new(study, Vec::new()).unwrap();
    let add = |part| {
        table.add(&part).unwrap();
        Ok(())
    };
    let bar = ProgressBar::hidden();
    batch::run(study, &bar, &batch::RunOptions::METRICS, add).unwrap();
    cells(&table.finish().unwrap())
}

fn outcomes(study: &Study) -> Vec<Outcome> {
    batch::all(study, None, &ProgressBar::hidden()).unwrap()
}

fn cells(bytes: &[u8]) -> Vec<Vec<String>> {
    let lines = std::str::from_utf8(bytes).unwrap().lines();
    lines
        .map(|line| line.split(',').map(str::to_owned).collect())
        .collect()
}

/// The numbers of a column.
#[track_caller]
fn column(table: &[Vec<String>], name: &str) -> Vec<f64> {
    let column_index = table[0]
        .iter()
        .position(|column| column == name)
        .unwrap_or_else(|| panic!("no column {name} in {:?}", table[0]));
    let cells = table[1..].iter().map(|row| row[column_index].parse());
    cells.map(|cell| cell.unwrap_or(f64::NAN)).collect()
}

#[track_caller]
fn assert_near(found: f64, wanted: f64, tolerance: f64) {
    let off = (found - wanted).abs() / wanted.abs();
    assert!(
        off <= tolerance,
        "{found} is not {wanted}: {off:e} relative"
    );
}

#[test]
fn steel_bars_have_the_force_time_and_overlap_of_a_textbook() {
    let steel = table(&bars(
        &format!("{STEEL}, \"gamma\": 1"),
        &format!("{EXACT}{SI}"),
    ));
    // To 40 digits by another program: C0 = sqrt(E/rho), T_I = 2 L/C0, and the force A rho C0 V0 that stops each end.
    let [c0, t_i, force] = [
        5_122.698_333_550_445,
        0.015_616_769_677_037_28,
        402_131.819_183_709_9,
    ];
    let one = |name: &str| column(&steel, name)[0];
    assert_near(one("peak_force_exact_in_N"), force, ROUND_OFF);
    // Two equal bars part after T_I; the exact duration is a difference of scaled times near 1.
    assert_near(one("contact_duration_exact_in_s"), t_i, ROUND_OFF);
    assert_near(
        one("contact_duration_in_s"),
        one("contact_duration") * t_i,
        ROUND_OFF,
    );
    assert_near(
        one("contact_steps_in_s"),
        one("contact_steps") * t_i,
        ROUND_OFF,
    );
    // Overlap in metres: r is over c T_I/2 with c = 2 V0 = 2 m/s; c T_I/2 is 2 L V0/C0.
    let length = 2.0 * 40.0 / c0;
    assert_near(
        one("max_overlap_in_m"),
        one("max_overlap") * length,
        ROUND_OFF,
    );
    assert_near(
        one("rms_error_r_in_m"),
        one("rms_error_r") * length,
        ROUND_OFF,
    );
    assert_near(
        one("rms_error_rdot_in_m_per_s"),
        one("rms_error_rdot") * 2.0,
        ROUND_OFF,
    );
    // The spring: its largest force is k_I times the largest overlap, both in units, k_I a parameter of the case. The
    // solver has neither: it rounds its own stiffness and force, some operations more.
    assert_near(
        one("peak_force_in_N"),
        one("k_I") * one("max_overlap_in_m"),
        1e-14,
    );
}

#[test]
fn unlike_bars_and_a_wall_have_the_force_of_the_waves() {
    // Steel at 3 m/s meets aluminium at 1 m/s. Between the waves both ends move at v: Z1 (V1 - v) = Z2 (v - V2).
    let other = r#""right": {"E": 7e10, "A": 0.02, "rho": 2700, "L": 40, "V0": 1}"#;
    let parameters =
        format!("{STEEL}, \"gamma\": 1, {other}").replace("\"V0\": 1, \"g", "\"V0\": 3, \"g");
    let unlike = table(&bars(&parameters, &format!("{EXACT}{SI}")));
    let z = |e: f64, a: f64, rho: f64| a * (e * rho).sqrt();
    let (z1, z2) = (z(2.06e11, 0.01, 7850.0), z(7e10, 0.02, 2700.0));
    let v = (z1 * 3.0 + z2) / (z1 + z2);
    // V1 - v loses a digit.
    let found = column(&unlike, "peak_force_exact_in_N")[0];
    assert_near(
        found,
        z1 * (3.0 - v) * column(&unlike, "peak_force_exact")[0],
        1e-14,
    );
    let found = column(&unlike, "rdot_oscillation_in_m_per_s")[0];
    assert_near(
        found,
        2.0 * column(&unlike, "rdot_oscillation")[0],
        ROUND_OFF,
    );

    let wall = table(&bars(
        &format!("{STEEL}, \"gamma\": 1, \"right\": \"wall\""),
        &format!("{EXACT}{SI}"),
    ));
    assert_near(column(&wall, "peak_force_exact_in_N")[0], z1, ROUND_OFF);
    assert_near(
        column(&wall, "contact_duration_exact_in_s")[0],
        80.0 / (2.06e11_f64 / 7850.0).sqrt(),
        ROUND_OFF,
    );
    let overlap = column(&wall, "max_overlap_in_m")[0];
    assert_near(
        column(&wall, "peak_force_in_N")[0],
        column(&wall, "k_I")[0] * overlap,
        1e-14,
    );
}

#[test]
fn every_case_has_its_own_scales() {
    // The scales of `scope.md` case by case, from the columns of the parameters.
    let some = r#""gamma": [0.5, 4], "E": [100, 2.06e5], "A": 2, "rho": [0.01, 7.85e-9], "L": 7, "V0": [0.1, 30]"#;
    let table = table(&bars(some, &format!("{EXACT}{SI}")));
    let of = |name: &str| column(&table, name);
    let (e, a, rho, l) = (of("E"), of("A"), of("rho"), of("L"));
    let (left, right) = (of("V0"), of("right.V0"));
    let mut compared = 0;
    for name in &table[0] {
        let Some((scaled, unit)) = name.split_once("_in_") else {
            continue;
        };
        let (scaled, found) = (of(scaled), of(name));
        for i in 0..table.len() - 1 {
            let (t_i, c) = (2.0 * l[i] * (rho[i] / e[i]).sqrt(), left[i] - right[i]);
            let scale = match unit {
                "s" => t_i,
                "m" => c * t_i / 2.0,
                "m_per_s" => c,
                "N" => c * a[i] * (e[i] * rho[i]).sqrt() / 2.0,
                other => panic!("{other}"),
            };
            assert_near(found[i], scaled[i] * scale, ROUND_OFF);
            compared += 1;
        }
    }
    // Three times, two lengths, two velocities, two forces, in 16 cases.
    assert_eq!(compared, 9 * 16);
}

#[test]
fn other_units_of_the_same_bars_give_other_numbers_for_the_same_thing() {
    let si = table(&bars(&format!("{STEEL}, \"gamma\": 2"), SI));
    // E in kN/mm^2, A in mm^2, rho in kN ms^2/mm^4, L in mm, V0 in mm/ms.
    let small = r#""E": 206, "A": 1e4, "rho": 7.85e-6, "L": 4e4, "V0": 1, "gamma": 2"#;
    let units = r#", "units": {"length": "mm", "force": "kN", "time": "ms"}"#;
    let small = table(&bars(small, units));
    for (one, other, factor) in [
        ("peak_force_in_N", "peak_force_in_kN", 1e3),
        ("contact_duration_in_s", "contact_duration_in_ms", 1e-3),
        ("max_overlap_in_m", "max_overlap_in_mm", 1e-3),
        (
            "rdot_oscillation_in_m_per_s",
            "rdot_oscillation_in_mm_per_ms",
            1.0,
        ),
    ] {
        // Parameters in other units are rounded anew.
        let wanted = factor * column(&small, other)[0];
        assert_near(column(&si, one)[0], wanted, 1e-14);
    }
}

#[test]
fn the_scaled_cells_are_the_same_with_and_without_units() {
    let parameters = format!("{STEEL}, \"gamma\": [0.5, 4], \"gap\": [0, 9]");
    let [without, with] = ["", SI].map(|more| table(&bars(&parameters, more)));
    let kept: Vec<usize> = (0..with[0].len())
        .filter(|i| !with[0][*i].contains("_in_"))
        .collect();
    let scaled = with
        .iter()
        .map(|row| kept.iter().map(|i| row[*i].clone()).collect());
    assert_eq!(scaled.collect::<Vec<Vec<String>>>(), without);
    // Each column in units follows its scaled one; a cell is empty where that one is: bars that never touch have no force.
    let index_of = |name: &str| with[0].iter().position(|column| column == name).unwrap();
    let [force, in_units] = ["peak_force", "peak_force_in_N"].map(index_of);
    assert_eq!(in_units, force + 1);
    let empty: Vec<bool> = with[1..].iter().map(|row| row[force].is_empty()).collect();
    assert_eq!(empty, [false, true, false, true]);
    for row in &with[1..] {
        assert_eq!(row[force].is_empty(), row[in_units].is_empty());
    }
}

#[test]
fn a_column_in_units_has_its_metric_solved() {
    // Metrics that are only computed where they are asked for.
    let check = r#", "checks": [{"metric": "step_error_r_in_m", "min": 0}]"#;
    let figure = r#", "figures": [{"name": "f", "kind": "metric", "x": "gamma", "y": "peak_force_exact_in_N"}]"#;
    let table = table(&bars(r#""gamma": [1, 2]"#, &format!("{SI}{check}{figure}")));
    // [I]: F0 = 0.1.
    for found in column(&table, "peak_force_exact_in_N") {
        assert_near(found, 0.1, ROUND_OFF);
    }
    assert!(column(&table, "step_error_r_in_m")[0] > 0.0);
    assert!(!table[0].iter().any(|name| name == "mesh_error_r"));
}

#[test]
fn a_result_beyond_double_precision_is_empty() {
    let fast = table(&bars(
        r#""gamma": 1, "V0": 1e300, "E": 1e20, "A": 1e20"#,
        SI,
    ));
    assert!(column(&fast, "peak_force")[0] > 1.0);
    assert!(column(&fast, "peak_force_in_N")[0].is_nan());
    assert!(column(&fast, "max_overlap_in_m")[0] > 1e280);
}

#[test]
fn histories_have_the_same_columns_in_units() {
    let study = bars(&format!("{STEEL}, \"gamma\": 1"), SI);
    let case = study.case(0).unwrap();
    let solution = study.problem.solve(&case, &[]).unwrap();
    let mut bytes = Vec::new();
    write_history(&study, &case, &solution, &mut bytes).unwrap();
    let steps = cells(&bytes);
    assert_eq!(
        steps[0].join(","),
        "t,t_in_s,r,r_in_m,rdot,rdot_in_m_per_s,force,force_in_N,r_exact,r_exact_in_m,rdot_exact,rdot_exact_in_m_per_s"
    );
    // Before the ends feel the spring they close at 2 m/s; then the force is k_I times the overlap.
    assert_eq!(column(&steps, "rdot_in_m_per_s")[0], -2.0);
    let k_i = case.number("k_I").unwrap();
    let pairs = column(&steps, "force_in_N")
        .into_iter()
        .zip(column(&steps, "r_in_m"));
    let pressing: Vec<(f64, f64)> = pairs.filter(|(force, _)| *force > 0.0).collect();
    assert!(pressing.len() > 15);
    for (force, r) in pressing {
        assert_near(force, -k_i * r, 1e-14);
    }
    let end = column(&steps, "t_in_s").pop().unwrap();
    assert_near(end, 3.0 * 80.0 / (2.06e11_f64 / 7850.0).sqrt(), ROUND_OFF);
    // Without units, the six columns alone.
    let (mut plain, study) = (Vec::new(), bars(&format!("{STEEL}, \"gamma\": 1"), ""));
    write_history(&study, &case, &solution, &mut plain).unwrap();
    assert_eq!(
        cells(&plain)[0].join(","),
        "t,r,rdot,force,r_exact,rdot_exact"
    );
}

/// The first figure of a study over all its cases.
fn drawn(study: &Study) -> Sheet {
    let outcomes = outcomes(study);
    let solved = outcomes.iter().map(|o| study.problem.solve(&o.case, &[]));
    let solutions: Vec<_> = solved.map(Result::unwrap).collect();
    let mut shown = ShownCases::new(study.problem.schema());
    for (outcome, solution) in outcomes.iter().zip(solutions) {
        shown.push(&outcome.case, &outcome.metrics, Some(solution));
    }
    sheet(&FigureData {
        study,
        figure: &study.figures[0],
        cases: &shown.all(),
        groups: &GroupResults::None,
        black: false,
        dpi: style::DPI,
    })
}

#[test]
fn a_history_figure_in_units_draws_every_case_by_its_own_scales() {
    let parameters = r#""gamma": 1, "E": [100, 400], "V0": 0.1"#;
    let figure = |more: &str| {
        let figure =
            format!(r#"{{"name": "f", "kind": "history", "y": ["r", "force", "r_error"]{more}}}"#);
        drawn(&bars(parameters, &format!("{SI}, \"figures\": [{figure}]")))
    };
    let (scaled, in_units) = (figure(""), figure(", \"in_units\": true"));
    let titles = in_units.panels.iter().map(|panel| panel.y.title.as_str());
    assert_eq!(
        titles.collect::<Vec<_>>(),
        ["*r* (m)", "*F* (N)", "*r* − *r*_exact_ (m)"]
    );
    assert_eq!(in_units.panels[2].x.title, "Time *t* (s)");
    // The defaults of [I]: T_I = 0.2, halved by four times the stiffness; c = 0.2 and F0 = E A V0/C0 = A V0 sqrt(E rho).
    let sizes = [("100", 0.2, 0.1), ("400", 0.1, 0.2)];
    for (panel, plain) in in_units.panels.iter().zip(&scaled.panels) {
        for (mark, t_i, force) in sizes {
            let of = |series: &&slipgap::figures::sheet::Series| series.label.contains(mark);
            let (one, other) = (panel.series.iter().find(of), plain.series.iter().find(of));
            let (one, other) = (one.unwrap(), other.unwrap());
            assert_eq!(one.points.len(), other.points.len());
            let y = if panel.y.title.contains("(N)") {
                force
            } else {
                0.2 * t_i / 2.0
            };
            for (found, wanted) in one.points.iter().zip(&other.points) {
                assert!((found[0] - wanted[0] * t_i).abs() <= ROUND_OFF * t_i * 3.0);
                assert!((found[1] - wanted[1] * y).abs() <= ROUND_OFF * (wanted[1] * y).abs());
            }
        }
    }
    // The slower bars end last: three times their T_I.
    assert!((in_units.panels[2].x.range[1] - 0.6).abs() < 1e-12);
    // The exact lines reach as far, both.
    let exact = in_units.panels[0]
        .series
        .iter()
        .filter(|s| s.label == "exact");
    let ends: Vec<f64> = exact.map(|s| s.points.last().unwrap()[0]).collect();
    assert_eq!(ends.len(), 2);
    assert!(ends.iter().all(|end| (end - 0.6).abs() < 1e-12), "{ends:?}");
}

#[test]
fn a_metric_figure_shows_the_unit() {
    let figure = r#", "figures": [{"name": "f", "kind": "metric", "x": "V0", "y": ["peak_force_in_N", "rdot_oscillation_in_m_per_s"]}]"#;
    let study = bars(
        r#""gamma": 1, "V0": [0.1, 0.2]"#,
        &format!(r#", "metrics": ["peak_force_exact"]{SI}{figure}"#),
    );
    let sheet = drawn(&study);
    assert_eq!(sheet.panels[0].y.title, "peak of *F* (N)");
    assert_eq!(sheet.panels[1].y.title, "rms of *ṙ* in contact (m/s)");
    // The scaled peak is one number; the force rises with the velocity. The exact one is A V0 sqrt(E rho) = V0.
    let of = |label: &str| sheet.panels[0].series.iter().find(|s| s.label == label);
    let exact = &of("exact").unwrap().points;
    assert_eq!(exact.len(), 2);
    for point in exact {
        assert_near(point[1], point[0], ROUND_OFF);
    }
}

#[test]
fn every_unit_of_a_table_is_known_and_can_be_taken_out_of_symbols() {
    for problem in PROBLEMS.iter() {
        for metric in problem.metrics() {
            // The name of a column in units can be told from all others.
            assert!(!metric.name.contains("_in_"), "{}", metric.name);
            let mut units = problem.schema().units.iter();
            let Some(unit) = units.find(|unit| unit.name == metric.unit) else {
                assert_eq!(metric.unit, "1", "{}", metric.name);
                continue;
            };
            let count = metric.symbol.matches(&*unit.over).count();
            assert_eq!(count, 1, "{} {}", metric.name, metric.symbol);
        }
        let over = |dimension: Dimension| {
            problem
                .schema()
                .units
                .iter()
                .find(|u| u.dimension == dimension)
        };
        for quantity in problem.schema().quantities.iter() {
            if let Some(unit) = over(problem.schema().channels[quantity.channel].dimension) {
                let error = quantity.name.ends_with("_error");
                assert_eq!(
                    quantity.title.matches(&*unit.over).count(),
                    usize::from(!error)
                );
            }
        }
        if let Some(unit) = over(Dimension::Time) {
            assert_eq!(problem.schema().time.title.matches(&*unit.over).count(), 1);
        }
    }
}
