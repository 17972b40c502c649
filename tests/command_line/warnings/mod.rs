//! Warnings: each kind is triggered by what it names and by nothing else, and none depends on threads, store or shards.

mod files;
mod given;
mod long_step;
mod weight;

use crate::Bench;
use serde_json::Value as Json;

impl Bench {
    /// The warnings in the manifest of study `s`.
    fn warnings(&self) -> Vec<Json> {
        let manifest: Json = serde_json::from_str(&self.text("figures/s/manifest.json")).unwrap();
        manifest["warnings"].as_array().unwrap().clone()
    }

    /// Runs a study; the kinds of warnings, each with its number of cases and the first one, from the manifest. stderr has the same.
    #[track_caller]
    pub(super) fn kinds(&self, study: &str) -> Vec<(String, u64, u64)> {
        self.file("s.json", study);
        let done = self.expect(0, &["run", "s.json"]);
        let warnings = self.warnings();
        let lines = warnings.iter().map(|warning| {
            let line = format!("s.json: {}\n", warning["message"].as_str().unwrap());
            assert!(done.err.contains(&line), "{line} {done:?}");
            let number = |key: &str| warning[key].as_u64().unwrap();
            let kind = warning["kind"].as_str().unwrap().to_owned();
            (kind, number("cases"), number("case"))
        });
        let kinds: Vec<_> = lines.collect();
        // How many cases have no contact is always said; it is a note if they are not all.
        let notes = done.err.contains("(note no-contact");
        assert_eq!(
            done.err.matches("(warning ").count() + done.err.matches("(note ").count(),
            kinds.len(),
            "{done:?}"
        );
        let is_note = |kind: &(String, u64, u64)| notes && kind.0 == "no-contact";
        kinds.into_iter().filter(|kind| !is_note(kind)).collect()
    }
}

pub(super) fn some(kinds: &[(&str, u64, u64)]) -> Vec<(String, u64, u64)> {
    let owned = |(kind, cases, first): &(&str, u64, u64)| (kind.to_string(), *cases, *first);
    kinds.iter().map(owned).collect()
}

/// A body of 1 on a spring of 1 with the velocity -1, with these parameters and contact, other parts of the structure, and metrics.
pub(super) fn body(parameters: &str, contact: &str, more: &str, metrics: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{{parameters}}},
          "structure": {{"masses": {{"a": 1}}, "springs": [{{"between": ["ground", "a"], "k": 1}}],
          "contacts": {{"c": {{{contact}}}}}, "start": {{"a": {{"v": -1}}}}{more}}}, "metrics": [{metrics}]}}"#
    )
}

