//! Parameters that vary among the cases of a figure that could not show it.

use super::taken::Values;
use crate::study::report::{Faults, join};
use crate::study::scope::Scope;
use crate::study::{Figure, FigureKind};

/// Reports parameters that vary, although they neither are among those `told` apart nor follow from them.
pub(super) fn check(
    figure: &Figure,
    told: &[usize],
    values: &Values,
    scope: &Scope,
    faults: &mut Faults,
) {
    let table = scope.problem.parameters();
    let varies = |row: &usize| scope.levels(&figure.filter, *row).len() > 1;
    let free = |row: &usize| {
        !told.contains(row) && varies(row) && !scope.follows(&figure.filter, *row, told)
    };
    let names: Vec<&str> = (0..table.len())
        .filter(free)
        .map(|row| table[row].name)
        .collect();
    let vary = match names.as_slice() {
        [] => return,
        [one] => format!("{one} varies"),
        several => format!("{} vary", several.join(", ")),
    };
    let by = |kind: &str| {
        format!(
            "a {kind} figure with \"by\" shows one case a place of a curve, and {vary}; fix it here or leave out \"by\""
        )
    };
    let message = match figure.kind {
        FigureKind::Map { .. } => format!("a map shows one case a place, and {vary}; fix it here"),
        FigureKind::Metric { .. } => by("metric"),
        FigureKind::Convergence { .. } => by("convergence"),
        FigureKind::History { .. } => {
            format!(
                "a history figure with \"by\" shows one case a curve, and {vary}; fix it here or leave out \"by\""
            )
        }
        _ => format!("a budget shows one case a place, and {vary}; fix it here"),
    };
    faults.add(values.at("where"), &join(values.path, "where"), message);
}

#[cfg(test)]
mod tests {
    use crate::study::parse;

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
    fn curves_of_several_cases_are_refused() {
        let law = r#""law": "displacement-control""#;
        for kind in [
            r#""kind": "metric", "x": "dT", "y": "rms_error""#,
            r#""kind": "convergence", "y": "rms_error""#,
        ] {
            let mixed = wrong(&format!(r#"{kind}, "by": "alpha", "where": {{{law}}}"#));
            assert!(mixed.contains("and x0 varies; fix it here"), "{mixed}");
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
            mixed.contains("one case a curve, and x0 varies; fix it here"),
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
