//! Faults of an exact motion, planted: it is that of a structure with another start, load, law or support than the steps have.

use super::*;
use crate::contact::offer::Form;
use crate::contact::{BoucWen, ContactKind, ContactLaw, Dahl, HuntCrossley, Lugre, Pendulum, Tanh};
use crate::methods::AverageAcceleration;
use crate::problem::structure::channels::names::Names;
use crate::problem::structure::motions::exact_motion;
use crate::solve::structure::settle;
use crate::system::structure::{Contact, Limit, Load, Node, Signal, StructureLaw, Table};
use std::sync::Arc;

/// A mass of 1 on a spring of 100 with a contact to the ground, from this displacement and velocity.
fn mass(law: StructureLaw, [u, v]: [f64; 2]) -> Structure {
    let mut structure = Structure::new(vec![Node {
        name: "m".into(),
        mass: 1.0,
        direction: Default::default(),
    }]);
    structure.stiffness.add(0, 0, 100.0);
    structure.contacts.push(Contact {
        name: "c".into(),
        along: vec![(0, 1.0)],
        gap: 0.0,
        law,
    });
    structure.displacement = vec![u];
    structure.velocity = vec![v];
    structure
}

/// Adds a static load.
fn load(mut structure: Structure, p: f64) -> Structure {
    let table = Table::new(vec![0.0, 1.0], vec![1.0, 1.0]);
    structure.loads.push(Load {
        pattern: vec![(0, p)],
        signal: Arc::new(Signal::Table(table.unwrap())),
    });
    structure.preload.load = vec![p];
    settle(&mut structure).unwrap();
    structure
}

fn friction(law: ContactLaw) -> StructureLaw {
    StructureLaw::new(law, Limit::constant(2.0)).from_its_answer()
}

/// Laws whose motion is integrated.
fn laws() -> Vec<StructureLaw> {
    let (compliance, limit) = (1.0 / 2000.0, 2.0);
    let lugre = Lugre {
        sigma0: 800.0,
        sigma1: 20.0,
        sigma2: 0.5,
        limit,
        static_limit: limit,
        stribeck_velocity: 1.0,
    };
    vec![
        friction(ContactLaw::Lugre(lugre)),
        friction(ContactLaw::Dahl(Dahl {
            compliance,
            limit,
            exponent: 1.0,
        })),
        friction(ContactLaw::BoucWen(BoucWen {
            compliance,
            limit,
            exponent: 2.0,
            beta: 0.5,
        })),
        friction(ContactLaw::Tanh(Tanh {
            compliance: 0.02,
            limit,
            ratio: 1.0,
            rate: 0.0,
        })),
        StructureLaw::new(
            Form::of(ContactLaw::HuntCrossley(HuntCrossley {
                stiffness: 2e4,
                damping: 0.5,
            }))
            .with_restitution(0.7),
            None,
        )
        .from_its_answer(),
    ]
}

/// What a study says of a motion.
struct Said {
    /// The error of the motion by two tolerances, and `reference_error`.
    estimate: f64,
    error: f64,
    /// The rms of the motion, and the distance of the given exact motion from that of the structure of the steps.
    rms: f64,
    fault: f64,
}

/// `reference_error` of a channel where the exact motion is that of `other`.
fn said(sound: &Structure, other: &Structure, channel: &str, dt: f64) -> Said {
    let names = Names::new(vec!["m".into()], Vec::new(), Vec::new())
        .with_contacts(vec!["c".into(), "idle".into()]);
    let channel = Channel::parse(channel, &names).unwrap();
    let numbering = Numbering::new(1, Vec::new(), 1, Vec::new());
    let numbers: Vec<Number> = channel.numbers(&numbering).collect();
    let last = (0.4 / dt).round() as u64;
    let method = AverageAcceleration.into();
    let recording = Recording {
        last,
        numbers: &numbers,
        energy: false,
        watch: None,
    };
    let prepared = motion::prepare(sound, &method, dt).unwrap();
    let [run] = motion::steps(&[sound], &prepared, recording);
    let computed = run.unwrap().0;
    let times: Vec<f64> = (0..=last).map(|i| i as f64 * dt).collect();
    let exact = |of: &Structure| exact_motion::exact(of, &times, &numbers).unwrap();
    let [right, given] = [sound, other].map(exact);
    let coarse = exact_motion::coarse(other, &times, &numbers)
        .unwrap()
        .unwrap();
    let steps = Stepped {
        structure: sound,
        numbering: &numbering,
        method: &method,
        dt,
        last,
    };
    let errors = steps.reference_errors(
        &[(&channel, 0..steps.last as usize + 1)],
        &computed,
        [&given, &coarse],
    );
    let of = |motion: &Recorded| motion.channel(&channel, &numbering);
    Said {
        estimate: difference(&of(&given), &of(&coarse), 1.0),
        error: errors[0],
        rms: reduce::rms(&of(&right)),
        fault: reduce::rms_error(&of(&right), &of(&given)),
    }
}

