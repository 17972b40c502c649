//! Every command and every JSON block of the pages runs as it is there, in the order of the page.
//!
//! Notes that readers do not see say what a page cannot say in words:
//!
//! - before a JSON block: `<!-- test: FILE -->`, a whole study for this file (a whole study without a note goes to the file that
//!   the words before it name); `<!-- test: into FILE at PATH -->`, its keys replace those of the object at PATH of the study, or
//!   the block is a further item of the list there; `<!-- test: into {"problem": ...} -->`, the same in a study of its own.
//!   At the end of the page every study is listed, and run and checked if no command of the page has run it.
//! - before commands: `<!-- test: with --set duration=1 -->`, further arguments of `run`, `check` and `calibrate`, for studies that take long;
//!   `<!-- test: exits with 5 -->`.
//! - anywhere: `<!-- test: FILE from PATH -->`, a file of the repository under this name (`FOLDER/START* from PATH`: files of a folder); `<!-- test: only listed -->`, studies of
//!   the page that no command runs are not run; `<!-- test: not run: REASON -->`, for the next block.

#[path = "../common/bench.rs"]
mod bench;
mod citation;
mod command;
mod links;
mod page;
mod scene;

use command::is_placeholder;
use page::{Piece, pieces};
use scene::{Scene, parse};

/// What notes say about the next block.
#[derive(Default)]
struct Notes {
    file: Option<String>,
    into: Option<(String, String)>,
    more: Vec<String>,
    code: i32,
    skipped: bool,
}

/// Runs a page; returns the number of commands and of JSON blocks.
fn run(name: &str) -> (usize, usize) {
    let mut scene = Scene::new();
    let mut notes = Notes::default();
    let mut only_listed = false;
    for (line, piece) in pieces(name) {
        match piece {
            Piece::Note(note) => {
                only_listed |= note == "only listed";
                read(&note, &mut notes, &mut scene);
            }
            Piece::Span(span) => run_span(&mut scene, &line, &span),
            Piece::Block {
                language,
                text,
                named,
            } => {
                let notes = std::mem::take(&mut notes);
                if !notes.skipped {
                    run_block(&mut scene, &line, &language, &text, named, &notes);
                }
            }
        }
    }
    scene.check_studies(only_listed);
    (scene.commands, scene.blocks)
}

fn read(note: &str, notes: &mut Notes, scene: &mut Scene) {
    if let Some(study) = note.strip_prefix("into ") {
        let (study, path) = study.rsplit_once(" at ").unwrap_or((study, ""));
        notes.into = Some((study.to_owned(), path.to_owned()));
    } else if let Some(words) = note.strip_prefix("with ") {
        notes.more = words.split(' ').map(String::from).collect();
    } else if let Some(code) = note.strip_prefix("exits with ") {
        notes.code = code.parse().unwrap();
    } else if note.starts_with("not run: ") {
        notes.skipped = true;
    } else if let Some((file, path)) = note.split_once(" from ") {
        scene.copy(file, path);
    } else if note != "only listed" {
        assert!(note.ends_with(".json"), "unknown note: {note}");
        notes.file = Some(note.to_owned());
    }
}

fn run_block(
    scene: &mut Scene,
    at: &str,
    language: &str,
    text: &str,
    named: Option<String>,
    notes: &Notes,
) {
    match language {
        "json" => match (&notes.into, notes.file.clone().or(named)) {
            (Some((study, path)), _) => scene.merge(at, study, path, text),
            (None, Some(file)) => scene.write(at, &file, text),
            (None, None) => panic!("{at}: a note must say which study this belongs to"),
        },
        "sh" => {
            let lines = text.lines().map(str::trim);
            for line in lines.filter(|line| !line.is_empty() && !line.starts_with('#')) {
                scene.run(at, line, &notes.more, notes.code);
            }
        }
        // tests/recommend.rs compares the output of the command in the first line; other programs run the rest.
        "text" => {
            let call = text
                .lines()
                .next()
                .and_then(|line| line.strip_prefix("$ slipgap "));
            let verb = call.and_then(|call| call.split(' ').next());
            if let Some(verb) = verb {
                assert_eq!(verb, "recommend", "{at}: put the command into ```sh");
            }
        }
        "python" | "sql" => {}
        other => panic!("{at}: a block of {other:?}; allowed: json, sh, text, python, sql"),
    }
}

