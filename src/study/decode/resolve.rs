//! From the draft of a block to the block: its design's points, and parameters in the order in which they follow from others.

use super::validate::MOST_CASES;
use crate::problem::parameter::{Default, Parameter};
use crate::problem::schema::Text;
use crate::problem::{Problem, Schema};
use crate::study::Block;
use crate::study::axes::design::design;
use crate::study::axes::draft::{Draft, Given};
use crate::study::axes::interval::Interval;
use crate::study::cases::derived::{Condition, Derived, Rule, fitted, refused, worked_out};
use crate::study::cases::design::{Design, Sampling};
use crate::study::expression::Formula;
use crate::study::source::faults::{Faults, quoted};
use crate::study::source::object::Object;
use std::sync::Arc;

impl Draft {
    /// Decodes the design beside the parameters, and what it samples.
    pub fn design(&mut self, object: &Object, faults: &mut Faults) {
        let sampled = |given: &&Given| given.interval.is_some();
        let rows = self
            .given
            .iter()
            .filter(sampled)
            .map(|given| given.parameter);
        let rows: Vec<usize> = rows.collect();
        let path = object.path("design");
        let Some(node) = object.get("design") else {
            for given in self.given.iter().filter(sampled) {
                let message = "needs a \"design\" next to \"parameters\", which chooses the points";
                faults.add(given.at, &given.path, message);
            }
            // Without points of theirs, nothing further can be said.
            self.faulty.extend(&rows);
            self.given.retain(|given| given.interval.is_none());
            return;
        };
        let design = design(node, &path, faults);
        if rows.is_empty() && self.faulty.is_empty() {
            let message = "samples nothing: give parameters as {\"uniform\": [a, b]} or {\"loguniform\": [a, b]}";
            faults.add(node.at, &path, message);
        }
        let others = self.given.iter().any(|given| given.values.len() > 1);
        let saltelli = |d: &Design| d.sampling == Sampling::Saltelli;
        if design.as_ref().is_some_and(saltelli) && (others || self.when.is_some()) {
            let message = "a saltelli design allows no other axis and no \"when\" in its block";
            faults.add(node.at, &path, message);
        }
        match design {
            Some(mut design) if !rows.is_empty() => {
                design.parameters = rows;
                let intervals = self.given.iter().filter_map(|given| given.interval);
                design.scales = intervals.map(Interval::scale).collect();
                self.design = Some(design);
            }
            _ => {
                self.faulty.extend(&rows);
                self.given.retain(|given| given.interval.is_none());
            }
        }
    }

    /// Gives what the design samples its values.
    pub fn sample(&mut self, table: &[Parameter]) {
        let Some(design) = &self.design else {
            return;
        };
        for given in &mut self.given {
            let place = design
                .parameters
                .iter()
                .position(|row| *row == given.parameter);
            if let (Some(place), Some(interval)) = (place, given.interval) {
                let parameter = &table[given.parameter];
                let points = design.coordinates(place).into_iter();
                given.values = points
                    .map(|u| (interval.at(u, parameter), given.at))
                    .collect();
            }
        }
    }

    /// The block; `None` where an expression names what is faulty itself, or has a fault.
    pub fn block(&self, problem: &dyn Problem, faults: &mut Faults) -> Option<Block> {
        let table = problem.parameters();
        let mut block = Block {
            groups: self.axes(),
            design: self.design.clone(),
            ..Block::default()
        };
        let derived = self.given.iter().filter(|given| given.formula.is_some());
        let mut waiting: Vec<&Given> = derived.collect();
        let before = faults.count();
        let mut dropped = false;
        for given in &waiting {
            dropped |= !self.known(given, table, faults);
        }
        if dropped || faults.count() > before {
            return None;
        }
        // Each after those that it names.
        while !waiting.is_empty() {
            let is_ready = |given: &&Given| {
                let uses = given.formula.iter().flat_map(|(formula, _)| formula.uses());
                let mut unready = uses.filter(|row| waiting.iter().any(|w| w.parameter == **row));
                unready.next().is_none()
            };
            let Some(place) = waiting.iter().position(is_ready) else {
                self.circle(&waiting, table, faults);
                return None;
            };
            let given = waiting.remove(place);
            if let Some((formula, text)) = &given.formula {
                let restates = self.restates(given, problem);
                derive(
                    &mut block,
                    given,
                    (formula, text),
                    restates,
                    problem.schema(),
                    faults,
                );
            }
        }
        if let Some((formula, at, text)) = &self.when {
            let path = match self.path.strip_suffix("parameters") {
                Some(path) => format!("{path}when"),
                None => "when".into(),
            };
            if !self.all_known(formula, text, *at, &path, table, faults) {
                return None;
            }
            if let Some(message) = condition(&mut block, formula, text, problem) {
                faults.add(*at, &path, message);
            }
        }
        (faults.count() == before).then_some(block)
    }

