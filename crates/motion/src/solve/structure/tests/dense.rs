//! The textbook form: full matrices, accelerations, and all patterns of the contacts.

use super::*;
use crate::contact::ClippedLine;
use crate::solve::structure::{Prepared, run};
use nalgebra::{DMatrix, DVector};

pub(super) fn full(matrix: &Symmetric) -> DMatrix<f64> {
    let mut full = DMatrix::zeros(matrix.size(), matrix.size());
    for ((i, j), value) in matrix.entries() {
        (full[(i, j)], full[(j, i)]) = (value, value);
    }
    full
}

/// A structure with full matrices.
struct Dense<'a> {
    structure: &'a Structure,
    m: DMatrix<f64>,
    k: DMatrix<f64>,
    c: DMatrix<f64>,
    b: DMatrix<f64>,
    u: DVector<f64>,
    v: DVector<f64>,
    a: DVector<f64>,
    s: DVector<f64>,
}

impl Dense<'_> {
    fn new(structure: &Structure) -> Dense<'_> {
        let (n, count) = (structure.len(), structure.contacts.len());
        let masses = structure.nodes.iter().map(|node| node.mass);
        let mut b = DMatrix::zeros(n, count);
        for c in 0..count {
            for (node, sign) in structure.column(c) {
                b[(node, c)] = sign;
            }
        }
        let mut dense = Dense {
            structure,
            m: DMatrix::from_diagonal(&DVector::from_iterator(n, masses)),
            k: full(&structure.stiffness),
            c: full(&structure.damping),
            b,
            u: DVector::from_column_slice(&structure.displacement),
            v: DVector::from_column_slice(&structure.velocity),
            a: DVector::zeros(n),
            s: DVector::zeros(count),
        };
        dense.a = dense.acceleration(0.0);
        dense
    }

    fn loads(&self, t: f64) -> DVector<f64> {
        let mut p = DVector::zeros(self.structure.len());
        self.structure.add_loads(t, p.as_mut_slice());
        p
    }

    fn acceleration(&self, t: f64) -> DVector<f64> {
        let force = self.loads(t) - &self.c * &self.v - &self.k * &self.u - &self.b * &self.s;
        self.m.clone().lu().solve(&force).unwrap()
    }

    /// Newmark's form in displacements; each law as r = c + g S between its bounds.
    fn step(&mut self, t: f64, dt: f64) {
        let [m, c, k] = [&self.m, &self.c, &self.k];
        let khat = (m * (4.0 / (dt * dt)) + c * (2.0 / dt) + k).lu();
        let inertia = m * (&self.u * (4.0 / (dt * dt)) + &self.v * (4.0 / dt) + &self.a);
        let viscous = c * (&self.u * (2.0 / dt) + &self.v);
        let free = khat.solve(&(self.loads(t) + inertia + viscous)).unwrap();
        let d = khat.solve(&self.b).unwrap();
        let h = self.b.transpose() * &d;
        let count = self.s.len();
        let gap = DVector::from_iterator(count, self.structure.contacts.iter().map(|c| c.gap));
        let (r, rdot) = (self.b.transpose() * &self.u, self.b.transpose() * &self.v);
        let trial = self.b.transpose() * &free + &gap;
        let (mut g, mut center) = (DVector::zeros(count), DVector::zeros(count));
        let (mut low, mut high) = (DVector::zeros(count), DVector::zeros(count));
        for i in 0..count {
            let law = &self.structure.contacts[i].law;
            let limit = law.limit().map(|limit| limit.at(t));
            (low[i], high[i]) = limit.map_or((f64::NEG_INFINITY, 0.0), |limit| (-limit, limit));
            let viscous = r[i] + gap[i] + 0.5 * dt * rdot[i];
            (g[i], center[i]) = match law.line() {
                Some(ClippedLine::Spring { stiffness }) => (1.0 / stiffness, 0.0),
                Some(ClippedLine::Stop { .. }) => (0.0, 0.0),
                Some(ClippedLine::Elastic { stiffness }) => {
                    (1.0 / stiffness, r[i] + gap[i] - self.s[i] / stiffness)
                }
                Some(ClippedLine::Viscous { viscosity }) => (0.5 * dt / viscosity, viscous),
                Some(ClippedLine::Coulomb) => (0.0, viscous),
                None => unreachable!(),
            };
        }
        self.s = all_patterns(
            &(h + DMatrix::from_diagonal(&g)),
            &(trial - center),
            &low,
            &high,
        );
        let u = free - d * &self.s;
        let v = (&u - &self.u) * (2.0 / dt) - &self.v;
        (self.u, self.v) = (u, v);
        self.a = self.acceleration(t);
    }
}

