//! The set of motions that get one factor: its rule, and which cases have its motions.

use super::target::target;
use crate::source::faults::Faults;
use crate::source::object::Object;
use crate::source::tree::{Node, Tree};
use crate::structure::keys::{RULES, Rule, SET, STATISTICS, names, range};
use crate::structure::reading::reader::{Reader, open};
use crate::value::name;
use slipgap_problem::problem::numbers::parameter::Range;
use slipgap_problem::problem::structure::given::amount::{Amount, Source};
use slipgap_problem::problem::structure::given::motion_set::{Set, Statistic};
use slipgap_problem::problem::structure::given::scale_to::Goal;
use slipgap_system::system::loads::pair::Component;

/// The set under a key, without its motions.
pub(super) fn set(
    node: &Node,
    path: &str,
    goal: &Goal,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<Set> {
    let object = open(node, path, SET, faults)?;
    let before = faults.count();
    let rule = object.get("rule").and_then(|node| {
        let names = RULES.map(|rule| rule.name);
        let index = name(node, &object.path("rule"), "rule", &names, faults)?;
        Some(&RULES[index])
    });
    let fixed = |x: f64| Amount {
        source: Source::Number(x),
        range: Range::Any,
        at: node.at,
        path: path.to_owned(),
    };
    let number =
        |key: &str, faults: &mut Faults| reader.optional(&object, key, range(SET, key), faults);
    let at_zero = number("least_at_zero", faults).or_else(|| Some(fixed(rule?.at_zero?)));
    let least = match (object.get("least"), rule) {
        (None, Some(rule)) => Some(fixed(rule.least)),
        _ => reader.needed(&object, SET, "least", faults),
    };
    let statistic = object.get("statistic").and_then(|node| {
        let names = STATISTICS.map(|row| row.0);
        let index = name(node, &object.path("statistic"), "statistic", &names, faults)?;
        Some(STATISTICS[index].1)
    });
    let by_rule = rule.map_or(Statistic::Mean, |rule| rule.statistic);
    let component_node = object.get("component");
    let given = component_node.and_then(|node| component(node, &object.path("component"), faults));
    let target = match (object.get("spectrum"), goal) {
        (Some(node), _) => target(node, &object.path("spectrum"), reader, faults),
        (None, Goal::Spectrum { target, .. }) => Some(target.clone()),
        (None, _) => {
            object.need("spectrum", "target spectrum", faults);
            None
        }
    };
    let between = between(&object, rule, reader, faults);
    let factor = number("factor", faults);
    if faults.count() > before {
        return None;
    }
    Some(Set {
        rule: rule.map(|rule| rule.name),
        members: Vec::new(),
        statistic: statistic.unwrap_or(by_rule),
        component: given.or_else(|| rule?.component),
        least: least?,
        at_zero,
        between: between?,
        target: target?,
        factor,
        made: Default::default(),
    })
}

/// Of what of a pair.
pub(in crate::structure) fn component(
    node: &Node,
    path: &str,
    faults: &mut Faults,
) -> Option<Component> {
    let names = Component::ALL.map(Component::name);
    let index = name(node, path, "component", &names, faults)?;
    Some(Component::ALL[index])
}

/// The first and last period: by their keys, or by those of the structure and the rule.
fn between(
    object: &Object,
    rule: Option<&Rule>,
    reader: &Reader,
    faults: &mut Faults,
) -> Option<[(f64, Vec<Amount>); 2]> {
    let path = object.path("period");
    let amount = |node: &Node, path: &str, faults: &mut Faults| {
        reader.amount(node, path, range(SET, "period"), faults)
    };
    let periods: Option<Vec<Amount>> = object.get("period").map(|node| match &node.tree {
        Tree::List(items) if !items.is_empty() => {
            let numbered = items.iter().enumerate();
            let amounts = numbered.map(|(i, item)| amount(item, &format!("{path}[{i}]"), faults));
            amounts.flatten().collect()
        }
        Tree::Object(_)
        | Tree::List(_)
        | Tree::Text(_)
        | Tree::Number(_)
        | Tree::Bool(_)
        | Tree::Null => amount(node, &path, faults).into_iter().collect(),
    });
    if let (Some(node), None) = (object.get("period"), rule) {
        faults.add(node.at, &path, "needs a rule");
    }
    if let (Some(node), Some(rule), Some([_])) = (object.get("period"), rule, periods.as_deref())
        && rule.of_bounds
    {
        let message = "must have two periods: with the upper and with the lower bound properties";
        faults.add(node.at, &path, message);
    }
    let ends = ["from", "to"].map(|key| object.get(key).is_some());
    let mut end = |index: usize| {
        let key = names(&SET[2..4])[index];
        match (&periods, rule, ends[index]) {
            (Some(periods), Some(rule), false) => Some((rule.times[index], periods.clone())),
            (None, Some(_), false) if !ends[0] && !ends[1] => {
                (index == 0).then(|| object.need("period", "period of the structure", faults));
                None
            }
            _ => reader
                .needed(object, SET, key, faults)
                .map(|amount| (1.0, vec![amount])),
        }
    };
    let (from, to) = (end(0), end(1));
    Some([from?, to?])
}

/// Gives a set of a ground in x and y the component of its spectra, or reports that it has none.
pub(super) fn give_component(
    set: &mut Set,
    of_pair: Option<Component>,
    (node, path): (&Node, &str),
    faults: &mut Faults,
) {
    set.component = set.component.or(of_pair);
    if set.component.is_none() {
        let message = "missing \"component\": geometric-mean, srss, rotd50 or rotd100 of x and y";
        faults.add(node.at, path, message);
    }
}
