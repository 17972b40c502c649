//! The parameters of a block as the study gives them, each with its place.

use super::interval::Interval;
use slipgap_cases::axis::design::Design;
use slipgap_cases::axis::group::{Axis, AxisGroup};
use slipgap_cases::axis::values::{Sampled, Values};
use slipgap_problem::problem::expression::Formula;

/// A parameter that a block gives, with the place of every value.
pub(crate) struct ParameterDraft {
    /// Row of the table.
    pub parameter: usize,
    pub path: String,
    /// Offset of the value in the text.
    pub at: usize,
    /// None if one of them is faulty.
    pub values: Values,
    /// Their offsets, if each has one of its own.
    pub places: Vec<usize>,
    /// Whether the value is a list.
    pub list: bool,
    /// Whether the value is a list or a rule.
    pub axis: bool,
    /// An expression of other parameters and its text, instead of values.
    pub formula: Option<(Formula, String)>,
    /// The range that a design samples.
    pub interval: Option<Interval>,
    /// The values that the design gives.
    pub sampled: Option<Sampled>,
}

/// The parameters of a block with their places, for faults that are found later.
pub(crate) struct BlockDraft {
    /// Offset of the opening brace.
    pub at: usize,
    pub path: String,
    pub parameters: Vec<ParameterDraft>,
    /// Rows of the parameters with a faulty value. They cause no further faults.
    pub faulty: Vec<usize>,
    /// Groups of parameters that advance together, by their rows.
    pub zips: Vec<Vec<usize>>,
    /// The condition with its offset and text.
    pub when: Option<(Formula, usize, String)>,
    /// The design, if there is one without a fault.
    pub design: Option<Design>,
}

impl BlockDraft {
    /// The draft of a parameter, if the block gives it.
    pub fn get(&self, parameter: usize) -> Option<&ParameterDraft> {
        let mut parameters = self.parameters.iter();
        parameters.find(|given| given.parameter == parameter)
    }

    /// Number of values of a parameter.
    pub fn count(&self, parameter: usize) -> usize {
        self.get(parameter).map_or(0, |given| given.values.len())
    }

    /// Which of the parameters with values advance together, by their indices in `parameters`. The groups are in the order
    /// of their first members.
    pub fn groups(&self) -> Vec<Vec<usize>> {
        let sampled = self.design.iter().map(|design| &design.parameters);
        let together: Vec<&Vec<usize>> = self.zips.iter().chain(sampled).collect();
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for (i, given) in self.parameters.iter().enumerate() {
            if given.formula.is_some() || groups.iter().flatten().any(|member| *member == i) {
                continue;
            }
            let zip = together.iter().find(|zip| zip.contains(&given.parameter));
            let member = |(_, other): &(usize, &ParameterDraft)| match zip {
                Some(zip) => zip.contains(&other.parameter),
                None => other.parameter == given.parameter,
            };
            let members = self.parameters.iter().enumerate().filter(member);
            groups.push(members.map(|(i, _)| i).collect());
        }
        groups
    }

    /// The groups as axes, without places.
    pub fn axes(&self) -> Vec<AxisGroup> {
        let axis = |given: &ParameterDraft| Axis {
            parameter: given.parameter,
            values: match &given.sampled {
                Some(sampled) => Values::Sampled(sampled.clone()),
                None => given.values.clone(),
            },
        };
        let group = |members: Vec<usize>| AxisGroup {
            axes: members.iter().map(|i| axis(&self.parameters[*i])).collect(),
        };
        self.groups().into_iter().map(group).collect()
    }
}
