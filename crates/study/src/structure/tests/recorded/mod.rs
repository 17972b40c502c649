//! Records as axes: of the command line, and chosen from many.

mod chosen;
mod own_records;
