//! A search for a friction model, from the numbers and names that a user gives.

use super::{Friction, Releases, law_names};
use crate::setting::choices;
use crate::task::{Search, check_target, choice, folder_name};
use crate::{Fixed, Request, Stop, Target, Variants, metric};
use slipgap_problem::problem::friction::FrictionOscillator;
use slipgap_problem::problem::numbers::parameter::shortest;
use slipgap_study::error::Error;

/// The releases, unless they are given. A range, because an answer for one release often misses the target at the others, and few
/// motions have one amplitude.
pub const X0: Releases = Releases::Range(8.0, 20.0);

/// A softened law returns energy that the exact motion has lost. 5 % of the energy is 2.5 % of an amplitude.
pub const ENERGY_GAIN: f64 = 0.05;

/// What is given of a friction model, and the target.
#[derive(Debug, Clone)]
pub struct FrictionTask {
    /// The law; `None` to search all.
    pub law: Option<String>,
    /// The method; `None` to search all.
    pub method: Option<String>,
    /// Displacements at release over Delta.
    pub x0: Releases,
    /// Largest rms_error.
    pub rms: f64,
    /// Largest excess of energy over the exact motion at any step, relative to the energy at release.
    pub energy_gain: f64,
}

impl FrictionTask {
    /// All laws and methods for the usual releases, with this largest rms_error.
    pub fn new(rms: f64) -> FrictionTask {
        FrictionTask {
            law: None,
            method: None,
            x0: X0,
            rms,
            energy_gain: ENERGY_GAIN,
        }
    }

    /// The search.
    ///
    /// # Errors
    /// A name or a number that is not allowed, and a method that has no stable step with the law.
    pub fn search(self) -> Result<Search, Error> {
        check_target("rms", self.rms)?;
        check_target("energy_gain", self.energy_gain)?;
        self.x0
            .check()
            .map_err(|why| Error::Usage(format!("x0: {why}")))?;
        let methods = choices(&FrictionOscillator, "method");
        let fixed = Fixed {
            law: choice(&law_names(), "law", self.law.as_ref())?,
            method: choice(&methods, "method", self.method.as_ref())?,
        };
        let space = Friction::new(fixed, self.x0);
        if space.variants().is_empty() {
            return Err(Error::Usage(
                "law and method: this method has no stable step with this law; allowed: a law with compliance, or another method"
                    .into(),
            ));
        }
        let words = [
            Some(format!("rms-{}", shortest(self.rms))),
            self.law,
            self.method,
            (self.x0 != X0).then(|| format!("x0-{}", self.x0)),
            (self.energy_gain != ENERGY_GAIN)
                .then(|| format!("energy-gain-{}", shortest(self.energy_gain))),
        ];
        let target = Target {
            name: "rms_error",
            metric: metric(&FrictionOscillator, "rms_error"),
            ideal: 0.0,
            limit: self.rms,
        };
        Ok(Search {
            folder: folder_name(&FrictionOscillator, words),
            space: Box::new(space),
            request: Request {
                targets: vec![target],
                energy_gain: self.energy_gain,
                energy_loss: f64::INFINITY,
                stop: Stop::default(),
            },
        })
    }
}
