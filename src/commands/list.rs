//! `slipgap list`: the studies with their axes, cases and steps.

use super::sources::Source;
use super::terminal::{print, table};
use slipgap::error::Error;
use slipgap::study::{Axis, Block, Study};

/// Prints one row for each study; returns the exit code.
pub fn list(sources: &[Source]) -> Result<u8, Error> {
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
    print(&table(&rows))
}

/// The number of cases, or the largest number possible.
pub fn cases(study: &Study) -> String {
    let at_most = if study.is_counted() { "" } else { "at most " };
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
    for case in study.representative_cases() {
        let steps = study.problem.steps(&case);
        (fewest, most) = (fewest.min(steps), most.max(steps));
    }
    if fewest == most {
        most.to_string()
    } else {
        format!("{fewest}..{most}")
    }
}
