//! The number of cases from the store, and why the others were computed.

use crate::batch::PartResult;

/// Largest number of reasons in the summary.
const MOST_REASONS: usize = 3;

/// The cases of a run, counted by their origin.
#[derive(Debug)]
pub struct Tally {
    /// Whether the store was empty.
    new_store: bool,
    /// Whether all cases are computed, also those of the store.
    again: bool,
    /// Number of all cases.
    cases: u64,
    from_store: u64,
    /// Reasons, with the number of parts of each.
    reasons: Vec<(String, u64)>,
}

impl Tally {
    /// No cases yet.
    pub fn new(new_store: bool, again: bool) -> Tally {
        Tally {
            new_store,
            again,
            cases: 0,
            from_store: 0,
            reasons: Vec::new(),
        }
    }

    /// Counts a part.
    pub fn add(&mut self, part: &PartResult) {
        self.cases += part.len() as u64;
        self.from_store += part.from_store;
        let Err(miss) = &part.stored else {
            return;
        };
        let why = miss.to_string();
        match self.reasons.iter_mut().find(|(reason, _)| *reason == why) {
            Some((_, count)) => *count += 1,
            None => self.reasons.push((why, 1)),
        }
    }

    /// Number of cases.
    pub fn cases(&self) -> u64 {
        self.cases
    }

    /// One line about the run.
    pub fn summary(&self) -> String {
        let cases = self.cases;
        if self.from_store == cases {
            return format!("{cases} of {cases} cases from the store");
        }
        if self.new_store {
            return cases_run(cases);
        }
        if self.again {
            return format!(
                "{}, also those of the store, for their histories",
                cases_run(cases)
            );
        }
        let text = |(reason, count): &(String, u64)| match count {
            1 => reason.clone(),
            _ => format!("{reason} ({count} parts)"),
        };
        let mut reasons: Vec<String> = self.reasons.iter().take(MOST_REASONS).map(text).collect();
        if self.reasons.len() > MOST_REASONS {
            reasons.push(format!(
                "{} more reasons",
                self.reasons.len() - MOST_REASONS
            ));
        }
        let run = cases_run(cases - self.from_store);
        let from_store = match self.from_store {
            0 => String::new(),
            count => format!("{count} of {cases} cases from the store, "),
        };
        format!("{from_store}{run}: {}", reasons.join(", "))
    }
}

/// The number of cases in words.
pub fn cases_run(cases: u64) -> String {
    match cases {
        1 => "1 case run".into(),
        _ => format!("{cases} cases run"),
    }
}
