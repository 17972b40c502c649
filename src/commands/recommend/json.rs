//! The answer of `slipgap recommend STUDY --json`: one object on one line.

use crate::problem::numbers::parameter;
use crate::recommend::study::{Advice, Choice, NotConverged};
use crate::solve::Warning;
use serde_json::{Map, Value, json};

/// The whole answer.
pub fn answer(advice: &Advice) -> Value {
    let choices = advice.choices.iter().enumerate();
    let candidates: Vec<Value> = choices
        .map(|(at, choice)| candidate(advice, at, choice))
        .collect();
    let lists: Vec<Value> = advice
        .not_converged
        .iter()
        .map(|entry| list(advice, entry))
        .collect();
    let recommended = advice
        .chosen
        .map(|at| parameters(advice, &advice.choices[at].values));
    json!({
        "recommended": recommended,
        "physical_cases": advice.conditions,
        "solved": advice.solved,
        "candidates": candidates,
        "not_converged": lists,
        "sentences": advice.sentences(),
    })
}

fn candidate(advice: &Advice, at: usize, choice: &Choice) -> Value {
    let within = advice.within().into_iter();
    let errors = within.enumerate().map(|(at, (name, _))| {
        let error = choice.errors.get(at).copied().unwrap_or(f64::INFINITY);
        (name.to_owned(), number(error))
    });
    let warnings: Vec<&str> = choice.warnings.iter().map(Warning::name).collect();
    json!({
        "parameters": parameters(advice, &choice.values),
        "cost": choice.cost,
        "energy_gain": number(choice.energy.gain),
        "energy_loss": number(choice.energy.loss),
        "errors": errors.collect::<Map<String, Value>>(),
        "worst": number(choice.worst),
        "warnings": warnings,
        "verdict": advice.verdict(at),
    })
}

fn list(advice: &Advice, list: &NotConverged) -> Value {
    let (metric, tolerance) = advice.within()[list.metric];
    json!({
        "parameter": advice.name(list.parameter),
        "values": list.values.map(value),
        "metric": metric,
        "change": number(list.change),
        "tolerance": tolerance,
    })
}

fn parameters(advice: &Advice, values: &[(usize, parameter::Value)]) -> Map<String, Value> {
    let named = values
        .iter()
        .map(|(row, chosen)| (advice.name(*row).to_owned(), value(*chosen)));
    named.collect()
}

fn value(value: parameter::Value) -> Value {
    match value {
        parameter::Value::Number(x) => number(x),
        parameter::Value::Whole(n) => n.into(),
        parameter::Value::Name(name) => name.into(),
    }
}

/// A number; null for one that is not known.
fn number(x: f64) -> Value {
    if x.is_finite() { x.into() } else { Value::Null }
}
