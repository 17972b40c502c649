//! A page with 100 000 cases: filter and sort use all of them.

use super::browser::{chromium, probe};
use super::data::{Cell, data};
use super::packed::{scripts, unpacked};
use super::page_of;
use std::fs;
use std::path::Path;
use std::sync::LazyLock;
use tempfile::TempDir;

/// 50 000 values of beta, the first axis, so that the first 20 000 cases have no beta above 0.1. With x0 = 0.5 there is no
/// motion, and work_error is undefined.
const STUDY: &str = r#"{ "problem": "friction-oscillator", "parameters": { "law": "velocity-control",
  "beta": { "linspace": [0.001, 0.4, 50000] }, "x0": [3, 0.5], "dT": "pi/10", "duration": "2*pi" },
  "figures": [ { "name": "curve", "title": "Every beta", "kind": "metric", "x": "beta", "y": "rms_error", "where": { "x0": 3 } } ],
  "checks": [ { "metric": "rms_error", "max": 10 } ] }
"#;

/// beta = 0.001 + 0.399 i/49999 > 0.1 from i = 12406 on (0.099 49999/0.399 = 12405.9), for two x0.
const OVER: usize = 2 * (50_000 - 12_406);

/// The folder, the page, and results.csv of the same study.
static REPORT: LazyLock<(TempDir, String, Table)> = LazyLock::new(|| {
    let (folder, page) = page_of(STUDY, &["run", "report"]);
    let table = table(&folder.path().join("out/s/results.csv"));
    (folder, page, table)
});

/// Header and rows of a table of texts.
type Table = (Vec<String>, Vec<Vec<String>>);

fn table(file: &Path) -> Table {
    let text = fs::read_to_string(file).unwrap();
    let row = |line: &str| line.split(',').map(String::from).collect();
    let mut lines = text.lines();
    (row(lines.next().unwrap()), lines.map(row).collect())
}

#[test]
fn every_cell_of_results_csv_is_in_the_page() {
    let (_, page, (header, rows)) = &*REPORT;
    let data = data(page);
    assert_eq!((rows.len(), &data.head["rows"]), (100_000, &100_000.into()));
    assert!(data.head["limit"].is_null());
    let names = data.columns.iter().map(|column| &column.0);
    assert!(header[1..].iter().eq(names));
    for (number, (name, cells)) in data.columns.iter().enumerate() {
        let same = |(cell, row): (&Option<Cell>, &Vec<String>)| match cell {
            None => row[number + 1].is_empty(),
            Some(Cell::Name(name)) => row[number + 1] == *name,
            Some(Cell::Number(x)) => {
                row[number + 1].parse::<f64>().unwrap().to_bits() == x.to_bits()
            }
        };
        assert!(cells.iter().zip(rows).all(same), "{name}");
        let varies = cells.iter().any(|cell| *cell != cells[0]);
        assert_eq!(data.head["columns"][number]["varies"], varies, "{name}");
    }
}

#[test]
fn points_and_checks_of_many_cases_do_not_enlarge_the_page() {
    let (_, page, (header, rows)) = &*REPORT;
    // At most eight bytes for a cell, and four letters for three bytes. A third of the columns have one value.
    let cells = header.len() * rows.len() * 8 / 3 * 4;
    assert!(page.len() < 2 * cells / 3, "{} bytes", page.len());
    assert!(
        page.contains("Checks: 100000 of 100000 met") && !unpacked(page).contains("limits</th>")
    );
    assert!(page.contains("Every beta"));
    // The curve of 50 000 points has fewer bytes than points.
    let is_drawing = |script: &Vec<u8>| script.starts_with(b"<svg ");
    let drawings: Vec<Vec<u8>> = scripts(page).into_iter().filter(is_drawing).collect();
    let [drawing] = &drawings[..] else {
        panic!("{} drawings", drawings.len());
    };
    assert!(drawing.len() < 1_000_000, "{}", drawing.len());
    let packed: Vec<usize> = page
        .split("<script type=\"text/plain\">")
        .filter_map(|part| part.split_once('<'))
        .map(|(text, _)| text.len())
        .collect();
    assert!(
        packed.iter().any(|len| (1000..50_000).contains(len)),
        "{packed:?}"
    );
}

