//! What only structures answer, beside [`Problem`].

use super::channels::channel::Term;
use super::described::ground_motion::GroundMotion;
use super::described::scheme::picture::Scheme;
use super::described::{describe, excitation, ground_motion, participation, scheme};
use super::given::motion_set::SetSpectra;
use super::given::shape::Scaled;
use super::given::signal_cache;
use super::metrics::unit_names::UnitNames;
use super::model::assemble::{Model, assemble, inertia};
use super::motions::compared::friction_limits;
use super::motions::motion;
use super::parts::listed;
use super::parts::models::Models;
use super::prepared::StructureProblem;
use super::tables::{history_columns, named_rows};
use super::warn;
use crate::history::History;
use crate::problem::numbers::unit::Dimension;
use crate::problem::{Case, HistoryColumn, MeasuredChannel, Samples};
use crate::system::loads::cycles::Cycles;
use crate::system::structure::Structure;

impl StructureProblem {
    /// The columns of the history of a completed case, after the time.
    pub(in crate::problem) fn history_columns(&self, case: &Case) -> Vec<HistoryColumn> {
        let exact = self.template.reference.is_some();
        let whole = assemble(&self.template, case, Model::Study);
        whole.map_or(Vec::new(), |(structure, _)| {
            history_columns::of(&structure, &self.template, self.drawn.len(), exact)
                .into_iter()
                .chain(history_columns::of_drawn(&self.drawn, exact))
                .collect()
        })
    }

    /// The structure of a completed case; `None` if it cannot be solved.
    pub(in crate::problem) fn assembled(&self, case: &Case) -> Option<Structure> {
        Some(self.structure(case, Model::Study).ok()?.0)
    }

    /// Lines that describe a completed case, for `explain`.
    pub fn description(&self, case: &Case) -> Option<String> {
        let (structure, numbering) = self.structure(case, Model::Study).ok()?;
        let times = [case.at(self.schema.step)?, case.at(self.schema.duration)?];
        let models = Models::of(&self.template, case, &structure, &numbering);
        let restitutions = warn::restitutions(&self.template, case, &structure);
        let units = &self.template.units;
        let mut text = describe::describe(&structure, &models, times, units, &restitutions);
        if let Some(total) = &models.total {
            let reductions = self.template.matrices.iter().map(|matrices| {
                let reduced = matrices.reduce.as_ref()?.reduced(case);
                reduced.ok()
            });
            let reduced: Vec<_> = reductions.collect();
            let supports = &self.template.supports;
            let massive = total.iter().filter(|(_, mass)| *mass > 0.0);
            let shaken = massive.map(|(direction, mass)| {
                let reduced = (&reduced[..], &numbering);
                let inertia = inertia(&structure, supports, reduced, *direction);
                (*direction, inertia, *mass)
            });
            text += &participation::described(&structure, &shaken.collect::<Vec<_>>());
        }
        text += &listed::listed(&self.template, numbering.elements());
        text += &ground_motion::described(&self.template, case, self.computed_steps(case)?);
        text += &named_rows::described(&self.template, case);
        let dt = case.at(self.schema.step)?;
        if let Some(measured) = &self.template.measured
            && let Ok(compared) = measured.in_case(case, dt, case.steps())
        {
            text += &compared.described(case);
        }
        text += &self.sample_described();
        Some(text)
    }

    /// The acceleration of the ground in a completed case; `None` where there is none.
    pub fn ground_motion(&self, case: &Case) -> Option<GroundMotion> {
        let duration = case.at(self.schema.duration)?;
        ground_motion::ground_motion(&self.template, case, duration)
    }

    /// Whether a channel of figures is a motion of the ground, which the study gives, and the same in these cases.
    pub fn is_one_input(&self, channel: usize, cases: &[Case]) -> bool {
        let terms = self.drawn.get(channel).map(|drawn| &drawn.channel.terms);
        let is_ground = terms.is_some_and(|terms| {
            terms
                .iter()
                .all(|(_, term)| matches!(term, Term::Ground(..)))
        });
        let motions = |case: &Case| {
            let of_case =
                |(_, motion): &(_, Scaled)| motion.in_case(case, self.template.metre).ok();
            Vec::from_iter(self.template.ground.iter().map(of_case))
        };
        let Some((first, others)) = cases.split_first().filter(|_| is_ground) else {
            return false;
        };
        let known = motions(first);
        others.iter().all(|case| motions(case) == known)
    }

