//! Pipes without threads, where the system says which of them are ready (POSIX `poll`): to wake a thread costs more than the metrics of
//! a case.

use super::super::tail::Tail;
use super::{LONGEST, LONGEST_ERROR, Silent};
use memchr::memchr;
use rustix::buffer::spare_capacity;
use rustix::event::{PollFd, PollFlags, Timespec, poll};
use rustix::io::{Errno, ioctl_fionbio, read, write};
use std::borrow::Cow;
use std::ops::Range;
use std::os::fd::{AsFd, OwnedFd};
use std::process::Child;
use std::time::{Duration, Instant};

/// Bytes that are read at once: what a pipe of Linux holds.
const CHUNK: usize = 1 << 16;

/// The pipes of a program.
#[derive(Debug)]
pub(in super::super) struct Pipes {
    /// `None` when it has ended.
    input: Option<OwnedFd>,
    /// What the input has not taken yet.
    request: Vec<u8>,
    output: Source,
    errors: Source,
    tail: Tail,
}

/// What comes out of a pipe, in lines.
#[derive(Debug)]
struct Source {
    /// `None` when it has ended.
    pipe: Option<OwnedFd>,
    bytes: Vec<u8>,
    /// Of the bytes, those of lines that were taken.
    taken: usize,
    /// Of the bytes, those in which no end of a line is left.
    searched: usize,
    /// Most bytes of a line.
    longest: usize,
}

/// A pipe that takes or gives only what it can at once; `None` without one.
fn at_once(pipe: Option<impl Into<OwnedFd>>) -> Option<OwnedFd> {
    let pipe = pipe?.into();
    ioctl_fionbio(&pipe, true).ok()?;
    Some(pipe)
}

impl Source {
    fn new(pipe: Option<impl Into<OwnedFd>>, longest: usize) -> Source {
        Source {
            pipe: at_once(pipe),
            bytes: Vec::new(),
            taken: 0,
            searched: 0,
            longest,
        }
    }

    /// Reads what there is.
    fn read(&mut self) {
        let Some(pipe) = &self.pipe else { return };
        self.bytes.drain(..self.taken);
        self.searched -= std::mem::take(&mut self.taken);
        self.bytes.reserve(CHUNK);
        match read(pipe, spare_capacity(&mut self.bytes)) {
            Ok(1..) | Err(Errno::AGAIN | Errno::INTR) => {}
            Ok(0) | Err(_) => self.pipe = None,
        }
    }

    /// The place of the next line that is complete, or the last one.
    fn line(&mut self) -> Option<Range<usize>> {
        let found = memchr(b'\n', &self.bytes[self.searched..]);
        let end = found.map_or(self.bytes.len(), |at| self.searched + at + 1);
        self.searched = end;
        let length = end - self.taken;
        let is_line = found.is_some() || self.pipe.is_none() || length >= self.longest;
        (is_line && length > 0).then(|| std::mem::replace(&mut self.taken, end)..end)
    }
}

/// The text of a line. Most lines are UTF-8, which is seen faster than where it is not.
fn text(bytes: &[u8]) -> Cow<'_, str> {
    let text = str::from_utf8(bytes).map(Cow::Borrowed);
    text.unwrap_or_else(|_| String::from_utf8_lossy(bytes))
}

impl Pipes {
    /// The pipes of a program that was just started.
    pub(in super::super) fn of(child: &mut Child) -> Pipes {
        Pipes {
            input: at_once(child.stdin.take()),
            request: Vec::new(),
            output: Source::new(child.stdout.take(), LONGEST),
            errors: Source::new(child.stderr.take(), LONGEST_ERROR),
            tail: Tail::default(),
        }
    }

    /// Sends a request: what the input does not take at once goes while a line is waited for.
    pub(in super::super) fn send(&mut self, request: Vec<u8>) {
        match self.request.is_empty() {
            true => self.request = request,
            false => self.request.extend(request),
        }
        self.write();
    }

    /// The input ends.
    pub(in super::super) fn end_input(&mut self) {
        self.input = None;
    }

    /// The next line of the output.
    ///
    /// # Errors
    /// There is none until this instant, or no more.
    pub(in super::super) fn line(&mut self, until: Instant) -> Result<Cow<'_, str>, Silent> {
        let place = loop {
            if let Some(place) = self.output.line() {
                break place;
            }
            if self.output.pipe.is_none() {
                return Err(Silent::Ended);
            }
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() {
                return Err(Silent::Late);
            }
            self.turn(left);
        };
        Ok(text(&self.output.bytes[place]))
    }

    /// Keeps a line for messages.
    pub(in super::super) fn keep(&mut self, line: &str) {
        self.tail.push(line);
    }

    /// Keeps what comes for some time as lines for messages, so that a program that ends can write; not longer than until all has come.
    pub(in super::super) fn keep_rest(&mut self, within: Duration) {
        let until = Instant::now() + within;
        loop {
            while let Some(place) = self.output.line() {
                self.tail.push(&text(&self.output.bytes[place]));
            }
            let left = until.saturating_duration_since(Instant::now());
            if left.is_zero() || (self.output.pipe.is_none() && self.errors.pipe.is_none()) {
                return;
            }
            self.turn(left);
        }
    }

    /// A message with the last lines of the program.
    pub(in super::super) fn with_tail(&self, why: &str) -> String {
        self.tail.after(why)
    }

    /// Waits until a pipe is ready or the time is over, and moves what can be moved.
    fn turn(&mut self, left: Duration) {
        let waiting = self.input.as_ref().filter(|_| !self.request.is_empty());
        let outputs = [&self.output.pipe, &self.errors.pipe].into_iter().flatten();
        let mut ends: Vec<PollFd> = outputs.map(|end| PollFd::new(end, PollFlags::IN)).collect();
        ends.extend(waiting.map(|end| PollFd::new(end, PollFlags::OUT)));
        let limit = Timespec::try_from(left).ok();
        // Nothing is ready, or a signal came: whoever waits asks again.
        let Ok(1..) = poll(&mut ends, limit.as_ref()) else {
            return;
        };
        self.output.read();
        self.errors.read();
        while let Some(place) = self.errors.line() {
            self.tail.push(&text(&self.errors.bytes[place]));
        }
        if !self.request.is_empty() {
            self.write();
        }
    }

    /// Writes what the input takes. Where it is closed, the program has ended, which its output tells.
    fn write(&mut self) {
        let Some(input) = &self.input else { return };
        match write(input.as_fd(), &self.request) {
            Ok(taken) => drop(self.request.drain(..taken)),
            Err(Errno::AGAIN | Errno::INTR) => {}
            Err(_) => self.input = None,
        }
    }
}
