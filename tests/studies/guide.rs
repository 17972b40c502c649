//! The numbers that the guide works out, and its advice. tests/pages runs its commands.

use std::fs;
use std::process::Command;

/// Numbers that the guide works out from the girder's data.
#[test]
fn the_numbers_of_the_guide_are_right() {
    let slowness = (7850.0_f64 / 2.1e11).sqrt();
    let impedance = 0.6 * 2.1e11 * slowness;
    let force = 0.5 * impedance / 2.0;
    assert!((impedance / 1e6 - 24.4).abs() < 0.05 && (force / 1e6 - 6.09).abs() < 0.01);
    for (peak, shown) in [(1.43, 8.7), (1.08, 6.6), (1.01, 6.2)] {
        assert!((peak * force / 1e6 - shown).abs() < 0.06);
    }
    // T_I = 2 L/C0 and c T_I/2; the gap over it, and the time in which it closes.
    let (time, unit) = (80.0 * slowness, 0.5 * 40.0 * slowness);
    assert!((time * 1e3 - 15.5).abs() < 0.05 && (unit * 1e3 - 3.87).abs() < 0.005);
    assert!((0.05 / unit - 12.93).abs() < 0.005 && (0.05 / 0.5 / time - 6.47).abs() < 0.005);
    assert!((time / 80.0 * 1e3 - 0.19).abs() < 0.005);
    assert!((force / 5e9 * 1e3 - 1.2).abs() < 0.05);
    // gamma = k_I L/(n E A): 0.4 with n = 20.
    assert!((2.5e10_f64 * 40.0 / (20.0 * 2.1e11 * 0.6) - 0.4).abs() < 0.005);
}

/// The peak of the force over F0 in a bar's contact of these n, in the order of the cases.
fn peaks(parameters: &str) -> Vec<f64> {
    let folder = tempfile::tempdir().unwrap();
    let study = format!(
        r#"{{ "problem": "bar-impact", "parameters": {{ "E": 2.1e11, "A": 0.6, "rho": 7850, "L": 40, "V0": 0.25,
            {parameters}, "duration": 1.5 }} }}"#
    );
    fs::write(folder.path().join("a.json"), study).unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_slipgap-tested"))
        .args(["run", "a.json"])
        .current_dir(folder.path())
        .output()
        .unwrap();
    assert!(output.status.success(), "{output:?}");
    let table = fs::read_to_string(folder.path().join("figures/a/results.csv")).unwrap();
    let mut lines = table.lines();
    let column = lines
        .next()
        .unwrap()
        .split(',')
        .position(|c| c == "peak_force");
    let cell = |line: &str| line.split(',').nth(column.unwrap()).unwrap().parse();
    lines.map(|line| cell(line).unwrap()).collect()
}

/// The late crests of the force in the contact mode, from the mode's closed form (tests/reference/README.md, Notes).
fn crest(gamma: f64) -> f64 {
    let root = (1.0 + 4.0 * gamma * gamma).sqrt();
    1.0 + 2.0 * gamma * (1.0 - 1.0 / root) / (2.0 + 2.0 * root).sqrt()
}

#[test]
fn a_finer_mesh_helps_at_one_stiffness_and_not_at_one_gamma() {
    const MESHES: [f64; 7] = [8.0, 12.0, 16.0, 20.0, 28.0, 40.0, 80.0];
    let n = r#""n": [8, 12, 16, 20, 28, 40, 80], "dt": "0.1/n""#;
    // At one k_I the peak falls from mesh to mesh, as the closed form of the mode at that gamma says. The first peak is
    // higher than the late crests by up to 0.01 at gamma = 1, and the spring's own rise takes 0.005 off at gamma = 0.1.
    let fixed = peaks(&format!(r#"{n}, "k_I": 2.5e10"#));
    for (peak, n) in fixed.iter().zip(MESHES) {
        let gamma = 2.5e10 * 40.0 / (n * 2.1e11 * 0.6);
        assert!((peak - crest(gamma)).abs() < 0.015, "n = {n}: {peak}");
        // The advice: gamma at most 0.4 for a peak within 10 %.
        assert!(gamma > 0.4 || (peak - 1.0).abs() < 0.1, "n = {n}: {peak}");
    }
    assert!(fixed.windows(2).all(|pair| pair[1] < pair[0]), "{fixed:?}");
    // At one gamma it stays: the same closed form for every mesh.
    for gamma in [0.4, 1.0] {
        for (peak, n) in peaks(&format!(r#"{n}, "gamma": {gamma}"#))
            .iter()
            .zip(MESHES)
        {
            assert!(
                (peak - crest(gamma)).abs() < 0.015,
                "gamma = {gamma}, n = {n}: {peak}"
            );
        }
    }
    // The advice on the step: T_I/(4 n), wherever in a step the impact falls.
    for gap in [0.0, 0.0013, 0.0037, 0.0071, 0.0113] {
        let coarse = r#""n": [8, 12, 16, 20, 28, 40, 80], "dt": "0.25/n""#;
        for peak in peaks(&format!(r#"{coarse}, "gamma": 0.4, "gap": {gap}"#)) {
            assert!((peak - 1.0).abs() < 0.1, "gap = {gap}: {peak}");
        }
    }
}
