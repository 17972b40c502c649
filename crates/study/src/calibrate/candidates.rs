//! The candidates of `recommend`, each made when it is needed.

use super::Alternative;
use crate::Study;
use slipgap_cases::axis::group::AxisGroup;
use slipgap_cases::block::Block;
use slipgap_problem::problem::Case;

/// The candidates of a block: all combinations of its groups of axes with a parameter to choose, each by its position in these groups.
#[derive(Debug, Clone)]
pub struct Candidates<'a> {
    study: &'a Study,
    block: usize,
    /// The groups to choose from, each with the number of combinations from one position to the next.
    chosen: Vec<(usize, u64)>,
    /// The combinations of the physical cases, less the first of the candidate.
    physical: Vec<u64>,
}

impl Study {
    /// The candidates of `recommend` by block; none without the key.
    pub fn candidates(&self) -> Vec<Candidates<'_>> {
        let over = self
            .recommend
            .iter()
            .map(|recommend| recommend.over.as_slice());
        let blocks = over.flat_map(|over| (0..self.blocks.len()).map(move |block| (over, block)));
        blocks
            .map(|(over, block)| Candidates::new(self, block, over))
            .collect()
    }
}

impl<'a> Candidates<'a> {
    fn new(study: &'a Study, block: usize, over: &[usize]) -> Candidates<'a> {
        let groups = &study.blocks[block].groups;
        let is_chosen = |group: &AxisGroup| over.iter().any(|row| group.has(*row));
        let (mut chosen, mut physical, mut stride) = (Vec::new(), vec![0], 1);
        for (at, group) in groups.iter().enumerate().rev() {
            match is_chosen(group) {
                true => chosen.push((at, stride)),
                false => {
                    let positions = (0..group.len()).map(|position| position * stride);
                    let added =
                        positions.flat_map(|offset| physical.iter().map(move |raw| offset + raw));
                    physical = added.collect();
                }
            }
            stride *= group.len();
        }
        chosen.reverse();
        Candidates {
            study,
            block,
            chosen,
            physical,
        }
    }

    fn block(&self) -> &'a Block {
        &self.study.blocks[self.block]
    }

    /// The groups to choose from.
    pub fn groups(&self) -> impl Iterator<Item = &'a AxisGroup> + '_ {
        let block = self.block();
        self.chosen.iter().map(|pair| &block.groups[pair.0])
    }

    /// Number of candidates.
    pub fn count(&self) -> u64 {
        self.groups().map(AxisGroup::len).product()
    }

    /// Number of physical cases of a candidate, if the condition of the block is always met.
    pub fn physical_cases(&self) -> usize {
        self.physical.len()
    }

    /// The positions of candidate `number`, the last group fastest.
    pub fn positions(&self, number: u64) -> Vec<u64> {
        let mut positions = vec![0; self.chosen.len()];
        let mut rest = number;
        for (position, (group, _)) in positions.iter_mut().zip(&self.chosen).rev() {
            let len = self.block().groups[*group].len();
            *position = rest % len;
            rest /= len;
        }
        positions
    }

    /// The first combination of a candidate.
    fn first(&self, positions: &[u64]) -> u64 {
        let pairs = self.chosen.iter().zip(positions);
        pairs.map(|((_, stride), position)| stride * position).sum()
    }

    /// Writes a physical case of a candidate over `case`, completed, and tests whether it is a case that breaks no rule.
    pub fn put(&self, positions: &[u64], physical: usize, case: &mut Case) -> bool {
        let (problem, block) = (&*self.study.problem, self.block());
        let raw = self.first(positions) + self.physical[physical];
        let met = block.put_and_test(problem, raw, case) == Some(true);
        if !met {
            block.put(problem, raw, case);
        }
        block.complete(problem, case).is_empty() && met
    }

    /// The cases of a candidate; `None` if no combination meets the condition of the block.
    pub fn candidate(&self, positions: &[u64]) -> Option<Alternative> {
        let problem = &*self.study.problem;
        let first = self.first(positions);
        let shifted = self.physical.iter().map(|raw| first + raw);
        let of_cases = shifted.filter(|raw| self.block().is_case(problem, *raw));
        let raws: Vec<u64> = of_cases.collect();
        (!raws.is_empty()).then_some(Alternative {
            name: String::new(),
            values: Vec::new(),
            block: self.block,
            raws,
            tests: Vec::new(),
        })
    }

    /// All candidates, in the order of the cases.
    pub fn listed(&self) -> Vec<Alternative> {
        let each = (0..self.count()).filter_map(|number| self.candidate(&self.positions(number)));
        let mut listed: Vec<Alternative> = each.collect();
        listed.sort_by_key(|candidate| candidate.raws[0]);
        listed
    }
}
