//! A matrix of the contacts in blocks: contacts that no others move are apart, so that many pairs of bodies need little room.

use crate::system::structure::{PlaneRow, Structure};

/// Fewer contacts are one block. With more, a block is searched and factored for itself.
const FEWEST: usize = 64;

/// A symmetric matrix of the contacts; what is in no block is zero.
#[derive(Debug, Clone, Default)]
pub(crate) struct BlockMatrix {
    pub(crate) blocks: Vec<MatrixBlock>,
    /// Of each contact: its block, and its place there.
    pub(crate) places: Vec<[usize; 2]>,
}

/// The rows and columns of some contacts.
#[derive(Debug, Clone)]
pub(crate) struct MatrixBlock {
    /// The contacts, in rising order.
    pub(crate) contacts: Vec<usize>,
    /// The entries by rows.
    pub(crate) entries: Vec<f64>,
}

impl BlockMatrix {
    /// The matrix of these entries (i, j), i >= j, in blocks of these contacts.
    pub(crate) fn new(blocks: Vec<Vec<usize>>, entry: impl Fn(usize, usize) -> f64) -> BlockMatrix {
        let count = blocks.iter().map(Vec::len).sum();
        let mut places = vec![[0; 2]; count];
        let block = |(b, contacts): (usize, Vec<usize>)| {
            let m = contacts.len();
            let mut entries = vec![0.0; m * m];
            for i in 0..m {
                for j in 0..=i {
                    let value = entry(contacts[i], contacts[j]);
                    (entries[i * m + j], entries[j * m + i]) = (value, value);
                }
                places[contacts[i]] = [b, i];
            }
            MatrixBlock { contacts, entries }
        };
        BlockMatrix {
            blocks: blocks.into_iter().enumerate().map(block).collect(),
            places,
        }
    }

    /// One block with these entries by rows.
    pub(crate) fn dense(entries: Vec<f64>, contacts: usize) -> BlockMatrix {
        BlockMatrix {
            blocks: vec![MatrixBlock {
                contacts: (0..contacts).collect(),
                entries,
            }],
            places: (0..contacts).map(|i| [0, i]).collect(),
        }
    }

    /// An entry.
    pub(crate) fn entry(&self, i: usize, j: usize) -> f64 {
        let ([of_i, i], [of_j, j]) = (self.places[i], self.places[j]);
        let block = &self.blocks[of_i];
        match of_i == of_j {
            true => block.entries[i * block.contacts.len() + j],
            false => 0.0,
        }
    }

    /// An entry of the diagonal.
    pub(crate) fn diagonal(&self, i: usize) -> f64 {
        self.entry(i, i)
    }
}

/// The contacts that move each other, by the places in their columns of L^-1 B; those in series and both directions of a plane are
/// together.
pub(crate) fn blocks<C: Iterator<Item = usize>>(
    structure: &Structure,
    columns: impl Iterator<Item = C>,
) -> Vec<Vec<usize>> {
    let m = structure.contacts.len();
    if m < FEWEST {
        return vec![(0..m).collect()];
    }
    let mut together = Together((0..m).collect());
    let mut first: Vec<Option<usize>> = vec![None; structure.len()];
    for (i, column) in columns.enumerate() {
        for at in column {
            match first[at] {
                Some(other) => together.join(i, other),
                None => first[at] = Some(i),
            }
        }
    }
    for (i, contact) in structure.contacts.iter().enumerate() {
        if contact.law.row() == Some(PlaneRow::First) {
            together.join(i, i + 1);
        }
    }
    for chain in structure.chains() {
        let members: Vec<usize> = chain.members().map(|member| member.contact).collect();
        members
            .windows(2)
            .for_each(|neighbours| together.join(neighbours[0], neighbours[1]));
    }
    together.sets()
}

/// Number of contacts of each block of a structure, before anything is factored: contacts of nodes that springs, dashpots and masses
/// connect are together.
pub fn sizes_of_blocks(structure: &Structure) -> Vec<usize> {
    let m = structure.contacts.len();
    if m < FEWEST {
        return vec![m];
    }
    let mut together = Together((0..structure.len() + m).collect());
    let matrices = [
        &structure.stiffness,
        &structure.damping,
        &structure.coupled_mass,
    ];
    for ((i, j), _) in matrices.into_iter().flat_map(|matrix| matrix.entries()) {
        together.join(i, j);
    }
    for (i, contact) in structure.contacts.iter().enumerate() {
        let row = structure.len() + i;
        for (node, _) in &contact.along {
            together.join(row, *node);
        }
        if contact.law.row() == Some(PlaneRow::First) {
            together.join(row, row + 1);
        }
    }
    let is_contact = |i: &&usize| **i >= structure.len();
    let sets = together.sets().into_iter();
    let sizes = sets.map(|set| set.iter().filter(is_contact).count());
    sizes.filter(|size| *size > 0).collect()
}

/// Sets of numbers: each points to another of its set, the root to itself.
struct Together(Vec<usize>);

impl Together {
    fn root(&mut self, mut i: usize) -> usize {
        while self.0[i] != i {
            self.0[i] = self.0[self.0[i]];
            i = self.0[i];
        }
        i
    }

    /// The sets, each in rising order.
    fn sets(mut self) -> Vec<Vec<usize>> {
        let mut sets: Vec<Vec<usize>> = Vec::new();
        let mut of: Vec<Option<usize>> = vec![None; self.0.len()];
        for i in 0..self.0.len() {
            let root = self.root(i);
            let set = *of[root].get_or_insert_with(|| {
                sets.push(Vec::new());
                sets.len() - 1
            });
            sets[set].push(i);
        }
        sets
    }

    fn join(&mut self, i: usize, j: usize) {
        let (i, j) = (self.root(i), self.root(j));
        self.0[i.max(j)] = i.min(j);
    }
}
