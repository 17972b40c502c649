//! Bars whose contact nodes have no mass, compared with all degrees of freedom: the nodes without mass are in equilibrium at each
//! step, with full matrices and without modes.

use crate::common;
use common::case;
use nalgebra::{DMatrix, DVector};
use serde_json::{Value as Json, json};
use slipgap::exact::mesh::Mesh;
use slipgap::lane::Lane;
use slipgap::metrics::impact::{Energy, Track};
use slipgap::problem::impact::case::{ImpactCase, condense};
use slipgap::problem::impact::scaled::Scaled;
use slipgap::problem::{Case, Problem, Snapshot, Solution, find};
use slipgap::solve::{self, ToSystem, Unsolvable};
use slipgap::system::bar::{Bar, Mass};
use std::f64::consts::PI;
use std::sync::Arc;

fn problem() -> Arc<dyn Problem> {
    find("bar-impact").unwrap()
}

/// A case without mass at the contact.
fn massless(given: &Json) -> Case {
    let mut given = given.clone();
    given["mass"] = json!("massless-contact");
    case(&*problem(), &given)
}

/// Equal and different bars, a wall, bars of one element, gaps that close within a step: at the touch itself rdot jumps.
fn mixed() -> [Json; 7] {
    [
        json!({"gamma": 1.0, "n": 10, "dt": 0.005, "duration": 1.5}),
        json!({"gamma": 3.0, "n": 5, "dt": 0.05, "duration": 2.0, "gap": 0.0537}),
        json!({"gamma": 2.0, "n": 10, "dt": 0.005, "duration": 2.5, "gap": 0.311,
               "right": {"L": 14.0, "A": 2.0, "n": 7, "V0": 0.03}}),
        json!({"gamma": 0.25, "n": 20, "dt": 0.01, "duration": 1.5, "right": "wall"}),
        json!({"gamma": 1e4, "n": 10, "dt": 0.01, "duration": 1.5}),
        json!({"gamma": 1.0, "n": 1, "dt": 0.01, "duration": 2.0}),
        json!({"gamma": 5.0, "n": 3, "dt": 0.01, "duration": 2.0, "right": {"n": 1, "L": 4.0}}),
    ]
}

/// All nodes from the far end of the left bar to the far end of the right one, in increments of the constant average acceleration
/// method. Displacements are positive to the right.
struct Nodes {
    mass: DVector<f64>,
    stiffness: DMatrix<f64>,
    /// r = b^T u + gap.
    b: DVector<f64>,
    spring: f64,
    gap: f64,
    dt: f64,
    u: DVector<f64>,
    v: DVector<f64>,
    a: DVector<f64>,
    closed: bool,
}

impl Nodes {
    fn new(scaled: &Scaled, dt: f64) -> Nodes {
        let first = scaled.pair.left.elements as usize + 1;
        let size = first + scaled.pair.right.map_or(0, |bar| bar.elements as usize + 1);
        let (mut mass, mut stiffness) = (DVector::zeros(size), DMatrix::zeros(size, size));
        for (bar, from, contact, neighbour) in [
            (Some(scaled.pair.left), 0, first - 1, first - 2),
            (scaled.pair.right, first, first, first + 1),
        ] {
            let Some(bar) = bar else { continue };
            let n = f64::from(bar.elements);
            // C0/h = 2 n/T and k = (C0/h)^2 m.
            let k = bar.mass / n * (2.0 * n / bar.travel_time).powi(2);
            for i in from..from + bar.elements as usize {
                for (row, column) in [(i, i + 1), (i + 1, i)] {
                    mass[row] += 0.5 * bar.mass / n;
                    stiffness[(row, row)] += k;
                    stiffness[(row, column)] -= k;
                }
            }
            mass[neighbour] += mass[contact];
            mass[contact] = 0.0;
        }
        let [left, right] = if scaled.pair.right.is_some() {
            [1.0, -1.0]
        } else {
            [2.0, 0.0]
        };
        let side = |x: f64, y: f64| DVector::from_fn(size, |i, _| if i < first { x } else { y });
        let mut b = DVector::zeros(size);
        b[first - 1] = -1.0;
        if let Some(b) = b.get_mut(first) {
            *b = 1.0;
        }
        Nodes {
            mass,
            stiffness,
            b,
            spring: scaled.spring,
            gap: scaled.bars.gap,
            dt,
            u: DVector::zeros(size),
            v: side(left, right),
            a: DVector::zeros(size),
            closed: false,
        }
    }

