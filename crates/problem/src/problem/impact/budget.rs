//! The motions between the exact impact and the computed one, for the error budget.

use super::case::{self, ImpactCase};
use super::scaled::{CLOSING, Scaled};
use crate::contact::ClippedLine;
use crate::exact::adaptive::{self, AdaptiveFault};
use crate::exact::mesh::Mesh;
use crate::exact::spring::Spring;
use crate::history::History;
use crate::metrics;
use crate::metrics::convergence::{self, Halved, Referred};
use crate::metrics::impact::Track;
use crate::metrics::structure::peak;
use crate::solve::{self, ToSystem};
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
    if matches!(scaled.law.line(), Some(ClippedLine::Spring { .. })) {
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

/// The errors of r and rdot of motions in continuous time: against `coarse` ones, and of the mesh as the convergence of the computed
/// motion shows it.
pub fn reference_errors(
    case: &ImpactCase,
    computed: &History,
    motions: &[History; 2],
    coarse: &[History; 2],
) -> [Option<f64>; 2] {
    let [_, mesh] = motions;
    let estimates = metrics::impact::reference_errors(motions, coarse);
    let channel = |channel: usize| {
        Some(Referred {
            exact: mesh.channel(channel).to_vec(),
            computed: computed.channel(channel).to_vec(),
            size: peak(computed.channel(channel)),
            estimate: estimates[channel]?,
        })
    };
    let (Some(r), Some(rdot)) = (channel(0), channel(1)) else {
        return estimates;
    };
    let errors = convergence::reference_errors(&[r, rdot], |halvings| {
        let every = 1_u64 << halvings;
        let halved = ImpactCase {
            dt: case.dt / every as f64,
            last: case.last.checked_mul(every)?,
            ..*case
        };
        let mut track = solve::run::<Track<1>>(&halved.system()).ok()?.track;
        case::condense(&[halved], &mut track);
        let history = track.history(halved.dt);
        let at_steps = |channel: usize| {
            let all = history.channel(channel).iter();
            all.step_by(every as usize).copied().collect()
        };
        Some(Halved {
            channels: vec![at_steps(0), at_steps(1)],
            resolved: true,
        })
    });
    [errors.first().copied(), errors.get(1).copied()]
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
            law: StructureLaw::new(scaled.law, None).from_its_answer(),
        }],
        loads: Vec::new(),
        displacement: vec![0.0; modes.len()],
        velocity,
        supports: Vec::new(),
        observed: None,
        preload: Default::default(),
    }
}

#[cfg(test)]
mod tests;
