//! Example studies.

/// The examples, by the name of their problem.
const EXAMPLES: [(&str, &str); 3] = [
    (
        "friction-oscillator",
        include_str!("start/friction-oscillator.json"),
    ),
    ("bar-impact", include_str!("start/bar-impact.json")),
    ("structure", include_str!("start/structure.json")),
];

/// A small study of a problem with remarks, with `NAME` for its name and `SCHEMA` for the path of the schema; `None` if there
/// is no example.
pub fn start(problem: &str) -> Option<&'static str> {
    let mut examples = EXAMPLES.into_iter();
    let (_, text) = examples.find(|(name, _)| *name == problem)?;
    Some(text)
}

#[cfg(test)]
mod tests {
    use super::*;
    use slipgap_problem::problem;

    #[test]
    fn every_problem_has_an_example_of_its_own() {
        for problem in problem::names() {
            let name = format!("\"problem\": \"{problem}\"");
            assert!(
                start(problem).is_some_and(|text| text.contains(&name)),
                "{name}"
            );
        }
    }
}
