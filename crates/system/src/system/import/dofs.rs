//! The rows of matrices: a node and a direction for each.

use super::forces::MemberForce;
use super::ties::Tie;
use super::{ImportFault, cells, fault, is_plain, lines, number, shown};
use crate::system::structure::Direction;
use std::collections::HashMap;
use std::sync::Arc;

/// A degree of freedom.
#[derive(Debug, Clone, PartialEq)]
pub struct Dof {
    /// Its node; rows of one node share its name.
    pub node: Arc<str>,
    /// Its direction.
    pub direction: Direction,
    /// The support that it moves with, by its place in [`Dofs::supports`].
    pub support: Option<usize>,
    /// X, Y, Z of its node, if the file has them.
    pub at: Option<[f64; 3]>,
    /// Line of the file, from 1.
    pub line: usize,
}

/// The degrees of freedom in the order of the rows.
#[derive(Debug, Clone, Default)]
pub struct Dofs {
    rows: Vec<Dof>,
    /// Names of supports, in the order of their first lines.
    pub supports: Vec<String>,
    places: HashMap<(Arc<str>, Direction), usize>,
    /// The degrees of freedom that are sums of rows.
    pub(super) ties: Vec<Tie>,
    /// Their places by node and direction.
    pub(super) tied: HashMap<(String, Direction), usize>,
    /// Forces of members as sums of displacements of rows.
    pub(super) forces_of_members: Vec<MemberForce>,
}

/// The columns that a file may have, the first two always.
const COLUMNS: [&str; 6] = ["node", "direction", "support", "X", "Y", "Z"];

impl Dofs {
    /// The rows of a CSV file with the header `node,direction`, and `support` and `X,Y,Z` if it has them.
    ///
    /// # Errors
    /// The first line that is wrong.
    pub fn parse(bytes: &[u8]) -> Result<Dofs, ImportFault> {
        let lines = lines(bytes)?;
        let header: Vec<&str> = lines
            .first()
            .map_or(Vec::new(), |line| cells(line).collect());
        let column_of = |name: &str| header.iter().position(|heading| *heading == name);
        let known = header.iter().all(|name| COLUMNS.contains(name));
        let once = header
            .iter()
            .enumerate()
            .all(|(i, name)| column_of(name) == Some(i));
        let (Some(of_node), Some(direction), true, true) =
            (column_of("node"), column_of("direction"), known, once)
        else {
            let message = "the header must be node,direction and, if wanted, support and X,Y,Z";
            return Err(fault(0, message));
        };
        let at = [column_of("X"), column_of("Y"), column_of("Z")];
        let support = column_of("support");
        let mut dofs = Dofs::default();
        let mut supported: HashMap<Arc<str>, Option<usize>> = HashMap::new();
        let rows = lines.iter().enumerate().skip(1);
        for (index, line) in rows.filter(|(_, line)| !line.trim().is_empty()) {
            let row_cells: Vec<&str> = cells(line).collect();
            if row_cells.len() != header.len() {
                let message = format!("must have {} cells, got {}", header.len(), row_cells.len());
                return Err(fault(index, message));
            }
            let name = row_cells[of_node];
            if name.is_empty() || !is_plain(name) {
                let message = format!(
                    "a node is named by letters, digits and _, got {}",
                    shown(name)
                );
                return Err(fault(index, message));
            }
            let Some(direction) = Direction::named(row_cells[direction]) else {
                let message = format!(
                    "a direction is x, y, z, rx, ry or rz, got {}",
                    shown(row_cells[direction])
                );
                return Err(fault(index, message));
            };
            let of_support = match support.map(|column| row_cells[column]) {
                None | Some("") => None,
                Some(support) if is_plain(support) => Some(dofs.support(support)),
                Some(support) => {
                    let message = format!(
                        "a support is named by letters, digits and _, got {}",
                        shown(support)
                    );
                    return Err(fault(index, message));
                }
            };
            let known = supported.get_key_value(name);
            let node: Arc<str> = known.map_or_else(|| name.into(), |(known, _)| known.clone());
            let before = supported.entry(node.clone()).or_insert(of_support);
            match (*before, of_support) {
                (Some(one), Some(two)) if one != two => {
                    let [one, two] = [one, two].map(|index| &dofs.supports[index]);
                    let message = format!("node {name} has two supports, {one} and {two}");
                    return Err(fault(index, message));
                }
                (None, of_support) => *before = of_support,
                _ => {}
            }
            let mut coordinates = None;
            if at.iter().any(Option::is_some) {
                let mut point = [0.0; 3];
                for (x, column) in point.iter_mut().zip(at) {
                    if let Some(column) = column {
                        *x = number(row_cells[column]).map_err(|message| fault(index, message))?;
                    }
                }
                coordinates = Some(point);
            }
            let key = (node.clone(), direction);
            if let Some(first) = dofs.places.insert(key, dofs.rows.len()) {
                let message = format!(
                    "{name}.{} is there twice, first in line {}",
                    direction.name(),
                    dofs.rows[first].line
                );
                return Err(fault(index, message));
            }
            dofs.rows.push(Dof {
                node,
                direction,
                support: of_support,
                at: coordinates,
                line: index + 1,
            });
        }
        dofs.rows.shrink_to_fit();
        match dofs.rows.is_empty() {
            true => Err(fault(lines.len().saturating_sub(1), "the file has no rows")),
            false => Ok(dofs),
        }
    }

    /// The place of a support by its name.
    fn support(&mut self, name: &str) -> usize {
        let known = self.supports.iter().position(|support| support == name);
        known.unwrap_or_else(|| {
            self.supports.push(name.to_owned());
            self.supports.len() - 1
        })
    }

    /// Number of rows.
    pub fn len(&self) -> usize {
        self.rows.len()
    }

    /// Whether there is no row.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }

    /// The rows.
    pub fn rows(&self) -> &[Dof] {
        &self.rows
    }

    /// The row with a name such as `7.x`.
    pub fn row(&self, name: &str) -> Option<usize> {
        let (node, direction) = name.rsplit_once('.')?;
        let key = (node.into(), Direction::named(direction)?);
        self.places.get(&key).copied()
    }

    /// The forces on the rows of a force 1 on each row and each tie of a direction.
    pub fn forces(&self, direction: Direction) -> Vec<f64> {
        let rows = self.rows.iter();
        let one = rows.map(|dof| f64::from(u8::from(dof.direction == direction)));
        let mut forces: Vec<f64> = one.collect();
        let ties = self.ties.iter().filter(|tie| tie.direction == direction);
        for (row, factor) in ties.flat_map(|tie| &tie.along) {
            forces[*row] += factor;
        }
        forces
    }

    /// The name of a row, such as `7.x`.
    pub fn name(&self, row: usize) -> String {
        let dof = &self.rows[row];
        format!("{}.{}", dof.node, dof.direction.name())
    }

    /// The directions of a node; none if it is not there.
    pub fn directions(&self, node: &str) -> Vec<Direction> {
        let is_there = |direction: &Direction| {
            self.places.contains_key(&(node.into(), *direction))
                || self.tied.contains_key(&(node.to_owned(), *direction))
        };
        Direction::ALL.into_iter().filter(is_there).collect()
    }
}
