//! The order of elimination of a sparse symmetric matrix.

use std::collections::{BTreeMap, BTreeSet};

/// What decides which node is eliminated next: the smallest rank.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Rank {
    /// Number of nodes that it is connected to.
    degree: usize,
    late: bool,
    /// Number of eliminations that must come before its own, in a chain. The smallest first lets a processor work on several
    /// chains at the same time.
    height: usize,
    node: usize,
}

/// The nodes that remain, by rank.
#[derive(Debug)]
pub(super) struct Remaining {
    ranks: Vec<Rank>,
    queue: BTreeSet<Rank>,
}

impl Remaining {
    /// All nodes of a matrix of these rows without the diagonal; among nodes of one degree those of `late` come last.
    pub(super) fn new(rows: &[BTreeMap<usize, f64>], late: &[bool]) -> Remaining {
        let rank = |(node, row): (usize, &BTreeMap<usize, f64>)| Rank {
            degree: row.len(),
            late: late[node],
            height: 0,
            node,
        };
        let ranks: Vec<Rank> = rows.iter().enumerate().map(rank).collect();
        let queue = ranks.iter().copied().collect();
        Remaining { ranks, queue }
    }

    /// Takes the next node: one of the smallest degree, so that a tree has no fill-in.
    pub(super) fn next(&mut self) -> Option<usize> {
        self.queue.pop_first().map(|rank| rank.node)
    }

    /// Records the degree of `node` after the elimination of its neighbour `eliminated`.
    pub(super) fn eliminated(&mut self, eliminated: usize, node: usize, degree: usize) {
        let height = self.ranks[eliminated].height + 1;
        let rank = &mut self.ranks[node];
        self.queue.remove(rank);
        rank.degree = degree;
        rank.height = rank.height.max(height);
        self.queue.insert(*rank);
    }
}
