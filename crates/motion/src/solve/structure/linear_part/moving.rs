//! Supports that move: where they are at the ends of steps, and what that does to gaps and nodes.

use crate::lane::Lane;
use crate::methods::Method;
use crate::system::structure::{Motion, Structure};
use std::sync::Arc;

/// The supports of L structures.
#[derive(Debug)]
pub(crate) struct Moving<const L: usize> {
    /// Length of the steps, or sub-steps, that [`Moving::advance`] counts.
    dt: f64,
    /// The end that was reached last.
    reached: Option<usize>,
    /// [`Method::load_weights`].
    weights: Vec<f64>,
    supports: Vec<Support<L>>,
    /// The supports that move the gap of each contact, with r for a unit of u_s.
    factors: Vec<Vec<(usize, Lane<L>)>>,
    /// The change of the gap of each contact since rest, and its rate: at the start and at the end of the last step.
    pub(crate) start: Vec<[Lane<L>; 2]>,
    pub(crate) end: Vec<[Lane<L>; 2]>,
}

#[derive(Debug)]
struct Support<const L: usize> {
    motions: [Arc<Motion>; L],
    /// Where the motions were found last.
    found: [usize; L],
    /// u, v and a.
    now: [Lane<L>; 3],
    /// What v at the ends of sub-steps misses of the mean velocity of an imposed displacement over the step.
    missed: Lane<L>,
    /// Its column of R, by nodes as in the structure.
    carried: Vec<Lane<L>>,
}

impl<const L: usize> Moving<L> {
    /// The supports at t = 0; `None` without any.
    pub(crate) fn new(cases: &[&Structure; L], dt: f64, method: &Method) -> Option<Moving<L>> {
        let count = cases[0].supports.len();
        if count == 0 {
            return None;
        }
        let (nodes, contacts) = (cases[0].len(), cases[0].contacts.len());
        let lanes = |of: &dyn Fn(&Structure) -> f64| {
            let mut lane = Lane::splat(0.0);
            for (x, case) in lane.0.iter_mut().zip(cases) {
                *x = of(case);
            }
            lane
        };
        let supports = (0..count).map(|s| Support {
            motions: cases.map(|case| case.supports[s].motion.clone()),
            found: [0; L],
            now: [Lane::splat(0.0); 3],
            missed: Lane::splat(0.0),
            carried: (0..nodes)
                .map(|node| lanes(&|case| case.supports[s].carried[node]))
                .collect(),
        });
        let factors = |contact: usize| -> Vec<(usize, Lane<L>)> {
            let factors = (0..count).map(|s| (s, lanes(&|case| case.supports[s].gaps[contact])));
            factors.filter(|(_, factor)| factor.0 != [0.0; L]).collect()
        };
        let zero = [Lane::splat(0.0); 2];
        let mut moving = Moving {
            dt: dt / method.count_of_sub_steps() as f64,
            weights: method.load_weights(),
            reached: None,
            supports: supports.collect(),
            factors: (0..contacts).map(factors).collect(),
            start: vec![zero; contacts],
            end: vec![zero; contacts],
        };
        moving.advance(0);
        Some(moving)
    }

    /// Moves the supports to the end of step `end`, once.
    pub(crate) fn advance(&mut self, end: usize) {
        if self.reached == Some(end) {
            return;
        }
        self.reached = Some(end);
        let t = end as f64 * self.dt;
        for support in &mut self.supports {
            for (l, motion) in support.motions.iter().enumerate() {
                let values = motion.at_later(t, &mut support.found[l]);
                for (now, value) in support.now.iter_mut().zip(values) {
                    now.0[l] = value;
                }
                if motion.is_by_displacement() {
                    support.now[2].0[l] = motion.shown_acceleration_at(t);
                    support.missed.0[l] = missed(motion, end, self.dt, &self.weights);
                }
            }
        }
        std::mem::swap(&mut self.start, &mut self.end);
        for (gap, factors) in self.end.iter_mut().zip(&self.factors) {
            *gap = [Lane::splat(0.0); 2];
            for (support, factor) in factors {
                let Support { now, missed, .. } = &self.supports[*support];
                let [u, v, _] = *now;
                *gap = [gap[0] + u * *factor, gap[1] + (v + *missed) * *factor];
            }
        }
    }

    /// Whether the gap of a contact moves in a lane.
    pub(crate) fn moves(&self, contact: usize, lane: usize) -> bool {
        let mut factors = self.factors[contact].iter();
        factors.any(|(_, factor)| factor.0[lane] != 0.0)
    }

    /// u (`which` = 0) or v (1) of a node with this rest w, or of a support, whose numbers follow those of the nodes.
    pub(crate) fn total(
        &self,
        node: usize,
        which: usize,
        rest: impl Fn(usize) -> Lane<L>,
    ) -> Lane<L> {
        let nodes = self.supports[0].carried.len();
        if let Some(support) = node.checked_sub(nodes) {
            return self.supports[support].now[which];
        }
        let terms = self.supports.iter();
        terms.fold(rest(node), |sum, support| {
            sum + support.now[which] * support.carried[node]
        })
    }

    /// a of a support.
    pub(crate) fn acceleration(&self, support: usize) -> Lane<L> {
        self.supports[support].now[2]
    }

    /// What a step of constant average acceleration moves the gap of a contact: beyond dt times its rate at the start for laws of r,
    /// and dt/2 times the change of its rate for laws of rdot.
    pub(crate) fn excess(&self, contact: usize) -> [Lane<L>; 2] {
        let ([g0, v0], [g1, v1]) = (self.start[contact], self.end[contact]);
        [(g1 - g0) - v0 * self.dt, (v1 - v0) * (0.5 * self.dt)]
    }
}

/// What v at the ends of sub-steps of `dt` misses of the mean velocity over the step with the sub-step that ends at `end`.
#[cold]
fn missed(motion: &Motion, end: usize, dt: f64, weights: &[f64]) -> f64 {
    let parts = weights.len() - 1;
    let Some(before) = end.checked_sub(1) else {
        return 0.0;
    };
    let start = before / parts * parts;
    let at = |number: usize| motion.at(number as f64 * dt);
    let mean = (at(start + parts)[0] - at(start)[0]) / (parts as f64 * dt);
    let ends = weights.iter().zip(start..);
    mean - ends
        .map(|(weight, number)| weight * at(number)[1])
        .sum::<f64>()
}
