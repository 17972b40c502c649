//! The records of the folder `records`, compared with an independent program (tests/reference/records.py), with the printed spectral
//! displacements of their source, and with their page.

use serde_json::Value as Json;
use sha2::{Digest, Sha256};
use slipgap_system::system::loads::record::{Reading, Record, parse};
use slipgap_system::system::loads::{Unit, signal, spectrum};
use slipgap_system::system::structure::{Signal, Table};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

fn folder() -> PathBuf {
    Path::new(env!("SLIPGAP_ROOT")).join("records")
}

fn bytes(file: &str) -> Vec<u8> {
    fs::read(folder().join(file)).unwrap_or_else(|why| panic!("{file}: {why}"))
}

fn record(file: &str) -> Record {
    parse(file, &bytes(file), Reading::default()).unwrap_or_else(|why| panic!("{why}"))
}

/// The acceleration in m/s2.
fn acceleration(record: &Record) -> Table {
    match &*signal(record, None, 1.0).unwrap() {
        Signal::Table(table) => table.clone(),
        Signal::Sine { .. } | Signal::Motion(..) => panic!("no table"),
    }
}

fn reference() -> Json {
    serde_json::from_str(include_str!("../../data/records.json")).unwrap()
}

fn number(json: &Json) -> f64 {
    json.as_f64().unwrap()
}

fn near(a: f64, b: f64, tolerance: f64, what: &str) {
    assert!((a - b).abs() <= tolerance * b.abs(), "{what}: {a} {b}");
}

#[test]
fn the_files_have_the_values_of_an_independent_program() {
    let reference = reference();
    let records = reference["records"].as_array().unwrap();
    assert_eq!(records.len(), 8);
    for expected in records {
        let file = expected["file"].as_str().unwrap();
        let parsed = record(file);
        assert_eq!(
            parsed.values.len() as f64,
            number(&expected["count"]),
            "{file}"
        );
        assert_eq!(
            parsed.unit.map(Unit::in_m_s2),
            expected["unit"].as_f64(),
            "{file}"
        );
        let ends = [parsed.values[0], parsed.values[parsed.values.len() - 1]];
        assert_eq!(
            ends.map(Some),
            [0, 1].map(|i| expected["ends"][i].as_f64()),
            "{file}"
        );
        let dt = number(&expected["dt"]);
        // Round-off of i dt.
        let even = parsed
            .times
            .iter()
            .enumerate()
            .all(|(i, t)| (t - i as f64 * dt).abs() < 1e-12);
        assert!(even, "{file}");
        let squares = parsed.values.iter().map(|a| a * a).sum::<f64>();
        // numpy sums in another order: some thousand roundings.
        near(squares, number(&expected["sum_of_squares"]), 1e-12, file);
    }
}

#[test]
fn spectral_displacements_are_those_of_the_source_and_of_an_independent_program() {
    // Printed with the records: 5 % damping, straight lines between the points, in continuous time.
    let printed = [
        (
            "lomaprieta-1989-redwoodcity-apeel2-043.smc",
            [0.00284053, 0.03222445, 0.28925310, 0.13652020, 0.18751497],
        ),
        (
            "lomaprieta-1989-redwoodcity-apeel2-133.smc",
            [0.00236992, 0.02752084, 0.13812305, 0.09676948, 0.10768184],
        ),
        (
            "lomaprieta-1989-sanfrancisco-shafter-360.smc",
            [0.00247211, 0.01317996, 0.01555161, 0.02222248, 0.04126632],
        ),
        (
            "lomaprieta-1989-sanfrancisco-shafter-270.smc",
            [0.00159943, 0.00728037, 0.01857998, 0.05698925, 0.07008496],
        ),
        (
            "lomaprieta-1989-sanfrancisco-shafter-up.smc",
            [0.00109237, 0.00338985, 0.01316786, 0.02919696, 0.02782374],
        ),
    ];
    let reference = reference();
    let periods: Vec<f64> = reference["periods"]
        .as_array()
        .unwrap()
        .iter()
        .map(number)
        .collect();
    for expected in reference["records"].as_array().unwrap() {
        let file = expected["file"].as_str().unwrap();
        let ordinates = spectrum::spectrum(&acceleration(&record(file)), &periods, 0.05).unwrap();
        for (i, ordinate) in ordinates.iter().enumerate() {
            // Closed forms and Taylor coefficients with round-off of some thousand steps.
            near(
                ordinate.displacement,
                number(&expected["sd"][i]),
                1e-9,
                file,
            );
        }
        if let Some((_, printed)) = printed.iter().find(|row| row.0 == file) {
            for (ordinate, printed) in ordinates.iter().zip(printed) {
                // Half a unit of the last printed digit, and round-off.
                assert!((ordinate.displacement - printed).abs() < 5.1e-9, "{file}");
            }
        }
    }
}

