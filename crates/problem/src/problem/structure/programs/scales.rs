//! Typical sizes of a case, for programs with constants of their own.

use crate::system::structure::Structure;

/// Typical sizes.
pub(super) struct Scales {
    pub length: f64,
    pub velocity: f64,
    pub force: f64,
}

impl Scales {
    /// The largest of what the start, the gaps, the loads and the limits of friction give; 1 where nothing gives any.
    pub(super) fn new(structure: &Structure, dt: f64, steps: usize) -> Scales {
        let n = structure.len();
        let nodes = structure.nodes.iter();
        let masses: Vec<f64> = nodes.map(|node| node.mass).collect();
        let mut stiffness = vec![0.0; n];
        for ((i, j), k) in structure.stiffness.entries() {
            if i == j {
                stiffness[i] = k;
            }
        }
        let mut forces = vec![0.0; n];
        for load in &structure.loads {
            let values = load.signal.at_steps(dt, steps).into_iter();
            let peak = values.fold(0.0, |peak: f64, x| peak.max(x.abs()));
            for (node, factor) in &load.pattern {
                forces[*node] += f64::abs(factor * peak);
            }
        }
        let largest = |values: &mut dyn Iterator<Item = f64>| {
            values.fold(0.0, |most: f64, x| match x.is_finite() {
                true => most.max(x.abs()),
                false => most,
            })
        };
        let (u, v) = (&structure.displacement, &structure.velocity);
        let contacts = || structure.contacts.iter();
        let limits = contacts().filter_map(|contact| Some(contact.law.limit()?.at(0.0)));
        let duration = dt * steps as f64;
        // A free body is moved by its loads for the whole time.
        let moved = |i: usize| match stiffness[i] > 0.0 {
            true => forces[i] / stiffness[i],
            false => 0.0,
        };
        let rate = |i: usize| match (masses[i] > 0.0, stiffness[i] > 0.0) {
            (true, true) => forces[i] / f64::sqrt(stiffness[i] * masses[i]),
            (true, false) => forces[i] * duration / masses[i],
            (false, _) => 0.0,
        };
        let elastic = |i: usize| stiffness[i] * u[i];
        let braked = |i: usize| v[i] * f64::sqrt(stiffness[i] * masses[i]);
        let nodes = || 0..n;
        let of_start = nodes().flat_map(|i| [elastic(i), braked(i), forces[i]]);
        let force = largest(&mut of_start.chain(limits));
        let velocity = largest(&mut nodes().flat_map(|i| {
            [v[i], rate(i), {
                let omega = f64::sqrt(stiffness[i] / masses[i]);
                u[i] * omega
            }]
        }));
        let swung = |i: usize| v[i] / f64::sqrt(stiffness[i] / masses[i]);
        let gaps = contacts().map(|contact| contact.gap);
        let length = largest(&mut nodes().flat_map(|i| [u[i], moved(i), swung(i)]).chain(gaps));
        let or_one = |x: f64| if x > 0.0 { x } else { 1.0 };
        let velocity_or_one = or_one(velocity);
        Scales {
            length: match length > 0.0 {
                true => length,
                false => velocity_or_one * duration,
            },
            velocity: velocity_or_one,
            force: or_one(force),
        }
    }
}
