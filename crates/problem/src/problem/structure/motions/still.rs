//! Motions that are round-off: of bodies that contacts hold, and of sums of quantities in equilibrium.

use super::recorded::Recorded;
use crate::metrics::structure::peak;
use crate::problem::structure::channels::channel::{Channel, Derived, Number, Quantity};
use crate::problem::structure::given::node::Numbering;
use crate::system::structure::{Load, Structure};

/// Below this part of what it is compared with, a quantity is round-off. It is no motion.
const ROUND_OFF: f64 = 1e-10;

/// What the loads would do to nodes without anything else that acts on them.
#[derive(Debug, Clone, Copy)]
pub struct Still {
    /// The largest acceleration.
    acceleration: f64,
    /// The time in which it acts: a step.
    dt: f64,
}

impl Still {
    /// Of a structure in so many steps of `dt`.
    pub fn of(structure: &Structure, dt: f64, steps: usize) -> Still {
        let largest = |values: &mut dyn Iterator<Item = f64>| {
            values.fold(0.0, |most: f64, x| most.max(x.abs()))
        };
        let of_load = |load: &Load| {
            let pattern = load.pattern.iter();
            let mut by_mass = pattern.filter_map(|(node, force)| {
                let mass = structure.nodes[*node].mass;
                (mass > 0.0).then(|| force / mass)
            });
            let mut signal = (0..=steps).map(|i| load.signal.at(i as f64 * dt));
            largest(&mut by_mass) * largest(&mut signal)
        };
        Still {
            acceleration: structure.loads.iter().map(of_load).sum(),
            dt,
        }
    }

    /// The size of a quantity that moves freely for a step; 0 for forces and energies, which contacts that hold have, too.
    fn size(&self, number: Number) -> f64 {
        use Quantity::{Displacement, Distance, Slip, SlipDistance, Speed, Velocity};
        let velocity = self.acceleration * self.dt;
        match number {
            Number::Displacement(_)
            | Number::Contact(_, Displacement | Slip | Distance | SlipDistance) => {
                velocity * self.dt
            }
            Number::Velocity(_) | Number::Contact(_, Velocity | Speed) => velocity,
            Number::Derived(Derived::Acceleration(_)) => self.acceleration,
            Number::Acceleration(_)
            | Number::Contact(..)
            | Number::Derived(_)
            | Number::Energy(_) => 0.0,
        }
    }

    /// Whether a quantity is round-off.
    pub fn is(&self, number: Number, computed: &Recorded) -> bool {
        peak(computed.of(number)) < ROUND_OFF * self.size(number)
    }

    /// Whether a channel with these values is round-off, also beside its own terms.
    pub fn is_channel(
        &self,
        channel: &Channel,
        (computed, numbering): (&Recorded, &Numbering),
        values: &[f64],
    ) -> bool {
        let size_of = |term: Number| peak(computed.of(term)).max(self.size(term));
        let size: f64 = channel.numbers(numbering).map(size_of).sum();
        peak(values) < ROUND_OFF * size
    }
}