/// A command inside the text runs if it is complete. Of any other one, and of searches, which take long, verb and options exist.
fn run_span(scene: &mut Scene, line: &str, span: &str) {
    if span.starts_with("{ \"") || span.starts_with('"') && span.contains("\": ") {
        parse(line, span);
    }
    let is_file = [".png", ".csv"].iter().any(|end| span.ends_with(end));
    if is_file && span.starts_with("figures/") && span.split('/').count() > 2 {
        scene.check_result(line, span);
    }
    let Some(call) = span.strip_prefix("slipgap ") else {
        return;
    };
    let words: Vec<&str> = call.split_whitespace().collect();
    let [verb, rest @ ..] = &words[..] else {
        return;
    };
    if verb.starts_with('-') || is_placeholder(verb) {
        return;
    }
    let only_options = *verb != "schema" && rest.iter().all(|word| word.starts_with('-'));
    let open = rest.is_empty() || only_options || rest.iter().any(|word| is_placeholder(word));
    if !open && *verb != "recommend" {
        return scene.run(line, span, &[], 0);
    }
    let help = match (*verb, rest) {
        ("recommend", [problem, ..]) if !problem.starts_with('-') => {
            scene.help(line, &format!("recommend {problem}"))
        }
        _ => scene.help(line, verb),
    };
    for option in rest
        .iter()
        .filter_map(|word| word.trim_start_matches('[').strip_prefix("--"))
    {
        let word = option.trim_end_matches([']', '.']);
        let option = word.split('=').next().unwrap_or(word);
        assert!(
            help.contains(&format!("--{option}")),
            "{line}: {span}: --{option}"
        );
    }
}

macro_rules! pages {
    ($($name:ident $file:literal),+ $(,)?) => {
        $(#[test]
        fn $name() {
            run($file);
        })+

        /// The pages that are tested.
        const PAGES: &[&str] = &[$($file),+];
    };
}

pages! {
    readme "README.md",
    architecture "ARCHITECTURE.md",
    benches "benches/README.md",
    contributing "CONTRIBUTING.md",
    python "python/README.md",
    answers "docs/answers.md",
    benchmarks "docs/benchmarks.md",
    calibrate "docs/calibrate.md",
    clusters "docs/clusters.md",
    conventions "CONVENTIONS.md",
    errata "docs/errata.md",
    findings "docs/findings.md",
    findings_friction "docs/findings-friction.md",
    findings_laws "docs/findings-laws.md",
    findings_plane "docs/findings-plane.md",
    findings_programs "docs/findings-programs.md",
    findings_structures "docs/findings-structures.md",
    guide "docs/guide.md",
    laws_and_methods "docs/laws-and-methods.md",
    parts "docs/parts.md",
    performance "docs/performance.md",
    platforms "docs/platforms.md",
    programs "docs/programs.md",
    recommend "docs/recommend.md",
    results "docs/results.md",
    scope "docs/scope.md",
    structures "docs/structures.md",
    study_files "docs/study-files.md",
    study_files_bar_impact "docs/study-files-bar-impact.md",
    study_files_friction_oscillator "docs/study-files-friction-oscillator.md",
    study_files_structure "docs/study-files-structure.md",
    versions "docs/versions.md",
}

#[test]
fn every_page_is_among_them() {
    let docs = format!("{}/docs", env!("SLIPGAP_ROOT"));
    for entry in std::fs::read_dir(docs).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        if name.ends_with(".md") {
            let page = format!("docs/{name}");
            assert!(PAGES.contains(&page.as_str()), "{page} is not tested");
        }
    }
}

/// results.csv may name a parameter otherwise than the study: the page says so.
#[test]
fn the_page_has_every_column_with_a_name_of_its_own() {
    let mut others = 0;
    for problem in slipgap::problem::PROBLEMS.iter() {
        let file = format!(
            "{}/docs/study-files-{}.md",
            env!("SLIPGAP_ROOT"),
            problem.name()
        );
        let page = std::fs::read_to_string(file).unwrap();
        for parameter in problem.parameters() {
            let column = parameter.column_name();
            if column != parameter.name {
                others += 1;
                assert!(
                    page.contains(&format!("its column is `{column}`")),
                    "{column}"
                );
            }
        }
    }
    assert_eq!(others, 1);
}
