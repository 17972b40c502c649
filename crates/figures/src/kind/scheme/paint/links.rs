//! Draws the links of a scheme.

use super::super::arrange::join::{Join, end};
use super::super::arrange::sizes::lane;
use super::super::symbols::{self, NAME_GAP, link};
use super::attach;
use super::painter::{OVER, Painter, ROWS};
use slipgap_drawing::layout::sheet::{Anchor, Shape};
use slipgap_drawing::style;
use slipgap_drawing::text::markup;
use slipgap_problem::problem::structure::described::scheme::picture::{Link, LinkKind};

/// A point of the picture.
type Point = [f64; 2];

/// Where a link is drawn.
pub struct LinkPlace {
    /// The link, by its place in the list.
    pub link: usize,
    /// From the lower or left end to the other one.
    pub ends: [Point; 2],
    /// Which end of the link, I (0) or J (1), is at each of these.
    pub of: [usize; 2],
    /// The part at each of these; `None` for the ground.
    pub parts: [Option<usize>; 2],
    /// +1 if the part at the second end moves to the right where the contact opens, else -1.
    pub opens: f64,
    /// Rods between the symbol and a part, each with its end, the first ones drawn before the symbol.
    pub rods: [Vec<(usize, Vec<Point>)>; 2],
    /// Place of the name.
    pub name: (Point, Anchor),
    /// Where ends are at parts.
    pub attached: Vec<(usize, usize, Point)>,
}

