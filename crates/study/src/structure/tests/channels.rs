//! Accelerations, forces and energies as channels: against sums of other channels, velocities, and closed forms.

use super::{faults, solved, study};
use slipgap_problem::problem::Solution;

const METHODS: [&str; 8] = [
    "average-acceleration",
    "linear-acceleration",
    "newmark",
    "hht",
    "generalized-alpha",
    "bathe",
    "central-difference",
    "moreau-jean",
];

/// A motion that begins and ends with 0, without jumps.
const SHAKE: &str =
    r#"{"table": {"t": [0, 0.31, 0.8, 1.1, 2.05, 3], "f": [0, 4, -7, 5, -2, 0]}, "scale": 1.3}"#;

/// Masses of 2, 3 and 4 and a bar of 1.5, with springs, dashpots, a gap and two bearings; `left` and `right` hold them.
fn chain(method: &str, [left, right]: [&str; 2], shaken: &str, y: &[&str]) -> Solution {
    solved(&study(&format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 6, "method": "{method}"}},
            "structure": {{"masses": {{"a": 2, "b": 3, "deck": 4}},
              "bars": {{"bar": {{"L": 3, "EA": 900, "mass": 1.5, "n": 4, "stiffness_damping": 0.002}}}},
              "springs": [{{"name": "s1", "between": ["{left}", "a"], "k": 90, "c": 0.8}},
                          {{"between": ["a", "b"], "k": 40, "c": 0.3}},
                          {{"name": "s3", "between": ["{right}", "bar.right"], "k": 300}}],
              "contacts": {{"gap": {{"law": "impact", "k": 4000, "between": ["b", "bar.left"], "gap": 0.02}},
                            "bearing": {{"law": "displacement-control", "k": 700, "limit": 6, "between": ["{right}", "deck"]}},
                            "other": {{"law": "velocity-control", "limit": 6, "rdotE": 1e-1, "between": ["{left}", "deck"]}}}},
              "loads": [{{"at": "b", "table": {{"t": [0, 1, 2], "f": [0, 9, 0]}}}}],
              {shaken}}},
            "metrics": ["energy_error", "impacts(gap)"],
            "figures": [{{"name": "h", "kind": "history", "y": {y:?}}}]}}"#
    )))
}

fn peak(x: &[f64]) -> f64 {
    x.iter().fold(0.0, |peak: f64, x| peak.max(x.abs()))
}

/// A channel that is 0 is so up to round-off of another one.
fn vanishes(x: &[f64], of: &[f64], part: f64, what: &str) {
    let (x, of) = (peak(x), peak(of));
    assert!(of > 0.0 && x <= part * of, "{what}: {x:e} of {of}");
}

/// What nodes and their masses have of the sum of mass times absolute acceleration.
const MASSES: [(&str, f64); 8] = [
    ("a", 2.0),
    ("b", 3.0),
    ("deck", 4.0),
    ("bar.left", 0.1875),
    ("bar.1", 0.375),
    ("bar.2", 0.375),
    ("bar.3", 0.375),
    ("bar.right", 0.1875),
];

fn load(t: f64) -> f64 {
    9.0 * (1.0 - (t - 1.0).abs()).max(0.0)
}

