//! Titles of metrics and channels, and the names that a study gives them.

use super::{faults, study};
use crate::Input;
use slipgap_problem::problem::numbers::parameter::Value;

/// Two masses with a contact, a spring with a name, and these `names`.
fn named(names: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"gap": 0.01, "width": 2, "dt": 0.01, "duration": 1}}, "names": {{{names}}},
          "structure": {{"units": "t, kN, m, s", "masses": {{"f1": 1, "f2": "width"}},
            "springs": [{{"name": "storey", "between": ["ground", "f1"], "k": 1}}, {{"between": ["ground", "f2"], "k": 1}}],
            "contacts": {{"pier": {{"law": "impact", "between": ["f1", "f2"], "gap": "gap", "k": 10}}}},
            "ground": {{"synthetic": {{"seed": 1}}}}}},
          "metrics": ["peak(f1.a_abs)", "max(f2 - f1)", "peak(pier.S)", "impulse(pier)", "impacts(pier.S)", "last(pier.dissipated)"],
          "figures": [{{"name": "h", "kind": "history",
            "y": ["f1.a_abs", "f2 - f1", "pier.S", "storey.S", "ground", "base + storey.S", "energy.kinetic"]}}]}}"#
    )
}

/// The titles of the quantities of figures.
fn quantities(names: &str) -> Vec<String> {
    let study = study(&named(names));
    let quantities = study.problem.schema().quantities.iter();
    quantities
        .map(|quantity| quantity.title.to_string())
        .collect()
}

/// The titles of metrics.
fn metrics(names: &str) -> Vec<String> {
    let study = study(&named(names));
    (0..study.measures.len())
        .map(|row| study.title(row))
        .collect()
}

#[test]
fn channels_and_metrics_are_in_words_with_set_units() {
    assert_eq!(
        quantities(""),
        [
            "Absolute acceleration of f1, m/s^2^",
            "Displacement of f2 relative to f1, m",
            "Contact force of pier, kN",
            "Force of storey, kN",
            "Ground acceleration, m/s^2^",
            "Base force + force of storey, kN",
            "Kinetic energy, kN·m",
        ]
    );
    assert_eq!(
        metrics(""),
        [
            "Peak absolute acceleration of f1, m/s^2^",
            "Largest displacement of f2 relative to f1, m",
            "Peak contact force of pier, kN",
            "Impulse of pier, kN·s",
            "Number of impacts of pier",
            "Last energy dissipated by pier, kN·m",
        ]
    );
}

#[test]
fn names_reach_channels_and_contacts() {
    let names = r#""f2-f1": ["drift", "cm"], "pier": ["gap at the pier"], "storey.S": ["shear"], "width": ["width of it", "t"]"#;
    let found = quantities(names);
    assert_eq!(
        found[1..4],
        [
            "Drift, cm",
            "Contact force of gap at the pier, kN",
            "Shear, kN"
        ]
    );
    assert_eq!(found[5], "Base force + shear, kN");
    let found = metrics(names);
    assert_eq!(
        found[1..4],
        [
            "Largest drift, cm",
            "Peak contact force of gap at the pier, kN",
            "Impulse of gap at the pier, kN·s"
        ]
    );
    // A parameter is before a part of the structure.
    let titled = study(&named(names));
    let table = titled.problem.parameters();
    let width = table.iter().find(|parameter| parameter.name == "width");
    assert_eq!(
        width.map(|parameter| parameter.title()),
        Some("Width of it, t".into())
    );
    // Columns keep their names.
    let study = study(&named(names));
    assert_eq!(study.measures[1].name, "max(f2 - f1)");
}

