//! Reductions of the computed motion that may compare with what was measured: one table, as that of reductions.

use super::function::OfLoop;
use super::reduction::Reduction;
use crate::metrics::{measured, structure as of};

/// What a reduction of the computed motion is that compares with what was measured: `m` is measured, `c` computed, straight between the
/// steps.
#[derive(Clone, Copy)]
pub(crate) struct OfMeasured {
    reduction: Reduction,
    /// Its title, with `{}` for what it is of.
    pub title: &'static str,
    /// Whether it has the unit of the reduction.
    pub has_unit: bool,
    pub function: MeasuredFunction,
    pub meaning: &'static str,
}

/// What computes it.
#[derive(Clone, Copy)]
pub(crate) enum MeasuredFunction {
    /// Of a channel.
    Channel(fn(&[f64], [&[f64]; 2]) -> Option<f64>),
    /// Of the loop of a contact.
    Contact(OfLoop),
}

/// The reductions of the computed motion that may also compare with what was measured.
static OF_MEASURED: [OfMeasured; 4] = [
    OfMeasured {
        reduction: Reduction::RmsError,
        title: "rms error of {} against what was measured",
        has_unit: true,
        function: MeasuredFunction::Channel(|_, [c, m]| Some(of::rms_error(c, m))),
        meaning: "sqrt(mean (c - m)^2) at the measured times",
    },
    OfMeasured {
        reduction: Reduction::LastError,
        title: "error of last {} against what was measured",
        has_unit: true,
        function: MeasuredFunction::Channel(|_, [c, m]| Some((c.last()? - m.last()?).abs())),
        meaning: "abs(c - m) at the last measured time that is compared",
    },
    OfMeasured {
        reduction: Reduction::PeakError,
        title: "error of peak {} against what was measured",
        has_unit: true,
        function: MeasuredFunction::Channel(|_, [c, m]| Some((of::peak(c) - of::peak(m)).abs())),
        meaning: "abs(peak c - peak m) at the measured times",
    },
    OfMeasured {
        reduction: Reduction::EnergyPerCycle,
        title: "relative error of the energy per cycle of {}",
        has_unit: false,
        function: MeasuredFunction::Contact(measured::energy_per_cycle_error),
        meaning: "mean abs(W_c - W_m) over mean abs(W_m), in the cycles of the measured r",
    },
];

/// The reductions of the computed motion that may also compare with what was measured, each with what it then is.
pub fn of_measured() -> [(&'static str, &'static str); 4] {
    OF_MEASURED.map(|row| (row.reduction.name(), row.meaning))
}

impl Reduction {
    /// What it is of measurements, if it is of the computed motion, too.
    pub(crate) fn of_measured(self) -> Option<&'static OfMeasured> {
        OF_MEASURED.iter().find(|row| row.reduction == self)
    }
}
