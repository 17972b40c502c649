//! Static equilibria that contacts alone hold, and bodies that rest until an earthquake moves them.

use serde_json::{Map, Value as Json, json};
use slipgap::problem::Solution;
use slipgap::study::{self, Study};

fn read(study: &Json) -> Study {
    study::parse("study.json", &study.to_string()).unwrap_or_else(|why| panic!("{why}"))
}

fn solve(study: &Study, case: u64) -> Solution {
    let case = study.case(case).unwrap();
    let solution = study.problem.solve(&case, &study.metrics);
    solution.unwrap_or_else(|why| panic!("{why}"))
}

/// A mass of 1 on a spring of 100 under a static load, with these contacts to the ground.
fn loaded(contacts: &Json, load: f64) -> Study {
    read(&json!({
        "problem": "structure", "parameters": {"dt": 0.002, "duration": 0.1},
        "structure": {
            "masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 100}], "static": {"m": load},
            "contacts": contacts
        },
        "metrics": ["min(m)", "max(m)"]
    }))
}

#[test]
fn a_damper_has_no_static_force() {
    for a in [0.1, 0.3, 1.0, 2.0] {
        let contacts = json!({"c": {"law": "viscous", "between": ["ground", "m"], "c": 5, "a": a}});
        let metrics = solve(&loaded(&contacts, 1.0), 0).metrics;
        // u = F/k, and it stays there. Round-off.
        for u in metrics {
            assert!((u.unwrap() - 0.01).abs() < 1e-16, "{a} {u:?}");
        }
    }
}

#[test]
fn friction_that_holds_all_of_the_load_leaves_no_displacement() {
    let contacts = json!({
        "c": {"law": "coulomb", "between": ["m", "ground"], "limit": 4.747},
        "d": {"law": "bouc-wen", "between": ["m", "ground"], "k": 6282, "limit": 1.286}
    });
    for u in solve(&loaded(&contacts, -0.156), 0).metrics {
        // Round-off of F/k = 0.0016.
        assert!(u.unwrap().abs() < 1e-17, "{u:?}");
    }
}

#[test]
fn a_gap_in_series_that_stays_open_carries_nothing() {
    let contacts = json!({"c": {"between": ["ground", "m"], "series": [
        {"law": "impact-spring", "k": 5000, "gap": 0.05}, {"law": "bilinear", "k1": 2000, "Fy": 3, "k2": 100}]}});
    for u in solve(&loaded(&contacts, 1.0), 0).metrics {
        // Round-off of the equilibrium.
        assert!((u.unwrap() / 0.01 - 1.0).abs() < 1e-10, "{u:?}");
    }
}

/// A rigid deck on two bearings at -b and b that only press, with friction by their force, on a soft spring k0 in each direction.
fn deck(b: f64, k0: f64) -> Study {
    let matrix = |diagonal: [f64; 4]| {
        let entries = diagonal.iter().enumerate().filter(|(_, x)| **x != 0.0);
        let lines: Vec<String> = entries
            .map(|(i, x)| format!("{} {} {x}", i + 1, i + 1))
            .collect();
        format!(
            "%%MatrixMarket matrix coordinate real symmetric\n4 4 {}\n{}\n",
            lines.len(),
            lines.join("\n")
        )
    };
    let bearing = |x: f64| json!({"law": "impact", "along": {"s.d.y": 1, "s.d.rz": x}, "k": 8e5});
    let slide = |of: &str| {
        json!({"law": "displacement-control", "along": {"s.d.x": 1, "s.d.rz": 4, "s.cap.x": -1}, "k": 1e5, "nu": 0.3,
               "N": {"contact": of}})
    };
    read(&json!({
        "problem": "structure", "parameters": {"dt": 0.001, "duration": 0.01},
        "structure": {
            "units": "t, kN, m, s",
            "matrices": {"s": {"M": matrix([600.0, 600.0, 7200.0, 120.0]), "K": matrix([k0, k0, k0, 4e4]),
                               "dofs": [["d", "x"], ["d", "y"], ["d", "rz"], ["cap", "x"]]}},
            "contacts": {"left": bearing(-b), "right": bearing(b), "slide_left": slide("left"), "slide_right": slide("right")},
            "static": {"gravity": -9.81}
        },
        "metrics": ["last(left.S)", "last(right.S)"]
    }))
}

