//! Hand-written files of each format; no recorded motion.

mod agencies;
mod formats;
mod people;

use super::*;
use proptest::prelude::*;

/// A text of a file named `f`, read so, or its fault as displayed.
fn with(text: &str, reading: Reading) -> Result<Record, String> {
    parse("f", text.as_bytes(), reading).map_err(|fault| fault.to_string())
}

fn read(text: &str) -> Record {
    with(text, Reading::default()).unwrap()
}

fn refused(text: &str) -> String {
    with(text, Reading::default()).unwrap_err()
}

/// The n-th component.
fn component(number: usize) -> Reading {
    Reading {
        component: Some(number),
        ..Reading::default()
    }
}

/// An AT2 file with this fourth line and these rows.
fn at2(fourth: &str, rows: &str) -> String {
    format!(
        "PEER NGA STRONG MOTION DATABASE RECORD\nNowhere-01, 1/1/2000, Hand Written, 90\n\
         ACCELERATION TIME SERIES IN UNITS OF G\n{fourth}\n{rows}"
    )
}

/// A K-NET file with this frequency, duration, scale factor and rows.
fn knet([frequency, duration, scale]: [&str; 3], rows: &str) -> String {
    format!(
        "Origin Time       2000/01/01 00:00:00\nLat.              0\nLong.             0\nDepth. (km)       0\n\
         Mag.              0\nStation Code      NONE\nStation Lat.      0\nStation Long.     0\n\
         Station Height(m) 0\nRecord Time       2000/01/01 00:00:15\nSampling Freq(Hz) {frequency}\n\
         Duration Time(s)  {duration}\nDir.              N-S\nScale Factor      {scale}\n\
         Max. Acc. (gal)   1\nLast Correction   2000/01/01 00:00:00\nMemo.\n{rows}"
    )
}

#[test]
fn every_spelling_of_npts_and_dt_is_read() {
    for fourth in [
        "NPTS=  7, DT= .005 SEC",
        "NPTS=   7, DT=   .0050 SEC,",
        "NPTS=7,DT=.005SEC",
        "NPTS = 7 , DT = 0.005 sec",
        "npts= 7 dt= 5.0D-03 sec.",
        "   7    0.0050   NPTS, DT",
        "   7    0.0050   NPTS,DT,SEC",
        "  7, .005, npts dt",
        "DT= .005, NPTS= 7",
        "NPTS: 7; DT: 0.005; FILTER 0.1",
    ] {
        let record = read(&at2(fourth, " .1E-01 -.2E-01 3D-2 4.d+0 5\n\n -6.25 +7.\n"));
        // i DT, as the header has it.
        let times: Vec<f64> = (0..7).map(|i| f64::from(i) * 0.005).collect();
        assert_eq!(record.times, times, "{fourth}");
        assert_eq!(record.values, [0.01, -0.02, 0.03, 4.0, 5.0, -6.25, 7.0]);
        assert_eq!(record.unit, Some(Unit::G));
    }
}

#[test]
fn at2_rows_of_eight_may_have_no_blank_before_a_sign() {
    let text = at2(
        "NPTS= 9, DT= .01 SEC",
        "-0.1000000-0.2000000 0.3000000-.4E-01+.5E+01 6 7 8\r\n-1.-2\r\n",
    );
    let fault = refused(&text);
    assert_eq!(fault, "f:6: more numbers than NPTS of line 4, 9");
    let record = read(&text.replace("-1.-2", "-1."));
    assert_eq!(
        record.values,
        [-0.1, -0.2, 0.3, -0.04, 5.0, 6.0, 7.0, 8.0, -1.0]
    );
}

#[test]
fn an_at2_header_may_have_another_unit_another_place_or_other_letters() {
    let text = at2("NPTS= 2, DT= 1", "1 2");
    let unit = |of: &str| read(&text.replace("OF G", of)).unit;
    assert_eq!(unit("OF CM/S/S. FILTER"), Some(Unit::CentimetrePerSecond2));
    assert_eq!(unit("OF m/s2"), Some(Unit::MetrePerSecond2));
    assert_eq!(unit("OF G. FILTER POINTS: HP=0.1 Hz"), Some(Unit::G));
    assert_eq!(unit("OF MM/S/S"), Some(Unit::MillimetrePerSecond2));
    assert_eq!(unit("OF FURLONGS"), None);
    assert_eq!(unit(""), None);
    assert_eq!(read(&format!("\u{feff}\n{text}")).values, [1.0, 2.0]);
    let latin = [b"Le\xf3n\n".as_slice(), text.as_bytes()].concat();
    assert_eq!(
        parse("f", &latin, Reading::default()).unwrap().values,
        [1.0, 2.0]
    );
}

