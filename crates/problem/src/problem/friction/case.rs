//! A case of the oscillator as numbers, its system, and its default metrics in a sweep.

use super::law_of_case::{PlainLaw, PlainLawName, law, plain_law};
use super::metric_table::{DEFAULT, Shared, values};
use super::tables::rows;
use crate::contact::{AnyRunningLaw, ContactLaw, DisplacementControl, OneLaw, VelocityControl};
use crate::lane::Lane;
use crate::methods::{AverageAcceleration, Method, OneMode, Recursion};
use crate::metrics::friction::{Compared, Sampled, work_by_energy};
use crate::metrics::{last_time, steps};
use crate::problem::preset::Preset;
use crate::problem::{Case, method};
use crate::solve::sweep::{LaneCase, ReferenceKey};
use crate::solve::{
    Displacements, EachMethod, Loops, Motion, Steps, ToSystem, Track, Warning, Warnings,
};
use crate::system::{Linear, Mode, System};
use slipgap_contact::for_widest;

/// The oscillator: X'' + X + S = 0.
const UNIT: Mode = Mode::new(1.0, 1.0);

/// Share of its limit that friction reaches where it slides, as in structures.
const SLIDES: f64 = 0.95;

/// Cases in lanes: enough to fill the pipelines of the processor, because each step of a case waits for the one before it.
pub const LANES: usize = 16;

/// The parameters of a case.
#[derive(Debug, Clone, Copy)]
pub struct OscillatorCase<W = ContactLaw, M = Method> {
    pub law: W,
    pub method: M,
    /// S(0).
    pub force: f64,
    pub x0: f64,
    pub step: f64,
    pub duration: f64,
    pub last: u64,
}

/// A case with a law of `[F]` and constant average acceleration: the one that sweeps of millions have, and small.
pub type PlainCase = OscillatorCase<PlainLaw, AverageAcceleration>;

impl OscillatorCase {
    /// The parameters; `None` if one is not given.
    pub fn new(case: &Case) -> Option<OscillatorCase> {
        let (law, force) = law(case)?;
        let method = method::of_case(case, rows::METHOD)?;
        OscillatorCase::with(case, law, method, force)
    }

    /// The system, whose contact is in the scales of the problem.
    pub fn preset(&self) -> Preset {
        Preset {
            system: self.system(),
            factors: [1.0; 3],
        }
    }
}

impl PlainCase {
    /// The law of a case; `None` for another law or method. It depends on the parameters [`PlainCase::deciding`].
    pub fn law_name(case: &Case) -> Option<PlainLawName> {
        match method::has_rules(case, rows::METHOD) {
            true => None,
            false => PlainLawName::of(case),
        }
    }

    /// The parameters that decide whether a case has this form.
    pub fn deciding() -> impl Iterator<Item = usize> {
        PlainLawName::ROWS.into_iter().chain([rows::METHOD])
    }

    /// The parameters of a case with this law; `None` if one is not given.
    #[inline(always)]
    pub fn plain(case: &Case, name: PlainLawName) -> Option<PlainCase> {
        let (law, force) = plain_law(name, case)?;
        OscillatorCase::with(case, law, AverageAcceleration, force)
    }
}

impl<W, M> OscillatorCase<W, M> {
    #[inline(always)]
    fn with(case: &Case, law: W, method: M, force: f64) -> Option<Self> {
        let (step, duration) = (case.at(rows::DT)?, case.at(rows::DURATION)?);
        Some(OscillatorCase {
            law,
            method,
            force,
            x0: case.at(rows::X0)?,
            step,
            duration,
            last: steps(duration, step),
        })
    }

    /// Work of the friction force over |x0|.
    #[inline(always)]
    pub fn work<const L: usize, T>(&self, motion: &Motion<L, T>, lane: usize) -> f64 {
        match &motion.taken {
            None => {
                let [x, v, _] = &motion.end;
                work_by_energy(self.x0, [x.0[lane], v.0[lane]])
            }
            Some(taken) => taken.by_contact.0[lane] / self.x0.abs(),
        }
    }

    /// Whether the step is long for the period of the oscillator.
    #[inline(always)]
    pub fn has_long_step(&self) -> bool {
        self.step > LONG
    }

    /// The time of the last step, if `duration` is no multiple of the step.
    #[inline(always)]
    pub fn ends_early(&self) -> Option<f64> {
        last_time(self.duration, self.step, self.last)
    }

    /// The exact solution at the case's steps.
    pub fn exact_at_steps(&self) -> Sampled {
        Sampled::new(self.x0, self.step, self.last, self.duration)
    }
}

