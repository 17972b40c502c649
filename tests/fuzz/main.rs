//! Studies changed or made up at random: read, listed, solved and drawn. A short form runs with all tests, the same every
//! time; `make fuzz` runs the long one, for SLIPGAP_FUZZ_SECONDS (300) from SLIPGAP_FUZZ_SEED (the time of day).

mod chance;
mod hold;
mod mutate;
mod random;
mod words;
mod xml;

use chance::Chance;
use hold::{Came, hold};
use std::collections::BTreeMap;
use std::fs;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::Mutex;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant, SystemTime};

/// Longest that a text may take before it counts as one that does not end. Texts take a second at most; this is no measure
/// of speed.
const ENDLESS: Duration = Duration::from_secs(300);

/// The studies that the project ships, and the ones that `init` writes.
fn shipped() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let files = walkdir::WalkDir::new(root.join("studies")).sort_by_file_name();
    let texts = files
        .into_iter()
        .filter_map(|entry| fs::read_to_string(entry.ok()?.path()).ok());
    let problems = slipgap::problem::PROBLEMS.iter();
    let starts =
        problems.filter_map(|problem| slipgap::study::start(&**problem).map(str::to_owned));
    texts.chain(starts).collect()
}

/// The text of one seed: three of four made up, half of these changed; the others shipped studies, changed.
fn text(seed: u64, shipped: &[String]) -> String {
    let mut chance = Chance::new(seed);
    match chance.below(8) {
        0..2 => mutate::mutated(&shipped[chance.below(shipped.len())], &mut chance),
        2..5 => {
            let made = random::study(&mut chance);
            mutate::mutated(&made, &mut chance)
        }
        _ => random::study(&mut chance),
    }
}

/// Puts the text of a seed to the tests; a failure prints its seed and text.
fn try_seed(seed: u64, shipped: &[String]) -> Came {
    let text = text(seed, shipped);
    let held = catch_unwind(AssertUnwindSafe(|| hold(&text, &mut Chance::new(seed))));
    held.unwrap_or_else(|_| panic!("seed {seed} fails; its study:\n{text}\n"))
}

#[test]
fn studies_at_random_are_refused_or_run() {
    let shipped = shipped();
    let mut came: BTreeMap<Came, usize> = BTreeMap::new();
    for seed in 0..400 {
        *came.entry(try_seed(seed, &shipped)).or_default() += 1;
    }
    // Made-up studies that are all refused would test little.
    for least in [Came::Refused, Came::Solved, Came::Drawn] {
        assert!(came.get(&least).copied().unwrap_or(0) >= 20, "{came:?}");
    }
}

#[test]
#[ignore = "minutes: make fuzz"]
fn studies_at_random_for_minutes() {
    let of = |name: &str| std::env::var(name).ok().and_then(|text| text.parse().ok());
    let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
    let start = of("SLIPGAP_FUZZ_SEED").unwrap_or(now.map_or(1, |now| now.as_secs()) << 20);
    let time = Duration::from_secs(of("SLIPGAP_FUZZ_SECONDS").unwrap_or(300));
    let (shipped, begun) = (shipped(), Instant::now());
    let next = AtomicU64::new(start);
    let came = Mutex::new(BTreeMap::<Came, usize>::new());
    let failed = Mutex::new(Vec::new());
    let work = || {
        while begun.elapsed() < time {
            let seed = next.fetch_add(1, Ordering::Relaxed);
            let ended = end_of(seed, &shipped);
            match ended {
                Some(how) => *came.lock().unwrap().entry(how).or_default() += 1,
                None => failed.lock().unwrap().push(seed),
            }
        }
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    std::thread::scope(|scope| (0..threads).for_each(|_| drop(scope.spawn(work))));
    println!(
        "seeds {start}..{}: {:?}",
        next.into_inner(),
        came.into_inner().unwrap()
    );
    let failed = failed.into_inner().unwrap();
    assert!(failed.is_empty(), "seeds that fail: {failed:?}");
}

/// How far a seed came, tried in a thread of its own; `None` if it failed. One that does not end ends the program.
fn end_of(seed: u64, shipped: &[String]) -> Option<Came> {
    let (sender, receiver) = std::sync::mpsc::channel();
    std::thread::scope(|scope| {
        let tried = scope.spawn(move || {
            let came = try_seed(seed, shipped);
            let _ = sender.send(());
            came
        });
        if let Err(std::sync::mpsc::RecvTimeoutError::Timeout) = receiver.recv_timeout(ENDLESS) {
            eprintln!(
                "seed {seed} does not end; its study:\n{}",
                text(seed, shipped)
            );
            std::process::exit(1);
        }
        tried.join().ok()
    })
}
