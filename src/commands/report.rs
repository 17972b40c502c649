//! `slipgap report`: one page about studies that needs nothing beside it.

use super::claims;
use super::drawn;
use super::progress::{self, Tally};
use super::sources::Source;
use super::{note, say};
use indicatif::ProgressBar;
use slipgap::batch::output::Folder;
use slipgap::batch::store::Store;
use slipgap::batch::{self, Outcome, Wishes};
use slipgap::checks::{self, Verdict};
use slipgap::claims::compute;
use slipgap::error::Error;
use slipgap::figures;
use slipgap::report::{MOST_ROWS, Section, Settled, page};
use std::path::{Path, PathBuf};

/// Name of the page.
const PAGE: &str = "report.html";

/// Where the ledgers of claims are looked for.
const LEDGERS: &str = "claims";

/// Runs the studies, by the stores in `out`, and writes the page there; gives the exit code.
pub fn report(sources: &[Source], out: &Path) -> Result<u8, Error> {
    let mut folder = Folder::open(out)?;
    let mut settled = settled(sources)?;
    let mut sections = Vec::new();
    for (i, source) in sources.iter().enumerate() {
        let claims = std::mem::take(&mut settled[i]);
        sections.push(section(source, i, out, claims)?);
    }
    let path = folder.write(PAGE, page(&sections).as_bytes())?;
    say(&format!("{}\n", path.display()))
}

fn section<'a>(
    source: &'a Source,
    place: usize,
    out: &Path,
    claims: Vec<Settled>,
) -> Result<Section<'a>, Error> {
    let study = &source.study;
    let text =
        std::fs::read_to_string(&source.file).map_err(Error::io("cannot read", &source.file))?;
    let store = Store::open(&out.join(&source.name))?;
    let bar = progress::bar(&source.name, study.len());
    let wishes = Wishes {
        store: Some(&store),
        keep: &|case| drawn::over_time(study, case),
        ..Wishes::METRICS
    };
    let mut tally = Tally::new(store.is_empty());
    let (mut verdicts, mut shown): (Vec<(usize, Verdict)>, Vec<Outcome>) = Default::default();
    let (mut outcomes, mut cases) = (Vec::new(), 0);
    batch::run(study, &bar, &wishes, |done| {
        tally.add(&done);
        for (number, outcome) in done.outcomes(study.problem) {
            cases += 1;
            checks::judge(study, number, &outcome, &mut verdicts);
            if outcomes.len() < MOST_ROWS {
                let solution = None;
                outcomes.push((
                    number,
                    Outcome {
                        solution,
                        ..outcome.clone()
                    },
                ));
            }
            if drawn::anywhere(study, &outcome.case) {
                shown.push(outcome);
            }
        }
        Ok(())
    })?;
    progress::finish(&bar, &source.name, &tally.told(cases));
    store.close()?;
    verdicts.sort_by_key(|(check, verdict)| (*check, verdict.case));
    let mut drawings = Vec::new();
    drawn::solve(study, &mut shown);
    for (k, figure) in study.figures.iter().enumerate() {
        let prefix = format!("s{place}f{k}-");
        let svg = drawn::with_shown(study, figure, &shown, |cases| {
            let sheet = figures::sheet(study, figure, cases);
            let svg = figures::svg(&sheet)?;
            Ok(figures::with_hover(
                study, figure, cases, &sheet, &svg, &prefix,
            ))
        })?;
        drawings.push((figure.name.clone(), svg));
    }
    Ok(Section {
        name: &source.name,
        file: source.file.display().to_string(),
        text,
        study,
        figures: drawings,
        outcomes,
        cases,
        verdicts: verdicts.into_iter().map(|(_, verdict)| verdict).collect(),
        claims,
    })
}

/// For each study the claims that it settles, computed now; none where there are no ledgers.
fn settled(sources: &[Source]) -> Result<Vec<Vec<Settled>>, Error> {
    let mut settled: Vec<Vec<Settled>> = sources.iter().map(|_| Vec::new()).collect();
    if !Path::new(LEDGERS).is_dir() {
        return Ok(settled);
    }
    let same = |a: &Path, b: &Path| {
        a.canonicalize()
            .ok()
            .is_some_and(|a| b.canonicalize().ok() == Some(a))
    };
    for ledger in claims::read(&[PathBuf::from(LEDGERS)])? {
        let place = |study: usize| {
            let file = &ledger.studies[study].file;
            sources.iter().position(|source| same(&source.file, file))
        };
        if (0..ledger.studies.len()).all(|study| place(study).is_none()) {
            continue;
        }
        let findings = compute(&ledger, &ProgressBar::hidden())?;
        note(&format!("{}: judged", ledger.paper));
        for (claim, findings) in ledger.claims.iter().zip(findings) {
            for (reading, finding) in claim.readings.iter().zip(findings) {
                if let Some(place) = place(reading.study) {
                    settled[place].push(Settled {
                        id: claim.id.clone(),
                        says: claim.says.clone(),
                        reading: reading.name.clone(),
                        found: finding.found.join("; "),
                        holds: finding.holds,
                    });
                }
            }
        }
    }
    Ok(settled)
}
