//! What `slipgap explain` shows of programs of others: their commands, and the request of a case.

use super::arguments::sources::Source;
use super::terminal::print;
use crate::error::Error;
use crate::problem::{Case, Violation};
use crate::study::Study;

/// Case `number` of a study.
pub fn case_of(source: &Source, number: u64) -> Result<Case, Error> {
    let study = &source.study;
    study.case(number).ok_or_else(|| {
        let (name, last) = (&source.name, study.len() - 1);
        let allowed = match number > last {
            true => format!("{name} has cases 0 to {last}"),
            false => "this combination does not meet the condition".into(),
        };
        Error::Usage(format!("case {number}: {allowed}"))
    })
}

/// Prints the request of case `number` of a study; returns the exit code.
pub fn request(source: &Source, number: u64) -> Result<u8, Error> {
    let (study, case) = (&source.study, case_of(source, number)?);
    if let Some(why) = Violation::all(&study.violations(number)) {
        return Err(Error::Unsolved(source.line(&why)));
    }
    let written = slipgap_study::request(study, &case);
    let line = written.map_err(|why| Error::Unsolved(source.line(&why.to_string())))?;
    print(&format!("{line}\n"))
}

/// The programs of the study with their commands.
pub fn programs(study: &Study) -> String {
    let list = study.programs().map_or(&[][..], |programs| &programs.list);
    let lines = list.iter().map(|program| {
        let command = program.shown_command();
        format!(
            "program {}: {command} (not started; `run` starts it with --allow-programs)\n",
            program.name
        )
    });
    lines.collect()
}
