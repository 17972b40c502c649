//! The steppers against the equations of the papers, solved with the matrices of a small structure.

use super::*;
use crate::system::Modal;
use nalgebra::{DMatrix, DVector, dmatrix, dvector};

/// A structure of three masses with a contact between the first and the last.
struct Structure {
    m: DMatrix<f64>,
    k: DMatrix<f64>,
    b: DVector<f64>,
}

fn structure() -> Structure {
    Structure {
        m: dmatrix![2.0, 0.3, 0.0; 0.3, 1.0, -0.2; 0.0, -0.2, 0.5],
        k: dmatrix![3.0, -1.0, 0.0; -1.0, 2.5, -1.5; 0.0, -1.5, 2.0],
        b: dvector![-1.0, 0.0, 1.0],
    }
}

/// Displacements, velocities and accelerations.
type State = [DVector<f64>; 3];

impl Structure {
    fn solve(&self, matrix: &DMatrix<f64>, right: &DVector<f64>) -> DVector<f64> {
        matrix.clone().lu().solve(right).unwrap()
    }

    fn acceleration(&self, u: &DVector<f64>, s: f64) -> DVector<f64> {
        self.solve(&self.m, &-(&self.k * u + &self.b * s))
    }

    /// M ((1 - am) a' + am a) + K ((1 - af) u' + af u) + b ((1 - af) S' + af S) = 0
    fn family(&self, c: &Coefficients, dt: f64, state: &State, [s, end]: [f64; 2]) -> State {
        let [u, v, a] = state;
        let (am, af) = (c.alpha_m, c.alpha_f);
        let free = u + v * dt + a * ((0.5 - c.beta) * dt * dt);
        let matrix = &self.m * (1.0 - am) + &self.k * ((1.0 - af) * c.beta * dt * dt);
        let right = &self.m * a * am
            + &self.k * (&free * (1.0 - af) + u * af)
            + &self.b * ((1.0 - af) * end + af * s);
        let next = self.solve(&matrix, &-right);
        [
            free + &next * (c.beta * dt * dt),
            v + (a * (1.0 - c.gamma) + &next * c.gamma) * dt,
            next,
        ]
    }

    /// The trapezoidal rule over dt/2, then v2 = (u0 - 4 u1 + 3 u2)/dt and the same of a2, with equilibrium at each end.
    fn bathe(&self, dt: f64, state: &State, [middle, end]: [f64; 2]) -> State {
        let [u0, v0, a0] = state;
        let h = 0.5 * dt;
        let matrix = &self.m * (4.0 / (h * h)) + &self.k;
        let inertia = &self.m * (u0 * (4.0 / (h * h)) + v0 * (4.0 / h) + a0);
        let u1 = self.solve(&matrix, &(inertia - &self.b * middle));
        let v1 = (&u1 - u0) * (2.0 / h) - v0;
        // a2 = (v0 - 4 v1 + 3 v2)/dt with v2 above.
        let matrix = &self.m * (9.0 / (dt * dt)) + &self.k;
        let known = (v0 - &v1 * 4.0) / dt + (u0 - &u1 * 4.0) * (3.0 / (dt * dt));
        let u2 = self.solve(&matrix, &-(&self.m * known + &self.b * end));
        let v2 = (u0 - &u1 * 4.0 + &u2 * 3.0) / dt;
        let a2 = self.acceleration(&u2, end);
        [u2, v2, a2]
    }

    /// M (v' - v) + dt K (u + theta dt v_theta) + dt b S' = 0
    fn moreau_jean(&self, theta: f64, dt: f64, state: &State, end: f64) -> State {
        let [u, v, a] = state;
        let matrix = &self.m + &self.k * (theta * theta * dt * dt);
        let force = &self.k * (u + v * (theta * (1.0 - theta) * dt)) + &self.b * end;
        let next = self.solve(&matrix, &(&self.m * v - force * dt));
        [
            u + (&next * theta + v * (1.0 - theta)) * dt,
            next,
            a.clone(),
        ]
    }
}

/// Steps with prescribed forces, beside the structure.
struct Compare<'a> {
    structure: &'a Structure,
    modal: &'a Modal,
    choice: Method,
    dt: f64,
    gap: f64,
    state: State,
    force: f64,
}

