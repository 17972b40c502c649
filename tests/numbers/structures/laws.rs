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
            "stribeck-hyperbolic",
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

/// X'' + X = S(v - X') of a mass on a belt, by the Runge-Kutta method of fourth order: X and X' after a time.
fn on_belt(speed: f64, start: f64, left: &dyn Fn(f64) -> f64, [time, dt]: [f64; 2]) -> [f64; 2] {
    let edge = 0.05 * 1.5;
    let force = |v: f64| {
        let size = match v.abs() < edge {
            true => v.abs() / 0.05,
            false => 1.0 + 0.5 * left((v.abs() - edge) / 0.2),
        };
        size.copysign(v)
    };
    let rate = |[x, v]: [f64; 2]| [v, force(speed - v) - x];
    let mut at = [start, 0.0];
    for _ in 0..(time / dt).round() as usize {
        let along = |k: [f64; 2], h: f64| [at[0] + h * k[0], at[1] + h * k[1]];
        let first = rate(at);
        let second = rate(along(first, 0.5 * dt));
        let third = rate(along(second, 0.5 * dt));
        let last = rate(along(third, dt));
        let mean = |i: usize| (first[i] + 2.0 * (second[i] + third[i]) + last[i]) / 6.0;
        at = along([mean(0), mean(1)], dt);
    }
    at
}

/// On a fast belt a mass slides, at X = L + (L_s - L)/(1 + x), and a small oscillation grows with half the slope of the force; on a
/// slow one it sticks and slips.
#[test]
fn a_mass_on_a_belt_sticks_and_slips_as_its_integral() {
    let left = |x: f64| 1.0 / (1.0 + x);
    let run = |speed: f64, start: f64, time: f64, dt: f64| {
        let study = parse(&format!(
            r#"{{"problem": "structure", "parameters": {{"dt": {dt}, "duration": {time}}}, "structure": {{"masses": {{"x": 1}},
                "springs": [{{"between": ["ground", "x"], "k": 1}}], "start": {{"x": {{"u": {start}, "v": 0}}, "belt": {{"v": {speed}}}}},
                "contacts": {{"f": {{"law": "stribeck-hyperbolic", "between": ["belt", "x"], "limit": 1, "c": 20, "static_ratio": 1.5, "stribeck_velocity": 0.2}}}}}},
                "metrics": ["last(x)", "last(x.v)"]}}"#
        ).replace(r#""x": 1}"#, r#""x": 1, "belt": 1e12}"#));
        let case = study.case(0).unwrap();
        let solution = study.problem.solve(&case, &study.metrics).unwrap();
        [0, 1].map(|i| solution.metrics[i].unwrap())
    };
    for (speed, start) in [(0.3, 0.0), (1.0, 1.1)] {
        let exact = on_belt(speed, start, &left, [40.0, 1e-4]);
        let errors = [0.008, 0.002].map(|dt| {
            let found = run(speed, start, 40.0, dt);
            (found[0] - exact[0]).abs().max((found[1] - exact[1]).abs())
        });
        // Of second order in the step, but for those in which it sticks or breaks loose.
        assert!(
            errors[1] < 1e-5 && errors[1] < 0.2 * errors[0],
            "{speed} {errors:?}"
        );
    }
    // At rest on the belt: X = S(1).
    let over = (1.0 - 0.075) / 0.2;
    let rest = 1.0 + 0.5 * left(over);
    assert!((run(1.0, rest, 10.0, 0.01)[0] - rest).abs() < 1e-11);
    // A small oscillation about it grows as exp(t S'/2), S' the slope, without that and with the period 2 pi/sqrt(1 - S'^2/4).
    let slope = 0.5 * left(over).powi(2) / 0.2;
    let period = 2.0 * std::f64::consts::PI / (1.0 - 0.25 * slope * slope).sqrt();
    let grown = (run(1.0, rest + 1e-6, 3.0 * period, period / 2000.0)[0] - rest) / 1e-6;
    let wanted = libm::exp(1.5 * slope * period);
    // (omega dt)^2/12 of the three periods, and the square of the amplitude.
    assert!((grown / wanted - 1.0).abs() < 1e-4, "{grown} {wanted}");
}
