//! What a run says about cases that were solved and may still mislead: the kinds, and the set of a case.

/// Fewest steps in a contact of two masses on a spring that give its force within some percent.
pub const FEWEST_STEPS: f64 = 6.0;

/// What an impact with few steps needs.
pub const TOO_FEW_STEPS: &str = "too few for its force, take a smaller dt";

macro_rules! warnings {
    ($($variant:ident $name:literal $message:literal $meaning:literal),+ $(,)?) => {
        /// A kind of warning.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
        pub enum Warning {
            $(#[doc = $meaning] $variant),+
        }

        /// The kinds in the order of messages.
        pub const WARNINGS: [Warning; [$($name),+].len()] = [$(Warning::$variant),+];

        impl Warning {
            /// Its name.
            pub const fn name(self) -> &'static str {
                match self {
                    $(Warning::$variant => $name),+
                }
            }

            /// What its cases have, as in "3 of 40 cases have ...".
            pub const fn message(self) -> &'static str {
                match self {
                    $(Warning::$variant => $message),+
                }
            }

            /// When a case has it.
            pub const fn meaning(self) -> &'static str {
                match self {
                    $(Warning::$variant => $meaning),+
                }
            }
        }
    };
}

warnings! {
    ShortContact "short-contact"
        "have an impact that touches for fewer than 6 steps at the stiffness it reaches: too few for its force, take a smaller dt"
        "An impact that touches would last fewer than 6 steps with the free masses of its nodes, with delta^1.5 at the stiffness of the largest overlap; of bars `contact_steps` is shorter.",
    ContactGain "contact-gain"
        "have a contact whose work is negative by more than 1 % of the largest energy: it makes energy, and peaks may be far too high; take a smaller dt"
        "Up to some step, the work of a contact and what it stored at t = 0 are negative by more than 1 % of the largest energy.",
    BarGain "bar-gain"
        "have bars that gain more than 1 % of their energy; take a smaller dt or a softer contact"
        "`energy_drift_max` or `energy_drift_final` of the bars is above 1 %.",
    LongStep "long-step"
        "have a step that is long for the structure itself: fewer than 12 steps in the shortest period that matters; take a smaller dt"
        "With up to 200 nodes: a mode with fewer than 12 steps in its period causes at least 5 % of the motion of a metric under a load or ground motion alone, or from the start (links at their initial stiffness, no friction or impacts). In friction-oscillator, dT is above 1.",
    AlternatingForce "alternating-force"
        "have metrics of the force of a friction contact that alternates from step to step: use metrics of its work, or of displacements"
        "A metric uses the force of a friction contact that resists velocity, which alternates over 6 steps by more than 1 % of its peak.",
    UnheldPart "unheld-part"
        "have a part that nothing holds (a rigid-body mode): without contact and load it moves on freely"
        "Nothing holds a part: no spring, friction or contact that is elastic at t = 0 connects it with the ground, nor do impacts or restrainers hold it in both directions, together or with a lasting load such as its weight. An unloaded part with a start velocity or an impact may move freely.",
    ClosedAtStart "closed-at-start"
        "have an impact that is closed at t = 0 without a static equilibrium: it throws its bodies apart; a gap is open where r > 0"
        "At t = 0 an impact has r < 0, and no `static` sets it in equilibrium.",
    RecordPeak "record-peak"
        "have a record with a peak above 2 g or below 1e-4 g: look at its unit and its scale"
        "With `units`, a ground acceleration times its scale, which is not 0, has a peak above 2 g or below 1e-4 g.",
    DeepOverlap "deep-overlap"
        "have an impact that overlaps by more than its gap: it is soft, look at the units of k and of the masses"
        "With `units`, the largest overlap of an impact that does not yield is larger than its gap > 0 and than half of what r rises above the gap.",
    NormalWeight "normal-weight"
        "have contacts whose N together is far from the weight that rests on them: N is a force, look at its units"
        "With `units`, a part that only contacts with N hold has a sum of N below a quarter or above four times its mass times 9.81 m/s2.",
    NormalTension "normal-tension"
        "have friction without N at a step, since the springs that N names are in tension: look at their signs, and at the weight that presses them (`static`)"
        "N of a friction contact is the force of springs alone, and 0 at a step.",
    LargeRadius "large-radius"
        "have a pendulum with R above 100 m: look at its units"
        "With `units`, R of a contact is above 100 m.",
    SupportDrift "support-drift"
        "have a support that drifts away: a sine acceleration from rest has a mean velocity of amplitude/omega; a `phase` of pi/2 has none"
        "A `sine` acceleration of a support, without a `baseline`, has a mean velocity that moves it further than its amplitude up to `duration`.",
    SpringMass "spring-mass"
        "have a spring whose `mass` is not that of its nodes"
        "`mass` of a spring with a period is 1 % or more below the mass of its node (of two, m1 m2/(m1 + m2)), or above that of all nodes that springs and bars connect with it; nodes of matrices are left out.",
    SpringPeriod "spring-period"
        "have a spring with a period below 0.01 s: look at its unit"
        "With `units`, `period` of a spring is above 0 and below 0.01 s.",
    DampingRatio "damping-ratio"
        "have a damping ratio above 1: 0.05 is 5 %"
        "`ratio` of a spring or `modal_damping` is above 1.",
    DampedTwice "damped-twice"
        "have damping that is given twice: both act"
        "Two of these are not 0: `modal_damping`; `rayleigh`; C of matrices or `ratio` of springs.",
    FrictionCoefficient "friction-coefficient"
        "have a coefficient of friction above 2: 0.05 is 5 %"
        "`nu` of a contact is above 2.",
    CollidingMass "colliding-mass"
        "have an impact whose `colliding_mass` is far from m1 m2/(m1 + m2): its restitution is another one"
        "`colliding_mass` is below half of m1 m2/(m1 + m2) of the nodes, or above twice that of all that springs and bars connect with them; nodes of matrices are left out.",
    MatrixPeriods "matrix-periods"
        "have matrices whose longest period is below 0.05 s or above 10 s: M and K may be exchanged, or not be in `units`"
        "With `units`, the longest natural period of a structure with matrices, without contacts, is below 0.05 s or above 10 s.",
    IdleGravity "idle-gravity"
        "have `gravity` in a direction in which nothing carries weight"
        "`gravity` has a direction that no mass, bar or matrix has; or, with `units` and 9 m/s2 or more, one in which friction contacts alone hold a part.",
    FrictionDirections "friction-directions"
        "have friction contacts of different directions between the same bodies, whose limit together is a polygon: give one contact with \"plane\", whose limit is a disc"
        "Friction contacts act in different directions between the same nodes or supports, or between the ground and two equal masses.",
    WaveSpeed "wave-speed"
        "have a bar with a wave speed below 500 m/s or above 8000 m/s, or V0 above a 20th of it: look at the units of its stiffness, mass, length and V0"
        "With `units`, sqrt(EA L/mass) of a bar, or sqrt(E/rho) in bar-impact, is below 500 m/s or, with several elements, above 8000 m/s (steel 5000 m/s, concrete 3500 m/s); or V0 is above a 20th of it, a strain above 2.5 %.",
    MotionCut "motion-cut"
        "have a motion or a load of which less than 95 % is computed: the rest lies after `duration` or between steps"
        "The steps up to `duration` have less than 95 % of the peak, the Arias intensity or the target spectrum of a recorded motion (of another one: of the target), or a smaller displacement than the file of a support. Of other functions of time: the largest value up to `duration` (of a given displacement: velocity) is more than 5 % above that at the steps, or a sine has fewer than eight steps in a period.",
    MeasuredScale "measured-scale"
        "have measured values more than 50 times those of the motion, or below a 50th: look at the unit of the column"
        "The peak of a measured channel that a metric uses is more than 50 times that of the motion, or less than a 50th; of tests as a sample, the median of a metric.",
    EndsInContact "ends-in-contact"
        "end while the bars touch; `contact_duration` and `contact_steps` are undefined: take a longer `duration`"
        "The bars of bar-impact touch at the last step.",
    Undamped "undamped"
        "have no damping at all, and impacts under an earthquake: each one excites motions that do not decay"
        "Note: C is 0, there are impacts, and the ground or a support moves by a record or a synthetic motion.",
    EndsEarly "ends-early"
        "have a `duration` that is no multiple of the time step: the last step is before it"
        "Note: `duration` over the time step is no whole number.",
    TimeBefore "time-before"
        "have a table with times before 0: what is before 0 does not act"
        "Note: a load, a motion or N is a table whose first time is below 0.",
    Restitution "restitution"
        "have an impact whose law gives a restitution that is not its target"
        "Note: two rigid bodies of `colliding_mass`, or of the masses of the nodes, part with a restitution that differs from `restitution` by more than 0.05.",
    ImpactsAtOnce "impacts-at-once"
        "have rigid impacts that touch at t = 0 and bounce at once with others: Newton's rule acts on all of them together, and with a gap, one after the other, bodies part with other velocities"
        "Note: a rigid impact with `e` > 0, or one beside it, is closed at t = 0 and shares a body with another one.",
    ImpactsTwice "impacts-twice"
        "have two impacts with the same nodes, law and numbers: both act, so that the stiffness is twice theirs"
        "Note: two impacts have the same nodes with the same factors, the same gap, law and numbers.",
    NeverSlides "never-slides"
        "have friction that never slides: look at the units of N or of the limit"
        "At every step of every case, the force of a friction contact is below 95 % of its limit (of nu_min N, if given). An elastic contact in series with one that slides, yields or damps is left out. In friction-oscillator with a law of the paper, 2 x0/(1 + alpha), from an unloaded start, or x0/beta is below 0.95.",
    NoContact "no-contact"
        "have no contact before `duration`; their contact metrics are undefined or 0"
        "No impact touches in any case; a gap that stays open in some cases is a result.",
    NeverYields "never-yields"
        "have contacts with Fy of which none yields: look at the units of Fy"
        "At every step of every case, the forces of all contacts with `Fy` that act are below 95 % of it.",
    NeverPulls "never-pulls"
        "have restrainers of which none pulls: look at the units of their slack"
        "No contact with `slack` has a force at any step of any case.",
    Runaway "runaway"
        "have a structure that has lost its stability and runs away: peaks grow with `duration` and are no measure of the motion; a fragility figure counts it with `collapse`"
        "K is not positive semidefinite, or a link softens, and at the last step the structure is further from its equilibrium than ever, moves on, and its own forces push it further.",
    ProgramSize "program-size"
        "have a displacement more than 1000 times the exact one, by a program of others: it is no motion any more"
        "The peak of a displacement that a metric or figure needs, by a program of `programs`, is more than 1000 times that of the exact motion, where a metric compares with it.",
    ProgramGain "program-gain"
        "have an energy above what went in by more than 1 % of the largest, by a program of others: it makes energy"
        "Of a program of `programs` whose energies a metric or figure needs: at some step the energy is above that at t = 0 and the work of loads and supports by more than 1 % of the largest energy.",
    ProgramUnheld "program-unheld"
        "have a body that rests without a force that holds it, by a program of others: S is not the force with which it computes"
        "Of a program of `programs` whose energies a metric or figure needs: over the last tenth of the steps a body does not move, and the forces on it are out of equilibrium by more than 1 % of their sum.",
    ProgramNull "program-null"
        "have no value of a channel at some instants, by a program of others: metrics of it are empty"
        "Note: a channel of a program of `programs` has a null.",
    CheckNotMet "check-not-met"
        "do not meet a check; `slipgap check` lists all checks"
        "A check of the study is not met.",
}

