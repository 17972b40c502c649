//! Records of a folder, of a pattern and of the command line.

pub(crate) mod own_records;
pub(crate) mod record_axis;
