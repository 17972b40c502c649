//! The nodes between laws in series: a dot where the links meet.

use super::super::mesh;
use super::super::part::is_node;
use super::super::symbols;
use super::painter::Painter;
use slipgap_drawing::layout::sheet::Shape;

/// Radius of its dot.
const DOT: f64 = 1.6;

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
            let joints = self.joined.iter().filter(|(part, _)| *part == i);
            let places: Vec<[f64; 2]> = joints.map(|(_, at)| *at).collect();
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
