//! How a channel is reduced to a number.

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
        pub(crate) const ALL: [(Reduction, Takes); REDUCTIONS.len()] = [$((Reduction::$variant, Takes::$takes)),+];
    };
}

reductions! {
    Peak "peak" Channel "largest absolute value over the steps",
    Last "last" Channel "value at the last step",
    Min "min" Channel "smallest value over the steps",
    Max "max" Channel "largest value over the steps",
    Rms "rms" Channel "sqrt(mean c^2) over the steps",
    TimeOfPeak "time_of_peak" Channel "first time of the largest absolute value",
    Impacts "impacts" Contact "number of times that the contact closes: steps with S != 0 after one with S = 0; a contact that is closed at t = 0, S(0) != 0, counts, too",
    Impulse "impulse" Contact "integral of abs(S) over time, by trapezoids",
    ContactTime "contact_time" Contact "time with a contact force: the steps that end with S != 0, dt each",
    OpenTime "open_time" Contact "time without contact: for an impact the steps that end with S = 0, for friction those with limit 0",
    Work "work" Contact "work of the contact force on the structure's motion, integral of S dr by trapezoids; positive where the contact takes energy",
    ResidualSlip "residual_slip" Contact "slip at the last step minus slip at t = 0",
    Restitution "restitution" Contact "restitution of the first impact of a contact: -rdot at the first step with S = 0 after it over rdot at the last step with S = 0 before it, so that other forces on the nodes count as well; empty without impact, where the contact is closed at t = 0 or at the last step, and for a contact that is no impact",
    EnergyError "energy_error" Nothing "largest work of unbalanced forces up to any step, over the largest energy (kinetic, strain, and stored in contacts); numerical dissipation does not count; round-off where nothing moves",
    NumericalDissipation "numerical_dissipation" Nothing "energy that the method takes from the structure up to the last step, over the largest energy (kinetic, strain, and stored in contacts); below 0 where it adds energy; 0 to round-off for average-acceleration and where nothing moves",
    RmsError "rms_error" ChannelOrMeasured "sqrt(mean (c - e)^2) over the steps; e is the exact motion of contacts_reference",
    LastError "last_error" ChannelOrMeasured "abs(c - e) at the last step, such as the error of a residual displacement; e is the exact motion of contacts_reference",
    PeakError "peak_error" ChannelOrMeasured "abs(peak c - peak e) over the steps; e is the exact motion of contacts_reference",
    RegularisationError "regularisation_error" Channel "sqrt(mean (g - e)^2); g is the exact motion of the softened laws, e that of the rigid laws",
    StepError "step_error" Channel "sqrt(mean (c - g)^2); g is the exact motion of the softened laws",
    ReferenceError "reference_error" Channel "estimated error of g, where it is integrated because a law is not of straight lines: the larger one of sqrt(mean (g - h)^2) at every third step and the last one, g with a tolerance of 1e-12 and h with 1e-10, and of the part of sqrt(mean (g - c)^2) that the convergence of the steps dt to dt/64 does not explain; empty where g is by events",
    MeshError "mesh_error" Channel "sqrt(mean (g - f)^2); g is the exact motion of the softened laws, f the same with 4 times as many elements in every bar and the same contacts",
    ReductionError "reduction_error" Channel "sqrt(mean (c - f)^2) over the steps; f is the motion by the same steps with the whole matrices instead of reduced ones",
    Divergence "divergence" ChannelAndThreshold "first time at which this run and one with start and loads 1e-10 larger differ by more than the threshold times the peak; empty where never",
    ImpactsBeforeDivergence "impacts_before_divergence" ChannelAndThreshold "sum of impacts over all contacts that are impacts, of the steps before divergence; of all steps where it never comes",
    Difference "difference" Channel "largest difference over the steps between this run and one with start and loads 1e-10 larger, over the peak; empty where the channel is always 0",
    SpragueGeersMagnitude "sprague_geers_magnitude" MeasuredChannel "M = sqrt(I_cc/I_mm) - 1 with I_xy the integral of x y over the measured times by trapezoids: M > 0 where the computed motion is larger than the measured one",
    SpragueGeersPhase "sprague_geers_phase" MeasuredChannel "P = acos(I_cm/sqrt(I_cc I_mm))/pi: 0 for the same shape, 0.5 without correlation, 1 for the opposite sign",
    SpragueGeersCombined "sprague_geers_combined" MeasuredChannel "sqrt(M^2 + P^2) of sprague_geers_magnitude and sprague_geers_phase",
    EnergyPerCycle "energy_per_cycle" ContactOrMeasured "mean over the whole cycles of the integral of S dr; a cycle begins where r rises through the middle of its extremes after it was clearly below it; empty without a whole cycle",
    LoopDistance "loop_distance" MeasuredLoop "distance of the computed loop of two channels from the measured one, whatever the time: each over half its measured range, then the larger of the mean distances from the points of one loop to the lines of the other",
    GroundPga "ground.pga" Ground "largest acceleration of the ground at the steps, as the structure gets it: all measures of `ground` are of the part that is computed",
    GroundPgv "ground.pgv" Ground "largest velocity of the ground: its acceleration, straight between the points, integrated from rest; also between the points",
    GroundPgd "ground.pgd" Ground "largest displacement of the ground: its acceleration integrated twice from rest; a baseline changes it much",
    GroundArias "ground.arias" Ground "Arias intensity, pi/(2 g) times the integral of a^2 by trapezoids",
    GroundDuration "ground.d5_95" Ground "time from 5 to 95 % of the Arias intensity",
    GroundSpectral "ground.Sa" GroundAndOscillator "(2 pi/T)^2 times the largest displacement of an oscillator on the ground: ground.Sa(T, ratio), ratio 0.05 if left out; exact for straight lines between the steps",
    GroundMeanPeriod "ground.Tm" Ground "mean of 1/f weighted by the squared Fourier amplitudes from 0.25 to 20 Hz (Rathje et al. 1998)",
}

/// What a reduction is of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Takes {
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

/// What errors with `, measured` are: `m` is measured, `c` computed, straight between the steps.
pub(crate) const OF_MEASURED: [(Reduction, &str); 4] = [
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
        "mean abs(W_c - W_m) over mean abs(W_m), over the cycles of the measured r; empty without a whole cycle",
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
