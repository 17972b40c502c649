//! The key `reductions` of a study.

use super::{OPERATORS, Operator, Reduction};
use crate::faults::{Faults, quoted, unknown};
use crate::field::{ANY, Field, Kind, field};
use crate::object::Object;
use crate::tree::Node;
use crate::value::text;
use crate::{Block, Measure};
use slipgap_cases::alike::unaffected;
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::numbers::parameter::{Default, Range, Value};

/// What a reduction looks like.
const FORM: &str =
    "\"WORD METRIC over PARAMETER, PARAMETER ...\", as in \"least rms_error over alpha\"";

/// The key with its meaning.
pub(crate) const KEY: Field = field("reductions", Kind::List(&Kind::Shared("reduction"), [0, ANY]))
    .means("metrics reduced over parameters, such as \"least rms_error over alpha\", for figures and checks");

/// The parts of the text of a reduction.
pub(crate) struct Parts<'a> {
    pub word: &'a str,
    /// The number after `quantile`.
    pub number: Option<&'a str>,
    pub metric: &'a str,
    pub over: Vec<&'a str>,
}

/// The parts of a text; `None` if it has another form.
pub(crate) fn parts(text: &str) -> Option<Parts<'_>> {
    let (rest, over) = text.rsplit_once(" over ")?;
    let (word, rest) = rest.trim().split_once(' ')?;
    let (number, metric) = match word {
        "quantile" => {
            let (number, metric) = rest.trim().split_once(" of ")?;
            (Some(number.trim()), metric)
        }
        _ => (None, rest),
    };
    Some(Parts {
        word,
        number,
        metric: metric.trim(),
        over: over.split(',').map(str::trim).collect(),
    })
}

/// The reductions of a study as further measures. One with a fault has no parameters, so that its name is known and it is
/// reported once.
pub(crate) fn measures(
    object: &Object,
    problem: &dyn Problem,
    measures: &[Measure],
    blocks: &[Block],
    faults: &mut Faults,
) -> Vec<Measure> {
    let texts = object.items(KEY.name, faults, |node, path, faults| {
        Some((node.clone(), path.to_owned(), text(node, path, faults)?))
    });
    let mut found: Vec<Measure> = Vec::new();
    for (node, path, name) in texts {
        if found.iter().any(|earlier| earlier.name == name) {
            faults.add(node.at, &path, format!("{} given twice", quoted(&name)));
            continue;
        }
        let scope = Scope {
            problem,
            measures,
            blocks,
        };
        let reduction = scope.reduction(&node, &path, &name, faults);
        found.push(scope.measure(name, reduction));
    }
    found
}

/// What the parts of a reduction may name.
struct Scope<'a> {
    problem: &'a dyn Problem,
    measures: &'a [Measure],
    blocks: &'a [Block],
}

