//! Two equal continuous bars, or a bar on a wall, with any law of contact: the limit of the mesh for n to infinity with the same law.
//!
//! Time is in T_I from the first touch, r in c T_I/2, rdot in c/2, F in F0, as the laws of bars have them. The force and the waves that
//! return from the free ends after each T_I move the ends of the bars ([`crate::exact::spring`]):
//!
//! ```text
//! dr/dt = -2 + 2 F(t) + 4 F(t - 1) + 4 F(t - 2) + ...,   F = -S(r, dr/dt)
//! ```
//!
//! An end of a continuous bar has no mass, so that a force changes rdot at once: the law answers with a flexibility of 2 for rdot.
//! Over the time s from k to k + 1 the motions r(s), r(1 + s), .. r(k + s) are integrated side by side, so that no past has to be kept.

use super::contact::Contact;
use super::drive::Drive;
use super::watched::{Motion, Watched};
use super::{AdaptiveFault, Flow, MOST_WORK, is_vertical};
use crate::contact::ContactLaw;
use crate::exact::State;

/// Loss of rdot by a force of 1.
const IMPEDANCE: f64 = 2.0;

/// Most T_I: the motions side by side grow with them.
const LONGEST: f64 = 100.0;

/// Bars at the times s, 1 + s, .. k + s.
struct Periods {
    contacts: Vec<Contact>,
    groups: Vec<usize>,
    watched: Vec<Watched>,
}

impl Periods {
    /// rdot of each without and with the force of its own contact, and its F.
    fn motions(&self, r: &[f64], mut visit: impl FnMut(usize, [f64; 3])) {
        let mut returned = 0.0;
        for (i, contact) in self.contacts.iter().enumerate() {
            let free = -2.0 + 2.0 * IMPEDANCE * returned;
            let push = -contact.force([r[i], free], None, None);
            returned += push;
            visit(i, [free, free + IMPEDANCE * push, push]);
        }
    }
}

impl Flow for Periods {
    fn groups(&self) -> &[usize] {
        &self.groups
    }

    fn work(&self) -> f64 {
        600.0 * self.contacts.len() as f64
    }

    fn enter(&mut self, _: [f64; 2]) {}

    fn rates(&mut self, _: f64, y: &[f64], to: &mut [f64]) {
        self.motions(y, |i, [_, rate, _]| to[i] = rate);
    }

    fn watch(&mut self, _: f64, y: &[f64]) -> &[Watched] {
        let mut watched = std::mem::take(&mut self.watched);
        watched.clear();
        let mut free = vec![0.0; y.len()];
        self.motions(y, |i, [r, ..]| free[i] = r);
        for (i, contact) in self.contacts.iter().enumerate() {
            contact.watch([y[i], free[i]], None, None, &mut watched);
        }
        self.motions(y, |_, [_, rate, _]| watched.push(Watched::sign(rate)));
        self.watched = watched;
        &self.watched
    }

    fn commit(&mut self, _: f64, y: &mut [f64]) {
        let mut free = vec![0.0; y.len()];
        self.motions(y, |i, [r, ..]| free[i] = r);
        for (i, contact) in self.contacts.iter_mut().enumerate() {
            let values = [y[i], free[i]];
            let sizes = values.map(f64::abs);
            contact.commit(Motion { values, sizes }, None, None);
        }
    }
}

/// The motion at these times, which rise, with a gap in c T_I/2 at t = 0.
///
/// # Errors
/// The law is rigid, the motion is longer than 100 T_I, or the integration takes too many steps.
pub fn continuous(
    law: &ContactLaw,
    gap: f64,
    times: &[f64],
    tolerance: f64,
) -> Result<Vec<State>, AdaptiveFault> {
    let touch = 0.5 * gap;
    let length = times.last().map_or(0.0, |end| end - touch);
    if is_vertical(law) || length > LONGEST {
        return Err(AdaptiveFault::Work { time: 0.0 });
    }
    let (before, after): (Vec<f64>, Vec<f64>) = times.iter().partition(|time| **time < touch);
    let mut states: Vec<State> = before
        .into_iter()
        .map(|time| State {
            displacement: gap - 2.0 * time,
            velocity: -1.0,
            force: 0.0,
        })
        .collect();
    let mut left = MOST_WORK;
    let mut after = after.into_iter().peekable();
    // r and the contacts at the start of each period.
    let mut starts = vec![0.0];
    let open = Contact::new(*law, IMPEDANCE, [0.0, -2.0], (None, None));
    let mut contacts = vec![open];
    while after.peek().is_some() {
        let k = contacts.len() - 1;
        let mut periods = Periods {
            groups: vec![0; contacts.len()],
            contacts,
            watched: Vec::new(),
        };
        let begun = periods.contacts.clone();
        let mut drive = Drive::new(&mut periods, starts.clone(), 1.0, tolerance, left);
        let end = touch + (k + 1) as f64;
        while let Some(time) = after.next_if(|time| *time < end) {
            drive.advance(time - touch - k as f64)?;
            drive.flow.motions(&drive.y, |i, [_, rate, force]| {
                if i == k {
                    states.push(State {
                        displacement: drive.y[k],
                        velocity: 0.5 * rate,
                        force,
                    });
                }
            });
        }
        drive.advance(1.0)?;
        left = drive.left();
        starts.push(drive.y[k]);
        // The last contact goes on; the others begin again as they began.
        contacts = begun;
        contacts.push(periods.contacts[k].clone());
    }
    Ok(states)
}
