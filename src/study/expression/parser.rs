//! A Pratt parser: from text to the steps of a formula, and what each part of it is.

use std::f64::consts::{E, PI};

use super::words::{self, CONSTANTS, FUNCTIONS, Function, length_of_number};
use super::{ExpressionFault, Formula, Step};
use crate::problem::parameter;
use crate::problem::parameter::Parameter;
use crate::study::report::unknown;

/// Deeper than any formula that a person writes.
const DEEPEST: usize = 100;

/// How tightly signs bind: more than a product, less than a power.
const SIGN: u8 = 13;

/// How tightly `not` binds: more than `and`, less than a comparison.
const NOT: u8 = 3;

/// What an operand is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    Number,
    Truth,
    /// The name that a row of the table has in the case.
    Choice(usize),
    /// A name in quotes, at these bytes of the text.
    Quoted(usize, usize),
}

/// Reads the whole of `text`, which must be of `kind`.
pub(super) fn parse(
    text: &str,
    table: &'static [Parameter],
    kind: Kind,
) -> Result<Formula, ExpressionFault> {
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
            steps: parser.steps,
            uses: parser.uses,
            table,
        }),
        None => {
            let message = match kind {
                Kind::Truth => "must be a condition, as in \"n > 2\"",
                _ => "must be a number",
            };
            Err(fault(0, message))
        }
        Some(')') => Err(parser.fault("')' without '('")),
        Some('=') => Err(parser.fault("write == to compare")),
        Some(c) => Err(parser.fault(format!("expected an operator, got '{}'", c.escape_debug()))),
    }
}

fn fault(offset: usize, message: impl Into<String>) -> ExpressionFault {
    ExpressionFault {
        offset,
        message: message.into(),
    }
}

