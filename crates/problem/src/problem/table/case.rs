//! One case: a value for each parameter of a problem.

use super::schema::Schema;
use crate::metrics::steps;
use crate::problem::Problem;
use crate::problem::numbers::parameter::{self, Value};
use crate::problem::numbers::text::Text;
use std::sync::Arc;

/// The values of one case, in the order of the problem's table; `None` for a parameter that does not apply.
///
/// In the bars of `[I]` the spring k_I = 10 has gamma = k_I L/(n E A) = 0.1 with 10 elements:
///
/// ```
/// use slipgap_problem::problem::{self, Case, numbers::parameter::Value};
///
/// let problem = problem::find("bar-impact").expect("a problem");
/// let given = [
///     ("k_I", Value::Number(10.0)),
///     ("n", Value::Whole(10)),
///     ("dt", Value::Number(0.05)),
///     ("duration", Value::Number(1.5)),
/// ];
/// let (case, violations) = Case::given(&*problem, &given);
/// assert_eq!(violations, []);
/// assert_eq!(case.number("gamma"), Some(0.1));
/// assert_eq!(case.steps(), 30);
/// ```
#[derive(Debug, Clone)]
pub struct Case {
    /// The problem's schema.
    pub schema: Arc<Schema>,
    /// One entry for each row of the table.
    pub values: Vec<Option<Value>>,
    /// Its number in the study, for programs of others; 0 where it is not known.
    pub number: u64,
}

impl Case {
    /// A case without values.
    pub fn new(schema: &Arc<Schema>) -> Case {
        let values = vec![None; schema.parameters.len()];
        Case {
            schema: schema.clone(),
            values,
            number: 0,
        }
    }

    /// A completed case from parameters by name, the others with their defaults, and the rules that it breaks.
    pub fn given(problem: &dyn Problem, given: &[(&str, Value)]) -> (Case, Vec<Violation>) {
        let mut case = problem.schema().case(given);
        let broken = problem.complete(&mut case);
        (case, broken)
    }

    /// The default of a row of the table; `None` if it has none or does not apply.
    pub fn default_at(&self, row: usize) -> Option<Value> {
        let parameter = &self.schema.parameters[row];
        let applies = parameter
            .applies
            .as_ref()
            .is_none_or(|on| on.allows(self.choice(on.governor)));
        match parameter.default {
            parameter::Default::Is(value) => Some(value).filter(|_| applies),
            parameter::Default::Required | parameter::Default::Follows(_) => None,
        }
    }

    /// The value of the parameter `name`, if it applies.
    pub fn get(&self, name: &str) -> Option<Value> {
        let row = self.schema.parameters.iter().position(|p| p.name == name)?;
        self.values[row]
    }

    /// The number `name`; `None` if it does not apply.
    pub fn number(&self, name: &str) -> Option<f64> {
        self.get(name)?.as_f64()
    }

    /// Number of steps N of a completed case.
    pub fn steps(&self) -> u64 {
        let number = |row| self.at(row).unwrap_or(f64::NAN);
        steps(number(self.schema.duration), number(self.schema.step))
    }

    /// The number in a row of the table; `None` if it does not apply.
    pub fn at(&self, row: usize) -> Option<f64> {
        self.values[row]?.as_f64()
    }

    /// The name in a row of the table; empty if it does not apply.
    pub fn name_at(&self, row: usize) -> &'static str {
        self.values[row].map_or("", Value::name)
    }

    /// The name chosen for `name`; empty if it does not apply.
    pub fn choice(&self, name: &str) -> &'static str {
        self.get(name).map_or("", Value::name)
    }
}

/// A rule across parameters that a case breaks.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Violation {
    /// The parameter that messages refer to: at its value if it is given, else at the opening brace of the block.
    pub parameter: Text,
    /// What is wrong and what is allowed.
    pub message: String,
    /// Byte offset in the study of the value that breaks the rule, if it is not a parameter; `parameter` is then its path.
    pub at: Option<usize>,
}

impl Violation {
    /// All rules that a case breaks, in one line; `None` if it breaks none.
    pub fn all(violations: &[Violation]) -> Option<String> {
        let one = |violation: &Violation| format!("{}: {}", violation.parameter, violation.message);
        let texts: Vec<String> = violations.iter().map(one).collect();
        (!texts.is_empty()).then(|| texts.join("; "))
    }
}

impl Schema {
    /// A case from parameters by name, the others at their defaults; values that follow from others are not filled in.
    pub fn case(self: &Arc<Schema>, given: &[(&str, Value)]) -> Case {
        let mut case = Case::new(self);
        for (row, parameter) in self.parameters.iter().enumerate() {
            let pair = given.iter().find(|(name, _)| *name == parameter.name);
            // A name that a default depends on precedes it in the table.
            case.values[row] = pair
                .map(|(_, value)| *value)
                .or_else(|| case.default_at(row));
        }
        case
    }
}
