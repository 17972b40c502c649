//! Static loads, laws in series and in parallel, normal forces by another contact, and imposed displacements.

use serde_json::{Value as Json, json};
use slipgap::study::{self, Study};

fn parse(study: &Json) -> Study {
    study::parse("study.json", &study.to_string()).unwrap()
}

fn fault(study: &Json) -> String {
    let fault = study::parse("study.json", &study.to_string()).unwrap_err();
    fault.to_string()
}

/// The metrics of case 0.
fn metrics(study: &Json) -> Vec<f64> {
    let study = parse(study);
    let solution = study.problem.solve(&study.case(0).unwrap(), &[]).unwrap();
    solution.metrics.into_iter().map(Option::unwrap).collect()
}

/// The channels of the history figure of case 0.
fn channels(study: &Json) -> Vec<Vec<f64>> {
    let study = parse(study);
    let solution = study.problem.solve(&study.case(0).unwrap(), &[]).unwrap();
    let figure = study.problem.schema().channels.len();
    let channels = (0..figure).map(|channel| solution.computed.channel(channel).to_vec());
    channels.collect()
}

/// A deck on a column under a sine, with these contacts.
fn deck(contacts: Json, dt: f64, metrics: &[&str]) -> Json {
    json!({
        "problem": "structure",
        "parameters": {"dt": dt, "duration": 6},
        "structure": {
            "masses": {"deck": 100},
            "springs": [{"between": ["ground", "deck"], "k": 4000, "c": 50}],
            "contacts": contacts,
            "ground": {"sine": {"amplitude": 6, "omega": 7}}
        },
        "metrics": metrics
    })
}

#[test]
fn gravity_and_forces_move_a_structure_before_it_starts() {
    let study = json!({
        "problem": "structure",
        "parameters": {"dt": 0.01, "duration": 1},
        "structure": {
            "masses": {"a": {"mass": 2, "direction": "y"}, "b": {"mass": 3, "direction": "y"}, "c": 5},
            "springs": [
                {"between": ["ground", "a"], "k": 100, "direction": "y"},
                {"between": ["a", "b"], "k": 50, "direction": "y"},
                {"between": ["ground", "c"], "k": 10}
            ],
            "static": {"gravity": -10, "b": "-2*5", "c": 4}
        },
        "metrics": ["max(a)", "min(a)", "max(b)", "min(b)", "max(c)", "min(c)", "energy_error"]
    });
    let found = metrics(&study);
    // 5 masses and 10 on the upper spring, 3 masses and 10 on the lower one.
    let (a, b, c) = (-0.6, -0.6 - 0.8, 0.4);
    for (found, expected) in found.iter().zip([a, a, b, b, c, c]) {
        assert!((found - expected).abs() < 1e-14, "{found} {expected}");
    }
    assert!(found[6] < 1e-14);
}

#[test]
fn the_steps_from_equilibrium_approach_the_exact_motion() {
    let error = |dt: f64| {
        let mut study = deck(
            json!({
                "bearing": {"law": "displacement-control", "between": ["ground", "deck"], "k": 3e4, "limit": 150},
                "stop": {"law": "impact", "between": ["deck", "ground"], "gap": 0.02, "k": 1e5}
            }),
            dt,
            &["step_error(deck)", "energy_error"],
        );
        study["structure"]["contacts_reference"] = json!("softened");
        study["structure"]["static"] = json!({"deck": 120});
        let found = metrics(&study);
        assert!(found[1] < 1e-13, "{}", found[1]);
        found[0]
    };
    let (coarse, fine) = (error(1e-3), error(2.5e-4));
    // Second order but for the steps in which a contact changes its phase.
    assert!(fine < coarse / 8.0 && fine < 1e-4, "{coarse:e} {fine:e}");
}

#[test]
fn a_start_has_no_displacement_beside_static_loads() {
    let mut study = deck(json!({}), 0.01, &["peak(deck)"]);
    study["structure"]["static"] = json!({"deck": 1});
    study["structure"]["start"] = json!({"deck": {"u": 1}});
    let message = fault(&study);
    assert!(message.contains("start.deck.u"), "{message}");
    assert!(
        message.contains("static loads give the displacements"),
        "{message}"
    );
}

