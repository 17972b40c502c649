//! Cases with the same linear part side by side, whatever their order.

use super::motion::{self, FEW, LANES};
use crate::methods::Method;
use crate::problem::Case;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::given::node::Numbering;
use crate::solve::structure::Prepared;
use crate::solve::{MetricTable, Unsolvable, Warnings};
use crate::system::structure::Structure;

/// A case ready to be stepped.
#[derive(Debug)]
pub struct Ready {
    /// Its place in the table of results.
    pub place: usize,
    /// The case.
    pub case: Case,
    /// Its structure.
    pub structure: Structure,
    /// Numbers of its nodes.
    pub numbering: Numbering,
    /// Method of integration.
    pub method: Method,
    /// Time step.
    pub dt: f64,
    /// Number of steps N.
    pub last: u64,
}

/// Most groups at a time.
const MOST_GROUPS: usize = 16;

/// Cases of a group that are solved together, some lanes at a time.
const FULL: usize = 8 * LANES;

/// Most cases that are solved one after the other: that many take as long as few lanes.
const ALONE: usize = 2;

/// Cases with the same linear part.
#[derive(Debug)]
struct Group {
    prepared: Prepared,
    last: u64,
    cases: Vec<Ready>,
}

/// The groups of a sweep, and its results. The bits of a case do not depend on its group.
#[derive(Debug)]
pub struct Groups<'a> {
    problem: &'a StructureProblem,
    groups: Vec<Group>,
    table: MetricTable,
}

impl Groups<'_> {
    /// No cases yet, for a table of `len` cases.
    pub fn new(problem: &StructureProblem, len: usize) -> Groups<'_> {
        Groups {
            problem,
            groups: Vec::new(),
            table: MetricTable::new(len, problem.metrics.len()),
        }
    }

    /// Records why a case could not be solved.
    pub fn fail(&mut self, index: usize, why: Unsolvable) {
        self.table.fail(index, why);
    }

    /// Adds a case to the group with its linear part.
    pub fn add(&mut self, ready: Ready) {
        if self.problem.program_of(&ready.case).is_some() {
            let judged = self.problem.solve_ready(&ready, &[]);
            put(&mut self.table, ready.place, judged);
            return;
        }
        let fits = |group: &Group| {
            group.last == ready.last
                && group
                    .prepared
                    .fits(&ready.method, &ready.structure, ready.dt)
        };
        if let Some(group) = self.groups.iter_mut().find(|group| fits(group)) {
            group.cases.push(ready);
            if group.cases.len() >= FULL {
                let cases = std::mem::take(&mut group.cases);
                solve(self.problem, &group.prepared, &cases, &mut self.table);
            }
            return;
        }
        match motion::prepare(&ready.structure, &ready.method, ready.dt) {
            Err(why) => self.table.fail(ready.place, why),
            Ok(prepared) => {
                if self.groups.len() == MOST_GROUPS {
                    let oldest = self.groups.remove(0);
                    solve(
                        self.problem,
                        &oldest.prepared,
                        &oldest.cases,
                        &mut self.table,
                    );
                }
                self.groups.push(Group {
                    prepared,
                    last: ready.last,
                    cases: vec![ready],
                });
            }
        }
    }

    /// Solves the rest.
    pub fn finish(mut self) -> MetricTable {
        for group in &self.groups {
            solve(self.problem, &group.prepared, &group.cases, &mut self.table);
        }
        self.table
    }
}

/// Solves cases with one linear part.
fn solve(
    problem: &StructureProblem,
    prepared: &Prepared,
    cases: &[Ready],
    table: &mut MetricTable,
) {
    let alone = |ready: &Ready| {
        let numbers = problem.numbers(&ready.numbering, |_| true);
        !problem.fits_side_by_side(ready, numbers.len())
    };
    // Cases of a group have equal numbers of steps and contacts.
    if cases.first().is_some_and(alone) {
        for case in cases {
            solve_lanes(problem, prepared, [case], 1, table);
        }
        return;
    }
    let (lanes, rest) = cases.as_chunks::<LANES>();
    for cases in lanes {
        solve_lanes(problem, prepared, cases.each_ref(), LANES, table);
    }
    // Curved laws are solved lane by lane: idle lanes would cost as much as cases.
    let alone = rest.len() <= ALONE || rest.iter().any(is_curved);
    match rest.len() {
        _ if alone => {
            for case in rest {
                solve_lanes(problem, prepared, [case], 1, table);
            }
        }
        used @ ..=FEW => solve_lanes(problem, prepared, repeated::<FEW>(rest), used, table),
        used => solve_lanes(problem, prepared, repeated::<LANES>(rest), used, table),
    }
}

fn is_curved(ready: &Ready) -> bool {
    let mut contacts = ready.structure.contacts.iter();
    contacts.any(|contact| contact.law.is_curved())
}

/// Solves cases side by side, of which the first `used` are wanted.
fn solve_lanes<const L: usize>(
    problem: &StructureProblem,
    prepared: &Prepared,
    cases: [&Ready; L],
    used: usize,
    table: &mut MetricTable,
) {
    let numbers = problem.numbers(&cases[0].numbering, |_| true);
    let structures = cases.map(|ready| &ready.structure);
    let recording = problem.recording(cases[0], &numbers);
    let runs = motion::steps(&structures, prepared, recording);
    let perturbed = problem.perturbed(cases, prepared);
    let runs = runs.into_iter().zip(perturbed);
    for (ready, (run, perturbed)) in cases.iter().zip(runs).take(used) {
        let judged = problem.judge(ready, run, perturbed, &[]);
        put(table, ready.place, judged);
    }
}

/// The result of a case.
fn put<M>(
    table: &mut MetricTable,
    place: usize,
    judged: Result<(M, Vec<Option<f64>>, Warnings), Unsolvable>,
) {
    if let Ok((_, _, warnings)) = &judged {
        table.warn(place, *warnings);
    }
    table.put(place, judged.map(|judged| judged.1));
}

/// Fewer cases than lanes: the other lanes repeat the last case.
fn repeated<const L: usize>(cases: &[Ready]) -> [&Ready; L] {
    std::array::from_fn(|lane| &cases[lane.min(cases.len() - 1)])
}
