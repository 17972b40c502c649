//! Files as agencies and programs write them, made by formulas; no recorded motion.

use super::*;

fn with(text: &str, reading: Reading) -> Result<Record, String> {
    parse("f", text.as_bytes(), reading).map_err(|fault| fault.to_string())
}

fn refused(text: &str, reading: Reading) -> String {
    with(text, reading).unwrap_err()
}

fn of(dt: Option<f64>, column: Option<usize>) -> Reading {
    Reading {
        dt,
        column,
        ..Reading::default()
    }
}

/// A decaying sine, `count` values 0.005 apart.
fn wave(count: usize) -> Vec<f64> {
    let value = |i: usize| {
        let t = i as f64 * 0.005;
        (-t).exp() * (14.0 * t).sin()
    };
    (0..count).map(value).collect()
}

/// Values in rows of `width`.
fn rows(values: &[f64], width: usize) -> String {
    let row = |row: &[f64]| row.iter().map(|a| format!("{a:15.7e}")).collect::<String>() + "\n";
    values.chunks(width).map(row).collect()
}

/// An AT2 file of a wave in rows of five.
fn wrapped(values: &[f64]) -> String {
    at2(
        &format!("NPTS= {}, DT= .0050 SEC", values.len()),
        &rows(values, 5),
    )
}

#[test]
fn rows_of_a_format_are_one_column_with_the_step_of_the_header() {
    let text = wrapped(&wave(101));
    let record = read(&text);
    assert_eq!(record.times[100], 0.5);
    for reading in [
        of(Some(0.005), None),
        of(Some(0.005), Some(1)),
        of(None, Some(1)),
        of(Some(1.0 / 200.0), Some(1)),
    ] {
        assert_eq!(with(&text, reading).as_ref(), Ok(&record));
    }
    for (reading, fault) in [
        (
            of(Some(0.01), Some(1)),
            "f:4: dt is 0.01, but 0.005 by DT of line 4; give 0.005",
        ),
        (
            of(Some(0.005), Some(2)),
            "f:1: the file is PEER AT2, whose rows are one series, which is column 1; give 1 or no column, got 2",
        ),
    ] {
        assert_eq!(refused(&text, reading), fault);
    }
    let shorter = text.replace("NPTS= 101", "NPTS= 100");
    let fault = "f:25: more numbers than NPTS of line 4, 100";
    assert_eq!(refused(&shorter, of(Some(0.005), Some(1))), fault);
    // A table of NPTS rows is no such series.
    let table = "NPTS= 4, DT= 0.5\n0.0 1 5\n0.5 2 6\n1.0 3 7\n1.5 4 8\n";
    assert_eq!(
        with(table, of(None, Some(3))).unwrap().values,
        [5.0, 6.0, 7.0, 8.0]
    );
    let fault = refused(&table.replace("NPTS= 4", "NPTS= 5"), of(None, Some(3)));
    assert_eq!(fault, "f:1: the table has 4 rows, but NPTS of line 1 is 5");
}

#[test]
fn rows_of_one_series_are_no_columns_without_a_header_either() {
    let values = wave(100);
    let text = rows(&values, 5);
    let fault = refused(&text, of(Some(0.005), Some(1)));
    assert!(
        fault.starts_with("f:1: the rows look like one series in rows of 5 numbers"),
        "{fault}"
    );
    let fault = refused(&rows(&values[..98], 5), of(Some(0.005), Some(2)));
    assert!(
        fault.starts_with("f:20: a row must have as many numbers as that of line 1, 5, got 3"),
        "{fault}"
    );
    for dt in [None, Some(0.005)] {
        let fault = refused(&text, of(dt, None));
        assert!(
            fault.contains("one series of numbers, not like columns")
                && !fault.contains("\"column\""),
            "{fault}"
        );
    }
    // Three components of one motion, and two of them alike, are columns.
    let columns: String = (0..100)
        .map(|i| {
            format!(
                "{} {} {}\n",
                values[i],
                0.3 * values[(i * 7 + 20) % 100],
                0.99 * values[i]
            )
        })
        .collect();
    let second = with(&columns, of(Some(0.005), Some(3))).unwrap();
    assert_eq!(second.values[50], 0.99 * values[50]);
    assert!(
        refused(&columns, of(Some(0.005), None)).ends_with("of several columns give \"column\"")
    );
    // Names make columns of any numbers.
    let named = format!("a b c d e\n{text}");
    assert_eq!(
        with(&named, of(Some(0.005), Some(1))).unwrap().values[1],
        read_number(&text, 5)
    );
}

/// The number at a place of a text.
fn read_number(text: &str, index: usize) -> f64 {
    text.split_whitespace().nth(index).unwrap().parse().unwrap()
}

