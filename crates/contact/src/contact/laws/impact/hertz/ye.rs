//! Hertz's law with the damping of Ye, Li and Zhu.

use super::damped_hertz::damped_hertz;
use super::damped_hertz::prelude::*;

damped_hertz! {
    /// kappa = 8 (1 - e)/(5 e) (Ye, Li and Zhu 2009).
    Ye "ye": "hertz with damping (Ye, Li and Zhu 2009)", e => 1.6 * (1.0 - e) / e;
}
