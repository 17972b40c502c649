//! The contacts of a face: a name and factors of degrees of freedom for each.

use super::{ImportFault, cells, fault, is_plain, lines, number, shown};
use std::collections::BTreeMap;

/// A contact of a face.
#[derive(Debug, Clone, PartialEq)]
pub struct Pair {
    /// Its name.
    pub name: String,
    /// Names of degrees of freedom with their factors in r.
    pub along: Vec<(String, f64)>,
    /// Line of the file, from 1.
    pub line: usize,
}

/// The contacts of a CSV file: `name`, then cells `dof:factor`. A first line that begins with `name` is a header.
///
/// # Errors
/// The first line that is wrong.
pub fn pairs(bytes: &[u8]) -> Result<Vec<Pair>, ImportFault> {
    let lines = lines(bytes)?;
    let mut pairs: Vec<Pair> = Vec::new();
    let mut first_lines = BTreeMap::new();
    for (index, line) in lines.iter().enumerate() {
        let mut row = cells(line).filter(|cell| !cell.is_empty());
        let Some(name) = row.next() else {
            continue;
        };
        if index == 0 && name == "name" {
            continue;
        }
        if !is_plain(name) {
            let message = format!(
                "a contact is named by letters, digits and _, got {}",
                shown(name)
            );
            return Err(fault(index, message));
        }
        if let Some(first) = first_lines.insert(name, index + 1) {
            let message = format!("{name} is there twice, first in line {first}");
            return Err(fault(index, message));
        }
        let mut along: Vec<(String, f64)> = Vec::new();
        for cell in row {
            let Some((dof, factor)) = cell.rsplit_once(':') else {
                let message = format!("must be dof:factor, got {}", shown(cell));
                return Err(fault(index, message));
            };
            let factor = number(factor.trim()).map_err(|message| fault(index, message))?;
            if along.iter().any(|(known, _)| known == dof.trim()) {
                return Err(fault(index, format!("{} is there twice", shown(dof))));
            }
            along.push((dof.trim().to_owned(), factor));
        }
        if along.is_empty() {
            return Err(fault(index, format!("contact {name} has no dof:factor")));
        }
        pairs.push(Pair {
            name: name.to_owned(),
            along,
            line: index + 1,
        });
    }
    match pairs.is_empty() {
        true => Err(fault(
            lines.len().saturating_sub(1),
            "the file has no contacts",
        )),
        false => Ok(pairs),
    }
}
