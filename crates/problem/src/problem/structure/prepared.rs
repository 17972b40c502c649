//! A case, ready to be solved.

use super::channels::channel::{Channel, Number};
use super::given::node::Numbering;
use super::given::source::Source;
use super::metrics::computed_ground::Steps;
use super::metrics::metric::StructureMetric;
use super::model::assemble::{self, Model, assemble};
use super::model::damping::{self, MOST_MODES};
use super::model::massless;
use super::motions::recorded::{Recorded, distinct};
use super::motions::sweep::Ready;
use super::motions::{exact_motion, motion};
use super::parts::template::Template;
use super::programs::Programs;
use super::tables::schema::Drawn;
use crate::methods::{AverageAcceleration, Method};
use crate::problem::{Case, Schema, Violation, method};
use crate::solve::Unsolvable;
use crate::solve::structure::{balance, settle};
use crate::system::structure::Structure;
use std::collections::BTreeSet;
use std::sync::Arc;

/// The structure of a study.
#[derive(Debug)]
pub struct StructureProblem {
    pub(super) schema: Arc<Schema>,
    pub(super) template: Template,
    pub(super) metrics: Vec<StructureMetric>,
    pub(super) drawn: Vec<Drawn>,
    pub(super) identity: String,
    pub(super) notes: Vec<String>,
    pub(super) programs: Programs,
}

impl StructureProblem {
    /// The structure, the method and the steps of a case in words: every number in the shortest form that reads back the same.
    pub(super) fn equations(&self, case: &Case) -> Option<String> {
        let ready = self.ready(0, case).ok()?;
        Some(format!(
            "{:?} {:?} {:?} {}{}",
            ready.structure,
            ready.method,
            ready.dt,
            ready.last,
            self.program_of(case).map_or(String::new(), |program| {
                let numbers = program.numbers.iter().map(|(_, amount)| amount.value(case));
                format!(" {} {:?}", program.name, numbers.collect::<Vec<_>>())
            })
        ))
    }

    /// Whether the ground motions are a set.
    pub fn has_set(&self) -> bool {
        self.template.set().is_some()
    }

    /// Rows of the parameters that are seeds of synthetic motions, in rising order.
    pub fn seeds(&self) -> Vec<usize> {
        let sources = self.template.sampled();
        let rows: BTreeSet<usize> = sources.flat_map(Source::seed_rows).copied().collect();
        rows.into_iter().collect()
    }

    /// The problem of a template with these tables. `identity` is different for different structures and records; `notes` say what
    /// was done to the records, and what may be a mistake.
    pub fn new(
        template: Template,
        schema: Arc<Schema>,
        metrics: Vec<StructureMetric>,
        drawn: Vec<Drawn>,
        identity: String,
        notes: Vec<String>,
        programs: Programs,
    ) -> StructureProblem {
        let of_metrics = metrics.iter().filter_map(|metric| metric.channel.as_ref());
        let mut channels = of_metrics.chain(drawn.iter().map(|drawn| &drawn.channel));
        // A request has the accelerations at t = 0.
        let observed = channels.any(Channel::is_derived) || !programs.list.is_empty();
        StructureProblem {
            schema,
            template: Template {
                observed,
                ..template
            },
            metrics,
            drawn,
            identity,
            notes,
            programs,
        }
    }

    /// The structure of a completed case, and the numbers of its nodes.
    pub(super) fn structure(
        &self,
        case: &Case,
        model: Model,
    ) -> Result<(Structure, Numbering), Unsolvable> {
        let broken = |violations: Vec<Violation>| {
            Unsolvable::BrokenRules(Violation::all(&violations).unwrap_or_default())
        };
        let (mut structure, numbering) = assemble(&self.template, case, model).map_err(broken)?;
        if let Some(modal) = &self.template.modal_damping {
            let stiffness = assemble::damping_stiffness(&self.template, &structure).into_owned();
            let Some(modes) = damping::modes(&structure, &stiffness) else {
                return Err(self.no_modes(&structure, case));
            };
            let ratios = modal
                .ratios(case, &modes.omega2)
                .map_err(|one| broken(vec![one]))?;
            damping::add_modal(&mut structure, &modes, &ratios);
        }
        match structure.preload.load.is_empty() {
            true => massless::place(&mut structure),
            false => settle(&mut structure)?,
        }
        structure.press_at_start();
        if let Some(dt) = case.at(self.schema.step) {
            balance(&mut structure, dt)?;
        }
        Ok((structure, numbering))
    }

