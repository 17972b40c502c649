//! The cases of a study with one kind of warning.

use serde_json::{Map, Value as Json, json};
use slipgap_motion::solve::{WARNINGS, Warning};
use slipgap_problem::problem::Case;
use slipgap_problem::problem::numbers::parameter::Value;
use slipgap_study::Study;
use std::fmt;

/// The cases of a study with one kind of warning: how many, and the first one as an example.
#[derive(Debug, Clone, PartialEq)]
pub struct WarnedCases {
    /// The kind.
    pub kind: Warning,
    /// Their number.
    pub cases: u64,
    /// Number of all cases.
    pub of: u64,
    /// Number of the first one.
    pub case: u64,
    /// The parameters of it that vary in the study, by name.
    pub parameters: Vec<(String, Value)>,
    /// What it is of in this case, such as a contact; `None` if only the motion says it.
    pub detail: Option<String>,
    /// Whether it is a note, which is not denied with the warnings.
    pub is_note: bool,
}

impl WarnedCases {
    /// What they have, as a sentence without its full stop.
    pub fn sentence(&self) -> String {
        let message = match self.cases < self.of {
            true => self.kind.message_of_some(),
            false => self.kind.message(),
        };
        format!("{} of {} cases {message}", self.cases, self.of)
    }

    /// What it is called: a warning, or a note.
    pub fn word(&self) -> &'static str {
        match self.is_note {
            true => "note",
            false => "warning",
        }
    }

    /// The example, as in `case 3: gap = 0.1, n = 5`.
    pub fn example(&self) -> String {
        let parameters = self.parameters.iter();
        let values: Vec<String> = parameters
            .map(|(name, value)| format!("{name} = {value}"))
            .collect();
        let mut text = format!("case {}", self.case);
        if !values.is_empty() {
            text += &format!(": {}", values.join(", "));
        }
        if let Some(detail) = &self.detail {
            text += &format!("; {detail}");
        }
        text
    }

    /// The entry of manifest.json.
    pub fn json(&self) -> Json {
        let value = |value: &Value| match value {
            Value::Number(x) => json!(x),
            Value::Whole(n) => json!(n),
            Value::Name(name) => json!(name),
        };
        let parameters: Map<String, Json> = self
            .parameters
            .iter()
            .map(|(name, given)| (name.clone(), value(given)))
            .collect();
        json!({
            "kind": self.kind.name(),
            "cases": self.cases,
            "case": self.case,
            "parameters": parameters,
            "message": self.to_string(),
        })
    }
}

impl fmt::Display for WarnedCases {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (sentence, word, kind) = (self.sentence(), self.word(), self.kind.name());
        write!(f, "{sentence} ({word} {kind}; {})", self.example())
    }
}

/// The numbers of cases by kind, in the order of the table.
#[derive(Debug, Clone)]
pub struct WarningCounts([Option<(u64, u64)>; WARNINGS.len()]);

impl Default for WarningCounts {
    fn default() -> WarningCounts {
        WarningCounts([None; WARNINGS.len()])
    }
}

impl WarningCounts {
    /// Counts a case with a warning; cases may come in any order.
    pub fn add(&mut self, kind: Warning, case: u64) {
        let index = WARNINGS.iter().position(|known| *known == kind);
        if let Some(index) = index {
            let (count, first) = self.0[index].unwrap_or((0, case));
            self.0[index] = Some((count + 1, first.min(case)));
        }
    }

    /// The kinds that some of the `of` cases of the study have.
    pub fn list(&self, study: &Study, of: u64) -> Vec<WarnedCases> {
        let pairs = WARNINGS.into_iter().zip(self.0);
        let found = pairs.filter_map(|(kind, found)| Some((kind, found?)));
        let warned = found.map(|(kind, (cases, case))| WarnedCases {
            kind,
            cases,
            of,
            case,
            is_note: kind.is_note(),
            parameters: study.case(case).map_or(Vec::new(), |case_of_warning| {
                varying(study, case, &case_of_warning)
            }),
            detail: study.case(case).and_then(|case_of_warning| {
                let mut doubts = study.problem.doubts(&case_of_warning).into_iter();
                doubts.find(|doubt| doubt.0 == kind).map(|doubt| doubt.1)
            }),
        });
        warned.collect()
    }
}

/// The parameters of a case that vary in the study: those on axes, and given ones that differ from block to block.
fn varying(study: &Study, number: u64, case: &Case) -> Vec<(String, Value)> {
    let Some(block) = study.enumeration().block_of(number) else {
        return Vec::new();
    };
    let firsts: Vec<Case> = (0..study.blocks.len())
        .filter_map(|i| study.case(study.enumeration().first_of(i)))
        .collect();
    let on_axis = |row: usize| {
        let groups = block.groups.iter().filter(|group| group.len() > 1);
        groups
            .flat_map(|group| &group.axes)
            .any(|axis| axis.parameter == row)
    };
    let differs = |row: usize| {
        let other = |other: &Case| !Value::identical(other.values[row], case.values[row]);
        study.blocks.iter().any(|block| block.gives(row)) && firsts.iter().any(other)
    };
    let parameter_rows = study.parameter_columns().into_iter();
    let rows = parameter_rows.filter(|row| on_axis(*row) || differs(*row));
    let named = rows.filter_map(|row| {
        let name = study.problem.parameters()[row].name.to_string();
        Some((name, case.values[row]?))
    });
    named.collect()
}
