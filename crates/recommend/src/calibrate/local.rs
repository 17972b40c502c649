//! The nearest minimum of the squared misfit, by quadratic functions fitted to blocks of points. The points are as far from the best
//! one as the squared misfit takes to rise by a threshold: jumps that are smaller do not mislead the search.

use super::counted::{Asking, squared};
use super::linear::{Eigen, axis, dot};
use super::model::{Model, Shape, design};

/// Gains below this part of the threshold end the search.
const GAIN: f64 = 1e-4;

/// Largest step, in lengths of the points.
const RADIUS: f64 = 2.5;

/// Smallest and largest length of the points along an axis.
const LENGTHS: [f64; 2] = [1e-9, 0.25];

/// The rise of the squared misfit over the lengths of the points.
#[derive(Debug, Clone, Copy)]
pub struct Threshold {
    /// Relative to the height of the squared misfit above `ground`.
    pub relative: f64,
    pub ground: f64,
    /// Smallest rise, > 0.
    pub least: f64,
}

impl Threshold {
    pub fn at(&self, square: f64) -> f64 {
        (self.relative * (square - self.ground).abs()).max(self.least)
    }
}

/// A search over some of the coordinates.
#[derive(Debug, Clone)]
pub struct Local {
    free: Vec<usize>,
    threshold: Threshold,
    crosses: bool,
    /// Blocks left.
    blocks: usize,
    centre: Vec<f64>,
    /// Lengths along axes, in free coordinates.
    pub shape: Shape,
    /// Part of the lengths after steps that failed.
    part: f64,
    least_part: f64,
    asked: Vec<Vec<f64>>,
    /// The best point and its misfit.
    pub best: (Vec<f64>, f64),
    /// The last fit, and its centre.
    pub model: Option<(Model, Vec<f64>)>,
    ended: bool,
}

impl Local {
    pub fn new(at: Vec<f64>, free: Vec<usize>, shape: Shape, threshold: Threshold) -> Local {
        Local {
            free,
            threshold,
            crosses: true,
            blocks: 15,
            best: (at.clone(), f64::INFINITY),
            centre: at,
            shape: limited(shape),
            part: 1.0,
            least_part: 0.0,
            asked: Vec::new(),
            model: None,
            ended: false,
        }
    }

    /// The same with fewer points: no products of coordinates in the fit if there are many, and fewer blocks.
    pub fn brief(mut self) -> Local {
        self.crosses = self.free.len() <= 4;
        self.blocks = 6;
        self
    }

    /// The same with points that stay as far apart as the threshold says, so that the fit shows jumps.
    pub fn steady(mut self) -> Local {
        self.least_part = 0.5;
        self
    }

    /// Whether it asks for no more points.
    pub fn has_ended(&self) -> bool {
        self.ended
    }

    /// A point whose displacement would leave the ranges is reflected along its own line: reflected coordinates would leave a narrow
    /// valley, and what the fit leaves would look like jumps.
    fn point(&self, u: &[f64]) -> Vec<f64> {
        let step = |k: usize| -> f64 {
            let along = u.iter().zip(&self.shape.values).zip(&self.shape.vectors);
            along.map(|((u, length), b)| u * length * b[k]).sum()
        };
        let steps: Vec<f64> = (0..self.free.len()).map(step).collect();
        let part = self.inside(&steps);
        let mut point = self.centre.clone();
        for (i, step) in self.free.iter().zip(&steps) {
            point[*i] = (point[*i] + part * step).clamp(0.0, 1.0);
        }
        point
    }

    /// The part of a displacement that stays within the ranges, after a reflection at their end.
    fn inside(&self, steps: &[f64]) -> f64 {
        let room = |sign: f64| {
            let each = self
                .free
                .iter()
                .zip(steps)
                .map(|(i, step)| match sign * step {
                    d if d > 0.0 => (1.0 - self.centre[*i]) / d,
                    d if d < 0.0 => -self.centre[*i] / d,
                    _ => f64::INFINITY,
                });
            each.fold(f64::INFINITY, f64::min)
        };
        match room(1.0) {
            ahead if ahead >= 1.0 => 1.0,
            ahead => (2.0 * ahead - 1.0).max(-room(-1.0)),
        }
    }

    /// The displacement of a point from the centre, in free coordinates.
    fn displacement(&self, point: &[f64]) -> Vec<f64> {
        self.free
            .iter()
            .map(|i| point[*i] - self.centre[*i])
            .collect()
    }

