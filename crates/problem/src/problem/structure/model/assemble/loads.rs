//! Loads, ground motion and motions of supports of a structure under construction.

use super::{Detail, Draft};
use crate::problem::Violation;
use crate::problem::numbers::short::short;
use crate::problem::structure::given::node::Numbering;
use crate::problem::structure::given::shape::Scaled;
use crate::problem::structure::given::supports::{Course, Support};
use crate::problem::structure::parts::template::{Moved, StaticLoad};
use crate::system::reduction::Reduced;
use crate::system::structure::{Direction, Ground, Load, Motion, Node, Signal, Structure};
use std::sync::Arc;

impl Draft<'_> {
    pub(super) fn loads(&mut self) {
        for load in &self.template.loads {
            let nodes = self.loaded(&load.at);
            self.load(&load.force, |_, scale| {
                nodes
                    .iter()
                    .map(|(node, share)| (*node, scale * share))
                    .collect()
            });
        }
        for (direction, acceleration) in &self.template.gravity {
            let value = self.value(acceleration);
            let pattern = self.weights(*direction, value);
            let signal = Arc::new(Signal::constant(1.0));
            if self.is_built() {
                self.structure.loads.push(Load { pattern, signal });
            }
        }
        for (direction, ground) in &self.template.ground {
            // u is relative to the ground: the load is -M a_g in the nodes of its direction.
            let shaken = match self.detail {
                Detail::Whole => self.shaken(*direction),
                Detail::Numbers | Detail::WithoutSamples => Vec::new(),
            };
            let moved = self.load(ground, |_, scale| {
                let masses = shaken.iter().enumerate().filter(|(_, mass)| **mass != 0.0);
                masses.map(|(i, mass)| (i, -scale * mass)).collect()
            });
            if let (Some(observed), Some((signal, scale))) = (&mut self.structure.observed, moved) {
                let direction = *direction;
                observed.ground.push(Ground {
                    direction,
                    signal,
                    scale,
                });
            }
        }
    }

    /// Loads that act from before t = 0 on. They are among the loads, and their sum is that of the preload.
    pub(super) fn static_loads(&mut self) {
        let template = self.template;
        if template.at_rest.is_empty() {
            return;
        }
        let mut sum = vec![0.0; self.structure.nodes.len()];
        for load in &template.at_rest {
            let pattern = match load {
                StaticLoad::Force(at, force) => {
                    let (nodes, force) = (self.loaded(at), self.value(force));
                    let nodes = nodes.into_iter();
                    nodes.map(|(node, share)| (node, force * share)).collect()
                }
                StaticLoad::Gravity(direction, acceleration) => {
                    let value = self.value(acceleration);
                    self.weights(*direction, value)
                }
            };
            if !self.is_built() {
                continue;
            }
            for (node, force) in &pattern {
                sum[*node] += force;
            }
            let signal = Arc::new(Signal::constant(1.0));
            self.structure.loads.push(Load { pattern, signal });
        }
        self.structure.preload.load = sum;
    }

    /// The forces of an acceleration of all masses in a direction; none where nothing is built.
    fn weights(&self, direction: Direction, acceleration: f64) -> Vec<(usize, f64)> {
        let shaken = match self.is_built() {
            true => self.shaken(direction),
            false => Vec::new(),
        };
        let numbered = shaken.into_iter().enumerate();
        let masses = numbered.filter(|(_, mass)| *mass != 0.0);
        masses
            .map(|(node, mass)| (node, acceleration * mass))
            .collect()
    }

    /// M times 1 in the nodes of a direction and 0 in the others.
    pub(super) fn shaken(&self, direction: Direction) -> Vec<f64> {
        let supports = &self.template.supports;
        let reduced = (&self.reduced[..], &self.numbering);
        inertia(&self.structure, supports, reduced, direction)
    }

    /// The nodes on which a load acts, with the forces of a load of 1.
    pub(super) fn loaded(&mut self, of: &Moved) -> Vec<(usize, f64)> {
        if let Moved::Rows(matrices, direction) = of
            && let Some(reduced) = &self.reduced[*matrices]
        {
            let forces = match self.is_built() {
                true => reduced.forces(*direction),
                false => Vec::new(),
            };
            let nodes = self.numbering.coordinates(*matrices, reduced).into_iter();
            return nodes
                .zip(forces)
                .filter_map(|(node, force)| Some((node?, force)))
                .collect();
        }
        // Those behind the nodes are supports.
        let nodes_in_case = self.numbering.nodes();
        match of {
            Moved::Rows(matrices, direction) => {
                let forces = self.template.matrices[*matrices]
                    .imported
                    .dofs
                    .forces(*direction)
                    .into_iter()
                    .enumerate()
                    .filter(|entry| entry.1 != 0.0);
                let nodes = forces
                    .filter_map(|(row, force)| Some((self.numbering.row(*matrices, row)?, force)));
                nodes.filter(|pair| pair.0 < nodes_in_case).collect()
            }
            Moved::Tied(terms) => {
                let nodes = terms
                    .iter()
                    .filter_map(|(factor, name)| Some((self.node(name)?, *factor)));
                nodes.filter(|pair| pair.0 < nodes_in_case).collect()
            }
            Moved::Node(_) | Moved::Bar(_) => {
                self.moved(of).into_iter().map(|node| (node, 1.0)).collect()
            }
        }
    }

    /// Adds a load; returns its signal and factor.
    pub(super) fn load(
        &mut self,
        force: &Scaled,
        pattern: impl Fn(&[Node], f64) -> Vec<(usize, f64)>,
    ) -> Option<(Arc<Signal>, f64)> {
        if self.detail != Detail::Whole && force.source.is_sampled() {
            let checked = force.check(self.case, self.template.metre);
            self.checked(checked);
            return None;
        }
        let found = force.in_case(self.case, self.template.metre);
        let (signal, scale) = self.checked(found)?;
        let pattern = pattern(&self.structure.nodes, scale);
        let load = Load {
            pattern,
            signal: signal.clone(),
        };
        self.structure.loads.push(load);
        Some((signal, scale))
    }

    /// A displacement of a support whose velocity jumps, where M couples it with nodes.
    fn blow(&self, index: usize, motion: &Motion) -> Option<Violation> {
        let Course::Displacement(_, (at, path)) = &self.template.supports[index].course else {
            return None;
        };
        let time = *motion.blows().first()?;
        let nodes = self.structure.nodes.len();
        let mut coupled = self.structure.coupled_mass.entries();
        let is_coupled =
            coupled.any(|((i, j), m)| m != 0.0 && i.min(j) < nodes && i.max(j) == nodes + index);
        is_coupled.then(|| Violation {
            parameter: path.clone().into(),
            message: format!(
                "the velocity jumps at t = {}, and M couples the support with nodes: that would be a blow; allowed: \"between\": \"cubic\", or an M without these entries",
                short(time)
            ),
            at: Some(*at),
        })
    }

    /// Prescribes the motions of the supports.
    pub(super) fn supports(&mut self) {
        let mut motions = Vec::with_capacity(self.template.supports.len());
        for (index, support) in self.template.supports.iter().enumerate() {
            let motion =
                support.in_case(self.case, self.template.metre, self.detail == Detail::Whole);
            if let Some(motion) = self.checked(motion) {
                let blow = self.blow(index, &motion);
                self.violations.extend(blow);
                motions.push((support.full_name(), Arc::new(motion)));
            }
        }
        if self.is_built() && self.violations.is_empty() {
            self.structure.prescribe(motions);
        }
        let nodes = self.numbering.nodes();
        for contact in &mut self.structure.contacts {
            contact.along.retain(|(node, _)| *node < nodes);
        }
    }
}

