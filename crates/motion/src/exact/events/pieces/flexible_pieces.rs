//! What nodes without mass add to the pieces.

use super::series::Series;
use crate::exact::events::coordinates::flexible::Flexible;
use crate::exact::events::coordinates::model::Model;
use crate::exact::events::numerics::bernstein::{ORDERS, Polynomial, TERMS, slope, value};
use crate::exact::events::numerics::least::Singular;
use crate::exact::events::phases::contact_state::{ContactState, Force};

impl Series {
    /// The terms of order 0 and 1 of contacts at nodes without mass, and the loads of plates.
    pub fn begin_flexible(&mut self, model: &Model) {
        let (Some(of), Some(series)) = (&model.flexible, &mut self.flexible) else {
            return;
        };
        for i in &of.contacts {
            let gap = Flexible::combine(of.gaps.rows(*i, 1), &self.loads);
            let r = &mut self.contacts[*i].r;
            series.free[*i] = [0.0; ORDERS];
            series.free[*i][..TERMS].copy_from_slice(&gap);
            series.free[*i][0] += r[0];
            series.free[*i][1] += r[1];
            let plates = of
                .start
                .iter()
                .enumerate()
                .map(|(plate, u)| of.plates[(*i, plate)] * u);
            r[0] = match series.known.get(*i) {
                Some(r) => *r,
                None => series.free[*i][0] + plates.sum::<f64>(),
            };
            r[1] = series.free[*i][1];
        }
        for (plate, load) in series.loads.iter_mut().enumerate() {
            *load = Flexible::combine(of.plate_loads.rows(plate, 1), &self.loads);
        }
    }

    /// Prepares the forces of contacts in these phases at nodes without mass.
    pub fn couple(&mut self, model: &Model, states: &[ContactState]) -> Result<(), Singular> {
        match (&model.flexible, &mut self.flexible) {
            (Some(of), Some(series)) => series.couple(of, &model.contacts, states),
            _ => Ok(()),
        }
    }

    /// Keeps r at s for the next piece, since nodes without mass have no u of their own.
    pub fn keep(&mut self, s: f64) {
        if let Some(flexible) = &mut self.flexible {
            let r = self.contacts.iter().map(|contact| {
                contact.r[..TERMS]
                    .iter()
                    .rev()
                    .fold(0.0, |sum, c| sum * s + c)
            });
            flexible.known = r.collect();
        }
    }

    /// Moves r of contacts at nodes without mass by the forces under which they were at rest before t = 0.
    pub fn rest(&mut self, model: &Model) {
        let (Some(of), Some(flexible)) = (&model.flexible, &mut self.flexible) else {
            return;
        };
        let preload = &model.structure.preload;
        if preload.forces.is_empty() {
            return;
        }
        let r = self.contacts.iter().enumerate().map(|(i, contact)| {
            let terms = of.contacts.iter();
            let terms = terms.map(|j| of.compliance[(i, *j)] * preload.force(*j).unwrap_or(0.0));
            contact.r[0] - terms.sum::<f64>()
        });
        flexible.known = r.collect();
    }

    /// Gives r of a contact at a node without mass, which has jumped.
    pub fn known(&mut self, contact: usize, r: f64) {
        let known = self.flexible.as_mut().map(|flexible| &mut flexible.known);
        if let Some(known) = known.and_then(|known| known.get_mut(contact)) {
            *known = r;
        }
    }

    /// The work of loads at nodes without mass that contacts feel, on 0..=s of a piece.
    pub fn flexible_work(&self, model: &Model, points: &[[f64; 2]]) -> f64 {
        let (Some(of), Some(series)) = (&model.flexible, &self.flexible) else {
            return 0.0;
        };
        let work = |force: &Polynomial, path: &Polynomial| -> f64 {
            points
                .iter()
                .map(|[s, w]| w * value(force, *s) * slope(path, *s))
                .sum()
        };
        let contacts = of.contacts.iter().map(|i| {
            let gap = Flexible::combine(of.gaps.rows(*i, 1), &self.loads);
            work(&self.contacts[*i].force, &gap)
        });
        let plates = series.loads.iter().zip(&series.plates);
        contacts.sum::<f64>() + plates.map(|(load, u)| work(load, u)).sum::<f64>()
    }

    /// The forces of order k at nodes without mass.
    pub fn flexible_forces(&mut self, k: usize, model: &Model, states: &[ContactState]) {
        let (Some(of), Some(series)) = (&model.flexible, &mut self.flexible) else {
            return;
        };
        let mut force: Vec<f64> = self
            .contacts
            .iter()
            .map(|contact| contact.force[k])
            .collect();
        let mut r: Vec<f64> = self.contacts.iter().map(|contact| contact.r[k]).collect();
        let origin = |i: usize| match states[i].law(&model.contacts[i].law) {
            Force::Spring { origin, .. } => origin,
            Force::None
            | Force::Line { .. }
            | Force::Dashpot { .. }
            | Force::Limit(_)
            | Force::Constraint => 0.0,
        };
        series.solve(k, of, origin, &mut force, &mut r);
        for ((contact, force), r) in self.contacts.iter_mut().zip(force).zip(r) {
            (contact.force[k], contact.r[k]) = (force, r);
        }
    }

    /// Adds r of order k + 2 of modes to that of contacts at nodes without mass.
    pub fn advance_flexible(&mut self, k: usize, model: &Model) {
        if let (Some(of), Some(flexible)) = (&model.flexible, &mut self.flexible) {
            for i in &of.contacts {
                flexible.free[*i][k + 2] += self.contacts[*i].r[k + 2];
            }
        }
    }

    /// r and rdot of a contact at s.
    pub fn relative_at(&self, contact: usize, s: f64) -> [f64; 2] {
        let r = &self.contacts[contact].r;
        let mut sums = [0.0; 2];
        for k in (1..ORDERS).rev() {
            sums[0] = (sums[0] + r[k]) * s;
            sums[1] = sums[1] * s + k as f64 * r[k] / self.length;
        }
        [sums[0] + r[0], sums[1]]
    }
}
