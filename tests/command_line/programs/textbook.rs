//! Programs in studies of the two textbook problems: the request is that of the structure that describes the problem, and the answer counts
//! like the motion of a method.

use super::{PYTHON, bench, column, numbers};
use crate::Bench;
use serde_json::Value as Json;

/// An oscillator in plain Python: constant average acceleration, with the friction of displacement-control by the return map.
const OSCILLATOR: &str = r#"
import json, sys
print(json.dumps({"format": 1, "program": "map", "version": "1", "laws": ["displacement-control"]}), flush=True)
for line in sys.stdin:
    case = json.loads(line)
    (contact,), dt = case["contacts"], case["dt"]
    k, limit = contact["numbers"]["k"], contact["numbers"]["nu"] * contact["N"]
    (m,), (stiffness,) = [row[2] for row in case["M"]], [row[2] for row in case["K"]]
    x, v, s, a = case["start"]["u"][0], case["start"]["v"][0], case["start"]["S"]["friction"], case["start"]["a"][0]
    rows = [(x, v, s)]
    for _ in range(case["steps"]):
        b = m * (4 * x / dt**2 + 4 * v / dt + a)
        # Elastic first, then at the limit of the side to which the elastic force goes.
        new = (b - s + k * x) / (4 * m / dt**2 + stiffness + k)
        force = s + k * (new - x)
        if abs(force) > limit:
            force = limit if force > 0 else -limit
            new = (b - force) / (4 * m / dt**2 + stiffness)
        a = 4 * (new - x) / dt**2 - 4 * v / dt - a
        v = 2 * (new - x) / dt - v
        x, s = new, force
        rows.append((x, v, s))
    x, v, s = zip(*rows)
    print(json.dumps({"case": case["case"], "channels": {"x": x, "x.v": v, "friction.S": s}, "cost": len(rows) - 1}), flush=True)
"#;

fn program(name: &str, file: &str) -> String {
    format!(
        r#""{name}": {{ "command": ["{}", "{file}"], "files": ["{file}"] }}"#,
        *PYTHON
    )
}

/// That the second half of the cases, by a program, has the values of the first one, by average-acceleration.
fn expect_equal(bench: &Bench, folder: &str, names: &[&str], most: f64) {
    for name in names {
        let found = numbers(bench, folder, name);
        let (own, other) = found.split_at(found.len() / 2);
        for (x, y) in own.iter().zip(other) {
            assert!((x - y).abs() <= most * x.abs().max(1.0), "{name}: {x} {y}");
        }
    }
}

#[test]
fn the_oscillator_by_a_program_has_the_metrics_of_the_problem() {
    let bench = bench();
    bench.file("map.py", OSCILLATOR);
    let study = format!(
        r#"{{ "problem": "friction-oscillator", "programs": {{ {} }},
  "parameters": {{ "method": ["average-acceleration", "map"], "law": "displacement-control", "alpha": [0.1, 1],
    "dT": ["pi/10", "pi/40"], "duration": "8*pi" }},
  "metrics": ["numerical_dissipation", "step_error", "cost", "spectral_radius"],
  "figures": [{{ "name": "x", "kind": "history", "y": ["X", "S"], "where": {{ "alpha": 1, "dT": "pi/40" }} }}] }}"#,
        program("map", "map.py")
    );
    bench.file("o.json", &study);
    let refused = bench.run(&["run", "o.json"]);
    assert_eq!(refused.code, Some(2));
    assert!(refused.err.contains("--allow-programs"), "{}", refused.err);
    bench.expect(0, &["run", "o.json", "--allow-programs", "--histories"]);
    // 320 steps of round-off; both solve each step to its root.
    let names = [
        "rms_error",
        "max_error",
        "peak_error",
        "rest_error",
        "work_error",
        "step_error",
    ];
    expect_equal(&bench, "figures/o", &names, 1e-11);
    assert_eq!(
        column(&bench, "figures/o", "cost")[4..],
        ["80.0", "320.0", "80.0", "320.0"]
    );
    // What only a method of the product has.
    assert_eq!(column(&bench, "figures/o", "spectral_radius")[4..], [""; 4]);
    let history = bench.text("figures/o/histories/7.csv");
    assert!(history.starts_with("T,X,V,S,X_exact,V_exact"), "{history}");
    // The request has the numbers of the study and of the structure.
    let line = bench
        .expect(0, &["explain", "o.json", "5", "--request"])
        .out;
    let request: Json = serde_json::from_str(&line).unwrap();
    assert_eq!(request["case"], 5);
    assert_eq!(request["parameters"]["alpha"], 0.1);
    assert_eq!(
        request["contacts"][0]["numbers"],
        serde_json::json!({ "k": 10.0, "nu": 1.0 })
    );
    assert_eq!(request["start"]["a"][0], -12.0);
}

