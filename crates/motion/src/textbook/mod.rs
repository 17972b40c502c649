//! The textbook form of the same method: assembled M and K, the papers' 2x2 element matrices, their iteration.
//!
//! A reader of the papers expects this form, and the modal form is tested with it. No converged result depends on it, because its
//! iteration can cycle; [`Cycle`] reports that.

mod assembled_bars;
mod linear_system;

pub use assembled_bars::{assemble, assemble_bars};

use crate::contact::element::Element;
use linear_system::solve;
use nalgebra::{DMatrix, DVector};

/// An assembled structure M u'' + K u + F^C = 0 with one two-node element between I and J.
#[derive(Debug, Clone)]
pub struct Assembly {
    /// Mass matrix M.
    pub mass: DMatrix<f64>,
    /// Stiffness matrix K, without the element.
    pub stiffness: DMatrix<f64>,
    /// Degrees of freedom of I and J; `None` for a fixed node. r = u_J - u_I [F (2), I (3)].
    pub nodes: [Option<usize>; 2],
    /// Gap at rest, added to r.
    pub gap: f64,
}

/// How a step's equation is solved.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Iteration {
    /// Until the branch of the element does not change and the residual is within 1/1000 of the largest force.
    Converged,
    /// No iteration: the tangent at the start of the step; the method gives the acceleration.
    Once,
}

/// The iteration did not converge in this step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cycle {
    /// The step, from 1.
    pub step: usize,
}

/// The assembled structure, integrated in time.
#[derive(Debug, Clone)]
pub struct Newmark<E> {
    assembly: Assembly,
    /// The element with its state at the end of the last step.
    pub element: E,
    dt: f64,
    step: usize,
    u: DVector<f64>,
    v: DVector<f64>,
    a: DVector<f64>,
}

impl<E: Element> Newmark<E> {
    /// From `u`, `v` at T = 0, with a(0) from equilibrium; `None` if M has no inverse.
    pub fn new(
        assembly: Assembly,
        element: E,
        dt: f64,
        u: DVector<f64>,
        v: DVector<f64>,
    ) -> Option<Self> {
        let forces = &assembly.stiffness * &u + assembly.spread(element.state().force);
        let a = -solve(assembly.mass.clone(), &forces)?;
        Some(Newmark {
            assembly,
            element,
            dt,
            step: 0,
            u,
            v,
            a,
        })
    }

    /// Relative displacement and velocity of the element, and its force.
    pub fn contact(&self) -> [f64; 3] {
        let (r, rdot) = self.relative(&self.u, &self.v);
        [r, rdot, self.element.state().force]
    }

    /// Displacements and velocities of the degrees of freedom.
    pub fn state(&self) -> (&DVector<f64>, &DVector<f64>) {
        (&self.u, &self.v)
    }

    /// One step of the constant average acceleration method.
    ///
    /// # Errors
    /// [`Cycle`] if the iteration does not converge; the state is then that of the step before.
    pub fn step(&mut self, iteration: Iteration) -> Result<(), Cycle> {
        self.step += 1;
        let dt = self.dt;
        let (_, rdot0) = self.relative(&self.u, &self.v);
        // Linearised about the start of the step: with the same u, v becomes -v and a becomes -4 v/dt - a.
        let mut state = self.element.state();
        let mut u = self.u.clone();
        let mut a = &self.v * (-4.0 / dt) - &self.a;
        let mut force = state.force - state.damping * 2.0 * rdot0;
        let mut branch = None;
        for _ in 0..50 {
            let residual = -(&self.assembly.mass * &a
                + &self.assembly.stiffness * &u
                + self.assembly.spread(force));
            let tangent = self.assembly.mass.clone() * (4.0 / (dt * dt))
                + &self.assembly.stiffness
                + self
                    .assembly
                    .matrix(state.stiffness + state.damping * 2.0 / dt);
            let Some(du) = solve(tangent, &residual) else {
                break;
            };
            u += du;
            let v = (&u - &self.u) * (2.0 / dt) - &self.v;
            a = (&u - &self.u) * (4.0 / (dt * dt)) - &self.v * (4.0 / dt) - &self.a;
            let (r, rdot) = self.relative(&u, &v);
            let trial = self.element.trial(r, rdot);
            let inertia = &self.assembly.mass * &a;
            let internal = &self.assembly.stiffness * &u + self.assembly.spread(trial.force);
            // In free flight both forces are round-off of the terms of the increments.
            let increments = (&self.assembly.mass * (&u + &self.u)).norm() * 4.0 / (dt * dt);
            let largest = inertia.norm().max(internal.norm());
            let within = (&inertia + &internal).norm() <= (1e-3 * largest).max(1e-13 * increments);
            // Branches are compared within the step only: N, and so the force at the start, may have changed.
            let converged = branch == Some(trial.branch) && within;
            (state, force, branch) = (trial, trial.force, Some(trial.branch));
            if converged || iteration == Iteration::Once {
                (self.u, self.v, self.a) = (u, v, a);
                self.element.commit(r, rdot);
                return Ok(());
            }
        }
        Err(Cycle { step: self.step })
    }

    /// The structure.
    pub fn assembly(&self) -> &Assembly {
        &self.assembly
    }

    fn relative(&self, u: &DVector<f64>, v: &DVector<f64>) -> (f64, f64) {
        let relative = |x| self.assembly.relative(x);
        (relative(u) + self.assembly.gap, relative(v))
    }
}

impl Assembly {
    /// Displacement or velocity of J relative to I.
    pub fn relative(&self, x: &DVector<f64>) -> f64 {
        let at = |node: Option<usize>| node.map_or(0.0, |i| x[i]);
        let [i, j] = self.nodes;
        at(j) - at(i)
    }

    /// F^C = {F_I, F_J} = {-S, S} over the degrees of freedom [F (6), I (4)].
    fn spread(&self, s: f64) -> DVector<f64> {
        let mut f = DVector::zeros(self.mass.nrows());
        for (node, sign) in self.nodes.iter().zip([-1.0, 1.0]) {
            if let Some(i) = node {
                f[*i] += sign * s;
            }
        }
        f
    }

    /// The 2x2 matrix [k -k; -k k] of k^FR, c^FR, k^IM over the degrees of freedom [F (8), (15), I (6)].
    fn matrix(&self, k: f64) -> DMatrix<f64> {
        let mut matrix = DMatrix::zeros(self.mass.nrows(), self.mass.nrows());
        for (row, node) in self.nodes.iter().enumerate() {
            for (column, other) in self.nodes.iter().enumerate() {
                if let (Some(i), Some(j)) = (node, other) {
                    matrix[(*i, *j)] += if row == column { k } else { -k };
                }
            }
        }
        matrix
    }
}