#[test]
fn at2_faults_have_their_line() {
    let good = "NPTS= 3, DT= .01 SEC";
    let needs = "f:4: needs NPTS and DT with a number each, as in \"NPTS= 4000, DT= .005 SEC\"";
    for (text, fault) in [
        (
            at2(good, "1 2"),
            "f:5: the file ends after 2 numbers; NPTS of line 4 is 3",
        ),
        (
            at2(good, ""),
            "f:4: the file ends after 0 numbers; NPTS of line 4 is 3",
        ),
        (
            at2(good, "1\n2 3\n4"),
            "f:7: more numbers than NPTS of line 4, 3",
        ),
        (at2(good, "1\n2 x3"), "f:6: not a number: \"x3\""),
        (at2(good, "1\n2 ***\n"), "f:6: not a number: \"***\""),
        (at2(good, "1\n2 NaN"), "f:6: not a finite number: \"NaN\""),
        (at2(good, "1e999"), "f:5: not a finite number: \"1e999\""),
        (at2("NPTS=, DT= .01", "1"), needs),
        (
            at2("NPTS= 1, DT= .01", "1"),
            "f:4: NPTS must be a whole number >= 2, got 1",
        ),
        (
            at2("NPTS= 2.5, DT= .01", "1"),
            "f:4: NPTS must be a whole number >= 2, got 2.5",
        ),
        (
            at2("NPTS= 2, DT= 0", "1 2"),
            "f:4: DT must be > 0 and finite, got 0",
        ),
        (
            at2("NPTS= 2, DT= -.01", "1 2"),
            "f:4: DT must be > 0 and finite, got -0.01",
        ),
    ] {
        assert_eq!(refused(&text), fault, "{text}");
    }
    for other in ["velocity", "displacement"] {
        let text = at2(good, "1 2 3").replace("ACCELERATION", &other.to_uppercase());
        assert_eq!(
            refused(&text),
            format!("f:3: the file has a {other}; it must have an acceleration")
        );
    }
}

#[test]
fn two_columns_may_have_any_separator_and_header() {
    let rows = ["0 1.5", "0.02 -2D1", ".03 3e-1"];
    for by in [" ", "\t", ",", ", ", ";", " ; "] {
        for (header, tail) in [
            ("", ""),
            ("t,a\n", "\n\n"),
            (
                "3\nTime (s)\tAcc. (m/s2)\n\n2000/01/01 3\n12:30 0\nInformation 1\n",
                "",
            ),
        ] {
            let text =
                header.to_owned() + &rows.map(|row| row.replace(' ', by)).join("\r\n") + tail;
            let record = read(&text);
            assert_eq!(record.times, [0.0, 0.02, 0.03], "{text}");
            assert_eq!(record.values, [1.5, -20.0, 0.3]);
            // The second header names no unit, the third one m/s2.
            let unit = header.contains("Acc.").then_some(Unit::MetrePerSecond2);
            assert_eq!(record.unit, unit);
        }
    }
    assert_eq!(read("0,1,\n1,2,\n").values, [1.0, 2.0]);
    assert_eq!(read("\u{feff}0 1\n1 2\n").values, [1.0, 2.0]);
}

