//! The laws that a problem offers, for its table of parameters.

use crate::contact::number::{Number, same};
use crate::contact::offer::{Offered, Place, most_numbers};
use crate::contact::{ALL, GivenNumbers, LAWS};
use crate::problem::numbers::parameter::Parameter;
use crate::problem::numbers::text::text;

/// Names and meanings of the laws of a problem, as [`crate::contact::offer::Which`] says.
macro_rules! laws {
    ($place:ident, $which:expr) => {{
        use $crate::contact::ALL;
        use $crate::contact::offer::{Place, Which, names, number_of};
        const WHICH: Which = $which;
        const COUNT: usize = number_of(&ALL, Place::$place, WHICH);
        static NAMES: [(&str, &str); COUNT] = names(&ALL, Place::$place, WHICH);
        &NAMES
    }};
}

/// The names alone.
macro_rules! law_names {
    ($place:ident, $which:expr) => {{
        use $crate::contact::ALL;
        use $crate::contact::offer::{Place, Which, names, number_of};
        const WHICH: Which = $which;
        const COUNT: usize = number_of(&ALL, Place::$place, WHICH);
        static NAMES: [&str; COUNT] =
            $crate::problem::offered_laws::without_meanings(names(&ALL, Place::$place, WHICH));
        &NAMES
    }};
}

pub(super) use {law_names, laws};

/// A law that a problem offers, with its numbers and the row of each in the problem's table.
pub(super) struct Own {
    pub offered: &'static Offered,
    pub numbers: &'static [&'static Number],
    pub rows: Vec<usize>,
}

/// Most numbers of a law of oscillator or bars.
const MOST: usize = {
    let of = [Place::Oscillator, Place::Bars];
    let most = [most_numbers(&ALL, of[0]), most_numbers(&ALL, of[1])];
    if most[0] > most[1] { most[0] } else { most[1] }
};

impl Own {
    /// The laws that a problem with this table offers.
    pub fn all(place: Place, table: &[Parameter]) -> Vec<Own> {
        let row = |number: &&Number| table.iter().position(|row| row.name == number.key);
        let of_law = |offered: &'static Offered| {
            let numbers = offered.at(place)?.numbers;
            // All or none: a number without a row would have the value of the next one.
            let rows = numbers.iter().map(row).collect::<Option<Vec<usize>>>()?;
            Some(Own {
                offered,
                numbers,
                rows,
            })
        };
        LAWS.iter().filter_map(of_law).collect()
    }

    /// The law of this name.
    pub fn named<'a>(laws: &'a [Own], name: &str) -> Option<&'a Own> {
        let name_of = |law: &&Own| law.offered.offer.name;
        // Names of the table: mostly the same memory.
        let is = |law: &&Own| std::ptr::eq(name_of(law), name) || name_of(law) == name;
        laws.iter().find(is)
    }

    /// What is made of the law's numbers, the `value` of each number in its row, and what the problem knows besides.
    pub fn make<T>(
        &self,
        value: impl Fn(&Number, usize) -> Option<f64>,
        others: &[(&'static str, f64)],
        of: impl FnOnce(&GivenNumbers) -> T,
    ) -> T {
        let mut values = [None; MOST];
        let pairs = self.numbers.iter().zip(&self.rows);
        for (slot, (number, row)) in values.iter_mut().zip(pairs) {
            *slot = value(number, *row);
        }
        of(&GivenNumbers {
            law: self.offered.offer.name,
            numbers: self.numbers,
            values: &values[..self.rows.len()],
            table: &[],
            others,
        })
    }
}

/// The names without their meanings.
pub(super) const fn without_meanings<const N: usize>(
    named: [(&'static str, &'static str); N],
) -> [&'static str; N] {
    let mut names = [""; N];
    let mut i = 0;
    while i < N {
        names[i] = named[i].0;
        i += 1;
    }
    names
}

/// Whether a number of a law has no row in a table, and none of a law before it is the same.
const fn is_new(place: Place, table: &[Parameter], law: usize, number: &Number) -> bool {
    let mut i = 0;
    while i < table.len() {
        if same(text(&table[i].name), number.key) {
            return false;
        }
        i += 1;
    }
    let mut i = 0;
    while i < law {
        if let Some(offer) = ALL[i].at(place)
            && number.is_in(offer.numbers)
        {
            return false;
        }
        i += 1;
    }
    true
}

/// Number of the numbers that laws have besides those of a table.
pub(super) const fn count_others(place: Place, table: &[Parameter]) -> usize {
    let (mut i, mut sum) = (0, 0);
    while i < ALL.len() {
        if let Some(offer) = ALL[i].at(place) {
            let mut j = 0;
            while j < offer.numbers.len() {
                if is_new(place, table, i, offer.numbers[j]) {
                    sum += 1;
                }
                j += 1;
            }
        }
        i += 1;
    }
    sum
}

/// The rows of these numbers; tables have columns of them if a study gives them.
pub(super) fn others(place: Place, table: &'static [Parameter]) -> Vec<Parameter> {
    let mut rows = Vec::new();
    for (i, law) in LAWS.iter().enumerate() {
        let numbers = law.at(place).map_or(&[][..], |offer| offer.numbers);
        for number in numbers.iter().filter(|n| is_new(place, table, i, n)) {
            let with = LAWS.iter().filter(|law| {
                let offer = law.at(place);
                offer.is_some_and(|offer| number.is_in(offer.numbers))
            });
            let names: Vec<&str> = with.map(|law| law.offer.name).collect();
            rows.push(Parameter::of_laws(number, names.leak()).with_column_if_given());
        }
    }
    rows
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::PROBLEMS;

    #[test]
    fn every_number_of_a_law_has_its_row() {
        for (problem, kind) in PROBLEMS.iter().zip([Place::Oscillator, Place::Bars]) {
            let laws = Own::all(kind, problem.parameters());
            let offered = LAWS.iter().filter(|law| law.at(kind).is_some());
            assert_eq!(laws.len(), offered.count());
            for law in laws {
                let name = law.offered.offer.name;
                assert!(law.rows.len() <= MOST, "{name}");
                let rows = law.rows.iter().map(|row| &*problem.parameters()[*row].name);
                assert!(
                    rows.eq(law.numbers.iter().map(|number| number.key)),
                    "{name}"
                );
            }
        }
    }

    #[test]
    fn the_rows_of_other_numbers_are_as_many_as_counted() {
        for kind in [Place::Oscillator, Place::Bars] {
            // Without a table these are all numbers, each once.
            let numbers = others(kind, &[]);
            let mut names: Vec<_> = numbers.iter().map(|row| row.name.clone()).collect();
            names.sort();
            names.dedup();
            assert_eq!(names.len(), numbers.len());
            assert_eq!(numbers.len(), count_others(kind, &[]));
            assert!(numbers.len() > 1);
        }
    }
}
