//! Small files of SMC, COSMOS, GeoNet and tables, written by hand after the descriptions of the formats; no recorded motion.

use super::*;

/// Rows of `width` numbers in fields of a width, `places` of them given, the others 0.
fn block(rows: usize, width: usize, places: &[(usize, f64)], field: usize) -> String {
    let value = |i: usize| {
        places
            .iter()
            .find(|pair| pair.0 == i)
            .map_or(0.0, |pair| pair.1)
    };
    let row = |row: usize| {
        let cells = (0..width).map(|i| format!("{:>field$}", value(row * width + i)));
        cells.collect::<String>() + "\n"
    };
    (0..rows).map(row).collect()
}

/// An SMC file with this first line, number of values and sampling rate.
pub(super) fn smc(first: &str, count: f64, rate: f64, data: &str) -> String {
    let text = format!("{first}\n*\nA000\n2000 1 1 0000 Nowhere\n*\n*\n*\n*\n*\n*\n*\n");
    let whole = block(6, 8, &[(16, count), (15, 2.0)], 10);
    let numbers = block(10, 5, &[(1, rate)], 15);
    format!("{text}{whole}{numbers}|\n|a remark of 1 2 3\n{data}").replace('\n', "\r\n")
}

#[test]
fn smc_has_its_count_and_rate_in_the_header_and_no_blank_before_a_sign() {
    let data = " 8.4524E+1 1.2760E+0-4.1217E+1\n-1.0000E-2\n";
    let record = read(&smc("2 CORRECTED ACCELEROGRAM   ", 4.0, 200.0, data));
    assert_eq!(record.values, [84.524, 1.276, -41.217, -0.01]);
    assert_eq!(record.times, [0.0, 0.005, 0.01, 3.0 * 0.005]);
    assert_eq!(record.unit, Some(Unit::CentimetrePerSecond2));
    let raw = read(&smc("1 UNCORRECTED ACCELEROGRAM", 4.0, 200.0, data));
    assert_eq!(raw, record);
    for (text, fault) in [
        (
            smc("3 VELOCITY", 4.0, 200.0, data),
            "f:1: the file has a velocity; it must have an acceleration",
        ),
        (
            smc("2 CORRECTED ACCELEROGRAM", 5.0, 200.0, data),
            "f:31: the file ends after 4 numbers; whole number 17 of the header, in line 14 is 5",
        ),
        (
            smc("2 CORRECTED ACCELEROGRAM", 3.0, 200.0, data),
            "f:31: more numbers than whole number 17 of the header, in line 14, 3",
        ),
        (
            smc("2 CORRECTED ACCELEROGRAM", 0.0, 200.0, data),
            "f:14: whole number 17, the number of values, must be a whole number >= 2, got 0",
        ),
        (
            smc("2 CORRECTED ACCELEROGRAM", 4.0, 0.0, data),
            "f:18: number 2, the samples per second, must be > 0, got 0",
        ),
        (
            "2 CORRECTED ACCELEROGRAM\n*".into(),
            "f:2: the header needs line 12",
        ),
    ] {
        assert_eq!(refused(&text), fault);
    }
}

/// A COSMOS channel with this first word, time step in ms and data line.
pub(super) fn cosmos(first: &str, step: f64, data: &str) -> String {
    let text = format!(
        "{first}  (Format v01.20 with 3 text lines)\nNowhere on Fri\nSta Chan   1: 90 Deg (Rcrdr)\n"
    );
    let whole = block(10, 10, &[(1, 1.0)], 8);
    let numbers = block(20, 5, &[(61, step), (33, 1.0)], 15);
    format!(
        "{text} 100 Integer-header values follow on  10 lines, Format= (10I8)\n{whole} \
         100 Real-header values follow on  20 lines, Format= (5F15.6)\n{numbers}   1 Comment line(s) follow, each \
         starting with a \"|\":\n| 7 acceleration pts\n{data}"
    )
}

/// Three accelerations and two velocities.
pub(super) const COSMOS_V2: &str = "   3 acceleration pts, approx 0 secs, units=cm/sec2(04),Format=(2F8.3)\n   1.500-200.25\n 3e0\n\
   2 velocity     pts, approx 0 secs, units=cm/sec(05),Format=(2F8.3)\n   9.0 9.0\nEnd-of-data for Chan 1\n";

