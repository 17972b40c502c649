//! Supports with motions of their own: against the ground with the same motion, and against solutions that come from no method.

mod imposed;
mod moving;

use super::{faults, solved, study};
use slipgap_problem::problem::Solution;

/// The channels of the history of a study.
fn channels(text: &str) -> Vec<Vec<f64>> {
    solved(&study(text)).computed.channels
}

/// A record with a jump at its start and a velocity that does not end at 0.
const SHAKE: &str =
    r#"{"table": {"t": [0, 0.31, 0.8, 1.1, 2.05, 3], "f": [0.6, 4, -7, 5, -2, 1]}, "scale": 1.3}"#;

/// Two blocks with a gap between them, one of them on springs, the other on a bearing, and a bar with stiffness damping.
fn chain(method: &str, laws: [&str; 2], shaken: &str, ends: [&str; 2], y: &str) -> String {
    let [left, right] = ends;
    let [stop, bearing] = laws;
    format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 6, "method": "{method}"}},
            "structure": {{"masses": {{"a": 2, "b": 3, "deck": 4}},
              "bars": {{"bar": {{"L": 3, "EA": 900, "mass": 1.5, "n": 4, "stiffness_damping": 0.002}}}},
              "springs": [{{"between": ["{left}", "a"], "k": 90, "c": 0.8}}, {{"between": ["a", "b"], "k": 40, "c": 0.3}},
                          {{"between": ["{right}", "bar.right"], "k": 300}}],
              "contacts": {{"gap": {{{stop}, "between": ["b", "bar.left"], "gap": 0.02}},
                            "bearing": {{{bearing}, "between": ["{right}", "deck"]}},
                            "other": {{{bearing}, "between": ["{left}", "deck"]}}}},
              {shaken}}},
            "metrics": ["energy_error", "numerical_dissipation", "impacts(gap)"],
            "figures": [{{"name": "h", "kind": "history", "y": {y}}}]}}"#
    )
}

const LAWS: [[&str; 2]; 2] = [
    [
        r#""law": "impact", "k": 4000"#,
        r#""law": "displacement-control", "k": 700, "limit": 6"#,
    ],
    [
        r#""law": "kelvin-voigt", "k": 4000, "restitution": 0.6, "colliding_mass": 1.5"#,
        r#""law": "velocity-control", "limit": 6, "rdotE": 1e-3"#,
    ],
];

#[test]
fn supports_with_one_motion_are_the_ground_with_it() {
    let relative = r#"["a - left", "b - left", "bar.2 - right", "deck - left", "gap.r", "bearing.S", "b.v - left.v"]"#;
    let plain = r#"["a", "b", "bar.2", "deck", "gap.r", "bearing.S", "b.v"]"#;
    for method in ["average-acceleration", "bathe", "hht", "newmark"] {
        for laws in LAWS {
            let ground = format!(r#""ground": {SHAKE}"#);
            let supports = format!(r#""supports": {{"left": {SHAKE}, "right": {SHAKE}}}"#);
            let ground = solved(&study(&chain(method, laws, &ground, ["ground"; 2], plain)));
            let text = chain(method, laws, &supports, ["left", "right"], relative);
            let supports = solved(&study(&text));
            agree(&ground, &supports, 7, 1e-10);
            assert!(ground.metrics[2] > Some(1.0), "{method}");
            // The books close: round-off of 600 steps.
            assert!(
                supports.metrics[0].unwrap() < 1e-11,
                "{method}: {:?}",
                supports.metrics
            );
        }
    }
}

/// The first `count` channels of both agree within a part of their peaks.
fn agree(a: &Solution, b: &Solution, count: usize, part: f64) {
    for k in 0..count {
        let (a, b) = (&a.computed.channels[k], &b.computed.channels[k]);
        let peak = a.iter().fold(0.0, |peak: f64, x| peak.max(x.abs()));
        let differences = a.iter().zip(b).map(|(a, b)| (a - b).abs());
        let difference = differences.fold(0.0, f64::max);
        assert!(
            peak > 0.0 && difference < part * peak,
            "{k}: {difference:e} of {peak}"
        );
    }
}

/// A mass of 2 on springs and dashpots to `left` and `right`.
fn oscillator(dt: f64, springs: &str, supports: &str) -> Solution {
    solved(&study(&format!(
        r#"{{"problem": "structure", "parameters": {{"dt": {dt}, "duration": 3}},
            "structure": {{"masses": {{"m": 2}}, "springs": [{springs}], "supports": {{{supports}}},
                           "contacts_reference": "softened"}},
            "metrics": ["energy_error"],
            "figures": [{{"name": "h", "kind": "history", "y": ["m", "m.v", "left.u", "left.v", "left.a"]}}]}}"#
    )))
}

