//! The motions that the metrics of a case need, and their values, one case at a time or side by side.

use super::exact_motion;
use super::metric_values;
use super::motion::{self, Recording, Run};
use super::recorded::{MetricContext, Motions, Recorded, distinct};
use super::sweep::Ready;
use crate::exact::events;
use crate::problem::Case;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::channels::channel::Number;
use crate::problem::structure::given::node::Numbering;
use crate::problem::structure::metrics::computed_ground::Steps;
use crate::problem::structure::metrics::function::{Function, Motion};
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::structure::metrics::reduction::Reduction;
use crate::problem::structure::model::assemble::{self, Model};
use crate::problem::structure::parts::template::Reference;
use crate::solve::structure::Prepared;
use crate::solve::{Unsolvable, Warning, Warnings};

/// Refinement of the mesh that `mesh_error` compares with.
const FINER: u32 = 4;

/// The motions of a case, its metrics and its warnings.
pub type JudgedCase = (Motions, Vec<Option<f64>>, Warnings);

impl StructureProblem {
    /// Whether a metric compares with this motion.
    fn needs(&self, motion: Motion) -> bool {
        let mut metrics = self.metrics.iter();
        metrics.any(|metric| metric.needs(motion))
    }

    /// Whether a metric is the estimated error of the exact motion.
    fn needs_estimate(&self) -> bool {
        let mut metrics = self.metrics.iter();
        metrics.any(|metric| metric.is_exact(Reduction::ReferenceError))
    }

    /// Cost of the exact motions of the metrics, in steps times modes; `one_run` is that of one run by steps.
    pub(crate) fn exact_work(&self, case: &Case, one_run: u64) -> u64 {
        if !self.metrics.iter().any(StructureMetric::needs_exact) {
            return 0;
        }
        let outline = assemble::outline(&self.template, case, Model::Study);
        let integrated = outline.is_ok_and(|outline| !events::knows_laws(&outline));
        let rigid = self.against_rigid();
        let against = self.needs(Motion::Reference);
        let softened = self.needs(Motion::Softened) || against && !rigid;
        let rigid = self.needs(Motion::Rigid) || against && rigid;
        let motions = u64::from(softened) + u64::from(rigid);
        // An integrated motion has 12 evaluations in a step at least, and 4 where its error is wanted.
        let without_halving = match (integrated, self.needs_estimate()) {
            (true, true) => 400,
            (true, false) => 300,
            (false, _) => 30,
        };
        let of_step = without_halving + self.halved_steps();
        let at_steps = one_run.saturating_mul(of_step);
        let of_one = at_steps.saturating_add(self.motion_work(case, Model::Study) as u64);
        let finer = match self.needs(Motion::Finer) {
            // As many nodes more in the motion at the steps.
            true => (self.motion_work(case, Model::Finer(FINER)) as u64)
                .saturating_add(at_steps.saturating_mul(u64::from(FINER))),
            false => 0,
        };
        of_one.saturating_mul(motions).saturating_add(finer)
    }

    /// Whether a metric compares with the run with start and loads that are 1e-10 larger.
    pub(crate) fn needs_perturbed(&self) -> bool {
        let mut metrics = self.metrics.iter();
        metrics.any(|metric| metric.reduction.needs(Motion::Perturbed))
    }

    /// Cost of the motion with the whole matrices, in steps times modes; 0 if no metric compares with it.
    pub(crate) fn unreduced_work(&self, case: &Case) -> u64 {
        let (true, Ok(numbering)) = (
            self.needs(Motion::Unreduced),
            assemble::check(&self.template, case),
        ) else {
            return 0;
        };
        let matrices = self.template.matrices.iter().enumerate();
        let more = matrices.map(|(block, matrices)| {
            let nodes = numbering.first_row(block + 1) - numbering.first_row(block);
            matrices.imported.len().saturating_sub(nodes)
        });
        self.stepping_work(case, numbering.nodes() + more.sum::<usize>())
    }

