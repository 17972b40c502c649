//! Motions of supports in a case.

use super::amount::Amount;
use super::chosen::Chosen;
use super::shape::Scaled;
use crate::problem::{Case, Violation};
use crate::system::loads::cycles::Cycles;
use crate::system::structure::{Baseline, Direction, Motion, MotionFault};
use std::sync::Arc;

impl Support {
    /// The motion in a case; without samples, a sampled one is only checked and does not move. `metre` is the study's unit of
    /// length in m.
    ///
    /// # Errors
    /// The first rule that it breaks.
    pub fn in_case(&self, case: &Case, metre: f64, samples: bool) -> Result<Motion, Violation> {
        let amount = self.delay.as_ref();
        let delay = amount.map_or(Ok(0.0), |amount| amount.value(case))?;
        match &self.course {
            Course::Acceleration(acceleration) => {
                let motion = self.accelerated(acceleration, delay, (case, metre, samples))?;
                let amount = self.velocity.as_ref();
                let velocity = amount.map_or(Ok(0.0), |amount| amount.value(case))?;
                let moving = motion.with_velocity(velocity);
                moving.map_err(|why| acceleration.source.violation(why.to_string()))
            }
            Course::Uniform => {
                let Some(velocity) = &self.velocity else {
                    return Ok(Motion::rest());
                };
                let moving = Motion::rest().with_velocity(velocity.value(case)?);
                moving.map_err(|why| velocity.violation(why.to_string()))
            }
            Course::Displacement(points, (at, path)) => {
                let broken = |message: String| Violation {
                    parameter: path.clone().into(),
                    message,
                    at: Some(*at),
                };
                let values = |amounts: &Vec<Amount>| -> Result<Vec<f64>, Violation> {
                    amounts.iter().map(|amount| amount.value(case)).collect()
                };
                let through = |t: &[f64], u: &[f64], line: Line| match line {
                    Line::Cubic => Motion::through(t, u, delay),
                    Line::Straight => Motion::straight(t, u, delay),
                };
                let motion = match points {
                    Points::Sine([amplitude, omega], phase) => {
                        let phase = phase.as_ref().map_or(Ok(0.0), |phase| phase.value(case));
                        let numbers = [amplitude.value(case)?, omega.value(case)?, phase?];
                        Motion::harmonic(numbers, delay)
                    }
                    Points::List([t, u], line) => through(&values(t)?, &values(u)?, *line),
                    Points::File(file, files, line) => {
                        let name = file.name(case);
                        let found = files.iter().find(|pair| pair.0 == name);
                        let none = || broken("the case has no file".to_owned());
                        let [t, u] = &*found.ok_or_else(none)?.1;
                        through(t, u, *line)
                    }
                };
                motion.map_err(|why| broken(why.to_string()))
            }
        }
    }

    fn accelerated(
        &self,
        acceleration: &Scaled,
        delay: f64,
        (case, metre, samples): (&Case, f64, bool),
    ) -> Result<Motion, Violation> {
        let broken = |why: MotionFault| acceleration.source.violation(why.to_string());
        if !samples && acceleration.source.is_sampled() {
            acceleration.check(case, metre)?;
            return Ok(Motion::rest());
        }
        let (signal, scale) = acceleration.in_case(case, metre)?;
        Motion::new(&signal, scale, delay, self.baseline).map_err(broken)
    }
}

/// The motion of a support in a direction.
#[derive(Debug, Clone)]
pub struct Support {
    /// Name of the support.
    pub name: String,
    /// The direction.
    pub direction: Direction,
    /// How it moves.
    pub course: Course,
    /// Time by which all of it is later, >= 0; none for 0.
    pub delay: Option<Amount>,
    /// Velocity at t = 0, in addition to that of its acceleration; none for 0.
    pub velocity: Option<Amount>,
    /// What is removed from its velocity.
    pub baseline: Baseline,
}

/// How a support moves.
#[derive(Debug, Clone)]
pub enum Course {
    /// An acceleration.
    Acceleration(Box<Scaled>),
    /// Displacements at times, with their place in the study.
    Displacement(Points, (usize, String)),
    /// Its velocity at t = 0, for ever.
    Uniform,
}

/// Imposed displacements: t and u of each point.
#[derive(Debug, Clone)]
pub enum Points {
    /// Those of the study.
    List([Vec<Amount>; 2], Line),
    /// Those of a file, or of the one that a parameter chooses, in the units of the study.
    File(Chosen, Vec<(&'static str, Arc<[Vec<f64>; 2]>)>, Line),
    /// amplitude (sin(omega t + phase) - sin phase), at all times; no phase is 0.
    Sine([Amount; 2], Option<Amount>),
}

/// The line between two points of imposed displacements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Line {
    /// A cubic, with a velocity that does not jump.
    #[default]
    Cubic,
    /// Straight.
    Straight,
}

impl Line {
    /// All of them.
    pub const ALL: [Line; 2] = [Line::Cubic, Line::Straight];

    /// Its name in a study.
    pub fn name(self) -> &'static str {
        match self {
            Line::Cubic => "cubic",
            Line::Straight => "straight",
        }
    }
}

impl Support {
    /// Its acceleration; `None` with displacements.
    pub fn acceleration(&self) -> Option<&Scaled> {
        match &self.course {
            Course::Acceleration(acceleration) => Some(acceleration),
            Course::Displacement(..) | Course::Uniform => None,
        }
    }

    /// The whole cycles of its motion in a case.
    pub fn cycles(&self, case: &Case) -> Result<Vec<Cycles>, Violation> {
        let delay = self.delay.as_ref();
        let delay = delay.map_or(Ok(0.0), |delay| delay.value(case))?;
        let cycles = match &self.course {
            Course::Acceleration(acceleration) => acceleration.cycles(case)?,
            Course::Displacement(Points::Sine([_, omega], phase), _) => {
                let phase = phase.as_ref().map_or(Ok(0.0), |phase| phase.value(case));
                Cycles::of_sine(omega.value(case)?, phase?)
                    .into_iter()
                    .collect()
            }
            Course::Displacement(..) | Course::Uniform => Vec::new(),
        };
        let later = cycles.into_iter().map(|cycles| cycles.delayed(delay));
        Ok(later.collect())
    }

    /// Its name with its direction, such as `left.x`.
    pub fn full_name(&self) -> String {
        format!("{}.{}", self.name, self.direction.name())
    }
}