#[test]
fn the_base_is_what_springs_and_contacts_exert_and_what_the_masses_need() {
    let ends = [
        (["ground"; 2], format!(r#""ground": {SHAKE}"#)),
        (
            ["left", "right"],
            format!(r#""supports": {{"left": {SHAKE}, "right": {SHAKE}}}"#),
        ),
        (
            ["left", "right"],
            format!(
                r#""supports": {{"left": {SHAKE}, "right": {{"table": {{"t": [0, 1, 5], "f": [0, 2, 0]}}, "delay": 0.4}}}}"#
            ),
        ),
    ];
    for method in METHODS {
        for (ends, shaken) in &ends {
            let accelerations = MASSES.map(|(name, _)| format!("{name}.a_abs"));
            let mut y = vec!["base", "base + s1.S + s3.S + bearing.S + other.S"];
            y.extend(accelerations.iter().map(String::as_str));
            let is_support = ends[0] == "left";
            if is_support {
                y.extend([
                    "base - base.left - base.right",
                    "base.left + s1.S + other.S",
                    "base.right + s3.S + bearing.S",
                ]);
            }
            let solution = chain(method, *ends, shaken, &y);
            assert!(solution.metrics[1] >= Some(1.0), "{method} {ends:?}");
            let channels = &solution.computed.channels;
            // Round-off of the largest of a few terms.
            vanishes(&channels[1], &channels[0], 1e-12, method);
            for sum in channels
                .iter()
                .skip(2 + MASSES.len())
                .take(if is_support { 3 } else { 0 })
            {
                vanishes(sum, &channels[0], 1e-12, method);
            }
            let steps = solution.computed.time.iter().enumerate();
            let rest: Vec<f64> = steps
                .map(|(i, t)| {
                    let masses = MASSES.iter().enumerate();
                    let inertia: f64 = masses.map(|(k, (_, mass))| mass * channels[2 + k][i]).sum();
                    inertia - load(*t) - channels[0][i]
                })
                .collect();
            vanishes(&rest, &channels[0], 1e-12, method);
        }
    }
}

#[test]
fn accelerations_are_the_slopes_of_velocities() {
    // The mean of both ends of a step of constant average acceleration is the change of the velocity over it, relative and absolute.
    let y = [
        "bar.1.a", "bar.1.v", "b.a", "b.v", "b.a_abs", "ground", "a.a", "a.v",
    ];
    let solution = chain(
        "average-acceleration",
        ["ground"; 2],
        &format!(r#""ground": {SHAKE}"#),
        &y,
    );
    let channels = &solution.computed.channels;
    for pair in [0, 2, 6] {
        let [a, v] = [&channels[pair], &channels[pair + 1]];
        let steps = a.windows(2).zip(v.windows(2));
        let rest: Vec<f64> = steps
            .map(|(a, v)| 0.5 * (a[0] + a[1]) - (v[1] - v[0]) / 0.01)
            .collect();
        // Round-off of v over dt, and of u times k/m = 7000.
        vanishes(&rest, a, 1e-11, y[pair]);
    }
    let rest: Vec<f64> = (0..channels[2].len())
        .map(|i| channels[2][i] + channels[5][i] - channels[4][i])
        .collect();
    vanishes(&rest, &channels[4], 1e-14, "a_abs");
}

#[test]
fn the_ground_moves_as_its_acceleration_says() {
    let ground = chain(
        "average-acceleration",
        ["ground"; 2],
        &format!(r#""ground": {SHAKE}"#),
        &["ground", "ground.a", "ground.v", "ground.u"],
    );
    let support = chain(
        "average-acceleration",
        ["left", "right"],
        &format!(r#""supports": {{"left": {SHAKE}, "right": {SHAKE}}}"#),
        &["left.a", "left.x.a", "left.v", "left"],
    );
    let [of_ground, same] = [ground, support].map(|one| one.computed.channels);
    for (channel, same) in of_ground.iter().zip(&same).take(4) {
        let rest: Vec<f64> = channel.iter().zip(same).map(|(a, b)| a - b).collect();
        // A table and the cubics of a motion differ by round-off.
        vanishes(&rest, channel, 1e-14, "ground");
    }
    // 1.3 times 4 at 0.31, by hand.
    assert!(
        (of_ground[0][31] - 5.2).abs() < 1e-12
            && (of_ground[2][31] - 0.5 * 0.31 * 5.2).abs() < 1e-12
    );
    assert!((of_ground[3][31] - 5.2 * 0.31 * 0.31 / 6.0).abs() < 1e-12);
}

#[test]
fn the_energies_add_up_to_the_input() {
    let y = [
        "energy.input",
        "energy.kinetic + energy.elastic + energy.damping + energy.contacts + energy.method - energy.input",
        "energy.method",
        "energy.contacts - gap.dissipated - bearing.dissipated - other.dissipated",
        "energy.damping",
        "gap.dissipated",
        "bearing.dissipated",
        "energy.kinetic",
    ];
    for method in METHODS {
        let ground = format!(r#""ground": {SHAKE}"#);
        let supports = format!(r#""supports": {{"left": {SHAKE}, "right": {SHAKE}}}"#);
        let relative = chain(method, ["ground"; 2], &ground, &y);
        let carried = chain(method, ["left", "right"], &supports, &y);
        for solution in [&relative, &carried] {
            let channels = &solution.computed.channels;
            // Round-off of 600 steps.
            vanishes(&channels[1], &channels[0], 1e-12, method);
            vanishes(&channels[3], &channels[0], 1e-12, method);
            assert!(
                channels[4].windows(2).all(|pair| pair[1] >= pair[0]),
                "{method}"
            );
            assert!(peak(&channels[6]) > 0.01 * peak(&channels[0]), "{method}");
            if method == "average-acceleration" {
                vanishes(&channels[2], &channels[0], 1e-12, method);
                // A spring gives back what it takes, but for the trapezoids of the steps in which it opens and closes.
                vanishes(&channels[5], &channels[0], 0.1, method);
            }
        }
        // The same motion in both forms, and so the same energies of it.
        let [one, other] = [&relative, &carried].map(|one| &one.computed.channels);
        for k in [0, 4, 6, 7] {
            let rest: Vec<f64> = one[k].iter().zip(&other[k]).map(|(a, b)| a - b).collect();
            vanishes(&rest, &one[k], 1e-9, y[k]);
        }
    }
}

#[test]
fn the_energies_of_a_free_vibration_are_its_closed_forms() {
    // m = 2, k = 8, c = 0.4: u = e^(-t/10) (cos w t + sin w t/(10 w)), w^2 = 4 - 1/100, from u = 1.
    let solution = solved(&study(
        r#"{"problem": "structure", "parameters": {"dt": 0.001, "duration": 5},
            "structure": {"masses": {"m": 2}, "springs": [{"name": "s", "between": ["ground", "m"], "k": 8, "c": 0.4}],
                          "start": {"m": {"u": 1}}, "contacts_reference": "softened"},
            "metrics": ["rms_error(m.a)", "peak(base)", "peak_error(s.S)"],
            "figures": [{"name": "h", "kind": "history", "y": ["energy.kinetic", "energy.elastic", "energy.damping",
                         "energy.input", "m.a", "s.S", "base"]}]}"#,
    ));
    let w = f64::sqrt(3.99);
    for (i, t) in solution.computed.time.iter().enumerate() {
        let ((sin, cos), fades) = ((w * t).sin_cos(), libm::exp(-t / 10.0));
        let u = fades * (cos + sin / (10.0 * w));
        let v = -fades * sin * 4.0 / w;
        let [kinetic, elastic] = [v * v, 4.0 * u * u];
        let a = -(0.4 * v + 8.0 * u) / 2.0;
        let closed = [
            kinetic,
            elastic,
            4.0 - kinetic - elastic,
            4.0,
            a,
            -2.0 * a,
            2.0 * a,
        ];
        for (k, x) in closed.iter().enumerate() {
            let steps = solution.computed.channels[k][i];
            // The phase of the method after two periods: (omega dt)^2/12 omega t = 3e-6, times some 8.
            assert!((steps - x).abs() < 3e-5, "{t}: {k} {steps} {x}");
            if k > 3 {
                let exact = solution.exact.channels[k][i];
                assert!((exact - x).abs() < 1e-11, "{t}: {k} {exact} {x}");
            }
        }
    }
    assert!(solution.exact.channels[..4].iter().all(Vec::is_empty));
    let metrics: Vec<f64> = solution.metrics.iter().map(|x| x.unwrap()).collect();
    assert!(
        metrics[0] > 0.0 && metrics[0] < 3e-5 && metrics[2] < 3e-5,
        "{metrics:?}"
    );
    // k u(0) at the start.
    assert!((metrics[1] - 8.0).abs() < 1e-12);
}

#[test]
fn a_bar_at_rest_has_the_same_force_in_all_elements() {
    let solution = solved(&study(
        r#"{"problem": "structure", "parameters": {"dt": 0.01, "duration": 0.1},
            "structure": {"bars": {"bar": {"L": 3, "EA": 900, "mass": 1.5, "n": 4}},
                          "springs": [{"name": "s", "between": ["ground", "bar.left"], "k": 500}],
                          "static": {"bar.right": 7}},
            "metrics": ["max(bar.1.S)", "min(bar.4.S)", "max(s.S)", "min(base)", "peak(bar.2.a)"]}"#,
    ));
    let found: Vec<f64> = solution.metrics.iter().map(|x| x.unwrap()).collect();
    for (found, force) in found.iter().zip([7.0, 7.0, 7.0, -7.0, 0.0]) {
        // Round-off of u times k/m = 3200 over 10 steps.
        assert!((found - force).abs() < 1e-10, "{found} {force}");
    }
}

#[test]
fn a_bounce_on_a_rigid_stop_has_the_force_of_its_impulse() {
    // m = 2 meets a stop with v = -3 and leaves with 1.5: the mean of S over the step of the impact is -2 4.5/dt.
    let text = |method: &str| {
        format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1, "method": "{method}"}},
                "structure": {{"masses": {{"m": 2}},
                  "contacts": {{"stop": {{"law": "rigid", "between": ["ground", "m"], "gap": 0.1, "e": 0.5}}}},
                  "start": {{"m": {{"v": -3}}}}, "contacts_reference": "softened"}},
                "metrics": ["max(m.a)", "last(stop.dissipated)", "peak(base + stop.S)"],
                "figures": [{{"name": "h", "kind": "history", "y": ["m.a", "energy.contacts"]}}]}}"#
        )
    };
    let solution = solved(&study(&text("moreau-jean")));
    let found: Vec<f64> = solution.metrics.iter().map(|x| x.unwrap()).collect();
    // m (9 - 2.25)/2 is lost.
    for (found, x) in found.iter().zip([450.0, 6.75, 0.0]) {
        assert!((found - x).abs() < 1e-9, "{found} {x}");
    }
    // The exact motion jumps between its instants: no force acts at them.
    assert_eq!(peak(&solution.exact.channels[0]), 0.0);
}

/// Three nodes on a line with coupled masses between the supports `left` and `right`, and a mass on a spring to the node 2.
fn matrices(support: bool, shaken: &str, y: &[&str]) -> Solution {
    // Several tests run at a time.
    let folder = tempfile::tempdir().unwrap();
    let header = "%%MatrixMarket matrix coordinate real symmetric\n";
    // Elements of masses 6 and stiffness 80, 95 and 70: M 2 1/1 2, K 1 -1/-1 1. Held rows are left out without supports.
    let (m, k, dofs) = match support {
        true => (
            "4 4 7\n1 1 2\n2 2 4\n3 3 4\n4 4 2\n2 1 1\n3 2 1\n4 3 1\n",
            "4 4 7\n1 1 80\n2 2 175\n3 3 165\n4 4 70\n2 1 -80\n3 2 -95\n4 3 -70\n",
            "node,direction,support\n0,x,left\n1,x,\n2,x,\n3,x,right\n",
        ),
        false => (
            "2 2 3\n1 1 4\n2 2 4\n2 1 1\n",
            "2 2 3\n1 1 175\n2 2 165\n2 1 -95\n",
            "node,direction\n1,x\n2,x\n",
        ),
    };
    for (name, text) in [
        ("m.mtx", format!("{header}{m}")),
        ("k.mtx", format!("{header}{k}")),
        ("dofs.csv", dofs.to_owned()),
    ] {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    let file = |name: &str| folder.path().join(name).display().to_string();
    solved(&study(&format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 4}},
            "structure": {{"masses": {{"top": 3}},
              "matrices": {{"t": {{"M": {:?}, "K": {:?}, "dofs": {:?}}}}},
              "springs": [{{"name": "s", "between": ["t.2.x", "top"], "k": 30, "c": 0.4}}],
              "contacts_reference": "softened", {shaken}}},
            "metrics": ["rms_error(t.1.x.a_abs)"],
            "figures": [{{"name": "h", "kind": "history", "y": {y:?}}}]}}"#,
        file("m.mtx"),
        file("k.mtx"),
        file("dofs.csv"),
    )))
}

