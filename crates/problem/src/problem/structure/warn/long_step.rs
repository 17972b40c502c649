//! A step that is long for the structure itself.

use super::doubt::Doubt;
use crate::contact::ContactKind;
use crate::problem::numbers::short::short;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::channels::channel::{Derived, Number, Quantity};
use crate::problem::structure::given::node::Numbering;
use crate::problem::structure::metrics::computed_ground::Steps;
use crate::problem::structure::model::damping::{Modes, modes};
use crate::problem::structure::motions::metric_values::needed;
use crate::solve::Warning;
use crate::system::structure::{Signal, Structure, Symmetric};
use std::f64::consts::PI;

/// Fewest steps in a period: constant average acceleration makes it 2 % longer, and half of the peaks under synthetic motions err by
/// more than 3 % (`tests/command_line/warnings/long_step.rs`).
const FEWEST: f64 = 12.0;

/// Share of the motion of a metric from which a mode matters.
const SHARE: f64 = 0.05;

/// Shortest period that a motion given by points drives, over the time between points: what is between them is straight.
const POINTS: f64 = 4.0;

/// Part of the period of a sine below which a mode follows it as if at rest: it moves 7 % more.
const FOLLOWS: f64 = 0.25;

/// Most nodes of a structure whose modes are looked at: those of more take longer than the motion.
const MOST: usize = 200;

/// What moves a structure: |phi^T f| of each mode by a load, which is this over omega^2; and the shortest period that it drives.
struct Drive {
    by_mode: Vec<f64>,
    shortest: f64,
}

impl StructureProblem {
    /// The shortest period that matters to a metric, if it has too few steps.
    pub(super) fn long_step(
        &self,
        structure: &Structure,
        numbering: &Numbering,
        steps: Steps,
    ) -> Option<Doubt> {
        let limit = FEWEST * steps.dt;
        if structure.len() > MOST || shortest_bound(structure) >= limit {
            return None;
        }
        let natural = modes(structure, &elastic(structure))?;
        let omega: Vec<f64> = natural.omega2.iter().map(|x| x.max(0.0).sqrt()).collect();
        let periods: Vec<f64> = omega.iter().map(|frequency| 2.0 * PI / frequency).collect();
        if periods.iter().all(|period| *period >= limit) {
            return None;
        }
        // A motion without a spring is as slow as the whole run.
        let slowest = 2.0 * PI / (steps.dt * steps.last.max(1) as f64);
        let omega: Vec<f64> = omega
            .iter()
            .map(|frequency| frequency.max(slowest))
            .collect();
        let drives = drives(structure, &natural, &omega);
        let numbers = self
            .metrics
            .iter()
            .flat_map(|metric| needed(metric, numbering, 0));
        let channels: Vec<_> = numbers
            .filter_map(|number| followed(structure, number))
            .map(|(along, order)| (natural.components(structure, &along), order))
            .collect();
        let matters = |mode: &usize| {
            let of = |drive: &Drive| {
                periods[*mode] >= drive.shortest
                    && channels.iter().any(|(channel, order)| {
                        let part = |k: usize| {
                            let moved = channel[k] * drive.by_mode[k];
                            moved.abs() * omega[k].powi(order - 2)
                        };
                        part(*mode) > SHARE * (0..omega.len()).map(part).sum::<f64>()
                    })
            };
            periods[*mode] < limit && drives.iter().any(of)
        };
        let mattering = (0..omega.len()).filter(matters).map(|mode| periods[mode]);
        let shortest = mattering.reduce(f64::min)?;
        let digits = |x: f64| short(format!("{x:.2e}").parse().unwrap_or(x));
        let text = format!(
            "a period of {} has {} steps",
            digits(shortest),
            digits(shortest / steps.dt)
        );
        Some((Warning::LongStep, text))
    }
}

/// K with the elastic links at their initial stiffness. Friction slides, and impacts are open.
fn elastic(structure: &Structure) -> Symmetric {
    let mut stiffness = structure.stiffness.clone();
    for (along, k) in links(structure) {
        stiffness.add_along(along, k);
    }
    stiffness
}

fn links(structure: &Structure) -> impl Iterator<Item = (&[(usize, f64)], f64)> {
    let contacts = structure.contacts.iter();
    let links = contacts
        .filter(|contact| contact.law.kind() == ContactKind::Link)
        .map(|contact| (&contact.along[..], contact.initial_stiffness()));
    links.filter(|(_, k)| *k > 0.0)
}

