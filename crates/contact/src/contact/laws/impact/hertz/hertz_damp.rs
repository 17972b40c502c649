//! Hertz's law with the damping of Lankarani and Nikravesh.

use super::damped_hertz::damped_hertz;
use super::damped_hertz::prelude::*;

damped_hertz! {
    /// kappa = 3 (1 - e^2)/4 (Lankarani and Nikravesh 1990; for pounding Muthukumar and DesRoches 2006).
    HertzDamp "hertz-damp" also "lankaraninikravesh", "hertzdamped":
        "hertz with damping (Lankarani and Nikravesh 1990; Muthukumar and DesRoches 2006)",
        e => 0.75 * (1.0 - e) * (1.0 + e);
}
