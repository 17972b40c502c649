//! The parts of a structure that nothing holds.

use super::initial::{join, root};
use super::{Contact, Signal, Structure};
use crate::contact::ContactKind;
use std::collections::BTreeMap;

/// Share of the forces on a part that their sum must have.
const SUM: f64 = 1e-12;

/// Both directions of a part: that of rising and that of falling displacements.
const BOTH: [f64; 2] = [1.0, -1.0];

/// A contact that pushes or pulls parts in one direction only.
struct OneSided {
    /// Sign of its force S.
    sign: f64,
    /// Its parts with the change of r when they move by 1, which is not 0.
    parts: Vec<(usize, f64)>,
}

impl Structure {
    /// The parts that nothing holds, by their nodes: neither springs nor contacts that are elastic, friction or pressed at t = 0 connect
    /// them with the ground; nor do contacts that push or pull in one direction together with others or with loads that last.
    pub fn unheld_nodes(&self) -> Vec<Vec<usize>> {
        let size = self.len();
        let mut part = self.parts();
        let mut held = vec![0.0; size];
        let mut diagonal = vec![0.0; size];
        // A spring to the ground is what is left of the sum of a row of K.
        for ((i, j), k) in self.stiffness.entries() {
            held[i] += k;
            if i != j {
                held[j] += k;
            } else {
                diagonal[i] = k;
            }
        }
        let mut grounded: Vec<bool> = held
            .iter()
            .zip(&diagonal)
            .map(|(held, diagonal)| held.abs() > 1e-12 * diagonal.max(f64::MIN_POSITIVE))
            .collect();
        let pressed = |contact: usize| {
            self.preload
                .force(contact)
                .is_some_and(|force| force != 0.0)
        };
        let contacts = self.contacts.iter().enumerate();
        let holding = contacts.filter(|(index, contact)| contact.holds() || pressed(*index));
        for (_, contact) in holding {
            let Some((first, others)) = contact.along.split_first() else {
                continue;
            };
            others
                .iter()
                .for_each(|(node, _)| join(&mut part, first.0, *node));
            // Equal displacements of all its nodes change r.
            let sum: f64 = contact.along.iter().map(|(_, factor)| factor).sum();
            grounded[first.0] |= sum != 0.0;
        }
        let part: Vec<usize> = (0..size).map(|i| root(&part, i)).collect();
        let mut is_held = vec![false; size];
        for (part, grounded) in part.iter().zip(grounded) {
            is_held[*part] |= grounded;
        }
        let mut members: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for (i, part) in part.iter().enumerate().filter(|(_, part)| !is_held[**part]) {
            members.entry(*part).or_default().push(i);
        }
        if members.is_empty() {
            return Vec::new();
        }
        let stopped = self.stopped(&part, &is_held);
        // A node between contacts in series is where they have it.
        let is_between = self.chain_nodes();
        let free = members.into_iter().filter(|(part, members)| {
            stopped[*part] != [true; 2] && !members.iter().all(|i| is_between[*i])
        });
        free.map(|(_, members)| members).collect()
    }

    /// In which of [`BOTH`] directions each part cannot move on: a load that lasts acts against it, or a contact that it closes, with
    /// parts behind it that cannot move on either.
    fn stopped(&self, part: &[usize], is_held: &[bool]) -> Vec<[bool; 2]> {
        let pushed = self.lasting_loads(part);
        let mut stopped: Vec<[bool; 2]> = is_held
            .iter()
            .zip(&pushed)
            .map(|(is_held, push)| BOTH.map(|direction| *is_held || direction * push < 0.0))
            .collect();
        let contacts: Vec<OneSided> = self
            .contacts
            .iter()
            .flat_map(|contact| one_sided(contact, part))
            .collect();
        loop {
            let mut is_new = false;
            for contact in &contacts {
                for (moved_part, factor) in &contact.parts {
                    let others = contact
                        .parts
                        .iter()
                        .filter(|(other, _)| other != moved_part);
                    // The force on a part is -S times its factor.
                    let direction = |factor: f64| usize::from(contact.sign * factor > 0.0);
                    let moved = 1 - direction(*factor);
                    let mut others = others.map(|(other, factor)| (*other, direction(*factor)));
                    if !stopped[*moved_part][moved] && others.all(|(other, to)| stopped[other][to])
                    {
                        stopped[*moved_part][moved] = true;
                        is_new = true;
                    }
                }
            }
            if !is_new {
                return stopped;
            }
        }
    }

    /// The sum of the loads on each part that never change their sign and do not end.
    fn lasting_loads(&self, part: &[usize]) -> Vec<f64> {
        let mut sums = vec![[0.0_f64; 2]; part.len()];
        for load in &self.loads {
            let last = lasting(&load.signal);
            for (node, factor) in load.pattern.iter().filter(|_| last != 0.0) {
                let [sum, size] = &mut sums[part[*node]];
                *sum += factor * last;
                *size += (factor * last).abs();
            }
        }
        let sums = sums.into_iter();
        sums.map(|[sum, size]| if sum.abs() > SUM * size { sum } else { 0.0 })
            .collect()
    }

    /// Their names.
    pub fn unheld_parts(&self) -> Vec<String> {
        let name = |i: &usize| self.nodes[*i].name.as_str();
        let free = self.unheld_nodes().into_iter();
        let names = free.filter_map(|members| match members[..] {
            [one] => Some(name(&one).to_owned()),
            [one, .., last] => Some(format!("{} to {}", name(&one), name(&last))),
            [] => None,
        });
        names.collect()
    }
}

/// The last value of a table of one sign; 0 of other signals.
fn lasting(signal: &Signal) -> f64 {
    match signal {
        Signal::Table(table) => {
            let values = table.values();
            let last = values.last().copied().unwrap_or_default();
            let is_one_sided = values.iter().all(|value| value * last >= 0.0);
            if is_one_sided { last } else { 0.0 }
        }
        Signal::Sine { .. } | Signal::Motion(..) => 0.0,
    }
}

/// A contact without stiffness at rest, for each sign of its force: an impact pushes, and a link may pull or push behind its slack.
fn one_sided(contact: &Contact, part: &[usize]) -> Vec<OneSided> {
    let law = contact.law.as_given();
    let [low, high] = match contact.law.kind() {
        ContactKind::Impact => [true, false],
        ContactKind::Link if !law.of_velocity() => {
            let [low, high] = law.properties().bounds();
            [low < 0.0, high > 0.0]
        }
        ContactKind::Link | ContactKind::Friction => [false; 2],
    };
    let mut parts: BTreeMap<usize, f64> = BTreeMap::new();
    for (node, factor) in &contact.along {
        *parts.entry(part[*node]).or_default() += factor;
    }
    let parts: Vec<(usize, f64)> = parts.into_iter().filter(|entry| entry.1 != 0.0).collect();
    let signs = [(low, -1.0), (high, 1.0)].into_iter();
    signs
        .filter(|(acts, _)| *acts)
        .map(|(_, sign)| OneSided {
            sign,
            parts: parts.clone(),
        })
        .collect()
}
