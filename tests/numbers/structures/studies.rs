//! Studies of structures: the format of the document, its faults, and the agreement of the ways to solve them.

use slipgap::problem::table::cases::Cases;
use slipgap::study::{self, Study};
use std::fs;
use std::path::Path;

/// A study in the format of docs/structures.md, with every part that it describes.
const EXAMPLE: &str = r#"{ "problem": "structure",
"parameters": { "gamma": {"geomspace": [0.0625, 4, 13]}, "gap": [0.01, 0.02], "n": 10, "L": 40, "EA": 1.5e8, "k_I": "gamma*n*EA/L", "dt": 0.001, "duration": 20 },
"structure": {
  "units": "t, kN, m, s",
  "masses":   { "p1": 100, "p2": 100 },
  "bars":     { "g1|g2": { "L": "L", "EA": "EA", "mass": 500, "n": "n", "stiffness_damping": 1.5e-4 } },
  "springs":  [ { "between": ["ground", "p1"], "mass": 600, "period": 1.0, "ratio": 0.05 }, { "between": ["p1", "g1.left"], "k": 2e6, "c": 0 } ],
  "rayleigh": { "mass": 0, "stiffness": 0 },
  "contacts": { "gap12": { "law": "impact", "between": ["g1.right", "g2.left"], "gap": "gap", "k": "k_I" },
                "bearing": { "law": "displacement-control", "between": ["p2", "g1.right"], "nu": 0.1, "N": 2450, "rE": 0.0005 } },
  "loads":    [ { "at": "p1", "sine": { "amplitude": 1, "omega": 2, "phase": 0 } } ],
  "ground":   { "record": "records/name.AT2", "unit": "g", "scale": 1 },
  "start":    { "g1": { "v": 0.1 } },
  "contacts_reference": "softened"
},
"metrics": ["peak(g1.right - p2)", "impacts(gap12)", "energy_error"] }"#;

/// A folder with the study and a record of its own, of which the last value is `last`.
fn folder(last: f64) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    fs::create_dir(folder.path().join("records")).unwrap();
    let record = format!(
        "TITLE\nSTATION\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS=   4, DT=   .0100 SEC\n 0.0 0.1 -0.2 {last}\n"
    );
    fs::write(folder.path().join("records/name.AT2"), record).unwrap();
    folder
}

fn read(folder: &Path, text: &str) -> Result<Study, String> {
    let file = folder.join("study.json");
    fs::write(&file, text).unwrap();
    study::read(&file).map_err(|fault| fault.to_string())
}

#[test]
fn the_example_of_the_format_is_read() {
    let folder = folder(0.0);
    let study = read(folder.path(), EXAMPLE).unwrap();
    assert_eq!(study.len(), 26);
    let case = study.case(24).unwrap();
    assert_eq!(case.number("k_I"), Some(4.0 * 10.0 * 1.5e8 / 40.0));
    let names: Vec<&str> = study.problem.metrics().iter().map(|m| &*m.name).collect();
    assert_eq!(
        names,
        ["peak(g1.right - p2)", "impacts(gap12)", "energy_error"]
    );
    let text = study
        .problem
        .as_structure()
        .unwrap()
        .description(&case)
        .unwrap();
    // Two masses of 100 and two bars of 500 with 11 nodes each.
    assert!(
        text.contains("24 nodes, total mass 1200, 2 contacts"),
        "{text}"
    );
    assert!(text.contains("nothing holds g2.left to g2.right"), "{text}");
    // Two nodes of 25 on k = 1.5e8: pi sqrt(12.5/1.5e8) = 9.069e-4, 0.9 of a step of 1e-3.
    let touch = "its nodes touch for 9.069e-4 = 0.9 steps; too few for its force";
    assert!(text.contains(touch), "{text}");
    let columns: Vec<String> = study
        .problem
        .history_columns(&case)
        .iter()
        .map(|column| column.column.name.to_string())
        .collect();
    assert_eq!(columns.len(), 2 * 24 + 3 * 2);
    assert_eq!(columns[..3], ["p1.u", "p1.v", "p2.u"]);
    assert_eq!(columns[columns.len() - 1], "bearing.S");
}

