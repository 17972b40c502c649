//! The places of the parts of a scheme from left to right.

use super::super::part::has_places;
use super::super::symbols;
use super::join::Join;
use super::reach::reach;
use super::relations::Relations;
use super::sizes::{Sizes, interval};
use slipgap_problem::problem::structure::described::scheme::picture::Scheme;

/// Distance of parts in a row that nothing joins.
const APART: f64 = 18.0;
/// Rounds in which bars become longer until the masses below have room.
const ROUNDS: usize = 20;

/// Sizes of the parts, and the left edge of each.
pub fn place(scheme: &Scheme, relations: &Relations) -> (Sizes, Vec<f64>) {
    let mut longer = vec![0.0; scheme.parts.len()];
    for round in 0.. {
        let mut columns = Columns::new(scheme, relations, &longer);
        columns.first();
        let overlap = columns.carriers(round == ROUNDS);
        if overlap <= 0.0 || round == ROUNDS {
            return (columns.sizes, columns.left);
        }
        for (part, by) in scheme.parts.iter().zip(&mut longer) {
            *by += if part.elements.is_some() {
                overlap
            } else {
                0.0
            };
        }
    }
    (Sizes::of(scheme, relations, &longer), longer)
}

/// Parts above one another.
struct Columns<'a> {
    scheme: &'a Scheme,
    relations: &'a Relations,
    sizes: Sizes,
    left: Vec<f64>,
    /// The column of each part, by its first part.
    of: Vec<usize>,
}

