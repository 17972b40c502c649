//! Masses and sizes of the matrices of a case, for `explain`.

use super::template::Template;
use crate::problem::Case;
use crate::problem::structure::given::node::Numbering;
use crate::system::import::Imported;
use crate::system::structure::{Direction, Structure};

/// The matrices of a case, and the masses of the whole structure with them.
pub struct Models {
    /// Mass of the structure by direction of translation; `None` without matrices.
    pub total: Option<Vec<(Direction, f64)>>,
    /// Each of the matrices.
    pub each: Vec<Summary>,
}

/// The size and mass of matrices.
pub struct Summary {
    /// Name of the matrices.
    pub name: String,
    /// Number of rows.
    pub dofs: usize,
    /// Number of rows of M without an entry other than 0.
    pub massless: usize,
    /// Sum of M over the rows of each direction of translation that has rows.
    pub mass: Vec<(Direction, f64)>,
}

impl Models {
    /// The matrices of a case.
    pub fn of(
        template: &Template,
        case: &Case,
        structure: &Structure,
        numbering: &Numbering,
    ) -> Models {
        let of_case = template.matrices.iter().map(|matrices| {
            let imported = matrices.in_case(case);
            Summary {
                name: matrices.name.clone(),
                dofs: imported.len(),
                massless: imported.massless_rows(),
                mass: mass(imported),
            }
        });
        let each: Vec<Summary> = of_case.collect();
        // Masses and bars come before the matrices.
        let lumped = structure.nodes.iter().take(numbering.first_row(0));
        let of_nodes = lumped.map(|node| (node.direction, node.mass));
        let masses: Vec<(Direction, f64)> = of_nodes
            .chain(each.iter().flat_map(|summary| summary.mass.iter().copied()))
            .collect();
        Models {
            total: (!each.is_empty()).then(|| sums(&masses)),
            each,
        }
    }
}

/// The sum of each direction of translation that is there.
fn sums(masses: &[(Direction, f64)]) -> Vec<(Direction, f64)> {
    let sum = |direction: Direction| {
        let mut along = masses.iter().filter(|one| one.0 == direction).peekable();
        along.peek()?;
        Some((direction, along.map(|one| one.1).sum()))
    };
    Direction::TRANSLATIONS
        .into_iter()
        .filter_map(sum)
        .collect()
}

fn mass(imported: &Imported) -> Vec<(Direction, f64)> {
    let rows = imported.dofs.rows();
    // A direction whose rows have no mass is there as well.
    let mut masses: Vec<(Direction, f64)> = rows.iter().map(|dof| (dof.direction, 0.0)).collect();
    for ((i, j), value) in imported.mass.entries() {
        if rows[i].direction == rows[j].direction {
            let twice = if i == j { 1.0 } else { 2.0 };
            masses.push((rows[i].direction, twice * value));
        }
    }
    sums(&masses)
}
