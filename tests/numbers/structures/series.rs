//! Laws in series, of which the softest may be anywhere.

use serde_json::{Value as Json, json};
use slipgap::study;

/// Two masses under a pulse with this beside them; the metrics of the first case.
fn metrics(more: &[(&str, Json)], metrics: &[&str]) -> Vec<f64> {
    let mut study = json!({
        "problem": "structure", "parameters": {"dt": 0.002, "duration": 2},
        "structure": {
            "masses": {"a": 100, "b": 150},
            "springs": [{"between": ["ground", "a"], "k": 6200, "c": 78}, {"between": ["ground", "b"], "k": 3500, "c": 72}],
            "ground": {"pulse": {"ricker": {"amplitude": 6, "frequency": 1.5, "at": 0.8, "sampled": 0.01}}}
        },
        "metrics": metrics
    });
    for (key, value) in more {
        match (&mut study["structure"][key], value) {
            (Json::Array(list), Json::Array(more)) => list.extend(more.iter().cloned()),
            (old, value) => *old = value.clone(),
        }
    }
    solved(&study)
}

fn series(laws: &[Json]) -> Vec<(&'static str, Json)> {
    vec![(
        "contacts",
        json!({"f": {"between": ["a", "b"], "series": laws}}),
    )]
}

/// All orders of some things.
fn orders(things: &[Json]) -> Vec<Vec<Json>> {
    match things {
        [] => vec![Vec::new()],
        _ => (0..things.len())
            .flat_map(|first| {
                let mut others = things.to_vec();
                let first = others.remove(first);
                let with = move |rest: Vec<Json>| [vec![first.clone()], rest].concat();
                orders(&others).into_iter().map(with)
            })
            .collect(),
    }
}

#[test]
fn laws_in_series_have_one_force_in_every_order() {
    let metrics_wanted = [
        "peak(a)",
        "peak(f.1.S)",
        "peak(f.2.S)",
        "peak(f.3.S)",
        "energy_error",
    ];
    let bilinear =
        |k: f64, limit: f64| json!({"law": "bilinear", "k1": k, "Fy": limit, "k2": k / 100.0});
    let lists = [
        vec![
            bilinear(1e5, 100.0),
            bilinear(5e4, 50.0),
            bilinear(1e5, 100.0),
        ],
        // Two softest, which may be side by side or not.
        vec![
            bilinear(5e4, 80.0),
            bilinear(5e4, 50.0),
            bilinear(1e5, 100.0),
        ],
        vec![
            json!({"law": "impact", "gap": 0.03, "k": 1e6}),
            json!({"law": "displacement-control", "k": 5e4, "limit": 500}),
            bilinear(2e5, 400.0),
        ],
    ];
    for laws in lists {
        let mut first: Option<Vec<f64>> = None;
        for laws in orders(&laws) {
            let found = metrics(&series(&laws), &metrics_wanted);
            let [u, forces] = [found[0], found[1]];
            assert!(found[4] < 1e-9, "{laws:?}: {found:?}");
            for force in &found[2..4] {
                assert_eq!(*force, forces, "{laws:?}: {found:?}");
            }
            let [u0, force0] = first.get_or_insert_with(|| found.clone())[..2] else {
                unreachable!()
            };
            // Round-off of 1000 steps.
            assert!((u / u0 - 1.0).abs() < 1e-11, "{laws:?}: {u} {u0}");
            assert!(
                (forces / force0 - 1.0).abs() < 1e-11,
                "{laws:?}: {forces} {force0}"
            );
        }
    }
}

#[test]
fn laws_in_series_that_do_not_yield_are_one_spring() {
    // 1/k is the sum of the 1/k.
    let stiff = [3e4, 1e4, 5e4, 1e4, 4e4];
    let spring = 1.0 / stiff.iter().map(|k| 1.0 / k).sum::<f64>();
    let alone = metrics(
        &[("springs", json!([{"between": ["a", "b"], "k": spring}]))],
        &["peak(a)", "peak(b)"],
    );
    let laws = stiff.map(|k| json!({"law": "bilinear", "k1": k, "Fy": 1e9, "k2": k}));
    let found = metrics(&series(&laws), &["peak(a)", "peak(b)", "peak(f.3.S)"]);
    for (peak, alone) in found.iter().zip(alone) {
        // Round-off of 1000 steps.
        assert!((peak / alone - 1.0).abs() < 1e-11, "{peak} {alone}");
    }
}

