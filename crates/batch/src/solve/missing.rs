//! The parts of a study that its store does not have: what is left for shards to compute.

use crate::chunks::shard::shard_of;
use crate::status::outline::{Outline, Reading};
use crate::store::{Miss, Store};
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::collections::BTreeSet;
use std::fmt;
use std::path::PathBuf;

/// Parts that the store does not have.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct MissingParts {
    /// Number of parts of the study.
    pub parts: u64,
    /// Number of parts without a file.
    pub absent: u64,
    /// Number of parts whose file cannot be read or is damaged, and the first of these files.
    pub damaged: (u64, Option<PathBuf>),
    /// Number of parts of another version of the study or of the solver.
    pub outdated: u64,
    /// The number of shards, if it is known, and the shards, from 1, that have these parts.
    pub shards: Option<(u64, BTreeSet<u64>)>,
}

impl MissingParts {
    fn is_empty(&self) -> bool {
        self.absent + self.damaged.0 + self.outdated == 0
    }
}

/// The parts that the store does not have, of a study in `shards` shards; `None` if it has all.
///
/// # Errors
/// A folder that cannot be read.
pub fn missing_parts(
    study: &Study,
    store: &mut Store,
    shards: Option<u64>,
) -> Result<Option<MissingParts>, Error> {
    // The last part may have been saved on another machine a moment ago.
    store.list_again()?;
    let mut missing = MissingParts {
        shards: shards.map(|of| (of, BTreeSet::new())),
        ..MissingParts::default()
    };
    let outline = Outline::new(study, store.folder(), Reading::Whole, shards.is_some())?;
    for (number, part) in outline.parts(study) {
        missing.add(number, part.found.err());
    }
    Ok(Some(missing).filter(|missing| !missing.is_empty()))
}

impl MissingParts {
    /// Counts a part, which the store does not have if there is a `miss`.
    fn add(&mut self, number: u64, miss: Option<Miss>) {
        self.parts += 1;
        match miss {
            None => return,
            Some(Miss::Outdated(_)) => self.outdated += 1,
            Some(Miss::Absent) => self.absent += 1,
            Some(Miss::Damaged(path) | Miss::Unread(path, _)) => {
                self.damaged.0 += 1;
                self.damaged.1.get_or_insert(path);
            }
        }
        if let Some((of, shards)) = &mut self.shards {
            shards.insert(shard_of(number, *of));
        }
    }
}

impl fmt::Display for MissingParts {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (parts, absent, outdated) = (self.parts, self.absent, self.outdated);
        let (damaged, file) = &self.damaged;
        let missing = absent + damaged + outdated;
        write!(
            f,
            "{missing} of {parts} parts are missing ({absent} not there, "
        )?;
        if let Some(file) = file {
            let file = file.display();
            write!(f, "{damaged} damaged or unreadable, such as {file}, ")?;
        }
        write!(f, "{outdated} of another version); ")?;
        match &self.shards {
            Some((of, shards)) => write!(f, "run shards {} of {of} again", ranges(shards)),
            None => f.write_str("with --shards N, this names the shards to run again"),
        }
    }
}

/// Numbers as the arrays of Slurm have them: 3,7,10-15.
fn ranges(numbers: &BTreeSet<u64>) -> String {
    let mut ranges: Vec<(u64, u64)> = Vec::new();
    for &number in numbers {
        match ranges.last_mut() {
            Some((_, last)) if *last + 1 == number => *last = number,
            _ => ranges.push((number, number)),
        }
    }
    let text = |(first, last): (u64, u64)| match last - first {
        0 => first.to_string(),
        1 => format!("{first},{last}"),
        _ => format!("{first}-{last}"),
    };
    let texts: Vec<String> = ranges.into_iter().map(text).collect();
    texts.join(",")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::store::key::Difference;

    #[test]
    fn the_message_counts_the_parts_and_names_the_shards() {
        let mut missing = MissingParts {
            shards: Some((16, BTreeSet::new())),
            ..MissingParts::default()
        };
        for number in 0..204 {
            let miss = match number % 16 {
                2 => Some(Miss::Absent),
                6 if number < 86 => Some(Miss::Damaged("x".into())),
                _ => None,
            };
            missing.add(number, miss);
        }
        // 13 of shard 3, and 5 of shard 7: numbers 6, 22, .., 70.
        assert_eq!(
            missing.to_string(),
            "18 of 204 parts are missing (13 not there, 5 damaged or unreadable, such as x, 0 of another version); run shards 3,7 of 16 again"
        );
        missing.add(204, Some(Miss::Outdated(Difference::Solver)));
        missing.shards = None;
        assert_eq!(
            missing.to_string(),
            "19 of 205 parts are missing (13 not there, 5 damaged or unreadable, such as x, 1 of another version); \
            with --shards N, this names the shards to run again"
        );
    }

    #[test]
    fn parts_saved_after_the_store_was_opened_are_not_missing() {
        let folder = tempfile::tempdir().unwrap();
        let text = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control", "beta": [0.1, 0.2],
            "dT": 0.5, "x0": 8, "duration": 3}}"#;
        let study = slipgap_study::parse("s.json", text).unwrap();
        let mut opened_before = Store::open_shared(folder.path()).unwrap();
        let found = missing_parts(&study, &mut opened_before, None).unwrap();
        assert_eq!(found.map(|missing| missing.absent), Some(1));
        // Another process.
        let other = Store::open_shared(folder.path()).unwrap();
        let bar = indicatif::ProgressBar::hidden();
        crate::run_shard(&study, "1/1".parse().unwrap(), &other, &bar).unwrap();
        let found = missing_parts(&study, &mut opened_before, None).unwrap();
        assert_eq!(found, None);
    }

    #[test]
    fn numbers_are_written_as_slurm_reads_them() {
        let text = |numbers: &[u64]| ranges(&numbers.iter().copied().collect());
        assert_eq!(text(&[3]), "3");
        assert_eq!(text(&[3, 4, 7]), "3,4,7");
        assert_eq!(text(&[1, 2, 3, 7, 9, 10, 11, 12]), "1-3,7,9-12");
    }
}
