//! Degrees of freedom that move as sums of rows of matrices, as rigid links and floors make them.

use super::{Dofs, ImportFault, cells, fault, is_plain, lines, number, shown};
use crate::system::structure::Direction;

/// A degree of freedom that is no row of matrices.
#[derive(Debug, Clone, PartialEq)]
pub struct Tie {
    /// Its direction.
    pub direction: Direction,
    /// The rows of which it is the sum, each with its factor.
    pub along: Vec<(usize, f64)>,
    /// Line of the file, from 1.
    pub line: usize,
}

impl Dofs {
    /// The same rows with the ties of a CSV file: a header that begins with `node,direction`, then lines of a node, a direction and
    /// cells `dof:factor`.
    ///
    /// # Errors
    /// The first line that is wrong.
    pub fn with_ties(mut self, bytes: &[u8]) -> Result<Dofs, ImportFault> {
        let lines = lines(bytes)?;
        let header: Vec<&str> = lines.iter().take(1).flat_map(|line| cells(line)).collect();
        if !header.starts_with(&["node", "direction"]) {
            return Err(fault(0, "the header must begin with node,direction"));
        }
        let rows = lines.iter().enumerate().skip(1);
        for (index, line) in rows.filter(|(_, line)| !line.trim().is_empty()) {
            let (name, tie) = self.tie_of(line, index)?;
            let direction = tie.direction.name();
            if let Some(row) = self.row(&format!("{name}.{direction}")) {
                let line = self.rows()[row].line;
                let message = format!("{name}.{direction} is a row, in line {line} of the dofs");
                return Err(fault(index, message));
            }
            let key = (name, tie.direction);
            if let Some(first) = self.tied.get(&key) {
                let (name, line) = (key.0, self.ties[*first].line);
                let message = format!("{name}.{direction} is there twice, first in line {line}");
                return Err(fault(index, message));
            }
            self.tied.insert(key, self.ties.len());
            self.ties.push(tie);
        }
        match self.ties.is_empty() {
            true => Err(fault(
                lines.len().saturating_sub(1),
                "the file has no ties; leave out \"ties\"",
            )),
            false => Ok(self),
        }
    }

    /// The tie with a name such as `7.x`.
    pub fn tie(&self, name: &str) -> Option<&Tie> {
        let (node, direction) = name.rsplit_once('.')?;
        let key = (node.to_owned(), Direction::named(direction)?);
        self.tied.get(&key).map(|tie| &self.ties[*tie])
    }

    /// The rows of which a dof is the sum, each with its factor: of a tied dof, or one row.
    pub fn rows_of(&self, node: &str, direction: Direction) -> Option<Vec<(usize, f64)>> {
        let name = format!("{node}.{}", direction.name());
        let tied = || self.tie(&name).map(|tie| tie.along.clone());
        self.row(&name).map(|row| vec![(row, 1.0)]).or_else(tied)
    }

    /// The node and the tie of a line.
    fn tie_of(&self, line: &str, index: usize) -> Result<(String, Tie), ImportFault> {
        let mut line_cells = cells(line);
        let name = line_cells.next().unwrap_or_default();
        if name.is_empty() || !is_plain(name) {
            let message = format!(
                "a node is named by letters, digits and _, got {}",
                shown(name)
            );
            return Err(fault(index, message));
        }
        let word = line_cells.next().unwrap_or_default();
        let Some(direction) = Direction::named(word) else {
            let message = format!("a direction is x, y, z, rx, ry or rz, got {}", shown(word));
            return Err(fault(index, message));
        };
        let along = self.sum_of(line_cells, index)?;
        if along.is_empty() {
            let direction = direction.name();
            let message = format!("{name}.{direction} has no dof:factor that moves it");
            return Err(fault(index, message));
        }
        let line = index + 1;
        let tie = Tie {
            direction,
            along,
            line,
        };
        Ok((name.to_owned(), tie))
    }

    /// The sum of rows of cells `dof:factor`, without factors 0.
    pub(super) fn sum_of<'a>(
        &self,
        cells: impl Iterator<Item = &'a str>,
        index: usize,
    ) -> Result<Vec<(usize, f64)>, ImportFault> {
        let mut along: Vec<(usize, f64)> = Vec::new();
        for cell in cells.filter(|cell| !cell.is_empty()) {
            let Some((dof, factor)) = cell.rsplit_once(':') else {
                let message = format!("must be dof:factor, got {}", shown(cell));
                return Err(fault(index, message));
            };
            let factor = number(factor.trim()).map_err(|message| fault(index, message))?;
            let Some(row) = self.row(dof.trim()) else {
                let message = format!("no row {} in the dofs", shown(dof.trim()));
                return Err(fault(index, message));
            };
            if along.iter().any(|(known, _)| *known == row) {
                return Err(fault(index, format!("{} is there twice", shown(dof))));
            }
            along.push((row, factor));
        }
        along.retain(|(_, factor)| *factor != 0.0);
        Ok(along)
    }
}