#[test]
fn every_fault_has_its_place_and_says_what_is_allowed() {
    let folder = folder(0.0);
    for (from, to, path, message) in [
        (
            "\"gap\": [",
            "\"unused\": 1, \"gap\": [",
            "2:58: parameters.unused",
            "is not used",
        ),
        (
            "\"gap\": [",
            "\"sin\": 1, \"gap\": [",
            "2:58: parameters.sin",
            "has a meaning in expressions",
        ),
        (
            "\"EA\": \"EA\"",
            "\"EA\": \"EB\"",
            "structure.bars.g1|g2.EA",
            "unknown name \"EB\"",
        ),
        (
            "\"p1\", \"g1.left\"",
            "\"p7\", \"g1.left\"",
            "springs[1].between[0]",
            "unknown node \"p7\"",
        ),
        (
            "[\"p2\", \"g1.right\"]",
            "[\"p2\", \"g1.10\"]",
            "bearing.between[1]",
            "inner nodes 1 to 9, got 10",
        ),
        (
            "\"p2\": 100",
            "\"p2\": -1",
            "5:34: structure.masses.p2",
            "must be >= 0, got -1",
        ),
        (
            "\"n\": \"n\"",
            "\"n\": \"n - 10\"",
            "structure.bars.g1|g2.n",
            "must be > 0",
        ),
        (
            "\"n\": \"n\"",
            "\"n\": \"n/4\"",
            "structure.bars.g1|g2.n",
            "whole number",
        ),
        (
            "[\"g1.right\", \"g2.left\"]",
            "[\"g1.right\", \"g1.right\"]",
            "gap12.between",
            "two different nodes",
        ),
        (
            "[\"g1.right\", \"g2.left\"]",
            "[\"g1.right\", \"g1.10\"]",
            "gap12.between[1]",
            "inner nodes 1 to 9",
        ),
        (
            "records/name.AT2",
            "records/none.AT2",
            "12:27: structure.ground.record",
            "cannot read",
        ),
        (
            "\"unit\": \"g\"",
            "\"unit\": \"gal\"",
            "structure.ground.unit",
            "allowed: g, m/s2, cm/s2, mm/s2",
        ),
        (
            "\"unit\": \"g\"",
            "\"unit\": \"m/s2\"",
            "structure.ground.unit",
            "the file is in g",
        ),
        (
            "\"sine\": { \"amplitude\": 1, \"omega\": 2, \"phase\": 0 }",
            "\"table\": {\"t\": [1, 0], \"f\": [1, 2]}",
            "structure.loads[0]",
            "times must rise",
        ),
        (
            "\"law\": \"impact\"",
            "\"law\": \"coulomb\"",
            "gap12.k",
            "has no k",
        ),
        (
            "\"rE\": 0.0005",
            "\"rE\": 0.0005, \"k\": 1",
            "bearing.rE",
            "give k or rE, not both",
        ),
        (
            ", \"rE\": 0.0005",
            "",
            "structure.contacts.bearing",
            "needs k or rE",
        ),
        (
            "\"g1\": { \"v\"",
            "\"g3\": { \"v\"",
            "structure.start.g3",
            "unknown node \"g3\"",
        ),
        (
            "\"t, kN, m, s\"",
            "\"t, kN, ell, s\"",
            "structure.units",
            "length in m, mm, cm, km, ft or in",
        ),
        (
            "\"t, kN, m, s\"",
            "\"kg, kN, mm, s\"",
            "4:12: structure.units",
            "kg mm/s^2 is mN, 0.001 N, not kN; give \"kg, mN, mm, s\"",
        ),
        (
            "\"unit\": \"g\"",
            "\"mean\": \"off\"",
            "structure.ground.mean",
            "allowed: removed, kept",
        ),
        (
            "\"softened\"",
            "\"soft\"",
            "contacts_reference",
            "did you mean \"softened\"",
        ),
        (
            "impacts(gap12)",
            "impacts(gap13)",
            "metrics[1]",
            "no contact 'gap13'",
        ),
        (
            "g1.right - p2)",
            "g1.right - p5)",
            "metrics[0]",
            "no node or contact 'p5'",
        ),
        ("\"dt\": 0.001, ", "", "parameters.dt", "missing"),
        (
            "\"problem\": \"structure\"",
            "\"problem\": \"structures\"",
            "1:14: problem",
            "did you mean \"structure\"",
        ),
        (
            "{ \"at\": \"p1\"",
            "{ \"at\": \"ground\"",
            "structure.loads[0].at",
            "the ground does not move",
        ),
        (
            "\"g1\": { \"v\"",
            "\"ground\": { \"v\"",
            "structure.start.ground",
            "the ground does not move",
        ),
        (
            "\"gap\": \"gap\", \"k\": \"k_I\"",
            "\"gap\": \"-gap\", \"e\": \"k_I/k_I\"",
            "structure.contacts.gap12",
            "must start with r >= 0, got -0.01",
        ),
    ] {
        assert!(EXAMPLE.contains(from), "{from}");
        let text = EXAMPLE.replacen(from, to, 1);
        let faults = read(folder.path(), &text).unwrap_err();
        assert!(
            faults.contains(path) && faults.contains(message),
            "{from} -> {to}: {faults}"
        );
    }
}

