//! Studies of structures with laws that are not clipped lines.

use slipgap::study::{self, Study};

fn parse(text: &str) -> Study {
    study::parse("study.json", text).unwrap()
}

#[test]
fn one_mass_with_each_friction_law_is_the_friction_oscillator() {
    // In the oscillator's scales mass, stiffness and limit are 1.
    let time = "\"duration\": \"8*pi\"";
    for (law, numbers, keys) in [
        (
            "velocity-control",
            "\"beta\": 0.1, \"nu_ratio\": 0.5, \"nu_rate\": 1.5",
            "\"nu\": 1, \"N\": 1, \"rdotE\": 0.1, \"nu_min\": 0.5, \"nu_rate\": 1.5",
        ),
        (
            "tanh",
            "\"beta\": 0.1, \"nu_ratio\": 0.5, \"nu_rate\": 1.5",
            "\"nu\": 2, \"N\": 0.5, \"rdotE\": 0.1, \"nu_min\": 1, \"nu_rate\": 1.5",
        ),
        (
            "stribeck",
            "\"beta\": 0.1, \"static_ratio\": 1.4, \"stribeck_velocity\": 0.7",
            "\"limit\": 1, \"rdotE\": 0.1, \"static_ratio\": 1.4, \"stribeck_velocity\": 0.7",
        ),
        (
            "bouc-wen",
            "\"alpha\": 0.1, \"exponent\": 2",
            "\"limit\": 1, \"rE\": 0.1, \"exponent\": 2",
        ),
        (
            "dahl",
            "\"alpha\": 0.1, \"exponent\": 1",
            "\"limit\": 1, \"k\": 10",
        ),
        (
            "lugre",
            "\"sigma0\": 10, \"sigma1\": 0.3, \"sigma2\": 0.1, \"static_ratio\": 1.4, \"stribeck_velocity\": 0.7",
            "\"limit\": 1, \"sigma0\": 10, \"sigma1\": 0.3, \"sigma2\": 0.1, \"static_ratio\": 1.4, \"stribeck_velocity\": 0.7",
        ),
    ] {
        let oscillator = parse(&format!(
            r#"{{"problem": "friction-oscillator", "parameters": {{"law": "{law}", {numbers}, "dT": "pi/50", {time}}}}}"#
        ));
        let structure = parse(&format!(
            r#"{{"problem": "structure", "parameters": {{"dt": "pi/50", {time}}}, "structure": {{"masses": {{"x": 1}},
                "springs": [{{"between": ["ground", "x"], "k": 1}}], "start": {{"x": {{"u": 12}}}},
                "contacts": {{"f": {{"law": "{law}", "between": ["ground", "x"], {keys}}}}}}},
                "metrics": ["peak(x)"], "figures": [{{"name": "h", "kind": "history", "y": ["x", "x.v", "f.S"]}}]}}"#
        ));
        let solve = |study: &Study| {
            let case = study.case(0).unwrap();
            study.problem.solve(&case, &[]).unwrap().computed
        };
        let (expected, found) = (solve(&oscillator), solve(&structure));
        assert_eq!(expected.len(), 401);
        for channel in 0..3 {
            for (a, b) in expected.channel(channel).iter().zip(found.channel(channel)) {
                // Round-off of 400 steps of numbers up to 12, and of S, which follows them with slopes up to 10.
                assert!((a - b).abs() < 1e-11, "{law} {channel}: {a} {b}");
            }
        }
    }
}

/// A mass with a velocity of -1 above a stop, and a friction contact.
fn study(stop: &str, friction: &str, reference: &str, metric: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.001, "duration": 1}}, "structure": {{"masses": {{"x": 1}},
        "springs": [{{"between": ["ground", "x"], "k": 1}}], "start": {{"x": {{"v": -1}}}},
        "contacts": {{"stop": {{"between": ["ground", "x"], "gap": 0.1, {stop}}},
                      "f": {{"between": ["ground", "x"], {friction}}}}}, "contacts_reference": "{reference}"}},
        "metrics": ["{metric}"]}}"#
    )
}

const STOP: &str = "\"law\": \"hertz-damp\", \"k_h\": 1e5, \"restitution\": 0.7";
const FRICTION: &str = "\"law\": \"tanh\", \"limit\": 0.1, \"rdotE\": 0.01";

