//! A rigid contact that slides along a line.

use super::watched::Watched;
use crate::contact::plane::Pair;

/// Round-off of a mean velocity in a step over the terms of the displacement and the step.
const ROUND_OFF_OF_MEAN: f64 = 1e-14;

/// The motion on a line at the end of a step.
#[derive(Debug, Clone, Copy)]
pub struct OnLine {
    t: f64,
    r: f64,
    pub rdot: f64,
    /// Sum of the sizes of the terms of r.
    size: f64,
}

impl OnLine {
    /// Of r and rdot, and the size of the terms of r; `None` for an rdot that is not along the first direction.
    pub fn at(t: f64, [r, rdot]: [Pair; 2], size: f64) -> Option<OnLine> {
        (rdot[1] == 0.0 && rdot[0] != 0.0).then_some(OnLine {
            t,
            r: r[0],
            rdot: rdot[0],
            size,
        })
    }

    /// The least velocity from here to r and rdot at a time, in the direction of the one here: of the parabola with both velocities and their mean.
    pub fn least_velocity(&self, t: f64, [r, rdot]: [f64; 2]) -> Watched {
        let (h, way) = (t - self.t, self.rdot.signum());
        let [start, end] = [self.rdot, rdot].map(|rdot| way * rdot);
        let mean = way * (r - self.r) / h;
        let curvature = 3.0 * (start + end) - 6.0 * mean;
        let slope = end - start - curvature;
        let lowest = -slope / (2.0 * curvature);
        let dips = end > 0.0 && curvature > 0.0 && 0.0 < lowest && lowest < 1.0;
        Watched {
            value: match dips {
                true => start + 0.5 * slope * lowest,
                false => end,
            },
            least: match dips {
                true => ROUND_OFF_OF_MEAN * self.size / h,
                false => 0.0,
            },
            one_sided: true,
        }
    }
}
