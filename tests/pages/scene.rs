//! A folder in which the commands of a page run one after another, with the studies that the page writes.

use crate::bench::Bench;
use crate::command::{Command, other_program};
use crate::page::Place;
use serde_json::{Map, Value};
use std::fs;
use std::path::Path;

/// What the page has written and run so far.
pub(crate) struct Scene {
    bench: Bench,
    /// The studies that the page writes: name, where, and whether a command of the page has used it since.
    studies: Vec<(String, Place, bool)>,
    /// Studies of the repository that are in the folder.
    shipped: Vec<String>,
    pub(crate) commands: usize,
    pub(crate) blocks: usize,
}

impl Scene {
    pub(crate) fn new() -> Scene {
        Scene {
            bench: Bench::new(),
            studies: Vec::new(),
            shipped: Vec::new(),
            commands: 0,
            blocks: 0,
        }
    }

    /// `FILE from PATH`: a file of the repository under the name that the page gives it. `FOLDER/START* from PATH`: those of a folder.
    pub(crate) fn copy(&mut self, file: &str, path: &str) {
        let source = Path::new(env!("SLIPGAP_ROOT")).join(path);
        let Some((folder, start)) = file
            .strip_suffix('*')
            .and_then(|name| name.rsplit_once('/'))
        else {
            let bytes = fs::read(source);
            let bytes = bytes.unwrap_or_else(|e| panic!("{path}: {e}"));
            return self.bench.file(file, bytes);
        };
        let entries = fs::read_dir(source).unwrap_or_else(|e| panic!("{path}: {e}"));
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        let mut names = names.filter(|name| name.starts_with(start)).peekable();
        assert!(names.peek().is_some(), "{path} has no {start}*");
        for name in names {
            self.copy(&format!("{folder}/{name}"), &format!("{path}/{name}"));
        }
    }

    /// A whole study for a file.
    pub(crate) fn write(&mut self, line: &str, file: &str, text: &str) {
        parse(line, text);
        self.bench.file(file, text);
        self.written(line, file);
    }

    fn written(&mut self, line: &str, file: &str) {
        self.studies.retain(|study| study.0 != file);
        self.studies.push((file.to_owned(), line.to_owned(), false));
        self.blocks += 1;
    }

    /// The keys of a block replace those of the object at `path` of a study; a list there gets the block as a further item.
    /// `study` is a file that is there already, or a study as JSON.
    pub(crate) fn merge(&mut self, line: &str, study: &str, path: &str, text: &str) {
        let is_file = !study.starts_with('{');
        let file = if is_file { study } else { "example.json" };
        let mut root = match is_file {
            true => {
                let text = fs::read_to_string(self.bench.path(file));
                parse(
                    line,
                    &text.unwrap_or_else(|e| panic!("{line}: {file}: {e}")),
                )
            }
            false => parse(line, study),
        };
        let mut target = &mut root;
        for key in path.split('.').filter(|key| !key.is_empty()) {
            target = &mut target[key];
        }
        if let Value::Array(items) = target {
            items.push(parse(line, text));
        } else {
            if target.is_null() {
                *target = Value::Object(Map::new());
            }
            let block = parse(line, text);
            let keys = target
                .as_object_mut()
                .unwrap_or_else(|| panic!("{line}: {path} is no object and no list"));
            keys.extend(block.as_object().unwrap().clone());
        }
        self.bench.file(file, root.to_string());
        self.written(line, file);
        if !is_file {
            self.check_studies(false);
        }
    }

    /// Runs a command and tests its exit code.
    pub(crate) fn run(&mut self, at: &str, line: &str, more: &[String], code: i32) {
        self.commands += 1;
        let command = Command::parse(line);
        if command.program() != "slipgap" {
            return other_program(at, &command);
        }
        let mut args = command.args().to_vec();
        for study in args.clone().iter().filter(|arg| arg.ends_with(".json")) {
            let repository = Path::new(env!("SLIPGAP_ROOT")).join(study);
            if !self.bench.path(study).exists() && repository.is_file() {
                self.copy(study, study);
                self.shipped.push(study.clone());
            }
            if let Some(entry) = self.studies.iter_mut().find(|entry| entry.0 == *study) {
                entry.2 |= ["run", "check"].contains(&args[0].as_str());
            }
        }
        // Other tests run the studies of the repository (tests/repository), some of which take minutes here.
        let shipped = args.iter().find(|arg| self.shipped.contains(arg));
        if let (Some(study), "run" | "check") = (shipped, args[0].as_str()) {
            args = vec!["list".into(), study.clone()];
        }
        if ["run", "check", "calibrate"].contains(&args[0].as_str()) {
            args.extend_from_slice(more);
        }
        let args: Vec<&str> = args.iter().map(String::as_str).collect();
        let done = self.bench.run(&args);
        assert_eq!(done.code, Some(code), "{at}: {line}\n{}", done.err);
        if let Some(file) = &command.into {
            self.bench.file(file, &done.out);
        }
    }

    /// Tests every study that the page has written and that no command has run: it has no mistake, and it runs.
    pub(crate) fn check_studies(&mut self, list_only: bool) {
        for (file, line, used) in std::mem::take(&mut self.studies) {
            let verbs: &[&str] = match used || list_only {
                true => &["list"],
                false => &["list", "run", "check"],
            };
            for verb in verbs {
                let done = self.bench.run(&[verb, &file]);
                assert_eq!(done.code, Some(0), "{line}: {verb} {file}\n{}", done.err);
            }
        }
    }

    /// Tests a file of results that the text names, if the page has made its folder so far.
    pub(crate) fn check_result(&self, line: &str, file: &str) {
        let path = self.bench.path(file);
        let made = path.parent().is_some_and(Path::is_dir);
        assert!(!made || path.is_file(), "{line}: no file {file}");
    }

    /// The help of a verb, which has its options.
    pub(crate) fn help(&self, line: &str, verb: &str) -> String {
        let words: Vec<&str> = verb.split(' ').chain(["--help"]).collect();
        let done = self.bench.run(&words);
        assert_eq!(done.code, Some(0), "{line}: slipgap {verb}: {}", done.err);
        done.out
    }
}

/// The JSON of a block; members of an object may stand without its braces.
pub(crate) fn parse(line: &str, text: &str) -> Value {
    let text = match text.trim_start().starts_with(['{', '[']) {
        true => text.to_owned(),
        false => format!("{{{text}}}"),
    };
    serde_json::from_str(&text).unwrap_or_else(|e| panic!("{line}: {e}: {text}"))
}
