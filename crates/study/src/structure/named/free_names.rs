//! The names that a study of a textbook problem gives to numbers of its own, for expressions.

use super::names::name_fault;
use crate::source::faults::Faults;
use crate::source::tree::Node;
use crate::structure::programs::KEY;
use crate::structure::reading::given::{given, members, under};
use crate::structure::reading::reader::is_name;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::numbers::parameter::{Default, Kind, Parameter, Range};
use slipgap_problem::problem::structure::tables::schema::symbol;
use std::sync::Arc;

/// The problem with the parameters of `root` that it does not have, if an expression of a parameter or of a condition contains them; of a
/// study that is not `whole`, with all of them.
pub(crate) fn with_free_names(
    problem: Arc<dyn Problem>,
    (root, whole): (&Node, bool),
    faults: &mut Faults,
) -> Arc<dyn Problem> {
    let Some(textbook) = problem.as_textbook() else {
        return problem;
    };
    let given = given(root);
    let mut table = problem.parameters().to_vec();
    let own = table.len();
    for (member, _) in &given {
        let name = &*member.key;
        let is_group = |known: &Parameter| known.name.split('.').next() == Some(name);
        if is_name(name) && !table.iter().any(is_group) {
            table.push(free_number(name));
        }
    }
    let is_choice = |name: &str| {
        let known = table.iter().find(|known| known.name == name);
        known.is_some_and(|known| matches!(known.kind, Kind::Choice(_)))
    };
    let numbers = given.iter().filter(|(member, _)| !is_choice(&member.key));
    let values = numbers.flat_map(|(member, _)| member.node.text());
    let mut conditions = Vec::new();
    under(root, "when", &mut conditions);
    let programs = root.get(KEY.name).map_or(&[][..], members).iter();
    let numbers = programs.filter_map(|program| program.node.get("parameters"));
    let of_programs = numbers
        .flat_map(members)
        .filter_map(|number| number.node.text());
    let values = values
        .chain(of_programs)
        .filter_map(|text| Formula::number(text, &table).ok());
    let texts = conditions.into_iter();
    let conditions = texts.filter_map(|text| Formula::condition(text, &table).ok());
    let formulas: Vec<Formula> = values.chain(conditions).collect();
    let is_used = |row: usize| formulas.iter().any(|formula| formula.uses().contains(&row));
    let free: Vec<Parameter> = (own..table.len())
        .filter(|row| !whole || is_used(*row))
        .map(|row| table[row].clone())
        .collect();
    if free.is_empty() {
        return problem;
    }
    let metrics = problem.metrics().iter().map(|metric| &*metric.name);
    let of_parameters = table[..own].iter().map(Parameter::column_name);
    let columns: Vec<&str> = metrics.chain(of_parameters).chain(["case"]).collect();
    for (member, path) in &given {
        let name = &*member.key;
        if !free.iter().any(|parameter| parameter.name == name) {
            continue;
        }
        if let Some(message) = name_fault(name, columns.contains(&name)) {
            faults.add(member.at, path, message);
        }
    }
    textbook.with_parameters(free)
}

/// A number that a study names.
pub(crate) fn free_number(name: &str) -> Parameter {
    let default = Default::Follows("only expressions contain it".into());
    let kind = Kind::Number(Range::Any);
    let unnamed = Parameter::new(["", "", "1"], kind, default, "number of expressions");
    Parameter {
        name: name.to_owned().into(),
        symbol: symbol(name).into(),
        ..unnamed.with_column_if_given()
    }
}

#[cfg(test)]
mod tests {
    use crate::{Study, parse};

    fn bars(parameters: &str) -> Result<Study, String> {
        let text = format!(
            r#"{{ "problem": "bar-impact", "parameters": {{ "law": "impact-spring", "gamma": 2, "duration": 1.5, {parameters} }} }}"#
        );
        parse("study.json", &text).map_err(|error| error.to_string())
    }

    /// The metrics of all cases.
    fn metrics(study: &Study) -> Vec<Vec<Option<f64>>> {
        let solved = study.cases().map(|case| study.problem.solve(&case, &[]));
        solved
            .map(|solution| solution.expect("a solution").metrics)
            .collect()
    }

    #[test]
    fn a_free_number_gives_the_motion_of_the_numbers_that_follow_from_it() {
        // Half an element in a step and two of them: dt = courant/(2 n) T_I, by hand.
        let free = bars(r#""n": 10, "courant": [0.5, 2], "dt": "courant/(2*n)""#).unwrap();
        let direct = bars(r#""n": 10, "dt": [0.025, 0.1]"#).unwrap();
        assert_eq!(metrics(&free), metrics(&direct));
        let row = free.problem.parameters().len() - 1;
        assert!(free.parameter_columns().contains(&row));
        let values = free.cases().map(|case| case.number("courant"));
        assert_eq!(values.collect::<Vec<_>>(), [Some(0.5), Some(2.0)]);
        // One in a condition alone; in units, with which bars have other doubts.
        let limited = r#"{ "problem": "bar-impact", "units": { "length": "m", "time": "s", "force": "kN" },
            "parameters": { "law": "impact-spring", "gamma": 2, "duration": 1.5, "n": 10, "dt": 0.025, "most": [1, 20] },
            "when": "n <= most" }"#;
        let study = parse("study.json", limited);
        let count = study.map(|study| study.cases().count());
        assert_eq!(count.map_err(|error| error.to_string()), Ok(1));
    }

    #[test]
    fn a_free_name_must_be_used_and_free() {
        let fault = |parameters: &str| bars(parameters).unwrap_err();
        let unused = fault(r#""n": 10, "courant": 0.5, "dt": 0.025"#);
        assert!(
            unused.contains("parameters.courant: unknown key \"courant\"")
                && unused.contains("must be in an expression"),
            "{unused}"
        );
        let misspelt = fault(r#""n": 10, "durations": 2, "dt": 0.025"#);
        assert!(
            misspelt.contains("did you mean \"duration\"?"),
            "{misspelt}"
        );
        let unknown = fault(r#""n": 10, "dt": "courant/(2*n)""#);
        assert!(
            unknown.contains("must be one of the \"parameters\""),
            "{unknown}"
        );
        let metric = fault(r#""n": 10, "separations": 2, "dt": "separations/n""#);
        assert!(metric.contains("is a column of results.csv"), "{metric}");
        let function = fault(r#""n": 10, "sqrt": 2, "dt": 0.1"#);
        assert!(function.contains("unknown key \"sqrt\""), "{function}");
        let circle = fault(r#""n": 10, "a": "b", "b": "a", "dt": "a/n""#);
        assert!(circle.contains("circular reference"), "{circle}");
    }
}
