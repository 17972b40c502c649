//! Exact solutions. They never import the stepper, so that the one can judge the other.

pub mod chain;
pub mod coulomb;
pub mod regularised;
pub mod spring;
pub mod wave;

/// The first of `count` steps for which `past` holds, as it does for all later ones; near `guess`.
pub(crate) fn first_step(count: usize, guess: f64, past: impl Fn(usize) -> bool) -> usize {
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
    fn the_first_step_is_found_from_any_guess() {
        for count in 0..6 {
            for first in 0..=count {
                for guess in [0.0, 1.0, 2.7, 5.0, 9.0, 1e300, f64::NAN] {
                    assert_eq!(first_step(count, guess, |i| i >= first), first, "{guess}");
                }
            }
        }
    }
}
