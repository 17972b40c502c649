//! The motion, piece by piece.

use super::coordinates::model::{LONGEST, Model};
use super::numerics::bernstein;
use super::phases::contact_phase::Phase;
use super::phases::contact_state::ContactState;
use super::pieces::book::{Book, energy};
use super::pieces::scales::Scales;
use super::pieces::series::Series;
use super::pieces::state_buffers::StateBuffers;
use super::pieces::watch::{Found, first_event};
use super::transitions::rigid::Constraints;
use super::{Event, EventsFault};
use crate::contact::ClippedLine;

/// Most events of a motion.
pub const MOST_EVENTS: usize = 1_000_000;

/// Most pieces of a motion.
pub const MOST_PIECES: usize = 5_000_000;

/// Most events at one time, for each contact.
const MOST_AT_ONCE: usize = 50;

/// A motion at the end of a piece.
pub struct Motion<'a> {
    pub model: Model<'a>,
    end: f64,
    pub t: f64,
    pub u: Vec<f64>,
    pub v: Vec<f64>,
    pub states: Vec<ContactState>,
    pub constraints: Constraints,
    pub series: Series,
    pub scales: Scales,
    /// Length of a piece in the present phases.
    pub length: f64,
    /// Index of the next point of a table.
    point: usize,
    /// Events since t last changed.
    at_once: usize,
    /// The end of the present piece: its s, and the event there.
    reached: (f64, Option<Found>),
    pub book: Book,
    has_book: bool,
    pub events: Vec<Event>,
    pub pieces: usize,
    pub least_impact_rate: Option<f64>,
}

