//! The parts of the error of a bar impact. Between the exact contact and the computed one are the continuous bars on their
//! spring, and the mesh in continuous time.

use super::{Sampled, Track};
use crate::history::History;
use crate::lane::Lane;

/// Norms of the three parts, defined as `rms_error_r` and `rms_error_rdot`, each of r and of rdot: of the spring (continuous bars
/// minus exact), of the mesh (mesh minus continuous bars), and of the step (computed minus mesh). Then in the same order their
/// shares <part, c - e>/<c - e, c - e>.
///
/// The shares of r add up to 1, and so do those of rdot. A share below 0 or above 1 means that parts have opposite signs.
pub fn budget(
    c: &Track<1>,
    exact: &Sampled,
    spring: &History,
    mesh: &History,
) -> [Option<f64>; 12] {
    let displacements = [spring.displacement(), mesh.displacement()];
    let velocities = [spring.velocity(), mesh.velocity()];
    let of_r = parts(0, displacements, &c.displacement, exact);
    let of_rdot = parts(1, velocities, &c.velocity, exact);
    let both = std::array::from_fn(|row| if row % 2 == 0 { of_r } else { of_rdot }[row / 2]);
    both.map(|x: f64| Some(x).filter(|x| x.is_finite()))
}

/// Errors of r and rdot of motions against `coarse` ones, which have some of their times: the larger root of the mean square.
pub fn reference_errors(motions: &[History; 2], coarse: &[History; 2]) -> [Option<f64>; 2] {
    [0, 1].map(|channel| {
        let errors = motions.iter().zip(coarse).map(|(motion, coarse)| {
            let mut own = motion.time.iter().zip(motion.channel(channel));
            let same = coarse.time.iter().zip(coarse.channel(channel));
            let squares = same.filter_map(|(time, coarse)| {
                let (_, x) = own.find(|(own, _)| *own == time)?;
                Some((x - coarse) * (x - coarse))
            });
            (squares.sum::<f64>() / coarse.len() as f64).sqrt()
        });
        Some(errors.fold(0.0, f64::max)).filter(|x| x.is_finite())
    })
}

/// Three norms and three shares of one component, see [`Sampled::mean`].
fn parts(
    component: usize,
    [spring, mesh]: [&[f64]; 2],
    c: &[Lane<1>],
    exact: &Sampled,
) -> [f64; 6] {
    let c = |i: usize| c[i].0[0];
    let parts: [&dyn Fn(usize, f64) -> f64; 3] = [
        &|i, e| spring[i] - e,
        &|i, _| mesh[i] - spring[i],
        &|i, _| c(i) - mesh[i],
    ];
    let mean =
        |value: &dyn Fn(usize, f64) -> f64| exact.mean(component, |i, e| Lane([value(i, e)])).0[0];
    let rms =
        |part: &dyn Fn(usize, f64) -> f64| exact.rms(component, |i, e| Lane([part(i, e)])).0[0];
    let total = mean(&|i, e| (c(i) - e) * (c(i) - e));
    let share = |part: &dyn Fn(usize, f64) -> f64| mean(&|i, e| part(i, e) * (c(i) - e)) / total;
    let [a, b, d] = parts;
    [rms(a), rms(b), rms(d), share(a), share(b), share(d)]
}
