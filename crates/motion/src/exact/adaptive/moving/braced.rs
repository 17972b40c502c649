//! Dampers behind springs: contacts with a law of velocity at nodes without mass.
//!
//! With the compliance F of the nodes, r = r* - F S, where r* is the motion without S. So rdot = g(S), the inverse of the law, is
//!
//! ```text
//! S' = (rdot* - g(S))/F
//! ```
//!
//! within the bounds of the law, where it stays as long as rdot* is faster than g there.

use crate::exact::adaptive::AdaptiveFault;
use crate::exact::events::Model;
use crate::system::structure::StructureLaw;

/// What is said of a contact at a node without mass that is none of these.
pub const MASSLESS: &str = "is at a node without mass";

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
        let is_alone = flexible
            .contacts
            .iter()
            .all(|j| i == j || f[(*i, *j)] == 0.0)
            && flexible.plates.ncols() == 0
            && flexible.gaps.row(*i).iter().all(|x| *x == 0.0);
        if !may_be_braced(&contact.law) || !is_alone || f[(*i, *i)] <= 0.0 {
            let (name, what) = (contact.name.clone(), MASSLESS);
            return Err(AdaptiveFault::Contact { name, what });
        }
        flexibilities[*i] = Some(f[(*i, *i)]);
    }
    Ok(flexibilities)
}
