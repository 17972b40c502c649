//! Forces of members of matrices, as sums of displacements of rows.

use super::{Dofs, ImportFault, cells, fault, is_plain, lines, shown};

/// What a sum of displacements is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForceKind {
    /// A force.
    Force,
    /// A moment.
    Moment,
}

/// A force of members.
#[derive(Debug, Clone, PartialEq)]
pub struct MemberForce {
    /// Its name.
    pub name: String,
    /// What it is.
    pub kind: ForceKind,
    /// The rows of which it is the sum, each with its factor.
    pub along: Vec<(usize, f64)>,
}

impl Dofs {
    /// The same rows with the forces of a CSV file: a header that begins with `name,quantity`, then lines of a name, `force` or
    /// `moment`, and cells `dof:factor`.
    ///
    /// # Errors
    /// The first line that is wrong.
    pub fn with_forces(mut self, bytes: &[u8]) -> Result<Dofs, ImportFault> {
        let lines = lines(bytes)?;
        let header: Vec<&str> = lines.iter().take(1).flat_map(|line| cells(line)).collect();
        if !header.starts_with(&["name", "quantity"]) {
            return Err(fault(0, "the header must begin with name,quantity"));
        }
        let rows = lines.iter().enumerate().skip(1);
        for (index, line) in rows.filter(|(_, line)| !line.trim().is_empty()) {
            let mut fields = cells(line);
            let name = fields.next().unwrap_or_default();
            if name.is_empty() || !is_plain(name) {
                let message = format!(
                    "a force is named by letters, digits and _, got {}",
                    shown(name)
                );
                return Err(fault(index, message));
            }
            if self.force(name).is_some() {
                return Err(fault(index, format!("{name} is there twice")));
            }
            let kind = match fields.next().unwrap_or_default() {
                "force" => ForceKind::Force,
                "moment" => ForceKind::Moment,
                other => {
                    let message = format!("a quantity is force or moment, got {}", shown(other));
                    return Err(fault(index, message));
                }
            };
            let along = self.sum_of(fields, index)?;
            if along.is_empty() {
                return Err(fault(index, format!("{name} has no dof:factor")));
            }
            self.forces_of_members.push(MemberForce {
                name: name.to_owned(),
                kind,
                along,
            });
        }
        match self.forces_of_members.is_empty() {
            true => Err(fault(
                lines.len().saturating_sub(1),
                "the file has no forces; leave out \"forces\"",
            )),
            false => Ok(self),
        }
    }

    /// The force of members with this name.
    pub fn force(&self, name: &str) -> Option<&MemberForce> {
        self.forces_of_members
            .iter()
            .find(|force| force.name == name)
    }

    /// The forces of members.
    pub fn member_forces(&self) -> &[MemberForce] {
        &self.forces_of_members
    }
}
