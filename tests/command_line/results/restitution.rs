//! The restitution of an impact: what its law gives, and what its motion has.

use crate::Bench;
use crate::warnings::some;

/// Two bodies of 1 that collide with these parameters, a contact and more parts of the structure.
fn collision(parameters: &str, contact: &str, more: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{{parameters}}},
          "structure": {{"masses": {{"a": 1, "b": 1}}, "contacts": {{"j": {{{contact}, "between": ["a", "b"], "gap": 0.01}}}},
            "start": {{"a": {{"v": 1}}}}{more}}},
          "metrics": ["restitution(j)", "impacts(j)"]}}"#
    )
}

/// The first column of the results that is a metric: empty or a number.
fn column(bench: &Bench, name: &str) -> Vec<Option<f64>> {
    let table = bench.text("figures/s/results.csv");
    let mut rows = table.lines().map(|row| row.split(',').collect::<Vec<_>>());
    let column_index = rows
        .next()
        .unwrap()
        .iter()
        .position(|cell| *cell == name)
        .unwrap();
    rows.map(|row| row[column_index].parse().ok()).collect()
}

/// The root e of W(-e) = W(1), W(u) = u/kappa - ln(1 + kappa u)/kappa^2, by bisection: k_h delta^1.5 (1 + kappa ddelta/v0).
fn of_kappa(kappa: f64) -> f64 {
    let w = |u: f64| u / kappa - (kappa * u).ln_1p() / (kappa * kappa);
    let [mut low, mut high] = [0.0, 1.0];
    for _ in 0..60 {
        let e = 0.5 * (low + high);
        if w(-e) < w(1.0) { low = e } else { high = e }
    }
    low
}

#[test]
fn the_restitution_of_two_bodies_is_that_of_the_closed_form() {
    let bench = Bench::new();
    // F = k delta + c ddelta is 0 again at 2 acos(xi)/omega_d, where the speed is exp(-2 xi acos(xi)/sqrt(1 - xi^2)).
    // There it jumps to c: the step at the touch has half of it only, and e is larger by c dt/(2 m) = xi omega dt of it.
    let dashpot = |target: f64| {
        let loss = -target.ln();
        let xi = loss / (std::f64::consts::PI.powi(2) + loss * loss).sqrt();
        let e = (-2.0 * xi * xi.acos() / (1.0 - xi * xi).sqrt()).exp();
        [e, e * (1.0 + xi * (1e5_f64 / 0.5).sqrt() * 2e-5)]
    };
    let both = |e: f64| [e; 2];
    let damped = |law: &str| format!(r#""law": "{law}", "restitution": "e""#);
    let targets = [0.2, 0.65];
    let curved = targets.map(|e| both(of_kappa(1.5 * (1.0 - e))));
    for (contact, expected) in [
        (r#""law": "impact", "k": 1e5"#.to_owned(), [both(1.0); 2]),
        (
            format!(
                r#"{}, "k": 1e5, "colliding_mass": 0.5"#,
                damped("kelvin-voigt")
            ),
            targets.map(dashpot),
        ),
        (
            format!(r#"{}, "k_h": 1e6"#, damped("hunt-crossley")),
            curved,
        ),
    ] {
        let used = contact.contains("\"e\"");
        let parameters = if used {
            r#""e": [0.2, 0.65], "dt": 2e-5, "duration": 0.05"#
        } else {
            r#""dt": [2e-5, 1e-5], "duration": 0.05"#
        };
        bench.file("s.json", collision(parameters, &contact, ""));
        bench.expect(0, &["run", "s.json"]);
        for (found, [_, expected]) in column(&bench, "restitution(j)").into_iter().zip(expected) {
            // Some (omega dt)^2, with omega dt = 0.009.
            assert!(
                (found.unwrap() - expected).abs() < 5e-5,
                "{contact}: {found:?} {expected}"
            );
        }
        if !used {
            continue;
        }
        // `explain` has target and closed form.
        let explained = bench.expect(0, &["explain", "s.json", "0"]).out;
        let line = format!(
            "restitution {} (target 0.2)",
            (expected[0][0] * 1e3).round() / 1e3
        );
        assert!(explained.contains(&line), "{line}: {explained}");
    }
    // Impulses have it to round-off.
    let rigid = r#""e": [0.2, 0.65], "method": "moreau-jean", "dt": 1e-3, "duration": 0.05"#;
    bench.file(
        "s.json",
        collision(rigid, r#""law": "rigid", "e": "e""#, ""),
    );
    bench.expect(0, &["run", "s.json"]);
    for (found, expected) in column(&bench, "restitution(j)").into_iter().zip(targets) {
        assert!(
            (found.unwrap() - expected).abs() < 1e-12,
            "{found:?} {expected}"
        );
    }
}

#[test]
fn a_contact_without_a_whole_impact_has_no_restitution() {
    let bench = Bench::new();
    // It touches from 0.01 to 0.017 s.
    let parameters = r#""dt": 1e-4, "duration": [0.005, 0.014, 0.05]"#;
    bench.file(
        "s.json",
        collision(parameters, r#""law": "impact", "k": 1e5"#, ""),
    );
    bench.expect(0, &["run", "s.json"]);
    let collided: Vec<bool> = column(&bench, "restitution(j)")
        .iter()
        .map(Option::is_some)
        .collect();
    assert_eq!(collided, [false, false, true]);
}

#[test]
fn a_restitution_that_is_not_the_target_is_a_note_and_is_not_denied() {
    let bench = Bench::new();
    let template = r#""e": [0.5, LOW, HIGH, 0.99], "dt": 1e-4, "duration": 0.05"#;
    // The law of Hunt and Crossley gives 0.05 more than the target 0.7477.
    let parameters = template.replace("LOW", "0.745").replace("HIGH", "0.75");
    let contact = r#""law": "hunt-crossley", "k_h": 1e6, "restitution": "e""#;
    assert_eq!(
        bench.kinds(&collision(&parameters, contact, "")),
        some(&[("restitution", 2, 0)])
    );
    let done = bench.expect(0, &["run", "s.json", "--deny-warnings"]);
    assert!(
        done.err.contains(
            "(note restitution; case 0: e = 0.5; contact j: restitution 0.663 (target 0.5))"
        ),
        "{done:?}"
    );
}