    fn step(&mut self) {
        let rate = 2.0 / self.dt;
        let weighted = |x: &DVector<f64>| self.mass.component_mul(x);
        let open = DMatrix::from_diagonal(&(&self.mass * (rate * rate))) + &self.stiffness;
        let load = weighted(&(&self.u * (rate * rate) + &self.v * (2.0 * rate) + &self.a));
        let u = open.clone().lu().solve(&load).unwrap();
        self.closed = self.b.dot(&u) + self.gap < 0.0;
        let u = if self.closed {
            let closed = open + &self.b * self.b.transpose() * self.spring;
            let load = load - &self.b * (self.spring * self.gap);
            closed.lu().solve(&load).unwrap()
        } else {
            u
        };
        let change = &u - &self.u;
        self.a = &change * (rate * rate) - &self.v * (2.0 * rate) - &self.a;
        self.v = change * rate - &self.v;
        self.u = u;
        self.contact_velocity();
    }

    /// The velocity of nodes without mass from the rate of their equilibrium.
    fn contact_velocity(&mut self) {
        let mut tangent = self.stiffness.clone();
        if self.closed {
            tangent += &self.b * self.b.transpose() * self.spring;
        }
        let nodes: Vec<usize> = (0..self.mass.len())
            .filter(|i| self.mass[*i] == 0.0)
            .collect();
        for i in &nodes {
            self.v[*i] = 0.0;
        }
        let unbalanced = &tangent * &self.v;
        let load = DVector::from_fn(nodes.len(), |i, _| -unbalanced[nodes[i]]);
        let inner = DMatrix::from_fn(nodes.len(), nodes.len(), |i, j| {
            tangent[(nodes[i], nodes[j])]
        });
        let rates = inner.lu().solve(&load).unwrap();
        for (i, rate) in nodes.iter().zip(rates.iter()) {
            self.v[*i] = *rate;
        }
    }

    /// r, rdot/c and F/F0.
    fn contact(&self) -> [f64; 3] {
        let r = self.b.dot(&self.u) + self.gap;
        [r, 0.5 * self.b.dot(&self.v), -self.spring * r.min(0.0)]
    }

    fn energy(&self) -> f64 {
        let r = self.contact()[0].min(0.0);
        let kinetic = self.v.dot(&self.mass.component_mul(&self.v));
        let strain = self.u.dot(&(&self.stiffness * &self.u));
        0.5 * (kinetic + strain + self.spring * r * r)
    }
}

#[test]
fn all_nodes_have_the_same_motion_and_energy() {
    for given in mixed() {
        let case = massless(&given);
        let impact = ImpactCase::new(&case).unwrap();
        let Solution {
            computed, metrics, ..
        } = problem().solve(&case, &[]).unwrap();
        let mut nodes = Nodes::new(&impact.scaled, impact.dt);
        let start = nodes.energy();
        let (mut worst, mut drift) = ([0.0_f64; 3], vec![0.0]);
        for i in 1..computed.len() {
            nodes.step();
            let c = [
                computed.displacement()[i],
                computed.velocity()[i],
                computed.force()[i],
            ];
            for (worst, (c, e)) in worst.iter_mut().zip(c.iter().zip(nodes.contact())) {
                *worst = worst.max((c - e).abs());
            }
            drift.push((nodes.energy() - start) / impact.system().linear.energy());
        }
        let largest = drift
            .iter()
            .fold(0.0, |a: f64, b| if b.abs() > a.abs() { *b } else { a });
        let energy = [
            metrics[8].unwrap() - largest,
            metrics[9].unwrap() - drift[drift.len() - 1],
        ];
        // Velocities of all nodes are differences of displacements over dt/2 in up to 500 steps. Measured: 7e-12, and 2e-11 for energy.
        let worst = worst
            .iter()
            .chain(&energy)
            .fold(0.0, |a: f64, b| a.max(b.abs()));
        assert!(worst < 1e-10, "{given}: {worst:e}");
        assert!(
            computed.force().iter().any(|f| *f > 0.1),
            "{given}: no contact"
        );
    }
}

