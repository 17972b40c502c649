use super::*;
use crate::batch::chunk::parts;
use crate::solve::Unsolvable;
use crate::study::parse;

/// A study with numbers, names, an axis, and a case that has no solution.
fn study() -> Study {
    let text = r#"{"problem": "bar-impact", "parameters": {"gamma": {"geomspace": [0.1, 10, 40]}, "n": [2, 3],
        "dt": 0.25, "duration": 1.5, "mass": ["lumped", "consistent"]}}"#;
    parse("s.json", text).unwrap()
}

/// The only part of the study, with its key, its cases and numbers that could be results.
fn part(study: &Study) -> (Key, Cases, MetricTable) {
    let part = parts(study, 0).pop().unwrap();
    let cases = part.cases();
    let width = study.problem.metrics().len();
    let mut found = MetricTable::new(cases.len(), width);
    for case in 0..cases.len() {
        found.set(case, (0..width).map(|metric| 1.0 / (case + metric) as f64));
    }
    found.fail(3, Unsolvable::Stored("no solution".into()));
    (Key::new(study, 0, &cases), cases, found)
}

/// The file in which a store keeps it.
fn kept(folder: &Path) -> PathBuf {
    let [(0, path)] = &there(&folder.join(STORE)).unwrap()[..] else {
        panic!("one part");
    };
    path.clone()
}

#[test]
fn results_of_another_solver_do_not_serve() {
    let (folder, study) = (tempfile::tempdir().unwrap(), study());
    let (key, cases, found) = part(&study);
    let other = Key {
        solver: "1 0123456789abcdef".into(),
        ..key.clone()
    };
    let store = Store::open(folder.path()).unwrap();
    store.put(&study, 0, &other, (0, &cases), &found).unwrap();
    drop(store);
    let store = Store::open(folder.path()).unwrap();
    let told = store.find(&study, 0, &key, cases.len()).unwrap_err();
    assert_eq!(told.unwrap(), "computed by another version of the solver");
    let same = store.find(&study, 0, &other, cases.len()).unwrap();
    for metric in &study.metrics {
        let bits = |found: &MetricTable| {
            found
                .column(*metric)
                .map(|x| x.map(f64::to_bits))
                .collect::<Vec<_>>()
        };
        // A case without a solution has no metrics, and those that were not asked for are not kept.
        assert_eq!(bits(&same), bits(&found));
    }
    let why = Unsolvable::Stored("no solution".into());
    assert_eq!(same.failures().collect::<Vec<_>>(), [(3, &why)]);
}

/// Numbers that look random, after Steele et al. (2014).
fn splitmix(state: &mut u64) -> u64 {
    *state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
    let mut z = *state;
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[test]
fn a_forged_part_with_the_right_sum_is_damaged_and_no_panic() {
    let (folder, study) = (tempfile::tempdir().unwrap(), study());
    let (key, cases, found) = part(&study);
    Store::open(folder.path())
        .unwrap()
        .put(&study, 0, &key, (0, &cases), &found)
        .unwrap();
    let path = kept(folder.path());
    let good = fs::read(&path).unwrap();
    fs::remove_file(&path).unwrap();
    // Of 20 000 rounds 9 make the library panic, one of them among these; SLIPGAP_FORGED asks for more.
    let rounds: u64 = std::env::var("SLIPGAP_FORGED").map_or(700, |n| n.parse().unwrap());
    let (mut random, mut damaged) = (1, 0);
    for round in 0..rounds {
        let mut forged = good.clone();
        for _ in 0..1 + splitmix(&mut random) % 4 {
            let footer = round % 2 == 0;
            let from = if footer { good.len() * 2 / 3 } else { 0 };
            let at = from + splitmix(&mut random) as usize % (good.len() - from);
            forged[at] = splitmix(&mut random) as u8;
        }
        let name = format!("part-{:012}-{}.parquet", 0, checksum(&forged));
        let path = folder.path().join(STORE).join(name);
        fs::write(&path, &forged).unwrap();
        let store = Store::open(folder.path()).unwrap();
        match store.find(&study, 0, &key, cases.len()) {
            // What was changed decides nothing, or is a number.
            Ok(found) => assert_eq!(found.len(), cases.len()),
            Err(why) => damaged += u64::from(why == Some(format!("{} is damaged", path.display()))),
        }
        // Read as text by `slipgap compare`: rows or an error.
        let _ = rows(folder.path());
        fs::remove_file(&path).unwrap();
    }
    assert!(damaged > rounds / 20, "{damaged} of {rounds}");
}

#[test]
fn a_panic_is_an_answer() {
    assert_eq!(caught(|| 1), Some(1));
    let empty: Vec<u8> = Vec::new();
    assert_eq!(caught(|| empty[0]), None);
}

#[test]
fn only_names_that_a_run_gives_are_parts() {
    let sum = "0123456789abcdef0123456789abcdef";
    let start = |name: String| named(Path::new(&name)).map(|(start, _)| start);
    assert_eq!(
        start(format!("part-000000016384-{sum}.parquet")),
        Some(16_384)
    );
    assert_eq!(
        start(format!("part-1000000000000-{sum}.parquet")),
        Some(1_000_000_000_000)
    );
    for other in [
        format!("part-+00000016384-{sum}.parquet"),
        format!("part-000000016384-{}.parquet", &sum[1..]),
        format!("part-000000016384-{}.parquet", sum.to_uppercase()),
        format!("part-000000016384-{sum} (copy).parquet"),
        format!("part-000000016384-{sum}.csv"),
        format!("my-part-000000016384-{sum}.parquet"),
        "part-1-mine.parquet".into(),
    ] {
        assert_eq!(start(other.clone()), None, "{other}");
    }
}
