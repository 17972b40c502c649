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
    use crate::contact::{ContactLaw, Hertz, HertzDamp, HuntCrossley, Jankowski, KelvinVoigt, Ye};
    use crate::study::parse;
    use crate::system::structure::{Contact, Node, Relation, Structure, Symmetric};

    const MASSES: [f64; 2] = [2.0, 3.0];

    /// The estimate for a law, over the `contact_time` of a run with fine steps: two free bodies that meet at 0.7.
    fn ratio(law: Relation, keys: &str) -> f64 {
        let [a, b] = MASSES;
        let text = format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.00001, "duration": 0.2}},
              "structure": {{"masses": {{"a": {a}, "b": {b}}}, "contacts": {{"c": {{{keys}, "between": ["a", "b"]}}}},
              "start": {{"a": {{"v": 0.7}}}}}}, "metrics": ["contact_time(c)", "min(c.r)"]}}"#
        );
        let study = parse("s", &text).unwrap_or_else(|e| panic!("{e}"));
        let metrics = study.problem.solve(&study.case(0).unwrap(), &[]);
        let metrics = metrics.unwrap().metrics;
        let node = |mass| Node {
            name: String::new(),
            mass,
        };
        let contact = Contact {
            name: String::new(),
            between: [Some(0), Some(1)],
            gap: 0.0,
            law,
        };
        let structure = Structure {
            nodes: MASSES.map(node).to_vec(),
            stiffness: Symmetric::zeros(2),
            damping: Symmetric::zeros(2),
            contacts: Vec::new(),
            loads: Vec::new(),
            displacement: vec![0.0; 2],
            velocity: vec![0.0; 2],
        };
        let time = super::time(&structure, &contact, metrics[1].map(|r| -r));
        time.unwrap() / metrics[0].unwrap()
    }

    #[test]
    fn free_bodies_touch_for_the_estimated_time() {
        // A step more or less at both ends, of 1e-5 s: of 0.03 s for the linear laws, and of 0.06 s for the others.
        let near = |ratio: f64| assert!((ratio - 1.0).abs() < 1e-3, "{ratio}");
        let stiffness = 4000.0;
        let spring = Relation::ImpactSpring { stiffness };
        near(ratio(spring, r#""law": "impact-spring", "k": 4000"#));
        let curved = |law: ContactLaw| Relation::CurvedImpact {
            law,
            restitution: 1.0,
        };
        let k_h = 90_000.0;
        let hertz = curved(ContactLaw::Hertz(Hertz { stiffness: k_h }));
        near(ratio(hertz, r#""law": "hertz", "k_h": 90000"#));
        // With m = 1.2 of the bodies xi is 0.22 and 0.69; with the larger one it is 3.
        for (e, m) in [(0.5, 1.2), (0.05, 1.2), (0.05, 22.7)] {
            let law = curved(ContactLaw::KelvinVoigt(KelvinVoigt::new(stiffness, e, m)));
            near(ratio(
                law,
                &format!(
                    r#""law": "kelvin-voigt", "k": 4000, "restitution": {e}, "colliding_mass": {m}"#
                ),
            ));
        }
        // Damping delays the separation: they touch for longer, but less than twice as long.
        let e = 0.6;
        for (law, name) in [
            (ContactLaw::HertzDamp(HertzDamp::new(k_h, e)), "hertz-damp"),
            (
                ContactLaw::HuntCrossley(HuntCrossley::new(k_h, e)),
                "hunt-crossley",
            ),
            (ContactLaw::Ye(Ye::new(k_h, e)), "ye"),
            (
                ContactLaw::Jankowski(Jankowski::new(k_h, e, 1.2)),
                "jankowski",
            ),
        ] {
            let mass = match name {
                "jankowski" => r#", "colliding_mass": 1.2"#,
                _ => "",
            };
            let keys = format!(r#""law": "{name}", "k_h": 90000, "restitution": {e}{mass}"#);
            let ratio = ratio(curved(law), &keys);
            assert!((0.5..1.2).contains(&ratio), "{name}: {ratio}");
        }
    }

    #[test]
    fn the_factor_of_critical_damping_is_continuous() {
        for xi in [1.0 - 1e-6, 1.0 - 1e-10, 1.0, 1.0 + 1e-10, 1.0 + 1e-6] {
            assert!((super::damped(xi) - 1.0).abs() < 1e-6, "{xi}");
        }
        assert!((super::damped(0.0) - std::f64::consts::FRAC_PI_2).abs() < 1e-15);
    }
}
