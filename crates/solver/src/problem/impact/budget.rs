//! The motions between the exact impact and the computed one, for the error budget.

use super::scaled::{CLOSING, Scaled};
use crate::contact::WhichLaw;
use crate::exact::adaptive::{self, AdaptiveFault};
use crate::exact::mesh::Mesh;
use crate::exact::spring::Spring;
use crate::history::History;
use crate::system::structure::{Contact, Node, Structure, StructureLaw, Symmetric};

/// Most elements of a bar: memory and time of the mesh in continuous time grow with the square of their number.
const MOST_ELEMENTS: u32 = 1000;

/// Motions in continuous time.
pub struct References {
    /// The continuous bars with their law, and the mesh.
    pub motions: [History; 2],
    /// The same at every third time and the last one, with a coarser tolerance; `None` of motions in closed form.
    pub coarse: Option<[History; 2]>,
}

/// The continuous bars with their law, and the mesh in continuous time, at times that increase.
///
/// `None` for bars that differ, for rigid contact, and for more than 1000 elements. For the impact spring `None` for a wall, for gamma n
/// < 0.404 (see [`Spring::new`]), for gamma n^2 > 10^20 (see [`Mesh::new`]), and for a contact with too many separations (see
/// [`Mesh::at`]); for another law where contact nodes have no mass, and where the integration takes too many steps.
pub fn references(scaled: &Scaled, times: &[f64], with_error: bool) -> Option<References> {
    let pair = &scaled.pair;
    if pair.left.elements > MOST_ELEMENTS {
        return None;
    }
    if scaled.law.which() == WhichLaw::ImpactSpring {
        return in_closed_form(scaled, times);
    }
    let alike = pair.right.is_none() || pair.equal();
    if !alike || pair.contact_compliance() != 0.0 {
        return None;
    }
    let at = |times: &[f64], tolerance: f64| integrated(scaled, times, tolerance).ok();
    let coarse = match with_error {
        true => Some(at(&adaptive::coarse_times(times), adaptive::COARSE)?),
        false => None,
    };
    Some(References {
        motions: at(times, adaptive::TOLERANCE)?,
        coarse,
    })
}

fn in_closed_form(scaled: &Scaled, times: &[f64]) -> Option<References> {
    if !scaled.pair.equal() {
        return None;
    }
    let gap = scaled.bars.gap;
    let spring = Spring::new(0.5 * scaled.spring, gap)?;
    let mut mesh = Mesh::new(&scaled.pair.left, scaled.spring, gap)?;
    let states = times
        .iter()
        .map(|&time| Some((time, mesh.at(time)?.values())));
    let mesh = states.collect::<Option<History>>()?;
    let spring = History::sample(times, |time| spring.at(time).values());
    Some(References {
        motions: [spring, mesh],
        coarse: None,
    })
}

fn integrated(
    scaled: &Scaled,
    times: &[f64],
    tolerance: f64,
) -> Result<[History; 2], AdaptiveFault> {
    let bars = adaptive::bars::continuous(&scaled.law, scaled.bars.gap, times, tolerance)?;
    let bars = times.iter().zip(bars);
    let bars = bars.map(|(time, state)| (*time, state.values())).collect();
    let mut states = Vec::with_capacity(times.len());
    adaptive::run_of_modes(&mesh(scaled), times, tolerance, |i, state| {
        let values = [state.r[0], 0.5 * state.rate[0], -state.force[0]];
        states.push((times[i], values));
    })?;
    Ok([bars, states.into_iter().collect()])
}

/// The modes of the bars as masses that a contact joins: each is scaled by its share of r.
fn mesh(scaled: &Scaled) -> Structure {
    let modes: Vec<_> = (0..scaled.pair.len())
        .map(|j| scaled.pair.mode(j))
        .collect();
    let mut stiffness = Symmetric::zeros(modes.len());
    for (j, mode) in modes.iter().enumerate() {
        stiffness.add(j, j, mode.omega2 / mode.phi2);
    }
    let node = |phi2: f64| Node {
        name: String::new(),
        mass: 1.0 / phi2,
        direction: Default::default(),
    };
    let mut velocity = vec![0.0; modes.len()];
    velocity[..1].fill(CLOSING);
    Structure {
        nodes: modes.iter().map(|mode| node(mode.phi2)).collect(),
        coupled_mass: Symmetric::zeros(modes.len()),
        stiffness,
        damping: Symmetric::zeros(modes.len()),
        contacts: vec![Contact {
            name: String::new(),
            along: (0..modes.len()).map(|j| (j, 1.0)).collect(),
            gap: scaled.bars.gap,
            law: StructureLaw::CurvedImpact {
                law: scaled.law,
                restitution: 1.0,
            },
        }],
        loads: Vec::new(),
        displacement: vec![0.0; modes.len()],
        velocity,
        supports: Vec::new(),
        observed: None,
        preload: Default::default(),
    }
}
