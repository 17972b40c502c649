//! The checks of figures of ensembles.

use super::checker::Checker;
use super::vary;
use crate::alike;
use slipgap_problem::problem::numbers::parameter::Default;

/// Reports parameters that cannot be along the axis of `kind` or distinguish its curves.
pub(super) fn check(checker: &mut Checker, x: Option<usize>, by: Option<usize>, kind: &str) {
    let scope = checker.scope;
    let Some(ensemble) = scope.ensemble.as_ref().filter(|rows| !rows.is_empty()) else {
        return;
    };
    let shared = alike::unaffected(&*scope.problem, &scope.blocks, ensemble);
    let table = scope.problem.parameters();
    let mut suitable = true;
    for (key, row) in [("x", x), ("by", by)] {
        let Some(row) = row else { continue };
        checker.has_values(key, row);
        if shared.contains(&row) {
            continue;
        }
        let name = &table[row].name;
        let given = scope.blocks.iter().any(|block| block.gives(row));
        let message = match (ensemble.contains(&row), &table[row].default) {
            (true, _) => format!("{name} is a parameter of the ensemble; choose another one"),
            (false, Default::Follows(_)) if !given => {
                format!("{name} follows from other parameters; choose one that the study gives")
            }
            (false, _) => {
                let varied: Vec<&str> = ensemble.iter().map(|row| &*table[*row].name).collect();
                let names = varied.join(", ");
                format!("{name} changes with the ensemble over {names}; choose another one")
            }
        };
        checker.fault(key, message);
        suitable = false;
    }
    if by.is_some() && by == x {
        checker.fault("by", "must be a parameter other than x");
        return;
    }
    if let Some(by) = by.filter(|_| suitable) {
        let distinguished: Vec<usize> = ensemble.iter().copied().chain(x).chain([by]).collect();
        let what = match x {
            Some(_) => {
                format!("a {kind} figure with \"by\" shows one ensemble at each point of a curve")
            }
            None => format!("a {kind} figure with \"by\" shows one ensemble for each value of it"),
        };
        vary::check(checker, &distinguished, &what, vary::OR_WITHOUT_BY);
    }
}