#[test]
fn a_deck_rests_on_its_bearings_whatever_their_digits() {
    for k0 in [0.0, 1e-6, 1.0, 100.0] {
        for step in 0..30 {
            let b = 0.5 + 0.1 * f64::from(step);
            let forces = solve(&deck(b, k0), 0).metrics;
            // W/2 in each, less what the soft spring carries of it: k0/(2 k).
            let expected = -600.0 * 9.81 / 2.0 / (1.0 + k0 / 1.6e6);
            for force in forces {
                // Steps end at changes of 1e-11; what is left is the sum of smaller ones.
                let force = force.unwrap();
                assert!(
                    (force / expected - 1.0).abs() < 1e-9,
                    "{k0} {b} {force} {expected}"
                );
            }
        }
    }
}

#[test]
fn bodies_at_rest_have_an_exact_motion_under_an_earthquake() {
    // Both move alike at first, so that r and rdot between them are round-off of u and v.
    let study = read(&json!({
        "problem": "structure",
        "parameters": {"law": ["dahl", "bouc-wen", "lugre", "viscous", "hertz"], "dt": [0.002, 0.001], "duration": 0.4},
        "structure": {
            "units": "t, kN, m, s", "masses": {"a": 1, "b": 2},
            "springs": [{"between": ["ground", "a"], "k": 150, "c": 0.4}, {"between": ["ground", "b"], "k": 250, "c": 0.5}],
            "contacts": {"c": {"law": "law", "between": ["a", "b"], "k": 2000, "limit": 2, "sigma0": 2000, "sigma1": 20, "c": 5,
                               "a": 0.5, "k_h": 1e5}},
            "ground": {"pulse": {"ricker": {"amplitude": 3, "frequency": 2, "at": 0.3, "sampled": 0.01}}}
        },
        "metrics": ["rms_error(a)"]
    }));
    let error = |case: u64| solve(&study, case).metrics[0].unwrap();
    for law in 0..5 {
        let [coarse, fine] = [2 * law, 2 * law + 1].map(error);
        // The steps converge to it with the second order.
        assert!((coarse / fine - 4.0).abs() < 1.5, "{law}: {coarse} {fine}");
    }
}

#[test]
fn dampers_of_contacts_have_no_static_force() {
    // A body on a floor that pushes: k u^p = F, whatever damper the law has. Two free bodies: the dampers of some laws follow rdot over the
    // closing speed, which stays however slowly they approach.
    let study = |law: &Json, spring: f64| {
        let mut law = law.clone();
        law["between"] = json!(["a", "b"]);
        read(&json!({
            "problem": "structure", "parameters": {"dt": 1e-6, "duration": 1e-6},
            "structure": {
                "masses": {"a": 0.7, "b": 1.9},
                "springs": [{"between": ["ground", "b"], "k": spring}],
                "contacts": {"c": law}, "static": {"a": 3.0, "b": -0.9}
            },
            "metrics": ["max(c.r)", "max(b)"]
        }))
    };
    let (k, k_h) = (2000.0, 11560.0);
    let curved =
        |law: &str| json!({"law": law, "k_h": k_h, "restitution": 0.6, "colliding_mass": 0.5});
    let undamped = |law: &str| json!({"law": law, "k_h": k_h, "restitution": 0.6});
    let of_curved = -(3.0_f64 / k_h).powf(2.0 / 3.0);
    for (law, r) in [
        (
            json!({"law": "kelvin-voigt", "k": k, "restitution": 0.6, "colliding_mass": 0.5}),
            -3.0 / k,
        ),
        (undamped("hertz-damp"), of_curved),
        (undamped("hunt-crossley"), of_curved),
        (undamped("ye"), of_curved),
        (curved("jankowski"), of_curved),
    ] {
        for spring in [2.4, 240.0] {
            let found = solve(&study(&law, spring), 0).metrics;
            // Round-off of u of the soft spring; with forces in balance nothing moves in the step.
            let [overlap, b] = [found[0].unwrap(), found[1].unwrap()];
            assert!(
                (overlap / r - 1.0).abs() < 1e-8,
                "{law} {spring} {overlap} {r}"
            );
            assert!(
                (b / (2.1 / spring) - 1.0).abs() < 1e-9,
                "{law} {spring} {b}"
            );
        }
    }
    // Friction that is viscous at rest creeps under a static load: nothing holds the body.
    let creeps = read(&json!({
        "problem": "structure", "parameters": {"dt": 0.001, "duration": 0.01},
        "structure": {
            "masses": {"a": 1},
            "contacts": {"c": {"law": "velocity-control", "between": ["ground", "a"], "c": 30, "limit": 3}},
            "static": {"a": 1}
        },
        "metrics": ["max(a)"]
    }));
    let why = creeps
        .problem
        .solve(&creeps.case(0).unwrap(), &[])
        .unwrap_err();
    assert!(why.to_string().contains("nothing holds node a"), "{why}");
}

