//! What gets a strength: a motion alone, or the pair of a station, whose horizontal motions get one factor, and so does the vertical
//! one.

use super::motion_set::{SetSpectra, State};
use super::shape::{Scaled, identity};
use super::strength::{Asked, Strengths};
use crate::problem::{Case, Violation};
use crate::system::loads::pair::Component;
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// Both horizontal motions of a station.
#[derive(Debug)]
pub struct Pair {
    /// The motions in x and y; their delays do not count.
    horizontal: [Scaled; 2],
    /// Strengths by the bits of all numbers on which they depend.
    made: Mutex<BTreeMap<Vec<u64>, Option<f64>>>,
}

/// Most strengths that are kept.
const MOST: usize = 1 << 18;

impl Pair {
    /// These motions, before they have a strength together.
    pub fn new(horizontal: [Scaled; 2]) -> Pair {
        Pair {
            horizontal,
            made: Mutex::default(),
        }
    }

    fn value(
        &self,
        component: Component,
        asked: Asked,
        case: &Case,
        metre: f64,
    ) -> Result<Option<f64>, Violation> {
        let mut key = self.identity(case)?;
        key.push(component as u64);
        key.extend(identity(asked.measure));
        let made = || self.made.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = made().get(&key) {
            return Ok(*known);
        }
        let [x, y] = &self.horizontal;
        let parts = [x.part(case, metre)?, y.part(case, metre)?];
        let tables = [x.points(&parts[0])?, y.points(&parts[1])?];
        let value = component.of(tables, asked.measure);
        let mut made = made();
        if made.len() >= MOST {
            made.clear();
        }
        made.insert(key, value);
        Ok(value)
    }
}

impl Strengths for Pair {
    fn strength(&self, asked: Asked, case: &Case, metre: f64) -> Result<f64, Violation> {
        let value = match asked.component {
            Some(component) => self.value(component, asked, case, metre)?,
            None => None,
        };
        let none = "the motions in x and y have no such strength together, so that they cannot be scaled to one";
        let value = value.filter(|value| *value > 0.0);
        value.ok_or_else(|| self.horizontal[0].source.violation(none))
    }

    fn identity(&self, case: &Case) -> Result<Vec<u64>, Violation> {
        let mut both = Vec::new();
        for record in &self.horizontal {
            let key = record.identity(case)?;
            both.push(key.len() as u64);
            both.extend(key);
        }
        Ok(both)
    }
}

impl Scaled {
    /// The factor with which the function reaches its strength, that of its set included; 1 without one.
    ///
    /// # Errors
    /// The first rule that a number breaks.
    pub fn factor(&self, case: &Case, metre: f64) -> Result<f64, Violation> {
        let Some(scale_to) = &self.shape.scale_to else {
            return Ok(1.0);
        };
        let factor = scale_to.factor(case, metre, self.strengths())?;
        match factor.is_finite() {
            true => Ok(factor),
            false => Err(self.source.violation("scale_to gives no finite factor")),
        }
    }

    /// The set that the function belongs to, in a case.
    pub fn set_state(&self, case: &Case, metre: f64) -> Option<State> {
        let scale_to = self.shape.scale_to.as_ref()?;
        scale_to.state(case, metre, self.strengths()).ok()?
    }

    /// The spectra of this set at these periods.
    pub fn set_spectra(&self, periods: &[f64], case: &Case, metre: f64) -> Option<SetSpectra> {
        let scale_to = self.shape.scale_to.as_ref()?;
        let spectra = scale_to.set_spectra(periods, case, metre, self.strengths());
        spectra.ok()?
    }

    /// What is scaled: the pair of the station, or the function alone.
    fn strengths(&self) -> &dyn Strengths {
        match &self.shape.pair {
            Some(pair) => &**pair,
            None => self,
        }
    }
}

impl Strengths for Scaled {
    fn strength(&self, asked: Asked, case: &Case, metre: f64) -> Result<f64, Violation> {
        let value = self.shape.measure(self, asked.measure, case, metre)?;
        let none = "the motion has no such strength, so that it cannot be scaled to one";
        let value = value.filter(|value| *value > 0.0);
        value.ok_or_else(|| self.source.violation(none))
    }

    fn identity(&self, case: &Case) -> Result<Vec<u64>, Violation> {
        self.shape.key(self, case)
    }
}
