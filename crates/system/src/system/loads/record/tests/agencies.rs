//! Small files of CSMIP, RENADIC, USC, BHRC, ESM, UNAM and NSMP, made by formulas after the layouts of the formats; no recorded motion.

use super::*;

fn column(number: usize) -> Reading {
    Reading {
        column: Some(number),
        ..Reading::default()
    }
}

/// `count` thousandths by a rule: exact as texts with three decimals, both signs, the largest one 267.957 at the eighth place.
fn thousandths(count: usize, seed: i64) -> Vec<i64> {
    let value = |i: usize| match i {
        7 => -267_957,
        _ => (seed * 7919 + i as i64 * 104_729) % 99_991 - 49_995,
    };
    (0..count).map(value).collect()
}

/// The numbers of thousandths.
fn numbers(values: &[i64]) -> Vec<f64> {
    values.iter().map(|x| *x as f64 / 1000.0).collect()
}

/// Thousandths in fields of a width, `row` of them a line, as Fortran writes them: no zero before the point if the field is full.
fn fortran(values: &[i64], width: usize, row: usize) -> String {
    let field = |x: &i64| {
        let sign = if *x < 0 { "-" } else { "" };
        let decimal = format!("{sign}{}.{:03}", x.abs() / 1000, x.abs() % 1000);
        let text = match decimal.len() > width {
            true => decimal.replacen("0.", ".", 1),
            false => decimal,
        };
        assert!(text.len() <= width, "{text}");
        format!("{text:>width$}")
    };
    let line = |row: &[i64]| row.iter().map(field).collect::<String>() + "\n";
    values.chunks(row).map(line).collect()
}

/// A hundred whole numbers in rows of 16, and `count` numbers in rows of 8.
fn header(count: usize) -> String {
    let fields: Vec<String> = (0..100).map(|i| format!("{:5}", i % 13)).collect();
    let whole: String = fields.chunks(16).map(|row| row.concat() + "\n").collect();
    whole + &fortran(&vec![41; count], 10, 8)
}

/// A corrected channel of CSMIP with these accelerations, and velocities and displacements behind them.
fn csmip(number: usize, direction: &str, values: &[i64]) -> String {
    let n = values.len();
    let block = |name: &str, unit: &str, values: &[i64]| {
        format!(" {n:4} POINTS OF {name} DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: {unit})\n")
            + &fortran(values, 10, 8)
    };
    format!(
        "CORRECTED ACCELEROGRAM   0-S0-0.01       CHAN  {number}:  {direction}     FROM\n\
         UNCORRECTED ACCELEROGRAM DATA              PROCESSED:  1/01/00, QC\nNOWHERE EARTHQUAKE\n\
         STATION NO. 00000   0.0N, 0.0W     SMA-1  S/N 0\nOLD MILL\nCHAN  {number}:  {direction}\n\
         INSTR PERIOD =  .0407 SEC,  DAMPING =  .630,  SENSITIVITY = 1.87 CM/G.\n\
         \x20                       RECORD LENGTH = 65.000 SEC.\n\
         \x20                                    UNCOR MAX  =  -.275 G, AT  10.947 SEC.\n\
         \x20 {n} POINTS OF INSTRUMENT- AND BASELINE-CORRECTED ACCEL, VELOC AND DISPL DATA\n\
         PEAK ACCELERATION =  -267.957    CM/SEC/SEC  AT   10.940   SEC.\n\n{}{}{}{}/&  ----------  END OF DATA FOR CHANNEL  {number}  ----------\n",
        header(100),
        block("ACCEL", "CM/SEC/SEC", values),
        block("VELOC", "CM/SEC", &thousandths(n, 5)),
        block("DISPL", "CM", &thousandths(n, 6)),
    )
}

