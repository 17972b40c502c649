//! Numbers of laws that live as long as the program: equal laws share them.
//!
//! A law of every kind is copied for each case, so that the numbers of the largest one would take room in all others.

use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// The numbers of all laws of a kind.
pub(in crate::contact) struct Shared<T: 'static>(Mutex<BTreeMap<Vec<u64>, &'static T>>);

impl<T: 'static> Shared<T> {
    pub(in crate::contact) const fn new() -> Shared<T> {
        Shared(Mutex::new(BTreeMap::new()))
    }

    /// The same numbers as before, if there were such; `all` are those that tell them from others.
    pub(in crate::contact) fn get(
        &self,
        values: impl Iterator<Item = f64>,
        numbers: T,
    ) -> &'static T {
        let key: Vec<u64> = values.map(f64::to_bits).collect();
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        known
            .entry(key)
            .or_insert_with(|| Box::leak(Box::new(numbers)))
    }
}
