//! Runs of whole studies: their columns, and what is made once.

mod made_once;
mod measured_columns;
mod new_parameter;
