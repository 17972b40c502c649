//! Quantities that follow from u, v, S and the loads of an instant: accelerations, forces of springs and supports, the ground.
//!
//! Each is a sum of factors times u, v and S, and a function of time. So nothing is computed in a step but these sums, and they are the
//! same for computed and exact motions. With supports that move, u is the rest w beside what the supports carry, R u_s.
//!
//! ```text
//! a = M^-1 (p - C v - K u - B S),   F_s = M_s a + C_s v + K_s u + B_s S
//! ```
//!
//! The acceleration is that of the equation of motion at the end of a step. It is the one of the constant average acceleration
//! method; others fulfil the equation elsewhere in the step, and their own accelerations are of lower order at its end.

use super::terms::Terms;
use crate::problem::structure::channels::channel::Derived;
use crate::solve::Unsolvable;
use crate::system::structure::{
    Along, Baseline, Inertia, Motion, Observed, Quantity, Reaction, Signal, Structure, Symmetric,
};
use std::sync::Arc;

/// Sums below this part of their terms are round-off.
const ROUND_OFF: f64 = 1e-12;

/// The sums of these quantities of a structure.
///
/// # Errors
/// M is not positive definite, or the motion of the ground is not finite.
pub fn terms(structure: &Structure, wanted: &[Derived]) -> Result<Vec<Terms>, Unsolvable> {
    let Some(observed) = &structure.observed else {
        return Ok(vec![Terms::default(); wanted.len()]);
    };
    let mut sums = Sums {
        structure,
        observed,
        inertia: None,
    };
    wanted.iter().map(|one| sums.of(*one)).collect()
}

/// What sums are made of.
struct Sums<'a> {
    structure: &'a Structure,
    observed: &'a Observed,
    inertia: Option<Inertia>,
}

