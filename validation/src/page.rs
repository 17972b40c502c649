//! The ledgers as a page: a table of verdicts for each paper or subject, then every claim with its readings and numbers.

use super::ledger::{Claim, Ledger, Reading};
use super::{Finding, NEAR, Verdict};
use std::fmt::Write;

/// A ledger with the findings of each reading of each claim.
#[derive(Debug)]
pub struct Judged {
    /// The ledger.
    pub ledger: Ledger,
    /// Claim by claim, reading by reading.
    pub findings: Vec<Vec<Finding>>,
}

impl Judged {
    /// The claims with their findings.
    pub fn claims(&self) -> impl Iterator<Item = (&Claim, &[Finding])> {
        let findings = self.findings.iter().map(Vec::as_slice);
        self.ledger.claims.iter().zip(findings)
    }

    /// Every reading with its claim and its finding.
    fn readings(&self) -> impl Iterator<Item = (&Claim, &Reading, &Finding)> {
        self.claims().flat_map(|(claim, findings)| {
            let readings = claim.readings.iter().zip(findings);
            readings.map(move |(reading, finding)| (claim, reading, finding))
        })
    }

    /// Number of readings near a limit, and of readings that lack a reason or have one that is not needed.
    pub fn near(&self) -> (usize, usize) {
        let near = self.readings().filter(|(_, _, f)| !f.near.is_empty());
        let wrong = |(_, reading, finding): &(_, &Reading, &Finding)| {
            finding.near.is_empty() == reading.near.is_some()
        };
        (near.count(), self.readings().filter(wrong).count())
    }

    /// Number of claims with a reading whose result is not the recorded one.
    pub fn changed(&self) -> usize {
        let changed = |(claim, findings): &(&Claim, &[Finding])| {
            let mut readings = claim.readings.iter().zip(*findings);
            readings.any(|(reading, finding)| reading.holds != finding.holds)
        };
        self.claims().filter(changed).count()
    }
}

/// The page in Markdown; files of results that it names are in the output folder.
pub fn page(ledgers: &[Judged]) -> String {
    let mut page = String::from(
        "# The statements of the papers and of the literature, tested by computation\n\n\
         This page lists every statement of the two papers that a computation can test, and statements of the literature and of \
         practice on laws, methods and bridges that studies can decide, each with its place or source and in our words. A reading is one way to \
         understand a statement; each is tested by a study. `slipgap claims` computes the verdicts. If a statement fails \
         in a reading, the reason is below the table. If a statement has no number, the limit is our choice; it is in \
         brackets next to each value. A metric over that of other values is the quotient of two cases that are otherwise the \
         same. The last column has a file of the results that shows it. docs/errata.md checks simple arithmetic (f_n, Delta, T_I).\n",
    );
    for judged in ledgers {
        let _ = write!(page, "\n## {}\n\n", judged.ledger.paper);
        page.push_str("| | statement | verdict |\n| --- | --- | --- |\n");
        for (claim, findings) in judged.claims() {
            let mut verdict = verdict(findings).as_str().to_owned();
            if let Some(condition) = condition(claim, findings) {
                verdict += &format!(": {}", cell(&condition));
            }
            let id = &claim.id;
            let _ = writeln!(
                page,
                "| [{id}](#{}) | {} | {verdict} |",
                id.to_lowercase(),
                cell(&claim.statement),
            );
        }
        for (claim, findings) in judged.claims() {
            section(&mut page, &judged.ledger, claim, findings);
        }
    }
    near(&mut page, ledgers);
    page
}

/// The readings whose verdicts depend on the choice of a limit, each with the reason for the limit.
fn near(page: &mut String, ledgers: &[Judged]) {
    let percent = 100.0 * NEAR;
    let _ = write!(
        page,
        "\n## Verdicts near a limit\n\nA reading is listed here if its verdict changes when its limits move by {percent} % of half their range, or of \
         the limit if there is only one. Trends have no limit.\n\n| claim | reading | computed | why this limit |\n| --- | --- | --- | --- |\n"
    );
    for (claim, reading, finding) in ledgers.iter().flat_map(Judged::readings) {
        let reason = match (&reading.near, finding.near.is_empty()) {
            (None, true) => continue,
            (Some(reason), false) => cell(reason),
            (None, false) => "**no reason given**".into(),
            (Some(_), true) => {
                "**a reason is given, but the reading is not near its limit**".into()
            }
        };
        let id = &claim.id;
        let _ = writeln!(
            page,
            "| [{id}](#{}) | {} | {} | {reason} |",
            id.to_lowercase(),
            cell(&reading.name),
            cell(&finding.near.join("; "))
        );
    }
}

/// The readings in which a claim holds, if these are some of several.
pub fn condition(claim: &Claim, findings: &[Finding]) -> Option<String> {
    let readings = claim.readings.iter().zip(findings);
    let holding = readings.filter(|(_, finding)| finding.holds);
    let names: Vec<&str> = holding.map(|(reading, _)| &*reading.name).collect();
    (verdict(findings) == Verdict::HoldsIf).then(|| names.join("; "))
}

/// The verdict of a claim by its findings.
pub fn verdict(findings: &[Finding]) -> Verdict {
    Verdict::of(findings.iter().map(|finding| finding.holds))
}

fn section(page: &mut String, ledger: &Ledger, claim: &Claim, findings: &[Finding]) {
    let _ = write!(
        page,
        "\n### {}\n\n{}: {} {}\n\nThe test: {}.\n\n",
        claim.id,
        claim.place,
        claim.statement,
        match condition(claim, findings) {
            Some(condition) => format!("**Holds if:** {condition}."),
            None => format!("**{}**", capital(verdict(findings).as_str())),
        },
        claim.quantity
    );
    page.push_str("| reading | computed | holds | figure |\n| --- | --- | --- | --- |\n");
    for (reading, finding) in claim.readings.iter().zip(findings) {
        let study = &ledger.studies[reading.study].name;
        let see = match &reading.figure {
            Some(figure) => format!("`{study}/{figure}.png`"),
            None => format!("`{study}/results.csv`"),
        };
        let holds = match (finding.holds, reading.holds) {
            (true, true) => "yes",
            (false, false) => "no",
            (true, false) => "yes, **recorded: no**",
            (false, true) => "no, **recorded: yes**",
        };
        let _ = writeln!(
            page,
            "| {} | {} | {holds} | {see} |",
            cell(&reading.name),
            cell(&finding.found.join("; "))
        );
    }
    if let Some(because) = &claim.because {
        let _ = write!(page, "\n{because}\n");
    }
}

/// A text for a cell of a table.
fn cell(words: &str) -> String {
    words.replace('|', "\\|")
}

fn capital(word: &str) -> String {
    let mut letters = word.chars();
    let first = letters.next().map(|c| c.to_uppercase().to_string());
    first.unwrap_or_default() + letters.as_str() + "."
}
