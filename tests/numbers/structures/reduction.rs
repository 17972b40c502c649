//! Reduced matrices of other programs against the whole ones, and against bars.

use slipgap::study;

/// Matrices that the tests of the formats have, and those of the studies.
const FRAMES: &str = concat!(env!("SLIPGAP_ROOT"), "/tests/data/own_structure");
const MODELS: &str = concat!(env!("SLIPGAP_ROOT"), "/studies/structures/models");

/// The metrics of the first case of a study whose files are in a folder.
fn metrics(folder: &str, text: &str) -> Vec<f64> {
    let study = study::parse(&format!("{folder}/s.json"), text).unwrap();
    let solution = study.problem.solve(&study.case(0).unwrap(), &study.metrics);
    let metrics = solution.unwrap().metrics;
    metrics.into_iter().map(Option::unwrap).collect()
}

/// Two frames with a skew contact; a rotation without mass is kept, and all kinds of loads and starts act.
fn frames(name: &str, reduce: &str, channels: [&str; 2]) -> Vec<f64> {
    let [u, r] = channels;
    metrics(
        FRAMES,
        &format!(
            r#"{{ "problem": "structure", "parameters": {{ "dt": 0.002, "duration": 3 }},
            "structure": {{
                "matrices": {{ "f": {{ "M": "{name}.M.mtx", "C": "{name}.C.mtx", "K": "{name}.K.mtx", "dofs": "{name}.dofs.csv"
                    {reduce} }} }},
                "masses": {{ "block": 3 }},
                "springs": [{{ "between": ["f.111.rz", "block"], "k": 2e3 }}, {{ "between": ["block", "ground"], "k": 1e3, "c": 1 }}],
                "contacts": {{ "roof": {{ "law": "impact", "gap": 0.005, "k": 4e4,
                    "along": {{ "f.132.x": -0.9998, "f.132.y": -0.02, "f.231.x": 0.9998, "f.231.y": 0.02 }} }} }},
                "loads": [{{ "at": "f.y", "sine": {{ "amplitude": 3, "omega": 11 }} }},
                    {{ "at": "f.121.x", "sine": {{ "amplitude": 40, "omega": 7 }} }}],
                "ground": {{ "x": {{ "synthetic": 3 }}, "y": {{ "synthetic": 4 }} }},
                "start": {{ "f.x": {{ "u": 0.01, "v": 0.1 }}, "f.132.x": {{ "u": 0.02 }} }} }},
            "metrics": ["reduction_error({u})", "reduction_error({r})", "peak({u})", "peak({r})", "reduction_error(block)"] }}"#
        ),
    )
}

