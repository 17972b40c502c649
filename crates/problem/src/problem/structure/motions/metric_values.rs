//! The metrics of a case from its recorded motions, by the functions in the table of reductions.

use super::measured_metrics;
use super::recorded::{MetricContext, Motions, Recorded};
use super::still::Still;
use crate::contact::{ClippedLine, ContactKind};
use crate::metrics::structure::closings;
use crate::problem::structure::channels::channel::{Channel, Number, Quantity};
use crate::problem::structure::given::node::Numbering;
use crate::problem::structure::metrics::function::{
    ContactSeries, Function, Motion, Perturbed, Plane,
};
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::structure::metrics::reduction::Reduction;
use std::borrow::Cow;
use std::ops::Range;

/// The quantities that a metric of a structure with so many contacts needs.
pub fn needed(metric: &StructureMetric, numbering: &Numbering, contacts: usize) -> Vec<Number> {
    let channels = metric.channel.iter().chain(&metric.second);
    let of_channel = channels.flat_map(|channel| channel.numbers(numbering));
    let rows = metric.contact.into_iter().flat_map(|first| {
        let last = first + usize::from(metric.in_plane);
        first..=last
    });
    let quantities = match metric.reduction.row().function {
        Function::Contact(quantities, ..) => quantities,
        Function::Values(_)
        | Function::Distance(..)
        | Function::Pair(..)
        | Function::Estimated
        | Function::Perturbed(_)
        | Function::Energies(_)
        | Function::Measured(_)
        | Function::Loop(_)
        | Function::Ground(_)
        | Function::Told => &[],
    };
    let of_contact = rows.flat_map(|contact| {
        quantities
            .iter()
            .map(move |quantity| Number::Contact(contact, *quantity))
    });
    // Which of them are impacts, the case decides.
    let counted = match metric.reduction == Reduction::ImpactsBeforeDivergence {
        true => 0..contacts,
        false => 0..0,
    };
    let forces = counted.map(|contact| Number::Contact(contact, Quantity::Force));
    of_channel.chain(of_contact).chain(forces).collect()
}

/// The value of a metric; `None` where it is undefined.
pub fn value(metric: &StructureMetric, of: MetricContext, motions: &Motions) -> Option<f64> {
    if metric.measured {
        return measured_metrics::value(metric, of, &motions.computed);
    }
    let series = |motion: Motion| -> Option<Vec<f64>> {
        let (recorded, numbering) = match motion {
            Motion::Computed => (&motions.computed, of.numbering),
            Motion::Reference if of.against_rigid => (motions.rigid.as_ref()?, of.numbering),
            Motion::Reference | Motion::Softened => (motions.softened.as_ref()?, of.numbering),
            Motion::Rigid => (motions.rigid.as_ref()?, of.numbering),
            Motion::Perturbed => (motions.perturbed.as_ref()?, of.numbering),
            Motion::Finer => motions
                .finer
                .as_ref()
                .map(|(finer, numbers)| (finer, numbers))?,
            Motion::Unreduced => motions
                .unreduced
                .as_ref()
                .map(|(unreduced, numbers)| (unreduced, numbers))?,
        };
        let mut values = recorded.channel(metric.channel.as_ref()?, numbering);
        if metric.window.is_given() {
            let steps = metric.window.steps(of.case, of.dt, values.len())?;
            values = values.get(steps)?.to_vec();
        }
        Some(values)
    };
    match metric.reduction.row().function {
        Function::Values(function) => {
            let first = metric.window.first_step(of.case, of.dt);
            function(&series(Motion::Computed)?, &|step| {
                (first + step) as f64 * of.dt
            })
        }
        Function::Distance([one, other], function) => match directions(metric) {
            Some(both) => length(both, of, motions),
            None => function(&series(one)?, &series(other)?),
        },
        Function::Pair([one, other], function) => function(&series(one)?, &series(other)?),
        Function::Estimated => match directions(metric) {
            Some(both) => length(both, of, motions),
            None => {
                let mut errors = motions.reference_errors.iter();
                let estimate = errors.find(|(name, _)| *name == metric.name);
                estimate.map(|(_, error)| *error)
            }
        },
        Function::Perturbed(function) => {
            let values = series(Motion::Computed)?;
            let channel = metric.channel.as_ref()?;
            let is_still = || {
                let still = Still::of(of.structure, of.dt, values.len().saturating_sub(1));
                still.is_channel(channel, (&motions.computed, of.numbering), &values)
            };
            function(&Perturbed {
                values: &values,
                other: &series(Motion::Perturbed)?,
                threshold: metric.threshold,
                dt: of.dt,
                is_still: &is_still,
                impacts: &|end| impacts(of, &motions.computed, end),
            })
        }
        Function::Contact(_, plane, function) => {
            let of_contact = |steps: Range<usize>| {
                let of_contact = Contacts {
                    of,
                    computed: &motions.computed,
                    function,
                    steps,
                };
                let contact = metric.contact?;
                match metric.in_plane {
                    true => of_contact.in_plane(contact, plane),
                    false => of_contact.one(contact),
                }
            };
            let steps = metric
                .window
                .steps(of.case, of.dt, motions.computed.count())?;
            match metric.reduction == Reduction::Impacts && steps.start > 0 {
                // What closes before the window does not count, even where it is still closed.
                true => Some(of_contact(0..steps.end)? - of_contact(0..steps.start)?),
                false => of_contact(steps),
            }
        }
        Function::Energies(function) => {
            let energies = motions.energies?;
            Some(function([energies.error, energies.dissipation]))
        }
        // Of what was measured, of the ground and of programs, which have other values.
        Function::Measured(_) | Function::Loop(_) | Function::Ground(_) | Function::Told => None,
    }
}

