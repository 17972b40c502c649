//! The warnings of a case of structures.

mod at_start;
mod between_steps;
mod directions;
mod doubt;
mod doubts;
mod long_step;
mod masses;
mod matrices;
mod never_slides;
mod restitution;
mod twice;
mod unheld;
mod unlikely;
mod unused;
mod weight;

use super::channels::channel::{Number, Quantity};
use super::given::shape::Scaled;
use super::given::source::Kind;
use super::metrics::metric::StructureMetric;
use super::metrics::reduction::Reduction;
use super::model::contact_duration::has_short_contact;
use super::motions::metric_values;
use super::motions::motion::{self, Recording};
use super::motions::recorded::{Recorded, distinct};
use super::motions::sweep::Ready;
use super::parts::contact::Normal;
use super::prepared::StructureProblem;
use crate::contact::ContactKind;
use crate::problem::Case;
use crate::solve::structure::{Watched, WatchedContact};
use crate::solve::{Unsolvable, Warning, Warnings};
use crate::system::loads::STANDARD_GRAVITY;
use crate::system::structure::{Contact, Signal, StructureLaw};

pub use restitution::{Restitution, restitutions};

/// Share of the largest energy that a contact may make.
const GAIN: f64 = 0.01;

/// Peaks of a record in g, beyond which its unit is wrong.
const PEAKS: [f64; 2] = [1e-4, 2.0];

/// Share of the motion away from each other by which two bodies that collide do not overlap.
const DEEP: f64 = 0.5;

/// Steps in a row in which a force must turn back, and the share of its peak by which it must, to alternate.
const TURNS: usize = 6;
const TURN: f64 = 0.01;

impl StructureProblem {
    /// The warnings of a case with these quantities.
    pub(super) fn warnings_of(
        &self,
        ready: &Ready,
        computed: &Recorded,
        watched: Option<&Watched>,
    ) -> Result<Warnings, Unsolvable> {
        let structure = &ready.structure;
        let watched_contacts = watched.map_or(&[][..], |watched| &watched.contacts);
        let contacts = || structure.contacts.iter().zip(watched_contacts);
        let mut impacts =
            contacts().filter(|(contact, _)| contact.law.kind() == ContactKind::Impact);
        let touches = |(_, seen): (&Contact, &WatchedContact)| seen.force < 0.0;
        let some = impacts.clone().next().is_some();
        let overlaps = |(contact, seen): (&Contact, &WatchedContact)| {
            !self.template.units.is_empty()
                && contact.law.kind() == ContactKind::Impact
                && contact.gap > 0.0
                && -seen.displacement > contact.gap
                && -seen.displacement > DEEP * (seen.opening - contact.gap)
                && !yields(&contact.law)
        };
        let doubts = self
            .doubts_of(&ready.case, structure, &ready.numbering)
            .iter()
            .fold(Warnings::NONE, |set, doubt| set.with(doubt.0, true));
        let given = match watched {
            Some(watched) => unused::with(doubts, &self.template, ready, watched),
            None => doubts,
        };
        Ok(given
            .with(Warning::DeepOverlap, contacts().any(overlaps))
            .with(
                Warning::NeverSlides,
                never_slides::has_stuck(&self.template, ready, watched),
            )
            .with(
                Warning::ShortContact,
                has_short_contact(structure, watched, ready.dt),
            )
            .with(Warning::ContactGain, self.gains(ready, watched)?)
            .with(
                Warning::AlternatingForce,
                self.force_alternates(ready, computed),
            )
            .with(
                Warning::Runaway,
                watched.is_some_and(|watched| watched.runs_away),
            )
            .with(Warning::UnheldPart, unheld::has_idle_part(structure))
            .with(Warning::RecordPeak, self.has_strange_record(&ready.case))
            .with(Warning::NoContact, some && !impacts.any(touches)))
    }

    /// Whether a contact makes more than 1 % of the largest energy.
    fn gains(&self, ready: &Ready, watched: Option<&Watched>) -> Result<bool, Unsolvable> {
        let gains = |watched: &Watched| {
            let most = -GAIN * watched.energy;
            let mut contacts = watched.contacts.iter();
            contacts.any(|contact| contact.work + watched.stored < most)
        };
        // The energy between the steps that were looked at can only be larger. The few cases left are looked at again.
        if !watched.is_some_and(gains) {
            return Ok(false);
        }
        let recording = Recording {
            last: ready.last,
            numbers: &[],
            energy: false,
            watch: Some(1),
        };
        let prepared = motion::prepare(&ready.structure, &ready.method, ready.dt)?;
        let [run] = motion::steps(&[&ready.structure], &prepared, recording);
        Ok(run?.2.as_ref().is_some_and(gains))
    }

