//! Parameters that vary among the cases of a figure that could not show it.

use super::checker::Checker;
use slipgap_cases::alike::Groups;
use slipgap_problem::problem::numbers::parameter::Default;

/// What a user can do besides narrowing the cases, for kinds with the key `by`.
pub(super) const OR_WITHOUT_BY: &str = " or leave out \"by\"";

/// Reports parameters that vary, although they neither are among those that the figure distinguishes nor follow from them.
/// `what` says how many cases the figure shows, `or` what else a user can do.
pub(super) fn check(checker: &mut Checker, distinguished: &[usize], what: &str, or: &str) {
    let (figure, scope) = (checker.figure, checker.scope);
    let table = scope.problem.parameters();
    let free = |row: &usize| {
        let lost = checker
            .reduced
            .iter()
            .any(|reduced| reduced.lost.contains(row));
        !lost
            && !distinguished.contains(row)
            && checker.levels(*row).len() > 1
            && !scope.follows(&figure.filter, *row, distinguished)
    };
    let names: Vec<&str> = (0..table.len())
        .filter(free)
        .map(|row| &*table[row].name)
        .collect();
    if names.is_empty() {
        return;
    }
    // What the problem computes has no given values: it replaces one parameter that it follows from, if each
    // of its values belongs to one case.
    let empty = |row: &&usize| checker.levels(**row).is_empty();
    let (worked_out, lacking): (Vec<usize>, Vec<usize>) = distinguished
        .iter()
        .filter(empty)
        .partition(|row| matches!(table[**row].default, Default::Follows(_)));
    // A parameter that no case has was reported as such.
    if !lacking.is_empty()
        || names.len() <= worked_out.len() && one_case_a_place(checker, distinguished)
    {
        return;
    }
    let vary = match names.as_slice() {
        [one] => format!("{one} varies"),
        several => format!("{} vary", several.join(", ")),
    };
    let message = format!("{what}, but {vary}; choose one value in \"where\"{or}");
    checker.fault("where", message);
}

/// Whether no two cases, or groups of reduced cases, have the same values of the distinguished parameters.
fn one_case_a_place(checker: &Checker, distinguished: &[usize]) -> bool {
    let mut places = Groups::new(distinguished);
    checker.cases().all(|case| places.place(&case).1)
}

#[cfg(test)]
mod tests {
    use crate::parse;

    /// What is wrong with a figure of cases that are alpha x x0 x dT, with a duration that follows from dT.
    fn wrong(figure: &str) -> String {
        let study = format!(
            r#"{{"problem": "friction-oscillator", "blocks": [
              {{"parameters": {{"law": "displacement-control", "alpha": [0.1, 1], "x0": [8, 12], "dT": ["pi/10", "pi/20"],
                               "duration": "80*dT"}}}},
              {{"parameters": {{"law": "velocity-control", "beta": [0.1, 0.3], "x0": [8, 12], "dT": ["pi/10", "pi/20"],
                               "duration": "8*pi"}}, "zip": [["beta", "x0"]]}}],
              "figures": [{{"name": "f", {figure}}}]}}"#
        );
        parse("s", &study)
            .err()
            .map_or(String::new(), |e| e.to_string())
    }

    #[test]
    fn a_value_that_the_problem_works_out_takes_the_place_of_one_given() {
        let wrong = |dt: &str, x: &str, by: &str| {
            let study = format!(
                r#"{{"problem": "bar-impact", "parameters": {{"k_I": [10, 100], "n": [4, 8], "dt": {dt}, "duration": 1}},
                  "figures": [{{"name": "f", "kind": "metric", "y": "peak_force", "x": "{x}", "by": "{by}"}}]}}"#
            );
            parse("s", &study)
                .err()
                .map_or(String::new(), |e| e.to_string())
        };
        assert_eq!(wrong("0.01", "gamma", "n"), "");
        assert_eq!(wrong("0.01", "n", "gamma"), "");
        let also = wrong("[0.01, 0.02]", "gamma", "n");
        assert!(also.contains("k_I, dt vary"), "{also}");
    }

    #[test]
    fn curves_of_several_cases_are_refused() {
        let law = r#""law": "displacement-control""#;
        for kind in [
            r#""kind": "metric", "x": "dT", "y": "rms_error""#,
            r#""kind": "convergence", "y": "rms_error""#,
        ] {
            let mixed = wrong(&format!(r#"{kind}, "by": "alpha", "where": {{{law}}}"#));
            assert!(
                mixed.contains("but x0 varies; choose one value in \"where\""),
                "{mixed}"
            );
            let fixed = wrong(&format!(
                r#"{kind}, "by": "alpha", "where": {{{law}, "x0": 12}}"#
            ));
            assert_eq!(fixed, "");
            // Without "by" every case has its curve.
            assert_eq!(wrong(&format!(r#"{kind}, "where": {{{law}}}"#)), "");
            // x0 advances with beta, duration follows from dT.
            let zipped = wrong(&format!(
                r#"{kind}, "by": "beta", "where": {{"law": "velocity-control"}}"#
            ));
            assert_eq!(zipped, "");
        }
        let history = r#""kind": "history", "by": "alpha""#;
        let mixed = wrong(&format!(r#"{history}, "where": {{{law}, "dT": "pi/10"}}"#));
        assert!(
            mixed.contains("one case for each curve, but x0 varies; choose one value in \"where\""),
            "{mixed}"
        );
        let both = wrong(&format!(r#"{history}, "where": {{{law}}}"#));
        assert!(both.contains("dT, duration, x0 vary"), "{both}");
        let panels = wrong(&format!(
            r#"{history}, "panels": "x0", "where": {{{law}, "dT": "pi/10"}}"#
        ));
        assert_eq!(panels, "");
    }
}
