//! Measurements with faults: each has its place in the study, and the line of the file where the file is at fault.

use crate::{Bench, TWO, friction};

/// The columns of most studies here.
const COLUMNS: &str = r#""deck.u": "u", "gap.S": "S""#;

/// Ten rows at times from `from`.
fn rows(from: f64) -> String {
    let row = |i: u32| format!("{},{i},0\n", from + f64::from(i));
    format!("t,u,S\n{}", (0..10).map(row).collect::<String>())
}

/// A study with this `measured`, metrics and units; the motion ends at 9.
fn study(measured: &str, metrics: &str, units: &str) -> String {
    format!(
        r#"{{ "problem": "structure", "parameters": {{ "dt": 0.1, "duration": 9, "lag": [0, 0.5] }},
  "structure": {{ {units} "masses": {{ "deck": 1, "wall": 2 }},
    "springs": [{{ "between": ["ground", "deck"], "k": "1 + lag" }}, {{ "between": ["ground", "wall"], "k": 3 }}],
    "contacts": {{ "gap": {{ "law": "impact", "between": ["deck", "wall"], "k": 10, "gap": 0.1 }} }},
    "start": {{ "deck": {{ "v": 1 }} }} }},
  {measured} "metrics": [{metrics}] }}"#
    )
}

/// The key with these columns and more.
fn key(columns: &str, more: &str) -> String {
    format!(
        "\"measured\": {{ \"file\": \"a.csv\", \"time\": \"t\", \"columns\": {{ {columns} }}{more} }},"
    )
}

/// Runs a study in which each sign ¶ marks the place of a fault by every verb that reads it, with this file.
#[track_caller]
fn refused(file: &str, marked: &str, expected: &[&str]) {
    let (mut text, mut lines) = (String::new(), Vec::new());
    for (i, part) in marked.split('¶').enumerate() {
        if i > 0 {
            let line = text.matches('\n').count() + 1;
            let column = text.rsplit('\n').next().unwrap().chars().count() + 1;
            lines.push(format!("s.json:{line}:{column}: {}", expected[i - 1]));
        }
        text.push_str(part);
    }
    assert_eq!(lines.len(), expected.len(), "a mark for each fault");
    let bench = Bench::new();
    bench.file("s.json", text);
    bench.file("a.csv", file);
    for verb in ["run", "check", "explain"] {
        let done = bench.expect(2, &[verb, "s.json"]);
        let found: Vec<&str> = done
            .err
            .lines()
            .filter(|l| !l.starts_with("  | "))
            .collect();
        let same_count = found.len() == lines.len();
        let fit = same_count
            && found
                .iter()
                .zip(&lines)
                .all(|(found, line)| found.starts_with(line.as_str()));
        assert!(fit, "{verb}: found {found:#?}\nexpected {lines:#?}");
    }
    assert_eq!(bench.tree("."), ["a.csv", "s.json"], "nothing is written");
}

/// A study of which the file is at fault.
#[track_caller]
fn bad_file(file: &str, expected: &str) {
    let measured = key(COLUMNS, "").replace("\"a.csv", "¶\"a.csv");
    let expected = format!("measured.file: \"a.csv\": {expected}");
    refused(
        file,
        &study(&measured, "\"rms_error(deck, measured)\"", ""),
        &[&expected],
    );
}

#[test]
fn numbers_and_times_of_a_file() {
    let with = |line: &str| rows(0.0).replace("4,4,0", line);
    bad_file(&with("4,x,0"), "line 6: column \"u\": not a number: \"x\"");
    bad_file(&with("4,,0"), "line 6: column \"u\": a number is missing");
    bad_file(
        &with("4,NaN,0"),
        "line 6: column \"u\": not a finite number: \"NaN\"",
    );
    bad_file(
        &with("4,-inf,0"),
        "line 6: column \"u\": not a finite number: \"-inf\"",
    );
    bad_file(
        &with("4,1e999,0"),
        "line 6: column \"u\": not a finite number",
    );
    // The sum of squares would overflow: sprague_geers_magnitude would be -1.
    for value in ["1e300", "-1.1e100"] {
        let expected =
            format!("line 6: column \"u\": must be from -1e100 to 1e100, got \"{value}\"");
        bad_file(&with(&format!("4,{value},0")), &expected);
    }
    bad_file(&with("3,4,0"), "line 6: the times must rise, got 3 after 3");
    bad_file(
        &with("4,4"),
        "line 6: a row must have a number for each of the 3 columns, got 2",
    );
    bad_file("", "line 1: the file must begin with a line of names");
    bad_file(
        &rows(0.0).replace("S\n", "S,u\n").replace(",0\n", ",0,0\n"),
        "line 1: two columns have the name \"u\"",
    );
    bad_file(
        "t,u,S\n0,1,2\n1,1,2\n",
        "2 rows of numbers; allowed: at least 10",
    );
}

