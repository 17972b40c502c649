//! Operands: numbers, names, calls of functions, and expressions in parentheses.

use std::f64::consts::{E, PI};

use super::{Kind, Outcome, Parser, fault, unknown};
use crate::problem::Text;
use crate::problem::expression::formula::{ExpressionFault, Step};
use crate::problem::expression::number_length::length_of_number;
use crate::problem::expression::tokens::{self, CONSTANTS, FUNCTIONS, Function};
use crate::problem::numbers::parameter;

/// Binding power of signs: above a product, below a power.
const SIGN: u8 = 13;

/// Binding power of `not`: above `and`, below a comparison.
const NOT: u8 = 3;

impl Parser<'_> {
    pub(super) fn operand(&mut self) -> Outcome {
        let at = self.offset;
        match self.peek() {
            Some(sign @ ('-' | '+')) => {
                let at = self.offset;
                self.take(1);
                if self.operand_and_operators(SIGN)? != Kind::Number {
                    return Err(fault(at, format!("{sign} needs a number")));
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
            return Err(fault(at, "not needs a condition"));
        }
        self.step(Step::One(tokens::not), at);
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
        if let Some(row) = self.row_with_brackets(rest) {
            self.take(self.table[row].name.len());
            return Ok(self.parameter(row, at));
        }
        let name = self.take(length);
        if let Some((_, function)) = FUNCTIONS.iter().find(|(known, _)| *known == name) {
            return self.call(name, *function, at);
        }
        let row = self.table.iter().position(|p| p.name == name);
        let constant = match name {
            // A parameter of a study may have the name of a constant.
            "pi" if row.is_none() => PI,
            "e" if row.is_none() => E,
            _ => {
                let Some(row) = row else {
                    let names = CONSTANTS.into_iter().chain(FUNCTIONS.iter().map(|f| f.0));
                    let known = names.map(Text::Borrowed);
                    let parameters = self.table.iter().map(|p| p.name.clone());
                    let allowed = known.chain(parameters).collect();
                    return Err(unknown(at, "name", name, allowed));
                };
                return Ok(self.parameter(row, at));
            }
        };
        self.step(Step::Number(constant), at);
        Ok(Kind::Number)
    }

    /// The row of the table with the longest name that `rest` begins with, of the names with brackets, such as `max(a3 - a2)`.
    fn row_with_brackets(&self, rest: &str) -> Option<usize> {
        let rows = self.table.iter().enumerate();
        let begins = rows.filter(|(_, parameter)| {
            parameter.name.contains('(') && rest.starts_with(&*parameter.name)
        });
        Some(begins.max_by_key(|(_, parameter)| parameter.name.len())?.0)
    }

    /// The value of the parameter in a row.
    fn parameter(&mut self, row: usize, at: usize) -> Kind {
        if !self.uses.contains(&row) {
            self.uses.push(row);
        }
        if let parameter::Kind::Choice(_) = self.table[row].kind {
            return Kind::Choice(row);
        }
        self.step(Step::Parameter(row), at);
        Kind::Number
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
                    return Err(self.fault(format!("expected ',': {name} needs two numbers")));
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
            Kind::Truth | Kind::Choice(_) | Kind::Quoted(..) => {
                Err(fault(at, format!("{name} needs numbers")))
            }
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