#[test]
fn a_node_between_two_contacts_is_seen_from_either_side() {
    // Of a contact from b to the node, S is that of the chain with the other sign; links resist both ways alike.
    let [first, second] = [(3e4, 100.0), (5e4, 60.0)]
        .map(|(k, limit)| json!({"law": "bilinear", "k1": k, "Fy": limit, "k2": k / 50.0}));
    let of = |ends: [&str; 2]| {
        let [mut one, mut other] = [first.clone(), second.clone()];
        (one["between"], other["between"]) = (json!(["a", "n"]), json!(ends));
        metrics(
            &[
                ("masses", json!({"a": 100, "b": 150, "n": 0})),
                ("contacts", json!({"one": one, "other": other})),
            ],
            &["peak(a)", "peak(one.S)", "peak(other.S)", "energy_error"],
        )
    };
    let [along, against] = [of(["n", "b"]), of(["b", "n"])];
    assert!(along[1] > 61.0 && along[1] == along[2], "{along:?}");
    assert_eq!(along, against);
}

/// A triple pendulum of W = 1000 kN as three bearings in series (Fenz and Constantinou 2008): mu, the effective radius, and the way to
/// the stop of each. With R1 = R4 = 2 and R2 = R3 = 0.4 they are R2 + R3, R1 - R2 and R4 - R3; the inner bearing has no stop.
const TRIPLE: [[f64; 3]; 3] = [[0.02, 0.8, 9.0], [0.06, 1.6, 0.2], [0.12, 1.6, 0.25]];
const WEIGHT: f64 = 1000.0;
/// Elastic deflection of the friction, and the stiffness of the stops.
const ELASTIC: f64 = 5e-4;
const STOP: f64 = 1e5;

/// One bearing: a pendulum, and a stop in each direction.
fn bearing([mu, radius, way]: [f64; 3]) -> Vec<Json> {
    vec![
        json!({"law": "pendulum", "nu": mu, "N": WEIGHT, "R": radius, "rE": ELASTIC}),
        json!({"law": "restrainer", "slack": way, "k": STOP, "Fy": 1e9, "hardening": 0}),
        json!({"law": "impact", "gap": way, "k": STOP}),
    ]
}

fn triple() -> Vec<Json> {
    TRIPLE
        .map(|given| json!({"parallel": bearing(given)}))
        .to_vec()
}

/// How a bearing of the triple pendulum moves under a first loading of F.
fn moved([mu, radius, way]: [f64; 3], force: f64) -> f64 {
    let [spring, limit] = [WEIGHT / radius, mu * WEIGHT];
    let elastic = force / (limit / ELASTIC + spring);
    let sliding = (force - limit) / spring;
    let stopped = (force - limit + STOP * way) / (spring + STOP);
    elastic.max(sliding.min(stopped))
}

