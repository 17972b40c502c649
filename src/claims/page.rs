//! The ledgers as a page: a table of verdicts for each paper or subject, then every claim with its readings and numbers.

use super::ledger::{Claim, Ledger};
use super::{Finding, Verdict};
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

    /// Number of claims with a reading whose result is not the recorded one.
    pub fn changed(&self) -> usize {
        let changed = |(claim, findings): &(&Claim, &[Finding])| {
            let mut readings = claim.readings.iter().zip(*findings);
            readings.any(|(reading, finding)| reading.holds != finding.holds)
        };
        self.claims().filter(changed).count()
    }
}

/// The page in Markdown; its links start from the output folder.
pub fn page(all: &[Judged]) -> String {
    let mut page = String::from(
        "# The statements of the papers and of the literature, tested by computation\n\n\
         This page lists every statement of the two papers that a computation can test, and statements of the literature and of \
         practice on laws, methods and bridges that studies can decide, each with its place or source and in our words. A reading is one way to \
         understand a statement; each is tested by a study. `slipgap claims` computes the verdicts. If a statement fails \
         in a reading, the reason is below the table. If a statement has no number, the limit is our choice; it is in \
         brackets next to each value. A metric over that of other values is the quotient of two cases that are otherwise the \
         same. docs/errata.md checks simple arithmetic (f_n, Delta, T_I).\n",
    );
    for judged in all {
        let _ = write!(page, "\n## {}\n\n", judged.ledger.paper);
        page.push_str("| | statement | verdict |\n| --- | --- | --- |\n");
        for (claim, findings) in judged.claims() {
            let verdict = verdict(findings).as_str();
            let id = &claim.id;
            let _ = writeln!(
                page,
                "| [{id}](#{}) | {} | {verdict} |",
                id.to_lowercase(),
                cell(&claim.statement)
            );
        }
        for (claim, findings) in judged.claims() {
            section(&mut page, &judged.ledger, claim, findings);
        }
    }
    page
}

/// The verdict of a claim by its findings.
pub fn verdict(findings: &[Finding]) -> Verdict {
    Verdict::of(findings.iter().map(|finding| finding.holds))
}

fn section(page: &mut String, ledger: &Ledger, claim: &Claim, findings: &[Finding]) {
    let _ = write!(
        page,
        "\n### {}\n\n{}: {} **{}**\n\nThe test: {}.\n\n",
        claim.id,
        claim.place,
        claim.statement,
        capital(verdict(findings).as_str()),
        claim.quantity
    );
    page.push_str("| reading | computed | holds | figure |\n| --- | --- | --- | --- |\n");
    for (reading, finding) in claim.readings.iter().zip(findings) {
        let study = &ledger.studies[reading.study].name;
        let see = match &reading.figure {
            Some(figure) => format!("[{study}]({study}/{figure}.png)"),
            None => format!("[{study}]({study}/results.csv)"),
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
