//! Structures of a study: masses, bars, springs, contacts, loads and records, with the exact motion by events.

pub mod amount;
mod assemble;
pub mod channel;
mod columns;
mod computed_ground;
pub mod contact_duration;
pub mod contacts;
mod damping;
mod derived;
mod describe;
mod diverge;
mod exact_metrics;
mod friction_limits;
mod ground;
pub mod ground_metric;
mod independent;
pub mod loads;
mod massless;
pub mod measured;
mod measured_metrics;
mod memory;
pub mod metric;
pub mod metric_pieces;
mod metric_text;
mod metric_title;
mod metric_values;
mod models;
mod motion;
pub mod names;
mod negative;
pub mod node;
mod observer;
pub mod reduce;
mod reference_error;
pub mod rows;
mod rules;
pub mod scale_to;
pub mod schema;
pub mod scheme;
pub mod shape;
mod signal_cache;
mod solve;
mod still;
mod supports;
mod sweep;
pub mod template;
pub mod unit_consistency;
pub mod units;
mod warn;

pub use ground::GroundMotion;
pub use scheme::Scheme;
pub use signal_cache::MOST_NUMBERS as MOST_SAMPLED;

use super::cases::Cases;
use super::method;
use super::unit::Dimension;
use super::{
    Case, HistoryColumn, MeasuredChannel, Problem, Samples, Schema, Solution, Violation, time_rules,
};
use crate::history::History;
use crate::methods::Method;
use crate::solve::structure::{balance, settle};
use crate::solve::{MetricTable, Unsolvable, Warning};
use crate::system::structure::Structure;
use assemble::{Model, assemble};
use channel::{Channel, Number};
use columns::all_numbers;
use metric::StructureMetric;
use metric_values::Recorded;
use node::Numbering;
use schema::Drawn;
use solve::distinct;
use std::sync::Arc;
use sweep::{Groups, Ready};
use template::Template;

/// The structure of a study.
#[derive(Debug)]
pub struct StructureProblem {
    schema: Arc<Schema>,
    template: Template,
    metrics: Vec<StructureMetric>,
    drawn: Vec<Drawn>,
    identity: String,
    notes: Vec<String>,
}