#[test]
fn static_loads_that_nothing_holds_are_named() {
    let written = json!({
        "problem": "structure",
        "parameters": {"dt": 0.01, "duration": 1},
        "structure": {
            "masses": {"a": 1, "b": 1},
            "springs": [{"between": ["ground", "a"], "k": 100}],
            "contacts": {"slider": {"law": "coulomb", "between": ["a", "b"], "limit": 2}},
            "static": {"b": 3}
        },
        "metrics": ["peak(b)"]
    });
    let study = parse(&written);
    let why = study
        .problem
        .solve(&study.case(0).unwrap(), &[])
        .unwrap_err();
    assert!(why.to_string().contains("nothing holds node b"), "{why}");
}

#[test]
fn springs_in_series_are_one_spring() {
    let of = |contact: Json, force: &str| {
        let study = deck(
            json!({"c": contact}),
            1e-3,
            &["max(deck)", "min(deck)", force],
        );
        metrics(&study)
    };
    let k = 1.0 / (1.0 / 1e5 + 1.0 / 2e4);
    let impact = |k: f64, gap: f64| json!({"law": "impact", "k": k, "gap": gap});
    let friction =
        |k: f64, limit: f64| json!({"law": "displacement-control", "k": k, "limit": limit});
    for (parts, mut one) in [
        ([impact(1e5, 0.02), impact(2e4, 0.01)], impact(k, 0.03)),
        (
            [friction(1e5, 900.0), friction(2e4, 300.0)],
            friction(k, 300.0),
        ),
    ] {
        one["between"] = json!(["deck", "ground"]);
        let series = of(
            json!({"between": ["deck", "ground"], "series": parts}),
            "peak(c.2.S)",
        );
        let expected = of(one, "peak(c.S)");
        for (a, b) in series.iter().zip(&expected) {
            // Round-off of the steps.
            assert!((a - b).abs() < 1e-9 * b.abs(), "{series:?} {expected:?}");
        }
    }
}

#[test]
fn a_gap_in_series_with_any_law_has_one_force() {
    for law in [
        json!({"law": "displacement-control", "k": 2e4, "limit": 200}),
        json!({"law": "bouc-wen", "k": 2e4, "limit": 200}),
        json!({"law": "dahl", "k": 2e4, "limit": 200}),
        json!({"law": "bilinear", "k1": 2e4, "Fy": 200, "k2": 100}),
        json!({"law": "viscous", "c": 2000, "a": 1}),
        json!({"law": "viscous", "c": 100, "a": 0.5}),
        json!({"law": "tanh", "c": 2e4, "limit": 200}),
    ] {
        let gap = json!({"law": "impact", "gap": 0.02, "k": 1e5});
        let contact = json!({"between": ["deck", "ground"], "series": [gap, law]});
        let mut study = deck(
            json!({"soil": contact}),
            1e-3,
            &["peak(soil.1.S)", "peak(soil.2.S)", "energy_error"],
        );
        study["figures"] = json!([{"name": "h", "kind": "history", "y": ["soil.1.S", "soil.2.S"]}]);
        let found = metrics(&study);
        assert!(found[0] > 10.0 && found[2] < 1e-12, "{law} {found:?}");
        let [first, second] = &channels(&study)[..] else {
            panic!("two channels");
        };
        assert_eq!(first, second, "{law}");
    }
}

#[test]
fn laws_in_parallel_are_contacts_of_the_same_nodes() {
    let [a, b] = [
        json!({"law": "bilinear", "k1": 3000, "Fy": 20, "k2": 100}),
        json!({"law": "viscous", "c": 20, "a": 0.5}),
    ];
    let parallel = deck(
        json!({"d": {"between": ["ground", "deck"], "parallel": [a, b]}}),
        1e-3,
        &["max(deck)", "peak(d.1.S)", "peak(d.2.S)"],
    );
    let with_nodes = |mut law: Json| {
        law["between"] = json!(["ground", "deck"]);
        law
    };
    let apart = deck(
        json!({"e": with_nodes(a.clone()), "f": with_nodes(b.clone())}),
        1e-3,
        &["max(deck)", "peak(e.S)", "peak(f.S)"],
    );
    assert_eq!(metrics(&parallel), metrics(&apart));
}

#[test]
fn a_list_has_two_laws_or_more_and_no_law_beside_it() {
    let law = json!({"law": "impact", "k": 1e4});
    let one = json!({"c": {"between": ["ground", "deck"], "series": [law]}});
    let message = fault(&deck(one, 1e-3, &["peak(deck)"]));
    assert!(message.contains("a list of two laws or more"), "{message}");
    let both = json!({"c": {"between": ["ground", "deck"], "k": 1, "series": [law, law]}});
    let message = fault(&deck(both, 1e-3, &["peak(deck)"]));
    assert!(
        message.contains("a contact with series has no k"),
        "{message}"
    );
}