#[test]
fn the_bytes_of_a_record_belong_to_the_results_and_remarks_do_not() {
    let identity = |last: f64, text: &str| {
        let folder = folder(last);
        let study = read(folder.path(), text).unwrap();
        study.problem.as_structure().unwrap().identity().to_owned()
    };
    let as_given = identity(0.0, EXAMPLE);
    let remark = EXAMPLE.replace("\"units\":", "\"//\": \"a remark\",\n  \"units\":");
    assert_eq!(identity(0.0, &remark), as_given);
    assert_ne!(identity(0.25, EXAMPLE), as_given);
    let stiffer = EXAMPLE.replace("\"k\": 2e6", "\"k\": 3e6");
    assert_ne!(identity(0.0, &stiffer), as_given);
}

fn parse(text: &str) -> Study {
    study::parse("study.json", text).unwrap()
}

#[test]
fn one_mass_with_friction_is_the_friction_oscillator() {
    // In the oscillator's scales mass, stiffness and limit are 1. Round-off of 400 steps of numbers up to 12, and of S, which is a
    // difference of numbers up to 12 over alpha = 0.1.
    for (law, key, width) in [
        ("displacement-control", "alpha", "\"rE\": 0.1"),
        ("velocity-control", "beta", "\"rdotE\": 0.1"),
    ] {
        let time = "\"duration\": \"8*pi\"";
        let oscillator = parse(&format!(
            r#"{{"problem": "friction-oscillator", "parameters": {{"law": "{law}", "{key}": 0.1, "dT": "pi/50", {time}}}}}"#
        ));
        let structure = parse(&format!(
            r#"{{"problem": "structure", "parameters": {{"dt": "pi/50", {time}}}, "structure": {{"masses": {{"x": 1}},
                "springs": [{{"between": ["ground", "x"], "k": 1}}], "start": {{"x": {{"u": 12}}}},
                "contacts": {{"f": {{"law": "{law}", "between": ["ground", "x"], "limit": 1, {width}}}}}}},
                "metrics": ["peak(x)"], "figures": [{{"name": "h", "kind": "history", "y": ["x", "x.v", "f.S"]}}]}}"#
        ));
        let solve = |study: &Study| {
            let case = study.case(0).unwrap();
            study.problem.solve(&case, &[]).unwrap().computed
        };
        let (expected, found) = (solve(&oscillator), solve(&structure));
        assert_eq!(expected.len(), 401);
        for channel in 0..3 {
            for (a, b) in expected.channel(channel).iter().zip(found.channel(channel)) {
                assert!((a - b).abs() < 1e-11, "{law} {channel}: {a} {b}");
            }
        }
    }
}