#[test]
fn a_mass_beside_does_not_change_an_equilibrium() {
    // Forces of these laws depend on the way, and nothing but the contacts holds the node between them.
    let series = json!([
        {"law": "lugre", "sigma0": 15377, "sigma1": 5.9, "limit": 2},
        {"law": "multilinear", "table": {"r": [0.0002, 0.0007, 0.002], "S": [0.4, 0.7, 1]}},
        {"law": "bouc-wen", "k": 2000, "limit": 1.5, "exponent": 2}
    ]);
    let equilibrium = |beside: Option<f64>| {
        let mut study = json!({
            "problem": "structure", "parameters": {"dt": 0.002, "duration": 0.002},
            "structure": {
                "masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 300}], "static": {"m": 0.9},
                "contacts": {"c": {"between": ["ground", "m"], "series": series}}
            },
            "metrics": ["max(c.1.S)", "max(m)"], "figures": [{"name": "h", "kind": "history", "y": ["m", "c.1.S"]}]
        });
        if let Some(mass) = beside {
            study["structure"]["masses"]["a"] = json!(mass);
            let spring = json!({"between": ["ground", "a"], "k": 1});
            study["structure"]["springs"]
                .as_array_mut()
                .unwrap()
                .push(spring);
        }
        let motion = solve(&read(&study), 0).computed;
        [0, 1].map(|channel| motion.channel(channel)[0])
    };
    let alone = equilibrium(None);
    for mass in [1e-3, 1.0, 1e3] {
        let both = equilibrium(Some(mass)).into_iter().zip(alone);
        for (with, without) in both {
            // An equilibrium has 1e-11 of u.
            assert!(
                (with / without - 1.0).abs() < 1e-10,
                "{mass}: {with} {without}"
            );
        }
    }
}

