//! Draws the bars and masses of a scheme with their names.

use super::super::arrange::sizes;
use super::super::nodes::marks;
use super::super::nodes::places::Placed;
use super::super::part::{has_places, is_node};
use super::super::symbols;
use super::painter::Painter;
use slipgap_drawing::layout::sheet::{Anchor, Shape};
use slipgap_drawing::style;

/// Grey of masses.
const GREY: u8 = 228;

impl Painter<'_> {
    /// Bars and masses with their names.
    pub fn parts(&mut self) {
        let parts = self.scheme.parts.iter().enumerate();
        for (i, part) in parts.filter(|(_, part)| !has_places(part) && !is_node(part)) {
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
    pub fn nodes(&mut self, placed: &Placed) {
        for (i, part) in self.scheme.parts.iter().enumerate() {
            if let Some(model) = part.model.as_ref().filter(|_| has_places(part)) {
                let places = self.node_places(i, model);
                marks::draw(&mut self.picture, placed, model, &places);
            }
        }
    }
}