#[test]
fn a_triple_pendulum_has_its_five_regimes() {
    // Regimes: the inner bearing slides alone, then with one and with both of the others, of which one and both stop.
    let slopes = [0.8, 2.4, 4.0, 2.4, 0.8].map(|radius| WEIGHT / radius);
    let forces = [20.0, 60.0, 120.0, 60.0 + 125.0, 120.0 + 156.25, 320.0];
    let total = |force: f64| TRIPLE.iter().map(|given| moved(*given, force)).sum::<f64>();
    for (pair, slope) in forces.windows(2).zip(slopes) {
        // Beside the elastic parts, which are some 1e-2 of the way.
        let [start, end] = [0.2, 0.9].map(|part| pair[0] + part * (pair[1] - pair[0]));
        let ratio = (end - start) / (total(end) - total(start));
        assert!(
            (ratio / slope - 1.0).abs() < 0.03,
            "{pair:?} {ratio} {slope}"
        );
        for sign in [1.0, -1.0] {
            for force in [start, end] {
                let u = sign * total(force);
                let study = json!({
                    "problem": "structure", "parameters": {"dt": 0.01, "duration": 1},
                    "structure": {
                        "masses": {"idle": 1}, "springs": [{"between": ["ground", "idle"], "k": 1}],
                        "supports": {"test": {"displacement": {"t": [0, 1], "u": [0, u]}}},
                        "contacts": {"f": {"between": ["ground", "test"], "series": triple()}}
                    },
                    "metrics": ["last(f.1.1.S)", "last(f.1.2.S)", "last(f.1.3.S)", "last(f.2.1.S)", "last(f.2.2.S)", "last(f.2.3.S)",
                        "last(f.3.1.S)", "last(f.3.2.S)", "last(f.3.3.S)", "last(f.1.1.r)", "last(f.2.1.r)", "last(f.3.1.r)"]
                });
                let forces_and_slips = solved(&study);
                for (i, given) in TRIPLE.iter().enumerate() {
                    let sum: f64 = forces_and_slips[3 * i..3 * i + 3].iter().sum();
                    // Round-off of 100 steps, of r through the slope of the stop.
                    assert!((sum - sign * force).abs() < 1e-9, "{i} {sum} {force}");
                    let r = forces_and_slips[9 + i] - sign * moved(*given, force);
                    assert!(r.abs() < 1e-13, "{i} {r}");
                }
            }
        }
    }
}

/// The metrics of the first case of a study.
fn solved(study: &Json) -> Vec<f64> {
    let study =
        study::parse("study.json", &study.to_string()).unwrap_or_else(|why| panic!("{why}"));
    let case = study.case(0).unwrap();
    let solution = study.problem.solve(&case, &study.metrics);
    let metrics = solution.unwrap_or_else(|why| panic!("{why}")).metrics;
    metrics.into_iter().map(Option::unwrap).collect()
}

/// A deck on a triple pendulum on a ground that shakes by this, to where the outer stops push.
fn shaken(between: [&str; 2], series: &[Json], scale: f64) -> Vec<f64> {
    solved(&json!({
        "problem": "structure", "parameters": {"dt": 0.002, "duration": 10},
        "structure": {
            "masses": {"deck": WEIGHT / 9.81},
            "contacts": {"f": {"between": between, "series": series}},
            "ground": {"sine": {"amplitude": 2.5 * scale, "omega": 2.2, "phase": 0.4}}
        },
        "metrics": ["max(deck)", "min(deck)", "peak(f.1.1.S)", "peak(f.2.1.r)", "peak(f.2.2.S)", "energy_error"]
    }))
}

#[test]
fn a_triple_pendulum_has_no_order_and_no_side() {
    let [first, second, third] = TRIPLE;
    let plain = shaken(["ground", "deck"], &triple(), 1.0);
    assert!(
        plain[0] > 0.2 && plain[1] < -0.2 && plain[4] > 10.0,
        "{plain:?}"
    );
    let near = |a: &[f64], b: &[f64], what: &str| {
        for (a, b) in a.iter().zip(b) {
            // Round-off of 5000 steps through the stops.
            assert!((a - b).abs() < 1e-9 * (1.0 + b.abs()), "{what} {a} {b}");
        }
    };
    // Books: round-off of the forces of a bearing over those of a step.
    assert!(plain[5] < 1e-11, "{plain:?}");
    let of = |numbers: [[f64; 3]; 3], turned: usize| {
        numbers.map(|given| {
            let mut laws = bearing(given);
            laws.rotate_left(turned);
            json!({"parallel": laws})
        })
    };
    for (order, turned) in [([second, first, third], 1), ([third, second, first], 2)] {
        let found = shaken(["ground", "deck"], &of(order, turned), 1.0);
        near(&found[..2], &plain[..2], "order");
        assert!(found[5] < 1e-11, "{found:?}");
    }
    let other = shaken(["deck", "ground"], &triple(), 1.0);
    // Seen from the other side, restrainers and impacts change their parts.
    near(&other[..4], &plain[..4], "side");
    let mirrored = shaken(["ground", "deck"], &triple(), -1.0);
    near(&[-mirrored[1], -mirrored[0]], &plain[..2], "mirror");
}

