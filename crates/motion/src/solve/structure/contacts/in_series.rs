//! Contacts in series over a step: one force, and the changes of all add up.
//!
//! With the flexibility a_i the answer J_i of a contact is a curve through all that its law allows: S = J_i(y), r' = r + y - a_i S. Under
//! S the contact may change by c_i(S) = y - a_i S, J_i(y) = S: a number that does not fall with S, or an interval where it slides, is
//! open, or yields. The force of the chain is the root of
//!
//! ```text
//! c_1(S) + c_2(S) + .. + a S = y
//! ```
//!
//! Neither 0 nor a bound of S is left to a search. Where several contacts have an interval, all of them change alike as far as they
//! can: this does not depend on their order or on units.

use super::series_root::{Bracket, NEAR, TRIES, filled, search};
/// A contact in series.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Part {
    /// a_i > 0, or 0 for a force that is known from the change.
    pub(crate) own: f64,
    /// The bounds of its force.
    pub(crate) bounds: [f64; 2],
    /// Its change in the step before, from which a search begins.
    pub(crate) change: f64,
}

/// Contacts in series with their answers J_i.
pub(crate) struct Series<'a> {
    pub(crate) parts: &'a [Part],
    pub(crate) answer: &'a dyn Fn(usize, f64) -> f64,
    /// The change c_i(S) and its slope where the law has them in closed form; `None` elsewhere.
    pub(crate) change: &'a dyn Fn(usize, f64) -> Option<[f64; 2]>,
    /// a.
    pub(crate) own: f64,
    /// The size of the numbers that y is the difference of.
    pub(crate) size: f64,
}

/// The force of a chain, and the changes of its contacts.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Shares {
    pub(crate) force: f64,
    pub(crate) changes: Vec<f64>,
}

/// The same as part of a size, where the root may be 0.
const TINY: f64 = 1e-19;

/// Growth of steps to the other side of a root.
const GROWTH: f64 = 8.0;

