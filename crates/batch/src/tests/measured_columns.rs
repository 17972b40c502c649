//! The columns of what was measured in the table of a history.

use crate::output::failures_and_histories::write_history;
use slipgap_study::read;

/// The time of the file that is t = 0 of the motion.
const DELAY: f64 = 0.5;

/// Displacement in mm and force in N at a time of the file.
fn at(time: f64) -> [f64; 2] {
    [40.0 - 25.0 * time, 300.0 * time * time]
}

const STUDY: &str = r#"{ "problem": "structure",
    "parameters": { "k": [20, 30], "dt": 0.01, "duration": 1.5 },
    "measured": { "file": "a.csv", "time": "t", "delay": 0.5,
      "columns": { "m": { "column": "disp_mm", "unit": "mm" }, "pad.r": { "column": "disp_mm", "unit": "mm" },
                   "pad.S": { "column": "force_N", "unit": "N" } } },
    "structure": { "units": "t, kN, m, s", "masses": { "m": 1, "other": 1 },
      "springs": [{ "between": ["ground", "m"], "k": "k" }, { "between": ["ground", "other"], "k": 5 }],
      "contacts": { "pad": { "law": "displacement-control", "between": ["ground", "m"], "limit": 0.2, "rE": 0.01 } },
      "start": { "m": { "u": 0.1 }, "other": { "u": 0.1 } } },
    "metrics": ["rms_error(m, measured)"] }"#;

#[test]
fn a_table_has_measured_columns_at_the_steps() {
    let folder = tempfile::tempdir().unwrap();
    // A file that begins and ends within the motion, at uneven times.
    let times: Vec<f64> = (0..60)
        .map(|i| f64::from(i) * (0.03 + 0.0005 * f64::from(i)))
        .filter(|t| (0.1..=0.9).contains(&(t - DELAY)))
        .collect();
    let row = |t: &f64| {
        let [u, s] = at(*t);
        format!("{t:e},{u:e},{s:e}\n")
    };
    let rows: String = times.iter().map(row).collect();
    let file = folder.path().join("a.csv");
    std::fs::write(file, format!("t,disp_mm,force_N\n{rows}")).unwrap();
    let path = folder.path().join("s.json");
    std::fs::write(&path, STUDY).unwrap();
    let study = read(&path).unwrap();
    let case = study.case(0).unwrap();
    let solution = study.problem.solve(&case, &[]).unwrap();
    let mut bytes = Vec::new();
    write_history(&study, &case, &solution, &mut bytes).unwrap();
    let text = String::from_utf8(bytes).unwrap();
    let mut rows = text.lines().map(|line| line.split(',').collect::<Vec<_>>());
    let header = rows.next().unwrap();
    let offset = header.len() - 3;
    let ends = &header[offset..];
    assert_eq!(ends, ["m_measured", "pad.r_measured", "pad.S_measured"]);
    let [first, last] = [times[0], times[times.len() - 1]].map(|t| t - DELAY);
    let mut inside = 0;
    for row in rows {
        assert_eq!(row.len(), header.len());
        let t: f64 = row[0].parse().unwrap();
        match (first..=last).contains(&t) {
            // The displacement is a straight line, so that it is this between the points, too.
            true => {
                inside += 1;
                let measured: f64 = row[offset].parse().unwrap();
                assert!((measured - 1e-3 * at(t + DELAY)[0]).abs() < 1e-14);
            }
            false => assert_eq!(row[offset], "", "{t}"),
        }
    }
    assert!((70..=80).contains(&inside), "{inside}");
}
