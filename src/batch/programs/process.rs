//! A process of a program: lines to its standard input, lines from its standard output, and what it says besides.
//!
//! Threads write and read, so that no program can hold up the product: after its time it is ended. What the pipe takes at once needs no
//! thread: waking one costs more than the metrics of a case.

use slipgap_problem::problem::structure::programs::{Hello, Program};
use std::collections::VecDeque;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Lines that are quoted, and characters of each.
const QUOTED: usize = 5;
const WIDTH: usize = 300;

/// Lines that wait to be read.
const WAITING: usize = 256;

/// Most bytes of a line: 100 channels over 10^6 steps are 2e9.
const LONGEST: u64 = 4 << 30;

/// Time that a program has to end after the end of its input.
const GRACE: Duration = Duration::from_secs(2);

/// How often it is looked whether it has ended.
const LOOK: Duration = Duration::from_millis(5);

/// The last lines of a program.
type Tail = Arc<Mutex<VecDeque<String>>>;

/// A running program.
#[derive(Debug)]
pub(super) struct Process {
    child: Child,
    /// `None` when its input has ended.
    requests: Option<Sender<Vec<u8>>>,
    /// The same input, which refuses what it cannot take at once. `None` where the system has none, and after the first refusal, since
    /// the bytes must stay in their order.
    at_once: Option<File>,
    lines: Receiver<String>,
    tail: Tail,
    /// Whether it has answered a request.
    pub answered: bool,
}

/// Why a program gave no line.
enum Silent {
    /// Its time is over.
    Late,
    /// It has ended.
    Ended,
}

impl Process {
    /// Starts a program and reads its first line.
    ///
    /// # Errors
    /// It cannot be started, says nothing in its time, or something else.
    pub(super) fn start(program: &Program) -> Result<(Process, Hello), String> {
        let mut words = program.command.iter();
        let folder: &Path = match program.folder.as_os_str().is_empty() {
            true => Path::new("."),
            false => &program.folder,
        };
        let mut command = Command::new(words.next().map_or("", String::as_str));
        let piped = command
            .args(words)
            .current_dir(folder)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped());
        let shown = program.shown_command();
        let unstarted = |why: io::Error| format!("cannot start {shown}: {why}");
        let mut child = piped.spawn().map_err(unstarted)?;
        let tail = Tail::default();
        let at_once = child.stdin.as_ref().and_then(at_once);
        let (requests, to_write) = channel::<Vec<u8>>();
        let (to_read, lines) = sync_channel(WAITING);
        if let Some(input) = child.stdin.take() {
            thread::spawn(move || write(input, to_write));
        }
        if let Some(output) = child.stdout.take() {
            thread::spawn(move || read(output, &to_read));
        }
        if let Some(errors) = child.stderr.take() {
            let tail = tail.clone();
            thread::spawn(move || keep(errors, &tail));
        }
        let mut process = Process {
            child,
            requests: Some(requests),
            at_once,
            lines,
            tail,
            answered: false,
        };
        let mut hello = None;
        let [_, seconds] = program.timeouts;
        let told = process.wait(seconds, &mut |line| {
            hello = Hello::parse(line);
            hello.is_some()
        });
        let why = match (told, hello) {
            (Ok(()), Some(Ok(hello))) => return Ok((process, hello)),
            (Ok(()), Some(Err(why))) => why,
            (Ok(()), None) => "no first line".into(),
            (Err(Silent::Late), _) => format!("no first line within {seconds} s"),
            (Err(Silent::Ended), _) => process.ended("before its first line"),
        };
        Err(format!("{shown}: {}", process.with_tail(&why)))
    }

    /// Sends a request, and reads lines until one is the answer.
    ///
    /// # Errors
    /// There is none in its time. The process is of no use any more.
    pub(super) fn ask(
        &mut self,
        mut request: Vec<u8>,
        seconds: f64,
        is_answer: &mut dyn FnMut(&str) -> bool,
    ) -> Result<(), String> {
        request.push(b'\n');
        // Where its input is closed, it has ended, which the lines tell.
        let write = |input: &mut File| input.write(&request).unwrap_or(0);
        let taken = self.at_once.as_mut().map_or(0, write);
        if taken < request.len() {
            self.at_once = None;
            let rest = request.split_off(taken);
            let _ = self.requests.as_ref().map(|requests| requests.send(rest));
        }
        let why = match self.wait(seconds, is_answer) {
            Ok(()) => {
                self.answered = true;
                return Ok(());
            }
            Err(Silent::Late) => format!("no answer within {seconds} s"),
            Err(Silent::Ended) => self.ended("without an answer"),
        };
        Err(self.with_tail(&why))
    }

    /// Reads lines until one is wanted; the others are kept for messages.
    fn wait(&self, seconds: f64, wanted: &mut dyn FnMut(&str) -> bool) -> Result<(), Silent> {
        let start = Instant::now();
        let limit = Duration::try_from_secs_f64(seconds).unwrap_or(Duration::MAX);
        loop {
            let left = limit.checked_sub(start.elapsed()).ok_or(Silent::Late)?;
            match self.lines.recv_timeout(left) {
                Ok(line) if wanted(&line) => return Ok(()),
                Ok(line) => push(&self.tail, line),
                Err(RecvTimeoutError::Timeout) => return Err(Silent::Late),
                Err(RecvTimeoutError::Disconnected) => return Err(Silent::Ended),
            }
        }
    }

    /// That the program has ended, and how.
    fn ended(&mut self, when: &str) -> String {
        let status = self.status(GRACE);
        match status {
            Some(status) => format!("it ended {when} ({status})"),
            None => format!("it closed its output {when}"),
        }
    }

    /// How it ended, if it does in this time.
    fn status(&mut self, within: Duration) -> Option<std::process::ExitStatus> {
        let start = Instant::now();
        loop {
            if let Ok(Some(status)) = self.child.try_wait() {
                return Some(status);
            }
            if start.elapsed() > within {
                return None;
            }
            thread::sleep(LOOK);
        }
    }

    /// A message with the last lines of the program.
    fn with_tail(&self, why: &str) -> String {
        let tail = self.tail.lock().unwrap_or_else(PoisonError::into_inner);
        let lines: Vec<&str> = tail.iter().map(String::as_str).collect();
        match lines.is_empty() {
            true => why.to_owned(),
            false => format!("{why}; its last lines: {}", lines.join(" | ")),
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        (self.requests, self.at_once) = (None, None);
        // One that answered ends by itself; any other may be stuck.
        let grace = if self.answered { GRACE } else { Duration::ZERO };
        if self.status(grace).is_none() {
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
    }
}

/// The input of a program once more, which refuses what it cannot take at once: Linux opens a pipe by its number as another file.
#[cfg(all(
    target_os = "linux",
    any(target_arch = "x86_64", target_arch = "aarch64")
))]
fn at_once(input: &ChildStdin) -> Option<File> {
    use std::os::fd::AsRawFd;
    use std::os::unix::fs::OpenOptionsExt;
    const O_NONBLOCK: i32 = 0o4000;
    File::options()
        .write(true)
        .custom_flags(O_NONBLOCK)
        .open(format!("/proc/self/fd/{}", input.as_raw_fd()))
        .ok()
}

