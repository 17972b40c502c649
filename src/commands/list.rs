//! `slipgap list`: the studies with their axes, cases and steps.

use super::arguments::StudiesArgs;
use super::arguments::sources::Source;
use super::terminal::{GAP, print, table};
use crate::error::Error;
use crate::study::{Axis, Block, Study};
use clap::Args;
use console::Term;
use std::path::Path;

/// The arguments of `slipgap list`.
#[derive(Args)]
pub struct ListArgs {
    #[command(flatten)]
    studies: StudiesArgs,
    /// Print only the paths of the studies and of the files that they read, one a line, each once
    #[arg(long)]
    files: bool,
}

impl ListArgs {
    /// Lists the studies; returns the exit code.
    pub fn execute(self) -> Result<u8, Error> {
        let sources = self.studies.read()?;
        match self.files {
            true => print(&files(&sources)),
            false => list(&sources),
        }
    }
}

/// The paths of the studies and of their records, matrices and tables, for programs that run studies again when these change.
fn files(sources: &[Source]) -> String {
    let mut paths: Vec<String> = Vec::new();
    for source in sources {
        let folder = source.file.parent().unwrap_or(Path::new(""));
        let read = source.study.read.iter().map(|file| folder.join(&file.name));
        for path in [source.file.clone()].into_iter().chain(read) {
            let line = format!("{}\n", path.display());
            if !paths.contains(&line) {
                paths.push(line);
            }
        }
    }
    paths.concat()
}

/// Prints one row for each study; returns the exit code.
fn list(sources: &[Source]) -> Result<u8, Error> {
    let mut rows = vec![
        [
            "study", "problem", "cases", "steps", "axes", "figures", "title",
        ]
        .map(String::from)
        .to_vec(),
    ];
    for source in sources {
        let study = &source.study;
        let figures: Vec<&str> = study.figures.iter().map(|f| f.name.as_str()).collect();
        rows.push(vec![
            source.name.clone(),
            study.problem.name().to_owned(),
            cases(study),
            steps(study),
            axes(study),
            figures.join(" "),
            study.title.clone(),
        ]);
    }
    if let Some((_, width)) = Term::stdout().size_checked() {
        shorten(&mut rows, usize::from(width));
    }
    let mut text = table(&rows);
    for source in sources {
        let programs = source.study.programs();
        for program in programs.map_or(&[][..], |programs| &programs.list) {
            let (name, command) = (program.name, program.shown_command());
            text += &format!("{}: program {name}: {command} (not started)\n", source.name);
        }
    }
    print(&text)
}

/// Fewest characters that are left of a cell.
const FEWEST: usize = 8;

/// Shortens the widest columns until the table has a width, as far as [`FEWEST`] allows. Files and other programs get the whole
/// cells.
fn shorten(rows: &mut [Vec<String>], width: usize) {
    let columns = rows.first().map_or(0, Vec::len);
    let widest = |column: usize| rows.iter().map(|row| row[column].chars().count()).max();
    let mut widths: Vec<usize> = (0..columns).filter_map(widest).collect();
    let gaps = GAP * columns.saturating_sub(1);
    while widths.iter().sum::<usize>() + gaps > width {
        // The name of a study stays, since it is needed for commands.
        match widths.iter_mut().skip(1).max() {
            Some(widest) if *widest > FEWEST => *widest -= 1,
            Some(_) | None => break,
        }
    }
    for row in rows {
        for (cell, width) in row.iter_mut().zip(&widths) {
            if cell.chars().count() > *width {
                *cell = cell.chars().take(width - 1).chain(['…']).collect();
            }
        }
    }
}

/// The number of cases, or the largest number possible.
pub fn cases(study: &Study) -> String {
    let at_most = if study.enumeration().is_counted() {
        ""
    } else {
        "at most "
    };
    format!("{at_most}{}", study.len())
}

/// The axes of every block, as in `alpha(3) dT+duration(2)`. Zipped axes are joined by `+`.
fn axes(study: &Study) -> String {
    let name = |axis: &Axis| &*study.problem.parameters()[axis.parameter].name;
    let block = |block: &Block| {
        let swept = block.groups.iter().filter(|group| group.len() > 1);
        let groups: Vec<String> = swept
            .map(|group| {
                let names: Vec<&str> = group.axes.iter().map(name).collect();
                format!("{}({})", names.join("+"), group.len())
            })
            .collect();
        if groups.is_empty() {
            "-".to_owned()
        } else {
            groups.join(" ")
        }
    };
    let blocks: Vec<String> = study.blocks.iter().map(block).collect();
    blocks.join(" + ")
}

/// Smallest and largest number of steps of a case.
fn steps(study: &Study) -> String {
    let (mut fewest, mut most) = (u64::MAX, 0);
    for case in study.enumeration().representative_cases() {
        let steps = case.steps();
        (fewest, most) = (fewest.min(steps), most.max(steps));
    }
    if fewest == most {
        most.to_string()
    } else {
        format!("{fewest}..{most}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_widest_columns_are_shortened_to_the_width_of_a_terminal() {
        let row = |cells: [&str; 3]| cells.map(String::from).to_vec();
        let rows = [
            row(["study", "axes", "title"]),
            row(["a", &"b".repeat(30), &"é".repeat(50)]),
            row(["name", "c", "short"]),
        ];
        let widest = |rows: &[Vec<String>]| {
            let text = table(rows);
            text.lines().map(|line| line.chars().count()).max()
        };
        for width in [40, 41, 80] {
            let mut short = rows.to_vec();
            shorten(&mut short, width);
            assert_eq!(widest(&short), Some(width));
            assert_eq!([&short[0], &short[2]], [&rows[0], &rows[2]]);
        }
        // 40 less study and two gaps are 31: one column has the odd character.
        let mut short = rows.to_vec();
        shorten(&mut short, 40);
        let lengths = [1, 2].map(|column| short[1][column].chars().count());
        assert!(lengths == [15, 16] || lengths == [16, 15], "{lengths:?}");
        assert!(short[1][1].ends_with('…') && short[1][2].ends_with('…'));
        let mut same = rows.to_vec();
        shorten(&mut same, 89);
        assert_eq!(same, rows);
        shorten(&mut same, 5);
        assert_eq!(same[1][1].chars().count(), FEWEST);
    }
}
