//! The words of a command, and commands of other programs.

/// A command of a page.
pub(crate) struct Command {
    words: Vec<String>,
    /// The file to which its output goes.
    pub(crate) into: Option<String>,
}

impl Command {
    /// The words of a line of a shell, with single quotes, a remark behind `#` and `> FILE`.
    pub(crate) fn parse(line: &str) -> Command {
        let mut words: Vec<String> = Vec::new();
        let (mut quoted, mut inside) = (false, false);
        for c in line.chars() {
            match c {
                '\'' => {
                    quoted = !quoted;
                    if !inside {
                        words.push(String::new());
                    }
                    inside = true;
                }
                '#' if !quoted && !inside => break,
                c if c.is_whitespace() && !quoted => inside = false,
                c => {
                    if !inside {
                        words.push(String::new());
                    }
                    inside = true;
                    words.last_mut().unwrap().push(c);
                }
            }
        }
        let into = words.iter().position(|word| word == ">").map(|at| {
            let file = words[at + 1].clone();
            words.truncate(at);
            file
        });
        Command { words, into }
    }

    pub(crate) fn program(&self) -> &str {
        &self.words[0]
    }

    pub(crate) fn args(&self) -> &[String] {
        &self.words[1..]
    }
}

/// Programs that the pages name and that are not run here, each with the reason.
const OTHERS: [(&str, &str); 10] = [
    (
        "make",
        "targets take minutes; this test compares their names with the Makefile",
    ),
    ("cargo", "builds the program, which this test has"),
    (
        "pip",
        "installs the Python package, which `make wheel` tests",
    ),
    (
        "bash",
        "starts the script of Slurm; tests/stress/slurm does so where Slurm is installed",
    ),
    ("SHARDS=2,5", "the same with an environment variable"),
    ("srun", "a program of Slurm"),
    (
        "seq",
        "a pipe to GNU parallel; tests/stress/recipes runs it where it is installed",
    ),
    (
        "python",
        "a recipe of docs/clusters.md; tests/stress/recipes runs it",
    ),
    ("snakemake", "the same"),
    ("nextflow", "the same, where it is installed"),
];

/// Tests that a command is one of another program that is known.
pub(crate) fn other_program(line: &str, command: &Command) {
    let program = command.program();
    let known = OTHERS.iter().any(|other| other.0 == program);
    assert!(
        known,
        "{line}: {program} is not in the list of other programs"
    );
    if program == "make" {
        let makefile = include_str!("../../Makefile");
        for target in command.args().iter().filter(|arg| !arg.contains('=')) {
            let rule = format!("\n{target}:");
            assert!(makefile.contains(&rule), "{line}: no target {target}");
        }
    }
}

/// Whether a word is to be replaced by the reader, as NAME, `[LEDGER]...`, studies/NAME.json and I/N.
pub(crate) fn is_placeholder(word: &str) -> bool {
    let mut parts = word.split(|c: char| !c.is_ascii_alphanumeric());
    let upper = |part: &str| part.chars().all(|c| c.is_ascii_uppercase());
    word.starts_with('[') || parts.any(|part| !part.is_empty() && upper(part))
}