/// M times 1 in the nodes of a direction and 0 in the others: with these supports and reductions of matrices.
pub fn inertia(
    structure: &Structure,
    supports: &[Support],
    (reduced, numbering): (&[Option<Reduced>], &Numbering),
    direction: Direction,
) -> Vec<f64> {
    let nodes = &structure.nodes;
    // Supports come after the nodes.
    let is_shaken = |i: usize| match nodes.get(i) {
        Some(node) => node.direction == direction,
        None => supports
            .get(i - nodes.len())
            .is_some_and(|support| support.direction == direction),
    };
    let indexed = nodes.iter().enumerate();
    let masses = indexed.map(|(i, node)| if is_shaken(i) { node.mass } else { 0.0 });
    let mut shaken: Vec<f64> = masses.collect();
    for ((i, j), mass) in structure.coupled_mass.entries() {
        for (row, column) in [(i, j), (j, i)] {
            if let (Some(sum), true) = (shaken.get_mut(row), is_shaken(column)) {
                *sum += mass;
            }
        }
    }
    for (block, reduced) in reduced.iter().enumerate() {
        if let Some(reduced) = reduced {
            let inertia = reduced.inertia(direction).into_iter();
            let nodes = numbering.coordinates(block, reduced).into_iter();
            for (node, inertia) in nodes.zip(inertia) {
                if let Some(node) = node {
                    shaken[node] = inertia;
                }
            }
        }
    }
    shaken
}
