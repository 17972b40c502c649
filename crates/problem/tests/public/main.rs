//! Problems by their public names: laws of parts, the textbook problems as structures, the parts of the error.

mod metrics;
mod parts;
mod presets;
mod reference;
