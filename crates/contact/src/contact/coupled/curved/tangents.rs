//! The step from a point to the minimum of the tangents.

use super::point::Point;
use super::{LEVEL, Laws, Numbers};
use crate::contact::coupled::{CoupledForces, Unsolved};

/// Least 1/f' as part of a: without it, tangents of contacts that depend on each other may be singular.
const SOFTENING: f64 = 1e-12;

/// 1/f' over a of a force in a plane in the direction in which it does not follow.
const HELD: f64 = 1e8;

/// Least width of a chord over the sizes of y and a S, whose difference is r'. Where a is far larger than the law's own 1/f', at nodes
/// without mass, such a chord may be as long as the law; the search then goes on with the narrow one, a thousand times round-off.
const WIDE: f64 = 1e-8;
const NARROW: f64 = 1e-12;

/// Number of steps with wide chords. Few searches need more than 20.
const WITH_WIDE: usize = 40;

/// The step from a point to the minimum of the tangents.
#[derive(Debug, Clone)]
pub(super) struct Tangents {
    problem: CoupledForces,
    /// 1/f'.
    pub(super) compliance: Vec<f64>,
    low: Vec<f64>,
    high: Vec<f64>,
    size: Vec<f64>,
    /// x, then the change of S.
    pub(super) change: Vec<f64>,
    /// Of contacts in a plane: 1/f', a symmetric matrix by its entries 11, 12 and 22.
    planes: Vec<[f64; 3]>,
}

impl Tangents {
    /// `matrix`: H with a positive diagonal more, which makes it regular.
    pub(super) fn new(matrix: Vec<f64>, contacts: usize) -> Tangents {
        let zero = || vec![0.0; contacts];
        Tangents {
            problem: CoupledForces::new(matrix, contacts),
            compliance: zero(),
            low: zero(),
            high: zero(),
            size: zero(),
            change: zero(),
            planes: vec![[0.0; 3]; contacts],
        }
    }

    /// The tangent of a contact in a plane, whose force has no bounds of its own in the step.
    fn plane(&mut self, laws: &dyn Laws, point: &Point, i: usize, flexibility: f64) {
        let y = [point.y[i], point.y[i + 1]];
        let force = [point.answer[i], point.answer[i + 1]];
        let directions = laws.directions(i, y, force);
        // A force that does not follow in a direction is as good as held by a large 1/f'.
        self.planes[i] = directions.matrix(HELD * flexibility);
        let clamped = directions.slopes.map(|g| g.clamp(0.0, HELD * flexibility));
        let least = clamped[0].min(clamped[1]);
        for row in i..i + 2 {
            self.compliance[row] = least;
            (self.low[row], self.high[row]) = (f64::NEG_INFINITY, f64::INFINITY);
        }
    }

    /// The change of S to the minimum of the tangents; false if there is none. `steps` were taken before.
    pub(super) fn solve(
        &mut self,
        step: Numbers,
        point: &Point,
        flexibilities: &[f64],
        flexibility: &[f64],
        steps: usize,
    ) -> bool {
        let m = flexibilities.len();
        let least = if steps > WITH_WIDE { NARROW } else { WIDE };
        let mut second = false;
        for (i, flexibility) in flexibilities.iter().enumerate() {
            self.size[i] = point.rest[i].abs();
            if std::mem::take(&mut second) {
                continue;
            }
            if step.laws.is_plane(i) {
                self.plane(step.laws, point, i, *flexibility);
                second = true;
                continue;
            }
            let (y, s) = (point.y[i], point.answer[i]);
            let scale = y.abs() + flexibility * s.abs();
            // A chord is to be short beside the step.
            let rest = flexibility * (s - point.force[i]).abs();
            let width = f64::max(1e-3 * rest, least * scale);
            let g = step.compliance(i, y, s, width);
            self.compliance[i] = g;
            let [low, high] = step.laws.bounds(i);
            let follows = g < LEVEL * flexibility;
            [self.low[i], self.high[i]] = match follows {
                true => [low - s, high - s],
                false => [0.0; 2],
            };
        }
        let mut soft = SOFTENING;
        loop {
            let mut second = false;
            for i in 0..m {
                if std::mem::take(&mut second) {
                    continue;
                }
                if step.laws.is_plane(i) {
                    let [own_g, between, next] = self.planes[i];
                    let h = |i: usize, j: usize| flexibility[i * m + j];
                    let more = soft * flexibilities[i];
                    self.problem.set_pair(
                        i,
                        [
                            h(i, i) + own_g + more,
                            h(i, i + 1) + between,
                            h(i + 1, i + 1) + next + more,
                        ],
                    );
                    second = true;
                    continue;
                }
                let compliance = self.compliance[i].max(soft * flexibilities[i]);
                let g = if compliance < LEVEL * flexibilities[i] {
                    compliance
                } else {
                    flexibilities[i]
                };
                self.problem.set_diagonal(i, flexibility[i * m + i] + g);
            }
            let Tangents {
                low,
                high,
                size,
                change,
                ..
            } = self;
            match self.problem.solve(&point.rest, low, high, size, change) {
                // Any larger 1/f' leads downhill, too.
                Err(Unsolved::Singular) if soft < 1.0 => soft *= 10.0,
                Err(_) => return false,
                Ok(()) => break,
            }
        }
        for (i, change) in self.change.iter_mut().enumerate() {
            *change += point.answer[i] - point.force[i];
        }
        true
    }
}
