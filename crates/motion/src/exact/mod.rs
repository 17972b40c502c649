//! Exact solutions. They never use the methods of integration, so that computed motions can be compared with them.

pub mod adaptive;
mod bisection;
pub mod coulomb;
pub mod events;
pub mod mesh;
pub mod regularised;
pub mod spring;
mod state;
pub mod wave;

pub use state::State;

use bisection::bisect;

/// The first of `count` steps for which `past` holds, as it does for all later ones; `guess` is an estimate of it.
pub fn first_step(count: usize, guess: f64, past: impl Fn(usize) -> bool) -> usize {
    let mut step = (guess as usize).min(count);
    while step > 0 && past(step - 1) {
        step -= 1;
    }
    while step < count && !past(step) {
        step += 1;
    }
    step
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_step_does_not_depend_on_the_guess() {
        for count in 0..6 {
            for first in 0..=count {
                for guess in [0.0, 1.0, 2.7, 5.0, 9.0, 1e300, f64::NAN] {
                    assert_eq!(first_step(count, guess, |i| i >= first), first, "{guess}");
                }
            }
        }
    }
}
