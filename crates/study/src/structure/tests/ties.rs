//! Dofs of matrices that are tied to rows.

use super::{faults, solved, study};

/// A study of a rigid arm of length 2 from node 1, which springs of 300 in x and 500 in rz hold, with its end at node 2: with these
/// keys of the matrices and the structure, and metrics.
fn arm(keys: &str, structure: &str, metrics: &str) -> String {
    let matrix = |a: f64, b: f64, c: f64| {
        format!(
            "%%MatrixMarket matrix coordinate real symmetric\\n2 2 3\\n1 1 {a}\\n2 1 {b}\\n2 2 {c}\\n"
        )
    };
    let (mass, stiffness) = (matrix(5.0, -4.0, 9.0), matrix(300.0, 0.0, 500.0));
    format!(
        r#"{{"problem": "structure", "parameters": {{"factor": 3, "dt": 0.01, "duration": 4}},
            "structure": {{"matrices": {{"t": {{"M": "{mass}", "K": "{stiffness}", "dofs": [["1", "x"], ["1", "rz"]], {keys}}}}},
                "masses": {{"block": 2}}, {structure}}},
            "metrics": {metrics}}}"#
    )
}

const TIES: &str = r#""ties": "node,direction,terms\n2,x,1.x:1,1.rz:-2\n3,y,1.rz:0.5\n""#;

fn metrics(text: &str) -> Vec<f64> {
    let solution = solved(&study(text));
    solution.metrics.iter().map(|x| x.unwrap()).collect()
}

#[test]
fn a_force_on_the_end_of_an_arm_bends_and_turns_it() {
    // u_2 = F/300 - 2 (-2 F)/500 at rest; of t.x also F at node 1.
    let at_end = 30.0 / 300.0 + 4.0 * 30.0 / 500.0;
    let at_both = at_end + 30.0 / 300.0;
    for (at, expected) in [("t.2.x", at_end), ("t.x", at_both)] {
        for reduce in ["", r#", "reduce": {"modes": 1}"#] {
            let found = metrics(&arm(
                &format!("{TIES}{reduce}"),
                &format!(r#""static": {{"{at}": "10*factor"}}"#),
                r#"["last(t.2.x)", "last(t.2.x - t.1.x)", "last(t.3.y)"]"#,
            ));
            let turn = -2.0 * 30.0 / 500.0;
            let expected = [expected, -2.0 * turn, 0.5 * turn];
            for (found, expected) in found.iter().zip(expected) {
                assert!(
                    (found - expected).abs() < 1e-12,
                    "{at} {reduce} {found} {expected}"
                );
            }
        }
    }
}

#[test]
fn a_tied_dof_is_the_sum_of_its_rows_everywhere() {
    let structure = |end: &str, spring: &str, load: &str| {
        format!(
            r#""contacts": {{
                    "gap": {{"law": "impact", {end}, "gap": 0.05, "k": 400}},
                    "bearing": {{"law": "displacement-control", {spring}, "limit": 20, "k": 1000}}}},
                "springs": [{{{spring}, "k": 50, "c": 2}}, {{"between": ["ground", "block"], "k": 90}}],
                "ground": {{"sine": {{"amplitude": 6, "omega": 8}}}},
                "loads": [{load}]"#
        )
    };
    let sine = r#""sine": {"amplitude": 40, "omega": 5}"#;
    let tied = structure(
        r#""between": ["t.2.x", "block"]"#,
        r#""along": {"t.2.x": "factor", "block": -1}"#,
        &format!(r#"{{"at": "t.2.x", {sine}}}"#),
    );
    let plain = structure(
        r#""along": {"t.1.x": -1, "t.1.rz": 2, "block": 1}"#,
        r#""along": {"t.1.x": "factor", "t.1.rz": "-2*factor", "block": -1}"#,
        &format!(
            r#"{{"at": "t.1.x", {sine}}}, {{"at": "t.1.rz", "sine": {{"amplitude": -80, "omega": 5}}}}"#
        ),
    );
    let channels =
        r#"["peak(t.1.x)", "peak(t.1.rz)", "peak(gap.S)", "work(bearing)", "energy_error"]"#;
    for reduce in ["", r#", "reduce": {"modes": 1}"#] {
        let keys = format!("{TIES}{reduce}");
        let tied = metrics(&arm(&keys, &tied, channels));
        let plain = metrics(&arm(&keys, &plain, channels));
        assert!(tied[2] > 1.0 && tied[4] < 1e-12, "{tied:?}");
        for (a, b) in tied.iter().zip(&plain).take(4) {
            // Round-off of another order of sums.
            assert!((a - b).abs() <= 1e-12 * a.abs(), "{tied:?} {plain:?}");
        }
    }
    // The channels, by those of the rows at each instant.
    let sums = r#"["peak(t.2.x - t.1.x + t.1.rz + t.1.rz)", "peak(t.2.x.v - t.1.x.v + t.1.rz.v + t.1.rz.v)",
        "peak(t.2.x.a - t.1.x.a + t.1.rz.a + t.1.rz.a)", "peak(t.2.x.a_abs - t.1.x.a_abs + t.1.rz.a + t.1.rz.a)"]"#;
    for found in metrics(&arm(TIES, &tied, sums)) {
        assert!(found < 1e-12, "{found}");
    }
}

