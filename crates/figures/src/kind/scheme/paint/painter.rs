//! A picture under way, and the places of its parts from top to bottom.

use super::super::arrange::join::Join;
use super::super::arrange::relations::Relations;
use super::super::arrange::sizes::Sizes;
use super::super::part::has_places;
use slipgap_drawing::layout::sheet::{Anchor, Picture, PlacedText, Rect};
use slipgap_drawing::style;
use slipgap_problem::problem::structure::described::scheme::picture::{LinkKind, Scheme};

/// Distance of rows, and of rows that only friction connects.
pub const ROWS: f64 = 32.0;
/// See `ROWS`.
const SLIDING: f64 = 15.0;
/// Height of a link over the parts of its row.
pub const OVER: f64 = 22.0;
/// A picture under way.
pub struct Painter<'a> {
    /// The scheme.
    pub scheme: &'a Scheme,
    /// Its relations.
    pub relations: &'a Relations,
    /// Its sizes.
    pub sizes: &'a Sizes,
    /// Places of the parts.
    pub rects: Vec<Rect>,
    /// Height of the ground under the lowest row.
    pub floor: f64,
    /// The middle of each vertical link from left to right.
    pub middles: Vec<Option<f64>>,
    /// Where links meet nodes between laws in series: the part, and the place.
    pub joined: Vec<(usize, [f64; 2])>,
    /// What is drawn so far.
    pub picture: Picture,
}

impl Painter<'_> {
    /// Places the rows, the highest one first.
    pub fn stack(&mut self, left: &[f64]) {
        let rows = &self.relations.rows;
        let count = self.scheme.parts.len();
        let rect = |part: usize| Rect {
            left: left[part],
            width: self.sizes.width[part],
            ..Rect::default()
        };
        self.rects = (0..count).map(rect).collect();
        let mut top = 0.0;
        for row in (0..=rows.iter().copied().max().unwrap_or(0)).rev() {
            let members: Vec<usize> = (0..count).filter(|i| rows[*i] == row).collect();
            let height = members
                .iter()
                .map(|i| self.sizes.height[*i])
                .fold(0.0, f64::max);
            let over = (0..self.scheme.links.len()).filter(|l| self.row_over(*l) == Some(row));
            top += OVER * over.count() as f64;
            let others = members
                .iter()
                .filter(|i| !has_places(&self.scheme.parts[**i]));
            let of_others = others.map(|i| self.sizes.height[*i]).fold(0.0, f64::max);
            for part in members {
                let inner = match has_places(&self.scheme.parts[part]) {
                    true => height,
                    false => of_others,
                };
                let rect = &mut self.rects[part];
                (rect.top, rect.height) = (top + (height - inner) / 2.0, inner);
            }
            let links = self.scheme.links.iter().zip(&self.relations.joins);
            let mut below = links
                .filter(|(_, join)| matches!(join, Join::Above(_, upper) if rows[*upper] == row));
            let slides = below.all(|(link, _)| link.kind == LinkKind::Friction);
            self.floor = top + height + if slides { SLIDING } else { ROWS };
            top = self.floor;
        }
    }

    /// The row that a link is drawn over, because others are between its parts.
    pub fn row_over(&self, l: usize) -> Option<usize> {
        let rows = &self.relations.rows;
        match self.relations.joins[l] {
            Join::Over(a, b) => Some(rows[a].max(rows[b])),
            Join::Beside([Some(a), Some(b)]) if !self.adjacent(a, b) => Some(rows[a]),
            Join::Beside(_) | Join::Above(..) => None,
        }
    }

    /// Whether no part is between two others.
    pub fn adjacent(&self, a: usize, b: usize) -> bool {
        let rows = &self.relations.rows;
        let right = self.rects[a].right();
        let between = |i: usize| {
            let rect = &self.rects[i];
            i != a
                && i != b
                && rows[i] == rows[a]
                && rect.left > right - 1.0
                && rect.left < self.rects[b].left
        };
        self.rects[b].left >= right - 1e-9 && !(0..self.rects.len()).any(between)
    }

    /// A word in the type of labels.
    pub fn word(&mut self, at: [f64; 2], anchor: Anchor, text: String) {
        self.picture.words.push(PlacedText {
            at,
            anchor,
            text,
            size: style::LABEL,
        });
    }
}