#[cfg(not(all(
    target_os = "linux",
    any(target_arch = "x86_64", target_arch = "aarch64")
)))]
fn at_once(_: &ChildStdin) -> Option<File> {
    None
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

/// Reads lines until the end.
fn read(output: impl Read, lines: &SyncSender<String>) {
    let mut reader = BufReader::with_capacity(1 << 16, output);
    let mut length = 0;
    loop {
        // Most answers are as long as the one before.
        let mut bytes = Vec::with_capacity(length);
        match reader.by_ref().take(LONGEST).read_until(b'\n', &mut bytes) {
            Ok(1..) => {}
            Ok(0) | Err(_) => return,
        }
        length = bytes.len();
        // A copy of a long answer is only made of one with other bytes.
        let line = String::from_utf8(bytes)
            .unwrap_or_else(|broken| String::from_utf8_lossy(broken.as_bytes()).into_owned());
        if lines.send(line).is_err() {
            return;
        }
    }
}

/// Keeps the last lines.
fn keep(errors: impl Read, tail: &Tail) {
    let mut reader = BufReader::new(errors);
    loop {
        let mut bytes = Vec::new();
        match reader.by_ref().take(1 << 16).read_until(b'\n', &mut bytes) {
            Ok(1..) => push(tail, String::from_utf8_lossy(&bytes).into_owned()),
            Ok(0) | Err(_) => return,
        }
    }
}

fn push(tail: &Tail, line: String) {
    let plain = |c: char| if c.is_control() { ' ' } else { c };
    let shown: String = line.trim().chars().map(plain).take(WIDTH).collect();
    if shown.is_empty() {
        return;
    }
    let mut tail = tail.lock().unwrap_or_else(PoisonError::into_inner);
    tail.push_back(shown);
    if tail.len() > QUOTED {
        tail.pop_front();
    }
}
