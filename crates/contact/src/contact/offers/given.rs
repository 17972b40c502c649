//! The numbers of a contact in a case, of which a law is made.

use super::LawFault;
use super::number::{Number, Usual};

/// The numbers of a contact in a case.
#[derive(Debug, Clone, Copy)]
pub struct GivenNumbers<'a> {
    /// The name of the law.
    pub law: &'static str,
    /// Its numbers.
    pub numbers: &'static [&'static Number],
    /// The value of each; `None` if it is not given.
    pub values: &'a [Option<f64>],
    /// Its table of r and S; empty if it has none.
    pub table: &'a [[f64; 2]],
    /// What the problem knows besides: the limit at rest, nu and its exponent of friction, the stiffness and m of bars.
    pub others: &'a [(&'static str, f64)],
}

impl GivenNumbers<'_> {
    /// A number; `None` if it is not given.
    pub(in crate::contact) fn given(&self, key: &str) -> Option<f64> {
        let pairs = self.numbers.iter().zip(self.values);
        let with_key = pairs.filter(|(number, _)| number.key == key);
        let others = self.others.iter().filter(|other| other.0 == key);
        with_key
            .filter_map(|(_, value)| *value)
            .chain(others.map(|other| other.1))
            .next()
    }

    /// A number or its usual value.
    ///
    /// # Errors
    /// It has neither.
    pub(in crate::contact) fn need(&self, key: &'static str) -> Result<f64, LawFault> {
        let usual = || {
            let number = self.numbers.iter().find(|number| number.key == key)?;
            match number.usual {
                Usual::Is(value) => Some(value),
                Usual::Needed | Usual::Follows(_) => None,
            }
        };
        let value = self.given(key).or_else(usual);
        value.ok_or(LawFault::Needs(self.law, key))
    }

    /// A number that is at most another one, both with their keys.
    ///
    /// # Errors
    /// It is above it.
    pub(in crate::contact) fn at_most(
        &self,
        key: &'static str,
        value: f64,
        (most, limit): (&'static str, f64),
    ) -> Result<f64, LawFault> {
        match value <= limit {
            true => Ok(value),
            false => Err(LawFault::AtMost {
                key,
                value,
                most,
                limit,
            }),
        }
    }

    /// The friction limit at rest.
    pub(in crate::contact) fn limit(&self) -> f64 {
        self.given("limit").unwrap_or(0.0)
    }

    /// k, or the limit at rest over r^E.
    ///
    /// # Errors
    /// Neither or both are given, or the limit at rest is 0.
    pub(in crate::contact) fn stiffness(&self) -> Result<f64, LawFault> {
        match (self.given("k"), self.given("rE")) {
            (Some(k), None) => Ok(k),
            (None, Some(elastic)) => Ok(positive(self.limit(), "k")? / elastic),
            _ => Err(LawFault::Needs(self.law, "k or rE")),
        }
    }

    /// c, or this limit at rest over rdot^E.
    ///
    /// # Errors
    /// Neither or both are given, or the limit at rest is 0.
    pub(in crate::contact) fn viscosity(&self, limit: f64) -> Result<f64, LawFault> {
        match (self.given("c"), self.given("rdotE")) {
            (Some(c), None) => Ok(c),
            (None, Some(rate)) => Ok(positive(limit, "c")? / rate),
            _ => Err(LawFault::Needs(self.law, "c or rdotE")),
        }
    }

    /// 1/k at S = 0, which is alpha in the oscillator.
    ///
    /// # Errors
    /// As [`GivenNumbers::stiffness`].
    pub(in crate::contact) fn compliance(&self) -> Result<f64, LawFault> {
        match self.given("alpha") {
            Some(alpha) => Ok(alpha),
            None => Ok(1.0 / self.stiffness()?),
        }
    }

    /// 1/c below this limit, which is beta over it in the oscillator.
    ///
    /// # Errors
    /// As [`GivenNumbers::viscosity`].
    pub(in crate::contact) fn fluidity(&self, limit: f64) -> Result<f64, LawFault> {
        match self.given("beta") {
            Some(beta) => Ok(beta / limit),
            None => Ok(1.0 / self.viscosity(limit)?),
        }
    }

    /// nu_min/nu, which is nu_ratio in the oscillator, and a of nu - (nu - nu_min) exp(-a |rdot|).
    ///
    /// # Errors
    /// Only one of both is given, or nu_min is above nu.
    pub(in crate::contact) fn bearing(&self) -> Result<[f64; 2], LawFault> {
        if let Some(ratio) = self.given("nu_ratio") {
            return Ok([ratio, self.need("nu_rate")?]);
        }
        match (self.given("nu_min"), self.given("nu_rate")) {
            (None, None) => Ok([1.0, 0.0]),
            (Some(least), Some(rate)) => {
                let nu = self
                    .given("nu")
                    .ok_or(LawFault::Needs("nu_min", "nu and N"))?;
                match least <= nu {
                    true => Ok([least / nu, rate]),
                    false => Err(LawFault::LeastFriction { nu, least }),
                }
            }
            _ => Err(LawFault::Together("nu_min", "nu_rate")),
        }
    }
}

/// The limit at rest, from which k or c follows.
fn positive(limit: f64, instead: &'static str) -> Result<f64, LawFault> {
    match limit > 0.0 {
        true => Ok(limit),
        false => Err(LawFault::NoLimit { limit, instead }),
    }
}
