//! The cases of an alternative at points of its free parameters.

use super::{Alternative, Free};
use crate::{Calibrate, Recommend, Study};
use slipgap_cases::axis::group::{Axis, AxisGroup};
use slipgap_cases::axis::values::Values;
use slipgap_cases::block::Block;
use slipgap_cases::formulas::derived::{Condition, Derived};
use slipgap_cases::formulas::formula_table::FormulaTable;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::table::cases::Cases;
use slipgap_problem::problem::{Case, Violation};

/// Makes the cases of an alternative at points of some free parameters; the others have the values of the study.
#[derive(Debug, Clone)]
pub struct PointCases<'a> {
    study: &'a Study,
    alternative: &'a Alternative,
    free: Vec<Free>,
}

impl Study {
    /// The cases of an alternative at points of these free parameters.
    pub fn point_cases<'a>(
        &'a self,
        alternative: &'a Alternative,
        free: &[Free],
    ) -> PointCases<'a> {
        PointCases {
            study: self,
            alternative,
            free: free.to_vec(),
        }
    }

    /// The free parameters that the block of an alternative gives, in the order of the file.
    pub fn free_of(&self, alternative: &Alternative) -> Vec<Free> {
        let parameters = self
            .calibrate
            .iter()
            .flat_map(|calibrate: &Calibrate| &calibrate.free);
        self.given(alternative, parameters)
    }

    /// The same of a candidate of `recommend`.
    pub fn free_of_candidate(&self, candidate: &Alternative) -> Vec<Free> {
        let parameters = self
            .recommend
            .iter()
            .flat_map(|recommend: &Recommend| &recommend.free);
        self.given(candidate, parameters)
    }

    fn given<'a>(
        &self,
        alternative: &Alternative,
        free: impl Iterator<Item = &'a Free>,
    ) -> Vec<Free> {
        let block = &self.blocks[alternative.block];
        let given = free.filter(|free| block.gives(free.parameter));
        given.copied().collect()
    }
}

impl PointCases<'_> {
    /// The free parameters.
    pub fn free(&self) -> &[Free] {
        &self.free
    }

    /// Number of cases at a point.
    pub fn tests(&self) -> usize {
        self.alternative.cases()
    }

    /// The values of the free parameters at a point of the unit cube.
    pub fn values(&self, point: &[f64]) -> Vec<f64> {
        let free = self.free.iter().zip(point);
        free.map(|(free, u)| free.range.at(*u)).collect()
    }

    /// The cases at points of the unit cube, completed: those of the first test at all points, then those of the second and so
    /// on. A case that breaks a rule, or the condition of its block, cannot be solved.
    pub fn cases(&self, points: &[Vec<f64>]) -> Cases {
        let values: Vec<Vec<f64>> = points.iter().map(|point| self.values(point)).collect();
        self.cases_with(&values)
    }

    /// The same with values of the free parameters instead of points.
    pub fn cases_with(&self, values: &[Vec<f64>]) -> Cases {
        let problem = &*self.study.problem;
        let mut cases = Cases::new(problem.schema());
        let mut case = Case::new(problem.schema());
        let given = &self.study.blocks[self.alternative.block];
        for raw in &self.alternative.raws {
            let block = self.block(given, *raw, values);
            for case_number in 0..values.len() as u64 {
                let met = block.put_and_test(problem, case_number, &mut case);
                if met != Some(true) {
                    block.put(problem, case_number, &mut case);
                }
                let violations = block.complete(problem, &mut case);
                let unmet = || {
                    let condition = block.when.as_ref().map_or("", |when| &when.text);
                    Some(format!("when: {condition} is not met"))
                };
                let violated = Violation::all(&violations);
                let refused = violated.or_else(|| (met != Some(true)).then(unmet)?);
                let next = cases.len() as u64;
                cases.push_at(next, &case, refused);
            }
        }
        cases
    }

    /// The block with the values of one combination and an axis of points.
    fn block(&self, template: &Block, raw: u64, values: &[Vec<f64>]) -> Block {
        let is_free = |axis: &Axis| {
            let mut free = self.free.iter();
            free.any(|free| free.parameter == axis.parameter)
        };
        let positions = template.positions(raw);
        let one = |(group, position): (&AxisGroup, &u64)| AxisGroup {
            axes: {
                let axes = group.axes.iter().filter(|axis| !is_free(axis));
                axes.map(|axis| Axis {
                    parameter: axis.parameter,
                    values: Values::Listed(vec![axis.values.at(*position as usize)]),
                })
                .collect()
            },
        };
        let groups = template.groups.iter().zip(&positions).map(one);
        let axis = |(i, free): (usize, &Free)| Axis {
            parameter: free.parameter,
            values: values
                .iter()
                .map(|column| Value::Number(column[i]))
                .collect(),
        };
        let points = AxisGroup {
            axes: self.free.iter().enumerate().map(axis).collect(),
        };
        let groups = groups.chain([points]);
        let mut block = Block::of(groups.filter(|group| !group.axes.is_empty()).collect());
        for derived in &template.derived {
            // A table would have a value for each point, too.
            let formula = FormulaTable::new(derived.formula.formula.clone(), &block);
            block.derived.push(Derived {
                formula,
                text: derived.text.clone(),
                ..*derived
            });
        }
        block.when = template.when.as_ref().map(|when| Condition {
            text: when.text.clone(),
            formula: FormulaTable::new(when.formula.formula.clone(), &block),
        });
        block
    }
}
