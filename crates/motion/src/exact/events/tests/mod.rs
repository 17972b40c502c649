//! Motions against closed forms, printed numbers and other methods.

mod bars;
mod friction;
mod impact;
mod lines;
mod modal;
mod orders;
mod pressed;
mod random;
mod restarts;
mod rigid;
mod series;
mod several;
mod static_ratio;

use super::*;
use crate::contact::ClippedLine;
use crate::system::structure::{
    Contact, Limit, Load, Node, Signal, StructureLaw, Symmetric, Table,
};
use std::sync::Arc;

/// Masses without springs, at rest.
pub fn masses(masses: &[f64]) -> Structure {
    let node = |(i, mass): (usize, &f64)| Node {
        name: format!("n{i}"),
        mass: *mass,
        direction: Default::default(),
    };
    Structure::new(masses.iter().enumerate().map(node).collect())
}

/// One mass of 1.
pub fn one() -> Structure {
    masses(&[1.0])
}

/// A structure, part by part.
pub trait Build: Sized {
    /// Adds a spring.
    fn spring(self, between: [Option<usize>; 2], k: f64) -> Self;
    /// Adds a damper.
    fn dashpot(self, between: [Option<usize>; 2], c: f64) -> Self;
    /// Adds a contact.
    fn contact(self, between: [Option<usize>; 2], gap: f64, law: StructureLaw) -> Self;
    /// Adds a load.
    fn load(self, pattern: &[(usize, f64)], signal: Signal) -> Self;
    /// Sets u(0) and u'(0).
    fn moving(self, u: &[f64], v: &[f64]) -> Self;
}

impl Build for Structure {
    fn spring(mut self, between: [Option<usize>; 2], k: f64) -> Structure {
        self.stiffness.add_spring(between, k);
        self
    }

    fn dashpot(mut self, between: [Option<usize>; 2], c: f64) -> Structure {
        self.damping.add_spring(between, c);
        self
    }

    fn contact(mut self, between: [Option<usize>; 2], gap: f64, law: StructureLaw) -> Structure {
        let name = format!("c{}", self.contacts.len());
        self.contacts.push(Contact {
            name,
            along: crate::system::structure::between(between),
            gap,
            law,
        });
        self
    }

    fn load(mut self, pattern: &[(usize, f64)], signal: Signal) -> Structure {
        self.loads.push(Load {
            pattern: pattern.to_vec(),
            signal: Arc::new(signal),
        });
        self
    }

    fn moving(mut self, u: &[f64], v: &[f64]) -> Structure {
        self.displacement = u.to_vec();
        self.velocity = v.to_vec();
        self
    }
}

/// amplitude sin(omega t + phase).
pub fn sine(amplitude: f64, omega: f64, phase: f64) -> Signal {
    Signal::Sine {
        amplitude,
        omega,
        phase,
    }
}

/// Straight lines between points.
pub fn table(points: &[[f64; 2]]) -> Signal {
    let [times, values] = [0, 1].map(|i| points.iter().map(|p| p[i]).collect());
    Signal::Table(Table::new(times, values).unwrap())
}

/// Coulomb friction with a limit that does not change.
pub fn coulomb(limit: f64) -> StructureLaw {
    StructureLaw::new(ClippedLine::Coulomb, Limit::constant(limit))
}

/// u of the first node, v, r of the first contact, rdot, S.
#[derive(Debug, Clone, Copy)]
pub struct First {
    pub u: f64,
    pub v: f64,
    pub r: f64,
    pub rate: f64,
    pub force: f64,
}

/// The first node and contact at `times`.
pub fn first(structure: &Structure, times: &[f64]) -> (Vec<First>, Summary) {
    let mut states = Vec::new();
    let summary = run(structure, times, |_, state| {
        let contact = |x: &[f64]| x.first().copied().unwrap_or(0.0);
        states.push(First {
            u: state.u[0],
            v: state.v[0],
            r: contact(state.r),
            rate: contact(state.rate),
            force: contact(state.force),
        });
    });
    (states, summary.unwrap())
}

/// 0, step, .. of `count` steps.
pub fn steps(step: f64, count: usize) -> Vec<f64> {
    (0..=count).map(|i| i as f64 * step).collect()
}

/// A limit constant + factor signal.
pub fn varying(constant: f64, factor: f64, signal: Signal) -> Limit {
    Limit {
        varying: Some((factor, Arc::new(signal))),
        ..Limit::constant(constant)
    }
}

/// u, v and all events of a motion up to `end`.
pub fn last(structure: &Structure, end: f64) -> (Vec<f64>, Summary) {
    let mut last = Vec::new();
    let summary = run(structure, &[end], |_, state| {
        last = [state.u, state.v].concat()
    });
    (last, summary.unwrap())
}
