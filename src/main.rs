//! The `slipgap` program.

mod version;

use std::process::ExitCode;

fn main() -> ExitCode {
    slipgap::program::main(&version::VERSION)
}