    /// Cost of the pieces of one exact motion.
    fn motion_work(&self, case: &Case, model: Model) -> f64 {
        let Ok(outline) = assemble::outline(&self.template, case, model) else {
            return 0.0;
        };
        let outline = match self.against_rigid() {
            // Without its static equilibrium, which does not count.
            true => motion::rigid(&outline).unwrap_or(outline),
            false => outline,
        };
        let points: usize = self
            .template
            .sampled()
            .filter_map(|source| Some(source.samples(case).ok()?.1))
            .sum();
        let duration = case.at(self.schema.duration).unwrap_or_default();
        events::work(&outline, duration, points)
    }

    /// The quantities that the metrics with these reductions need.
    pub(crate) fn numbers(
        &self,
        numbering: &Numbering,
        chosen: impl Fn(&StructureMetric) -> bool,
    ) -> Vec<Number> {
        let metrics = self.metrics.iter().filter(|metric| chosen(metric));
        let contacts = self.template.contacts.len();
        distinct(metrics.flat_map(|metric| metric_values::needed(metric, numbering, contacts)))
    }

    /// Whether errors are against the motion of the rigid laws.
    pub(crate) fn against_rigid(&self) -> bool {
        self.template.reference == Some(Reference::Rigid)
    }

    /// The metrics of a case, with these quantities recorded too: of the computed motion and, if the study asks for a reference, of
    /// the reference.
    pub(crate) fn solve_ready(
        &self,
        ready: &Ready,
        more: &[Number],
    ) -> Result<JudgedCase, Unsolvable> {
        if let Some(program) = self.program_of(&ready.case) {
            return self.solve_by_program(program, ready, more);
        }
        let of_metrics = self.numbers(&ready.numbering, |_| true);
        let numbers = distinct(of_metrics.into_iter().chain(more.iter().copied()));
        let recording = self.recording(ready, &numbers);
        let prepared = motion::prepare(&ready.structure, &ready.method, ready.dt)?;
        let [run] = motion::steps(&[&ready.structure], &prepared, recording);
        let [perturbed] = self.perturbed([ready], &prepared);
        self.judge(ready, run, perturbed, more)
    }

    /// The runs with start and loads that are 1e-10 larger, by the same linear part; none if no metric compares with them.
    pub(crate) fn perturbed<const L: usize>(
        &self,
        cases: [&Ready; L],
        prepared: &Prepared,
    ) -> [Option<Run>; L] {
        let needs = |metric: &StructureMetric| metric.reduction.needs(Motion::Perturbed);
        let (Some(first), true) = (cases.first(), self.needs_perturbed()) else {
            return [const { None }; L];
        };
        let needed_metrics = self.metrics.iter().filter(|metric| needs(metric));
        let channels = needed_metrics.filter_map(|metric| metric.channel.as_ref());
        let numbers = distinct(channels.flat_map(|channel| channel.numbers(&first.numbering)));
        let recording = Recording {
            last: first.last,
            numbers: &numbers,
            energy: false,
            watch: None,
        };
        let others = cases.map(|ready| motion::perturbed(&ready.structure));
        motion::steps(&others.each_ref(), prepared, recording).map(Some)
    }

    /// Why there is no exact motion, with the first metric that needs it.
    fn needing(&self, why: Unsolvable) -> Unsolvable {
        let mut metrics = self.metrics.iter();
        match (why, metrics.find(|metric| metric.needs_exact())) {
            (Unsolvable::Reference(why), Some(metric)) => {
                Unsolvable::Reference(format!("{why} ({} needs it)", metric.name))
            }
            (why, _) => why,
        }
    }

