//! What runs keep of rigid stops: impulses, and the projection of overlaps.

pub(crate) mod corrections;
pub(crate) mod impacts;
