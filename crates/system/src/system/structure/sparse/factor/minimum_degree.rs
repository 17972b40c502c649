//! The order of the smallest degree (Tinney and Walker 1967).

use crate::system::structure::sparse::lists::Lists;
use std::collections::BTreeSet;

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

/// The order for these neighbours of each node, which rise; among nodes of one degree those of `late` come last. `None` if the
/// smallest degree exceeds `most`.
///
/// A tree has no fill-in.
pub(super) fn minimum_degree(
    neighbours: &Lists<usize>,
    late: &[bool],
    most: usize,
) -> Option<Vec<usize>> {
    let size = late.len();
    // The neighbours, also eliminated ones.
    let mut rows: Vec<Vec<usize>> = (0..size).map(|i| neighbours.list(i).to_vec()).collect();
    let rank = |node: usize| Rank {
        degree: rows[node].len(),
        late: late[node],
        height: 0,
        node,
    };
    let mut ranks: Vec<Rank> = (0..size).map(rank).collect();
    let mut queue: BTreeSet<Rank> = ranks.iter().copied().collect();
    let mut eliminated = vec![false; size];
    let mut order = Vec::with_capacity(size);
    while let Some(Rank {
        degree,
        height,
        node,
        ..
    }) = queue.pop_first()
    {
        if degree > most {
            return None;
        }
        order.push(node);
        eliminated[node] = true;
        let mut column = std::mem::take(&mut rows[node]);
        column.retain(|i| !eliminated[*i]);
        // All remaining nodes are neighbours of each other.
        let complete = column.len() == queue.len();
        for i in &column {
            let row = &mut rows[*i];
            let before = row.len();
            for j in column.iter().filter(|j| !complete && *j != i) {
                if let Err(position) = row.binary_search(j) {
                    row.insert(position, *j);
                }
            }
            let rank = &mut ranks[*i];
            queue.remove(rank);
            rank.degree += row.len() - before;
            rank.degree -= 1;
            rank.height = rank.height.max(height + 1);
            queue.insert(*rank);
        }
    }
    Some(order)
}
