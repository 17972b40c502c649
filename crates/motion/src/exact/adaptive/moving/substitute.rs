//! Substitution of the forces that begin to slide.

use super::structure::Moving;
use crate::contact::plane::{Pair, length};
use crate::exact::adaptive::Flow;
use crate::exact::adaptive::plane::Imposed;
use crate::exact::adaptive::radau::POINTS;

impl Moving<'_> {
    /// States from the rates with the forces.
    pub(crate) fn substitute(
        &mut self,
        times: [f64; POINTS],
        h: f64,
        y: &[f64],
        firsts: &[usize],
        weights: &[[f64; POINTS]; POINTS],
        points: &mut Points,
    ) {
        let mut rates = vec![vec![0.0; y.len()]; POINTS];
        for (i, rates) in rates.iter_mut().enumerate() {
            self.impose(firsts, |c| Some(Imposed::Force(points.forces[i][c])));
            self.rates(times[i], &points.states[i], rates);
        }
        combine(&mut points.states, y, h, weights, &rates);
    }

    /// How much the forces of these contacts take from their accelerations, by rows, while others stick.
    pub(crate) fn influence(&mut self, t: f64, points: &Points, firsts: &[usize]) -> Vec<f64> {
        let [state, forces] = [&points.states[POINTS - 1], &points.states[0]].map(Vec::clone);
        let n = self.model.len();
        let p = firsts.len();
        let base = &points.forces[POINTS - 1];
        let mut rates = vec![0.0; forces.len()];
        let mut accelerations = |moving: &mut Self, column: Option<usize>| -> Vec<f64> {
            moving.impose(firsts, |c| {
                let mut force = base[c];
                if let Some(column) = column.filter(|column| column / 2 == c) {
                    force[column % 2] += length(base[c]);
                }
                Some(Imposed::Force(force))
            });
            moving.rates(t, &state, &mut rates);
            let rows = firsts.iter().flat_map(|first| [*first, *first + 1]);
            rows.map(|row| moving.model.columns[row].dot(&rates[n..2 * n]))
                .collect()
        };
        let without = accelerations(self, None);
        let mut influence = vec![0.0; 4 * p * p];
        for column in 0..2 * p {
            let with = accelerations(self, Some(column));
            for row in 0..2 * p {
                let change = without[row] - with[row];
                influence[row * 2 * p + column] = change / length(base[column / 2]);
            }
        }
        influence
    }
}

/// The points of a step.
pub(crate) struct Points {
    /// States.
    pub(crate) states: Vec<Vec<f64>>,
    /// Forces of the contacts that begin.
    pub(crate) forces: Vec<Vec<Pair>>,
}

/// y + h times the weighted sums of rates.
pub(crate) fn combine(
    to: &mut [Vec<f64>],
    y: &[f64],
    h: f64,
    weights: &[[f64; POINTS]; POINTS],
    rates: &[Vec<f64>],
) {
    for (to, weights) in to.iter_mut().zip(weights) {
        for (k, to) in to.iter_mut().enumerate() {
            let terms = weights.iter().zip(rates);
            *to = y[k] + h * terms.map(|(w, rates)| w * rates[k]).sum::<f64>();
        }
    }
}
