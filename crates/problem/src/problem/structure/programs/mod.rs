//! Programs of others as methods of a study: one line of JSON for each case, and one back.
//!
//! What such a program is asked for are the channels that the metrics and figures of a study need; what follows from them is computed.

mod answer;
mod asked;
mod contacts;
mod energies;
mod json;
mod known;
mod matrices;
mod program;
mod request;
mod scales;
mod supports;

pub use answer::{Answer, Hello};
pub use program::{Program, Programs, Runner, methods};

use super::metrics::reduction::Reduction;
use super::motions::motion;
use super::motions::recorded::{Energies, Recorded, distinct};
use super::motions::solve::JudgedCase;
use super::motions::sweep::Ready;
use crate::problem::Case;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::channels::channel::{Number, Quantity};
use crate::solve::{Unsolvable, Warning, Warnings};
use crate::system::structure::Structure;
use asked::Asked;
use energies::Balance;
use known::Known;
use request::Request;
use std::time::Instant;

/// The motion of a case by a program.
struct ProgramRun {
    recorded: Recorded,
    /// Those of a case of which all channels were asked for.
    energies: Option<Energies>,
    /// The program's own count.
    cost: Option<f64>,
    /// Seconds from the request to the answer.
    wall: f64,
    /// Whether its energy is above what went in.
    gains: bool,
    /// Whether a body rests although forces act on it.
    has_unheld: bool,
    /// Whether a channel has no value at some instant.
    has_null: bool,
}

/// Displacements over those of the exact motion that are no motion any more.
const FAR: f64 = 1000.0;

/// Whether a displacement is far larger than the exact one ever is.
fn is_far(computed: &Recorded, exact: &Recorded, numbers: &[Number]) -> bool {
    let peak = |recorded: &Recorded, number: Number| {
        let values = recorded.of(number).iter();
        values.fold(0.0, |peak: f64, x| peak.max(x.abs()))
    };
    let is_motion = |number: &&Number| match number {
        Number::Displacement(_) => true,
        Number::Contact(_, quantity) => *quantity == Quantity::Displacement,
        Number::Velocity(_) | Number::Acceleration(_) | Number::Derived(_) | Number::Energy(_) => {
            false
        }
    };
    let mut motions = numbers.iter().filter(is_motion);
    motions.any(|number| {
        let exact = peak(exact, *number);
        exact > 0.0 && peak(computed, *number) > FAR * exact
    })
}

impl StructureProblem {
    /// The program that computes a case; `None` for one by a method of the product.
    pub(super) fn program_of(&self, case: &Case) -> Option<&Program> {
        if self.programs.list.is_empty() {
            return None;
        }
        self.programs.named(case.choice("method"))
    }

    /// The programs of the study.
    pub fn programs(&self) -> &Programs {
        &self.programs
    }

    /// The metrics of a completed case without its histories, with its warnings.
    ///
    /// # Errors
    /// Why it has none.
    pub fn solve_metrics(&self, case: &Case) -> Result<(Vec<Option<f64>>, Warnings), Unsolvable> {
        let ready = self.ready(0, case)?;
        let (_, metrics, warnings) = self.solve_ready(&ready, &[])?;
        Ok((metrics, warnings))
    }

    /// The request of a completed case, as a line of JSON, with text for all numbers.
    ///
    /// # Errors
    /// The case cannot be assembled, or the format does not have a part of it.
    pub fn request(&self, case: &Case) -> Result<String, Unsolvable> {
        let ready = self.observing().ready(0, case)?;
        let program = self.program_of(case);
        let of_metrics = self.numbers(&ready.numbering, |_| true);
        let drawn = self.drawn_numbers(&ready.numbering);
        let numbers = distinct(of_metrics.into_iter().chain(drawn));
        let energies = self.recording(&ready, &numbers).energy;
        let asked = Asked::new(&ready.structure, &numbers, energies)?;
        let written = Request {
            problem: self,
            ready: &ready,
            structure: &ready.structure,
            program,
            asked: &asked,
            base64: false,
        };
        let line = written.line().map_err(Unsolvable::Program)?;
        Ok(String::from_utf8_lossy(&line).into_owned())
    }

    /// The same structure, with what the accelerations at t = 0 follow from.
    fn observing(&self) -> StructureProblem {
        let (template, schema) = (self.template.clone(), self.schema.clone());
        let mut observing = StructureProblem {
            template,
            schema,
            metrics: Vec::new(),
            drawn: Vec::new(),
            identity: String::new(),
            notes: Vec::new(),
            programs: Programs::new(self.programs.list.clone(), String::new(), String::new()),
        };
        observing.template.observed = true;
        observing
    }