#[test]
fn faults_of_ties_have_lines() {
    let held = r#""springs": [{"between": ["t.1.x", "block"], "k": 1}]"#;
    let of = |lines: &str| format!(r#""ties": "{lines}""#);
    for (lines, line, part) in [
        ("a,b\\n", 1, "begin with node,direction"),
        ("node,direction\\n", 1, "no ties"),
        ("node,direction\\n2,q,1.x:1\\n", 2, "x, y, z, rx, ry or rz"),
        ("node,direction\\n2-,x,1.x:1\\n", 2, "letters, digits"),
        ("node,direction\\n2,x,1.x\\n", 2, "dof:factor"),
        ("node,direction\\n2,x,1.x:nan\\n", 2, "finite"),
        ("node,direction\\n2,x,1.y:1\\n", 2, "no row \\\"1.y\\\""),
        ("node,direction\\n2,x,1.x:1,1.x:2\\n", 2, "twice"),
        ("node,direction\\n2,x,1.x:0\\n", 2, "that moves it"),
        ("node,direction\\n2,x\\n", 2, "that moves it"),
        ("node,direction\\n1,x,1.x:1\\n", 2, "1.x is a row"),
        (
            "node,direction\\n2,x,1.x:1\\n2,x,1.x:1\\n",
            3,
            "twice, first in line 2",
        ),
    ] {
        let message = faults(&arm(&of(lines), held, r#"["peak(block)"]"#));
        let part = part.replace("\\\"", "\"");
        assert!(
            message.contains(&format!("line {line}: ")) && message.contains(&part),
            "{lines}: {message}"
        );
    }
    let start = format!(r#"{held}, "start": {{"t.2.x": {{"u": 1}}}}"#);
    let message = faults(&arm(TIES, &start, r#"["peak(block)"]"#));
    assert!(message.contains("starts as the dofs"), "{message}");
    let twice = r#""springs": [{"between": ["t.2.x", "t.2.x"], "k": 1}]"#;
    let message = faults(&arm(TIES, twice, r#"["peak(block)"]"#));
    assert!(message.contains("two different nodes"), "{message}");
    let message = faults(&arm(TIES, held, r#"["peak(t.2.y)"]"#));
    assert!(
        message.contains("node 2 of t has the directions x"),
        "{message}"
    );
}

const FORCES: &str =
    r#""forces": "name,quantity,terms\nshear,force,1.x:300,1.rz:0\nfoot,moment,1.rz:-500\n""#;

#[test]
fn forces_of_members_are_sums_of_rows() {
    // At rest the springs have the force and the moment of the load: 30 and 2*30.
    let at_rest = r#""static": {"t.2.x": "10*factor"}"#;
    for reduce in ["", r#", "reduce": {"modes": 1}"#] {
        let found = metrics(&arm(
            &format!("{TIES}, {FORCES}{reduce}"),
            at_rest,
            r#"["last(t.shear)", "last(t.foot)", "last(0.5*t.foot)", "last(t.foot - 2*t.foot)", "last(3*t.2.x - .5e1*t.1.x)"]"#,
        ));
        let u = 30.0 / 300.0;
        let last = 3.0 * (u + 4.0 * 30.0 / 500.0) - 5.0 * u;
        for (found, expected) in found.iter().zip([30.0, 60.0, 30.0, -60.0, last]) {
            assert!((found - expected).abs() < 1e-11, "{found} {expected}");
        }
    }
    let message = faults(&arm(
        &format!("{TIES}, {FORCES}"),
        at_rest,
        r#"["peak(t.shear + t.foot)", "peak(t.thrust)"]"#,
    ));
    assert!(
        message.contains("a force and an energy or a moment")
            && message.contains("t has no node or force \"thrust\""),
        "{message}"
    );
}

#[test]
fn faults_of_forces_have_lines() {
    let of = |lines: &str| format!(r#""forces": "{lines}""#);
    let held = r#""springs": [{"between": ["t.1.x", "block"], "k": 1}]"#;
    for (lines, line, part) in [
        ("a,b\\n", 1, "begin with name,quantity"),
        ("name,quantity\\n", 1, "no forces"),
        ("name,quantity\\na.b,force,1.x:1\\n", 2, "letters, digits"),
        (
            "name,quantity\\na,stress,1.x:1\\n",
            2,
            "force or moment, got \"stress\"",
        ),
        ("name,quantity\\na,force,2.x:1\\n", 2, "no row \"2.x\""),
        ("name,quantity\\na,force,1.x:0\\n", 2, "a has no dof:factor"),
        (
            "name,quantity\\na,force,1.x:1\\na,moment,1.x:1\\n",
            3,
            "a is there twice",
        ),
    ] {
        let message = faults(&arm(&of(lines), held, r#"["peak(block)"]"#));
        assert!(
            message.contains(&format!("line {line}: ")) && message.contains(part),
            "{lines}: {message}"
        );
    }
}
