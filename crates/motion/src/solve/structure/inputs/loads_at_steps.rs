//! Loads and limits at the steps of a run.

use super::pressing::Pressing;
use super::sampled_signals::{Samples, Series};
use crate::contact::ContactKind;
use crate::lane::Lane;
use crate::solve::structure::Prepared;
use crate::solve::structure::contacts::laws::varying;
use crate::system::structure::{PressedBy, PressingSpring, Pressure, Signal, Structure};
use std::sync::Arc;

/// A load: a factor at each of its places times a signal.
#[derive(Debug)]
struct LaneLoad<const L: usize> {
    pattern: Vec<(usize, Lane<L>)>,
    signal: Series<L>,
}

/// A friction limit that changes with time, of at least one lane.
#[derive(Debug)]
struct Varying<const L: usize> {
    contact: usize,
    /// Whether the law of the lane is friction.
    slides: [bool; L],
    constant: Lane<L>,
    factor: Lane<L>,
    signal: Option<Series<L>>,
    /// What presses this contact; empty if nothing does in any lane.
    pressed_by: Vec<Option<PressedBy>>,
    /// How the coefficient falls with the normal force; empty if it does not in any lane.
    pressure: Vec<Option<Pressure>>,
}

/// Loads on the nodes and limits of the contacts at the steps.
#[derive(Debug)]
pub(crate) struct Inputs<const L: usize> {
    /// Means of loads over the step that ends at each step.
    means: Vec<Vec<f64>>,
    /// Values of limits at each step.
    values: Vec<Vec<f64>>,
    /// The loads of the equations of sub-steps, and what the loads jump at each of their ends; none for the constant average
    /// acceleration method, of which these are the means.
    weighted: Vec<Vec<f64>>,
    jumps: Vec<Vec<f64>>,
    /// The loads at the end of each step, before they jump there; none where every node has mass.
    ends: Vec<Vec<f64>>,
    loads: Vec<LaneLoad<L>>,
    limits: Vec<Varying<L>>,
}

impl<const L: usize> Inputs<L> {
    /// Inputs of structures with loads on the same nodes.
    pub(crate) fn new(cases: &[&Structure; L], prepared: &Prepared, steps: usize) -> Self {
        Inputs::at(cases, prepared, prepared.dt, steps).0
    }

    /// Adds the loads at the end of a step.
    pub(crate) fn add_ends(&self, step: usize, force: &mut [Lane<L>]) {
        self.add(&self.ends, step, force);
    }

    /// Inputs at the ends of sub-steps of equal length, each with the weights of the loads at its start and end.
    pub(crate) fn of_sub_steps(
        cases: &[&Structure; L],
        prepared: &Prepared,
        steps: usize,
        weights: &[[f64; 2]],
    ) -> Self {
        let parts = weights.len();
        let load_weights = prepared.method.load_weights();
        let (dt, count) = (prepared.dt / parts as f64, steps * parts);
        let (mut inputs, signals) = Inputs::at(cases, prepared, dt, count);
        for signal in signals {
            let [before, after] = signal.step_ends(dt, count);
            let jumps = before
                .iter()
                .zip(&after)
                .map(|(before, after)| after - before);
            inputs.jumps.push(jumps.collect());
            let at_ends = (0..=count).map(|end| {
                let start = end.saturating_sub(1);
                let [w0, w1] = weights[start % parts];
                w0 * after[start] + w1 * before[end]
            });
            let mut weighted: Vec<f64> = at_ends.collect();
            // A load in one step alone has the impulse of its mean over all sub-steps.
            for (step, mean) in signal.exact_means(prepared.dt, steps) {
                let start = (step - 1) * parts;
                let ends = std::iter::once(after[start]).chain(before[start + 1..].iter().copied());
                let of_ends = load_weights.iter().zip(ends);
                let missed = mean - of_ends.map(|(weight, load)| weight * load).sum::<f64>();
                let of_step = &mut weighted[start + 1..=start + parts];
                of_step.iter_mut().for_each(|load| *load += missed);
            }
            inputs.weighted.push(weighted);
        }
        // Most loads never jump.
        if inputs.jumps.iter().flatten().all(|jump| *jump == 0.0) {
            inputs.jumps.clear();
        }
        inputs
    }

    /// Inputs at 0, dt, .. steps dt, and the signals of the loads.
    fn at<'a>(
        cases: &[&'a Structure; L],
        prepared: &Prepared,
        dt: f64,
        steps: usize,
    ) -> (Self, Vec<&'a Arc<Signal>>) {
        let mut means = Samples::new(Signal::step_means, dt, steps);
        let mut values = Samples::new(Signal::at_steps, dt, steps);
        let mut loads = Vec::new();
        for (number, load) in cases[0].loads.iter().enumerate() {
            let mut of = [0; L];
            for (of, case) in of.iter_mut().zip(cases) {
                *of = means.number(&case.loads[number].signal);
            }
            let factors = |(k, (node, _)): (usize, &(usize, f64))| {
                let mut factors = Lane::splat(0.0);
                for (x, case) in factors.0.iter_mut().zip(cases) {
                    *x = case.loads[number].pattern[k].1;
                }
                (prepared.place[*node], factors)
            };
            loads.push(LaneLoad {
                pattern: load.pattern.iter().enumerate().map(factors).collect(),
                signal: Series::new(of),
            });
        }
        let inputs = Inputs {
            limits: limits(cases, prepared, &mut values),
            means: means.series,
            values: values.series,
            weighted: Vec::new(),
            jumps: Vec::new(),
            ends: match prepared.massless.is_empty() {
                true => Vec::new(),
                false => {
                    let ends = |signal: &&Arc<Signal>| {
                        let [before, _] = signal.step_ends(dt, steps);
                        before
                    };
                    means.signals.iter().map(ends).collect()
                }
            },
            loads,
        };
        (inputs, means.signals)
    }

