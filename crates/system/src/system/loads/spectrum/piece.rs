//! The motion of an oscillator while the ground acceleration is straight, over at most one radian.
//!
//! On a piece of the length h with omega h <= 1, the Taylor coefficients of u(h tau) follow from
//! u'' + 2 zeta omega u' + omega^2 u = -a:
//!
//! ```text
//! (k+1)(k+2) c_(k+2) = -h^2 a_k - 2 zeta omega h (k+1) c_(k+1) - (omega h)^2 c_k,   a = a_0 + a_1 tau
//! ```
//!
//! They fall like 1/k!, so 20 of them are exact to round-off. The closed form would lose digits by cancellation for long periods.

/// Number of Taylor coefficients: 1/20! < 1e-18.
const TERMS: usize = 20;

/// The motion on a piece as a polynomial of tau from 0 to 1.
pub(super) struct Piece([f64; TERMS]);

impl Piece {
    /// The motion for omega h and the damping ratio, from u and h u' on, under the load h^2 a_0 and h^2 (a_1 - a_0).
    pub fn new([turn, ratio]: [f64; 2], start: [f64; 2], load: [f64; 2]) -> Piece {
        let mut c = [0.0; TERMS];
        [c[0], c[1]] = start;
        for k in 0..TERMS - 2 {
            let next = (k + 1) as f64;
            let load = load.get(k).copied().unwrap_or(0.0);
            let sum = load + 2.0 * ratio * turn * next * c[k + 1] + turn * turn * c[k];
            c[k + 2] = -sum / (next * (next + 1.0));
        }
        Piece(c)
    }

    /// A sum of two motions over the same time, each times a factor.
    pub fn plus(&self, own_factor: f64, other: &Piece, factor: f64) -> Piece {
        let mut sum = self.0;
        for (c, other) in sum.iter_mut().zip(other.0) {
            *c = own_factor * *c + factor * other;
        }
        Piece(sum)
    }

    /// Largest |u| inside and at the end.
    pub fn peak(&self) -> f64 {
        let [first, second] = self.extremes();
        let ends = [first, second, Some(1.0)].into_iter().flatten();
        ends.fold(0.0, |peak: f64, tau| peak.max(self.u(tau).abs()))
    }

    /// u.
    pub fn u(&self, tau: f64) -> f64 {
        self.0.iter().rev().fold(0.0, |sum, c| sum * tau + c)
    }

    /// du/dtau.
    pub fn v(&self, tau: f64) -> f64 {
        (1..TERMS)
            .rev()
            .fold(0.0, |sum, k| sum * tau + k as f64 * self.0[k])
    }

    /// d2u/dtau2.
    fn y(&self, tau: f64) -> f64 {
        (2..TERMS)
            .rev()
            .fold(0.0, |sum, k| sum * tau + (k * (k - 1)) as f64 * self.0[k])
    }

    /// u and du/dtau at the end.
    pub fn end(&self) -> [f64; 2] {
        [self.u(1.0), self.v(1.0)]
    }

    /// d2u/dtau2 and d3u/dtau3 at the start.
    #[cfg(test)]
    pub fn bend(&self) -> [f64; 2] {
        [2.0 * self.0[2], 6.0 * self.0[3]]
    }

    /// The extremes of u inside: v is 0.
    ///
    /// y is 0 at most once, because omega h <= 1 < pi. So v is 0 at most twice: once if it changes its sign, twice only if y does.
    pub fn extremes(&self) -> [Option<f64>; 2] {
        let v = |tau| self.v(tau);
        if let Some(tau) = root(v, 0.0, 1.0) {
            return [Some(tau), None];
        }
        match root(|tau| self.y(tau), 0.0, 1.0) {
            Some(turn) => [root(v, 0.0, turn), root(v, turn, 1.0)],
            None => [None, None],
        }
    }
}

/// The root of a function whose sign differs at the ends, by bisection.
fn root(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> Option<f64> {
    let start = f(low);
    let end = f(high);
    if start == 0.0 || end == 0.0 || (start < 0.0) == (end < 0.0) {
        return None;
    }
    // 2^-53 of the piece.
    for _ in 0..53 {
        let middle = 0.5 * (low + high);
        if (f(middle) < 0.0) == (start < 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_extremes_inside_one_piece_are_both_seen() {
        // u = tau^3/3 - tau^2/2 + 3/16 tau has extremes at 1/4 and 3/4; its y changes its sign at 1/2.
        let mut c = [0.0; TERMS];
        (c[1], c[2], c[3]) = (3.0 / 16.0, -0.5, 1.0 / 3.0);
        let [first, second] = Piece(c).extremes();
        // Round-off of v, whose slope is 1/2 there.
        let near = |tau: Option<f64>, exact: f64| assert!((tau.unwrap() - exact).abs() < 1e-15);
        near(first, 0.25);
        near(second, 0.75);
    }
}
