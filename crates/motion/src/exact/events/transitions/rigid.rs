//! Constraints of rigid contacts that stick or are shut, and impulses.
//!
//! Impulses minimise 1/2 J^T A J - J^T d, J <= 0, A = B^T M^-1 B, with d = (1 + e) rdot of contacts that close. A finite friction
//! limit has no impulse.

use crate::contact::ClippedLine;
use crate::exact::events::coordinates::model::Model;
use crate::exact::events::numerics::cholesky::Cholesky;
use crate::exact::events::numerics::least::{Singular, least};
use crate::exact::events::phases::contact_phase::Phase;
use crate::exact::events::phases::contact_state::ContactState;
use crate::exact::events::pieces::book::Book;
use crate::exact::events::pieces::scales::Scales;
use crate::exact::events::pieces::series::Series;

/// Impacts with a smaller |rdot|, over the largest velocity, accumulate: the contact shuts.
const SHUT: f64 = 1e-9;

/// The contacts with constraints, and the factor of their A.
#[derive(Debug, Clone, Default)]
pub struct Constraints {
    contacts: Vec<usize>,
    factor: Cholesky,
}

impl Constraints {
    /// The constraints of these phases.
    pub fn new(model: &Model, states: &[ContactState]) -> Result<Constraints, Singular> {
        let contacts = model.contacts.iter().zip(states).enumerate();
        let closed = contacts
            .filter(|(_, (contact, state))| contact.law.is_rigid() && state.phase == Phase::Closed);
        let contacts: Vec<usize> = closed.map(|(i, _)| i).collect();
        let factor =
            Cholesky::of_any(model.flexibility(&contacts), contacts.len()).ok_or(Singular)?;
        Ok(Constraints { contacts, factor })
    }

    /// The contacts and the factor.
    pub fn parts(&self) -> (&[usize], &Cholesky) {
        (&self.contacts, &self.factor)
    }
}

/// The rate of each contact that had an impact.
pub type Impacts = Vec<(usize, f64)>;

/// Changes the velocities by the impulses of rigid stops that close. `series` has begun.
pub fn impacts(
    model: &Model,
    series: &Series,
    scales: &Scales,
    book: &mut Book,
    v: &mut [f64],
) -> Result<Impacts, Singular> {
    let gap_rate = |i: usize| series.gaps.at(i, 0.0).map_or(0.0, |[_, rate]| rate);
    let mut touching = Vec::new();
    let (mut d, mut before) = (Vec::new(), Vec::new());
    for (i, contact) in model.contacts.iter().enumerate() {
        let Some(ClippedLine::Stop { restitution }) = contact.law.line() else {
            continue;
        };
        if series.contacts[i].r[0] <= scales.r(model, i, series.length) {
            let rate = model.relative(i, v) + gap_rate(i);
            let e = if rate < -SHUT * scales.velocity {
                restitution
            } else {
                0.0
            };
            touching.push(i);
            before.push(rate);
            d.push(rate + e * rate.min(0.0));
        }
    }
    let tolerance = scales.rate(series.length);
    if before.iter().all(|rate| *rate >= -tolerance) {
        return Ok(Vec::new());
    }
    let m = touching.len();
    let size: Vec<f64> = before.iter().map(|rate| rate.abs() + tolerance).collect();
    let mut impulses = vec![0.0; m];
    let bounds = [vec![f64::NEG_INFINITY; m], vec![0.0; m]];
    least(
        model.flexibility(&touching),
        &d,
        &bounds,
        &size,
        &mut impulses,
    )?;
    for (i, impulse) in touching.iter().zip(&impulses) {
        model.subtract_force(*i, *impulse, v);
    }
    for ((i, impulse), before) in touching.iter().zip(&impulses).zip(&before) {
        let moved = gap_rate(*i);
        book.dissipate(0.5 * impulse * (before + (model.relative(*i, v) + moved)));
        book.add_work(impulse * moved);
    }
    let closing = touching.into_iter().zip(before);
    Ok(closing.filter(|(_, rate)| *rate < -tolerance).collect())
}