#[test]
fn contacts_hold_what_nothing_else_holds_however_soft_they_become() {
    // Forces by Newton's method on the potential of springs and contacts, in Python. Some contacts slide or yield, so that what
    // still holds the masses is up to 1e5 times softer than at the start.
    let soft = json!({
        "masses": {"m0": 0.113, "m1": 6.504},
        "springs": [{"between": ["m0", "m1"], "k": 62303.5}],
        "contacts": {
            "c0": {"law": "displacement-control", "between": ["m0", "m1"], "k": 309974.7, "limit": 18.9615},
            "c1": {"law": "displacement-control", "between": ["ground", "m0"], "k": 25872.8, "limit": 8.3871},
            "c2": {"law": "bilinear", "between": ["m0", "ground"], "k1": 587.8, "Fy": 0.267, "ratio": 0.01},
            "c3": {"law": "dahl", "between": ["m1", "m0"], "k": 480742, "limit": 5.932}
        },
        "static": {"m1": 17.325}
    });
    let pushed = json!({
        "masses": {"m0": 0.419, "m1": 89.73},
        "contacts": {
            "c0": {"law": "displacement-control", "between": ["m0", "m1"], "k": 20585, "limit": 0.166},
            "c1": {"law": "displacement-control", "between": ["m1", "m0"], "k": 6471, "limit": 4.213},
            "c2": {"law": "hertz", "between": ["ground", "m0"], "k_h": 8860.9, "gap": 0},
            "c3": {"law": "hertz", "between": ["m0", "m1"], "k_h": 1432.5, "gap": 0.001},
            "c4": {"law": "bilinear", "between": ["ground", "m1"], "k1": 19821.9, "Fy": 1.014, "ratio": 0.1}
        },
        "static": {"m0": -5.135, "m1": -0.35}
    });
    let stuck = json!({
        "masses": {"m0": 35.809, "m1": 0.165},
        "contacts": {
            "c0": {"between": ["ground", "m0"], "series": [
                {"law": "impact", "gap": 0, "k": 416.5}, {"law": "displacement-control", "k": 138.8, "limit": 0.118}]},
            "c1": {"law": "displacement-control", "between": ["m0", "m1"], "k": 18448.5, "limit": 0.675},
            "c2": {"law": "dahl", "between": ["ground", "m1"], "k": 4113.6, "limit": 73.302},
            "c3": {"law": "impact", "between": ["ground", "m1"], "k": 353978.1, "gap": 0.01},
            "c4": {"law": "coulomb", "between": ["m1", "ground"], "limit": 0.273}
        },
        "static": {"m0": -0.188, "m1": 2.316}
    });
    // The last number is the tolerance: laws with a memory are loaded in 50 parts, whose rule is of first order.
    let cases = [
        (
            soft,
            vec![9.861238514295424, 8.3871, -8.9379, -5.481697550242707],
            1e-4,
        ),
        (
            pushed,
            vec![
                0.166,
                -3.932622398197047,
                -1.036377601802955,
                0.0,
                -4.448622398197045,
            ],
            1e-9,
        ),
        (stuck, vec![0.188, 1.855, 0.0, -0.273], 1e-9),
    ];
    for (structure, expected, tolerance) in cases {
        let names = match expected.len() {
            4 if structure["contacts"]["c3"]["law"] == "impact" => vec!["c1", "c2", "c3", "c4"],
            m => ["c0", "c1", "c2", "c3", "c4"][..m].to_vec(),
        };
        let metrics: Vec<String> = names.iter().map(|name| format!("last({name}.S)")).collect();
        let study = read(
            &json!({"problem": "structure", "parameters": {"dt": 1e-5, "duration": 1e-5}, "structure": structure,
                                     "metrics": metrics.clone()}),
        );
        let found = solve(&study, 0).metrics;
        for ((name, found), expected) in names.iter().zip(found).zip(&expected) {
            let found = found.unwrap();
            assert!(
                (found - expected).abs() < tolerance * 20.0,
                "{name} {found} {expected}"
            );
        }
    }
}

/// Storeys on laws that soften, in equilibrium on their first branches: displacements of storeys by shear over stiffness.
#[test]
fn laws_that_soften_stay_on_their_first_branch_under_small_loads() {
    let bilinear = |k: f64| json!({"law": "bilinear", "k1": k, "Fy": 100, "ratio": -0.1});
    let hinge = |k: f64| json!({"law": "imk-peak-oriented", "k": k, "Fy": 100, "Up": 0.1, "Upc": 0.5, "Fcap_ratio": 1.1});
    let equal = || bilinear(1e4);
    for (laws, loads) in [
        (vec![bilinear(1e4), bilinear(1e5)], vec![1.0, -1.0]),
        (
            vec![equal(), equal(), equal(), equal()],
            vec![1.0, -1.0, 1.0, -1.0],
        ),
        (vec![bilinear(1e4), hinge(1e6)], vec![0.0, 1.0]),
        (vec![hinge(1e4), bilinear(1e6)], vec![1.0, 1.0]),
        (
            vec![hinge(1e6), hinge(1e4), hinge(1e5)],
            vec![2.0, -3.0, 1.0],
        ),
    ] {
        let (mut masses, mut contacts, mut loaded) = (Map::new(), Map::new(), Map::new());
        let mut below = "ground".to_owned();
        let (mut known, mut u) = (Vec::new(), 0.0);
        for (i, law) in laws.iter().enumerate() {
            let name = format!("a{i}");
            masses.insert(name.clone(), json!(1));
            loaded.insert(name.clone(), json!(loads[i]));
            let mut contact = law.clone();
            contact["between"] = json!([below, name]);
            contacts.insert(format!("h{i}"), contact);
            let k = law
                .get("k1")
                .or(law.get("k"))
                .and_then(Json::as_f64)
                .unwrap();
            u += loads[i..].iter().sum::<f64>() / k;
            known.push(u);
            below = name;
        }
        let metrics: Vec<String> = masses.keys().map(|name| format!("last({name})")).collect();
        let study = json!({
            "problem": "structure", "parameters": {"dt": 1e-4, "duration": 2e-4},
            "structure": {"masses": masses, "contacts": contacts, "static": loaded},
            "metrics": metrics
        });
        let largest = known.iter().fold(0.0_f64, |most, u| most.max(u.abs()));
        for (found, known) in solve(&read(&study), 0).metrics.iter().zip(known) {
            let found = found.unwrap();
            // Forces within 1e-10, and two steps of what is left.
            assert!(
                (found - known).abs() < 1e-9 * largest,
                "{study}: {found} {known}"
            );
        }
    }
}

