//! Arithmetic in strings: `"8*pi"`, `"1/sqrt(3)"`, `"-2^2"` (which is -4).
//!
//! A Pratt parser that computes as it reads. Own code, because the permissively licensed crates either make -2^2
//! four or cannot say where a fault is.

use std::f64::consts::{E, PI};

use super::report::unknown;
use super::words::{FUNCTIONS, Function, length_of_number};

/// Deeper than any formula that a person writes.
const DEEPEST: usize = 100;

/// What is wrong with an expression, and at which byte of it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ExpressionFault {
    /// Byte offset in the expression.
    pub offset: usize,
    /// What is wrong, with what was expected.
    pub message: String,
}

/// The value of `text`; `lookup` answers for names other than pi and e.
///
/// The result and every step towards it are finite; anything else is a fault.
pub fn evaluate(text: &str, lookup: &dyn Fn(&str) -> Option<f64>) -> Result<f64, ExpressionFault> {
    let mut parser = Parser {
        text,
        offset: 0,
        depth: 0,
        last: None,
        lookup,
    };
    let value = parser.operand_and_operators(0)?;
    match parser.peek() {
        None => Ok(value),
        Some(')') => Err(parser.fault("')' without '('")),
        Some(c) => Err(parser.fault(format!("expected an operator, got '{}'", c.escape_debug()))),
    }
}

struct Parser<'a> {
    text: &'a str,
    offset: usize,
    depth: usize,
    /// The token read last, to name what an operand is missing after.
    last: Option<&'a str>,
    lookup: &'a dyn Fn(&str) -> Option<f64>,
}

