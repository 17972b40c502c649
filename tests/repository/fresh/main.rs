//! Whether what is committed is what the program writes now: figures/ and its hashes against the results of studies/, the claims, the
//! numbers of pages, and the schema.
//!
//! `make fresh` and `make evidence` compute all studies, and these tests read the results; nothing is computed here.

mod answers;
mod bridge_answers;
mod committed;
mod deck_answers;
mod evidence;
mod floor_answers;
mod hashes;
mod pictures;
mod population_answers;
mod shown;
mod tower_answers;

use serde_json::Value as Json;
use slipgap::study::search::slashes;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// A page among the results.
const CLAIMS: &str = "claims.md";
/// The program.
const PROGRAM: &str = env!("CARGO_BIN_EXE_slipgap-tested");

fn root() -> &'static Path {
    Path::new(env!("SLIPGAP_ROOT"))
}

/// The folder with the results of all studies.
fn results() -> PathBuf {
    let folder = std::env::var("SLIPGAP_RESULTS");
    PathBuf::from(
        folder.expect(
            "SLIPGAP_RESULTS, the folder that `make fresh` or `make evidence` has computed",
        ),
    )
}

/// The studies by programs of others, which no verb starts unasked.
const BY_PROGRAMS: &str = "programs/";

/// The names of all studies without programs of others: their paths in studies/ without `.json`.
fn studies() -> Vec<String> {
    let folder = root().join("studies");
    let files = walkdir::WalkDir::new(&folder)
        .sort_by_file_name()
        .into_iter()
        .map(|entry| entry.unwrap().into_path());
    let studies = files.filter(|file| file.extension().is_some_and(|ending| ending == "json"));
    let name = |file: PathBuf| {
        let relative = file.strip_prefix(&folder).unwrap().with_extension("");
        slashes(&relative)
    };
    let names = studies.map(name);
    let studies: Vec<String> = names
        .filter(|name| !name.starts_with(BY_PROGRAMS))
        .collect();
    assert!(studies.len() > 100, "{studies:?}");
    studies
}

/// The manifest that the run of a study has written last.
fn manifest(results: &Path, study: &str) -> Json {
    let path = results.join(study).join("manifest.json");
    let text = fs::read_to_string(&path)
        .unwrap_or_else(|e| panic!("{}: {e}: no results of {study}", path.display()));
    serde_json::from_str(&text).unwrap()
}

/// The tables and pictures of all studies, and the page of claims, by their paths in the folder of results.
fn outputs(results: &Path) -> BTreeSet<String> {
    let mut outputs = BTreeSet::from([CLAIMS.to_owned()]);
    for study in studies() {
        let manifest = manifest(results, &study);
        let listed = manifest["files"].as_array().unwrap().iter();
        let files = listed.map(|file| file.as_str().unwrap());
        let kept = files.filter(|file| file.ends_with(".csv") || file.ends_with(".png"));
        outputs.extend(kept.map(|file| format!("{study}/{file}")));
    }
    outputs
}

/// The files of the repository with these paths, as git knows them; `None` outside a repository.
fn tracked(paths: &[&str]) -> Option<BTreeSet<String>> {
    let mut command = Command::new("git");
    command.args(["ls-files", "-z", "--"]).args(paths);
    let output = command.current_dir(root()).output().ok()?;
    let text = String::from_utf8(output.stdout).unwrap();
    let names = text.split('\0').filter(|name| !name.is_empty());
    output
        .status
        .success()
        .then(|| names.map(String::from).collect())
}

/// The committed files of figures/ by their paths in it, without the list of hashes.
fn committed() -> BTreeSet<String> {
    let tracked = tracked(&["figures"]).expect("a git repository, which says what is committed");
    let names = tracked
        .iter()
        .filter_map(|name| name.strip_prefix("figures/"));
    names
        .filter(|name| *name != hashes::FILE)
        .map(String::from)
        .collect()
}

#[test]
#[ignore = "run by `make fresh`, next to the other committed output"]
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

/// Runs the program in the project's folder and gives its stdout.
fn slipgap(words: &[&str]) -> Vec<u8> {
    let output = Command::new(PROGRAM)
        .args(words)
        .current_dir(env!("SLIPGAP_ROOT"))
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "slipgap {words:?}: {said}");
    output.stdout
}