#[test]
fn a_contact_presses_another_one() {
    // The weight of a block on a stiff floor is its normal force: while it rests there, the limit is that of a constant N.
    let block = |normal: Json, vertical: f64, dt: f64| {
        json!({
            "problem": "structure",
            "parameters": {"dt": dt, "duration": 4},
            "structure": {
                "masses": {"x": 2, "y": {"mass": 2, "direction": "y"}},
                "springs": [{"between": ["ground", "x"], "k": 50}],
                "contacts": {
                    "floor": {"law": "impact", "between": ["ground", "y"], "k": 1e4},
                    "slide": {"law": "displacement-control", "between": ["ground", "x"], "k": 2000, "nu": 0.3, "N": normal}
                },
                "static": {"gravity": -10},
                "ground": {
                    "x": {"sine": {"amplitude": 6, "omega": 3}},
                    "y": {"sine": {"amplitude": vertical, "omega": 9}}
                }
            },
            "metrics": ["max(x)", "min(x)", "peak(slide.S)", "last(x)"]
        })
    };
    let pressed = json!({"contact": "floor"});
    let (found, expected) = (
        metrics(&block(pressed.clone(), 0.0, 0.002)),
        metrics(&block(json!(20), 0.0, 0.002)),
    );
    for (a, b) in found.iter().zip(&expected) {
        // Round-off of a force of 20 that rests.
        assert!((a - b).abs() < 1e-11, "{found:?} {expected:?}");
    }
    // With vertical motion the block slides and sticks: of second order, within what its stops within a step change.
    let last = |dt: f64| metrics(&block(pressed.clone(), 4.0, dt))[3];
    let reference = last(6.25e-5);
    let [coarse, fine] = [4e-3, 1e-3].map(|dt| (last(dt) - reference).abs());
    let ratio = coarse / fine;
    assert!(
        (12.0..30.0).contains(&ratio) && fine < 1e-4,
        "{coarse:e} {fine:e}"
    );
    let unknown = fault(&block(json!({"contact": "flor"}), 0.0, 0.01));
    assert!(unknown.contains("did you mean \"floor\""), "{unknown}");
}

#[test]
fn several_bearings_and_springs_press_a_contact() {
    let block = |vertical: Json, springs: Json, normal: Json, dt: f64, method: &str| {
        let mut study = json!({
            "problem": "structure",
            "parameters": {"dt": dt, "duration": 1, "method": method},
            "structure": {
                "masses": {"x": 2, "y": {"mass": 2, "direction": "y"}},
                "springs": springs,
                "contacts": {
                    "slide": {"law": "displacement-control", "between": ["ground", "x"], "k": 2000, "nu": 0.3, "N": normal}
                },
                "static": {"gravity": -10},
                "ground": {
                    "x": {"sine": {"amplitude": 6, "omega": 3}},
                    "y": {"sine": {"amplitude": 4, "omega": 9}}
                }
            },
            "metrics": ["max(x)", "min(x)", "peak(slide.S)", "last(x)", "last(y)"]
        });
        for (name, law) in vertical.as_object().unwrap() {
            study["structure"]["contacts"][name] = law.clone();
        }
        study
    };
    let floor = |k: f64| json!({"law": "impact", "between": ["ground", "y"], "k": k});
    let lateral = json!({"between": ["ground", "x"], "k": 50});
    let one = json!([lateral]);
    let spring = |k: f64, name: &str| json!({"between": ["ground", "y"], "name": name, "k": k});
    let two = json!([lateral, spring(2500.0, "pad"), spring(7500.0, "other")]);
    for method in ["average-acceleration", "hht"] {
        let of = |vertical: &Json, springs: &Json, normal: Json| {
            metrics(&block(
                vertical.clone(),
                springs.clone(),
                normal,
                0.001,
                method,
            ))
        };
        // One bearing; a quarter and three quarters of it; one with a spring; springs alone: the mass never lifts off.
        let alone = json!({"floor": floor(1e4)});
        let expected = of(&alone, &one, json!({"contact": "floor"}));
        let parts = json!({"left": floor(2500.0), "right": floor(7500.0)});
        let found = [
            of(&parts, &one, json!({"contact": ["left", "right"]})),
            of(&json!({}), &two, json!({"contact": ["other", "pad"]})),
            of(
                &json!({"left": floor(2500.0)}),
                &json!([lateral, spring(7500.0, "other")]),
                json!({"contact": ["left", "other"]}),
            ),
        ];
        for found in &found {
            for (a, b) in found.iter().zip(&expected) {
                // Round-off of 1000 steps of a stiff spring.
                assert!(
                    (a - b).abs() < 1e-9 * b.abs().max(0.01),
                    "{found:?} {expected:?}"
                );
            }
        }
    }
    // The limit of a spring at rest is nu k u = nu m g, on the mass that it carries and on no other.
    let quiet = |normal: Json| {
        let mut study = block(
            json!({}),
            two.clone(),
            normal,
            0.001,
            "average-acceleration",
        );
        study["structure"]["ground"] = json!({"x": {"sine": {"amplitude": 60, "omega": 3}}});
        metrics(&study)[2]
    };
    for (normal, expected) in [("pad", 1.5), ("other", 4.5)] {
        let found = quiet(json!({"contact": normal}));
        assert!((found - expected).abs() < 1e-11, "{normal} {found}");
    }
}

