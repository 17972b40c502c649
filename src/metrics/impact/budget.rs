//! What the error of a bar impact is made of: between the exact contact and the computed one stand the bars on their
//! spring as continua, and the chain of elements in continuous time.

use super::{Norm, displacement, velocity};
use crate::exact::wave::Wave;
use crate::history::History;

/// Norms of the three parts as `rms_error_r` and `rms_error_rdot` have them, each of r and of rdot: the spring's
/// (continuum minus exact), the mesh's (chain minus continuum), the step's (computed minus chain). Then in the same
/// order their shares <part, c - e>/<c - e, c - e>.
///
/// Shares of one quantity add to 1; one below 0 or above 1 says that the parts oppose each other.
pub fn budget(
    c: &History,
    wave: &Wave,
    spring: &History,
    chain: &History,
    duration: f64,
) -> [Option<f64>; 12] {
    let of_r = parts(
        [&c.displacement, &spring.displacement, &chain.displacement],
        &Norm {
            time: &c.time,
            wave,
            of: displacement,
            duration,
        },
    );
    let of_rdot = parts(
        [&c.velocity, &spring.velocity, &chain.velocity],
        &Norm {
            time: &c.time,
            wave,
            of: velocity,
            duration,
        },
    );
    let both = std::array::from_fn(|row| if row % 2 == 0 { of_r } else { of_rdot }[row / 2]);
    both.map(|x: f64| Some(x).filter(|x| x.is_finite()))
}

/// Three norms and three shares of one quantity.
fn parts([c, spring, chain]: [&[f64]; 3], norm: &Norm) -> [f64; 6] {
    let parts: [&dyn Fn(usize, f64) -> f64; 3] = [
        &|i, e| spring[i] - e,
        &|i, _| chain[i] - spring[i],
        &|i, _| c[i] - chain[i],
    ];
    let rms = |part: &dyn Fn(usize, f64) -> f64| norm.mean(|i, e| part(i, e) * part(i, e)).sqrt();
    let whole = norm.mean(|i, e| (c[i] - e) * (c[i] - e));
    let share =
        |part: &dyn Fn(usize, f64) -> f64| norm.mean(|i, e| part(i, e) * (c[i] - e)) / whole;
    let [a, b, d] = parts;
    [rms(a), rms(b), rms(d), share(a), share(b), share(d)]
}
