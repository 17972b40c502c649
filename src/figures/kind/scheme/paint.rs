//! Draws a scheme: the places of its parts from top to bottom, and its symbols.

use super::places::{Placed, has_places};
use super::relations::{Join, Relations};
use super::sizes::{self, Sizes};
use super::{columns, ground_motion, inner, marks, symbols};
use slipgap_drawing::layout::sheet::{Anchor, Picture, PlacedText, Rect, Shape};
use slipgap_drawing::{style, text};
use slipgap_solver::problem::structure::described::scheme::picture::{LinkKind, Scheme};

/// Distance of rows, and of rows that only friction connects.
pub const ROWS: f64 = 32.0;
/// See `ROWS`.
const SLIDING: f64 = 15.0;
/// Height of a link over the parts of its row.
pub const OVER: f64 = 22.0;
/// The horizontal and the vertical axis of a structure without places: its row along X.
const ROW: [usize; 2] = [0, 2];
/// Grey of masses.
const GREY: u8 = 228;

/// The picture of a scheme with its upper left corner at 0, and its size.
pub fn paint(scheme: &Scheme) -> (Picture, [f64; 2]) {
    let (drawn, axes) = with_places(scheme, |mut painter, placed| {
        painter.parts();
        painter.links();
        painter.joints();
        painter.loads();
        if let Some(placed) = placed {
            painter.nodes(placed);
        }
        (painter.picture, placed.map_or(ROW, |placed| placed.axes))
    });
    let (mut picture, mut size) = boxed(drawn);
    if !scheme.ground.is_empty() {
        size[1] = ground_motion::draw(&mut picture, size, &scheme.ground, axes);
    }
    (picture, size)
}

/// The result of `draw` for a painter that knows the places of the parts and has drawn nothing, and the matrices with places.
pub fn with_places<T>(scheme: &Scheme, draw: impl FnOnce(Painter<'_>, Option<&Placed>) -> T) -> T {
    let placed = Placed::of(scheme);
    let scheme = placed.as_ref().map_or(scheme, |placed| &placed.outer);
    let relations = Relations::of(scheme);
    let (sizes, left) = columns::place(scheme, &relations);
    let mut painter = Painter {
        scheme,
        relations: &relations,
        sizes: &sizes,
        rects: Vec::new(),
        floor: 0.0,
        joined: Vec::new(),
        picture: Picture::default(),
    };
    painter.stack(&left);
    draw(painter, placed.as_ref())
}

/// The picture with its upper left corner at 0, and its size.
fn boxed(mut picture: Picture) -> (Picture, [f64; 2]) {
    let mut corners: Vec<[f64; 2]> = Vec::new();
    for shape in &picture.shapes {
        match shape {
            Shape::Line(points, _) => corners.extend(points),
            Shape::Box(rect, _) => {
                corners.extend([[rect.left, rect.top], [rect.right(), rect.bottom()]])
            }
            Shape::Arrow(ends) | Shape::DoubleArrow(ends) => corners.extend(ends),
        }
    }
    for words in &picture.words {
        let length = text::width(&words.text, words.size);
        let start = match words.anchor {
            Anchor::Start => words.at[0],
            Anchor::Middle => words.at[0] - length / 2.0,
            Anchor::End => words.at[0] - length,
        };
        corners.extend([
            [start, words.at[1] - 0.8 * words.size],
            [start + length, words.at[1] + 0.25 * words.size],
        ]);
    }
    let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for corner in corners {
        for k in 0..2 {
            low[k] = low[k].min(corner[k]);
            high[k] = high[k].max(corner[k]);
        }
    }
    // Half a line at every side.
    let low = low.map(|x| if x.is_finite() { x - 1.0 } else { 0.0 });
    let size = [0, 1].map(|k| (high[k] + 1.0 - low[k]).max(1.0));
    super::transform(&mut picture, 1.0, [-low[0], -low[1]]);
    (picture, size)
}

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
    /// Where links meet nodes between laws in series: the part, and the place.
    pub joined: Vec<(usize, [f64; 2])>,
    /// What is drawn so far.
    pub picture: Picture,
}

impl Painter<'_> {
    /// Places the rows, the highest one first.
    fn stack(&mut self, left: &[f64]) {
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
                let own = match has_places(&self.scheme.parts[part]) {
                    true => height,
                    false => of_others,
                };
                let rect = &mut self.rects[part];
                (rect.top, rect.height) = (top + (height - own) / 2.0, own);
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

    fn parts(&mut self) {
        let parts = self.scheme.parts.iter().enumerate();
        for (i, part) in parts.filter(|(_, part)| !has_places(part) && !inner::is_node(part)) {
            let rect = self.rects[i];
            match part.elements {
                Some(n) => symbols::bar(&mut self.picture, rect, n),
                None => self.picture.shapes.push(Shape::Box(rect, GREY)),
            }
            let x = rect.left + rect.width / 2.0;
            let y = rect.top + (rect.height + style::CAP_HEIGHT * style::LABEL) / 2.0;
            self.word([x, y], Anchor::Middle, sizes::label(self.scheme, i));
        }
    }

    /// The nodes of matrices with all that is between them.
    fn nodes(&mut self, placed: &Placed) {
        for (i, part) in self.scheme.parts.iter().enumerate() {
            if let Some(model) = part.model.as_ref().filter(|_| has_places(part)) {
                let places = self.node_places(i, model);
                marks::draw(&mut self.picture, placed, model, &places);
            }
        }
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
