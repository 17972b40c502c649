//! Metrics of a structure: a reduction of a channel over time.

use super::channel::Channel;
use super::ground_metric::{GroundMetric, PREFIX, without_direction};

/// A metric of the study.
#[derive(Debug, Clone)]
pub struct StructureMetric {
    /// Its column: the text in the study, such as `peak(g1.right - p2)`.
    pub name: String,
    /// How the channel is reduced to a number.
    pub reduction: Reduction,
    /// The channel; none for measures of the ground, `energy_error` and `numerical_dissipation`.
    pub channel: Option<Channel>,
    /// The second channel of a loop.
    pub second: Option<Channel>,
    /// Whether it compares with what was measured.
    pub measured: bool,
    /// The contact of a reduction of contacts, by its place in the list.
    pub contact: Option<usize>,
    /// Whether it is of both directions of a contact in a plane, of which `contact` is the first one.
    pub in_plane: bool,
    /// The threshold of a divergence, over the peak.
    pub threshold: f64,
    /// What a measure of the ground is of.
    pub ground: Option<GroundMetric>,
    /// Byte offset and path of the text in the study.
    pub place: (usize, String),
}

macro_rules! reductions {
    ($($variant:ident $name:literal $takes:ident $meaning:literal),+ $(,)?) => {
        /// How a channel is reduced to a number.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Reduction {
            $(#[doc = $meaning] $variant),+
        }

        /// The reductions, each with its meaning.
        pub const REDUCTIONS: [(&str, &str); [$($name),+].len()] = [$(($name, $meaning)),+];

        /// The reductions, each with what it is of.
        pub(super) const ALL: [(Reduction, Takes); REDUCTIONS.len()] = [$((Reduction::$variant, Takes::$takes)),+];
    };
}

/// What a reduction is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Takes {
    Channel,
    Contact,
    Nothing,
    ChannelAndThreshold,
    ChannelOrMeasured,
    MeasuredChannel,
    ContactOrMeasured,
    MeasuredLoop,
    Ground,
    GroundAndOscillator,
}

reductions! {
    Peak "peak" Channel "largest absolute value over the steps",
    Last "last" Channel "value at the last step",
    Min "min" Channel "smallest value over the steps",
    Max "max" Channel "largest value over the steps",
    Rms "rms" Channel "sqrt(mean c^2) over the steps",
    TimeOfPeak "time_of_peak" Channel "first time of the largest absolute value",
    Impacts "impacts" Contact "times that the contact closes: steps with S != 0 after one with S = 0, and S(0) != 0",
    Impulse "impulse" Contact "integral of abs(S) over time, by trapezoids",
    ContactTime "contact_time" Contact "dt times the number of steps that end with S != 0",
    OpenTime "open_time" Contact "dt times the number of steps that end with S = 0, of friction with limit 0",
    Work "work" Contact "integral of S dr by trapezoids; positive where the contact takes energy",
    ResidualSlip "residual_slip" Contact "slip at the last step minus slip at t = 0",
    Restitution "restitution" Contact "restitution of the first impact: -rdot at the first step with S = 0 after it over rdot at the last one before it, other forces on the nodes included; empty without impact, with S != 0 at t = 0 or at the last step, and for other contacts",
    EnergyError "energy_error" Nothing "largest work of unbalanced forces up to any step, over the largest energy (kinetic, strain, in contacts); numerical dissipation does not count",
    NumericalDissipation "numerical_dissipation" Nothing "energy that the method takes, over the largest energy; below 0 where it adds energy; round-off for average-acceleration",
    RmsError "rms_error" ChannelOrMeasured "sqrt(mean (c - e)^2); e is the exact motion of contacts_reference",
    LastError "last_error" ChannelOrMeasured "abs(c - e) at the last step",
    PeakError "peak_error" ChannelOrMeasured "abs(peak c - peak e)",
    RegularisationError "regularisation_error" Channel "sqrt(mean (g - e)^2); g is the exact motion of the softened laws, e that of the rigid ones",
    StepError "step_error" Channel "sqrt(mean (c - g)^2)",
    ReferenceError "reference_error" Channel "estimated error of a g that is integrated: the larger of sqrt(mean (g - h)^2), h with a tolerance of 1e-10 instead of 1e-12, and the part of sqrt(mean (g - c)^2) that the convergence of the steps dt to dt/64 does not explain; empty where g is by events",
    MeshError "mesh_error" Channel "sqrt(mean (g - f)^2); f is g with 4 times as many elements in every bar",
    ReductionError "reduction_error" Channel "sqrt(mean (c - f)^2); f is the motion by the same steps with the whole matrices",
    Divergence "divergence" ChannelAndThreshold "first time at which this run and one with start and loads 1e-10 larger differ by more than the threshold times the peak; empty where never",
    ImpactsBeforeDivergence "impacts_before_divergence" ChannelAndThreshold "impacts of all contacts before the divergence, or of all steps",
    Difference "difference" Channel "largest difference between these two runs over the peak; empty where the channel is always 0",
    SpragueGeersMagnitude "sprague_geers_magnitude" MeasuredChannel "M = sqrt(I_cc/I_mm) - 1, I_xy the integral of x y over the measured times by trapezoids; above 0 where the computed motion is larger",
    SpragueGeersPhase "sprague_geers_phase" MeasuredChannel "P = acos(I_cm/sqrt(I_cc I_mm))/pi: 0 for the same shape, 0.5 without correlation, 1 for the opposite sign",
    SpragueGeersCombined "sprague_geers_combined" MeasuredChannel "sqrt(M^2 + P^2)",
    EnergyPerCycle "energy_per_cycle" ContactOrMeasured "mean of the integral of S dr over whole cycles; a cycle begins where r rises through the middle of its extremes after it was 5 % of the half range below; empty without one",
    LoopDistance "loop_distance" MeasuredLoop "distance of the computed and the measured loop of two channels, each over half its measured range: the larger of the mean distances from the points of one loop to the lines of the other",
    GroundPga "ground.pga" Ground "largest acceleration of the ground at the steps; all measures are of the motion that the structure gets, up to duration",
    GroundPgv "ground.pgv" Ground "largest velocity: the acceleration, straight between the points, integrated from rest",
    GroundPgd "ground.pgd" Ground "largest displacement: the same integrated twice; a baseline changes it much",
    GroundArias "ground.arias" Ground "Arias intensity, pi/(2 g) times the integral of a^2 by trapezoids",
    GroundDuration "ground.d5_95" Ground "time from 5 to 95 % of the Arias intensity",
    GroundSpectral "ground.Sa" GroundAndOscillator "ground.Sa(T, ratio), ratio 0.05 if left out: (2 pi/T)^2 times the largest displacement of an oscillator; exact for straight lines between the steps",
    GroundMeanPeriod "ground.Tm" Ground "mean of 1/f weighted by the squared Fourier amplitudes from 0.25 to 20 Hz (Rathje et al. 1998)",
}

