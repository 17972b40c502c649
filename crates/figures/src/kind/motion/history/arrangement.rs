//! How the panels of a history figure are arranged on its sheet.

use slipgap_drawing::layout;

/// How panels of several quantities, for several values of a parameter, share a sheet.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Arrangement {
    /// All below one another.
    Stack,
    /// A row for each quantity, a column for each value.
    GroupsAcross,
    /// A row for each value, a column for each quantity.
    QuantitiesAcross,
}

/// Which quantity of which value's cases a panel shows.
pub struct Cell {
    /// Place of the quantity in the figure's `y`.
    pub quantity: usize,
    /// Place of the value among those of the figure's `panels`.
    pub group: usize,
}

impl Arrangement {
    /// Rows and columns if they fit on a page and in the `width`, if one is given, or else a stack.
    pub fn of(quantities: usize, groups: usize, width: Option<f64>) -> Arrangement {
        match (quantities, groups) {
            (2.., 2..=3) if layout::side_by_side(groups, width) == groups => {
                Arrangement::GroupsAcross
            }
            (2..=3, 4..) if layout::own_axes(quantities, width) => Arrangement::QuantitiesAcross,
            _ => Arrangement::Stack,
        }
    }

    /// Number of columns.
    pub fn columns(self, quantities: usize, groups: usize) -> usize {
        match self {
            Arrangement::Stack => 1,
            Arrangement::GroupsAcross => groups,
            Arrangement::QuantitiesAcross => quantities,
        }
    }

    /// The panels, row by row.
    pub fn rows(self, quantities: usize, groups: usize) -> Vec<Vec<Cell>> {
        let cell = |quantity, group| Cell { quantity, group };
        let across = |q| (0..groups).map(move |g| cell(q, g)).collect();
        match self {
            Arrangement::GroupsAcross => (0..quantities).map(across).collect(),
            Arrangement::QuantitiesAcross => {
                let row = |g| (0..quantities).map(move |q| cell(q, g)).collect();
                (0..groups).map(row).collect()
            }
            Arrangement::Stack => {
                let each = |g| (0..quantities).map(move |q| vec![cell(q, g)]);
                (0..groups).flat_map(each).collect()
            }
        }
    }
}