    /// Fits, and chooses the next centre and lengths.
    fn advance(&mut self, misfits: &[f64], before: f64) {
        let finite = self
            .asked
            .iter()
            .zip(misfits)
            .filter(|(_, m)| m.is_finite());
        let (points, values): (Vec<_>, Vec<_>) = finite
            .map(|(x, m)| (self.displacement(x), squared(*m)))
            .unzip();
        let best = squared(self.best.1);
        let Some(model) = Model::fit(&self.shape, &points, &values, self.crosses) else {
            // Fewer fail near the best; points along the coordinates determine a fit at bounds.
            let n = self.free.len();
            let extent = |k: usize| {
                let along = self.shape.values.iter().zip(&self.shape.vectors);
                along.map(|(l, b)| (l * b[k]).abs()).fold(0.0, f64::max)
            };
            let lengths = (0..n).map(|k| 0.5 * extent(k)).collect();
            self.shape = limited(Eigen {
                values: lengths,
                vectors: (0..n).map(|k| axis(n, k)).collect(),
            });
            self.centre = self.best.0.clone();
            self.ended |= self.best.1.is_infinite();
            return;
        };
        let threshold = self.threshold.at(best);
        let ends = |end: f64| {
            self.free
                .iter()
                .map(|i| end - self.centre[*i])
                .collect::<Vec<f64>>()
        };
        let step = model.minimum(&self.shape, RADIUS, &ends(0.0), &ends(1.0));
        let gain = best - model.at(&step);
        // The first value is that of the centre, to which the last fit led.
        self.part = match squared(misfits[0]) > before + 0.1 * threshold {
            true => (self.part * 0.5).max(self.least_part),
            false => (2.0 * self.part).min(1.0),
        };
        let centre = match gain > 0.0 {
            true => {
                let mut centre = self.centre.clone();
                self.free
                    .iter()
                    .zip(&step)
                    .for_each(|(i, d)| centre[*i] = (centre[*i] + d).clamp(0.0, 1.0));
                centre
            }
            false => self.best.0.clone(),
        };
        let shape = self.lengths(&model, threshold);
        let settled = shape.values.iter().zip(&shape.vectors).all(|(length, b)| {
            let ratio = length / self.extent(b);
            (0.4..=2.5).contains(&ratio)
        });
        self.ended |= gain <= GAIN * threshold && settled;
        self.model = Some((model, std::mem::replace(&mut self.centre, centre)));
        self.shape = shape;
    }

    /// The present length along a direction.
    fn extent(&self, direction: &[f64]) -> f64 {
        let along = self.shape.values.iter().zip(&self.shape.vectors);
        let inverse: f64 = along
            .map(|(l, b)| (dot(b, direction) / l) * (dot(b, direction) / l))
            .sum();
        1.0 / inverse.sqrt()
    }

    /// The lengths over which the model rises by the threshold, along the axes of its curvature.
    fn lengths(&self, model: &Model, threshold: f64) -> Shape {
        let Some(mut eigen) = Eigen::of(&model.curvature) else {
            return self.shape.clone();
        };
        for (value, direction) in eigen.values.iter_mut().zip(&eigen.vectors) {
            let present = self.extent(direction);
            let wanted = if *value > 0.0 {
                (threshold / *value).sqrt()
            } else {
                f64::INFINITY
            };
            *value = (self.part * wanted).clamp(present / 10.0, present * 4.0);
        }
        limited(eigen)
    }
}

/// With lengths within their limits.
fn limited(mut shape: Shape) -> Shape {
    shape
        .values
        .iter_mut()
        .for_each(|x| *x = x.clamp(LENGTHS[0], LENGTHS[1]));
    shape
}

impl Asking for Local {
    fn ask(&mut self) -> Vec<Vec<f64>> {
        if self.ended {
            return Vec::new();
        }
        let points = design(self.free.len(), self.crosses);
        self.asked = points.iter().map(|u| self.point(u)).collect();
        self.asked.clone()
    }

    fn tell(&mut self, misfits: &[f64]) {
        let before = squared(self.best.1);
        for (point, misfit) in self.asked.iter().zip(misfits) {
            if *misfit < self.best.1 {
                self.best = (point.clone(), *misfit);
            }
        }
        self.blocks -= 1;
        self.ended = self.blocks == 0 || self.free.is_empty();
        if !self.free.is_empty() {
            self.advance(misfits, before);
        }
    }
}
