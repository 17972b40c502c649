//! Checks that sweeps do not become slower: the instructions of their kernels and of whole runs by callgrind, and the speed of
//! lanes on AVX-512.
//!
//! `guard` makes the checks. `guard NAME TIMES` only runs a sweep so many times, for callgrind. `guard kernel STUDY`, `guard rates
//! BYTES ..` and `guard factor M K DT` print what `make peers` needs.

mod count;
mod kernels;
mod measure;
mod runs;

use std::env::args;
use std::process::ExitCode;

fn main() -> ExitCode {
    let args: Vec<String> = args().skip(1).collect();
    let words: Vec<&str> = args.iter().map(String::as_str).collect();
    match words[..] {
        [] => {}
        ["kernel", study] => measure::kernel(study),
        ["rates", ..] => measure::rates(&args[1..]),
        ["factor", mass, stiffness, dt] => measure::factor([mass, stiffness], dt),
        [name, times] => kernels::sweep(name, times.parse().expect("a number")),
        _ => panic!("unknown arguments"),
    }
    if !words.is_empty() {
        return ExitCode::SUCCESS;
    }
    let counted = if count::is_possible() {
        let kernels = kernels::are_near();
        runs::are_near() && kernels
    } else {
        println!("no valgrind: instructions are not counted");
        true
    };
    if kernels::ratios() && counted {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}
