//! Contacts in a plane: what is refused, and the warning of two contacts in their place.

use crate::Bench;

/// A body that slides, with these keys of its contact.
fn body(contact: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}}, "metrics": ["peak(a.x)"], "structure": {{
  "masses": {{"a": {{"mass": 1, "direction": ["x", "y"]}}}},
  "start": {{"a.x": {{"v": 1}}}},
  "contacts": {{"f": {{{contact}}}}}
}}}}"#
    )
}

#[test]
fn what_is_no_contact_in_a_plane_is_named() {
    let bench = Bench::new();
    for (contact, told) in [
        (
            r#""law": "dahl", "between": ["ground", "a"], "directions": ["x", "y"], "limit": 1, "k": 1, "exponent": 1"#,
            "structure.contacts.f: dahl does not act in a plane; allowed: displacement-control, velocity-control, coulomb",
        ),
        (
            r#""law": "coulomb", "between": ["ground", "a"], "directions": ["x", "x"], "limit": 1"#,
            "structure.contacts.f.directions: the two directions must differ",
        ),
        (
            r#""law": "coulomb", "between": ["ground", "b"], "directions": ["x", "y"], "limit": 1"#,
            "structure.contacts.f.between[1]: unknown node \"b.x\"",
        ),
        (
            r#""law": "coulomb", "plane": [["ground", "a.x"]], "limit": 1"#,
            "structure.contacts.f.plane: must be two pairs of nodes",
        ),
        (
            r#""law": "coulomb", "plane": [["ground", "ground"], ["ground", "ground"]], "limit": 1"#,
            "structure.contacts.f: a contact needs two different nodes in a direction",
        ),
        (
            r#""law": "coulomb", "between": ["ground", "a"], "directions": ["x", "y"], "limit": 1, "gap": 0.1"#,
            "structure.contacts.f.gap: a contact in a plane has no gap",
        ),
    ] {
        bench.file("s.json", body(contact));
        let err = bench.expect(2, &["check", "s.json"]).err;
        assert!(err.contains(told), "{contact}: {err}");
    }
}

#[test]
fn metrics_name_a_direction_where_both_have_none_together() {
    let bench = Bench::new();
    let contact =
        r#""law": "coulomb", "between": ["ground", "a"], "directions": ["x", "y"], "limit": 1"#;
    for (metric, told) in [
        ("work(f)", None),
        ("residual_slip(f)", None),
        ("peak(f.r)", None),
        ("last(f.S.2)", None),
        ("last(f.dissipated)", None),
        (
            "impacts(f)",
            Some("f is a contact in a plane; name a direction, f.1 or f.2"),
        ),
        ("peak(f.S.3)", Some("no node or contact 'f.S.3'")),
    ] {
        bench.file("s.json", body(contact).replace("peak(a.x)", metric));
        match told {
            None => drop(bench.expect(0, &["run", "s.json"])),
            Some(told) => {
                let err = bench.expect(2, &["check", "s.json"]).err;
                assert!(err.contains(told), "{metric}: {err}");
            }
        }
    }
}

#[test]
fn two_contacts_of_one_body_in_two_directions_are_a_square() {
    let bench = Bench::new();
    let two = |second: &str| {
        body(r#""law": "displacement-control", "k": 9, "between": ["ground", "a.x"], "limit": 0.1"#).replace(
            "\"contacts\": {",
            &format!(
                "\"contacts\": {{\"g\": {{\"law\": \"displacement-control\", \"k\": 9, \"between\": [\"ground\", \"{second}\"], \"limit\": 0.1}}, "
            ),
        )
    };
    bench.file("s.json", two("a.y"));
    for verb in ["run", "check", "explain"] {
        let done = bench.expect(0, &[verb, "s.json"]);
        let text = format!("{}{}", done.out, done.err);
        assert!(
            text.contains("contacts g in y and f in x"),
            "{verb}: {text}"
        );
    }
    // Two contacts in one direction are none.
    bench.file("s.json", two("a.x"));
    let done = bench.expect(0, &["check", "s.json"]);
    assert!(!done.err.contains("friction-directions"), "{}", done.err);
}

#[test]
fn contacts_along_two_directions_are_a_square_unless_they_are_parallel() {
    let bench = Bench::new();
    let study = |second: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 0.1}}, "metrics": ["peak(x)"], "structure": {{
  "masses": {{"x": 1, "y": {{"mass": 1, "direction": "y"}}}},
  "start": {{"x": {{"v": 1}}}},
  "contacts": {{
    "f": {{"law": "displacement-control", "k": 9, "limit": 0.1, "along": {{"x": 0.6, "y": 0.8}}}},
    "g": {{"law": "displacement-control", "k": 9, "limit": 0.1, "along": {{{second}}}}}
  }}
}}}}"#
        )
    };
    bench.file("s.json", study(r#""x": -0.8, "y": 0.6"#));
    for verb in ["run", "check", "explain"] {
        let done = bench.expect(0, &[verb, "s.json"]);
        let text = format!("{}{}", done.out, done.err);
        let told = "contacts f in (0.600 x, 0.800 y) and g in (-0.800 x, 0.600 y)";
        assert!(text.contains(told), "{verb}: {text}");
    }
    for parallel in [r#""x": 0.6, "y": 0.8"#, r#""x": -1.2, "y": -1.6"#] {
        bench.file("s.json", study(parallel));
        let done = bench.expect(0, &["check", "s.json"]);
        assert!(!done.err.contains("friction-directions"), "{}", done.err);
    }
}
