//! The parts of a study and what a store has of them, without making the cases: a study may have 10^9.
//!
//! A chunk of which the store has no file is estimated from a sample. The cases of any other chunk are made, for the keys of its parts.

use crate::chunks::chunk::{self, WORK};
use crate::files::place::is_object;
use crate::store::key::Key;
use crate::store::{Miss, Summary, all_in, checked_summary, summary};
use rayon::prelude::*;
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::Path;
use std::time::SystemTime;

/// Cases whose work is computed, of all chunks without a file together, and at least one of each.
const SAMPLED: u64 = 2048;

/// The largest work in a sample must be this many times below what makes a chunk several parts.
const MARGIN: f64 = 4.0;

/// Fractional part of the golden ratio: its multiples are spread evenly, whatever the lengths of the axes.
const GOLDEN: f64 = 0.618_033_988_749_894_9;

/// What is read of a part.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reading {
    /// Its end, so that damage of its rows is not seen.
    Footer,
    /// All of it, which must have its checksum.
    Whole,
}

/// A part, or what is known of it.
pub(crate) struct KnownPart {
    /// Number of its cases.
    pub cases: u64,
    /// Their steps times modes, perhaps estimated.
    pub work: f64,
    /// What the store has of it.
    pub found: Result<Found, Miss>,
}

/// A part in the store.
#[derive(Clone, Copy)]
pub(crate) struct Found {
    /// Number of cases without a solution.
    pub failed: u64,
    /// When it was saved.
    pub saved: Option<SystemTime>,
}

/// Why a file was not taken, and what its footer says.
type FoundFile = (Miss, Option<(Summary, Found)>);

/// The files of a store, and a sample of the work of the chunks without any.
pub(crate) struct Outline {
    files: BTreeMap<u64, Vec<FoundFile>>,
    /// Of each chunk without a file: the mean work of its cases.
    sampled: BTreeMap<u64, f64>,
    /// Number of cases of a part of such a chunk; `None` if only the cases tell it.
    cases_of_part: Option<u64>,
}

impl Outline {
    /// Of a store, which may not be there yet. If the parts are `numbered`, their numbers decide to which shard they belong.
    ///
    /// # Errors
    /// A folder that cannot be read.
    pub fn new(
        study: &Study,
        store: &Path,
        reading: Reading,
        numbered: bool,
    ) -> Result<Outline, Error> {
        let is_there =
            is_object(store) || fs::exists(store).map_err(Error::io("cannot read", store))?;
        let paths = if is_there { all_in(store)? } else { Vec::new() };
        let read: Result<Vec<_>, Error> = paths
            .into_par_iter()
            .map(|(start, path)| {
                let saved = fs::metadata(&path).and_then(|file| file.modified()).ok();
                let found = |summary: Summary| {
                    let failed = summary.failed;
                    (summary, Found { failed, saved })
                };
                let read = match reading {
                    Reading::Footer => summary(&path),
                    Reading::Whole => checked_summary(&path),
                };
                if let Err(miss) = &read {
                    miss.answered()?;
                }
                let read = read.ok().flatten().map(found);
                Ok((start, (Miss::Damaged(path), read)))
            })
            .collect();
        let mut files: BTreeMap<u64, Vec<_>> = BTreeMap::new();
        for (start, file) in read? {
            files.entry(start).or_default().push(file);
        }
        let with_files: BTreeMap<u64, ()> = files
            .keys()
            .map(|start| (chunk::of_combination(study, *start), ()))
            .collect();
        let absent: Vec<u64> = (0..chunk::count(study))
            .filter(|chunk| !with_files.contains_key(chunk))
            .collect();
        let each = SAMPLED.div_ceil(absent.len().max(1) as u64);
        let works: Vec<(u64, Vec<f64>)> = absent
            .into_par_iter()
            .map(|chunk| (chunk, sample(study, chunk, each)))
            .collect();
        let positive = || {
            works
                .iter()
                .flat_map(|(_, works)| works)
                .copied()
                .filter(|work| *work > 0.0)
        };
        let (smallest, largest) = (
            positive().fold(f64::INFINITY, f64::min),
            positive().fold(0.0, f64::max),
        );
        let most = works.iter().map(|(chunk, _)| {
            let raws = chunk::combinations(study, *chunk);
            raws.end - raws.start
        });
        let most = most.max().unwrap_or(0);
        let cases_of_part = match () {
            () if chunk::owned_whole(study) || !numbered => Some(most),
            () if largest * most as f64 * MARGIN <= WORK as f64 => Some(most),
            () if smallest == largest => Some((WORK / largest as u64).max(1)),
            () => None,
        };
        let mean = |(chunk, works): (u64, Vec<f64>)| {
            (chunk, works.iter().sum::<f64>() / works.len().max(1) as f64)
        };
        Ok(Outline {
            files,
            sampled: works.into_iter().map(mean).collect(),
            cases_of_part,
        })
    }

