//! Records as axes: of the command line, chosen from many, and read by parameters.

mod chosen;
mod keys;
mod own_records;
