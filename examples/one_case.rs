//! One case: a mass on a spring with Coulomb friction, released at X = 12, by the displacement-control model.
//!
//! Run with `cargo run --example one_case`.

use slipgap::problem::numbers::parameter::Value;
use slipgap::problem::{Case, find};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let problem = find("friction-oscillator").ok_or("no such problem")?;
    let alpha = 0.1;
    let (case, broken_rules) = Case::given(
        &*problem,
        &[
            ("law", Value::Name("displacement-control")),
            ("alpha", Value::Number(alpha)),
            ("dT", Value::Number(0.1)),
            ("duration", Value::Number(25.0)),
        ],
    );
    assert!(broken_rules.is_empty(), "{broken_rules:?}");
    let solution = problem.solve(&case, &[])?;

    println!("{:>8} {:>12} {:>12}", "T", "X", "X exact");
    let (computed, exact) = (&solution.computed, &solution.exact);
    for i in (0..computed.len()).step_by(25) {
        let (x, x_exact) = (computed.displacement()[i], exact.displacement()[i]);
        println!("{:8.1} {x:12.6} {x_exact:12.6}", computed.time[i]);
    }
    for (metric, value) in problem.metrics().iter().zip(&solution.metrics) {
        if let Some(value) = value {
            println!("{} = {value:.6}", metric.name);
        }
    }

    // Coulomb's motion rests at X = 0 from 6 pi on. The model then vibrates on the spring of its friction element.
    let last = computed.displacement().last().ok_or("no step")?;
    assert!(last.abs() < 2.0 * alpha, "X = {last} at the end");
    Ok(())
}
