//! The largest energy gain of an impact, which `energy_drift_max` does not show where a loss is larger.

use crate::history::History;
use crate::lane::Lane;
use crate::metrics::impact::{Track, energy_of_books};
use crate::problem::Case;
use crate::problem::impact::scaled::Scaled;
use crate::system::Linear;

/// max (E_i - E_0)/E_0 over the steps of a run from t = 0; never negative, since step 0 is among them.
pub fn gain(case: &Case, computed: &History) -> Option<f64> {
    let start = Linear::Bars(Scaled::new(case)?.pair).energy();
    let lanes = |of: &[f64]| of.iter().map(|x| Lane([*x])).collect();
    let track = Track {
        displacement: lanes(computed.displacement()),
        velocity: Vec::new(),
        force: lanes(computed.force()),
    };
    let energy = energy_of_books(&track, Lane([start]), computed.len());
    let (Lane([start]), Lane([greatest])) = (energy.start, energy.largest);
    Some((greatest - start) / start)
}
