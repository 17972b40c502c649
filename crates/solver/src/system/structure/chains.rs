//! Contacts in series: chains of contacts with nodes between them that have nothing else.

use super::Structure;

/// Contacts in series. All of them have one force, but for its sign.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    /// The contacts from end to end.
    pub members: Vec<Member>,
    /// The nodes between them: node i is between the members i and i + 1.
    pub nodes: Vec<InnerNode>,
}

/// A node between two contacts of a chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InnerNode {
    /// The node.
    pub node: usize,
    /// Its factors in both contacts, 1 or -1.
    pub factors: [f64; 2],
}

/// A contact of a chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Member {
    /// The contact.
    pub contact: usize,
    /// 1, or -1 for a contact that is seen from the other side: its S over that of the chain, and its r in that of the chain.
    pub sign: f64,
}

impl Structure {
    /// Its contacts in series. A node between them has no mass, spring, dashpot or load, and two contacts, both with a factor of 1 or -1.
    pub fn chains(&self) -> Vec<Chain> {
        if self.has_mass_everywhere() {
            return Vec::new();
        }
        let free = self.free_nodes();
        let inner = |contact: usize| -> Vec<(usize, f64)> {
            let nodes = self.column(contact);
            nodes.filter(|(node, _)| free[*node].is_some()).collect()
        };
        let mut chains = Vec::new();
        let mut is_done = vec![false; self.contacts.len()];
        for first in 0..self.contacts.len() {
            if is_done[first] || inner(first).len() != 1 {
                continue;
            }
            let mut chain = Chain {
                members: vec![Member {
                    contact: first,
                    sign: 1.0,
                }],
                nodes: Vec::new(),
            };
            let mut last = chain.members[0];
            is_done[first] = true;
            let next = |contact: usize, before: Option<usize>| {
                let mut nodes = inner(contact).into_iter();
                nodes.find(|(node, _)| Some(*node) != before)
            };
            while let Some((node, factor)) =
                next(last.contact, chain.nodes.last().map(|own| own.node))
            {
                let Some([a, b]) = free[node] else { break };
                let other = if a.0 == last.contact { b } else { a };
                // The forces at the node are in equilibrium.
                let sign = -last.sign * factor * other.1;
                last = Member {
                    contact: other.0,
                    sign,
                };
                is_done[last.contact] = true;
                chain.nodes.push(InnerNode {
                    node,
                    factors: [factor, other.1],
                });
                chain.members.push(last);
            }
            chains.push(chain);
        }
        chains
    }

    /// Whether each node is between contacts in series.
    pub fn chain_nodes(&self) -> Vec<bool> {
        let mut is_between = vec![false; self.len()];
        for node in self.chains().iter().flat_map(|chain| &chain.nodes) {
            is_between[node.node] = true;
        }
        is_between
    }

    /// Both contacts of each node that has nothing else, with their factors.
    fn free_nodes(&self) -> Vec<Option<[(usize, f64); 2]>> {
        let held = self.stiffness.nonzero_rows();
        let mut is_free: Vec<bool> = self
            .massless()
            .into_iter()
            .zip(held)
            .map(|(massless, held)| massless && !held)
            .collect();
        let loaded = self.loads.iter().flat_map(|load| &load.pattern);
        let loaded = loaded.filter(|(_, factor)| *factor != 0.0);
        for (node, _) in loaded {
            is_free[*node] = false;
        }
        let preload = self.preload.load.iter().enumerate();
        for (node, _) in preload.filter(|(_, load)| **load != 0.0) {
            is_free[node] = false;
        }
        let mut of_node: Vec<Vec<(usize, f64)>> = vec![Vec::new(); self.len()];
        for (contact, own) in self.contacts.iter().enumerate() {
            // More than two nodes would be no chain, nor is a direction of a plane.
            let is_alone = own.law.row().is_some();
            let free = own
                .along
                .iter()
                .filter(|(node, _)| is_free.get(*node) == Some(&true));
            let free: Vec<_> = free.copied().collect();
            for (node, factor) in &free {
                let factor = if is_alone || free.len() > 2 {
                    f64::NAN
                } else {
                    *factor
                };
                of_node[*node].push((contact, factor));
            }
        }
        let both = |contacts: Vec<(usize, f64)>| -> Option<[(usize, f64); 2]> {
            let both: [(usize, f64); 2] = contacts.try_into().ok()?;
            both.iter()
                .all(|(_, factor)| factor.abs() == 1.0)
                .then_some(both)
        };
        let is_free = is_free.into_iter();
        let pairs = of_node.into_iter().zip(is_free);
        pairs
            .map(|(contacts, is_free)| both(contacts).filter(|_| is_free))
            .collect()
    }
}
