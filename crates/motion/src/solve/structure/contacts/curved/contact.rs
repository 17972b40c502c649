//! A contact with a law that is not a clipped line, over a step.

use super::plane::Plane;
use super::step::{Motion, ROUND_OFF, Scale, line, trial};
use crate::contact::plane::PlaneMemory;
use crate::contact::{AnyRunningLaw, ContactKind, ContactLaw, ContactResponse, Trial, WhichLaw};
use crate::lane::Lane;
use crate::solve::structure::contacts::static_in_plane::Admissible;
use crate::system::structure::{PlaneRow, Structure, StructureLaw};

/// A contact.
#[derive(Debug, Clone)]
pub(crate) struct Contact {
    pub(crate) relation: StructureLaw,
    /// The law with its memory: the answer with the flexibility a, and the law itself, without flexibility.
    pub(crate) law: AnyRunningLaw<1>,
    /// Its numbers, with the present limit.
    pub(crate) now: ContactLaw,
    /// a.
    pub(crate) own: f64,
    pub(crate) scale: Scale,
    /// 1/f' of a clipped line.
    pub(crate) line: Option<f64>,
    pub(crate) bounds: [f64; 2],
    /// Whether they are those of Coulomb friction with two limits, and not those of the law.
    pub(crate) two_limits: bool,
    /// The motion over the step without the forces at its end.
    pub(crate) motion: Motion,
    /// The largest sizes of the terms of r and rdot so far.
    pub(crate) terms: [f64; 2],
    /// r at the end of the step, and its change.
    pub(crate) displacement: f64,
    pub(crate) change: f64,
    /// The law's answer to the last step.
    pub(crate) answered: f64,
    /// The mean rdot of the step before, if three points give rdot'.
    pub(crate) before: Option<f64>,
    /// The law of both directions of a contact in a plane, beside the first one.
    pub(crate) plane: Option<Plane>,
}

/// What the law of a contact remembers, also of a contact in a plane, and its mean rdot over the last step.
pub(crate) type Memory = (AnyRunningLaw<1>, Option<PlaneMemory>, Option<f64>);

/// Whether a structure has a contact with a curved law, contacts in series, or contacts that follow the velocity of nodes without mass.
pub(crate) fn has_curved(structure: &Structure) -> bool {
    let mut contacts = structure.contacts.iter();
    contacts.any(|contact| contact.law.is_curved())
        || !structure.chains().is_empty()
        || structure.has_massless_dampers()
}

/// Whether three points give rdot' of a contact at a node without mass: of laws that are smooth in it. Others know only its sign, which
/// must be that of r' - r.
pub(crate) fn has_three_points(law: &StructureLaw, scale: Scale) -> bool {
    let is_smooth = law.as_given().of_velocity() || law.kind() == ContactKind::Impact;
    scale.is_massless && !scale.is_explicit() && is_smooth && !law.is_rigid() && law.row().is_none()
}

impl Contact {
    pub(crate) fn memory(&self) -> Memory {
        let plane = self.plane.map(|plane| plane.memory);
        (self.law, plane, self.before)
    }

    /// Takes the mean rdot of the step before, from which on three points give rdot'.
    pub(crate) fn follow_from(&mut self, before: Option<f64>) {
        if before.is_some() != self.before.is_some() {
            self.scale = match before {
                Some(_) => self.scale.by_three_points(),
                None => self.scale.by_two_points(),
            };
            self.law.change(&self.now, &self.scale.steps(self.own));
            self.line = line(&self.relation, self.scale.pace);
        }
        self.before = before;
    }

    /// Takes where a force with two limits may be.
    pub(crate) fn admit(&mut self, to: Admissible) {
        match (to, &mut self.plane) {
            (Admissible::Between(bounds), _) => {
                (self.bounds, self.two_limits) = (bounds, true);
            }
            (Admissible::Disc(disc), Some(plane)) => plane.disc = Some(disc),
            (Admissible::Disc(_), None) => {}
        }
    }