type Outcome = Result<f64, ExpressionFault>;

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
        ExpressionFault {
            offset: self.offset,
            message: message.into(),
        }
    }

    /// An operand and all operators after it that bind more tightly than `least`.
    fn operand_and_operators(&mut self, least: u8) -> Outcome {
        if self.depth == DEEPEST {
            return Err(self.fault(format!("nested more than {DEEPEST} deep")));
        }
        self.depth += 1;
        let mut value = self.operand()?;
        while let Some((token, binds, right)) = self.operator() {
            if binds <= least {
                break;
            }
            let at = self.offset;
            self.take(token.len());
            let other = self.operand_and_operators(right)?;
            value = match token {
                "+" => value + other,
                "-" => value - other,
                "*" => value * other,
                "/" => value / other,
                _ => libm::pow(value, other),
            };
            finite(value, at)?;
        }
        self.depth -= 1;
        Ok(value)
    }

    /// The operator ahead, how tightly it binds, and how tightly what is to its right must bind: for a power a
    /// little less than itself, as 2^3^2 is 2^9.
    fn operator(&mut self) -> Option<(&'static str, u8, u8)> {
        Some(match self.peek()? {
            '+' => ("+", 1, 1),
            '-' => ("-", 1, 1),
            '*' if self.text[self.offset..].starts_with("**") => ("**", 4, 3),
            '*' => ("*", 2, 2),
            '/' => ("/", 2, 2),
            '^' => ("^", 4, 3),
            _ => return None,
        })
    }

    fn operand(&mut self) -> Outcome {
        match self.peek() {
            Some('-') => {
                self.take(1);
                Ok(-self.operand_and_operators(3)?)
            }
            Some('+') => {
                self.take(1);
                self.operand_and_operators(3)
            }
            Some('(') => {
                self.take(1);
                let value = self.operand_and_operators(0)?;
                self.close()?;
                Ok(value)
            }
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
                Err(self.fault(message))
            }
        }
    }

    fn number(&mut self) -> Outcome {
        let end = length_of_number(&self.text.as_bytes()[self.offset..]);
        let at = self.offset;
        let written = self.take(end);
        match written.parse() {
            Ok(value) => finite(value, at),
            Err(_) => Err(ExpressionFault {
                offset: at,
                message: format!("'{written}' is not a number"),
            }),
        }
    }

    /// A constant, a function with its arguments, or a name that `lookup` knows; names may contain dots.
    fn name(&mut self) -> Outcome {
        let rest = &self.text[self.offset..];
        let length = rest
            .find(|c: char| !(c.is_alphanumeric() || c == '_' || c == '.'))
            .unwrap_or(rest.len());
        let at = self.offset;
        let name = self.take(length);
        if let Some((_, function)) = FUNCTIONS.iter().find(|(known, _)| *known == name) {
            return finite(self.call(name, *function)?, at);
        }
        match name {
            "pi" => Ok(PI),
            "e" => Ok(E),
            _ => (self.lookup)(name).ok_or_else(|| {
                let known = ["pi", "e"].into_iter().chain(FUNCTIONS.iter().map(|f| f.0));
                let known: Vec<&str> = known.collect();
                let message = unknown("name", name, &known);
                ExpressionFault {
                    offset: at,
                    message,
                }
            }),
        }
    }

    /// The arguments in parentheses, and what the function makes of them.
    fn call(&mut self, name: &str, function: Function) -> Outcome {
        self.open(name)?;
        let first = self.operand_and_operators(0)?;
        let value = match function {
            Function::One(function) => function(first),
            Function::Two(function) => {
                if self.peek() != Some(',') {
                    return Err(self.fault(format!("expected ',': {name} takes two numbers")));
                }
                self.take(1);
                function(first, self.operand_and_operators(0)?)
            }
        };
        self.close()?;
        Ok(value)
    }

    fn open(&mut self, function: &str) -> Result<(), ExpressionFault> {
        if self.peek() != Some('(') {
            return Err(self.fault(format!("expected '(' after {function}")));
        }
        self.take(1);
        Ok(())
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

fn finite(value: f64, offset: usize) -> Outcome {
    if value.is_finite() {
        return Ok(value);
    }
    let message = format!("must be finite, got {value}");
    Err(ExpressionFault { offset, message })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(text: &str) -> f64 {
        let lookup = |name: &str| (name == "right.L").then_some(10.0);
        evaluate(text, &lookup).unwrap_or_else(|e| panic!("{text}: {e:?}"))
    }

    fn fault(text: &str) -> (usize, String) {
        let fault = evaluate(text, &|_| None).expect_err(text);
        (fault.offset, fault.message)
    }

    #[test]
    fn arithmetic_as_in_a_textbook() {
        for (text, expected) in [
            ("12", 12.0),
            (" 1.5e-3 ", 1.5e-3),
            ("1e3", 1000.0),
            (".5", 0.5),
            ("-2^2", -4.0),
            ("2^-1", 0.5),
            ("2**3**2", 512.0),
            ("2^3^2", 512.0),
            ("(2^3)^2", 64.0),
            ("2^-3^2", 1.0 / 512.0),
            ("2*-3", -6.0),
            ("-2*-3", 6.0),
            ("--2", 2.0),
            ("+5", 5.0),
            ("8-3-2", 3.0),
            ("8/4/2", 1.0),
            ("1+2*3", 7.0),
            ("2*3^2", 18.0),
            ("sqrt(16) + 1", 5.0),
            ("max(1, 2) - min(3, 4)", -1.0),
            ("ln(e)", 1.0),
            ("abs(-3)", 3.0),
            ("pi/10", PI / 10.0),
            ("8*pi", 8.0 * PI),
            ("2*right.L", 20.0),
            ("2 * e", 2.0 * E),
        ] {
            assert_eq!(value(text), expected, "{text}");
        }
    }

    #[test]
    fn faults_say_what_was_expected_and_where() {
        for (text, offset, says) in [
            ("", 0, "expected a number, a name or '('"),
            ("pi/", 3, "expected a number, a name or '(' after '/'"),
            ("pi/*2", 3, "after '/', got '*'"),
            ("2 pi", 2, "expected an operator, got 'p'"),
            ("2e", 1, "expected an operator, got 'e'"),
            ("(1", 2, "')' is missing"),
            ("1)", 1, "')' without '('"),
            ("()", 1, "after '(', got ')'"),
            ("sqrt 4", 5, "expected '(' after sqrt"),
            ("max(1)", 5, "takes two"),
            ("sqrt(-1)", 0, "must be finite, got NaN"),
            ("1/0", 1, "must be finite, got inf"),
            ("1/(1/0)", 4, "must be finite, got inf"),
            ("1e999", 0, "must be finite, got inf"),
            ("1/1e999", 2, "must be finite, got inf"),
            ("NaN", 0, "unknown name \"NaN\""),
            ("sqr(2)", 0, "did you mean \"sqrt\""),
            ("1,5", 1, "expected an operator, got ','"),
            (".", 0, "not a number"),
            ("1.2.3", 3, "expected an operator, got '.'"),
            ("2π", 1, "expected an operator, got 'π'"),
        ] {
            let (at, message) = fault(text);
            assert!(message.contains(says), "{text}: {message}");
            assert_eq!(at, offset, "{text}: {message}");
        }
    }

    #[test]
    fn depth_is_limited_and_length_is_not() {
        for deep in ["(", "-", "2^", "sqrt("] {
            let (_, message) = fault(&deep.repeat(100_000));
            assert!(message.contains("deep"), "{message}");
        }
        assert_eq!(value(&("1".to_owned() + &"+1".repeat(100_000))), 100_001.0);
        assert_eq!(value(&("(".repeat(50) + "1" + &")".repeat(50))), 1.0);
        assert_eq!(value(&vec!["-1"; 300].join("*")), 1.0);
    }
}