    /// Adds the mean of the loads over the step that ends at `step` to the forces by place.
    #[inline(always)]
    pub(crate) fn add_loads(&self, step: usize, force: &mut [Lane<L>]) {
        self.add(&self.means, step, force);
    }

    /// Adds the loads in the equation of the sub-step that ends at `step`.
    #[inline(always)]
    pub(crate) fn add_weighted(&self, step: usize, force: &mut [Lane<L>]) {
        self.add(&self.weighted, step, force);
    }

    /// Whether any load jumps between two sub-steps.
    pub(crate) fn loads_jump(&self) -> bool {
        !self.jumps.is_empty()
    }

    /// Adds what the loads jump at the end of the sub-step `step`.
    pub(crate) fn add_jumps(&self, step: usize, force: &mut [Lane<L>]) {
        self.add(&self.jumps, step, force);
    }

    #[inline(always)]
    fn add(&self, series: &[Vec<f64>], step: usize, force: &mut [Lane<L>]) {
        for load in &self.loads {
            let value = load.signal.at(series, step);
            for (row, factor) in &load.pattern {
                force[*row] = force[*row] + *factor * value;
            }
        }
    }

    /// Whether any limit changes.
    pub(crate) fn limits_vary(&self) -> bool {
        !self.limits.is_empty()
    }

    /// The contacts whose limits change, and the lanes that have these limits.
    pub(crate) fn varying(&self) -> impl Iterator<Item = (usize, [bool; L])> {
        self.limits
            .iter()
            .map(|limit| (limit.contact, limit.slides))
    }

    /// One of these limits at a step. `force` gives the forces of contacts that press in a lane, `motion` u and u' of nodes.
    #[inline(always)]
    pub(crate) fn limit(
        &self,
        number: usize,
        step: usize,
        force: impl Fn(usize, usize) -> f64,
        motion: impl Fn(usize, usize) -> [f64; 2],
    ) -> Lane<L> {
        let limit = &self.limits[number];
        let mut sum = limit.constant;
        if let Some(signal) = &limit.signal {
            sum = sum + limit.factor * signal.at(&self.values, step);
        }
        for (l, other) in limit.pressed_by.iter().enumerate() {
            if let Some(other) = other {
                let spring =
                    |pressing: &PressingSpring| pressing.spring.compression(|node| motion(node, l));
                sum.0[l] += other.limit(|contact| force(contact, l), spring);
            }
        }
        // As in `Limit::at`: f64::max does not compile to one instruction.
        let mut positive = sum.larger(Lane::splat(0.0));
        for (x, pressure) in positive.0.iter_mut().zip(&limit.pressure) {
            *x = pressure.map_or(*x, |pressure| pressure.limit(*x));
        }
        positive
    }

    /// What the rounds of a step need where other contacts or springs press any contact.
    pub(crate) fn pressing(&self) -> Option<Pressing<L>> {
        let pressed = self.limits.iter().any(|limit| !limit.pressed_by.is_empty());
        pressed.then(|| Pressing::new(self.limits.len()))
    }
}

/// The limits that change with time.
fn limits<'a, const L: usize>(
    cases: &[&'a Structure; L],
    prepared: &Prepared,
    samples: &mut Samples<'a>,
) -> Vec<Varying<L>> {
    let mut limits = Vec::new();
    for contact in 0..prepared.contacts() {
        let of = cases.map(|case| varying(&case.contacts[contact]));
        if of.iter().all(Option::is_none) {
            continue;
        }
        let any = of.iter().flatten().find_map(|limit| limit.varying.as_ref());
        let mut limit = Varying {
            contact,
            slides: cases.map(|case| case.contacts[contact].law.kind() == ContactKind::Friction),
            constant: Lane::splat(0.0),
            factor: Lane::splat(0.0),
            signal: None,
            pressed_by: Vec::new(),
            pressure: Vec::new(),
        };
        let pressed_by = |case: &&Structure| case.contacts[contact].law.limit()?.pressed_by.clone();
        let pressed = cases.iter().map(pressed_by);
        if pressed.clone().any(|other| other.is_some()) {
            limit.pressed_by = pressed.collect();
        }
        let pressure = |case: &&Structure| case.contacts[contact].law.limit()?.pressure;
        let pressures = cases.iter().map(pressure);
        if pressures.clone().any(|pressure| pressure.is_some()) {
            limit.pressure = pressures.collect();
        }
        let mut signals = [0; L];
        for (l, case) in cases.iter().enumerate() {
            let given = case.contacts[contact].law.limit();
            let (constant, varying) = given.map_or((0.0, None), |given| {
                (given.constant, given.varying.as_ref())
            });
            limit.constant.0[l] = constant;
            if let Some((factor, signal)) = varying {
                limit.factor.0[l] = *factor;
                signals[l] = samples.number(signal);
            } else if let Some((_, signal)) = any {
                signals[l] = samples.number(signal);
            }
        }
        limit.signal = any.map(|_| Series::new(signals));
        limits.push(limit);
    }
    limits
}