#[test]
fn energy_by_the_work_of_the_contact_is_that_of_all_modes() {
    for given in mixed() {
        let impact = ImpactCase::new(&massless(&given)).unwrap();
        let system = impact.system();
        let mut sums = Vec::new();
        // r of the modes times S/2 is the energy of the spring and of the elements without mass.
        solve::visit(&system, |_, stepper| {
            let contact = stepper.contact();
            let modes = (0..).zip(stepper.modes());
            let energy: f64 = modes
                .map(|(j, [x, v])| impact.scaled.pair.mode(j).energy(x, v))
                .sum();
            sums.push(energy + 0.5 * contact.force.0[0] * contact.displacement.0[0]);
        });
        // The work of the contact is with r of the contact itself.
        let mut track = solve::run::<Track<1>>(&system).unwrap().track;
        condense(&[impact], &mut track);
        let mut worst: f64 = 0.0;
        for (step, sum) in sums.iter().enumerate() {
            let Lane([energy]) = Energy::of_case(&track, &system, step + 1).last;
            worst = worst.max((energy - sum).abs() / sums[0]);
        }
        // Round-off of r in each step times the force; sums over up to 42 modes.
        let steps = sums.len() as f64;
        assert!(
            worst < 2e-16 * (20.0 + steps),
            "{given}: {worst:e} in {steps}"
        );
    }
}

#[test]
fn no_oscillation_stays_at_the_contact() {
    // With mass at the contact the contact mode keeps its amplitude 1 - 1/sqrt(1 + 4 gamma^2) for any n. Without it, only radiating
    // waves are left, which fall with the time in h/C0, so with n in the same part of T_I. Measured at n = 20 and 80: 0.0016 and 0.00003 for
    // gamma = 0.25, 0.0005 and 0.00003 for 1, 0.0004 and 0.00002 for 4.
    for gamma in [0.25, 1.0, 4.0] {
        let late = |mass: &str, n: u32| {
            let dt = 0.01 / f64::from(n);
            let given = json!({"gamma": gamma, "n": n, "dt": dt, "duration": 0.9, "mass": mass});
            let c = problem()
                .solve(&case(&*problem(), &given), &[])
                .unwrap()
                .computed;
            let from = c.time.partition_point(|t| *t < 0.3);
            let to = c.time.partition_point(|t| *t < 0.85);
            let swing = c.velocity()[from..to]
                .iter()
                .fold(0.0, |a: f64, v| a.max(v.abs()));
            let force = c.force()[from..to].iter().map(|f| (f - 1.0).abs());
            [swing, force.fold(0.0, f64::max)]
        };
        let mode = 1.0 - 1.0 / f64::sqrt(1.0 + 4.0 * gamma * gamma);
        assert!(late("lumped", 80)[0] > 0.97 * mode);
        let [coarse, fine] = [20, 80].map(|n| late("massless-contact", n));
        assert!(
            coarse[0] < 0.002 && fine[0] < 0.08 * coarse[0],
            "{gamma}: {coarse:?} {fine:?}"
        );
        assert!(
            coarse[1] < 0.002 && fine[1] < 1e-4,
            "{gamma}: {coarse:?} {fine:?}"
        );
    }
}

#[test]
fn a_long_mesh_repeats_the_front_of_a_short_one() {
    // In h/C0 and h both meshes are the same until the front returns; it passes 0.3 T_I of 1 only. The front of the shorter mesh is
    // ahead of h/C0 by some elements, with amplitudes below round-off.
    for gamma in [0.25, 1.0, 4.0] {
        let solve = |n: u32| {
            let given = json!({"gamma": gamma, "n": n, "dt": 0.08 / f64::from(n), "duration": 12.0 / f64::from(n)});
            problem().solve(&massless(&given), &[]).unwrap().computed
        };
        let [short, long] = [40, 80].map(solve);
        let mut worst = [0.0_f64; 3];
        for i in 0..=150 {
            worst[0] = worst[0].max((short.displacement()[i] - 2.0 * long.displacement()[i]).abs());
            worst[1] = worst[1].max((short.velocity()[i] - long.velocity()[i]).abs());
            worst[2] = worst[2].max((short.force()[i] - long.force()[i]).abs());
        }
        // Round-off of 150 steps of 40 and 80 modes.
        let worst = worst.iter().fold(0.0, |a: f64, b| a.max(*b));
        assert!(worst < 1e-13, "gamma = {gamma}: {worst:e}");
    }
}