#[test]
fn a_sweep_has_the_bits_of_single_cases_whatever_its_order() {
    // n changes the linear part, the others do not; 23 cases of a kind do not fill the lanes.
    let study = parse(
        r#"{"problem": "structure", "parameters": {"scale": {"linspace": [0.1, 2.3, 23]}, "n": [1, 3], "law":
            ["displacement-control", "velocity-control", "coulomb"], "dt": 0.01, "duration": 3},
            "structure": {"masses": {"p": 2}, "bars": {"b": {"L": 1, "EA": 300, "mass": 1, "n": "n"}},
            "springs": [{"between": ["ground", "p"], "k": 50, "c": 0.3}],
            "contacts": {"slide": {"law": "law", "between": ["p", "b.left"], "limit": 0.4, "rE": 0.002, "rdotE": 0.01},
                         "stop": {"law": "impact", "between": ["b.right", "ground"], "gap": 0.05, "k": 700}},
            "ground": {"sine": {"amplitude": 1, "omega": 5}, "scale": "scale"}},
            "metrics": ["peak(p)", "rms(b.right.v)", "impacts(stop)", "impulse(stop)", "contact_time(stop)", "open_time(stop)",
                        "work(slide)", "residual_slip(slide)", "time_of_peak(p)", "last(b.left - p)", "min(slide.S)", "max(stop.r)",
                        "divergence(p, 1e-9)", "energy_error"]}"#,
    );
    assert_eq!(study.len(), 138);
    let mut cases = Cases::new(study.problem.schema());
    study.cases().for_each(|case| cases.push(&case));
    let rows: Vec<u32> = (0..138).rev().collect();
    let table = study.problem.sweep(&cases, &rows);
    for (row_number, row) in rows.iter().enumerate() {
        let case = study.case(u64::from(*row)).unwrap();
        let alone = study.problem.solve(&case, &[]).unwrap().metrics;
        let swept: Vec<Option<f64>> = table.row(row_number).collect();
        let bits = |metrics: &[Option<f64>]| -> Vec<Option<u64>> {
            metrics.iter().map(|x| x.map(f64::to_bits)).collect()
        };
        assert_eq!(bits(&swept), bits(&alone), "case {row}");
        let energy_error = alone[13].unwrap();
        assert!(energy_error < 1e-13, "case {row}: {energy_error}");
    }
}

/// A mass between a stop and friction, by `method`.
fn by(method: &str, dt: f64, stop: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"method": {method}, "scale": {{"linspace": [0.5, 2, 17]}}, "dt": {dt}, "duration": 3}},
            "structure": {{"masses": {{"p": 2}}, "springs": [{{"between": ["ground", "p"], "k": 50, "c": 0.3}}],
            "contacts": {{"slide": {{"law": "displacement-control", "between": ["ground", "p"], "limit": 0.4, "rE": 0.002}},
                         "stop": {{"law": "impact", "between": ["p", "ground"], "gap": 0.02, {stop}}}}},
            "ground": {{"sine": {{"amplitude": 1, "omega": 5}}, "scale": "scale"}}}},
            "metrics": ["peak(p)", "impacts(stop)", "energy_error", "numerical_dissipation"]}}"#
    )
}