impl<'a> Columns<'a> {
    fn new(scheme: &'a Scheme, relations: &'a Relations, longer: &[f64]) -> Columns<'a> {
        let sizes = Sizes::of(scheme, relations, longer);
        let count = scheme.parts.len();
        let mut columns = Columns {
            scheme,
            relations,
            sizes,
            left: vec![0.0; count],
            of: (0..count).collect(),
        };
        let is_mass = |part: usize| scheme.parts[part].elements.is_none();
        for join in &relations.joins {
            if let Join::Above(Some(lower), upper) = *join
                && is_mass(lower)
                && is_mass(upper)
            {
                columns.merge(lower, upper);
            }
        }
        for part in 0..count {
            let members = columns.members(columns.of[part]).into_iter();
            let alike = |other: &usize| *other == part || !has_places(&scheme.parts[*other]);
            let widths = members.filter(alike).map(|part| columns.sizes.width[part]);
            let widest = widths.fold(0.0, f64::max);
            columns.sizes.width[part] = widest;
        }
        columns
    }

    /// Joins two columns that have no row in common.
    fn merge(&mut self, a: usize, b: usize) {
        let (a, b) = (self.of[a].min(self.of[b]), self.of[a].max(self.of[b]));
        let rows = |column| -> Vec<usize> {
            let members = self.members(column).into_iter();
            members.map(|part| self.relations.rows[part]).collect()
        };
        let (rows_of_a, other) = (rows(a), rows(b));
        if a != b && rows_of_a.iter().all(|row| !other.contains(row)) {
            self.of
                .iter_mut()
                .filter(|column| **column == b)
                .for_each(|column| *column = a);
        }
    }

    fn members(&self, column: usize) -> Vec<usize> {
        (0..self.of.len())
            .filter(|part| self.of[*part] == column)
            .collect()
    }

    /// Links between a mass of a column and bars.
    fn to_bars(&self, column: usize) -> Vec<usize> {
        let is_bar = |part: usize| self.scheme.parts[part].elements.is_some();
        let of_it = |l: &usize| match self.relations.joins[*l] {
            Join::Above(Some(lower), upper) => {
                is_bar(upper) && self.of[lower] == column && !is_bar(lower)
                    || is_bar(lower) && self.of[upper] == column && !is_bar(upper)
            }
            Join::Beside(_) | Join::Above(..) | Join::Over(..) => false,
        };
        (0..self.scheme.links.len()).filter(of_it).collect()
    }

    /// Least distance of two parts of a row.
    fn distance(&self, a: usize, b: usize) -> f64 {
        let links = self.scheme.links.iter().zip(&self.relations.joins);
        let between = links.filter(|(_, join)| **join == Join::Beside([Some(a), Some(b)]));
        let joined = interval(between.map(|(link, _)| link));
        match joined > 0.0 {
            true => joined,
            false => {
                APART
                    + reach(self.scheme, self.relations, a, 1)
                    + reach(self.scheme, self.relations, b, 0)
            }
        }
    }

    /// The columns in order: each after those left of it, then as in the study.
    fn order(&self, columns: &[usize]) -> Vec<usize> {
        let mut rest = columns.to_vec();
        let mut order = Vec::new();
        while !rest.is_empty() {
            let waits = |column: usize| {
                let mut joins = self.relations.joins.iter();
                joins.any(|join| match *join {
                    Join::Beside([Some(a), Some(b)]) => {
                        self.of[b] == column && self.of[a] != column && rest.contains(&self.of[a])
                    }
                    Join::Beside(_) | Join::Above(..) | Join::Over(..) => false,
                })
            };
            // In a circle, the first one.
            let next = rest.iter().position(|column| !waits(*column)).unwrap_or(0);
            order.push(rest.remove(next));
        }
        order
    }

    /// Places the columns that no bar gives a place, group by group.
    fn first(&mut self) {
        let mut start = 0.0;
        let count = self.scheme.parts.len();
        let groups: Vec<usize> = (0..count)
            .filter(|i| self.relations.groups[*i] == *i)
            .collect();
        for group in groups {
            let columns =
                (0..count).filter(|i| self.of[*i] == *i && self.relations.groups[*i] == group);
            let of_group: Vec<usize> = columns.collect();
            let without_bars: Vec<usize> = of_group
                .iter()
                .copied()
                .filter(|c| self.to_bars(*c).is_empty())
                .collect();
            // The last part of each row.
            let mut last: Vec<Option<usize>> = vec![None; count + 1];
            for column in self.order(&without_bars) {
                let members = self.members(column);
                let middle = members.iter().map(|part| {
                    let before = match last[self.relations.rows[*part]] {
                        Some(other) => {
                            self.left[other] + self.sizes.width[other] + self.distance(other, *part)
                        }
                        None => start + reach(self.scheme, self.relations, *part, 0),
                    };
                    before + self.sizes.width[*part] / 2.0
                });
                let middle = middle.fold(f64::NEG_INFINITY, f64::max);
                for part in members {
                    self.left[part] = middle - self.sizes.width[part] / 2.0;
                    last[self.relations.rows[part]] = Some(part);
                }
            }
            let parts = (0..count).filter(|i| self.relations.groups[*i] == group);
            let edge = |i: usize| {
                self.left[i] + self.sizes.width[i] + reach(self.scheme, self.relations, i, 1)
            };
            // Masses below the ends of bars may be farther out.
            let below = if without_bars.len() < of_group.len() {
                60.0
            } else {
                0.0
            };
            start = parts.map(edge).fold(start, f64::max) + APART + below;
        }
    }

    /// Places the columns under and over bars: each in the middle of its links. The largest overlap of two of them; `push` moves
    /// them apart.
    fn carriers(&mut self, push: bool) -> f64 {
        let count = self.scheme.parts.len();
        let mut placed = Vec::new();
        for column in (0..count).filter(|i| self.of[*i] == *i) {
            let mut places: Vec<[f64; 2]> = Vec::new();
            for l in self.to_bars(column) {
                if let Some(slot) = self.sizes.slots[l] {
                    let x = self.left[slot.of] + self.sizes.offset(slot);
                    let half = symbols::across(self.scheme.links[l].kind) / 2.0 + 3.0;
                    places.push([x - half, x + half]);
                }
            }
            if places.is_empty() {
                continue;
            }
            let low = places
                .iter()
                .map(|span| span[0])
                .fold(f64::INFINITY, f64::min);
            let high = places
                .iter()
                .map(|span| span[1])
                .fold(f64::NEG_INFINITY, f64::max);
            for part in self.members(column) {
                let width = self.sizes.width[part].max(high - low);
                self.sizes.width[part] = width;
                self.left[part] = (low + high - width) / 2.0;
            }
            placed.push(column);
        }
        placed.sort_by(|a, b| self.left[*a].total_cmp(&self.left[*b]));
        let mut largest = 0.0_f64;
        let rest = (0..count).filter(|i| self.of[*i] == *i && !placed.contains(i));
        let mut before: Vec<usize> = rest.collect();
        for column in placed {
            // Past one column it may overlap the next one.
            for _ in 0..=before.len() {
                let overlap = self.overlap(column, &before);
                largest = largest.max(overlap);
                if !push || overlap <= 0.0 {
                    break;
                }
                for moved in self.members(column) {
                    self.left[moved] += overlap;
                }
            }
            before.push(column);
        }
        largest
    }

    /// How far right a column must move for one of the others; 0 if it overlaps none.
    fn overlap(&self, column: usize, others: &[usize]) -> f64 {
        let others: Vec<usize> = others
            .iter()
            .flat_map(|other| self.members(*other))
            .collect();
        let mut largest = 0.0_f64;
        for part in self.members(column) {
            for other in others.iter().copied() {
                let right = |i: usize| self.left[i] + self.sizes.width[i];
                let same_row = self.relations.rows[part] == self.relations.rows[other];
                let clear = right(part) + self.distance(part, other) <= self.left[other];
                if same_row && !clear {
                    let free = right(other) + self.distance(other, part);
                    largest = largest.max(free - self.left[part]);
                }
            }
        }
        largest
    }
}
