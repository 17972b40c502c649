//! The rule of a computed metric from its text: arithmetic, or a ratio to a reference case.

use super::super::sources::Source;
use super::super::{Reference, Rule, formula};
use super::{Decoded, Decoder};
use crate::source::faults::{Faults, in_words, quoted};
use crate::source::tree::{Member, Node, Tree};
use slipgap_problem::problem::escape;
use slipgap_problem::problem::expression::ExpressionFault;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_problem::problem::structure::metrics::pieces::{Piece, pieces};
use slipgap_problem::problem::structure::tables::schema::title;

/// What a ratio looks like.
const FORM: &str = "\"METRIC relative to PARAMETER = VALUE, ...\", as in \"peak(gap.S) relative to gamma = 1, n = 10\"";

impl Decoder<'_, '_> {
    pub(super) fn arithmetic(
        &mut self,
        source: &Source,
        part: &str,
        start: usize,
        faults: &mut Faults,
    ) -> Option<Decoded> {
        let mut report = |fault: ExpressionFault| {
            let message = format!("{}: {}", quoted(source.text.trim()), in_words(&fault));
            faults.add(source.place(start + fault.offset), &source.path, message);
        };
        let names: Vec<String> = self
            .names
            .iter()
            .map(|known| known.name.key.clone())
            .collect();
        let others: Vec<&str> = names.iter().map(String::as_str).collect();
        let problem = self.scope.problem.clone();
        let table = formula::table(&*problem, &self.scope.measures, &others);
        let from = table.len() - others.len();
        let uses = match formula::parse(part, &table, from) {
            Ok((_, uses)) => uses,
            Err(fault) => {
                report(fault);
                return None;
            }
        };
        // A name that has its measure is known as one.
        for index in uses {
            self.row_of_name(&names[index], source, faults)?;
        }
        let table = formula::table(&*problem, &self.scope.measures, &[]);
        let first = problem.parameters().len();
        let (formula, uses) = formula::parse(part, &table, first).ok()?;
        // One metric alone keeps its unit and title.
        let alone = uses
            .iter()
            .find(|row| self.scope.measures[**row].name == part.trim());
        let (unit, symbol) = match alone.map(|row| &self.scope.measures[*row]) {
            Some(measure) => (measure.unit.clone(), measure.bare_symbol().to_owned()),
            None => ("1".to_owned(), self.in_words(part.trim())),
        };
        Some(Decoded {
            rule: Rule::Formula(formula),
            unit,
            symbol,
        })
    }

    /// Arithmetic with the words of its metrics and the symbols of its parameters.
    fn in_words(&self, text: &str) -> String {
        if !self.scope.problem.schema().described {
            return title(text);
        }
        let table = self.scope.problem.parameters();
        let (mut words, mut end) = (String::new(), 0);
        for piece in pieces(text) {
            let (range, symbol) = match piece {
                Piece::Metric(range) => {
                    let name = text[range.clone()].trim();
                    let mut measures = self.scope.measures.iter();
                    let known = measures.find(|measure| measure.name == name);
                    (range, known.map(|known| known.bare_symbol()))
                }
                Piece::Name(range) => {
                    let metric = table
                        .iter()
                        .find(|metric| metric.name == text[range.clone()]);
                    (range, metric.map(|metric| &*metric.symbol))
                }
            };
            let Some(symbol) = symbol else { continue };
            words += &operators(&text[end..range.start]);
            words += symbol;
            end = range.end;
        }
        words + &operators(&text[end..])
    }

    pub(super) fn ratio(
        &mut self,
        source: &Source,
        (metric, start): (&str, usize),
        (values, after): (&str, usize),
        faults: &mut Faults,
    ) -> Option<Decoded> {
        let of = self.row_of_part(source, metric, start, faults)?;
        let before = faults.count();
        let node = self.values(source, values, after, faults)?;
        let filter = self.scope.filter(&node, &source.path, faults)?;
        let reference = Reference::new(filter, &*self.scope.problem, &self.scope.blocks);
        if !self.scope.blocks.is_empty()
            && let Some(message) = reference.fault_of_ratio(self.scope, "\"relative to\"")
        {
            faults.add(source.place(after), &source.path, message);
        }
        let table = self.scope.problem.parameters();
        let value = |(row, wanted): &(usize, Vec<Value>)| {
            let value = wanted.first().map(Value::to_string).unwrap_or_default();
            format!("{} = {}", table[*row].symbol, escape(&value))
        };
        let values: Vec<String> = reference.filter.0.iter().map(value).collect();
        let symbol = self.scope.measures[of].bare_symbol();
        (faults.count() == before).then(|| Decoded {
            symbol: format!("{symbol} relative to {}", values.join(", ")),
            unit: "1".to_owned(),
            rule: Rule::Ratio(of, reference),
        })
    }

    /// The values of a reference case as an object.
    fn values(
        &self,
        source: &Source,
        values: &str,
        after: usize,
        faults: &mut Faults,
    ) -> Option<Node> {
        let mut terms = Vec::new();
        let mut start = after;
        for term in values.split(',') {
            let at = source.place(start + term.len() - term.trim_start().len());
            start += term.len() + 1;
            let Some((name, value)) = term.split_once('=') else {
                let message = format!("must be {FORM}, got {}", quoted(source.text));
                faults.add(at, &source.path, message);
                return None;
            };
            let value = value.trim().trim_matches('\'');
            let tree = match value.parse::<f64>() {
                Ok(_) => Tree::Number(value.to_owned()),
                Err(_) => Tree::Text(value.to_owned()),
            };
            terms.push(Member {
                key: name.trim().to_owned(),
                at,
                node: Node { at, tree },
            });
        }
        Some(Node {
            at: source.place(after),
            tree: Tree::Object(terms),
        })
    }
}

/// What is between the words of arithmetic.
fn operators(text: &str) -> String {
    let apart = text.replace('/', " / ").replace('*', " × ");
    title(&apart.replace("  ", " "))
}
