//! The equations of a structure: M u'' + C u' + K u + B S = p(t), in the coordinates of a model.

use super::braced::in_series;
use super::damper::Creep;
use crate::contact::plane::Pair;
use crate::exact::adaptive::contact::Contact;
use crate::exact::adaptive::plane::{PlaneContact, PlaneState};
use crate::exact::adaptive::watched::{LimitAt, Motion, Watched};
use crate::exact::events::Model;
use crate::system::structure::{PlaneRow, Structure};

/// Part of the time between two points of tables over which the rate of a limit is a difference.
pub(crate) const DIFFERENCE: f64 = 1e-4;

/// Round-off of the change of velocities in a step over its terms and the tolerance, some five times the unit round-off: a body that
/// hardly moves under forces in equilibrium has no better velocity.
pub(crate) const ROUND_OFF_OF_STEP: f64 = 1e-3;

/// Part of velocities, and of the time of the motion, that does not matter, and the times at which loads are measured.
const SHORT: f64 = 1e-3;
const SAMPLES: usize = 64;

/// A structure with its contacts.
pub struct Moving<'a> {
    pub(crate) model: Model<'a>,
    pub(crate) contacts: Vec<Contact>,
    /// The compliance of springs behind which a contact is.
    pub(crate) braces: Vec<Option<f64>>,
    /// The contacts in a plane, by their first rows.
    pub(crate) planes: Vec<Option<PlaneContact>>,
    /// Place of z of each contact; `None` without a state.
    pub(crate) places: Vec<Option<usize>>,
    /// What dampers that are steep at rest do; none beside contacts in a plane without compliance.
    pub(crate) creeps: Vec<Option<Creep>>,
    pub(crate) groups: Vec<usize>,
    /// Start and end of the present smooth part of all signals.
    pub(crate) part: [f64; 2],
    pub(crate) watched: Vec<Watched>,
    /// The time of the last end of a step.
    pub(crate) t: f64,
    /// The largest sum of the sizes of the terms of an acceleration there, whose round-off it has.
    pub(crate) acceleration_terms: f64,
    /// Sizes of u and u' below which they do not matter.
    pub(crate) least: [f64; 2],
    /// The state there, if contacts in a plane are rigid: they may hold a structure that no load has moved yet.
    pub(crate) last: Option<Vec<f64>>,
    pub(crate) work: f64,
}

impl<'a> Moving<'a> {
    /// The equations with the compliances behind contacts, and the state at t = 0.
    pub fn new(model: Model<'a>, braces: Vec<Option<f64>>) -> (Moving<'a>, Vec<f64>) {
        let structure = model.structure;
        let n = model.len();
        let [u, v] = &model.start;
        let mut y: Vec<f64> = u.iter().chain(v).copied().collect();
        let mut groups: Vec<usize> = (0..2 * n).map(|i| i / n.max(1)).collect();
        let (mut contacts, mut places) = (Vec::new(), Vec::new());
        let mut planes = Vec::new();
        for (i, given) in structure.contacts.iter().enumerate() {
            let limit = given.law.limit().map_or(0.0, |limit| limit.at(0.0));
            let law = given.law.law(limit);
            let [gap, of_gap] = moved_gap(structure, i, 0.0);
            let r = model.columns[i].dot(u) + given.gap + gap;
            let rdot = model.columns[i].dot(v) + of_gap;
            let memory = structure.preload.laws.get(i).copied().flatten();
            let at_rest = structure.preload.force(i);
            let contact = Contact::new(law, 0.0, [r, rdot], (at_rest, memory)).behind(braces[i]);
            contacts.push(contact.clone());
            if given.law.row() == Some(PlaneRow::First) {
                let [gap, of_gap] = moved_gap(structure, i + 1, 0.0);
                let other = structure.contacts[i + 1].gap + gap;
                let r = [r, model.columns[i + 1].dot(u) + other];
                let rdot = [rdot, model.columns[i + 1].dot(v) + of_gap];
                let at_rest = at_rest
                    .zip(structure.preload.force(i + 1))
                    .map(|(first, second)| [first, second]);
                let behind = braces[i].and_then(|brace| in_series(&given.law, brace));
                let is_rigid = behind.is_none() && given.law.is_rigid();
                let rigid = is_rigid.then(|| given.law.static_ratio());
                let plane = PlaneContact::new(behind.unwrap_or(law), rigid, at_rest, rdot);
                let state = plane.state(r).filter(|_| plane.phase.is_none());
                places.push(state.map(|z| {
                    y.extend(z);
                    groups.extend([2 + i; 2]);
                    y.len() - 2
                }));
                planes.push(Some(plane));
                continue;
            }
            planes.push(None);
            if given.law.row() == Some(PlaneRow::Second) {
                places.push(None);
                continue;
            }
            places.push(contact.state().map(|z| {
                y.push(z);
                groups.push(2 + i);
                y.len() - 1
            }));
        }
        // Products of matrices and vectors, and about 50 of them for the answer of a law.
        let entries = model.stiffness.entries() + model.damping.entries() + 8 * n;
        let columns: usize = model.columns.iter().map(|row| row.entries()).sum();
        let signals = model.patterns.iter().map(|row| 20 + row.entries());
        let once = entries + 3 * columns + 50 * contacts.len() + signals.sum::<usize>();
        let has_rigid = planes.iter().flatten().any(|plane| plane.phase.is_some());
        let creep = |contact: usize| {
            let law = &structure.contacts[contact].law;
            let is_alone = !has_rigid && law.row().is_none() && braces[contact].is_none();
            Creep::of(&law.as_given()).filter(|_| is_alone)
        };
        let creeps = (0..contacts.len()).map(creep).collect();
        let moving = Moving {
            contacts,
            creeps,
            braces,
            planes,
            places,
            groups,
            part: [0.0, f64::INFINITY],
            watched: Vec::new(),
            t: 0.0,
            acceleration_terms: 0.0,
            least: [0.0; 2],
            last: None,
            work: 12.0 * once as f64,
            model,
        };
        (moving, y)
    }