/// An uncorrected channel of RENADIC with pairs from a time on, 0.005 apart.
fn renadic(number: usize, direction: &str, values: &[i64], from: i64) -> String {
    let n = values.len();
    let steps = values.iter().enumerate();
    let pairs: Vec<i64> = steps.flat_map(|(i, a)| [from + 5 * i as i64, *a]).collect();
    let end = (from + 5 * n as i64) as f64 / 1000.0;
    format!(
        "UNCORRECTED ACCELEROGRAM DATA              PROCESSED: 01/01/2000\nNOWHERE 2000\n\
         STATION NO.          0.000N    0.000E  QDR       S/N  0\nLOWER TOWN\nCHAN  {number}: {direction}       (STA CHN:  {number})\n\
         UNIVERSIDAD - RENADIC\nINSTR PERIOD = 0.0390 SEC,  DAMPING =0.7000,  SENSITIVITY =1.250 VDC/G\n\
         NO. OF POINTS =   {n}  RECORD LENGTH = {end:.3} SEC\n\
         UNITS OF UNCOR ACCEL ARE SEC AND G/10.     MAX  = -0.250 G, AT  23.180 SEC\n\
         RMS ACCEL OF COMPLETE RECORD = 0.006 G\n{}{}/&  ----------  END OF DATA FOR CHANNEL {number}  ----------\n",
        header(50),
        fortran(&pairs, 7, 10)
    )
}

/// Thousandths with the largest one -2.5, as RENADIC has tenths of g.
fn tenths(count: usize) -> Vec<i64> {
    (0..count as i64)
        .map(|i| if i == 3 { -2500 } else { (i * 37) % 1999 - 999 })
        .collect()
}

#[test]
fn csmip_v2_has_the_accelerations_of_each_channel() {
    let (first, second) = (thousandths(21, 1), thousandths(18, 2));
    let both = csmip(1, "90 DEG", &first) + &csmip(2, "UP", &second);
    for (number, values) in [(1, &first), (2, &second)] {
        let record = with(&both, component(number)).unwrap();
        assert_eq!(record.values, numbers(values));
        let times: Vec<f64> = (0..values.len()).map(|i| i as f64 * 0.02).collect();
        assert_eq!(record.times, times);
        assert_eq!(record.unit, Some(Unit::CentimetrePerSecond2));
        assert_eq!(record.doubts, []);
    }
    let several = "f:1: \"component\" must be the number of one of the file's components, 1 \"CHAN 1: 90 DEG\", 2 \"CHAN 2: UP\"";
    assert_eq!(refused(&both), several);
    assert_eq!(
        with(&both, component(3)).unwrap_err(),
        format!("{several}, got 3")
    );
    let words = |number| Heading::of(both.as_bytes(), &component(number)).words();
    assert_eq!(words(1), "NOWHERE EARTHQUAKE, OLD MILL, 90°");
    assert_eq!(words(2), "NOWHERE EARTHQUAKE, OLD MILL, UP");
    // The newer files have small letters and another end of the line.
    let one = csmip(1, "90 DEG", &first);
    let label = "21 POINTS OF ACCEL DATA EQUALLY SPACED AT  .020 SEC.  (UNITS: CM/SEC/SEC)";
    for other in [
        "21 points of accel data equally spaced at  .020 sec, in cm/sec2. (8f10.3)",
        "21 Accelerogram points at 50 pts/sec in units of cm/sec2 .      Format: (8f10.3)",
        "21 POINTS OF ACC DATA EQUALLY SPACED AT   .020 SEC.  IN UNITS CM/SEC/SEC",
    ] {
        assert_eq!(read(&one.replace(label, other)), read(&one), "{other}");
    }
}