impl<'a> Motion<'a> {
    /// The motion at t = 0, up to `end`.
    pub fn start(model: Model<'a>, end: f64, has_book: bool) -> Result<Motion<'a>, EventsFault> {
        let open = ContactState::in_phase(Phase::Open);
        let contacts = model.contacts.len();
        let [u, v] = model.start.clone();
        // Contacts only shorten the pieces.
        if model.pieces(&vec![open; contacts], end) > MOST_PIECES as f64 {
            return Err(EventsFault::TooManyPieces {
                most: MOST_PIECES,
                time: end,
            });
        }
        let mut motion = Motion {
            series: Series::new(&model),
            scales: Scales::new(contacts),
            states: vec![open; contacts],
            constraints: Constraints::default(),
            end,
            t: 0.0,
            u,
            v,
            length: 1.0,
            point: 0,
            at_once: 0,
            reached: (0.0, None),
            book: Book::default(),
            has_book,
            events: Vec::new(),
            pieces: 0,
            least_impact_rate: None,
            model,
        };
        motion.begin();
        motion.series.rest(&motion.model);
        motion.begin();
        motion.refuse_overlaps()?;
        let (review, states) = motion.review();
        review.start(states);
        motion.series.start_pressing(&motion.model, &motion.states);
        motion.book.start = energy(&motion.model, &motion.states, &motion.u, &motion.v);
        motion.settle(None)?;
        motion
            .book
            .close(energy(&motion.model, &motion.states, &motion.u, &motion.v));
        Ok(motion)
    }

    /// The time at which the present piece ends.
    pub fn reached(&self) -> f64 {
        let (s, found) = self.reached;
        let next = self.t + self.series.length;
        match found {
            Some(_) => self.t + s * self.series.length,
            // Without the round-off of the sum.
            None if next >= self.limit() * (1.0 - f64::EPSILON) => self.limit(),
            None => next,
        }
    }

    /// The next point of a table, or the end.
    fn limit(&self) -> f64 {
        let point = self.model.points.get(self.point);
        point.map_or(self.end, |point| point.min(self.end))
    }

    /// Starts the polynomials at t.
    pub fn begin(&mut self) {
        let left = self.limit() - self.t;
        let wanted = self.length.min(if left > 0.0 { left } else { 1.0 });
        // The length between the times as numbers, so that their round-off does not add up.
        let length = (self.t + wanted) - self.t;
        let phase = LONGEST * (length / self.length);
        let Motion { u, v, .. } = self;
        self.series
            .begin(&self.model, [self.t, length, phase], [u, v]);
        self.series.press(&self.model, &self.states);
        self.scales.include(&self.model, u, v, &self.series);
    }

    fn refuse_overlaps(&self) -> Result<(), EventsFault> {
        for (i, contact) in self.model.contacts.iter().enumerate() {
            let rigid = contact.law.is_stop();
            let r = self.series.contacts[i].r[0];
            if rigid && r < -self.scales.r(&self.model, i, self.series.length) {
                return Err(EventsFault::Overlap {
                    contact: contact.name.clone(),
                    r,
                });
            }
        }
        Ok(())
    }

    /// Computes the next piece up to its first event.
    pub fn advance(&mut self) -> Result<(), EventsFault> {
        self.pieces += 1;
        self.begin();
        // Shorter pieces than the round-off of t have no end.
        if self.pieces > MOST_PIECES || self.length < f64::EPSILON * self.end {
            return Err(EventsFault::TooManyPieces {
                most: MOST_PIECES,
                time: self.t,
            });
        }
        let constraints = self.constraints.parts();
        self.series.complete(&self.model, &self.states, constraints);
        let found = first_event(&self.model, &self.series, &self.states, &self.scales);
        self.reached = (found.map_or(1.0, |found| found.s), found);
        Ok(())
    }

    /// Goes to the end of the piece, through its event.
    pub fn finish(&mut self) -> Result<(), EventsFault> {
        let (s, found) = self.reached;
        let reached = self.reached();
        if self.has_book {
            self.book
                .add_piece(&self.model, &self.series, &self.states, s);
        }
        self.series.motion_at(s, &mut self.u, &mut self.v);
        self.series.keep(s);
        for (i, state) in self.states.iter_mut().enumerate() {
            state.force = bernstein::value(&self.series.contacts[i].force, s);
            if state.line.is_some() {
                [state.r, _] = self.series.relative_at(i, s);
            }
        }
        self.at_once = if reached > self.t {
            0
        } else {
            self.at_once + 1
        };
        self.t = reached;
        let before = self.point;
        while self
            .model
            .points
            .get(self.point)
            .is_some_and(|point| *point <= self.t)
        {
            self.point += 1;
        }
        if found.is_some() || self.point > before {
            self.settle(found)?;
        }
        if self.has_book {
            self.book
                .close(energy(&self.model, &self.states, &self.u, &self.v));
        }
        if self.events.len() > MOST_EVENTS {
            return Err(EventsFault::TooManyEvents {
                most: MOST_EVENTS,
                time: self.t,
            });
        }
        if self.at_once > MOST_AT_ONCE * self.states.len() {
            return Err(EventsFault::Unsettled { time: self.t });
        }
        Ok(())
    }

    /// The state at a time of the present piece; of modes, u and u' of these nodes only.
    pub fn at(&self, time: f64, nodes: &[usize], room: &mut StateBuffers) {
        let s = ((time - self.t) / self.series.length).clamp(0.0, self.reached.0);
        match &self.model.modes {
            None => self.series.motion_at(s, &mut room.u, &mut room.v),
            Some(modes) => room.modes_at(modes, &self.series, s, nodes),
        }
        for (i, contact) in self.model.contacts.iter().enumerate() {
            let force = bernstein::value(&self.series.contacts[i].force, s);
            let [r, rate] = match &self.model.modes {
                None => {
                    let [gap, of_gap] = self.series.gaps.at(i, s).unwrap_or_default();
                    let r = self.model.relative(i, &room.u) + contact.gap;
                    [r + gap, self.model.relative(i, &room.v) + of_gap]
                }
                // Their series contain what supports move.
                Some(_) => self.series.relative_at(i, s),
            };
            room.force[i] = force;
            room.r[i] = r;
            room.rate[i] = rate;
            room.slip[i] = match contact.law.line() {
                Some(ClippedLine::Elastic { stiffness }) => r - force / stiffness,
                _ => r,
            };
        }
    }
}
