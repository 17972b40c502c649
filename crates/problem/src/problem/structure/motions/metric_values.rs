//! The metrics of a case from its recorded motions.

use super::measured_metrics;
use super::recorded::{MetricContext, Motions, Recorded};
use super::still::Still;
use crate::contact::{ClippedLine, ContactKind};
use crate::metrics::measured::energy_per_cycle;
use crate::metrics::structure as reduce;
use crate::problem::structure::channels::channel::{Number, Quantity};
use crate::problem::structure::given::node::Numbering;
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::structure::metrics::reduction::Reduction;

/// The quantities that a metric of a structure with so many contacts needs.
pub fn needed(metric: &StructureMetric, numbering: &Numbering, contacts: usize) -> Vec<Number> {
    let channels = metric.channel.iter().chain(&metric.second);
    let of_channel = channels.flat_map(|channel| channel.numbers(numbering));
    let rows = metric.contact.into_iter().flat_map(|first| {
        let last = first + usize::from(metric.in_plane);
        first..=last
    });
    let of_contact = rows.flat_map(|contact| {
        let quantities: &[Quantity] = match metric.reduction {
            Reduction::OpenTime => &[Quantity::Force, Quantity::Limit],
            Reduction::Work => &[Quantity::Force, Quantity::Displacement, Quantity::Velocity],
            Reduction::ResidualSlip => &[Quantity::Slip],
            Reduction::Restitution => &[Quantity::Force, Quantity::Velocity],
            Reduction::EnergyPerCycle => &[Quantity::Force, Quantity::Displacement],
            _ => &[Quantity::Force],
        };
        quantities
            .iter()
            .map(move |quantity| Number::Contact(contact, *quantity))
    });
    // Which of them are impacts, the case decides.
    let all = match metric.reduction {
        Reduction::ImpactsBeforeDivergence => 0..contacts,
        _ => 0..0,
    };
    let forces = all.map(|contact| Number::Contact(contact, Quantity::Force));
    of_channel.chain(of_contact).chain(forces).collect()
}

/// The value of a metric; `None` where it is undefined.
pub fn value(metric: &StructureMetric, of: MetricContext, motions: &Motions) -> Option<f64> {
    match metric.reduction {
        Reduction::EnergyError => return Some(motions.energies?.error),
        Reduction::NumericalDissipation => return Some(motions.energies?.dissipation),
        _ => {}
    }
    if metric.measured {
        return measured_metrics::value(metric, of, &motions.computed);
    }
    if let (Some(first), true) = (metric.contact, metric.in_plane) {
        return of_plane(metric.reduction, first, of, &motions.computed);
    }
    if let Some(contact) = metric.contact {
        return of_contact(metric.reduction, contact, of, &motions.computed);
    }
    let channel = metric.channel.as_ref()?;
    if let (Some(both), true) = (channel.by_direction(), metric.reduction.is_of_difference()) {
        // The rms of a distance is the length of those of its directions.
        let values = both.map(|channel| {
            let own = StructureMetric {
                channel: Some(channel),
                ..metric.clone()
            };
            value(&own, of, motions)
        });
        let [first, second] = values;
        return Some(libm::hypot(first?, second?));
    }
    let series = |motion: &Recorded| motion.channel(channel, of.numbering);
    let exact = |motion: &Option<Recorded>| motion.as_ref().map(series);
    let reference = || match of.against_rigid {
        true => exact(&motions.rigid),
        false => exact(&motions.softened),
    };
    let c = series(&motions.computed);
    let is_still = || {
        let still = Still::of(of.structure, of.dt, c.len().saturating_sub(1));
        still.is_channel(channel, (&motions.computed, of.numbering), &c)
    };
    match metric.reduction {
        Reduction::Peak
        | Reduction::Last
        | Reduction::Min
        | Reduction::Max
        | Reduction::Rms
        | Reduction::TimeOfPeak => of_values(metric.reduction, &c, |step| step as f64 * of.dt),
        Reduction::RmsError => Some(reduce::rms_error(&c, &reference()?)),
        Reduction::LastError => Some((c.last()? - reference()?.last()?).abs()),
        Reduction::PeakError => {
            let exact = reference()?;
            Some((reduce::peak(&c) - reduce::peak(&exact)).abs())
        }
        Reduction::RegularisationError => Some(reduce::rms_error(
            &exact(&motions.softened)?,
            &exact(&motions.rigid)?,
        )),
        Reduction::StepError => Some(reduce::rms_error(&c, &exact(&motions.softened)?)),
        Reduction::ReferenceError => {
            let mut errors = motions.reference_errors.iter();
            let own = errors.find(|(name, _)| *name == metric.name);
            own.map(|(_, error)| *error)
        }
        Reduction::MeshError => {
            let (finer, numbering) = motions.finer.as_ref()?;
            let finer = finer.channel(channel, numbering);
            Some(reduce::rms_error(&exact(&motions.softened)?, &finer))
        }
        Reduction::ReductionError => {
            let (unreduced, numbering) = motions.unreduced.as_ref()?;
            let unreduced = unreduced.channel(channel, numbering);
            Some(reduce::rms_error(&c, &unreduced))
        }
        Reduction::Divergence | Reduction::Difference if is_still() => None,
        Reduction::Divergence => {
            let perturbed = exact(&motions.perturbed)?;
            let step = reduce::divergence(&c, &perturbed, metric.threshold)?;
            Some(step as f64 * of.dt)
        }
        Reduction::Difference => reduce::difference(&c, &exact(&motions.perturbed)?),
        Reduction::ImpactsBeforeDivergence => {
            let perturbed = exact(&motions.perturbed)?;
            let end = reduce::divergence(&c, &perturbed, metric.threshold);
            let end = end.filter(|_| !is_still()).unwrap_or(c.len());
            let contacts = of.structure.contacts.iter().enumerate();
            let impacts = contacts.filter(|(_, contact)| contact.law.kind() == ContactKind::Impact);
            let closings = impacts.map(|(place, _)| {
                let force = motions.computed.of(Number::Contact(place, Quantity::Force));
                reduce::closings(&force[..end.min(force.len())])
            });
            Some(closings.sum::<usize>() as f64)
        }
        Reduction::Impacts
        | Reduction::Impulse
        | Reduction::ContactTime
        | Reduction::OpenTime
        | Reduction::Work
        | Reduction::ResidualSlip
        | Reduction::Restitution
        | Reduction::SpragueGeersMagnitude
        | Reduction::SpragueGeersPhase
        | Reduction::SpragueGeersCombined
        | Reduction::EnergyPerCycle
        | Reduction::LoopDistance
        | Reduction::EnergyError
        | Reduction::NumericalDissipation
        | Reduction::GroundPga
        | Reduction::GroundPgv
        | Reduction::GroundPgd
        | Reduction::GroundArias
        | Reduction::GroundDuration
        | Reduction::GroundSpectral
        | Reduction::GroundMeanPeriod
        | Reduction::GroundFactor
        | Reduction::GroundSetFactor
        | Reduction::GroundSetRatio => None,
    }
}

