//! What a metric is divided by: the metric of a case that differs in some parameters only.

use super::Over;
use slipgap_solver::problem::Case;
use slipgap_study::Filter;
use slipgap_study::alike;
use slipgap_study::faults::{Faults, join};
use slipgap_study::scope::Scope;
use slipgap_study::tree::Node;

/// Most pairs of cases that are compared to find the partners. This takes less than a second.
const MOST_PAIRS: u64 = 10_000_000;

impl Over {
    /// Whether the metric of one case may be divided by that of `other`.
    pub fn pairs(&self, case: &Case, other: &Case) -> bool {
        self.filter.matches(other) && self.alike(case, other)
    }

    /// Whether two cases agree in the shared parameters that both have.
    fn alike(&self, case: &Case, other: &Case) -> bool {
        self.shared.iter().all(|row| agree(case, other, *row))
    }
}

/// Whether two cases agree in a parameter, or one of them does not have it.
fn agree(case: &Case, other: &Case, row: usize) -> bool {
    match (case.values[row], other.values[row]) {
        (Some(a), Some(b)) => a.matches(b),
        (None, _) | (_, None) => true,
    }
}

/// Decodes `over`. Every case that `chosen` selects must have one partner.
pub(super) fn over(
    node: &Node,
    path: &str,
    chosen: &Filter,
    scope: &Scope,
    faults: &mut Faults,
) -> Option<Over> {
    let filter = scope.filter(node, path, faults)?;
    if filter.0.is_empty() {
        faults.must_be(node, path, "an object with at least one parameter");
        return None;
    }
    let table = scope.problem.parameters();
    if let Some((row, _)) = filter.0.iter().find(|(_, wanted)| wanted.len() > 1) {
        let message = "must be one value, since a metric is divided by that of one case";
        faults.add(node.at, &join(path, &table[*row].name), message);
        return None;
    }
    let rows: Vec<usize> = filter.0.iter().map(|(row, _)| *row).collect();
    let shared = alike::unaffected(&*scope.problem, &scope.blocks, &rows);
    let over = Over { filter, shared };
    match fault(&over, chosen, scope) {
        Some(message) => {
            faults.add(node.at, path, message);
            None
        }
        None => Some(over),
    }
}

/// The first case without partner or with several, as a message.
fn fault(over: &Over, chosen: &Filter, scope: &Scope) -> Option<String> {
    let [cases, others] = [chosen, &over.filter].map(|filter| scope.select(filter).count() as u64);
    if cases.saturating_mul(others) > MOST_PAIRS {
        return Some(format!(
            "compares {cases} cases with {others} others; allowed: at most {MOST_PAIRS} pairs; choose fewer in \"where\""
        ));
    }
    let others: Vec<Case> = scope.cases(&over.filter).collect();
    let partners = |case: &Case| -> Vec<&Case> {
        others
            .iter()
            .filter(|other| over.alike(case, other))
            .collect()
    };
    scope
        .cases(chosen)
        .find_map(|case| match partners(&case).as_slice() {
            [_] => None,
            [] => Some(missing(over, scope, &case, &others)),
            [one, two, ..] => Some(ambiguous(over, scope, &case, [one, two])),
        })
}

/// The message that a case has no partner, with a value that no possible partner has.
fn missing(over: &Over, scope: &Scope, case: &Case, others: &[Case]) -> String {
    let alone = |row: &&usize| others.iter().all(|other| !agree(case, other, **row));
    let reason = match over.shared.iter().find(alone) {
        Some(row) => format!("; none of them has {}", alike::values(case, &[*row])),
        None => String::new(),
    };
    format!(
        "no case with {} is otherwise the same as the case with {}{reason}",
        wanted(over, case),
        described(over, scope, case)
    )
}

/// The message that a case has several partners, with what distinguishes them.
fn ambiguous(over: &Over, scope: &Scope, case: &Case, [one, two]: [&Case; 2]) -> String {
    let table = scope.problem.parameters();
    let differs = |row: &&usize| {
        !agree(one, two, **row) || one.values[**row].is_some() != two.values[**row].is_some()
    };
    let differing = over.shared.iter().filter(differs);
    let names: Vec<&str> = differing.map(|row| &*table[*row].name).collect();
    let advice = match names.as_slice() {
        [] => "; they have the same parameters".to_owned(),
        names => format!(
            "; they differ in {}, which \"over\" must give",
            names.join(", ")
        ),
    };
    format!(
        "several cases with {} are otherwise the same as the case with {}{advice}",
        wanted(over, case),
        described(over, scope, case)
    )
}

/// The values of the partner.
fn wanted(over: &Over, case: &Case) -> String {
    over.text(&case.schema.parameters)
}

/// The values of a case that vary in the study.
fn described(over: &Over, scope: &Scope, case: &Case) -> String {
    let all = Filter::default();
    let given = over.filter.0.iter().map(|(row, _)| *row);
    let mut rows: Vec<usize> = given.chain(over.shared.iter().copied()).collect();
    rows.retain(|row| scope.levels(&all, *row).len() > 1);
    rows.sort_unstable();
    alike::values(case, &rows)
}
