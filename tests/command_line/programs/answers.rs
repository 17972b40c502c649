//! What programs answer counts like the motion of a method.

use super::{bench, column, fake, numbers, plain, towers};
use serde_json::Value as Json;

#[test]
fn the_shipped_program_agrees_with_the_method_of_the_product() {
    let bench = bench();
    let names = [
        "peak(a)",
        "last(b.v)",
        "peak(joint.S)",
        "peak(a.a_abs)",
        "mean(joint.r)",
        "last(energy.input)",
        "last(energy.damping)",
        "rms_error(a)",
        "impacts(joint)",
        "work(joint)",
        "difference(a)",
    ];
    let listed: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
    let metrics = format!(
        r#", "metrics": [{}, "energy_error", "cost", "wall"]"#,
        listed.join(", ")
    );
    let parameters =
        r#""method": ["average-acceleration", "plain"], "tol": [1e-6, 1e-8], "gap": [0.01, 0.02]"#;
    bench.file("s.json", towers(&plain(), parameters, &metrics));
    bench.expect(0, &["run", "s.json", "--allow-programs", "--jobs", "2"]);
    let folder = "figures/s";
    // Two cases of the method, and four of the program, whose parameter is an axis for it alone.
    let methods = column(&bench, folder, "method");
    assert_eq!(methods[..2], ["average-acceleration"; 2]);
    assert_eq!(methods[2..], ["plain"; 4]);
    assert_eq!(
        column(&bench, folder, "tol"),
        ["", "", "1e-6", "1e-6", "1e-8", "1e-8"]
    );
    for name in names {
        let found = numbers(&bench, folder, name);
        for (place, x) in found.iter().enumerate() {
            let own = found[place % 2];
            // Round-off of 500 steps; a change of 1e-10 grows by another factor, and is itself a difference of such numbers.
            let most = if name == "difference(a)" { 1e-2 } else { 1e-12 };
            // The work of an elastic contact is what is left of pushes and pulls of the order of 1.
            let size = if name == "work(joint)" {
                1.0
            } else {
                own.abs()
            };
            assert!((x - own).abs() <= most * size, "{name}: {x} {own}");
        }
    }
    // The books of its motion close to round-off, as average acceleration has no numerical dissipation.
    assert!(
        numbers(&bench, folder, "energy_error")
            .iter()
            .all(|x| *x < 1e-12)
    );
    assert_eq!(
        column(&bench, folder, "cost"),
        ["", "", "500.0", "500.0", "500.0", "500.0"]
    );
    let seconds = column(&bench, folder, "wall");
    assert_eq!(seconds[..2], [""; 2]);
    assert!(
        seconds[2..]
            .iter()
            .all(|cell| cell.parse::<f64>().unwrap() > 0.0)
    );
    // Without seconds, any number of workers gives the same bytes, and shards the same results; with them, a comparison leaves them out.
    bench.expect(0, &["run", "s.json", "--allow-programs", "--out", "again"]);
    bench.expect(0, &["compare", "figures", "again"]);
    let without = metrics.replace(", \"wall\"", "");
    bench.file("s.json", towers(&plain(), parameters, &without));
    bench.expect(0, &["run", "s.json", "--allow-programs"]);
    let results = bench.text("figures/s/results.csv");
    for words in [
        &[
            "run",
            "s.json",
            "--allow-programs",
            "--jobs",
            "1",
            "--out",
            "one",
        ][..],
        &[
            "run",
            "s.json",
            "--allow-programs",
            "--out",
            "two",
            "--shard",
            "1/2",
        ],
        &[
            "run",
            "s.json",
            "--allow-programs",
            "--out",
            "two",
            "--shard",
            "2/2",
        ],
        &["merge", "s.json", "--allow-programs", "--out", "two"],
    ] {
        bench.expect(0, words);
    }
    assert_eq!(bench.text("one/s/results.csv"), results);
    assert_eq!(bench.text("two/s/results.csv"), results);
}

#[test]
fn a_request_longer_than_a_pipe_arrives_whole() {
    let bench = bench();
    let parameters = r#""method": ["average-acceleration", "plain"], "tol": 1e-8, "gap": 10"#;
    let metrics = r#", "metrics": ["last(a)", "last(b)"]"#;
    // The ground and the load over 10 000 steps are 400 kB of text, of which a pipe takes 64 kB at once.
    let short = towers(&plain(), parameters, metrics);
    bench.file(
        "s.json",
        short.replace("\"duration\": 5", "\"duration\": 100"),
    );
    bench.expect(0, &["run", "s.json", "--allow-programs", "--jobs", "1"]);
    for name in ["last(a)", "last(b)"] {
        let found = numbers(&bench, "figures/s", name);
        // Round-off of 10 000 steps.
        assert!(
            (found[1] - found[0]).abs() <= 1e-9 * found[0].abs(),
            "{found:?}"
        );
    }
}