/// The warnings of a case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Warnings(u64);

/// Each kind has a bit of its own.
const _: () = assert!(WARNINGS.len() <= u64::BITS as usize);

impl Warnings {
    /// No warning.
    pub const NONE: Warnings = Warnings(0);

    /// The set of a text of [`Warnings::names`]; unknown names are left out.
    pub fn parse(text: &str) -> Warnings {
        let known = |name: &str| WARNINGS.into_iter().find(|kind| kind.name() == name);
        let kinds = text.split(' ').filter_map(known);
        kinds.fold(Warnings::NONE, |set, kind| set.with(kind, true))
    }

    /// The names, with blanks between them.
    pub fn names(self) -> String {
        self.iter().map(Warning::name).collect::<Vec<_>>().join(" ")
    }

    /// Whether there are none.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Whether the case has this one.
    pub fn has(self, kind: Warning) -> bool {
        self.0 & kind.bit() != 0
    }

    /// The set with this one, if `applies`.
    #[must_use]
    pub fn with(self, kind: Warning, applies: bool) -> Warnings {
        match applies {
            true => Warnings(self.0 | kind.bit()),
            false => self,
        }
    }

    /// Its warnings, in the order of the table.
    pub fn iter(self) -> impl Iterator<Item = Warning> {
        WARNINGS.into_iter().filter(move |kind| self.has(*kind))
    }
}