struct Parser<'a> {
    text: &'a str,
    table: &'static [Parameter],
    offset: usize,
    depth: usize,
    /// The token read last, to name what an operand is missing after.
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

    /// An operand and all operators after it that bind more tightly than `least`.
    fn operand_and_operators(&mut self, least: u8) -> Outcome {
        if self.depth == DEEPEST {
            return Err(self.fault(format!("nested more than {DEEPEST} deep")));
        }
        self.depth += 1;
        let mut kind = self.operand()?;
        let mut compared = false;
        while self.peek().is_some() {
            let Some(operator) = words::operator(&self.text[self.offset..]) else {
                break;
            };
            if operator.binds <= least {
                break;
            }
            let at = self.offset;
            if compared && operator.compares() {
                return Err(fault(at, "join two comparisons by and"));
            }
            compared = operator.compares();
            self.take(operator.token.len());
            let right = self.operand_and_operators(operator.right)?;
            kind = self.joined(kind, operator, right, at)?;
        }
        self.depth -= 1;
        Ok(kind)
    }

    /// What an operator makes of what stands on its two sides.
    fn joined(
        &mut self,
        left: Kind,
        operator: &words::Operator,
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
                let name = self.table[row].name;
                return Err(fault(at, format!("compares {name} with a name in quotes")));
            }
            _ if operator.joins() => return Err(fault(at, format!("{token} takes conditions"))),
            _ => return Err(fault(at, format!("{token} takes numbers"))),
        };
        let name = &self.text[quoted.0..quoted.1];
        let parameter::Kind::Choice(choices) = self.table[row].kind else {
            return Err(fault(at, format!("{token} takes numbers")));
        };
        let names: Vec<&'static str> = choices.iter().map(|choice| choice.0).collect();
        let Some(known) = names.iter().find(|known| **known == name) else {
            return Err(fault(
                quoted.0 - 1,
                unknown(self.table[row].name, name, &names),
            ));
        };
        self.step(Step::Is(row, known), at);
        if token == "!=" {
            self.step(Step::One(words::not), at);
        }
        Ok(Kind::Truth)
    }

    fn operand(&mut self) -> Outcome {
        let at = self.offset;
        match self.peek() {
            Some(sign @ ('-' | '+')) => {
                let at = self.offset;
                self.take(1);
                if self.operand_and_operators(SIGN)? != Kind::Number {
                    return Err(fault(at, format!("{sign} takes a number")));
                }
                if sign == '-' {
                    self.step(Step::One(|x| -x), at);
                }
                Ok(Kind::Number)
            }
            Some('!') => self.not(1),
            Some('(') => {
                self.take(1);
                let kind = self.operand_and_operators(0)?;
                self.close()?;
                Ok(kind)
            }
            Some(quote @ ('\'' | '"')) => self.quoted(quote),
            Some(c) if c.is_ascii_digit() || c == '.' => self.number(),
            Some(c) if c.is_alphabetic() || c == '_' => self.name(),
            found => {
                let mut message = "expected a number, a name or '('".to_owned();
                if let Some(last) = self.last {
                    message += &format!(" after '{last}'");
                }
                if let Some(c) = found {
                    message += &format!(", got '{}'", c.escape_debug());
                }
                Err(fault(at.max(self.offset), message))
            }
        }
    }

    fn not(&mut self, length: usize) -> Outcome {
        let at = self.offset;
        self.take(length);
        if self.operand_and_operators(NOT)? != Kind::Truth {
            return Err(fault(at, "not takes a condition"));
        }
        self.step(Step::One(words::not), at);
        Ok(Kind::Truth)
    }

    fn quoted(&mut self, quote: char) -> Outcome {
        let from = self.offset + 1;
        let Some(length) = self.text[from..].find(quote) else {
            return Err(self.fault(format!("a {quote} is missing at the end")));
        };
        self.take(length + 2);
        Ok(Kind::Quoted(from, from + length))
    }

    fn number(&mut self) -> Outcome {
        let end = length_of_number(&self.text.as_bytes()[self.offset..]);
        let at = self.offset;
        let written = self.take(end);
        match written.parse::<f64>() {
            Ok(x) if x.is_finite() => self.step(Step::Number(x), at),
            Ok(x) => return Err(fault(at, format!("must be finite, got {x}"))),
            Err(_) => return Err(fault(at, format!("'{written}' is not a number"))),
        }
        Ok(Kind::Number)
    }

    /// A constant, a function with its arguments, or the name of a parameter; names may contain dots.
    fn name(&mut self) -> Outcome {
        let rest = &self.text[self.offset..];
        let length = rest
            .find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '.'))
            .unwrap_or(rest.len());
        let at = self.offset;
        if &rest[..length] == "not" {
            return self.not(length);
        }
        let name = self.take(length);
        if let Some((_, function)) = FUNCTIONS.iter().find(|(known, _)| *known == name) {
            return self.call(name, *function, at);
        }
        let row = self.table.iter().position(|p| p.name == name);
        let constant = match name {
            "pi" => PI,
            "e" => E,
            _ => {
                let Some(row) = row else {
                    let known = CONSTANTS.into_iter().chain(FUNCTIONS.iter().map(|f| f.0));
                    let known: Vec<&str> = known.chain(self.table.iter().map(|p| p.name)).collect();
                    return Err(fault(at, unknown("name", name, &known)));
                };
                if !self.uses.contains(&row) {
                    self.uses.push(row);
                }
                if let parameter::Kind::Choice(_) = self.table[row].kind {
                    return Ok(Kind::Choice(row));
                }
                self.step(Step::Parameter(row), at);
                return Ok(Kind::Number);
            }
        };
        self.step(Step::Number(constant), at);
        Ok(Kind::Number)
    }

    /// The arguments in parentheses.
    fn call(&mut self, name: &str, function: Function, at: usize) -> Outcome {
        if self.peek() != Some('(') {
            return Err(self.fault(format!("expected '(' after {name}")));
        }
        self.take(1);
        self.argument(name)?;
        match function {
            Function::One(function) => {
                self.close()?;
                self.step(Step::One(function), at);
            }
            Function::Two(function) => {
                if self.peek() != Some(',') {
                    return Err(self.fault(format!("expected ',': {name} takes two numbers")));
                }
                self.take(1);
                self.argument(name)?;
                self.close()?;
                self.step(Step::Two(function), at);
            }
        }
        Ok(Kind::Number)
    }

    fn argument(&mut self, name: &str) -> Result<(), ExpressionFault> {
        let at = self.offset;
        match self.operand_and_operators(0)? {
            Kind::Number => Ok(()),
            _ => Err(fault(at, format!("{name} takes numbers"))),
        }
    }

    fn close(&mut self) -> Result<(), ExpressionFault> {
        match self.peek() {
            Some(')') => {
                self.take(1);
                Ok(())
            }
            Some(c) => Err(self.fault(format!(
                "expected an operator or ')', got '{}'",
                c.escape_debug()
            ))),
            None => Err(self.fault("a ')' is missing at the end")),
        }
    }
}