    /// All parts in order, with the numbers that decide their shards.
    pub fn parts(&self, study: &Study) -> Vec<(u64, KnownPart)> {
        let of_chunk = |chunk: u64| (chunk, self.of_chunk(study, chunk));
        let chunks: Vec<_> = (0..chunk::count(study))
            .into_par_iter()
            .map(of_chunk)
            .collect();
        let (whole, mut count) = (chunk::owned_whole(study), 0);
        let mut numbered = Vec::new();
        for (chunk, parts) in chunks {
            for part in parts {
                numbered.push((if whole { chunk } else { count }, part));
                count += 1;
            }
        }
        numbered
    }

    fn of_chunk(&self, study: &Study, chunk: u64) -> Vec<KnownPart> {
        match (self.sampled.get(&chunk), self.cases_of_part) {
            (Some(mean), Some(of_part)) => {
                let numbers = numbers(study, chunk);
                absent(numbers.end - numbers.start, of_part, *mean)
            }
            (Some(_), None) | (None, _) => self.with_cases(study, chunk),
        }
    }

    /// The parts of a chunk whose cases are made for it.
    fn with_cases(&self, study: &Study, chunk: u64) -> Vec<KnownPart> {
        let parts = chunk::parts(study, chunk).into_iter();
        let known = parts.map(|part| {
            let (start, first, work) = (part.start, part.first, part.work as f64);
            let cases = part.cases();
            let found = self.find(start, &Key::new(study, first, &cases), cases.len());
            KnownPart {
                cases: cases.len() as u64,
                work,
                found,
            }
        });
        known.collect()
    }

    /// The file with this start, key and number of cases.
    fn find(&self, start: u64, key: &Key, cases: usize) -> Result<Found, Miss> {
        let mut miss = Miss::Absent;
        for (damaged, file) in self.files.get(&start).into_iter().flatten() {
            let Some((summary, found)) = file else {
                miss = damaged.clone();
                continue;
            };
            match key.difference(&summary.key) {
                None if summary.cases == cases => return Ok(*found),
                None => miss = damaged.clone(),
                Some(difference) => miss = Miss::Outdated(difference),
            }
        }
        Err(miss)
    }
}

/// The numbers of the cases of a chunk.
fn numbers(study: &Study, chunk: u64) -> Range<u64> {
    let raws = chunk::combinations(study, chunk);
    study.enumeration().first_from(raws.start)..study.enumeration().first_from(raws.end)
}

/// The work of so many cases of a chunk, which are spread in it.
fn sample(study: &Study, chunk: u64, count: u64) -> Vec<f64> {
    let Range { start, end } = numbers(study, chunk);
    let length = end - start;
    let number = |i: u64| match count >= length {
        true => start + i,
        false => start + ((GOLDEN * (chunk * count + i) as f64).fract() * length as f64) as u64,
    };
    let work = |number: u64| {
        study
            .case(number)
            .map_or(0.0, |case| study.work(&case) as f64)
    };
    (0..count.min(length)).map(number).map(work).collect()
}