    /// Takes the motion of a step.
    pub(crate) fn move_by(&mut self, motion: Motion) {
        self.take_terms(motion.terms);
        self.motion = motion;
    }

    /// Takes the sizes of the terms of r and rdot in a step.
    pub(crate) fn take_terms(&mut self, terms: [f64; 2]) {
        self.terms = [0, 1].map(|i| self.terms[i].max(terms[i]));
    }

    /// The trial with this y.
    pub(super) fn trial(&self, y: f64) -> Trial<1> {
        self.trial_of(&self.motion, y)
    }

    fn trial_of(&self, motion: &Motion, y: f64) -> Trial<1> {
        if self.scale.is_explicit() {
            return trial(motion, motion.change, y);
        }
        let rate = motion.rate + self.scale.pace * (y - motion.change);
        trial(motion, y, rate)
    }

    /// Sets the closing speed of an impact that may begin in this step.
    ///
    /// The law takes it from a trial that overlaps. Where other contacts push this one together, the trial without forces does not
    /// overlap: then it is the present closing speed, or the mean one that closes the gap in the step. So it does not depend on the
    /// forces, and the law rises.
    pub(crate) fn begin(&mut self) {
        if self.relation.kind() != ContactKind::Impact {
            return;
        }
        let motion = match self.now.properties().divides_by_closing_speed() {
            true => self.motion.without_round_off(self.terms),
            false => self.motion,
        };
        let r = motion.displacement;
        if r + motion.change < 0.0 {
            let free = self.trial_of(&motion, self.scale.free(&motion));
            ContactResponse::force(&mut self.law, 0, &free);
        } else {
            let rate = f64::min(motion.velocity, -r.max(0.0) / self.scale.dt);
            self.touch(motion, rate);
        }
    }

    /// Lets the law take its closing speed from a motion that just closes the contact at this rate.
    fn touch(&mut self, motion: Motion, rate: f64) {
        let r = motion.displacement;
        let just = match r == 0.0 {
            true => -f64::MIN_POSITIVE,
            false if r > 0.0 => -r * (1.0 + 1e-12),
            false => 0.0,
        };
        ContactResponse::force(&mut self.law, 0, &trial(&motion, just, rate));
    }

    /// The same for a contact of a chain that closes at this rate.
    pub(crate) fn begin_at(&mut self, rate: f64) {
        if self.relation.kind() == ContactKind::Impact {
            let motion = Motion {
                velocity: rate,
                ..self.motion
            };
            self.touch(motion, rate);
        }
    }

    /// The end of the step of a contact of a chain.
    pub(crate) fn end_in_chain(&mut self, change: f64, force: f64, round_off: f64) {
        let change = self.without_round_off(change, force, round_off);
        self.displacement = self.motion.displacement + change;
        self.end(change + self.own * force, force);
    }

    /// A change without force, of an impact that overlaps by round-off only: it has not begun.
    fn without_round_off(&self, change: f64, force: f64, round_off: f64) -> f64 {
        let r = self.motion.displacement;
        let is_impact = self.relation.kind() == ContactKind::Impact;
        match is_impact && force == 0.0 && (r + change).abs() <= round_off {
            true => -r,
            false => change,
        }
    }

    /// The direction of a contact in a plane.
    pub(crate) fn row(&self) -> Option<PlaneRow> {
        self.relation.row()
    }

    /// The gap that an impact has to close.
    pub(crate) fn open(&self) -> f64 {
        match self.relation.kind() {
            ContactKind::Impact => self.motion.displacement.max(0.0),
            ContactKind::Friction | ContactKind::Link => 0.0,
        }
    }

    /// S of the trial with this y. The memory changes when the step is done.
    pub(crate) fn answer(&self, y: f64) -> f64 {
        if self.two_limits {
            // What keeps rdot' = 0, within the bounds.
            let [low, high] = self.bounds;
            let rate = self.motion.rate + self.scale.pace * (y - self.motion.change);
            return (rate / (self.scale.pace * self.own)).clamp(low, high);
        }
        if self.is_open(y) {
            return 0.0;
        }
        let mut law = self.law;
        let Lane([force]) = ContactResponse::force(&mut law, 0, &self.trial(y));
        force
    }

