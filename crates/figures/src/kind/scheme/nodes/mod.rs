//! Nodes of other programs: their places in the plane of the picture, and the symbols at them.

pub(super) mod groups;
pub(super) mod labels;
pub(super) mod marks;
pub(super) mod places;
pub(super) mod walls;
