//! The friction law of a case.

use super::tables::{InitialSlip, SCHEMA, rows};
use crate::contact::number::Number;
use crate::contact::offer::{Form, Place, most_numbers};
use crate::contact::{
    ALL, ContactLaw, Described, DisplacementControl, GivenNumbers, LAWS, LawFault, VelocityControl,
};
use crate::problem::Case;
use std::sync::LazyLock;

/// The friction limit nu N in the problem's scales.
const LIMIT: f64 = 1.0;

/// A law of the oscillator.
struct Own {
    name: &'static str,
    form: fn(&GivenNumbers) -> Result<Form, LawFault>,
    numbers: &'static [&'static Number],
    /// The row of each.
    rows: Vec<usize>,
    /// Whether S(0) depends on the slip at release.
    slips: bool,
}

/// Most numbers of a law.
const MOST: usize = most_numbers(&ALL, Place::Oscillator);

static OWN: LazyLock<Vec<Own>> = LazyLock::new(|| {
    let row = |number: &&Number| {
        let mut rows = SCHEMA.parameters.iter();
        rows.position(|row| row.name == number.key)
    };
    let own = LAWS.iter().filter_map(|law| {
        let offer = law.offer.oscillator?;
        let rows = offer.numbers.iter().map(row);
        Some(Own {
            name: law.offer.name,
            form: law.offer.form,
            numbers: offer.numbers,
            // All or none: a number without a row would have the value of the next one.
            rows: rows.collect::<Option<Vec<usize>>>()?,
            slips: !law.of_velocity,
        })
    });
    own.collect()
});

/// The law of a case, and S(0); `None` if a parameter is not given.
pub fn law(case: &Case) -> Option<(ContactLaw, f64)> {
    let name = case.name_at(rows::LAW);
    // Names of the table: mostly the same memory.
    let is = |own: &&Own| std::ptr::eq(own.name, name) || own.name == name;
    let own = OWN.iter().find(is)?;
    let mut values = [None; MOST];
    for (value, row) in values.iter_mut().zip(&own.rows) {
        *value = Some(case.at(*row)?);
    }
    let given = GivenNumbers {
        law: own.name,
        numbers: own.numbers,
        values: &values[..own.rows.len()],
        table: &[],
        others: &[("limit", LIMIT)],
    };
    let force = match own.slips {
        true => {
            let slip = InitialSlip::parse(case.name_at(rows::INITIAL_SLIP))?;
            release_force(slip, case.at(rows::X0)?)
        }
        false => 0.0,
    };
    let law = (own.form)(&given).ok()?.given.law();
    Some((law.at_limit(LIMIT), force))
}

/// Which law of `[F]` a case has.
#[derive(Debug, Clone, Copy)]
pub enum PlainLawName {
    Displacement(InitialSlip),
    Velocity,
}

impl PlainLawName {
    /// The parameters that it depends on.
    pub const ROWS: [usize; 3] = [rows::LAW, rows::INITIAL_SLIP, rows::NU_RATIO];

    /// `None` for another law.
    pub fn of(case: &Case) -> Option<PlainLawName> {
        match case.name_at(rows::LAW) {
            DisplacementControl::NAME => {
                let slip = InitialSlip::parse(case.name_at(rows::INITIAL_SLIP))?;
                Some(PlainLawName::Displacement(slip))
            }
            // With another ratio it is the law of a bearing.
            VelocityControl::NAME if case.at(rows::NU_RATIO)? == 1.0 => {
                Some(PlainLawName::Velocity)
            }
            _ => None,
        }
    }
}

/// This law of `[F]` with S(0); `None` if a parameter is not given.
#[inline(always)]
pub fn plain_law(name: PlainLawName, case: &Case) -> Option<(PlainLaw, f64)> {
    let limit = LIMIT;
    match name {
        PlainLawName::Displacement(slip) => {
            let compliance = case.at(rows::ALPHA)?;
            let law = DisplacementControl { compliance, limit };
            let force = release_force(slip, case.at(rows::X0)?);
            Some((PlainLaw::Displacement(law), force))
        }
        PlainLawName::Velocity => {
            let compliance = case.at(rows::BETA)?;
            let law = VelocityControl { compliance, limit };
            Some((PlainLaw::Velocity(law), 0.0))
        }
    }
}

/// Force S(0) at release.
fn release_force(initial_slip: InitialSlip, x0: f64) -> f64 {
    match initial_slip {
        InitialSlip::Unloaded => 0.0,
        InitialSlip::Pulled => x0.signum(),
        InitialSlip::Sliding => -x0.signum(),
    }
}

/// A law of `[F]`.
#[derive(Debug, Clone, Copy)]
pub enum PlainLaw {
    Displacement(DisplacementControl),
    Velocity(VelocityControl),
}

impl From<PlainLaw> for ContactLaw {
    #[inline(always)]
    fn from(law: PlainLaw) -> ContactLaw {
        match law {
            PlainLaw::Displacement(law) => law.into(),
            PlainLaw::Velocity(law) => law.into(),
        }
    }
}

impl PlainLaw {
    /// The same of any law; `None` for one that is not of `[F]`.
    pub fn of(law: &ContactLaw) -> Option<PlainLaw> {
        match *law {
            ContactLaw::DisplacementControl(law) => Some(PlainLaw::Displacement(law)),
            ContactLaw::VelocityControl(law) => Some(PlainLaw::Velocity(law)),
            _ => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_number_of_a_law_has_its_row() {
        let offered = LAWS.iter().filter(|law| law.offer.oscillator.is_some());
        assert_eq!(OWN.len(), offered.count());
        for own in OWN.iter() {
            assert!(own.rows.len() <= MOST, "{}", own.name);
            let names = own.rows.iter().map(|row| &*SCHEMA.parameters[*row].name);
            assert!(
                names.eq(own.numbers.iter().map(|number| number.key)),
                "{}",
                own.name
            );
        }
    }
}