    /// The steps of a case.
    pub(super) fn computed_steps(&self, case: &Case) -> Option<Steps> {
        let dt = case.at(self.schema.step)?;
        let last = usize::try_from(case.steps()).ok()?;
        Some(Steps { dt, last })
    }

    /// Why a structure has no modes for its modal damping.
    fn no_modes(&self, structure: &Structure, case: &Case) -> Unsolvable {
        let method = self.method(case);
        let fault = method.and_then(|method| massless::fault(structure, &method));
        match fault {
            _ if structure.len() > MOST_MODES => Unsolvable::NoModes,
            Some((node, why)) => {
                let name = &structure.nodes[node].name;
                Unsolvable::BrokenRules(format!("node {name} {why}"))
            }
            None => Unsolvable::BrokenRules(
                "modal damping needs a positive definite M, and a K that holds the nodes without mass".into(),
            ),
        }
    }

    /// A case ready to be stepped; `place` is its place in the table of results.
    pub(super) fn ready(&self, index: usize, case: &Case) -> Result<Ready, Unsolvable> {
        let dt = case.at(self.schema.step);
        let (structure, numbering) = self.structure(case, Model::Study)?;
        Ok(Ready {
            place: index,
            case: case.clone(),
            structure,
            numbering,
            method: match self.program_of(case) {
                // It has no rule of a method and no impulses.
                Some(_) => AverageAcceleration.into(),
                None => self.method(case).ok_or(Unsolvable::ParameterMissing)?,
            },
            dt: dt.ok_or(Unsolvable::ParameterMissing)?,
            last: case.steps(),
        })
    }

    /// Cost of the time steps of a structure with so many nodes, in steps times modes.
    pub(super) fn stepping_work(&self, case: &Case, nodes: usize) -> u64 {
        let size = (nodes + 5 * self.template.contacts.len()).max(1);
        let parts = self
            .method(case)
            .map_or(1, |method| method.count_of_sub_steps());
        case.steps().saturating_mul(size as u64 * parts)
    }

    /// Cost of one run by steps.
    pub(super) fn one_run_work(&self, case: &Case) -> u64 {
        let numbering = assemble::check(&self.template, case);
        self.stepping_work(case, numbering.map_or(0, |numbering| numbering.nodes()))
    }

    /// The method of a completed case.
    pub(super) fn method(&self, case: &Case) -> Option<Method> {
        if self.program_of(case).is_some() {
            return None;
        }
        let name = method::PARAMETERS[0].name.as_ref();
        let mut parameters = self.schema.parameters.iter();
        let row = parameters.position(|parameter| parameter.name == name)?;
        method::of_case(case, row)
    }

    /// The exact motion of the reference at these times.
    pub(super) fn reference(
        &self,
        structure: &Structure,
        times: &[f64],
        numbers: &[Number],
    ) -> Result<Recorded, Unsolvable> {
        match self.against_rigid() {
            true => exact_motion::exact(&motion::rigid(structure)?, times, numbers),
            false => exact_motion::exact(structure, times, numbers),
        }
    }

    /// The channels of histories: those of figures, then those of every node and contact.
    /// Those that the motion does not have are empty: energies of an exact one.
    pub(super) fn history(
        &self,
        recorded: &Recorded,
        numbering: &Numbering,
        numbers: &[Number],
    ) -> Vec<Vec<f64>> {
        let channels = self.drawn.iter();
        let drawn = channels.map(|drawn| recorded.channel(&drawn.channel, numbering));
        drawn
            .chain(numbers.iter().map(|number| recorded.of(*number).to_vec()))
            .collect()
    }

    pub(super) fn drawn_numbers(&self, numbering: &Numbering) -> Vec<Number> {
        let drawn = self.drawn.iter();
        distinct(drawn.flat_map(|drawn| drawn.channel.numbers(numbering)))
    }
}
