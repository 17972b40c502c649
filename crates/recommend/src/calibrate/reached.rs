//! The values of one side of a profile, and where the misfit exceeds a rise.

/// A value is added between two with rises below and above these parts of a rise,
const LOW: f64 = 0.1;
const HIGH: f64 = 10.0;

/// that are farther apart than this part of their distance.
const NARROW: f64 = 0.02;

/// A value, the squared misfit and the point.
#[derive(Debug, Clone)]
pub struct Reached {
    /// From the best point, >= 0.
    pub distance: f64,
    /// The rise of the squared misfit.
    pub rise: f64,
    /// The misfit.
    pub misfit: f64,
    /// All coordinates.
    pub at: Vec<f64>,
}

/// The last place below a rise and the next one.
fn bracket(reached: &[Reached], rise: f64) -> Option<usize> {
    let inside = reached.iter().rposition(|r| r.rise <= rise)?;
    (inside + 1 < reached.len()).then_some(inside)
}

/// The distance at which the misfit exceeds a rise for good: the root of the rise is nearly a straight line.
pub fn crossing(reached: &[Reached], rise: f64) -> Option<f64> {
    let i = bracket(reached, rise)?;
    let [inside, outside] = [&reached[i], &reached[i + 1]];
    if !outside.rise.is_finite() {
        return Some(0.5 * (inside.distance + outside.distance));
    }
    let root = |r: &Reached| r.rise.max(0.0).sqrt();
    let (wanted, from, to) = (rise.sqrt(), root(inside), root(outside));
    let part = (wanted - from) / (to - from);
    let straight = inside.distance + part * (outside.distance - inside.distance);
    // With one place more a parabola of distance over root, if the place is on the same rising curve.
    let parabola = i.checked_sub(1).map(|b| &reached[b]).and_then(|below| {
        let zero = root(below);
        let first = (inside.distance - below.distance) / (from - zero);
        let second = (outside.distance - inside.distance) / (to - from);
        let bend = (second - first) / (to - zero);
        let found =
            inside.distance + first * (wanted - from) + bend * (wanted - zero) * (wanted - from);
        let between = (inside.distance..=outside.distance).contains(&found);
        (zero < from && between).then_some(found)
    });
    Some(parabola.unwrap_or(straight))
}

/// A value between two that are too far apart for the distance of a rise.
pub fn between(reached: &[Reached], rise: f64) -> Option<f64> {
    let i = bracket(reached, rise)?;
    let [inside, outside] = [&reached[i], &reached[i + 1]];
    // A bound of another coordinate bends the profile at once: then the root of the rise is no straight line.
    let bent = inside.rise < LOW * rise || outside.rise > HIGH * rise;
    let gap = outside.distance - inside.distance;
    if !bent || gap <= NARROW * outside.distance {
        return None;
    }
    let wanted = crossing(reached, rise)?;
    Some(wanted.clamp(inside.distance + 0.25 * gap, outside.distance - 0.25 * gap))
}