/// What errors with `, measured` are: `m` is measured, `c` computed, straight between the steps.
const OF_MEASURED: [(Reduction, &str); 4] = [
    (
        Reduction::RmsError,
        "sqrt(mean (c - m)^2) at the measured times",
    ),
    (
        Reduction::LastError,
        "abs(c - m) at the last measured time that is compared",
    ),
    (
        Reduction::PeakError,
        "abs(peak c - peak m) at the measured times",
    ),
    (
        Reduction::EnergyPerCycle,
        "mean abs(W_c - W_m) over mean abs(W_m), in the cycles of the measured r",
    ),
];

/// The reductions of the computed motion that may also compare with what was measured, each with what it then is.
pub fn of_measured() -> [(&'static str, &'static str); 4] {
    OF_MEASURED.map(|(reduction, meaning)| (reduction.name(), meaning))
}

/// Reductions that compare with an exact motion, unless they compare with what was measured.
pub const ERRORS: [Reduction; 7] = [
    Reduction::RmsError,
    Reduction::LastError,
    Reduction::PeakError,
    Reduction::StepError,
    Reduction::RegularisationError,
    Reduction::ReferenceError,
    Reduction::MeshError,
];

impl Reduction {
    /// Whether it is the size of a difference of two motions, of a contact in a plane that of a vector.
    pub fn is_of_difference(self) -> bool {
        matches!(
            self,
            Reduction::RmsError
                | Reduction::LastError
                | Reduction::RegularisationError
                | Reduction::StepError
                | Reduction::ReferenceError
                | Reduction::MeshError
                | Reduction::ReductionError
        )
    }

    /// Whether it compares with the run with start and loads that are 1e-10 larger.
    pub fn needs_perturbed(self) -> bool {
        matches!(
            self,
            Reduction::Divergence | Reduction::ImpactsBeforeDivergence | Reduction::Difference
        )
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        let place = ALL.iter().position(|known| known.0 == self);
        place.map_or("", |place| REDUCTIONS[place].0)
    }

    /// Its meaning.
    pub fn meaning(self) -> &'static str {
        let place = ALL.iter().position(|known| known.0 == self);
        place.map_or("", |place| REDUCTIONS[place].1)
    }
}

/// Names of metrics of the whole structure.
pub const OF_ALL: [&str; 2] = ["energy_error", "numerical_dissipation"];

/// Whether a text has the form of a metric: `name(...)`, or one of [`OF_ALL`].
pub fn looks_like_metric(text: &str) -> bool {
    let name = text.split('(').next().unwrap_or_default().trim();
    let name = &*without_direction(name).0;
    let with_brackets = text.contains('(') && text.trim_end().ends_with(')');
    let known = REDUCTIONS.iter().any(|known| known.0 == name);
    known && (with_brackets || OF_ALL.contains(&name) || name.starts_with(PREFIX))
}