#[test]
fn faults_of_two_columns_have_their_line() {
    let rows = "a row must have two numbers, t and a, with decimal points, got";
    let give = "; of several columns give \"column\"";
    let none = "the file has no row of two numbers, t and a; if it has no times, give \"dt\"";
    // Where no row is one of a table, the file may be in another format.
    let tried = "; the file is in no other format, either: K-NET ASCII (";
    for (text, fault) in [
        ("", format!("f:1: {none}{tried}")),
        ("t a\n\n", format!("f:2: {none}{tried}")),
        ("1\n2\n3", format!("f:3: {none}{tried}")),
        ("t a\n0 1 2\n", format!("f:2: {rows} 3{give}{tried}")),
        ("0 1 2\n1 2 3\n", format!("f:1: {rows} 3{give}{tried}")),
        ("0 1\n2\n", format!("f:2: {rows} 1")),
        ("0,1\n1,,2\n", format!("f:2: {rows} 3")),
        (
            "t;a\n0,01;1\n",
            "f:2: numbers must have decimal points, got \"0,01\"".into(),
        ),
        ("0 0x1\n1 2\n", "f:1: not a number: \"0x1\"".into()),
        ("0 1\n1 2\nlast\n", format!("f:3: {rows} 1")),
        ("0 1\n1 inf\n", "f:2: not a finite number: \"inf\"".into()),
        ("t a\n-.5x ***\n1 2\n", "f:2: not a number: \"-.5x\"".into()),
        ("0 nan\n1 2\n", "f:1: not a finite number: \"nan\"".into()),
        (
            "0 1\n0 2\n",
            "f:2: the times must rise, got 0 after 0".into(),
        ),
        (
            "0 1\n1 2\n\n0.5 2\n",
            "f:4: the times must rise, got 0.5 after 1".into(),
        ),
        (
            "t a\n0 1\n",
            "f:2: the file has one row of numbers; a record needs two or more".into(),
        ),
    ] {
        let refused = refused(text);
        match refused.split_once(tried) {
            Some((before, _)) => assert_eq!(format!("{before}{tried}"), fault, "{text}"),
            None => assert_eq!(refused, fault, "{text}"),
        }
    }
}

#[test]
fn knet_counts_are_scaled_without_their_mean() {
    // Mean 100; 2000/8000 gal a count.
    let record = read(&knet(
        ["100Hz", "0.04", "2000(gal)/8000"],
        "   104 96\n 100   100\n",
    ));
    assert_eq!(record.times, [0.0, 0.01, 0.02, 0.03]);
    assert_eq!(record.values, [1.0, -1.0, 0.0, 0.0]);
    assert_eq!(record.unit, Some(Unit::CentimetrePerSecond2));
    // 0.07 times 100 is above 7 in floating point.
    let record = read(&knet(["100Hz", "0.07", "1(gal)/1"], "1 2 3 4 5 6 7"));
    assert_eq!(record.values, [-3.0, -2.0, -1.0, 0.0, 1.0, 2.0, 3.0]);
}

#[test]
fn the_mean_of_any_record_is_kept_or_removed() {
    let with = |text: &str, mean| {
        let reading = Reading {
            mean,
            ..Reading::default()
        };
        parse("f", text.as_bytes(), reading).unwrap()
    };
    // Counts 104, 96, 103, 97 with the mean 100, 0.25 gal a count: powers of two, so without round-off.
    let text = knet(["100Hz", "0.04", "2000(gal)/8000"], "104 96 103 97\n");
    let kept = with(&text, Some(Mean::Kept));
    assert_eq!(
        (kept.values, kept.removed_mean),
        (vec![26.0, 24.0, 25.75, 24.25], None)
    );
    for mean in [None, Some(Mean::Removed)] {
        let removed = with(&text, mean);
        assert_eq!(removed.values, [1.0, -1.0, 0.75, -0.75]);
        assert_eq!(removed.removed_mean, Some(25.0));
    }
    let text = at2("NPTS= 4, DT= 1", "1 2 3 6");
    for mean in [None, Some(Mean::Kept)] {
        let kept = with(&text, mean);
        assert_eq!(
            (kept.values, kept.removed_mean),
            (vec![1.0, 2.0, 3.0, 6.0], None)
        );
    }
    let removed = with(&text, Some(Mean::Removed));
    assert_eq!(
        (removed.values, removed.removed_mean),
        (vec![-2.0, -1.0, 0.0, 3.0], Some(3.0))
    );
}