#[test]
fn what_a_channel_of_csmip_contradicts_is_named_with_its_line() {
    let values = thousandths(21, 1);
    let good = csmip(1, "90 DEG", &values);
    let line = |word: &str| 1 + good.lines().position(|line| line.contains(word)).unwrap();
    let (at, velocities) = (line("21 POINTS OF ACCEL"), line("POINTS OF VELOC"));
    let source = format!("the number of points of line {at}");
    for (from, to, fault) in [
        (
            "21 POINTS OF ACCEL",
            "24 POINTS OF ACCEL",
            format!(
                "f:{}: the numbers end after 21; {source} is 24",
                velocities - 1
            ),
        ),
        (
            "21 POINTS OF ACCEL",
            "16 POINTS OF ACCEL",
            format!("f:{}: more numbers than {source}, 16", velocities - 1),
        ),
        (
            "21 POINTS OF ACCEL",
            "2.5 POINTS OF ACCEL",
            format!("f:{at}: the number of points must be a whole number >= 2, got 2.5"),
        ),
        (
            "AT  .020 SEC.  (UNITS: CM/SEC/SEC",
            "AT  .000 SEC.  (UNITS: CM/SEC/SEC",
            format!("f:{at}: the time step must be > 0, got 0"),
        ),
        (
            "POINTS OF ACCEL DATA",
            "POINTS OF VELOC DATA",
            format!("f:{at}: the file has a velocity; it must have an acceleration"),
        ),
        (
            "PEAK ACCELERATION",
            "RESPONSE AND FOURIER AMPLITUDE SPECTRA",
            format!(
                "f:{}: the file has a response spectrum; it must have an acceleration",
                line("PEAK ACC")
            ),
        ),
    ] {
        assert_eq!(refused(&good.replacen(from, to, 1)), fault);
    }
    // A unit that is none leaves it to the study.
    assert_eq!(read(&good.replace("CM/SEC/SEC)", "FURLONGS)")).unit, None);
    // A peak in another unit, and within its last digit.
    let peak = |text: &str| read(&good.replace("-267.957    CM/SEC/SEC", text)).doubts;
    for text in ["-267.957    CM/SEC/SEC", "  .2732 G", "-268. CM/SEC/SEC"] {
        assert_eq!(peak(text), [], "{text}");
    }
    let doubts = peak("-26.7957    CM/SEC/SEC");
    let expected = format!(
        "line {0}: the largest acceleration is 267.957, but PEAK ACCELERATION of line {0} is 26.7957",
        line("PEAK ACC")
    );
    assert_eq!(
        doubts.iter().map(Doubt::to_string).collect::<Vec<_>>(),
        [expected]
    );
    let fault = with(
        &good,
        Reading {
            dt: Some(0.01),
            ..Reading::default()
        },
    );
    let by = format!("f:{at}: dt is 0.01, but 0.02 by the time step of line {at}; give 0.02");
    assert_eq!(fault.unwrap_err(), by);
}

#[test]
fn renadic_has_pairs_without_blanks_behind_100_s() {
    let values = tenths(33);
    // Fields of seven hold `-2.500`, and `100.000` without a blank before it.
    let text = renadic(1, "EW", &values, 99_950) + &renadic(2, "NS", &values[..20], 0);
    assert!(
        text.contains(" -2.500 ") && text.contains("-0.629100.005"),
        "{text}"
    );
    let record = with(&text, component(1)).unwrap();
    let g: Vec<f64> = values.iter().map(|x| *x as f64 / 1000.0 / 10.0).collect();
    assert_eq!(record.values, g);
    let times: Vec<f64> = (0..33).map(|i| (99_950 + 5 * i) as f64 / 1000.0).collect();
    assert_eq!((record.times, record.unit), (times, Some(Unit::G)));
    assert_eq!(record.doubts, []);
    let second = with(&text, component(2)).unwrap();
    assert_eq!((second.values.len(), second.times[19]), (20, 0.095));
    let words = Heading::of(text.as_bytes(), &component(2)).words();
    assert_eq!(words, "NOWHERE 2000, LOWER TOWN, NS");
    let one = renadic(1, "EW", &values, 0);
    let dt = |dt| Reading {
        dt: Some(dt),
        ..Reading::default()
    };
    assert_eq!(with(&one, dt(0.005)).as_ref(), Ok(&read(&one)));
    let fault = with(&one, dt(0.01)).unwrap_err();
    assert!(
        fault.contains("dt is 0.01, but 0.005 by the times of line 25"),
        "{fault}"
    );
    for (from, to, fault) in [
        (
            "POINTS =   33",
            "POINTS =   34",
            "f:31: the numbers end after 66; twice NO. OF POINTS of line 8 is 68",
        ),
        (
            "POINTS =   33",
            "POINTS =   32",
            "f:31: more numbers than twice NO. OF POINTS of line 8, 64",
        ),
        (
            "NO. OF POINTS",
            "POINTS",
            "f:11: the header needs the line \"NO. OF POINTS\"",
        ),
        (
            "  0.005 ",
            "  0.000 ",
            "f:25: the times must rise, got 0 after 0",
        ),
    ] {
        assert_eq!(refused(&one.replacen(from, to, 1)), fault);
    }
    let doubts = |from: &str, to: &str| {
        let doubts = read(&one.replace(from, to)).doubts;
        doubts.iter().map(Doubt::to_string).collect::<Vec<_>>()
    };
    assert_eq!(
        doubts("LENGTH = 0.165", "LENGTH = 0.330"),
        ["line 8: the times end at 0.16, but RECORD LENGTH of line 8 is 0.33"]
    );
    // Tenths of g taken for g.
    assert_eq!(
        doubts("G/10.", "G ."),
        ["line 9: the largest acceleration is 2.5, but MAX of line 9 is 0.25"]
    );
}