#[test]
fn the_method_is_an_axis() {
    let methods = r#"["average-acceleration", "hht", "generalized-alpha", "bathe", "moreau-jean"]"#;
    // Only moreau-jean knows the restitution of a rigid stop.
    let rigid = r#"["moreau-jean"]"#;
    for (methods, stop, count) in [(methods, r#""k": 700"#, 85), (rigid, r#""e": 0.5"#, 17)] {
        let study = parse(&by(methods, 0.002, stop));
        assert_eq!(study.len(), count);
        let mut cases = Cases::new(study.problem.schema());
        study.cases().for_each(|case| cases.push(&case));
        let rows: Vec<u32> = (0..count as u32).collect();
        let table = study.problem.sweep(&cases, &rows);
        for row in 0..count {
            let case = study.case(row).unwrap();
            let alone = study.problem.solve(&case, &[]).unwrap().metrics;
            let swept: Vec<Option<f64>> = table.row(row as usize).collect();
            assert_eq!(swept, alone, "case {row}");
            let [_, impacts, error, dissipation] = alone[..] else {
                panic!("{alone:?}")
            };
            let method = case.choice("method");
            assert!(impacts > Some(0.0), "{row} {alone:?}");
            assert!(error < Some(1e-12), "{row} {alone:?}");
            if method == "average-acceleration" {
                assert!(dissipation.unwrap().abs() < 1e-12, "{row} {dissipation:?}");
            }
        }
    }
}

#[test]
fn a_step_above_the_critical_one_is_refused() {
    let central = r#""central-difference""#;
    // omega^2 = (50 + 0.4/0.002 + 700)/2.
    let critical = 2.0 / 475.0_f64.sqrt();
    assert_eq!(
        parse(&by(central, 0.999 * critical, r#""k": 700"#)).len(),
        17
    );
    for (dt, stop, part) in [
        (
            1.001 * critical,
            r#""k": 700"#,
            "must be at most 0.0917662, the critical step",
        ),
        (
            0.001,
            r#""e": 0.5"#,
            "has no stable step with rigid contact, such as 'stop'",
        ),
    ] {
        let fault = study::parse("s", &by(central, dt, stop)).unwrap_err();
        assert!(fault.to_string().contains(part), "{fault}");
    }
}

/// The exact channel 0 of the one history figure of a study.
fn exact(study: &Study, case: u64) -> Vec<f64> {
    let case = study.case(case).unwrap();
    let solution = study.problem.solve(&case, &[]).unwrap();
    solution.exact.channel(0).to_vec()
}

fn rms(differences: impl Iterator<Item = f64>) -> f64 {
    let squares: Vec<f64> = differences.map(|x| x * x).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

#[test]
fn errors_are_the_differences_of_the_motions_they_name() {
    // A bar that falls on a spring, with the exact motions of the softened and of the rigid laws, and of a finer mesh.
    let study = |n: u32, reference: &str| {
        parse(&format!(
            r#"{{"problem": "structure", "parameters": {{"n": {n}, "dt": 0.01, "duration": 1.5}},
                "structure": {{"bars": {{"b": {{"L": 1, "EA": 20, "mass": 1, "n": "n", "stiffness_damping": 0.002}}}},
                "contacts": {{"wall": {{"law": "impact", "between": ["ground", "b.left"], "gap": 0.1, "k": 300}}}},
                "start": {{"b": {{"v": -0.5}}}}, "contacts_reference": "{reference}"}},
                "metrics": ["rms_error(b.right)", "step_error(b.right)", "mesh_error(b.right)", "regularisation_error(b.right)",
                            "peak_error(b.right)", "last_error(b.right)"],
                "figures": [{{"name": "h", "kind": "history", "y": "b.right"}}]}}"#
        ))
    };
    let (softened, rigid, finer) = (
        study(3, "softened"),
        study(3, "rigid"),
        study(12, "softened"),
    );
    let case = softened.case(0).unwrap();
    let solution = softened.problem.solve(&case, &[]).unwrap();
    let metrics: Vec<f64> = solution.metrics.iter().map(|x| x.unwrap()).collect();
    let computed = solution.computed.channel(0);
    let [g, e, f] = [exact(&softened, 0), exact(&rigid, 0), exact(&finer, 0)];
    let between = |a: &[f64], b: &[f64]| rms(a.iter().zip(b).map(|(a, b)| a - b));
    let expected = [
        between(computed, &g),
        between(computed, &g),
        between(&g, &f),
        between(&g, &e),
    ];
    for (found, expected) in metrics.iter().zip(expected) {
        // Round-off of sums in another order, and of motions up to 1.
        assert!((found - expected).abs() < 1e-13, "{metrics:?} {expected}");
        assert!(expected > 1e-6);
    }
    let peak = |x: &[f64]| x.iter().fold(0.0, |peak: f64, x| peak.max(x.abs()));
    assert!((metrics[4] - (peak(computed) - peak(&g)).abs()).abs() < 1e-15);
    let last = |x: &[f64]| *x.last().unwrap();
    assert!((metrics[5] - (last(computed) - last(&g)).abs()).abs() < 1e-15);
    assert!(metrics[5] > 1e-6);
    let against_rigid = rigid.problem.solve(&rigid.case(0).unwrap(), &[]).unwrap();
    let found = against_rigid.metrics[0].unwrap();
    assert!((found - between(computed, &e)).abs() < 1e-13);
}

#[test]
fn inner_nodes_keep_their_places_on_the_finer_mesh() {
    // A spring and the channel at node 2 of 4, which is node 8 of 16.
    let study = |n: u32, node: u32| {
        parse(&format!(
            r#"{{"problem": "structure", "parameters": {{"n": {n}, "dt": 0.01, "duration": 1.5}},
                "structure": {{"bars": {{"b": {{"L": 1, "EA": 20, "mass": 1, "n": "n"}}}},
                "springs": [{{"between": ["ground", "b.{node}"], "k": 3}}], "start": {{"b": {{"v": -0.5}}, "b.left": {{"u": 0.1}}}},
                "contacts_reference": "softened"}}, "metrics": ["mesh_error(b.{node})"],
                "figures": [{{"name": "h", "kind": "history", "y": "b.{node}"}}]}}"#
        ))
    };
    let (coarse, fine) = (study(4, 2), study(16, 8));
    let found = coarse.problem.solve(&coarse.case(0).unwrap(), &[]).unwrap();
    let [g, f] = [exact(&coarse, 0), exact(&fine, 0)];
    let expected = rms(g.iter().zip(&f).map(|(a, b)| a - b));
    assert!((found.metrics[0].unwrap() - expected).abs() < 1e-13);
    // The start of one node and that of its bar add up.
    let columns = coarse.problem.history_columns(&coarse.case(0).unwrap());
    let at_start = |name: &str| {
        let column = columns.iter().find(|c| c.column.name == name).unwrap();
        found.computed.channel(column.index)[0]
    };
    assert_eq!([at_start("b.left.u"), at_start("b.left.v")], [0.1, -0.5]);
}

