//! The integration: steps as long as their errors allow, up to the times that are asked for, and up to events.

use super::step::Step;
use super::watched::Watched;
use super::{AdaptiveFault, Flow};

/// Least and largest factor of the length of a step to the one before it.
const FACTORS: [f64; 2] = [0.2, 6.0];

/// Part of the length at which the error would be that of the tolerance.
const SAFETY: f64 = 0.9;

/// Length of the first step over that of the whole motion.
const FIRST: f64 = 1e-6;

/// Part of the last length with which an integration starts anew behind an event.
const RESTART: f64 = 0.01;

/// Part of the whole motion that counts as its beginning: events are found to the round-off of later times.
const BEGINNING: f64 = 1e-3;

/// Tolerance of a direction over that of a step.
const OF_DIRECTION: f64 = 100.0;

/// Work of a step from rest over that of another one.
const BEGIN: f64 = 12.0;

/// Most steps that find one event: each halves the time in which it is.
const MOST_HALVES: usize = 120;

/// An integration.
#[derive(Debug)]
pub struct Drive<'a, F> {
    /// The equations.
    pub flow: &'a mut F,
    /// The time reached.
    pub t: f64,
    /// The state there.
    pub y: Vec<f64>,
    tolerance: f64,
    /// Length of the next step.
    h: f64,
    /// Length of the whole motion.
    length: f64,
    step: Step,
    /// The end of a step in one part, where something begins.
    whole: Vec<f64>,
    /// Largest value of each group so far.
    largest: Vec<f64>,
    scales: Vec<f64>,
    sides: Vec<f64>,
    /// Work that is left.
    left: f64,
}

impl<'a, F: Flow> Drive<'a, F> {
    /// Starts at t = 0.
    pub fn new(flow: &'a mut F, mut y: Vec<f64>, length: f64, tolerance: f64, work: f64) -> Self {
        flow.commit(0.0, &mut y);
        let groups = flow.groups().iter().max().map_or(0, |most| most + 1);
        let mut drive = Drive {
            step: Step::new(y.len()),
            whole: vec![0.0; y.len()],
            largest: vec![0.0; groups],
            scales: vec![0.0; y.len()],
            sides: Vec::new(),
            flow,
            t: 0.0,
            y,
            tolerance,
            h: FIRST * length,
            length,
            left: work,
        };
        drive.measure();
        drive.orient(true);
        drive
    }

    /// Goes on to `end`, through all events. The equations are smooth but for what they watch.
    pub fn advance(&mut self, end: f64) -> Result<(), AdaptiveFault> {
        self.flow.enter([self.t, end]);
        self.step.begin(self.flow, self.t, &self.y);
        while self.t < end {
            let rest = end - self.t;
            let cut = self.h >= rest;
            // No short step is left over.
            let h = match cut {
                true => rest,
                false if 2.0 * self.h > rest => 0.5 * rest,
                false => self.h,
            };
            let error = self.attempt(h)?;
            if error > 1.0 {
                self.h = h * factor(error).min(1.0);
                continue;
            }
            let event = self.fires(h);
            let taken = match event {
                true => self.locate(h)?,
                false => h,
            };
            if event {
                self.cross(taken);
            }
            let reached = taken == rest;
            self.t = if reached { end } else { self.t + taken };
            self.y.copy_from_slice(&self.step.end);
            self.flow.commit(self.t, &mut self.y);
            self.measure();
            self.orient(false);
            self.h = match (event, cut) {
                // From rest nothing is fast but what such steps allow for.
                (true, _) if self.flow.begins() => self.h.min(h),
                (true, _) => RESTART * self.h.min(h),
                (false, true) => self.h.max(h * factor(error)),
                (false, false) => h * factor(error),
            };
            self.step.begin(self.flow, self.t, &self.y);
        }
        Ok(())
    }

    /// Work that is left.
    pub fn left(&self) -> f64 {
        self.left
    }

