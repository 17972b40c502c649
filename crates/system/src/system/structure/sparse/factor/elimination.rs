//! The order of elimination of a sparse symmetric matrix.

use super::minimum_degree::minimum_degree;
use crate::system::structure::sparse::lists::Lists;
use feral_amd::{CscPattern, amd_order};

/// Most rows of a matrix that is always eliminated by exact degrees.
const SMALL: usize = 1000;
/// Most neighbours of a row at its elimination, in a larger matrix that is eliminated by exact degrees.
const FEW: usize = 8;

/// An order of elimination.
#[derive(Debug)]
pub(super) struct Order {
    /// The rows of the matrix.
    pub(super) rows: Vec<usize>,
    /// A number of each place. Of two entries of a column, the one of the smaller number is divided by the pivot before their
    /// product is formed.
    pub(super) numbers: Vec<usize>,
    /// Whether L has much fill-in. There are fewer than 2^31 rows then.
    pub(super) fills: bool,
}

/// The order for these neighbours of each row, which rise.
///
/// Exact degrees cost too much in a large matrix with much fill-in, where they also give more of it than the approximate degrees
/// of Amestoy, Davis and Duff (1996): 18 % in a grid of 10^4 rows. In small matrices, trees and narrow bands they cost little.
/// There they let rows of contacts come late and chains alternate, which makes steps faster.
pub(super) fn order(neighbours: Lists<usize>, late: &[bool]) -> Order {
    let size = late.len();
    let most = if size > SMALL { FEW } else { size };
    let exact = minimum_degree(&neighbours, late, most);
    if let Some(rows) = exact {
        let numbers = rows.clone();
        return Order {
            rows,
            numbers,
            fills: false,
        };
    }
    let rows = approximate(neighbours);
    Order {
        fills: rows.is_some(),
        rows: rows.unwrap_or_else(|| (0..size).collect()),
        // Numbers that rise need no choice in the loops of the factor.
        numbers: (0..size).collect(),
    }
}

/// The order by approximate degrees; `None` if there are too many neighbours for its 32 bits.
fn approximate(neighbours: Lists<usize>) -> Option<Vec<usize>> {
    let narrow = |x: &usize| i32::try_from(*x).ok();
    let starts: Option<Vec<i32>> = neighbours.starts().iter().map(narrow).collect();
    let entries: Option<Vec<i32>> = neighbours.entries().iter().map(narrow).collect();
    let (starts, entries) = (starts?, entries?);
    drop(neighbours);
    let pattern = CscPattern::new(starts.len() - 1, &starts, &entries)?;
    let rows = amd_order(&pattern).ok()?;
    rows.into_iter()
        .map(|row| usize::try_from(row).ok())
        .collect()
}
