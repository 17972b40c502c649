//! The structure of a case as a picture: ground, masses, bars with their elements, springs, contacts and loads.

mod arrange;
mod mesh;
mod nodes;
mod paint;
mod part;
mod symbols;

// For films of structures, which move what is drawn here.
pub use mesh::shown;
pub use nodes::places::Placed;
pub use paint::links::LinkPlace;
pub use paint::painter::Painter;
pub use paint::with_places;
pub use part::has_places;
pub use symbols::LONG;

use super::Draw;
use crate::FigureData;
use slipgap_drawing::layout;
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_drawing::style;
use slipgap_problem::problem::structure::Scheme as Structure;
use slipgap_study::kinds::Scheme;

/// Widest picture that keeps the size of its letters if the figure has no width.
const WIDEST: f64 = style::DOUBLE;

impl Draw for Scheme {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData {
            study,
            figure,
            cases,
            ..
        } = *data;
        let first = cases.first();
        let scheme = first.and_then(|shown| {
            study
                .problem
                .as_structure()
                .and_then(|structure| structure.scheme(&shown.case()))
        });
        let Some(scheme) = scheme else {
            return Sheet {
                width: figure.width.unwrap_or(style::SINGLE),
                height: 2.0 * style::EDGE,
                ..Sheet::default()
            };
        };
        let (mut picture, size) = paint::paint(&scheme);
        let natural = size[0] + 2.0 * style::EDGE;
        let width = figure.width.unwrap_or(natural.clamp(style::SINGLE, WIDEST));
        let factor = ((width - 2.0 * style::EDGE) / size[0]).min(1.0);
        let left = (width - factor * size[0]) / 2.0;
        paint::transform(&mut picture, factor, [left, style::EDGE]);
        let mut sheet = Sheet {
            width,
            height: (factor * size[1] + 2.0 * style::EDGE).ceil(),
            description: describe(&scheme),
            picture,
            ..Sheet::default()
        };
        sheet.height += layout::head(&mut sheet, figure.title.as_deref());
        sheet
    }
}

/// What the picture shows, in plain text.
fn describe(scheme: &Structure) -> String {
    let bars = scheme
        .parts
        .iter()
        .filter(|part| part.elements.is_some())
        .count();
    let named = scheme.links.iter().filter(|link| !link.name.is_empty());
    let contacts: Vec<&str> = named.map(|link| link.name.as_str()).collect();
    let bodies = scheme.parts.iter().filter(|part| !part::is_node(part));
    let parts: Vec<&str> = bodies.map(|part| part.name.as_str()).collect();
    let with_model = scheme.parts.iter().filter(|part| part.model.is_some());
    let models = with_model.count();
    let matrices = match models {
        0 => String::new(),
        _ => format!(", {models} matrices"),
    };
    format!(
        "{} masses and {bars} bars{matrices}: {}; {} springs; contacts: {}",
        parts.len() - bars - models,
        parts.join(", "),
        scheme.links.len() - contacts.len(),
        match contacts.is_empty() {
            true => "none".to_owned(),
            false => contacts.join(", "),
        }
    )
}
