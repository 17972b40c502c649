//! How long the nodes of an impact touch.

use crate::contact::ContactLaw;
use crate::system::structure::{Contact, Relation, Structure};
use std::f64::consts::PI;

/// 2 sqrt(5/4) times the integral of 1/sqrt(1 - x^2.5) from 0 to 1, which is sqrt(pi) Gamma(1.4)/Gamma(0.9).
const HERTZ: f64 = 3.290_681_694_319_133;

/// Time for which the nodes of an impact touch as two free masses without other forces; `None` for friction and rigid impacts.
/// For a law with delta^1.5 it depends on the largest overlap, and is `None` without it.
///
/// With m = m1 m2/(m1 + m2) of the nodes and omega = sqrt(k/m):
///
/// - a linear spring: half a period, pi/omega.
/// - `kelvin-voigt`, with xi = c/(2 m omega): delta is e^(-xi omega t) sin(omega_d t), omega_d = omega sqrt(1 - xi^2), and its force
///   k delta + c ddelta is 0 again at t = 2 acos(xi)/omega_d; for xi > 1 the hyperbolic functions take their place.
/// - delta^1.5 without damping: from the energy 2/5 k_h delta^2.5 at the largest overlap, HERTZ sqrt(m/(k_h sqrt(delta))). The damped
///   ones take longer to part, and are counted by the same overlap.
pub fn time(structure: &Structure, contact: &Contact, overlap: Option<f64>) -> Option<f64> {
    let nodes = contact.between.iter().flatten();
    let inverse: f64 = nodes.map(|node| 1.0 / structure.nodes[*node].mass).sum();
    let linear = |k: f64| PI / (k * inverse).sqrt();
    let hertz = |k: f64| Some(HERTZ / (k * overlap?.sqrt() * inverse).sqrt());
    match &contact.law {
        Relation::ImpactSpring { stiffness } => Some(linear(*stiffness)),
        Relation::CurvedImpact { law, .. } => match law {
            ContactLaw::KelvinVoigt(law) => {
                let omega = (law.stiffness * inverse).sqrt();
                Some(2.0 * damped(law.ratio(1.0 / inverse)) / omega)
            }
            ContactLaw::Hertz(law) => hertz(law.stiffness),
            ContactLaw::HertzDamp(law) => hertz(law.stiffness),
            ContactLaw::HuntCrossley(law) => hertz(law.stiffness),
            ContactLaw::Ye(law) => hertz(law.stiffness),
            ContactLaw::Jankowski(law) => hertz(law.stiffness),
            _ => None,
        },
        _ => None,
    }
}

/// acos(xi)/sqrt(1 - xi^2), which is acosh(xi)/sqrt(xi^2 - 1) above 1.
fn damped(xi: f64) -> f64 {
    let distance = 1.0 - xi * xi;
    match distance {
        // The next term is (1 - xi)/3 of it.
        _ if distance.abs() < 1e-9 => 1.0,
        _ if distance > 0.0 => libm::acos(xi) / distance.sqrt(),
        _ => libm::acosh(xi) / (-distance).sqrt(),
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_factor_of_critical_damping_is_continuous() {
        for xi in [1.0 - 1e-6, 1.0 - 1e-10, 1.0, 1.0 + 1e-10, 1.0 + 1e-6] {
            assert!((super::damped(xi) - 1.0).abs() < 1e-6, "{xi}");
        }
        assert!((super::damped(0.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    }
}
