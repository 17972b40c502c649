//! Finds the reference case of many cases.

use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::Value;
use std::collections::HashMap;

/// The reference case of a case, by its place among all of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Found {
    /// There is none.
    None,
    /// There is one.
    One(usize),
    /// There are several; the first two.
    Several(usize, usize),
}

/// The reference cases of a study by the values of what they share with other cases.
#[derive(Debug)]
pub struct Partners {
    shared: Vec<usize>,
    /// The different values of each shared parameter.
    levels: Vec<Levels>,
    /// The reference cases that have the same of the shared parameters.
    groups: Vec<Group>,
}

/// The different values of a parameter.
#[derive(Debug, Default)]
struct Levels {
    /// Rising.
    numbers: Vec<f64>,
    names: Vec<&'static str>,
}

/// The places of the values of a case among the levels; `None` for a parameter that it does not have.
type Places = Vec<Option<usize>>;

#[derive(Debug)]
struct Group {
    cases: Vec<(usize, Places)>,
    /// By the parameters that are compared, and their places.
    found: HashMap<Vec<bool>, HashMap<Places, Found>>,
}

/// The place of a value that no reference case has.
const NOWHERE: usize = usize::MAX;

impl Partners {
    /// All reference cases, and the rows of the parameters that a case shares with its own.
    pub fn new(shared: &[usize], cases: &[&Case]) -> Partners {
        let of = |row: &usize| Levels::of(cases.iter().filter_map(|case| case.values[*row]));
        let mut partners = Partners {
            levels: shared.iter().map(of).collect(),
            shared: shared.to_vec(),
            groups: Vec::new(),
        };
        let mut groups: HashMap<Vec<bool>, usize> = HashMap::new();
        for (number, case) in cases.iter().enumerate() {
            let places = partners.places(case);
            let has = places.iter().map(Option::is_some).collect();
            let next = partners.groups.len();
            let group = *groups.entry(has).or_insert(next);
            if group == next {
                partners.groups.push(Group {
                    cases: Vec::new(),
                    found: HashMap::new(),
                });
            }
            partners.groups[group].cases.push((number, places));
        }
        partners
    }

    fn places(&self, case: &Case) -> Places {
        let rows = self.shared.iter().zip(&self.levels);
        rows.map(|(row, levels)| case.values[*row].map(|value| levels.place(value)))
            .collect()
    }

    /// The reference case of a case.
    pub fn find(&mut self, case: &Case) -> Found {
        let values = self.places(case);
        let mut found = Found::None;
        for group in &mut self.groups {
            found = found.and(group.find(&values));
        }
        found
    }
}

impl Group {
    fn find(&mut self, wanted: &Places) -> Found {
        let Some((_, first)) = self.cases.first() else {
            return Found::None;
        };
        let pairs = wanted.iter().zip(first);
        let compared: Vec<bool> = pairs
            .map(|(value, other)| value.is_some() && other.is_some())
            .collect();
        let key = |places: &Places| -> Places {
            let pairs = places.iter().zip(&compared);
            pairs
                .map(|(value, compared)| value.filter(|_| *compared))
                .collect()
        };
        let cases = &self.cases;
        let found = self.found.entry(compared.clone()).or_insert_with(|| {
            let mut found: HashMap<Places, Found> = HashMap::new();
            for (number, places) in cases {
                let known = found.entry(key(places)).or_insert(Found::None);
                *known = known.and(Found::One(*number));
            }
            found
        });
        found.get(&key(wanted)).copied().unwrap_or(Found::None)
    }
}

impl Found {
    fn and(self, other: Found) -> Found {
        match (self, other) {
            (found, Found::None) | (Found::None, found) => found,
            (Found::Several(one, two), _) => Found::Several(one, two),
            (Found::One(one), Found::One(two) | Found::Several(two, _)) => Found::Several(one, two),
        }
    }
}

impl Levels {
    fn of(values: impl Iterator<Item = Value>) -> Levels {
        let mut levels = Levels::default();
        for value in values {
            match value.as_f64() {
                Some(x) => levels.numbers.push(x),
                None if levels.names.contains(&value.name()) => {}
                None => levels.names.push(value.name()),
            }
        }
        levels.numbers.sort_by(f64::total_cmp);
        levels
            .numbers
            .dedup_by(|a, b| Value::Number(*a).matches(Value::Number(*b)));
        levels
    }

    fn place(&self, value: Value) -> usize {
        let Some(x) = value.as_f64() else {
            let index = self.names.iter().position(|name| *name == value.name());
            return index.unwrap_or(NOWHERE);
        };
        let next = self.numbers.partition_point(|level| *level < x);
        let range = next.saturating_sub(1)..self.numbers.len().min(next + 1);
        let mut near = range.filter(|index| Value::Number(self.numbers[*index]).matches(value));
        near.next().unwrap_or(NOWHERE)
    }
}
