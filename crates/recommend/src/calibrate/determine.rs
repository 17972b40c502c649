//! How sharply a minimum is determined: the profiles of all coordinates next to one another, and the intervals from them.

use super::arm::Arm;
use super::counted::{Counted, Round, round, squared};
use super::minimum::{Minimum, ROUGH};
use super::reached::{Reached, crossing};
use super::{Best, Determined, End, Objective, Profile, ProfilePoint, Stopped};
use slipgap_statistics::{CONFIDENCE, fisher};

/// Searches for a better minimum at most, after the profiles found one.
const RESTARTS: usize = 2;

/// Part of the rise of the interval by which a better point is lower.
const BETTER: f64 = 0.1;

/// Intervals of the quadratic function and of the profile agree within this part.
const AGREE: f64 = 0.2;

/// Components of a direction that count.
const COMPONENT: f64 = 0.1;

/// Determines the profiles at the best point of a search. `residuals` is the effective number of independent residuals if the misfit is the
/// root of their mean square; otherwise there is no probability.
///
/// # Errors
/// The user ended it.
pub fn determine(
    best: &Best,
    objective: &mut dyn Objective,
    residuals: Option<f64>,
) -> Result<Determined, Stopped> {
    let n = best.at.len();
    if !best.misfit.is_finite() {
        return Ok(nothing(best));
    }
    let freedom = residuals
        .map(|count| count - n as f64)
        .filter(|freedom| *freedom > 0.0);
    let fraction = freedom.map(|freedom| fisher::quantile(CONFIDENCE, 1.0, freedom) / freedom);
    let mut counted = Counted::new(objective, u64::MAX);
    let mut from = (best.at.clone(), best.misfit);
    let mut restarts = 0;
    loop {
        let minimum = Minimum::near(from, &mut counted, fraction)?;
        let sides = (0..n).flat_map(|k| [(k, -1.0), (k, 1.0)]);
        let mut arms: Vec<Arm> = sides.map(|(k, side)| Arm::new(&minimum, k, side)).collect();
        let limit = squared(minimum.misfit) - (BETTER * minimum.rises.0).max(minimum.residual);
        let better = |counted: &Counted| {
            counted
                .best
                .clone()
                .filter(|(_, misfit)| squared(*misfit) < limit)
        };
        let most = if minimum.widened > 1.0 { 1 } else { RESTARTS };
        let again = |counted: &Counted| restarts < most && better(counted).is_some();
        while !again(&counted) && round(&mut arms, &mut counted)? == Round::Next {}
        match better(&counted) {
            Some(point) if restarts < most => {
                from = point;
                restarts += 1;
            }
            point => {
                let mut found = describe(best, &minimum, &arms, fraction.is_some());
                if let Some((at, misfit)) = point {
                    (found.best.at, found.best.misfit) = (at, misfit);
                    found.quadratic = false;
                }
                found.solved = counted.solved;
                return Ok(found);
            }
        }
    }
}

/// Of a search without any solution.
fn nothing(best: &Best) -> Determined {
    let profile = Profile {
        points: Vec::new(),
        interval: None,
        within_tenth: [End::Open; 2],
    };
    Determined {
        profiles: vec![profile; best.at.len()],
        ..Determined::only(best.clone())
    }
}

fn describe(best: &Best, minimum: &Minimum, arms: &[Arm], probable: bool) -> Determined {
    let (near, far) = minimum.rises;
    let profile = |(k, pair): (usize, &[Arm])| {
        let at = minimum.at[k];
        let end = |arm: &Arm, sign: f64, rise: f64| match crossing(&arm.reached, rise) {
            Some(distance) if !arm.is_open(rise) => End::At((at + sign * distance).clamp(0.0, 1.0)),
            _ => End::Open,
        };
        let ends = |rise: f64| [end(&pair[0], -1.0, rise), end(&pair[1], 1.0, rise)];
        let below = pair[0].reached.iter().skip(1).rev();
        let points = below
            .chain(&pair[1].reached)
            .map(|reached| point(reached, k));
        Profile {
            points: points.collect(),
            interval: probable.then(|| ends(near)),
            within_tenth: ends(far),
        }
    };
    let profiles: Vec<Profile> = arms.chunks(2).enumerate().map(profile).collect();
    let agrees = |arm: &Arm| match crossing(&arm.reached, near) {
        Some(distance) if !arm.is_open(near) => {
            (distance / minimum.width(arm.k, near) - 1.0).abs() <= AGREE
        }
        _ => arm.room <= (1.0 + AGREE) * minimum.width(arm.k, near),
    };
    let open = |k: usize| arms[2 * k].is_open(near) || arms[2 * k + 1].is_open(near);
    let counts = |direction: &Vec<f64>| {
        direction
            .iter()
            .enumerate()
            .any(|(k, d)| d.abs() > COMPONENT && open(k))
    };
    let undetermined = minimum.direction().filter(counts);
    let is_part = |k: &usize| {
        let direction = undetermined.as_ref();
        direction.is_some_and(|direction| direction[*k].abs() > COMPONENT) && minimum.limits(*k)
    };
    let combined = (0..minimum.at.len()).filter(is_part).collect();
    Determined {
        best: Best {
            at: minimum.at.clone(),
            misfit: minimum.misfit,
            ..best.clone()
        },
        profiles,
        correlation: minimum.correlation(),
        widened: minimum.widened,
        undetermined,
        combined,
        quadratic: minimum.widened == 1.0
            && minimum.residual <= ROUGH * near
            && arms.iter().all(agrees),
        solved: 0,
    }
}

fn point(reached: &Reached, k: usize) -> ProfilePoint {
    let mut others = reached.at.clone();
    let at = others.remove(k);
    ProfilePoint {
        at,
        misfit: reached.misfit,
        others,
    }
}
