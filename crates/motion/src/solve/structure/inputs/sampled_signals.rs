//! Signals at the steps of a run.

use crate::lane::Lane;
use crate::system::structure::Signal;
use std::sync::Arc;

/// Numbers of signals for the steps 0..=N, each signal sampled once.
#[derive(Debug)]
pub(crate) struct Samples<'a> {
    of: fn(&Signal, f64, usize) -> Vec<f64>,
    pub(crate) signals: Vec<&'a Arc<Signal>>,
    pub(crate) series: Vec<Vec<f64>>,
    dt: f64,
    steps: usize,
}

impl<'a> Samples<'a> {
    pub(crate) fn new(of: fn(&Signal, f64, usize) -> Vec<f64>, dt: f64, steps: usize) -> Self {
        Samples {
            of,
            signals: Vec::new(),
            series: Vec::new(),
            dt,
            steps,
        }
    }

    /// Number of the series of a signal.
    pub(crate) fn number(&mut self, signal: &'a Arc<Signal>) -> usize {
        let known = self.signals.iter().position(|s| Arc::ptr_eq(s, signal));
        known.unwrap_or_else(|| {
            self.signals.push(signal);
            self.series.push((self.of)(signal, self.dt, self.steps));
            self.signals.len() - 1
        })
    }
}

/// One signal for each lane, often the same one.
#[derive(Debug)]
pub(crate) struct Series<const L: usize> {
    of: [usize; L],
    shared: bool,
}

impl<const L: usize> Series<L> {
    pub(crate) fn new(of: [usize; L]) -> Self {
        Series {
            of,
            shared: of.iter().all(|number| *number == of[0]),
        }
    }

    #[inline(always)]
    pub(crate) fn at(&self, series: &[Vec<f64>], step: usize) -> Lane<L> {
        let mut lane = Lane::splat(series[self.of[0]][step]);
        if !self.shared {
            for (x, number) in lane.0.iter_mut().zip(self.of) {
                *x = series[number][step];
            }
        }
        lane
    }
}
