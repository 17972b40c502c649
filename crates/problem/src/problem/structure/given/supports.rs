//! Motions of supports in a case.

use super::amount::Amount;
use super::chosen::Chosen;
use super::shape::Scaled;
use crate::problem::{Case, Violation};
use crate::system::structure::{Baseline, Direction, Motion, MotionFault, Signal};
use std::sync::Arc;

impl Support {
    /// The motion in a case; without samples, a sampled one is only checked and does not move. `metre` is the study's unit of
    /// length in m.
    ///
    /// # Errors
    /// The first rule that it breaks.
    pub fn in_case(&self, case: &Case, metre: f64, samples: bool) -> Result<Motion, Violation> {
        let delay = self.delay.as_ref();
        let delay = delay.map_or(Ok(0.0), |delay| delay.value(case))?;
        match &self.course {
            Course::Acceleration(acceleration) => {
                self.accelerated(acceleration, delay, (case, metre, samples))
            }
            Course::Displacement(points, (at, path)) => {
                let broken = |message: String| Violation {
                    parameter: path.clone().into(),
                    message,
                    at: Some(*at),
                };
                let values = |own: &Vec<Amount>| -> Result<Vec<f64>, Violation> {
                    own.iter().map(|amount| amount.value(case)).collect()
                };
                let motion = match points {
                    Points::List([t, u]) => Motion::through(&values(t)?, &values(u)?, delay),
                    Points::File(file, files) => {
                        let name = file.name(case);
                        let found = files.iter().find(|own| own.0 == name);
                        let none = || broken("the case has no file".to_owned());
                        let [t, u] = &*found.ok_or_else(none)?.1;
                        Motion::through(t, u, delay)
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
            let rest = Signal::Sine {
                amplitude: 0.0,
                omega: 0.0,
                phase: 0.0,
            };
            return Motion::new(&rest, 0.0, delay, Baseline::None).map_err(broken);
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
}

/// Imposed displacements: t and u of each point.
#[derive(Debug, Clone)]
pub enum Points {
    /// Those of the study.
    List([Vec<Amount>; 2]),
    /// Those of a file, or of the one that a parameter chooses, in the units of the study.
    File(Chosen, Vec<(&'static str, Arc<[Vec<f64>; 2]>)>),
}

impl Support {
    /// Its acceleration; `None` with displacements.
    pub fn acceleration(&self) -> Option<&Scaled> {
        match &self.course {
            Course::Acceleration(acceleration) => Some(acceleration),
            Course::Displacement(..) => None,
        }
    }

    /// Its name with its direction, such as `left.x`.
    pub fn full_name(&self) -> String {
        format!("{}.{}", self.name, self.direction.name())
    }
}