#[test]
fn cosmos_has_accelerations_before_velocities_and_channels_in_a_row() {
    let text = cosmos("Corrected acceleration", 5.0, COSMOS_V2);
    let record = read(&text);
    assert_eq!(record.values, [1.5, -200.25, 3.0]);
    assert_eq!(record.times, [0.0, 0.005, 0.01]);
    assert_eq!(record.unit, Some(Unit::CentimetrePerSecond2));
    let other = "  2 acceleration pts, approx 0 secs, units=g(02),Format=(1E15.6)\n 1.0e-1\n 2.0e-1\nEnd-of-data\n";
    let both = format!("{text}{}", cosmos("Uncorrected acceleration", 10.0, other));
    assert_eq!(with(&both, component(1)), Ok(record));
    let second = with(&both, component(2)).unwrap();
    assert_eq!(
        (second.values, second.times),
        (vec![0.1, 0.2], vec![0.0, 0.01])
    );
    assert_eq!(second.unit, Some(Unit::G));
    assert_eq!(
        refused(&both),
        "f:1: \"component\" must be the number of one of the file's components, 1 \"Sta Chan   1: 90 Deg\", 2 \"Sta Chan   1: 90 Deg\""
    );
    let channel = |data: &str| cosmos("Corrected acceleration", 5.0, data);
    let line = COSMOS_V2.lines().next().unwrap();
    for (text, fault) in [
        (
            channel(&format!("{line}\n 1 2\nEnd-of-data\n")),
            "f:40: not a number: \"End-of-data\"",
        ),
        (
            channel(&format!("{line}\n 1 2\n")),
            "f:39: the file ends after 2 numbers; the number of points of line 38 is 3",
        ),
        (
            channel(&format!("{line}\n 1 2\n 3 4\n")),
            "f:40: more numbers than the number of points of line 38, 3",
        ),
        (
            channel("nothing\n"),
            "f:38: the header needs the line \"acceleration\"",
        ),
        (
            cosmos("Corrected acceleration", -999.0, COSMOS_V2),
            "f:15: real header 62, the time step in ms, must be > 0, got -999",
        ),
        (
            cosmos("Corrected velocity", 5.0, COSMOS_V2),
            "f:1: the file has a velocity or displacement; it must have an acceleration",
        ),
    ] {
        assert_eq!(refused(&text), fault);
    }
}

/// A GeoNet component with this number of accelerations and time step.
pub(super) fn geonet(name: &str, count: f64, dt: f64, data: &str) -> String {
    let text = format!(
        "Corrected accelerogram 20000101 Nowhere\n{}Component {name}\nAcceleration:\nVelocity:\nDisplacement:\n",
        "x\n".repeat(11)
    );
    let whole = block(4, 10, &[(33, count), (30, 99.0)], 8);
    let numbers = block(6, 10, &[(24, 0.001), (25, dt)], 8);
    format!("{text}{whole}{numbers}{data}")
}

#[test]
fn geonet_has_a_step_and_a_count_for_each_component() {
    let first = geonet(
        "N28W",
        12.0,
        0.02,
        &format!("{}  -0.5 1.5\n 7 8\n", " 1.5-2.5".repeat(5) + "\n"),
    );
    let record = read(&first);
    assert_eq!(record.values[8..], [1.5, -2.5, -0.5, 1.5]);
    assert_eq!((record.values.len(), record.times[11]), (12, 11.0 * 0.02));
    assert_eq!(record.unit, Some(Unit::MillimetrePerSecond2));
    let both = first.clone() + &geonet("Up    Vertical", 2.0, 0.005, " 3.0 4.0\n");
    assert_eq!(with(&both, component(1)).unwrap(), record);
    let up = with(&both, component(2)).unwrap();
    assert_eq!((up.values, up.times), (vec![3.0, 4.0], vec![0.0, 0.005]));
    let several = "f:1: \"component\" must be the number of one of the file's components, 1 \"N28W\", 2 \"Up    Vertical\"";
    assert_eq!(refused(&both), several);
    assert_eq!(
        with(&both, component(3)).unwrap_err(),
        format!("{several}, got 3")
    );
    for (text, fault) in [
        (
            geonet("Up", 13.0, 0.02, " 1 2\n"),
            "f:27: the file ends after 2 numbers; field 4 of line 20 is 13",
        ),
        (
            geonet("Up", 0.5, 0.02, " 1 2\n"),
            "f:20: field 4, the number of accelerations, must be a whole number >= 2, got 0.5",
        ),
        (
            geonet("Up", 2.5, 0.02, " 1 2 3\n"),
            "f:20: field 4, the number of accelerations, must be a whole number >= 2, got 2.5",
        ),
        (
            geonet("Up", 2.0, 0.0, " 1 2\n"),
            "f:23: field 6, the time step, must be > 0, got 0",
        ),
    ] {
        assert_eq!(refused(&text), fault);
    }
}