#[test]
fn frames_with_all_modes_move_as_the_whole_model() {
    for name in ["frames", "rotary", "damped"] {
        let found = frames(
            name,
            r#", "reduce": { "modes": 1000 }"#,
            ["f.222.x", "roof.S"],
        );
        let [u, force, peak_u, peak_force, block] = found[..] else {
            panic!();
        };
        // The whole model and the other coordinates have different round-off; the condition of K is 1e5.
        assert!(
            u < 1e-9 * peak_u && block < 1e-9 * peak_u,
            "{name}: {u} {block}"
        );
        assert!(
            force < 1e-9 * peak_force && peak_force > 10.0,
            "{name}: {force}"
        );
        // Few modes are another model: the metric sees it.
        let few = frames(name, r#", "reduce": { "up_to": 5 }"#, ["f.222.x", "roof.S"]);
        assert!(few[0] > 1e-3 * peak_u && few[0] < peak_u, "{name}: {few:?}");
    }
}

#[test]
fn a_bar_with_more_modes_tends_to_its_mesh() {
    // The bar of the studies against a stop, as a bar of the study and by matrices.
    let study = |parts: &str, node: &str, start: &str, metrics: &str| {
        format!(
            r#"{{ "problem": "structure", "parameters": {{ "dt": 0.002, "duration": 3 }}, "structure": {{ {parts},
            "contacts": {{ "stop": {{ "law": "impact", "between": ["{node}", "ground"], "k": 60 }} }}, "start": {{ "{start}": {{ "v": 1 }} }} }},
            "metrics": [{metrics}] }}"#
        )
    };
    let plain = r#""impulse(stop)", "peak(stop.S)", "contact_time(stop)""#;
    let mesh = metrics(
        MODELS,
        &study(
            r#""bars": { "b": { "L": 1, "EA": 1, "mass": 1, "n": 60 } }"#,
            "b.right",
            "b",
            plain,
        ),
    );
    let with = |modes: usize| {
        let parts = format!(
            r#""matrices": {{ "b": {{ "M": "bar.M.mtx", "K": "bar.K.mtx", "dofs": "bar.dofs.csv", "reduce": {{ "modes": {modes} }} }} }}"#
        );
        let errors = format!(r#"{plain}, "reduction_error(stop.S)", "reduction_error(b.61.x)""#);
        metrics(MODELS, &study(&parts, "b.61.x", "b.x", &errors))
    };
    let errors: Vec<[f64; 2]> = [1, 4, 16, 59]
        .map(|modes| {
            let found = with(modes);
            [found[3], found[4]]
        })
        .to_vec();
    for pair in errors.windows(2) {
        assert!(
            pair[1][0] < pair[0][0] && pair[1][1] < 0.5 * pair[0][1],
            "{errors:?}"
        );
    }
    let by_modes = with(60);
    for (of_modes, mesh) in by_modes.iter().zip(&mesh) {
        // Round-off; contact times are whole steps.
        assert!((of_modes - mesh).abs() < 1e-10, "{by_modes:?} {mesh:?}");
    }
    assert!(by_modes[3] < 1e-9 && by_modes[4] < 1e-10, "{by_modes:?}");
}

#[test]
fn the_steps_agree_where_no_modes_are_needed() {
    // A load that rests is carried statically by any number of modes, after heavy damping.
    let last = |reduce: &str| {
        metrics(
            FRAMES,
            &format!(
                r#"{{ "problem": "structure", "parameters": {{ "dt": 0.05, "duration": 60 }},
                "structure": {{ "matrices": {{ "f": {{ "M": "frames.M.mtx", "K": "frames.K.mtx", "dofs": "frames.dofs.csv" {reduce} }} }},
                "rayleigh": {{ "mass": 4, "stiffness": 0.1 }},
                "loads": [{{ "at": "f.132.x", "table": {{ "t": [0, 1], "f": [0, 100] }} }}, {{ "at": "f.y", "table": {{ "t": [0, 1], "f": [0, -9] }} }}] }},
                "metrics": ["last(f.132.x)", "last(f.111.rz)", "last(f.231.y)"] }}"#
            ),
        )
    };
    let whole = last("");
    for modes in [0, 2, 22] {
        let reduced = last(&format!(r#", "reduce": {{ "modes": {modes} }}"#));
        for (peak, whole) in reduced.iter().zip(&whole) {
            // exp(-2 * 60) is left of the motion; round-off of a condition of 1e5.
            assert!((peak / whole - 1.0).abs() < 1e-9, "{peak} {whole}");
        }
    }
}

#[test]
fn histories_and_descriptions_name_what_is_left() {
    let text = r#"{ "problem": "structure", "parameters": { "modes": [2, 5], "dt": 0.01, "duration": 1 },
        "structure": { "matrices": { "f": { "M": "frames.M.mtx", "K": "frames.K.mtx", "dofs": "frames.dofs.csv", "reduce": { "modes": "modes" } } },
        "ground": { "synthetic": 3 } }, "metrics": ["peak(f.132.x)"], "checks": [{ "metric": "peak(f.111.y)", "max": 1 }] }"#;
    let study = study::parse(&format!("{FRAMES}/s.json"), text).unwrap();
    for (case, modes) in [(0, 2), (1, 5)] {
        let case = study.case(case).unwrap();
        let columns = study.problem.history_columns(&case);
        let names: Vec<&str> = columns
            .iter()
            .map(|channel| &*channel.column.name)
            .collect();
        assert_eq!(names.len(), 2 * (2 + modes));
        assert_eq!(
            names[..6],
            [
                "f.111.y.u",
                "f.111.y.v",
                "f.132.x.u",
                "f.132.x.v",
                "f.mode1.u",
                "f.mode1.v"
            ]
        );
        let text = study
            .problem
            .as_structure()
            .unwrap()
            .description(&case)
            .unwrap();
        let expected = format!(
            "reduction of f: of 36 dofs 2 are kept, with {modes} of 22 modes up to the frequency "
        );
        assert!(text.contains(&expected), "{text}");
        // That of the whole model.
        assert!(text.contains("total mass x 156, y 156,"), "{text}");
    }
}

