//! Contacts, springs and forces at nodes of other programs, with the ground that they need.

use super::super::mesh;
use super::super::symbols::{self, FACE, GAP, OUTLINE};
use super::labels::Labels;
use super::places::Placed;
use super::walls::{Wall, Walls};
use slipgap_drawing::layout::sheet::{Picture, Rect, Shape};
use slipgap_drawing::text::markup;
use slipgap_problem::problem::structure::described::scheme::model::Model;
use slipgap_problem::problem::structure::described::scheme::picture::{End, Link, LinkKind, Place};

/// Distance of the ground from a node.
const TO_GROUND: f64 = 26.0;
/// Length of an arrow.
const FORCE: f64 = 22.0;
/// Half the length of a face, and least half.
const FACES: [f64; 2] = [4.0, 1.2];
/// Half the length of a sliding plate.
const PLATE: f64 = 8.0;
/// More nodes than this are not named one by one, nor led to the ground.
const MANY: usize = 12;
/// A point of the picture.
type Point = [f64; 2];

/// Draws nodes with their links and forces, and the names of all.
pub fn draw(picture: &mut Picture, placed: &Placed, model: &Model, places: &[Point]) {
    mesh::mesh(picture, model, places);
    let mut marks = Marks {
        placed,
        model,
        places,
        middle: middle(places),
        walls: Walls::default(),
    };
    let ends: Vec<[Point; 2]> = placed.inner.iter().map(|link| marks.ends(link)).collect();
    let middles: Vec<Point> = ends.iter().map(|ends| middle(ends)).collect();
    let mut labels = Labels::new(model, places);
    for ((link, ends), at) in placed.inner.iter().zip(&ends).zip(&middles) {
        let half = half(*at, &middles);
        marks.link(picture, link, *ends, half);
        labels.crossed(*ends);
        let across = match link.kind {
            LinkKind::Impact => [GAP + 1.0, half],
            LinkKind::Friction => [PLATE, 4.0],
            LinkKind::Spring { .. } => [9.0; 2],
        };
        labels.taken(Rect {
            left: at[0] - across[0],
            top: at[1] - across[1],
            width: 2.0 * across[0],
            height: 2.0 * across[1],
        });
    }
    marks.held(picture, &mut labels);
    marks.walls.draw(picture, &mut labels);
    marks.forces(picture, &mut labels);
    for (name, [first, end]) in &placed.names {
        let points = &places[*first..*end];
        let lowest = points
            .iter()
            .fold(f64::NEG_INFINITY, |y, point| y.max(point[1]));
        labels.below([middle(points)[0], lowest], markup::escape(name));
    }
    labels.links(&placed.inner, &middles);
    marks.names(&mut labels);
    picture.words.append(&mut labels.words);
}

/// The middle of the box around points.
fn middle(points: &[Point]) -> Point {
    [0, 1].map(|k| {
        let start = [f64::INFINITY, f64::NEG_INFINITY];
        let [low, high] = points.iter().fold(start, |[low, high], point| {
            [low.min(point[k]), high.max(point[k])]
        });
        (low + high) / 2.0
    })
}

/// Half the length of the faces of a contact, so that those of its neighbours stay apart.
fn half(at: Point, points: &[Point]) -> f64 {
    let others = points.iter().filter(|other| **other != at);
    let distances = others.map(|other| libm::hypot(other[0] - at[0], other[1] - at[1]));
    (0.38 * distances.fold(f64::INFINITY, f64::min)).clamp(FACES[1], FACES[0])
}

struct Marks<'a> {
    placed: &'a Placed,
    model: &'a Model,
    places: &'a [Point],
    middle: Point,
    walls: Walls,
}