#[test]
fn a_table_may_have_several_columns_or_no_times() {
    let table = "t (s),a_x (m/s2),a_y (cm/s2)\n0,1,2\n0.5,3,4\n";
    let column = |number| Reading {
        column: Some(number),
        ..Reading::default()
    };
    let y = with(table, column(3)).unwrap();
    assert_eq!((y.times, y.values), (vec![0.0, 0.5], vec![2.0, 4.0]));
    assert_eq!(y.unit, Some(Unit::CentimetrePerSecond2));
    let x = with(table, column(2)).unwrap();
    assert_eq!(
        (x.values, x.unit),
        (vec![1.0, 3.0], Some(Unit::MetrePerSecond2))
    );
    let even = |dt, column| Reading {
        dt: Some(dt),
        column,
        ..Reading::default()
    };
    let one = with("a in (g)\n1\n-2\n 3 \n", even(0.01, None)).unwrap();
    assert_eq!(
        (one.times, one.values),
        (vec![0.0, 0.01, 0.02], vec![1.0, -2.0, 3.0])
    );
    assert_eq!(one.unit, Some(Unit::G));
    // Without times the first column may be the one.
    let plain = table.replace("t (s)", "a_z");
    assert_eq!(with(&plain, even(0.5, Some(1))).unwrap().values, [0.0, 0.5]);
    for (text, reading, fault) in [
        (
            table,
            column(1),
            "f:1: column 1 has the times; give another column, or \"dt\" if the table has no times",
        ),
        (
            table,
            column(4),
            "f:2: a row needs 4 numbers or more, got 3",
        ),
        (
            table,
            even(0.1, None),
            "f:1: column 1 has the times; give another column, or \"dt\" if the table has no times",
        ),
        (
            "a\nb",
            even(0.1, None),
            "f:2: the file has no row of numbers",
        ),
        (
            table,
            Reading {
                component: Some(1),
                ..column(2)
            },
            "f:1: the file is a table, which has columns and no components; give no component",
        ),
        (
            table,
            component(1),
            "f:1: the file is a table, which has one component; give none",
        ),
    ] {
        assert_eq!(with(text, reading).unwrap_err(), fault);
    }
    let at2 = "NPTS= 2, DT= 1\n1 2\n";
    let fault = with(at2, component(1)).unwrap_err();
    assert_eq!(
        fault,
        "f:1: the file is PEER AT2, which has one component; give none"
    );
}

#[test]
fn an_unknown_format_says_what_was_tried() {
    let text = "some header\n1 2 3 4 5\n6 7 8 9 10\n";
    let fault = refused(text);
    let (first, tried) = fault
        .split_once("; the file is in no other format, either: ")
        .unwrap();
    assert_eq!(
        first,
        "f:2: a row must have two numbers, t and a, with decimal points, got 5; of several columns give \"column\""
    );
    let lines: Vec<&str> = text.lines().collect();
    let why =
        FORMATS.map(|format| format!("{} ({})", format.name, (format.find)(&lines).unwrap_err()));
    assert_eq!(tried, why.join(", "));
    for why in [
        "PEER AT2 (no line of the first 20 names NPTS and DT)",
        "SMC (line 1 does not begin with a digit",
    ] {
        assert!(tried.contains(why), "{tried}");
    }
}

#[test]
fn an_end_line_of_at2_is_no_number() {
    let text = "x\nx\nUNITS OF G\nNPTS= 3, DT= .01 SEC\n 1 2\n 3\n*** End Data ***\n";
    assert_eq!(read(text).values, [1.0, 2.0, 3.0]);
    let fault = refused(&text.replace(" 3\n", ""));
    assert_eq!(
        fault,
        "f:5: the file ends after 2 numbers; NPTS of line 4 is 3"
    );
}