/// A period that no mode is below: omega^2 is at most the largest sum of a row of M^-1 K. 0 where masses are coupled or none.
fn shortest_bound(structure: &Structure) -> f64 {
    if !structure.coupled_mass.is_empty() {
        return 0.0;
    }
    let mut rows = vec![0.0; structure.len()];
    for ((i, j), k) in structure.stiffness.entries() {
        rows[i] += k.abs();
        if i != j {
            rows[j] += k.abs();
        }
    }
    for (along, k) in links(structure) {
        let sum: f64 = along.iter().map(|(_, factor)| factor.abs()).sum();
        for (node, factor) in along {
            rows[*node] += k * factor.abs() * sum;
        }
    }
    let each = rows.iter().zip(&structure.nodes);
    let largest = each
        .map(|(row, node)| row / node.mass)
        .fold(0.0, |most: f64, x| match x.is_nan() {
            true => most,
            false => most.max(x),
        });
    2.0 * PI / largest.sqrt()
}

/// What moves a structure with these modes.
fn drives(structure: &Structure, modes: &Modes, omega: &[f64]) -> Vec<Drive> {
    let at_rest = !structure.preload.load.is_empty();
    let loads = structure.loads.iter().filter_map(|load| {
        let shortest = match &*load.signal {
            Signal::Sine { omega, .. } => FOLLOWS * 2.0 * PI / omega.abs(),
            Signal::Table(table) => match table.times() {
                // Static loads go on, without a motion.
                [_] if at_rest => return None,
                times => between(times),
            },
            Signal::Motion(motion, _) => between(&motion.points()),
        };
        let by_mode = modes.components(structure, &load.pattern);
        Some(Drive { by_mode, shortest })
    });
    let mut drives: Vec<Drive> = loads.collect();
    // Static equilibrium does not move.
    let starts = [(&structure.displacement, 2), (&structure.velocity, 1)]
        .into_iter()
        .filter(|(start, order)| start.iter().any(|x| *x != 0.0) && (*order == 1 || !at_rest));
    drives.extend(starts.map(|(start, order)| {
        let mut inertia: Vec<f64> = vec![0.0; structure.len()];
        structure.coupled_mass.add_product(start, &mut inertia);
        let of_nodes = structure.nodes.iter().zip(start).zip(inertia).enumerate();
        let force: Vec<(usize, f64)> = of_nodes
            .map(|(i, ((node, x), coupled))| (i, node.mass * x + coupled))
            .collect();
        let by_mode = modes.components(structure, &force).into_iter().zip(omega);
        Drive {
            by_mode: by_mode
                .map(|(part, omega)| part * omega.powi(order))
                .collect(),
            shortest: 0.0,
        }
    }));
    drives
}

/// The shortest period that points at these times drive.
fn between(times: &[f64]) -> f64 {
    match times {
        [first, .., last] if times.len() > 8 => POINTS * (last - first) / (times.len() - 1) as f64,
        _ => 0.0,
    }
}

/// The displacement that a number follows, and the order of its derivative. Forces are elastic.
fn followed(structure: &Structure, number: Number) -> Option<(Vec<(usize, f64)>, i32)> {
    let node = |node: usize| (node < structure.len()).then(|| vec![(node, 1.0)]);
    match number {
        Number::Displacement(index) => Some((node(index)?, 0)),
        Number::Velocity(index) => Some((node(index)?, 1)),
        Number::Derived(Derived::Acceleration(index) | Derived::Absolute(index)) => {
            Some((node(index)?, 2))
        }
        Number::Derived(Derived::Spring(spring)) => {
            let springs = &structure.observed.as_ref()?.springs;
            Some((springs.get(spring)?.along.clone(), 0))
        }
        Number::Derived(Derived::Element(_, [left, right])) => {
            Some((vec![(left, -1.0), (right, 1.0)], 0))
        }
        Number::Contact(contact, quantity) => {
            let along = || structure.contacts[contact].along.clone();
            match quantity {
                Quantity::Displacement
                | Quantity::Slip
                | Quantity::Distance
                | Quantity::SlipDistance => Some((along(), 0)),
                Quantity::Velocity | Quantity::Speed => Some((along(), 1)),
                Quantity::Force | Quantity::Size => {
                    let is_elastic = structure.contacts[contact].law.kind() == ContactKind::Link;
                    is_elastic.then(|| (along(), 0))
                }
                Quantity::Limit => None,
            }
        }
        Number::Acceleration(_) | Number::Energy(_) => None,
        Number::Derived(Derived::Ground(..) | Derived::Base(_) | Derived::Reaction(_)) => None,
    }
}
