//! How far a study is, from the files of its store alone: its parts, and the signs of the processes that compute them. Nothing is
//! written, so that any machine that sees the folder can ask.

mod progress;

pub use progress::{Progress, State};

use super::chunks::chunk::{self, Part};
use super::chunks::queue::PartQueue;
use super::chunks::shard::{Shard, shard_of};
use super::files::heartbeat;
use super::files::place::is_object;
use super::store::key::{Difference, Key};
use super::store::{Miss, STORE, all_in, failures};
use rayon::prelude::*;
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::SystemTime;

/// Number of parts for each thread that are looked at at a time.
const PARTS: usize = 4;

/// Largest number of shards that are listed.
pub const MOST_SHARDS: u64 = 100_000;

/// How far a study is.
#[derive(Debug)]
pub struct StudyStatus {
    /// All cases.
    pub all: Progress,
    /// Each shard, if their number is known.
    pub shards: Vec<(Shard, Progress)>,
    /// Number of parts of another version of the study or of the solver, and the first difference.
    pub outdated: Option<(u64, Difference)>,
}

/// How far a study with this folder of results is, in `shards` shards; if this is not given, in as many as the process has that last
/// gave a sign.
///
/// # Errors
/// A folder that cannot be read.
pub fn study_status(
    study: &Study,
    results: &Path,
    shards: Option<u64>,
) -> Result<StudyStatus, Error> {
    let store = results.join(STORE);
    let signs = heartbeat::signs(&store);
    let last = signs.iter().max_by_key(|sign| sign.written);
    let of_last = last.and_then(|sign| sign.shard).map(Shard::of);
    let of = shards.or(of_last.filter(|of| *of <= MOST_SHARDS));
    let mut status = StudyStatus {
        all: Progress::default(),
        shards: Vec::new(),
        outdated: None,
    };
    let mut shards: Vec<Progress> = Vec::new();
    shards.resize_with(of.unwrap_or(0) as usize, Progress::default);
    for sign in &signs {
        status.all.sign(sign);
        let known = sign.shard.filter(|shard| of == Some(shard.of()));
        if let Some(shard) = known {
            shards[shard.index() as usize - 1].sign(sign);
        }
    }
    let files = Files::of(&store)?;
    let mut queue = PartQueue::new(study);
    let count = chunk::parts_at_a_time(study, PARTS * rayon::current_num_threads());
    loop {
        let parts = queue.next(count);
        if parts.is_empty() {
            break;
        }
        let found: Vec<_> = parts
            .into_par_iter()
            .map(|(number, part)| (number, part.len(), part.work, files.find(study, part)))
            .collect();
        for (number, cases, work, found) in found {
            if let Err(Miss::Outdated(difference)) = &found {
                let (count, _) = status.outdated.get_or_insert((0, *difference));
                *count += 1;
            }
            let of_shard = of.map(|of| &mut shards[shard_of(number, of) as usize - 1]);
            for progress in of_shard.into_iter().chain([&mut status.all]) {
                progress.part(cases, work, found.as_ref().ok());
            }
        }
    }
    // The clock of the file server, which gives the times, may be ahead of this one.
    let latest = shards.iter().chain([&status.all]).filter_map(|p| p.latest);
    let newest = latest.max().max(Some(SystemTime::now()));
    let now = newest.unwrap_or(SystemTime::UNIX_EPOCH);
    let progresses = shards.iter_mut().chain([&mut status.all]);
    progresses.for_each(|progress| progress.finish(now));
    status.shards = Shard::all(of.unwrap_or(0)).zip(shards).collect();
    Ok(status)
}

/// A part in the store.
struct Found {
    /// Number of cases without a solution.
    failed: u64,
    /// When it was saved.
    saved: Option<SystemTime>,
}

/// The files of parts by their starts.
struct Files(BTreeMap<u64, Vec<PathBuf>>);

impl Files {
    /// Those of a store, which may not be there yet.
    fn of(store: &Path) -> Result<Files, Error> {
        let mut files: BTreeMap<u64, Vec<PathBuf>> = BTreeMap::new();
        if is_object(store) || fs::exists(store).map_err(Error::io("cannot read", store))? {
            for (start, path) in all_in(store)? {
                files.entry(start).or_default().push(path);
            }
        }
        Ok(Files(files))
    }

    /// The file of a part.
    fn find(&self, study: &Study, part: Part) -> Result<Found, Miss> {
        let mut miss = Miss::Absent;
        let Some(paths) = self.0.get(&part.start) else {
            return Err(miss);
        };
        let first = part.first;
        let cases = part.cases();
        let key = Key::new(study, first, &cases);
        for path in paths {
            match failures(path, &key, cases.len()) {
                Ok(failed) => {
                    let saved = fs::metadata(path).and_then(|file| file.modified()).ok();
                    return Ok(Found { failed, saved });
                }
                Err(other) => miss = other,
            }
        }
        Err(miss)
    }
}