#[test]
fn impacts_of_every_law_need_some_steps_at_the_stiffness_they_reach() {
    let bench = Bench::new();
    // k: pi/100 s. k_h: delta is (1.25/1e5)^0.4 = 0.011, and the body touches for 2.94 delta = 0.032 s or a little longer.
    for law in [
        r#""law": "impact", "k": 1e4"#,
        r#""law": "kelvin-voigt", "k": 1e4, "restitution": 0.6, "colliding_mass": 1"#,
        r#""law": "hertz", "k_h": 1e5"#,
        r#""law": "hertz-damp", "k_h": 1e5, "restitution": 0.6"#,
        r#""law": "hunt-crossley", "k_h": 1e5, "restitution": 0.6"#,
        r#""law": "ye", "k_h": 1e5, "restitution": 0.6"#,
        r#""law": "jankowski", "k_h": 1e5, "restitution": 0.6, "colliding_mass": 1"#,
    ] {
        let contact = format!(r#"{law}, "between": ["ground", "a"], "gap": "gap""#);
        // 3 and 8 steps. The gap of 5 does not close: then the step is fine.
        let parameters = r#""gap": [0.1, 5], "dt": [0.004, 0.01], "duration": 1"#;
        let kinds = bench.kinds(&body(parameters, &contact, "", "\"peak(a)\""));
        assert!(
            kinds.contains(&("short-contact".to_owned(), 1, 1)),
            "{law}: {kinds:?}"
        );
        // In the other cases it is a result that the gap stays open.
        assert!(
            kinds.iter().all(|kind| kind.0 != "no-contact"),
            "{law}: {kinds:?}"
        );
        let open = parameters.replace("[0.1, 5]", "[4, 5]");
        assert_eq!(
            bench
                .kinds(&body(&open, &contact, "", "\"peak(a)\""))
                .iter()
                .find(|kind| kind.0 == "no-contact"),
            Some(&("no-contact".to_owned(), 4, 0)),
            "{law}"
        );
    }
    // A spring that is reached slowly is softer: delta is (1.25e-4/1e5)^0.4 = 2.8e-4 at 0.01, and the body touches for 0.08 s.
    let contact = r#""law": "hertz", "k_h": 1e5, "between": ["ground", "a"]"#;
    let slow = |v: &str| {
        let study = body(r#""dt": 0.01, "duration": 0.5"#, contact, "", "\"peak(a)\"");
        study.replace(r#""v": -1"#, &format!(r#""v": {v}"#))
    };
    assert_eq!(bench.kinds(&slow("-0.01")), []);
    let fast = bench.kinds(&slow("-1"));
    assert!(
        fast.contains(&("short-contact".to_owned(), 1, 0)),
        "{fast:?}"
    );
}

/// A girder that pounds on a light plate before soil.
fn plate(parameters: &str) -> String {
    format!(
        r#"{{"problem": "structure", "parameters": {{{parameters}, "duration": 1}},
          "structure": {{"units": "t, kN, m, s", "masses": {{"girder": 500, "plate": 0.01}},
            "springs": [{{"between": ["ground", "girder"], "k": 20000}}, {{"between": ["ground", "plate"], "k": 1}}],
            "contacts": {{"joint": {{"law": "impact", "between": ["girder", "plate"], "gap": "gap", "k": "k"}},
              "soil": {{"law": "displacement-control", "between": ["plate", "ground"], "k": 2e5, "limit": 1e4}}}},
            "start": {{"girder": {{"v": "v"}}}}}},
          "metrics": ["work(joint)", "work(soil)", "energy_error"]}}"#
    )
}

#[test]
fn a_contact_that_makes_energy_is_found_although_the_books_balance() {
    let bench = Bench::new();
    let parameters =
        r#""gap": [0.01, 0.0157, 0.02], "v": [0.5, 0.75, 1, 1.25, 1.5], "k": 1e7, "dt": 5e-4"#;
    let kinds = bench.kinds(&plate(parameters));
    let table = bench.text("figures/s/results.csv");
    let mut rows = table.lines().map(|row| row.split(',').collect::<Vec<_>>());
    let header = rows.next().unwrap();
    let column = |name: &str| header.iter().position(|h| *h == name).unwrap();
    let mut makes = Vec::new();
    for (case, row) in rows.enumerate() {
        let value = |name: &str| -> f64 { row[column(name)].parse().unwrap() };
        assert!(value("energy_error") < 1e-12);
        // The girder has all energy at t = 0.
        let least = value("work(joint)").min(value("work(soil)"));
        if least < -0.01 * 250.0 * value("v").powi(2) {
            makes.push(case as u64);
        }
    }
    assert!((2..14).contains(&makes.len()), "{makes:?}");
    // The work up to the last step is that of the metric; up to an earlier one it may be less.
    let gain = kinds.iter().find(|kind| kind.0 == "contact-gain").unwrap();
    let most = makes.len() as u64 + 3;
    assert!(
        (makes.len() as u64..=most).contains(&gain.1) && gain.2 <= makes[0],
        "{gain:?} {makes:?}"
    );
    // With 25 steps in a touch of pi sqrt(0.01/1e6) = 3.1e-4 s.
    let fine = r#""gap": 0.0157, "v": [0.5, 1.5], "k": 1e6, "dt": 1.25e-5"#;
    assert_eq!(bench.kinds(&plate(fine)), []);
}

#[test]
fn bars_that_gain_energy_and_short_contacts_of_bars_are_found() {
    let bench = Bench::new();
    let bars = |gamma: &str, n: u32, dt: &str| {
        format!(
            r#"{{"problem": "bar-impact", "parameters": {{"gamma": {gamma}, "n": {n}, "dt": {dt}, "duration": 2}}}}"#
        )
    };
    assert_eq!(
        bench.kinds(&bars("[0.25, 8]", 40, "0.02")),
        some(&[("bar-gain", 1, 1)])
    );
    // The bars touch for T_I and a little longer: about 5 and 20 steps.
    let kinds = bench.kinds(&bars("1", 4, "[0.05, 0.25]"));
    assert!(
        kinds.contains(&("short-contact".to_owned(), 1, 1)),
        "{kinds:?}"
    );
    let apart =
        |gaps: &str| bars("0.25", 4, "0.0125").replace("\"n\"", &format!("\"gap\": {gaps}, \"n\""));
    assert_eq!(bench.kinds(&apart("[0, 9]")), []);
    assert_eq!(bench.kinds(&apart("[8, 9]")), some(&[("no-contact", 2, 0)]));
    let short = bars("0.25", 4, "0.0125").replace("\"duration\": 2", "\"duration\": [0.5, 2]");
    assert_eq!(bench.kinds(&short), some(&[("ends-in-contact", 1, 0)]));
}

#[test]
fn forces_of_rigid_friction_that_alternate_are_found_if_a_metric_uses_them() {
    let bench = Bench::new();
    let friction = |law: &str, metric: &str, method: &str| {
        let contact = format!(r#"{law}, "limit": 0.3, "between": ["ground", "a"]"#);
        let parameters = format!(r#""method": "{method}", "dt": 0.01, "duration": 12"#);
        body(&parameters, &contact, "", metric)
    };
    let coulomb = r#""law": "coulomb""#;
    let alternates = some(&[("alternating-force", 1, 0)]);
    for metric in ["\"impulse(c)\"", "\"contact_time(c)\"", "\"rms(c.S)\""] {
        let study = friction(coulomb, metric, "average-acceleration");
        assert_eq!(bench.kinds(&study), alternates, "{metric}");
    }
    for (law, metric, method) in [
        (coulomb, "\"work(c)\", \"peak(a)\"", "average-acceleration"),
        (coulomb, "\"impulse(c)\"", "moreau-jean"),
        (
            r#""law": "displacement-control", "rE": 0.01"#,
            "\"impulse(c)\"",
            "average-acceleration",
        ),
    ] {
        assert_eq!(
            bench.kinds(&friction(law, metric, method)),
            [],
            "{law} {metric} {method}"
        );
    }
}

#[test]
fn parts_that_nothing_holds_and_strange_records_are_found() {
    let bench = Bench::new();
    let contact =
        r#""law": "displacement-control", "rE": 0.01, "limit": 0.3, "between": ["ground", "a"]"#;
    let held = body(r#""dt": 0.01, "duration": 1"#, contact, "", "\"peak(a)\"");
    assert_eq!(bench.kinds(&held), []);
    let free = held.replace(r#""a": 1}"#, r#""a": 1, "b": 2}"#);
    assert_eq!(bench.kinds(&free), some(&[("unheld-part", 1, 0)]));
    // The synthetic record has a peak of 0.3 g.
    let ground =
        r#", "units": "kg, N, m, s", "ground": {"synthetic": {"seed": 1}, "scale": "scale"}"#;
    let parameters = r#""scale": [0, 3e-4, 4e-4, 1, 6.6, 6.7, -6.7], "dt": 0.02, "duration": 1"#;
    let shaken = body(parameters, contact, ground, "\"peak(a)\"");
    assert_eq!(bench.kinds(&shaken), some(&[("record-peak", 3, 1)]));
    // Without units the study may be one without dimensions.
    assert_eq!(
        bench.kinds(&shaken.replace(r#""units": "kg, N, m, s", "#, "")),
        []
    );
}

#[test]
fn warnings_name_a_case_are_the_same_from_everywhere_and_are_denied_on_request() {
    let bench = Bench::new();
    // More combinations than a part has, so that there are several; the last axis decides.
    let study = r#"{"problem": "bar-impact", "parameters": {"n": 2, "gamma": {"linspace": [0.5, 1, 5]}, "dt": 0.25, "duration": 0.5,
        "gap": {"linspace": [1, 2, 5001]}},
        "checks": [{"metric": "restitution", "where": {"gap": 1, "gamma": 0.5}, "max": -9}]}"#;
    let kinds = bench.kinds(study);
    let not_met = kinds.iter().find(|kind| kind.0 == "check-not-met").unwrap();
    assert_eq!(not_met.1, 1);
    // No gap of 1 or more closes before 0.5.
    let apart = kinds
        .iter()
        .position(|kind| kind.0 == "no-contact")
        .unwrap();
    let (first, expected) = (kinds[apart].2, bench.warnings());
    assert_eq!((kinds[apart].1, first), (5 * 5001, 0));
    let parameters = &expected[apart]["parameters"];
    assert_eq!(
        (parameters["gap"].as_f64(), parameters["gamma"].as_f64()),
        (Some(1.0), Some(0.5))
    );
    assert!(parameters["n"].is_null());
    let message = expected[apart]["message"].as_str().unwrap();
    assert!(
        message.ends_with("(warning no-contact; case 0: gamma = 0.5, gap = 1)"),
        "{message}"
    );
    // From the store; computed by one and two threads; merged.
    bench.expect(0, &["run", "s.json"]);
    assert_eq!(bench.warnings(), expected);
    for jobs in ["1", "2"] {
        std::fs::remove_dir_all(bench.path("figures")).unwrap();
        bench.expect(0, &["run", "s.json", "--jobs", jobs]);
        assert_eq!(bench.warnings(), expected, "{jobs}");
    }
    std::fs::remove_dir_all(bench.path("figures")).unwrap();
    for shard in ["1/2", "2/2"] {
        let done = bench.expect(0, &["run", "s.json", "--shard", shard]);
        assert!(!done.err.contains("warning"), "{done:?}");
    }
    let done = bench.expect(5, &["merge", "s.json", "--deny-warnings"]);
    assert_eq!(bench.warnings(), expected);
    let check = bench.expect(5, &["check", "s.json"]);
    for warning in &expected {
        let message = warning["message"].as_str().unwrap();
        assert!(
            done.err.contains(message) && check.err.contains(message),
            "{message}"
        );
    }
    bench.expect(5, &["run", "s.json", "--deny-warnings"]);
    let explained = bench.expect(0, &["explain", "s.json", "0"]);
    assert!(
        explained
            .out
            .contains("note: no-contact: cases have no contact"),
        "{explained:?}"
    );
    bench.expect(0, &["report", "s.json"]);
    let page = bench.text("figures/report.html");
    assert!(
        page.contains("<p class=\"facts\">warning no-contact; case 0: gamma = 0.5, gap = 1</p>")
    );
    // Nothing to warn of.
    let clean = r#"{"problem": "friction-oscillator", "parameters": {"law": "displacement-control", "alpha": 1, "dT": 0.5, "duration": 3}}"#;
    bench.file("clean.json", clean);
    bench.expect(0, &["run", "clean.json", "--deny-warnings"]);
}

#[test]
fn a_restitution_that_the_method_ignores_is_a_fault() {
    let bench = Bench::new();
    let contact = r#""law": "LAW", "between": ["ground", "a"], "e": 0.5"#;
    for law in ["rigid", "impact"] {
        let with_law = contact.replace("LAW", law);
        let study = |method: &str| {
            let parameters = format!(r#""method": {method}, "dt": 0.01, "duration": 1"#);
            body(&parameters, &with_law, "", "\"peak(a)\"")
        };
        bench.file("good.json", study("\"moreau-jean\""));
        bench.expect(0, &["list", "good.json"]);
        for method in ["\"hht\"", r#"["moreau-jean", "bathe"]"#] {
            bench.file("bad.json", study(method));
            let done = bench.expect(2, &["list", "bad.json"]);
            let column = study(method).lines().nth(2).unwrap().find("0.5").unwrap() + 1;
            let start = format!("bad.json:3:{column}: structure.contacts.c.e: ");
            assert!(
                done.err.starts_with(&start) && done.err.contains("moreau-jean"),
                "{done:?}"
            );
        }
    }
    let bars = |more: &str| {
        format!(
            r#"{{"problem": "bar-impact", "parameters": {{"law": "rigid", "n": 4, "dt": 0.1, "duration": 1.5{more}}}}}"#
        )
    };
    for (more, code) in [
        ("", 0),
        (r#", "restitution": 0"#, 2),
        (r#", "restitution": [0, 0.5], "method": "moreau-jean""#, 0),
        (r#", "method": ["bathe", "moreau-jean"]"#, 0),
        (
            r#", "restitution": 0.5, "method": ["bathe", "moreau-jean"]"#,
            2,
        ),
    ] {
        bench.file("bars.json", bars(more));
        let done = bench.expect(code, &["list", "bars.json"]);
        let names =
            done.err.contains("parameters.restitution: ") && done.err.contains("moreau-jean");
        assert_eq!(names, code == 2, "{done:?}");
    }
}

#[test]
fn a_motion_that_ends_before_the_shaking_is_no_earthquake() {
    let bench = Bench::new();
    // Up to 8 s 0.01, then 3 for half a second: a record of 10 s.
    let value = |i: u32| if (800..850).contains(&i) { 3.0 } else { 0.01 };
    let rows = (0..1000).map(|i| format!("{},{}\n", f64::from(i) / 100.0, value(i)));
    bench.file("quake.csv", format!("t,a\n{}", rows.collect::<String>()));
    let study = |dt: f64, duration: f64| {
        let ground = r#", "ground": {"record": "quake.csv", "unit": "m/s2"}"#;
        let parameters = format!(r#""dt": {dt}, "duration": {duration}"#);
        let spring = r#""law": "spring", "between": ["ground", "a"], "k": 1"#;
        let metrics = r#""ground.pga", "ground.arias""#;
        body(&parameters, spring, ground, metrics).replace(
            r#""law": "spring""#,
            r#""law": "displacement-control", "limit": 9"#,
        )
    };
    let cut = |kinds: &[(String, u64, u64)]| kinds.iter().any(|kind| kind.0 == "motion-cut");
    assert!(!cut(&bench.kinds(&study(0.01, 10.0))));
    assert!(bench.text("figures/s/results.csv").contains(",3.0,"));
    // Before the shaking, and by steps that pass over it.
    assert!(cut(&bench.kinds(&study(0.01, 5.0))));
    assert!(bench.text("figures/s/results.csv").contains(",0.01,"));
    assert!(cut(&bench.kinds(&study(1.1, 9.9))));
    bench.file("s.json", study(0.01, 5.0));
    let explained = bench.expect(0, &["explain", "s.json"]);
    assert!(
        explained.out.contains("pga 0.01 of 3") || explained.err.contains("pga 0.01 of 3"),
        "{explained:?}"
    );
}

#[test]
fn several_studies_end_with_one_line_for_each_kind() {
    let bench = Bench::new();
    // 3 and 8 steps in a touch of pi/100 s, as above; gaps of 4 and 5 stay open.
    let contact = r#""law": "impact", "k": 1e4, "between": ["ground", "a"], "gap": "gap""#;
    let study = |gaps: &str| {
        let parameters = format!(r#""gap": {gaps}, "dt": [0.004, 0.01], "duration": 1"#);
        body(&parameters, contact, "", r#""peak(a)""#)
    };
    bench.file("studies/one.json", study("[0.1, 5]"));
    bench.file("studies/two.json", study("[0.1, 0.2, 5]"));
    bench.file("studies/three.json", study("[4, 5]"));
    bench.file(
        "studies/clean.json",
        study("[0.1]").replace("[0.004, 0.01]", "0.001"),
    );
    for verb in ["run", "merge", "check"] {
        let done = bench.expect(0, &[verb]);
        let lines: Vec<&str> = done.err.lines().collect();
        let of_word = |word: &str| -> Vec<(usize, &str)> {
            let numbered = lines.iter().copied().enumerate();
            numbered.filter(|(_, line)| line.contains(word)).collect()
        };
        let [(first, short), (_, gain), (_, open)] = of_word("warning: ")[..] else {
            panic!("{verb}: {}", done.err);
        };
        assert!(
            short.starts_with("warning: short-contact: 3 of 10 cases in 2 of 4 studies have "),
            "{short}"
        );
        assert!(short.ends_with(": one (1), two (2)"), "{short}");
        assert!(
            gain.starts_with("warning: contact-gain: 3 of 10 cases "),
            "{gain}"
        );
        assert!(
            open.starts_with("warning: no-contact: 4 of 4 cases in 1 of 4 studies have "),
            "{open}"
        );
        // How many cases have no contact is said where others have one, too.
        let [(_, note)] = of_word("note: ")[..] else {
            panic!("{verb}: {}", done.err);
        };
        assert!(
            note.starts_with("note: no-contact: 4 of 10 cases in 2 of 4 studies have "),
            "{note}"
        );
        // They come after the last study.
        let last = of_word("cases")
            .into_iter()
            .rfind(|(_, line)| line.contains(" run") || line.contains(" store"));
        assert!(
            last.is_some_and(|(last, _)| last < first),
            "{verb}: {}",
            done.err
        );
    }
    // Of one study the lines have an example.
    let done = bench.expect(0, &["run", "one"]);
    assert!(
        done.err
            .contains("(warning short-contact; case 1: gap = 0.1, dt = 0.01)"),
        "{}",
        done.err
    );
    assert_eq!(bench.run(&["run", "--deny-warnings"]).code, Some(5));
}
