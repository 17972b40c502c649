//! The largest gain of energy of an impact. `energy_drift_max` does not show it if a loss is larger.

use crate::history::History;
use crate::lane::Lane;
use crate::metrics::impact::{Energy, Track};
use crate::problem::Case;
use crate::problem::impact::BarImpact;

/// max (E_i - E_0)/E_0 over all steps from t = 0. It is not negative, because step 0 is one of them.
pub fn energy_gain(case: &Case, computed: &History) -> Option<f64> {
    let system = BarImpact.system(case).ok()?;
    let lanes = |of: &[f64]| of.iter().map(|x| Lane([*x])).collect();
    let track = Track {
        displacement: lanes(computed.displacement()),
        velocity: Vec::new(),
        force: lanes(computed.force()),
        touching: Vec::new(),
    };
    let energy = Energy::of_case(&track, &system, computed.len());
    let (Lane([start]), Lane([greatest])) = (energy.start, energy.largest);
    Some((greatest - start) / start)
}
