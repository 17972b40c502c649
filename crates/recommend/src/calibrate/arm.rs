//! One side of a profile: values of a coordinate farther and farther from the best, with the others optimised at each.

use super::counted::{Asking, squared};
use super::linear::{Eigen, block};
use super::local::{Local, Threshold};
use super::minimum::Minimum;
use super::reached::{Reached, between};

/// Values from half the width of the interval to the range of 10 %.
const VALUES: i32 = 6;

/// Values at most on the way to the end of the range: their distances then grow to any size.
const MOST: usize = 16;

/// Further values at most, next to the ends of the interval and the range of 10 %.
const FURTHER: usize = 10;

/// The values of one side.
#[derive(Debug)]
pub struct Arm<'a> {
    minimum: &'a Minimum,
    /// The coordinate.
    pub k: usize,
    /// 1 or -1.
    side: f64,
    /// By distance; the first is the best point.
    pub reached: Vec<Reached>,
    /// From the best point to the end of the range.
    pub room: f64,
    /// The next distance, and its growth.
    step: f64,
    growth: f64,
    further: usize,
    inner: Option<(Local, f64)>,
}

impl<'a> Arm<'a> {
    pub fn new(minimum: &'a Minimum, k: usize, side: f64) -> Arm<'a> {
        let at = minimum.at[k];
        let room = if side > 0.0 { 1.0 - at } else { at };
        let [near, far] = [minimum.rises.0, minimum.rises.1].map(|rise| minimum.width(k, rise));
        let step = 0.5 * near;
        let growth = libm::pow((1.2 * far / step).max(1.0), 1.0 / f64::from(VALUES - 1));
        let mut arm = Arm {
            minimum,
            k,
            side,
            reached: vec![Reached {
                distance: 0.0,
                rise: 0.0,
                misfit: minimum.misfit,
                at: minimum.at.clone(),
            }],
            room,
            step: step.min(room),
            growth: growth.clamp(1.25, 3.0),
            further: 0,
            inner: None,
        };
        arm.inner = arm.next();
        arm
    }

    /// Whether the misfit is still below a rise at the end of the range.
    pub fn is_open(&self, rise: f64) -> bool {
        let last = self.reached.last();
        last.is_some_and(|last| last.distance >= self.room && last.rise <= rise)
    }

    /// The next value to be optimised; `None` at the end.
    fn next(&mut self) -> Option<(Local, f64)> {
        let (near, far) = self.minimum.rises;
        let last = self.reached.last()?;
        let outward = last.distance < self.room && last.rise <= near.max(far);
        let distance = match outward {
            true => {
                let step = if self.reached.len() >= MOST {
                    self.room
                } else {
                    self.step
                };
                self.step *= if self.reached.len() > VALUES as usize {
                    self.growth.max(2.0)
                } else {
                    self.growth
                };
                step.max(last.distance).min(self.room)
            }
            false if self.further >= FURTHER => return None,
            false => {
                self.further += 1;
                [near, far]
                    .into_iter()
                    .find_map(|rise| between(&self.reached, rise))?
            }
        };
        Some((self.optimise(distance), distance))
    }

    /// A search over the others at this distance.
    fn optimise(&self, distance: f64) -> Local {
        let (minimum, k) = (self.minimum, self.k);
        let others: Vec<usize> = (0..minimum.at.len()).filter(|i| *i != k).collect();
        let before = self
            .reached
            .iter()
            .rposition(|r| r.distance < distance)
            .unwrap_or(0);
        let mut at = self.reached[before].at.clone();
        // Straight on, at first along the valley of the quadratic function.
        let slope: Vec<f64> = match before.checked_sub(1).map(|i| &self.reached[i]) {
            Some(earlier) => {
                let length = self.reached[before].distance - earlier.distance;
                others
                    .iter()
                    .map(|i| (at[*i] - earlier.at[*i]) / length)
                    .collect()
            }
            None => minimum
                .valley(k, &others)
                .iter()
                .map(|x| x * self.side)
                .collect(),
        };
        let further = distance - self.reached[before].distance;
        for (i, slope) in others.iter().zip(slope) {
            at[*i] = (at[*i] + slope * further).clamp(0.0, 1.0);
        }
        at[k] = (minimum.at[k] + self.side * distance).clamp(0.0, 1.0);
        if distance >= self.room {
            at[k] = if self.side > 0.0 { 1.0 } else { 0.0 };
        }
        let threshold = Threshold {
            relative: 0.2,
            ground: squared(minimum.misfit),
            least: minimum.smooth,
        };
        let rise = (0.2 * self.reached[before].rise).max(threshold.least);
        let conditional = block(&minimum.curvature, &others, &others);
        let mut shape = Eigen::of(&conditional).unwrap_or_else(|| Eigen::unit(others.len()));
        for value in &mut shape.values {
            *value = if *value > 0.0 {
                (rise / *value).sqrt()
            } else {
                1.0
            };
        }
        Local::new(at, others, shape, threshold).brief()
    }
}

impl Asking for Arm<'_> {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        self.inner
            .as_mut()
            .map_or(Vec::new(), |(local, _)| local.ask())
    }

    fn tell(&mut self, misfits: &[f64]) {
        let Some((local, distance)) = &mut self.inner else {
            return;
        };
        local.tell(misfits);
        if !local.has_ended() {
            return;
        }
        let (at, misfit) = local.best.clone();
        let found = Reached {
            distance: *distance,
            rise: squared(misfit) - squared(self.minimum.misfit),
            misfit,
            at,
        };
        let index = self
            .reached
            .partition_point(|r| r.distance < found.distance);
        self.reached.insert(index, found);
        self.inner = self.next();
    }
}
