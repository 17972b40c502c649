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
    EnergyPerCycle "energy_per_cycle" ContactOrMeasured "mean of the integral of S dr over whole cycles; a cycle begins where r rises through the middle of its extremes after it was 5 % of the half range below; the first one, from rest, counts; empty without one",
    LoopDistance "loop_distance" MeasuredLoop "distance of the computed and the measured loop of two channels, each over half its measured range: the larger of the mean distances from the points of one loop to the lines of the other",
    GroundPga "ground.pga" Ground "largest acceleration of the ground at the steps; all measures are of the motion that the structure gets, up to duration",
    GroundPgv "ground.pgv" Ground "largest velocity: the acceleration, straight between the points, integrated from rest",
    GroundPgd "ground.pgd" Ground "largest displacement: the same integrated twice; a baseline changes it much",
    GroundArias "ground.arias" Ground "Arias intensity, pi/(2 g) times the integral of a^2 by trapezoids",
    GroundDuration "ground.d5_95" Ground "time from 5 to 95 % of the Arias intensity",
    GroundSpectral "ground.Sa" GroundAndOscillator "ground.Sa(T, ratio), ratio 0.05 if left out: (2 pi/T)^2 times the largest displacement of an oscillator; exact for straight lines between the steps",
    GroundMeanPeriod "ground.Tm" Ground "mean of 1/f weighted by the squared Fourier amplitudes from 0.25 to 20 Hz (Rathje et al. 1998)",
    GroundFactor "ground.factor" Ground "factor of the whole motion by \"scale_to\", that of its set included",
    GroundSetFactor "ground.set_factor" Ground "factor of the set of \"scale_to\", the same for all its motions",
    GroundSetRatio "ground.set_ratio" Ground "least ratio of the spectrum of the set to what its rule asks for; at least 1 where the rule holds",
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

/// Reductions of the values of a channel alone: those that a test has, too.
pub const OF_VALUES: [Reduction; 6] = [
    Reduction::Peak,
    Reduction::Last,
    Reduction::Min,
    Reduction::Max,
    Reduction::Rms,
    Reduction::TimeOfPeak,
];

/// What stands in the brackets behind a reduction, in words; `None` without brackets.
pub fn in_brackets(name: &str) -> Option<&'static str> {
    let place = REDUCTIONS.iter().position(|known| known.0 == name)?;
    match ALL[place].1 {
        Takes::Nothing | Takes::Ground => None,
        Takes::Channel | Takes::ChannelOrMeasured => Some("NODE"),
        Takes::MeasuredChannel => Some("NODE, measured"),
        Takes::Contact | Takes::ContactOrMeasured => Some("CONTACT"),
        Takes::MeasuredLoop => Some("NODE, CONTACT.S, measured"),
        Takes::ChannelAndThreshold => Some("NODE, 0.01"),
        Takes::GroundAndOscillator => Some("1"),
    }
}

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

    /// Whether a value of it has the unit of its channel.
    pub fn is_in_unit_of_channel(self) -> bool {
        let of_values = [
            Reduction::Peak,
            Reduction::Last,
            Reduction::Min,
            Reduction::Max,
            Reduction::Rms,
            Reduction::PeakError,
        ];
        self.is_of_difference() || of_values.contains(&self)
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
