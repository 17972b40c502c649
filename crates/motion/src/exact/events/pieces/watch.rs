//! Event functions: polynomials that are not negative as long as the contacts keep their phases.

use super::scales::Scales;
use super::series::Series;
use crate::contact::{ClippedLine, ContactKind};
use crate::exact::events::coordinates::model::Model;
use crate::exact::events::numerics::bernstein::{Polynomial, TERMS, first_negative};
use crate::exact::events::phases::contact_phase::Phase;
use crate::exact::events::phases::contact_state::ContactState;
use crate::exact::events::phases::lines::{End, Line};
use crate::system::structure::StructureLaw;

/// What happens at an event.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Crossing {
    /// r of an open impact contact becomes 0.
    Touch,
    /// The force of a closed impact contact becomes 0.
    Release,
    /// The force of a sticking contact reaches the limit in this direction.
    Limit(f64),
    /// The slip, or the viscous force, of a sliding contact falls below what sliding needs.
    Stop,
    /// The limit becomes 0 or positive.
    Normal,
    /// A line ends.
    Line(End),
    /// This spring begins or ends to press the contact.
    Press(usize),
}

/// The first event of a piece.
#[derive(Debug, Clone, Copy)]
pub struct Found {
    /// Time over the length of the piece.
    pub s: f64,
    /// The contact.
    pub contact: usize,
    /// What happens.
    pub crossing: Crossing,
}

/// The first event on 0..=1 of a piece.
pub fn first_event(
    model: &Model,
    series: &Series,
    states: &[ContactState],
    scales: &Scales,
) -> Option<Found> {
    let mut first: Option<Found> = None;
    for (contact, state) in states.iter().enumerate() {
        let mut test = |crossing, p: &Polynomial, tolerance: f64| {
            let until = first.map_or(1.0, |found| found.s);
            if let Some(s) = first_negative(p, until, tolerance)
                && first.is_none_or(|found| s < found.s)
            {
                first = Some(Found {
                    s,
                    contact,
                    crossing,
                });
            }
        };
        let watched = Watched {
            model,
            series,
            contact,
            scales,
        };
        match &state.line {
            Some(line) => watched.line(line, &mut test),
            None => watched.functions(state.phase, &mut test),
        }
        let pressed = model.pressed.iter().zip(&series.springs);
        for (pressed, springs) in pressed.filter(|(pressed, _)| pressed.contact == contact) {
            for (j, (given, spring)) in pressed.springs.iter().zip(springs).enumerate() {
                let sign = if spring.presses { -1.0 } else { 1.0 };
                let tolerance = scales.spring([given.k, given.c], series.length);
                test(
                    Crossing::Press(j),
                    &spring.force.map(|s| sign * s),
                    tolerance,
                );
            }
        }
    }
    first
}

struct Watched<'a> {
    model: &'a Model<'a>,
    series: &'a Series,
    contact: usize,
    scales: &'a Scales,
}

impl Watched<'_> {
    /// Calls `test` with each event function and its tolerance.
    fn functions(&self, phase: Phase, test: &mut impl FnMut(Crossing, &Polynomial, f64)) {
        let law = &self.model.contacts[self.contact].law;
        let of = &self.series.contacts[self.contact];
        let (limit, force) = (&of.limit, &of.force);
        let scales = self.scales;
        let force_tolerance = scales.contact_force(self.model, self.contact, self.series.length);
        let limit_tolerance = scales.limit(self.contact);
        let impact = law.kind() == ContactKind::Impact;
        let varying = law.limit().is_some_and(|limit| limit.varying.is_some());
        match phase {
            Phase::Open if impact => self.touch(law, test),
            Phase::Open if varying => {
                test(Crossing::Normal, &limit.map(|l| -l), limit_tolerance);
            }
            Phase::Open => {}
            Phase::Closed if impact => {
                test(Crossing::Release, &force.map(|s| -s), force_tolerance);
            }
            Phase::Closed => {
                let ratio = law.static_ratio();
                for direction in [1.0, -1.0] {
                    let distance = std::array::from_fn(|k| ratio * limit[k] - direction * force[k]);
                    test(Crossing::Limit(direction), &distance, force_tolerance);
                }
            }
            Phase::Sliding(direction) => {
                let (slip, tolerance) = self.slip(law, direction);
                test(Crossing::Stop, &slip, tolerance);
                if varying {
                    test(Crossing::Normal, limit, limit_tolerance);
                }
            }
        }
    }

    /// The ends of a line.
    fn line(&self, line: &Line, test: &mut impl FnMut(Crossing, &Polynomial, f64)) {
        let length = self.series.length;
        let r = &self.series.contacts[self.contact].r;
        let tolerance = self.scales.r(self.model, self.contact, length);
        let [low, high] = line.ends;
        for (end, at, sign) in [(End::Low, low, 1.0), (End::High, high, -1.0)] {
            if at.is_finite() {
                let mut distance = std::array::from_fn(|k| sign * r[k]);
                distance[0] -= sign * at;
                test(Crossing::Line(end), &distance, tolerance);
            }
        }
        if line.direction != 0.0 {
            let rate = self
                .series
                .rate(self.contact)
                .map(|rate| line.direction * rate);
            test(Crossing::Line(End::Turn), &rate, self.scales.rate(length));
        }
    }

    /// r of an open impact contact; for a rigid stop that just bounced at r = 0, r over s.
    fn touch(&self, law: &StructureLaw, test: &mut impl FnMut(Crossing, &Polynomial, f64)) {
        let r = &self.series.contacts[self.contact].r;
        let length = self.series.length;
        let tolerance = self.scales.r(self.model, self.contact, length);
        let rate_tolerance = self.scales.rate(length);
        let rigid = law.is_stop();
        if rigid && r[0].abs() <= tolerance && r[1] > rate_tolerance * length {
            let over_s = std::array::from_fn(|k| r[k + 1]);
            test(Crossing::Touch, &over_s, rate_tolerance * length);
        } else {
            test(Crossing::Touch, &std::array::from_fn(|k| r[k]), tolerance);
        }
    }

    /// The event function of sliding, and its tolerance: the rate of the slip, or the viscous force beyond the limit.
    fn slip(&self, law: &StructureLaw, direction: f64) -> (Polynomial, f64) {
        let (limit, length) = (
            &self.series.contacts[self.contact].limit,
            self.series.length,
        );
        let tolerance = self.scales.rate(length);
        let mut slip = self.series.rate(self.contact).map(|rate| direction * rate);
        match law.line() {
            // The spring follows the limit, so that the slip has the rate rdot - direction (nu N)'/k^C.
            Some(ClippedLine::Elastic { stiffness }) => {
                for k in 0..TERMS - 1 {
                    slip[k] -= (k + 1) as f64 * limit[k + 1] / (length * stiffness);
                }
            }
            Some(ClippedLine::Viscous { viscosity }) => {
                for (slip, limit) in slip.iter_mut().zip(limit) {
                    *slip -= limit / viscosity;
                }
                return (
                    slip,
                    tolerance + self.scales.limit(self.contact) / viscosity,
                );
            }
            _ => {}
        }
        (slip, tolerance)
    }
}