impl<W: Copy + Into<ContactLaw>, M> OscillatorCase<W, M> {
    /// The share of the limit that a law of `[F]` has at most where it never slides, if that is below the one that counts as sliding.
    ///
    /// A spring 1/alpha that is unloaded at x0 swings about x0 alpha/(1 + alpha), so that it has 2 x0/(1 + alpha) half a period later; a
    /// dashpot 1/beta has at most the velocity x0 of free vibration.
    #[inline(always)]
    pub fn share_without_sliding(&self) -> Option<f64> {
        let share = match PlainLaw::of(&self.law.into())? {
            PlainLaw::Displacement(law) if self.force == 0.0 => {
                2.0 * self.x0.abs() / (1.0 + law.compliance)
            }
            PlainLaw::Displacement(_) => return None,
            PlainLaw::Velocity(law) => self.x0.abs() / law.compliance,
        };
        (share < SLIDES).then_some(share)
    }

    /// The warnings of the case, which need no motion.
    #[inline(always)]
    pub fn own_warnings(&self) -> Warnings {
        Warnings::NONE
            .with(Warning::LongStep, self.has_long_step())
            .with(Warning::EndsEarly, self.ends_early().is_some())
            .with(Warning::NeverSlides, self.share_without_sliding().is_some())
    }
}

impl<W: Copy + Into<ContactLaw>, M: EachMethod> ToSystem for OscillatorCase<W, M> {
    type Methods = M;

    #[inline(always)]
    fn system(&self) -> System {
        System {
            linear: Linear::Oscillator {
                mode: UNIT,
                displacement: self.x0,
            },
            law: self.law.into(),
            gap: 0.0,
            force: self.force,
            step: self.step,
            last: self.last,
            method: self.method.into(),
        }
    }
}

/// omega dt from which a step is long: six steps in a period.
const LONG: f64 = 1.0;

/// The laws of `[F]` have loops of their own.
pub struct LawsOfPaper;

impl<const L: usize> Loops<L> for LawsOfPaper {
    fn step<N: Recursion<L>, T: Track<L>>(law: &mut AnyRunningLaw<L>, steps: Steps<'_, L, N, T>) {
        if let Some(law) = DisplacementControl::running(law) {
            steps.by_widest(law);
        } else if let Some(law) = VelocityControl::running(law) {
            steps.by_widest(law);
        } else {
            steps.by_widest(law);
        }
    }
}

impl<W: Copy + Into<ContactLaw>, M: EachMethod> LaneCase<LANES> for OscillatorCase<W, M> {
    type Reference = Sampled;
    type Modes = OneMode;
    type Track = Displacements<LANES>;
    type Loops = LawsOfPaper;
    type Metrics = [Lane<LANES>; DEFAULT.len()];
    type OneMetrics = [Lane<1>; DEFAULT.len()];

    fn reference_key(&self) -> ReferenceKey {
        [self.x0, self.step, self.duration, 0.0, 0.0]
    }

    fn reference(&self) -> Sampled {
        self.exact_at_steps()
    }

    fn metrics(
        cases: &[Self; LANES],
        motion: &Motion<LANES, Self::Track>,
        exact: &Sampled,
    ) -> Self::Metrics {
        let mut work = Lane::splat(0.0);
        for (l, case) in cases.iter().enumerate() {
            work.0[l] = case.work(motion, l);
        }
        evaluate_all(&motion.track.0[..exact.count()], work, exact)
    }

    #[inline(always)]
    fn warnings(&self, _: impl Fn(usize) -> f64) -> Warnings {
        self.own_warnings()
    }

    fn metrics_of_one(
        &self,
        motion: &Motion<LANES, Self::Track>,
        lane: usize,
        exact: &Sampled,
    ) -> Self::OneMetrics {
        let recorded = motion.track.0[..exact.count()].iter();
        let steps: Vec<_> = recorded.map(|x| Lane([x.0[lane]])).collect();
        values(&Shared {
            compared: Compared::new(&steps, exact),
            work: Lane([self.work(motion, lane)]),
        })
    }
}

for_widest! {
    /// All metrics of a group.
    #[allow(unused_braces, reason = "the macro puts them")]
    fn evaluate_all(x: &[Lane<LANES>], work: Lane<LANES>, exact: &Sampled) -> [Lane<LANES>; DEFAULT.len()] {
        values(&Shared {
            compared: Compared::new(x, exact),
            work,
        })
    }
}
