//! Hertz's law with the damping of Hunt and Crossley.

use super::damped_hertz::damped_hertz;
use super::damped_hertz::prelude::*;

damped_hertz! {
    /// kappa = 3 (1 - e)/2 (Hunt and Crossley 1975).
    HuntCrossley "hunt-crossley": "hertz with damping (Hunt and Crossley 1975)", e => 1.5 * (1.0 - e);
}
