//! How a channel is reduced to a number: one table, in which a row has all that a reduction is.

use super::function::{Function, Motion, OfGround, Plane, UnitOf};
use crate::contact::ContactKind;
use crate::metrics::measured as of_measured;
use crate::metrics::residual;
use crate::metrics::structure as of;
use crate::problem::structure::channels::channel::Quantity as Q;
use crate::system::loads::measures::Measure;

/// A row of the table.
#[derive(Clone, Copy)]
pub(crate) struct Row {
    reduction: Reduction,
    name: &'static str,
    pub takes: Takes,
    pub unit: UnitOf,
    /// Its title, with `{}` for what it is of.
    pub title: &'static str,
    pub function: Function,
    meaning: &'static str,
}

macro_rules! reductions {
    ($($variant:ident $name:literal $takes:ident $unit:ident $title:literal $function:expr; $meaning:literal),+ $(,)?) => {
        /// How a channel is reduced to a number.
        #[derive(Debug, Clone, Copy, PartialEq, Eq)]
        pub enum Reduction {
            $(#[doc = $meaning] $variant),+
        }

        /// The reductions, each with its meaning.
        pub const REDUCTIONS: [(&str, &str); [$($name),+].len()] = [$(($name, $meaning)),+];

        /// The rows, in the order of the variants.
        static ROWS: [Row; REDUCTIONS.len()] = [$(Row {
            reduction: Reduction::$variant,
            name: $name,
            takes: Takes::$takes,
            unit: UnitOf::$unit,
            title: $title,
            function: $function,
            meaning: $meaning,
        }),+];
    };
}

use Function::{
    Contact, Distance, Energies, Estimated, Ground, Loop, Measured, Pair, Perturbed, Told, Values,
};
use Motion::{Computed, Finer, Reference, Rigid, Softened, Unreduced};

reductions! {
    Peak "peak" Channel Channel "peak {}" Values(|c, _| Some(of::peak(c)));
    "largest absolute value over the steps",
    Last "last" Channel Channel "last {}" Values(|c, _| c.last().copied());
    "value at the last step",
    Min "min" Channel Channel "smallest {}" Values(|c, _| Some(of::extent(c)[0]));
    "smallest value over the steps",
    Max "max" Channel Channel "largest {}" Values(|c, _| Some(of::extent(c)[1]));
    "largest value over the steps",
    Rms "rms" Channel Channel "rms {}" Values(|c, _| Some(of::rms(c)));
    "sqrt(mean c^2) over the steps",
    Mean "mean" Channel Channel "mean {}" Values(residual::mean);
    "mean over time by trapezoids",
    Residual "residual" Channel Channel "residual {}" Values(residual::residual);
    "what remains after free vibration: mean over the whole cycles in the second half of the motion or window (in all of it if the half has none; without any, the mean of the half)",
    TimeOfPeak "time_of_peak" Channel Time "time of peak {}" Values(|c, time| of::step_of_peak(c).map(time));
    "first time of the largest absolute value",
    Impacts "impacts" Contact None "number of impacts of {}"
    Contact(&[Q::Force], Plane::No, |contact| Some(of::closings(&contact.force()) as f64));
    "times that the contact closes: steps with S != 0 after one with S = 0, and S(0) != 0",
    Impulse "impulse" Contact Impulse "impulse of {}"
    Contact(&[Q::Force], Plane::OfSizes, |contact| Some(of::impulse(&contact.force(), contact.dt)));
    "integral of abs(S) over time, by trapezoids",
    ContactTime "contact_time" Contact Time "contact time of {}"
    Contact(&[Q::Force], Plane::No, |contact| Some(of::time_where(&contact.force(), contact.dt, |s| s != 0.0)));
    "dt times the number of steps that end with S != 0",
    OpenTime "open_time" Contact Time "open time of {}"
    Contact(&[Q::Force, Q::Limit], Plane::Same, |contact| Some(match contact.kind {
        ContactKind::Impact => of::time_where(&contact.force(), contact.dt, |s| s == 0.0),
        ContactKind::Friction => of::time_where(&(contact.of)(Q::Limit), contact.dt, |limit| limit <= 0.0),
        ContactKind::Link => 0.0,
    }));
    "dt times the number of steps that end with S = 0, of friction with limit 0",
    Work "work" Contact Energy "work of {}"
    Contact(&[Q::Force, Q::Displacement, Q::Velocity], Plane::Sum, |contact| Some(match contact.by_impulses {
        true => of::work_of_impulses(&contact.force(), &(contact.of)(Q::Velocity), contact.dt),
        false => of::work(&contact.force(), &(contact.of)(Q::Displacement)),
    }));
    "integral of S dr by trapezoids; positive where the contact takes energy",
    ResidualSlip "residual_slip" Contact Length "residual slip of {}"
    Contact(&[Q::Slip], Plane::Vector, |contact| {
        let slip = (contact.of)(Q::Slip);
        Some(slip.last()? - slip.first()?)
    });
    "slip at the last step minus slip at t = 0",
    Restitution "restitution" Contact None "restitution of {}"
    Contact(&[Q::Force, Q::Velocity], Plane::No, |contact| match contact.kind {
        ContactKind::Impact => of::restitution(&contact.force(), &(contact.of)(Q::Velocity)),
        ContactKind::Friction | ContactKind::Link => None,
    });
    "restitution of the first impact: -rdot at the first step with S = 0 after it over rdot at the last one before it, other forces included; empty without impact, with S != 0 at t = 0 or at the last step, and for other contacts",
    EnergyError "energy_error" Nothing None "energy error" Energies(|[error, _]| error);
    "largest work of unbalanced forces up to any step, over the largest energy (kinetic, strain, in contacts), without numerical dissipation",
    NumericalDissipation "numerical_dissipation" Nothing None "numerical dissipation" Energies(|[_, dissipation]| dissipation);
    "energy that the method takes, over the largest energy; below 0 where it adds energy; round-off for average-acceleration",
    Cost "cost" Nothing None "cost" Told;
    "count that a program of `programs` gives of its work on a case; otherwise empty",
    Wall "wall" Nothing Time "seconds of a case" Told;
    "seconds from the request of a case to the answer of a program of `programs`; other in each run; otherwise empty",
    RmsError "rms_error" ChannelOrMeasured Channel "rms error of {}"
    Distance([Computed, Reference], |c, e| Some(of::rms_error(c, e)));
    "sqrt(mean (c - e)^2); e is the exact motion of contacts_reference",
    LastError "last_error" ChannelOrMeasured Channel "error of last {}"
    Distance([Computed, Reference], |c, e| Some((c.last()? - e.last()?).abs()));
    "abs(c - e) at the last step",
    PeakError "peak_error" ChannelOrMeasured Channel "error of peak {}"
    Pair([Computed, Reference], |c, e| Some((of::peak(c) - of::peak(e)).abs()));
    "abs(peak c - peak e)",
    RegularisationError "regularisation_error" Channel Channel "regularisation error of {}"
    Distance([Softened, Rigid], |g, e| Some(of::rms_error(g, e)));
    "sqrt(mean (g - e)^2); g is the exact motion of the softened laws, e that of the rigid ones",
    StepError "step_error" Channel Channel "step error of {}"
    Distance([Computed, Softened], |c, g| Some(of::rms_error(c, g)));
    "sqrt(mean (c - g)^2)",
    ReferenceError "reference_error" Channel Channel "reference error of {}" Estimated;
    "estimated error of an integrated g: the larger of sqrt(mean (g - h)^2), h with a tolerance of 1e-10 instead of 1e-12, and the part of step_error that the convergence from dt to dt/64 does not explain; empty where g is by events",
    MeshError "mesh_error" Channel Channel "mesh error of {}"
    Distance([Softened, Finer], |g, f| Some(of::rms_error(g, f)));
    "sqrt(mean (g - f)^2); f is g with 4 times as many elements in every bar",
    ReductionError "reduction_error" Channel Channel "reduction error of {}"
    Distance([Computed, Unreduced], |c, f| Some(of::rms_error(c, f)));
    "sqrt(mean (c - f)^2); f is the motion by the same steps with the whole matrices",
    Divergence "divergence" ChannelAndThreshold Time "time of divergence of {} by {threshold}"
    Perturbed(|runs| {
        let step = of::divergence(runs.values, runs.other, runs.threshold).filter(|_| !(runs.is_still)())?;
        Some(step as f64 * runs.dt)
    });
    "first time at which a run with start and loads 1e-10 larger differs by more than the threshold times the peak; empty where never",
    ImpactsBeforeDivergence "impacts_before_divergence" ChannelAndThreshold None "impacts before divergence of {} by {threshold}"
    Perturbed(|runs| {
        let end = of::divergence(runs.values, runs.other, runs.threshold).filter(|_| !(runs.is_still)());
        Some((runs.impacts)(end.unwrap_or(runs.values.len())) as f64)
    });
    "impacts of all contacts before the divergence, or of all steps",
    Difference "difference" Channel None "relative difference of {} of two starts"
    Perturbed(|runs| of::difference(runs.values, runs.other).filter(|_| !(runs.is_still)()));
    "largest difference between these two runs over the peak; empty where the channel is always 0",
    SpragueGeersMagnitude "sprague_geers_magnitude" MeasuredChannel None "magnitude error (Sprague-Geers) of {}"
    Measured(|times, [c, m]| Some(of_measured::sprague_geers(times, c, m)?.magnitude));
    "M = sqrt(I_cc/I_mm) - 1, I_xy the integral of x y over the measured times; above 0 where the computed motion is larger (Schwer 2007)",
    SpragueGeersPhase "sprague_geers_phase" MeasuredChannel None "phase error (Sprague-Geers) of {}"
    Measured(|times, [c, m]| Some(of_measured::sprague_geers(times, c, m)?.phase));
    "P = acos(I_cm/sqrt(I_cc I_mm))/pi: 0 for the same shape, 0.5 without correlation, 1 for the opposite sign",
    SpragueGeersCombined "sprague_geers_combined" MeasuredChannel None "combined error (Sprague-Geers) of {}"
    Measured(|times, [c, m]| Some(of_measured::sprague_geers(times, c, m)?.combined));
    "sqrt(M^2 + P^2)",
    EnergyPerCycle "energy_per_cycle" ContactOrMeasured Energy "energy per cycle of {}"
    Contact(&[Q::Force, Q::Displacement], Plane::Sum, |contact| of_measured::energy_per_cycle(&(contact.of)(Q::Displacement), &contact.force()));
    "mean of the integral of S dr over whole cycles; a cycle begins where r rises through the middle of its extremes after it was 5 % of the half range below; without a window the one from rest counts, too; empty without one",
    LoopDistance "loop_distance" MeasuredLoop None "distance of the loop of {} and {} from the measured one"
    Loop(of_measured::loop_distance);
    "distance of the computed and the measured loop of two channels, each over half its measured range: the larger mean distance from the points of one to the lines of the other (Dubuisson and Jain 1994)",
    GroundPga "ground.pga" Ground Acceleration "peak ground acceleration" Ground(OfGround::Measure(Measure::PeakAcceleration));
    "largest acceleration at the steps; all measures are of the scaled motion up to duration",
    GroundPgv "ground.pgv" Ground Velocity "peak ground velocity" Ground(OfGround::Measure(Measure::PeakVelocity));
    "largest velocity: the acceleration, straight between the points, integrated from rest",
    GroundPgd "ground.pgd" Ground Length "peak ground displacement" Ground(OfGround::Measure(Measure::PeakDisplacement));
    "largest displacement: the same integrated twice; a baseline changes it much",
    GroundArias "ground.arias" Ground Velocity "Arias intensity of the ground" Ground(OfGround::Measure(Measure::Arias));
    "Arias intensity, pi/(2 g) times the integral of a^2 by trapezoids",
    GroundDuration "ground.d5_95" Ground Time "duration of the ground motion from 5 to 95 %" Ground(OfGround::Measure(Measure::Duration));
    "time from 5 to 95 % of the Arias intensity",
    GroundSpectral "ground.Sa" GroundAndOscillator Acceleration "spectral acceleration of the ground" Ground(OfGround::Oscillator);
    "ground.Sa(T, ratio), ratio default 0.05: (2 pi/T)^2 times the largest displacement of an oscillator",
    GroundMeanPeriod "ground.Tm" Ground Time "mean period of the ground" Ground(OfGround::Measure(Measure::MeanPeriod));
    "mean of 1/f weighted by the squared Fourier amplitudes from 0.25 to 20 Hz (Rathje et al. 1998)",
    GroundFactor "ground.factor" Ground None "factor of the ground motion" Ground(OfGround::Factor);
    "factor of the whole motion by \"scale_to\", that of its set included",
    GroundSetFactor "ground.set_factor" Ground None "factor of the set of ground motions" Ground(OfGround::SetFactor);
    "factor of the set of \"scale_to\", the same for all its motions",
    GroundSetRatio "ground.set_ratio" Ground None "least ratio of the set to its rule" Ground(OfGround::SetRatio);
    "least ratio of the spectrum of the set to what its rule asks for; at least 1 where the rule holds",
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

/// What stands in the brackets behind a reduction, in words; `None` without brackets.
pub fn in_brackets(name: &str) -> Option<&'static str> {
    match Reduction::named(name)?.row().takes {
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
    /// All reductions.
    pub fn all() -> impl Iterator<Item = Reduction> {
        ROWS.iter().map(|row| row.reduction)
    }

    /// The reduction with this name.
    pub fn named(name: &str) -> Option<Reduction> {
        let row = ROWS.iter().find(|row| row.name == name);
        row.map(|row| row.reduction)
    }

    /// Its row.
    pub(crate) fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }

    /// Whether it is of the values of a channel alone: a test has it, too, and an exact motion.
    pub fn is_of_values(self) -> bool {
        matches!(self.row().function, Values(_))
    }

    /// Whether it compares this motion with another one.
    pub fn needs(self, motion: Motion) -> bool {
        match self.row().function {
            Distance(motions, _) | Pair(motions, _) => motions.contains(&motion),
            Estimated => motion == Softened,
            Perturbed(_) => motion == Motion::Perturbed,
            Values(_) | Contact(..) | Energies(_) | Measured(_) | Loop(_) | Ground(_) | Told => {
                false
            }
        }
    }

    /// Whether it compares with an exact motion.
    pub fn needs_exact(self) -> bool {
        match self.row().function {
            Distance(motions, _) | Pair(motions, _) => motions.iter().any(|own| own.is_exact()),
            Estimated => true,
            Perturbed(_) | Values(_) | Contact(..) | Energies(_) | Measured(_) | Loop(_)
            | Ground(_) | Told => false,
        }
    }

    /// Whether a contact in a plane has it as a whole.
    pub fn is_in_plane(self) -> bool {
        matches!(self.row().function, Contact(_, plane, _) if plane != Plane::No)
    }

    /// Whether a value of it has the unit of its channel.
    pub fn is_in_unit_of_channel(self) -> bool {
        self.row().unit == UnitOf::Channel
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// Its meaning; of what was measured, where it compares with that.
    pub fn meaning(self, measured: bool) -> &'static str {
        let own = self.of_measured().filter(|_| measured);
        own.map_or(self.row().meaning, |own| own.meaning)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_is_at_the_place_of_its_reduction_and_has_a_form_that_its_text_gives() {
        for (place, reduction) in Reduction::all().enumerate() {
            let row = reduction.row();
            assert_eq!((reduction as usize, row.reduction), (place, reduction));
            assert_eq!(Reduction::named(row.name), Some(reduction));
            // What is in the brackets is what the function needs.
            let fits = match row.function {
                Values(_) | Estimated => row.takes == Takes::Channel,
                Distance([_, Reference], _) | Pair([_, Reference], _) => {
                    row.takes == Takes::ChannelOrMeasured
                }
                Distance(..) | Pair(..) => row.takes == Takes::Channel,
                Perturbed(_) => [Takes::Channel, Takes::ChannelAndThreshold].contains(&row.takes),
                Contact(..) => [Takes::Contact, Takes::ContactOrMeasured].contains(&row.takes),
                Energies(_) | Told => row.takes == Takes::Nothing,
                Measured(_) => row.takes == Takes::MeasuredChannel,
                Loop(_) => row.takes == Takes::MeasuredLoop,
                Ground(OfGround::Oscillator) => row.takes == Takes::GroundAndOscillator,
                Ground(_) => row.takes == Takes::Ground,
            };
            assert!(fits, "{}", row.name);
            let may = [Takes::ChannelOrMeasured, Takes::ContactOrMeasured].contains(&row.takes);
            assert_eq!(reduction.of_measured().is_some(), may, "{}", row.name);
            let places = row.title.matches("{}").count();
            let of = match row.takes {
                Takes::Nothing | Takes::Ground | Takes::GroundAndOscillator => 0,
                Takes::MeasuredLoop => 2,
                Takes::Channel
                | Takes::Contact
                | Takes::ChannelAndThreshold
                | Takes::ChannelOrMeasured
                | Takes::MeasuredChannel
                | Takes::ContactOrMeasured => 1,
            };
            assert_eq!(places, of, "{}", row.title);
        }
    }
}