#[test]
fn a_program_is_asked_for_what_metrics_need() {
    let asked = |metrics: &str| {
        let bench = bench();
        let more = format!(r#", "metrics": [{metrics}]"#);
        let parameters = r#""method": "fake", "gap": 0.01"#;
        bench.file("s.json", towers(&fake("asked"), parameters, &more));
        let said = bench.expect(3, &["run", "s.json", "--allow-programs"]).err;
        let (_, rest) = said.split_once("asked for ").unwrap();
        rest.lines().next().unwrap().to_owned()
    };
    assert_eq!(asked(r#""peak(a)""#), "a");
    assert_eq!(asked(r#""last(b.v)", "peak(joint.S)""#), "b.v joint.S");
    assert_eq!(asked(r#""peak(joint.r)""#), "a b");
    // u'' = (p - c v - k u + S)/m.
    assert_eq!(asked(r#""peak(a.a)""#), "a a.v joint.S");
    assert_eq!(asked(r#""energy_error""#), "a b a.v b.v joint.S");
}

#[test]
fn the_version_of_a_program_and_its_files_are_in_the_keys_of_stores() {
    let bench = bench();
    bench.file("version", "1");
    let file = r#""files": ["fake.py"], "timeout""#;
    let program = fake("version").replace("\"timeout\"", file);
    let parameters = r#""method": "fake", "gap": [0.01, 0.02]"#;
    let metrics = r#", "metrics": ["peak(a)"]"#;
    bench.file("s.json", towers(&program, parameters, metrics));
    let run = || bench.expect(0, &["run", "s.json", "--allow-programs"]).err;
    assert!(run().contains("s: 2 cases run\n"));
    assert!(
        run().contains("s: 2 of 2 cases from the store"),
        "{}",
        run()
    );
    // Without permission, the version is not known, and the store is not outdated.
    let status = bench.expect(0, &["status", "s.json"]).out;
    assert!(status.contains("all    done   2      2 "), "{status}");
    bench.file("version", "2");
    assert!(run().contains("computed by another version of the solver"));
    bench.file("fake.py", &(super::FAKE.to_owned() + "\n"));
    assert!(run().contains("2 cases run"), "{}", run());
}

#[test]
fn a_request_has_the_equations_of_its_case() {
    let bench = bench();
    let parameters =
        r#""method": ["average-acceleration", "plain"], "tol": [1e-6, 1e-8], "gap": [0.01, 0.02]"#;
    let metrics = r#", "metrics": ["peak(a)", "peak(joint.S)"]"#;
    bench.file("s.json", towers(&plain(), parameters, metrics));
    let line = bench
        .expect(0, &["explain", "s.json", "5", "--request"])
        .out;
    assert_eq!(line.lines().count(), 1);
    let request: Json = serde_json::from_str(&line).unwrap();
    let is = |key: &str, text: &str| {
        let expected: Json = serde_json::from_str(text).unwrap();
        assert_eq!(request[key], expected, "{key}");
    };
    is("format", "1");
    is("case", "5");
    is("study", r#""s""#);
    is("numbers", r#"{"tolerance": 1e-8}"#);
    is(
        "parameters",
        r#"{"method": "plain", "tol": 1e-8, "gap": 0.02, "dt": 0.01, "duration": 5.0}"#,
    );
    is("units", r#""t, kN, m, s""#);
    is("dt", "0.01");
    is("steps", "500");
    is("dofs", r#"["a", "b"]"#);
    is("M", "[[0, 0, 2.0], [1, 1, 3.0]]");
    is("K", "[[0, 0, 300.0], [1, 1, 200.0]]");
    is("C", "[[0, 0, 2.0]]");
    // m u'' = -c v.
    is(
        "start",
        r#"{"u": [0.0, 0.0], "v": [0.3, 0.0], "a": [-0.3, 0.0], "S": {"joint": 0.0}, "slip": {}}"#,
    );
    is("supports", "{}");
    is(
        "contacts",
        r#"[{"name": "joint", "law": "impact-spring", "numbers": {"k": 50000.0, "gap": 0.02}, "along": [[0, -1.0], [1, 1.0]]}]"#,
    );
    is("channels", r#"["a", "joint.S"]"#);
    let at = |list: &Json, i: usize| list[i].as_f64().unwrap();
    let (load, ground) = (&request["loads"]["b"], &request["ground"]["x"]);
    for i in [0, 1, 250, 500] {
        let t = i as f64 * 0.01;
        assert!((at(load, i) - 2.0 * (3.0 * t).sin()).abs() < 1e-14);
        assert!((at(&ground["a"], i) - 1.5 * (7.0 * t).sin()).abs() < 1e-14);
    }
    assert_eq!(load.as_array().unwrap().len(), 501);
    assert_eq!(ground["influence"], serde_json::json!([1.0, 1.0]));
    let scales = request["scales"].as_object().unwrap();
    assert!(scales.len() == 3 && scales.values().all(|x| x.as_f64().unwrap() > 0.0));
}
