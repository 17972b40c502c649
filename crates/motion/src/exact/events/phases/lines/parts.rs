//! The multilinear law: a spring beside parts that yield one after the other.

use super::{End, Line};
use crate::contact::Multilinear;
use crate::exact::events::phases::contact_phase::Phase;

/// What it keeps is the stretch of each part at the point of the line.
#[derive(Debug, Clone, Copy)]
pub struct Parts(pub Multilinear);

impl Parts {
    /// The line from r on with these stretches, on which the first parts yield in a direction.
    fn line(&self, r: f64, stretch: [f64; super::KEPT], yielding: usize, direction: f64) -> Line {
        let law = &self.0;
        let [low, high] = law.bends;
        // To the bend of the next part.
        let end = |bends: [f64; super::KEPT], never: f64| {
            let next = bends.iter().zip(&stretch).nth(yielding);
            next.map_or(never, |(bend, x)| r + (bend - x))
        };
        let low = end(low, f64::NEG_INFINITY);
        let high = end(high, f64::INFINITY);
        let parts = law.parts.iter().zip(&stretch);
        let loss = parts.take(yielding).map(|(k, x)| k * x);
        let rest: f64 = law.parts.iter().skip(yielding).sum();
        // A reversal ends a line on which parts yield before r comes back.
        let ends = match direction {
            _ if direction > 0.0 => [f64::NEG_INFINITY, high],
            _ if direction < 0.0 => [low, f64::INFINITY],
            _ => [low, high],
        };
        let phase = match yielding {
            0 => Phase::Closed,
            _ => Phase::Sliding(direction),
        };
        Line {
            slope: law.stiffness + rest,
            point: [r, law.force(r, &stretch)],
            direction,
            loss: [loss.sum(), 0.0],
            phase,
            yielding,
            kept: stretch,
            ..Line::open(ends)
        }
    }

    /// The stretches at r.
    fn stretches(&self, line: &Line, r: f64) -> [f64; super::KEPT] {
        let change = r - line.point[0];
        let mut stretch = line.kept;
        for x in stretch.iter_mut().skip(line.yielding) {
            *x += change;
        }
        stretch
    }

    pub fn start(&self, r: f64) -> Line {
        let stretch = self.0.first(r);
        let bends = self.0.bends[usize::from(r > 0.0)];
        let yielding = bends.iter().take_while(|bend| bend.abs() < r.abs()).count();
        let direction = if yielding > 0 { r.signum() } else { 0.0 };
        self.line(r, stretch, yielding, direction)
    }

    /// Whether a first loading to r has this force, but for round-off.
    pub fn is_first(&self, r: f64, force: f64) -> bool {
        let first = self.0.force(r, &self.0.first(r));
        (force - first).abs() <= 1e-9 * first.abs()
    }

    pub fn next(&self, line: &Line, end: End, r: f64) -> Line {
        let mut stretch = self.stretches(line, r);
        let direction = match end {
            End::Turn => return self.line(r, stretch, 0, 0.0),
            End::Low => -1.0,
            End::High => 1.0,
        };
        let bends = self.0.bends[usize::from(direction > 0.0)];
        let next = line.yielding;
        if let (Some(x), Some(bend)) = (stretch.get_mut(next), bends.get(next)) {
            *x = *bend;
        }
        self.line(r, stretch, next + 1, direction)
    }

    pub fn stored(&self, line: &Line, r: f64) -> f64 {
        let law = &self.0;
        let stretch = self.stretches(line, r);
        let parts = law.parts.iter().zip(&stretch);
        0.5 * (law.stiffness * r * r + parts.map(|(k, x)| k * x * x).sum::<f64>())
    }
}