#[test]
fn the_names_of_parameters_belong_to_the_key_of_results() {
    let key = |a: &str, b: &str| {
        let study = parse(&format!(
            r#"{{"problem": "structure", "parameters": {{"{a}": 1, "{b}": 4, "dt": 0.1, "duration": 2}},
                "structure": {{"masses": {{"m": "a"}}, "springs": [{{"between": ["ground", "m"], "k": "b"}}]}}}}"#
        ));
        let mut cases = Cases::new(study.problem.schema());
        study.cases().for_each(|case| cases.push(&case));
        slipgap::batch::store::key::Key::new(&study, 0, &cases)
    };
    assert_ne!(key("a", "b"), key("b", "a"));
    assert_eq!(key("a", "b"), key("a", "b"));
}

#[test]
fn a_parameter_may_have_the_name_of_a_constant() {
    let study = parse(
        r#"{"problem": "structure", "parameters": {"method": "moreau-jean", "e": [0, 0.5], "dt": 0.1, "duration": 2},
            "structure": {"masses": {"m": 1}, "contacts": {"stop": {"law": "impact", "between": ["m", "ground"], "gap": 1, "e": "e"}}}}"#,
    );
    let text = study
        .problem
        .as_structure()
        .unwrap()
        .description(&study.case(1).unwrap())
        .unwrap();
    assert!(text.contains("restitution 0.5"), "{text}");
}