/// Bodies on Hertz contacts, the uppermost on a soft spring, too: far below, the free displacement is 10^7 times that of the contacts.
#[test]
fn contacts_below_a_soft_spring_carry_the_weight_that_it_leaves() {
    for (law, stiffness) in [("hertz", "k_h"), ("impact", "k"), ("hunt-crossley", "k_h")] {
        let masses = [0.01, 0.2, 5.0, 100.0];
        let (mut bodies, mut contacts) = (Map::new(), Map::new());
        let mut below = "ground".to_owned();
        for (i, mass) in masses.iter().enumerate() {
            let name = format!("b{i}");
            bodies.insert(name.clone(), json!({"mass": mass, "direction": "y"}));
            let mut contact = json!({"law": law, "gap": 0, "between": [below, name]});
            contact[stiffness] = json!(1e7);
            if law == "hunt-crossley" {
                contact["restitution"] = json!(0.6);
            }
            contacts.insert(format!("c{i}"), contact);
            below = name;
        }
        let study = json!({
            "problem": "structure", "parameters": {"dt": 1e-4, "duration": 2e-3},
            "structure": {
                "masses": bodies, "contacts": contacts, "static": {"gravity": -9.81},
                "springs": [{"name": "s", "between": ["ground", "b3"], "k": 1, "direction": "y"}]
            },
            "metrics": ["min(c0.S)", "max(c0.S)", "last(b3)"]
        });
        let found: Vec<f64> = solve(&read(&study), 0)
            .metrics
            .into_iter()
            .flatten()
            .collect();
        let [least, most, sunk] = found[..] else {
            panic!("{found:?}")
        };
        let known = -9.81 * masses.iter().sum::<f64>() - sunk;
        for force in [least, most] {
            assert!(
                (force - known).abs() < 1e-9 * known.abs(),
                "{law}: {force} {known}"
            );
        }
    }
}

/// Nothing touches b, and no load moves it: it stays where it is, also where a is pushed near it.
#[test]
fn a_body_that_nothing_moves_stays() {
    for law in [
        json!({"law": "impact", "k": 1e5}),
        json!({"law": "hertz", "k_h": 1e5}),
    ] {
        for (load, gap, r) in [(5.0, 0.5, 0.495), (-5.0, 0.01, 0.015)] {
            let mut contact = law.clone();
            (contact["between"], contact["gap"]) = (json!(["a", "b"]), json!(gap));
            let study = json!({
                "problem": "structure", "parameters": {"dt": 1e-3, "duration": 0.01},
                "structure": {
                    "masses": {"a": 1, "b": 1}, "springs": [{"between": ["ground", "a"], "k": 1e3}],
                    "contacts": {"c": contact}, "static": {"a": load}
                },
                "metrics": ["last(a)", "last(b)", "last(c.r)", "peak(b.v)"]
            });
            let found: Vec<f64> = solve(&read(&study), 0)
                .metrics
                .into_iter()
                .flatten()
                .collect();
            // Round-off of a solution.
            for (found, known) in found.iter().zip([load / 1e3, 0.0, r, 0.0]) {
                assert!((found - known).abs() < 1e-12, "{study}: {found} {known}");
            }
        }
    }
}
