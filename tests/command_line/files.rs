//! The files that a run writes, removes and keeps.

use crate::{Bench, ONE, TWO, bars, friction};

#[test]
fn results_have_a_row_for_each_case_with_all_parameters_and_metrics() {
    let bench = Bench::new();
    let blocks = format!("{{ \"parameters\": {{ {TWO} }} }}, {{ \"parameters\": {{ {ONE} }} }}");
    let study = format!("{{ \"problem\": \"friction-oscillator\", \"blocks\": [{blocks}] }}");
    bench.file("s.json", study);
    let done = bench.expect(0, &["run", "s.json"]);
    assert_eq!(done.out, "figures/s\n");
    assert_eq!(done.err, "s: 3 cases run\n");
    let text = bench.text("figures/s/results.csv");
    let rows: Vec<Vec<&str>> = text.lines().map(|line| line.split(',').collect()).collect();
    assert_eq!(
        rows[0].join(","),
        "case,law,alpha,beta,dT,duration,x0,initial_slip,rms_error,max_error,peak_error,rest_error,\
         residual_motion,work_error,sprague_geers_magnitude,sprague_geers_phase,sprague_geers_combined"
    );
    let step = std::f64::consts::PI / 10.0;
    let end = 8.0 * std::f64::consts::PI;
    let parameters = |row: usize| rows[row][..8].join(",");
    assert_eq!(rows.len(), 4);
    assert_eq!(
        parameters(1),
        format!("0,displacement-control,0.1,,{step},{end},12.0,unloaded")
    );
    assert_eq!(
        parameters(2),
        format!("1,displacement-control,1.0,,{step},{end},12.0,unloaded")
    );
    assert_eq!(parameters(3), "2,velocity-control,,1.0,0.5,3.0,12.0,");
    // Defined in the first two cases. The third ends before the rest at 6 pi.
    assert!(
        rows[1]
            .iter()
            .skip(8)
            .all(|cell| cell.parse::<f64>().is_ok())
    );
    assert_eq!(rows[3][11..14], ["", "", ""]);
    assert!(rows[1][8].starts_with("0.02445"));
}

#[test]
fn results_of_bars_have_both_stiffnesses_and_the_right_bar() {
    let bench = Bench::new();
    let common = r#""n": 2, "dt": 0.1, "duration": 1.5"#;
    bench.file("two.json", bars(&format!("\"gamma\": 5, {common}"), ""));
    let wall = format!("\"k_I\": 100, {common}, \"right\": \"wall\", \"gap\": 0.25");
    bench.file("wall.json", bars(&wall, ""));
    bench.expect(0, &["run", "two.json", "wall.json"]);
    let two = bench.text("figures/two/results.csv");
    let wall = bench.text("figures/wall/results.csv");
    assert!(two.starts_with(
        "case,gamma,k_I,n,dt,duration,gap,mass,E,A,rho,L,V0,right,right.E,right.A,right.rho,right.L,right.n,right.V0,\
         contact_duration,contact_steps,separations,max_overlap,rdot_oscillation,peak_force,impulse_error,restitution,\
         energy_drift_max,energy_drift_final,rms_error_r,rms_error_rdot\n"
    ));
    assert!(two.contains(
        "\n0,5.0,100.0,2,0.1,1.5,0.0,lumped,100.0,1.0,0.01,10.0,0.1,,100.0,1.0,0.01,10.0,2,-0.1,"
    ));
    assert!(
        wall.contains("\n0,5.0,100.0,2,0.1,1.5,0.25,lumped,100.0,1.0,0.01,10.0,0.1,wall,,,,,,,")
    );
}