#[test]
fn knet_faults_have_their_line() {
    let good = ["100Hz", "0.02", "2000(gal)/8000"];
    let source = "Duration Time(s) times Sampling Freq(Hz)";
    let with = |line: usize, text| {
        let mut header = good;
        header[line] = text;
        knet(header, "1 2")
    };
    for (text, fault) in [
        (
            knet(good, "1"),
            format!("f:18: the file ends after 1 numbers; {source} is 2"),
        ),
        (
            knet(good, "1 2\n3"),
            format!("f:19: more numbers than {source}, 2"),
        ),
        (
            knet(["100Hz", "0.01", good[2]], "1"),
            "f:18: a record needs two or more numbers".into(),
        ),
        (knet(good, "1 2a"), "f:18: not a number: \"2a\"".into()),
        (
            with(0, "0Hz"),
            "f:11: Sampling Freq(Hz) must be > 0, got 0".into(),
        ),
        (with(0, "fast"), "f:11: not a number: \"fast\"".into()),
        (
            with(1, "-1"),
            "f:12: Duration Time(s) must be > 0, got -1".into(),
        ),
        (
            with(1, "0.01"),
            "f:18: more numbers than Duration Time(s) times Sampling Freq(Hz), 1".into(),
        ),
        (
            with(2, "2000/8"),
            "f:14: the scale factor must have the form \"a(gal)/b\", got \"2000/8\"".into(),
        ),
        (
            with(2, "1(gal)/0"),
            "f:14: the scale factor must have the form \"a(gal)/b\", got \"1(gal)/0\"".into(),
        ),
        (
            with(2, "-1(gal)/2"),
            "f:14: Scale Factor must be > 0, got -0.5".into(),
        ),
        (
            knet(["100Hz", "0.02", "1e308(gal)/1"], "100 -100"),
            "f:18: the numbers are too large with this frequency and scale factor".into(),
        ),
        (
            knet(good, "1 2").replace("Memo.", "1 2"),
            "f:17: a K-NET header must have 17 lines, the last one \"Memo.\"".into(),
        ),
        (
            knet(good, "1 2").replace("Duration", "Length"),
            "f:17: the header needs the line \"Duration Time(s)\"".into(),
        ),
    ] {
        assert_eq!(refused(&text), fault, "{text}");
    }
}

/// Pieces of record files, to reach the depths of the readers with random texts.
fn piece() -> impl Strategy<Value = String> {
    let fixed = [
        "NPTS",
        "DT",
        "=",
        "SEC",
        "\n",
        "\n",
        " ",
        ",",
        ";",
        "-",
        "1",
        "2",
        ".5",
        "1e9",
        "1e308",
        "D",
        "nan",
        "Scale Factor",
        "(gal)/",
        "Memo.",
        "Sampling Freq(Hz)",
        "Duration Time(s)",
        "UNITS OF",
        "VELOCITY TIME",
        "2 CORRECTED ACCELEROGRAM",
        "Corrected accelerogram",
        "(Format v1 text lines acceleration",
        "5 real-header values on 2 lines",
        "3 acceleration pts",
        "*** End Data",
        "ACCELEROGRAM DATA\nINSTR PERIOD\nSENSITIVITY\nNO. OF POINTS = 3\nUNITS ARE SEC AND G/10\n",
        "VOL1DS",
        "\n0 0 0 0 0 0 0 0 0 0\n 0 0\n .1 .1 .1 .1\n .1\n",
        "3 POINTS OF ACC DATA EQUALLY SPACED AT .02 SEC, IN G\n",
        "SAMPLING_INTERVAL_S: 0.1\nNDATA: 3\nUNITS: g\nSTREAM: X\n",
        "INTERVALO DE MUESTREO: /1/1\nNUM. TOTAL DE MUESTRAS: /2/2\nUNIDADES DE LOS DATOS: Gal\nVERSION DEL FORMATO\n",
        "SAMPLES/SEC=2 FILTER TYPE=X JULIAN DAY=1 DATA TYPE=AC\nNO OF POINTS= 2, UNITS=G\n",
        "|",
        "\u{e9}",
    ];
    prop_oneof![
        proptest::sample::select(fixed.to_vec()).prop_map(str::to_owned),
        any::<String>()
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn no_text_panics_and_a_record_is_a_table(pieces in proptest::collection::vec(piece(), 0..60)) {
        holds(&parse("f", pieces.concat().as_bytes(), Reading::default()));
    }

    #[test]
    fn no_header_and_no_row_of_knet_panics(
        header in [piece(), piece(), piece()],
        rows in proptest::collection::vec(piece(), 0..20),
    ) {
        let [a, b, c] = header;
        holds(&parse("f", knet([&a, &b, &c], &rows.concat()).as_bytes(), Reading::default()));
    }

    #[test]
    fn no_bytes_panic(bytes in any::<Vec<u8>>()) {
        holds(&parse("f", &bytes, Reading::default()));
    }
}

/// What each record and each fault must be.
fn holds(parsed: &Result<Record, RecordFault>) {
    match parsed {
        Ok(record) => {
            assert!(record.times.len() >= 2 && record.times.len() == record.values.len());
            assert!(record.times.windows(2).all(|t| t[0] < t[1]));
            assert!(
                record
                    .times
                    .iter()
                    .chain(&record.values)
                    .all(|x| x.is_finite())
            );
        }
        Err(fault) => assert!(fault.line >= 1 && !fault.cause.to_string().is_empty()),
    }
}
