//! The displacements by which the scene of a structure moves, and its contacts.

use crate::animate::film::contact_history::Contact;
use crate::animate::film::short_numbers::peak;
use slipgap_motion::history::History;
use slipgap_problem::problem::structure::described::scheme::picture::LinkKind;
use std::borrow::Cow;
use std::collections::HashMap;

/// Most pieces of a bar with colours of their own.
const PIECES: u32 = 20;

/// The displacements that a scene uses.
pub struct Motion<'a> {
    /// The motion.
    pub history: &'a History,
    /// The columns of the history by name.
    pub columns: HashMap<String, usize>,
    /// Their channels of the history.
    pub moves: Vec<usize>,
    /// Axial forces of pieces of bars.
    pub stresses: Vec<Vec<f64>>,
}

impl<'a> Motion<'a> {
    /// The column of this name.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns.get(name).copied()
    }

    /// The place of a column among the displacements.
    pub fn add(&mut self, column: usize) -> usize {
        let known = self
            .moves
            .iter()
            .position(|known_column| *known_column == column);
        known.unwrap_or_else(|| {
            self.moves.push(column);
            self.moves.len() - 1
        })
    }

    /// The displacement of a node or a support; `None` if the history has none.
    pub fn of(&mut self, node: &str) -> Option<usize> {
        let column = self.column(&format!("{node}.u"))?;
        Some(self.add(column))
    }

    /// The values of a column; none without it.
    pub fn values(&self, name: &str) -> &'a [f64] {
        let column = self.column(name);
        column.map_or(&[], |column| self.history.channel(column))
    }

    /// A contact or another link.
    pub fn contact(&self, kind: LinkKind, name: &str, limits: &[Option<Vec<f64>>]) -> Contact<'a> {
        let force = Cow::Borrowed(self.values(&format!("{name}.S")));
        // Limits are in the order of the contacts in the columns.
        let force_column = self.column(&format!("{name}.S"));
        let mut forces: Vec<usize> = self
            .columns
            .iter()
            .filter(|(name, _)| name.ends_with(".S"))
            .map(|(_, column)| *column)
            .collect();
        forces.sort_unstable();
        let number =
            force_column.and_then(|wanted| forces.iter().position(|column| *column == wanted));
        let limit = number.and_then(|number| limits.get(number)?.as_deref());
        match kind {
            LinkKind::Impact => Contact::impact(name, force),
            LinkKind::Friction => {
                let rate = self.values(&format!("{name}.rdot"));
                Contact::friction(name, force, rate, limit)
            }
            LinkKind::Spring { .. } => Contact::link(name, force),
        }
    }

    /// Axial forces of the pieces of a bar: differences of displacements over the largest one.
    pub fn stresses(&mut self, bar: &str, elements: u32) -> Vec<usize> {
        let pieces = elements.min(PIECES);
        let nodes: Vec<&[f64]> = (0..=pieces)
            .map(|piece| {
                let node = node_of_bar(bar, elements, elements * piece / pieces);
                self.values(&format!("{node}.u"))
            })
            .collect();
        let mut differences: Vec<Vec<f64>> = Vec::new();
        for (piece, pair) in nodes.windows(2).enumerate() {
            let count = |piece: u32| elements * piece / pieces;
            let length = count(piece as u32 + 1) - count(piece as u32);
            let both = pair[0].iter().zip(pair[1]);
            differences.push(both.map(|(a, b)| (b - a) / f64::from(length)).collect());
        }
        let largest = differences
            .iter()
            .map(|values| peak(values))
            .fold(0.0, f64::max);
        if largest == 0.0 {
            return Vec::new();
        }
        let first = self.stresses.len();
        for mut values in differences {
            values.iter_mut().for_each(|x| *x /= largest);
            self.stresses.push(values);
        }
        (first..self.stresses.len()).collect()
    }
}

/// The name of node `i` of a bar.
pub fn node_of_bar(bar: &str, elements: u32, i: u32) -> String {
    match i {
        0 => format!("{bar}.left"),
        i if i == elements => format!("{bar}.right"),
        i => format!("{bar}.{i}"),
    }
}