/// The fault is a part of the motion, the tolerances do not show it, and `reference_error` has its size: each step of the first
/// order of these motions would err by less than a tenth of it after five halvings.
fn assert_seen(sound: &Structure, other: &Structure, channel: &str, dt: f64, what: &str) {
    let right = said(sound, sound, channel, dt);
    assert_eq!(right.error, right.estimate, "{what} {channel} {dt}");
    assert!(right.error < 1e-8 * right.rms, "{what} {channel} {dt}");
    let wrong = said(sound, other, channel, dt);
    assert!(wrong.fault > 1e-3 * right.rms, "{what} {channel} {dt}");
    assert!(wrong.estimate < 1e-8 * right.rms, "{what} {channel} {dt}");
    let part = wrong.error / wrong.fault;
    assert!((0.9..1.01).contains(&part), "{what} {channel} {dt}: {part}");
}

#[test]
fn a_pendulum_that_starts_away_from_its_middle_with_bent_friction_is_seen() {
    let pendulum = friction(ContactLaw::Pendulum(Pendulum {
        compliance: 1.0 / 2000.0,
        limit: 2.0,
        restoring: 10.0,
        at_rest: [2.0, 1.0],
        rising: [1.0, 0.0],
    }));
    let mut swinging = mass(pendulum, [-0.01, 0.0]);
    // A pendulum alone has a motion by events. This contact makes it an integrated one, and never closes.
    let idle = mass(laws().remove(4), [0.0; 2]).contacts.remove(0);
    swinging.contacts.push(Contact { gap: 5.0, ..idle });
    // S = 0 at rest, so that friction balances (N/R) r: a start that integrated motions once had.
    let mut other = swinging.clone();
    other.preload.forces = vec![Some(0.0), None];
    for dt in [0.004, 0.001, 0.00025] {
        for channel in ["m", "m.v", "c.S"] {
            assert_seen(&swinging, &other, channel, dt, "pendulum");
        }
    }
}

#[test]
fn a_bristle_that_forgets_its_static_deflection_is_seen() {
    let lugre = laws().remove(0);
    let driven = load(mass(lugre, [0.0, -0.5]), 1.2);
    let mut other = driven.clone();
    other.preload.forces = vec![None];
    for dt in [0.002, 0.001, 0.00025] {
        for channel in ["m", "m.v"] {
            assert_seen(&driven, &other, channel, dt, "lugre");
        }
    }
}

#[test]
fn a_wrong_start_load_law_or_mass_is_seen() {
    type Fault = fn(&mut Structure);
    let faults: [(&str, Fault); 6] = [
        ("start", |of| of.displacement[0] *= 1.02),
        ("velocity", |of| of.velocity[0] *= 1.02),
        ("gap", |of| of.contacts[0].gap += 5e-4),
        ("mass", |of| of.nodes[0].mass *= 1.02),
        ("stiffness", |of| of.stiffness.add(0, 0, 2.0)),
        ("damping", |of| of.damping.add(0, 0, 0.4)),
    ];
    for law in laws() {
        let sound = mass(law, [0.01, 0.4]);
        for (what, fault) in faults {
            let mut other = sound.clone();
            fault(&mut other);
            // Friction that has no memory of r has no gap.
            let impact = other.contacts[0].law.kind() == ContactKind::Impact;
            if what == "gap" && !impact {
                continue;
            }
            assert_seen(&sound, &other, "m", 0.001, what);
        }
    }
}
