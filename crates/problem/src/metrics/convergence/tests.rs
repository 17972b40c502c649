use super::*;

/// The exact motion of the tests: a sine.
fn exact(shift: f64) -> Vec<f64> {
    (0..200)
        .map(|i| libm::sin(0.05 * f64::from(i)) + if i > 0 { shift } else { 0.0 })
        .collect()
}

/// The motion after `halvings` with an error of this order that swings around it.
fn halved(halvings: u32, order: i32) -> Vec<f64> {
    let size = 0.01 / 2.0_f64.powi(halvings as i32 * order);
    let error = |i: usize| size * libm::cos(0.3 * i as f64);
    let values = exact(0.0).into_iter().enumerate();
    values.map(|(i, x)| x + error(i)).collect()
}

/// The error of an exact motion by this estimate and these motions, and the number of halvings.
fn error(exact: &[f64], estimate: f64, motion: impl Fn(u32) -> Vec<f64>) -> (f64, u32) {
    let channel = Referred {
        exact: exact.to_vec(),
        computed: motion(0),
        size: 1.0,
        estimate,
    };
    let mut count = 0;
    let errors = reference_errors(&[channel], |halvings| {
        count = halvings;
        Some(Halved {
            channels: vec![motion(halvings)],
            resolved: true,
        })
    });
    (errors[0], count)
}

#[test]
fn right_motions_keep_their_estimate() {
    for order in [1, 2, 4] {
        let found = error(&exact(0.0), 1e-12, |halvings| halved(halvings, order));
        assert_eq!(found, (1e-12, 4), "{order}");
    }
    // A first order whose factor swings by as much as 2 in each halving.
    let uneven = |halvings: u32| {
        let factor = [1.0, 0.5, 1.3, 0.7, 1.0, 0.5, 1.3][halvings as usize];
        let pairs = halved(halvings, 1).into_iter().zip(exact(0.0));
        pairs.map(|(c, e)| e + factor * (c - e)).collect()
    };
    assert_eq!(error(&exact(0.0), 1e-12, uneven).0, 1e-12);
}

#[test]
fn a_wrong_motion_is_seen_at_its_size() {
    for order in [1, 2] {
        for shift in [1e-1, 1e-2, 1e-3] {
            let (found, count) = error(&exact(shift), 1e-12, |halvings| halved(halvings, order));
            // The bound of what the steps may err by after so many halvings: four times 0.01/sqrt(2) at first.
            let bound =
                |halvings: u32| 4.1 * 0.01 / 2.0_f64.sqrt() / 2.0_f64.powi(halvings as i32 * order);
            // A smaller error is none that the steps could tell.
            if shift < bound(4) {
                continue;
            }
            assert_eq!(count, MOST_HALVINGS);
            let most = bound(5);
            assert!(
                found <= shift && found >= shift - most,
                "{order} {shift}: {found}"
            );
        }
    }
}

#[test]
fn a_body_at_rest_shows_a_wrong_place() {
    let rest = |_| vec![1.0; 200];
    assert_eq!(error(&[1.0; 200], 1e-14, rest), (1e-14, 4));
    let (found, _) = error(&[1.01; 200], 1e-14, rest);
    assert!((found - 0.01).abs() < 1e-9, "{found}");
    // Round-off of both, which does not converge.
    let noise = |k: u32| (0..200).map(move |i| 1.0 + 1e-14 * f64::from((7 * i + 3 * k) % 5));
    assert_eq!(
        error(&[1.0; 200], 1e-14, |k| noise(k).collect()),
        (1e-14, 4)
    );
}

#[test]
fn steps_that_do_not_converge_say_nothing() {
    let other = |k: u32| (0..200).map(move |i| libm::sin(f64::from(i * (k + 1))));
    assert_eq!(error(&exact(0.0), 1e-12, |k| other(k).collect()).0, 1e-12);
}

#[test]
fn steps_that_do_not_resolve_the_motion_say_nothing() {
    let channel = Referred {
        exact: exact(0.1),
        computed: halved(0, 2),
        size: 1.0,
        estimate: 1e-12,
    };
    let errors = reference_errors(&[channel], |halvings| {
        Some(Halved {
            channels: vec![halved(halvings, 2)],
            resolved: false,
        })
    });
    assert_eq!(errors, [1e-12]);
}

#[test]
fn a_limit_that_only_coarse_steps_seem_to_have_is_none() {
    // Up to four halvings the motions tend to another limit, then to the exact one.
    let motion = |halvings: u32| match halvings {
        0..5 => {
            let shifted = halved(halvings, 2).into_iter();
            shifted.map(|x| x + 0.05).collect()
        }
        _ => halved(halvings, 2),
    };
    assert_eq!(error(&exact(0.0), 1e-12, motion).0, 1e-12);
}
