//! The parameters of a block as the study gives them, each with its place.

use super::interval::Interval;
use crate::problem::parameter::Value;
use crate::study::cases::design::Design;
use crate::study::expression::Formula;
use crate::study::{Axis, Group};

/// A parameter that a block gives, with the place of every value.
pub(in crate::study) struct Given {
    /// Row of the table.
    pub parameter: usize,
    pub path: String,
    /// Offset of the whole value.
    pub at: usize,
    /// Values with their offsets; none at all if one of them is faulty.
    pub values: Vec<(Value, usize)>,
    /// Whether the values stand in a list.
    pub list: bool,
    /// Whether they stand in a list or follow a rule.
    pub axis: bool,
    /// In place of values: an expression of other parameters, and its text.
    pub formula: Option<(Formula, String)>,
    /// In place of values, until the design gives them: where they lie.
    pub interval: Option<Interval>,
}

/// The parameters of a block with their places, for the faults that show only later.
pub(in crate::study) struct Draft {
    /// Offset of the opening brace.
    pub at: usize,
    pub path: String,
    pub given: Vec<Given>,
    /// Rows of parameters that are given, but with a faulty value: of them nothing further is said.
    pub faulty: Vec<usize>,
    /// Groups of parameters that advance together, by their rows.
    pub zips: Vec<Vec<usize>>,
    /// What combinations must meet, with its offset and text.
    pub when: Option<(Formula, usize, String)>,
    /// The design, where there is one without a fault.
    pub design: Option<Design>,
}

impl Draft {
    /// Number of values of a parameter.
    pub fn count(&self, parameter: usize) -> usize {
        let given = self.given.iter().find(|given| given.parameter == parameter);
        given.map_or(0, |given| given.values.len())
    }

    /// Which of `given` advance together: all with values, each group where its first member stands in the file.
    pub fn groups(&self) -> Vec<Vec<usize>> {
        let sampled = self.design.iter().map(|design| &design.parameters);
        let together: Vec<&Vec<usize>> = self.zips.iter().chain(sampled).collect();
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for (i, given) in self.given.iter().enumerate() {
            if given.formula.is_some() || groups.iter().flatten().any(|member| *member == i) {
                continue;
            }
            let zip = together.iter().find(|zip| zip.contains(&given.parameter));
            let member = |(_, other): &(usize, &Given)| match zip {
                Some(zip) => zip.contains(&other.parameter),
                None => other.parameter == given.parameter,
            };
            let members = self.given.iter().enumerate().filter(member);
            groups.push(members.map(|(i, _)| i).collect());
        }
        groups
    }

    /// The groups without places.
    pub fn axes(&self) -> Vec<Group> {
        let axis = |given: &Given| Axis {
            parameter: given.parameter,
            values: given.values.iter().map(|(value, _)| *value).collect(),
        };
        let group = |members: Vec<usize>| Group {
            axes: members.iter().map(|i| axis(&self.given[*i])).collect(),
        };
        self.groups().into_iter().map(group).collect()
    }
}
