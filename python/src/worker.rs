//! Work on other threads while Python goes on: its other threads run, and Ctrl-C ends the work.

use crate::error::{raise, usage};
use pyo3::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};
use slipgap::error::Error;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::{RecvTimeoutError, sync_channel};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// Time between two looks at signals.
const TICK: Duration = Duration::from_millis(50);

/// Time that stopped work has to end by itself. A single long case goes on after it, and its result is dropped.
const GRACE: Duration = Duration::from_millis(300);

/// Largest number of threads.
const MOST_THREADS: usize = 1024;

/// The threads of the last call, for the next one: to start them takes longer than a small study.
struct Idle {
    /// A process that is forked has no threads of its parent.
    process: u32,
    jobs: usize,
    pool: ThreadPool,
}

static IDLE: Mutex<Option<Idle>> = Mutex::new(None);

/// Threads, `jobs` of them, 0 for one on each core.
fn threads(jobs: usize) -> Result<Idle, Error> {
    let process = std::process::id();
    let idle = IDLE.lock().unwrap_or_else(PoisonError::into_inner).take();
    match idle {
        Some(idle) if idle.process == process && idle.jobs == jobs => return Ok(idle),
        // To drop threads that are not there would wait for them.
        Some(idle) if idle.process != process => std::mem::forget(idle),
        Some(_) | None => {}
    }
    let built = ThreadPoolBuilder::new().num_threads(jobs).build();
    let pool = built.map_err(|e| Error::Internal(format!("cannot start threads: {e}")))?;
    Ok(Idle {
        process,
        jobs,
        pool,
    })
}

/// The number of threads that a caller asks for.
pub fn jobs(py: Python<'_>, jobs: Option<i64>) -> PyResult<usize> {
    let Some(jobs) = jobs else {
        return Ok(0);
    };
    let allowed = usize::try_from(jobs).ok();
    allowed
        .filter(|jobs| (1..=MOST_THREADS).contains(jobs))
        .ok_or_else(|| usage(py, format!("jobs: must be 1 to {MOST_THREADS}, got {jobs}")))
}

/// The result of `work` on these threads. `tick` is called now and then; its error, or Ctrl-C, calls `stop` and ends the
/// waiting.
pub fn wait<T: Send + 'static>(
    py: Python<'_>,
    jobs: usize,
    work: impl FnOnce() -> Result<T, Error> + Send + 'static,
    stop: impl FnOnce(),
    mut tick: impl FnMut(Python<'_>) -> PyResult<()>,
) -> PyResult<T> {
    let threads = threads(jobs).map_err(|error| raise(py, error))?;
    let (sender, receiver) = sync_channel(1);
    let receiver = Mutex::new(receiver);
    let receive = |time: Duration| {
        let receiver = receiver.lock().unwrap_or_else(PoisonError::into_inner);
        receiver.recv_timeout(time)
    };
    threads.pool.spawn(move || {
        let result = catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| {
            let message = "internal error of slipgap; please report it";
            Err(Error::Internal(message.into()))
        });
        // Nobody waits for a stopped result.
        let _ = sender.send(result);
    });
    let interruption = loop {
        match py.detach(|| receive(TICK)) {
            Ok(result) => {
                *IDLE.lock().unwrap_or_else(PoisonError::into_inner) = Some(threads);
                return result.map_err(|error| raise(py, error));
            }
            Err(RecvTimeoutError::Disconnected) => {
                let message = "a thread of slipgap ended; please report it";
                return Err(raise(py, Error::Internal(message.into())));
            }
            Err(RecvTimeoutError::Timeout) => {}
        }
        if let Err(error) = py.check_signals().and_then(|()| tick(py)) {
            break error;
        }
    };
    stop();
    // A stopped run removes its partial files.
    let _ = py.detach(|| receive(GRACE));
    Err(interruption)
}