#[test]
fn columns_that_a_file_does_not_have() {
    let metrics = "\"rms_error(deck, measured)\"";
    let columns = r#""deck.u": ¶"disp", "gap.S": { "column": ¶"s" }"#;
    refused(
        &rows(0.0).replace("u,S", "disp_mm,S"),
        &study(&key(columns, ""), metrics, ""),
        &[
            "measured.columns.deck.u: \"a.csv\": line 1: no column \"disp\"; the columns are \"t\", \"disp_mm\", \"S\", did you mean \"disp_mm\"?",
            "measured.columns.gap.S.column: \"a.csv\": line 1: no column \"s\"",
        ],
    );
    let measured = key(COLUMNS, "").replace("\"t\"", "¶\"time\"");
    refused(
        &rows(0.0),
        &study(&measured, metrics, ""),
        &["measured.time: \"a.csv\": line 1: no column \"time\""],
    );
    let measured = key(COLUMNS, "").replace("\"a.csv", "¶\"b.csv");
    refused(
        &rows(0.0),
        &study(&measured, metrics, ""),
        &["measured.file: \"b.csv\": cannot read "],
    );
}

#[test]
fn times_without_a_motion() {
    let measured = |more: &str| key(COLUMNS, more).replace("\"a.csv", "¶\"a.csv");
    let metrics = "\"rms_error(deck, measured)\"";
    refused(
        &rows(20.0),
        &study(&measured(""), metrics, ""),
        &[
            "measured.file: \"a.csv\" has times from 20 to 29, the motion from 0 to 9: 0 of its points are within the motion; allowed: at least 10",
        ],
    );
    refused(
        &rows(0.0),
        &study(&measured(", \"delay\": \"lag\""), metrics, ""),
        &[
            "measured.file: \"a.csv\" has times from 0 to 9, the motion from 0 to 9, with every delay from 0 to 0.5: 9 of its points are",
        ],
    );
    refused(
        &rows(0.0),
        &study(&measured(", \"delay\": -1"), metrics, ""),
        &[
            "measured.file: \"a.csv\" has times from 0 to 9, the motion from 0 to 9, with a delay of -1: 9 of its points are",
        ],
    );
    let measured = key(COLUMNS, ", \"delay\": ¶\"log\"");
    refused(
        &rows(0.0),
        &study(&measured, metrics, ""),
        &["measured.delay: \"log\": "],
    );
}

#[test]
fn units_of_columns() {
    let metrics = "\"rms_error(deck, measured)\"";
    let bad = |columns: &str, units: &str, expected: &[&str]| {
        refused(
            &rows(0.0),
            &study(&key(columns, ""), metrics, units),
            expected,
        );
    };
    let si = "\"units\": \"t, kN, m, s\",";
    bad(
        r#""deck.u": { "column": "u", "unit": ¶"kN" }, "gap.S": { "column": "S", "unit": ¶"mm" }"#,
        si,
        &[
            "measured.columns.deck.u.unit: must be a unit of a length, got \"kN\", one of a force; allowed: m, mm, cm, km, ft, in",
            "measured.columns.gap.S.unit: must be a unit of a force, got \"mm\", one of a length; allowed: N, kN, MN",
        ],
    );
    bad(
        r#""deck.v": { "column": "u", "unit": ¶"m/h" }, "deck.a": { "column": "u", "unit": ¶"m/s" }"#,
        si,
        &[
            "measured.columns.deck.v.unit: unknown unit \"m/h\" of a velocity; allowed: one of m, mm,",
            "measured.columns.deck.a.unit: must be a unit of an acceleration, got \"m/s\", one of a velocity; allowed: g, or",
        ],
    );
    bad(
        r#""deck.u": { "column": "u", "unit": ¶"mm" }"#,
        "",
        &["measured.columns.deck.u.unit: needs \"units\" in \"structure\""],
    );
    bad(
        r#""deck.u": { "column": "u", "unit": ¶"mm" }"#,
        "\"units\": \"t, kN, ell, s\",",
        &["measured.columns.deck.u.unit: the study's unit of a length, \"ell\", is not known"],
    );
    bad(
        r#""deck.u": { "column": "u", "unit": "mm" }, "gap.S": { "column": "S", "units": ¶"kN" }, "wall.u": ¶3"#,
        si,
        &[
            "measured.columns.gap.S.units: unknown key \"units\", did you mean \"unit\"?",
            "measured.columns.wall.u: must be the name of a column, or an object with column and unit, got 3",
        ],
    );
}