#[test]
fn a_name_of_nothing_is_a_fault() {
    for (names, part) in [
        (
            r#""peir": ["x"]"#,
            "unknown key \"peir\", did you mean \"pier\"?",
        ),
        (r#""storey.s": ["x"]"#, "did you mean \"storey.S\"?"),
        (r#""pier": ["x", "kN"]"#, "must be a list of a name, as in"),
        (r#""f1": "x""#, "must be a list of a name and a unit"),
    ] {
        let found = faults(&named(names));
        assert!(found.contains(part), "{names}: {found}");
    }
}

#[test]
fn records_are_named_by_their_headers_or_by_the_study() {
    let folder = std::env::temp_dir().join(format!("slipgap-titles-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("r")).unwrap();
    let at2 = |component: &str| {
        format!(
            "DATABASE\nNowhere-01, 1/1/2000, Hill, {component}\nIN UNITS OF G\nNPTS= 3, DT= .5\n0 1 0\n"
        )
    };
    for (name, text) in [
        ("a.AT2", at2("90")),
        ("b.AT2", at2("180")),
        ("c.AT2", at2("180")),
        ("d.csv", "0, 0\n1, 1\n".to_owned()),
    ] {
        std::fs::write(folder.join("r").join(name), text).unwrap();
    }
    let shown = |names: &str| -> Vec<String> {
        let text = format!(
            r#"{{"problem": "structure", "parameters": {{"record": ["r/a.AT2", "r/b.AT2", "r/c.AT2", "r/d.csv"], "dt": 0.01, "duration": 1}},
              "names": {{{names}}}, "metrics": ["peak(m)"],
              "structure": {{"units": "t, kN, m, s", "masses": {{"m": 1}}, "springs": [{{"between": ["ground", "m"], "k": 1}}],
                "ground": {{"record": "record", "unit": "g"}}}}}}"#
        );
        let file = folder.join("s.json").display().to_string();
        let study = Input::new(&file, &text).study(1000).unwrap();
        let table = study.problem.parameters();
        let row = table
            .iter()
            .position(|parameter| parameter.name == "record")
            .unwrap();
        let value = |number| study.case(number).unwrap().values[row];
        // The values, which tables have, are the files.
        assert_eq!(value(0), Some(Value::Name("r/a.AT2")));
        let shown = (0..study.len())
            .map(|number| table[row].shown(value(number).unwrap().name()).to_owned());
        shown.collect()
    };
    assert_eq!(
        shown(""),
        [
            "Nowhere-01, Hill, 90°",
            "Nowhere-01, Hill, 180° (b)",
            "Nowhere-01, Hill, 180° (c)",
            "d"
        ]
    );
    let names = r#""r/b.AT2": ["the second"], "d.csv": ["a table"]"#;
    let found = shown(names);
    assert_eq!([&*found[1], &*found[3]], ["the second", "a table"]);
}

#[test]
fn titles_have_the_units_of_the_study() {
    let study = crate::parse(
        "s",
        r#"{"problem": "structure", "parameters": {"dt": 0.01, "duration": 1}, "metrics": ["peak(m)", "energy_error"],
          "structure": {"units": "t, N, mm, s", "masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 1}],
            "start": {"m": {"u": 1}}}}"#,
    )
    .unwrap_or_else(|e| panic!("{e}"));
    let [peak, error] = &study.measures[..] else {
        panic!("{:?}", study.measures);
    };
    assert_eq!(
        [&*peak.symbol, &*peak.unit],
        ["peak displacement of m, mm", "mm"]
    );
    assert_eq!(peak.bare_symbol(), "peak displacement of m");
    assert_eq!(peak.above("5"), "peak displacement of m > 5 mm");
    assert_eq!([&*error.symbol, &*error.unit], ["energy error", "1"]);
    assert_eq!(error.above("5"), "energy error > 5");
}

#[test]
fn figures_have_names_of_programs_in_every_problem() {
    let of_structure = r#""problem": "structure", "parameters": {"method": ["p-1", "q"], "dt": 0.01, "duration": 1}, "metrics": ["peak(m)"],
        "structure": {"masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "k": 1}]}"#;
    let of_textbook = r#""problem": "friction-oscillator", "parameters": {"method": ["p-1", "q"], "law": "coulomb", "dT": 0.01, "duration": 20}"#;
    for problem in [of_structure, of_textbook] {
        let parsed = |names: &str| {
            let text = format!(
                r#"{{{problem}, "programs": {{"p-1": {{"command": ["p"]}}, "q": {{"command": ["q"]}}}}, "names": {{{names}}}}}"#
            );
            crate::parse("s", &text)
        };
        let study = parsed(r#""p-1": ["Program, first rule"]"#).unwrap();
        let table = study.problem.parameters();
        let row = table
            .iter()
            .position(|parameter| parameter.name == "method")
            .unwrap();
        let values = [0, 1].map(|number| study.case(number).unwrap().values[row].unwrap().name());
        assert_eq!(values, ["p-1", "q"]);
        assert_eq!(
            values.map(|value| table[row].shown(value)),
            ["Program, first rule", "q"]
        );
        for (names, part) in [
            (r#""p": ["a"]"#, "unknown key \"p\""),
            (r#""q": "a""#, "names.q: must be a list of a name"),
            (r#""q": ["a", "m"]"#, "names.q: must be a list of a name"),
        ] {
            let why = parsed(names).unwrap_err().to_string();
            assert!(why.contains(part), "{why}");
        }
    }
}