#[test]
fn single_histories_diverge_where_impacts_make_the_motion_chaotic() {
    // An oscillator with a stiff stop, driven hard, and the same without the stop.
    let study = |gap: f64| {
        parse(&format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.005, "duration": 400}},
                "structure": {{"masses": {{"x": 1}}, "springs": [{{"between": ["ground", "x"], "k": 1, "c": 0.02}}],
                "contacts": {{"stop": {{"law": "impact", "between": ["x", "ground"], "gap": {gap}, "k": 1000}}}},
                "loads": [{{"at": "x", "sine": {{"amplitude": 1, "omega": 2.7}}}}], "start": {{"x": {{"u": 0.01}}}}}},
                "metrics": ["divergence(x, 0.01)"]}}"#
        ))
    };
    let divergence = |gap| {
        let study = study(gap);
        study
            .problem
            .solve(&study.case(0).unwrap(), &[])
            .unwrap()
            .metrics[0]
    };
    assert_eq!(divergence(10.0), None);
    let time = divergence(0.0);
    assert!(time.is_none_or(|time| time > 1.0), "{time:?}");
}

#[test]
fn the_example_of_init_runs_and_meets_its_check() {
    let text = study::start("structure").unwrap();
    let study = parse(
        &text
            .replace("SCHEMA", "schema.json")
            .replace("NAME", "frames"),
    );
    assert_eq!(study.len(), 26);
    let row = study
        .problem
        .metrics()
        .iter()
        .position(|m| m.name == "energy_error");
    for case in [0, 25] {
        let case = study.case(case).unwrap();
        let solution = study.problem.solve(&case, &[]).unwrap();
        assert!(solution.metrics[row.unwrap()].unwrap() < 1e-12);
        assert!(solution.metrics[0].unwrap() > 0.0);
    }
}

#[test]
fn a_contact_that_is_closed_at_the_start_is_an_impact() {
    // A mass on the spring of a contact only, pressed by 0.01: it leaves after a quarter of the period and never comes back. With a
    // gap of 0.5 and the velocity towards the ground it comes once, for half a period.
    let study = |gap: f64, start: &str| {
        let text = format!(
            r#"{{ "problem": "structure", "parameters": {{ "dt": 0.001, "duration": 3 }},
            "structure": {{ "masses": {{ "m": 1 }}, "start": {{ "m": {start} }},
                "contacts": {{ "c": {{ "law": "impact", "between": ["ground", "m"], "gap": {gap}, "k": 100 }} }} }},
            "metrics": ["impacts(c)", "contact_time(c)", "open_time(c)", "impacts_before_divergence(c.r, 0.01)"] }}"#
        );
        let study = study::parse("s.json", &text).unwrap();
        let case = study.case(0).unwrap();
        study.problem.solve(&case, &study.metrics).unwrap().metrics
    };
    let quarter = std::f64::consts::PI / 2.0 / 10.0;
    for (gap, start, time) in [
        (0.0, r#"{ "u": -0.01 }"#, quarter),
        (0.5, r#"{ "v": -1 }"#, 2.0 * quarter),
    ] {
        let metrics = study(gap, start);
        let [impacts, contact, open, before] = [0, 1, 2, 3].map(|i| metrics[i].unwrap());
        assert_eq!((impacts, before), (1.0, 1.0), "{gap}");
        // The steps at which the contact closes and opens count as a whole or not at all.
        assert!((contact - time).abs() <= 0.002, "{gap}: {contact}");
        // Every step is one of the two: 3000 products and sums of rounding 2e-16.
        assert!((contact + open - 3.0).abs() < 1e-12, "{gap}");
    }
}

#[test]
fn viscosity_and_stiffness_stay_where_the_normal_force_varies() {
    // A heavy mass keeps the velocity 1 mm/s. nu N is 10 until t = 1, and 20 from t = 2 on.
    let force = |law: &str, given: &str, duration: f64| {
        let text = format!(
            r#"{{ "problem": "structure", "parameters": {{ "dt": 0.001, "duration": {duration} }},
            "structure": {{ "masses": {{ "m": 1e12 }}, "start": {{ "m": {{ "v": 0.001 }} }},
                "contacts": {{ "c": {{ "law": "{law}", "between": ["ground", "m"], "nu": 0.1, {given},
                    "N": {{ "t": [0, 1, 2, 9], "N": [100, 100, 200, 200] }} }} }} }},
            "metrics": ["last(c.S)"] }}"#
        );
        let study = study::parse("s.json", &text).unwrap();
        let case = study.case(0).unwrap();
        study.problem.solve(&case, &study.metrics).unwrap().metrics[0].unwrap()
    };
    let tanh = |limit: f64| limit * (1.0 / limit).tanh();
    // c v = 1 with c = 1000, or 10/rdotE; the stiffness of 1000 reaches 0.5 at t = 0.5 and 2.5 at t = 2.5.
    for (law, given, at) in [
        ("velocity-control", "\"c\": 1000", [1.0, 1.0]),
        ("velocity-control", "\"rdotE\": 0.01", [1.0, 1.0]),
        ("tanh", "\"c\": 1000", [tanh(10.0), tanh(20.0)]),
        ("tanh", "\"rdotE\": 0.01", [tanh(10.0), tanh(20.0)]),
        ("displacement-control", "\"k\": 1000", [0.5, 2.5]),
        ("displacement-control", "\"rE\": 0.01", [0.5, 2.5]),
    ] {
        for (duration, expected) in [0.5, 2.5].into_iter().zip(at) {
            let found = force(law, given, duration);
            // The mass loses 3e-12 of its velocity 1e-3; the steps add round-off of some 1e-12.
            assert!(
                (found - expected).abs() < 1e-8,
                "{law} {given} {duration}: {found}"
            );
        }
    }
}

