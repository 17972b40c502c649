//! Programs of others as methods of a study.

mod answers;
mod faults;
mod refused;
mod textbook;

use crate::Bench;
use std::process::Command;
use std::sync::LazyLock;

/// The shipped program.
const PLAIN: &str = include_str!("../../../examples/programs/average_acceleration.py");

/// A program that does what its argument says, wrong answers above all.
const FAKE: &str = include_str!("fake.py");

/// The interpreter of Python by its full path: the program of a bench finds no others.
static PYTHON: LazyLock<String> = LazyLock::new(|| {
    let name = std::env::var("SLIPGAP_PYTHON").unwrap_or("python3".into());
    let arguments = ["-c", "import sys; print(sys.executable)"];
    let output = Command::new(name).args(arguments).output().unwrap();
    String::from_utf8(output.stdout).unwrap().trim().to_owned()
});

/// Two bodies that collide, under a load and a motion of the ground; `programs` are those of the study, `parameters` and `more` go
/// with its keys.
fn towers(programs: &str, parameters: &str, more: &str) -> String {
    format!(
        r#"{{ "problem": "structure", "programs": {{ {programs} }},
  "parameters": {{ {parameters}, "dt": 0.01, "duration": 5 }},
  "structure": {{ "units": "t, kN, m, s", "masses": {{ "a": 2, "b": 3 }},
    "springs": [{{ "between": ["ground", "a"], "k": 300, "c": 2 }}, {{ "between": ["ground", "b"], "k": 200 }}],
    "contacts": {{ "joint": {{ "between": ["a", "b"], "law": "impact-spring", "k": 5e4, "gap": "gap" }} }},
    "loads": [{{ "at": "b", "sine": {{ "amplitude": 2, "omega": 3 }} }}],
    "ground": {{ "sine": {{ "amplitude": 1.5, "omega": 7 }} }}, "start": {{ "a": {{ "v": 0.3 }} }}, "contacts_reference": "softened" }}{more} }}"#
    )
}

/// A program that is the shipped one.
fn plain() -> String {
    format!(
        r#""plain": {{ "command": ["{}", "average_acceleration.py"], "files": ["average_acceleration.py"], "parameters": {{ "tolerance": "tol" }} }}"#,
        *PYTHON
    )
}

/// A fake program; `way` is what it does.
fn fake(way: &str) -> String {
    format!(
        r#""fake": {{ "command": ["{}", "fake.py", "{way}"], "timeout": 2, "start_timeout": 5 }}"#,
        *PYTHON
    )
}

/// A folder with both programs.
fn bench() -> Bench {
    let bench = Bench::new();
    bench.file("average_acceleration.py", PLAIN);
    bench.file("fake.py", FAKE);
    bench
}

/// The values of a column of results.csv.
fn column(bench: &Bench, folder: &str, name: &str) -> Vec<String> {
    let text = bench.text(&format!("{folder}/results.csv"));
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let place = names.iter().position(|known| *known == name).unwrap();
    lines
        .map(|line| line.split(',').nth(place).unwrap().to_owned())
        .collect()
}

fn numbers(bench: &Bench, folder: &str, name: &str) -> Vec<f64> {
    let cells = column(bench, folder, name);
    cells.iter().map(|cell| cell.parse().unwrap()).collect()
}
