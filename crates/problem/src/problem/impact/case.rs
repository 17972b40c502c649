//! A case of the bars as numbers, its system, and its default metrics in a sweep.

use super::scaled::Scaled;
use super::tables::{
    CONTACT_STEPS, DEFAULT, ENERGY_DRIFT_FINAL, ENERGY_DRIFT_MAX, MAX_OVERLAP, rows, values,
};
use crate::contact::{AnyRunningLaw, ImpactSpring, OneLaw, StoredEnergy, energies};
use crate::exact::wave::Wave;
use crate::lane::Lane;
use crate::methods::{ContactWork, ManyModes, Method, Recursion};
use crate::metrics::impact::{Compared, Energy, Sampled, Track, energy_of_books, step_work};
use crate::metrics::{last_time, steps};
use crate::problem::Case;
use crate::problem::preset::Preset;
use crate::solve::Track as AnyTrack;
use crate::solve::sweep::{LaneCase, ReferenceKey};
use crate::solve::{FEWEST_STEPS, Loops, Motion, Steps, ToSystem, Warning, Warnings};
use crate::system::{Linear, System};
use slipgap_contact::for_widest;

/// Cases in lanes: more of them, with all their modes, would not fit in the caches of the processor.
pub const LANES: usize = 16;

/// The parameters of a case, scaled.
#[derive(Debug, Clone, Copy)]
pub struct ImpactCase {
    /// Bars, spring and gap.
    pub scaled: Scaled,
    /// Time step in T_I.
    pub dt: f64,
    /// End of the run in T_I.
    pub duration: f64,
    /// Number of steps N.
    pub last: u64,
    /// Whether a bar is of no known material, if the units say so.
    pub has_strange_bar: bool,
}

impl ImpactCase {
    /// The parameters; `None` if one is not given.
    pub fn new(case: &Case) -> Option<ImpactCase> {
        let (dt, duration) = (case.at(rows::DT)?, case.at(rows::DURATION)?);
        Some(ImpactCase {
            scaled: Scaled::new(case)?,
            dt,
            duration,
            last: steps(duration, dt),
            has_strange_bar: false,
        })
    }

    /// The time of the last step, if `duration` is no multiple of the step.
    pub fn ends_early(&self) -> Option<f64> {
        last_time(self.duration, self.dt, self.last)
    }

    /// The system, and the scales of r, rdot and F in the problem.
    pub fn preset(&self) -> Preset {
        Preset {
            system: self.system(),
            factors: [1.0, 0.5, -1.0],
        }
    }

    /// The exact solution, and its samples at the steps of the case.
    pub fn exact_at_steps(&self) -> (Wave, Sampled) {
        let wave = self.scaled.bars.solve(self.duration);
        let sampled = Sampled::new(&wave, self.dt, self.last, self.duration);
        (wave, sampled)
    }
}

/// The system of a case. At t = 0 the contact force is zero, also for ends that touch.
pub fn system(scaled: &Scaled, step: f64, last: u64) -> System {
    System {
        linear: Linear::Bars(scaled.pair),
        law: scaled.law,
        gap: scaled.bars.gap,
        force: 0.0,
        step,
        last,
        method: scaled.method,
    }
}

impl ToSystem for ImpactCase {
    type Methods = Method;

    #[inline(always)]
    fn system(&self) -> System {
        system(&self.scaled, self.dt, self.last)
    }
}

/// The law of `[I]` has a loop of its own.
pub struct LawOfPaper;

impl<const L: usize> Loops<L> for LawOfPaper {
    fn step<N: Recursion<L>, T: AnyTrack<L>>(
        law: &mut AnyRunningLaw<L>,
        steps: Steps<'_, L, N, T>,
    ) {
        if let Some(law) = ImpactSpring::running(law) {
            steps.by_widest(law);
        } else {
            steps.by_widest(law);
        }
    }
}

impl LaneCase<LANES> for ImpactCase {
    type Reference = Sampled;
    type Modes = ManyModes;
    type Track = Track<LANES>;
    type Loops = LawOfPaper;
    type Metrics = [Lane<LANES>; DEFAULT.len()];
    type OneMetrics = [Lane<1>; DEFAULT.len()];

    fn reference_key(&self) -> ReferenceKey {
        let bars = self.scaled.bars;
        let (z, theta) = (bars.impedance_ratio, bars.time_ratio);
        [self.dt, self.duration, bars.gap, z, theta]
    }

    fn reference(&self) -> Sampled {
        self.exact_at_steps().1
    }

    fn condense(cases: &[Self; LANES], motion: &mut Motion<LANES, Self::Track>) {
        condense(cases, &mut motion.track);
    }

