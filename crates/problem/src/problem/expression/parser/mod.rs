//! A Pratt parser: from a text to the steps of a formula.

mod operand;

use super::formula::{ExpressionFault, Formula, Step, UnknownName};
use super::tokens;
use crate::problem::Text;
use crate::problem::numbers::parameter;
use crate::problem::numbers::parameter::Parameter;

/// Most levels of nesting.
const DEEPEST: usize = 100;

/// The kind of an operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Number,
    Truth,
    /// The name of the parameter in a row of the table.
    Choice(usize),
    /// A name in quotes, at these bytes of the text.
    Quoted(usize, usize),
}

impl Formula {
    /// Parses a number. Names are parameters of `table`, pi and e. A name with brackets, such as `max(a3 - a2)`, is read as it is
    /// written in the table, before a function of the same name.
    pub fn number(text: &str, table: &[Parameter]) -> Result<Formula, ExpressionFault> {
        parse(text, table, Kind::Number)
    }

    /// Parses a condition: comparisons joined by `and`, `or`, `not`.
    pub fn condition(text: &str, table: &[Parameter]) -> Result<Formula, ExpressionFault> {
        parse(text, table, Kind::Truth)
    }
}

/// Parses `text`, which must be of `kind`.
fn parse(text: &str, table: &[Parameter], kind: Kind) -> Result<Formula, ExpressionFault> {
    let mut parser = Parser {
        text,
        table,
        offset: 0,
        depth: 0,
        last: None,
        steps: Vec::new(),
        uses: Vec::new(),
    };
    let found = parser.operand_and_operators(0)?;
    match parser.peek() {
        None if found == kind => Ok(Formula {
            names: parser
                .uses
                .iter()
                .map(|row| table[*row].name.clone())
                .collect(),
            steps: parser.steps,
            uses: parser.uses,
        }),
        None => {
            let message = match kind {
                Kind::Truth => "must be a condition, as in \"n > 2\"",
                Kind::Number | Kind::Choice(_) | Kind::Quoted(..) => "must be a number",
            };
            Err(fault(0, message))
        }
        Some(')') => Err(parser.fault("')' without '('")),
        Some('=') => Err(parser.fault("write == to compare")),
        Some(c) => {
            let hint = match c {
                ',' => "; the decimal sign is '.', and a list is written [0, 1]",
                c if c.is_alphabetic() => "; a product is written with *",
                _ => "",
            };
            let c = c.escape_debug();
            Err(parser.fault(format!("expected an operator, got '{c}'{hint}")))
        }
    }
}

fn fault(offset: usize, message: impl Into<String>) -> ExpressionFault {
    ExpressionFault {
        offset,
        message: message.into(),
        unknown: None,
    }
}

/// A name that is none of those allowed.
fn unknown(offset: usize, what: &str, name: &str, allowed: Vec<Text>) -> ExpressionFault {
    let (what, name) = (what.to_owned(), name.to_owned());
    ExpressionFault {
        offset,
        message: format!("unknown {what} \"{name}\"; allowed: {}", allowed.join(", ")),
        unknown: Some(Box::new(UnknownName {
            what,
            name,
            allowed,
        })),
    }
}

struct Parser<'a> {
    text: &'a str,
    table: &'a [Parameter],
    offset: usize,
    depth: usize,
    /// The last token, for the message about a missing operand.
    last: Option<&'a str>,
    steps: Vec<(Step, usize)>,
    uses: Vec<usize>,
}

type Outcome = Result<Kind, ExpressionFault>;

impl<'a> Parser<'a> {
    /// The next character that is not blank.
    fn peek(&mut self) -> Option<char> {
        let rest = &self.text[self.offset..];
        self.offset += rest.len() - rest.trim_start().len();
        self.text[self.offset..].chars().next()
    }

    /// Moves over `length` bytes and returns them.
    fn take(&mut self, length: usize) -> &'a str {
        let token = &self.text[self.offset..self.offset + length];
        self.offset += length;
        self.last = Some(token);
        token
    }

    fn fault(&self, message: impl Into<String>) -> ExpressionFault {
        fault(self.offset, message)
    }

    fn step(&mut self, step: Step, at: usize) {
        self.steps.push((step, at));
    }

    /// An operand and all operators after it with a binding power above `least`.
    fn operand_and_operators(&mut self, least: u8) -> Outcome {
        if self.depth == DEEPEST {
            return Err(self.fault(format!("nested more than {DEEPEST} deep")));
        }
        self.depth += 1;
        let mut kind = self.operand()?;
        let mut compared = false;
        while self.peek().is_some() {
            let Some(operator) = tokens::operator(&self.text[self.offset..]) else {
                break;
            };
            if operator.binds <= least {
                break;
            }
            let at = self.offset;
            if compared && operator.compares() {
                return Err(fault(at, "join two comparisons with and"));
            }
            compared = operator.compares();
            self.take(operator.token.len());
            let right = self.operand_and_operators(operator.right)?;
            kind = self.joined(kind, operator, right, at)?;
        }
        self.depth -= 1;
        Ok(kind)
    }

    /// Applies an operator to its two operands.
    fn joined(
        &mut self,
        left: Kind,
        operator: &tokens::Operator,
        right: Kind,
        at: usize,
    ) -> Outcome {
        let token = operator.token;
        let equality = matches!(token, "==" | "!=");
        let (row, quoted) = match (left, right) {
            (Kind::Number, Kind::Number) if !operator.joins() => {
                self.step(Step::Two(operator.function), at);
                return Ok(if operator.compares() {
                    Kind::Truth
                } else {
                    Kind::Number
                });
            }
            (Kind::Truth, Kind::Truth) if operator.joins() => {
                self.step(Step::Two(operator.function), at);
                return Ok(Kind::Truth);
            }
            (Kind::Choice(row), Kind::Quoted(from, to))
            | (Kind::Quoted(from, to), Kind::Choice(row))
                if equality =>
            {
                (row, (from, to))
            }
            (Kind::Choice(row), _) | (_, Kind::Choice(row)) if equality => {
                let name = &self.table[row].name;
                return Err(fault(
                    at,
                    format!("{name} is compared with a name in single quotes"),
                ));
            }
            _ if operator.joins() => return Err(fault(at, format!("{token} joins conditions"))),
            _ => return Err(fault(at, format!("{token} needs numbers"))),
        };
        let name = &self.text[quoted.0..quoted.1];
        let parameter::Kind::Choice(choices) = self.table[row].kind else {
            return Err(fault(at, format!("{token} needs numbers")));
        };
        let names: Vec<&'static str> = choices.iter().map(|choice| choice.0).collect();
        let Some(known) = names.iter().find(|known| **known == name) else {
            let allowed = names.into_iter().map(Text::Borrowed).collect();
            return Err(unknown(quoted.0 - 1, &self.table[row].name, name, allowed));
        };
        self.step(Step::Is(row, known), at);
        if token == "!=" {
            self.step(Step::One(tokens::not), at);
        }
        Ok(Kind::Truth)
    }
}