#[test]
fn springs_in_series_and_parallel_are_one_spring() {
    let link = |k: f64| json!({"law": "bilinear", "k1": k, "Fy": 1e9, "k2": k});
    let beside = |a: f64, b: f64| json!({"parallel": [link(a), link(b)]});
    let chain = |stiffnesses: [f64; 3]| 1.0 / stiffnesses.iter().map(|k| 1.0 / k).sum::<f64>();
    let names = ["peak(a)", "peak(b)"];
    let alone = |spring: f64| {
        metrics(
            &[("springs", json!([{"between": ["a", "b"], "k": spring}]))],
            &names,
        )
    };
    let near = |found: &[f64], alone: &[f64]| {
        for (peak, alone) in found.iter().zip(alone) {
            // Round-off of 1000 steps.
            assert!((peak / alone - 1.0).abs() < 1e-11, "{peak} {alone}");
        }
    };
    let laws = [beside(1e4, 2e4), link(4e4), beside(5e4, 1e3)];
    let found = metrics(
        &series(&laws),
        &["peak(a)", "peak(b)", "peak(f.3.2.S)", "energy_error"],
    );
    near(&found[..2], &alone(chain([3e4, 4e4, 5.1e4])));
    assert!(found[2] > 0.0 && found[3] < 1e-12, "{found:?}");
    // Series in parallel, with parallel in it.
    let inner = json!({"series": [beside(1e4, 2e4), link(4e4), link(1e4)]});
    let contact = json!({"f": {"between": ["a", "b"], "parallel": [link(5e3), inner]}});
    let found = metrics(
        &[("contacts", contact)],
        &["peak(a)", "peak(b)", "peak(f.2.1.2.S)", "peak(f.2.node1)"],
    );
    near(&found[..2], &alone(5e3 + chain([3e4, 4e4, 1e4])));
    assert!(found[2] > 0.0 && found[3] > 0.0);
}

#[test]
fn friction_without_compliance_beside_a_spring_is_in_series() {
    // A block that holds up to 100 beside a spring, behind a spring: until it slides the outer spring alone acts.
    let link = |k: f64| json!({"law": "bilinear", "k1": k, "Fy": 1e9, "k2": k});
    let stuck = json!({"parallel": [{"law": "coulomb", "limit": 1e6}, link(2e4)]});
    let found = metrics(
        &series(&[link(3e4), stuck]),
        &["peak(a)", "peak(b)", "peak(f.2.1.r)"],
    );
    let alone = metrics(
        &[("springs", json!([{"between": ["a", "b"], "k": 3e4}]))],
        &["peak(a)", "peak(b)"],
    );
    for (peak, alone) in found.iter().zip(alone) {
        assert!((peak / alone - 1.0).abs() < 1e-11, "{peak} {alone}");
    }
    assert!(found[2] < 1e-15, "{found:?}");
    let slides = json!({"parallel": [{"law": "coulomb", "limit": 100}, link(2e4)]});
    let found = metrics(
        &series(&[link(3e4), slides]),
        &["peak(f.2.1.S)", "peak(f.2.1.r)", "energy_error"],
    );
    assert!(
        (found[0] - 100.0).abs() < 1e-10 && found[1] > 1e-3 && found[2] < 1e-11,
        "{found:?}"
    );
}

#[test]
fn lists_in_lists_of_their_kind_are_refused() {
    let law = json!({"law": "bilinear", "k1": 1e4, "Fy": 100, "k2": 0});
    let of = |outer: &str, inner: Json| {
        let study = json!({
            "problem": "structure", "parameters": {"dt": 0.01, "duration": 1},
            "structure": {
                "masses": {"a": 1}, "contacts": {"f": {"between": ["ground", "a"], outer: [law.clone(), inner]}}
            },
            "metrics": ["peak(a)"]
        });
        study::parse("study.json", &study.to_string())
            .unwrap_err()
            .to_string()
    };
    let two = json!([law, law]);
    for (outer, inner, expected) in [
        (
            "series",
            json!({"series": two}),
            "write its laws into the outer one",
        ),
        (
            "parallel",
            json!({"parallel": two}),
            "write its laws into the outer one",
        ),
        (
            "series",
            json!({"parallel": [law, {"series": two}]}),
            "parallel in series has laws only",
        ),
        (
            "series",
            json!({"parallel": two, "gap": 0.1}),
            "has no gap: the laws of the list have their own",
        ),
        (
            "series",
            json!({"parallel": [law]}),
            "a list of two laws or more",
        ),
    ] {
        let why = of(outer, inner);
        assert!(why.contains(expected), "{why}");
    }
}

