//! A contact in a plane in continuous time.

use super::on_line::OnLine;
use super::watched::{LimitAt, Watched};
use crate::contact::ContactLaw;
use crate::contact::plane::{AnyPlaneLaw, Pair, PlaneStep, dot, length};

/// Relative size of values that are round-off.
const ROUND_OFF: f64 = 1e-15;

/// Part of its limit by which the force that would hold a contact exceeds it when it begins to slide: at the limit itself it may stay,
/// and shares of contacts that hold a body together have errors of 1e-10.
const BEGINS: f64 = 1e-9;

/// Speed over the largest one so far, below which a rigid contact that slides has come to rest: its way from there is 1e-18 of the whole.
const STOPS: f64 = 1e-9;

/// A contact in a plane between two ends of steps of the integration.
#[derive(Debug, Clone)]
pub struct PlaneContact {
    law: ContactLaw,
    at_rest: Option<Pair>,
    /// Whether z is at the limit and follows it.
    slides: bool,
    /// What a rigid contact does; `None` of a law with compliance.
    pub phase: Option<Phase>,
    /// Of a rigid contact: up to so many times its limit it sticks.
    static_ratio: f64,
    /// A force in place of that of the motion, while one that begins to slide is sought.
    pub imposed: Option<Imposed>,
    /// Whether one that begins to slide is fast enough for explicit steps at the end of the last step.
    pub is_fast: bool,
    /// Largest r and rdot so far, with the sizes of their terms.
    largest: [f64; 2],
    /// Largest speed so far.
    speed: f64,
    /// The last end of a step, if a rigid contact slides along its first direction there: nothing turns then.
    on_line: Option<OnLine>,
}

/// What a contact without compliance does.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Phase {
    /// It sticks.
    Sticks,
    /// It slides, so slowly that its direction follows the forces much faster than they change.
    Begins {
        /// The time of the begin, at which it rests.
        since: f64,
    },
    /// It slides.
    Slides,
}

/// The force of a contact that begins to slide.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Imposed {
    /// The limit along the force that would hold it: its direction at rest.
    AlongHeld,
    /// This one.
    Force(Pair),
}

/// The motion of a contact at a time.
#[derive(Debug, Clone, Copy)]
pub struct PlaneState {
    /// Time.
    pub t: f64,
    /// r.
    pub r: Pair,
    /// rdot.
    pub rdot: Pair,
    /// z.
    pub z: Pair,
    /// The force that a rigid contact needs to stick.
    pub held: Pair,
}

impl PlaneContact {
    /// A contact with rdot, rigid with this static limit over its limit, which was at rest under S before, if static loads act.
    pub fn new(law: ContactLaw, rigid: Option<f64>, at_rest: Option<Pair>, rdot: Pair) -> Self {
        let sticks = rdot == [0.0; 2];
        let phase = if sticks { Phase::Sticks } else { Phase::Slides };
        PlaneContact {
            law,
            at_rest,
            slides: false,
            phase: rigid.map(|_| phase),
            static_ratio: rigid.unwrap_or(1.0),
            largest: [0.0; 2],
            imposed: None,
            is_fast: false,
            speed: length(rdot),
            on_line: None,
        }
    }

    /// The law with this limit; `None` leaves it. Only laws in a plane are here.
    fn law(&self, limit: Option<LimitAt>) -> Option<AnyPlaneLaw> {
        let law = limit.map_or(self.law, |limit| self.law.at_limit(limit.value));
        law.in_plane(&PlaneStep::of_given_motion(1.0))
    }

    /// z at the start; `None` for a law without a state.
    pub fn state(&self, r: Pair) -> Option<Pair> {
        let law = self.law(None).filter(AnyPlaneLaw::has_state)?;
        Some(law.state(self.at_rest, r))
    }

    /// The limit of a rigid contact.
    pub fn limit(&self, limit: Option<LimitAt>) -> f64 {
        let [_, bound] = self.law.properties().bounds();
        limit.map_or(bound, |limit| limit.value)
    }

    /// The limit up to which one sticks.
    pub fn static_limit(&self, limit: Option<LimitAt>) -> f64 {
        self.static_ratio * self.limit(limit)
    }

    /// z at its bound, or not beyond it.
    fn within(&self, z: Pair, bound: f64) -> Pair {
        let size = length(z);
        match size > 0.0 && (self.slides || size > bound) {
            true => z.map(|z| z * (bound / size)),
            false => z,
        }
    }

    /// S of a law with compliance, or of a rigid contact that slides.
    pub fn force(&self, state: &PlaneState, limit: Option<LimitAt>) -> Pair {
        match (self.phase, self.law(limit)) {
            (None, Some(law)) => law.force(self.within(state.z, law.bound()), state.r, state.rdot),
            (Some(Phase::Sticks), _) => state.held,
            _ => {
                let along = match (self.imposed, self.has_direction(state.t)) {
                    (Some(Imposed::Force(force)), _) => return force,
                    // Beyond rest it stays smooth: rest ends the step.
                    (_, true) => match self.line(state) {
                        Some(line) => [line.rdot, 0.0],
                        None => state.rdot,
                    },
                    (_, false) => state.held,
                };
                let size = length(along);
                let limit = self.limit(limit);
                along.map(|x| if size > 0.0 { x / size * limit } else { 0.0 })
            }
        }
    }

    /// Whether a rigid contact slides in the direction of its velocity or of a force that is imposed.
    pub fn has_direction(&self, t: f64) -> bool {
        match (self.phase, self.imposed) {
            (Some(Phase::Begins { .. }), Some(imposed)) => imposed != Imposed::AlongHeld,
            (Some(Phase::Begins { since }), None) => t > since,
            (phase, _) => phase == Some(Phase::Slides),
        }
    }

