//! A run that is interrupted.

use crate::{Bench, ONE, friction};
use std::process::Command;
use std::thread::sleep;
use std::time::Duration;

#[test]
fn an_interrupted_run_does_not_change_the_former_results() {
    let bench = Bench::new();
    bench.file("s.json", friction(ONE, ""));
    bench.expect(0, &["run", "s.json"]);
    let former = bench.text("figures/s/results.csv");
    // A run of minutes. It makes its output folder before it computes.
    let long = r#""law": "velocity-control", "beta": {"linspace": [1, 2, 1000]}, "dT": 1e-5, "duration": 100"#;
    bench.file("s.json", friction(long, ""));
    bench.file("t.json", friction(long, ""));
    let mut child = bench
        .command()
        .args(["run", "s.json", "t.json"])
        .spawn()
        .unwrap();
    while !bench.path("figures/t").exists() {
        sleep(Duration::from_millis(10));
    }
    let id = child.id().to_string();
    let sent = Command::new("kill").args(["-INT", &id]).status();
    assert!(sent.unwrap().success());
    let status = child.wait().unwrap();
    assert_eq!(status.code(), Some(130));
    assert_eq!(bench.text("figures/s/results.csv"), former);
    assert!(!bench.path("figures/t/results.csv").exists());
}
