//! The checks of a study on the page.

use super::Detail;
use super::packed::write_part;
use super::text::{escape, verdict};
use slipgap_batch::Outcome;
use slipgap_batch::checks::{self, ReducedChecks, Verdict};
use slipgap_study::Study;
use std::io::{self, Write};

/// Largest number of checks that the page lists.
const MOST: usize = 1000;

/// What a list leaves out.
const NOT_MET: &str = "The list shows only the checks that are not met.";

/// The checks so far: all of them if they are few, else those that are not met.
#[derive(Debug, Default)]
pub struct Checks {
    total: u64,
    met: u64,
    /// Each with the place of its check in the file.
    listed: Vec<(usize, Verdict)>,
}

impl Checks {
    /// Judges the next case.
    pub fn judge(&mut self, study: &Study, number: u64, outcome: &Outcome) {
        let mut verdicts = Vec::new();
        checks::judge(study, number, outcome, &mut verdicts);
        verdicts
            .into_iter()
            .for_each(|(check, verdict)| self.add(check, verdict));
    }

    /// Judges the reductions of all cases.
    pub fn judge_reduced(&mut self, study: &Study, reduced: &ReducedChecks) {
        for (check, case, value) in reduced.values() {
            self.add(check, checks::verdict(study, check, case, value));
        }
    }

    fn add(&mut self, check: usize, verdict: Verdict) {
        let few = self.total < MOST as u64;
        self.total += 1;
        self.met += u64::from(verdict.holds());
        if self.total == MOST as u64 + 1 {
            self.listed.retain(|(_, verdict)| !verdict.holds());
        }
        if few || !verdict.holds() && self.listed.len() < MOST {
            self.listed.push((check, verdict));
        }
    }

    /// Number of all checks.
    pub fn total(&self) -> u64 {
        self.total
    }

    /// Number of checks that are not met.
    pub fn failed(&self) -> u64 {
        self.total - self.met
    }

    /// A sentence about the list if it does not have all checks.
    fn limit(&self) -> Option<String> {
        let failed = self.failed();
        match (self.total <= MOST as u64, failed) {
            (true, _) | (false, 0) => None,
            (false, failed) if failed <= MOST as u64 => Some(NOT_MET.into()),
            (false, failed) => Some(format!(
                "The list shows {MOST} of the {failed} checks that are not met, those of the cases with the lowest numbers."
            )),
        }
    }

    /// Writes how many checks are met, and the list, which is open if a check is not met.
    pub fn write(&self, out: &mut impl Write, detail: Detail) -> io::Result<()> {
        if self.total == 0 {
            return Ok(());
        }
        let (class, sign) = verdict(self.failed() == 0, "✓", "✗");
        let heading = format!(
            "<span class=\"{class}\">{sign} Checks: {} of {} met</span>",
            self.met, self.total
        );
        let mut list = Vec::new();
        self.write_list(&mut list, detail)?;
        let open = self.failed() > 0 || detail == Detail::Whole;
        write_part(out, &heading, open, &list)
    }

    fn write_list(&self, out: &mut impl Write, detail: Detail) -> io::Result<()> {
        let is_listed = |verdict: &Verdict| detail == Detail::Whole || !verdict.holds();
        let mut listed: Vec<&(usize, Verdict)> = self
            .listed
            .iter()
            .filter(|(_, verdict)| is_listed(verdict))
            .collect();
        let limit = match self.limit() {
            None if listed.len() < self.listed.len() => Some(NOT_MET.to_owned()),
            limit => limit,
        };
        if let Some(limit) = limit {
            writeln!(out, "<p>{limit}</p>")?;
        }
        if listed.is_empty() {
            return Ok(());
        }
        out.write_all(
            b"<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Checks\"><table>\n\
              <thead><tr><th>case</th><th class=\"words\">metric</th><th>value</th><th class=\"words\">limits</th><th class=\"words\">verdict</th></tr></thead>\n<tbody>\n",
        )?;
        // By check, then by case; the groups of a reduction in their order.
        listed.sort_by_key(|(check, _)| *check);
        for (_, judged) in listed {
            let value = judged.value.map_or("undefined".into(), |x| x.to_string());
            let (class, word) = verdict(judged.holds(), "met", "not met");
            writeln!(
                out,
                "<tr><td>{}</td><td class=\"words\">{}</td><td>{value}</td><td class=\"words\">{}</td><td class=\"words {class}\">{word}</td></tr>",
                judged.case,
                judged.metric,
                escape(&judged.limits())
            )?;
        }
        out.write_all(b"</tbody></table></div>\n")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn checks(count: u64, holds: impl Fn(u64) -> bool) -> Checks {
        let mut checks = Checks::default();
        for case in 0..count {
            let value = Some(if holds(case) { 0.0 } else { 2.0 });
            let (min, max) = (None, Some(1.0));
            checks.add(
                0,
                Verdict {
                    case,
                    metric: "rms_error".into(),
                    value,
                    min,
                    max,
                },
            );
        }
        checks
    }

    fn page(checks: &Checks) -> String {
        let mut out = Vec::new();
        checks.write(&mut out, Detail::Whole).unwrap();
        checks.write_list(&mut out, Detail::Whole).unwrap();
        String::from_utf8(out).unwrap()
    }

    #[test]
    fn a_long_list_has_only_checks_that_are_not_met() {
        let few = page(&checks(1000, |case| case != 7));
        assert!(few.contains("Checks: 999 of 1000 met") && !few.contains("<p>"));
        assert_eq!(few.matches("<tr><td>").count(), 1000);
        // Cases 0, 500, .. 999 500.
        let many = page(&checks(1_000_000, |case| case % 500 != 0));
        assert!(many.contains("Checks: 998000 of 1000000 met"));
        assert_eq!(many.matches("not met</td>").count(), 1000);
        assert_eq!(many.matches("<tr><td>").count(), 1000);
        assert!(many.contains("<tr><td>499500</td>") && many.contains("1000 of the 2000 checks"));
        let one = page(&checks(1_000_000, |case| case != 999_999));
        assert_eq!(one.matches("<tr><td>").count(), 1);
        assert!(one.contains("<tr><td>999999</td>"));
        let none = page(&checks(1001, |_| true));
        assert!(none.contains("1001 of 1001 met") && !none.contains("<table"));
        assert!(many.len() < 200_000, "{} bytes", many.len());
    }
}
