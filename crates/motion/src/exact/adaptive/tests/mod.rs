//! Motions against closed forms, motions by events, and laws whose step tends to them.

use super::*;
use crate::contact::{
    BoucWen, Dahl, DisplacementControl, Hertz, HuntCrossley, ImpactSpring, Jankowski, KelvinVoigt,
    Lugre, Pendulum, Tanh, VelocityControl, Viscous,
};
use crate::exact::events;
use crate::exact::regularised::Regularised;
use crate::system::structure::{
    Contact, Limit, Load, Node, Signal, StructureLaw, Symmetric, Table,
};

mod bars;
mod braced;
mod oscillator;
mod structures;

/// A mass of 1 on a spring of `k` with a contact to the ground.
fn one(k: f64, law: StructureLaw, gap: f64) -> Structure {
    let mut structure = Structure::new(vec![Node {
        name: "mass".into(),
        mass: 1.0,
        direction: Default::default(),
    }]);
    structure.stiffness.add(0, 0, k);
    structure.contacts.push(Contact {
        name: "floor".into(),
        along: vec![(0, 1.0)],
        gap,
        law,
    });
    structure
}

/// u, v, S of the first node and contact at these times.
fn at(structure: &Structure, times: &[f64], tolerance: f64) -> Vec<[f64; 3]> {
    let mut states = Vec::new();
    run_of(structure, &[0], times, tolerance, |_, state| {
        states.push([state.u[0], state.v[0], state.force[0]]);
    })
    .unwrap();
    states
}

/// The same by events.
fn by_events(structure: &Structure, times: &[f64]) -> Vec<[f64; 3]> {
    let mut states = Vec::new();
    events::run_of(structure, &[0], times, |_, state| {
        states.push([state.u[0], state.v[0], state.force[0]]);
    })
    .unwrap();
    states
}

fn times(end: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|i| end * i as f64 / count as f64).collect()
}

/// The largest difference of a component.
fn distance(a: &[[f64; 3]], b: &[[f64; 3]], component: usize) -> f64 {
    let pairs = a.iter().zip(b);
    pairs
        .map(|(a, b)| (a[component] - b[component]).abs())
        .fold(0.0, f64::max)
}
