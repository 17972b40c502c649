//! Where links meet matrices: at named points on the edge of a block, or at a node that a thin line leads to.

use super::super::arrange::join::end;
use super::super::mesh;
use super::super::part::{AROUND_NODES, BESIDE, extent, has_places, is_node, longest};
use super::super::symbols::{self, length};
use super::painter::Painter;
use slipgap_drawing::layout::sheet::{Anchor, Shape};
use slipgap_drawing::style;
use slipgap_drawing::text::markup;
use slipgap_problem::problem::structure::described::scheme::model::Model;
use slipgap_problem::problem::structure::described::scheme::picture::{Part, Place};

/// Distance of links over a part from its edge.
const INSET: f64 = 5.0;

/// Distance of link `count` over a part from the edge of the part.
pub fn inset(part: &Part, count: usize) -> f64 {
    match longest(part) {
        0.0 => INSET * count as f64,
        longest => (longest + BESIDE) * (count as f64 - 0.5),
    }
}

impl Painter<'_> {
    /// Nodes of a part in the picture.
    pub fn node_places(&self, part: usize, model: &Model) -> Vec<[f64; 2]> {
        let rect = self.rects[part];
        let size = [self.sizes.width[part], self.sizes.height[part]];
        let corner = [
            rect.left + (rect.width - size[0]) / 2.0 + AROUND_NODES,
            rect.top + (rect.height - size[1]) / 2.0 + AROUND_NODES,
        ];
        let least = [0, 1].map(|axis| extent(&model.nodes, axis)[0]);
        let nodes = model.nodes.iter();
        nodes
            .map(|node| [0, 1].map(|k| corner[k] + node[k] - least[k]))
            .collect()
    }

    /// Marks where an end of a link is at a part. `which` is 1 for the second of two ends at this part.
    pub fn attach(&mut self, l: usize, part: usize, which: usize, at: [f64; 2]) {
        if is_node(&self.scheme.parts[part]) {
            self.joined.push((part, at));
        }
        let link = &self.scheme.links[l];
        let both = [end(link, 0), end(link, 1)].into_iter().flatten();
        let ends = both.filter(|end| end.0 == part);
        if let Some((_, Place::Dof(dof))) = ends.take(which + 1).last() {
            self.attach_dof(part, dof, at);
        }
    }

    /// Marks where a degree of freedom is at the edge of its part.
    pub fn attach_dof(&mut self, part: usize, dof: usize, at: [f64; 2]) {
        let scheme = self.scheme;
        let Some(model) = &scheme.parts[part].model else {
            return;
        };
        let named = &model.interface[dof];
        if has_places(&scheme.parts[part]) {
            let node = self.node_places(part, model)[named.node];
            let line = Shape::Line(vec![node, at], symbols::HATCH);
            self.picture.shapes.push(line);
            return;
        }
        mesh::dot(&mut self.picture, at, 1.4);
        let rect = self.rects[part];
        let [x, y] = at;
        let middle = y + style::CAP_HEIGHT * style::LABEL / 2.0;
        let half = length(&named.name) / 2.0;
        let inside = x.min(rect.right() - half - 2.0).max(rect.left + half + 2.0);
        let text = markup::escape(&named.name);
        let (at, anchor) = if (x - rect.left).abs() < 0.5 {
            ([x + 4.0, middle], Anchor::Start)
        } else if (x - rect.right()).abs() < 0.5 {
            ([x - 4.0, middle], Anchor::End)
        } else if y < rect.top + rect.height / 2.0 {
            let line = style::CAP_HEIGHT * style::LABEL;
            ([inside, rect.top + 4.0 + line], Anchor::Middle)
        } else {
            ([inside, rect.bottom() - 4.0], Anchor::Middle)
        };
        self.word(at, anchor, text);
    }
}
