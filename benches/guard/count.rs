//! Counts of instructions by callgrind.

use std::ffi::OsStr;
use std::path::Path;
use std::process::Command;

/// Largest relative difference from the recorded counts. Compilers differ by a few per cent.
const TOLERANCE: f64 = 0.1;

/// Whether callgrind can be run.
pub fn is_possible() -> bool {
    let version = Command::new("valgrind").arg("--version").output();
    version.is_ok_and(|output| output.status.success())
}

/// Number of instructions of a program with these arguments.
pub fn instructions<A: AsRef<OsStr>>(program: &Path, args: impl IntoIterator<Item = A>) -> i64 {
    let output = Command::new("valgrind")
        .args(["--tool=callgrind", "--callgrind-out-file=/dev/null"])
        .arg(program)
        .args(args)
        .output()
        .expect("valgrind runs");
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    let line = errors.lines().find(|line| line.contains("Collected :"));
    let number = line.and_then(|line| line.split(':').nth(1)?.trim().parse().ok());
    number.unwrap_or_else(|| panic!("no count in: {errors}"))
}

/// Whether the count for each case is near the recorded one; prints both.
pub fn is_near(name: &str, each: f64, recorded: u64) -> bool {
    let near = (each / recorded as f64 - 1.0).abs() < TOLERANCE;
    let verdict = if near { "near" } else { "NOT NEAR" };
    println!("{name}: {each:.0} instructions a case, {verdict} the recorded {recorded}");
    near
}