#[test]
fn what_does_not_press_is_no_normal_force() {
    let study = |law: Json, normal: Json| {
        let mut law = law;
        law["between"] = json!(["ground", "y"]);
        json!({
            "problem": "structure", "parameters": {"dt": 0.001, "duration": 0.01},
            "structure": {
                "masses": {"x": 2, "y": 2},
                "springs": [{"between": ["ground", "x"], "k": 50}, {"between": ["ground", "y"], "k": 50, "name": "pad"}],
                "contacts": {
                    "other": law,
                    "slide": {"law": "coulomb", "between": ["ground", "x"], "nu": 0.3, "N": {"contact": normal}}
                }
            },
            "metrics": ["peak(x)"]
        })
    };
    for law in [
        json!({"law": "restrainer", "k": 10, "Fy": 1}),
        json!({"law": "bilinear", "k1": 10, "Fy": 1, "k2": 1}),
        json!({"law": "viscous", "c": 1, "a": 1}),
        json!({"law": "coulomb", "limit": 1}),
    ] {
        let name = law["law"].as_str().unwrap().to_owned();
        let message = fault(&study(law, json!(["pad", "other"])));
        let expected = format!(
            "contact other with law {name} does not press; N may name springs, and contacts with law impact"
        );
        assert!(message.contains(&expected), "{message}");
    }
    let push = || json!({"law": "impact", "k": 10});
    let again = fault(&study(push(), json!(["other", "other"])));
    assert!(again.contains("other presses already"), "{again}");
    let unknown = fault(&study(push(), json!(["pat"])));
    assert!(unknown.contains("did you mean \"pad\""), "{unknown}");
    let why = fault(&study(push(), json!("slide")));
    assert!(why.contains("a contact does not press itself"), "{why}");
    let empty = fault(&study(push(), json!([])));
    assert!(empty.contains("a list of one name or more"), "{empty}");
}

#[test]
fn imposed_displacements_turn_where_the_table_does() {
    let study = json!({
        "problem": "structure",
        "parameters": {"dt": 0.01, "duration": 8},
        "structure": {
            "masses": {"idle": 1},
            "springs": [{"between": ["ground", "idle"], "k": 1}],
            "supports": {"top": {"displacement": {"t": [0, 1, 3, 5, 6], "u": [0, 2, -2, 3, 0]}}},
            "contacts": {"part": {"law": "displacement-control", "between": ["ground", "top"], "k": 10, "limit": 8}}
        },
        "metrics": ["max(top)", "min(top)", "last(top)", "last(part.S)"],
        "figures": [{"name": "loop", "kind": "history", "y": ["top", "part.S"]}]
    });
    let found = metrics(&study);
    for (found, expected) in found.iter().zip([3.0, -2.0, 0.0]) {
        assert!((found - expected).abs() < 1e-14, "{found} {expected}");
    }
    // Elastic with 10 to a force of 8, which stays while the part slides: S = clip(S + 10 du).
    let [u, force] = &channels(&study)[..] else {
        panic!("two channels");
    };
    let (mut s, mut before) = (0.0_f64, 0.0);
    for (u, found) in u.iter().zip(force) {
        s = (s + 10.0 * (u - before)).clamp(-8.0, 8.0);
        before = *u;
        assert!((s - found).abs() < 1e-12, "{s} {found}");
    }
    let mut away = study.clone();
    away["structure"]["supports"]["top"]["displacement"]["u"][0] = json!(1);
    let message = fault(&away);
    assert!(message.contains("u = 0 at the first one"), "{message}");
}
