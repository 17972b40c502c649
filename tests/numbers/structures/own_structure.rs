//! Structures of other programs: matrices, general rows of contacts, nodes without mass, compared with an independent program
//! (tests/reference/structures/own_structure.py, which agrees with OpenSees) and with the same model as masses and springs.

use serde_json::{Value as Json, json};
use slipgap::study::{self, Study};
use slipgap_problem::problem::structure::described::scheme::picture::{End, Place};
use std::path::Path;

/// A study beside the models.
fn beside(study: &Json) -> Study {
    let folder = Path::new(env!("SLIPGAP_ROOT")).join("tests/data/own_structure/s.json");
    study::parse(&folder.to_string_lossy(), &study.to_string()).unwrap_or_else(|e| panic!("{e}"))
}

/// The columns of the history of case 0 with their names.
fn history(study: &Study) -> Vec<(String, Vec<f64>)> {
    let case = study.case(0).unwrap();
    let solution = study.problem.solve(&case, &[]).unwrap();
    let columns = study.problem.history_columns(&case).into_iter();
    columns
        .map(|channel| {
            let values = solution.computed.channels[channel.index].clone();
            (channel.column.name.to_string(), values)
        })
        .collect()
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |a, x| a.max(x.abs()))
}

fn number(json: &Json) -> f64 {
    json.as_f64().unwrap()
}

#[test]
fn imported_structures_move_as_an_independent_program_says() {
    let references: Vec<Json> =
        serde_json::from_str(include_str!("../../data/own_structure.json")).unwrap();
    // The steps of the absolute displacements of supports are not those of slipgap: their motion with a common one of all supports
    // is not that of the ground.
    let of_slipgap = references.iter().filter(|case| case["name"] != "supports");
    for case in of_slipgap {
        let name = case["name"].as_str().unwrap();
        let study = beside(&case["study"]);
        let columns = history(&study);
        let steps = case["steps"].as_array().unwrap();
        for (channel, expected) in case["channels"].as_object().unwrap() {
            let (_, values) = columns.iter().find(|column| column.0 == *channel).unwrap();
            let size = number(&expected["largest"]);
            for (step, value) in steps.iter().zip(expected["values"].as_array().unwrap()) {
                let found = values[number(step) as usize];
                // Both programs have round-off of some 1000 steps; agreement was 2e-13.
                assert!(
                    (found - number(value)).abs() <= 1e-11 * size,
                    "{name}, {channel}, step {step}: {found} {value} of {size}"
                );
            }
        }
    }
}

/// A chain of three masses and a block, by masses and springs or by matrices.
fn chain(by_matrices: bool, method: &str) -> Study {
    let of_tower = |name: &str, mass: f64| match by_matrices {
        true => String::new(),
        false => format!(r#""{name}": {mass}, "#),
    };
    let name = |i: usize| match by_matrices {
        true => format!("t.{i}.x"),
        false => format!("t{i}"),
    };
    let springs = match by_matrices {
        true => String::new(),
        false => r#"{"between": ["ground", "t1"], "k": 100}, {"between": ["t1", "t2"], "k": 70}, {"between": ["t2", "t3"], "k": 30},"#
            .to_owned(),
    };
    let matrices = match by_matrices {
        true => {
            r#""matrices": {"t": {"M": "chain.M.mtx", "K": "chain.K.mtx", "dofs": "chain.dofs.csv"}},"#
        }
        false => "",
    };
    let text = format!(
        r#"{{"problem": "structure", "structure": {{{matrices}
          "masses": {{{}{}{}"b": 5}},
          "springs": [{springs} {{"between": ["b", "ground"], "k": 50, "c": 1}},
            {{"along": {{"{t2}": -0.6, "b": 0.8}}, "k": 20, "c": 0.3}}],
          "contacts": {{"stop": {{"law": "impact", "between": ["{t3}", "b"], "gap": 0.01, "k": 1e4}},
            "skew": {{"law": "impact", "along": {{"{t1}": 0.8, "b": -0.6}}, "gap": 0.05, "k": 3e3}},
            "slip": {{"law": "displacement-control", "between": ["{t1}", "ground"], "k": 100, "limit": 0.5}}}},
          "ground": {{"sine": {{"amplitude": 1, "omega": 5}}}}, "rayleigh": {{"mass": 0.1, "stiffness": 0.001}},
          "start": {{"{t2}": {{"u": 0.02, "v": -0.1}}}}}},
          "parameters": {{"dt": 0.01, "duration": 5, "method": "{method}"}}, "metrics": ["energy_error"]}}"#,
        of_tower("t1", 2.0),
        of_tower("t2", 1.0),
        of_tower("t3", 3.0),
        t1 = name(1),
        t2 = name(2),
        t3 = name(3),
    );
    beside(&serde_json::from_str(&text).unwrap())
}

