//! The contact forces of a step: of each block of contacts that move each other, of all lanes together while the patterns stand.

mod block;
mod lane_forces;

use crate::contact::Unsolved;
use crate::lane::Lane;
use crate::solve::structure::linear_part::block_matrix::{BlockMatrix, MatrixBlock};
use block::Block;

/// Where the forces of a lane are found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Found {
    /// Here, and the lane fails without them.
    Here,
    /// Here, and elsewhere without them: then they are NaN.
    HereOrElsewhere,
    Elsewhere,
}

/// The forces of the contacts of L structures with the same flexibility.
#[derive(Debug, Clone)]
pub(crate) struct Forces<const L: usize> {
    blocks: Vec<Block<L>>,
    /// Of each contact: its block, and its place there.
    places: Vec<[usize; 2]>,
    /// The first step at which a lane has no forces, and why.
    failures: [Option<(usize, Unsolved)>; L],
    /// Where the forces of each lane are found; `None` if all are here.
    found: Option<[Found; L]>,
    /// d and the forces of one of several blocks.
    scratch: [Vec<Lane<L>>; 2],
}

impl<const L: usize> Forces<L> {
    /// The contacts with H, and g and the bounds of each.
    pub(crate) fn new(
        flexibility: &BlockMatrix,
        contacts: impl Iterator<Item = (Lane<L>, [Lane<L>; 2])>,
    ) -> Self {
        let contacts: Vec<_> = contacts.collect();
        let block = |block: &MatrixBlock| {
            let contacts_of_block = block.contacts.iter().map(|contact| contacts[*contact]);
            Block::new(block, contacts_of_block)
        };
        let most = flexibility
            .blocks
            .iter()
            .map(|block| block.contacts.len())
            .max();
        let zeros = || vec![Lane::splat(0.0); most.unwrap_or(0)];
        Forces {
            blocks: flexibility.blocks.iter().map(block).collect(),
            places: flexibility.places.clone(),
            failures: [None; L],
            found: None,
            scratch: [zeros(), zeros()],
        }
    }

    /// Changes the bounds of a contact; [`Forces::hold`] must follow.
    #[inline(always)]
    pub(crate) fn bound(&mut self, contact: usize, bounds: [Lane<L>; 2]) {
        let [block, row] = self.places[contact];
        self.blocks[block].bound(row, bounds);
    }

    /// Changes the bounds of a contact in a lane; [`Forces::hold`] must follow, or [`Forces::solve_lane`].
    pub(crate) fn bound_lane(&mut self, [contact, l]: [usize; 2], bounds: [f64; 2]) {
        let [block, row] = self.places[contact];
        self.blocks[block].bound_lane([row, l], bounds);
    }

    /// Changes the bounds of a contact, also from finite to infinite ones; [`Forces::hold`] must follow.
    #[inline(always)]
    pub(crate) fn rebound(&mut self, contact: usize, bounds: [Lane<L>; 2]) {
        let [block, row] = self.places[contact];
        self.blocks[block].rebound(row, bounds);
    }

    /// The bounds of a contact.
    #[inline(always)]
    pub(crate) fn bounds(&self, contact: usize) -> [Lane<L>; 2] {
        let [block, row] = self.places[contact];
        self.blocks[block].bounds(row)
    }

    /// Computes the forces at the bounds and their effect.
    #[inline(always)]
    pub(crate) fn hold(&mut self) {
        for block in &mut self.blocks {
            block.hold();
        }
    }

    /// The first step at which a lane has no forces, and why.
    pub(crate) fn failures(&self) -> [Option<(usize, Unsolved)>; L] {
        self.failures
    }

    /// Sets where the forces of each lane are found.
    pub(crate) fn find(&mut self, lanes: [Found; L]) {
        self.found = lanes.iter().any(|l| *l != Found::Here).then_some(lanes);
    }