impl Painter<'_> {
    /// All links, then the ground that they need.
    pub fn links(&mut self) {
        for drawn in self.link_places() {
            self.link(&drawn);
        }
        for drawn in self.ground_places() {
            symbols::ground(&mut self.picture, drawn.ends, drawn.away);
        }
    }

    /// Where all links are.
    pub fn link_places(&self) -> Vec<LinkPlace> {
        let mut over = vec![0; self.scheme.parts.len() + 1];
        let mut places = Vec::new();
        for l in 0..self.scheme.links.len() {
            match self.relations.joins[l] {
                Join::Above(lower, upper) => places.extend(self.above(l, lower, upper)),
                Join::Beside([Some(a), Some(b)]) if self.adjacent(a, b) => {
                    places.extend(self.beside(l));
                }
                Join::Beside([Some(a), Some(b)]) | Join::Over(a, b) => {
                    let row = self.row_over(l).unwrap_or(0);
                    over[row] += 1;
                    places.push(self.over(l, a, b, over[row]));
                }
                Join::Beside(_) => places.extend(self.beside(l)),
            }
        }
        places
    }

    /// Draws a link at its place.
    fn link(&mut self, drawn: &LinkPlace) {
        let scheme_link = &self.scheme.links[drawn.link];
        let rod = |(_, points): &(usize, Vec<Point>)| Shape::Line(points.clone(), symbols::OUTLINE);
        self.picture.shapes.extend(drawn.rods[0].iter().map(rod));
        link(&mut self.picture, scheme_link.kind, drawn.ends, drawn.opens);
        self.picture.shapes.extend(drawn.rods[1].iter().map(rod));
        if !scheme_link.name.is_empty() {
            let (at, anchor) = drawn.name;
            self.word(at, anchor, markup::escape(&scheme_link.name));
        }
        for (part, which, at) in &drawn.attached {
            self.attach(drawn.link, *part, *which, *at);
        }
    }

    /// Where a vertical link is.
    fn above(&self, l: usize, lower: Option<usize>, upper: usize) -> Option<LinkPlace> {
        let link = &self.scheme.links[l];
        let slot = self.sizes.slots[l]?;
        let (at, x) = (self.straight(l)?, self.middles[l]?);
        let bottom = self.rects[upper].bottom();
        let top = lower.map_or(self.floor, |lower| self.rects[lower].top);
        // The symbol is straight below the upper part; a rod leads to a lower part that is farther left or right.
        let foot = lower.map_or(x, |lower| {
            let rect = self.rects[lower];
            x.clamp(rect.left + 4.0, rect.right() - 4.0)
        });
        let mut rods = [Vec::new(), Vec::new()];
        if (foot - x).abs() > 0.5 {
            rods[0].push((0, vec![[foot, top], [foot, top - 3.0], [x, top - 3.0]]));
        }
        let top = if (foot - x).abs() > 0.5 {
            top - 3.0
        } else {
            top
        };
        let low_is_first = end(link, 0).map(|end| end.0) == lower;
        // The symbol of a long rod is at its foot.
        let end = bottom.max(top - ROWS);
        if end > bottom {
            let mut rod = vec![[x, end], [x, bottom]];
            if x != at {
                // Around the parts between.
                rod = vec![
                    [x, end],
                    [x, bottom + 3.0],
                    [at, bottom + 3.0],
                    [at, bottom],
                ];
            }
            rods[1].push((1, rod));
            // The post of an impact is at one side of the rod.
            if link.kind == LinkKind::Impact {
                rods[1].push((1, vec![[x - symbols::GAP, end], [x + symbols::GAP, end]]));
            }
        }
        let away = symbols::across(link.kind) / 2.0 + NAME_GAP;
        let y = (top + end + style::CAP_HEIGHT * style::LABEL) / 2.0;
        let mut attached = Vec::new();
        if let Some(lower) = lower {
            attached.push((lower, 0, [foot, self.rects[lower].top]));
        }
        attached.push((upper, 0, [at, bottom]));
        Some(LinkPlace {
            link: l,
            ends: [[x, top], [x, end]],
            of: if low_is_first { [0, 1] } else { [1, 0] },
            parts: [lower, Some(upper)],
            // The second part of an impact is right of the first one.
            opens: if low_is_first { 1.0 } else { -1.0 },
            rods,
            name: match slot.name_right {
                true => ([x + away, y], Anchor::Start),
                false => ([x - away, y], Anchor::End),
            },
            attached,
        })
    }

    /// Where a link between two faces is, one of several at different heights.
    fn beside(&self, l: usize) -> Option<LinkPlace> {
        let Join::Beside(parts) = self.relations.joins[l] else {
            return None;
        };
        let (part, side) = match parts {
            [Some(left), _] => (left, 1),
            [_, Some(right)] => (right, 0),
            [None, None] => return None,
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
        let height: f64 = alike.iter().map(|l| lane(&self.scheme.links[*l])).sum();
        let free = (rect.height - height) / (alike.len() + 1) as f64;
        let mut y = rect.top + free;
        for other in alike {
            let link = &self.scheme.links[other];
            let next = y + lane(link);
            if other == l {
                let y = next - symbols::height(link.kind) / 2.0;
                let ends = [[from, y], [to, y]];
                let first = end(link, 0).map(|end| end.0) == parts[0];
                let pairs = parts.into_iter().zip(ends);
                let attached = pairs.filter_map(|(part, at)| Some((part?, 0, at)));
                return Some(LinkPlace {
                    link: l,
                    ends,
                    of: if first { [0, 1] } else { [1, 0] },
                    parts,
                    opens: 1.0,
                    rods: [Vec::new(), Vec::new()],
                    name: over_symbol(link, ends),
                    attached: attached.collect(),
                });
            }
            y = next + free;
        }
        None
    }

    /// Where a link over the parts between its own is.
    fn over(&self, l: usize, a: usize, b: usize, count: usize) -> LinkPlace {
        let link = &self.scheme.links[l];
        let parts = match self.rects[a].left <= self.rects[b].left {
            true => [a, b],
            false => [b, a],
        };
        let [first, second] = parts.map(|part| self.rects[part]);
        let y = first.top.min(second.top) - OVER * count as f64 + 8.0;
        let inset = |part: usize| attach::inset(&self.scheme.parts[part], count);
        let in_ = parts.map(inset);
        let (from, to) = match a == b {
            true => (first.left + in_[0], first.right() - in_[0]),
            false => (first.right() - in_[0], second.left + in_[1]),
        };
        let ends = [[from, y], [to, y]];
        let in_order = end(link, 0).map(|end| end.0) == Some(parts[0]);
        LinkPlace {
            link: l,
            ends,
            of: if in_order { [0, 1] } else { [1, 0] },
            parts: parts.map(Some),
            opens: 1.0,
            rods: [
                vec![
                    (0, vec![[from, first.top], ends[0]]),
                    (1, vec![[to, second.top], ends[1]]),
                ],
                Vec::new(),
            ],
            name: over_symbol(link, ends),
            attached: vec![
                (parts[0], 0, [from, first.top]),
                (parts[1], usize::from(a == b), [to, second.top]),
            ],
        }
    }
}

/// The place of the name over a horizontal symbol.
fn over_symbol(link: &Link, [from, to]: [Point; 2]) -> (Point, Anchor) {
    let y = from[1] - symbols::height(link.kind) / 2.0 - 2.0;
    ([(from[0] + to[0]) / 2.0, y], Anchor::Middle)
}
