//! The disturbed commands, each in a folder with the results of a former study, and their undisturbed results.

use crate::{Bench, Done, Tree, differences};
use serde_json::Value as Json;

/// A command, and the content of its output folder before and after an undisturbed run.
pub(crate) struct Scene {
    pub(crate) bench: Bench,
    /// The arguments of the command.
    pub(crate) words: &'static [&'static str],
    /// The output folder after a run of the former study.
    pub(crate) former: Tree,
    /// The output folder after an undisturbed run in an empty folder.
    pub(crate) wanted: Tree,
}

/// The output folder of every scene.
pub(crate) const OUT: &str = "figures";

/// The list of the files of runs, which changes during a run.
const MANIFEST: &str = "s/manifest.json";

/// A sweep in three chunks of few cases and a saltelli design, with a figure: all kinds of files with few writes.
fn study(betas: &str, figure: &str) -> String {
    format!(
        r#"{{ "problem": "friction-oscillator", "blocks": [
  {{ "parameters": {{ "law": "velocity-control", "beta": {{"range": {betas}}}, "dT": "pi/8", "duration": "8*pi",
      "x0": {{"linspace": [1, 20, 4000]}} }}, "when": "x0 > 19.99" }},
  {{ "parameters": {{ "law": "displacement-control", "alpha": {{"uniform": [0.1, 1]}}, "x0": {{"uniform": [8, 20]}},
      "dT": "pi/8", "duration": "8*pi" }}, "design": {{"kind": "saltelli", "n": 4, "seed": 1}} }}],
  "figures": [{{ "name": "{figure}", "kind": "metric", "x": "beta", "y": "rms_error",
      "where": {{"law": "velocity-control"}} }}] }}"#
    )
}

const LEDGER: &str = r#"{ "paper": "A paper", "studies": "studies", "claims": [
  { "id": "A1", "where": "section 1", "says": "It rises.", "quantity": "the error", "because": "It depends.",
    "readings": [{ "reading": "as printed", "study": "s", "figure": "new", "holds": true,
      "expect": [{ "metric": "rms_error", "min": 0, "max": 1 }] }] }] }"#;

impl Scene {
    /// A run over the results of the former study.
    pub(crate) fn run() -> Scene {
        Scene::of(&["run", "--jobs", "1", "--verbose"])
    }

    /// A run with histories.
    pub(crate) fn histories() -> Scene {
        Scene::of(&["run", "--jobs", "1", "--histories", "--verbose"])
    }

    /// A page about the study.
    pub(crate) fn report() -> Scene {
        Scene::of(&["report", "--jobs", "1"])
    }

    /// Claims about the study.
    pub(crate) fn claims() -> Scene {
        Scene::of(&["claims", "ledger.json", "--jobs", "1"])
    }

    /// All scenes.
    pub(crate) fn all() -> [Scene; 4] {
        [
            Scene::run(),
            Scene::histories(),
            Scene::report(),
            Scene::claims(),
        ]
    }

    fn of(words: &'static [&'static str]) -> Scene {
        let with = |study: String| {
            let bench = Bench::new();
            bench.file("studies/s.json", study);
            bench.file("ledger.json", LEDGER);
            let done = bench.run(words);
            assert_eq!(done.code, Some(0), "{words:?}: {done:?}");
            bench
        };
        let named = study("[0.1, 1.3, 0.1]", "new").replace(
            "\"name\": \"new\"",
            "\"name\": \"new\", \"title\": \"Former\"",
        );
        let study_before = match words[0] {
            // A claim names the figure. A run has a figure that the new study does not have.
            "claims" => named,
            _ => study("[0.1, 1.3, 0.1]", "old"),
        };
        let former = with(study_before).tree(OUT);
        let bench = with(study("[0.2, 1.1, 0.1]", "new"));
        let wanted = bench.tree(OUT);
        Scene {
            bench,
            words,
            former,
            wanted,
        }
    }

    /// Restores the former results.
    pub(crate) fn reset(&self) {
        self.bench.put(OUT, &self.former);
    }

    /// Asserts that every file of results has the bytes of the former or of the undisturbed run. Temporary files of a killed
    /// run are allowed if `temporary`. The manifest must list all files that a later run may have to remove.
    #[track_caller]
    pub(crate) fn only_complete_files(&self, temporary: bool, what: &str) {
        let tree = self.bench.tree(OUT);
        for (name, bytes) in &tree {
            if name == MANIFEST {
                continue;
            }
            let known = [&self.former, &self.wanted].map(|tree| tree.get(name));
            let ending = [".csv", ".png", ".svg", ".pdf", ".html", ".md", ".parquet"];
            let result = ending.iter().any(|ending| name.ends_with(ending));
            match known.iter().any(Option::is_some) {
                true => assert!(
                    known.contains(&Some(bytes)),
                    "{what}: {name} is not complete"
                ),
                false => assert!(temporary && !result, "{what}: {name} remains"),
            }
        }
        let Some(manifest) = tree.get(MANIFEST) else {
            return;
        };
        let read = serde_json::from_slice(manifest);
        let manifest: Json = read.unwrap_or_else(|e| panic!("{what}: the manifest: {e}"));
        let files = manifest["files"].as_array().unwrap();
        let unfinished = manifest["unfinished"]["cases"].as_u64().unwrap_or(0);
        let of_study = tree.keys().filter_map(|name| name.strip_prefix("s/"));
        let other = |name: &str| {
            name.is_empty()
                || name.ends_with('/')
                || name.ends_with(".partial")
                || name.starts_with("store/")
        };
        for name in of_study.filter(|name| !other(name) && *name != "manifest.json") {
            let case = name
                .strip_prefix("histories/")
                .and_then(|name| name.strip_suffix(".csv"));
            let listed = files.iter().any(|file| file == name)
                || case.is_some_and(|case| case.parse().is_ok_and(|case: u64| case < unfinished));
            assert!(listed, "{what}: the manifest does not name {name}");
        }
    }

    /// Asserts that an undisturbed run now gives the undisturbed results, and that the files it prints exist.
    #[track_caller]
    pub(crate) fn repaired(&self, what: &str) -> Done {
        let done = self.bench.run(self.words);
        assert_eq!(done.code, Some(0), "{what}: {done:?}");
        let printed = done.out.lines().filter(|_| self.words[0] != "claims");
        for path in printed {
            assert!(self.bench.path(path).exists(), "{what}: {path}");
        }
        self.complete(what);
        done
    }

    /// Asserts that the output folder is the same as after an undisturbed run.
    #[track_caller]
    pub(crate) fn complete(&self, what: &str) {
        let differ = differences(&self.bench.tree(OUT), &self.wanted);
        assert_eq!(differ, "", "{what}");
    }
}
