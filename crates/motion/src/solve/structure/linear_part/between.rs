//! Nodes between contacts in series: the contacts move them, and nothing else.

use crate::system::structure::{Structure, Symmetric};

/// The entries that hold these nodes in the matrix of a step, over its largest one: what moves them there is round-off.
const HELD: f64 = (1_u64 << 60) as f64;

/// A node between two links of a chain, of which the first contact says where it is.
#[derive(Debug, Clone)]
pub(crate) struct Between {
    /// Its place.
    pub(crate) place: usize,
    /// The first contact of the link before it, with its factor.
    pub(crate) first: (usize, f64),
    /// All its contacts with its factors.
    pub(crate) contacts: Vec<(usize, f64)>,
}

/// The nodes between contacts in series by place, from end to end of each chain.
pub(crate) fn nodes(structure: &Structure, row_of: &[usize]) -> Vec<Between> {
    let chains = structure.chains();
    let between = chains.iter().flat_map(|chain| {
        let pairs = chain.links.windows(2).zip(&chain.nodes);
        pairs.map(|(pair, between_node)| {
            let factor = |contact: usize| {
                let mut column = structure.column(contact);
                column.find(|(node, _)| *node == between_node.node)
            };
            let contacts = pair.iter().flatten().filter_map(|member| {
                let (_, factor) = factor(member.contact)?;
                Some((member.contact, factor))
            });
            Between {
                place: row_of[between_node.node],
                first: (pair[0][0].contact, between_node.factor),
                contacts: contacts.collect(),
            }
        })
    });
    between.collect()
}

/// Holds the nodes between contacts in series in the matrix of a step. Its forces are in equilibrium there.
pub(crate) fn hold(structure: &Structure, matrix: &mut Symmetric) {
    let chains = structure.chains();
    let largest = matrix.largest();
    let held = if largest > 0.0 { HELD * largest } else { 1.0 };
    for node in chains.iter().flat_map(|chain| &chain.nodes) {
        matrix.add(node.node, node.node, held);
    }
}
