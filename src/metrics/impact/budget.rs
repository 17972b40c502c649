//! What the error of a bar impact is made of: between the exact contact and the computed one stand the bars on their
//! spring as continua, and the chain of elements in continuous time.

use super::{Sampled, Track};
use crate::history::History;
use crate::lane::Lane;

/// Norms of the three parts as `rms_error_r` and `rms_error_rdot` have them, each of r and of rdot: the spring's
/// (continuum minus exact), the mesh's (chain minus continuum), the step's (computed minus chain). Then in the same
/// order their shares <part, c - e>/<c - e, c - e>.
///
/// Shares of one quantity add to 1; one below 0 or above 1 says that the parts oppose each other.
pub fn budget(
    c: &Track<1>,
    exact: &Sampled,
    spring: &History,
    chain: &History,
) -> [Option<f64>; 12] {
    let of_r = parts(
        0,
        [spring.displacement(), chain.displacement()],
        &c.displacement,
        exact,
    );
    let of_rdot = parts(1, [spring.velocity(), chain.velocity()], &c.velocity, exact);
    let both = std::array::from_fn(|row| if row % 2 == 0 { of_r } else { of_rdot }[row / 2]);
    both.map(|x: f64| Some(x).filter(|x| x.is_finite()))
}

/// Three norms and three shares of one quantity, `of` as in [`Sampled::mean`].
fn parts(of: usize, [spring, chain]: [&[f64]; 2], c: &[Lane<1>], exact: &Sampled) -> [f64; 6] {
    let c = |i: usize| c[i].0[0];
    let parts: [&dyn Fn(usize, f64) -> f64; 3] = [
        &|i, e| spring[i] - e,
        &|i, _| chain[i] - spring[i],
        &|i, _| c(i) - chain[i],
    ];
    let mean = |what: &dyn Fn(usize, f64) -> f64| exact.mean(of, |i, e| Lane([what(i, e)])).0[0];
    let rms = |part: &dyn Fn(usize, f64) -> f64| mean(&|i, e| part(i, e) * part(i, e)).sqrt();
    let whole = mean(&|i, e| (c(i) - e) * (c(i) - e));
    let share = |part: &dyn Fn(usize, f64) -> f64| mean(&|i, e| part(i, e) * (c(i) - e)) / whole;
    let [a, b, d] = parts;
    [rms(a), rms(b), rms(d), share(a), share(b), share(d)]
}