#[test]
fn histories_have_a_row_for_each_step() {
    let bench = Bench::new();
    bench.file("f.json", friction(TWO, ""));
    bench.file(
        "b.json",
        bars(r#""gamma": 1, "n": 2, "dt": 0.25, "duration": 1.5"#, ""),
    );
    bench.expect(0, &["run", "f.json", "b.json", "--histories", "--out", "o"]);
    assert_eq!(
        bench.tree("o"),
        [
            "b/histories/0.csv",
            "b/manifest.json",
            "b/results.csv",
            "f/histories/0.csv",
            "f/histories/1.csv",
            "f/manifest.json",
            "f/results.csv"
        ]
    );
    let f = bench.text("o/f/histories/1.csv");
    assert!(f.starts_with("T,X,V,S,X_exact,V_exact\n0.0,12.0,0.0,0.0,12.0,"));
    assert_eq!(f.lines().count(), 1 + 81);
    let b = bench.text("o/b/histories/0.csv");
    assert!(
        b.starts_with("t,r,rdot,force,r_exact,rdot_exact\n0.0,0.0,-1.0,0.0,0.0,"),
        "{b}"
    );
    let times: Vec<&str> = b
        .lines()
        .skip(1)
        .filter_map(|l| l.split(',').next())
        .collect();
    assert_eq!(times, ["0.0", "0.25", "0.5", "0.75", "1.0", "1.25", "1.5"]);
}

#[test]
fn the_manifest_has_the_origin_of_results() {
    let bench = Bench::new();
    bench.file("in/s.json", friction(ONE, ""));
    bench.expect(0, &["run", "in", "--out", "o"]);
    let manifest: serde_json::Value =
        serde_json::from_str(&bench.text("o/s/manifest.json")).unwrap();
    let keys: Vec<&String> = manifest.as_object().unwrap().keys().collect();
    assert_eq!(
        keys,
        [
            "study",
            "study_sha256",
            "problem",
            "program",
            "program_version",
            "solver_version",
            "git_commit",
            "files",
            "warnings"
        ]
    );
    assert_eq!(manifest["study"], "s.json");
    assert_eq!(manifest["problem"], "friction-oscillator");
    assert_eq!(manifest["program_version"], env!("CARGO_PKG_VERSION"));
    assert_eq!(manifest["files"], serde_json::json!(["results.csv"]));
    assert_eq!(manifest["warnings"], serde_json::json!([]));
    assert_eq!(manifest["study_sha256"].as_str().unwrap().len(), 64);
}

#[test]
fn only_files_of_former_runs_are_removed() {
    let bench = Bench::new();
    let figure =
        |name: &str| format!(", \"figures\": [{{ \"name\": \"{name}\", \"kind\": \"law\" }}]");
    bench.file("s.json", friction(TWO, &figure("old")));
    bench.expect(0, &["run", "s.json", "--histories"]);
    bench.file("figures/s/notes.txt", "mine");
    bench.file("figures/s/old.eps", "mine");
    bench.file("figures/s/histories/mine.csv", "mine");
    bench.file("figures/other/results.csv", "mine");
    bench.file("s.json", friction(TWO, &figure("new")));
    bench.expect(0, &["run", "s.json"]);
    assert_eq!(
        bench.tree("figures"),
        [
            "other/results.csv",
            "s/histories/mine.csv",
            "s/manifest.json",
            "s/new.pdf",
            "s/new.png",
            "s/new.svg",
            "s/notes.txt",
            "s/old.eps",
            "s/results.csv"
        ]
    );
    // Files outside the folder are not removed, also if the manifest lists them.
    bench.file(
        "figures/s/manifest.json",
        r#"{"files": ["../other/results.csv", "/etc/none", "..", "", ".", "histories"]}"#,
    );
    bench.expect(0, &["run", "s.json"]);
    assert_eq!(bench.text("figures/other/results.csv"), "mine");
}

#[test]
fn an_empty_folder_of_histories_is_removed() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    bench.expect(0, &["run", "s.json", "--histories"]);
    assert!(bench.path("figures/s/histories/0.csv").exists());
    bench.expect(0, &["run", "s.json"]);
    assert!(!bench.path("figures/s/histories").exists());
}

#[test]
fn results_have_the_folders_of_the_studies() {
    let bench = Bench::new();
    for name in ["a.json", "deep/er/b.c.json", "deep/ü ber.json"] {
        bench.file(&format!("studies/{name}"), friction(ONE, ""));
    }
    bench.file("studies/.hidden.json", "not a study");
    bench.file("studies/readme.txt", "not a study");
    let written = [
        "a/manifest.json",
        "a/results.csv",
        "deep/er/b.c/manifest.json",
        "deep/er/b.c/results.csv",
        "deep/ü ber/manifest.json",
        "deep/ü ber/results.csv",
    ];
    bench.expect(0, &["run"]);
    assert_eq!(bench.tree("figures"), written);
    bench.expect(0, &["run", "./studies/", "--out", "x y/z/"]);
    assert_eq!(bench.tree("x y/z"), written);
}

#[test]
fn a_study_of_a_folder_of_studies_has_the_same_folder_of_results_by_every_path() {
    let bench = Bench::new();
    bench.file("studies/bridges/short/s.json", friction(ONE, ""));
    bench.file("other/studies/s.json", friction(ONE, ""));
    let short = bench.path("studies/bridges/short/s.json");
    let full = short.to_str().unwrap();
    for path in [
        "studies/bridges/short/s.json",
        "./studies/../studies/bridges/short/s",
        "s",
        "short/s",
        full,
    ] {
        let done = bench.expect(0, &["run", path]);
        assert_eq!(done.out, "figures/bridges/short/s\n", "{path}");
    }
    bench.expect(0, &["run", "studies/bridges", "--out", "o"]);
    assert_eq!(
        bench.tree("o"),
        [
            "bridges/short/s/manifest.json",
            "bridges/short/s/results.csv"
        ]
    );
    bench.expect(0, &["animate", "s", "--out", "film.html"]);
    bench.expect(0, &["animate", "s"]);
    assert!(
        bench
            .path("figures/bridges/short/s/animation.html")
            .is_file()
    );
    // A study elsewhere has its own name alone.
    let done = bench.expect(0, &["run", "other/studies/s.json"]);
    assert_eq!(done.out, "figures/s\n");
}

