//! A process of a program: a line to its standard input, a line from its standard output, and what it says besides. After its time it is
//! ended.

use super::pipes::{Pipes, Silent};
use slipgap_problem::problem::structure::programs::{Hello, Program};
use std::io;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// Time that a program has to end after the end of its input.
const GRACE: Duration = Duration::from_secs(2);

/// How often it is looked whether it has ended.
const LOOK: Duration = Duration::from_millis(5);

/// How often it is looked whether a silent program has ended: a process that it started may keep its output open.
const LOOK_AT_SILENT: Duration = Duration::from_millis(500);

/// A running program.
#[derive(Debug)]
pub(super) struct Process {
    child: Child,
    pipes: Pipes,
    /// Whether it has answered a request.
    pub answered: bool,
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
        let pipes = Pipes::of(&mut child);
        let mut process = Process {
            child,
            pipes,
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
        Err(format!("{shown}: {}", process.pipes.with_tail(&why)))
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
        self.pipes.send(request);
        let why = match self.wait(seconds, is_answer) {
            Ok(()) => {
                self.answered = true;
                return Ok(());
            }
            Err(Silent::Late) => format!("no answer within {seconds} s"),
            Err(Silent::Ended) => self.ended("without an answer"),
        };
        Err(self.pipes.with_tail(&why))
    }

    /// Reads lines until one is wanted; the others are kept for messages.
    fn wait(&mut self, seconds: f64, wanted: &mut dyn FnMut(&str) -> bool) -> Result<(), Silent> {
        let limit = Duration::try_from_secs_f64(seconds).ok();
        let until = limit.and_then(|limit| Instant::now().checked_add(limit));
        let mut has_ended = false;
        loop {
            let look = Instant::now() + LOOK_AT_SILENT;
            let soon = until.map_or(look, |until| until.min(look));
            let line = match self.pipes.line(soon) {
                Ok(line) => line,
                Err(Silent::Late) if has_ended => return Err(Silent::Ended),
                Err(Silent::Late) if Some(soon) != until => {
                    has_ended = matches!(self.child.try_wait(), Ok(Some(_)));
                    continue;
                }
                Err(silent) => return Err(silent),
            };
            if wanted(&line) {
                return Ok(());
            }
            let other = line.into_owned();
            self.pipes.keep(&other);
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

    /// How it ended, if it does in this time. What it still writes is kept for messages.
    fn status(&mut self, within: Duration) -> Option<ExitStatus> {
        let start = Instant::now();
        loop {
            let turn = Instant::now();
            self.pipes.keep_rest(LOOK);
            if let Ok(Some(status)) = self.child.try_wait() {
                self.pipes.keep_rest(LOOK);
                return Some(status);
            }
            if start.elapsed() > within {
                return None;
            }
            thread::sleep(LOOK.saturating_sub(turn.elapsed()));
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        self.pipes.end_input();
        // One that answered ends by itself; any other may be stuck.
        let grace = if self.answered { GRACE } else { Duration::ZERO };
        if self.status(grace).is_none() {
            let _ = self.child.kill();
            let _ = self.child.wait();
        }
    }
}
