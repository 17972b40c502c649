//! Tests of the stepper.

mod at_rest;
mod bodies;
mod books;
mod carried;
mod curved;
mod dense;
mod lanes;
mod large;
mod link;
mod methods;
mod motion;
mod preload;
mod pushed;
mod static_ratio;

use crate::contact::ClippedLine;
use crate::system::structure::{
    Contact, Limit, Load, Node, Signal, Structure, StructureLaw, Symmetric, Table,
};
use std::f64::consts::PI;
use std::sync::Arc;

/// Nodes at rest without springs.
fn masses(masses: &[f64]) -> Structure {
    let node = |(i, mass): (usize, &f64)| Node {
        name: format!("m{i}"),
        mass: *mass,
        direction: Default::default(),
    };
    Structure::new(masses.iter().enumerate().map(node).collect())
}

fn contact(between: [Option<usize>; 2], gap: f64, law: StructureLaw) -> Contact {
    Contact {
        name: "contact".into(),
        along: crate::system::structure::between(between),
        gap,
        law,
    }
}

fn displacement_control(stiffness: f64, limit: f64) -> StructureLaw {
    StructureLaw::new(ClippedLine::Elastic { stiffness }, Limit::constant(limit))
}

fn velocity_control(viscosity: f64, limit: f64) -> StructureLaw {
    StructureLaw::new(ClippedLine::Viscous { viscosity }, Limit::constant(limit))
}

/// A ground acceleration with many frequencies, peak about 3.
fn ground() -> Arc<Signal> {
    let times: Vec<f64> = (0..=500).map(|i| 0.01 * f64::from(i)).collect();
    let wave = |t: f64, k: u32| libm::sin(f64::from(k * k) * 0.7 * t + f64::from(k));
    let value = |t: &f64| (1..9).map(|k| wave(*t, k)).sum::<f64>();
    let values = times.iter().map(value).collect();
    Arc::new(Signal::Table(Table::new(times, values).unwrap()))
}

/// Three girders of `n` elements on piers, with gaps between them and friction on the next pier.
fn girders(n: usize, k_factor: f64, scale: f64, ground: &Arc<Signal>) -> Structure {
    let mut nodes = Vec::new();
    for _ in 0..3 {
        nodes.push(100.0);
        let share = |i| if i == 0 || i == n { 0.5 } else { 1.0 };
        nodes.extend((0..=n).map(|i| share(i) * 500.0 / n as f64));
    }
    let mut structure = masses(&nodes);
    let element = 1.5e8 * n as f64 / 40.0;
    let (k, c) = (&mut structure.stiffness, &mut structure.damping);
    for (girder, period) in [1.0, 0.7, 1.2].into_iter().enumerate() {
        let (pier, omega) = (girder * (n + 2), 2.0 * PI / period);
        k.add_spring([None, Some(pier)], 600.0 * omega * omega);
        c.add_spring([None, Some(pier)], 2.0 * 0.05 * omega * 600.0);
        k.add_spring([Some(pier), Some(pier + 1)], 2e6);
        for i in pier + 1..pier + 1 + n {
            k.add_spring([Some(i), Some(i + 1)], element);
            c.add_spring([Some(i), Some(i + 1)], 1.5e-4 * element);
        }
    }
    let pier = |girder: usize| Some(girder * (n + 2));
    let left = |girder: usize| Some(girder * (n + 2) + 1);
    let right = |girder: usize| Some(girder * (n + 2) + 1 + n);
    let stiffness = k_factor * element;
    let stop = |g: usize| {
        contact(
            [right(g), left(g + 1)],
            0.02,
            StructureLaw::new(ClippedLine::Spring { stiffness }, None),
        )
    };
    let bearing = |i, j| contact([i, j], 0.0, displacement_control(245.0 / 0.0005, 245.0));
    structure.contacts = vec![
        stop(0),
        stop(1),
        bearing(pier(1), right(0)),
        bearing(pier(2), right(1)),
        bearing(None, right(2)),
    ];
    let pattern = nodes.iter().enumerate();
    structure.loads = vec![Load {
        pattern: pattern.map(|(i, mass)| (i, -mass * scale)).collect(),
        signal: ground.clone(),
    }];
    structure
}

/// The same with every law, limits that change, and a contact that shares its nodes with another.
fn mixed(n: usize, factor: f64, ground: &Arc<Signal>) -> Structure {
    let mut structure = girders(n, factor, 1.0, ground);
    let weight = Limit {
        constant: 200.0,
        varying: Some((30.0 * factor, ground.clone())),
        ..Limit::constant(0.0)
    };
    structure.contacts[2].law =
        StructureLaw::new(ClippedLine::Viscous { viscosity: 2e4 }, weight.clone());
    structure.contacts[3].law = StructureLaw::new(ClippedLine::Elastic { stiffness: 3e5 }, weight);
    structure.contacts[4].law = StructureLaw::new(ClippedLine::Coulomb, Limit::constant(150.0));
    structure.contacts.push(Contact {
        gap: 0.0,
        law: velocity_control(5e3 * factor, 60.0),
        ..structure.contacts[0].clone()
    });
    structure
}
