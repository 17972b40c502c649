//! Laws of parts of bridges and buildings: loops in closed form, the equation of a step, the energy of a motion, and other programs.

use serde_json::Value;
use slipgap_contact::contact::offer::{Form, Place};
use slipgap_contact::contact::{
    AnyRunningLaw, ContactLaw, ContactResponse, Flexibility, GivenNumbers, StepFlexibility,
    StoredEnergy, Trial, offer::Offered,
};
use slipgap_contact::lane::Lane;
use slipgap_motion::solve::structure::{Books, Prepared, run};
use slipgap_system::methods::{AverageAcceleration, Bathe, Coefficients, Method};
use slipgap_system::system::structure::{
    Contact, Direction, Limit, Node, Structure, StructureLaw, Symmetric,
};

/// The law of a study's numbers, as a law of structures and alone.
fn made(name: &str, numbers: &Value) -> (StructureLaw, ContactLaw) {
    let offered = Offered::named(Place::Structure, name).expect(name);
    let own = offered.offer.structure.expect(name);
    let table = &numbers["table"];
    let list = |key: &str| -> Vec<f64> {
        let values = table[key].as_array().expect(key).iter();
        values.map(|x| x.as_f64().expect(key)).collect()
    };
    let points: Vec<[f64; 2]> = match table.is_null() {
        true => Vec::new(),
        false => {
            let (r, s) = (list("r"), list("S"));
            r.into_iter().zip(s).map(|(r, s)| [r, s]).collect()
        }
    };
    let value = |key: &str| numbers[key].as_f64();
    let values: Vec<Option<f64>> = own.numbers.iter().map(|own| value(own.key)).collect();
    let limit = value("nu").zip(value("N")).map_or(0.0, |(nu, n)| nu * n);
    let mut others = vec![("limit", limit)];
    others.extend(value("nu").map(|nu| ("nu", nu)));
    let given = GivenNumbers {
        law: offered.offer.name,
        numbers: own.numbers,
        values: &values,
        table: &points,
        others: &others,
    };
    let form: Form = (offered.offer.form)(&given).unwrap_or_else(|why| panic!("{name}: {why}"));
    let relation = StructureLaw::new(form, Limit::constant(limit));
    let law = relation.law(limit);
    (relation, law)
}

fn law(name: &str, numbers: &str) -> ContactLaw {
    made(name, &serde_json::from_str(numbers).expect(numbers)).1
}