    /// Whether a derived parameter names only what has values; says so where that is a fault.
    fn known(&self, given: &Given, table: &[Parameter], faults: &mut Faults) -> bool {
        let Some((formula, text)) = &given.formula else {
            return true;
        };
        self.all_known(formula, text, given.at, &given.path, table, faults)
    }

    fn all_known(
        &self,
        formula: &Formula,
        text: &str,
        at: usize,
        path: &str,
        table: &[Parameter],
        faults: &mut Faults,
    ) -> bool {
        let mut known = true;
        for &row in formula.uses() {
            let given = self.given.iter().any(|given| given.parameter == row);
            if given || matches!(table[row].default, Default::Is(_)) {
                continue;
            }
            known = false;
            if !self.faulty.contains(&row) {
                let name = &table[row].name;
                let message = format!("{}: {name} is not given in this block", quoted(text));
                faults.add(at, path, message);
            }
        }
        known
    }

    /// Whether an expression names, by others or itself, what its parameter would follow from.
    fn restates(&self, given: &Given, problem: &dyn Problem) -> bool {
        let table = problem.parameters();
        let name = &table[given.parameter].name;
        let other = |pair: &&[Text; 2]| pair.contains(name);
        let Some(pair) = problem.schema().alternatives.iter().find(other) else {
            return false;
        };
        let (mut seen, mut next) = (Vec::new(), vec![given.parameter]);
        while let Some(row) = next.pop() {
            let given = self.given.iter().find(|given| given.parameter == row);
            let formula = given.and_then(|given| given.formula.as_ref());
            for row in formula.iter().flat_map(|(formula, _)| formula.uses()) {
                if table[*row].name != *name && pair.contains(&table[*row].name) {
                    return true;
                }
                if !seen.contains(row) {
                    seen.push(*row);
                    next.push(*row);
                }
            }
        }
        false
    }

    /// Says which parameters name each other in a circle.
    fn circle(&self, waiting: &[&Given], table: &[Parameter], faults: &mut Faults) {
        let next = |row: usize| {
            let given = waiting.iter().find(|given| given.parameter == row)?;
            let (formula, _) = given.formula.as_ref()?;
            let mut uses = formula.uses().iter().copied();
            uses.find(|row| waiting.iter().any(|w| w.parameter == *row))
        };
        // Every one of them leads into a circle; the first met twice is on it.
        let mut way = vec![waiting[0].parameter];
        while let Some(row) = way.last().and_then(|row| next(*row)) {
            if let Some(start) = way.iter().position(|earlier| *earlier == row) {
                way.drain(..start);
                way.push(row);
                break;
            }
            way.push(row);
        }
        let names: Vec<&str> = way.iter().map(|row| &*table[*row].name).collect();
        let first = self
            .given
            .iter()
            .find(|given| Some(&given.parameter) == way.first());
        if let Some(given) = first {
            let message = format!("circular reference: {}", names.join(" -> "));
            faults.add(given.at, &given.path, message);
        }
    }
}

/// Adds a condition; gives what is wrong with it.
fn condition(
    block: &mut Block,
    formula: &Formula,
    text: &str,
    problem: &dyn Problem,
) -> Option<String> {
    let mut rule = Rule::new(formula.clone(), block);
    if let Err((case, fault)) = rule.tabulate(block, problem.schema()) {
        return Some(worked_out(formula, text, &case, &fault));
    }
    let (known, count) = (rule.table.is_some(), block.raw_len());
    block.when = Some(Condition { rule });
    if !known && count > MOST_CASES {
        return Some(format!(
            "{}: must be tested for {count} combinations; allowed: at most {MOST_CASES}",
            quoted(text)
        ));
    }
    if let Some(raw) = block.undecided(problem) {
        let case = block.raw_case(problem, raw);
        let fault = formula.value(&|row| case.values[row]).err()?;
        return Some(worked_out(formula, text, &case, &fault));
    }
    let none = block.len(problem) == 0;
    none.then(|| format!("{}: no combination meets it", quoted(text)))
}

/// Adds a parameter that follows from others; its first bad value is a fault.
fn derive(
    block: &mut Block,
    given: &Given,
    (formula, text): (&Formula, &str),
    restates: bool,
    schema: &Arc<Schema>,
    faults: &mut Faults,
) {
    let mut rule = Rule::new(formula.clone(), block);
    let parameter = &schema.parameters[given.parameter];
    let bad = match rule.tabulate(block, schema) {
        Err((case, _)) => Some(case),
        Ok(()) => {
            let mut values = rule.table.iter().flatten();
            let unfit = values.position(|x| fitted(*x, parameter).is_err());
            unfit.map(|set| rule.case(block, set as u64, schema))
        }
    };
    if let Some(message) = bad.and_then(|case| refused(formula, text, &case, parameter)) {
        faults.add(given.at, &given.path, message);
    }
    block.derived.push(Derived {
        parameter: given.parameter,
        text: text.to_owned(),
        restates,
        rule,
    });
}
