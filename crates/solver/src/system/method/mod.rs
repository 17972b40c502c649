//! The choice of a method of integration, and the coefficients of Newmark's family. The methods themselves are in [`crate::methods`].

mod choice;
mod coefficients;

pub use choice::{MethodChoice, MethodKind};
pub use coefficients::Coefficients;
