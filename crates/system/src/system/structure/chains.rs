//! Contacts in series: chains of contacts with nodes between them that have nothing else.

use super::Structure;

/// Contacts in series, each alone or several side by side. All of these links have one force, but for its sign.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    /// The links from end to end. Those of one link are side by side: they have the same motion, and share the force.
    pub links: Vec<Vec<Member>>,
    /// The nodes between them: node i is between the links i and i + 1.
    pub nodes: Vec<InnerNode>,
}

/// A node between two links of a chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InnerNode {
    /// The node.
    pub node: usize,
    /// Its factor in the first contact of the link before it, 1 or -1.
    pub factor: f64,
}

/// A contact of a chain.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Member {
    /// The contact.
    pub contact: usize,
    /// 1, or -1 for a contact that is seen from the other side: its S over that of the chain, and its r in that of the chain.
    pub sign: f64,
}

/// Contacts side by side: the first one, and all with their signs beside it.
type Link = Vec<(usize, f64)>;

impl Chain {
    /// All contacts.
    pub fn members(&self) -> impl Iterator<Item = &Member> {
        self.links.iter().flatten()
    }

    /// The first contact of each link, which has the motion of the link.
    pub fn leaders(&self) -> impl Iterator<Item = &Member> {
        self.links.iter().filter_map(|link| link.first())
    }
}

impl Structure {
    /// Its contacts in series. A node between them has no mass, spring, dashpot or load, and two links, both with a factor of 1 or -1.
    pub fn chains(&self) -> Vec<Chain> {
        if self.has_mass_everywhere() {
            return Vec::new();
        }
        let is_free = self.nodes_with_contacts_only();
        let links = self.links(&is_free);
        let free = self.nodes_of_two(&is_free, &links);
        let inner = |link: usize| -> Vec<(usize, f64)> {
            let nodes = self.column(links[link][0].0);
            nodes.filter(|(node, _)| free[*node].is_some()).collect()
        };
        let members = |link: usize, sign: f64| -> Vec<Member> {
            let members = links[link].iter();
            members
                .map(|(contact, member_sign)| Member {
                    contact: *contact,
                    sign: sign * member_sign,
                })
                .collect()
        };
        let mut chains = Vec::new();
        let mut is_done = vec![false; links.len()];
        for first in 0..links.len() {
            if is_done[first] || inner(first).len() != 1 {
                continue;
            }
            let (mut last, mut sign) = (first, 1.0);
            let mut chain = Chain {
                links: vec![members(first, sign)],
                nodes: Vec::new(),
            };
            is_done[first] = true;
            let next = |link: usize, before: Option<usize>| {
                let mut nodes = inner(link).into_iter();
                nodes.find(|(node, _)| Some(*node) != before)
            };
            while let Some((node, factor)) =
                next(last, chain.nodes.last().map(|chain_node| chain_node.node))
            {
                let Some([a, b]) = free[node] else { break };
                let other = if a.0 == last { b } else { a };
                // The forces at the node are in equilibrium.
                sign *= -factor * other.1;
                last = other.0;
                is_done[last] = true;
                chain.nodes.push(InnerNode { node, factor });
                chain.links.push(members(last, sign));
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

    /// Whether each node has nothing but contacts.
    fn nodes_with_contacts_only(&self) -> Vec<bool> {
        let held = self.stiffness.nonzero_rows();
        let mut is_free: Vec<bool> = self
            .massless()
            .into_iter()
            .zip(held)
            .map(|(massless, held)| massless && !held)
            .collect();
        let terms = self.loads.iter().flat_map(|load| &load.pattern);
        let loaded = terms.filter(|(_, factor)| *factor != 0.0);
        for (node, _) in loaded {
            is_free[*node] = false;
        }
        let preload = self.preload.load.iter().enumerate();
        for (node, _) in preload.filter(|(_, load)| **load != 0.0) {
            is_free[node] = false;
        }
        is_free
    }

    /// The contacts at free nodes, those side by side together: they move by the same factors of the same nodes, but for a sign.
    fn links(&self, is_free: &[bool]) -> Vec<Link> {
        let mut links: Vec<Link> = Vec::new();
        let is_free = |node: usize| is_free.get(node) == Some(&true);
        for (contact, other) in self.contacts.iter().enumerate() {
            if !other.along.iter().any(|(node, _)| is_free(*node)) {
                continue;
            }
            // Directions of a plane are no links of a chain.
            let is_alone = other.law.row().is_some();
            let beside = links.iter_mut().filter(|_| !is_alone).find_map(|link| {
                let first = &self.contacts[link[0].0];
                let sign = sign_beside(&first.along, &other.along)?;
                first.law.row().is_none().then_some((link, sign))
            });
            match beside {
                Some((link, sign)) => link.push((contact, sign)),
                None => links.push(vec![(contact, 1.0)]),
            }
        }
        links
    }

    /// Both links of each node that has nothing else, with their factors.
    fn nodes_of_two(&self, is_free: &[bool], links: &[Link]) -> Vec<Option<[(usize, f64); 2]>> {
        let mut of_node: Vec<Vec<(usize, f64)>> = vec![Vec::new(); self.len()];
        for (link, members) in links.iter().enumerate() {
            let contact = &self.contacts[members[0].0];
            // More than two nodes would be no chain, nor is a direction of a plane.
            let is_alone = contact.law.row().is_some();
            let free: Vec<_> = contact
                .along
                .iter()
                .filter(|(node, _)| is_free.get(*node) == Some(&true))
                .copied()
                .collect();
            for (node, factor) in &free {
                let factor = if is_alone || free.len() > 2 {
                    f64::NAN
                } else {
                    *factor
                };
                of_node[*node].push((link, factor));
            }
        }
        let both = |links: Vec<(usize, f64)>| -> Option<[(usize, f64); 2]> {
            let both: [(usize, f64); 2] = links.try_into().ok()?;
            both.iter()
                .all(|(_, factor)| factor.abs() == 1.0)
                .then_some(both)
        };
        let is_free = is_free.iter();
        let pairs = of_node.into_iter().zip(is_free);
        pairs
            .map(|(links, is_free)| both(links).filter(|_| *is_free))
            .collect()
    }
}

/// 1 or -1 for columns that are the same but for this sign.
fn sign_beside(first: &[(usize, f64)], other: &[(usize, f64)]) -> Option<f64> {
    let factor = |node: usize| other.iter().find(|term| term.0 == node).map(|term| term.1);
    let is = |sign: f64| {
        let mut terms = first.iter();
        first.len() == other.len() && terms.all(|(node, value)| factor(*node) == Some(sign * value))
    };
    [1.0, -1.0].into_iter().find(|sign| is(*sign))
}