/// A reduction that needs nothing but the values of a channel and the times of their places; `None` for others.
pub fn of_values(reduction: Reduction, c: &[f64], time: impl Fn(usize) -> f64) -> Option<f64> {
    match reduction {
        Reduction::Peak => Some(reduce::peak(c)),
        Reduction::Last => c.last().copied(),
        Reduction::Min => Some(reduce::extent(c)[0]),
        Reduction::Max => Some(reduce::extent(c)[1]),
        Reduction::Rms => Some(reduce::rms(c)),
        Reduction::TimeOfPeak => reduce::step_of_peak(c).map(time),
        _ => None,
    }
}

/// Of both directions of a contact in a plane.
fn of_plane(
    reduction: Reduction,
    first: usize,
    of: MetricContext,
    computed: &Recorded,
) -> Option<f64> {
    if reduction == Reduction::Impulse {
        let [a, b] = [0, 1].map(|i| computed.of(Number::Contact(first + i, Quantity::Force)));
        let sizes: Vec<f64> = a.iter().zip(b).map(|(a, b)| libm::hypot(*a, *b)).collect();
        return Some(reduce::impulse(&sizes, of.dt));
    }
    let [a, b] = [0, 1].map(|i| of_contact(reduction, first + i, of, computed));
    match reduction {
        Reduction::OpenTime => a,
        Reduction::ResidualSlip => Some(libm::hypot(a?, b?)),
        _ => Some(a? + b?),
    }
}

fn of_contact(
    reduction: Reduction,
    contact: usize,
    of: MetricContext,
    computed: &Recorded,
) -> Option<f64> {
    let series = |quantity| computed.of(Number::Contact(contact, quantity));
    let force = series(Quantity::Force);
    let kind = of.structure.contacts.get(contact)?.law.kind();
    match reduction {
        Reduction::Impacts => Some(reduce::closings(force) as f64),
        Reduction::Impulse => Some(reduce::impulse(force, of.dt)),
        Reduction::ContactTime => Some(reduce::time_where(force, of.dt, |s| s != 0.0)),
        Reduction::OpenTime => match kind {
            ContactKind::Impact => Some(reduce::time_where(force, of.dt, |s| s == 0.0)),
            ContactKind::Friction => {
                let limit = series(Quantity::Limit);
                Some(reduce::time_where(limit, of.dt, |limit| limit <= 0.0))
            }
            ContactKind::Link => Some(0.0),
        },
        Reduction::Work => {
            let law = &of.structure.contacts[contact].law;
            let rigid = law.line().is_some_and(ClippedLine::is_rigid);
            Some(match of.impulses && rigid {
                true => reduce::work_of_impulses(force, series(Quantity::Velocity), of.dt),
                false => reduce::work(force, series(Quantity::Displacement)),
            })
        }
        Reduction::Restitution if kind == ContactKind::Impact => {
            reduce::restitution(force, series(Quantity::Velocity))
        }
        Reduction::EnergyPerCycle => energy_per_cycle(series(Quantity::Displacement), force),
        Reduction::ResidualSlip => {
            let slip = series(Quantity::Slip);
            Some(slip.last()? - slip.first()?)
        }
        _ => None,
    }
}
