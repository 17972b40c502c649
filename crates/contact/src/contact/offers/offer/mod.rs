//! The laws by the names that studies give them.

mod offered;
mod table;

pub use offered::{Form, In, Offer, Offered, Place};
pub(in crate::contact) use table::{OffersOf, collect, count};
pub use table::{Which, most_numbers, names, number_of};
