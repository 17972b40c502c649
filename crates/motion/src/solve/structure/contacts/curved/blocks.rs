//! The forces of contacts with any laws, block by block of those that move each other.

use crate::contact::Unsolved;
use crate::contact::coupled::curved::{CurvedForces, Directions, Laws};
use crate::solve::structure::linear_part::block_matrix::{BlockMatrix, MatrixBlock};

/// The forces of all contacts, or groups of them.
#[derive(Debug, Clone)]
pub(crate) struct CurvedBlocks {
    blocks: Vec<CurvedBlock>,
    /// Of each: its block, and its place there.
    places: Vec<[usize; 2]>,
}

#[derive(Debug, Clone)]
struct CurvedBlock {
    contacts: Vec<usize>,
    forces: CurvedForces,
    /// d, size and force of a step.
    step: [Vec<f64>; 3],
}

impl CurvedBlocks {
    /// Of H; each of `planes` and the next one are the components of a contact in a plane.
    pub(crate) fn new(flexibility: BlockMatrix, planes: &[usize]) -> CurvedBlocks {
        let places = flexibility.places;
        let blocks = flexibility.blocks.into_iter().enumerate();
        let block = |(b, block): (usize, MatrixBlock)| {
            let m = block.contacts.len();
            let in_blocks = planes.iter().map(|plane| places[*plane]);
            let members: Vec<usize> = in_blocks
                .filter(|pair| pair[0] == b)
                .map(|pair| pair[1])
                .collect();
            CurvedBlock {
                forces: CurvedForces::with_planes(block.entries, m, &members),
                contacts: block.contacts,
                step: std::array::from_fn(|_| vec![0.0; m]),
            }
        };
        CurvedBlocks {
            blocks: blocks.map(block).collect(),
            places,
        }
    }

    /// The flexibility a with which a contact has to answer.
    pub(crate) fn flexibility(&self, contact: usize) -> f64 {
        let [block, member] = self.places[contact];
        self.blocks[block].forces.flexibility(member)
    }

    /// y of a contact in the last answer.
    pub(crate) fn argument(&self, contact: usize) -> f64 {
        let [block, member] = self.places[contact];
        self.blocks[block].forces.argument(member)
    }

    /// Forces of a step, as by [`CurvedForces::solve`].
    pub(crate) fn solve(
        &mut self,
        d: &[f64],
        size: &[f64],
        laws: &dyn Laws,
        force: &mut [f64],
    ) -> Result<(), Unsolved> {
        if let [block] = &mut self.blocks[..] {
            return block.forces.solve(d, size, laws, force);
        }
        for CurvedBlock {
            contacts,
            forces,
            step: [ds, sizes, own],
        } in &mut self.blocks
        {
            for (row, contact) in contacts.iter().enumerate() {
                (ds[row], sizes[row], own[row]) = (d[*contact], size[*contact], force[*contact]);
            }
            forces.solve(ds, sizes, &OfBlock { laws, contacts }, own)?;
            for (contact, solved) in contacts.iter().zip(own) {
                force[*contact] = *solved;
            }
        }
        Ok(())
    }
}

/// The laws of a block.
struct OfBlock<'a> {
    laws: &'a dyn Laws,
    contacts: &'a [usize],
}

impl Laws for OfBlock<'_> {
    fn answer(&self, contact: usize, y: f64) -> f64 {
        self.laws.answer(self.contacts[contact], y)
    }

    fn compliance(&self, contact: usize, y: f64, force: f64, width: f64) -> f64 {
        self.laws
            .compliance(self.contacts[contact], y, force, width)
    }

    fn bounds(&self, contact: usize) -> [f64; 2] {
        self.laws.bounds(self.contacts[contact])
    }

    fn is_plane(&self, contact: usize) -> bool {
        self.laws.is_plane(self.contacts[contact])
    }

    fn answer_plane(&self, contact: usize, y: [f64; 2]) -> [f64; 2] {
        self.laws.answer_plane(self.contacts[contact], y)
    }

    fn directions(&self, contact: usize, y: [f64; 2], force: [f64; 2]) -> Directions {
        self.laws.directions(self.contacts[contact], y, force)
    }
}
