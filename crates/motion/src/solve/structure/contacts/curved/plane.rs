//! Contacts in a plane: two neighbouring contacts of a structure, which answer together.

use super::step::{Motion, Scale};
use crate::contact::coupled::curved::Directions;
use crate::contact::plane::{AnyPlaneLaw, Pair, PlaneMemory, PlaneStep, PlaneTrial, length};
use crate::solve::structure::contacts::static_in_plane::Disc;
use crate::system::structure::{PlaneRow, Structure};

/// The law of both directions with its memory, beside the first one.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Plane {
    pub(crate) law: AnyPlaneLaw,
    pub(crate) memory: PlaneMemory,
    scale: Scale,
    on: PlaneStep,
    /// Where S may be, of Coulomb friction with two limits.
    pub(super) disc: Option<Disc>,
}

/// The law of a contact in a plane that is its first direction.
pub(crate) fn first(
    structure: &Structure,
    contact: usize,
    limit: f64,
    scale: Scale,
    flexibility: f64,
) -> Option<Plane> {
    let law = plane_law(structure, contact, limit, scale, flexibility)?;
    let remembers = structure.preload.planes.get(contact).copied().flatten();
    Some(Plane {
        law,
        memory: remembers.unwrap_or_default(),
        scale,
        on: step(scale, flexibility),
        disc: None,
    })
}

fn plane_law(
    structure: &Structure,
    contact: usize,
    limit: f64,
    scale: Scale,
    flexibility: f64,
) -> Option<AnyPlaneLaw> {
    let relation = &structure.contacts[contact].law;
    match relation.row()? {
        PlaneRow::First => relation.law(limit).in_plane(&step(scale, flexibility)),
        PlaneRow::Second => None,
    }
}

pub(crate) fn step(scale: Scale, flexibility: f64) -> PlaneStep {
    let [h, h_rate] = match scale.is_explicit() {
        true => [0.0, flexibility],
        false => [flexibility, scale.pace * flexibility],
    };
    PlaneStep {
        h,
        h_rate,
        dt: scale.dt,
    }
}

/// S(0) of both directions of a contact in a plane with this motion, and what its law remembers.
pub(crate) fn first_forces(
    structure: &Structure,
    contact: usize,
    r: Pair,
    rdot: Pair,
    limit: f64,
) -> Option<(Pair, PlaneMemory)> {
    let scale = Scale {
        pace: 0.0,
        dt: 1.0,
        is_massless: false,
    };
    let law = plane_law(structure, contact, limit, scale, 0.0)?;
    let forces = [contact, contact + 1].map(|c| structure.preload.force(c));
    let at_rest = match forces {
        [Some(a), Some(b)] => Some([a, b]),
        _ => None,
    };
    Some(law.at_start(at_rest, r, rdot))
}

impl Plane {
    /// The trial with these y.
    fn trial(&self, motions: [&Motion; 2], y: Pair) -> PlaneTrial {
        let of = |of: fn(&Motion) -> f64| motions.map(of);
        let change = of(|motion| motion.change);
        let (change, rate) = match self.scale.is_explicit() {
            true => (change, y),
            false => {
                let rate = |i: usize| motions[i].rate + self.scale.pace * (y[i] - change[i]);
                (y, [rate(0), rate(1)])
            }
        };
        PlaneTrial {
            displacement: of(|motion| motion.displacement),
            velocity: of(|motion| motion.velocity),
            force: of(|motion| motion.force),
            change,
            rate,
        }
    }

    /// The force that keeps rdot' = 0 with these y.
    fn held(&self, motions: [&Motion; 2], y: Pair) -> Pair {
        let PlaneTrial { rate, .. } = self.trial(motions, y);
        rate.map(|rate| rate / self.on.h_rate)
    }

    /// J(y).
    pub(crate) fn answer(&self, motions: [&Motion; 2], y: Pair) -> (Pair, PlaneMemory) {
        if let Some(disc) = self.disc {
            return (disc.nearest(self.held(motions, y)), self.memory);
        }
        self.law.answer(&self.trial(motions, y), &self.memory)
    }

    /// 1/f' where J(y) is `force`.
    pub(crate) fn directions(&self, motions: [&Motion; 2], y: Pair, force: Pair) -> Directions {
        if let Some(disc) = self.disc {
            return self.directions_of(disc, disc.centred(self.held(motions, y)));
        }
        let trial = self.trial(motions, y);
        self.law
            .directions(&trial, &self.memory, force, self.scale.pace)
    }

    /// The same at the rim of a disc or within it, for the force that would hold from its centre.
    fn directions_of(&self, disc: Disc, held: Pair) -> Directions {
        let size = length(held);
        if size < disc.radius {
            return Directions {
                along: [1.0, 0.0],
                slopes: [0.0; 2],
            };
        }
        if size == 0.0 {
            return Directions {
                along: [1.0, 0.0],
                slopes: [f64::INFINITY; 2],
            };
        }
        // J turns with y by R/|held| of it, and 1/f' = 1/J' - a.
        let own = match self.scale.is_explicit() {
            true => self.on.h_rate,
            false => self.on.h,
        };
        Directions {
            along: held.map(|s| s / size),
            slopes: [f64::INFINITY, own * (size / disc.radius - 1.0)],
        }
    }
}