/// The metric in both directions of a contact in a plane.
fn directions(metric: &StructureMetric) -> Option<[StructureMetric; 2]> {
    let both: [Channel; 2] = metric.channel.as_ref()?.by_direction()?;
    Some(both.map(|channel| StructureMetric {
        channel: Some(channel),
        ..metric.clone()
    }))
}

/// The rms of a distance is the length of those of its directions.
fn length(both: [StructureMetric; 2], of: MetricContext, motions: &Motions) -> Option<f64> {
    let [first, second] = both.map(|component| value(&component, of, motions));
    Some(libm::hypot(first?, second?))
}

/// The impacts of all contacts in so many steps.
fn impacts(of: MetricContext, computed: &Recorded, end: usize) -> usize {
    let contacts = of.structure.contacts.iter().enumerate();
    let impacts = contacts.filter(|(_, contact)| contact.law.kind() == ContactKind::Impact);
    let closed = impacts.map(|(index, _)| {
        let force = computed.of(Number::Contact(index, Quantity::Force));
        closings(&force[..end.min(force.len())])
    });
    closed.sum()
}

/// A reduction of contacts.
struct Contacts<'a> {
    of: MetricContext<'a>,
    computed: &'a Recorded,
    function: fn(&ContactSeries) -> Option<f64>,
    /// The steps that it is of.
    steps: Range<usize>,
}

impl Contacts<'_> {
    /// A quantity of a contact.
    fn series(&self, contact: usize, quantity: Quantity) -> &[f64] {
        let values = self.computed.of(Number::Contact(contact, quantity));
        values.get(self.steps.clone()).unwrap_or_default()
    }

    fn one(&self, contact: usize) -> Option<f64> {
        let of = |quantity| Cow::Borrowed(self.series(contact, quantity));
        self.by(contact, &of)
    }

    /// Of both directions of a contact in a plane, of which this is the first one.
    fn in_plane(&self, first: usize, plane: Plane) -> Option<f64> {
        let second = first + 1;
        match plane {
            Plane::No => None,
            Plane::Sum => Some(self.one(first)? + self.one(second)?),
            Plane::Same => self.one(first),
            Plane::Vector => Some(libm::hypot(self.one(first)?, self.one(second)?)),
            Plane::OfSizes => {
                let sizes = |quantity| {
                    let [a, b] =
                        [first, second].map(|contact| self.series(contact, quantity).iter());
                    Cow::Owned(a.zip(b).map(|(a, b)| libm::hypot(*a, *b)).collect())
                };
                self.by(first, &sizes)
            }
        }
    }

    fn by<'b>(
        &self,
        contact: usize,
        series: &'b dyn Fn(Quantity) -> Cow<'b, [f64]>,
    ) -> Option<f64> {
        let law = &self.of.structure.contacts.get(contact)?.law;
        (self.function)(&ContactSeries {
            of: series,
            dt: self.of.dt,
            kind: law.kind(),
            by_impulses: self.of.impulses && law.line().is_some_and(ClippedLine::is_rigid),
        })
    }
}
