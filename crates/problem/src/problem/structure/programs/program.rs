//! The programs of a study, and what starts them.

use super::answer::Hello;
use crate::problem::interned;
use crate::problem::structure::given::amount::Amount;
use std::fmt::Debug;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

/// A program of others.
#[derive(Debug, Clone)]
pub struct Program {
    /// Its name among the methods of the study.
    pub name: &'static str,
    /// The command and its arguments.
    pub command: Vec<String>,
    /// The folder of the study, in which it runs.
    pub folder: PathBuf,
    /// The numbers of its own.
    pub numbers: Vec<(String, Amount)>,
    /// Seconds that it has for a case, and for its first line.
    pub timeouts: [f64; 2],
    /// Whether dt is only the spacing of its answers.
    pub adaptive: bool,
}

impl Program {
    /// The command as messages show it.
    pub fn shown_command(&self) -> String {
        let plain = |word: &&String| {
            let is_plain = |c: char| c.is_ascii_alphanumeric() || "._-/=+:,@%".contains(c);
            !word.is_empty() && word.chars().all(is_plain)
        };
        let words = self.command.iter().map(|word| match plain(&word) {
            true => word.clone(),
            false => format!("{word:?}"),
        });
        words.collect::<Vec<_>>().join(" ")
    }
}

/// What starts programs and asks them.
pub trait Runner: Debug + Send + Sync {
    /// The first line of a program.
    ///
    /// # Errors
    /// It cannot be started, or says something else.
    fn hello(&self, program: &Program) -> Result<Arc<Hello>, String>;
    /// Sends a request and reads lines until one is the answer.
    ///
    /// # Errors
    /// There is none, in words about the program.
    fn ask(
        &self,
        program: &Program,
        request: Vec<u8>,
        is_answer: &mut dyn FnMut(&str) -> bool,
    ) -> Result<(), String>;
    /// Why no case of a program can be computed: it failed at its first request in every worker.
    fn failure(&self) -> Option<String>;
}

/// The programs of a study, and what may start them.
#[derive(Debug, Default)]
pub struct Programs {
    /// Each once.
    pub list: Vec<Program>,
    /// The name of the study.
    study: String,
    /// Different for different programs and files, in a study whose structure has none of its own.
    identity: String,
    /// Whether u and v of all nodes and S of all contacts are asked for, as files of histories have them.
    whole: AtomicBool,
    runner: OnceLock<Arc<dyn Runner>>,
}

impl Programs {
    /// These of a study, which nothing starts yet.
    pub fn new(list: Vec<Program>, study: String, identity: String) -> Programs {
        Programs {
            list,
            study,
            identity,
            whole: AtomicBool::new(false),
            runner: OnceLock::new(),
        }
    }

    /// What differs for different programs and files.
    pub fn identity(&self) -> &str {
        &self.identity
    }

    /// The name of the study.
    pub fn study(&self) -> &str {
        &self.study
    }

    /// Lets this start them.
    pub fn allow(&self, runner: Arc<dyn Runner>) {
        self.runner.get_or_init(|| runner);
    }

    /// Lets the solutions of cases have the whole motion, and not only what metrics and figures need.
    pub fn ask_for_all(&self) {
        self.whole.store(true, Ordering::Relaxed);
    }

    /// Whether they have it.
    pub(in crate::problem::structure) fn is_whole(&self) -> bool {
        self.whole.load(Ordering::Relaxed)
    }

    /// What may start them; `None` if nothing may.
    pub fn runner(&self) -> Option<&Arc<dyn Runner>> {
        self.runner.get()
    }

    /// The program with a name.
    pub fn named(&self, name: &str) -> Option<&Program> {
        self.list.iter().find(|program| program.name == name)
    }
}

/// The names of methods: those of the product, and these of programs.
pub fn methods<'a>(programs: impl Iterator<Item = &'a str>) -> Vec<(&'static str, &'static str)> {
    let known = crate::methods::METHODS.iter();
    let own = known.map(|method| (method.name, method.meaning));
    own.chain(programs.map(|name| (interned(name), "a program of the study")))
        .collect()
}