const PROBE: &str = r#"
probe.begun = count();
probe.over = [typed("beta>0.1"), typed("beta > 0.1"), typed("beta>0.1 x0==3")];
probe.undefined = [typed("work_error=undefined"), typed("work_error!=undefined")];
probe.name = typed("velocity");
probe.absent = typed("law=displacement-control");
probe.faults = ["bta>0.1", "bta", "beta", "beta>", "beta>abc", "law>a", "law=velocity"].map(typed);
probe.faulty = root.querySelector("[type=search]").getAttribute("aria-invalid");
probe.rows = root.querySelectorAll("tbody tr").length;
type("");
sort("rms_error");
probe.best = values("rms_error");
probe.first = values("case")[0];
sort("rms_error");
probe.worst = values("rms_error");
type("beta>0.1");
probe.over_worst = values("rms_error")[0];
type("case<4");
sort("work_error");
probe.last = [values("case"), values("work_error")];
sort("work_error");
probe.falling = [values("case"), values("work_error")];
"#;

#[test]
fn in_a_browser_filter_and_sort_use_every_case() {
    let Some(program) = chromium() else { return };
    let (folder, page, (header, rows)) = &*REPORT;
    let probe = probe(&program, folder.path(), page, PROBE);
    let column_of = |name: &str| header.iter().position(|known| known == name).unwrap();
    let number = |row: &[String], name: &str| row[column_of(name)].parse::<f64>().unwrap();
    assert_eq!(
        rows.iter().filter(|row| number(row, "beta") > 0.1).count(),
        OVER
    );
    let found = |cases: usize| format!("1 to 100 of {cases} cases");
    assert_eq!(probe["begun"], found(100_000));
    assert_eq!(
        probe["over"],
        serde_json::json!([found(OVER), found(OVER), found(OVER / 2)])
    );
    assert_eq!(
        probe["undefined"],
        serde_json::json!([found(50_000), found(50_000)])
    );
    assert_eq!(probe["name"], found(100_000));
    assert_eq!(probe["absent"], "no case");
    // A fault names the wrong word and the allowed ones.
    let faults: Vec<&str> = probe["faults"]
        .as_array()
        .unwrap()
        .iter()
        .map(|fault| fault.as_str().unwrap())
        .collect();
    let columns = header.join(", ");
    assert_eq!(
        faults[0],
        format!("No column is called “bta”. The columns are {columns}")
    );
    assert_eq!(
        faults[1],
        format!(
            "“bta” is neither a name in this table nor a comparison. The columns are {columns}"
        )
    );
    assert_eq!(
        faults[2..],
        [
            "beta is a column: compare it with a value, as in beta>0.1",
            "“beta>” is not a comparison: write column, sign, value, as in beta>0.1",
            "“abc” is not a number, but beta has numbers as values",
            "law has names for values: compare it by = or !=",
            "law is never “velocity”. Its values are displacement-control, velocity-control, coulomb, tanh, stribeck, stribeck-hyperbolic, bouc-wen, dahl, lugre",
        ]
    );
    assert_eq!(
        (&probe["faulty"], &probe["rows"]),
        (&"true".into(), &0.into())
    );
    // The hundred smallest and largest of all.
    let mut errors: Vec<(f64, usize)> = rows
        .iter()
        .map(|row| (number(row, "rms_error"), number(row, "case") as usize))
        .collect();
    errors.sort_by(|a, b| a.partial_cmp(b).unwrap());
    let values = |name: &str| -> Vec<f64> {
        let list = probe[name].as_array().unwrap().iter();
        list.map(|text| text.as_str().unwrap().parse().unwrap())
            .collect()
    };
    assert!(
        values("best")
            .iter()
            .eq(errors[..100].iter().map(|(error, _)| error))
    );
    assert_eq!(probe["first"], errors[0].1.to_string());
    assert!(
        values("worst")
            .iter()
            .eq(errors[99_900..].iter().rev().map(|(error, _)| error))
    );
    let over = rows.iter().filter(|row| number(row, "beta") > 0.1);
    let worst = over.map(|row| number(row, "rms_error")).fold(0.0, f64::max);
    assert_eq!(
        probe["over_worst"]
            .as_str()
            .unwrap()
            .parse::<f64>()
            .unwrap(),
        worst
    );
    // Cases 1 and 3 have no work_error: they are last in both directions.
    let work = |case: usize| rows[case][column_of("work_error")].clone();
    let rising = number(&rows[0], "work_error") < number(&rows[2], "work_error");
    for (name, zero_first) in [("last", rising), ("falling", !rising)] {
        let [a, b] = if zero_first { [0, 2] } else { [2, 0] };
        let cases = serde_json::json!([a.to_string(), b.to_string(), "1", "3"]);
        assert_eq!(probe[name][0], cases, "{name}");
        assert_eq!(
            probe[name][1],
            serde_json::json!([work(a), work(b), "", ""]),
            "{name}"
        );
    }
}
