//! Draws the links of a scheme, the ground and the loads.

use super::blocks;
use super::paint::{OVER, Painter, ROWS};
use super::relations::{Join, end};
use super::sizes::{self, NAME_GAP, lane};
use super::symbols::{self, link};
use slipgap_drawing::layout::sheet::{Anchor, Shape};
use slipgap_drawing::style;
use slipgap_drawing::text::markup;
use slipgap_solver::problem::structure::described::scheme::picture::{End, Link, LinkKind, Place};

/// Length of an arrow.
const FORCE: f64 = 22.0;

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

/// A force on a part.
pub struct LoadPlace {
    /// The end that it acts on.
    pub end: End,
    /// From its tail to its head.
    pub arrow: [Point; 2],
    /// A post on the part that carries it.
    pub post: Option<[Point; 2]>,
    /// Where its end is at the part.
    pub at: Point,
}

/// A surface of the ground from one point to the other, hatched on the side `away`.
pub struct GroundPlace {
    /// The points.
    pub ends: [Point; 2],
    /// See above.
    pub away: Point,
}

impl Painter<'_> {
    /// All links, then the ground that they need.
    pub fn links(&mut self) {
        for place in self.link_places() {
            self.link(&place);
        }
        for place in self.ground_places() {
            symbols::ground(&mut self.picture, place.ends, place.away);
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

    /// The surfaces of the ground: walls, then floors.
    pub fn ground_places(&self) -> Vec<GroundPlace> {
        let mut floors: Vec<[f64; 2]> = Vec::new();
        let mut walls: Vec<(usize, usize)> = Vec::new();
        for l in 0..self.scheme.links.len() {
            match self.relations.joins[l] {
                Join::Above(None, upper) => floors.extend(self.floor_below(l, upper)),
                Join::Beside([left, right]) if left.is_none() || right.is_none() => {
                    walls.extend(left.map(|part| (part, 1)));
                    walls.extend(right.map(|part| (part, 0)));
                }
                Join::Above(..) | Join::Beside(_) | Join::Over(..) => {}
            }
        }
        let wall = |(part, side): (usize, usize)| {
            let (x, rect) = (self.wall(part, side), self.rects[part]);
            GroundPlace {
                ends: [[x, rect.top - 2.0], [x, rect.bottom() + 2.0]],
                away: [2.0 * side as f64 - 1.0, 0.0],
            }
        };
        let mut places: Vec<GroundPlace> = walls.into_iter().map(wall).collect();
        floors.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let mut joined: Vec<[f64; 2]> = Vec::new();
        for [from, to] in floors {
            match joined.last_mut() {
                Some(last) if from < last[1] + 120.0 => last[1] = last[1].max(to),
                _ => joined.push([from, to]),
            }
        }
        let floor = |[from, to]: [f64; 2]| GroundPlace {
            ends: [[from, self.floor], [to, self.floor]],
            away: [0.0, 1.0],
        };
        places.extend(joined.into_iter().map(floor));
        places
    }

    /// Draws a link at its place.
    fn link(&mut self, place: &LinkPlace) {
        let own = &self.scheme.links[place.link];
        let rod = |(_, points): &(usize, Vec<Point>)| Shape::Line(points.clone(), symbols::OUTLINE);
        self.picture.shapes.extend(place.rods[0].iter().map(rod));
        link(&mut self.picture, own.kind, place.ends, place.opens);
        self.picture.shapes.extend(place.rods[1].iter().map(rod));
        if !own.name.is_empty() {
            let (at, anchor) = place.name;
            self.word(at, anchor, markup::escape(&own.name));
        }
        for (part, which, at) in &place.attached {
            self.attach(place.link, *part, *which, *at);
        }
    }

    /// Where a vertical link is.
    fn above(&self, l: usize, lower: Option<usize>, upper: usize) -> Option<LinkPlace> {
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
        let mut rods = [Vec::new(), Vec::new()];
        if (foot - x).abs() > 0.5 {
            rods[0].push((0, vec![[foot, top], [foot, top - 3.0], [x, top - 3.0]]));
        }
        let top = if (foot - x).abs() > 0.5 {
            top - 3.0
        } else {
            top
        };
        let low_is_first = end(own, 0).map(|end| end.0) == lower;
        // The symbol of a long rod is at its foot.
        let end = bottom.max(top - ROWS);
        if end > bottom {
            rods[1].push((1, vec![[x, end], [x, bottom]]));
            // The post of an impact is at one side of the rod.
            if own.kind == LinkKind::Impact {
                rods[1].push((1, vec![[x - symbols::GAP, end], [x + symbols::GAP, end]]));
            }
        }
        let away = symbols::across(own.kind) / 2.0 + NAME_GAP;
        let y = (top + end + style::CAP_HEIGHT * style::LABEL) / 2.0;
        let mut attached = Vec::new();
        if let Some(lower) = lower {
            attached.push((lower, 0, [foot, self.rects[lower].top]));
        }
        attached.push((upper, 0, [x, bottom]));
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

    /// The ground that a vertical link needs, from left to right.
    fn floor_below(&self, l: usize, upper: usize) -> Option<[f64; 2]> {
        let slot = self.sizes.slots[l]?;
        let x = self.rects[slot.of].left + self.sizes.offset(slot);
        let rect = &self.rects[upper];
        Some(match self.scheme.parts[upper].elements.is_some() {
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
        let all: f64 = alike.iter().map(|l| lane(&self.scheme.links[*l])).sum();
        let free = (rect.height - all) / (alike.len() + 1) as f64;
        let mut y = rect.top + free;
        for other in alike {
            let own = &self.scheme.links[other];
            let next = y + lane(own);
            if other == l {
                let y = next - symbols::height(own.kind) / 2.0;
                let ends = [[from, y], [to, y]];
                let first = end(own, 0).map(|end| end.0) == parts[0];
                let attached = parts.into_iter().zip(ends);
                let attached = attached.filter_map(|(part, at)| Some((part?, 0, at)));
                return Some(LinkPlace {
                    link: l,
                    ends,
                    of: if first { [0, 1] } else { [1, 0] },
                    parts,
                    opens: 1.0,
                    rods: [Vec::new(), Vec::new()],
                    name: over_symbol(own, ends),
                    attached: attached.collect(),
                });
            }
            y = next + free;
        }
        None
    }

    /// Where a link over the parts between its own is.
    fn over(&self, l: usize, a: usize, b: usize, count: usize) -> LinkPlace {
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
        let ends = [[from, y], [to, y]];
        let in_order = end(own, 0).map(|end| end.0) == Some(parts[0]);
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
            name: over_symbol(own, ends),
            attached: vec![
                (parts[0], 0, [from, first.top]),
                (parts[1], usize::from(a == b), [to, second.top]),
            ],
        }
    }

    /// An arrow for each load: at a free face of its part, or over it.
    pub fn loads(&mut self) {
        for load in self.load_places() {
            if let Some(post) = load.post {
                let post = Shape::Line(post.to_vec(), symbols::OUTLINE);
                self.picture.shapes.push(post);
            }
            self.picture.shapes.push(Shape::Arrow(load.arrow));
            if let End::Part(part, Place::Dof(dof)) = load.end {
                self.attach_dof(part, dof, load.at);
            }
        }
    }

    /// Where the loads are.
    pub fn load_places(&self) -> Vec<LoadPlace> {
        let mut done: Vec<(usize, usize)> = Vec::new();
        let mut places = Vec::new();
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
            let mut post = None;
            let arrow = match (side, place) {
                (0, _) => [[rect.left - FORCE, middle], [rect.left - 0.5, middle]],
                (1, _) => [[rect.right(), middle], [rect.right() + FORCE, middle]],
                (_, place) => {
                    let x = match place {
                        Place::Left => rect.left + 4.0,
                        Place::Right | Place::Mass | Place::Dof(_) => rect.right() - 4.0,
                        Place::Inner(part) => rect.left + part * rect.width,
                    };
                    let y = rect.top - 7.0;
                    post = Some([[x, rect.top], [x, y]]);
                    [[x, y], [x + FORCE, y]]
                }
            };
            places.push(LoadPlace {
                end: *load,
                arrow,
                post,
                at: match side {
                    0 => [rect.left, middle],
                    1 => [rect.right(), middle],
                    _ => [rect.right() - 4.0, rect.top],
                },
            });
        }
        places
    }
}

/// The place of the name over a horizontal symbol.
fn over_symbol(own: &Link, [from, to]: [Point; 2]) -> (Point, Anchor) {
    let y = from[1] - symbols::height(own.kind) / 2.0 - 2.0;
    ([(from[0] + to[0]) / 2.0, y], Anchor::Middle)
}