    /// The whole cycles of the loads and motions of a completed case.
    ///
    /// # Errors
    /// Why they are not known: there are none, or several.
    pub fn cycles(&self, case: &Case) -> Result<Vec<Cycles>, String> {
        let times = [self.schema.step, self.schema.duration];
        let times = times.map(|row| case.at(row).unwrap_or(f64::NAN));
        excitation::cycles(&self.template, case, times)
    }

    /// The spectra of this set in a completed case at these periods, and the units of length and time; `None` without a set.
    pub fn set_spectra(&self, case: &Case, periods: &[f64]) -> Option<(SetSpectra, [String; 2])> {
        let spectra = ground_motion::set_spectra(&self.template, case, periods)?;
        Some((spectra, ground_motion::units(&self.template)))
    }

    /// The unit of a dimension as the study of a described structure names it; `None` if it names none.
    pub fn unit_name(&self, dimension: Dimension) -> Option<String> {
        let units = UnitNames::of(&self.template.units)?;
        Some(units.of_dimension(dimension))
    }

    /// The structure of a completed case for a picture; `None` if it cannot be assembled.
    pub fn scheme(&self, case: &Case) -> Option<Scheme> {
        scheme::scheme(&self.template, case)
    }

    /// The friction limit of each contact at the times of a motion, >= 0; `None` without friction.
    pub fn friction_limits(&self, case: &Case, motion: &History) -> Vec<Option<Vec<f64>>> {
        match self.structure(case, Model::Study) {
            Ok((structure, _)) => {
                friction_limits::of(&structure, &self.template, self.drawn.len(), motion)
            }
            Err(_) => Vec::new(),
        }
    }

    /// What was measured of the motion of a completed case, for each channel that the study gives; none without.
    pub fn measured(&self, case: &Case) -> Vec<MeasuredChannel> {
        let (Some(measured), Some(dt)) = (&self.template.measured, case.at(self.schema.step))
        else {
            return Vec::new();
        };
        match measured.in_case(case, dt, case.steps()) {
            Ok(compared) => compared.channels(),
            Err(_) => Vec::new(),
        }
    }

    /// The same, with the points that this metric compares.
    pub fn measured_by(&self, case: &Case, metric: usize) -> Vec<MeasuredChannel> {
        let window = &self.metrics[metric].window;
        let mut channels = self.measured(case);
        for channel in &mut channels {
            let compared = channel.compared.clone();
            let points = window.points(case, &channel.time[compared.clone()]);
            let inside =
                points.map(|points| compared.start + points.start..compared.start + points.end);
            channel.compared = inside.unwrap_or(compared.start..compared.start);
        }
        channels
    }

    /// What identifies the sampled signals of a completed case.
    pub fn samples(&self, case: &Case) -> Samples {
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

    /// What was done to input files that the study does not ask for, and what may be a mistake, in words.
    pub fn notes(&self) -> &[String] {
        &self.notes
    }

    /// Whether two completed cases have the same equations, steps and measured points to the bit. False if one cannot be solved.
    pub fn has_same_motion(&self, one: &Case, other: &Case) -> bool {
        let equations = |case| self.equations(case);
        equations(one).is_some_and(|of_one| equations(other) == Some(of_one))
            && self.measured(one) == self.measured(other)
    }

    /// Whether two completed cases are stepped side by side in a sweep. False for a case that cannot be solved.
    pub fn are_side_by_side(&self, one: &Case, other: &Case) -> bool {
        let ready = |case: &Case| self.ready(0, case).ok();
        let (Some(one), Some(other)) = (ready(one), ready(other)) else {
            return false;
        };
        let prepared = motion::prepare(&one.structure, &one.method, one.dt);
        one.last == other.last
            && prepared
                .is_ok_and(|prepared| prepared.fits(&other.method, &other.structure, other.dt))
    }

    /// What determines results and is neither in the parameters nor in the program; empty if there is nothing.
    pub fn identity(&self) -> &str {
        &self.identity
    }

    /// Number of sampled signals that were made so far; cases share them.
    pub fn sampled_so_far(&self) -> u64 {
        self.template
            .sampled()
            .map(|source| source.made_so_far())
            .sum()
    }

    /// The metrics in these rows of the exact motion of a completed case, at the times of its steps; `None` for those that are not known.
    pub fn exact_metrics(&self, case: &Case, rows: &[usize]) -> Vec<Option<f64>> {
        let values = self
            .ready(0, case)
            .and_then(|ready| self.exact_values(&ready, rows));
        values.unwrap_or_else(|_| vec![None; rows.len()])
    }
}