impl Scope<'_> {
    fn reduction(
        &self,
        node: &Node,
        path: &str,
        text: &str,
        faults: &mut Faults,
    ) -> Option<Reduction> {
        let Some(parts) = parts(text) else {
            let first = text.split_whitespace().next().unwrap_or_default();
            let words = OPERATORS.map(|word| word.0);
            let known = words
                .iter()
                .any(|word| word.split(' ').next() == Some(first));
            let message = match known || !text.contains(" over ") {
                true => format!("must be {FORM}, got {}", quoted(text)),
                false => unknown("word", first, &words),
            };
            faults.add(node.at, path, message);
            return None;
        };
        let mut fault = |message: String| faults.add(node.at, path, message);
        let operator = self.operator(&parts, &mut fault);
        let names: Vec<&str> = self.measures.iter().map(|m| m.name.as_str()).collect();
        let of = names.iter().position(|name| *name == parts.metric);
        if of.is_none() {
            fault(unknown("metric", parts.metric, &names));
        }
        let over = self.over(&parts.over, &mut fault);
        let (operator, of, over) = (operator?, of?, over?);
        let kept = unaffected(self.problem, self.blocks, &over);
        let given = |row: &usize| self.blocks.iter().any(|block| block.gives(*row));
        let rows = 0..self.problem.parameters().len();
        Some(Reduction {
            operator,
            of,
            lost: rows
                .filter(|row| given(row) && !kept.contains(row))
                .collect(),
            kept: kept
                .into_iter()
                .filter(|row| varies(self.blocks, *row))
                .collect(),
            over,
        })
    }

    fn operator(&self, parts: &Parts, fault: &mut impl FnMut(String)) -> Option<Operator> {
        let Some(number) = parts.number else {
            let words = OPERATORS.map(|word| word.0);
            let row = words.iter().position(|word| *word == parts.word);
            let operator = row.and_then(Operator::at);
            if operator.is_none() {
                fault(unknown("word", parts.word, &words));
            }
            return operator;
        };
        let read = Formula::number(number, &[]).and_then(|formula| formula.value(&|_| None));
        let p = read.ok().filter(|p| Range::UpToOne.contains(*p));
        if p.is_none() {
            let number = quoted(number);
            fault(format!(
                "a quantile needs a number from 0 to 1, as in \"quantile 0.84 of\", got {number}"
            ));
        }
        p.map(Operator::Quantile)
    }

    fn over(&self, names: &[&str], fault: &mut impl FnMut(String)) -> Option<Vec<usize>> {
        let table = self.problem.parameters();
        let known: Vec<&str> = table.iter().map(|parameter| &*parameter.name).collect();
        let mut rows = Vec::new();
        for name in names {
            let Some(row) = known.iter().position(|known| known == name) else {
                fault(unknown("parameter", name, &known));
                continue;
            };
            if rows.contains(&row) {
                fault(format!("{name} given twice"));
            } else if !self.blocks.is_empty() && !self.blocks.iter().any(|b| b.gives(row)) {
                let why = match matches!(table[row].default, Default::Follows(_)) {
                    true => "is computed from other parameters; name one that the study gives",
                    false => "is not given; a reduction is over parameters that the study gives",
                };
                fault(format!("{name} {why}"));
            } else {
                rows.push(row);
            }
        }
        (rows.len() == names.len()).then_some(rows)
    }

    /// The measure of a reduction, or of a text with a fault.
    fn measure(&self, name: String, reduction: Option<Reduction>) -> Measure {
        let of = reduction
            .as_ref()
            .map(|reduction| &self.measures[reduction.of]);
        let word = reduction
            .as_ref()
            .map(|reduction| reduction.operator.title());
        let nothing = Reduction {
            operator: Operator::Least,
            of: 0,
            over: Vec::new(),
            lost: Vec::new(),
            kept: Vec::new(),
        };
        let text = |of: Option<&String>| of.cloned().unwrap_or_default();
        Measure {
            symbol: format!("{} {}", text(word.as_ref()), text(of.map(|of| &of.symbol))),
            meaning: format!("{name}: {}", text(of.map(|of| &of.meaning))),
            name,
            unit: text(of.map(|of| &of.unit)),
            metric: of.and_then(|of| of.metric),
            dimension: of.and_then(|of| of.dimension),
            reduction: Some(reduction.unwrap_or(nothing)),
            computed: None,
        }
    }
}

/// The value of a parameter in all cases of a block.
enum Constant {
    Missing,
    Is(Value),
    Varies,
}

fn constant(block: &Block, row: usize) -> Constant {
    let axis = block.axes().find(|axis| axis.parameter == row);
    match axis.map(|axis| &axis.values) {
        Some(values) if values.len() == 1 => Constant::Is(values.at(0)),
        Some(_) => Constant::Varies,
        None if block.gives(row) => Constant::Varies,
        None => Constant::Missing,
    }
}

/// Whether the values that the study gives a parameter differ, or some of its blocks give none.
pub(super) fn varies(blocks: &[Block], row: usize) -> bool {
    let missing = |block: &Block| matches!(constant(block, row), Constant::Missing);
    if blocks.iter().any(missing) && !blocks.iter().all(missing) {
        return true;
    }
    let mut first = None;
    blocks.iter().any(|block| match constant(block, row) {
        Constant::Missing => false,
        Constant::Varies => true,
        Constant::Is(value) => *first.get_or_insert(value) != value,
    })
}
