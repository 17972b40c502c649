//! `slipgap report`: one page about studies that needs nothing beside it.

use super::claims;
use super::drawn;
use super::progress::{self, Tally};
use super::run::{self, Manner};
use super::sources::Source;
use super::{note, say};
use indicatif::ProgressBar;
use slipgap::batch::output::{self, Folder};
use slipgap::batch::sobol::Gathered;
use slipgap::batch::store::Store;
use slipgap::batch::{self, Wishes};
use slipgap::claims::compute;
use slipgap::error::Error;
use slipgap::figures::style;
use slipgap::report::{
    self, Checks, Counts, Drawing, Indices, MOST_BYTES, Results, Section, Settled,
};
use std::path::{Path, PathBuf};

/// Name of the page.
const PAGE: &str = "report.html";

/// Where the ledgers of claims are looked for.
const LEDGERS: &str = "claims";

/// Runs the studies, by the stores in `out`, and writes the page there; gives the exit code.
pub fn report(sources: &[Source], out: &Path) -> Result<u8, Error> {
    let folder = Folder::open(out)?;
    let mut settled = settled(sources)?;
    let mut sections = Vec::new();
    let mut left = MOST_BYTES;
    for (i, source) in sources.iter().enumerate() {
        let claims = std::mem::take(&mut settled[i]);
        let section = section(source, i, out, left, claims)?;
        left = left.saturating_sub(section.results.bytes());
        sections.push(section);
    }
    let path = folder.put(PAGE, |file| report::write(file, &sections))?;
    say(&format!("{}\n", path.display()))
}

fn section<'a>(
    source: &'a Source,
    place: usize,
    out: &Path,
    most: usize,
    claims: Vec<Settled>,
) -> Result<Section<'a>, Error> {
    let study = &source.study;
    let results = out.join(&source.name);
    bring_up_to_date(source, out, &results)?;
    // Reports of one study at the same time take turns.
    let store = Store::open_in_turn(&results)?;
    let (bar, pace) = progress::with_store(&source.name, study);
    let wishes = Wishes {
        store: Some(&store),
        keep: &|case| drawn::over_time(study, case),
        pace: Some(&*pace),
        ..Wishes::METRICS
    };
    let mut tally = Tally::new(store.is_empty());
    let mut results = Results::new(study, store.folder().to_owned(), most);
    let (mut counts, mut checks) = (Counts::new(study), Checks::default());
    let mut shown = Vec::new();
    let mut designs = Gathered::new(study);
    batch::run(study, &bar, &wishes, |done| {
        tally.add(&done);
        designs.add(&done);
        for (number, outcome) in done.outcomes(study) {
            results.add(&outcome);
            counts.add(number, &outcome);
            checks.judge(study, number, &outcome);
            if drawn::anywhere(study, &outcome.case) {
                shown.push(outcome);
            }
        }
        Ok(())
    })?;
    progress::finish(&bar, &source.name, &tally.told(results.cases()));
    store.close()?;
    let indices = super::run::indices(source, &designs)?;
    let mut drawings = Vec::new();
    drawn::solve(study, &mut shown);
    for (k, figure) in study.figures.iter().enumerate() {
        let prefix = format!("s{place}f{k}-");
        drawings.push(drawn::with_shown(study, figure, &shown, |cases| {
            Drawing::new(study, figure, cases, &prefix)
        })?);
    }
    Ok(Section {
        name: &source.name,
        file: source.origin(),
        text: source.text.clone(),
        study,
        figures: drawings,
        results,
        counts,
        indices: Indices::new(indices.as_deref().unwrap_or_default()),
        checks,
        claims,
    })
}

/// Runs a study whose results.csv is of an earlier form of it, so that its store and results.csv keep the same rows.
fn bring_up_to_date(source: &Source, out: &Path, results: &Path) -> Result<(), Error> {
    if !output::outdated(results, &source.study) {
        return Ok(());
    }
    note(&format!(
        "{}: the results are of an earlier version of the study; running it again",
        source.name
    ));
    let manner = Manner {
        histories: false,
        fail_fast: false,
        format: None,
        dpi: style::DPI,
    };
    // Cases without a solution are on the page.
    run::run(std::slice::from_ref(source), out, &manner).map(|_| ())
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
            // What the command line changes settles nothing.
            let own = |source: &Source| source.study.settings.is_empty();
            let mut sources = sources.iter();
            sources.position(|source| own(source) && same(&source.file, file))
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
                        says: claim.statement.clone(),
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
