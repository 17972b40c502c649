//! Nodes of other programs as dots, and lines between those that K couples.

use super::symbols;
use slipgap_drawing::layout::sheet::{Picture, Shape};
use slipgap_problem::problem::structure::described::scheme::model::Model;

/// With more couplings than this, lines and dots are fine.
const MANY: usize = 100;
/// With more couplings than this, only the outline is drawn.
const MOST: usize = 2000;
/// Width of fine lines.
const FINE: f64 = 0.3;
/// Width of an outline.
const EDGE: f64 = 0.6;
/// Radius of a dot, and of one of many.
const DOTS: [f64; 2] = [1.4, 0.7];

/// Draws nodes at their places.
pub fn mesh(picture: &mut Picture, model: &Model, places: &[[f64; 2]]) {
    let count = model.couplings.len();
    let width = match count {
        0..=MANY => symbols::OUTLINE,
        _ if count <= MOST => FINE,
        _ => EDGE,
    };
    for [a, b] in shown(model, places) {
        let [from, to] = [places[a], places[b]];
        if from != to {
            picture.shapes.push(Shape::Line(vec![from, to], width));
        }
    }
    let mut dots: Vec<usize> = match count <= MOST && places.len() <= MOST {
        true => (0..places.len()).collect(),
        false => model.interface.iter().map(|named| named.node).collect(),
    };
    dots.sort_unstable();
    dots.dedup();
    let radius = DOTS[usize::from(count > MANY || dots.len() > MANY)];
    for node in dots {
        dot(picture, places[node], radius);
    }
}

/// A filled circle.
pub fn dot(picture: &mut Picture, [x, y]: [f64; 2], radius: f64) {
    const CORNERS: u32 = 8;
    // The line covers the circle from its middle to its edge.
    let ring = (0..=CORNERS).map(|i| {
        let angle = 2.0 * std::f64::consts::PI * f64::from(i) / f64::from(CORNERS);
        let half = radius / 2.0;
        [x + half * libm::cos(angle), y + half * libm::sin(angle)]
    });
    picture.shapes.push(Shape::Line(ring.collect(), radius));
}

/// The couplings that are drawn: all, or those of the outline, which have common neighbours on one side only.
pub fn shown(model: &Model, places: &[[f64; 2]]) -> Vec<[usize; 2]> {
    if model.couplings.len() <= MOST {
        return model.couplings.clone();
    }
    let mut neighbours: Vec<Vec<usize>> = vec![Vec::new(); places.len()];
    for [a, b] in &model.couplings {
        neighbours[*a].push(*b);
        neighbours[*b].push(*a);
    }
    let is_outer = |pair: &&[usize; 2]| {
        let [a, b] = **pair;
        let [ux, uy] = [0, 1].map(|k| places[b][k] - places[a][k]);
        let common = neighbours[a].iter().filter(|i| neighbours[b].contains(i));
        let sides = common.map(|i| {
            let [vx, vy] = [0, 1].map(|k| places[*i][k] - places[a][k]);
            let area = ux * vy - uy * vx;
            // On the line, but for round-off.
            match area.abs() <= 1e-9 * (ux * ux + uy * uy + vx * vx + vy * vy) {
                true => 0,
                false => area.signum() as i32,
            }
        });
        let sides: Vec<i32> = sides.collect();
        !(sides.contains(&1) && sides.contains(&-1))
    };
    model.couplings.iter().filter(is_outer).copied().collect()
}
