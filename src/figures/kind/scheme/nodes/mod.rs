//! Nodes of other programs: their places in the plane of the picture, and the symbols at them.

pub(crate) mod groups;
pub(crate) mod labels;
pub(crate) mod marks;
pub(crate) mod places;
pub(crate) mod walls;