#[test]
fn a_chain_by_matrices_moves_as_one_of_masses_and_springs() {
    for method in [
        "average-acceleration",
        "bathe",
        "hht",
        "generalized-alpha",
        "moreau-jean",
    ] {
        let [springs, matrices] = [false, true].map(|by| history(&chain(by, method)));
        assert_eq!(springs.len(), matrices.len());
        for (name, matrix) in &matrices {
            let other = name.replacen("t.", "t", 1).replacen(".x", "", 1);
            let (_, expected) = springs.iter().find(|column| column.0 == other).unwrap();
            let size = largest(expected);
            for (x, y) in matrix.iter().zip(expected) {
                // The order of elimination differs; impacts enlarge round-off.
                assert!(
                    (x - y).abs() <= 1e-12 * size,
                    "{method}, {name}: {x} {y} of {size}"
                );
            }
        }
    }
}

/// A mass on a bar of two springs with a node between them that has no mass, or this one.
fn between_springs(mass: f64, law: &str, method: &str, dt: f64) -> Vec<f64> {
    let text = format!(
        r#"{{"problem": "structure", "structure": {{"masses": {{"deck": 2, "joint": {mass}}},
          "springs": [{{"between": ["ground", "joint"], "k": 300}}, {{"between": ["joint", "deck"], "k": 500, "c": 0}},
            {{"between": ["ground", "deck"], "k": 20, "c": 0.4}}],
          "contacts": {{"c": {{{law}, "between": ["joint", "ground"]}}}},
          "loads": [{{"at": "deck", "sine": {{"amplitude": 30, "omega": 4}}}}, {{"at": "joint", "sine": {{"amplitude": 5, "omega": 9}}}}]}},
          "parameters": {{"dt": {dt}, "duration": 3, "method": "{method}"}},
          "metrics": ["peak(deck)", "peak(joint)", "peak(c.S)", "work(c)", "energy_error"]}}"#
    );
    let study = beside(&serde_json::from_str(&text).unwrap());
    let case = study.case(0).unwrap();
    let metrics = study.problem.solve(&case, &[]).unwrap().metrics;
    metrics.into_iter().map(|metric| metric.unwrap()).collect()
}

#[test]
fn a_node_without_mass_is_the_limit_of_a_small_mass() {
    let laws = [
        r#""law": "impact", "gap": 0.01, "k": 2e3"#,
        r#""law": "displacement-control", "k": 4e3, "limit": 4"#,
        r#""law": "velocity-control", "rdotE": 0.01, "limit": 4"#,
        r#""law": "coulomb", "limit": 4"#,
    ];
    for method in ["average-acceleration", "bathe", "hht", "generalized-alpha"] {
        for law in laws {
            // Bathe's method damps what the small mass does; the others let it vibrate, so that only their own steps converge.
            let [coarse, fine] = [1e-3, 2.5e-4].map(|dt| between_springs(0.0, law, method, dt));
            let light = between_springs(1e-7, law, "bathe", 2.5e-4);
            for (i, ((a, b), c)) in coarse.iter().zip(&fine).zip(&light).take(4).enumerate() {
                // The work of an elastic contact is 0 but for what the step makes.
                let size = c.abs().max(if i == 3 {
                    0.1 * light[1] * light[2]
                } else {
                    0.0
                });
                let error = [(a - c).abs() / size, (b - c).abs() / size];
                // First order where velocities are differences.
                assert!(
                    error[1] < 2e-3 && error[1] < 0.6 * error[0] + 1e-5,
                    "{method}, {law}, {i}: {a} {b} {c}"
                );
            }
            // The rates at a node without mass are means over a step, so that the books close in displacements.
            assert!(fine[4] < 1e-9, "{method}, {law}: {}", fine[4]);
        }
    }
}