#[test]
fn every_fault_has_its_place_and_says_what_is_allowed() {
    for (stop, friction, path, message) in [
        (
            "\"law\": \"hertz\", \"k\": 1",
            FRICTION,
            "contacts.stop.k",
            "a contact with law hertz has no k; it has k_h",
        ),
        (
            "\"law\": \"hertz\"",
            FRICTION,
            "contacts.stop",
            "hertz needs k_h",
        ),
        (
            "\"law\": \"jankowski\", \"k_h\": 1, \"restitution\": 0.5",
            FRICTION,
            "contacts.stop",
            "jankowski needs colliding_mass",
        ),
        (
            "\"law\": \"kelvin-voigt\", \"colliding_mass\": 1",
            FRICTION,
            "contacts.stop",
            "kelvin-voigt needs k",
        ),
        (
            "\"law\": \"ye\", \"k_h\": 1, \"restitution\": 1.2",
            FRICTION,
            "contacts.stop.restitution",
            "must be > 0 and <= 1, got 1.2",
        ),
        (
            "\"law\": \"rigid\"",
            FRICTION,
            "contacts.stop",
            "rigid needs e",
        ),
        (
            "\"law\": \"impact-spring\"",
            FRICTION,
            "contacts.stop",
            "impact-spring needs k",
        ),
        (
            STOP,
            "\"law\": \"tanh\", \"limit\": 0.1",
            "contacts.f",
            "tanh needs c or rdotE",
        ),
        (
            STOP,
            "\"law\": \"tanh\", \"limit\": 0.1, \"c\": 1, \"nu_min\": 0.1, \"nu_rate\": 1",
            "contacts.f",
            "nu_min needs nu and N",
        ),
        (
            STOP,
            "\"law\": \"velocity-control\", \"nu\": 0.1, \"N\": 1, \"c\": 1, \"nu_min\": 0.1",
            "contacts.f",
            "give nu_min and nu_rate together",
        ),
        (
            STOP,
            "\"law\": \"velocity-control\", \"nu\": 0.1, \"N\": 1, \"c\": 1, \"nu_min\": 0.2, \"nu_rate\": 1",
            "contacts.f",
            "nu_min must be at most nu = 0.1, got 0.2",
        ),
        (
            STOP,
            "\"law\": \"stribeck\", \"limit\": 1, \"c\": 1, \"static_ratio\": 1.5",
            "contacts.f",
            "stribeck needs stribeck_velocity",
        ),
        (
            STOP,
            "\"law\": \"lugre\", \"limit\": 1",
            "contacts.f",
            "lugre needs sigma0",
        ),
        (
            STOP,
            "\"law\": \"bouc-wen\", \"limit\": 1, \"k\": 1, \"exponent\": 0.5",
            "contacts.f.exponent",
            "must be >= 1, got 0.5",
        ),
        (
            STOP,
            "\"law\": \"coulomb\", \"limit\": 1, \"pressure_exponent\": 0.2",
            "contacts.f",
            "pressure_exponent needs nu and N",
        ),
    ] {
        let text = study(stop, friction, "rigid", "peak(x)");
        let faults = study::parse("study.json", &text).unwrap_err().to_string();
        assert!(
            faults.contains(path) && faults.contains(message),
            "{stop} {friction}: {faults}"
        );
    }
}

#[test]
fn errors_against_rigid_laws_and_against_curved_ones_exist() {
    let solve = |reference: &str, metric: &str| {
        let study = parse(&study(STOP, FRICTION, reference, metric));
        let case = study.case(0).unwrap();
        let solution = study.problem.solve(&case, &[]);
        solution.map(|solution| solution.metrics[0])
    };
    // The stop returns the mass with about 0.7 of its speed in both motions.
    let error = solve("rigid", "rms_error(x)").unwrap().unwrap();
    assert!(error > 0.0 && error < 0.1, "{error}");
    // The error against rigid laws and its parts are sides of a triangle.
    let parts = ["step_error(x)", "regularisation_error(x)"];
    let [of_step, of_law] = parts.map(|metric| solve("softened", metric).unwrap().unwrap());
    assert!(
        error <= of_step + of_law && of_law <= error + of_step,
        "{error} {of_step} {of_law}"
    );
    // What the integration may err by is nothing against what the step does.
    let of_softened = solve("softened", "reference_error(x)").unwrap().unwrap();
    assert!(of_softened < 1e-3 * of_step, "{of_softened} {of_step}");
}