#[test]
fn the_time_for_which_nodes_touch_is_that_of_their_own_masses() {
    let time = |reduce: &str| {
        let text = format!(
            r#"{{ "problem": "structure", "parameters": {{ "dt": 0.002, "duration": 3 }}, "structure": {{
            "matrices": {{ "b": {{ "M": "bar.M.mtx", "K": "bar.K.mtx", "dofs": "bar.dofs.csv" {reduce} }} }},
            "contacts": {{ "stop": {{ "law": "impact", "between": ["b.61.x", "ground"], "k": 60 }} }} }}, "metrics": ["impulse(stop)"] }}"#
        );
        let study = study::parse(&format!("{MODELS}/s.json"), &text).unwrap();
        let text = study
            .problem
            .as_structure()
            .unwrap()
            .description(&study.case(0).unwrap())
            .unwrap();
        let behind = text.split("its nodes touch for ").nth(1).unwrap();
        behind.split(' ').next().unwrap().parse::<f64>().unwrap()
    };
    // pi sqrt(m/k) of half an element.
    let expected = std::f64::consts::PI * (1.0 / 120.0 / 60.0_f64).sqrt();
    for reduce in ["", r#", "reduce": { "modes": 60 }"#] {
        // Six digits are printed.
        assert!((time(reduce) / expected - 1.0).abs() < 1e-5, "{reduce}");
    }
    // Without modes the whole bar is the mass.
    let whole = std::f64::consts::PI * (1.0 / 60.0_f64).sqrt();
    assert!((time(r#", "reduce": { "modes": 0 }"#) / whole - 1.0).abs() < 1e-5);
}

#[test]
fn rows_of_supports_stay_outside_the_modes() {
    let motion = r#""supports": { "west": { "x": { "synthetic": 3 } }, "east": { "x": { "synthetic": 3 }, "delay": 0.2 } }"#;
    let text = format!(
        r#"{{ "problem": "structure", "parameters": {{ "dt": 0.002, "duration": 3 }}, "structure": {{
            "matrices": {{ "f": {{ "M": "bases.M.mtx", "K": "bases.K.mtx", "dofs": "bases.dofs.csv", "reduce": {{ "modes": 100 }} }} }},
            "contacts": {{ "gap": {{ "law": "impact", "between": ["f.122.x", "f.221.x"], "gap": 0.01, "k": 4e4 }} }},
            "loads": [{{ "at": "f.y", "sine": {{ "amplitude": 3, "omega": 11 }} }}], "start": {{ "f.x": {{ "u": 0.01 }} }}, {motion} }},
            "metrics": ["reduction_error(f.112.x)", "peak(f.112.x)", "reduction_error(gap.S)", "peak(gap.S)"] }}"#
    );
    let found = metrics(FRAMES, &text);
    // Round-off as of the other frames.
    assert!(
        found[0] < 1e-9 * found[1] && found[2] <= 1e-9 * found[3],
        "{motion}: {found:?}"
    );
}
