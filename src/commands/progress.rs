//! How far a run is, and what it came to.

use super::note;
use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use slipgap::batch::Done;
use slipgap::batch::cost;
use slipgap::batch::pace::Pace;
use slipgap::study::Study;
use std::fmt::Write;
use std::io::{IsTerminal, stderr};
use std::sync::Arc;
use std::time::Duration;

/// Most reasons that one line gives.
const MOST_REASONS: usize = 3;

/// Time between two pictures of a spinner.
const TICK: Duration = Duration::from_millis(100);

/// A progress bar with rate and time left for a terminal, nothing otherwise.
pub fn bar(name: &str, cases: u64) -> ProgressBar {
    if !stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template(
        "{prefix} {wide_bar} {human_pos}/{human_len} cases, {per_sec}, {eta} left",
    )
    .unwrap_or_else(|_| ProgressStyle::default_bar());
    ProgressBar::new(cases)
        .with_style(style)
        .with_prefix(name.to_owned())
}

/// The same for a run with a store, and what takes the work done: the time left follows from the work that this run
/// computes, not from the cases that the store has.
pub fn with_store(name: &str, study: &Study) -> (ProgressBar, Arc<Pace>) {
    let bar = bar(name, study.len());
    if bar.is_hidden() {
        return (bar, Arc::new(Pace::new(0.0)));
    }
    let pace = Arc::new(Pace::new(cost::total(study)));
    let shown = pace.clone();
    let style = ProgressStyle::with_template(
        "{prefix} {wide_bar} {human_pos}/{human_len} cases, {time} left",
    )
    .unwrap_or_else(|_| ProgressStyle::default_bar())
    .with_key("time", move |_: &ProgressState, out: &mut dyn Write| {
        let left = shown.left();
        let _ = out.write_str(&left.map_or("?".into(), |left| time(left.as_secs_f64())));
    });
    (bar.with_style(style), pace)
}

/// Some time for people, in two digits or so.
pub fn time(seconds: f64) -> String {
    match seconds {
        _ if seconds < 0.1 => "less than 0.1 s".into(),
        _ if seconds < 10.0 => format!("{seconds:.1} s"),
        _ if seconds < 120.0 => format!("{seconds:.0} s"),
        _ if seconds < 2.0 * 3600.0 => format!("{:.0} min", seconds / 60.0),
        _ if seconds < 48.0 * 3600.0 => format!("{:.0} h", seconds / 3600.0),
        _ => format!("{:.0} days", seconds / 86_400.0),
    }
}

/// A bar of so many steps for what takes long after the last case; where no terminal shows it, a line says what is done.
pub fn steps(name: &str, what: &str, steps: usize, long: bool) -> ProgressBar {
    if !stderr().is_terminal() {
        if long {
            note(&format!("{name}: {what}"));
        }
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{prefix} {spinner} {msg} {wide_bar} {pos}/{len}")
        .unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar = ProgressBar::new(steps as u64)
        .with_style(style)
        .with_prefix(name.to_owned())
        .with_message(what.to_owned());
    // A step may take many seconds: the spinner shows that the program is at work.
    bar.enable_steady_tick(TICK);
    bar
}

/// Takes the bar away and says in one plain line what is done.
pub fn finish(bar: &ProgressBar, name: &str, told: &str) {
    bar.finish_and_clear();
    note(&format!("{name}: {told}"));
}

/// So many cases were run.
pub fn run(cases: u64) -> String {
    match cases {
        1 => "1 case run".into(),
        _ => format!("{cases} cases run"),
    }
}

/// How many cases came from the store, and why the others did not.
#[derive(Debug)]
pub struct Tally {
    /// Whether there was no store to find anything in.
    new: bool,
    kept: u64,
    /// Reasons, with the number of parts that had them.
    reasons: Vec<(String, u64)>,
}

impl Tally {
    /// Nothing yet.
    pub fn new(new: bool) -> Tally {
        Tally {
            new,
            kept: 0,
            reasons: Vec::new(),
        }
    }

    /// Counts a part.
    pub fn add(&mut self, done: &Done) {
        self.kept += done.from_store;
        let why = match &done.kept {
            Ok(()) => return,
            Err(None) => "not in the store yet".to_owned(),
            Err(Some(why)) => why.clone(),
        };
        match self.reasons.iter_mut().find(|(reason, _)| *reason == why) {
            Some((_, count)) => *count += 1,
            None => self.reasons.push((why, 1)),
        }
    }

    /// In one line.
    pub fn told(&self, cases: u64) -> String {
        if self.kept == cases {
            return format!("{cases} of {cases} cases from the store");
        }
        if self.new {
            return run(cases);
        }
        let told = |(reason, count): &(String, u64)| match count {
            1 => reason.clone(),
            _ => format!("{reason} ({count} parts)"),
        };
        let mut reasons: Vec<String> = self.reasons.iter().take(MOST_REASONS).map(told).collect();
        if self.reasons.len() > MOST_REASONS {
            reasons.push(format!(
                "{} more reasons",
                self.reasons.len() - MOST_REASONS
            ));
        }
        let run = run(cases - self.kept);
        let kept = match self.kept {
            0 => String::new(),
            kept => format!("{kept} of {cases} cases from the store, "),
        };
        format!("{kept}{run}: {}", reasons.join(", "))
    }
}
