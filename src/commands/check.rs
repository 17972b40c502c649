//! `slipgap check`: every check of every study, with the value it judged.

use super::sources::Source;
use super::{NOT_MET, UNSOLVED, columns, note, progress, run, say};
use slipgap::batch::{self, Wishes};
use slipgap::checks::{self, Verdict};
use slipgap::error::Error;
use slipgap::problem::parameter::shortest;

/// Runs the studies without writing anything and prints the verdicts; gives the exit code.
pub fn check(sources: &[Source]) -> Result<u8, Error> {
    let mut rows = vec![
        ["study", "case", "metric", "value", "limits", "verdict"]
            .map(String::from)
            .to_vec(),
    ];
    let (mut code, mut count, mut failed) = (0, 0, 0);
    for source in sources {
        let bar = progress::bar(&source.name, source.study.len());
        let (mut verdicts, mut unsolved) = (Vec::new(), Vec::new());
        batch::run(&source.study, &bar, &Wishes::METRICS, |done| {
            for (number, outcome) in done.outcomes(source.study.problem) {
                checks::judge(&source.study, number, &outcome, &mut verdicts);
                if outcome.failure.is_some() {
                    unsolved.push((number, outcome));
                }
            }
            Ok(())
        })?;
        progress::finish(&bar, &source.name, &progress::run(source.study.len()));
        if !unsolved.is_empty() {
            run::name_unsolved(source, &unsolved);
            code = UNSOLVED;
        }
        // By check, then by case.
        verdicts.sort_by_key(|(check, verdict)| (*check, verdict.case));
        for (_, verdict) in verdicts {
            count += 1;
            failed += usize::from(!verdict.holds());
            rows.push(row(&source.name, &verdict));
        }
    }
    say(&columns(&rows))?;
    note(&format!("{count} checks, {failed} not met"));
    // A case without a solution outweighs a check without a value.
    Ok(if code == 0 && failed > 0 {
        NOT_MET
    } else {
        code
    })
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