/// A file of USC with times that are not even.
fn usc(values: &[i64], times: &[i64]) -> String {
    let pairs: Vec<i64> = times
        .iter()
        .zip(values)
        .flat_map(|(t, a)| [*t, *a])
        .collect();
    let end = *times.last().unwrap() as f64 / 1000.0;
    format!(
        "FILE     0 OF UNCORRECTED ACCELEROGRAM DATA OF VOLUME I:\nNOWHERE EARTHQUAKE                                                      18\n\
         JAN 1, 2000 -0000 GMT                                                   21\nIBB000  00.000.0 N                                                      18\n\
         STATION USC# 0000   00 00 00N, 000 00 00W                               39\n1 OLD ROAD, UPPER TOWN, CA                                              26\n\
         COMP N00W                                                               9\nINSTR PERIOD =  .039 SEC  DAMPING =   .577  SENSITIVITY =   1.86CM/G    69\n\
         NO. OF POINTS =   {}      DURATION =  {end} SEC                      50\nUNITS ARE SEC AND G/10                                                  22\n\
         RMS ACCLN. OF COMPLETE RECORD =     .638 G/10                           45\n{}{}",
        values.len(),
        header(50),
        fortran(&pairs, 8, 10)
    )
}

#[test]
fn usc_has_times_that_are_not_even() {
    let values = tenths(23);
    let times: Vec<i64> = (0..23).map(|i| 4 * i + i / 4).collect();
    let text = usc(&values, &times);
    let record = read(&text);
    assert_eq!(record.times, numbers(&times));
    let g: Vec<f64> = values.iter().map(|x| *x as f64 / 1000.0 / 10.0).collect();
    assert_eq!((record.values, record.unit), (g, Some(Unit::G)));
    assert_eq!(record.doubts, []);
    let words = Heading::of(text.as_bytes(), &Reading::default()).words();
    assert_eq!(
        words,
        "NOWHERE EARTHQUAKE, 1 OLD ROAD, UPPER TOWN, CA, N00W"
    );
    let step = Reading {
        dt: Some(0.004),
        ..Reading::default()
    };
    assert_eq!(
        with(&text, step).unwrap_err(),
        "f:1: the file has times of its own, which are not even; give no dt"
    );
}

#[test]
fn bhrc_has_no_pairs_and_rows_of_its_header_are_cut() {
    let values = tenths(27);
    let field = |x: &i64| {
        let text = format!("{:.6E}", *x as f64 / 1000.0);
        let (digits, exponent) = text.split_once('E').unwrap();
        let exponent: i32 = exponent.parse().unwrap();
        // Fortran has the exponent with its sign.
        format!(
            " {digits:>9}E{}{:02}",
            if exponent < 0 { "-" } else { "+" },
            exponent.abs()
        )
    };
    let rows = |values: &[i64]| -> String {
        let row = |row: &[i64]| row.iter().map(field).collect::<String>() + "\n";
        values.chunks(10).map(row).collect()
    };
    let zero = "  .000000E+00".repeat(5) + "  .00\n";
    let rate = zero.replacen(".000000E+00", ".200000E+03", 1);
    let whole = ("    0".repeat(14) + "\n").repeat(6) + "    0    0    0    0\n";
    let numbers = zero.clone() + &rate + &zero.repeat(4) + "  .000000E+00  .000000E+00\n";
    let channel = |name: &str, values: &[i64]| {
        format!(
            "* VOL1DS FILE:  0000/01\nInst Type = SSA-2\n\nCOMP {name}\nNowhere     Station   0.0 N 0.0 E\n\
             INSTR PERIOD =  .020 SEC   DAMPING =  .640\nNO. OF POINTS =  {}      DURATION =  {}\n\
             UNITS ARE SECONDS AND G/10\n{whole}{numbers}{}/&\n",
            values.len(),
            values.len() as f64 / 200.0,
            rows(values)
        )
    };
    let both = channel("L1", &values) + &channel("V2", &values[..11]);
    let record = with(&both, component(1)).unwrap();
    let g: Vec<f64> = values.iter().map(|x| *x as f64 / 1000.0 / 10.0).collect();
    assert_eq!((record.values, record.unit), (g, Some(Unit::G)));
    assert_eq!(record.times[26], 26.0 / 200.0);
    assert_eq!(record.doubts, []);
    assert_eq!(with(&both, component(2)).unwrap().values.len(), 11);
    let one = channel("L1", &values);
    assert_eq!(
        refused(&one.replace(".200000E+03", ".000000E+00")),
        "f:17: number 9 of the header, the samples per second, must be > 0, got 0"
    );
    let doubts = read(&one.replace("DURATION =  0.135", "DURATION =  0.270")).doubts;
    assert_eq!(
        doubts.iter().map(Doubt::to_string).collect::<Vec<_>>(),
        ["line 7: the times end at 0.13, but DURATION of line 7 is 0.27"]
    );
}

