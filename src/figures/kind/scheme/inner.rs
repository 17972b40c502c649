//! The nodes between laws in series: a dot where the links meet.

use super::paint::Painter;
use super::{mesh, symbols};
use slipgap_drawing::layout::sheet::Shape;
use slipgap_solver::problem::structure::described::scheme::picture::Part;

/// Width and height of such a node.
pub const SIZE: f64 = 4.0;

/// Radius of its dot.
const DOT: f64 = 1.6;

/// Whether a part is a node between laws in series, as NAME.node1. Other parts have no dot in their names.
pub fn is_node(part: &Part) -> bool {
    let number = part.name.rsplit_once(".node").map(|(_, number)| number);
    part.elements.is_none()
        && part.model.is_none()
        && number.is_some_and(|number| number.parse::<u32>().is_ok())
}

impl Painter<'_> {
    /// The dots, with a line to each link.
    pub fn joints(&mut self) {
        for (i, _) in self
            .scheme
            .parts
            .iter()
            .enumerate()
            .filter(|(_, part)| is_node(part))
        {
            let own = self.joined.iter().filter(|(part, _)| *part == i);
            let places: Vec<[f64; 2]> = own.map(|(_, at)| *at).collect();
            let count = places.len().max(1) as f64;
            let middle = [0, 1].map(|k| places.iter().map(|at| at[k]).sum::<f64>() / count);
            for at in &places {
                let line = Shape::Line(vec![*at, middle], symbols::OUTLINE);
                self.picture.shapes.push(line);
            }
            if !places.is_empty() {
                mesh::dot(&mut self.picture, middle, DOT);
            }
        }
    }
}
