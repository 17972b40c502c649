//! The loops over all coordinates of a piece, eight at a time. Each number has the same bits with any vector instructions.

use super::row::LANES;
use slipgap_contact::for_widest;

/// One order of a piece of modes: u_(k+2) = factor (p - w^2 u_k - rate c u_(k+1) - B S).
pub struct Order<'a> {
    /// w^2 of each mode.
    pub squares: &'a [f64],
    /// c of each mode; `None` without damping.
    pub damping: Option<&'a [f64]>,
    /// (k + 1)/h.
    pub rate: f64,
    /// h^2/((k + 1) (k + 2)).
    pub factor: f64,
    /// u_k and u_(k+1).
    pub u: [&'a [f64]; 2],
    /// The pattern of each load with its number.
    pub loads: &'a [(f64, &'a [f64])],
    /// B and the force of each contact.
    pub contacts: &'a [(f64, &'a [f64])],
}

for_widest! {
    /// Computes one order into `next`, and r of it for each contact in as many parts as there are lanes. The number of modes is a
    /// multiple of the lanes.
    pub fn order(of: &Order, next: &mut [f64], r: &mut [[f64; LANES]]) {
        r.fill([0.0; LANES]);
        let [u, u1] = of.u.map(|u| u.as_chunks::<LANES>().0);
        let squares = of.squares.as_chunks::<LANES>().0;
        for (c, next) in next.as_chunks_mut::<LANES>().0.iter_mut().enumerate() {
            let mut a = [0.0; LANES];
            for (signal, pattern) in of.loads {
                let pattern = &pattern.as_chunks::<LANES>().0[c];
                for l in 0..LANES {
                    a[l] += signal * pattern[l];
                }
            }
            for l in 0..LANES {
                a[l] -= squares[c][l] * u[c][l];
            }
            if let Some(damping) = of.damping {
                let damping = &damping.as_chunks::<LANES>().0[c];
                for l in 0..LANES {
                    a[l] -= of.rate * (damping[l] * u1[c][l]);
                }
            }
            for (force, column) in of.contacts {
                let column = &column.as_chunks::<LANES>().0[c];
                for l in 0..LANES {
                    a[l] -= force * column[l];
                }
            }
            for l in 0..LANES {
                next[l] = of.factor * a[l];
            }
            for ((_, column), r) in of.contacts.iter().zip(r.iter_mut()) {
                let column = &column.as_chunks::<LANES>().0[c];
                for l in 0..LANES {
                    r[l] += column[l] * next[l];
                }
            }
        }
    }
}

for_widest! {
    /// u and u' at s from all terms, those of one power together.
    pub fn motion(terms: &[f64], [s, length]: [f64; 2], [u, v]: [&mut [f64]; 2]) {
        let n = u.len();
        let mut from = 0;
        while from + LANES <= n {
            let [mut x, mut rate] = [[0.0; LANES]; 2];
            for (k, terms) in terms.chunks_exact(n).enumerate().skip(1).rev() {
                let factor = k as f64 / length;
                let terms = &terms[from..from + LANES];
                for l in 0..LANES {
                    x[l] = (x[l] + terms[l]) * s;
                    rate[l] = rate[l] * s + factor * terms[l];
                }
            }
            for l in 0..LANES {
                u[from + l] = x[l] + terms[from + l];
                v[from + l] = rate[l];
            }
            from += LANES;
        }
        for i in from..n {
            let [mut x, mut rate] = [0.0; 2];
            for (k, terms) in terms.chunks_exact(n).enumerate().skip(1).rev() {
                let factor = k as f64 / length;
                x = (x + terms[i]) * s;
                rate = rate * s + factor * terms[i];
            }
            (u[i], v[i]) = (x + terms[i], rate);
        }
    }
}
