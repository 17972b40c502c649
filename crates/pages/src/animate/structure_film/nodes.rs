//! Nodes of matrices in a scene: each moves in the plane of the picture.

use super::displacements::Motion;
use super::words::kind;
use crate::animate::film::scene::{Link, Mover, Point, Scene};
use slipgap_figures::scheme::{self, Painter, Placed, has_places};
use slipgap_problem::problem::structure::described::scheme::model::Model;
use slipgap_problem::problem::structure::described::scheme::picture::{End, LinkKind, Place};

/// Most nodes that are drawn.
const MOST: usize = 400;

/// Distance of the ground from a node.
const TO_GROUND: f64 = 26.0;

/// Adds the nodes with their links.
pub fn add(
    scene: &mut Scene,
    painter: &Painter<'_>,
    placed: &Placed,
    motion: &mut Motion<'_>,
    contacts: &[&str],
) {
    let parts = painter.scheme.parts.iter().enumerate();
    let part_with_model = { parts }
        .find_map(|(i, part)| Some((i, part.model.as_ref().filter(|_| has_places(part))?)));
    let Some((part, model)) = part_with_model else {
        return;
    };
    let places = painter.node_places(part, model);
    let mover = |node: usize, motion: &mut Motion<'_>| {
        let name = matrices(placed, node).unwrap_or_default();
        let node = &model.names[node];
        let [right, up] = placed.axes.map(|axis| ["x", "y", "z"][axis]);
        let of = |direction: &str, motion: &mut Motion<'_>| {
            motion.of(&format!("{name}.{node}.{direction}"))
        };
        Mover(of(right, motion), of(up, motion))
    };
    let (drawn, lines) = drawn(model, &places);
    for node in &drawn {
        let by = mover(*node, motion);
        if by == Mover::default() {
            scene.left_out.push(scene.nodes.len());
        }
        scene.nodes.push((places[*node], by));
    }
    scene.lines = lines;
    for link in &placed.inner {
        let node = |end: End| match end {
            End::Part(_, Place::Dof(dof)) => Some(model.interface[dof].node),
            End::Ground | End::Part(..) => None,
        };
        let nodes = link.between.map(node);
        let direction = in_plane(placed, link.direction);
        let ends = match nodes {
            [Some(i), Some(j)] => [i, j].map(|node| (places[node], mover(node, motion))),
            [Some(i), None] => {
                let far = ground(link.kind, places[i], direction, 1.0);
                scene.grounds.push(far);
                [
                    (places[i], mover(i, motion)),
                    (middle(far.0), Mover::default()),
                ]
            }
            [None, Some(j)] => {
                let far = ground(link.kind, places[j], direction, -1.0);
                scene.grounds.push(far);
                [
                    (middle(far.0), Mover::default()),
                    (places[j], mover(j, motion)),
                ]
            }
            [None, None] => continue,
        };
        let at = middle([ends[0].0, ends[1].0]);
        scene.links.push(Link {
            kind: kind(link.kind),
            contact: contacts.iter().position(|name| *name == link.name),
            name: (link.name.clone(), [at[0], at[1] - 7.0], "center"),
            ends,
            direction,
            opening: None,
            rods: Vec::new(),
        });
    }
    held(scene, model, &places, &drawn);
    for (name, [first, end]) in &placed.names {
        let points = &places[*first..*end];
        let lowest = points
            .iter()
            .fold(f64::NEG_INFINITY, |y, point| y.max(point[1]));
        let left = points
            .iter()
            .fold(f64::INFINITY, |x, point| x.min(point[0]));
        let right = points
            .iter()
            .fold(f64::NEG_INFINITY, |x, point| x.max(point[0]));
        let at = [(left + right) / 2.0, lowest + TO_GROUND + 16.0];
        scene
            .words
            .push((at, "center", Mover::default(), name.clone()));
    }
    name_once(scene);
}

/// The name of the matrices of a node.
pub fn matrices(placed: &Placed, node: usize) -> Option<&str> {
    let mut names = placed.names.iter();
    let name = names.find(|(_, [first, end])| (*first..*end).contains(&node));
    name.map(|name| &*name.0)
}

