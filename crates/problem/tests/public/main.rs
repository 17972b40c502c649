//! Problems by their public names: the textbook problems as structures, the parts of the error.

mod metrics;
mod presets;
mod reference;