impl Compare<'_> {
    fn next(&self, forces: [f64; 2]) -> State {
        let [first, second] = forces;
        match &self.choice {
            Method::Family(coefficients) => {
                self.structure
                    .family(coefficients, self.dt, &self.state, [self.force, first])
            }
            Method::Bathe(Bathe) => self.structure.bathe(self.dt, &self.state, [first, second]),
            Method::MoreauJean(MoreauJean { theta }) => {
                self.structure
                    .moreau_jean(*theta, self.dt, &self.state, first)
            }
            Method::ContactStabilized(ContactStabilized) => {
                self.structure.moreau_jean(0.5, self.dt, &self.state, first)
            }
            Method::AverageAcceleration(AverageAcceleration) => unreachable!(),
        }
    }
}

impl WithMethod for Compare<'_> {
    type Output = ();
    fn run<N: Recursion<1>>(mut self, mut method: N) {
        let (choice, dt, b) = (self.choice, self.dt, self.structure.b.clone());
        let bathe = choice == Method::Bathe(Bathe);
        for i in 0..100 {
            let forces = [0.37, 0.61].map(|rate| libm::sin(rate * f64::from(i)));
            let next = self.next(forces);
            let mut seen = Recorder(forces, Vec::new());
            let on = method.flexibilities();
            let contact = method.step(&mut seen);
            let (r, rdot) = (b.dot(&next[0]) + self.gap, b.dot(&next[1]));
            // Accelerations of size 10 are solved with matrices of condition 10 for 100 steps; v also by differences over dt.
            let tolerance = 1e-12 * (1.0 + 1.0 / dt) * (1.0 + dt * dt);
            assert!(
                (contact.displacement.0[0] - r).abs() < tolerance,
                "{choice:?} {dt} {i}"
            );
            assert!(
                (contact.velocity.0[0] - rdot).abs() < tolerance,
                "{choice:?} {dt} {i}"
            );
            assert_eq!(contact, method.contact());
            // The trials and the flexibilities give the same motion.
            let last = usize::from(bathe);
            let (trial, force) = (&seen.1[last], forces[last]);
            let moved = on[last].start.h * trial.force + on[last].end.h * Lane([force]);
            let slowed = on[last].start.h_rate * trial.force + on[last].end.h_rate * Lane([force]);
            let r = (trial.displacement + trial.change - moved).0[0];
            let rdot = (trial.rate - slowed).0[0];
            assert!(
                (contact.displacement.0[0] - r).abs() < tolerance,
                "{choice:?} {dt} {i}"
            );
            assert!(
                (contact.velocity.0[0] - rdot).abs() < tolerance,
                "{choice:?} {dt} {i}"
            );
            // Modes sum to r and have the structure's energy.
            let energy = self.modal.energy(&next[0], &next[1]);
            let (mut sum, mut modal) = (0.0, 0.0);
            for (mode, (x, v)) in self.modal.modes(0).iter().zip(method.modes()) {
                sum += x.0[0];
                modal += mode.energy(x.0[0], v.0[0]);
            }
            assert!((sum + self.gap - contact.displacement.0[0]).abs() < tolerance);
            assert!(
                (modal - energy).abs() < 10.0 * tolerance * (1.0 + energy),
                "{choice:?} {dt}"
            );
            self.force = forces[last];
            self.state = next;
        }
    }
}

/// Prescribed forces, and the trials that they answered.
struct Recorder([f64; 2], Vec<Trial<1>>);

impl ContactResponse<1> for Recorder {
    fn force(&mut self, part: usize, trial: &Trial<1>) -> Lane<1> {
        assert_eq!(part, self.1.len());
        self.1.push(*trial);
        Lane([self.0[part]])
    }
}

#[test]
fn modes_under_a_force_follow_the_equations_of_the_papers() {
    let structure = structure();
    let b = DMatrix::from_column_slice(3, 1, structure.b.as_slice());
    let modal = Modal::new(&structure.m, &structure.k, &b).unwrap();
    let highest = modal.omega2.iter().copied().fold(0.0, f64::max).sqrt();
    let (u, v) = (dvector![0.7, -1.3, 2.1], dvector![1.0, 0.0, -0.5]);
    let (gap, force) = (0.25, 0.6);
    let (x, xdot) = (modal.shares(0, &u), modal.shares(0, &v));
    let modes: Vec<_> = (0..3)
        .map(|i| {
            let lane_mode = modal.modes(0)[i];
            mode(lane_mode.omega2, lane_mode.phi2, x[i], xdot[i])
        })
        .collect();
    for (choice, limit) in all() {
        for dt in [0.01, 0.3, 2.0] {
            if highest * dt > limit {
                continue;
            }
            let state = [u.clone(), v.clone(), structure.acceleration(&u, force)];
            let compare = Compare {
                structure: &structure,
                modal: &modal,
                choice,
                dt,
                gap,
                state,
                force,
            };
            with(&start(choice, dt, gap, force), &modes, compare);
        }
    }
}
