//! The metrics of a study that are computed from others, of the keys `metrics`, `reductions`, `checks` and `figures`.

mod forms;
mod rules;

use super::sources::{self, Source, is_arithmetic, members};
use super::{Computed, Rule};
use crate::Measure;
use crate::cases::scope::Scope;
use crate::source::faults::{Faults, quoted, unknown};
use crate::source::hint::nearest;
use crate::source::object::Object;
use crate::source::tree::{Member, Tree};
use forms::{check_forms, refused};
use slipgap_problem::problem::escape;
use slipgap_problem::problem::expression::Formula;
use slipgap_problem::problem::structure::tables::schema::{in_unit, symbol};

/// What `metrics` of a study asks for.
#[derive(Debug, Default)]
pub(crate) struct Listed {
    /// Rows of the measures that the list names.
    pub named: Vec<usize>,
    /// Rows of the computed measures that are columns, in the order of the file.
    pub columns: Vec<usize>,
}

/// Adds the computed metrics to the measures of the scope. One with a fault is among them, so that it is reported once.
pub(crate) fn computed(object: &Object, scope: &mut Scope, faults: &mut Faults) -> Listed {
    if let Some(node) = object.get("metrics") {
        check_forms(node, faults);
    }
    let listed = sources::listed(object);
    let known: Vec<&str> = scope.metrics();
    let mut names: Vec<Named> = Vec::new();
    for source in &listed {
        let Some(member) = source.name else {
            continue;
        };
        let taken = names.iter().any(|known| known.name.key == member.key);
        match refused(member, taken, scope, &known) {
            Some(message) => faults.add(member.at, &source.path, message),
            None => names.push(Named {
                name: member,
                source: source.clone(),
                state: State::New,
            }),
        }
    }
    let mut decoder = Decoder { scope, names };
    let mut found = Listed::default();
    for source in &listed {
        let row = match source.name {
            Some(member) => decoder.row_of_name(&member.key, source, faults),
            None => decoder.row_of_item(source, faults),
        };
        found.add(row, &decoder.scope.measures);
    }
    let others = sources::reduced(object).into_iter();
    for source in others.chain(sources::shown(object)) {
        let row = decoder.row_of_text(&source, faults);
        found.add(row, &decoder.scope.measures);
    }
    found
}

impl Listed {
    fn add(&mut self, row: Option<usize>, measures: &[Measure]) {
        let Some(row) = row else {
            return;
        };
        let rows = match measures[row].computed {
            Some(_) => &mut self.columns,
            None => &mut self.named,
        };
        if !rows.contains(&row) {
            rows.push(row);
        }
    }
}

/// A metric with a name of the study.
struct Named<'a> {
    name: &'a Member,
    source: Source<'a>,
    state: State,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    New,
    /// What it is computed from is being decoded.
    Open,
    /// Its row of the measures.
    Done(usize),
}

struct Decoder<'a, 'b> {
    scope: &'b mut Scope,
    names: Vec<Named<'a>>,
}

/// A rule with the unit and the title of its value, in markup.
struct Decoded {
    rule: Rule,
    unit: String,
    symbol: String,
}

impl Decoder<'_, '_> {
    /// The row of the measure with this name.
    fn known(&self, name: &str) -> Option<usize> {
        let mut measures = self.scope.measures.iter();
        measures.position(|measure| measure.name == name)
    }

    /// An item of the list.
    fn row_of_item(&mut self, source: &Source, faults: &mut Faults) -> Option<usize> {
        if let Some(row) = self.row_of_text(source, faults) {
            return Some(row);
        }
        let name = source.text;
        if self.known(name).is_none() && !self.names.iter().any(|named| named.name.key == name) {
            faults.add(
                source.at,
                &source.path,
                unknown("metric", name, &self.scope.metrics()),
            );
        }
        None
    }

