//! One case: from a dictionary, solved, by its exact solution, with its histories.

pub(super) mod exact;
pub(super) mod of_dict;
pub(super) mod solution;
pub(super) mod solve;