/// A file of ESM with this unit and kind.
fn esm(values: &[i64], unit: &str, kind: &str) -> String {
    format!(
        "EVENT_NAME: NOWHERE\nSTATION_CODE: ABC\nVS30_M/S: 300\nSAMPLING_INTERVAL_S: 0.005000\nNDATA: {}\nSTREAM: HNE\nUNITS: {unit}\n\
         PGA_CM/S^2: -267.957\nDATA_TYPE: {kind}\nUSER1: 12\nUSER2: \n{}",
        values.len(),
        fortran(values, 9, 1)
    )
}

#[test]
fn esm_has_step_unit_and_count_in_its_header() {
    let values = thousandths(12, 3);
    let text = esm(&values, "cm/s^2", "ACCELERATION");
    let record = read(&text);
    assert_eq!(
        (record.values, record.unit),
        (numbers(&values), Some(Unit::CentimetrePerSecond2))
    );
    assert_eq!((record.times[11], record.doubts), (11.0 * 0.005, vec![]));
    let words = Heading::of(text.as_bytes(), &Reading::default()).words();
    assert_eq!(words, "NOWHERE, ABC, HNE");
    for (text, fault) in [
        (
            text.replace("NDATA: 12", "NDATA: 13"),
            "f:5: the table has 12 rows, but NDATA of line 5 is 13",
        ),
        (
            text.replace("NDATA: 12", "NDATA: many"),
            "f:5: not a number: \"many\"",
        ),
        (
            text.replace("0.005000", "-0.005"),
            "f:4: SAMPLING_INTERVAL_S must be > 0, got -0.005",
        ),
        (
            text.replace("SAMPLING_INTERVAL_S: 0.005000\n", ""),
            "f:1: the header needs the line \"SAMPLING_INTERVAL_S\"",
        ),
        (
            esm(&values, "cm/s", "VELOCITY"),
            "f:9: the file has a velocity; it must have an acceleration",
        ),
        (
            esm(&values, "cm", "ACCELERATION"),
            "f:7: the file has a displacement; it must have an acceleration",
        ),
        (
            esm(&values, "cm/s^2", "ACCELERATION RESPONSE SPECTRUM"),
            "f:9: the file has a response spectrum; it must have an acceleration",
        ),
        (
            text.replace("-267.957\n", "-267.957 1\n")
                .replacen("957 1", "957", 1),
            "f:19: a row must have a number for each of the 1 channels of SAMPLING_INTERVAL_S of line 4, got 2",
        ),
    ] {
        assert_eq!(refused(&text), fault);
    }
    assert_eq!(read(&esm(&values, "", "ACCELERATION")).unit, None);
    // With times it is a table.
    let times: Vec<i64> = (0..12).flat_map(|i| [5 * i as i64, values[i]]).collect();
    let head = text.split("USER2: \n").next().unwrap();
    let table = format!("{head}USER2: \n{}", fortran(&times, 9, 2));
    assert_eq!(read(&table).values, numbers(&values));
    let shorter = text.replace("USER1: 12", "DURATION_S: 0.12");
    assert_eq!(
        read(&shorter)
            .doubts
            .iter()
            .map(Doubt::to_string)
            .collect::<Vec<_>>(),
        ["line 10: the times end at 0.06, but DURATION_S of line 10 is 0.12"]
    );
    assert_eq!(read(&shorter.replace("0.12\n", "0.06\n")).doubts, []);
    let doubts = read(&text.replace("PGA_CM/S^2: -267.957", "PGA_CM/S^2: 2.67957")).doubts;
    assert_eq!(
        doubts.iter().map(Doubt::to_string).collect::<Vec<_>>(),
        ["line 8: the largest acceleration is 267.957, but PGA_CM/S^2 of line 8 is 2.67957"]
    );
}

