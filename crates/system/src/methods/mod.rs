//! Methods of integration, one file each. Each is described once: its names and parameters ([`Description`]), and its sub-steps, order,
//! stability limit and amplification ([`Scheme`]). Structures with many contacts step by the sub-steps ([`SubStep`]).
//!
//! Structures with one contact have modes and are solved many at a time, in lanes. There each scheme is a recursion of its own
//! ([`Recursion`]): a mode takes three to ten operations in a step and no matrix, some ten times fewer than by the sub-steps, and round-off
//! stays small for short steps. Tests compare both.

mod amplification;
mod average_acceleration;
mod bathe;
mod bathe_mode;
mod contact_stabilized;
mod critical_step;
mod description;
mod family;
mod lanes;
mod method;
mod moreau_jean;
mod sub_step;

pub use amplification::{Amplification, Principal};
pub use average_acceleration::AverageAcceleration;
pub use bathe::Bathe;
pub use contact_stabilized::ContactStabilized;
#[cfg(test)]
use critical_step::highest_frequency;
pub use critical_step::six_digits_below;
pub use description::{Description, MethodParameter};
pub use family::Coefficients;
pub use lanes::{
    ContactState, ContactWork, EndingLanes, ManyModes, Mode, ModeCount, ModeStart, OneMode,
    Recursion, Start, Storage,
};
pub use method::{METHODS, Method, Scheme};
pub use moreau_jean::MoreauJean;
pub use sub_step::SubStep;

#[cfg(test)]
mod tests;