    /// The metrics of a case by a program, with these quantities recorded too.
    pub(super) fn solve_by_program(
        &self,
        program: &Program,
        ready: &Ready,
        more: &[Number],
    ) -> Result<JudgedCase, Unsolvable> {
        let of_metrics = self.numbers(&ready.numbering, |_| true);
        let numbers = distinct(of_metrics.into_iter().chain(more.iter().copied()));
        let wanted = (&numbers[..], self.recording(ready, &numbers).energy);
        let run = self.run_of_program(program, ready, &ready.structure, wanted)?;
        let perturbed = match self.needs_perturbed() {
            true => {
                let other = motion::perturbed(&ready.structure);
                let run = self.run_of_program(program, ready, &other, (&numbers, false))?;
                Some(Ok((run.recorded, None, None)))
            }
            false => None,
        };
        let computed = (run.recorded, run.energies, None);
        let (motions, mut values, warnings) = self.judge(ready, Ok(computed), perturbed, more)?;
        for (metric, value) in self.metrics.iter().zip(&mut values) {
            if metric.reduction == Reduction::Cost {
                *value = run.cost;
            }
            if metric.reduction == Reduction::Wall {
                *value = Some(run.wall);
            }
        }
        let is_far = |exact: &Option<Recorded>| {
            let exact = exact.as_ref();
            exact.is_some_and(|exact| is_far(&motions.computed, exact, &numbers))
        };
        let warnings = warnings
            .with(
                Warning::ProgramSize,
                is_far(&motions.softened) || is_far(&motions.rigid),
            )
            .with(Warning::ProgramGain, run.gains)
            .with(Warning::ProgramUnheld, run.has_unheld)
            .with(Warning::ProgramNull, run.has_null);
        Ok((motions, values, warnings))
    }

    /// The motion of a structure by a program, with these quantities and, if wanted, its energies.
    fn run_of_program(
        &self,
        program: &Program,
        ready: &Ready,
        structure: &Structure,
        (numbers, energies): (&[Number], bool),
    ) -> Result<ProgramRun, Unsolvable> {
        let broken = |why: String| Unsolvable::Program(format!("{}: {why}", program.name));
        let Some(runner) = self.programs.runner() else {
            let command = program.shown_command();
            let why = format!("{command} is not started without --allow-programs");
            return Err(broken(why));
        };
        let hello = runner.hello(program).map_err(broken)?;
        self.check_laws(ready, &hello).map_err(broken)?;
        let asked = Asked::new(structure, numbers, energies)?;
        let request = Request {
            problem: self,
            ready,
            structure,
            program: Some(program),
            asked: &asked,
            base64: hello.base64,
        };
        let line = request.line().map_err(broken)?;
        let mut answer = None;
        let start = Instant::now();
        let asking = runner.ask(program, line, &mut |line| {
            answer = Answer::parse(line, ready.case.number);
            answer.is_some()
        });
        let wall = start.elapsed().as_secs_f64();
        asking.map_err(broken)?;
        let no_answer = || Err("no answer".into());
        let mut answer = answer.unwrap_or_else(no_answer).map_err(broken)?;
        let steps = ready.last as usize;
        let read = Known::new(structure, &asked, (ready.dt, steps), &mut answer);
        let known = read.map_err(broken)?;
        let balance = asked.is_whole().then(|| Balance::new(&known));
        let energy = |energy| balance.as_ref().map_or(Vec::new(), |of| of.series(energy));
        let recorded = known.recorded(numbers, &energy)?;
        Ok(ProgramRun {
            recorded,
            cost: answer.cost,
            wall,
            gains: balance.as_ref().is_some_and(Balance::gains),
            has_unheld: balance.is_some() && known.has_unheld(),
            has_null: known.has_null(),
            energies: balance.map(|balance| balance.energies()),
        })
    }

    /// That a program has the laws of a case.
    fn check_laws(&self, ready: &Ready, hello: &Hello) -> Result<(), String> {
        let contacts = self.template.contacts.iter();
        let mut laws = contacts.map(|contact| contact.law.name(&ready.case));
        match laws.find(|law| !hello.laws.iter().any(|known| known == law)) {
            None => Ok(()),
            Some(law) => Err(format!(
                "it does not have the law {law}; it has {}",
                match &hello.laws[..] {
                    [] => "none".to_owned(),
                    laws => laws.join(", "),
                }
            )),
        }
    }
}
