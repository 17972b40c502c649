//! Checks that sweeps do not become slower: the instructions of their kernels and of whole runs by callgrind, and the speed of
//! lanes on AVX-512.
//!
//! `guard` makes the checks. `guard NAME TIMES` only runs a sweep so many times, for callgrind.

mod count;
mod kernels;
mod runs;

use std::env::args;
use std::process::ExitCode;

fn main() -> ExitCode {
    let args: Vec<String> = args().skip(1).collect();
    if let [name, times] = &args[..] {
        kernels::sweep(name, times.parse().expect("a number"));
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