/// Every law of a part, with names and numbers; r of about 3 shows all of it.
const ALL: [(&str, &str); 17] = [
    ("bilinear", r#"{"k1": 2.5, "Fy": 3, "ratio": 0.1}"#),
    ("bilinear", r#"{"k1": 2.5, "Fy": 3, "k2": 0}"#),
    ("gap-yield", r#"{"k": 2.5, "Fy": 3, "hardening": 0.1}"#),
    (
        "gap-yield",
        r#"{"k": 2.5, "Fy": 3, "damage": 0, "hardening": 0}"#,
    ),
    (
        "restrainer",
        r#"{"slack": 0.4, "k": 2.5, "Fy": 3, "hardening": 0.1}"#,
    ),
    ("viscous", r#"{"c": 0.7, "a": 0.1}"#),
    ("viscous", r#"{"c": 0.7, "a": 0.5}"#),
    ("viscous", r#"{"c": 0.7, "a": 2}"#),
    (
        "multilinear",
        r#"{"table": {"r": [0.5, 1.5, 4], "S": [1, 2, 2.5]}}"#,
    ),
    (
        "multilinear",
        r#"{"table": {"r": [-3, -1, -0.5, 0.75, 2], "S": [-1.5, -1.5, -1, 1.5, 2]}}"#,
    ),
    (
        "hyperbolic-gap",
        r#"{"k": 2.5, "Fult": 5, "Rf": 0.7, "k_unloading": 4}"#,
    ),
    ("pendulum", r#"{"nu": 0.1, "N": 8, "R": 2, "k": 20}"#),
    ("impact-yield", r#"{"k1": 2.5, "k2": 0.8, "delta_y": 0.5}"#),
    ("bilinear", r#"{"k1": 2.5, "Fy": 3, "ratio": -0.1}"#),
    (
        "imk-bilinear",
        r#"{"k": 2.5, "Fy": 3, "Up": 1, "Upc": 30, "Fcap_ratio": 1.1, "Fres_ratio": 0.2, "lambda_S": 200, "lambda_C": 300, "lambda_K": 400}"#,
    ),
    (
        "imk-peak-oriented",
        r#"{"k": 2.5, "Fy": 3, "Up": 1, "Upc": 30, "Fcap_ratio": 1.1, "Fres_ratio": 0.2, "lambda_S": 200, "lambda_K": 400}"#,
    ),
    (
        "imk-pinching",
        r#"{"k": 2.5, "Fy": 3, "Up": 1, "Upc": 30, "Fcap_ratio": 1.1, "Fres_ratio": 0.2, "lambda_A": 300, "lambda_C": 300,
            "kappa_F": 0.4, "kappa_D": 0.3}"#,
    ),
];

fn all() -> impl Iterator<Item = ContactLaw> {
    ALL.into_iter().map(|(name, numbers)| law(name, numbers))
}

fn on(h: f64, h_rate: f64) -> StepFlexibility<1> {
    let flexibility = |h: f64, h_rate: f64| Flexibility {
        h: Lane([h]),
        h_rate: Lane([h_rate]),
    };
    StepFlexibility {
        start: flexibility(0.0, 0.0),
        end: flexibility(h, h_rate),
        dt: Lane([1.0]),
        by_impulse: false,
    }
}

/// A law along a motion: r, rdot and S at the last step.
struct Path {
    running: AnyRunningLaw<1>,
    state: [f64; 3],
}

impl Path {
    /// From r on, with the force of a first loading.
    fn new(law: &ContactLaw, r: f64, on: StepFlexibility<1>) -> Path {
        let running = ContactLaw::running(&[*law], &[on; 2]);
        let mut path = Path {
            running,
            state: [r, 0.0, 0.0],
        };
        let mut first = path.running;
        let s = Path::answer(&mut first, path.state, [0.0, 0.0]);
        path.state[2] = s;
        path
    }

    fn answer(law: &mut AnyRunningLaw<1>, [r, rdot, s]: [f64; 3], [change, rate]: [f64; 2]) -> f64 {
        let trial = Trial {
            displacement: Lane([r]),
            velocity: Lane([rdot]),
            force: Lane([s]),
            change: Lane([change]),
            rate: Lane([rate]),
        };
        let Lane([force]) = law.force(0, &trial);
        force
    }

    /// S at the end of a step to r.
    fn to(&mut self, r: f64) -> f64 {
        let change = r - self.state[0];
        let s = Path::answer(&mut self.running, self.state, [change, 0.0]);
        self.state = [r, 0.0, s];
        s
    }

    /// The work along straight lines through these points, in steps; the last S. The work is exact where S is straight in a step.
    fn along(&mut self, points: &[f64], steps: u32) -> [f64; 2] {
        let mut work = 0.0;
        for point in points {
            let from = self.state[0];
            for k in 1..=steps {
                let [r, _, s] = self.state;
                let next = from + (point - from) * f64::from(k) / f64::from(steps);
                work += 0.5 * (self.to(next) + s) * (next - r);
            }
        }
        [work, self.state[2]]
    }
}

/// Whether two numbers agree to 1e-12 of 1.
fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-12 * (1.0 + b.abs())
}

#[test]
fn a_bilinear_loop_has_its_corners_and_its_area() {
    for k2 in [0.0, 0.25, 1.0, -0.5] {
        let (k1, fy, a) = (2.5, 3.0, 2.0);
        let law = law(
            "bilinear",
            &format!(r#"{{"k1": {k1}, "Fy": {fy}, "k2": {k2}}}"#),
        );
        let mut path = Path::new(&law, 0.0, on(0.0, 0.0));
        let uy = fy / k1;
        assert!(near(path.to(uy), fy));
        let top = fy + k2 * (a - uy);
        assert!(near(path.to(a), top));
        // It yields backwards after 2 Fy/k1, however large k2 is.
        assert!(near(path.to(a - 2.0 * uy), top - 2.0 * fy));
        assert!(near(path.to(-a), -top));
        assert!(near(path.to(-a + 2.0 * uy), 2.0 * fy - top));
        assert!(near(path.to(a), top));
        // A closed loop: the corners are ends of steps.
        let [area, _] = path.along(&[a - 2.0 * uy, -a, 2.0 * uy - a, a], 16);
        assert!(near(area, 4.0 * (k1 - k2) * uy * (a - uy)), "{k2} {area}");
        // Released from a stretch at rest.
        let start = Path::new(&law, a, on(0.0, 0.0));
        assert!(near(start.state[2], top));
    }
}

#[test]
fn a_gap_that_yields_opens_or_closes_again() {
    let (k, fy, eta, a) = (2.5, 3.0, 0.1, 2.0);
    for damage in [1, 0] {
        let text = format!(r#"{{"k": {k}, "Fy": {fy}, "hardening": {eta}, "damage": {damage}}}"#);
        let law = law("gap-yield", &text);
        let mut path = Path::new(&law, 0.5, on(0.0, 0.0));
        assert_eq!([path.to(0.1), path.to(0.0)], [0.0; 2]);
        let b = a - fy / k;
        let most = fy + eta * k * b;
        let [work, _] = path.along(&[-fy / k, -a, most / k - a], 8);
        let lost = fy * b + 0.5 * eta * k * b * b + 0.5 * (fy * fy - most * most) / k;
        assert!(near(work, lost), "{work} {lost}");
        assert!(path.to(most / k - a).abs() < 1e-12);
        // Half of the way back to the old gap.
        let half = 0.5 * (most / k - a);
        assert_eq!(path.to(half), 0.0);
        // Pushed again by 0.1 of it: with damage the contact is still open.
        let again = path.to(1.1 * half);
        let expected = match damage {
            1 => 0.0,
            _ => -k * 0.1 * half.abs(),
        };
        assert!(near(again, expected), "{again} {expected}");
        // The yield line is where it was, in either case.
        assert!(near(
            path.to(-2.0 * a),
            -(fy + eta * k * (2.0 * a - fy / k))
        ));
    }
}

#[test]
fn a_restrainer_pulls_beyond_its_slack_and_becomes_longer() {
    let (slack, k, fy) = (0.4, 2.5, 3.0);
    let law = law(
        "restrainer",
        &format!(r#"{{"slack": {slack}, "k": {k}, "Fy": {fy}}}"#),
    );
    let mut path = Path::new(&law, 0.0, on(0.0, 0.0));
    assert_eq!([path.to(-5.0), path.to(0.4)], [0.0; 2]);
    assert!(near(path.to(1.0), 1.5));
    let longest = slack + fy / k + 0.7;
    path.to(slack);
    let [work, _] = path.along(&[slack + fy / k, longest, slack + 0.7], 8);
    assert!(near(work, fy * 0.7), "{work}");
    assert!(path.to(slack + 0.7).abs() < 1e-12);
    assert_eq!(path.to(0.0), 0.0);
    assert_eq!(path.to(slack + 0.69), 0.0);
    assert!(near(path.to(slack + 0.9), 0.2 * k));
}

#[test]
fn a_multilinear_loop_follows_masing() {
    let table = r#"{"table": {"r": [0.5, 1.5, 4], "S": [1, 2, 2.5]}}"#;
    let law = law("multilinear", table);
    // The table and its last line.
    let first = |r: f64| match r {
        _ if r < 0.5 => 2.0 * r,
        _ if r < 1.5 => 1.0 + (r - 0.5),
        _ => 2.0 + 0.2 * (r - 1.5),
    };
    let mut path = Path::new(&law, 0.0, on(0.0, 0.0));
    for r in [0.3, 0.5, 1.1, 1.5, 3.0, 5.0] {
        assert!(near(path.to(r), first(r)));
    }
    let (a, top) = (5.0, first(5.0));
    for r in [4.5, 3.9, 2.0, 1.0, -4.0, -5.0] {
        assert!(near(path.to(r), top - 2.0 * first(0.5 * (a - r))), "{r}");
    }
    // A small loop closes, and the large one goes on.
    path.to(1.0);
    let here = path.to(2.0);
    assert!(near(here, -top + 2.0 * first(3.5)));
    for r in [1.5, 1.2, 1.6, 2.0] {
        let back = path.to(r);
        assert!(r != 2.0 || near(back, here), "{back} {here}");
    }
    assert!(near(path.to(3.0), -top + 2.0 * first(4.0)));
    // The area of Masing's loop is 8 times that between the first loading and its chord.
    path.to(5.0);
    path.to(-5.0);
    let [area, _] = path.along(&[-4.0, -2.0, 5.0, 4.0, 2.0, -5.0], 8);
    let below = 0.25 + 1.5 + 0.5 * (2.0 + top) * 3.5;
    assert!(near(area, 8.0 * (below - 0.5 * a * top)), "{area}");
}

#[test]
fn a_multilinear_table_may_differ_on_both_sides() {
    let (name, numbers) = ALL[9];
    let law = law(name, numbers);
    let mut path = Path::new(&law, 0.0, on(0.0, 0.0));
    for (r, s) in [(0.75, 1.5), (1.375, 1.75), (2.0, 2.0), (3.0, 2.4)] {
        assert!(near(path.to(r), s), "{r}");
    }
    let mut path = Path::new(&law, 0.0, on(0.0, 0.0));
    for (r, s) in [
        (-0.25, -0.5),
        (-0.5, -1.0),
        (-0.75, -1.25),
        (-1.0, -1.5),
        (-9.0, -1.5),
    ] {
        assert!(near(path.to(r), s), "{r}");
    }
    // From below the first part has the way 0.75 + 0.5 to its other bend.
    assert!(near(path.to(-9.0 + 1.25), -1.5 + 2.5));
    let closed = path.along(&[0.0, -9.0, 0.0, 3.0, -9.0], 1000)[0];
    assert!(closed > 0.0);
}

#[test]
fn tables_that_do_not_yield_are_refused() {
    let refused = |points: &[[f64; 2]], part: &str| {
        let why = slipgap_contact::contact::Multilinear::new(points).expect_err(part);
        assert!(why.to_string().contains(part), "{why}");
    };
    refused(&[], "r > 0");
    refused(&[[-1.0, -1.0]], "r > 0");
    refused(&[[1.0, 1.0], [1.0, 2.0]], "r must rise");
    refused(&[[0.0, 1.0], [1.0, 2.0]], "0 at r = 0");
    refused(&[[1.0, 1.0], [2.0, 3.0]], "slope");
    refused(&[[1.0, 1.0], [2.0, 0.5]], "must rise");
    refused(&[[1.0, -1.0]], "must rise");
    refused(&[[-1.0, -2.0], [1.0, 1.0]], "same");
    let many = |n: usize| -> Vec<[f64; 2]> {
        (1..=n)
            .map(|i| [i as f64, (2.0 * n as f64 - i as f64) * i as f64])
            .collect()
    };
    assert!(slipgap_contact::contact::Multilinear::new(&many(7)).is_ok());
    refused(&many(8), "more than 6");
    // Points on a line have no bend; a point at 0 is one of the table.
    let line: Vec<[f64; 2]> = (0..9)
        .map(|i| [f64::from(i) * 0.1, f64::from(i) * 0.3])
        .collect();
    let straight = slipgap_contact::contact::Multilinear::new(&line).expect("a line");
    assert_eq!(straight.parts, [0.0; 6]);
}

#[test]
fn backfill_follows_its_hyperbola_and_takes_energy() {
    let (k, ult, rf, ku, a) = (2.5, 5.0, 0.7, 4.0, 2.0);
    let law = law(ALL[10].0, ALL[10].1);
    let mut path = Path::new(&law, 0.5, on(0.0, 0.0));
    assert_eq!(path.to(0.0), 0.0);
    let first = |d: f64| d / (1.0 / k + rf * d / ult);
    for d in [0.2, 1.0, a] {
        assert!(near(path.to(-d), -first(d)));
    }
    let left = a - first(a) / ku;
    assert!(near(path.to(-a + 0.1), -first(a) + 0.1 * ku));
    assert!(path.to(-left).abs() < 1e-12);
    assert_eq!([path.to(0.3), path.to(0.01 - left)], [0.0; 2]);
    assert!(near(path.to(-a), -first(a)));
    assert!(near(path.to(-3.0), -first(3.0)));
    // The work of a first loading, by trapezoids with Richardson's extrapolation.
    let work = |steps: u32| Path::new(&law, 0.0, on(0.0, 0.0)).along(&[-a, -left], steps)[0];
    let fine = (4.0 * work(4096) - work(2048)) / 3.0;
    let (ca, cb) = (1.0 / k, rf / ult);
    let expected =
        a / cb - ca / (cb * cb) * (1.0 + a * cb / ca).ln() - 0.5 * first(a) * first(a) / ku;
    assert!((fine - expected).abs() < 1e-11, "{fine} {expected}");
}

#[test]
fn a_pendulum_slides_on_its_surface_and_follows_n() {
    let (nu, n, radius, k) = (0.1, 8.0, 2.0, 20.0);
    let pendulum = law(ALL[11].0, ALL[11].1);
    let mut path = Path::new(&pendulum, 0.0, on(0.0, 0.0));
    let a = 1.5;
    let re = nu * n / k;
    assert!(near(path.to(re), nu * n + n / radius * re));
    assert!(near(path.to(a), nu * n + n / radius * a));
    assert!(near(path.to(-a), -nu * n - n / radius * a));
    path.to(a);
    let [area, _] = path.along(&[a - 2.0 * re, -a, 2.0 * re - a, a], 16);
    assert!(near(area, 4.0 * nu * n * (a - re)), "{area}");
    // Half of N: both parts.
    let half = pendulum.at_limit(0.5 * nu * n);
    path.running.change(&half, &[on(0.0, 0.0); 2]);
    assert!(near(path.to(a), 0.5 * (nu * n + n / radius * a)));
    let open = pendulum.at_limit(0.0);
    path.running.change(&open, &[on(0.0, 0.0); 2]);
    assert_eq!(path.to(0.7 * a), 0.0);
    // The coefficient falls with N to the power 0.2: the surface follows N, not the limit.
    let offered = Offered::named(Place::Structure, "pendulum").expect("pendulum");
    let numbers = offered.offer.structure.expect("pendulum").numbers;
    let values = [Some(k), None, Some(radius)];
    let given = GivenNumbers {
        law: "pendulum",
        numbers,
        values: &values,
        table: &[],
        others: &[("limit", nu * n), ("nu", nu), ("pressure_exponent", 0.2)],
    };
    let form = (offered.offer.form)(&given).expect("a pendulum");
    let other = StructureLaw::new(form, Limit::constant(nu * n)).law(nu * n * 3.0_f64.powf(0.8));
    let mut path = Path::new(&other, 0.0, on(0.0, 0.0));
    let expected = nu * n * 3.0_f64.powf(0.8) + 3.0 * n / radius * a;
    assert!(near(path.to(a), expected));
}

#[test]
fn an_impact_that_yields_takes_its_parallelogram_and_returns() {
    let (k1, k2, dy, a) = (2.5, 0.8, 0.5, 2.0);
    let law = law(ALL[12].0, ALL[12].1);
    let mut path = Path::new(&law, 0.5, on(0.0, 0.0));
    for _ in 0..2 {
        path.to(0.0);
        let [work, s] = path.along(&[-dy, -a, dy - a, 0.0], 8);
        assert!(near(work, (k1 - k2) * dy * (a - dy)), "{work}");
        assert_eq!(s, 0.0);
    }
    // The authors' design: an impact up to d_m takes Delta E.
    let (kh, dm, e, part) = (300.0_f64, 0.04_f64, 0.6_f64, 0.1);
    let lost = kh * dm.powf(2.5) * (1.0 - e * e) / 2.5;
    let keff = kh * dm.sqrt();
    let k1 = keff + lost / (part * dm * dm);
    let k2 = keff - lost / ((1.0 - part) * dm * dm);
    let numbers = format!(r#"{{"k1": {k1}, "k2": {k2}, "delta_y": {}}}"#, part * dm);
    let designed = self::law("impact-yield", &numbers);
    let mut path = Path::new(&designed, 0.0, on(0.0, 0.0));
    let [work, _] = path.along(&[-part * dm, -dm, (part - 1.0) * dm, 0.0], 8);
    assert!((work / lost - 1.0).abs() < 1e-12, "{work} {lost}");
}

#[test]
fn a_damper_takes_the_energy_of_its_power() {
    for (a, steps) in [
        (0.1, 200_000),
        (0.5, 20_000),
        (1.0, 2000),
        (1.7, 2000),
        (2.0, 2000),
    ] {
        let law = law("viscous", &format!(r#"{{"c": 0.7, "a": {a}}}"#));
        let (x, omega) = (0.6, 3.0);
        let mut running = ContactLaw::running(&[law], &[on(0.0, 0.0); 2]);
        // The integral of S rdot over a period, by the midpoint rule, which is exact for smooth functions of a period.
        let mut work = 0.0;
        for i in 0..steps {
            let t = std::f64::consts::TAU * (f64::from(i) + 0.5) / f64::from(steps);
            let rdot = x * omega * libm::cos(t);
            let s = Path::answer(&mut running, [0.0; 3], [0.0, rdot]);
            work += s * rdot * std::f64::consts::TAU / (omega * f64::from(steps));
        }
        let shape = libm::tgamma(1.0 + 0.5 * a);
        let expected = 4.0 * libm::pow(2.0, a) * shape * shape / libm::tgamma(2.0 + a)
            * (0.7 * libm::pow(x, 1.0 + a) * libm::pow(omega, a));
        // |cos|^(1 + a) has a kink, of which the rule has an error of the order steps^-(2 + a).
        assert!(
            (work / expected - 1.0).abs() < 1e-9,
            "{a} {work} {expected}"
        );
    }
}

/// A fixed series of numbers from -1 to 1.
fn noise(seed: u64) -> impl Iterator<Item = f64> {
    let mut state = seed;
    std::iter::repeat_with(move || {
        state = state
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (state >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    })
}

#[test]
fn the_answer_of_a_step_is_the_root_of_its_equation() {
    for law in all() {
        for (which, h) in [1e-3, 0.3, 20.0].into_iter().enumerate() {
            // As of average acceleration with dt = 0.01.
            let h_rate = 200.0 * h;
            if !law.properties().has_one_root(&on(h, h_rate)) {
                assert!(law.properties().falls() && h == 20.0, "{law:?}");
                continue;
            }
            let mut path = Path::new(&law, 0.1, on(h, h_rate));
            let mut numbers = noise(7 + which as u64);
            let mut largest = 0.0_f64;
            for step in 0..3000 {
                let [r, rdot, s] = path.state;
                let target = 3.0 * numbers.next().unwrap_or(0.0);
                // The step leads to about the target, whatever the force.
                let change = target - r + h * s;
                let rate = 200.0 * change - rdot;
                let mut alone = path.running;
                let force = Path::answer(&mut path.running, path.state, [change, rate]);
                // The law itself at the end that this force leaves.
                alone.change(&law, &[on(0.0, 0.0); 2]);
                let end = [change - h * force, rate - h_rate * force];
                let own = Path::answer(&mut alone, path.state, end);
                // Round-off of the end through the slope of the law, and of a vertical law through that of its inverse.
                let sizes = r.abs() + change.abs() + h * force.abs();
                let size = match law.of_velocity() {
                    true => {
                        let exact = (force.abs() / 0.7).powf(1.0 / law.properties().shown()[1].1);
                        let rates = rate.abs() + rdot.abs() + h_rate * force.abs();
                        assert!(
                            (exact - end[1].abs()).abs() < 1e-14 * rates,
                            "{law:?} {step}"
                        );
                        f64::INFINITY
                    }
                    false => 30.0 * sizes + force.abs(),
                };
                assert!(
                    (own - force).abs() <= 4e-15 * size,
                    "{law:?} {h} {step} {own} {force}"
                );
                largest = largest.max(force.abs());
                path.state = [r + end[0], end[1], force];
            }
            assert!(largest > 0.0, "{law:?}");
        }
    }
}

#[test]
fn no_part_gives_energy_in_any_motion() {
    for law in all() {
        if law.of_velocity() {
            continue;
        }
        let mut path = Path::new(&law, 0.0, on(0.0, 0.0));
        let (mut work, mut least) = (0.0, 0.0_f64);
        for point in noise(3).take(400) {
            work += path.along(&[3.0 * point], 200)[0];
            let [r, _, s] = path.state;
            least = least.min(work - law.stored_energy(r, s));
        }
        // Trapezoids across corners within steps: some 1e-4 each.
        assert!(least > -2e-3 && work > 1.0, "{law:?} {least} {work}");
    }
}

/// A mass on a weak spring, pushed to and fro, with the law against the ground, and a second mass that makes the contacts depend
/// on each other.
fn masses(first: &StructureLaw, second: &StructureLaw) -> Structure {
    let node = |name: &str, mass: f64| Node {
        name: name.into(),
        mass,
        direction: Direction::X,
    };
    let mut stiffness = Symmetric::zeros(2);
    stiffness.add(0, 0, 3.0);
    stiffness.add_spring([Some(0), Some(1)], 1.0);
    let contact = |name: &str, along: &[(usize, f64)], gap: f64, law: &StructureLaw| Contact {
        name: name.into(),
        along: along.to_vec(),
        gap,
        law: law.clone(),
    };
    let mut structure = Structure::new(vec![node("one", 1.0), node("two", 0.7)]);
    structure.stiffness = stiffness;
    structure.contacts = vec![
        contact("first", &[(0, 1.0)], 0.1, first),
        contact("second", &[(0, -1.0), (1, 1.0)], 0.2, second),
    ];
    structure.displacement = vec![0.5, 0.0];
    structure.velocity = vec![6.0, -3.0];
    structure
}

/// r and S of both contacts at the steps, and the energy error.
fn motion(structure: &Structure, method: &Method, dt: f64, steps: usize) -> (Vec<[f64; 4]>, f64) {
    let prepared = Prepared::by(method, structure, dt).expect("a method for it");
    let mut books: Option<Books<1>> = None;
    let mut rows = Vec::new();
    let [done] = run::<1>(&[structure], &prepared, steps, |_, state| {
        let contacts = [0, 1].map(|c| {
            let now = state.contact(c.min(state.contacts() - 1));
            [now.displacement, now.force].map(|x| x.0[0])
        });
        rows.push([
            contacts[0][0],
            contacts[0][1],
            contacts[1][0],
            contacts[1][1],
        ]);
        match &mut books {
            Some(books) => books.add(state),
            None => books = Some(Books::new(state)),
        }
    });
    done.expect("forces");
    (rows, books.expect("a step").energy_error().0[0])
}

#[test]
fn energy_is_kept_to_round_off_and_methods_tend_to_one_motion() {
    let relations: Vec<StructureLaw> = ALL
        .iter()
        .map(|(name, numbers)| made(name, &serde_json::from_str(numbers).expect(numbers)).0)
        .collect();
    for (i, first) in relations.iter().enumerate() {
        let structure = masses(first, &relations[(i + 4) % relations.len()]);
        let average = Method::AverageAcceleration(AverageAcceleration);
        let (fine, error) = motion(&structure, &average, 1e-4, 20_000);
        assert!(error < 1e-12, "{first:?} {error}");
        let others = [
            Method::AverageAcceleration(AverageAcceleration),
            Method::Family(Coefficients::hht(-0.1)),
            Method::Bathe(Bathe),
        ];
        for method in others {
            let (rows, error) = motion(&structure, &method, 1e-3, 2000);
            assert!(error < 1e-12, "{first:?} {method:?} {error}");
            let largest = fine
                .iter()
                .fold(0.0_f64, |most, row| most.max(row[0].abs()));
            for (i, row) in rows.iter().enumerate() {
                let distance = (row[0] - fine[10 * i][0])
                    .abs()
                    .max((row[2] - fine[10 * i][2]).abs());
                // Corners within steps are met to the second order, steep dampers near rdot = 0 to the first.
                assert!(
                    distance < 5e-3 * largest,
                    "{first:?} {method:?} {i} {distance}"
                );
            }
        }
    }
}

#[test]
fn collisions_are_those_of_the_independent_program() {
    let text = include_str!("../../../tests/data/parts.json");
    let rows: Vec<Value> = serde_json::from_str(text).expect("data");
    assert_eq!(rows.len(), 14);
    for row in rows {
        let number = |key: &str| row[key].as_f64().expect("a number");
        let (_, law) = made(row["law"].as_str().expect("a law"), &row["numbers"]);
        let found = law
            .collision(number("m"), number("v0"))
            .expect("a closed form");
        for (key, value) in [
            ("restitution", found.restitution),
            ("duration", found.duration()),
            ("overlap", found.overlap),
        ] {
            // Of the program: that of its two tolerances at most.
            let error = (value / number(key) - 1.0).abs();
            assert!(
                error < number("difference") + 1e-13,
                "{row} {key} {value} {error}"
            );
        }
    }
}

#[test]
fn forces_are_those_of_the_materials_of_opensees() {
    let text = include_str!("../../../tests/data/parts_opensees.json");
    let data: Value = serde_json::from_str(text).expect("data");
    let rows = data["materials"].as_array().expect("rows");
    assert_eq!(rows.len(), 10);
    let list = |row: &Value| -> Vec<f64> {
        let numbers = row.as_array().expect("a list").iter();
        numbers.map(|x| x.as_f64().expect("a number")).collect()
    };
    for row in rows {
        let (_, law) = made(row["law"].as_str().expect("a law"), &row["numbers"]);
        let gap = row["gap"].as_f64().expect("a gap");
        let mut path = Path::new(&law, gap, on(0.0, 0.0));
        let forces = list(&row["S"]);
        let largest = forces.iter().fold(0.0_f64, |most, s| most.max(s.abs()));
        assert!(largest > 2.0);
        for (x, expected) in list(&row["x"]).into_iter().zip(forces) {
            let s = path.to(x + gap);
            // Points at the end of a gap are 1e-13 inside it.
            assert!(
                (s - expected).abs() < 1e-12 * largest,
                "{} {x} {s} {expected}",
                row["material"]
            );
        }
    }
    for row in data["dampers"].as_array().expect("rows") {
        let number = |key: &str| row[key].as_f64().expect("a number");
        let (damper, _) = made("viscous", row);
        let mut structure = masses(&damper, &damper);
        structure.nodes.truncate(1);
        structure.contacts.truncate(1);
        structure.nodes[0].mass = number("mass");
        structure.coupled_mass = Symmetric::zeros(1);
        structure.damping = Symmetric::zeros(1);
        structure.stiffness = Symmetric::zeros(1);
        structure.stiffness.add(0, 0, number("k"));
        (structure.displacement, structure.velocity) = (vec![0.0], vec![number("v")]);
        structure.contacts[0].gap = 0.0;
        let average = Method::AverageAcceleration(AverageAcceleration);
        let expected = list(&row["u"]);
        let (rows, _) = motion(&structure, &average, number("dt"), expected.len());
        for (row, expected) in rows[1..].iter().zip(expected) {
            assert!((row[0] - expected).abs() < 1e-13, "{row:?} {expected}");
        }
    }
}

#[test]
fn forces_that_degrade_are_those_of_opensees() {
    let text = include_str!("../../../tests/data/imk_opensees.json");
    let rows: Vec<Value> = serde_json::from_str(text).expect("data");
    assert_eq!(rows.len(), 16);
    for row in &rows {
        let (_, law) = made(row["law"].as_str().expect("a law"), &row["numbers"]);
        let list = |key: &str| -> Vec<f64> {
            let numbers = row[key].as_array().expect(key).iter();
            numbers.map(|x| x.as_f64().expect(key)).collect()
        };
        let forces = list("S");
        let largest = forces.iter().fold(0.0_f64, |most, s| most.max(s.abs()));
        assert!(largest > 2.0);
        let mut path = Path::new(&law, 0.0, on(0.0, 0.0));
        for (x, expected) in list("x").into_iter().zip(forces) {
            let s = path.to(x);
            // Round-off of the lines, which degrade by products of factors.
            assert!(
                (s - expected).abs() < 1e-12 * largest,
                "{} {x} {s} {expected}",
                row["numbers"]
            );
        }
    }
}

#[test]
fn every_lane_has_the_bits_that_it_has_alone() {
    for (name, numbers) in ALL {
        let alone = law(name, numbers);
        // Other numbers of the same law beside it.
        let mut others: Value = serde_json::from_str(numbers).expect(numbers);
        for key in ["k", "k1", "c", "Fy", "Fult", "slack"] {
            if let Some(x) = others[key].as_f64() {
                others[key] = (1.1 * x).into();
            }
        }
        if name == "hyperbolic-gap" {
            others["k_unloading"] = 7.into();
        }
        let (_, other) = made(name, &others);
        let three = [Lane([0.2]), Lane([0.3])].map(|Lane([x])| Lane([x; 3]));
        let wide = StepFlexibility {
            start: Flexibility {
                h: Lane([0.0; 3]),
                h_rate: Lane([0.0; 3]),
            },
            end: Flexibility {
                h: three[0],
                h_rate: three[1],
            },
            dt: Lane([1.0; 3]),
            by_impulse: false,
        };
        let mut lanes = ContactLaw::running(&[other, alone, other], &[wide; 2]);
        let mut single = ContactLaw::running(&[alone], &[on(0.2, 0.3); 2]);
        let mut states = [[0.0, 0.0, 0.0]; 3];
        for numbers in noise(11).take(3000).collect::<Vec<f64>>().chunks_exact(3) {
            let mut trial = Trial {
                displacement: Lane([0.0; 3]),
                velocity: Lane([0.0; 3]),
                force: Lane([0.0; 3]),
                change: Lane([0.0; 3]),
                rate: Lane([0.0; 3]),
            };
            for (l, [r, rdot, s]) in states.into_iter().enumerate() {
                trial.displacement.0[l] = r;
                trial.velocity.0[l] = rdot;
                trial.force.0[l] = s;
                trial.change.0[l] = 3.0 * numbers[l] - r + 0.2 * s;
                trial.rate.0[l] = 4.0 * numbers[l];
            }
            let Lane(forces) = lanes.force(0, &trial);
            let own = [trial.change.0[1], trial.rate.0[1]];
            let force = Path::answer(&mut single, states[1], own);
            assert_eq!(force.to_bits(), forces[1].to_bits(), "{alone:?}");
            for (l, state) in states.iter_mut().enumerate() {
                let r = state[0] + trial.change.0[l] - 0.2 * forces[l];
                *state = [r, trial.rate.0[l] - 0.3 * forces[l], forces[l]];
            }
        }
    }
}
