//! A warning of a case that needs no motion.

use crate::solve::Warning;

/// A warning with what it is of.
pub type Doubt = (Warning, String);
