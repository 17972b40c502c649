//! A few cases in place of all: the ends of the axes, where only a range matters.

use super::block::Block;
use super::select::distinct;
use crate::Enumeration;
use crate::axis::group::{Axis, AxisGroup};
use crate::axis::values::Values;
use slipgap_problem::problem::Case;

/// Larger blocks are tested only at the ends of their axes.
pub const MOST_TESTED: u64 = 1_000_000;

/// Of smaller blocks all cases are representative.
const MOST_LISTED: u64 = 10_000;

impl<'a> Enumeration<'a> {
    /// Cases that show the range of a quantity: those at the ends of the axes, or every case of a small block with
    /// dependent axes.
    pub fn representative_cases(self) -> impl Iterator<Item = Case> + 'a {
        self.blocks.iter().flat_map(move |block| {
            let positions = match block.raw_len() <= MOST_LISTED && !block.is_independent() {
                true => all_positions(block),
                false => ends(block),
            };
            let part = restricted(block, &positions);
            let raws = 0..part.raw_len().min(MOST_TESTED);
            let cases = raws.filter(|raw| part.is_case(self.problem, *raw));
            let completed = cases.map(|raw| part.completed(self.problem, raw));
            completed.collect::<Vec<_>>()
        })
    }
}

/// All positions of every group.
pub fn all_positions(block: &Block) -> Vec<Vec<usize>> {
    let every_index = |group: &AxisGroup| (0..group.len() as usize).collect();
    block.groups.iter().map(every_index).collect()
}

/// The positions of the smallest and the largest number of every axis, and of all names. A rule that compares parameters
/// and that some case breaks is broken there.
pub fn ends(block: &Block) -> Vec<Vec<usize>> {
    let of_axis = |axis: &Axis| -> Vec<usize> {
        let numbers = axis.values.numbers();
        if numbers.len() < axis.values.len() {
            return first_of_each(&axis.values);
        }
        let numbered = || numbers.iter().enumerate();
        let smallest = numbered().min_by(|a, b| a.1.total_cmp(b.1));
        let largest = numbered().max_by(|a, b| a.1.total_cmp(b.1));
        let both = smallest.into_iter().chain(largest);
        both.map(|(position, _)| position).collect()
    };
    let of_group = |group: &AxisGroup| {
        let mut positions: Vec<usize> = group.axes.iter().flat_map(of_axis).collect();
        positions.sort_unstable();
        positions.dedup();
        positions
    };
    block.groups.iter().map(of_group).collect()
}

fn first_of_each(values: &Values) -> Vec<usize> {
    let names = distinct(values.iter());
    names
        .iter()
        .filter_map(|name| values.iter().position(|value| value == *name))
        .collect()
}

/// The block with only some positions of each group. Tables of formulas are dropped unless all positions remain.
pub fn restricted(block: &Block, positions: &[Vec<usize>]) -> Block {
    let axis = |axis: &Axis, positions: &[usize]| Axis {
        parameter: axis.parameter,
        values: match positions.len() == axis.values.len() {
            true => axis.values.clone(),
            false => positions.iter().map(|i| axis.values.at(*i)).collect(),
        },
    };
    let pairs = block.groups.iter().zip(positions);
    let groups = pairs.map(|(group, positions)| AxisGroup {
        axes: group.axes.iter().map(|a| axis(a, positions)).collect(),
    });
    let mut part = Block {
        groups: groups.collect(),
        derived: block.derived.clone(),
        when: block.when.clone(),
        ..Block::default()
    };
    let mut lens = block.groups.iter().zip(&part.groups);
    if lens.any(|(a, b)| a.len() != b.len()) {
        let derived = part.derived.iter_mut().map(|d| &mut d.formula);
        for formula in derived.chain(part.when.iter_mut().map(|w| &mut w.formula)) {
            formula.table = None;
        }
    }
    part
}
