//! Draws the links of a scheme, the ground and the loads.

use super::blocks;
use super::paint::{OVER, Painter, ROWS};
use super::relations::{Join, end};
use super::sizes::{self, NAME_GAP, lane};
use super::symbols::{self, link};
use slipgap_drawing::layout::sheet::{Anchor, Shape};
use slipgap_drawing::style;
use slipgap_drawing::text::markup;
use slipgap_solver::problem::structure::scheme::{End, Link, LinkKind, Place};

/// Length of an arrow.
const FORCE: f64 = 22.0;

impl Painter<'_> {
    /// All links, then the ground that they need.
    pub fn links(&mut self) {
        let mut over = vec![0; self.scheme.parts.len() + 1];
        let mut floors: Vec<[f64; 2]> = Vec::new();
        let mut walls: Vec<(usize, usize)> = Vec::new();
        for l in 0..self.scheme.links.len() {
            match self.relations.joins[l] {
                Join::Above(lower, upper) => floors.extend(self.above(l, lower, upper)),
                Join::Beside([Some(a), Some(b)]) if self.adjacent(a, b) => self.beside(l),
                Join::Beside([Some(a), Some(b)]) | Join::Over(a, b) => {
                    let row = self.row_over(l).unwrap_or(0);
                    over[row] += 1;
                    self.over(l, a, b, over[row]);
                }
                Join::Beside([left, right]) => {
                    self.beside(l);
                    walls.extend(left.map(|part| (part, 1)));
                    walls.extend(right.map(|part| (part, 0)));
                }
            }
        }
        for (part, side) in walls {
            let (x, rect) = (self.wall(part, side), self.rects[part]);
            let away = [2.0 * side as f64 - 1.0, 0.0];
            let ends = [[x, rect.top - 2.0], [x, rect.bottom() + 2.0]];
            symbols::ground(&mut self.picture, ends, away);
        }
        floors.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut joined: Vec<[f64; 2]> = Vec::new();
        for [from, to] in floors {
            match joined.last_mut() {
                Some(last) if from < last[1] + 120.0 => last[1] = last[1].max(to),
                _ => joined.push([from, to]),
            }
        }
        for [from, to] in joined {
            let ends = [[from, self.floor], [to, self.floor]];
            symbols::ground(&mut self.picture, ends, [0.0, 1.0]);
        }
    }

    /// A vertical link; the ground that it needs from left to right.
    fn above(&mut self, l: usize, lower: Option<usize>, upper: usize) -> Option<[f64; 2]> {
        let own = &self.scheme.links[l];
        let slot = self.sizes.slots[l]?;
        let x = self.rects[slot.of].left + self.sizes.offset(slot);
        let bottom = self.rects[upper].bottom();
        let top = lower.map_or(self.floor, |lower| self.rects[lower].top);
        // The symbol is straight below the upper part; a rod leads to a lower part that is farther left or right.
        let foot = lower.map_or(x, |lower| {
            let rect = self.rects[lower];
            x.clamp(rect.left + 4.0, rect.right() - 4.0)
        });
        if (foot - x).abs() > 0.5 {
            let rod = vec![[foot, top], [foot, top - 3.0], [x, top - 3.0]];
            self.picture.shapes.push(Shape::Line(rod, symbols::OUTLINE));
        }
        let top = if (foot - x).abs() > 0.5 {
            top - 3.0
        } else {
            top
        };
        let low_is_first = end(own, 0).map(|end| end.0) == lower;
        // The second part of an impact is right of the first one.
        let opens = if low_is_first { 1.0 } else { -1.0 };
        // The symbol of a long rod is at its foot.
        let end = bottom.max(top - ROWS);
        link(&mut self.picture, own.kind, [[x, top], [x, end]], opens);
        if end > bottom {
            let rod = vec![[x, end], [x, bottom]];
            self.picture.shapes.push(Shape::Line(rod, symbols::OUTLINE));
            // The post of an impact is at one side of the rod.
            if own.kind == LinkKind::Impact {
                let across = vec![[x - symbols::GAP, end], [x + symbols::GAP, end]];
                self.picture
                    .shapes
                    .push(Shape::Line(across, symbols::OUTLINE));
            }
        }
        if !own.name.is_empty() {
            let away = symbols::across(own.kind) / 2.0 + NAME_GAP;
            let y = (top + end + style::CAP_HEIGHT * style::LABEL) / 2.0;
            let (x, anchor) = match slot.name_right {
                true => (x + away, Anchor::Start),
                false => (x - away, Anchor::End),
            };
            self.word([x, y], anchor, markup::escape(&own.name));
        }
        if let Some(lower) = lower {
            self.attach(l, lower, 0, [foot, self.rects[lower].top]);
        }
        self.attach(l, upper, 0, [x, bottom]);
        let rect = &self.rects[upper];
        let bar = self.scheme.parts[upper].elements.is_some();
        lower.is_none().then(|| match bar {
            true => [x - 18.0, x + 18.0],
            false => [rect.left - 6.0, rect.right() + 6.0],
        })
    }

    /// Where the wall at a side of a part is.
    fn wall(&self, part: usize, side: usize) -> f64 {
        let width = sizes::interval(self.at_face(part, side).map(|l| &self.scheme.links[l]));
        match side {
            0 => self.rects[part].left - width,
            _ => self.rects[part].right() + width,
        }
    }

    /// Horizontal links at a side of a part.
    fn at_face(&self, part: usize, side: usize) -> impl Iterator<Item = usize> + '_ {
        let joins = self.relations.joins.iter().enumerate();
        joins.filter_map(move |(l, join)| match *join {
            Join::Beside(parts) => (parts[1 - side] == Some(part)).then_some(l),
            _ => None,
        })
    }

    /// A link between two faces, one of several at different heights.
    fn beside(&mut self, l: usize) {
        let Join::Beside(parts) = self.relations.joins[l] else {
            return;
        };
        let (part, side) = match parts {
            [Some(left), _] => (left, 1),
            [_, Some(right)] => (right, 0),
            [None, None] => return,
        };
        let alike: Vec<usize> = self
            .at_face(part, side)
            .filter(|other| self.relations.joins[*other] == Join::Beside(parts))
            .collect();
        let from = match parts[0] {
            Some(left) => self.rects[left].right(),
            None => self.wall(part, 0),
        };
        let to = match parts[1] {
            Some(right) => self.rects[right].left,
            None => self.wall(part, 1),
        };
        let mut rect = self.rects[part];
        if let [Some(left), Some(right)] = parts
            && self.rects[right].height < self.rects[left].height
        {
            rect = self.rects[right];
        }
        let all: f64 = alike.iter().map(|l| lane(&self.scheme.links[*l])).sum();
        let free = (rect.height - all) / (alike.len() + 1) as f64;
        let mut y = rect.top + free;
        for other in alike {
            let own = &self.scheme.links[other];
            let next = y + lane(own);
            if other == l {
                let y = next - symbols::height(own.kind) / 2.0;
                self.horizontal(own, [from, to], y);
                for (part, x) in parts.into_iter().zip([from, to]) {
                    part.into_iter()
                        .for_each(|part| self.attach(l, part, 0, [x, y]));
                }
            }
            y = next + free;
        }
    }

    /// A horizontal link at a height with its name over it.
    fn horizontal(&mut self, own: &Link, [from, to]: [f64; 2], y: f64) {
        link(&mut self.picture, own.kind, [[from, y], [to, y]], 1.0);
        if !own.name.is_empty() {
            let at = [(from + to) / 2.0, y - symbols::height(own.kind) / 2.0 - 2.0];
            self.word(at, Anchor::Middle, markup::escape(&own.name));
        }
    }

    /// A link over the parts between its own.
    fn over(&mut self, l: usize, a: usize, b: usize, count: usize) {
        let own = &self.scheme.links[l];
        let parts = match self.rects[a].left <= self.rects[b].left {
            true => [a, b],
            false => [b, a],
        };
        let [first, second] = parts.map(|part| self.rects[part]);
        let y = first.top.min(second.top) - OVER * count as f64 + 8.0;
        let inset = |part: usize| blocks::inset(&self.scheme.parts[part], count);
        let in_ = parts.map(inset);
        let (from, to) = match a == b {
            true => (first.left + in_[0], first.right() - in_[0]),
            false => (first.right() - in_[0], second.left + in_[1]),
        };
        for (x, rect) in [(from, first), (to, second)] {
            let rod = vec![[x, rect.top], [x, y]];
            self.picture.shapes.push(Shape::Line(rod, symbols::OUTLINE));
        }
        self.horizontal(own, [from, to], y);
        self.attach(l, parts[0], 0, [from, first.top]);
        let which = usize::from(a == b);
        self.attach(l, parts[1], which, [to, second.top]);
    }

    /// An arrow for each load: at a free face of its part, or over it.
    pub fn loads(&mut self) {
        let mut done: Vec<(usize, usize)> = Vec::new();
        for load in &self.scheme.loads {
            let End::Part(part, place) = *load else {
                continue;
            };
            let rect = self.rects[part];
            let is_free = |side: usize| {
                let shown = done.contains(&(part, side));
                !shown && self.at_face(part, side).next().is_none()
            };
            let middle = rect.top + rect.height / 2.0;
            let side = match place {
                Place::Left | Place::Mass | Place::Dof(_) if is_free(0) => 0,
                Place::Right | Place::Mass | Place::Dof(_) if is_free(1) => 1,
                Place::Left | Place::Right | Place::Mass | Place::Inner(_) | Place::Dof(_) => 2,
            };
            done.push((part, side));
            let (from, to) = match (side, place) {
                (0, _) => ([rect.left - FORCE, middle], [rect.left - 0.5, middle]),
                (1, _) => ([rect.right(), middle], [rect.right() + FORCE, middle]),
                (_, place) => {
                    let x = match place {
                        Place::Left => rect.left + 4.0,
                        Place::Right | Place::Mass | Place::Dof(_) => rect.right() - 4.0,
                        Place::Inner(part) => rect.left + part * rect.width,
                    };
                    let y = rect.top - 7.0;
                    let post = vec![[x, rect.top], [x, y]];
                    self.picture
                        .shapes
                        .push(Shape::Line(post, symbols::OUTLINE));
                    ([x, y], [x + FORCE, y])
                }
            };
            self.picture.shapes.push(Shape::Arrow([from, to]));
            if let Place::Dof(dof) = place {
                let at = match side {
                    0 => [rect.left, middle],
                    1 => [rect.right(), middle],
                    _ => [rect.right() - 4.0, rect.top],
                };
                self.attach_dof(part, dof, at);
            }
        }
    }
}