impl StructureProblem {
    /// The problem of a template with these tables. `identity` is different for different structures and records; `notes` say what
    /// was done to the records, and what may be a mistake.
    pub fn new(
        template: Template,
        schema: Arc<Schema>,
        metrics: Vec<StructureMetric>,
        drawn: Vec<Drawn>,
        identity: String,
        notes: Vec<String>,
    ) -> StructureProblem {
        let channels = metrics.iter().filter_map(|metric| metric.channel.as_ref());
        let mut channels = channels.chain(drawn.iter().map(|drawn| &drawn.channel));
        let observed = channels.any(Channel::is_derived);
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
        }
    }

    /// The structure of a completed case, and the numbers of its nodes.
    fn structure(&self, case: &Case, model: Model) -> Result<(Structure, Numbering), Unsolvable> {
        let broken =
            |all: Vec<Violation>| Unsolvable::BrokenRules(Violation::all(&all).unwrap_or_default());
        let (mut structure, numbering) = assemble(&self.template, case, model).map_err(broken)?;
        if let Some(ratio) = &self.template.modal_damping {
            let ratio = ratio.value(case).map_err(|one| broken(vec![one]))?;
            let stiffness = assemble::damping_stiffness(&self.template, &structure).into_owned();
            if damping::add_modal(&mut structure, &stiffness, ratio).is_none() {
                return Err(self.no_modes(&structure, case));
            }
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
    fn computed_steps(&self, case: &Case) -> Option<computed_ground::Steps> {
        let dt = case.at(self.schema.step)?;
        let last = usize::try_from(self.steps(case)).ok()?;
        Some(computed_ground::Steps { dt, last })
    }

    /// Why a structure has no modes for its modal damping.
    fn no_modes(&self, structure: &Structure, case: &Case) -> Unsolvable {
        let method = self.method(case);
        let fault = method.and_then(|method| massless::fault(structure, &method));
        match fault {
            _ if structure.len() > damping::MOST_MODES => Unsolvable::NoModes,
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
    fn ready(&self, place: usize, case: &Case) -> Result<Ready, Unsolvable> {
        let dt = case.at(self.schema.step);
        let (structure, numbering) = self.structure(case, Model::Study)?;
        Ok(Ready {
            place,
            case: case.clone(),
            structure,
            numbering,
            method: self.method(case).ok_or(Unsolvable::ParameterMissing)?,
            dt: dt.ok_or(Unsolvable::ParameterMissing)?,
            last: self.steps(case),
        })
    }

    /// Cost of the time steps of a structure with so many nodes, in steps times modes.
    fn stepping_work(&self, case: &Case, nodes: usize) -> u64 {
        let size = (nodes + 5 * self.template.contacts.len()).max(1);
        let parts = self
            .method(case)
            .map_or(1, |method| method.count_of_sub_steps());
        self.steps(case).saturating_mul(size as u64 * parts)
    }

    /// Cost of one run by steps.
    fn one_run_work(&self, case: &Case) -> u64 {
        let numbering = assemble::check(&self.template, case);
        self.stepping_work(case, numbering.map_or(0, |numbering| numbering.nodes()))
    }

    /// The method of a completed case.
    fn method(&self, case: &Case) -> Option<Method> {
        let name = method::PARAMETERS[0].name.as_ref();
        let mut parameters = self.schema.parameters.iter();
        let row = parameters.position(|parameter| parameter.name == name)?;
        method::of_case(case, row)
    }

    /// The exact motion of the reference at these times.
    fn reference(
        &self,
        structure: &Structure,
        times: &[f64],
        numbers: &[Number],
    ) -> Result<Recorded, Unsolvable> {
        match self.against_rigid() {
            true => motion::exact(&motion::rigid(structure)?, times, numbers),
            false => motion::exact(structure, times, numbers),
        }
    }

    /// The channels of histories: those of figures, then those of every node and contact.
    /// Those that the motion does not have are empty: energies of an exact one.
    fn history(&self, recorded: &Recorded, numbering: &Numbering, all: &[Number]) -> Vec<Vec<f64>> {
        let drawn = self.drawn.iter();
        let drawn = drawn.map(|drawn| recorded.channel(&drawn.channel, numbering));
        drawn
            .chain(all.iter().map(|number| recorded.of(*number).to_vec()))
            .collect()
    }

    fn drawn_numbers(&self, numbering: &Numbering) -> Vec<Number> {
        let drawn = self.drawn.iter();
        distinct(drawn.flat_map(|drawn| drawn.channel.numbers(numbering)))
    }
}

impl Problem for StructureProblem {
    fn schema(&self) -> &Arc<Schema> {
        &self.schema
    }

    fn identity(&self) -> &str {
        &self.identity
    }

    fn samples(&self, case: &Case) -> Samples {
        let mut samples = Samples::default();
        for source in self.template.sampled() {
            // A case that breaks a rule makes none.
            let Ok((key, points)) = source.samples(case) else {
                return Samples::default();
            };
            samples.key.extend(key);
            samples.work += source.sampling_work(points);
            samples.numbers = samples.numbers.max(signal_cache::numbers(points));
        }
        samples
    }

    fn sampled_so_far(&self) -> u64 {
        self.template
            .sampled()
            .map(|source| source.made_so_far())
            .sum()
    }

    fn notes(&self) -> &[String] {
        &self.notes
    }

    fn complete(&self, case: &mut Case) -> Vec<Violation> {
        let number = |row| case.at(row).unwrap_or(f64::NAN);
        let (step, duration) = (number(self.schema.step), number(self.schema.duration));
        let mut violations = Vec::new();
        if step.is_finite() && duration.is_finite() {
            violations.extend(time_rules("dt", step, duration));
        }
        match assemble::check(&self.template, case) {
            Err(broken) => violations.extend(broken),
            Ok(numbering) => {
                violations.extend(self.check_channels(&numbering, case));
                violations.extend(self.check_measures(case));
                violations.extend(self.check_measured(case));
                violations.extend(self.check_contacts());
                if violations.is_empty() {
                    violations.extend(self.check_memory(&numbering, duration / step));
                }
                if violations.is_empty() {
                    violations.extend(self.ignored_restitutions(case));
                    violations.extend(self.negative_stiffness(case));
                    violations.extend(self.static_ratio_rules(case));
                    violations.extend(self.step_rules(case, step));
                }
            }
        }
        violations
    }

    fn work(&self, case: &Case) -> u64 {
        let runs = 1 + u64::from(self.needs_perturbed());
        self.one_run_work(case).saturating_mul(runs)
    }

    fn reference_work(&self, case: &Case, _wanted: &[usize]) -> u64 {
        self.exact_work(case)
            .saturating_add(self.unreduced_work(case))
    }

    fn solve(&self, case: &Case, _wanted: &[usize]) -> Result<Solution, Unsolvable> {
        let ready = self.ready(0, case)?;
        // A whole history that does not fit is refused where one is asked for; figures need their own channels.
        let all = match self.check_history(case) {
            None => all_numbers(&ready.structure, &self.template),
            Some(_) => Vec::new(),
        };
        let drawn = self.drawn_numbers(&ready.numbering);
        let recorded = distinct(drawn.into_iter().chain(all.iter().copied()));
        let (motions, metrics, warnings) = self.solve_ready(&ready, &recorded)?;
        let time: Vec<f64> = (0..=ready.last).map(|i| i as f64 * ready.dt).collect();
        let exact = match (self.template.reference, self.against_rigid()) {
            (None, _) => &None,
            (Some(_), true) => &motions.rigid,
            (Some(_), false) => &motions.softened,
        };
        let exact = exact.as_ref();
        let exact = exact.map(|exact| self.history(exact, &ready.numbering, &all));
        let computed = self.history(&motions.computed, &ready.numbering, &all);
        let history = |channels| History {
            time: time.clone(),
            channels,
        };
        let solution = Solution {
            computed: history(computed),
            exact: history(exact.unwrap_or_default()),
            metrics,
            warnings,
        };
        match solution.computed.is_finite() {
            true => Ok(solution),
            false => Err(Unsolvable::OutOfRange),
        }
    }

    fn solve_once(&self, _case: &Case, _wanted: &[usize]) -> Result<Solution, Unsolvable> {
        Err(Unsolvable::NotPrinted)
    }

    fn sweep(&self, cases: &Cases, rows: &[u32]) -> MetricTable {
        let mut groups = Groups::new(self, rows.len());
        let mut shown = cases.shown();
        for (place, row) in rows.iter().enumerate() {
            match self.ready(place, shown.at(*row as usize)) {
                Ok(ready) => groups.add(ready),
                Err(why) => groups.fail(place, why),
            }
        }
        groups.finish()
    }

    fn exact(&self, case: &Case, times: &[f64]) -> Option<History> {
        self.template.reference?;
        let (structure, numbering) = self.structure(case, Model::Study).ok()?;
        let numbers = self.drawn_numbers(&numbering);
        let exact = self.reference(&structure, times, &numbers).ok()?;
        Some(History {
            time: times.to_vec(),
            channels: self.history(&exact, &numbering, &[]),
        })
    }

    fn exact_metrics(&self, case: &Case, rows: &[usize]) -> Vec<Option<f64>> {
        let values = self
            .ready(0, case)
            .and_then(|own| self.exact_values(&own, rows));
        values.unwrap_or_else(|_| vec![None; rows.len()])
    }

    fn history_fault(&self, case: &Case) -> Option<Violation> {
        self.check_history(case)
    }

    fn history_columns(&self, case: &Case) -> Vec<HistoryColumn> {
        let exact = self.template.reference.is_some();
        match assemble(&self.template, case, Model::Study) {
            Ok((structure, _)) => columns::of(&structure, &self.template, self.drawn.len(), exact)
                .into_iter()
                .chain(columns::of_drawn(&self.drawn, exact))
                .collect(),
            Err(_) => Vec::new(),
        }
    }

    fn measured(&self, case: &Case) -> Vec<MeasuredChannel> {
        let (Some(measured), Some(dt)) = (&self.template.measured, case.at(self.schema.step))
        else {
            return Vec::new();
        };
        match measured.in_case(case, dt, self.steps(case)) {
            Ok(compared) => compared.channels(),
            Err(_) => Vec::new(),
        }
    }

    fn diverges(&self, case: &Case) -> Option<bool> {
        self.case_diverges(case)
    }

    fn are_side_by_side(&self, one: &Case, other: &Case) -> bool {
        let ready = |case: &Case| self.ready(0, case).ok();
        let (Some(one), Some(other)) = (ready(one), ready(other)) else {
            return false;
        };
        let prepared = motion::prepare(&one.structure, &one.method, one.dt);
        one.last == other.last
            && prepared.is_ok_and(|own| own.fits(&other.method, &other.structure, other.dt))
    }

    fn has_same_motion(&self, one: &Case, other: &Case) -> bool {
        let equations = |case: &Case| {
            let ready = self.ready(0, case).ok()?;
            // The text has every number in the shortest form that reads back the same.
            Some(format!(
                "{:?} {:?} {:?} {}",
                ready.structure, ready.method, ready.dt, ready.last
            ))
        };
        equations(one).is_some_and(|own| equations(other) == Some(own))
            && self.measured(one) == self.measured(other)
    }

    fn diverges_by(&self, metrics: &[Option<f64>]) -> Option<bool> {
        self.metrics_say(metrics)
    }

    fn scheme(&self, case: &Case) -> Option<Scheme> {
        scheme::scheme(&self.template, case)
    }

    fn unit_name(&self, dimension: Dimension) -> Option<String> {
        let units = units::UnitNames::of(&self.template.units)?;
        Some(units.of_dimension(dimension))
    }

    fn friction_limits(&self, case: &Case, motion: &History) -> Vec<Option<Vec<f64>>> {
        match self.structure(case, Model::Study) {
            Ok((structure, _)) => {
                friction_limits::of(&structure, &self.template, self.drawn.len(), motion)
            }
            Err(_) => Vec::new(),
        }
    }

    fn ground_motion(&self, case: &Case) -> Option<GroundMotion> {
        let duration = case.at(self.schema.duration)?;
        ground::ground_motion(&self.template, case, duration)
    }

    fn doubts(&self, case: &Case) -> Vec<(Warning, String)> {
        let whole = self.structure(case, Model::Study);
        whole.map_or(Vec::new(), |(structure, numbering)| {
            self.doubts_of(case, &structure, &numbering)
        })
    }

    fn description(&self, case: &Case) -> Option<String> {
        let (structure, numbering) = self.structure(case, Model::Study).ok()?;
        let times = [case.at(self.schema.step)?, case.at(self.schema.duration)?];
        let models = models::Models::of(&self.template, case, &structure, &numbering);
        let restitutions = warn::restitutions(&self.template, case, &structure);
        let units = &self.template.units;
        let mut text = describe::describe(&structure, &models, times, units, &restitutions);
        text += &channel::listed(&self.template, numbering.elements());
        text += &ground::described(&self.template, case, self.computed_steps(case)?);
        text += &reduce::described(&self.template, case, describe::short);
        let dt = case.at(self.schema.step)?;
        if let Some(measured) = &self.template.measured
            && let Ok(compared) = measured.in_case(case, dt, self.steps(case))
        {
            text += &compared.described(case);
        }
        Some(text)
    }
}