    /// Takes what loads and supports do up to a time as the measure of u and u'. Behind a damper whose force is a power of velocity, a
    /// motion from rest may have the same shape at all times, so that the first step has the same part of u' as its error however short.
    pub fn measure(&mut self, length: f64) {
        let structure = self.model.structure;
        let between = (0..=SAMPLES).map(|i| length * i as f64 / SAMPLES as f64);
        let points = self.model.points.iter().copied();
        let mut times: Vec<f64> = between.chain(points.filter(|t| *t < length)).collect();
        times.sort_by(f64::total_cmp);
        // Without springs and contacts, and of the supports.
        let mut velocities = vec![0.0; self.model.len()];
        let (mut fastest, mut moved) = (0.0_f64, [0.0_f64; 2]);
        let mut last: Option<(f64, Vec<f64>)> = None;
        for t in times {
            let mut forces = vec![0.0; self.model.len()];
            for (load, pattern) in structure.loads.iter().zip(&self.model.patterns) {
                pattern.add(load.signal.at(t), &mut forces);
            }
            if let Some((before, others)) = last {
                let means = forces.iter().zip(&others).map(|(a, b)| 0.5 * (a + b));
                let masses = self.model.inverse_masses.iter();
                for ((v, mean), w) in velocities.iter_mut().zip(means).zip(masses) {
                    *v += (t - before) * mean * w;
                    fastest = fastest.max(v.abs());
                }
            }
            last = Some((t, forces));
            for support in &structure.supports {
                let [u, v, _] = support.motion.at(t);
                let gaps = support.gaps.iter();
                let factor = gaps.fold(0.0_f64, |most, gap| most.max(gap.abs()));
                moved = [
                    moved[0].max(factor * u.abs()),
                    moved[1].max(factor * v.abs()),
                ];
            }
        }
        let [u, v] = [SHORT * SHORT * length * fastest, SHORT * fastest];
        self.least = [u.max(SHORT * SHORT * moved[0]), v.max(SHORT * moved[1])];
    }

    /// Times at which the equations are not smooth.
    pub fn points(&self) -> &[f64] {
        &self.model.points
    }

    /// A time of the present part: at its end, the one before.
    pub(crate) fn inside(&self, t: f64) -> f64 {
        match t >= self.part[1] {
            true => self.part[1].next_down(),
            false => t,
        }
    }

    /// A limit that changes, for forces: without its rate.
    pub(crate) fn limit(&self, contact: usize, t: f64, y: &[f64]) -> Option<LimitAt> {
        let limit = self.model.structure.contacts[contact].law.limit()?;
        if limit.varying.is_none() && limit.pressed_by.is_none() {
            return None;
        }
        Some(LimitAt {
            value: self.limit_value(limit, self.inside(t), y),
            rate: 0.0,
        })
    }