/// A girder that meets a plate without mass before soil that yields: the peaks of displacement and force for each gap and velocity.
fn plate(dt: f64) -> Vec<[f64; 4]> {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{"gap": [0.005, 0.01, 0.0157, 0.02, 0.03],
            "v": [0.5, 0.625, 0.75, 0.875, 1, 1.125, 1.25, 1.5], "dt": {dt}, "duration": 1}},
          "structure": {{"units": "t, kN, m, s", "masses": {{"girder": 500, "plate": 0}},
            "springs": [{{"between": ["ground", "girder"], "k": 20000}}],
            "contacts": {{"joint": {{"law": "impact", "between": ["girder", "plate"], "gap": "gap", "k": 1e7}},
              "soil": {{"law": "displacement-control", "between": ["plate", "ground"], "k": 2e5, "limit": 1e4}}}},
            "start": {{"girder": {{"v": "v"}}}}}},
          "metrics": ["peak(girder)", "peak(joint.S)", "work(joint)", "energy_error"]}}"#
    );
    let study = beside(&serde_json::from_str(&text).unwrap());
    (0..40)
        .map(|case| {
            let case = study.case(case).unwrap();
            let cells = study.problem.solve(&case, &[]).unwrap().metrics;
            let metrics: Vec<f64> = cells.into_iter().flatten().collect();
            metrics.try_into().unwrap()
        })
        .collect()
}

/// The same by Verlet's method with one law for gap and soil in series.
fn series(gap: f64, v: f64) -> [f64; 2] {
    const STEPS: usize = 40_000;
    let (mass, k, soil, limit, spring) = (500.0, 1e7, 2e5, 1e4, 2e4);
    let dt = 1.0 / STEPS as f64;
    let compliance = 1.0 / k + 1.0 / soil;
    let mut slid = 0.0;
    let mut force = |x: f64| {
        let pressed = (x - gap - slid).max(0.0) / compliance;
        if pressed > limit {
            slid = x - gap - limit * compliance;
        }
        f64::min(pressed, limit)
    };
    let (mut x, mut v, mut peaks) = (0.0, v, [0.0; 2]);
    let mut a = 0.0;
    for _ in 0..STEPS {
        x += dt * v + 0.5 * dt * dt * a;
        let s = force(x);
        let next = -(spring * x + s) / mass;
        v += 0.5 * dt * (a + next);
        a = next;
        peaks = [f64::max(peaks[0], f64::abs(x)), f64::max(peaks[1], s)];
    }
    peaks
}

#[test]
fn a_gap_and_soil_that_yields_need_no_light_plate_between_them() {
    let gaps = [0.005, 0.01, 0.0157, 0.02, 0.03];
    let velocities = [0.5, 0.625, 0.75, 0.875, 1.0, 1.125, 1.25, 1.5];
    let cases = gaps.iter().flat_map(|gap| velocities.map(|v| (*gap, v)));
    for ((gap, v), peaks) in cases.zip(plate(5e-4)) {
        let [x, force] = series(gap, v);
        let energy = 250.0 * v * v;
        // The light plate of tests/command_line/warnings.rs makes energy in some of these cases.
        assert!(
            (peaks[0] - x).abs() < 0.01 * x,
            "gap {gap}, v {v}: {} {x}",
            peaks[0]
        );
        assert!(
            (peaks[1] - force).abs() < 0.01 * force,
            "gap {gap}, v {v}: {} {force}",
            peaks[1]
        );
        assert!(
            peaks[2] > -1e-3 * energy && peaks[3] < 1e-9,
            "gap {gap}, v {v}: {peaks:?}"
        );
    }
}

