//! Pipes with a thread each, for systems that do not say which of them are ready.

use super::super::tail::Tail;
use super::{LONGEST, LONGEST_ERROR, Silent};
use std::borrow::Cow;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::Child;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel, sync_channel};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// Lines that wait to be read.
const WAITING: usize = 256;

/// The pipes of a program.
#[derive(Debug)]
pub(in super::super) struct Pipes {
    /// `None` when its input has ended.
    requests: Option<Sender<Vec<u8>>>,
    lines: Receiver<String>,
    /// Reads what it says besides.
    errors: Option<JoinHandle<()>>,
    tail: Arc<Mutex<Tail>>,
}

/// How often it is looked whether all has been read.
const LOOK: Duration = Duration::from_millis(1);

fn locked(tail: &Mutex<Tail>) -> MutexGuard<'_, Tail> {
    tail.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Pipes {
    /// The pipes of a program that was just started.
    pub(in super::super) fn of(child: &mut Child) -> Pipes {
        let tail = Arc::<Mutex<Tail>>::default();
        let (requests, to_write) = channel::<Vec<u8>>();
        let (to_read, lines) = sync_channel(WAITING);
        if let Some(input) = child.stdin.take() {
            thread::spawn(move || write(input, to_write));
        }
        if let Some(output) = child.stdout.take() {
            thread::spawn(move || read(output, LONGEST, |line| to_read.send(line).is_ok()));
        }
        let errors = child.stderr.take().map(|errors| {
            let tail = tail.clone();
            let keep = move |line: String| {
                locked(&tail).push(&line);
                true
            };
            thread::spawn(move || read(errors, LONGEST_ERROR, keep))
        });
        Pipes {
            requests: Some(requests),
            lines,
            errors,
            tail,
        }
    }

    /// Sends a request.
    pub(in super::super) fn send(&mut self, request: Vec<u8>) {
        // Where its input is closed, the program has ended, which its output tells.
        let _ = self
            .requests
            .as_ref()
            .map(|requests| requests.send(request));
    }

    /// The input ends.
    pub(in super::super) fn end_input(&mut self) {
        self.requests = None;
    }

    /// The next line of the output.
    ///
    /// # Errors
    /// There is none until this instant, or no more.
    pub(in super::super) fn line(&mut self, until: Instant) -> Result<Cow<'_, str>, Silent> {
        let left = until.saturating_duration_since(Instant::now());
        let line = self.lines.recv_timeout(left).map_err(|why| match why {
            RecvTimeoutError::Timeout => Silent::Late,
            RecvTimeoutError::Disconnected => Silent::Ended,
        })?;
        Ok(Cow::Owned(line))
    }

    /// Keeps a line for messages.
    pub(in super::super) fn keep(&mut self, line: &str) {
        locked(&self.tail).push(line);
    }

    /// Keeps what comes for some time as lines for messages, so that a program that ends can write; not longer than until all has come.
    pub(in super::super) fn keep_rest(&mut self, within: Duration) {
        let until = Instant::now() + within;
        while let Ok(line) = self.line(until).map(Cow::into_owned) {
            self.keep(&line);
        }
        let reads = |errors: &JoinHandle<()>| !errors.is_finished();
        while Instant::now() < until && self.errors.as_ref().is_some_and(reads) {
            thread::sleep(LOOK);
        }
    }

    /// A message with the last lines of the program.
    pub(in super::super) fn with_tail(&self, why: &str) -> String {
        locked(&self.tail).after(why)
    }
}

/// Writes requests until there are no more, or the program does not read any more.
fn write(mut input: impl Write, requests: Receiver<Vec<u8>>) {
    for request in requests {
        if input
            .write_all(&request)
            .and_then(|()| input.flush())
            .is_err()
        {
            return;
        }
    }
}

/// Reads lines until the end, or until nobody takes them.
fn read(output: impl Read, longest: usize, mut take: impl FnMut(String) -> bool) {
    let mut reader = BufReader::with_capacity(1 << 16, output);
    loop {
        let mut bytes = Vec::new();
        match reader
            .by_ref()
            .take(longest as u64)
            .read_until(b'\n', &mut bytes)
        {
            Ok(1..) => {}
            Ok(0) | Err(_) => return,
        }
        if !take(String::from_utf8_lossy(&bytes).into_owned()) {
            return;
        }
    }
}
