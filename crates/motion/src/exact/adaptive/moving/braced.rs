//! Dampers behind springs: contacts with a law of velocity at nodes without mass.
//!
//! With the compliance F of the nodes, r = r* - F S, where r* is the motion without S. So rdot = g(S), the inverse of the law, is
//!
//! ```text
//! S' = (rdot* - g(S))/F
//! ```
//!
//! within the bounds of the law, where it stays as long as rdot* is faster than g there.

use crate::contact::{ContactLaw, DisplacementControl};
use crate::exact::adaptive::AdaptiveFault;
use crate::exact::events::Model;
use crate::system::structure::{PlaneRow, StructureLaw};

/// What is said of a contact at a node without mass that is none of these.
pub const MASSLESS: &str = "is at a node without mass";

/// What is said of a contact in a plane there that is not behind equal springs of its own.
const UNEQUAL: &str = "in a plane shares its node without mass with others, or is there behind springs that differ in both directions";

/// Part of a compliance that is round-off.
const ROUND_OFF: f64 = 1e-12;

/// Friction in a plane that is rigid or elastic up to its limit, in series with springs of this compliance; `None` of another law.
pub fn in_series(law: &StructureLaw, compliance: f64) -> Option<ContactLaw> {
    let limit = law.limit().map_or(0.0, |limit| limit.at(0.0));
    if law.static_ratio() > 1.0 {
        return None;
    }
    if law.row().is_some() && law.is_rigid() {
        return Some(DisplacementControl { compliance, limit }.into());
    }
    match (law.row(), law.law(limit)) {
        (Some(_), ContactLaw::DisplacementControl(elastic)) => {
            let compliance = elastic.compliance + compliance;
            Some(
                DisplacementControl {
                    compliance,
                    ..elastic
                }
                .into(),
            )
        }
        _ => None,
    }
}

/// Whether a law has rdot under its force, so that it may be behind a spring.
pub fn may_be_braced(law: &StructureLaw) -> bool {
    law.row().is_none() && law.as_given().properties().rate_under(0.0).is_some()
}

/// F of each contact behind springs; `None` of others.
///
/// # Errors
/// The nodes of such a contact have others, or loads, or nothing else holds them.
pub fn compliances(model: &Model) -> Result<Vec<Option<f64>>, AdaptiveFault> {
    let mut flexibilities = vec![None; model.columns.len()];
    let Some(flexible) = &model.flexible else {
        return Ok(flexibilities);
    };
    for i in &flexible.contacts {
        let f = &flexible.compliance;
        let contact = &model.structure.contacts[*i];
        let other = match contact.law.row() {
            Some(PlaneRow::First) => Some(i + 1),
            Some(PlaneRow::Second) => Some(i - 1),
            None => None,
        };
        let is_other_row = |j: usize| other == Some(j);
        let is_alone = flexible
            .contacts
            .iter()
            .all(|j| i == j || is_other_row(*j) || f[(*i, *j)] == 0.0)
            && flexible.plates.ncols() == 0
            && flexible.gaps.row(*i).iter().all(|x| *x == 0.0);
        let (known, what) = match (other, in_series(&contact.law, 0.0)) {
            (Some(j), Some(_)) => {
                let near = |a: f64, b: f64| (a - b).abs() <= ROUND_OFF * f[(*i, *i)];
                let equal = near(f[(*i, j)], 0.0) && near(f[(j, j)], f[(*i, *i)]);
                (equal, UNEQUAL)
            }
            _ => (may_be_braced(&contact.law), MASSLESS),
        };
        if !known || !is_alone || f[(*i, *i)] <= 0.0 {
            let name = contact.name.clone();
            return Err(AdaptiveFault::Contact { name, what });
        }
        flexibilities[*i] = Some(f[(*i, *i)]);
    }
    Ok(flexibilities)
}
