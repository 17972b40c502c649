//! How far a study is, from the files of its store alone: its parts, and the signs of the processes that compute them. Nothing is
//! written, so that any machine that sees the folder can ask.

pub(crate) mod outline;
mod progress;

pub use progress::{Progress, State};

use super::chunks::shard::{Shard, shard_of};
use super::files::heartbeat::{self, DEAD, Sign};
use super::store::key::Difference;
use super::store::{Miss, STORE};
use outline::{Outline, Reading};
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime};

/// Largest number of shards that are listed.
pub const MOST_SHARDS: u64 = 100_000;

/// Most shards that are listed if their number is only that in a sign, which a mistake may have left. Of more, those with a sign are.
const MOST_UNASKED: u64 = 1000;

/// How far a study is.
#[derive(Debug)]
pub struct StudyStatus {
    /// All cases.
    pub all: Progress,
    /// Each shard, if their number is known.
    pub shards: Vec<(Shard, Progress)>,
    /// Processes whose last sign is more than [`DEAD`] ahead of the clock of this machine, and by how much: whether they run is not known.
    pub ahead: Vec<(Option<Shard>, Duration)>,
    /// Number of parts of another version of the study or of the solver, and the first difference.
    pub outdated: Option<(u64, Difference)>,
    /// Number of damaged or unreadable parts, and the first of them.
    pub damaged: Option<(u64, PathBuf)>,
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
    let (store, shards_given) = (results.join(STORE), shards.is_some());
    let signs = heartbeat::signs(&store);
    // The clock of the file server, which gives the times, may be ahead of this one.
    let latest_possible = SystemTime::now() + DEAD;
    let (signs, ahead): (Vec<Sign>, Vec<Sign>) = signs
        .into_iter()
        .partition(|sign| sign.written <= latest_possible);
    let last = signs.iter().max_by_key(|sign| sign.written);
    let of_last = last.and_then(|sign| sign.shard).map(Shard::of);
    let of = shards.or(of_last.filter(|of| *of <= MOST_SHARDS));
    let mut status = StudyStatus {
        all: Progress::default(),
        shards: Vec::new(),
        outdated: None,
        damaged: None,
        ahead: ahead
            .into_iter()
            .map(|sign| (sign.shard, until(sign.written)))
            .collect(),
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
    let outline = Outline::new(study, &store, Reading::Footer, of.is_some())?;
    for (number, part) in outline.parts(study) {
        match &part.found {
            Err(Miss::Outdated(difference)) => {
                status.outdated.get_or_insert((0, *difference)).0 += 1;
            }
            Err(Miss::Damaged(path)) => {
                status.damaged.get_or_insert_with(|| (0, path.clone())).0 += 1;
            }
            Ok(_) | Err(Miss::Absent | Miss::Unread(..)) => {}
        }
        let of_shard = of.map(|of| &mut shards[shard_of(number, of) as usize - 1]);
        for progress in of_shard.into_iter().chain([&mut status.all]) {
            progress.part(&part);
        }
    }
    let latest = shards.iter().chain([&status.all]).filter_map(|p| p.latest);
    let newest = latest.max().max(Some(SystemTime::now()));
    let now = newest.unwrap_or(SystemTime::UNIX_EPOCH);
    let progresses = shards.iter_mut().chain([&mut status.all]);
    progresses.for_each(|progress| progress.finish(now));
    let few = shards_given || of.unwrap_or(0) <= MOST_UNASKED;
    let listed = |(shard, _): &(Shard, Progress)| {
        let mut of_signs = signs.iter().filter_map(|sign| sign.shard);
        few || of_signs.any(|of_sign| of_sign == *shard)
    };
    let numbered = Shard::all(of.unwrap_or(0)).zip(shards);
    status.shards = numbered.filter(listed).collect();
    Ok(status)
}

/// How long it is until a time.
fn until(time: SystemTime) -> Duration {
    time.duration_since(SystemTime::now()).unwrap_or_default()
}
