//! One case through the stepper, with the energy and the mass centres on the way.

use super::scaled::Scaled;
use crate::history::History;
use crate::lane::Lane;
use crate::law::ImpactSpring;
use crate::stepper::{Start, Stepper};

/// What a run leaves behind.
#[derive(Debug)]
pub struct Run {
    /// t/T_I, r/(c T_I/2), rdot/c, F/F0.
    pub history: History,
    /// Energy at each step, with the spring, in the frame of the common mass centre.
    pub energy: Vec<f64>,
    /// Relative velocity of the mass centres at the end over c.
    pub restitution: f64,
}

/// The modes of both bars and the spring between them, at t = 0.
pub fn start(scaled: &Scaled, dt: f64) -> (Stepper<1>, ImpactSpring<1>) {
    let mut modes = Vec::new();
    for bar in scaled.each() {
        for (j, mode) in bar.modes().enumerate() {
            let velocity = if j == 0 { scaled.approach() } else { 0.0 };
            modes.push(Start {
                mode: [mode],
                displacement: Lane([0.0]),
                velocity: Lane([velocity]),
            });
        }
    }
    let law = ImpactSpring {
        compliance: Lane([1.0 / scaled.spring]),
    };
    let gap = Lane([scaled.bars.gap]);
    (
        // Ends that touch at t = 0 do not press yet: r = 0, F = 0.
        Stepper::new(Lane([dt]), &modes, gap, Lane([0.0])),
        law,
    )
}

/// Runs `last` steps.
pub fn run(scaled: &Scaled, dt: f64, last: u64) -> Run {
    let (mut stepper, mut law) = start(scaled, dt);
    let mut history = History::with_capacity(last as usize + 1);
    let mut energy = Vec::with_capacity(last as usize + 1);
    let mut contact = stepper.contact();
    let books = Books::new(scaled);
    for i in 0..=last {
        if i > 0 {
            contact = stepper.step(&mut law);
        }
        let [Lane([r]), Lane([rdot]), Lane([s])] =
            [contact.displacement, contact.velocity, contact.force];
        // dr/dt in c T_I/2 over T_I is 2 rdot/c; S resists, so the force that pushes is -S.
        history.push(i as f64 * dt, r, 0.5 * rdot, 0.0 - s);
        energy.push(books.energy(&stepper) + 0.5 * scaled.spring * r.min(0.0) * r.min(0.0));
    }
    let centres: f64 = books.rigid(&stepper).iter().sum();
    Run {
        history,
        energy,
        restitution: 0.5 * centres,
    }
}

/// What turns modes into energies.
struct Books {
    /// omega^2 and phi^2 of each mode.
    modes: Vec<(f64, f64)>,
    /// Where each bar's rigid-body mode stands, and its mass.
    rigid: Vec<(usize, f64)>,
}

impl Books {
    fn new(scaled: &Scaled) -> Books {
        let (mut modes, mut rigid) = (Vec::new(), Vec::new());
        for bar in scaled.each() {
            rigid.push((modes.len(), bar.mass));
            modes.extend(bar.modes().map(|mode| (mode.omega2, mode.phi2)));
        }
        Books { modes, rigid }
    }

    /// Velocities of the mass centres, each counted as it opens the gap.
    fn rigid(&self, stepper: &Stepper<1>) -> Vec<f64> {
        let mut rates = vec![0.0; self.rigid.len()];
        for (i, (_, velocity)) in stepper.modes().enumerate() {
            if let Some(bar) = self.rigid.iter().position(|&(at, _)| at == i) {
                rates[bar] = velocity.0[0];
            }
        }
        rates
    }

    fn energy(&self, stepper: &Stepper<1>) -> f64 {
        let mut vibration = 0.0;
        let mut rates = [0.0; 2];
        let mut bar = 0;
        for (i, ((x, v), (omega2, phi2))) in stepper.modes().zip(&self.modes).enumerate() {
            let ([x], [v]) = (x.0, v.0);
            if bar < self.rigid.len() && self.rigid[bar].0 == i {
                rates[bar] = v;
                bar += 1;
            } else {
                vibration += (v * v + omega2 * x * x) / phi2;
            }
        }
        // In the frame of the common mass centre two bodies have the energy of their relative motion; a wall is one
        // of infinite mass.
        let reduced = match self.rigid[..] {
            [(_, m)] => m,
            [(_, m1), (_, m2)] => m1 * m2 / (m1 + m2),
            _ => 0.0,
        };
        let relative = rates[0] + rates[1];
        0.5 * (vibration + reduced * relative * relative)
    }
}