impl Series<'_> {
    /// The answer to y; `guess` is the force of the step before.
    pub(crate) fn share(&self, y: f64, guess: f64) -> Shares {
        let bound = |of: usize, start: f64, more: fn(f64, f64) -> f64| {
            let bounds = self.parts.iter().map(|part| part.bounds[of]);
            bounds.fold(start, more)
        };
        let [low, high] = [
            bound(0, f64::NEG_INFINITY, f64::max),
            bound(1, f64::INFINITY, f64::min),
        ];
        // Most steps are like the one before.
        let stays = guess == 0.0 || guess == low || guess == high;
        let stayed = match stays {
            true => self.stay(guess, y),
            false => None,
        };
        let near = stayed
            .or_else(|| self.by_changes(y, guess))
            .or_else(|| self.newton(y, guess, [low, high]));
        near.unwrap_or_else(|| self.find(y, [low, high]))
    }

    /// The answer by a search that always ends.
    fn find(&self, y: f64, [low, high]: [f64; 2]) -> Shares {
        let zero = 0.0;
        let first = match self.at(zero, y) {
            Ok(shares) => return shares,
            Err(rest) => rest,
        };
        // The changes under no force are too large, so that the contacts push.
        let bound = if first > 0.0 { low } else { high };
        let mut end = bound;
        if bound.is_finite() {
            if bound == zero {
                return self.fill(zero, y);
            }
            match self.at(bound, y) {
                Ok(shares) => return shares,
                Err(rest) if (rest > 0.0) == (first > 0.0) => return self.fill(bound, y),
                Err(_) => {}
            }
        } else {
            // What one contact alone would have.
            let answers = (0..self.parts.len()).map(|i| (self.answer)(i, -first).abs());
            let mut step = answers.fold(f64::MIN_POSITIVE, f64::max);
            for _ in 0..TRIES {
                end = -first.signum() * step;
                if (self.rest(end, y) > 0.0) != (first > 0.0) || !step.is_finite() {
                    break;
                }
                step *= GROWTH;
            }
        }
        let ends = if zero < end { [zero, end] } else { [end, zero] };
        let known = |force: f64| {
            if force == zero {
                first
            } else {
                self.rest(force, y)
            }
        };
        let bracket = Bracket {
            x: ends,
            f: ends.map(known),
        };
        let Bracket { x: forces, f } = search(
            bracket,
            |force| self.rest(force, y),
            f64::MIN_POSITIVE,
            false,
        );
        let force = if f[0].abs() < f[1].abs() {
            forces[0]
        } else {
            forces[1]
        };
        let interval = |i: usize| {
            let ends = [(forces[0], false), (forces[1], true)];
            ends.map(|(force, upper)| self.change(i, force, upper))
        };
        let intervals: Vec<[f64; 2]> = (0..self.parts.len()).map(interval).collect();
        let changes = filled(&intervals, y - self.own * force);
        Shares { force, changes }
    }

    /// The answer with the force of the step before, 0 or a bound, if it is one: contacts that have no more force change alike.
    fn stay(&self, force: f64, y: f64) -> Option<Shares> {
        let mut changes = vec![f64::NAN; self.parts.len()];
        let (mut rest, mut free) = (y - self.own * force, 0.0);
        for (i, part) in self.parts.iter().enumerate() {
            let [low, high] = part.bounds;
            if low < force && force < high {
                changes[i] = self.only_change(i, force)?;
                rest -= changes[i];
            } else {
                free += 1.0;
            }
        }
        rest /= free;
        for (i, change) in changes
            .iter_mut()
            .enumerate()
            .filter(|(_, change)| change.is_nan())
        {
            if (self.answer)(i, rest + self.parts[i].own * force) != force {
                return None;
            }
            *change = rest;
        }
        (free > 0.0).then_some(Shares { force, changes })
    }

    /// The changes under this force if it is the answer to y; else how much the changes differ from it.
    fn at(&self, force: f64, y: f64) -> Result<Shares, f64> {
        let total = y - self.own * force;
        let lowest: Vec<f64> = (0..self.parts.len())
            .map(|i| self.change(i, force, false))
            .collect();
        let low: f64 = lowest.iter().sum();
        let round_off = NEAR * self.size;
        if low - total > round_off {
            return Err(low - total);
        }
        let intervals: Vec<[f64; 2]> = lowest
            .into_iter()
            .enumerate()
            .map(|(i, low)| [low, self.change(i, force, true).max(low)])
            .collect();
        let high: f64 = intervals.iter().map(|[_, high]| high).sum();
        if high - total < -round_off {
            return Err(high - total);
        }
        Ok(Shares {
            force,
            changes: filled(&intervals, total),
        })
    }

    /// The changes under a force beyond which the contacts have none.
    fn fill(&self, force: f64, y: f64) -> Shares {
        let intervals: Vec<[f64; 2]> = (0..self.parts.len())
            .map(|i| [false, true].map(|upper| self.change(i, force, upper)))
            .collect();
        Shares {
            force,
            changes: filled(&intervals, y - self.own * force),
        }
    }

    /// How much the changes under a force are larger than those that y has.
    fn rest(&self, force: f64, y: f64) -> f64 {
        let changes = (0..self.parts.len()).map(|i| self.change(i, force, false));
        changes.sum::<f64>() + (self.own * force - y)
    }

    /// The lowest change of a contact under a force, or the uppermost.
    fn change(&self, part: usize, force: f64, upper: bool) -> f64 {
        let Part {
            own,
            bounds: [low, high],
            ..
        } = self.parts[part];
        if upper && force >= high {
            return f64::INFINITY;
        }
        if !upper && force <= low {
            return f64::NEG_INFINITY;
        }
        if let Some(change) = self.only_change(part, force) {
            return change;
        }
        let value = |y: f64| (self.answer)(part, y) - force;
        let is_right = |f: f64| if upper { f > 0.0 } else { f >= 0.0 };
        let start = own * force;
        let first = value(start);
        let right = is_right(first);
        let away = if right { -1.0 } else { 1.0 };
        // A line would be there.
        let mut step = (own * first).abs().max(1e-3 * (self.size + start.abs()));
        if step == 0.0 {
            step = own.max(f64::MIN_POSITIVE);
        }
        let [mut near, mut other] = [(start, first), (start, first)];
        for _ in 0..TRIES {
            let x = start + away * step;
            other = (x, value(x));
            if is_right(other.1) != right || !x.is_finite() {
                break;
            }
            near = other;
            step *= GROWTH;
        }
        if is_right(other.1) == right {
            return away * f64::INFINITY;
        }
        let (l, r) = if right { (other, near) } else { (near, other) };
        let bracket = Bracket {
            x: [l.0, r.0],
            f: [l.1, r.1],
        };
        let found = search(bracket, value, TINY * (self.size + start.abs()), upper);
        found.x[usize::from(!upper)] - start
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_equal_as_far_as_the_intervals_allow() {
        let infinite = f64::INFINITY;
        let intervals = [[0.0, infinite], [-1.0, 2.0], [5.0, 5.0]];
        assert_eq!(filled(&intervals, 4.0), [0.0, -1.0, 5.0]);
        assert_eq!(filled(&intervals, 4.5), [0.0, -0.5, 5.0]);
        assert_eq!(filled(&intervals, 7.0), [1.0, 1.0, 5.0]);
        assert_eq!(filled(&intervals, 10.0), [3.0, 2.0, 5.0]);
        assert_eq!(filled(&[[-infinite, infinite]; 2], 3.0), [1.5, 1.5]);
    }

    #[test]
    fn two_springs_share_as_their_stiffnesses() {
        // Springs of 2 and 6 that only push, and one of 3, with a = 0.5: 1/k = 1/2 + 1/6 + 1/3 + 1/2.
        let k = [2.0, 6.0, 3.0];
        let parts = [0, 1, 2].map(|i| Part {
            own: [0.1, 7.0, 1.0][i],
            bounds: [f64::NEG_INFINITY, if i < 2 { 0.0 } else { f64::INFINITY }],
            change: 0.0,
        });
        let answer = |i: usize, y: f64| {
            let force = y / (1.0 / k[i] + parts[i].own);
            if i < 2 { force.min(0.0) } else { force }
        };
        let series = Series {
            parts: &parts,
            answer: &answer,
            change: &|_, _| None,
            own: 0.5,
            size: 1.0,
        };
        let Shares { force, changes } = series.share(-3.0, 0.0);
        assert!((force + 2.0).abs() < 1e-15, "{force}");
        for (change, k) in changes.iter().zip(k) {
            assert!((change + 2.0 / k).abs() < 1e-15);
        }
        // Open: the spring has no force, both others move alike.
        let open = series.share(3.0, 0.0);
        assert_eq!(
            open,
            Shares {
                force: 0.0,
                changes: vec![1.5, 1.5, 0.0]
            }
        );
    }

    #[test]
    fn changes_in_closed_form_have_the_force_of_a_search() {
        // A damper with S = 3 v^0.35, v = 100 times its change, and a spring of 8000, with a = 1e-5.
        let (c, exponent, pace, k) = (3.0, 0.35, 100.0, 8e3);
        let parts = [1e-7, 2e-6].map(|own| Part {
            own,
            bounds: [f64::NEG_INFINITY, f64::INFINITY],
            change: 0.0,
        });
        let change = |i: usize, force: f64| -> Option<[f64; 2]> {
            let rate = libm::pow(force.abs() / c, 1.0 / exponent);
            let slope = rate / force.abs() / exponent;
            Some(
                [
                    [rate.copysign(force) / pace, slope / pace],
                    [force / k, 1.0 / k],
                ][i],
            )
        };
        // J(y) = S where c(S) + a S = y, by bisection.
        let answer = |i: usize, y: f64| {
            let [mut low, mut high] = [-1e6, 1e6];
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                let change_of_part =
                    change(i, middle).map_or(0.0, |numbers| numbers[0]) + parts[i].own * middle;
                if change_of_part < y {
                    low = middle
                } else {
                    high = middle
                }
            }
            0.5 * (low + high)
        };
        let (closed, searched) = (&change, &|_, _| None);
        for y in [-0.3, -0.002, 1e-5, 0.04] {
            let share = |change: &dyn Fn(usize, f64) -> Option<[f64; 2]>| {
                let series = Series {
                    parts: &parts,
                    answer: &answer,
                    change,
                    own: 1e-5,
                    size: 0.3,
                };
                series.share(y, 0.7)
            };
            let [newton, known] = [share(closed), share(searched)];
            // Round-off of y and of the size over the flexibility.
            assert!(
                (newton.force - known.force).abs() < 1e-10 * known.force.abs(),
                "{newton:?} {known:?}"
            );
            let sum: f64 = newton.changes.iter().sum();
            assert!((sum + 1e-5 * newton.force - y).abs() < 1e-16, "{newton:?}");
        }
    }

    #[test]
    fn changes_add_up_where_one_contact_hardly_gains_force() {
        // A force that tends to a limit, and a spring: at the limit a force with all its digits says nothing of the first change.
        let (limit, length, k) = (2.44, 1e-3, 8.7e3);
        let parts = [1e-6, 2e-6].map(|own| Part {
            own,
            bounds: [f64::NEG_INFINITY, f64::INFINITY],
            change: 0.0,
        });
        let answer = |i: usize, y: f64| match i {
            0 => limit * (1.0 - libm::exp(-y / length)),
            _ => y / (1.0 / k + parts[1].own),
        };
        for order in [[0, 1], [1, 0]] {
            let series = Series {
                parts: &order.map(|i| parts[i]),
                answer: &|i, y| answer(order[i], y),
                change: &|_, _| None,
                own: 3e-6,
                size: 0.03,
            };
            for i in 0..20 {
                let y = 0.02 + 1e-4 * f64::from(i);
                let guess = limit * (1.0 - libm::exp(-y / length));
                let Shares { force, changes } = series.share(y, guess);
                let spring = changes[order[1]];
                assert!((spring * k / force - 1.0).abs() < 1e-14, "{spring}");
                let sum: f64 = changes.iter().sum();
                // Round-off of 0.02.
                assert!((sum + 3e-6 * force - y).abs() < 1e-17, "{sum} {y}");
            }
        }
    }
}
