//! The laws as studies give them: names, numbers, and the law that numbers make.

mod fault;
mod given;
pub mod number;
pub mod numbers;
pub mod offer;

pub use fault::LawFault;
pub use given::GivenNumbers;