    /// The same with its rate.
    pub(crate) fn moving_limit(&self, contact: usize, t: f64, y: &[f64]) -> Option<LimitAt> {
        let limit = self.limit(contact, t, y)?;
        Some(LimitAt {
            rate: self.limit_rate(contact, self.inside(t), y),
            ..limit
        })
    }

    /// r and rdot of a contact.
    pub(crate) fn relative(&self, contact: usize, t: f64, y: &[f64]) -> [f64; 2] {
        let n = self.model.len();
        let column = &self.model.columns[contact];
        let structure = self.model.structure;
        let [gap, of_gap] = moved_gap(structure, contact, t);
        [
            column.dot(&y[..n]) + structure.contacts[contact].gap + gap,
            column.dot(&y[n..2 * n]) + of_gap,
        ]
    }

    /// The same with the sizes of their terms.
    pub(crate) fn motion(&self, contact: usize, t: f64, y: &[f64]) -> Motion {
        let n = self.model.len();
        let column = &self.model.columns[contact];
        let structure = self.model.structure;
        let of_supports = structure.supports.iter();
        let [mut u, mut v] = [column.size(&y[..n]), column.size(&y[n..2 * n])];
        for support in of_supports {
            let motion = support.motion.at(t);
            u += (support.gaps[contact] * motion[0]).abs();
            v += (support.gaps[contact] * motion[1]).abs();
        }
        Motion {
            values: self.relative(contact, t, y),
            sizes: [u + structure.contacts[contact].gap.abs(), v],
        }
    }

    /// The contacts in a plane, with their first rows.
    pub(crate) fn planes(&self) -> impl Iterator<Item = (usize, &PlaneContact)> {
        let planes = self.planes.iter().enumerate();
        planes.filter_map(|(first, plane)| Some((first, plane.as_ref()?)))
    }

    /// A contact in a plane at a time; `held` is the force that a rigid one needs to stick.
    pub(crate) fn in_plane(&self, first: usize, t: f64, y: &[f64], held: Pair) -> PlaneState {
        let [a, b] = [first, first + 1].map(|row| self.relative(row, t, y));
        PlaneState {
            t,
            r: [a[0], b[0]],
            rdot: [a[1], b[1]],
            z: self.places[first].map_or([0.0; 2], |index| [y[index], y[index + 1]]),
            held,
        }
    }

    /// M a without contacts, and the forces of all contacts; of rigid ones in a plane also those that would hold them.
    pub(crate) fn sums(&self, t: f64, y: &[f64], a: &mut [f64]) -> [Vec<f64>; 2] {
        let n = self.model.len();
        a.fill(0.0);
        self.model.stiffness.subtract_product(1.0, &y[..n], a);
        self.model.damping.subtract_product(1.0, &y[n..2 * n], a);
        let loads = self.model.structure.loads.iter();
        for (load, pattern) in loads.zip(&self.model.patterns) {
            pattern.add(load.signal.at(self.inside(t)), a);
        }
        let mut forces = vec![0.0; self.contacts.len()];
        let mut held = forces.clone();
        let laws = self
            .model
            .structure
            .contacts
            .iter()
            .map(|contact| &contact.law);
        for (i, (plane, law)) in self.planes.iter().zip(laws).enumerate() {
            match plane {
                _ if law.row().is_none() => forces[i] = self.force(i, t, y),
                Some(plane) if plane.phase.is_none() => {
                    let state = self.in_plane(i, t, y, [0.0; 2]);
                    let plane_forces = plane.force(&state, self.limit(i, t, y));
                    forces[i..i + 2].copy_from_slice(&plane_forces);
                }
                _ => {}
            }
        }
        if self.planes().any(|(_, plane)| plane.phase.is_some()) {
            self.hold(t, y, a, [&mut forces, &mut held]);
        }
        [forces, held]
    }
}

/// What supports that move add to a gap and to its rate.
pub(crate) fn moved_gap(structure: &Structure, contact: usize, t: f64) -> [f64; 2] {
    let mut sum = [0.0; 2];
    for support in &structure.supports {
        let [u, v, _] = support.motion.at(t);
        sum[0] += support.gaps[contact] * u;
        sum[1] += support.gaps[contact] * v;
    }
    sum
}
