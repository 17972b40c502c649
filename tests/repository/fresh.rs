//! Whether what is committed is what the program writes now: figures/ against a run of studies/, and the schema.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Most that a channel may differ, of 255. The numbers drawn are the same to the bit, but processors differ in how they
/// round the single-precision sums that blend a pixel, by one or two steps of a channel.
const CHANNEL: u8 = 2;
/// Pixels that may differ by more, where such a sum tips an edge over: fewer than a full stop covers.
const PIXELS: usize = 8;

/// Files that are made on demand and not committed.
const BESIDE: [&str; 2] = ["manifest.json", "report.html"];

#[test]
#[ignore = "runs every study; run by `make fresh`"]
fn committed_results_are_what_a_run_writes_now() {
    let root = Path::new(env!("SLIPGAP_ROOT"));
    // The test of the claims reads these stores later. Here everything is computed.
    let now = Path::new(env!("CARGO_TARGET_TMPDIR")).join("fresh");
    if now.exists() {
        fs::remove_dir_all(&now).unwrap();
    }
    let out = now.to_str().unwrap();
    slipgap(&["run", "studies", "--out", out]);
    slipgap(&["claims", "--out", out]);
    let committed = root.join("figures");

    let (old, new) = (results(&committed), results(&now));
    assert!(!new.is_empty(), "a run of studies/ wrote nothing");
    let mut differences: Vec<String> = Vec::new();
    for name in old.difference(&new) {
        differences.push(format!(
            "{}: committed, but no study writes it",
            name.display()
        ));
    }
    for name in new.difference(&old) {
        differences.push(format!(
            "{}: written now, but not committed",
            name.display()
        ));
    }
    for name in old.intersection(&new) {
        let (old, new) = (committed.join(name), now.join(name));
        let difference = match name.extension().is_some_and(|e| e == "png") {
            true => compare_pictures(&Picture::read(&old), &Picture::read(&new)),
            false => compare_text(&old, &new),
        };
        differences.extend(difference.map(|what| format!("{}: {what}", name.display())));
    }
    assert!(
        differences.is_empty(),
        "figures/ is not what `make figures` writes now:\n  {}",
        differences.join("\n  ")
    );
}

#[test]
#[ignore = "run by `make fresh`, beside the other committed output"]
fn committed_schema_and_its_pages_are_what_the_program_prints_now() {
    let root = Path::new(env!("SLIPGAP_ROOT"));
    let mut files = vec![
        ("schema/study.json".to_owned(), vec!["schema"]),
        (
            "docs/study-files.md".to_owned(),
            vec!["schema", "--markdown"],
        ),
    ];
    for problem in slipgap::study::problem_pages() {
        let page = format!("docs/study-files-{problem}.md");
        files.push((page, vec!["schema", "--markdown", problem]));
    }
    for (file, words) in files {
        let now = slipgap(&words);
        let committed = fs::read(root.join(&file)).unwrap();
        assert!(
            committed == now,
            "{file} is not what `make schema` writes now"
        );
    }
}

/// The release build that the Makefile names, or else the one of the tests, which is slower.
fn program() -> String {
    std::env::var("SLIPGAP_PROGRAM").unwrap_or_else(|_| env!("CARGO_BIN_EXE_slipgap-tested").into())
}

/// Runs the program in the project's folder and gives its stdout.
fn slipgap(words: &[&str]) -> Vec<u8> {
    let output = Command::new(program())
        .args(words)
        .current_dir(env!("SLIPGAP_ROOT"))
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "slipgap {words:?}: {said}");
    output.stdout
}

/// The files under `folder` that are committed: all but what .gitignore names.
fn results(folder: &Path) -> BTreeSet<PathBuf> {
    walkdir::WalkDir::new(folder)
        .into_iter()
        .filter_entry(|entry| {
            let name = entry.file_name().to_string_lossy();
            name != "histories" && name != "store" && !name.starts_with("recommend-")
        })
        .map(|entry| entry.unwrap())
        .filter(|entry| {
            entry.file_type().is_file() && !BESIDE.iter().any(|name| entry.file_name() == *name)
        })
        .map(|entry| entry.path().strip_prefix(folder).unwrap().to_owned())
        .filter(|name| name.extension().is_none_or(|e| e != "svg" && e != "pdf"))
        .collect()
}

/// Where two files differ first: they must be the same, byte for byte.
fn compare_text(old: &Path, new: &Path) -> Option<String> {
    let (old, new) = (fs::read(old).unwrap(), fs::read(new).unwrap());
    if old == new {
        return None;
    }
    let (old, new) = (String::from_utf8_lossy(&old), String::from_utf8_lossy(&new));
    let same = old
        .split('\n')
        .zip(new.split('\n'))
        .take_while(|(a, b)| a == b)
        .count();
    let line = |text: &str| text.split('\n').nth(same).unwrap_or("(ends)").to_owned();
    Some(format!(
        "line {}:\n    committed {}\n    now       {}",
        same + 1,
        line(&old),
        line(&new)
    ))
}

/// How two pictures differ by more than the tolerance.
fn compare_pictures(old: &Picture, new: &Picture) -> Option<String> {
    if (old.width, old.height, old.channels) != (new.width, new.height, new.channels) {
        return Some(format!("{old} committed, {new} now"));
    }
    let far = |(a, b): (&[u8], &[u8])| a.iter().zip(b).any(|(a, b)| a.abs_diff(*b) > CHANNEL);
    let (a, b) = (old.data.chunks(old.channels), new.data.chunks(new.channels));
    let count = a.zip(b).filter(|&pair| far(pair)).count();
    (count > PIXELS)
        .then(|| format!("{count} pixels differ by more than {CHANNEL} of 255, {PIXELS} may"))
}

#[test]
fn a_full_stop_more_is_a_difference() {
    let picture = |grey: u8, dots: usize| Picture {
        width: 100,
        height: 50,
        channels: 3,
        data: [[0; 3], [grey; 3]]
            .iter()
            .zip([dots, 5000 - dots])
            .flat_map(|(pixel, count)| pixel.repeat(count))
            .collect(),
    };
    let plain = picture(255, 0);
    assert_eq!(compare_pictures(&plain, &picture(255 - CHANNEL, 0)), None);
    assert_eq!(compare_pictures(&plain, &picture(255, PIXELS)), None);
    assert!(compare_pictures(&plain, &picture(255, PIXELS + 1)).is_some());
    assert!(compare_pictures(&plain, &picture(254 - CHANNEL, 0)).is_some());
    let wider = Picture {
        width: 101,
        ..picture(255, 0)
    };
    assert!(compare_pictures(&plain, &wider).is_some());
}

/// A picture as 8-bit samples.
struct Picture {
    width: u32,
    height: u32,
    channels: usize,
    data: Vec<u8>,
}

impl Picture {
    fn read(path: &Path) -> Picture {
        let file = std::io::BufReader::new(fs::File::open(path).unwrap());
        let mut decoder = png::Decoder::new(file);
        decoder.set_transformations(png::Transformations::normalize_to_color8());
        let mut reader = decoder.read_info().unwrap();
        let mut data = vec![0; reader.output_buffer_size().unwrap()];
        let info = reader.next_frame(&mut data).unwrap();
        data.truncate(info.buffer_size());
        Picture {
            width: info.width,
            height: info.height,
            channels: info.color_type.samples(),
            data,
        }
    }
}

impl std::fmt::Display for Picture {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Picture {
            width,
            height,
            channels,
            ..
        } = self;
        write!(f, "{width} x {height} pixels of {channels} bytes")
    }
}
