//! A motion to show: what moves, how, and its contacts.

pub(super) mod contact_history;
pub(super) mod scene;
pub(super) mod short_numbers;
pub(super) mod thin;
pub(super) mod trace;

use contact_history::Contact;
use scene::Scene;
use serde_json::{Value, json};
use short_numbers::{differences, peak};
use std::borrow::Cow;
use thin::Row;

/// A motion to show.
#[derive(Debug, Default)]
pub struct Film<'a> {
    /// What it is, in words.
    pub label: String,
    /// Time step.
    pub dt: f64,
    /// Number of the last step.
    pub last: u64,
    /// The drawing at rest.
    pub scene: Scene,
    /// The steps at which the motion is known, in rising order.
    pub steps: Vec<u64>,
    /// Displacements by which the scene moves, each with one value for each of the steps, in the unit of length.
    pub moves: Vec<Cow<'a, [f64]>>,
    /// How many of them are displacements of parts; the others are distances of contacts.
    pub places: usize,
    /// Axial forces of pieces of bars, each over the largest of its bar, tension positive.
    pub stresses: Vec<Cow<'a, [f64]>>,
    /// Contacts, with values at all steps.
    pub contacts: Vec<Contact<'a>>,
    /// The first support that moves, with its acceleration at all steps.
    pub support: Option<(String, &'a [f64])>,
}

/// Parts of the largest displacement in which places are rounded; at five times the usual magnification a tenth of a pixel.
const PARTS: f64 = 2500.0;

/// Parts of the largest axial force in which these are rounded.
const SHADES: f64 = 40.0;

/// A frame is left out if nothing moves by more than this part of the largest displacement from the straight line between its
/// neighbours.
const TOLERANCE: f64 = 0.002;

/// The same for axial forces, which are colours.
const OF_COLOURS: f64 = 0.08;

/// Length of the rods between the faces of a contact and its parts.
const RODS: f64 = 4.0;

/// Steps that are looked at for thinning.
const CANDIDATES: usize = 20_000;

impl Film<'_> {
    /// Largest displacement.
    pub fn largest(&self) -> f64 {
        let places = self.moves.iter().take(self.places);
        places.map(|values| peak(values)).fold(0.0, f64::max)
    }

    /// Points of the picture for a unit of length, such that parts keep clear of each other and gaps have room; at most `most`.
    pub fn clear_factor(&self, most: f64) -> f64 {
        // Motions that pass through each other are better than none.
        let least = most / 8.0;
        let mut factor = most;
        let value = |channel: Option<usize>, i: usize| {
            channel.map_or(0.0, |channel| self.moves[channel][i])
        };
        for link in &self.scene.links {
            let Some(opening) = link.opening else {
                continue;
            };
            let [(from, a), (to, b)] = link.ends;
            let along = link.direction;
            let moved = |i: usize| {
                along[0] * (value(b.0, i) - value(a.0, i))
                    - along[1] * (value(b.1, i) - value(a.1, i))
            };
            let rest = along[0] * (to[0] - from[0]) + along[1] * (to[1] - from[1]);
            // What of the distance r is there without motion: its gap, if it has no other part.
            let gaps = (0..self.steps.len()).map(|i| self.moves[opening][i] - moved(i));
            let gap = gaps.fold(0.0, f64::max);
            let limit_of_gap = (rest - RODS) / gap;
            // A gap that has no room in a small motion either is drawn with a break.
            if gap > 0.0 && limit_of_gap >= least {
                factor = factor.min(limit_of_gap);
            }
        }
        for (distance, [left, right]) in &self.scene.distances {
            let closes = (0..self.steps.len()).map(|i| value(*left, i) - value(*right, i));
            let most = closes.fold(0.0, f64::max);
            if most > 0.0 {
                factor = factor.min(distance.max(1.0) / most);
            }
        }
        factor.max(least)
    }

    /// The film with at most `most` frames, with displacements over `largest`.
    pub fn data(&self, largest: f64, most: usize) -> Value {
        let unit = if largest > 0.0 { largest } else { 1.0 };
        let frames = self.frames(unit, most);
        let taken = |values: &[f64], parts: f64| {
            let rounded = frames.iter().map(|i| (values[*i] * parts).round() as i64);
            differences(rounded)
        };
        let moves = self.moves.iter().map(|values| {
            let values: Vec<f64> = frames.iter().map(|i| values[*i] / unit * PARTS).collect();
            differences(values.into_iter().map(|x| x.round() as i64))
        });
        let contacts = self.contacts.iter().map(Contact::data);
        json!({
            "label": self.label,
            "half": 0.5 * self.dt,
            "last": 2 * self.last,
            "scene": self.scene.data(),
            "steps": differences(frames.iter().map(|i| 2 * self.steps[*i] as i64)),
            "unit": unit / PARTS,
            "moves": moves.collect::<Vec<_>>(),
            "shades": SHADES,
            "stresses": self.stresses.iter().map(|values| taken(values, SHADES)).collect::<Vec<_>>(),
            "contacts": contacts.collect::<Vec<_>>(),
        })
    }

    /// The frames that are kept: those at which contacts change, at which displacements are largest, and as many others as the
    /// motion between them needs.
    fn frames(&self, unit: f64, most: usize) -> Vec<usize> {
        let count = self.steps.len();
        let stride = count.div_ceil(CANDIDATES).max(1);
        let mut kept = Vec::new();
        for values in self.moves.iter().take(self.places) {
            kept.extend(thin::extremes(values));
        }
        let changes = self.contacts.iter().flat_map(Contact::changes);
        let frame = |step: u64| self.steps.binary_search(&step).ok();
        let changes: Vec<usize> = changes.filter_map(frame).collect();
        // A contact that chatters has more changes than frames.
        let every = changes.len().div_ceil((most / 2).max(1)).max(1);
        kept.extend(changes.into_iter().step_by(every));
        kept.extend(
            self.contacts
                .iter()
                .filter_map(|contact| frame(contact.peak().0)),
        );
        let candidates: Vec<usize> = (0..count).step_by(stride).collect();
        let rows: Vec<Row> = self
            .moves
            .iter()
            .map(|values| (&values[..], TOLERANCE * unit))
            .chain(self.stresses.iter().map(|values| (&values[..], OF_COLOURS)))
            .collect();
        thin::thin(&self.steps, candidates, kept, &rows, most)
    }
}
