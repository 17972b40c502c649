//! What steps and warnings ask of a law, its stiffness, its energy and the time of an impact, against its own answer.

use super::{collided, follow, is_rigid, made_with, sample};
use slipgap_contact::contact::number::Number;
use slipgap_contact::contact::offer::Offered;
use slipgap_contact::contact::{ContactKind, ContactLaw, LAWS, Pendulum, StoredEnergy};

/// Values that differ where two numbers of a law are of one kind, so that one in the place of the other is seen.
fn distinct(number: &Number) -> f64 {
    match number.key {
        "k_unloading" => 4.0,
        "k2" => 0.7,
        "R" => 3.5,
        _ => sample(number),
    }
}

fn laws() -> impl Iterator<Item = (&'static Offered, ContactLaw)> {
    let made = |law: &'static Offered| Some((law, made_with(law, distinct)?));
    LAWS.iter().filter_map(made)
}

#[test]
fn the_largest_stiffness_is_the_steepest_slope_of_the_force() {
    for (law, made) in laws().filter(|(_, made)| !is_rigid(made)) {
        // So slow that damping gives nothing; out, back and again, each cycle shorter than the one before.
        let slow = 1e-9;
        // Dahl's force tends to its limit as 1/r.
        let reaches = if law.kind == ContactKind::Friction {
            50.0
        } else {
            1.5
        };
        let reach = reaches * made.properties().reach();
        let motion = |t: f64| {
            let phase = slow * t;
            let size = reach * libm::exp(-0.1 * phase);
            [-size * libm::sin(phase), -slow * size * libm::cos(phase)]
        };
        let states = follow(&made, motion, 25.0 / slow, 400_000);
        let mut steepest = 0.0_f64;
        // Damping that is scaled by the closing speed does not vanish with it: there the spring alone is asked.
        let is_scaled = matches!(
            made,
            ContactLaw::HertzDamp(_)
                | ContactLaw::HuntCrossley(_)
                | ContactLaw::Jankowski(_)
                | ContactLaw::Ye(_)
        );
        let spring = |r: f64, s: f64| match is_scaled {
            true => made.conservative_force(r, s),
            false => s,
        };
        for pair in states.windows(2) {
            let [[r, _, s], [next, _, after]] = [pair[0], pair[1]];
            // A step of round-off size has no slope.
            if (next - r).abs() > 1e-7 * reach {
                let change = spring(next, after) - spring(r, s);
                steepest = steepest.max((change / (next - r)).abs());
            }
        }
        let overlap = states
            .iter()
            .fold(0.0, |most: f64, state| most.max(-state[0]));
        let stated = made.properties().largest_stiffness(overlap);
        // A force of velocity alone follows no displacement.
        if made.of_velocity() {
            assert_eq!(stated, 0.0, "{made:?}");
            continue;
        }
        // Chords of a curve are less steep than its tangent, by the step over the reach.
        let is_lugre = matches!(made, ContactLaw::Lugre(_));
        let is_pendulum = matches!(made, ContactLaw::Pendulum(_));
        let least = match (is_lugre, is_pendulum) {
            // A bound: a bristle that is bent to the static limit and turns back fast.
            (true, _) => 0.6,
            // A bound: friction of a fast slip, 1/0.75 times that of a slow one.
            (false, true) => 0.75,
            (false, false) => 0.99,
        };
        let shares = least * stated..stated * (1.0 + 1e-6);
        assert!(
            shares.contains(&steepest),
            "{made:?}: {steepest} of {stated}"
        );
    }
}

/// The pendulum with a constant coefficient.
fn constant(law: Pendulum) -> Pendulum {
    Pendulum {
        rising: [1.0, 0.0],
        ..law
    }
}

#[test]
fn what_an_elastic_contact_took_it_stores() {
    for (_, made) in laws().filter(|(law, _)| law.kind != ContactKind::Impact) {
        // The energy of LuGre's bristle does not follow from r and S; it counts as dissipated.
        if made.of_velocity() || matches!(made, ContactLaw::Lugre(_)) {
            continue;
        }
        // Nor does that of a pendulum whose coefficient rises with velocity.
        let mut made = made;
        if let ContactLaw::Pendulum(law) = made {
            made = ContactLaw::Pendulum(constant(law));
        }
        // Far below what yields or slips: hysteresis takes a part of the order of r over the reach.
        let small = 1e-6 * made.properties().reach();
        let states = follow(&made, |t: f64| [small * t, 1e-12], 1.0, 1000);
        let (mut work, mut before) = (0.0, [0.0; 2]);
        for [r, _, s] in states {
            work += 0.5 * (before[1] + s) * (r - before[0]);
            before = [r, s];
        }
        let [r, s] = before;
        let stored = made.stored_energy(r, s);
        assert!(
            (stored - work).abs() <= 1e-5 * work,
            "{made:?} {stored} {work}"
        );
    }
}

#[test]
fn a_pendulum_dissipates_by_its_slip_and_stores_the_rest() {
    let pendulum = laws().find(|(law, _)| law.offer.name == "pendulum");
    let (_, made) = pendulum.expect("a law of this name");
    let ContactLaw::Pendulum(law) = made else {
        panic!("{made:?}");
    };
    let made = ContactLaw::Pendulum(constant(law));
    // S = F + (N/R) r with nu N = 2, R = 3.5 and nu = 2, so N = 1.
    let (limit, k, surface) = (2.0, 1.0 / law.compliance, 1.0 / 3.5);
    for a in [0.5, 3.0, 20.0] {
        let states = follow(&made, |t: f64| [a * t, a], 1.0, 100_000);
        let (mut work, mut before) = (0.0, [0.0; 2]);
        for [r, _, s] in states {
            work += 0.5 * (before[1] + s) * (r - before[0]);
            before = [r, s];
        }
        let friction = f64::min(k * a, limit);
        let stored = 0.5 * friction * friction / k + 0.5 * surface * a * a;
        let slip = (a - limit / k).max(0.0);
        // Trapezoids of straight pieces, one of which has the corner; sums of round-off.
        let near = |x: f64, y: f64| (x - y).abs() < 1e-9 * (1.0 + y);
        assert!(
            near(made.stored_energy(before[0], before[1]), stored),
            "{a}"
        );
        assert!(near(work, stored + limit * slip), "{a} {work}");
    }
}

#[test]
fn no_impact_is_shorter_than_its_touching_time() {
    for (law, made) in laws().filter(|(law, _)| law.kind == ContactKind::Impact) {
        if is_rigid(&made) {
            continue;
        }
        for mass in [0.3, 2.0] {
            for speed in [1e-6, 0.1, 3.0] {
                let collision = collided(&made, mass, speed);
                let overlap = Some(collision.overlap);
                let time = made.properties().touching_time(1.0 / mass, overlap);
                let stated = time.unwrap_or_else(|| panic!("{}", law.offer.name));
                let share = stated / collision.duration;
                // The closed forms of damped impacts are integrals with this tolerance.
                // Damping of the approach alone makes it shorter for the same overlap; the return, half of the time, stays.
                let is_jankowski = matches!(made, ContactLaw::Jankowski(_));
                let most = if is_jankowski { 2.0 } else { 1.0 };
                assert!(
                    share < most * (1.0 + 1e-7),
                    "{made:?} {mass} {speed} {share}"
                );
                // Slow impacts do not yield. Unloading with k_u = 2.7 k, or damping, make them longer.
                assert!(speed > 1e-6 || share > 0.7, "{made:?} {mass} {share}");
            }
        }
    }
}