    fn metrics(
        cases: &[Self; LANES],
        motion: &Motion<LANES, Self::Track>,
        exact: &Sampled,
    ) -> Self::Metrics {
        let mut start = Lane::splat(0.0);
        let mut laws = [cases[0].system().law; LANES];
        for (l, case) in cases.iter().enumerate() {
            start.0[l] = case.system().linear.energy();
            laws[l] = case.system().law;
        }
        let restitution = motion.first_mode * 0.5;
        let evaluate = Evaluate {
            track: &motion.track,
            start,
            work: step_work(cases),
            restitution,
            exact,
        };
        match ImpactSpring::all(&laws) {
            Some(laws) => evaluate_all(evaluate, &laws),
            None => evaluate_all(evaluate, &laws),
        }
    }

    fn metrics_of_one(
        &self,
        motion: &Motion<LANES, Self::Track>,
        lane: usize,
        exact: &Sampled,
    ) -> Self::OneMetrics {
        let track = motion.track.lane(lane, exact.count());
        let restitution = Lane([motion.first_mode.0[lane] * 0.5]);
        let energy = Energy::of_case(&track, &self.system(), exact.count());
        values(&Compared::new(&track, &energy, restitution, exact))
    }

    #[inline(always)]
    fn warnings(&self, metrics: impl Fn(usize) -> f64) -> Warnings {
        // Half a step less: the metric is a whole number of steps with round-off.
        let short = metrics(CONTACT_STEPS) < (FEWEST_STEPS - 0.5) * self.dt;
        let gains = |row: usize| metrics(row) > GAIN;
        Warnings::NONE
            .with(Warning::ShortContact, short)
            .with(
                Warning::BarGain,
                gains(ENERGY_DRIFT_MAX) || gains(ENERGY_DRIFT_FINAL),
            )
            .with(
                Warning::EndsInContact,
                metrics(CONTACT_STEPS).is_nan() && !metrics(MAX_OVERLAP).is_nan(),
            )
            .with(Warning::NoContact, metrics(MAX_OVERLAP).is_nan())
            .with(Warning::EndsEarly, self.ends_early().is_some())
            .with(Warning::WaveSpeed, self.has_strange_bar)
    }
}

/// Gain of energy from which a case has a warning.
const GAIN: f64 = 0.01;

/// r of a rigid contact with a force: closed, with an overlap less than any round-off.
const CLOSED: f64 = -1e-300;

/// Changes the motion of the modes to that of the contacts, which differ if contact nodes have no mass, and finds where rigid contacts
/// touch.
pub fn condense<const L: usize>(cases: &[ImpactCase; L], track: &mut Track<L>) {
    let mut compliance = Lane::splat(0.0);
    let mut laws = [cases[0].scaled.law; L];
    for (l, case) in cases.iter().enumerate() {
        compliance.0[l] = case.scaled.pair.contact_compliance();
        laws[l] = case.scaled.law;
    }
    if compliance.0.iter().any(|c0| *c0 != 0.0) {
        match ImpactSpring::all(&laws) {
            Some(laws) => condense_all(track, &laws, &compliance),
            None => condense_all(track, &laws, &compliance),
        }
    }
    track.touching.clear();
    if laws[0].properties().is_vertical() {
        let states = track.displacement.iter().zip(&track.force);
        let touching = states.map(|(r, force)| {
            r.zip(
                *force,
                |r, force| if force > 0.0 { CLOSED } else { r.max(0.0) },
            )
        });
        track.touching = touching.collect();
    }
}

for_widest! {
    /// The motion of all contacts.
    fn condense_all<const L: usize, W: StoredEnergy>(
        track: &mut Track<L>,
        laws: &[W; L],
        c0: &Lane<L>,
    ) {
        track.condense(laws, c0);
    }
}

/// What the metrics of a group are computed from.
#[derive(Clone, Copy)]
struct Evaluate<'a> {
    track: &'a Track<LANES>,
    start: Lane<LANES>,
    work: ContactWork<LANES>,
    restitution: Lane<LANES>,
    exact: &'a Sampled,
}

for_widest! {
    /// All metrics of a group.
    #[allow(unused_braces, reason = "the macro puts them")]
    fn evaluate_all<W: StoredEnergy>(of: Evaluate, laws: &[W; LANES]) -> [Lane<LANES>; DEFAULT.len()] {
        let Evaluate {
            track,
            start,
            work,
            restitution,
            exact,
        } = of;
        let books = |r, s| energies(laws, r, s);
        let energy: Energy<LANES> = energy_of_books(track, start, &work, books, exact.count());
        values(&Compared::new(track, &energy, restitution, exact))
    }
}