    pub(crate) fn recording<'a>(&self, ready: &Ready, numbers: &'a [Number]) -> Recording<'a> {
        Recording {
            last: ready.last,
            numbers,
            energy: {
                let mut metrics = self.metrics.iter();
                metrics
                    .any(|metric| matches!(metric.reduction.row().function, Function::Energies(_)))
            },
            watch: (!self.template.contacts.is_empty()).then_some(motion::EVERY),
        }
    }

    /// The metrics of a case from its run and the perturbed one, with the other motions that they need; the reference has these
    /// quantities more.
    pub(crate) fn judge(
        &self,
        ready: &Ready,
        run: Run,
        perturbed: Option<Run>,
        more: &[Number],
    ) -> Result<JudgedCase, Unsolvable> {
        let (computed, energies, watched) = run?;
        let Ready {
            structure,
            numbering,
            method,
            dt,
            last,
            ..
        } = ready;
        let mut motions = Motions {
            computed,
            energies,
            ..Motions::default()
        };
        if let Some(run) = perturbed {
            motions.perturbed = Some(run?.0);
        }
        let of_metrics = self.numbers(numbering, StructureMetric::needs_exact);
        let numbers = distinct(of_metrics.into_iter().chain(more.iter().copied()));
        let referred =
            self.needs(Motion::Reference) || self.template.reference.is_some() && !more.is_empty();
        let times: Vec<f64> = (0..=*last).map(|i| i as f64 * dt).collect();
        let rigid = self.against_rigid();
        if self.needs(Motion::Softened) || referred && !rigid {
            let exact = exact_motion::exact(structure, &times, &numbers);
            motions.softened = Some(exact.map_err(|why| self.needing(why))?);
        }
        if self.needs_estimate() {
            motions.coarse = exact_motion::coarse(structure, &times, &numbers)?;
            motions.reference_errors = self.reference_errors(ready, &motions);
        }
        if self.needs(Motion::Rigid) || referred && rigid {
            let exact = exact_motion::exact(&motion::rigid(structure)?, &times, &numbers);
            motions.rigid = Some(exact.map_err(|why| self.needing(why))?);
        }
        if self.needs(Motion::Finer) {
            let (finer, numbering) = self.structure(&ready.case, Model::Finer(FINER))?;
            let numbers = self.numbers(&numbering, |metric| metric.needs(Motion::Finer));
            motions.finer = Some((exact_motion::exact(&finer, &times, &numbers)?, numbering));
        }
        motions.unreduced = self.unreduced(ready)?;
        let compared = self.compared(ready)?;
        let of = MetricContext {
            case: &ready.case,
            structure,
            numbering,
            compared: compared.as_ref(),
            dt: *dt,
            against_rigid: rigid,
            impulses: method.has_impulses(),
        };
        let value = |metric: &StructureMetric| match &metric.ground {
            Some(ground) => {
                let steps = Steps {
                    dt: ready.dt,
                    last: ready.last as usize,
                };
                ground.value(metric.reduction, &self.template, &ready.case, steps)
            }
            None => metric_values::value(metric, of, &motions).filter(|x| x.is_finite()),
        };
        let values: Vec<Option<f64>> = self.metrics.iter().map(value).collect();
        let warnings = self.warnings_of(ready, &motions.computed, watched.as_ref())?;
        let is_far = self.is_far_from_measured(of, &motions.computed, &values);
        let warnings = warnings.with(Warning::MeasuredScale, is_far);
        Ok((motions, values, warnings))
    }

    /// The motion of a case with the whole matrices; `None` if no metric compares with it.
    fn unreduced(&self, ready: &Ready) -> Result<Option<(Recorded, Numbering)>, Unsolvable> {
        if !self.needs(Motion::Unreduced) {
            return Ok(None);
        }
        let (structure, numbering) = self.structure(&ready.case, Model::Unreduced)?;
        let numbers = self.numbers(&numbering, |metric| metric.needs(Motion::Unreduced));
        let recording = Recording {
            last: ready.last,
            numbers: &numbers,
            energy: false,
            watch: None,
        };
        let prepared = motion::prepare(&structure, &ready.method, ready.dt)?;
        let [run] = motion::steps(&[&structure], &prepared, recording);
        Ok(Some((run?.0, numbering)))
    }
}