#[test]
fn the_base_of_matrices_is_the_reaction_of_held_rows() {
    // Held rows that are not in the file: K of the elements to them, 80 and 70, is what is left of the sums of rows.
    let ground = format!(r#""ground": {SHAKE}"#);
    let y = [
        "base",
        "t.1.x",
        "t.2.x",
        "t.1.x.a_abs",
        "t.2.x.a_abs",
        "top.a_abs",
    ];
    let solution = matrices(false, &ground, &y);
    for motion in [&solution.computed, &solution.exact] {
        let channels = &motion.channels;
        let springs = (0..channels[0].len())
            .map(|i| channels[0][i] + 80.0 * channels[1][i] + 70.0 * channels[2][i]);
        vanishes(&springs.collect::<Vec<_>>(), &channels[0], 1e-12, "springs");
        let inertia = (0..channels[0].len()).map(|i| {
            let [a1, a2, top] = [3, 4, 5].map(|k| channels[k][i]);
            5.0 * a1 + 5.0 * a2 + 3.0 * top - channels[0][i]
        });
        // The exact motion solves the coupled masses by modes.
        vanishes(&inertia.collect::<Vec<_>>(), &channels[0], 1e-11, "inertia");
    }
    // Second order, (omega dt)^2/12 with omega = 8.
    assert!(solution.metrics[0].unwrap() < 0.01 * peak(&solution.computed.channels[3]));
}

#[test]
fn supports_of_matrices_have_their_rows_of_the_equations() {
    let other = r#"{"table": {"t": [0, 1, 3], "f": [0, 2, 0]}, "delay": 0.2}"#;
    for right in [SHAKE, other] {
        let shaken = format!(r#""supports": {{"left": {SHAKE}, "right": {right}}}"#);
        let y = [
            "base",
            "base.left",
            "base.right",
            "t.1.x.a",
            "t.2.x.a",
            "top.a",
            "left.a",
            "right.a",
            "t.1.x - left",
            "t.2.x - right",
        ];
        let solution = matrices(true, &shaken, &y);
        let channels = &solution.computed.channels;
        let rest = |f: &dyn Fn([f64; 10]) -> f64| -> Vec<f64> {
            let row = |i: usize| std::array::from_fn(|k| channels[k][i]);
            (0..channels[0].len()).map(|i| f(row(i))).collect()
        };
        let left = rest(&|x| 2.0 * x[6] + x[3] - 80.0 * x[8] - x[1]);
        let right = rest(&|x| 2.0 * x[7] + x[4] - 70.0 * x[9] - x[2]);
        let sum = rest(&|x| x[1] + x[2] - x[0]);
        let inertia =
            rest(&|x| 3.0 * x[6] + 6.0 * x[3] + 6.0 * x[4] + 3.0 * x[7] + 3.0 * x[5] - x[0]);
        for (what, residual) in [
            ("left", left),
            ("right", right),
            ("sum", sum),
            ("inertia", inertia),
        ] {
            vanishes(&residual, &channels[0], 1e-11, what);
        }
    }
}

#[test]
fn wrong_channels_say_what_is_allowed() {
    let with = |shaken: &str, spring: &str, y: &str| {
        faults(&format!(
            r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 1}},
                "structure": {{"masses": {{"p1": 1, "up": {{"mass": 1, "direction": "y"}}}},
                  "bars": {{"bar": {{"L": 3, "EA": 900, "mass": 1.5, "n": 4}}}},
                  "springs": [{{{spring}"between": ["p1", "up"], "k": 1}}, {{"between": ["ground", "p1"], "k": 1}}],
                  "contacts_reference": "softened"{shaken}}},
                "metrics": ["rms_error(energy.kinetic)"],
                "figures": [{{"name": "h", "kind": "history", "y": ["{y}"]}}]}}"#
        ))
    };
    let ground = format!(r#", "ground": {{"x": {SHAKE}, "y": {SHAKE}}}"#);
    for (shaken, spring, y, part) in [
        ("", "", "ground", "the study has no \"ground\""),
        (&*ground, "", "ground", "name one: ground.x.a or ground.y.a"),
        (&ground, "", "ground.z.v", "does not move in z"),
        (&ground, "", "ground.y.w", "got 'ground.y.w'"),
        ("", "", "base", "name one: base.x or base.y"),
        ("", "", "base.z", "no node moves in z"),
        ("", "", "energy.heat", "no energy 'energy.heat'"),
        ("", "", "bar.x.S", "have the numbers 1, 2"),
        ("", r#""name": "p1", "#, "p1", "is the name of another part"),
        ("", r#""name": "a b", "#, "p1", "cannot name a spring"),
        ("", "", "p1 + p1.a", "a length and an acceleration"),
        ("", "", "error(energy.input)", "no energies by kind"),
        ("", "", "energy.kinetic", "no energies by kind"),
        (
            "",
            r#""name": "storey", "#,
            "story.S",
            "did you mean 'storey.S'?",
        ),
        ("", "", "energie.input", "did you mean 'energy.input'?"),
    ] {
        let found = with(shaken, spring, y);
        assert!(found.contains(part), "{y}: {found}");
    }
}

#[test]
fn cases_side_by_side_have_the_bits_of_each_alone() {
    let gaps: Vec<f64> = (0..23).map(|i| 0.002 * f64::from(i)).collect();
    let study = study(&format!(
        r#"{{"problem": "structure", "parameters": {{"dt": 0.01, "duration": 3, "gap": {gaps:?}, "method": ["average-acceleration", "hht"]}},
            "structure": {{"masses": {{"a": 2, "b": 3}},
              "springs": [{{"name": "s", "between": ["ground", "a"], "k": "90 + 100*gap", "c": 0.8}},
                          {{"between": ["ground", "a"], "k": "10 - 100*gap"}}, {{"between": ["a", "b"], "k": 40}}],
              "contacts": {{"stop": {{"law": "impact", "k": 4000, "between": ["b", "ground"], "gap": "gap"}}}},
              "ground": {SHAKE}}},
            "metrics": ["peak(a.a)", "max(b.a_abs)", "peak(s.S)", "peak(base)", "last(energy.input)", "last(energy.method)",
                        "peak(stop.dissipated)", "difference(b.a)", "last(ground.u)"]}}"#
    ));
    let (_, cases) = study.columns(0, study.raw_len());
    let rows: Vec<u32> = (0..cases.len() as u32).collect();
    let swept = study.problem.sweep(&cases, &rows);
    for i in 0..cases.len() {
        let alone = study
            .problem
            .solve(&study.case(i as u64).unwrap(), &[])
            .unwrap();
        let row: Vec<Option<f64>> = swept.row(i).collect();
        assert_eq!(row, alone.metrics, "{i}");
    }
}

#[test]
fn gravity_acts_where_masses_are_coupled_to_supports() {
    // At rest the supports carry the weight of the free rows: M times 1 in them, 6 each, and the mass of 3.
    let shaken = r#""supports": {"left": {"displacement": {"t": [0, 9], "u": [0, 0]}}, "right": {"displacement": {"t": [0, 9], "u": [0, 0]}}},
                    "static": {"gravity": {"x": 10}}"#;
    let solution = matrices(true, shaken, &["base", "t.1.x"]);
    for x in &solution.computed.channels[0] {
        assert!((x + 150.0).abs() < 1e-9, "{x}");
    }
}