    /// dz/dt.
    pub fn rate(&self, state: &PlaneState, limit: Option<LimitAt>) -> Pair {
        let Some(law) = self.law(limit) else {
            return [0.0; 2];
        };
        let z = self.within(state.z, law.bound());
        let mut rate = law.rate(z, state.rdot);
        if self.slides {
            // z turns with the motion, and its length is the limit.
            let size = length(z);
            if size > 0.0 {
                let along_z = dot(z, rate) / size;
                let wanted = limit.map_or(0.0, |limit| limit.rate);
                for (rate, z) in rate.iter_mut().zip(z) {
                    *rate += (wanted - along_z) * z / size;
                }
            }
        }
        rate
    }

    /// How much faster than its limit z would grow beyond it.
    fn pressure(&self, state: &PlaneState, law: &AnyPlaneLaw, limit: Option<LimitAt>) -> f64 {
        let size = length(state.z);
        let wanted = limit.map_or(0.0, |limit| limit.rate);
        match size > 0.0 {
            true => dot(state.z, law.rate(state.z, state.rdot)) / size - wanted,
            false => -wanted,
        }
    }

    /// What is watched at a state.
    pub fn watch(&self, state: &PlaneState, limit: Option<LimitAt>, to: &mut Vec<Watched>) {
        let one_sided = |value: f64, least: f64| Watched {
            value,
            least,
            one_sided: true,
        };
        if let Some(phase) = self.phase {
            let [bound, most] = [self.limit(limit), self.static_limit(limit)];
            to.push(match phase {
                Phase::Sticks => one_sided(most - length(state.held), BEGINS * most),
                Phase::Begins { .. } => one_sided(1.0, 0.0),
                Phase::Slides if bound > 0.0 => match self.line(state) {
                    Some(line) => line.least_velocity(state.t, [state.r[0], state.rdot[0]]),
                    None => one_sided(length(state.rdot) - STOPS * self.speed, 0.0),
                },
                Phase::Slides => one_sided(1.0, 0.0),
            });
            return;
        }
        let Some(law) = self.law(limit) else {
            return;
        };
        let [_, rdot_scale] = self.largest.map(|x| ROUND_OFF * x);
        if !law.has_state() {
            // Corners of S over the speed.
            let speed = length(state.rdot);
            to.push(Watched {
                value: law.corner(speed),
                least: rdot_scale,
                one_sided: false,
            });
            return;
        }
        to.push(match self.slides {
            true => one_sided(
                self.pressure(state, &law, limit),
                ROUND_OFF * length(law.rate([0.0; 2], [self.largest[1], 0.0])),
            ),
            false => one_sided(law.bound() - length(state.z), 0.0),
        });
        if !law.is_cut() {
            // <z . rdot> has a corner.
            let size = length(state.z);
            let along = if size > 0.0 {
                dot(state.z, state.rdot) / size
            } else {
                0.0
            };
            to.push(Watched {
                value: along,
                least: rdot_scale,
                one_sided: false,
            });
        }
    }

    /// The size of z below which it is round-off of r over the tolerance.
    pub fn least_state(&self, least: f64) -> f64 {
        let size = |law: AnyPlaneLaw| {
            let r = self.largest[0].max(least);
            let elastic = length(law.rate([0.0; 2], [r, 0.0]));
            elastic.min(law.bound())
        };
        self.law(None).map_or(0.0, size)
    }

    /// Takes a state as the last one; `sizes` are those of the terms of r and rdot. Returns z there.
    pub fn commit(&mut self, state: &PlaneState, sizes: [f64; 2], limit: Option<LimitAt>) -> Pair {
        self.largest = [0, 1].map(|i| self.largest[i].max(sizes[i]));
        self.speed = self.speed.max(length(state.rdot));
        let Some(law) = self.law(limit).filter(AnyPlaneLaw::has_state) else {
            return state.z;
        };
        let z = self.within(state.z, law.bound());
        let at = PlaneState { z, ..*state };
        let pressure = self.pressure(&at, &law, limit);
        let slack = ROUND_OFF * length(law.rate([0.0; 2], [self.largest[1], 0.0]));
        self.slides = match self.slides {
            true => pressure >= -slack,
            // The length of what was cut has round-off.
            false => length(z) >= (1.0 - ROUND_OFF) * law.bound() && pressure >= 0.0,
        };
        z
    }

    /// Whether one that slides has come to rest.
    pub fn stops(&self, state: &PlaneState, limit: Option<LimitAt>) -> bool {
        let slides = self.phase == Some(Phase::Slides) && self.limit(limit) > 0.0;
        let rests = || match self.line(state) {
            Some(line) => line.rdot.signum() * state.rdot[0] <= 0.0,
            None => length(state.rdot) <= STOPS * self.speed,
        };
        slides && rests()
    }

    /// The motion on a line, if a state goes on along it.
    fn line(&self, state: &PlaneState) -> Option<OnLine> {
        self.on_line.filter(|_| state.rdot[1] == 0.0)
    }

    /// Keeps a state from which a contact that slides goes on along a line; `size` is that of the terms of r.
    pub fn follow_line(&mut self, state: &PlaneState, size: f64) {
        let slides = self.phase == Some(Phase::Slides);
        let on_line = OnLine::at(state.t, [state.r, state.rdot], size);
        self.on_line = on_line.filter(|_| slides);
    }
}