    /// Whether a metric is of the force of a friction contact that resists velocity, and this force alternates.
    fn force_alternates(&self, ready: &Ready, computed: &Recorded) -> bool {
        let contacts = &ready.structure.contacts;
        let of_force = |metric: &&StructureMetric| {
            !matches!(
                metric.reduction,
                Reduction::Work
                    | Reduction::OpenTime
                    | Reduction::Restitution
                    | Reduction::ImpactsBeforeDivergence
            )
        };
        let metrics = self.metrics.iter().filter(of_force);
        let numbers =
            metrics.flat_map(|m| metric_values::needed(m, &ready.numbering, contacts.len()));
        let mut forces = distinct(numbers).into_iter().filter(|number| match number {
            Number::Contact(contact, Quantity::Force) => resists_velocity(&contacts[*contact].law),
            Number::Displacement(_)
            | Number::Velocity(_)
            | Number::Acceleration(_)
            | Number::Contact(..)
            | Number::Derived(_)
            | Number::Energy(_) => false,
        });
        forces.any(|force| alternates(computed.of(force)))
    }

    /// Whether a record has a peak that no earthquake has.
    fn has_strange_record(&self, case: &Case) -> bool {
        let template = &self.template;
        // A study without units may be dimensionless, and a note says how it is read.
        if template.units.is_empty() {
            return false;
        }
        let vertical = template
            .contacts
            .iter()
            .filter_map(|contact| match &contact.normal {
                Some(Normal::Weight { vertical, .. }) => Some(vertical),
                _ => None,
            });
        let gravity = STANDARD_GRAVITY / template.metre;
        let strange = |record: &Scaled| {
            let kind = record.source.kind();
            if !matches!(kind, Kind::Record { .. } | Kind::Synthetic { .. }) {
                return false;
            }
            let Ok((signal, scale)) = record.in_case(case, template.metre) else {
                return false;
            };
            let Signal::Table(table) = &*signal else {
                return false;
            };
            let values = table.values().iter();
            let peak = values.fold(0.0, |peak: f64, a| peak.max(a.abs())) * scale.abs() / gravity;
            scale != 0.0 && !(PEAKS[0]..=PEAKS[1]).contains(&peak)
        };
        let ground = template.ground.iter().map(|(_, ground)| ground);
        let supports = template
            .supports
            .iter()
            .filter_map(|support| support.acceleration());
        ground.chain(supports).chain(vertical).any(strange)
    }
}

/// Whether an impact law has a largest force: what lies behind the gap may give way by more than the gap.
fn yields(law: &StructureLaw) -> bool {
    law.kind() == ContactKind::Impact && !law.as_given().properties().has_rigid_form()
}

/// Whether a law of friction or of a damper without elastic displacement: its force may jump from step to step.
fn resists_velocity(law: &StructureLaw) -> bool {
    law.row().is_none() && law.as_given().of_velocity()
}

/// Whether a force turns back at each of some steps in a row, by more than a share of its peak.
fn alternates(force: &[f64]) -> bool {
    let peak = force.iter().fold(0.0, |peak: f64, s| peak.max(s.abs()));
    let mut turns = 0;
    force.windows(3).any(|s| {
        let [before, after] = [s[1] - s[0], s[2] - s[1]];
        let turns_back = before * after < 0.0 && before.abs().min(after.abs()) > TURN * peak;
        turns = if turns_back { turns + 1 } else { 0 };
        turns >= TURNS
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_force_alternates_if_it_turns_back_at_many_steps_in_a_row() {
        let sign = |i: usize| if i.is_multiple_of(2) { 1.0 } else { -1.0 };
        let ripple = |size: f64| -> Vec<f64> { (0..40).map(|i| 1.0 + size * sign(i)).collect() };
        // The change is twice the size, the peak 1 + size.
        assert!(alternates(&ripple(0.006)) && !alternates(&ripple(0.004)));
        assert!(!alternates(&ripple(0.5)[..7]) && alternates(&ripple(0.5)[..8]));
        // Four steps in a period are resolved.
        let sine: Vec<f64> = (0..40).map(|i| [0.0, 1.0, 0.0, -1.0][i % 4]).collect();
        assert!(!alternates(&sine) && !alternates(&[]));
    }
}
