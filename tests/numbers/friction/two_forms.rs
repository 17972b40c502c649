//! The modal form with its closed-form root, compared with the textbook form with the papers' matrices and iteration.

use nalgebra::{DMatrix, DVector, dmatrix, dvector};
use slipgap::contact::element::{DisplacementFriction, Element, VelocityFriction};
use slipgap::contact::{
    DisplacementControl, Law, RunningLaw, StepLaw, VelocityControl, friction_limit,
};
use slipgap::lane::Lane;
use slipgap::methods::{AverageAcceleration, ModeStart, Recursion, Start};
use slipgap::solve::visited::Stepper;
use slipgap::system::Modal;
use slipgap::textbook::{Assembly, Cycle, Iteration, Newmark};
use std::f64::consts::PI;

/// A structure, the position of its contact, its state at t = 0, and its steps.
struct Set {
    assembly: Assembly,
    u: DVector<f64>,
    v: DVector<f64>,
    dt: f64,
    steps: usize,
}

impl Set {
    /// The papers' oscillator: the surface is fixed, the mass moves [F] Fig. 4.
    fn oscillator(x0: f64, dt: f64, steps: usize) -> Set {
        Set {
            assembly: Assembly {
                mass: dmatrix![1.0],
                stiffness: dmatrix![1.0],
                nodes: [None, Some(0)],
                gap: 0.0,
            },
            u: dvector![x0],
            v: dvector![0.0],
            dt,
            steps,
        }
    }

    /// Three masses in a row on springs, with friction between the first and the last one.
    fn frame(dt: f64, steps: usize) -> Set {
        Set {
            assembly: Assembly {
                mass: DMatrix::from_diagonal(&dvector![1.0, 2.0, 0.5]),
                stiffness: dmatrix![3.0, -1.0, 0.0; -1.0, 2.5, -1.5; 0.0, -1.5, 2.0],
                nodes: [Some(0), Some(2)],
                gap: 0.0,
            },
            u: dvector![2.0, 5.0, -4.0],
            v: dvector![0.0, -1.0, 3.0],
            dt,
            steps,
        }
    }

    fn modal(&self, force: f64) -> Stepper {
        let mut b = DMatrix::zeros(self.u.len(), 1);
        for (node, sign) in self.assembly.nodes.iter().zip([-1.0, 1.0]) {
            if let Some(i) = node {
                b[(*i, 0)] += sign;
            }
        }
        let modal = Modal::new(&self.assembly.mass, &self.assembly.stiffness, &b).unwrap();
        let (x, v) = (modal.shares(0, &self.u), modal.shares(0, &self.v));
        let start = modal
            .modes(0)
            .into_iter()
            .enumerate()
            .map(|(k, mode)| ModeStart {
                mode: [mode],
                displacement: Lane([x[k]]),
                velocity: Lane([v[k]]),
            });
        let at = Start {
            method: [AverageAcceleration.into()],
            dt: Lane([self.dt]),
            gap: Lane([0.0]),
            force: Lane([force]),
        };
        Stepper::new(&at, start).unwrap()
    }

    /// Largest difference of r, rdot and S over all steps, `change` preparing both laws for a step.
    fn difference<W: StepLaw<1>, E: Element>(
        &self,
        law: W,
        element: E,
        change: impl Fn(usize, &mut W, &mut E),
    ) -> Result<f64, Cycle> {
        let mut modal = self.modal(element.state().force);
        let mut law = RunningLaw::new(law);
        let mut textbook = Newmark::new(
            self.assembly.clone(),
            element,
            self.dt,
            self.u.clone(),
            self.v.clone(),
        )
        .unwrap();
        let mut largest: f64 = 0.0;
        for step in 1..=self.steps {
            change(step, &mut law.parts[0], &mut textbook.element);
            let contact = modal.step(&mut law);
            textbook.step(Iteration::Converged)?;
            let [r, rdot, s] = textbook.contact();
            for (a, b) in [
                (contact.displacement, r),
                (contact.velocity, rdot),
                (contact.force, s),
            ] {
                largest = largest.max((a.0[0] - b).abs());
            }
        }
        Ok(largest)
    }
}

/// Both displacement-control forms with k^C = 1/alpha, nu = 0.5, N = -2, S(0) = 0, on this structure.
fn displacement(
    set: &Set,
    alpha: f64,
    slip: f64,
) -> (<DisplacementControl as Law>::Step<1>, DisplacementFriction) {
    let law = DisplacementControl {
        compliance: alpha,
        limit: friction_limit(0.5, -2.0),
    };
    (
        Law::step(&[law], &set.modal(0.0).flexibilities()[0]),
        DisplacementFriction::new(1.0 / alpha, 0.5, -2.0, slip, 0.0),
    )
}

/// Both velocity-control forms with c^C = 1/beta.
fn velocity(set: &Set, beta: f64) -> (<VelocityControl as Law>::Step<1>, VelocityFriction) {
    let law = VelocityControl {
        compliance: beta,
        limit: friction_limit(0.5, -2.0),
    };
    (
        Law::step(&[law], &set.modal(0.0).flexibilities()[0]),
        VelocityFriction::new(1.0 / beta, 0.5, -2.0),
    )
}

/// Round-off: 80 steps of numbers up to 12, the textbook form working with 4/dT^2 = 40 times as large ones, and a
/// force that takes r over alpha = 0.1.
const ROUND_OFF: f64 = 2e-12;

