//! Friction in a plane with a static limit above the kinetic one, in studies.

use serde_json::{Value as Json, json};
use slipgap::study::{self, Study};

fn read(study: &Json) -> Study {
    study::parse("study.json", &study.to_string()).unwrap_or_else(|why| panic!("{why}"))
}

fn metrics(study: &Json) -> Vec<f64> {
    let study = read(study);
    let case = study.case(0).unwrap();
    let solution = study.problem.solve(&case, &study.metrics);
    let metrics = solution.unwrap_or_else(|why| panic!("{why}")).metrics;
    metrics.into_iter().map(Option::unwrap).collect()
}

/// The last values of the exact motion of these channels.
fn exact(study: &Json, names: [&str; 2]) -> [f64; 2] {
    let study = read(study);
    let case = study.case(0).unwrap();
    let solution = study.problem.solve(&case, &study.metrics).unwrap();
    let columns = study.problem.history_columns(&case);
    names.map(|name| {
        let mut columns = columns.iter();
        let column = columns.find(|channel| channel.column.name == name).unwrap();
        *solution.exact.channels[column.index].last().unwrap()
    })
}

fn refused(study: &Json) -> String {
    let study = match study::parse("study.json", &study.to_string()) {
        Err(why) => return why.to_string(),
        Ok(study) => study,
    };
    let case = study.case(0).unwrap();
    let solution = study.problem.solve(&case, &study.metrics);
    solution.map(|_| ()).unwrap_err().to_string()
}

/// Code_Aster's V5.01.106 (SDND106) along a line in a plane.
fn two_masses(method: &str, way: [f64; 2]) -> Json {
    let table = |part: f64| {
        let f = [3000.0 * part, 3000.0 * part, 0.0, 0.0];
        json!({"t": [0, 0.2, 0.2, 1], "f": f})
    };
    json!({
        "problem": "structure", "parameters": {"method": method, "dt": 1e-4, "duration": 0.34},
        "structure": {
            "masses": {"m1": {"mass": 5, "direction": ["x", "y"]}, "m2": {"mass": 5, "direction": ["x", "y"]}},
            "springs": [{"between": ["m1", "m2"], "directions": ["x", "y"], "k": 1e4}],
            "contacts": {"f": {"law": "coulomb", "between": ["ground", "m1"], "directions": ["x", "y"], "limit": 2000, "static_ratio": 1.5}},
            "loads": [{"at": "m2.x", "table": table(way[0])}, {"at": "m2.y", "table": table(way[1])}],
            "contacts_reference": "softened"
        },
        "metrics": ["last(m2.x)", "last(m2.y)", "last_error(m2.x)", "last_error(m2.y)", "energy_error"]
    })
}

#[test]
fn the_published_numbers_are_met_along_any_line() {
    for method in ["average-acceleration", "moreau-jean"] {
        for way in [[0.6, 0.8], [-0.8, 0.6]] {
            let study = two_masses(method, way);
            let of_case = metrics(&study);
            let exact = exact(&study, ["m2.x.u", "m2.y.u"]);
            for axis in 0..2 {
                // Six digits.
                let wanted = 3.96813 * way[axis];
                assert!((exact[axis] - wanted).abs() < 1e-5, "{exact:?} {wanted}");
                // The contact breaks loose at the end of a step: up to (Ls - L) dt/(2 m) of velocity, 10 mm/s, for 0.3 s.
                assert!(of_case[2 + axis].abs() < 3e-3, "{method} {of_case:?}");
            }
            assert!(of_case[4] < 1e-10, "{method} {of_case:?}");
        }
    }
}

#[test]
fn what_is_not_known_is_refused_with_a_reason() {
    for method in ["newmark", "hht", "bathe", "central-difference"] {
        let why = refused(&two_masses(method, [0.6, 0.8]));
        assert!(
            why.contains("static_ratio above 1: the force of a contact that sticks alternates"),
            "{method}: {why}"
        );
    }
    let mut massless = two_masses("average-acceleration", [0.6, 0.8]);
    massless["structure"]["masses"]["m1"] = json!({"mass": 0, "direction": ["x", "y"]});
    let why = refused(&massless);
    assert!(
        why.contains("static_ratio above 1 in a plane is not known at a node without mass"),
        "{why}"
    );
    let mut elastic = two_masses("average-acceleration", [0.6, 0.8]);
    elastic["structure"]["contacts"]["f"]["law"] = json!("displacement-control");
    elastic["structure"]["contacts"]["f"]["k"] = json!(1e6);
    assert!(refused(&elastic).contains("static_ratio"));
}

#[test]
fn a_ratio_of_one_has_the_bits_of_a_law_without() {
    let mut one = two_masses("average-acceleration", [0.6, 0.8]);
    one["parameters"]["dt"] = json!(1e-3);
    one["structure"]["contacts"]["f"]["static_ratio"] = json!(1);
    let mut without = one.clone();
    let law = without["structure"]["contacts"]["f"].as_object_mut();
    law.unwrap().remove("static_ratio");
    let bits = |study: &Json| {
        metrics(study)
            .into_iter()
            .map(f64::to_bits)
            .collect::<Vec<_>>()
    };
    assert_eq!(bits(&one), bits(&without));
}

