//! Programs of others, which compute cases of a study: one process for each worker, started only where the command line allows it.

mod pipes;
mod pool;
mod process;
mod tail;

use pool::Pool;

use slipgap_problem::problem::structure::programs::{Program, Programs};
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::path::Path;
use std::sync::Arc;

/// Lets the programs of the study in a file be started where that is allowed.
///
/// # Errors
/// The study has programs, and they are not allowed. The message has their commands.
pub fn allow(file: &Path, study: &Study, allowed: bool) -> Result<(), Error> {
    let Some(programs) = study.programs() else {
        return Ok(());
    };
    if allowed {
        programs.allow(Arc::new(Pool::default()));
        return Ok(());
    }
    let list = programs.list.iter();
    let shown = list.map(|program| format!("{}: {}", program.name, program.shown_command()));
    let commands: Vec<String> = shown.collect();
    Err(Error::Usage(format!(
        "{}: not run: its programs would be started ({}); allowed with --allow-programs (in Python allow_programs=True), if you trust them",
        file.display(),
        commands.join("; ")
    )))
}

/// The programs that compute cases of a study.
fn used<'a>(study: &'a Study, programs: &'a Programs) -> impl Iterator<Item = &'a Program> {
    let table = study.problem.parameters();
    let row = table
        .iter()
        .position(|parameter| parameter.name == "method");
    let blocks = study.blocks.iter().flat_map(|block| block.axes());
    let axes = blocks.filter(move |axis| Some(axis.parameter) == row);
    let names: Vec<&str> = axes
        .flat_map(|axis| axis.values.iter().map(|value| value.name()))
        .collect();
    let list = programs.list.iter();
    list.filter(move |program| names.contains(&program.name))
}

/// Starts one process of each program that a study uses, and reads its first line.
///
/// # Errors
/// One cannot be started, or says something else. Without permission, none is started: their cases then say so.
pub fn start(study: &Study) -> Result<(), Error> {
    let Some((programs, runner)) = study
        .programs()
        .and_then(|programs| Some((programs, programs.runner()?)))
    else {
        return Ok(());
    };
    used(study, programs).try_for_each(|program| {
        let hello = runner.hello(program);
        let ended = |why| Error::Unsolved(format!("program {}: {why}", program.name));
        hello.map(drop).map_err(ended)
    })
}

/// The versions of the programs that a study uses, for keys of stores; `?` where they are not known, since nothing may start them.
/// `None` without programs.
pub fn versions(study: &Study) -> Option<String> {
    let programs = study.programs()?;
    let Some(runner) = programs.runner() else {
        return Some(UNKNOWN.to_owned());
    };
    let version = |program: &Program| {
        let hello = runner.hello(program);
        let version = hello.map_or(String::new(), |hello| hello.version.clone());
        format!("{}: {version}", program.name)
    };
    let versions: Vec<String> = used(study, programs).map(version).collect();
    Some(versions.join(", "))
}

/// The versions of programs that nothing may start.
pub const UNKNOWN: &str = "?";

/// That a program failed at its first request in every worker, if so.
///
/// # Errors
/// What it said.
pub fn go_on(study: &Study) -> Result<(), Error> {
    let runner = study.programs().and_then(Programs::runner);
    match runner.and_then(|runner| runner.failure()) {
        None => Ok(()),
        Some(why) => Err(Error::Unsolved(why)),
    }
}