/// The one pattern of low, free and high forces that contradicts itself least.
pub(super) fn all_patterns(
    a: &DMatrix<f64>,
    d: &DVector<f64>,
    low: &DVector<f64>,
    high: &DVector<f64>,
) -> DVector<f64> {
    let count = d.len();
    let mut best = (f64::INFINITY, DVector::zeros(count));
    for pattern in 0..3_usize.pow(count as u32) {
        let digit = |i: usize| pattern / 3_usize.pow(i as u32) % 3;
        if (0..count).any(|i| digit(i) == 0 && low[i].is_infinite()) {
            continue;
        }
        // Rows of fixed forces say S = bound.
        let (mut matrix, mut right) = (a.clone(), d.clone());
        for i in (0..count).filter(|i| digit(*i) != 1) {
            matrix.row_mut(i).fill(0.0);
            matrix[(i, i)] = 1.0;
            right[i] = if digit(i) == 0 { low[i] } else { high[i] };
        }
        let Some(s) = matrix.lu().solve(&right) else {
            continue;
        };
        let q = d - a * &s;
        let wrong_by = |i: usize| match digit(i) {
            0 => q[i] / a[(i, i)],
            1 => (low[i] - s[i]).max(s[i] - high[i]),
            _ => -q[i] / a[(i, i)],
        };
        let wrong = (0..count).map(wrong_by).fold(0.0, f64::max);
        if wrong < best.0 {
            best = (wrong, s);
        }
    }
    best.1
}

#[test]
fn the_textbook_form_moves_alike() {
    let ground = ground();
    let mut second = girders(1, 1.0, 3.0, &ground);
    // Closed loops, a general C, and a start in motion.
    for (i, j) in [(0, 4), (2, 7), (1, 8), (5, 8)] {
        second.stiffness.add_spring([Some(i), Some(j)], 3e3);
    }
    second.damping.add(2, 5, -30.0);
    second.damping.add(2, 2, 80.0);
    second.damping.add(5, 5, 90.0);
    second.velocity[4] = 0.7;
    second.displacement[7] = 0.01;
    for (structure, dt) in [
        (girders(2, 0.25, 1.0, &ground), 0.005),
        (second, 0.005),
        (mixed(2, 0.5, &ground), 0.005),
    ] {
        let steps = 800;
        let mut dense = Dense::new(&structure);
        let prepared = Prepared::new(&structure, dt).unwrap();
        let (mut worst, mut size) = ([0.0_f64; 3], [0.0_f64; 3]);
        let mut touched = vec![[false; 2]; structure.contacts.len()];
        let [done] = run::<1>(&[&structure], &prepared, steps, |step, state| {
            if step == 0 {
                dense.s = DVector::from_iterator(
                    dense.s.len(),
                    (0..state.contacts()).map(|c| state.contact(c).force.0[0]),
                );
                dense.a = dense.acceleration(0.0);
            } else {
                dense.step(step as f64 * dt, dt);
            }
            let mut compare = |k: usize, a: f64, b: f64| {
                worst[k] = worst[k].max((a - b).abs());
                size[k] = size[k].max(b.abs());
            };
            for node in 0..state.nodes() {
                compare(0, state.displacement(node).0[0], dense.u[node]);
                compare(1, state.velocity(node).0[0], dense.v[node]);
            }
            for (c, touched) in touched.iter_mut().enumerate() {
                let now = state.contact(c);
                compare(2, now.force.0[0], dense.s[c]);
                let fixed = now.force.0[0].abs() == now.limit.0[0];
                touched[usize::from(fixed)] = true;
            }
        });
        done.unwrap();
        // All contacts were free and at a bound.
        assert!(touched.iter().all(|t| *t == [true, true]), "{touched:?}");
        // The textbook form takes differences of 4/dt^2 u, some 1e-11 of u. An impact's force is k_I = 4e6 times r.
        for (k, tolerance) in [1e-10, 1e-9, 1e-8].into_iter().enumerate() {
            assert!(worst[k] < tolerance * size[k], "{k} {worst:?} {size:?}");
        }
    }
}