#[test]
fn bars_by_a_program_have_the_metrics_of_the_problem() {
    let bench = bench();
    let blocks = [
        r#""gamma": 2"#,
        r#""gamma": 2, "right": { "rho": 0.03, "L": 15 }"#,
        r#""k_I": 300, "right": "wall", "gap": 0.1"#,
    ];
    for (place, more) in blocks.into_iter().enumerate() {
        let study = format!(
            r#"{{ "problem": "bar-impact", "programs": {{ {} }},
  "parameters": {{ "method": ["average-acceleration", "plain"], "n": 6, "dt": 0.01, "duration": 1.5, {more} }},
  "metrics": ["energy_lost", "step_error_r"] }}"#,
            program("plain", "average_acceleration.py")
        );
        let name = format!("b{place}");
        bench.file(&format!("{name}.json"), &study);
        bench.expect(0, &["run", &format!("{name}.json"), "--allow-programs"]);
        // 150 steps of round-off. The energy is summed over the nodes by one and over the work of the contact by the other.
        let names = [
            "contact_duration",
            "separations",
            "max_overlap",
            "rdot_oscillation",
            "peak_force",
            "impulse_error",
            "restitution",
            "energy_drift_max",
            "energy_drift_final",
            "rms_error_r",
            "rms_error_rdot",
            "energy_lost",
        ];
        expect_equal(&bench, &format!("figures/{name}"), &names, 1e-11);
    }
}

#[test]
fn what_a_structure_does_not_have_is_a_fault_of_the_case() {
    let bench = bench();
    let study = |problem: &str, parameters: &str| {
        format!(
            r#"{{ "problem": "{problem}", "programs": {{ {} }}, "parameters": {{ "method": "plain", {parameters} }} }}"#,
            program("plain", "average_acceleration.py")
        )
    };
    let oscillator = r#""law": "displacement-control", "alpha": 1, "dT": 0.1, "duration": 10"#;
    for (text, part) in [
        (
            study("friction-oscillator", oscillator),
            "does not have the law displacement-control",
        ),
        (
            study(
                "friction-oscillator",
                &format!(r#"{oscillator}, "initial_slip": "pulled""#),
            ),
            "allowed: unloaded",
        ),
        (
            study(
                "bar-impact",
                r#""gamma": 2, "n": 6, "dt": 0.01, "duration": 1.5, "mass": "consistent""#,
            ),
            "allowed: lumped",
        ),
    ] {
        bench.file("s.json", &text);
        let run = bench.run(&["run", "s.json", "--allow-programs"]);
        assert_eq!(run.code, Some(3), "{}", run.err);
        assert!(run.err.contains(part), "{}", run.err);
    }
}

#[test]
fn numbers_of_a_program_are_axes_for_it_alone() {
    let bench = bench();
    let study = format!(
        r#"{{ "problem": "bar-impact",
  "programs": {{ "plain": {{ "command": ["{}", "average_acceleration.py"], "parameters": {{ "tolerance": "tol" }} }} }},
  "parameters": {{ "method": ["average-acceleration", "plain"], "tol": [1e-6, 1e-8], "gamma": 2, "n": 2, "dt": 0.05, "duration": 1.5 }} }}"#,
        *PYTHON
    );
    bench.file("s.json", &study);
    bench.expect(0, &["run", "s.json", "--allow-programs"]);
    assert_eq!(column(&bench, "figures/s", "tol"), ["", "1e-6", "1e-8"]);
    let line = bench
        .expect(0, &["explain", "s.json", "2", "--request"])
        .out;
    let request: Json = serde_json::from_str(&line).unwrap();
    assert_eq!(request["numbers"], serde_json::json!({ "tolerance": 1e-8 }));
}