/// Four masses, of which two hold the ends of a contact by springs, under a load from rest. Places, lengths and forces are units, and the
/// names order the nodes. The motion of the loaded mass, and S of both laws, in the first units.
fn stuck(law: &Json, names: [&str; 6], [length, force]: [f64; 2]) -> [Vec<f64>; 3] {
    let [a, b, c, d, y, z] = names;
    let stiffness = force / length;
    let spring = |one: &str, other: &str, k: f64, damping: f64| json!({"between": [one, other], "k": k * stiffness, "c": damping * stiffness});
    let mut springs = vec![
        spring("ground", a, 398.9726916899273, 0.82381717138899),
        spring(a, b, 101.93652450420619, 0.9519649213526886),
        spring(b, c, 37.27896298629898, 0.1794229774479621),
        spring(c, d, 37.6360543950915, 0.01100343079471433),
        spring(a, y, 820.8317814106814, 0.0),
        spring(d, z, 3586.8830387313396, 0.0),
    ];
    if a > b {
        springs.reverse();
    }
    let mass = |m: f64| json!(m * stiffness);
    let mut law = law.clone();
    law["k_h"] = json!(8329.542440279285 * force / length.powf(1.5));
    let written = json!({
        "problem": "structure", "parameters": {"dt": 0.001, "duration": 0.2},
        "structure": {
            "masses": {
                a: mass(3.6892283601729017), b: mass(2.1739207967570398), c: mass(0.4516445346942201),
                d: mass(2.587425324815951), y: 0, z: 0
            },
            "springs": springs,
            "contacts": {"f": {
                "parallel": [law, {"law": "coulomb", "limit": 0.9348684461210188 * force}], "between": [y, z]
            }},
            "loads": [{"at": a, "sine": {"amplitude": 4.833765128744049 * force, "omega": 9.202525809221013, "phase": 0.5}}]
        },
        "metrics": [format!("peak({a})")],
        "figures": [{"name": "h", "kind": "history", "y": [a, "f.1.S", "f.2.S"]}]
    });
    let study =
        study::parse("study.json", &written.to_string()).unwrap_or_else(|why| panic!("{why}"));
    let case = study.case(0).unwrap();
    let solution = study.problem.solve(&case, &study.metrics);
    let motion = solution.unwrap_or_else(|why| panic!("{why}")).computed;
    let channel = |i: usize, unit: f64| {
        motion
            .channel(i)
            .iter()
            .map(|x| x / unit)
            .collect::<Vec<_>>()
    };
    [channel(0, length), channel(1, force), channel(2, force)]
}

#[test]
fn an_impact_that_friction_holds_closed_begins_when_it_slides() {
    // Held at r = 0 but for round-off, whose sign depends on order and units. An overlap or a speed of this size is no impact.
    let names = ["a", "b", "c", "d", "y", "z"];
    let reversed = ["z", "y", "d", "c", "b", "a"];
    for name in ["ye", "hunt-crossley", "hertz-damp"] {
        let law = json!({"law": name, "restitution": 0.8884100752516936});
        let first = stuck(&law, names, [1.0, 1.0]);
        let pushes = |force: &[f64]| force.iter().any(|s| *s < -0.1);
        assert!(pushes(&first[1]), "{law}");
        for (names, units) in [
            (reversed, [1.0, 1.0]),
            (names, [37.3, 0.0291]),
            (names, [0.001, 1000.0]),
            (reversed, [3.7e4, 0.11]),
        ] {
            let other = stuck(&law, names, units);
            for (curve, other) in first.iter().zip(&other) {
                let size = curve.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
                let pairs = curve.iter().zip(other);
                let error = pairs.fold(0.0, |most: f64, (a, b)| most.max((a - b).abs()));
                // Round-off of 200 steps, which the stiffness of the contact magnifies.
                assert!(
                    error < 1e-10 * size,
                    "{law} {names:?} {units:?}: {error:e} of {size}"
                );
            }
        }
    }
}
