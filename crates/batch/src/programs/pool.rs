//! The processes of the programs of a study.

use super::process::Process;
use slipgap_problem::problem::structure::programs::{Hello, Program, Runner};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

/// The processes of the programs of a study. Each worker takes an idle one or starts one, so that there are no more than workers.
#[derive(Debug, Default)]
pub struct Pool {
    programs: Mutex<BTreeMap<&'static str, Arc<Mutex<Started>>>>,
}

/// The processes of a program.
#[derive(Debug, Default)]
struct Started {
    hello: Option<Result<Arc<Hello>, String>>,
    idle: Vec<Process>,
    /// Whether any process has answered a request.
    answered: bool,
    /// Number of processes that failed at their first request, and what the last one said.
    failed: usize,
    said: String,
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Pool {
    fn of(&self, program: &Program) -> Arc<Mutex<Started>> {
        locked(&self.programs)
            .entry(program.name)
            .or_default()
            .clone()
    }
}

impl Runner for Pool {
    fn hello(&self, program: &Program) -> Result<Arc<Hello>, String> {
        let started = self.of(program);
        // The other workers wait for the first process.
        let mut started = locked(&started);
        if let Some(known) = &started.hello {
            return known.clone();
        }
        let hello = Process::start(program).map(|(process, hello)| {
            started.idle.push(process);
            Arc::new(hello)
        });
        started.hello = Some(hello.clone());
        hello
    }

    fn ask(
        &self,
        program: &Program,
        request: Vec<u8>,
        is_answer: &mut dyn FnMut(&str) -> bool,
    ) -> Result<(), String> {
        let known = self.hello(program)?;
        let started = self.of(program);
        let idle = locked(&started).idle.pop();
        let mut process = match idle {
            Some(process) => process,
            None => {
                let (process, hello) = Process::start(program)?;
                if hello != *known {
                    return Err(format!(
                        "its first line says {}, and {} before",
                        hello.version, known.version
                    ));
                }
                process
            }
        };
        let [seconds, _] = program.timeouts;
        let is_first = !process.answered;
        let asked = process.ask(request, seconds, is_answer);
        let mut started = locked(&started);
        match &asked {
            Ok(()) => {
                started.answered = true;
                started.idle.push(process);
            }
            Err(why) if is_first => {
                started.failed += 1;
                started.said = format!("program {}: {why}", program.name);
            }
            Err(_) => {}
        }
        asked
    }

    fn failure(&self) -> Option<String> {
        let programs: Vec<_> = locked(&self.programs).values().cloned().collect();
        programs.iter().find_map(|started| {
            let started = locked(started);
            let is_dead = !started.answered && started.failed >= rayon::current_num_threads();
            is_dead.then(|| {
                format!(
                    "{}; it failed at its first request in every worker",
                    started.said
                )
            })
        })
    }
}
