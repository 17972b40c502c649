//! The texts of metrics, such as `peak(g1.right - p2)` or `rms_error(deck.u, measured)`.

use super::metric::StructureMetric;
use super::reduction::{REDUCTIONS, Reduction, Takes};
use crate::problem::structure::channels::channel::{Channel, QUANTITIES};
use crate::problem::structure::channels::names::Names;
use crate::problem::structure::metrics::ground_metric::{GroundMetric, without_direction};
use crate::problem::structure::metrics::window::{Window, no_window};

impl StructureMetric {
    /// The metric of a text such as `peak(g1.right - p2)`.
    ///
    /// # Errors
    /// What is wrong and what is allowed.
    pub fn parse(text: &str, names: &Names) -> Result<StructureMetric, String> {
        let text = text.trim();
        let (name, inside) = match text.split_once('(') {
            None => (text, None),
            Some((name, rest)) => {
                let inside = rest.strip_suffix(')');
                (
                    name.trim(),
                    Some(inside.ok_or("a ')' is missing at the end")?),
                )
            }
        };
        let (name, direction) = without_direction(name);
        let name = &*name;
        let Some(reduction) = Reduction::named(name) else {
            let all = REDUCTIONS.map(|known| known.0).join(", ");
            return Err(format!("no metric '{name}'; allowed: {all}"));
        };
        let takes = reduction.row().takes;
        let mut metric = StructureMetric::named(text, reduction);
        let mut inside = inside.map(str::trim);
        if let Some(whole) = inside {
            let (rest, window) = Window::split(whole)?;
            if window.is_given() && !reduction.has_window() {
                return Err(no_window(name));
            }
            metric.window = window;
            inside = Some(rest);
        }
        if let Some(rest) = inside.and_then(before_measured) {
            takes.check_measured(name)?;
            metric.measured = true;
            inside = Some(rest);
        }
        match (takes, inside) {
            (Takes::Ground | Takes::GroundAndOscillator, inside) => {
                let oscillator = takes == Takes::GroundAndOscillator;
                metric.ground = Some(GroundMetric::new(name, direction, oscillator, inside)?);
            }
            (Takes::Nothing, None) => {}
            (Takes::Nothing, Some(_)) => return Err(format!("{name} has no channel")),
            (_, None | Some("")) => {
                let contact = [Takes::Contact, Takes::ContactOrMeasured].contains(&takes);
                let what = if contact { "a contact" } else { "a channel" };
                return Err(format!("{name} needs {what} in brackets"));
            }
            (Takes::MeasuredChannel, _) if !metric.measured => {
                return Err(format!(
                    "{name} compares with what was measured: {name}(CHANNEL, {MEASURED})"
                ));
            }
            (Takes::MeasuredLoop, Some(inside)) => {
                let two = inside.split_once(',').filter(|_| metric.measured);
                let (first, second) = two.ok_or_else(|| {
                    format!(
                        "{name} compares a loop of two channels with what was measured: {name}(CHANNEL, CHANNEL, {MEASURED})"
                    )
                })?;
                metric.channel = Some(Channel::parse(first, names)?);
                metric.second = Some(Channel::parse(second, names)?);
            }
            (Takes::Channel | Takes::ChannelOrMeasured | Takes::MeasuredChannel, Some(inside)) => {
                metric.channel = Some(Channel::parse(inside, names)?);
            }
            (Takes::Contact | Takes::ContactOrMeasured, Some(inside)) => {
                let (place, in_plane) = contact(inside, names)?;
                (metric.contact, metric.in_plane) = (Some(place), in_plane);
                if in_plane && !reduction.is_in_plane() {
                    return Err(format!(
                        "{inside} is a contact in a plane; name a direction, {inside}.1 or {inside}.2"
                    ));
                }
            }
            (Takes::ChannelAndThreshold, Some(inside)) => {
                let (channel, threshold) = inside.rsplit_once(',').ok_or_else(|| {
                    format!("{name} needs a channel and a threshold, as in {name}(p1, 0.01)")
                })?;
                let threshold = threshold.trim();
                let number: Option<f64> = threshold.parse().ok();
                metric.threshold =
                    number
                        .filter(|x| *x > 0.0 && x.is_finite())
                        .ok_or_else(|| {
                            format!("the threshold must be a number > 0, got '{threshold}'")
                        })?;
                metric.channel = Some(Channel::parse(channel, names)?);
            }
        }
        Ok(metric)
    }
}

/// The word behind the channel of a metric that compares with what was measured.
pub const MEASURED: &str = "measured";

/// What is before `, measured` in the brackets of a metric.
fn before_measured(inside: &str) -> Option<&str> {
    let (rest, last) = inside.rsplit_once(',')?;
    (last.trim() == MEASURED).then_some(rest.trim())
}

impl Takes {
    /// Whether the metric may compare with what was measured; if not, which ones may.
    fn check_measured(self, name: &str) -> Result<(), String> {
        let may = |takes: Takes| {
            matches!(
                takes,
                Takes::ChannelOrMeasured
                    | Takes::MeasuredChannel
                    | Takes::ContactOrMeasured
                    | Takes::MeasuredLoop
            )
        };
        if may(self) {
            return Ok(());
        }
        let comparing = Reduction::all().filter(|reduction| may(reduction.row().takes));
        let names: Vec<&str> = comparing.map(Reduction::name).collect();
        Err(format!(
            "{name} does not compare with what was measured; these do: {}",
            names.join(", ")
        ))
    }
}

/// A contact by its name, or by one of its channels; and whether it is both directions of one in a plane.
fn contact(text: &str, names: &Names) -> Result<(usize, bool), String> {
    let bare = text
        .rsplit_once('.')
        .filter(|(_, end)| QUANTITIES.iter().any(|known| known.0 == *end))
        .map_or(text, |(bare, _)| bare);
    if let Some(first) = names.plane(bare) {
        return Ok((first, true));
    }
    let place = names.contact(bare).map(|place| (place, false));
    let known = names.contacts.join(", ");
    place.ok_or_else(|| format!("no contact '{bare}'; the contacts are {known}"))
}