#[test]
fn both_forms_agree_on_the_papers_oscillator() {
    for divisor in [10.0, 5.0, 3.0] {
        let steps = (8.0 * divisor) as usize;
        let set = Set::oscillator(12.0, PI / divisor, steps);
        for alpha in [0.1, 1.0, 5.0] {
            let (law, element) = displacement(&set, alpha, 12.0);
            let difference = set.difference(law, element, |_, _, _| ()).unwrap();
            assert!(difference < ROUND_OFF, "alpha = {alpha}: {difference:e}");
        }
        for beta in [1.0, 5.0] {
            let (law, element) = velocity(&set, beta);
            let difference = set.difference(law, element, |_, _, _| ()).unwrap();
            assert!(difference < ROUND_OFF, "beta = {beta}: {difference:e}");
        }
    }
}

#[test]
fn both_forms_agree_for_a_contact_of_two_masses() {
    let set = Set::frame(0.1, 400);
    let (law, element) = displacement(&set, 0.3, -6.0);
    let difference = set.difference(law, element, |_, _, _| ()).unwrap();
    assert!(difference < ROUND_OFF, "{difference:e}");
    let (law, element) = velocity(&set, 0.5);
    let difference = set.difference(law, element, |_, _, _| ()).unwrap();
    assert!(difference < ROUND_OFF, "{difference:e}");
}

#[test]
fn the_papers_iteration_cycles_where_the_root_exists() {
    // A cycle exists for beta < 2 dT/(4 + dT^2) = 0.153 at dT = pi/10: the paper's beta = 0.1 meets it near rest.
    let set = Set::oscillator(12.0, PI / 10.0, 80);
    let (law, element) = velocity(&set, 0.1);
    let cycle = set.difference(law, element, |_, _, _| ()).unwrap_err();
    assert!([59, 60].contains(&cycle.step), "step {}", cycle.step);
    let before = Set::oscillator(12.0, PI / 10.0, cycle.step - 1);
    let difference = before.difference(law, element, |_, _, _| ()).unwrap();
    assert!(difference < ROUND_OFF, "{difference:e}");
}

/// N over the steps: closed, with less force, open, closed again.
fn normal_force(step: usize) -> f64 {
    -1.0 - 2.0 * libm::sin(step as f64 * 0.05)
}

#[test]
fn friction_vanishes_and_slip_follows_in_an_open_contact() {
    let set = Set::frame(0.1, 400);
    let (law, element) = displacement(&set, 0.3, -6.0);
    let difference = set
        .difference(law, element, |step, law, element| {
            law.limit = Lane([friction_limit(0.5, normal_force(step))]);
            element.normal_force = normal_force(step);
        })
        .unwrap();
    assert!(difference < ROUND_OFF, "{difference:e}");

    let mut modal = set.modal(0.0);
    let mut lifted = 0;
    let mut law = RunningLaw::new(law);
    for step in 1..=set.steps {
        let limit = friction_limit(0.5, normal_force(step));
        law.parts[0].limit = Lane([limit]);
        let contact = modal.step(&mut law);
        if normal_force(step) >= 0.0 {
            lifted += 1;
            assert_eq!(contact.force, Lane([0.0]));
        }
        assert!(contact.force.0[0].abs() <= limit);
    }
    assert!(lifted > 100, "the test must lift the contact");

    let (law, element) = velocity(&set, 0.5);
    let difference = set
        .difference(law, element, |step, law, element| {
            law.limit = Lane([friction_limit(0.5, normal_force(step))]);
            element.normal_force = normal_force(step);
        })
        .unwrap();
    assert!(difference < ROUND_OFF, "{difference:e}");
}

#[test]
fn the_papers_dimensional_data_are_gravitational_units() {
    // [F (21)] prints kg and N/cm. Only with m in kgf s^2/cm and k in kgf/cm do its own f_n and Delta follow.
    let (m, k, nu, g) = (0.037, 71.4, 0.5, 980.0);
    let omega = f64::sqrt(k / m);
    assert!((omega / (2.0 * PI) - 6.99).abs() < 0.005); // printed 6.98, truncated
    let delta = nu * m * g / k;
    assert!((delta - 0.254).abs() < 0.0005);
    // As printed, 71.4 N/cm = 7140 kg/s^2: 69.9 Hz, ten times the paper's own frequency.
    assert!((f64::sqrt(7140.0 / m) / (2.0 * PI) - 69.9).abs() < 0.05);

    // The motion in cm and s is the same as in T and X.
    let alpha = 1.0;
    let scaled = Set::oscillator(12.0, PI / 10.0, 80);
    let mut dimensional = Set::oscillator(12.0 * delta, PI / 10.0 / omega, 80);
    dimensional.assembly.mass = dmatrix![m];
    dimensional.assembly.stiffness = dmatrix![k];
    let elastic = alpha * delta; // r^E
    let limit = friction_limit(nu, -m * g);
    let (mut a, mut b) = (dimensional.modal(0.0), scaled.modal(0.0));
    let compliance = elastic / limit;
    let control = DisplacementControl { compliance, limit };
    let law = DisplacementControl::step(&[control], &a.flexibilities()[0]);
    let (scaled_law, _) = displacement(&scaled, alpha, 12.0);
    let [mut law, mut scaled_law] = [law, scaled_law].map(RunningLaw::new);
    for _ in 0..80 {
        let (x, y) = (a.step(&mut law), b.step(&mut scaled_law));
        assert!((x.displacement.0[0] / delta - y.displacement.0[0]).abs() < ROUND_OFF);
        assert!((x.velocity.0[0] / (omega * delta) - y.velocity.0[0]).abs() < ROUND_OFF);
        assert!((x.force.0[0] / limit - y.force.0[0]).abs() < ROUND_OFF);
    }
}
