//! One independent start of a search: CMA-ES until its population is near a minimum, then the minimum itself.

use super::cma_es::CmaEs;
use super::counted::{Asking, squared};
use super::local::{Local, Threshold};

/// Standard deviation at first.
const SIGMA: f64 = 0.25;

/// A population whose better half is within this part above its best is near a minimum.
const SPREAD: f64 = 0.05;

/// So is one with these standard deviations.
const EXTENT: f64 = 3e-3;

/// So is a misfit below this part of a usual one.
const SMALL: f64 = 1e-3;

/// Generations without a better point after which a start ends.
const STALLED: usize = 40;

/// The rise of the squared misfit over the points of a local search: 10 % of the misfit.
pub const TENTH: f64 = 0.21;

/// The smallest rise, relative to a usual squared misfit.
pub const LEAST: f64 = 1e-10;

/// A start with its phases.
#[derive(Debug)]
pub struct Start {
    phase: Phase,
    /// The usual misfit.
    usual: f64,
    /// The best point and its misfit.
    pub best: (Vec<f64>, f64),
    stalled: usize,
}

#[derive(Debug)]
enum Phase {
    Wide(Box<CmaEs>),
    Near(Box<Local>),
    Ended,
}

impl Start {
    /// From the best of its first points; `usual` is the misfit of many of them.
    pub fn new(
        best: (Vec<f64>, f64),
        usual: f64,
        population: usize,
        random: rand_chacha::ChaCha8Rng,
    ) -> Start {
        let phase = match best.1.is_finite() {
            true => Phase::Wide(Box::new(CmaEs::new(
                best.0.clone(),
                SIGMA,
                population,
                random,
            ))),
            false => Phase::Ended,
        };
        Start {
            phase,
            usual,
            best,
            stalled: 0,
        }
    }

    /// Whether it ended at a point with a solution.
    pub fn has_ended(&self) -> bool {
        match &self.phase {
            Phase::Near(local) => local.has_ended() && self.best.1.is_finite(),
            Phase::Wide(_) | Phase::Ended => false,
        }
    }

    /// What the last fit of the squared misfit left: the size of its jumps.
    pub fn residual(&self) -> f64 {
        match &self.phase {
            Phase::Near(local) => local
                .model
                .as_ref()
                .map_or(0.0, |(model, _)| model.residual),
            Phase::Wide(_) | Phase::Ended => 0.0,
        }
    }

    fn is_near(&self, misfits: &[f64], cma: &CmaEs) -> bool {
        let mut sorted = misfits.to_vec();
        sorted.sort_by(f64::total_cmp);
        let [first, middle] = [sorted[0], sorted[sorted.len() / 2]];
        middle - first <= SPREAD * first.abs()
            || cma.axes().values.iter().all(|x| *x < EXTENT)
            || first.abs() < SMALL * self.usual
            || self.stalled >= STALLED
    }
}

impl Asking for Start {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        match &mut self.phase {
            Phase::Wide(cma) => cma.ask(),
            Phase::Near(local) => local.ask(),
            Phase::Ended => Vec::new(),
        }
    }

    fn tell(&mut self, misfits: &[f64]) {
        match &mut self.phase {
            Phase::Wide(cma) => {
                let best = (0..misfits.len()).min_by(|a, b| misfits[*a].total_cmp(&misfits[*b]));
                self.stalled += 1;
                if let Some(i) = best.filter(|i| misfits[*i] < self.best.1) {
                    self.best = (cma.point(i).to_vec(), misfits[i]);
                    self.stalled = 0;
                }
                cma.tell(misfits);
                // Checked with the phase taken out, since it needs both.
                let Phase::Wide(cma) = std::mem::replace(&mut self.phase, Phase::Ended) else {
                    return;
                };
                self.phase = match self.is_near(misfits, &cma) {
                    true => Phase::Near(Box::new(self.local(&cma))),
                    false => Phase::Wide(cma),
                };
            }
            Phase::Near(local) => {
                local.tell(misfits);
                self.best = local.best.clone();
            }
            Phase::Ended => {}
        }
    }
}

impl Start {
    fn local(&self, cma: &CmaEs) -> Local {
        let threshold = Threshold {
            relative: TENTH,
            ground: 0.0,
            least: (LEAST * squared(self.usual)).max(f64::MIN_POSITIVE),
        };
        let free = (0..self.best.0.len()).collect();
        Local::new(self.best.0.clone(), free, cma.axes(), threshold)
    }
}
