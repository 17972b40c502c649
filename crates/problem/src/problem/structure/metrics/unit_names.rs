//! Names of the units of a structure, for the titles of figures.

use super::function::UnitOf;
use super::metric::StructureMetric;
use super::unit_consistency::size_of;
use crate::problem::numbers::unit::Dimension;
use crate::problem::structure::channels::channel_words::Words;

/// The units of force, length and time, as the study writes them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UnitNames<'a> {
    force: &'a str,
    /// Of length.
    pub length: &'a str,
    /// Of time.
    pub time: &'a str,
}

impl UnitNames<'_> {
    /// The names in a text such as `t, kN, m, s`: units of mass, force, length and time. `None` for another text.
    pub fn of(text: &str) -> Option<UnitNames<'_>> {
        let mut names = text.split(',').map(str::trim);
        let (_, force, length) = (names.next()?, names.next()?, names.next()?);
        let time = names.next()?;
        let named = [force, length, time].iter().all(|name| !name.is_empty());
        (named && names.next().is_none()).then_some(UnitNames {
            force,
            length,
            time,
        })
    }

    /// The unit of a channel.
    pub fn of_dimension(&self, dimension: Dimension) -> String {
        match dimension {
            Dimension::Time => self.time.to_owned(),
            Dimension::Length => self.length.to_owned(),
            Dimension::Velocity => format!("{}/{}", self.length, self.time),
            Dimension::Acceleration => format!("{}/{}2", self.length, self.time),
            Dimension::Force => self.force.to_owned(),
            Dimension::Energy => format!("{} {}", self.force, self.length),
        }
    }

    /// A unit of a dimension in the one of the study; `None` if one of them is not known.
    pub fn factor(&self, unit: &str, dimension: Dimension) -> Option<f64> {
        Some(size_of(unit, dimension)? / size_of(&self.of_dimension(dimension), dimension)?)
    }

    /// The unit of a metric; `None` for a number or a ratio.
    pub fn of_metric(&self, metric: &StructureMetric, words: Words) -> Option<String> {
        let against = metric.reduction.of_measured().filter(|_| metric.measured);
        if against.is_some_and(|row| !row.has_unit) {
            return None;
        }
        let of = |dimension| Some(self.of_dimension(dimension));
        match metric.reduction.row().unit {
            UnitOf::Channel => words.unit(metric.channel.as_ref()?, of),
            UnitOf::Time => of(Dimension::Time),
            UnitOf::Length => of(Dimension::Length),
            UnitOf::Velocity => of(Dimension::Velocity),
            UnitOf::Acceleration => of(Dimension::Acceleration),
            UnitOf::Energy => of(Dimension::Energy),
            UnitOf::Impulse => Some(format!("{} {}", self.force, self.time)),
            UnitOf::None => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::structure::channels::channel_words::Shown;
    use crate::problem::structure::channels::names::Names;

    #[test]
    fn a_metric_has_the_unit_of_its_reduction() {
        let units = UnitNames::of("t, kN, m, s").unwrap();
        let shown = Shown::default();
        let names =
            Names::new(vec!["p".into()], Vec::new(), Vec::new()).with_contacts(vec!["stop".into()]);
        let words = Words {
            names: &names,
            shown: &shown,
        };
        for (metric, unit) in [
            ("peak(p)", Some("m")),
            ("rms(p.v)", Some("m/s")),
            ("peak(stop.S)", Some("kN")),
            ("impulse(stop)", Some("kN s")),
            ("work(stop)", Some("kN m")),
            ("time_of_peak(p)", Some("s")),
            ("residual_slip(stop)", Some("m")),
            ("impacts(stop)", None),
            ("energy_error", None),
            ("rms_error(stop.S, measured)", Some("kN")),
            ("energy_per_cycle(stop)", Some("kN m")),
            ("energy_per_cycle(stop, measured)", None),
            ("sprague_geers_magnitude(p, measured)", None),
            ("loop_distance(stop.r, stop.S, measured)", None),
            ("ground.pga", Some("m/s2")),
            ("ground.Sa(1)", Some("m/s2")),
            ("ground.arias", Some("m/s")),
            ("ground.pgd", Some("m")),
            ("ground.Tm", Some("s")),
        ] {
            let parsed = StructureMetric::parse(metric, &names).unwrap();
            assert_eq!(units.of_metric(&parsed, words).as_deref(), unit, "{metric}");
        }
    }

    #[test]
    fn only_four_names_are_units() {
        for text in ["", "m, s", "t, kN, m", "t, kN, m, s, K", "t, , m, s"] {
            assert_eq!(UnitNames::of(text), None, "{text}");
        }
    }
}