/// The nodes that are drawn, and the lines between them by their places in this list.
fn drawn(model: &Model, places: &[Point]) -> (Vec<usize>, Vec<[usize; 2]>) {
    let edges = scheme::shown(model, places);
    let step = edges.len().div_ceil(2 * MOST).max(1);
    let lines: Vec<[usize; 2]> = edges.into_iter().step_by(step).collect();
    let mut drawn: Vec<usize> = lines.iter().flatten().copied().collect();
    drawn.extend(model.interface.iter().map(|named| named.node));
    if places.len() <= MOST {
        drawn.extend(0..places.len());
    }
    drawn.sort_unstable();
    drawn.dedup();
    let position = |node: usize| drawn.binary_search(&node).unwrap_or(0);
    let lines = lines.iter().map(|line| line.map(position)).collect();
    (drawn, lines)
}

/// A direction in the plane, downwards positive, of length 1; to the right if it is across the plane.
fn in_plane(placed: &Placed, direction: [f64; 3]) -> Point {
    let [x, y] = placed.axes.map(|axis| direction[axis]);
    let length = libm::hypot(x, y);
    match length > 0.0 {
        true => [x / length, 0.0 - y / length],
        false => [1.0, 0.0],
    }
}

/// A surface of the ground that a link needs at a node.
fn ground(
    kind: LinkKind,
    [x, y]: Point,
    direction: Point,
    sign: f64,
) -> ([Point; 2], Point, Mover) {
    let [dx, dy] = match kind {
        // Friction acts along a surface below the node, or right of it.
        LinkKind::Friction if direction[0].abs() >= direction[1].abs() => [0.0, 1.0],
        LinkKind::Friction => [1.0, 0.0],
        LinkKind::Impact | LinkKind::Spring { .. } => direction.map(|component| sign * component),
    };
    let away = match dx.abs() >= dy.abs() {
        true => [dx.signum(), 0.0],
        false => [0.0, dy.signum()],
    };
    let [x, y] = [x + TO_GROUND * away[0], y + TO_GROUND * away[1]];
    let half = scheme::LONG / 2.0;
    let ends = [-half, half].map(|along| [x + along * away[1].abs(), y + along * away[0].abs()]);
    (ends, away, Mover::default())
}

/// Thin lines to the ground from nodes that the matrices hold.
fn held(scene: &mut Scene, model: &Model, places: &[Point], drawn: &[usize]) {
    let held: Vec<usize> = (0..places.len())
        .filter(|node| model.held.get(*node) == Some(&true))
        .collect();
    let span = held.iter().fold(None, |range: Option<[f64; 3]>, node| {
        let [x, y] = places[*node];
        Some(match range {
            None => [x, x, y],
            Some([low, high, lowest]) => [low.min(x), high.max(x), lowest.max(y)],
        })
    });
    let Some([low, high, lowest]) = span else {
        return;
    };
    let y = lowest + TO_GROUND;
    scene.grounds.push((
        [[low - 8.0, y], [high + 8.0, y]],
        [0.0, 1.0],
        Mover::default(),
    ));
    for node in held.iter().filter(|node| drawn.contains(node)) {
        let first = scene.nodes.len();
        scene.nodes.push(([places[*node][0], y], Mover::default()));
        if let Ok(index) = drawn.binary_search(node) {
            scene.lines.push([index, first]);
        }
    }
}

/// Contacts of one table, such as `face.1` and `face.2`, are named once.
fn name_once(scene: &mut Scene) {
    let mut tables: Vec<String> = Vec::new();
    for link in &mut scene.links {
        let Some((table, _)) = link.name.0.split_once('.') else {
            continue;
        };
        let table = table.to_owned();
        match tables.contains(&table) {
            true => link.name.2 = "none",
            false => tables.push(table),
        }
    }
}

fn middle([a, b]: [Point; 2]) -> Point {
    [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0]
}
