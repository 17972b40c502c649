//! Titles of metrics in words, for figures.

use super::metric::StructureMetric;
use crate::problem::structure::channels::channel_words::Words;

/// The title of a metric without its unit, such as `peak displacement of a3 relative to a2`: that of its reduction, with what it is of.
/// The window has the unit of time.
pub fn title(metric: &StructureMetric, words: Words, time: Option<&str>) -> String {
    let against = metric.reduction.of_measured().filter(|_| metric.measured);
    let title = against.map_or(metric.reduction.row().title, |row| row.title);
    let of_metric = metric.channel.iter().chain(&metric.second);
    let channels: Vec<String> = of_metric.map(|channel| words.channel(channel)).collect();
    let of_contact = channels.is_empty() && title.contains("{}");
    let mut of = channels
        .into_iter()
        .chain(of_contact.then(|| contact(metric, words)));
    let mut parts = title.split("{}");
    let mut title = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        title += &of.next().unwrap_or_default();
        title += part;
    }
    let mut title = title.replace("{threshold}", &metric.threshold.to_string());
    title += &metric.window.in_words(time);
    if let Some(ground) = metric.ground.as_ref() {
        if let Some(direction) = ground.direction {
            title += &format!(" in {}", direction.name());
        }
        match &ground.texts[..] {
            [] => {}
            [period] => title += &format!(", T = {period}"),
            texts => title += &format!(", T, ratio = {}", texts.join(", ")),
        }
    }
    title
}

/// The contact of a metric in words. Named by one of its channels, it is the same contact.
fn contact(metric: &StructureMetric, words: Words) -> String {
    let (_, rest) = metric.name.split_once('(').unwrap_or_default();
    let text = rest.split([',', ')']).next().unwrap_or_default().trim();
    let known = |name: &&str| {
        words
            .names
            .contact(name)
            .or(words.names.plane(name))
            .is_some()
    };
    let above = text.rsplit_once('.').map(|(above, _)| above).filter(known);
    words.contact(above.filter(|_| !known(&text)).unwrap_or(text))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::structure::channels::channel_words::Shown;
    use crate::problem::structure::channels::names::Names;

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
            assert_eq!(title(&metric, words, Some("s")), expected, "{text}");
        }
    }
}