#[test]
fn a_scheme_has_the_nodes_of_a_model_and_the_ends_of_its_links() {
    let study = beside(&json!({
        "problem": "structure", "parameters": { "dt": 0.001, "duration": 0.01 }, "metrics": ["energy_error"],
        "structure": {
            "units": "t, kN, m, s",
            "masses": { "block": 5 },
            "matrices": {
                "frames": { "M": "frames.M.mtx", "K": "frames.K.mtx", "C": "frames.C.mtx", "dofs": "frames.dofs.csv" },
                "chain": { "M": "chain.M.mtx", "K": "chain.K.mtx", "dofs": "chain.dofs.csv" }
            },
            "springs": [{ "between": ["chain.1.x", "block"], "k": 10 }],
            "contacts": {
                "leaning": { "law": "impact", "k": 4e4, "gap": 1, "along": {
                    "frames.132.y": 0.6, "frames.132.x": -0.8, "frames.231.y": -0.6, "frames.231.x": 0.8 } },
                "wall": { "law": "impact", "k": 4e4, "gap": 1, "along": { "frames.232.y": -0.1, "frames.232.x": -1 } }
            }
        }
    }));
    let case = study.case(0).unwrap();
    let scheme = study.problem.as_structure().unwrap().scheme(&case).unwrap();
    let model = |part: usize| scheme.parts[part].model.as_ref().unwrap();
    assert_eq!(scheme.parts[0].model, None);
    // Storeys of 3.2 m and 3 m; the right frame leans.
    let frames = model(1);
    assert_eq!(frames.nodes.len(), 12);
    assert_eq!(frames.nodes[0], [0.0, 3.2, 0.0]);
    assert_eq!(frames.nodes[8], [6.12, 6.0, 0.0]);
    let mut members: Vec<[usize; 2]> = Vec::new();
    for frame in [0, 6] {
        let beams = [0, 2, 4].map(|left| [frame + left, frame + left + 1]);
        let columns = [0, 1, 2, 3].map(|foot| [frame + foot, frame + foot + 2]);
        members.extend(beams);
        members.extend(columns);
    }
    members.sort_unstable();
    assert_eq!(frames.couplings, members);
    // The other matrices have no places.
    assert!(model(2).nodes.is_empty() && model(2).couplings.is_empty());
    let name = |end: End| match end {
        End::Ground => "ground".to_owned(),
        End::Part(part, Place::Dof(dof)) => {
            format!(
                "{}.{}",
                scheme.parts[part].name,
                model(part).interface[dof].name
            )
        }
        End::Part(part, _) => scheme.parts[part].name.clone(),
    };
    let ends: Vec<[String; 2]> = scheme
        .links
        .iter()
        .map(|link| link.between.map(name))
        .collect();
    assert_eq!(ends[0], ["chain.1.x", "block"]);
    assert_eq!(ends[1], ["frames.132.x", "frames.231.x"]);
    assert_eq!(ends[2], ["frames.232.x", "ground"]);
    let directions: Vec<[f64; 3]> = scheme.links.iter().map(|link| link.direction).collect();
    assert_eq!(directions[1..], [[0.8, -0.6, 0.0], [1.0, 0.1, 0.0]]);
    let nodes: Vec<usize> = frames.interface.iter().map(|dof| dof.node).collect();
    assert_eq!(nodes, [5, 10, 11]);
    let text = study
        .problem
        .as_structure()
        .unwrap()
        .description(&case)
        .unwrap();
    // examples/models/frame.py lumps 156 t, which move in x and y; the 12 rotations have none.
    let line = "matrices frames: 36 dofs, 12 of them without mass, mass x 156, y 156\n";
    assert!(text.contains(line), "{text}");
}