#[test]
fn channels_and_keys() {
    let metrics = "\"peak(deck)\"";
    let bad = |measured: &str, expected: &[&str]| {
        refused(&rows(0.0), &study(measured, metrics, ""), expected);
    };
    bad(
        &key(r#"¶"dekc.u": "u", "gap.S": "S", ¶"gap": "u""#, ""),
        &[
            "measured.columns.dekc.u: \"dekc.u\": no node or contact 'dekc.u'; channels are u, v",
            "measured.columns.gap: \"gap\": 'gap' is a contact",
        ],
    );
    bad(
        &key(r#""deck": "u", ¶"deck.u": "S""#, ""),
        &["measured.columns.deck.u: \"deck.u\" is given twice, as deck"],
    );
    bad(
        &key(COLUMNS, ", \"delays\": ¶1"),
        &["measured.delays: unknown key \"delays\", did you mean \"delay\"?"],
    );
    bad(
        "\"measured\": ¶{ \"file\": \"a.csv\", \"time\": \"t\" },",
        &["measured.columns: missing: "],
    );
    let empty = key("", "").replace("{  }", "¶{}");
    bad(
        &empty,
        &["measured.columns: must be an object with a column for each channel"],
    );
    bad("\"measured\": ¶3,", &["measured: must be an object"]);
    refused(
        "",
        &friction(TWO, ", \"measured\": ¶{}"),
        &["measured: only a study with \"problem\": \"structure\" compares with measurements"],
    );
}

#[test]
fn metrics_of_what_was_not_measured() {
    let bad = |measured: &str, metrics: &str, expected: &[&str]| {
        refused(&rows(0.0), &study(measured, metrics, ""), expected);
    };
    bad(
        "",
        "¶\"rms_error(deck, measured)\"",
        &["metrics[0]: \"rms_error(deck, measured)\" needs the key \"measured\" of the study"],
    );
    bad(
        &key(COLUMNS, ""),
        r#"¶"rms_error(wall.v, measured)", ¶"energy_per_cycle(gap, measured)", ¶"loop_distance(gap.r, gap.S, measured)""#,
        &[
            "metrics[0]: \"rms_error(wall.v, measured)\": wall.v is not among the columns of \"measured\"; there are deck.u, gap.S",
            "metrics[1]: \"energy_per_cycle(gap, measured)\": gap.r is not among the columns",
            "metrics[2]: \"loop_distance(gap.r, gap.S, measured)\": gap.r is not among the columns",
        ],
    );
    bad(
        &key(COLUMNS, ""),
        r#"¶"peak(deck, measured)", ¶"sprague_geers_phase(deck)", ¶"loop_distance(deck, measured)", ¶"loop_distance(deck, gap.S)""#,
        &[
            "metrics[0]: \"peak(deck, measured)\": peak does not compare with what was measured; these do: rms_error, last_error,",
            "metrics[1]: \"sprague_geers_phase(deck)\": sprague_geers_phase compares with what was measured: sprague_geers_phase(CHANNEL, measured)",
            "metrics[2]: \"loop_distance(deck, measured)\": loop_distance compares a loop of two channels",
            "metrics[3]: \"loop_distance(deck, gap.S)\": loop_distance compares a loop of two channels",
        ],
    );
}
