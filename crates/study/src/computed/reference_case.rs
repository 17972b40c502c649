//! The reference case of a ratio: the case that differs in some parameters only.

use crate::cases::scope::Scope;
use slipgap_cases::alike;
use slipgap_cases::block::Block;
use slipgap_cases::filter::Filter;
use slipgap_cases::{Found, Partners};
use slipgap_problem::problem::numbers::parameter::Parameter;
use slipgap_problem::problem::{Case, Problem};

/// The values of a reference case. A case goes with the one that has them and is otherwise the same.
#[derive(Debug, Clone)]
pub struct Reference {
    /// The values, one for each parameter.
    pub filter: Filter,
    /// Rows of the parameters that both cases share, unless one of them does not have the parameter.
    pub shared: Vec<usize>,
}

impl Reference {
    /// The reference with one value for each parameter of the filter. What changes with these parameters is not shared.
    pub fn new(filter: Filter, problem: &dyn Problem, blocks: &[Block]) -> Reference {
        let rows: Vec<usize> = filter.0.iter().map(|(row, _)| *row).collect();
        let shared = alike::unaffected(problem, blocks, &rows);
        Reference { filter, shared }
    }

    /// Whether `other` is the reference case of a case.
    pub fn pairs(&self, case: &Case, other: &Case) -> bool {
        self.filter.matches(other) && self.shared.iter().all(|row| agree(case, other, *row))
    }

    /// The values, as in `law = kelvin-voigt, n = 5`.
    pub fn text(&self, table: &[Parameter]) -> String {
        let values = self.filter.0.iter().flat_map(|(row, wanted)| {
            let name = &table[*row].name;
            wanted.iter().map(move |value| format!("{name} = {value}"))
        });
        values.collect::<Vec<_>>().join(", ")
    }

    /// The message about a first case among those `chosen` that has no reference case or several; `key` names what gives the
    /// values.
    pub fn fault(&self, chosen: &Filter, scope: &Scope, key: &str) -> Option<String> {
        self.first(chosen, scope, key, |found| !matches!(found, Found::One(_)))
    }

    /// The message about a first case of the study that has several reference cases, or that no case has one.
    pub fn fault_of_ratio(&self, scope: &Scope, key: &str) -> Option<String> {
        let no_filter = Filter::default();
        let several = self.first(&no_filter, scope, key, |found| {
            matches!(found, Found::Several(..))
        });
        several.or_else(|| {
            let others = self.others(scope);
            let mut partners = self.partners(&others);
            let mut cases = scope.cases(&no_filter).take(MOST_TESTED);
            match cases.any(|case| matches!(partners.find(&case), Found::One(_))) {
                true => None,
                false => self.first(&no_filter, scope, key, |_| true),
            }
        })
    }

    fn partners(&self, others: &[Case]) -> Partners {
        Partners::new(&self.shared, &others.iter().collect::<Vec<_>>())
    }

    fn others(&self, scope: &Scope) -> Vec<Case> {
        scope.cases(&self.filter).take(MOST_TESTED).collect()
    }

    /// The message about the first case of which `is_fault` says so.
    fn first(
        &self,
        chosen: &Filter,
        scope: &Scope,
        key: &str,
        is_fault: impl Fn(&Found) -> bool,
    ) -> Option<String> {
        let others = self.others(scope);
        let mut partners = self.partners(&others);
        let mut cases = scope.cases(chosen).take(MOST_TESTED);
        cases.find_map(|case| match partners.find(&case) {
            found if !is_fault(&found) => None,
            Found::Several(one, two) => {
                Some(self.ambiguous(scope, &case, [&others[one], &others[two]], key))
            }
            Found::None | Found::One(_) => Some(self.missing(scope, &case, &others)),
        })
    }

    /// The message that a case has no reference case, with a value that none of them has.
    fn missing(&self, scope: &Scope, case: &Case, others: &[Case]) -> String {
        let alone = |row: &&usize| others.iter().all(|other| !agree(case, other, **row));
        let reason = match self.shared.iter().find(alone) {
            Some(row) => format!("; none of them has {}", alike::values(case, &[*row])),
            None => String::new(),
        };
        format!(
            "no case with {} is otherwise the same as the case with {}{reason}",
            self.text(&case.schema.parameters),
            self.described(scope, case)
        )
    }

    /// The message that a case has several reference cases, with what distinguishes them.
    fn ambiguous(&self, scope: &Scope, case: &Case, [one, two]: [&Case; 2], key: &str) -> String {
        let table = scope.problem.parameters();
        let differs = |row: &&usize| {
            !agree(one, two, **row) || one.values[**row].is_some() != two.values[**row].is_some()
        };
        let differing = self.shared.iter().filter(differs);
        let names: Vec<&str> = differing.map(|row| &*table[*row].name).collect();
        let advice = match names.as_slice() {
            [] => "; they have the same parameters".to_owned(),
            names => format!(
                "; they differ in {}, which {key} must give",
                names.join(", ")
            ),
        };
        format!(
            "several cases with {} are otherwise the same as the case with {}{advice}",
            self.text(&case.schema.parameters),
            self.described(scope, case)
        )
    }

    /// The values of a case that vary in the study.
    fn described(&self, scope: &Scope, case: &Case) -> String {
        let no_filter = Filter::default();
        let given = self.filter.0.iter().map(|(row, _)| *row);
        let mut rows: Vec<usize> = given.chain(self.shared.iter().copied()).collect();
        rows.retain(|row| scope.levels(&no_filter, *row).len() > 1);
        rows.sort_unstable();
        alike::values(case, &rows)
    }
}

/// Most cases that are tested before a run. Others with a fault have no value.
const MOST_TESTED: usize = 100_000;

/// Whether two cases agree in a parameter, or one of them does not have it.
fn agree(case: &Case, other: &Case, row: usize) -> bool {
    match (case.values[row], other.values[row]) {
        (Some(a), Some(b)) => a.matches(b),
        (None, _) | (_, None) => true,
    }
}
