//! The energy book: E(t) - E(0) = work of the loads - dissipated energy, E kinetic, of K and of the springs of the contacts.

use super::series::Series;
use crate::contact::ClippedLine;
use crate::exact::events::coordinates::model::Model;
use crate::exact::events::numerics::bernstein::{slope, value};
use crate::exact::events::numerics::row::dot;
use crate::exact::events::phases::contact_state::{ContactState, Force};
use crate::exact::events::phases::lines::{self, Line};

/// Points and weights of Gauss's rule with ten points on -1..=1, for the positive points.
const TEN: &[[f64; 2]] = &[
    [0.148_874_338_981_631_2, 0.295_524_224_714_752_9],
    [0.433_395_394_129_247_2, 0.269_266_719_309_996_3],
    [0.679_409_568_299_024_4, 0.219_086_362_515_982],
    [0.865_063_366_688_984_5, 0.149_451_349_150_580_6],
    [0.973_906_528_517_171_7, 0.066_671_344_308_688_1],
];

/// The same with five points; the middle one in two halves.
const FIVE: &[[f64; 2]] = &[
    [0.0, 0.284_444_444_444_444_4],
    [0.538_469_310_105_683_1, 0.478_628_670_499_366_5],
    [0.906_179_845_938_664, 0.236_926_885_056_189_1],
];

/// Largest phase of a piece for five points: their error is 4e-13 times the tenth power of twice the phase.
const SHORT: f64 = 0.25;

/// Energies from t = 0 on.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Book {
    /// Energy at t = 0.
    pub start: f64,
    /// Work of the loads.
    pub work: f64,
    /// Energy that dampers, friction and impacts dissipated.
    pub dissipated: f64,
    /// The largest energy.
    pub largest: f64,
    /// The largest |E(t) - E(0) - work + dissipated|.
    pub residual: f64,
}

impl Book {
    /// Adds dissipated energy.
    pub fn dissipate(&mut self, energy: f64) {
        self.dissipated += energy;
    }

    /// Adds work of the supports.
    pub fn add_work(&mut self, work: f64) {
        self.work += work;
    }

    /// Adds the work on 0..=s of a piece.
    pub fn add_piece(&mut self, model: &Model, series: &Series, states: &[ContactState], s: f64) {
        let rule = if series.phase > SHORT { TEN } else { FIVE };
        let points: Vec<[f64; 2]> = (rule.iter())
            .flat_map(|[x, w]| {
                [
                    [0.5 * s * (1.0 - x), 0.5 * s * w],
                    [0.5 * s * (1.0 + x), 0.5 * s * w],
                ]
            })
            .collect();
        for (pattern, signal) in model.patterns.iter().zip(&series.loads) {
            let path = series.combine(pattern);
            let terms = points
                .iter()
                .map(|[s, w]| w * value(signal, *s) * slope(&path, *s));
            self.work += terms.sum::<f64>();
        }
        if !model.damping.is_zero() {
            let [mut u, mut v] = [(); 2].map(|()| vec![0.0; model.len()]);
            for [s, w] in &points {
                series.motion_at(*s, &mut u, &mut v);
                self.dissipated += w * series.length * model.damping.form(&v);
            }
        }
        self.work += series.flexible_work(model, &points);
        for (i, state) in states.iter().enumerate() {
            self.dissipated += contact_work(model, series, i, state, &points);
            if let Some(gap) = series.gaps.polynomial(i) {
                let force = &series.contacts[i].force;
                let terms = points
                    .iter()
                    .map(|[s, w]| w * value(force, *s) * slope(&gap, *s));
                self.work += terms.sum::<f64>();
            }
        }
    }

    /// Closes the book at a time with this state.
    pub fn close(&mut self, energy: f64) {
        self.largest = self.largest.max(energy);
        let residual = energy - self.start - self.work + self.dissipated;
        self.residual = self.residual.max(residual.abs());
    }
}

/// The energy that a contact dissipates on a piece: the integral of S times the rate of the slip.
fn contact_work(
    model: &Model,
    series: &Series,
    i: usize,
    state: &ContactState,
    points: &[[f64; 2]],
) -> f64 {
    let law = &model.contacts[i].law;
    if let Some(line) = &state.line {
        return line_work(series, i, line, points);
    }
    let elastic = match (state.law(law), law.line()) {
        (Force::Limit(_), Some(ClippedLine::Elastic { stiffness })) => 1.0 / stiffness,
        (Force::Limit(_) | Force::Dashpot { .. }, _) => 0.0,
        _ => return 0.0,
    };
    let (rate, force) = (series.rate(i), &series.contacts[i].force);
    let terms = points.iter().map(|[s, w]| {
        let slip = series.length * value(&rate, *s) - elastic * slope(force, *s);
        w * value(force, *s) * slip
    });
    terms.sum()
}

/// The same on a line: what dr dissipates is linear in S.
fn line_work(series: &Series, i: usize, line: &Line, points: &[[f64; 2]]) -> f64 {
    let [constant, factor] = line.loss;
    if line.loss == [0.0; 2] {
        return 0.0;
    }
    let (rate, force) = (series.rate(i), &series.contacts[i].force);
    let terms = points.iter().map(|[s, w]| {
        let loss = constant + factor * value(force, *s);
        w * loss * series.length * value(&rate, *s)
    });
    terms.sum()
}

/// Kinetic energy, energy of K, and of the springs of the contacts.
pub fn energy(model: &Model, states: &[ContactState], u: &[f64], v: &[f64]) -> f64 {
    let kinetic = match &model.modes {
        None => v
            .iter()
            .zip(&model.inverse_masses)
            .map(|(v, w)| v * v / w)
            .sum(),
        Some(_) => dot(v, v),
    };
    let contacts = model.contacts.iter().zip(states);
    let of_lines = contacts.clone().filter_map(|(contact, state)| {
        let line = state.line.as_ref()?;
        Some(lines::of(&contact.law)?.stored(line, state.r))
    });
    let lines: f64 = of_lines.sum();
    let stored = contacts.map(|(contact, state)| {
        let spring = contact.law.spring();
        spring.map_or(0.0, |k| state.force * state.force / k)
    });
    let flexible = model
        .flexible
        .as_ref()
        .map_or(0.0, |flexible| 0.5 * flexible.stored(states));
    flexible + 0.5 * (kinetic + model.stiffness.form(u) + stored.sum::<f64>()) + lines
}