#[test]
fn profiles_are_those_of_all_nodes() {
    for given in mixed() {
        let case = massless(&given);
        let impact = ImpactCase::new(&case).unwrap();
        let times: Vec<f64> = (0..=8)
            .map(|i| 0.125 * f64::from(i) * impact.duration)
            .collect();
        let snapshots = problem().as_textbook().unwrap().snapshots(&case, &times);
        let mut nodes = Nodes::new(&impact.scaled, impact.dt);
        let mut worst: f64 = 0.0;
        let mut step = 0;
        for snapshot in &snapshots {
            while (f64::from(step) + 0.5) * impact.dt < snapshot.time {
                nodes.step();
                step += 1;
            }
            worst = worst.max(difference(&impact.scaled, &nodes, snapshot));
        }
        // As in the motion of the contact; a stress is the stretch of an element times up to 60.
        assert!(worst < 1e-9, "{given}: {worst:e}");
    }
}

/// The largest difference of a velocity at a node or of a stress in an element.
fn difference(scaled: &Scaled, nodes: &Nodes, snapshot: &Snapshot) -> f64 {
    let first = scaled.pair.left.elements as usize + 1;
    let frame = if scaled.pair.right.is_some() {
        0.0
    } else {
        1.0
    };
    let mut worst: f64 = 0.0;
    for (i, bar) in scaled.pair.each().enumerate() {
        let n = bar.elements as usize;
        let node = |k: usize| if i == 0 { first - 1 - k } else { first + k };
        let velocity = &snapshot.profiles[0].computed[i];
        assert_eq!(velocity.len(), n + 1);
        for (k, [_, v]) in velocity.iter().enumerate() {
            worst = worst.max((v - (nodes.v[node(k)] - frame)).abs());
        }
        for (k, [_, stress]) in snapshot.profiles[1].computed[i].iter().enumerate() {
            let stretch =
                (nodes.u[node(k + 1)] - nodes.u[node(k)]) * if i == 0 { -1.0 } else { 1.0 };
            let stiffness = -nodes.stiffness[(node(k), node(k + 1))];
            worst = worst.max((stress - stiffness * stretch).abs());
        }
    }
    worst
}

#[test]
fn bars_of_one_element_are_masses_on_a_spring() {
    // m/2 on 1/(1/k + c0) with m = 1/2, k = 2 gamma and c0 = 1 in the units of the mesh: half a period of sin(omega t).
    for gamma in [0.25, 1.0, 40.0, 1e12] {
        let bar = Bar {
            elements: 1,
            mass: 0.5,
            travel_time: 1.0,
            kind: Mass::MasslessContact,
        };
        let mut mesh = Mesh::new(&bar, 2.0 * gamma, 0.3).unwrap();
        let share = 1.0 / (1.0 + 2.0 * gamma);
        let omega = f64::sqrt(2.0 * gamma * share / 0.25);
        for i in 0..100 {
            let t = 0.04 * f64::from(i);
            let state = mesh.at(0.15 + t).unwrap();
            let (sin, cos) = (omega * t).sin_cos();
            let expected = if t < PI / omega {
                [-share * 2.0 / omega * sin, -share * cos, 0.5 * omega * sin]
            } else {
                [2.0 * (t - PI / omega), 1.0, 0.0]
            };
            for (a, b) in state.values().iter().zip(expected) {
                // The time of an event has an error of 1e-13.
                assert!((a - b).abs() < 1e-12, "{gamma} at {t}: {a} {b}");
            }
        }
    }
}

#[test]
fn the_step_error_has_the_second_order() {
    let metrics = |dt: f64| {
        let given = json!({"gamma": 1.0, "n": 7, "dt": dt, "duration": 1.5, "gap": 0.1});
        problem().solve(&massless(&given), &[12]).unwrap().metrics
    };
    let by_step = [0.004, 0.002, 0.001, 0.0005].map(metrics);
    for pair in by_step.windows(2) {
        // Rows of the step error of r and of rdot; the times of opening and closing relative to the steps differ.
        for row in [16, 17] {
            let [coarse, fine] = [0, 1].map(|i| pair[i][row].unwrap());
            let order = (coarse / fine).log2();
            assert!((1.8..2.2).contains(&order), "{coarse} {fine}");
        }
    }
    for m in &by_step {
        let shares: Vec<f64> = m[18..24].iter().map(|share| share.unwrap()).collect();
        for of in [0, 1] {
            let sum = shares[of] + shares[of + 2] + shares[of + 4];
            assert!((sum - 1.0).abs() < 1e-13, "{shares:?}");
        }
    }
}

#[test]
fn the_papers_matrices_are_refused() {
    let given = json!({"gamma": 1.0, "n": 4, "dt": 0.1, "duration": 1.0});
    let refused = problem()
        .as_textbook()
        .unwrap()
        .solve_once(&massless(&given), &[]);
    assert_eq!(refused.err(), Some(Unsolvable::SingularMass));
}