impl Marks<'_> {
    fn node(&self, end: End) -> Option<Point> {
        match end {
            End::Part(_, Place::Dof(dof)) => Some(self.places[self.model.interface[dof].node]),
            End::Ground | End::Part(..) => None,
        }
    }

    /// A direction in the plane, of length 1; `None` if it is across the plane.
    fn unit(&self, direction: [f64; 3]) -> Option<Point> {
        let [x, y] = self.placed.axes.map(|axis| direction[axis]);
        let length = libm::hypot(x, y);
        let whole = direction.iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        (length > 0.1 * whole).then(|| [x / length, 0.0 - y / length])
    }

    /// The ends of a link; those at the ground are added to the walls.
    fn ends(&mut self, link: &Link) -> [Point; 2] {
        let [i, j] = link.between.map(|end| self.node(end));
        let (node, sign) = match (i, j) {
            (Some(i), Some(j)) => return [i, j],
            (Some(i), None) => (i, 1.0),
            (None, Some(j)) => (j, -1.0),
            (None, None) => return [self.middle; 2],
        };
        let [x, y] = self.unit(link.direction).unwrap_or([1.0, 0.0]);
        let outwards = match (node[0] - self.middle[0]) * x + (node[1] - self.middle[1]) * y >= 0.0
        {
            true => 1.0,
            false => -1.0,
        };
        let [x, y] = match link.kind {
            LinkKind::Impact => [sign * x, sign * y],
            LinkKind::Spring { .. } => [outwards * x, outwards * y],
            // Below the node, or right of it.
            LinkKind::Friction if x.abs() >= y.abs() => [0.0, 1.0],
            LinkKind::Friction => [1.0, 0.0],
        };
        // Surfaces are horizontal or vertical.
        let away = match x.abs() >= y.abs() {
            true => [x.signum(), 0.0],
            false => [0.0, y.signum()],
        };
        let end = [node[0] + TO_GROUND * x, node[1] + TO_GROUND * y];
        let [at, along] = match away[1] == 0.0 {
            true => end,
            false => [end[1], end[0]],
        };
        self.walls.0.push(Wall { away, at, along });
        match i {
            Some(_) => [node, end],
            None => [end, node],
        }
    }

    fn link(&self, picture: &mut Picture, link: &Link, [i, j]: [Point; 2], half: f64) {
        let [x, y] = [(i[0] + j[0]) / 2.0, (i[1] + j[1]) / 2.0];
        let between = [j[0] - i[0], j[1] - i[1]];
        let length = libm::hypot(between[0], between[1]);
        let straight = match length > 0.0 {
            true => between.map(|x| x / length),
            false => [1.0, 0.0],
        };
        let [ux, uy] = self.unit(link.direction).unwrap_or(straight);
        let at =
            |along: f64, across: f64| [x + along * ux - across * uy, y + along * uy + across * ux];
        let mut line = |points: Vec<Point>, width: f64| {
            picture.shapes.push(Shape::Line(points, width));
        };
        match link.kind {
            LinkKind::Impact => {
                let gap = GAP.min(0.3 * length).max(2.2);
                for (end, side) in [(i, -gap), (j, gap)] {
                    line(vec![end, at(side, 0.0)], OUTLINE);
                    line(vec![at(side, -half), at(side, half)], FACE);
                }
            }
            LinkKind::Friction => {
                // The plate of each end is on the side of this end.
                let across = between[1] * ux - between[0] * uy;
                let sign = if across < 0.0 { -1.0 } else { 1.0 };
                let plate = PLATE.min(2.0 * half);
                for (end, side) in [(i, -1.8 * sign), (j, 1.8 * sign)] {
                    line(vec![end, at(0.0, side)], OUTLINE);
                    line(vec![at(-plate, side), at(plate, side)], OUTLINE);
                }
                for k in 0..5 {
                    let foot = plate * (f64::from(k) / 2.5 - 1.0);
                    line(
                        vec![at(foot, 1.8), at(foot + 0.4 * plate, -1.8)],
                        symbols::HATCH,
                    );
                }
            }
            LinkKind::Spring { .. } => {
                // A spring between nodes that are too close is drawn past them.
                let more = ((symbols::LONG + 2.0 - length) / 2.0).max(0.0);
                let ends = [(i, -more), (j, more)]
                    .map(|(end, by)| [end[0] + by * straight[0], end[1] + by * straight[1]]);
                symbols::spring_between(picture, link.kind, ends);
            }
        }
    }

    /// Lines to the ground from nodes that the matrices hold: their supports are no nodes.
    fn held(&mut self, picture: &mut Picture, labels: &mut Labels) {
        let nodes = self.model.held.iter().enumerate();
        let held: Vec<usize> = nodes
            .filter(|(_, held)| **held)
            .map(|(node, _)| node)
            .collect();
        for node in &held {
            let [x, y] = self.places[*node];
            let end = y + TO_GROUND;
            if held.len() <= MANY {
                picture
                    .shapes
                    .push(Shape::Line(vec![[x, y], [x, end]], symbols::HATCH));
                labels.crossed([[x, y], [x, end]]);
            }
            self.walls.0.push(Wall {
                away: [0.0, 1.0],
                at: end,
                along: x,
            });
        }
    }

    /// The nodes that the study names, without their directions, if they are few.
    fn names(&self, labels: &mut Labels) {
        let mut named: Vec<usize> = Vec::new();
        if self.model.interface.len() > MANY {
            return;
        }
        for dof in &self.model.interface {
            if named.contains(&dof.node) {
                continue;
            }
            named.push(dof.node);
            let name = dof
                .name
                .rsplit_once('.')
                .map_or(&dof.name[..], |(node, _)| node);
            labels.near(self.places[dof.node], markup::escape(name));
        }
    }

    /// An arrow for each force, or the name of a degree of freedom that is not in the plane.
    fn forces(&self, picture: &mut Picture, labels: &mut Labels) {
        for dof in &self.placed.loads {
            let named = &self.model.interface[*dof];
            let node = self.places[named.node];
            let axes = slipgap_system::system::structure::Direction::TRANSLATIONS;
            let direction = axes.map(|axis| if axis == named.direction { 1.0 } else { 0.0 });
            match self.unit(direction).filter(|_| direction != [0.0; 3]) {
                None => labels.near(node, format!("force {}", markup::escape(&named.name))),
                Some([x, y]) => {
                    let from = [node[0] - FORCE * x, node[1] - FORCE * y];
                    picture.shapes.push(Shape::Arrow([from, node]));
                }
            }
        }
    }
}
