//! The memory of a run of a large structure.

use crate::Bench;
use slipgap::system::structure::Symmetric;
use slipgap::system::structure::sparse::factor::Factor;
use std::fmt::Write;
use std::process::{Child, Stdio};
use std::time::Duration;

/// A block of quadrilaterals with two dofs at each node, 10^5 in all: the factor has 71 MB.
const MESH: [usize; 2] = [316, 157];
const DT: f64 = 0.5;

/// The entries of K on and below its diagonal: in each quadrilateral a spring between every two of its eight dofs.
fn stiffness() -> Vec<(usize, usize, f64)> {
    // Number of quadrilaterals in a row that have both nodes.
    let common = |a: usize, b: usize, last: usize| match a == b {
        true => usize::from(a > 0) + usize::from(a < last),
        false => 1,
    };
    let [nx, ny] = MESH;
    let mut entries = Vec::new();
    for (i, j) in (0..=nx).flat_map(|i| (0..=ny).map(move |j| (i, j))) {
        let near = |a: usize, last: usize| a.saturating_sub(1)..=last.min(a + 1);
        for row in [0, 1].map(|direction| 2 * (i * (ny + 1) + j) + direction) {
            for (k, l) in near(i, nx).flat_map(|k| near(j, ny).map(move |l| (k, l))) {
                let count = (common(i, k, nx) * common(j, l, ny)) as f64;
                for column in [0, 1].map(|direction| 2 * (k * (ny + 1) + l) + direction) {
                    match column.cmp(&row) {
                        std::cmp::Ordering::Less => entries.push((row, column, -count)),
                        std::cmp::Ordering::Equal => entries.push((row, row, 7.0 * count)),
                        std::cmp::Ordering::Greater => {}
                    }
                }
            }
        }
    }
    entries
}

/// The largest resident memory of a process in bytes until it ends; `None` where the system does not tell it.
fn peak(child: &mut Child) -> Option<u64> {
    let status = format!("/proc/{}/status", child.id());
    let mut most = None;
    // The peak is that of the factor or of the steps; what is written after them takes longer than the pause.
    while child.try_wait().unwrap().is_none() {
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kilobytes = line.and_then(|line| line.trim_end_matches("kB").trim().parse().ok());
        most = most.max(kilobytes.map(|size: u64| 1024 * size));
        std::thread::sleep(Duration::from_millis(2));
    }
    most
}

#[test]
fn a_run_of_a_large_structure_needs_twice_the_memory_of_its_factor_beside_its_matrices() {
    let bench = Bench::new();
    let entries = stiffness();
    let count = entries.len() as u64;
    let size = 2 * (MESH[0] + 1) * (MESH[1] + 1);
    let head = "%%MatrixMarket matrix coordinate real symmetric\n";
    let mut text = format!("{head}{size} {size} {}\n", entries.len());
    let mut step = Symmetric::zeros(size);
    for (i, j, k) in entries {
        writeln!(text, "{} {} {k}", i + 1, j + 1).unwrap();
        step.add(i, j, 0.25 * k);
    }
    bench.file("block.K.mtx", text);
    let mut masses = format!("{head}{size} {size} {size}\n");
    let mut dofs = String::from("node,direction\n");
    for dof in 0..size {
        writeln!(masses, "{} {} 1", dof + 1, dof + 1).unwrap();
        writeln!(dofs, "{},{}", dof / 2 + 1, ["x", "y"][dof % 2]).unwrap();
        step.add(dof, dof, 1.0 / (DT * DT));
    }
    bench.file("block.M.mtx", masses);
    bench.file("block.dofs.csv", dofs);
    let study = format!(
        r#"{{"problem": "structure", "parameters": {{"dt": {DT}, "duration": 1}}, "structure": {{
            "matrices": {{"block": {{"M": "block.M.mtx", "K": "block.K.mtx", "dofs": "block.dofs.csv"}}}},
            "contacts": {{"wall": {{"law": "impact", "between": ["ground", "block.{}.x"], "k": 1}}}},
            "start": {{"block.x": {{"v": -1}}}}}}, "metrics": ["peak(wall.S)"]}}"#,
        size / 2
    );
    bench.file("block.json", study);
    let mut command = bench.command();
    command.args(["run", "block.json", "--jobs", "1"]);
    command.stdout(Stdio::null()).stderr(Stdio::null());
    let mut child = command.spawn().unwrap();
    let peak = peak(&mut child);
    assert!(child.wait().unwrap().success());
    let Some(peak) = peak else {
        eprintln!("no /proc: the memory of a run is not tested");
        return;
    };
    let factor = Factor::new(step, &vec![false; size]).unwrap().bytes() as u64;
    // Each entry of K is kept once, in 12 bytes, and as a spring in 24. The program itself has up to 24 MB.
    let most = 2 * factor + 36 * count + (24 << 20);
    assert!(
        peak <= most,
        "{peak} bytes, {most} at most, the factor {factor}"
    );
}
