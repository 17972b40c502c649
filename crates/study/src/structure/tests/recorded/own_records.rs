//! Records of the command line instead of synthetic motions.

use crate::{Input, Setting, Study};
use slipgap_system::system::loads::synthetic::PEAK;

/// A mass on synthetic motions; `scale` doubles them.
const SYNTHETIC: &str = r#"{"problem": "structure",
  "parameters": {"T": [0.5, 1], "seed": {"range": [1, 20, 1]}, "filter": "omega/2", "omega": "10 + seed", "scale": 2, "dt": 0.01, "duration": 4},
  "structure": {"units": "t, kN, m, s", "masses": {"m": 1}, "springs": [{"between": ["ground", "m"], "mass": 1, "period": "T"}],
    "ground": {"synthetic": {"seed": "seed", "omega": "filter"}, "scale": "scale"}},
  "metrics": ["peak(m)"], "reductions": ["median peak(m) over seed"], "ensemble": "seed"}"#;

/// The study with settings; records are in a folder of its own.
fn study(text: &str, settings: &[&str]) -> Result<Study, String> {
    let folder = tempfile::tempdir().unwrap();
    for (name, largest) in [("a.csv", 3.0), ("b.csv", -7.0)] {
        std::fs::write(
            folder.path().join(name),
            format!("0, 0\n1, {largest}\n2, 1\n3, 0\n"),
        )
        .unwrap();
    }
    let file = folder.path().join("s.json").display().to_string();
    let settings: Vec<Setting> = settings
        .iter()
        .map(|text| Setting::new(text).unwrap())
        .collect();
    let input = Input::new(&file, text).with(&settings);
    assert!(input.uses_settings());
    input.study(1000).map_err(|error| error.to_string())
}

#[test]
fn records_of_the_command_line_take_the_place_of_seeds() {
    let both = study(SYNTHETIC, &[r#"record=["a.csv", "b.csv"]"#, "unit=g"]).unwrap();
    assert_eq!(both.len(), 4);
    let files = study(SYNTHETIC, &[r#"record={"files": "*.csv"}"#, "unit=g"]).unwrap();
    assert_eq!(files.len(), 4);
    for number in 0..4 {
        // The largest acceleration is that of the synthetic motions times the scale of the study; its time is that of the record.
        let motion = |study: &Study| {
            study
                .problem
                .as_structure()
                .unwrap()
                .ground_motion(&study.case(number).unwrap())
                .unwrap()
        };
        let ground = motion(&both).acceleration;
        let largest = ground.at(1.0).abs();
        assert!((largest - 2.0 * PEAK * 9.80665).abs() < 1e-14, "{largest}");
        assert_eq!(ground.values(), motion(&files).acceleration.values());
    }
    let settings = [r#"record=["b.csv", "a.csv"]"#, "start=[1, 0]", "unit=m/s2"];
    let first = study(SYNTHETIC, &settings).unwrap();
    assert_eq!(first.len(), 4);
    let ground = first
        .problem
        .as_structure()
        .unwrap()
        .ground_motion(&first.case(0).unwrap())
        .unwrap();
    assert_eq!(ground.acceleration.times()[0], 0.0);
    assert!(ground.acceleration.at(0.0) < -5.8);
}

#[test]
fn a_study_without_lists_of_seeds_does_not_take_records() {
    let setting = [Setting::new("record=a.csv").unwrap()];
    let takes = |text: &str| Input::new("s", text).with(&setting).uses_settings();
    assert!(takes(SYNTHETIC));
    assert!(!takes(
        &SYNTHETIC.replace(r#"{"range": [1, 20, 1]}"#, r#""round(T)""#)
    ));
    assert!(!takes(
        &SYNTHETIC.replace(r#"{"seed": "seed", "omega": "filter"}"#, "1")
    ));
    let zipped = SYNTHETIC.replace(r#""ensemble""#, r#""zip": [["T", "seed"]], "ensemble""#);
    let fault = study(&zipped, &[r#"record=["a.csv", "b.csv"]"#]).unwrap_err();
    assert!(fault.contains("seed \"seed\" is in a zip"), "{fault}");
}
