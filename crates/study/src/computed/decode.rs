//! The metrics of a study that are computed from others, of the keys `metrics`, `reductions`, `checks` and `figures`.

use super::sources::{self, NAMED, Source, is_arithmetic, members};
use super::{Computed, Reference, Rule, formula};
use crate::Measure;
use crate::cases::scope::Scope;
use crate::source::faults::{Faults, in_words, join, quoted, unknown};
use crate::source::hint::nearest;
use crate::source::object::Object;
use crate::source::tree::{Member, Node, Tree};
use crate::value::text;
use slipgap_solver::expression::{CONSTANTS, ExpressionFault, FUNCTIONS, Formula};
use slipgap_solver::problem::escape;
use slipgap_solver::problem::parameter::Value;
use slipgap_solver::problem::structure::schema::{in_unit, symbol, title};

/// What a ratio looks like.
const FORM: &str = "\"METRIC relative to PARAMETER = VALUE, ...\", as in \"peak(gap.S) relative to gamma = 1, n = 10\"";

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
    for own in &listed {
        let Some(member) = own.name else {
            continue;
        };
        let taken = names.iter().any(|known| known.name.key == member.key);
        match refused(member, taken, scope, &known) {
            Some(message) => faults.add(member.at, &own.path, message),
            None => names.push(Named {
                name: member,
                source: own.clone(),
                state: State::New,
            }),
        }
    }
    let mut decoder = Decoder { scope, names };
    let mut found = Listed::default();
    for own in &listed {
        let row = match own.name {
            Some(member) => decoder.row_of_name(&member.key, own, faults),
            None => decoder.row_of_item(own, faults),
        };
        found.add(row, &decoder.scope.measures);
    }
    let others = sources::reduced(object).into_iter();
    for own in others.chain(sources::shown(object)) {
        let row = decoder.row_of_text(&own, faults);
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

/// Reports items of `metrics` of another form.
fn check_forms(node: &Node, faults: &mut Faults) {
    let what = "a list of metrics, or an object with their names";
    if !matches!(node.tree, Tree::List(_) | Tree::Object(_)) {
        faults.must_be(node, "metrics", what);
        return;
    }
    for (item, path) in sources::items(node, "metrics") {
        match &item.tree {
            Tree::Text(_) => {
                text(item, &path, faults);
            }
            Tree::Object(_) => members(item).for_each(|member| {
                check_entry(&member.node, &join(&path, &member.key), faults);
            }),
            _ => faults.must_be(
                item,
                &path,
                "the name of a metric, or an object such as {\"drift\": \"max(a3 - a2)/h\"}",
            ),
        }
    }
}

/// Reports the faults of the form of a metric with a name.
fn check_entry(node: &Node, path: &str, faults: &mut Faults) {
    match &node.tree {
        Tree::Text(_) => {
            text(node, path, faults);
        }
        Tree::Object(_) => {
            let Some(object) = Object::open(node, path, &NAMED.map(|key| key.0), faults) else {
                return;
            };
            object.need(NAMED[0].0, NAMED[0].1, faults);
            for member in &object.members {
                text(&member.node, &object.path(&member.key), faults);
            }
        }
        _ => faults.must_be(
            node,
            path,
            "a string, or an object with value, unit and title",
        ),
    }
}

/// Why a metric cannot have a name; `None` if it can.
fn refused(member: &Member, taken: bool, scope: &Scope, known: &[&str]) -> Option<String> {
    let name = member.key.as_str();
    let shown = quoted(name);
    let plain = |c: char| c.is_ascii_alphanumeric() || c == '_';
    if !name.chars().all(plain) || !name.starts_with(|c: char| c.is_ascii_alphabetic()) {
        return Some(format!(
            "{shown} cannot name a metric; a name is letters, digits and _, beginning with a letter"
        ));
    }
    let has_meaning = FUNCTIONS.iter().any(|own| own.0 == name)
        || CONSTANTS.contains(&name)
        || ["and", "or", "not", "case"].contains(&name);
    if has_meaning {
        return Some(format!(
            "{shown} has a meaning of its own; choose another name"
        ));
    }
    if scope.parameters().contains(&name) {
        return Some(format!("{shown} is a parameter; choose another name"));
    }
    if known.contains(&name) {
        return Some(format!(
            "{shown} is a metric of the problem; choose another name"
        ));
    }
    taken.then(|| format!("{shown} given twice"))
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
    fn row_of_item(&mut self, own: &Source, faults: &mut Faults) -> Option<usize> {
        if let Some(row) = self.row_of_text(own, faults) {
            return Some(row);
        }
        let name = own.text;
        if self.known(name).is_none() && !self.names.iter().any(|named| named.name.key == name) {
            faults.add(
                own.at,
                &own.path,
                unknown("metric", name, &self.scope.metrics()),
            );
        }
        None
    }

    /// A text that may be arithmetic; `None` for another name that is not known.
    fn row_of_text(&mut self, own: &Source, faults: &mut Faults) -> Option<usize> {
        let name = own.text.trim();
        if let Some(row) = self.known(name) {
            return Some(row);
        }
        if self.names.iter().any(|named| named.name.key == name) {
            return self.row_of_name(name, own, faults);
        }
        if !is_arithmetic(name) || crate::reduction::decode::parts(own.text).is_some() {
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
        let decoded = self.rule(own, own.text, 0, faults);
        Some(self.push(name.to_owned(), own.text, decoded))
    }

    /// The metric with a name of the study.
    fn row_of_name(&mut self, name: &str, from: &Source, faults: &mut Faults) -> Option<usize> {
        let place = self.names.iter().position(|own| own.name.key == name)?;
        match self.names[place].state {
            State::Done(row) => return Some(row),
            State::Open => {
                let open = self.names.iter().filter(|own| own.state == State::Open);
                let names: Vec<&str> = open.map(|own| own.name.key.as_str()).collect();
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
        self.names[place].state = State::Open;
        let (member, source) = (self.names[place].name, self.names[place].source.clone());
        let mut decoded = self.rule(&source, source.text, 0, faults);
        let given = |key: &str| {
            let found = members(&member.node).find(|own| own.key == key)?;
            match &found.node.tree {
                Tree::Text(text) => Some(text.clone()),
                _ => None,
            }
        };
        if let Some(decoded) = &mut decoded {
            decoded.symbol = match given(NAMED[2].0) {
                Some(title) => escape(&title),
                None => symbol(name),
            };
            decoded.unit = given(NAMED[1].0).unwrap_or(decoded.unit.clone());
        }
        let row = self.push(name.to_owned(), source.text, decoded);
        self.names[place].state = State::Done(row);
        Some(row)
    }

    /// The measure of an expression that begins at byte `start` of the text of a source.
    fn row_of_part(
        &mut self,
        own: &Source,
        part: &str,
        start: usize,
        faults: &mut Faults,
    ) -> Option<usize> {
        let name = part.trim();
        if let Some(row) = self.known(name) {
            return Some(row);
        }
        if self.names.iter().any(|named| named.name.key == name) {
            return self.row_of_name(name, own, faults);
        }
        let decoded = self.rule(own, part, start, faults)?;
        Some(self.push(name.to_owned(), part, Some(decoded)))
    }

    /// The rule of an expression that begins at byte `start` of the text of a source.
    fn rule(
        &mut self,
        own: &Source,
        part: &str,
        start: usize,
        faults: &mut Faults,
    ) -> Option<Decoded> {
        match part.rsplit_once(sources::RELATIVE) {
            Some((metric, values)) => {
                let after = start + part.len() - values.len();
                self.ratio(own, (metric, start), (values, after), faults)
            }
            None => self.arithmetic(own, part, start, faults),
        }
    }

    fn arithmetic(
        &mut self,
        own: &Source,
        part: &str,
        start: usize,
        faults: &mut Faults,
    ) -> Option<Decoded> {
        let mut report = |fault: ExpressionFault| {
            let message = format!("{}: {}", quoted(own.text.trim()), in_words(&fault));
            faults.add(own.place(start + fault.offset), &own.path, message);
        };
        let names: Vec<String> = self.names.iter().map(|own| own.name.key.clone()).collect();
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
        for place in uses {
            self.row_of_name(&names[place], own, faults)?;
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
            None => ("1".to_owned(), title(part.trim())),
        };
        Some(Decoded {
            rule: Rule::Formula(formula),
            unit,
            symbol,
        })
    }

    fn ratio(
        &mut self,
        own: &Source,
        (metric, start): (&str, usize),
        (values, after): (&str, usize),
        faults: &mut Faults,
    ) -> Option<Decoded> {
        let of = self.row_of_part(own, metric, start, faults)?;
        let before = faults.count();
        let node = self.values(own, values, after, faults)?;
        let filter = self.scope.filter(&node, &own.path, faults)?;
        let reference = Reference::new(filter, &*self.scope.problem, &self.scope.blocks);
        if !self.scope.blocks.is_empty()
            && let Some(message) = reference.fault_of_ratio(self.scope, "\"relative to\"")
        {
            faults.add(own.place(after), &own.path, message);
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
        own: &Source,
        values: &str,
        after: usize,
        faults: &mut Faults,
    ) -> Option<Node> {
        let mut all = Vec::new();
        let mut start = after;
        for term in values.split(',') {
            let at = own.place(start + term.len() - term.trim_start().len());
            start += term.len() + 1;
            let Some((name, value)) = term.split_once('=') else {
                let message = format!("must be {FORM}, got {}", quoted(own.text));
                faults.add(at, &own.path, message);
                return None;
            };
            let value = value.trim().trim_matches('\'');
            let tree = match value.parse::<f64>() {
                Ok(_) => Tree::Number(value.to_owned()),
                Err(_) => Tree::Text(value.to_owned()),
            };
            all.push(Member {
                key: name.trim().to_owned(),
                at,
                node: Node { at, tree },
            });
        }
        Some(Node {
            at: own.place(after),
            tree: Tree::Object(all),
        })
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
