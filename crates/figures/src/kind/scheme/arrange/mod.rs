//! Which parts are beside or above one another, how large they are and where from left to right.

pub(crate) mod columns;
pub(crate) mod join;
pub(crate) mod pairs;
pub(crate) mod reach;
pub(crate) mod relations;
pub(crate) mod sizes;