    /// A text that may be arithmetic; `None` for another name that is not known.
    fn row_of_text(&mut self, source: &Source, faults: &mut Faults) -> Option<usize> {
        let name = source.text.trim();
        if let Some(row) = self.known(name) {
            return Some(row);
        }
        if self.names.iter().any(|named| named.name.key == name) {
            return self.row_of_name(name, source, faults);
        }
        if !is_arithmetic(name) || crate::reduction::decode::parts(source.text).is_some() {
            return None;
        }
        // A name with a hyphen.
        let metrics = self.scope.metrics();
        let is_word = name
            .chars()
            .all(|c| c.is_ascii_alphanumeric() || "_-.".contains(c));
        if is_word && nearest(name, &metrics).is_some() {
            return None;
        }
        let decoded = self.rule(source, source.text, 0, faults);
        Some(self.push(name.to_owned(), source.text, decoded))
    }

    /// The metric with a name of the study.
    fn row_of_name(&mut self, name: &str, from: &Source, faults: &mut Faults) -> Option<usize> {
        let index = self.names.iter().position(|known| known.name.key == name)?;
        match self.names[index].state {
            State::Done(row) => return Some(row),
            State::Open => {
                let open = self
                    .names
                    .iter()
                    .filter(|metric| metric.state == State::Open);
                let names: Vec<&str> = open.map(|metric| metric.name.key.as_str()).collect();
                let message = format!(
                    "{} is computed from itself: {}",
                    quoted(name),
                    names.join(", ")
                );
                faults.add(from.at, &from.path, message);
                return None;
            }
            State::New => {}
        }
        self.names[index].state = State::Open;
        let (member, source) = (self.names[index].name, self.names[index].source.clone());
        let mut decoded = self.rule(&source, source.text, 0, faults);
        let given = |key: &str| {
            let found = members(&member.node).find(|key_member| key_member.key == key)?;
            match &found.node.tree {
                Tree::Text(text) => Some(text.clone()),
                Tree::Object(_) | Tree::List(_) | Tree::Number(_) | Tree::Bool(_) | Tree::Null => {
                    None
                }
            }
        };
        if let Some(decoded) = &mut decoded {
            decoded.symbol = match given("title") {
                Some(title) => escape(&title),
                None => symbol(name),
            };
            decoded.unit = given("unit").unwrap_or(decoded.unit.clone());
        }
        let row = self.push(name.to_owned(), source.text, decoded);
        self.names[index].state = State::Done(row);
        Some(row)
    }

    /// The measure of an expression that begins at byte `start` of the text of a source.
    fn row_of_part(
        &mut self,
        source: &Source,
        part: &str,
        start: usize,
        faults: &mut Faults,
    ) -> Option<usize> {
        let name = part.trim();
        if let Some(row) = self.known(name) {
            return Some(row);
        }
        if self.names.iter().any(|named| named.name.key == name) {
            return self.row_of_name(name, source, faults);
        }
        let decoded = self.rule(source, part, start, faults)?;
        Some(self.push(name.to_owned(), part, Some(decoded)))
    }

    /// The rule of an expression that begins at byte `start` of the text of a source.
    fn rule(
        &mut self,
        source: &Source,
        part: &str,
        start: usize,
        faults: &mut Faults,
    ) -> Option<Decoded> {
        match part.rsplit_once(sources::RELATIVE) {
            Some((metric, values)) => {
                let after = start + part.len() - values.len();
                self.ratio(source, (metric, start), (values, after), faults)
            }
            None => self.arithmetic(source, part, start, faults),
        }
    }

    /// Adds a measure.
    fn push(&mut self, name: String, text: &str, decoded: Option<Decoded>) -> usize {
        let decoded = decoded.unwrap_or_else(|| Decoded {
            rule: Rule::Formula(Formula::default()),
            unit: "1".to_owned(),
            symbol: escape(&name),
        });
        let measures = &mut self.scope.measures;
        let unit = decoded.unit;
        let shown = Some(unit.clone()).filter(|unit| unit != "1");
        let mut computed = Computed {
            late: matches!(decoded.rule, Rule::Ratio(..)),
            rule: decoded.rule,
        };
        let uses = computed.uses(self.scope.problem.parameters().len());
        computed.late |= uses.iter().any(|row| {
            let used = measures[*row].computed.as_ref();
            used.is_some_and(|used| used.late)
        });
        measures.push(Measure {
            name,
            symbol: in_unit(decoded.symbol, shown),
            unit,
            meaning: text.trim().to_owned(),
            metric: None,
            dimension: None,
            reduction: None,
            computed: Some(computed),
        });
        measures.len() - 1
    }
}