/// A file of UNAM with two channels in columns, and so many samples in its header.
fn unam(values: &[i64], samples: usize) -> String {
    let line = "*".repeat(40);
    format!(
        "{line}\nINSTITUTO\n{line}\nARCHIVO ESTANDAR DE ACELERACION:\nVERSION DEL FORMATO                    : 2.0\n\
         CLAVE DE LA ESTACION                   : ABCD\nORIENTACION C1-C6 (rumbo;orientacion)  : /V/N90E\n\
         ORIENTACION C7-C12 (rumbo;orientacion) :\nINTERVALO DE MUESTREO, C1-C6 (s)       : /0.004/0.004\n\
         INTERVALO DE MUESTREO, C7-C12 (s)      :\nFECHA DEL SISMO [GMT]                  : 2000/01/02\n\
         NUM. TOTAL DE MUESTRAS, C1-C6          : /{samples}/{samples}\nACEL. MAX.(Gal), C1-C6                 : /-267.96/267.96\n\
         UNIDADES DE LOS DATOS                  : Gal (cm/s/s)\nDATOS DE ACELERACION:\n---------+---------+\n   CANAL-1   CANAL-2\n         V      N90E\n{}",
        fortran(values, 9, 2)
    )
}

#[test]
fn unam_has_a_column_for_each_channel() {
    let first = thousandths(14, 4);
    let second: Vec<i64> = first.iter().map(|x| -x).collect();
    let both: Vec<i64> = first
        .iter()
        .zip(&second)
        .flat_map(|(a, b)| [*a, *b])
        .collect();
    let text = unam(&both, 14);
    for (number, values, direction) in [(1, first, "V"), (2, second, "N90E")] {
        let record = with(&text, column(number)).unwrap();
        assert_eq!(
            (record.values, record.unit),
            (numbers(&values), Some(Unit::CentimetrePerSecond2))
        );
        assert_eq!((record.times[13], record.doubts), (13.0 * 0.004, vec![]));
        let words = Heading::of(text.as_bytes(), &column(number)).words();
        assert_eq!(words, format!("2000-01-02, ABCD, {direction}"));
    }
    let several =
        "f:1: \"column\" must be the number of one of the file's columns, 1 \"V\", 2 \"N90E\"";
    assert_eq!(refused(&text), several);
    assert_eq!(
        with(&text, column(3)).unwrap_err(),
        format!("{several}, got 3")
    );
    assert_eq!(
        with(&text, component(1)).unwrap_err(),
        "f:1: the file is UNAM (ASA 2.0), which has columns and no components; give no component"
    );
    let given = Reading {
        dt: Some(0.01),
        ..column(1)
    };
    assert_eq!(
        with(&text, given).unwrap_err(),
        "f:9: dt is 0.01, but 0.004 by INTERVALO DE MUESTREO of line 9; give 0.004"
    );
    // An excerpt is read with a doubt, also a file with two samples more than its header has.
    for samples in [17_500, 12] {
        let doubts = with(&unam(&both, samples), column(1)).unwrap().doubts;
        let expected = format!(
            "line 12: the table has 14 rows, but NUM. TOTAL DE MUESTRAS of line 12 is {samples}"
        );
        assert_eq!(
            doubts.iter().map(Doubt::to_string).collect::<Vec<_>>(),
            [expected]
        );
    }
    let three = text.replace(": /0.004/0.004", ": /0.004/0.004/0.004");
    assert_eq!(
        with(&three, column(1)).unwrap_err(),
        "f:19: a row must have a number for each of the 3 channels of INTERVALO DE MUESTREO of line 9, got 2"
    );
    let doubts = with(&text.replace("/-267.96/", "/-2.6796/"), column(1))
        .unwrap()
        .doubts;
    assert_eq!(
        doubts.iter().map(Doubt::to_string).collect::<Vec<_>>(),
        ["line 13: the largest acceleration is 267.957, but ACEL. MAX.(Gal) of line 13 is 2.6796"]
    );
}

