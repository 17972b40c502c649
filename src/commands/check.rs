//! `slipgap check`: every check of every study, with the value it judged.

use super::sources::Source;
use super::unsolved::Unsolved;
use super::{NOT_MET, UNSOLVED, lines, note, progress, say_all};
use slipgap::batch::{self, Wishes};
use slipgap::checks::{self, Verdict};
use slipgap::error::Error;
use slipgap::problem::parameter::shortest;

/// What the checks of a study judged, check by check: cases and values, not a number where one is undefined. Lines are
/// made of it one by one: of a million they would take half a gigabyte.
struct Judged<'a> {
    source: &'a Source,
    values: Vec<Vec<(u64, f64)>>,
}

/// Runs the studies without writing anything and prints the verdicts; gives the exit code.
pub fn check(sources: &[Source]) -> Result<u8, Error> {
    let (mut all, mut solved) = (Vec::new(), true);
    for source in sources {
        let (judged, every) = judged(source)?;
        all.push(judged);
        solved &= every;
    }
    let header = ["study", "case", "metric", "value", "limits", "verdict"];
    say_all(lines(|| {
        let rows = all.iter().flat_map(|judged| {
            let name = &judged.source.name;
            judged.verdicts().map(move |verdict| row(name, &verdict))
        });
        std::iter::once(header.map(String::from).to_vec()).chain(rows)
    }))?;
    let verdicts = || all.iter().flat_map(Judged::verdicts);
    let failed = verdicts().filter(|verdict| !verdict.holds()).count();
    note(&format!("{} checks, {failed} not met", verdicts().count()));
    // A case without a solution outweighs a check without a value.
    Ok(match (solved, failed) {
        (false, _) => UNSOLVED,
        (true, 0) => 0,
        (true, _) => NOT_MET,
    })
}

/// Runs one study; what its checks judged, and whether every case was solved.
fn judged(source: &Source) -> Result<(Judged<'_>, bool), Error> {
    let study = &source.study;
    let bar = progress::bar(&source.name, study.len());
    let mut values = vec![Vec::new(); study.checks.len()];
    let mut unsolved = Unsolved::new(source);
    batch::run(study, &bar, &Wishes::METRICS, |done| {
        let mut shown = done.cases.shown();
        for (place, number) in (0..done.len()).zip(done.first..) {
            let value = |metric| done.found.row(place).nth(metric).flatten();
            for (check, value) in checks::applicable(study, shown.at(place), value) {
                values[check].push((number, value.unwrap_or(f64::NAN)));
            }
            if let Some(why) = done.found.failure(place) {
                unsolved.add(number, &why.to_string());
            }
        }
        Ok(())
    })?;
    progress::finish(&bar, &source.name, &progress::run(study.len()));
    unsolved.tell();
    Ok((Judged { source, values }, unsolved.is_empty()))
}

impl Judged<'_> {
    /// By check, then by case.
    fn verdicts(&self) -> impl Iterator<Item = Verdict> {
        let study = &self.source.study;
        self.values
            .iter()
            .enumerate()
            .flat_map(move |(check, values)| {
                values.iter().map(move |(case, x)| {
                    checks::verdict(study, check, *case, Some(*x).filter(|x| !x.is_nan()))
                })
            })
    }
}

fn row(name: &str, verdict: &Verdict) -> Vec<String> {
    vec![
        name.to_owned(),
        verdict.case.to_string(),
        verdict.metric.to_owned(),
        verdict.value.map_or("undefined".into(), shortest),
        verdict.limits(),
        if verdict.holds() { "ok" } else { "NOT MET" }.to_owned(),
    ]
}
