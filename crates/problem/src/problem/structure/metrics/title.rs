//! Titles of metrics in words, for figures.

use super::metric::StructureMetric;
use super::reduction::Reduction;
use crate::problem::structure::channels::words::Words;

/// The title of a metric without its unit, such as `peak displacement of a3 relative to a2`.
pub fn title(metric: &StructureMetric, words: Words) -> String {
    let mut title = bare(metric, words);
    if metric.measured && AGAINST.contains(&metric.reduction) {
        title += " against what was measured";
    }
    title
}

/// Reductions whose name does not say that they are of what was measured.
const AGAINST: [Reduction; 3] = [
    Reduction::RmsError,
    Reduction::LastError,
    Reduction::PeakError,
];

fn bare(metric: &StructureMetric, words: Words) -> String {
    if let (Some(first), Some(second)) = (&metric.channel, &metric.second) {
        let [first, second] = [first, second].map(|channel| words.channel(channel));
        return format!("distance of the loop of {first} and {second} from the measured one");
    }
    match (&metric.channel, metric.ground.as_ref()) {
        (Some(channel), _) => {
            of_channel(metric.reduction, &words.channel(channel), metric.threshold)
        }
        (None, Some(ground)) => {
            let mut title = of_ground(metric.reduction).to_owned();
            if let Some(direction) = ground.direction {
                title += &format!(" in {}", direction.name());
            }
            if !ground.texts.is_empty() {
                title += &format!(", T, ratio = {}", ground.texts.join(", "));
                if ground.texts.len() == 1 {
                    title = title.replace(", T, ratio", ", T");
                }
            }
            title
        }
        (None, None) => of_contact(metric, words),
    }
}

fn of_channel(reduction: Reduction, channel: &str, threshold: f64) -> String {
    match reduction {
        Reduction::Peak => format!("peak {channel}"),
        Reduction::Last => format!("last {channel}"),
        Reduction::Min => format!("smallest {channel}"),
        Reduction::Max => format!("largest {channel}"),
        Reduction::Rms => format!("rms {channel}"),
        Reduction::TimeOfPeak => format!("time of peak {channel}"),
        Reduction::RmsError => format!("rms error of {channel}"),
        Reduction::LastError => format!("error of last {channel}"),
        Reduction::PeakError => format!("error of peak {channel}"),
        Reduction::RegularisationError => format!("regularisation error of {channel}"),
        Reduction::StepError => format!("step error of {channel}"),
        Reduction::MeshError => format!("mesh error of {channel}"),
        Reduction::ReductionError => format!("reduction error of {channel}"),
        Reduction::SpragueGeersMagnitude => format!("magnitude error (Sprague-Geers) of {channel}"),
        Reduction::SpragueGeersPhase => format!("phase error (Sprague-Geers) of {channel}"),
        Reduction::SpragueGeersCombined => format!("combined error (Sprague-Geers) of {channel}"),
        Reduction::Divergence => format!("time of divergence of {channel} by {threshold}"),
        Reduction::ImpactsBeforeDivergence => {
            format!("impacts before divergence of {channel} by {threshold}")
        }
        Reduction::Difference => format!("relative difference of {channel} of two starts"),
        other => format!("{} of {channel}", blanks(other.name())),
    }
}

fn of_ground(reduction: Reduction) -> &'static str {
    match reduction {
        Reduction::GroundPga => "peak ground acceleration",
        Reduction::GroundPgv => "peak ground velocity",
        Reduction::GroundPgd => "peak ground displacement",
        Reduction::GroundArias => "Arias intensity of the ground",
        Reduction::GroundDuration => "duration of the ground motion from 5 to 95 %",
        Reduction::GroundSpectral => "spectral acceleration of the ground",
        Reduction::GroundMeanPeriod => "mean period of the ground",
        Reduction::GroundFactor => "factor of the ground motion",
        Reduction::GroundSetFactor => "factor of the set of ground motions",
        Reduction::GroundSetRatio => "least ratio of the set to its rule",
        other => other.name(),
    }
}

/// The title of a metric of a contact or of the whole structure.
fn of_contact(metric: &StructureMetric, words: Words) -> String {
    let (_, rest) = metric.name.split_once('(').unwrap_or_default();
    let text = rest.split([',', ')']).next().unwrap_or_default().trim();
    // Named by one of its channels, it is the same contact.
    let known = |name: &&str| {
        words
            .names
            .contact(name)
            .or(words.names.plane(name))
            .is_some()
    };
    let above = text.rsplit_once('.').map(|(above, _)| above).filter(known);
    let contact = words.contact(above.filter(|_| !known(&text)).unwrap_or(text));
    match (metric.reduction, &*contact) {
        (other, "") => blanks(other.name()),
        (Reduction::EnergyPerCycle, _) if metric.measured => {
            format!("relative error of the energy per cycle of {contact}")
        }
        (Reduction::Impacts, _) => format!("number of impacts of {contact}"),
        (other, _) => format!("{} of {contact}", blanks(other.name())),
    }
}

/// A name with blanks.
fn blanks(name: &str) -> String {
    name.replace('_', " ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::structure::channels::names::Names;
    use crate::problem::structure::channels::words::Shown;

    #[test]
    fn titles_say_what_is_reduced() {
        let owned = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect();
        let names = Names::new(owned(&["a2", "a3"]), owned(&["g1"]), Vec::new())
            .with_contacts(owned(&["gap"]));
        for (text, expected) in [
            ("max(a3-a2)", "largest displacement of a3 relative to a2"),
            ("peak(a3)", "peak displacement of a3"),
            (
                "min(a3.v + a2.v)",
                "smallest velocity of a3 + velocity of a2",
            ),
            ("peak(gap.S)", "peak contact force of gap"),
            ("rms(gap.r)", "rms relative displacement of gap"),
            ("last(gap.slip)", "last slip of gap"),
            ("impacts(gap.S)", "number of impacts of gap"),
            ("contact_time(gap)", "contact time of gap"),
            ("energy_error", "energy error"),
            (
                "divergence(a3, 0.01)",
                "time of divergence of displacement of a3 by 0.01",
            ),
            ("step_error(a3)", "step error of displacement of a3"),
            (
                "peak_error(gap.S, measured)",
                "error of peak contact force of gap against what was measured",
            ),
            (
                "sprague_geers_phase(a3, measured)",
                "phase error (Sprague-Geers) of displacement of a3",
            ),
            ("energy_per_cycle(gap)", "energy per cycle of gap"),
            (
                "energy_per_cycle(gap, measured)",
                "relative error of the energy per cycle of gap",
            ),
            (
                "loop_distance(gap.r, gap.S, measured)",
                "distance of the loop of relative displacement of gap and contact force of gap from the measured one",
            ),
            ("ground.y.pga", "peak ground acceleration in y"),
            (
                "ground.Sa(T1)",
                "spectral acceleration of the ground, T = T1",
            ),
            (
                "ground.Sa(1, 0.02)",
                "spectral acceleration of the ground, T, ratio = 1, 0.02",
            ),
        ] {
            let metric = StructureMetric::parse(text, &names).unwrap();
            let shown = Shown::default();
            let words = Words {
                names: &names,
                shown: &shown,
            };
            assert_eq!(title(&metric, words), expected, "{text}");
        }
    }
}
