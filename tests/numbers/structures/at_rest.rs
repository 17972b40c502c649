//! A structure that does not move has no ratios of round-offs.

use serde_json::json;
use slipgap::solve::Warning;
use slipgap::study;

/// The energy metrics of a body on a floor under a pulse, and whether a contact seems to make energy, in every method.
fn of_sticking(between: [&str; 2], law: &str, limit: f64) {
    let written = json!({
        "problem": "structure",
        "parameters": {
            "dt": [0.002, 0.0005], "duration": 0.6,
            "method": ["average-acceleration", "linear-acceleration", "generalized-alpha", "central-difference", "bathe"]
        },
        "structure": {
            "masses": {"m": 2.687, "n": 1.3},
            "springs": [{"between": ["ground", "m"], "k": 1839, "c": 0.8812}],
            "ground": {"pulse": {"cosine": {"amplitude": 1.042, "period": 0.2812, "sampled": 0.01}}},
            "contacts": {
                "c": {"law": law, "limit": limit, "between": between},
                "d": {"law": "coulomb", "limit": 9, "between": ["n", "m"]}
            }
        },
        "metrics": ["energy_error", "numerical_dissipation"]
    });
    let study = study::parse("s.json", &written.to_string()).unwrap_or_else(|why| panic!("{why}"));
    for case in study.cases() {
        let solution = study.problem.solve(&case, &study.metrics).unwrap();
        let gains = |warning: Warning| warning == Warning::ContactGain;
        assert!(!solution.warnings.iter().any(gains), "{case:?}");
        for value in solution.metrics {
            // Round-off of 1200 steps over a thousandth of what the forces take from a step; before, up to 609.
            assert!(value.unwrap().abs() < 1e-9, "{value:?} {case:?}");
        }
    }
}

#[test]
fn the_energies_of_a_contact_that_never_slides_are_no_ratios_of_round_offs() {
    of_sticking(["m", "ground"], "coulomb", 8.246);
    of_sticking(["ground", "m"], "coulomb", 1e3);
}