impl StructureMetric {
    /// Whether it is one of these reductions, and not of what was measured.
    pub fn is_exact(&self, reductions: &[Reduction]) -> bool {
        !self.measured && reductions.contains(&self.reduction)
    }

    /// Whether it compares with an exact motion.
    pub fn needs_exact(&self) -> bool {
        self.is_exact(&ERRORS)
    }

    /// Its meaning.
    pub fn meaning(&self) -> &'static str {
        let mut own = OF_MEASURED.iter().filter(|_| self.measured);
        let own = own.find(|own| own.0 == self.reduction);
        own.map_or(self.reduction.meaning(), |own| own.1)
    }
}

#[cfg(test)]
mod tests {
    use super::super::names::Names;
    use super::*;
    use crate::system::structure::Direction;

    fn names() -> Names {
        let owned = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
        Names::new(owned(&["p1", "p2"]), owned(&["g1"]), Vec::new()).with_contacts(owned(&["gap"]))
    }

    #[test]
    fn errors_of_measured_channels_are_of_no_exact_motion() {
        let metric = |text| StructureMetric::parse(text, &names()).unwrap();
        for (text, measured, exact) in [
            ("rms_error(p1)", false, true),
            ("rms_error(p1, measured)", true, false),
            ("last_error( p1 - p2 ,measured )", true, false),
            ("peak_error(gap.S, measured)", true, false),
            ("step_error(p1)", false, true),
            ("energy_per_cycle(gap)", false, false),
            ("energy_per_cycle(gap.S, measured)", true, false),
            ("loop_distance(gap.r, gap.S, measured)", true, false),
        ] {
            let metric = metric(text);
            assert_eq!(metric.name, text);
            assert_eq!(
                (metric.measured, metric.needs_exact()),
                (measured, exact),
                "{text}"
            );
            assert!(looks_like_metric(text));
        }
        assert_eq!(
            metric("rms_error(p1, measured)").channel,
            metric("peak(p1)").channel
        );
        let of_loop = metric("loop_distance(gap.r, gap.S, measured)");
        assert_eq!(of_loop.second, metric("peak(gap.S)").channel);
        assert_ne!(
            metric("rms_error(p1)").meaning(),
            metric("rms_error(p1, measured)").meaning()
        );
    }

    #[test]
    fn metrics_are_reductions_of_channels() {
        let metric = |text| StructureMetric::parse(text, &names()).unwrap();
        let peak = metric("peak( g1.right-p2 )");
        assert_eq!(peak.name, "peak( g1.right-p2 )");
        assert_eq!(peak.channel, metric("peak(g1.right - p2)").channel);
        assert_eq!(peak.reduction, Reduction::Peak);
        assert_eq!(
            metric("impacts(gap)").contact,
            metric("impacts(gap.S)").contact
        );
        for name in OF_ALL {
            assert_eq!(metric(name).reduction.name(), name);
            assert!(looks_like_metric(name));
        }
        let ground = |text| metric(text).ground.unwrap();
        assert_eq!(ground("ground.pga").direction, None);
        let spectral = ground("ground.y.Sa( T1 ,0.02)");
        assert_eq!(spectral.direction, Some(Direction::Y));
        assert_eq!(spectral.texts, ["T1", "0.02"]);
        assert!(looks_like_metric("ground.z.Tm") && !looks_like_metric("ground.x"));
        let divergence = metric("divergence(p1, 0.01)");
        assert_eq!(divergence.threshold, 0.01);
        for (text, part) in [
            ("peek(p1)", "no metric 'peek'"),
            ("peak(p3)", "no node or contact 'p3'"),
            ("peak", "needs a channel"),
            ("peak(p1", "')' is missing"),
            ("impacts(p1)", "no contact 'p1'"),
            ("energy_error(p1)", "has no channel"),
            ("divergence(p1)", "a channel and a threshold"),
            ("divergence(p1, 0)", "must be a number > 0"),
            ("ground.pga(1)", "has no brackets"),
            ("ground.Sa", "needs the period"),
            ("ground.y.Sa(1, 2, 3)", "needs the period"),
            ("ground.w.pga", "no metric 'ground.w.pga'"),
            (
                "peak(p1, measured)",
                "peak does not compare with what was measured",
            ),
            ("energy_error(measured)", "has no channel"),
            (
                "step_error(p1,measured)",
                "these do: rms_error, last_error, peak_error, sprague_geers_magnitude,",
            ),
            ("rms_error(, measured)", "needs a channel"),
            ("rms_error(measured)", "no node or contact 'measured'"),
            (
                "sprague_geers_phase(p1)",
                "sprague_geers_phase(CHANNEL, measured)",
            ),
            ("loop_distance(p1, p2)", "a loop of two channels"),
            ("loop_distance(p1, measured)", "a loop of two channels"),
            ("loop_distance(p1, p2, p1, measured)", "'p2,'"),
        ] {
            let why = StructureMetric::parse(text, &names()).unwrap_err();
            assert!(why.contains(part), "{text}: {why}");
        }
    }
}
