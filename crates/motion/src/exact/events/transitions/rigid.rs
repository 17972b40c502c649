//! Constraints of rigid contacts that stick or are shut, and impulses.
//!
//! Impulses minimise 1/2 J^T A J - J^T d, J <= 0, A = B^T M^-1 B, with d = (1 + e) rdot of contacts that close. A finite friction
//! limit has no impulse, but that of friction which the stop presses has one: nu times its impulse.

use crate::contact::ClippedLine;
use crate::exact::events::coordinates::model::Model;
use crate::exact::events::coordinates::pressed::Pressed;
use crate::exact::events::numerics::cholesky::Cholesky;
use crate::exact::events::numerics::factor::Factor;
use crate::exact::events::numerics::least::{Singular, least};
use crate::exact::events::phases::contact_phase::Phase;
use crate::exact::events::phases::contact_state::{ContactState, Force};
use crate::exact::events::pieces::book::Book;
use crate::exact::events::pieces::scales::Scales;
use crate::exact::events::pieces::series::Series;
use nalgebra::DMatrix;

/// Impacts with a smaller |rdot|, over the largest velocity, accumulate: the contact shuts.
const SHUT: f64 = 1e-9;

/// Change of a limit, as a part of it, that is round-off of the forces that press.
pub const SAME: f64 = 1e-14;

/// Most rounds with changed limits.
const MOST_ROUNDS: usize = 200;

/// The contacts with constraints, and the factor of their A.
#[derive(Debug, Clone, Default)]
pub struct Constraints {
    contacts: Vec<usize>,
    factor: Factor,
}

impl Constraints {
    /// The constraints of these phases.
    pub fn new(model: &Model, states: &[ContactState]) -> Result<Constraints, Singular> {
        let contacts = model.contacts.iter().zip(states).enumerate();
        let closed = contacts
            .filter(|(_, (contact, state))| contact.law.is_rigid() && state.phase == Phase::Closed);
        let contacts: Vec<usize> = closed.map(|(i, _)| i).collect();
        let matrix = model.flexibility(&contacts);
        let factor = match pressed_matrix(model, states, &contacts) {
            Some(pressed) => {
                let factor = pressed.lu();
                match factor.is_invertible() {
                    true => Factor::Pressed(factor),
                    false => return Err(Singular),
                }
            }
            None => Factor::Symmetric(Cholesky::of_any(matrix, contacts.len()).ok_or(Singular)?),
        };
        Ok(Constraints { contacts, factor })
    }

    /// The contacts and the factor.
    pub fn parts(&self) -> (&[usize], &Factor) {
        (&self.contacts, &self.factor)
    }
}

/// The matrix of constraints with the friction that they press and that slides; `None` if it is not coupled with them.
fn pressed_matrix(
    model: &Model,
    states: &[ContactState],
    contacts: &[usize],
) -> Option<DMatrix<f64>> {
    let m = contacts.len();
    let mut matrix: Option<DMatrix<f64>> = None;
    for pressed in &model.pressed {
        let friction = pressed.contact;
        let Force::Limit(direction) = states[friction].law(&model.contacts[friction].law) else {
            continue;
        };
        let presses = |column: &usize| pressed.contacts.contains(&contacts[*column]);
        for column in (0..m).filter(presses) {
            for (row, contact) in contacts.iter().enumerate() {
                let coupling = model.flexibility(&[*contact, friction])[1];
                if coupling != 0.0 {
                    let matrix = matrix.get_or_insert_with(|| {
                        DMatrix::from_row_slice(m, m, &model.flexibility(contacts))
                    });
                    matrix[(row, column)] -= direction * pressed.nu * coupling;
                }
            }
        }
    }
    matrix
}

/// The rate of each contact that had an impact.
pub type Impacts = Vec<(usize, f64)>;

/// Repeats a solution until nothing changes. Where normal forces depend on the friction that they cause, each round is nearer by the
/// part of one by the other; it must be below 1.
pub fn rounds(mut solve: impl FnMut() -> Result<bool, Singular>) -> Result<(), Singular> {
    for _ in 0..MOST_ROUNDS {
        if !solve()? {
            return Ok(());
        }
    }
    Err(Singular)
}

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
    let stops = touching.len();
    let is_struck = |pressed: &&Pressed| {
        let rigid = model.contacts[pressed.contact].law.is_rigid();
        rigid && pressed.contacts.iter().any(|i| touching.contains(i))
    };
    let pressed: Vec<&Pressed> = model.pressed.iter().filter(is_struck).collect();
    let mut struck = touching.clone();
    for friction in &pressed {
        let rate = model.relative(friction.contact, v) + gap_rate(friction.contact);
        struck.push(friction.contact);
        before.push(rate);
        d.push(rate);
    }
    let size: Vec<f64> = before.iter().map(|rate| rate.abs() + tolerance).collect();
    let flexibility = model.flexibility(&struck);
    let mut impulses = vec![0.0; struck.len()];
    let mut bounds = [vec![0.0; struck.len()], vec![0.0; struck.len()]];
    bounds[0][..stops].fill(f64::NEG_INFINITY);
    // Friction that rests holds up to its static limit; where it breaks loose, it has the one of sliding.
    let rests = |i: usize| before[i].abs() <= tolerance;
    let ratio = |i: usize| match rests(i) {
        true => model.contacts[struck[i]].law.static_ratio(),
        false => 1.0,
    };
    let mut ratios: Vec<f64> = (0..struck.len()).map(ratio).collect();
    rounds(|| {
        least(flexibility.clone(), &d, &bounds, &size, &mut impulses)?;
        let mut changes = false;
        for (f, friction) in pressed.iter().enumerate() {
            let i = stops + f;
            let of_stop = |contact| Some(impulses[touching.iter().position(|i| *i == contact)?]);
            let limit = friction.limit_by(of_stop);
            let static_limit = ratios[i] * limit;
            changes |= (static_limit - bounds[1][i]).abs() > SAME * limit;
            if !changes && ratios[i] > 1.0 && impulses[i].abs() >= (1.0 - SAME) * static_limit {
                (ratios[i], changes) = (1.0, true);
            }
            let bound = ratios[i] * limit;
            (bounds[0][i], bounds[1][i]) = (-bound, bound);
        }
        Ok(changes)
    })?;
    for (i, impulse) in struck.iter().zip(&impulses) {
        model.subtract_force(*i, *impulse, v);
    }
    for ((i, impulse), before) in struck.iter().zip(&impulses).zip(&before) {
        let moved = gap_rate(*i);
        book.dissipate(0.5 * impulse * (before + (model.relative(*i, v) + moved)));
        book.add_work(impulse * moved);
    }
    let closing = touching.into_iter().zip(before);
    Ok(closing.filter(|(_, rate)| *rate < -tolerance).collect())
}
