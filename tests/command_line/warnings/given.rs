//! Warnings of numbers that are allowed and unlikely: each at its limit.

use crate::Bench;
use crate::warnings::{body, some};

const UNITS: &str = r#", "units": "kg, N, m, s""#;
const TIMES: &str = r#""dt": 0.01, "duration": 1"#;
const FRICTION: &str = r#""law": "displacement-control", "k": 100, "between": ["ground", "a"]"#;

/// A body with a friction contact that slides, another spring and other parts.
fn sprung(parameters: &str, springs: &str, more: &str) -> String {
    let contact = format!(r#"{FRICTION}, "limit": 0.1"#);
    let parameters = format!("{parameters}, {TIMES}");
    let study = body(&parameters, &contact, more, r#""peak(a)""#);
    study.replace(r#""k": 1}]"#, &format!(r#""k": 1}}{springs}]"#))
}

#[test]
fn a_contact_that_is_soft_beside_the_motion_overlaps_too_far() {
    let bench = Bench::new();
    // x^2 + k (x - 0.1)^2 = 1: the overlap x - 0.1 is 0.5, half of the amplitude, for k = 0.64/0.25.
    let study = |k: &str, more: &str| {
        let parameters = format!(r#""k": {k}, "dt": 0.01, "duration": 6"#);
        let contact = r#""law": "impact", "between": ["ground", "a"], "gap": 0.1, "k": "k""#;
        body(&parameters, contact, more, r#""peak(a)""#)
    };
    let soft = some(&[("deep-overlap", 2, 0)]);
    assert_eq!(bench.kinds(&study("[0.1, 2.4, 2.7, 1000]", UNITS)), soft);
    // Where only some have it, the units are those of the others.
    let message = |bench: &Bench| bench.warnings()[0]["message"].to_string();
    let of_some = message(&bench);
    assert!(
        of_some.contains("its k is small") && !of_some.contains("units"),
        "{of_some}"
    );
    bench.kinds(&study("[0.1, 2.4]", UNITS));
    assert!(message(&bench).contains("look at the units of k"));
    assert_eq!(bench.kinds(&study("[0.1, 2.4, 2.7, 1000]", "")), []);
    // With a mass of the wrong unit, too.
    let heavy = study("1000", UNITS);
    assert_eq!(bench.kinds(&heavy), []);
}

#[test]
fn the_mass_of_a_spring_is_that_of_its_nodes() {
    let bench = Bench::new();
    let of_one = r#", {"between": ["ground", "a"], "mass": "m", "period": 1}"#;
    let study = sprung(r#""m": [0.98, 0.995, 1.005, 1.02]"#, of_one, "");
    assert_eq!(bench.kinds(&study), some(&[("spring-mass", 2, 0)]));
    let table = bench.text("figures/s/manifest.json");
    assert!(
        table.contains("structure.springs[1].mass is 0.98, the nodes have 1"),
        "{table}"
    );
    // From m1 m2/(m1 + m2) to all that springs connect.
    let of_two =
        r#", {"between": ["a", "b"], "mass": "m", "period": 1}, {"between": ["b", "d"], "k": 1}"#;
    let study = sprung(r#""m": [0.49, 0.5, 1, 2.5, 2.6]"#, of_two, "")
        .replace(r#""a": 1}"#, r#""a": 1, "b": 1, "d": 0.5}"#);
    assert_eq!(bench.kinds(&study), some(&[("spring-mass", 2, 0)]));
}

#[test]
fn a_spring_with_a_period_of_milliseconds_is_named() {
    let bench = Bench::new();
    // It is far from the motion of the other spring, which has all of the displacement.
    let stiff = r#", {"between": ["a", "b"], "mass": 0.5, "period": "T"}"#;
    let study = |units: &str| {
        sprung(r#""T": [0.0099, 0.0101]"#, stiff, units).replace(r#""a": 1}"#, r#""a": 1, "b": 1}"#)
    };
    let of_period = |kinds: Vec<(String, u64, u64)>| -> Vec<(String, u64, u64)> {
        kinds
            .into_iter()
            .filter(|kind| kind.0 == "spring-period")
            .collect()
    };
    assert_eq!(
        of_period(bench.kinds(&study(UNITS))),
        some(&[("spring-period", 1, 0)])
    );
    assert!(
        bench
            .text("figures/s/manifest.json")
            .contains("structure.springs[1].period is 0.0099 s")
    );
    assert_eq!(of_period(bench.kinds(&study(""))), []);
}

#[test]
fn two_impacts_that_are_the_same_are_noted() {
    let bench = Bench::new();
    let study = |other: &str| {
        let contact = r#""law": "impact", "between": ["ground", "a"], "gap": 0.1, "k": "k""#;
        let two = format!(r#"{contact}}}, "d": {{{other}"#);
        body(
            r#""k": [10, 20], "dt": 0.001, "duration": 1"#,
            &two,
            "",
            r#""peak(a)""#,
        )
    };
    let same = r#""law": "impact", "between": ["ground", "a"], "gap": "0.05 + 0.05", "k": "2*k/2""#;
    assert_eq!(bench.kinds(&study(same)), some(&[("impacts-twice", 2, 0)]));
    assert!(
        bench
            .text("figures/s/manifest.json")
            .contains("contacts c and d")
    );
    // In one of the cases only, with another gap or law, or on the other side.
    assert_eq!(
        bench.kinds(&study(&same.replace("2*k/2", "20"))),
        some(&[("impacts-twice", 1, 1)])
    );
    for (old, new) in [
        ("0.05 + 0.05", "0.2"),
        (
            r#"impact", "between": ["ground", "a"], "gap": "0.05 + 0.05""#,
            r#"kelvin-voigt", "restitution": 0.9, "colliding_mass": 1, "between": ["ground", "a"], "gap": "0.1""#,
        ),
        (r#"["ground", "a"]"#, r#"["a", "ground"]"#),
    ] {
        let study = study(&same.replace(old, new));
        assert_eq!(bench.kinds(&study), [], "{new}");
    }
}

#[test]
fn an_oscillator_whose_friction_never_slides_is_found() {
    let bench = Bench::new();
    let study = |law: &str, x0: &str| {
        crate::friction(
            &format!(r#"{law}, "x0": {x0}, "dT": 0.001, "duration": 7"#),
            r#", "metrics": ["rms_error"]"#,
        )
    };
    // The force in half a period of X'' + X + (X - x0)/alpha = 0, released at x0: 2 x0/(1 + alpha). Of a weak dashpot, whose
    // X'' + X'/beta + X = 0 has nearly the velocity of free vibration: x0/beta.
    for (law, at_095) in [
        (r#""law": "displacement-control", "alpha": 99"#, 0.95 * 50.0),
        (r#""law": "velocity-control", "beta": 50"#, 0.95 * 50.0),
    ] {
        let [below, above] = [0.99 * at_095, 1.01 * at_095];
        assert_eq!(
            bench.kinds(&study(law, &below.to_string())),
            some(&[("never-slides", 1, 0)]),
            "{law}"
        );
        // The motion itself: its largest force is that of the detail, for the dashpot at most.
        bench.expect(0, &["run", "s.json", "--histories"]);
        let history = bench.text("figures/s/histories/0.csv");
        let forces = history.lines().skip(1).map(|line| {
            let cell = line.split(',').nth(3).unwrap();
            cell.parse::<f64>().unwrap().abs()
        });
        let most = forces.fold(0.0, f64::max);
        assert!(
            most <= below / 50.0 * (1.0 + 1e-6) && most > 0.98 * below / 50.0,
            "{law}: {most}"
        );
        assert_eq!(bench.kinds(&study(law, &above.to_string())), [], "{law}");
        // Where it slides in one case, it is a result in the others.
        assert_eq!(
            bench.kinds(&study(law, &format!("[{below}, {above}]"))),
            [],
            "{law}"
        );
    }
    let pulled = r#""law": "displacement-control", "alpha": 99, "initial_slip": "pulled""#;
    assert_eq!(bench.kinds(&study(pulled, "5")), []);
}

#[test]
fn ratios_and_coefficients_are_no_percentages() {
    let bench = Bench::new();
    let spring = r#", {"between": ["ground", "a"], "mass": 1, "period": 1, "ratio": "x"}"#;
    let ratio = some(&[("damping-ratio", 1, 1)]);
    assert_eq!(bench.kinds(&sprung(r#""x": [1, 1.01]"#, spring, "")), ratio);
    let modal = r#", "modal_damping": "x""#;
    assert_eq!(bench.kinds(&sprung(r#""x": [1, 1.01]"#, "", modal)), ratio);
    let coefficient =
        sprung(r#""x": [2, 2.01]"#, "", "").replace(r#""limit": 0.1"#, r#""nu": "x", "N": 0.01"#);
    assert_eq!(
        bench.kinds(&coefficient),
        some(&[("friction-coefficient", 1, 1)])
    );
}

#[test]
fn friction_that_never_reaches_its_limit_in_any_case_is_found() {
    let bench = Bench::new();
    // The largest elastic force is 100/sqrt(101) = 9.95, and 95 % of the limit are 9.88 and 10.07.
    let study = |limit: &str, law: &str| {
        let contact = format!(r#"{law}, "between": ["ground", "a"], "limit": "limit""#);
        let parameters = format!(r#""limit": {limit}, "dt": 0.001, "duration": 1"#);
        body(&parameters, &contact, "", r#""peak(a)""#)
    };
    let elastic = r#""law": "displacement-control", "k": 100"#;
    assert_eq!(bench.kinds(&study("10.4", elastic)), []);
    assert_eq!(
        bench.kinds(&study("10.6", elastic)),
        some(&[("never-slides", 1, 0)])
    );
    for law in [
        elastic,
        r#""law": "bouc-wen", "k": 100"#,
        r#""law": "tanh", "c": 1"#,
        r#""law": "coulomb""#,
    ] {
        assert_eq!(bench.kinds(&study("[0.1, 50]", law)), [], "{law}");
        assert_eq!(
            bench.kinds(&study("[5000, 6000]", law)),
            some(&[("never-slides", 2, 0)]),
            "{law}"
        );
    }
}

#[test]
fn the_colliding_mass_is_that_of_the_bodies() {
    let bench = Bench::new();
    let contact = r#""law": "kelvin-voigt", "k": 100, "restitution": 0.9, "colliding_mass": "m", "between": ["ground", "a"]"#;
    let parameters = format!(r#""m": [0.49, 0.51, 1.99, 2.01], {TIMES}"#);
    let study = body(&parameters, contact, "", r#""peak(a)""#);
    assert_eq!(bench.kinds(&study), some(&[("colliding-mass", 2, 0)]));
}

#[test]
fn matrices_in_other_units_or_exchanged_have_strange_periods() {
    let bench = Bench::new();
    let dofs = "node,direction\n1,x\n2,x\n";
    let matrix = |entries: [f64; 3]| {
        let [a, b, c] = entries;
        format!(
            "%%MatrixMarket matrix coordinate real symmetric\n2 2 3\n1 1 {a}\n2 1 {b}\n2 2 {c}\n"
        )
    };
    bench.file("p.dofs.csv", dofs);
    bench.file("I.mtx", matrix([1.0, 0.0, 1.0]));
    let study = |mass: &str, stiffness: &str, units: &str| {
        let units = match units {
            "" => String::new(),
            units => format!(r#""units": "{units}","#),
        };
        format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.001, "duration": 1}}, "structure": {{{units}
              "matrices": {{"p": {{"M": "{mass}", "K": "{stiffness}", "dofs": "p.dofs.csv"}}}}, "start": {{"p.1.x": {{"v": 1}}}}}},
              "metrics": ["peak(p.1.x)"]}}"#
        )
    };
    // Two storeys of 1 t and k: the longest period is 2 pi/(0.618 sqrt(k)), 10 s for k = 1.0336 and 0.05 s for 41344.
    for (k, wrong) in [
        (1.03, true),
        (1.04, false),
        (1000.0, false),
        (41300.0, false),
        (41400.0, true),
    ] {
        bench.file("K.mtx", matrix([2.0 * k, -k, k]));
        let kinds = bench.kinds(&study("I.mtx", "K.mtx", "t, kN, m, s"));
        let expected = some(&[("matrix-periods", 1, 0)]);
        assert_eq!(kinds, if wrong { expected } else { Vec::new() }, "{k}");
        assert_eq!(bench.kinds(&study("I.mtx", "K.mtx", "")), []);
    }
    // Exchanged: 2 pi sqrt((3 + sqrt(5))/2 k).
    bench.file("K.mtx", matrix([2000.0, -1000.0, 1000.0]));
    assert_eq!(
        bench.kinds(&study("K.mtx", "I.mtx", "t, kN, m, s")),
        some(&[("matrix-periods", 1, 0)])
    );
    let shown = "the longest period is 321.49 s";
    assert!(bench.text("figures/s/manifest.json").contains(shown));
    let explained = bench.expect(0, &["explain", "s.json"]);
    assert!(explained.out.contains(shown), "{explained:?}");
}

#[test]
fn gravity_needs_a_node_that_it_moves() {
    let bench = Bench::new();
    let study = |gravity: &str| {
        sprung(
            r#""x": 1"#,
            "",
            &format!(r#", "static": {{"gravity": {gravity}}}"#),
        )
        .replace(r#""x": 1, "#, "")
    };
    assert_eq!(
        bench.kinds(&study("-9.81")),
        some(&[("idle-gravity", 1, 0)])
    );
    assert_eq!(bench.kinds(&study(r#"{"x": 0.01}"#)), []);
    assert_eq!(bench.kinds(&study("0")), []);
}

#[test]
fn bars_have_the_wave_speed_of_a_material() {
    let bench = Bench::new();
    // EA = c^2 m/L: 2.5e7 for 500 m/s and 6.4e9 for 8000 m/s.
    let bar = r#", "bars": {"g": {"L": 10, "EA": "EA", "mass": 1000, "n": 2}}"#;
    let held = r#", {"between": ["ground", "g.left"], "k": 1}"#;
    let study = |more: &str| {
        sprung(
            r#""EA": [2.4e7, 2.6e7, 6.3e9, 6.5e9]"#,
            held,
            &format!("{bar}{more}"),
        )
    };
    assert_eq!(bench.kinds(&study(UNITS)), some(&[("wave-speed", 2, 0)]));
    assert_eq!(bench.kinds(&study("")), []);
    let rigid = study(UNITS).replace(r#""n": 2"#, r#""n": 1"#);
    assert_eq!(bench.kinds(&rigid), some(&[("wave-speed", 1, 0)]));
    // Bars of 3e10 N/m2 and 2500 kg/m3: 3464 m/s. With kN, the density is in t.
    let bars = |force: &str, e: &str, rho: &str| {
        format!(
            r#"{{"problem": "bar-impact", "units": {{"length": "m", "force": "{force}", "time": "s"}}, "parameters": {{"E": {e},
                "A": 5, "rho": {rho}, "L": 30, "V0": 0.5, "gamma": [0.3, 1], "n": 10, "dt": 0.01, "duration": 2}}}}"#
        )
    };
    assert_eq!(bench.kinds(&bars("N", "3e10", "2500")), []);
    assert_eq!(bench.kinds(&bars("kN", "3e7", "2.5")), []);
    let found = some(&[("wave-speed", 2, 0)]);
    assert_eq!(bench.kinds(&bars("kN", "3e7", "2500")), found);
    assert_eq!(
        bench.kinds(&bars("kN", "[3e7, 3e10]", "2.5")),
        some(&[("wave-speed", 2, 2)])
    );
    // 0.5 m/s in mm/s: 14 % of the wave speed.
    let fast = bars("kN", "3e7", "2.5").replace("0.5", "500");
    assert_eq!(bench.kinds(&fast), found);
    // A unit of no known size says nothing.
    assert_eq!(
        bench.kinds(&bars("kN", "3e7", "2500").replace("\"m\"", "\"el\"")),
        []
    );
}

#[test]
fn friction_holds_a_part_and_bodies_may_fly_until_they_collide() {
    let bench = Bench::new();
    // The velocity laws have no stiffness at rest; the force of the bearing is that of another contact.
    for law in [
        r#""velocity-control", "rdotE": 0.01, "limit": 0.1"#,
        r#""tanh", "c": 1, "limit": 0.1"#,
        r#""coulomb", "limit": 0.1"#,
    ] {
        let contact = format!(r#""law": {law}, "between": ["ground", "a"]"#);
        let study = body(TIMES, &contact, "", r#""peak(a)""#);
        let free = study.replace(r#""springs": [{"between": ["ground", "a"], "k": 1}],"#, "");
        assert_eq!(bench.kinds(&free), [], "{law}");
    }
    let flies = |more: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{{TIMES}}}, "structure": {{"masses": {{"a": 1, "b": 1}},
              "contacts": {{"c": {{"law": "impact", "k": 100, "between": ["a", "b"], "gap": 0.1}}}}, "start": {{"a": {{"v": 1}}}}{more}}},
              "metrics": ["restitution(c)"]}}"#
        )
    };
    assert_eq!(bench.kinds(&flies("")), []);
    let shaken = flies(r#", "ground": {"sine": {"amplitude": 1, "omega": 1}}"#);
    assert_eq!(bench.kinds(&shaken), some(&[("unheld-part", 1, 0)]));
}

#[test]
fn the_first_studies_of_readme_and_guide_have_no_warning() {
    let bench = Bench::new();
    for (page, name) in [
        (include_str!("../../../README.md"), "towers"),
        (include_str!("../../../docs/guide.md"), "building"),
    ] {
        let named = format!("studies/{name}.json");
        let after = &page[page.find(&named).unwrap()..];
        let block = after.split("```json\n").nth(1).unwrap();
        bench.file("s.json", block.split("```").next().unwrap());
        let short = ["--set", "duration=7"];
        let run = ["run", "s.json", "--deny-warnings"];
        bench.expect(0, &[&run[..], &short[..]].concat());
    }
}

#[test]
fn weight_and_stops_on_both_sides_hold_a_part() {
    let bench = Bench::new();
    let study = |direction: &str, more: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{{TIMES}}}, "structure": {{"masses": {{"a": {{"mass": 1, "direction": "{direction}"}}}},
              "contacts": {{"c": {{"law": "impact", "k": 1000, "between": ["ground", "a"], "gap": 0}}{more}}},
              "metrics": ["peak(c.S)"]}}"#
        )
    };
    let static_load = r#"}, "static": {"gravity": -9.81}"#;
    let shaken = r#"}, "ground": {"y": {"sine": {"amplitude": 1, "omega": 1}}}"#;
    let load = |force: f64| {
        format!(
            r#"}}, "loads": [{{"at": "a", "table": {{"t": [0, 1], "f": [{force}, {force}]}}}}]"#
        )
    };
    let other = r#", "d": {"law": "impact", "k": 1000, "between": ["a", "ground"], "gap": 1}"#;
    assert_eq!(bench.kinds(&study("y", static_load)), []);
    assert_eq!(bench.kinds(&study("y", &load(-2.0))), []);
    assert_eq!(bench.kinds(&study("y", &format!("{other}{shaken}"))), []);
    // Away from the contact, or to and fro on one side of it.
    let unheld = some(&[("unheld-part", 1, 0)]);
    let found = |more: &str| {
        let kinds = bench.kinds(&study("y", more));
        kinds
            .into_iter()
            .filter(|warning| warning.0 == "unheld-part")
            .collect::<Vec<_>>()
    };
    assert_eq!(found(&load(2.0)), unheld);
    assert_eq!(found(shaken), unheld);
}

#[test]
fn an_overlap_at_the_start_is_named_with_its_force() {
    let bench = Bench::new();
    let study = r#"{"problem": "structure", "parameters": {"gap": [0, -0.02], "dt": 1e-5, "duration": 0.1}, "structure": {"masses": {"a": 1},
        "contacts": {"c": {"law": "impact", "k": 1e5, "between": ["ground", "a"], "gap": "gap"}}, "start": {"a": {"v": -1}}},
        "metrics": ["peak(c.S)"]}"#;
    assert_eq!(bench.kinds(study), some(&[("closed-at-start", 1, 1)]));
    bench.file("s.json", study);
    let run = bench.expect(0, &["run", "s.json"]);
    // k times the overlap.
    assert!(
        run.err
            .contains("contact c overlaps by 0.02 at t = 0 and presses with 2e3"),
        "{run:?}"
    );
}

#[test]
fn a_structure_runs_away_above_the_energy_of_its_barrier() {
    let bench = Bench::new();
    // Elastic up to 0.1, then 1, less 4 u: the forces are 0 at u = 0.25, after the work 0.075 = v^2/2.
    let barrier = 0.15_f64.sqrt();
    let study = format!(
        r#"{{"problem": "structure", "parameters": {{"v": [{}, {}], "dt": 0.001, "duration": 6}}, "structure": {{"masses": {{"a": 1}},
          "springs": [{{"between": ["ground", "a"], "k": -4}}],
          "contacts": {{"hinge": {{"law": "bilinear", "k1": 10, "Fy": 1, "k2": 0, "between": ["ground", "a"]}}}},
          "start": {{"a": {{"v": "v"}}}}}}, "metrics": ["peak(a)"]}}"#,
        0.99 * barrier,
        1.01 * barrier
    );
    assert_eq!(bench.kinds(&study), some(&[("runaway", 1, 1)]));
}

#[test]
fn friction_in_two_directions_is_seen_at_tied_nodes_and_fans_have_polygons() {
    let bench = Bench::new();
    let matrix = |a: f64| {
        let head = "%%MatrixMarket matrix coordinate real symmetric\\n3 3 3\\n";
        format!("{head}1 1 {a}\\n2 2 {a}\\n3 3 {}\\n", 20.0 * a)
    };
    let study = |contacts: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 0.1}}, "structure": {{"matrices": {{"b": {{"M": "{}", "K": "{}",
              "dofs": [["1", "x"], ["1", "y"], ["1", "rz"]], "ties": "node,direction,terms\n2,x,1.x:1.0,1.rz:3.0\n2,y,1.y:1.0\n"}}}},
              "contacts": {{{contacts}}}, "ground": {{"x": {{"sine": {{"amplitude": 9, "omega": 9}}}}}}}}, "metrics": ["peak(b.1.x)"]}}"#,
            matrix(1.0),
            matrix(50.0)
        )
    };
    let two = ["x", "y"].map(|axis| {
        format!(
            r#""f{axis}": {{"law": "coulomb", "between": ["ground", "b.2.{axis}"], "limit": 0.01}}"#
        )
    });
    let kinds = bench.kinds(&study(&two.join(", ")));
    assert!(
        kinds
            .iter()
            .any(|warning| warning.0 == "friction-directions"),
        "{kinds:?}"
    );
    let fan = (0..8).map(|i| {
        let (y, x) = (f64::from(i) * std::f64::consts::PI / 8.0).sin_cos();
        format!(r#""f{i}": {{"law": "displacement-control", "k": 10, "along": {{"b.1.x": {x}, "b.1.y": {y}}}, "limit": 0.01}}"#)
    });
    bench.file("s.json", study(&fan.collect::<Vec<_>>().join(", ")));
    let run = bench.expect(0, &["run", "s.json"]);
    assert!(
        run.err.contains("a polygon of 16 sides") && !run.err.contains("square"),
        "{run:?}"
    );
}

#[test]
fn the_elastic_link_of_a_series_need_not_slide() {
    let bench = Bench::new();
    let study = |limit: &str, other: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{{TIMES}}}, "structure": {{"masses": {{"a": 1}}, "springs": [{{"between": ["ground", "a"], "k": 1}}],
              "contacts": {{"c": {{"between": ["ground", "a"], "series": [
                {{"law": "displacement-control", "k": 10, "limit": {limit}}}, {other}]}}}},
              "start": {{"a": {{"v": 1}}}}}}, "metrics": ["peak(a)"]}}"#
        )
    };
    for other in [
        r#"{"law": "viscous", "c": 1, "a": 1}"#,
        r#"{"law": "displacement-control", "k": 10, "limit": 0.01}"#,
        r#"{"law": "bilinear", "k1": 10, "Fy": 0.01, "ratio": 0.1}"#,
    ] {
        assert_eq!(bench.kinds(&study("1e6", other)), [], "{other}");
    }
    let stuck = study(
        "1e6",
        r#"{"law": "displacement-control", "k": 10, "limit": 1e5}"#,
    );
    assert_eq!(bench.kinds(&stuck), some(&[("never-slides", 1, 0)]));
}