    /// Whether this is an impact that stays open if r changes by this: it has no force then, and most are open at most steps.
    fn is_open(&self, change: f64) -> bool {
        self.relation.kind() == ContactKind::Impact
            && self.now.which() != WhichLaw::Own
            && !self.scale.is_explicit()
            && self.motion.displacement + change > 0.0
    }

    /// 1/f' where the answer to y is `force`: of the line, or of a chord over `width` to both sides of r'.
    pub(crate) fn compliance(&self, y: f64, force: f64, width: f64) -> f64 {
        if let Some(line) = self.line {
            let [low, high] = self.bounds;
            let inside = low < force && force < high;
            return if inside { line } else { f64::INFINITY };
        }
        let change = y - self.own * force;
        2.0 * width / (self.follow(change + width) - self.follow(change - width))
    }

    /// S of the trial in which r changes by this; of a contact without compliance on the side of the jump.
    pub(crate) fn follow(&self, change: f64) -> f64 {
        let trial = self.trial(change);
        if self.relation.is_rigid() {
            let [low, high] = self.bounds;
            let is_impact = self.relation.kind() == ContactKind::Impact;
            let motion = match is_impact {
                true => self.motion.displacement + change,
                false => trial.rate.0[0],
            };
            return match motion.partial_cmp(&0.0) {
                Some(std::cmp::Ordering::Less) => low,
                Some(std::cmp::Ordering::Greater) => high,
                _ => 0.0,
            };
        }
        if self.is_open(change) {
            return 0.0;
        }
        let mut law = self.law;
        let Lane([force]) = ContactResponse::force(&mut law, 1, &trial);
        force
    }

    /// S of a law with compliance whose r changes by this, at the end of the step.
    pub(crate) fn lead(&mut self, change: f64) -> f64 {
        let trial = self.trial(change);
        let Lane([force]) = ContactResponse::force(&mut self.law, 1, &trial);
        force
    }

    /// Bounds of S of a contact without compliance whose r changes by this; `None` of others, whose force follows the change.
    pub(crate) fn free_force(&self, change: f64, round_off: f64) -> Option<[f64; 2]> {
        let is_open = self.relation.kind() == ContactKind::Impact
            && self.motion.displacement + change > round_off;
        let bounds = if is_open { [0.0; 2] } else { self.bounds };
        self.relation.is_rigid().then_some(bounds)
    }

    /// The end of the step with this y, where S' is `force`.
    pub(crate) fn end(&mut self, y: f64, force: f64) {
        let mut trial = self.trial(y);
        if self.has_not_begun(y, force) {
            trial.change = Lane([-self.motion.displacement]);
        }
        let Lane([answer]) = ContactResponse::force(&mut self.law, 0, &trial);
        self.answered = answer;
        self.change = y - self.own * force;
        if has_three_points(&self.relation, self.scale) {
            self.follow_from(Some(self.change / self.scale.dt));
        }
    }

    /// Whether this is the end of an impact that overlaps by round-off only. Its closing speed would be round-off, too, and a law
    /// that divides by it would hold the contact from then on.
    fn has_not_begun(&self, y: f64, force: f64) -> bool {
        let [change, by_force] = match self.scale.is_explicit() {
            true => [self.motion.change, 0.0],
            false => [y - self.own * force, self.own * force],
        };
        let least = ROUND_OFF * self.terms[0];
        self.now.properties().divides_by_closing_speed()
            && by_force.abs() <= least
            && (self.motion.displacement + change).abs() <= least
    }

    pub(crate) fn stored_energy(&self, r: f64, s: f64) -> f64 {
        use crate::contact::StoredEnergy;
        self.relation.law(1.0).stored_energy(r, s)
    }
}
