//! The structure of a case as a picture.

use crate::Scale;
use crate::figure::checker::Checker;
use crate::figure::kinds::{Decoded, FigureKind, Kind, Needs};

/// Most masses and bars, and most springs, contacts and loads, whose names are legible on a page.
const MOST: [usize; 2] = [40, 120];

pub(in crate::figure::kinds) const KIND: Kind = Kind {
    name: "scheme",
    needs: Needs::Structure,
    meaning: "a picture of the structure of the first case",
    keys: &[],
    decode: |_, _| Some(FigureKind::Scheme(Scheme)),
};

/// The structure of the first case.
#[derive(Debug)]
pub struct Scheme;

impl Decoded for Scheme {
    fn limited_axes(&self) -> Option<([Scale; 2], usize)> {
        None
    }

    fn check_cases(&self, checker: &mut Checker) {
        let first = checker.cases().next();
        let Some(scheme) = first.and_then(|case| {
            checker
                .scope
                .problem
                .as_structure()
                .and_then(|structure| structure.scheme(&case))
        }) else {
            return;
        };
        let links = scheme.links.len() + scheme.loads.len();
        for (count, most, what) in [
            (scheme.parts.len(), MOST[0], "masses and bars"),
            (links, MOST[1], "springs, contacts and loads"),
        ] {
            if count > most {
                let message = format!("a scheme shows at most {most} {what}, got {count}");
                checker.fault("kind", message);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::parse;

    #[test]
    fn only_structures_of_few_parts_have_a_scheme() {
        let told = |study: &str| {
            let wrong = parse("s", study).err().map(|e| e.to_string());
            wrong
                .unwrap_or_default()
                .lines()
                .next()
                .unwrap_or_default()
                .to_owned()
        };
        for kind in [r#"scheme""#, r#"spectrum", "y": "displacement""#] {
            let other = told(&format!(
                r#"{{"problem": "friction-oscillator",
"parameters": {{"law": "displacement-control", "alpha": 1, "dT": 0.1, "duration": 9}},
"figures": [{{"name": "f", "kind": "{kind}}}]}}"#
            ));
            let message = "s:3:35: figures[0].kind: friction-oscillator has no structure to draw; allowed: history, curve, metric,";
            assert!(other.contains(message), "{other}");
        }
        let masses = |count: usize| -> String {
            let masses: Vec<String> = (0..count).map(|i| format!("\"m{i}\": 1")).collect();
            told(&format!(
                r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}}, "metrics": ["peak(m1)"],
"structure": {{"masses": {{{}}}}},
"figures": [{{"name": "f", "kind": "scheme"}}]}}"#,
                masses.join(", ")
            ))
        };
        assert_eq!(masses(40), "");
        let many = masses(41);
        let message = "s:3:35: figures[0].kind: a scheme shows at most 40 masses and bars, got 41";
        assert!(many.contains(message), "{many}");
    }
}