/// The header of ESM, shortened, before numbers.
fn esm(values: &[f64], unit: &str) -> String {
    format!(
        "EVENT_NAME: NOWHERE\nVS30_M/S: 300\nSAMPLING_INTERVAL_S: 0.005000\nNDATA: {}\nUNITS: {unit}\nPGA_CM/S^2: -0.2\n\
         DATA_TYPE: ACCELERATION\n{}",
        values.len(),
        rows(values, 1)
    )
}

#[test]
fn a_header_of_any_table_agrees_with_the_study_and_the_rows() {
    let values = wave(20);
    let text = esm(&values, "cm/s^2");
    let record = with(&text, of(Some(0.005), None)).unwrap();
    assert_eq!(record.unit, Some(Unit::CentimetrePerSecond2));
    assert_eq!((record.times.len(), record.times[19]), (20, 19.0 * 0.005));
    let by = "SAMPLING_INTERVAL_S of line 3";
    assert_eq!(
        refused(&text, of(Some(0.01), None)),
        format!("f:3: dt is 0.01, but 0.005 by {by}; give 0.005")
    );
    assert_eq!(
        refused(
            &text.replace("NDATA: 20", "NDATA: 21"),
            of(Some(0.005), None)
        ),
        "f:4: the table has 20 rows, but NDATA of line 4 is 21"
    );
    // The header has all.
    assert_eq!(with(&text, Reading::default()).as_ref(), Ok(&record));
    let few = text
        .replace("VS30_M/S", "x")
        .replace("NDATA", "N")
        .replace("DATA_TYPE", "x")
        .replace("PGA_CM/S^2", "y");
    let by = "sampling interval s of line 3";
    let fault = refused(&few, Reading::default());
    assert!(
        fault.contains(&format!("{by} states a time step: give \"dt\": 0.005")),
        "{fault}"
    );
    assert_eq!(
        refused(&esm(&values, "cm/s"), of(Some(0.005), None)),
        "f:5: the file has a velocity; it must have an acceleration"
    );
    for (header, unit) in [
        (
            "#SampleRate(Hz): 200\n#AmplitudeUnit:  gal. DCoffset(corr)",
            Some(Unit::CentimetrePerSecond2),
        ),
        (
            "SAMPLES/SEC=200 FILTER TYPE=X\nNO OF POINTS=  20, UNITS=CM/SEC**2",
            Some(Unit::CentimetrePerSecond2),
        ),
        (
            "INTERVALO DE MUESTREO, C1-C6 (s)       : /0.005/0.005\nUNIDADES DE LOS DATOS : Gal (cm/s/s)",
            Some(Unit::CentimetrePerSecond2),
        ),
        ("Sampling interval (ms): 5", None),
        ("time step 0.005 s", None),
    ] {
        let text = format!("{header}\n{}", rows(&values, 1));
        assert_eq!(
            with(&text, of(Some(0.005), None)).unwrap().unit,
            unit,
            "{header}"
        );
        let fault = refused(&text, of(Some(0.02), None));
        assert!(fault.contains("dt is 0.02, but 0.005 by"), "{fault}");
        // Times, too, are those of the header.
        let timed: String = (0..20)
            .map(|i| format!("{} {}\n", f64::from(i) * 5.0, values[i as usize]))
            .collect();
        let fault = refused(
            &format!("{header}\n{timed}").replace("=  20", "= 20"),
            Reading::default(),
        );
        assert!(fault.contains("the times are 5 apart, but"), "{fault}");
    }
}

#[test]
fn a_step_against_the_header_is_refused_in_every_format() {
    let knet = knet(["100Hz", "0.04", "2000(gal)/8000"], "104 96 100 100\n");
    let smc = formats::smc("2 CORRECTED ACCELEROGRAM", 4.0, 100.0, "1 2 3 4\n");
    let geonet = formats::geonet("Up", 3.0, 0.01, " 1 2 3\n");
    let cosmos = formats::cosmos("Corrected acceleration", 10.0, formats::COSMOS_V2);
    for text in [knet, smc, geonet, cosmos] {
        let record = read(&text);
        assert_eq!(with(&text, of(Some(0.01), Some(1))), Ok(record));
        let fault = refused(&text, of(Some(0.02), None));
        assert!(fault.contains("dt is 0.02, but 0.01 by"), "{fault}");
        let fault = refused(&text, of(None, Some(2)));
        assert!(
            fault.contains("whose rows are one series") && fault.ends_with("got 2"),
            "{fault}"
        );
    }
    // A table of times, too.
    let table = "t (s),x (m/s2),y (m/s2)\n".to_owned()
        + &(0..9)
            .map(|i| format!("{},1,2\n", f64::from(i) * 0.5))
            .collect::<String>();
    assert_eq!(
        with(&table, of(Some(0.5), Some(3))).unwrap().values,
        [2.0; 9]
    );
    let fault = refused(&table, of(Some(0.1), Some(3)));
    assert_eq!(
        fault,
        "f:1: dt is 0.1, but 0.5 by the times of column 1; give 0.5"
    );
}

