//! Intensity measures of the ground as metrics, such as `ground.pga` or `ground.y.Sa(T, 0.05)`.

use super::computed_ground::{self, Steps};
use super::function::{Function, OfGround};
use super::reduction::Reduction;
use crate::problem::structure::given::amount::Amount;
use crate::problem::structure::given::scale_to::RATIO;
use crate::problem::structure::given::shape::Scaled;
use crate::problem::structure::parts::template::Template;
use crate::problem::{Case, Violation};
use crate::system::loads::measures::Measure;
use crate::system::structure::Direction;

/// What a measure is of.
#[derive(Debug, Clone, Default)]
pub struct GroundMetric {
    /// The direction of the acceleration; none for the only one of the ground.
    pub direction: Option<Direction>,
    /// The period and the damping ratio of an oscillator as the study writes them.
    pub texts: Vec<String>,
    /// Their numbers.
    pub amounts: Vec<Amount>,
}

/// What is before the name of each measure.
pub const PREFIX: &str = "ground.";

/// The name of a metric without the direction of the ground, and this direction: of `ground.y.pga` `ground.pga` and y.
pub fn without_direction(name: &str) -> (String, Option<Direction>) {
    let parts = name
        .strip_prefix(PREFIX)
        .and_then(|rest| rest.split_once('.'));
    let named = parts.and_then(|(direction, rest)| {
        let mut directions = Direction::TRANSLATIONS.into_iter();
        let direction = directions.find(|known| known.name() == direction)?;
        Some((format!("{PREFIX}{rest}"), Some(direction)))
    });
    named.unwrap_or_else(|| (name.to_owned(), None))
}

impl GroundMetric {
    /// The metric with these texts in brackets, none for a measure without an oscillator.
    ///
    /// # Errors
    /// What is wrong and what is allowed.
    pub fn new(
        name: &str,
        direction: Option<Direction>,
        oscillator: bool,
        inside: Option<&str>,
    ) -> Result<GroundMetric, String> {
        let texts: Vec<String> = match (oscillator, inside) {
            (false, None) => Vec::new(),
            (false, Some(_)) => return Err(format!("{name} has no brackets")),
            (true, inside) => {
                let inside = inside.unwrap_or_default();
                inside
                    .split(',')
                    .map(|text| text.trim().to_owned())
                    .collect()
            }
        };
        let complete = texts.iter().all(|text| !text.is_empty()) && texts.len() <= 2;
        if oscillator && !complete {
            return Err(format!(
                "{name} needs the period and, if it is not 0.05, the damping ratio of an oscillator, as in {name}(1, 0.02)"
            ));
        }
        Ok(GroundMetric {
            direction,
            texts,
            amounts: Vec::new(),
        })
    }

    /// The acceleration of the ground that it is of.
    ///
    /// # Errors
    /// There is none, or there are several.
    pub fn of<'a>(
        &self,
        reduction: Reduction,
        template: &'a Template,
    ) -> Result<&'a Scaled, String> {
        let ground = &template.ground;
        if of_ground(reduction).is_some_and(OfGround::of_set) {
            if self.direction.is_some() {
                return Err("a set has one for all directions; begin with ground.".to_owned());
            }
            let found = template.set().map(|set| set.0);
            return found.ok_or_else(|| "the \"scale_to\" of the ground has no \"set\"".to_owned());
        }
        let chosen =
            |own: &&(Direction, Scaled)| self.direction.is_none_or(|wanted| own.0 == wanted);
        let mut found = ground.iter().filter(chosen);
        match (found.next(), found.next()) {
            (Some((_, scaled)), None) => Ok(scaled),
            (None, _) if ground.is_empty() => Err("the study has no \"ground\"".to_owned()),
            (first, _) => {
                let directions: Vec<String> = ground
                    .iter()
                    .map(|own| format!("{PREFIX}{}.", own.0.name()))
                    .collect();
                let what = match first {
                    Some(_) => "the ground has several directions",
                    None => "the ground does not move in this direction",
                };
                Err(format!("{what}; begin with {}", directions.join(" or ")))
            }
        }
    }

    /// The measure in a case.
    pub fn measure(&self, reduction: Reduction, case: &Case) -> Result<Option<Measure>, Violation> {
        match of_ground(reduction) {
            Some(OfGround::Measure(measure)) => Ok(Some(measure)),
            Some(OfGround::Oscillator) => {
                let mut amounts = self.amounts.iter().map(|amount| amount.value(case));
                let period = amounts.next().transpose()?;
                let ratio = amounts.next().transpose()?.unwrap_or(RATIO);
                Ok(period.map(|period| Measure::Spectral { period, ratio }))
            }
            Some(OfGround::Factor | OfGround::SetFactor | OfGround::SetRatio) | None => Ok(None),
        }
    }

    /// Its value in a case, for the accelerations at its steps; none if they have no such measure.
    pub fn value(
        &self,
        reduction: Reduction,
        template: &Template,
        case: &Case,
        steps: Steps,
    ) -> Option<f64> {
        let scaled = self.of(reduction, template).ok()?;
        let state = || scaled.set_state(case, template.metre);
        match of_ground(reduction)? {
            OfGround::Factor => scaled.factor(case, template.metre).ok(),
            OfGround::SetFactor => Some(state()?.factor),
            OfGround::SetRatio => Some(state()?.ratio),
            OfGround::Measure(_) | OfGround::Oscillator => {
                let measure = self.measure(reduction, case).ok()??;
                computed_ground::measured(scaled, measure, case, template.metre, steps)
            }
        }
    }
}

/// What of the ground a reduction is of.
fn of_ground(reduction: Reduction) -> Option<OfGround> {
    match reduction.row().function {
        Function::Ground(of) => Some(of),
        Function::Values(_)
        | Function::Distance(..)
        | Function::Pair(..)
        | Function::Estimated
        | Function::Perturbed(_)
        | Function::Contact(..)
        | Function::Energies(_)
        | Function::Told
        | Function::Measured(_)
        | Function::Loop(_) => None,
    }
}