    /// Takes a step; its error.
    fn attempt(&mut self, h: f64) -> Result<f64, AdaptiveFault> {
        self.left -= self.flow.work();
        if self.left < 0.0 {
            return Err(AdaptiveFault::Work { time: self.t });
        }
        let begins = self.flow.begins();
        let direction = match begins {
            true => {
                self.left -= BEGIN * self.flow.work();
                let ends = [&mut self.whole[..], &mut self.step.end[..]];
                let [error, least] = self.flow.begin(self.t, h, &self.y, ends);
                error / least.max(OF_DIRECTION * self.tolerance)
            }
            false => {
                self.step.take(self.flow, self.t, h, &self.y);
                0.0
            }
        };
        let groups = self.flow.groups();
        let mut sizes = self.largest.clone();
        for (group, y) in groups.iter().zip(&self.step.end) {
            sizes[*group] = sizes[*group].max(y.abs());
        }
        self.flow.raise(h, &mut sizes);
        for (scale, group) in self.scales.iter_mut().zip(groups) {
            *scale = self.tolerance * sizes[*group];
        }
        Ok(match begins {
            true => {
                let pairs = self.whole.iter().zip(&self.step.end).zip(&self.scales);
                let errors = pairs.map(|((a, b), scale)| match a == b {
                    true => 0.0,
                    false => (a - b).abs() / scale,
                });
                errors.fold(direction, larger)
            }
            false => self.step.error(h, &self.scales),
        })
    }

    /// Takes the state into account in the scales.
    fn measure(&mut self) {
        for (group, y) in self.flow.groups().iter().zip(&self.y) {
            self.largest[*group] = self.largest[*group].max(y.abs());
        }
    }

    /// Whether a watched number of the end of the step has another sign than at the start.
    fn fires(&mut self, h: f64) -> bool {
        let watched = self.flow.watch(self.t + h, &self.step.end);
        let mut pairs = watched.iter().zip(&self.sides);
        pairs.any(|(watched, side)| side * watched.value < -watched.least)
    }

    /// Takes the signs that end the step of `h`. Where a number is round-off once the law remembers this end, it has changed, too.
    fn cross(&mut self, h: f64) {
        let watched = self.flow.watch(self.t + h, &self.step.end);
        for (side, watched) in self.sides.iter_mut().zip(watched) {
            if !watched.one_sided && *side * watched.value < -watched.least {
                *side = -*side;
            }
        }
    }

    /// The signs of the watched numbers; a number that is round-off keeps its sign.
    fn orient(&mut self, first: bool) {
        let watched = self.flow.watch(self.t, &self.y);
        let anew = first || self.sides.len() != watched.len();
        let sides = watched.iter().enumerate().map(|(i, watched)| {
            let Watched {
                value,
                least,
                one_sided,
            } = *watched;
            match one_sided {
                true => 1.0,
                false if value.abs() > least => value.signum(),
                false if anew => 0.0,
                false => self.sides[i],
            }
        });
        self.sides = sides.collect();
    }

    /// The length of the shortest step at whose end a watched number has another sign; the last step is this one.
    fn locate(&mut self, h: f64) -> Result<f64, AdaptiveFault> {
        let [mut low, mut high] = [0.0, h];
        let least = f64::EPSILON * self.t.max(BEGINNING * self.length);
        for _ in 0..MOST_HALVES {
            let middle = 0.5 * (low + high);
            if high - low <= least || middle <= low || middle >= high {
                break;
            }
            self.attempt(middle)?;
            match self.fires(middle) {
                true => high = middle,
                false => low = middle,
            }
        }
        self.attempt(high)?;
        Ok(high)
    }
}

/// The larger number; not a number is larger than all.
fn larger(a: f64, b: f64) -> f64 {
    if a >= b { a } else { b }
}

/// The next length over this one.
fn factor(error: f64) -> f64 {
    let [least, most] = FACTORS;
    match error > 0.0 {
        true => (SAFETY * libm::pow(error, -1.0 / 8.0)).clamp(least, most),
        false => most,
    }
}