/// Exact histories equal closed forms at every step, and those by steps come near to them.
fn is(solution: &Solution, closed: impl Fn(f64) -> [f64; 2]) {
    for (i, t) in solution.computed.time.iter().enumerate() {
        let closed = closed(*t);
        for (k, x) in closed.iter().enumerate() {
            let exact = solution.exact.channels[k][i];
            // Round-off of some hundred pieces.
            assert!(
                (exact - x).abs() < 1e-12 * (1.0 + x.abs()),
                "{t}: {k} {exact} {x}"
            );
            // (omega dt)^2/12 of a few periods.
            let steps = solution.computed.channels[k][i];
            assert!(
                (steps - x).abs() < 2e-4 * (1.0 + x.abs()),
                "{t}: {k} {steps} {x}"
            );
        }
    }
}

#[test]
fn a_mass_follows_supports_as_closed_forms_say() {
    // omega_0^2 = 50/2 = 25; a sine 3 sin 2 t under both ends.
    let sine = r#""left": {"sine": {"amplitude": 3, "omega": 2}}, "right": {"sine": {"amplitude": 3, "omega": 2}}"#;
    let springs = r#"{"between": ["left", "m"], "k": 20}, {"between": ["m", "right"], "k": 30}"#;
    let relative = |t: f64, part: f64| {
        let a = -3.0 * part / (25.0 - 4.0);
        [
            a * ((2.0 * t).sin() - 0.4 * (5.0 * t).sin()),
            a * (2.0 * (2.0 * t).cos() - 2.0 * (5.0 * t).cos()),
        ]
    };
    let carried = |t: f64| {
        [
            1.5 * t - 0.75 * (2.0 * t).sin(),
            1.5 - 1.5 * (2.0 * t).cos(),
        ]
    };
    let total = |t: f64, part: f64| {
        let (w, u) = (relative(t, part), carried(t));
        [w[0] + part * u[0], w[1] + part * u[1]]
    };
    is(&oscillator(0.002, springs, sine), |t| total(t, 1.0));
    // Only the left end moves: it carries the mass by 20/50.
    let (left, _) = sine.split_once(", \"right\"").unwrap();
    let one = format!(r#"{left}, "right": {{"y": {{"sine": {{"amplitude": 1, "omega": 1}}}}}}"#);
    is(&oscillator(0.002, springs, &one), |t| total(t, 0.4));
}

#[test]
fn a_table_with_a_delay_and_a_dashpot_is_the_closed_form() {
    // u_s = t^2 from 0.3 on: u = t^2 - 2 c/k t + beta and a decaying vibration, from 2 u'' + c u' + k u = k u_s.
    let (m, c, k) = (2.0, 1.2, 50.0);
    let springs =
        r#"{"between": ["left", "m"], "k": 50}, {"between": ["ground", "m"], "k": 0, "c": 1.2}"#;
    let supports = r#""left": {"table": {"t": [0], "f": [2]}, "delay": 0.3}"#;
    let alpha = -2.0 * c / k;
    let beta = (-2.0 * m - c * alpha) / k;
    let decay = c / (2.0 * m);
    let omega = f64::sqrt(k / m - decay * decay);
    let [a, b] = [-beta, (-alpha - decay * beta) / omega];
    let closed = |t: f64| {
        let t = t - 0.3;
        if t <= 0.0 {
            return [0.0; 2];
        }
        let (sin, cos) = (omega * t).sin_cos();
        let fades = (-decay * t).exp();
        let wave = a * cos + b * sin;
        let slope = omega * (b * cos - a * sin) - decay * wave;
        [
            t * t + alpha * t + beta + fades * wave,
            2.0 * t + alpha + fades * slope,
        ]
    };
    let solution = oscillator(0.002, springs, supports);
    is(&solution, closed);
    // The support itself.
    let ends = solution
        .computed
        .channels
        .iter()
        .map(|x| *x.last().unwrap());
    let last: Vec<f64> = ends.skip(2).take(3).collect();
    for (value, expected) in last.iter().zip([2.7 * 2.7, 5.4, 2.0]) {
        assert!((value - expected).abs() < 1e-14 * 10.0, "{last:?}");
    }
}

#[test]
fn a_delay_of_steps_shifts_the_motion_by_them() {
    let drawn = r#"["a", "b.v", "gap.r", "bearing.S", "left.u"]"#;
    for method in ["average-acceleration", "bathe"] {
        let of = |delay: &str| {
            // The record begins with 0, so that no jump is between two steps of one and at a step of the other.
            let shake =
                format!(r#"{{"table": {{"t": [0, 0.3, 0.8, 3], "f": [0, 4, -7, 1]}}{delay}}}"#);
            let supports = format!(r#""supports": {{"left": {shake}, "right": {shake}}}"#);
            let text = chain(method, LAWS[0], &supports, ["left", "right"], drawn);
            channels(&text)
        };
        let (now, zero, later) = (of(""), of(r#", "delay": 0"#), of(r#", "delay": 0.25"#));
        assert_eq!(now, zero);
        for (now, later) in now.iter().zip(&later).take(5) {
            let rest = later[0];
            assert!(later[..=25].iter().all(|x| *x == rest), "{method}");
            let peak = now.iter().fold(0.0, |peak: f64, x| peak.max(x.abs()));
            for (now, later) in now.iter().zip(&later[25..]) {
                // Round-off of the times.
                assert!(
                    (now - later).abs() < 1e-11 * peak,
                    "{method}: {now} {later}"
                );
            }
        }
    }
}

/// Supports with different motions, with the errors against the exact motion.
fn different(method: &str, laws: [&str; 2], reference: &str, dt: f64) -> Vec<f64> {
    let supports = format!(
        r#""contacts_reference": "{reference}", "supports": {{"left": {SHAKE},
           "right": {{"sine": {{"amplitude": 4, "omega": 3, "phase": 0.4}}, "delay": 0.4}}}}"#
    );
    let chained = chain(method, laws, &supports, ["left", "right"], r#"["gap.r"]"#);
    let errors =
        r#"["rms_error(b)", "rms_error(deck)", "rms_error(gap.r)", "energy_error", "impacts(gap)""#;
    let text = chained
        .replace("[\"energy_error\"", errors)
        .replace(r#""dt": 0.01"#, &format!(r#""dt": {dt}"#))
        .replace(r#""duration": 6"#, r#""duration": 2"#);
    let solution = solved(&study(&text));
    solution.metrics.iter().flatten().copied().collect()
}

#[test]
fn steps_with_different_motions_tend_to_the_exact_motion() {
    let friction = r#""law": "displacement-control", "k": 700, "limit": 6"#;
    let impact = r#""law": "impact", "k": 4000"#;
    for method in ["average-acceleration", "bathe"] {
        let [coarse, fine] =
            [4e-4, 1e-4].map(|dt| different(method, [impact, friction], "softened", dt));
        assert!(coarse[4] >= 1.0, "{coarse:?}");
        for k in 0..3 {
            // The order is 2, a ratio of 16; slip that begins within a step leaves a small part of order 1, a ratio of 4.
            assert!(
                fine[k] < 1e-6 && fine[k] < coarse[k] / 3.0,
                "{method}: {coarse:?} {fine:?}"
            );
        }
        // The books close: round-off of 20 000 steps.
        assert!(fine[3] < 1e-10, "{method}: {fine:?}");
    }
    // Rigid laws, by impulses: the exact motion has jumps, the steps are of first order.
    let rigid = [
        r#""law": "rigid", "e": 0.6"#,
        r#""law": "coulomb", "limit": 6"#,
    ];
    let [coarse, fine] = [4e-4, 5e-5].map(|dt| different("moreau-jean", rigid, "softened", dt));
    assert!(coarse[4] >= 1.0, "{coarse:?}");
    for k in 0..3 {
        assert!(
            fine[k] < 2e-4 && fine[k] < coarse[k] / 3.0,
            "{coarse:?} {fine:?}"
        );
    }
    assert!(fine[3] < 1e-10, "{fine:?}");
}

/// Matrices of a chain of two nodes in x and in y between rows 0 and 3 of supports, in a folder of their own.
fn imported(name: &str, support: &str, rows: [&str; 2]) -> std::path::PathBuf {
    let folder =
        std::env::temp_dir().join(format!("slipgap-supports-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    // Rows 0 to 3 in x, 4 to 7 in y, with one coupling of x and y between the free nodes and a consistent mass.
    let [mut m, mut k] = [String::new(), String::new()];
    let (mut count_m, mut count_k) = (0, 0);
    let add = |to: &mut String, count: &mut usize, i: usize, j: usize, x: f64| {
        *to += &format!("{} {} {x}\n", i + 1, j + 1);
        *count += 1;
    };
    for (first, stiff) in [(0, 80.0), (4, 120.0)] {
        for i in 0..4 {
            add(&mut m, &mut count_m, first + i, first + i, 2.0);
            let ends = if i == 0 || i == 3 { stiff } else { 2.0 * stiff };
            add(&mut k, &mut count_k, first + i, first + i, ends);
            if i > 0 {
                add(&mut m, &mut count_m, first + i, first + i - 1, 0.5);
                add(&mut k, &mut count_k, first + i, first + i - 1, -stiff);
            }
        }
    }
    // A spring along (1, -1) between the two free nodes.
    for (i, j, x) in [(5, 1, -15.0), (6, 2, -15.0), (5, 2, 15.0), (6, 1, 15.0)] {
        add(&mut k, &mut count_k, i, j, x);
    }
    let k = k
        .replace("6 6 240\n", "6 6 255\n")
        .replace("7 7 240\n", "7 7 255\n")
        .replace("7 6 -120\n", "7 6 -135\n")
        .replace("2 2 160\n", "2 2 175\n")
        .replace("3 3 160\n", "3 3 175\n")
        .replace("3 2 -80\n", "3 2 -95\n");
    let header = "%%MatrixMarket matrix coordinate real symmetric\n";
    std::fs::write(folder.join("m.mtx"), format!("{header}8 8 {count_m}\n{m}")).unwrap();
    std::fs::write(folder.join("k.mtx"), format!("{header}8 8 {count_k}\n{k}")).unwrap();
    let mut dofs = format!("node,direction,{support}\n");
    for direction in ["x", "y"] {
        for node in 0..4 {
            let row = match node {
                0 => rows[0],
                3 => rows[1],
                _ => "",
            };
            dofs += &format!("{node},{direction},{row}\n");
        }
    }
    std::fs::write(folder.join("dofs.csv"), dofs).unwrap();
    folder
}

/// A study of the matrices in a folder.
fn of_matrices(folder: &std::path::Path, method: &str, shaken: &str, y: &str) -> crate::Study {
    let against = match shaken.contains("supports") {
        true => r#", "left.x": -0.6, "left.y": -0.8"#,
        false => "",
    };
    let stop = format!(r#""t.1.x": 0.6, "t.1.y": 0.8{against}"#);
    with_keys(folder, method, ["", &stop, shaken], y)
}

/// The same with more keys of the matrices, and a stop along these nodes.
fn with_keys(
    folder: &std::path::Path,
    method: &str,
    [keys, stop, shaken]: [&str; 3],
    y: &str,
) -> crate::Study {
    let text = format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 6, "method": "{method}"}},
            "structure": {{"units": "t, kN, m, s",
              "matrices": {{"t": {{"M": "m.mtx", "K": "k.mtx", "dofs": "dofs.csv"{keys}}}}},
              "contacts": {{"stop": {{"law": "impact", "along": {{{stop}}},
                                      "gap": 0.01, "k": 900}},
                            "pair": {{"law": "displacement-control", "between": ["t.1.x", "t.2.x"], "k": 50, "limit": 0.4}}}},
              {shaken}}},
            "metrics": ["impacts(stop)", "energy_error"],
            "figures": [{{"name": "h", "kind": "history", "y": {y}}}]}}"#
    );
    let file = folder.join("study.json");
    std::fs::write(&file, text).unwrap();
    crate::read(&file).unwrap_or_else(|fault| panic!("{fault}"))
}

#[test]
fn rows_of_supports_move_as_the_ground_does() {
    let y = r#"{"sine": {"amplitude": 2, "omega": 5, "phase": 0.3}}"#;
    let both = format!(r#"{{"x": {SHAKE}, "y": {y}}}"#);
    let folder = imported("moving", "support", ["left", "right"]);
    let supports = format!(r#""supports": {{"left": {both}, "right": {both}}}"#);
    let fixed = imported("fixed", "support", ["left", "left"]);
    for method in ["average-acceleration", "bathe", "generalized-alpha"] {
        let channels = r#"["t.1.x - left.x", "t.2.y - left.y", "stop.r", "pair.S", "t.1.y.v - left.y.v", "t.0.y - left.y"]"#;
        let moving = solved(&of_matrices(&folder, method, &supports, channels));
        // One support for both sides is the same.
        let block = format!(r#""supports": {{"left": {both}}}"#);
        let one = solved(&of_matrices(&fixed, method, &block, channels));
        agree(&moving, &one, 5, 1e-10);
        assert!(moving.metrics[0] > Some(0.0));
        assert!(moving.metrics[1].unwrap() < 1e-11, "{:?}", moving.metrics);
        let largest = moving.computed.channels[5]
            .iter()
            .fold(0.0, |a: f64, b| a.max(b.abs()));
        assert_eq!(largest, 0.0);
        let ground = format!(r#""ground": {both}"#);
        let relative = r#"["t.1.x", "t.2.y", "stop.r", "pair.S", "t.1.y.v"]"#;
        let ground = solved(&of_ground(method, &ground, relative));
        agree(&ground, &moving, 5, 1e-10);
    }
    for folder in [folder, fixed] {
        std::fs::remove_dir_all(folder).unwrap();
    }
}

/// A node that is tied to the middle between two nodes, on supports that move apart, with all four modes and without.
#[test]
fn tied_nodes_on_supports_move_as_their_rows_with_all_modes() {
    let folder = imported("tied", "support", ["left", "right"]);
    let later = r#"{"sine": {"amplitude": 2, "omega": 5, "phase": 0.3}}"#;
    let moving = format!(
        r#""supports": {{"left": {{"x": {SHAKE}, "y": {later}}}, "right": {{"x": {later}, "y": {SHAKE}}}}}"#
    );
    let ties = r#", "ties": "node,direction,terms\n5,x,1.x:0.5,2.x:0.5\n5,y,1.y:0.5,2.y:0.5\n""#;
    let by_rows =
        r#""t.1.x": 0.3, "t.2.x": 0.3, "t.1.y": 0.4, "t.2.y": 0.4, "left.x": -0.6, "left.y": -0.8"#;
    let by_tie = r#""t.5.x": 0.6, "t.5.y": 0.8, "left.x": -0.6, "left.y": -0.8"#;
    for method in ["average-acceleration", "bathe", "generalized-alpha"] {
        let channels =
            |x: &str| format!(r#"["{x} - left.x", "t.2.y", "stop.r", "stop.S", "pair.S"]"#);
        let solve = |keys: &str, stop: &str, x: &str| {
            let keys = format!("{ties}{keys}");
            solved(&with_keys(
                &folder,
                method,
                [&keys, stop, &moving],
                &channels(x),
            ))
        };
        let plain = solve("", by_rows, "0.5*t.1.x + 0.5*t.2.x");
        assert!(plain.metrics[0] > Some(0.0));
        for reduce in ["", r#", "reduce": {"modes": 4}"#] {
            // Round-off of other coordinates, which the contacts let grow.
            agree(&plain, &solve(reduce, by_tie, "t.5.x"), 5, 1e-10);
        }
    }
    std::fs::remove_dir_all(folder).unwrap();
}

/// The same structure on the ground: the rows of the free nodes, and the ground shakes the mass of their whole rows.
fn of_ground(method: &str, shaken: &str, y: &str) -> crate::Study {
    let folder =
        std::env::temp_dir().join(format!("slipgap-ground-{}-{method}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let header = "%%MatrixMarket matrix coordinate real symmetric\n";
    let m = "1 1 2\n2 2 2\n2 1 0.5\n3 3 2\n4 4 2\n4 3 0.5\n";
    let k =
        "1 1 175\n2 2 175\n2 1 -95\n3 3 255\n4 4 255\n4 3 -135\n3 1 -15\n4 2 -15\n3 2 15\n4 1 15\n";
    std::fs::write(folder.join("m.mtx"), format!("{header}4 4 6\n{m}")).unwrap();
    std::fs::write(folder.join("k.mtx"), format!("{header}4 4 10\n{k}")).unwrap();
    std::fs::write(
        folder.join("dofs.csv"),
        "node,direction\n1,x\n2,x\n1,y\n2,y\n",
    )
    .unwrap();
    // M of a free node with its support, 0.5, is a load of its own: a part of the ground's.
    let extra = |node: &str, direction: &str, function: &str| {
        format!(r#"{{"at": "t.{node}.{direction}", {function}}}"#)
    };
    let x = r#""table": {"t": [0, 0.31, 0.8, 1.1, 2.05, 3], "f": [0.6, 4, -7, 5, -2, 1]}, "scale": -0.65"#;
    let sine = r#""sine": {"amplitude": -1, "omega": 5, "phase": 0.3}"#;
    let loads: Vec<String> = ["1", "2"]
        .iter()
        .flat_map(|node| [extra(node, "x", x), extra(node, "y", sine)])
        .collect();
    let shaken = format!(r#"{shaken}, "loads": [{}]"#, loads.join(", "));
    let study = of_matrices(&folder, method, &shaken, y);
    std::fs::remove_dir_all(folder).unwrap();
    study
}

#[test]
fn faults_of_supports_have_places() {
    let of = |supports: &str, more: &str| {
        faults(&format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}},
                "structure": {{"masses": {{"m": 1}}, "springs": [{{"between": ["left", "m"], "k": 1}}],
                "supports": {supports}{more}}}, "metrics": ["peak(m)"]}}"#
        ))
    };
    let sine = r#"{"sine": {"amplitude": 1, "omega": 1}}"#;
    let left = format!(r#"{{"left": {sine}}}"#);
    for (supports, more, at, part) in [
        (
            left.clone(),
            format!(r#", "ground": {sine}"#),
            "structure.supports",
            "not both",
        ),
        (
            format!(r#"{{"right": {sine}}}"#),
            String::new(),
            "between[0]",
            "unknown node \"left\"",
        ),
        (
            format!(r#"{{"left": {{"sine": {{"amplitude": 1, "omega": 1}}, "y": {sine}}}}}"#),
            String::new(),
            "supports.left.sine",
            "not both",
        ),
        (
            format!(r#"{{"left": {{"x": {sine}, "delay": -1}}}}"#),
            String::new(),
            "supports.left.delay",
            ">= 0",
        ),
        (
            r#"{"left": {"sine": {"amplitude": 1, "omega": 1}, "baseline": "linear"}}"#.to_owned(),
            String::new(),
            "supports.left",
            "a sine has none",
        ),
        (
            format!(r#"{{"left": {{"x": {sine}, "baseline": "parabolic"}}}}"#),
            String::new(),
            "supports.left.baseline",
            "linear",
        ),
        (
            format!(r#"{{"m": {sine}, "left": {sine}}}"#),
            String::new(),
            "supports.m",
            "another part",
        ),
        (
            left.clone(),
            r#", "start": {"left": {"u": 1}}"#.to_owned(),
            "start.left",
            "moves as",
        ),
        (
            left.clone(),
            r#", "contacts": {"c": {"law": "coulomb", "between": ["left", "ground"], "limit": 1}}"#
                .to_owned(),
            "contacts.c",
            "needs a law with a stiffness or a damper",
        ),
    ] {
        let found = of(&supports, &more);
        assert!(
            found.contains(at) && found.contains(part),
            "{supports}{more}: {found}"
        );
    }
    let folder = imported("faulty", "support", ["left", "middle"]);
    let supports = format!(r#""supports": {{"left": {sine}}}"#);
    for (shaken, part) in [
        (
            supports,
            "line 5: no support middle under \"supports\"; there are left",
        ),
        (
            format!(r#""ground": {sine}"#),
            "line 2: the study has no \"supports\"",
        ),
    ] {
        let text = format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}},
                "structure": {{"matrices": {{"t": {{"M": "m.mtx", "K": "k.mtx", "dofs": "dofs.csv"}}}}, {shaken}}},
                "metrics": ["peak(t.1.x)"]}}"#
        );
        std::fs::write(folder.join("study.json"), text).unwrap();
        let found = crate::read(&folder.join("study.json"))
            .unwrap_err()
            .to_string();
        assert!(
            found.contains(part) && found.contains("matrices.t.dofs"),
            "{found}"
        );
    }
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn the_delay_of_a_wave_is_an_axis_and_explain_shows_it() {
    let study = study(
        r#"{"problem": "structure", "parameters": {"dt": 0.01, "duration": 2, "v": [200, 400], "d": 60},
            "structure": {"masses": {"m": 1}, "springs": [{"between": ["left", "m"], "k": 1}],
                "contacts": {"stop": {"law": "impact", "between": ["m", "right"], "gap": 0.1, "k": 100}},
                "supports": {"left": {"sine": {"amplitude": 1, "omega": 4}},
                             "right": {"y": {"sine": {"amplitude": 1, "omega": 4}}, "x": {"sine": {"amplitude": 1, "omega": 4}}, "delay": "d/v"}}},
            "metrics": ["last(right)", "last(right.a)", "last(right.y.v)"]}"#,
    );
    for (row, delay) in [(0, 0.3), (1, 0.15)] {
        let case = study.case(row).unwrap();
        let solution = study.problem.solve(&case, &[]).unwrap();
        let x: f64 = 4.0 * (2.0 - delay);
        let expected = [(x - x.sin()) / 16.0, x.sin(), (1.0 - x.cos()) / 4.0];
        for (value, expected) in solution.metrics.iter().zip(expected) {
            assert!(
                (value.unwrap() - expected).abs() < 1e-14,
                "{:?}",
                solution.metrics
            );
        }
        let text = study
            .problem
            .as_structure()
            .unwrap()
            .description(&case)
            .unwrap();
        assert!(
            text.contains(&format!("right.y: moves from t = {delay} on")),
            "{text}"
        );
        assert!(text.contains("stop: m to right.x, gap 0.1"), "{text}");
        assert!(
            text.contains("1 node, total mass 1, 1 contact, 0 loads"),
            "{text}"
        );
    }
}

#[test]
fn parts_that_nothing_holds_do_not_follow_supports() {
    // One mass moves freely, two others, joined by a spring, meet a support that comes to them at 1.5 - 0.5: u_s = t^2/2.
    let study = study(
        r#"{"problem": "structure", "parameters": {"dt": 0.001, "duration": 1.2},
            "structure": {"masses": {"free": 3, "a": 1, "b": 1}, "springs": [{"between": ["a", "b"], "k": 100}],
                "contacts": {"stop": {"law": "impact", "between": ["left", "a"], "gap": 0.5, "k": 1e4}},
                "supports": {"left": {"table": {"t": [0], "f": [1]}}}, "start": {"free": {"v": 2}}},
            "metrics": ["last(free)", "last(left)", "energy_error"],
            "figures": [{"name": "h", "kind": "history", "y": ["stop.r", "stop.rdot", "a", "stop.S"]}]}"#,
    );
    let solution = solved(&study);
    assert!((solution.metrics[0].unwrap() - 2.4).abs() < 1e-13);
    assert!((solution.metrics[1].unwrap() - 0.72).abs() < 1e-15);
    assert!(
        solution.metrics[2].unwrap() < 1e-12,
        "{:?}",
        solution.metrics
    );
    let [r, rate, a, s] = &solution.computed.channels[..4] else {
        panic!("four channels");
    };
    for (i, t) in solution.computed.time.iter().enumerate() {
        if *t < 1.0 {
            // a and b move with the support or not, as R says: their u stays 0.
            let expected = [0.5 - 0.5 * t * t, -t, 0.0, 0.0];
            for (value, expected) in [r, rate, a, s].iter().zip(expected) {
                assert!(
                    (value[i] - expected).abs() < 1e-12,
                    "{t}: {} {expected}",
                    value[i]
                );
            }
        }
    }
    assert!(s.iter().any(|s| *s < 0.0));
}