    /// Where the forces of a lane are found.
    pub(crate) fn found(&self, lane: usize) -> Found {
        self.found.map_or(Found::Here, |found| found[lane])
    }

    /// H of a contact with itself.
    pub(crate) fn own(&self, contact: usize) -> f64 {
        let [block, row] = self.places[contact];
        self.blocks[block].own(row)
    }

    /// Records that a lane has no forces at a step.
    pub(crate) fn fail(&mut self, lane: usize, step: usize, why: Unsolved) {
        self.failures[lane].get_or_insert((step, why));
    }

    /// Writes the forces of a step for d = r* - c; `size` gives the size of the terms of d of a contact in a lane.
    #[inline(always)]
    pub(crate) fn solve(
        &mut self,
        step: usize,
        d: &[Lane<L>],
        size: impl Fn(usize, usize) -> f64,
        force: &mut [Lane<L>],
    ) {
        if let [block] = &mut self.blocks[..] {
            let excess = block.follow(d, force);
            for l in wrong(excess, self.found) {
                if let Err(why) = block.solve_lane(l, d, &size, force) {
                    record(&mut self.failures[l], self.found, (l, step), why);
                }
            }
            return;
        }
        self.solve_blocks(step, d, &size, force);
    }

    #[inline(never)]
    fn solve_blocks(
        &mut self,
        step: usize,
        d: &[Lane<L>],
        size: &dyn Fn(usize, usize) -> f64,
        force: &mut [Lane<L>],
    ) {
        let [ds, solved] = &mut self.scratch;
        for block in &mut self.blocks {
            let count = block.of_all.len();
            for (value, contact) in ds.iter_mut().zip(&block.of_all) {
                *value = d[*contact];
            }
            let (ds, solved) = (&ds[..count], &mut solved[..count]);
            let excess = block.follow(ds, solved);
            for l in wrong(excess, self.found) {
                if let Err(why) = block.solve_lane(l, ds, size, solved) {
                    record(&mut self.failures[l], self.found, (l, step), why);
                }
            }
            for (value, contact) in solved.iter().zip(&block.of_all) {
                force[*contact] = *value;
            }
        }
    }

    /// Solves the whole problem of lane `l` and keeps its pattern.
    #[cold]
    #[inline(never)]
    pub(crate) fn solve_lane(
        &mut self,
        [l, step]: [usize; 2],
        d: &[Lane<L>],
        size: &dyn Fn(usize, usize) -> f64,
        force: &mut [Lane<L>],
    ) {
        for block in &mut self.blocks {
            let ds: Vec<Lane<L>> = block.of_all.iter().map(|contact| d[*contact]).collect();
            let mut solved: Vec<Lane<L>> = block.of_all.iter().map(|c| force[*c]).collect();
            if let Err(why) = block.solve_lane(l, &ds, size, &mut solved) {
                self.failures[l].get_or_insert((step, why));
            }
            for (value, contact) in solved.iter().zip(&block.of_all) {
                force[*contact] = *value;
            }
        }
    }
}

/// Records why lane `l` has no forces, unless they may be found elsewhere.
fn record<const L: usize>(
    failure: &mut Option<(usize, Unsolved)>,
    found: Option<[Found; L]>,
    (l, step): (usize, usize),
    why: Unsolved,
) {
    if found.is_none_or(|found| found[l] == Found::Here) {
        failure.get_or_insert((step, why));
    }
}

/// The lanes with forces to be found here, whose pattern is contradicted.
#[inline(always)]
fn wrong<const L: usize>(
    excess: Lane<L>,
    found: Option<[Found; L]>,
) -> impl Iterator<Item = usize> {
    let mut stands = true;
    for excess in excess.0 {
        stands &= excess <= 0.0;
    }
    let lanes = if stands { 0..0 } else { 0..L };
    lanes.filter(move |l| {
        let is_elsewhere = found.is_some_and(|found| found[*l] == Found::Elsewhere);
        excess.0[*l] > 0.0 && !is_elsewhere
    })
}