impl Sums<'_> {
    fn of(&mut self, wanted: Derived) -> Result<Terms, Unsolvable> {
        let mut terms = Terms::default();
        match wanted {
            Derived::Acceleration(node) => self.add_acceleration(&[(node, 1.0)], &mut terms)?,
            Derived::Absolute(node) => {
                self.add_acceleration(&[(node, 1.0)], &mut terms)?;
                let direction = self.structure.nodes[node].direction;
                let ground = self.observed.ground.iter();
                let shaking = ground.filter(|ground| ground.direction == direction);
                terms
                    .signals
                    .extend(shaking.map(|ground| (ground.scale, ground.signal.clone())));
            }
            Derived::Spring(spring) => {
                let observed = &self.observed.springs[spring];
                self.add_spring(&observed.along, [observed.k, observed.c], &mut terms);
            }
            Derived::Element(bar, [left, right]) => {
                let observed = &self.observed.bars[bar];
                // On a finer mesh the mean of the elements between the nodes.
                let count = (right - left) as f64;
                let along = [(left, -1.0), (right, 1.0)];
                self.add_spring(&along, [observed.k / count, observed.c / count], &mut terms);
            }
            Derived::Ground(direction, quantity) => {
                let mut ground = self.observed.ground.iter();
                if let Some(given) = ground.find(|ground| ground.direction == direction) {
                    if quantity == Quantity::Acceleration {
                        terms.signals.push((given.scale, given.signal.clone()));
                    } else {
                        let motion = Motion::new(&given.signal, given.scale, 0.0, Baseline::None)
                            .map_err(|_| Unsolvable::OutOfRange)?;
                        terms.add_motion(1.0, &Arc::new(motion), quantity);
                    }
                }
            }
            Derived::Base(direction) => {
                let nodes = self.structure.nodes.iter();
                let along = nodes.map(|node| f64::from(u8::from(node.direction == direction)));
                self.add_base(&along.collect::<Vec<f64>>(), &mut terms);
                let end = format!(".{}", direction.name());
                for (support, reaction) in self.observed.reactions.iter().enumerate() {
                    if self.structure.supports[support].name.ends_with(&end) {
                        self.add_inertia(reaction, &mut terms)?;
                    }
                }
            }
            Derived::Reaction(support) => {
                let reaction = &self.observed.reactions[support];
                self.add_inertia(reaction, &mut terms)?;
                let [_, damping, stiffness] = &reaction.nodes;
                terms.u.extend(stiffness);
                terms.v.extend(damping);
                terms.s.extend(&reaction.contacts);
                self.add_carried(
                    damping,
                    &reaction.supports[1],
                    Quantity::Velocity,
                    &mut terms,
                );
                self.add_carried(
                    stiffness,
                    &reaction.supports[2],
                    Quantity::Displacement,
                    &mut terms,
                );
            }
        }
        Ok(terms)
    }

    /// Adds the sum of factors times u'' of nodes.
    fn add_acceleration(
        &mut self,
        of: &[(usize, f64)],
        terms: &mut Terms,
    ) -> Result<(), Unsolvable> {
        let structure = self.structure;
        let inertia = match &self.inertia {
            Some(inertia) => inertia,
            None => {
                let made = Inertia::new(structure).map_err(|why| Unsolvable::Indefinite {
                    node: structure.nodes[why.row].name.clone(),
                })?;
                self.inertia.insert(made)
            }
        };
        let mut y = vec![0.0; structure.len()];
        for (node, factor) in of {
            y[*node] += factor;
        }
        inertia.divide(&mut y);
        let minus: Vec<f64> = y.iter().map(|y| -y).collect();
        add(&mut terms.u, product(&structure.stiffness, &minus, 0.0));
        add(&mut terms.v, product(&structure.damping, &minus, 0.0));
        self.add_contacts(&minus, terms);
        for load in &structure.loads {
            let factor = load
                .pattern
                .iter()
                .fold(0.0, |sum, (node, x)| sum + x * y[*node]);
            if factor != 0.0 {
                terms.signals.push((factor, load.signal.clone()));
            }
        }
        // What the supports carry.
        for support in &structure.supports {
            let factor = of
                .iter()
                .fold(0.0, |sum, (node, x)| sum + x * support.carried[*node]);
            terms.add_motion(factor, &support.motion, Quantity::Acceleration);
        }
        Ok(())
    }

    /// Adds what springs, dashpots and contacts exert on the nodes with these factors from outside: between the nodes they cancel.
    fn add_base(&self, of: &[f64], terms: &mut Terms) {
        let structure = self.structure;
        let minus: Vec<f64> = of.iter().map(|x| -x).collect();
        add(
            &mut terms.u,
            product(&structure.stiffness, &minus, ROUND_OFF),
        );
        add(&mut terms.v, product(&structure.damping, &minus, ROUND_OFF));
        self.add_contacts(&minus, terms);
        // The loads by the motion of supports are forces of springs and dashpots.
        for load in &structure.loads {
            let Signal::Motion(_, Quantity::Velocity | Quantity::Displacement) = *load.signal
            else {
                continue;
            };
            let factor = load
                .pattern
                .iter()
                .fold(0.0, |sum, (node, x)| sum + x * of[*node]);
            if factor != 0.0 {
                terms.signals.push((factor, load.signal.clone()));
            }
        }
    }

    /// Adds the inertia in the row of a support.
    fn add_inertia(&mut self, of: &Reaction, terms: &mut Terms) -> Result<(), Unsolvable> {
        let [mass, ..] = &of.nodes;
        if !mass.is_empty() {
            self.add_acceleration(mass, terms)?;
        }
        let supports = &self.structure.supports;
        for (support, mass) in &of.supports[0] {
            terms.add_motion(*mass, &supports[*support].motion, Quantity::Acceleration);
        }
        Ok(())
    }

    /// Adds k e + c e'; places from the number of nodes on are supports.
    fn add_spring(&self, along: &[(usize, f64)], [k, c]: [f64; 2], terms: &mut Terms) {
        let n = self.structure.len();
        let (nodes, supports): (Along, Along) = along.iter().partition(|(at, _)| *at < n);
        let supports: Along = supports.iter().map(|(at, x)| (at - n, *x)).collect();
        for (by, quantity) in [(k, Quantity::Displacement), (c, Quantity::Velocity)] {
            if by == 0.0 {
                continue;
            }
            let scaled = |factors: &Along| -> Along {
                factors.iter().map(|(at, x)| (*at, by * x)).collect()
            };
            let nodes = scaled(&nodes);
            self.add_carried(&nodes, &scaled(&supports), quantity, terms);
            match quantity {
                Quantity::Displacement => terms.u.extend(nodes),
                Quantity::Velocity | Quantity::Acceleration => terms.v.extend(nodes),
            }
        }
    }

    /// Adds the sum of factors times what supports carry of nodes, and times the motions of supports.
    fn add_carried(&self, nodes: &Along, supports: &Along, quantity: Quantity, terms: &mut Terms) {
        for (s, support) in self.structure.supports.iter().enumerate() {
            let carried = nodes.iter().map(|(node, x)| x * support.carried[*node]);
            let moved = supports
                .iter()
                .filter(|(at, _)| *at == s)
                .map(|pair| pair.1);
            let (sum, size) = carried
                .chain(moved)
                .fold((0.0, 0.0), |(sum, size), x| (sum + x, size + f64::abs(x)));
            if f64::abs(sum) > ROUND_OFF * size {
                terms.add_motion(sum, &support.motion, quantity);
            }
        }
    }

    /// Adds B^T y.
    fn add_contacts(&self, y: &[f64], terms: &mut Terms) {
        for (c, contact) in self.structure.contacts.iter().enumerate() {
            let along = contact.along.iter();
            let factor = along.fold(0.0, |sum, (node, x)| sum + x * y[*node]);
            if factor != 0.0 {
                terms.s.push((c, factor));
            }
        }
    }
}

/// A y without sums below this part of their terms.
fn product(matrix: &Symmetric, y: &[f64], least: f64) -> Vec<f64> {
    let (mut sums, mut sizes) = (vec![0.0; y.len()], vec![0.0; y.len()]);
    for ((i, j), value) in matrix.entries() {
        for (row, column) in [(i, j), (j, i)].into_iter().take(1 + usize::from(i != j)) {
            let term = value * y[column];
            sums[row] += term;
            sizes[row] += f64::abs(term);
        }
    }
    for (sum, size) in sums.iter_mut().zip(sizes) {
        if f64::abs(*sum) <= least * size {
            *sum = 0.0;
        }
    }
    sums
}

/// Adds the factors that are not 0.
fn add(terms: &mut Along, factors: Vec<f64>) {
    let factors = factors.into_iter().enumerate();
    terms.extend(factors.filter(|(_, factor)| *factor != 0.0));
}
