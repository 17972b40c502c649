//! Pages in HTML that need no other file: the report about studies, and cases in motion.

pub mod animate;
pub mod report;