#[test]
fn the_studies_of_a_folder_run_in_the_order_of_their_cost() {
    let bench = Bench::new();
    let of = |step: &str| {
        let one = ONE.replace("0.5", step);
        assert_ne!(one, ONE);
        friction(&one, "")
    };
    for (name, step) in [("a", "0.001"), ("b", "0.1"), ("c/d", "0.01")] {
        bench.file(&format!("studies/{name}.json"), of(step));
    }
    bench.file("x/z.json", of("0.002"));
    let order = |args: &[&str]| {
        let done = bench.expect(0, &[&["run"], args].concat());
        let noted = done
            .err
            .lines()
            .filter_map(|line| line.split_once("studies, "));
        let names = noted.filter_map(|(_, rest)| rest.split_once(':'));
        names.map(|(name, _)| name.to_owned()).collect::<Vec<_>>()
    };
    assert_eq!(order(&[]), ["b", "c/d", "a"]);
    // Folder after folder, and single files as they are given.
    assert_eq!(order(&["x", "studies"]), ["z", "b", "c/d", "a"]);
    assert_eq!(order(&["a", "studies/c", "b"]), ["a", "c/d", "b"]);
    assert_eq!(order(&["a", "studies"]), ["a", "b", "c/d"]);
}

#[test]
fn a_repeated_study_runs_once_and_two_studies_of_one_name_are_an_error() {
    let bench = Bench::new();
    bench.file("a/s.json", friction(ONE, ""));
    bench.file("b/s.json", friction(ONE, ""));
    let done = bench.expect(
        0,
        &["run", "a/s.json", "a", "./a/../a/s.json", "--out", "o"],
    );
    assert_eq!(done.out, "o/s\n");
    let done = bench.expect(2, &["run", "a", "b", "--out", "p"]);
    assert!(
        done.err.contains("a/s.json") && done.err.contains("b/s.json"),
        "{done:?}"
    );
    assert!(!bench.path("p").exists());
}

#[test]
fn results_in_a_folder_of_studies_are_not_studies() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    for _ in 0..2 {
        let done = bench.expect(0, &["run", "."]);
        assert_eq!(done.out, "figures/s\n");
    }
    // A study may have this name, also next to files of results.
    bench.file("studies/manifest.json", friction(ONE, ""));
    for name in ["studies/store/part", "studies/results.csv"] {
        bench.file(name, "");
        let done = bench.expect(0, &["run", "studies"]);
        assert_eq!(done.out, "figures/manifest\n");
    }
}

#[test]
fn several_studies_are_counted_and_their_files_listed_only_with_verbose() {
    let bench = Bench::new();
    bench.file("studies/a.json", friction(ONE, ""));
    bench.file("studies/b/c.json", friction(TWO, ""));
    bench.file(
        "studies/d.json",
        friction(ONE, r#", "figures": [{ "name": "f", "kind": "history" }]"#),
    );
    let done = bench.expect(0, &["run", "studies"]);
    // The one with more cases comes last.
    let counted = "1 of 3 studies, a: 1 case run\n2 of 3 studies, d: 1 case run\n3 of 3 studies, b/c: 2 cases run\n";
    assert_eq!(
        (done.out.as_str(), done.err.as_str()),
        ("figures\n", counted)
    );
    // The same lines from the stores: the log of a short run has no times.
    let done = bench.expect(0, &["run", "studies", "--verbose"]);
    let stored = "1 of 3 studies, a: 1 of 1 cases from the store\n2 of 3 studies, d: 1 of 1 cases from the store\n\
                  3 of 3 studies, b/c: 2 of 2 cases from the store\n";
    assert_eq!(done.err, stored);
    let files = "figures/a/results.csv\nfigures/d/results.csv\nfigures/d/f.png\nfigures/d/f.svg\nfigures/d/f.pdf\n\
                 figures/b/c/results.csv\n";
    assert_eq!(done.out, files);
    // No colours, no control characters.
    let mut characters = done.err.chars().chain(done.out.chars());
    assert!(!characters.any(|c| c.is_control() && c != '\n'));
}
