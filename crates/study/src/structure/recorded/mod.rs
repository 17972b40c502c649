//! Records of a folder, of a pattern and of the command line, and the choice among many.

mod cache;
mod choice;
mod ordinates;
pub(crate) mod own_records;
mod pattern;
pub(crate) mod record_axis;
pub(crate) mod selected;
mod selection;
