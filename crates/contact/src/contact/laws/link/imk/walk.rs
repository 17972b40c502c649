//! The way of a step from line to line.
//!
//! Over a step r' = y - h S'. As 1 + k h > 0 for the slope k of every line, r' < r if y - h S < r, whatever the lines are: so the step goes
//! in one direction, along the lines that come one after the other. On a line through (a, f) with the slope k,
//!
//! ```text
//! r' = (y - h (f - k a))/(1 + h k)
//! ```
//!
//! is the end, unless it is beyond that of the line. Where the next line begins with a larger force, it may be that of a force between
//! both at the same r.

use super::state::{Branch, State};
use super::{Numbers, Reloading};

/// A state at r under S, at the start of a step.
pub(super) struct Walk<'a> {
    law: &'a Numbers,
    state: State,
    start: [f64; 2],
}

/// A line of the way, in the direction of the step.
struct Line {
    /// A point of it: r and S.
    point: [f64; 2],
    slope: f64,
    /// Where it ends.
    end: f64,
    /// Whether the end belongs to the next line.
    excludes_end: bool,
}

impl<'a> Walk<'a> {
    pub(super) fn new(law: &'a Numbers, state: State, start: [f64; 2]) -> Walk<'a> {
        Walk { law, state, start }
    }

    /// S' and the state at the end of the step with this y.
    pub(super) fn to(self, y: f64, h: f64) -> (f64, State) {
        let [r, s] = self.start;
        let (law, before) = (self.law, self.state);
        let direction = match (y - h * s).partial_cmp(&r) {
            Some(std::cmp::Ordering::Greater) => 1.0,
            Some(std::cmp::Ordering::Less) => -1.0,
            // No motion, or no number.
            _ => return (if y.is_nan() { y } else { s }, before),
        };
        if before.branch == Branch::Failed {
            return (0.0, before);
        }
        let (end, mut after, mut fails) = self.along(direction, y, h);
        let [r_end, force] = end;
        let side = usize::from(direction > 0.0);
        fails |= direction * r_end >= law.sides[side].ultimate;
        // In a step of a structure the force would jump with its own motion.
        let force = if fails && h == 0.0 { 0.0 } else { force };
        after.energy[0] += 0.5 * (force + s) * (r_end - r);
        if fails {
            after.branch = Branch::Failed;
        }
        (force, after)
    }

    /// r' and S', the state there, and whether the part fails with its force.
    fn along(mut self, direction: f64, y: f64, h: f64) -> ([f64; 2], State, bool) {
        let side = usize::from(direction > 0.0);
        let mut fails = !self.begin(direction);
        // In the signs of the direction, in which r rises.
        let turned = |[r, s]: [f64; 2]| [direction * r, direction * s];
        let (y, mut from) = (direction * y, turned(self.start));
        loop {
            let line = self.line(side, from);
            let Line {
                point: [a, f],
                slope,
                end,
                excludes_end,
            } = line;
            let pushes = self.pushes(side, from[1]);
            // A line that ends before it begins is left out, as the one to a cap that has come in front of the peak.
            if end > from[0] {
                let r = (y - h * (f - slope * a)) / (1.0 + h * slope);
                if r < from[0] && h > 0.0 {
                    // Between the forces of both lines, which are the same but where the next one begins with a larger force.
                    let next = f + slope * (from[0] - a);
                    let s = ((y - from[0]) / h).min(from[1].max(next));
                    return (
                        turned([from[0], s.max(from[1].min(next))]),
                        self.state,
                        fails,
                    );
                }
                if r < end || (r == end && !excludes_end) || r.is_nan() {
                    return (turned([r, f + slope * (r - a)]), self.state, fails);
                }
                from = [end, f + slope * (end - a)];
            }
            if excludes_end && self.law.reloading == Reloading::Bilinear {
                // Round-off is no load of the other direction.
                from = [from[0].max(end), 0.0];
            }
            if !self.leave(side, end, pushes) {
                fails = true;
                return (turned([y, 0.0]), self.state, fails);
            }
        }
    }

    /// Turns from loading, if the step does; whether the part survives it.
    fn begin(&mut self, direction: f64) -> bool {
        let [r, s] = self.start;
        let loaded = match s {
            0.0 if self.state.positive => 1.0,
            0.0 => -1.0,
            s => f64::signum(s),
        };
        let on_way = !matches!(self.state.branch, Branch::Elastic | Branch::Unloading);
        if !on_way || loaded == direction {
            return true;
        }
        let side = usize::from(loaded > 0.0);
        self.state.turn(self.law, side, [loaded * r, loaded * s])
    }

    /// Whether S of a side loads it.
    fn pushes(&self, side: usize, s: f64) -> bool {
        s > 0.0 || (s == 0.0 && self.state.is_bilinear(self.law, side))
    }

    /// The line of the present branch from a point, in the signs of a side in whose direction the step goes.
    fn line(&self, side: usize, from: [f64; 2]) -> Line {
        let state = &self.state;
        let side_state = &state.sides[side];
        let line = |point: [f64; 2], slope: f64, end: f64| Line {
            point,
            slope,
            end,
            excludes_end: false,
        };
        let never = f64::INFINITY;
        match state.branch {
            Branch::Elastic => {
                let end = self.law.sides[side].yield_force / self.law.stiffness;
                line([0.0; 2], self.law.stiffness, end)
            }
            // To the first loading, to the last turn of this side, or to S = 0.
            Branch::Unloading
                if self.pushes(side, from[1]) && self.law.reloading == Reloading::Bilinear =>
            {
                let end = state.degraded(self.law, side).meets(state.unloading, from);
                line(from, state.unloading, end)
            }
            Branch::Unloading if from[1] > 0.0 => line(from, state.unloading, side_state.last[0]),
            Branch::Unloading => Line {
                excludes_end: true,
                ..line(from, state.unloading, from[0] - from[1] / state.unloading)
            },
            Branch::ToPinch => line(state.pinch, state.reloading, state.pinch[0]),
            Branch::ToLast => line(side_state.last, state.reloading, side_state.last[0]),
            Branch::ToPeak => {
                let peak = state.peak(self.law, side);
                // A peak that is the last turn ends at once.
                let slope = if state.reloading.is_finite() {
                    state.reloading
                } else {
                    0.0
                };
                line(peak, slope, peak[0])
            }
            Branch::ToCap => {
                let left = state.degraded(self.law, side);
                line(left.cap, left.hardening, left.cap[0])
            }
            Branch::Falling => {
                let left = state.degraded(self.law, side);
                line(left.cap, left.falling, left.residual[0])
            }
            Branch::Residual => {
                let left = state.degraded(self.law, side);
                let hardens = left.hardens_from();
                let end = if from[0] < hardens { hardens } else { never };
                line([from[0], left.residual[1]], 0.0, end)
            }
            Branch::Failed => line([0.0; 2], 0.0, never),
        }
    }

    /// The branch after the end of the present one, in which S had the sign of the direction or not; whether the part survives it.
    fn leave(&mut self, side: usize, end: f64, pushes: bool) -> bool {
        let state = &mut self.state;
        match state.branch {
            Branch::Elastic => {
                state.positive = side == 1;
                state.branch = Branch::ToCap;
            }
            Branch::Unloading if pushes => match self.law.reloading {
                Reloading::Bilinear => return state.load(self.law, side, end),
                Reloading::PeakOriented | Reloading::Pinching(_) => state.go_on(self.law, side),
            },
            Branch::Unloading => return state.begin(self.law, side, end),
            Branch::ToPinch => state.leave_pinch(self.law, side),
            Branch::ToLast => state.leave_last(self.law, side),
            Branch::ToPeak => state.branch = Branch::ToCap,
            Branch::ToCap => state.branch = Branch::Falling,
            Branch::Falling if state.degraded(self.law, side).residual[1] <= 0.0 => return false,
            Branch::Falling => state.branch = Branch::Residual,
            // Before it hardens.
            Branch::Residual => state.branch = Branch::ToCap,
            Branch::Failed => {}
        }
        true
    }
}