impl Warning {
    /// Whether it is a warning only if every case of the study has it: in some cases it is a result.
    pub const fn is_of_all_cases(self) -> bool {
        matches!(
            self,
            Warning::NoContact | Warning::NeverSlides | Warning::NeverYields | Warning::NeverPulls
        )
    }

    /// What some cases of a study have and others do not: their parameters are the reason, not the units.
    pub const fn message_of_some(self) -> &'static str {
        if matches!(self, Warning::DeepOverlap) {
            return "have an impact that overlaps by more than its gap: its k is small for these masses";
        }
        self.message()
    }

    /// Whether a contact or a program may make energy: what such a case gives is no measure of the motion, and `recommend` does not choose it.
    pub const fn is_contact_energy(self) -> bool {
        matches!(
            self,
            Warning::ShortContact | Warning::ContactGain | Warning::ProgramGain
        )
    }

    /// Whether it is a note, which is not denied with the warnings.
    pub const fn is_note(self) -> bool {
        matches!(
            self,
            Warning::Restitution
                | Warning::ImpactsAtOnce
                | Warning::Undamped
                | Warning::EndsEarly
                | Warning::TimeBefore
                | Warning::ProgramNull
                | Warning::ImpactsTwice
        )
    }

    const fn bit(self) -> u64 {
        1 << self as u64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_has_what_was_put_in_and_reads_back() {
        assert!(Warnings::NONE.is_empty());
        let some = Warnings::NONE
            .with(Warning::RecordPeak, true)
            .with(Warning::ShortContact, true)
            .with(Warning::NoContact, false);
        let kinds: Vec<Warning> = some.iter().collect();
        assert_eq!(kinds, [Warning::ShortContact, Warning::RecordPeak]);
        assert_eq!(some.names(), "short-contact record-peak");
        assert_eq!(Warnings::parse(&some.names()), some);
        assert_eq!(
            Warnings::parse("other record-peak"),
            Warnings::NONE.with(Warning::RecordPeak, true)
        );
        assert!(Warnings::parse("").is_empty());
        let every_warning = WARNINGS
            .iter()
            .fold(Warnings::NONE, |warnings, kind| warnings.with(*kind, true));
        assert_eq!(
            Warnings::parse(&every_warning.names()).iter().count(),
            WARNINGS.len()
        );
    }

    #[test]
    fn names_differ_and_messages_fit_after_a_number_of_cases() {
        for (i, kind) in WARNINGS.iter().enumerate() {
            assert!(
                WARNINGS[..i]
                    .iter()
                    .all(|other| other.name() != kind.name())
            );
            let first = kind.message().split(' ').next();
            assert!(
                matches!(first, Some("have" | "do" | "end")),
                "{}",
                kind.message()
            );
        }
        assert!(Warning::ShortContact.message().ends_with(TOO_FEW_STEPS));
    }
}