/// A chunk without files, with so many cases in all and in a part, and the work of each.
fn absent(cases: u64, of_part: u64, work: f64) -> Vec<KnownPart> {
    let starts = (0..cases).step_by(of_part.max(1) as usize);
    let part = |start: u64| {
        let cases_of_part = of_part.min(cases - start);
        KnownPart {
            cases: cases_of_part,
            work: work * cases_of_part as f64,
            found: Err(Miss::Absent),
        }
    };
    starts.map(part).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chunks::shard::Shard;
    use crate::run_shard;
    use crate::store::Store;
    use indicatif::ProgressBar;
    use slipgap_study::parse;
    use std::time::{Duration, Instant};

    fn study(parameters: &str, more: &str) -> Study {
        let text = format!(
            r#"{{"problem": "friction-oscillator", "parameters": {{"law": "velocity-control", {parameters}}}{more}}}"#
        );
        parse("s.json", &text).unwrap()
    }

    fn outline(study: &Study, store: &Path) -> Vec<(u64, u64, f64, bool)> {
        let outline = Outline::new(study, store, Reading::Footer, true).unwrap();
        let parts = outline.parts(study).into_iter();
        let known = parts.map(|(n, part)| (n, part.cases, part.work, part.found.is_ok()));
        known.collect()
    }

    /// The same parts from their cases.
    fn made(study: &Study) -> Vec<(u64, u64, f64, bool)> {
        let parts = (0..chunk::count(study)).flat_map(|chunk| chunk::parts(study, chunk));
        let known = (0..).zip(parts);
        known
            .map(|(n, part)| (n, part.len() as u64, part.work as f64, false))
            .collect()
    }

    #[test]
    fn parts_that_the_store_does_not_have_are_those_that_the_cases_make() {
        let nowhere = Path::new("no store");
        // A condition; parts of fewer cases than a chunk, of the same work; and of work that only the cases tell.
        let light = r#""beta": {"linspace": [1, 2, 300]}, "dT": {"linspace": [0.1, 0.5, 400]}, "duration": 30"#;
        let heavy = r#""beta": {"linspace": [1, 2, 300]}, "x0": {"linspace": [1, 2, 100]}, "dT": 1e-4, "duration": 30"#;
        let mixed = r#""beta": {"linspace": [1, 2, 200]}, "dT": {"geomspace": [0.5, 1e-5, 100]}, "duration": 3"#;
        for (parameters, more, tolerance) in [
            (light, r#", "when": "dT > 0.2""#, 0.02),
            (heavy, "", 1e-12),
            (mixed, "", 1e-12),
        ] {
            let study = study(parameters, more);
            let (outlined, made) = (outline(&study, nowhere), made(&study));
            let counts = |parts: &[(u64, u64, f64, bool)]| -> Vec<(u64, u64)> {
                parts.iter().map(|part| (part.0, part.1)).collect()
            };
            assert_eq!(counts(&outlined), counts(&made), "{parameters}");
            let work = |parts: &[(u64, u64, f64, bool)]| parts.iter().map(|part| part.2).sum();
            let [estimate, exact]: [f64; 2] = [work(&outlined), work(&made)];
            // 2048 of 90 000 cases, whose work differs 2.5-fold.
            assert!(
                (estimate / exact - 1.0).abs() < tolerance,
                "{estimate} {exact}"
            );
        }
    }

    #[test]
    fn the_parts_of_a_shard_are_found_beside_those_that_are_missing() {
        let folder = tempfile::tempdir().unwrap();
        let parameters = r#""beta": {"linspace": [1, 2, 250]}, "x0": {"linspace": [1, 2, 100]}, "dT": 0.5, "duration": 3"#;
        let study = study(parameters, r#", "when": "x0 > 1.2""#);
        let store = Store::open_shared(folder.path()).unwrap();
        let second: Shard = "2/2".parse().unwrap();
        run_shard(&study, second, &store, &ProgressBar::hidden()).unwrap();
        let found = |study: &Study| -> Vec<bool> {
            let parts = outline(study, store.folder()).into_iter();
            parts.map(|part| part.3).collect()
        };
        assert_eq!(found(&study), [false, true]);
        let text = parameters.replace("0.5", "0.25");
        let other = self::study(&text, r#", "when": "x0 > 1.2""#);
        assert_eq!(found(&other), [false, false]);
    }

    #[test]
    fn no_case_of_a_billion_is_made_to_count_them() {
        let parameters = r#""beta": {"linspace": [1, 2, 100000]}, "x0": {"linspace": [1, 2, 10000]}, "dT": 0.5, "duration": 3"#;
        let study = study(parameters, "");
        let begin = Instant::now();
        let parts = outline(&study, Path::new("no store"));
        // Without optimisation and beside other tests; making the cases would take a quarter of an hour.
        assert!(begin.elapsed() < Duration::from_secs(5));
        assert_eq!(parts.len(), 3815);
        assert_eq!(parts.iter().map(|part| part.1).sum::<u64>(), 1_000_000_000);
    }
}