/// A block of NSMP of this kind.
fn nsmp(direction: usize, kind: &str, values: &[i64]) -> String {
    format!(
        " NOWHERE, 1 OLD ROAD, ROOF\n {direction:03} DEGREES\n EARTHQUAKE OF JANUARY 1, 2000 0000 GMT\n BUTTERWORTH AT .25 HZ, ORDER 4\n\
         \x20YEAR=2000 JULIAN DAY=  1 HOUR= 0 MINUTE= 0 SECOND= 0 COMPONENT=  {direction}\n\
         \x20SAMPLES/SEC=200 FILTER TYPE=BUTTERWORTH  CORNER= 0.25 ORDER=4 DATA TYPE={kind}\n\
         \x20NO OF POINTS=  {}, UNITS=CM/SEC**2, CM/SEC, AND CM\n{}",
        values.len(),
        fortran(values, 8, 10)
    )
}

#[test]
fn nsmp_has_blocks_of_which_those_of_accelerations_are_components() {
    // Fields of eight are full: -267.957.
    let (first, second) = (thousandths(25, 7), thousandths(12, 8));
    let channel = |direction, values: &[i64]| {
        ["AC", "VL", "DP"]
            .map(|kind| nsmp(direction, kind, values))
            .concat()
    };
    let one = channel(90, &first);
    let record = read(&one);
    assert_eq!(
        (record.values, record.unit),
        (numbers(&first), Some(Unit::CentimetrePerSecond2))
    );
    assert_eq!(record.times[24], 24.0 / 200.0);
    let both = one.clone() + &channel(180, &second);
    assert_eq!(with(&both, component(2)).unwrap().values, numbers(&second));
    assert_eq!(
        refused(&both),
        "f:1: \"component\" must be the number of one of the file's components, 1 \"90\", 2 \"180\""
    );
    let words = Heading::of(both.as_bytes(), &component(2)).words();
    assert_eq!(
        words,
        "EARTHQUAKE OF JANUARY 1, 2000 0000 GMT, NOWHERE, 1 OLD ROAD, ROOF, 180°"
    );
    for (text, fault) in [
        (
            nsmp(90, "VL", &first),
            "f:1: the file has a velocity or displacement; it must have an acceleration",
        ),
        (
            one.replacen("POINTS=  25", "POINTS=  20", 1),
            "f:10: more numbers than NO OF POINTS of line 7, 20",
        ),
        (
            one.replacen("POINTS=  25", "POINTS=  26", 1),
            "f:10: the numbers end after 25; NO OF POINTS of line 7 is 26",
        ),
        (
            one.replace("SAMPLES/SEC=200", "SAMPLES/SEC=0"),
            "f:6: SAMPLES/SEC must be > 0, got 0",
        ),
        (
            one.replacen("-267.957", "********", 1),
            "f:8: not a number: \"33.866********\"",
        ),
    ] {
        assert_eq!(refused(&text), fault);
    }
}

/// A file of each format with one record, the reading with which it has one, and marks without which it is none.
fn samples() -> Vec<(String, Reading, &'static [&'static str])> {
    let (values, g) = (thousandths(16, 9), tenths(16));
    let times: Vec<i64> = (0..16).map(|i| 4 * i + i / 4).collect();
    let marks: &[&str] = &[
        "ACCEL", "INSTR", "SENS", "CHAN", "STATION", "RMS", "LENGTH", "UNCOR", "POINTS", "SEC AND",
        "ACC",
    ];
    vec![
        (csmip(1, "UP", &values), Reading::default(), marks),
        (renadic(1, "EW", &g, 0), Reading::default(), marks),
        (usc(&g, &times), Reading::default(), marks),
        (
            esm(&values, "cm/s^2", "ACCELERATION"),
            Reading::default(),
            &["EVENT_NAME", "STATION_CODE", "NDATA", "STREAM", "DATA_TYPE"],
        ),
        (
            unam(&values, 8),
            column(2),
            &["ARCHIVO", "VERSION", "ORIENTACION", "NUM.", "DATOS DE"],
        ),
        (
            nsmp(90, "AC", &values),
            Reading::default(),
            &["JULIAN", "FILTER"],
        ),
    ]
}

