//! `slipgap list`: what the studies would run, without running it.

use super::sources::Source;
use super::{columns, say};
use slipgap::error::Error;
use slipgap::study::{Axis, Block, Study};

/// Prints one row a study; gives the exit code.
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
            study.len().to_string(),
            steps(study),
            axes(study),
            figures.join(" "),
            study.title.clone(),
        ]);
    }
    say(&columns(&rows))
}

/// The axes of every block, as in `alpha(3) dT+duration(2)`; what advances together is joined.
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

/// Steps of a case: the fewest and the most.
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
