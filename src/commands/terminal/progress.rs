//! Progress bars, and lines about finished work.

use super::duration::duration;
use super::note;
use super::studies::Estimate;
use crate::batch::solve::cost;
use crate::batch::solve::work_progress::WorkProgress;
use crate::study::{Study, choosing};
use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::io::{IsTerminal, stderr};
use std::sync::Arc;
use std::time::Duration;

/// Time between two frames of a spinner.
const TICK: Duration = Duration::from_millis(100);

/// Draws the bar now, then at each tick. The thread of the ticks alone may start after short work has ended.
fn show(bar: &ProgressBar) {
    bar.tick();
    bar.enable_steady_tick(TICK);
}

/// A progress bar with rate and time left on a terminal, else a hidden one. It is there before the first cases are finished.
pub fn bar(name: &str, cases: u64) -> ProgressBar {
    let bar = bar_of_cases(name, cases);
    show(&bar);
    bar
}

fn bar_of_cases(name: &str, cases: u64) -> ProgressBar {
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

/// A spinner while the studies of a command are read, which may select records; hidden without a terminal.
pub fn reading() -> ProgressBar {
    let hidden = !stderr().is_terminal();
    let bar = match hidden {
        true => ProgressBar::hidden(),
        false => ProgressBar::new_spinner().with_style(style_of_reading()),
    };
    show(&bar);
    bar
}

/// What is read now, at each tick.
fn style_of_reading() -> ProgressStyle {
    let what = |_: &ProgressState, out: &mut dyn Write| {
        let _ = match choosing() {
            Some([done, of]) => write!(out, "choosing records {done}/{of}"),
            None => write!(out, "reading studies"),
        };
    };
    ProgressStyle::with_template("{spinner} {what}")
        .unwrap_or_else(|_| ProgressStyle::default_spinner())
        .with_key("what", what)
}

/// A counter of cases, for work of which the number of cases is not known before; hidden without a terminal.
pub fn counter(name: &str) -> ProgressBar {
    if !stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{prefix} {spinner} {human_pos} cases, {per_sec}")
        .unwrap_or_else(|_| ProgressStyle::default_spinner());
    let bar = ProgressBar::no_length()
        .with_style(style)
        .with_prefix(name.to_owned());
    show(&bar);
    bar
}

/// The progress bar of a run with a store, and the counter of its work. The time left is computed from the work of this
/// run, without the cases from the store; `all` is the estimate of all studies, and the outputs of this one.
pub fn bar_with_store(
    name: &str,
    study: &Study,
    of_studies: Option<(Estimate, usize)>,
) -> (ProgressBar, Arc<WorkProgress>) {
    let bar = bar_of_cases(name, study.len());
    if bar.is_hidden() {
        return (bar, Arc::new(WorkProgress::new(0.0)));
    }
    let work = Arc::new(WorkProgress::new(cost::total(study)));
    let shown = work.clone();
    let time_left = move |_: &ProgressState, out: &mut dyn Write| {
        let left = shown.time_left();
        let time_left = left.map_or("?".into(), |left| duration(left.as_secs_f64()));
        let _ = match &of_studies {
            None => write!(out, "{time_left} left"),
            Some((estimate, outputs)) => {
                write!(
                    out,
                    "{time_left} left, all {}",
                    estimate.text(left, *outputs)
                )
            }
        };
    };
    let style = ProgressStyle::with_template(
        "{prefix} {wide_bar} {human_pos}/{human_len} cases, {time_left}",
    )
    .unwrap_or_else(|_| ProgressStyle::default_bar())
    .with_key("time_left", time_left);
    let bar = bar.with_style(style);
    show(&bar);
    (bar, work)
}

/// The progress bar of the figures of a study; hidden without a terminal. `all` is the estimate of all studies.
pub fn figures(name: &str, figures: usize, estimate: Option<Estimate>) -> ProgressBar {
    if figures == 0 || !stderr().is_terminal() {
        return ProgressBar::hidden();
    }
    let time_left = move |state: &ProgressState, out: &mut dyn Write| {
        let drawn = usize::try_from(state.pos()).unwrap_or(figures);
        let left = estimate
            .as_ref()
            .map(|estimate| estimate.text(Some(Duration::ZERO), figures.saturating_sub(drawn)));
        let _ = write!(
            out,
            "{}",
            left.map_or(String::new(), |left| format!(", all {left}"))
        );
    };
    let style = ProgressStyle::with_template("{prefix} {wide_bar} {pos}/{len} figures{time_left}")
        .unwrap_or_else(|_| ProgressStyle::default_bar())
        .with_key("time_left", time_left);
    ProgressBar::new(figures as u64)
        .with_style(style)
        .with_prefix(name.to_owned())
}

/// A progress bar for work after the last case. Without a terminal it is hidden, and a line names the work if it is long.
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
    // A step may take many seconds. The spinner shows that the program runs.
    show(&bar);
    bar
}

/// Removes the bar and writes one line about the finished work.
pub fn finish(bar: &ProgressBar, name: &str, summary: &str) {
    bar.finish_and_clear();
    note(&format!("{name}: {summary}"));
}