#[test]
fn the_mean_of_a_knet_record_is_removed_and_said_or_kept() {
    let folder = tempfile::tempdir().unwrap();
    let header = [
        "Origin Time       2000/01/01 00:00:00",
        "Lat.              0",
        "Long.             0",
        "Depth. (km)       0",
        "Mag.              0",
        "Station Code      NONE",
        "Station Lat.      0",
        "Station Long.     0",
        "Station Height(m) 0",
        "Record Time       2000/01/01 00:00:15",
        "Sampling Freq(Hz) 100Hz",
        "Duration Time(s)  0.04",
        "Dir.              N-S",
        "Scale Factor      2000(gal)/8000",
        "Max. Acc. (gal)   1",
        "Last Correction   2000/01/01 00:00:00",
        "Memo.",
    ];
    let record = header.join("\n") + "\n104 96 103 97\n";
    fs::write(folder.path().join("a.EW"), record).unwrap();
    let study = |mean: &str| {
        let text = format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}}, "metrics": ["peak(m)"],
              "structure": {{"units": "kg, N, m, s", "masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": 1}}],
                "ground": {{"record": "a.EW"{mean}}}}}}}"#
        );
        read(folder.path(), &text).unwrap_or_else(|why| panic!("{why}"))
    };
    let values = |study: &Study| {
        let motion = study
            .problem
            .as_structure()
            .unwrap()
            .ground_motion(&study.case(0).unwrap())
            .unwrap();
        motion.acceleration.values()[..4].to_vec()
    };
    // 0.25 gal a count: 4 counts are 0.01 m/s2, and the mean is 25 gal. A product of roundings of 0.26.
    let near = |a: Vec<f64>, b: [f64; 4]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-16);
    let study_of = study("");
    assert!(near(values(&study_of), [0.01, -0.01, 0.0075, -0.0075]));
    let note = &study_of.problem.as_structure().unwrap().notes()[0];
    assert!(
        note.starts_with("the mean of \"a.EW\", 25 cm/s2, is removed"),
        "{note}"
    );
    let removed = study(r#", "mean": "removed""#);
    assert!(removed.problem.as_structure().unwrap().notes().is_empty());
    assert_eq!(values(&removed), values(&study_of));
    let kept = study(r#", "mean": "kept""#);
    assert!(kept.problem.as_structure().unwrap().notes().is_empty());
    assert!(
        near(values(&kept), [0.26, 0.24, 0.2575, 0.2425]),
        "{:?}",
        values(&kept)
    );
    assert_ne!(
        kept.problem.as_structure().unwrap().identity(),
        removed.problem.as_structure().unwrap().identity()
    );
}