/// A mass of 1 with friction that slides at 1 and holds 2, under a static load along (0.6, 0.8).
fn held(load: f64) -> Json {
    json!({
        "problem": "structure", "parameters": {"dt": 0.01, "duration": 1},
        "structure": {
            "masses": {"m": {"mass": 1, "direction": ["x", "y"]}},
            "springs": [{"between": ["ground", "m"], "directions": ["x", "y"], "k": 1}],
            "static": {"m.x": 0.6 * load, "m.y": 0.8 * load}, "contacts_reference": "softened",
            "contacts": {"f": {"law": "coulomb", "between": ["ground", "m"], "directions": ["x", "y"], "limit": 1, "static_ratio": 2}}
        },
        "metrics": ["peak(m.x)", "peak(f.S)", "peak_error(m.x)"]
    })
}

#[test]
fn a_static_load_is_held_up_to_the_static_limit_in_any_direction() {
    let at_limit = metrics(&held(1.9));
    // Round-off.
    assert!(
        at_limit[0] < 1e-12 && (at_limit[1] - 1.9).abs() < 1e-10 && at_limit[2] < 1e-12,
        "{at_limit:?}"
    );
    let why = refused(&held(2.1));
    assert!(
        why.contains("the static loads break contact 'f.1' loose"),
        "{why}"
    );
}

/// A block on a belt that moves along x, which is pushed by nothing else: as with one direction. A push across makes it slide obliquely.
#[test]
fn a_block_on_a_belt_sticks_and_slides_as_with_one_direction() {
    let block = |plane: bool, push: f64| {
        let (mass, spring, contact) = match plane {
            true => (
                json!({"mass": 1, "direction": ["x", "y"]}),
                json!({"between": ["ground", "m"], "directions": ["x", "y"], "k": 1}),
                json!({"law": "coulomb", "between": ["belt", "m"], "directions": ["x", "y"], "limit": 1, "static_ratio": 1.5}),
            ),
            false => (
                json!(1),
                json!({"between": ["ground", "m"], "k": 1}),
                json!({"law": "coulomb", "between": ["belt", "m"], "limit": 1, "static_ratio": 1.5}),
            ),
        };
        let belt = match plane {
            true => json!({"x": {"velocity": 0.3}, "y": {"velocity": 0}}),
            false => json!({"velocity": 0.3}),
        };
        let name = if plane { "m.x" } else { "m" };
        let mut study = json!({
            "problem": "structure", "parameters": {"dt": 0.001, "duration": 30},
            "structure": {
                "masses": {"m": mass}, "springs": [spring], "supports": {"belt": belt},
                "contacts": {"skid": contact}, "contacts_reference": "rigid"
            },
            "metrics": [format!("max({name})"), format!("last({name})"), format!("peak_error({name})"), "energy_error"]
        });
        if plane {
            study["structure"]["loads"] =
                json!([{"at": "m.y", "sine": {"amplitude": push, "omega": 0.4}}]);
        }
        metrics(&study)
    };
    let [line, plane] = [block(false, 0.0), block(true, 0.0)];
    for (a, b) in line.iter().zip(&plane).take(3) {
        // Round-off of 30,000 steps, and 1e-9 of the largest speed at a stop.
        assert!((a - b).abs() < 1e-8, "{line:?} {plane:?}");
    }
    // It slides around u = 1 with the radius sqrt(0.5^2 + V^2).
    assert!((plane[0] - (1.0 + f64::hypot(0.5, 0.3))).abs() < 2e-4);
    let oblique = block(true, 0.9);
    assert!(oblique[0] < plane[0] - 0.01, "{oblique:?}");
    assert!(oblique[2] < 2e-3 && oblique[3] < 1e-11, "{oblique:?}");
}

/// N is the force of another contact, which is the weight.
#[test]
fn the_force_of_another_contact_presses_with_both_limits() {
    let study = |pressed: bool| {
        let normal = match pressed {
            true => json!({"contact": "floor"}),
            false => json!(10),
        };
        json!({
            "problem": "structure", "parameters": {"dt": 0.001, "duration": 6},
            "structure": {
                "masses": {"b": {"mass": 1, "direction": ["x", "y"]}, "z": {"mass": 1, "direction": "z"}},
                "springs": [{"between": ["ground", "b"], "directions": ["x", "y"], "k": 8}],
                "loads": [{"at": "b.x", "sine": {"amplitude": 3, "omega": 1.7}}, {"at": "b.y", "sine": {"amplitude": 2, "omega": 1.1}}],
                "static": {"z": -10},
                "contacts": {
                    "floor": {"law": "impact", "between": ["ground", "z"], "k": 1e4},
                    "f": {"law": "coulomb", "between": ["ground", "b"], "directions": ["x", "y"], "nu": 0.1, "static_ratio": 1.6, "N": normal}
                }
            },
            "metrics": ["last(b.x)", "last(b.y)", "peak(f.S)", "energy_error"]
        })
    };
    let [of_pressure, number] = [true, false].map(|pressed| metrics(&study(pressed)));
    for (metric, number) in of_pressure.iter().zip(&number) {
        // Round-off of the equilibrium on the floor.
        assert!((metric - number).abs() < 1e-9, "{metric} {number}");
    }
    assert!(of_pressure[2] > 1.5, "{of_pressure:?}");
}
