//! Signals as polynomials of a piece.

use super::bernstein::{Polynomial, TERMS};
use crate::system::structure::{Limit, Signal, Structure};
use libm::{cos, sin};

/// Adds `factor` times the signal to a polynomial for the times `start` + `length` s. Between the points of a table it is a
/// straight line.
pub fn add_signal(signal: &Signal, factor: f64, [start, length]: [f64; 2], to: &mut Polynomial) {
    match signal {
        Signal::Sine {
            amplitude,
            omega,
            phase,
        } => {
            let angle = omega * start + phase;
            let derivatives = [sin(angle), cos(angle), -sin(angle), -cos(angle)];
            let mut term = factor * amplitude;
            for (k, to) in to.iter_mut().enumerate() {
                *to += term * derivatives[k % 4];
                term *= omega * length / (k + 1) as f64;
            }
        }
        Signal::Table(table) => {
            let (times, values) = (table.times(), table.values());
            to[0] += factor * table.at(start);
            let after = times.partition_point(|time| *time <= start);
            if 0 < after && after < times.len() {
                let slope = (values[after] - values[after - 1]) / (times[after] - times[after - 1]);
                to[1] += factor * slope * length;
            }
        }
        Signal::Motion(motion, quantity) => {
            let u: [f64; TERMS + 2] = motion.taylor([start, length]);
            // Differentiated once for v, twice for a.
            let order = *quantity as usize;
            for (k, to) in to.iter_mut().enumerate() {
                let factors = (k + 1..=k + order).map(|i| i as f64 / length);
                *to += factor * factors.fold(u[k + order], |u, i| u * i);
            }
        }
    }
}

/// The limit of a friction contact where it is positive; the contact is open where this is negative.
pub fn limit(limit: &Limit, time: [f64; 2]) -> Polynomial {
    let mut polynomial = [0.0; TERMS];
    polynomial[0] = limit.constant;
    if let Some((factor, signal)) = &limit.varying {
        add_signal(signal, *factor, time, &mut polynomial);
    }
    polynomial
}

fn signals(structure: &Structure) -> impl Iterator<Item = &Signal> {
    let limits = structure
        .contacts
        .iter()
        .filter_map(|contact| contact.law.limit())
        .filter_map(|limit| Some(&*limit.varying.as_ref()?.1));
    structure
        .loads
        .iter()
        .map(|load| &*load.signal)
        .chain(limits)
}

/// Times > 0 of the points of all tables, rising.
pub fn points(structure: &Structure) -> Vec<f64> {
    let tables = signals(structure).filter_map(|signal| match signal {
        Signal::Table(table) => Some(table.times()),
        // Those of supports follow.
        Signal::Sine { .. } | Signal::Motion(..) => None,
    });
    let of_supports = structure
        .supports
        .iter()
        .flat_map(|support| support.motion.points());
    let ends = tables.flatten().copied().chain(of_supports);
    let mut times: Vec<f64> = ends.filter(|t| *t > 0.0).collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    times
}

/// The largest circular frequency of a sine.
pub fn fastest(structure: &Structure) -> f64 {
    let frequencies = signals(structure).map(|signal| match signal {
        Signal::Sine { omega, .. } => omega.abs(),
        Signal::Table(_) | Signal::Motion(..) => 0.0,
    });
    let of_supports = structure
        .supports
        .iter()
        .map(|support| support.motion.omega().abs());
    frequencies.chain(of_supports).fold(0.0, f64::max)
}
