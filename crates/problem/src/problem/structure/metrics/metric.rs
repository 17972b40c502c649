//! Metrics of a structure: a reduction of a channel over time.

use super::function::Motion;
use super::reduction::Reduction;
use crate::problem::structure::channels::channel::Channel;
use crate::problem::structure::metrics::ground_metric::{GroundMetric, PREFIX, without_direction};
use crate::problem::structure::metrics::window::Window;

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
    /// The times that it is of.
    pub window: Window,
    /// What a measure of the ground is of.
    pub ground: Option<GroundMetric>,
    /// Byte offset and path of the text in the study.
    pub place: (usize, String),
}

/// Names of metrics of the whole structure.
pub const OF_ALL: [&str; 2] = ["energy_error", "numerical_dissipation"];

/// Names of what programs of others tell of a case; in arithmetic they are parameters.
pub const OF_PROGRAMS: [&str; 2] = ["cost", "wall"];

/// Whether a text has the form of a metric: `name(...)`, or one of [`OF_ALL`] or [`OF_PROGRAMS`].
pub fn looks_like_metric(text: &str) -> bool {
    let word = text.split('(').next().unwrap_or_default().trim();
    let name = &*without_direction(word).0;
    let with_brackets = text.contains('(') && text.trim_end().ends_with(')');
    OF_PROGRAMS.contains(&text.trim())
        || Reduction::named(name).is_some()
            && (with_brackets || OF_ALL.contains(&name) || name.starts_with(PREFIX))
}

impl StructureMetric {
    /// A reduction with this name, of nothing yet.
    pub fn named(name: &str, reduction: Reduction) -> StructureMetric {
        StructureMetric {
            name: name.to_owned(),
            reduction,
            channel: None,
            second: None,
            measured: false,
            contact: None,
            in_plane: false,
            threshold: 0.0,
            window: Window::default(),
            ground: None,
            place: (0, String::new()),
        }
    }

    /// Whether it is this reduction, and not of what was measured.
    pub fn is_exact(&self, reduction: Reduction) -> bool {
        !self.measured && self.reduction == reduction
    }

    /// Whether it compares with this motion.
    pub fn needs(&self, motion: Motion) -> bool {
        !self.measured && self.reduction.needs(motion)
    }

    /// Whether it compares with an exact motion.
    pub fn needs_exact(&self) -> bool {
        !self.measured && self.reduction.needs_exact()
    }

    /// Its meaning.
    pub fn meaning(&self) -> &'static str {
        self.reduction.meaning(self.measured)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::structure::channels::names::Names;
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