#[test]
fn ends_of_lines_and_of_files_and_encodings_change_no_record() {
    for (text, reading, _) in samples() {
        let record = with(&text, reading).unwrap();
        for other in [
            text.replace('\n', "\r\n"),
            text.clone() + "\u{1a}",
            text.replace('\n', "\r\n") + "\u{1a}\0\0\r\n",
            text.clone() + "\n\n",
            text.clone() + "END OF DATA\n",
            text.clone() + "*** End Data ***\n",
            "\u{feff}".to_owned() + &text,
        ] {
            assert_eq!(with(&other, reading).as_ref(), Ok(&record), "{other}");
            for to in [u16::to_le_bytes, u16::to_be_bytes] {
                let units = [0xfeff]
                    .into_iter()
                    .chain(other.trim_start_matches('\u{feff}').encode_utf16());
                let bytes: Vec<u8> = units.flat_map(to).collect();
                assert_eq!(parse("f", &bytes, reading).as_ref(), Ok(&record));
            }
        }
    }
}

#[test]
fn no_line_that_is_missing_or_twice_there_changes_a_record_in_silence() {
    for (text, reading, _) in samples() {
        let record = with(&text, reading).unwrap();
        let lines: Vec<&str> = text.lines().collect();
        for i in 0..lines.len() {
            let without = [&lines[..i], &lines[i + 1..]].concat().join("\n");
            let twice = [&lines[..=i], &lines[i..]].concat().join("\n");
            for other in [without, twice] {
                let Ok(read) = with(&other, reading) else {
                    continue;
                };
                let same = read.values == record.values && read.times == record.times;
                let unit = read.unit.is_none() || read.unit == record.unit;
                assert!(
                    same && unit || read.doubts != record.doubts,
                    "line {}: {other}",
                    i + 1
                );
            }
        }
    }
}

#[test]
fn without_its_marks_a_file_is_in_no_format_and_each_says_why() {
    for (text, _, marks) in samples() {
        let bare = marks
            .iter()
            .fold(text, |text, mark| text.replace(mark, "x"));
        let lines: Vec<&str> = bare.lines().collect();
        let why = FORMATS.map(|format| match (format.find)(&lines) {
            Ok(()) => panic!("{} finds {bare}", format.name),
            Err(why) => format!("{} ({why})", format.name),
        });
        let fault = refused(&bare);
        // A table with a known step, and one of two columns whose first one has no times.
        let of_table = ["states a time step: give \"dt\"", "the times must rise"];
        let told =
            fault.contains(&why.join(", ")) || of_table.iter().any(|text| fault.contains(text));
        assert!(told, "{fault}");
    }
}

#[test]
fn a_table_of_pairs_may_have_no_blank_before_a_sign() {
    let text = "NOWHERE\nt and a in m/s2, as Fortran writes them\n0.000-0.12345\n0.005 1.0E-02\n0.010-2.0D-01\n0.015-.5\n";
    let record = read(text);
    assert_eq!(record.times, [0.0, 0.005, 0.01, 0.015]);
    assert_eq!(record.values, [-0.12345, 0.01, -0.2, -0.5]);
    // Three components in full fields, the second one behind a number that fills its field.
    let columns = "99.990-1.500100.000\n99.995-1.500200.000\n100.000-1.500300.000\n";
    let third = with(columns, column(3)).unwrap();
    assert_eq!(third.times, [99.99, 99.995, 100.0]);
    assert_eq!(third.values, [100.0, 200.0, 300.0]);
    // One number too few is no column less.
    let fault = with(&columns.replace("99.995-1.500200", "99.995-200"), column(3)).unwrap_err();
    assert_eq!(fault, "f:2: a row needs 3 numbers or more, got 2");
}