/// The rows of the tables of the page, by file: the cells after its name, table by table.
fn page() -> BTreeMap<String, Vec<Vec<String>>> {
    let text = fs::read_to_string(folder().join("README.md")).unwrap();
    let mut rows = BTreeMap::<String, Vec<Vec<String>>>::new();
    for line in text.lines().filter(|line| line.starts_with("| ")) {
        let cells: Vec<String> = line
            .trim_matches('|')
            .split('|')
            .map(|cell| cell.trim().to_owned())
            .collect();
        if cells[0].ends_with(".smc") || cells[0].ends_with(".v2a") {
            rows.entry(cells[0].clone())
                .or_default()
                .push(cells[1..].to_vec());
        }
    }
    rows
}

#[test]
fn the_page_has_every_file_with_its_hash_and_numbers() {
    let page = page();
    let mut files: Vec<String> = fs::read_dir(folder())
        .unwrap()
        .map(|file| file.unwrap().file_name())
        .map(|name| name.into_string().unwrap())
        .collect();
    files.retain(|name| name != "README.md");
    files.sort();
    assert_eq!(files, page.keys().cloned().collect::<Vec<_>>());
    let reference = reference();
    let of = |file: &str| {
        let records = reference["records"].as_array().unwrap();
        records
            .iter()
            .find(|record| record["file"] == file)
            .unwrap()
            .clone()
    };
    for (file, rows) in &page {
        let [about, measures, source] = &rows[..] else {
            panic!("{file} is in {} tables", rows.len());
        };
        let hash: String = Sha256::digest(bytes(file))
            .iter()
            .map(|byte| format!("{byte:02x}"))
            .collect();
        assert_eq!(source.last(), Some(&hash), "{file}");
        let (parsed, expected) = (record(file), of(file));
        let cell = |text: &String| text.parse::<f64>().unwrap();
        assert_eq!(cell(&about[5]), parsed.values.len() as f64);
        // Half a unit of the last printed digit; the page has velocities at the points, which leave out up to 1 % of a peak between.
        let pga = number(&expected["pga"]) / 9.80665;
        assert!((cell(&measures[0]) - pga).abs() <= 5.1e-5, "{file}");
        near(
            cell(&measures[1]),
            number(&expected["pgv_without_mean"]),
            0.01,
            file,
        );
        near(cell(&measures[2]), number(&expected["pgv"]), 0.01, file);
        assert!(
            (cell(&measures[4]) - number(&expected["d5_95"])).abs() <= 0.051,
            "{file}"
        );
    }
}

/// Real files of other formats with their values, which are not part of the repository: `SLIPGAP_RECORDS` names a folder with a file
/// `NAME.json` for each file `NAME`.
#[test]
#[ignore = "needs a folder of records, SLIPGAP_RECORDS"]
fn real_files_have_the_values_beside_them() {
    let Some(folder) = std::env::var_os("SLIPGAP_RECORDS") else {
        println!("SLIPGAP_RECORDS names no folder: nothing is compared");
        return;
    };
    let mut compared = 0;
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.extension().is_none_or(|end| end != "json") {
            continue;
        }
        let expected: Json = serde_json::from_slice(&fs::read(&path).unwrap()).unwrap();
        let file = path.with_file_name(expected["file"].as_str().unwrap());
        let bytes = fs::read(&file).unwrap();
        let channels = expected["channels"].as_array().unwrap();
        for (i, channel) in channels.iter().enumerate() {
            let what = format!("{}, channel {i}", file.display());
            let reading = Reading {
                component: (channels.len() > 1).then_some(i + 1),
                ..Reading::default()
            };
            let parsed = parse(&what, &bytes, reading).unwrap_or_else(|why| panic!("{why}"));
            let n = parsed.values.len();
            assert_eq!(n as f64, number(&channel["n"]), "{what}");
            assert_eq!(
                parsed.unit.map(Unit::in_m_s2),
                channel["to_m_per_s2"].as_f64(),
                "{what}"
            );
            let dt = number(&channel["dt"]);
            near(parsed.times[n - 1], (n - 1) as f64 * dt, 1e-14, &what);
            for (values, key) in [
                (&parsed.values[..5], "first5"),
                (&parsed.values[n - 5..], "last5"),
            ] {
                let expected: Vec<f64> = channel[key]
                    .as_array()
                    .unwrap()
                    .iter()
                    .map(number)
                    .collect();
                assert_eq!(values, expected, "{what}");
            }
            let peak = number(&channel["index_of_peak"]) as usize;
            assert_eq!(parsed.values[peak], number(&channel["peak"]), "{what}");
            let squares = parsed.values.iter().map(|a| a * a).sum::<f64>();
            near(squares, number(&channel["sum_of_squares"]), 1e-12, &what);
            compared += 1;
        }
    }
    assert!(compared > 0);
}
