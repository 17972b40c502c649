//! Numbers of laws that live as long as the program.

use super::{MOST, Parts};
use std::collections::BTreeMap;
use std::sync::{Mutex, PoisonError};

/// The bits of all numbers.
type Key = [u64; 1 + 3 * MOST];

/// The same numbers as before, if there were such.
pub(super) fn shared(parts: Parts) -> &'static Parts {
    static KNOWN: Mutex<BTreeMap<Key, &'static Parts>> = Mutex::new(BTreeMap::new());
    let [low, high] = parts.bends;
    let numbers = [parts.stiffness].into_iter().chain(parts.parts);
    let mut key = [0; 1 + 3 * MOST];
    for (bits, number) in key.iter_mut().zip(numbers.chain(low).chain(high)) {
        *bits = number.to_bits();
    }
    let mut known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    known
        .entry(key)
        .or_insert_with(|| Box::leak(Box::new(parts)))
}
