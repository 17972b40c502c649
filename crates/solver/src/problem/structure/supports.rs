//! Motions of supports in a case.

use super::amount::Amount;
use super::template::{Course, Points, Scaled, Support};
use crate::problem::{Case, Violation};
use crate::system::structure::{Baseline, Motion, MotionFault, Signal};

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
