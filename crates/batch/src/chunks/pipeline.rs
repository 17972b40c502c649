//! Parts on all threads, their results in order.

use super::chunk::{self, Part};
use super::queue::PartQueue;
use rayon::Yield;
use slipgap_study::Study;
use slipgap_study::error::Error;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Number of parts for each thread that are begun and not taken.
const PARTS: usize = 4;

/// Time after which a thread that waits for a part looks for other work again.
const PAUSE: Duration = Duration::from_micros(200);

/// Does the `work` of all parts of the queue. `take` receives the results in the order of the parts, each as soon as it and all
/// before it are there. No thread waits for another one while parts are left. Memory does not grow with their number.
///
/// # Errors
/// The first of `work` or `take`, in the order of the parts. It ends the work.
pub(crate) fn in_order<R: Send>(
    study: &Study,
    mut queue: PartQueue,
    work: impl Fn(Part) -> Result<R, Error> + Sync,
    mut take: impl FnMut(R) -> Result<(), Error>,
) -> Result<(), Error> {
    let threads = rayon::current_num_threads();
    let most = chunk::parts_at_a_time(study, PARTS * threads);
    let (finished, work) = (Finished::default(), &work);
    rayon::in_place_scope_fifo(|scope| {
        let (mut begun, mut taken, mut left) = (0, 0, true);
        loop {
            while left && begun - taken + threads <= most {
                let parts = queue.next(threads);
                left = !parts.is_empty();
                for (_, part) in parts {
                    let (position, finished) = (begun, &finished);
                    scope.spawn_fifo(move |_| {
                        if !finished.stopped.load(Ordering::Relaxed) {
                            // Without its result, `take` would wait for ever.
                            let first = part.first;
                            let done = catch_unwind(AssertUnwindSafe(|| work(part)));
                            finished.put(position, done.unwrap_or_else(|_| Err(ended(first))));
                        }
                    });
                    begun += 1;
                }
            }
            if taken == begun {
                return Ok(());
            }
            let result = finished.wait_for(taken).and_then(&mut take);
            if result.is_err() {
                finished.stopped.store(true, Ordering::Relaxed);
                return result;
            }
            taken += 1;
        }
    })
}

/// The error of a part whose work has panicked, after the message of the panic.
fn ended(first: u64) -> Error {
    let what = format!(
        "the computation of case {first} or of one after it ended by a fault of the program"
    );
    Error::Internal(what)
}

/// Results that are not taken yet, by the places of their parts.
struct Finished<R> {
    results: Mutex<BTreeMap<usize, Result<R, Error>>>,
    changed: Condvar,
    stopped: AtomicBool,
}

impl<R> Default for Finished<R> {
    fn default() -> Self {
        Finished {
            results: Mutex::default(),
            changed: Condvar::new(),
            stopped: AtomicBool::new(false),
        }
    }
}

impl<R> Finished<R> {
    fn put(&self, position: usize, result: Result<R, Error>) {
        self.results().insert(position, result);
        self.changed.notify_one();
    }

    /// The result of a part that was begun. Until it is there, this thread does other work of its pool.
    fn wait_for(&self, position: usize) -> Result<R, Error> {
        loop {
            if let Some(result) = self.results().remove(&position) {
                return result;
            }
            if rayon::yield_now() == Some(Yield::Executed) {
                continue;
            }
            let results = self.results();
            if !results.contains_key(&position) {
                drop(self.changed.wait_timeout(results, PAUSE));
            }
        }
    }

    fn results(&self) -> MutexGuard<'_, BTreeMap<usize, Result<R, Error>>> {
        self.results.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::sync::atomic::AtomicUsize;

    /// Does parts in a study of 40, each of which waits a different time, on so many threads; `fail` fails. Gives the numbers of the
    /// first cases that were taken, and the largest number of parts that were done and not taken.
    fn taken(threads: usize, fail: Option<u64>) -> (Vec<u64>, usize, Result<(), Error>) {
        let text = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control", "dT": 0.1, "duration": 3,
            "beta": {"range": [1, 655360, 1]}}}"#;
        let study = slipgap_study::parse("s.json", text).unwrap();
        let (done, most, mut firsts) = (AtomicUsize::new(0), AtomicUsize::new(0), Vec::new());
        let work = |part: Part| {
            let number = part.first / 16_384;
            std::thread::sleep(Duration::from_millis(number * 7 % 5));
            done.fetch_add(1, Ordering::SeqCst);
            match fail == Some(number) {
                true => Err(Error::Interrupted),
                false => Ok(number),
            }
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let result = pool.build().unwrap().install(|| {
            in_order(&study, PartQueue::new(&study), work, |number| {
                most.fetch_max(done.load(Ordering::SeqCst) - firsts.len(), Ordering::SeqCst);
                firsts.push(number);
                Ok(())
            })
        });
        (firsts, most.into_inner(), result)
    }

    #[test]
    fn results_are_taken_in_order_and_few_wait() {
        for threads in 1..=4 {
            let (firsts, most, result) = taken(threads, None);
            assert!(result.is_ok());
            assert_eq!(firsts, (0..40).collect::<Vec<_>>());
            assert!(most <= PARTS * threads, "{most} with {threads}");
        }
    }

    #[test]
    fn the_parts_before_an_error_are_taken() {
        for threads in 1..=4 {
            let (firsts, _, result) = taken(threads, Some(7));
            assert!(matches!(result, Err(Error::Interrupted)), "{result:?}");
            assert_eq!(firsts, (0..7).collect::<Vec<_>>());
        }
    }

    #[test]
    fn a_part_whose_work_panics_is_an_error_and_nobody_waits_for_it() {
        let text = r#"{"problem": "friction-oscillator", "parameters": {"law": "velocity-control", "dT": 0.1, "duration": 3,
            "beta": {"range": [1, 655360, 1]}}}"#;
        let study = slipgap_study::parse("s.json", text).unwrap();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2);
        let work = |part: Part| {
            assert!(part.first != 5 * 16_384, "a panic of this test");
            Ok(())
        };
        let mut taken = 0;
        let result = pool.build().unwrap().install(|| {
            in_order(&study, PartQueue::new(&study), work, |()| {
                taken += 1;
                Ok(())
            })
        });
        let why = result.unwrap_err().to_string();
        assert!(why.contains("case 81920"), "{why}");
        assert_eq!(taken, 5);
    }
}
