//! How many cases of a shard are done, and how long the others take.

use super::outline::KnownPart;
use crate::files::heartbeat::{Computed, DEAD, Sign};
use std::time::{Duration, SystemTime};

/// How far a shard is, or all shards together.
#[derive(Debug, Default)]
pub struct Progress {
    /// Number of its cases.
    pub cases: u64,
    /// Number of these in the store.
    pub done: u64,
    /// Number of these that could not be solved.
    pub failed: u64,
    /// Number of processes that compute it.
    pub running: u64,
    /// Cases a second, of the processes that compute it.
    pub rate: Option<f64>,
    /// Seconds until it is done, at the rate of these processes.
    pub left: Option<f64>,
    /// Seconds since the last sign of a process, or since the last part was saved.
    pub quiet: Option<f64>,
    /// When that was.
    pub(super) latest: Option<SystemTime>,
    /// Steps times modes of cases that are not in the store.
    work_left: f64,
    signs: Vec<(SystemTime, Option<Computed>)>,
}

/// What a shard does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum State {
    /// All its cases are in the store.
    Done,
    /// A process gave a sign a short time ago.
    Running,
    /// No process computes it any more.
    Stopped,
    /// There is no part of it and no sign.
    NotBegun,
}

impl Progress {
    /// What it does.
    pub fn state(&self) -> State {
        match (self.quiet, self.running) {
            _ if self.done == self.cases => State::Done,
            (_, 1..) => State::Running,
            (Some(_), 0) => State::Stopped,
            (None, 0) => State::NotBegun,
        }
    }

    /// Adds the sign of a process.
    pub(super) fn sign(&mut self, sign: &Sign) {
        self.latest = self.latest.max(Some(sign.written));
        self.signs.push((sign.written, sign.computed));
    }

    /// Adds a part, which may be in the store.
    pub(super) fn part(&mut self, part: &KnownPart) {
        self.cases += part.cases;
        let Ok(found) = &part.found else {
            self.work_left += part.work;
            return;
        };
        self.done += part.cases;
        self.failed += found.failed;
        // A time ahead of all clocks is none.
        let known = found
            .saved
            .filter(|saved| *saved <= SystemTime::now() + DEAD);
        self.latest = self.latest.max(known);
    }

    /// The rate and the time left, after all signs and parts.
    pub(super) fn finish(&mut self, now: SystemTime) {
        let age = |time: SystemTime| now.duration_since(time).unwrap_or(Duration::ZERO);
        self.quiet = self.latest.map(|latest| age(latest).as_secs_f64());
        if self.done == self.cases {
            return;
        }
        let running = self.signs.iter().filter(|sign| age(sign.0) <= DEAD);
        let (mut cases, mut work) = (0.0, 0.0);
        for (_, computed) in running {
            self.running += 1;
            if let Some(computed) = computed.filter(|computed| computed.seconds > 0.0) {
                cases += computed.cases as f64 / computed.seconds;
                work += computed.work / computed.seconds;
            }
        }
        self.rate = Some(cases).filter(|cases| *cases > 0.0);
        self.left = Some(self.work_left / work).filter(|_| work > 0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::super::outline::Found;
    use super::*;
    use crate::store::Miss;

    fn part(cases: u64, work: f64, found: Option<(u64, Option<SystemTime>)>) -> KnownPart {
        let found = found.map(|(failed, saved)| Found { failed, saved });
        KnownPart {
            cases,
            work,
            found: found.ok_or(Miss::Absent),
        }
    }

    fn at(seconds: u64) -> SystemTime {
        SystemTime::UNIX_EPOCH + Duration::from_secs(seconds)
    }

    /// After 100 s: 600 of 1000 cases done, the last at second 80, and a sign at this second.
    fn with_sign_at(second: u64) -> Progress {
        let mut progress = Progress::default();
        progress.part(&part(600, 6000.0, Some((2, Some(at(80))))));
        progress.part(&part(400, 8000.0, None));
        let computed = Some(Computed {
            seconds: 50.0,
            cases: 500,
            work: 4000.0,
        });
        progress.sign(&Sign {
            shard: None,
            written: at(second),
            computed,
        });
        progress.finish(at(100));
        progress
    }

    #[test]
    fn the_time_left_is_that_of_the_work_left_not_of_the_cases() {
        let progress = with_sign_at(99);
        assert_eq!(progress.state(), State::Running);
        assert_eq!(
            (progress.cases, progress.done, progress.failed),
            (1000, 600, 2)
        );
        // 500 cases in 50 s; 8000 of work left at 80 a second.
        assert_eq!((progress.rate, progress.left), (Some(10.0), Some(100.0)));
        assert_eq!(progress.quiet, Some(1.0));
    }

    #[test]
    fn a_sign_that_is_old_is_of_a_process_that_was_killed() {
        for (second, state) in [
            (120, State::Running),
            (70, State::Running),
            (69, State::Stopped),
        ] {
            let progress = with_sign_at(second);
            assert_eq!(progress.state(), state, "{second}");
            let running = state == State::Running;
            assert_eq!(progress.rate.is_some(), running);
            assert_eq!(progress.left.is_some(), running);
        }
        // A part is younger than the sign.
        assert_eq!(with_sign_at(10).quiet, Some(20.0));
        // A sign of the future: the clock of its machine is ahead.
        assert_eq!(with_sign_at(120).quiet, Some(0.0));
    }

    #[test]
    fn a_shard_without_parts_and_signs_has_not_begun_or_is_done() {
        let mut progress = Progress::default();
        assert_eq!(progress.state(), State::Done);
        progress.part(&part(3, 9.0, None));
        progress.finish(at(100));
        assert_eq!(progress.state(), State::NotBegun);
        let mut progress = Progress::default();
        progress.part(&part(3, 9.0, Some((0, None))));
        progress.finish(at(100));
        assert_eq!(progress.state(), State::Done);
    }
}