#[test]
fn one_phrase_makes_no_format() {
    for header in [
        "Scale Factor 1.5",
        "Corrected accelerogram of my shaking table",
        "1 Corrected acceleration (m/s2)",
        "Scale Factor      2000(gal)/8000\nStation Code      X",
    ] {
        let text = format!("{header}\n0 1\n1 2\n");
        assert_eq!(
            with(&text, Reading::default()).unwrap().values,
            [1.0, 2.0],
            "{header}"
        );
    }
}

#[test]
fn a_velocity_is_no_acceleration_whatever_the_unit_of_the_study() {
    for (text, line, quantity) in [
        (
            "VELOCITY TIME HISTORY IN UNITS OF CM/SEC\n0 1\n1 2\n",
            1,
            "velocity",
        ),
        ("x\nVelocity, cm/sec\n0 1\n1 2\n", 2, "velocity"),
        ("t (s),v (m/s)\n0,1\n1,2\n", 1, "velocity"),
        ("t (s);u (mm)\n0;1\n1;2\n", 1, "displacement"),
        ("DISPLACEMENT (CM)\n0 1\n1 2\n", 1, "displacement"),
        (
            "x\nVELOCITY, CM/SEC\nx\nNPTS= 2, DT= .01\n1 2\n",
            2,
            "velocity",
        ),
        ("Units: cm/sec\n0 1\n1 2\n", 1, "velocity"),
    ] {
        let fault = format!("f:{line}: the file has a {quantity}; it must have an acceleration");
        assert_eq!(refused(text, Reading::default()), fault, "{text}");
    }
    for text in [
        "shear wave velocity 300 m/s\n0 1\n1 2\n",
        "Vs30 (m/s): 300\n0 1\n1 2\n",
        "velocity 3, displacement 4, acceleration 5\n0 1\n1 2\n",
        "displacement control of the table\nt,a\n0,1\n1,2\n",
        "Units: m, s\n0 1\n1 2\n",
        "Unit G, building 5\n0 1\n1 2\n",
        "t (s),a (m/s2),v (m/s)\n0,1,7\n1,2,7\n",
    ] {
        let column = text.contains("7\n").then_some(2);
        assert_eq!(
            with(text, of(None, column)).unwrap().values,
            [1.0, 2.0],
            "{text}"
        );
    }
}

#[test]
fn ends_quotes_and_encodings_of_other_programs_are_read() {
    let wanted = read("0.0 1.5\n0.1 2.5\n");
    for text in [
        "0.0 1.5\n0.1 2.5\nEND OF DATA\n",
        "0.0 1.5\n0.1 2.5\n*** End Data ***\n\n",
        "0.0 1.5\r\n0.1 2.5\r\n\u{1a}",
        "\"t\",\"a\"\n\"0.0\",\"1.5\"\n\"0.1\",\"2.5\"\n",
        "\"0.0\";\"1.5\"\r\"0.1\";\"2.5\"\r",
        "*****\n0.0 1.5\n0.1 2.5\n",
    ] {
        assert_eq!(
            with(text, Reading::default()).as_ref(),
            Ok(&wanted),
            "{text}"
        );
        let wide: Vec<u8> = "\u{feff}"
            .encode_utf16()
            .chain(text.encode_utf16())
            .flat_map(u16::to_le_bytes)
            .collect();
        assert_eq!(parse("f", &wide, Reading::default()).as_ref(), Ok(&wanted));
    }
    let text = at2("NPTS= 3, DT= .01 SEC", "1 2 3\nEND OF DATA\n");
    assert_eq!(read(&text).values, [1.0, 2.0, 3.0]);
    assert_eq!(
        super::refused(&(text + "4 5\n")),
        "f:7: numbers after line 6, which says that they end; a file must have one record"
    );
    assert_eq!(
        super::refused("0 1\n1 2\nend\n2 3\n"),
        "f:4: numbers after line 3, which says that they end; a file must have one record"
    );
}

#[test]
fn a_decimal_comma_is_named() {
    for (text, line, shown, dt) in [
        ("t;a\n0,002;1\n", 2, "0,002", None),
        ("0,00 1,5\n0,01 1,5\n", 1, "0,00", None),
        ("t\ta\n0,01\t1,5\n", 2, "0,01", None),
        ("0,002\n0,004\n", 1, "0,002", Some(0.01)),
        ("1,5\n2,07\n", 2, "2,07", Some(0.01)),
        ("\"0,5\",\"1,5\"\n", 1, "0,5", None),
        ("t,a\n0,002,1,5\n", 2, "0,002", None),
    ] {
        for column in [None, Some(2 - usize::from(dt.is_some()))] {
            let fault = format!("f:{line}: numbers must have decimal points, got \"{shown}\"");
            assert_eq!(
                refused(text, of(dt, column)).split("; the file").next(),
                Some(&*fault),
                "{text}"
            );
        }
    }
    assert_eq!(read("0,1\n1,2\n").values, [1.0, 2.0]);
}
