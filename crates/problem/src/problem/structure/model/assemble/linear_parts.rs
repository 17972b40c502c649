//! Masses, bars, springs and damping of a structure under construction.

use super::Draft;
use crate::problem::numbers::short::short;
use crate::problem::structure::model::damping::{MOST_MODES, modes};
use crate::problem::structure::parts::damping::{ModalDamping, Pair, Rayleigh, factors};
use crate::problem::structure::parts::template::{DampingStiffness, SpringNumbers, Template};
use crate::system::structure::{Elements, Node, Structure, Symmetric};
use std::borrow::Cow;
use std::f64::consts::PI;

/// The K of Rayleigh and modal damping.
pub fn damping_stiffness<'a>(template: &Template, structure: &'a Structure) -> Cow<'a, Symmetric> {
    match template.damping_stiffness {
        DampingStiffness::WithoutContacts => Cow::Borrowed(&structure.stiffness),
        DampingStiffness::Initial => Cow::Owned(structure.initial_stiffness()),
    }
}

/// The smallest and the largest second ratio over the first one for which both factors are not negative.
fn bounds([w1, w2]: [f64; 2]) -> [f64; 2] {
    let over = w2 / w1;
    [over.min(1.0 / over), over.max(1.0 / over)]
}

impl Draft<'_> {
    pub(super) fn masses(&mut self) {
        for mass in &self.template.masses {
            let node = Node {
                name: mass.name.clone(),
                mass: self.value(&mass.mass),
                direction: mass.direction,
            };
            self.structure.nodes.push(node);
        }
    }

    /// Lumped masses m/n, half of it at the ends; stiffness n E A/L of each element.
    pub(super) fn bars(&mut self) {
        for (b, bar) in self.template.bars.iter().enumerate() {
            let n = self.numbering.elements()[b];
            let elements = f64::from(n);
            let (length, stiffness) = (self.value(&bar.length), self.value(&bar.stiffness));
            let element = self.value(&bar.mass) / elements;
            let k = elements * stiffness / length;
            let c = self.optional(&bar.stiffness_damping) * k;
            let first = self.numbering.first(b);
            if let Some(observed) = &mut self.structure.observed {
                observed.bars.push(Elements { k, c });
            }
            for i in if self.is_built() { 0..n + 1 } else { 0..0 } {
                let (end, mass) = match i {
                    0 => ("left".to_owned(), 0.5 * element),
                    i if i == n => ("right".to_owned(), 0.5 * element),
                    i => (i.to_string(), element),
                };
                let name = format!("{}.{end}", bar.name);
                let direction = bar.direction;
                self.structure.nodes.push(Node {
                    name,
                    mass,
                    direction,
                });
            }
            for i in if self.is_built() {
                first..first + n as usize
            } else {
                0..0
            } {
                self.add(&[(i, -1.0), (i + 1, 1.0)], k, c);
            }
        }
    }

    pub(super) fn springs(&mut self) {
        for number in 0..self.template.springs.len() {
            let spring = self.spring(number);
            self.add(&spring.along, spring.k, spring.c);
            if let Some(observed) = &mut self.structure.observed {
                observed.springs.push(spring);
            }
        }
    }

    /// k and c of a spring.
    pub(super) fn stiffness_and_dashpot(&mut self, numbers: &SpringNumbers) -> [f64; 2] {
        match numbers {
            SpringNumbers::Stiffness { k, c } => [self.value(k), self.optional(c)],
            SpringNumbers::Period {
                mass,
                period,
                ratio,
            } => {
                let (mass, period) = (self.value(mass), self.value(period));
                let omega = 2.0 * PI / period;
                let c = 2.0 * self.optional(ratio) * omega * mass;
                [mass * omega * omega, c]
            }
        }
    }

    /// C += mass M + stiffness K.
    pub(super) fn rayleigh(&mut self) {
        let [mass, stiffness] = self.rayleigh_factors();
        if stiffness != 0.0 && self.is_built() {
            let k = damping_stiffness(self.template, &self.structure).into_owned();
            self.structure.damping.add_matrix(&k, stiffness);
        }
        if mass != 0.0 && self.is_built() {
            let Structure {
                nodes,
                coupled_mass,
                damping,
                ..
            } = &mut self.structure;
            for (i, node) in nodes.iter().enumerate() {
                damping.add(i, i, mass * node.mass);
            }
            damping.add_matrix(coupled_mass, mass);
        }
    }

    /// The factors of M and K in C.
    fn rayleigh_factors(&mut self) -> [f64; 2] {
        let (ratios, of) = match &self.template.rayleigh {
            Rayleigh::Factors(factors) => {
                return [0, 1].map(|i| self.optional(&factors[i]));
            }
            Rayleigh::Ratios { ratios, of } => (ratios, of),
        };
        let values = [0, 1].map(|i| self.value(&ratios[i]));
        let omega2 = match of {
            Pair::Periods(_) => Vec::new(),
            Pair::Modes(numbers) => {
                for number in numbers {
                    self.value(number);
                }
                if !self.is_built() {
                    return [0.0; 2];
                }
                let nodes: Vec<usize> = (0..self.structure.len()).collect();
                let k = damping_stiffness(self.template, &self.structure).block(&nodes);
                let Some(found) = modes(&self.structure, &k) else {
                    let message = format!(
                        "modes need at most {MOST_MODES} nodes, a positive definite M, and a K that holds the nodes without mass; \
                         give \"periods\" instead"
                    );
                    self.violations.push(numbers[0].violation(message));
                    return [0.0; 2];
                };
                found.omega2
            }
        };
        let Some(frequencies) = self.checked(of.frequencies(self.case, &omega2)) else {
            return [0.0; 2];
        };
        let found = factors(values, frequencies);
        for (i, matrix) in ["M", "K"].into_iter().enumerate() {
            // Round-off of two equal products.
            if found[i] < -1e-12 * found[i].abs().max(values[0] + values[1]) {
                let [low, high] = bounds(frequencies);
                let message = format!(
                    "the factor of {matrix} would be {}; the second ratio over the first must be from {} to {}",
                    short(found[i]),
                    short(low),
                    short(high)
                );
                self.violations.push(ratios[1].violation(message));
            }
        }
        found
    }

    pub(super) fn modal_damping(&mut self) {
        let modal = self.template.modal_damping.as_ref();
        let ratios = modal.map_or(&[][..], ModalDamping::amounts);
        for ratio in ratios {
            self.value(ratio);
        }
        let Some(ratio) = ratios.first() else {
            return;
        };
        let nodes = self.numbering.nodes();
        if nodes > MOST_MODES {
            let message =
                format!("modal damping is allowed for at most {MOST_MODES} nodes, got {nodes}");
            self.violations.push(ratio.violation(message));
        }
    }
}
