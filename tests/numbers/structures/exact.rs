//! Exact motions and time steps of structures compared with an independent program (tests/reference/structures/structures.py), which
//! integrates by Dormand and Prince's method of order 8 from event to event.

use serde_json::Value as Json;
use slipgap::contact::ClippedLine;
use slipgap::exact::events;
use slipgap::solve::structure::{Prepared, run};
use slipgap::system::structure::{
    Contact, Limit, Load, Node, Signal, Structure, StructureLaw, Symmetric, Table, between,
};
use std::sync::Arc;

fn all() -> Vec<Json> {
    serde_json::from_str(include_str!("../../data/structures.json")).unwrap()
}

fn number(json: &Json) -> f64 {
    json.as_f64().unwrap()
}

fn numbers(json: &Json) -> Vec<f64> {
    json.as_array().unwrap().iter().map(number).collect()
}

fn list(json: &Json) -> &[Json] {
    json.as_array().unwrap()
}

/// A node; null is the ground.
fn node(json: &Json) -> Option<usize> {
    json.as_u64().map(|node| node as usize)
}

fn signal(json: &Json) -> Arc<Signal> {
    Arc::new(match json.get("sine") {
        Some(sine) => Signal::Sine {
            amplitude: number(&sine["amplitude"]),
            omega: number(&sine["omega"]),
            phase: number(&sine["phase"]),
        },
        None => {
            let table = &json["table"];
            Signal::Table(Table::new(numbers(&table["t"]), numbers(&table["f"])).unwrap())
        }
    })
}

fn limit(json: &Json) -> Limit {
    let varying = json["signal"].is_object();
    Limit {
        constant: number(&json["constant"]),
        varying: varying.then(|| (number(&json["factor"]), signal(&json["signal"]))),
        ..Limit::constant(0.0)
    }
}

fn relation(json: &Json) -> StructureLaw {
    match json["law"].as_str().unwrap() {
        "impact" => StructureLaw::new(
            ClippedLine::Spring {
                stiffness: number(&json["k"]),
            },
            None,
        ),
        "displacement-control" => StructureLaw::new(
            ClippedLine::Elastic {
                stiffness: number(&json["k"]),
            },
            limit(&json["limit"]),
        ),
        "velocity-control" => StructureLaw::new(
            ClippedLine::Viscous {
                viscosity: number(&json["c"]),
            },
            limit(&json["limit"]),
        ),
        law => panic!("{law}"),
    }
}

fn structure(json: &Json) -> Structure {
    let masses = numbers(&json["masses"]);
    let mut stiffness = Symmetric::zeros(masses.len());
    let mut damping = Symmetric::zeros(masses.len());
    for spring in list(&json["springs"]) {
        let between = [node(&spring[0]), node(&spring[1])];
        stiffness.add_spring(between, number(&spring[2]));
        damping.add_spring(between, number(&spring[3]));
    }
    let contact = |json: &Json| Contact {
        name: String::new(),
        along: between([node(&json["between"][0]), node(&json["between"][1])]),
        gap: number(&json["gap"]),
        law: relation(json),
    };
    let load = |json: &Json| Load {
        pattern: list(&json["pattern"])
            .iter()
            .map(|part| (node(&part[0]).unwrap(), number(&part[1])))
            .collect(),
        signal: signal(&json["signal"]),
    };
    let named = |mass: f64| Node {
        name: String::new(),
        mass,
        direction: Default::default(),
    };
    let mut structure = Structure::new(masses.into_iter().map(named).collect());
    structure.stiffness = stiffness;
    structure.damping = damping;
    structure.contacts = list(&json["contacts"]).iter().map(contact).collect();
    structure.loads = list(&json["loads"]).iter().map(load).collect();
    structure.displacement = numbers(&json["displacement"]);
    structure.velocity = numbers(&json["velocity"]);
    structure
}

const CHANNELS: [&str; 5] = ["u", "v", "r", "rdot", "S"];

/// The largest difference of each channel from the rows of the data, over its amplitude; `motion` has the rows at the same times.
fn errors(json: &Json, motion: &[[Vec<f64>; 5]]) -> [f64; 5] {
    let mut errors = [0.0; 5];
    for (c, name) in CHANNELS.iter().enumerate() {
        let amplitude = number(&json["amplitude"][name]);
        let rows = list(&json["rows"][name]);
        assert_eq!(rows.len(), motion.len());
        for (row, channels) in rows.iter().zip(motion) {
            for (expected, found) in numbers(row).iter().zip(&channels[c]) {
                errors[c] = f64::max(errors[c], (expected - found).abs() / amplitude);
            }
        }
    }
    errors
}

#[test]
fn exact_motions_are_those_of_an_independent_integrator() {
    for json in all() {
        let times = numbers(&json["rows"]["t"]);
        let mut motion = Vec::new();
        let visit = |_: usize, state: &events::State| {
            let channels = [state.u, state.v, state.r, state.rate, state.force];
            motion.push(channels.map(<[f64]>::to_vec));
        };
        let summary = events::run(&structure(&json), &times, visit).unwrap();
        let errors = errors(&json, &motion);
        // The data are good to 1.5e-12 of the amplitude; a stiff contact turns an error of r into one of S.
        for (name, error) in CHANNELS.iter().zip(errors) {
            assert!(error < 2e-10, "{}: {name} {error:e}", json["name"]);
        }
        // Every change of a contact of the data is found, and no other.
        let expected = list(&json["events"]).len();
        assert!(
            summary.events.len() >= expected,
            "{}: {} of {expected}",
            json["name"],
            summary.events.len()
        );
    }
}

/// The motion by n steps at the times of the rows.
fn stepped(json: &Json, n: usize) -> Vec<[Vec<f64>; 5]> {
    let structure = structure(json);
    let rows = list(&json["rows"]["t"]).len() - 1;
    let prepared = Prepared::new(&structure, number(&json["end"]) / n as f64).unwrap();
    let mut motion = Vec::new();
    let [end] = run(&[&structure], &prepared, n, |step, state| {
        if step % (n / rows) == 0 {
            let nodes = 0..structure.len();
            let contacts = || (0..structure.contacts.len()).map(|c| state.contact(c));
            motion.push([
                nodes.clone().map(|i| state.displacement(i).0[0]).collect(),
                nodes.map(|i| state.velocity(i).0[0]).collect(),
                contacts()
                    .map(|contact| contact.displacement.0[0])
                    .collect(),
                contacts().map(|contact| contact.velocity.0[0]).collect(),
                contacts().map(|contact| contact.force.0[0]).collect(),
            ]);
        }
    });
    end.unwrap();
    motion
}

#[test]
fn time_steps_converge_to_the_independent_motion_with_order_two() {
    for json in all() {
        // Where contacts change within a step, single errors are irregular: the order is that over a factor of 16.
        let [coarse, fine] = [4_000, 64_000].map(|n| errors(&json, &stepped(&json, n))[0]);
        let order = (coarse / fine).log(16.0);
        assert!(
            order > 1.6 && fine < 1e-4,
            "{}: {coarse:e} {fine:e}, order {order}",
            json["name"]
        );
    }
}
