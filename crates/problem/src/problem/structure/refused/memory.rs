//! What the motions of a case and its contact forces need in memory, known before the work.

use crate::problem::structure::StructureProblem;
use crate::problem::structure::given::node::Numbering;
use crate::problem::structure::model::assemble::{self, Model};
use crate::problem::structure::motions::motion::LANES;
use crate::problem::structure::motions::sweep::Ready;
use crate::problem::{Case, Violation};
use crate::solve::structure::sizes_of_blocks;

/// Most numbers of a motion, and of the matrices of its contacts: 2 GiB.
const MOST_NUMBERS: f64 = 268_435_456.0;

/// Numbers of the matrices of m contacts that move each other over m^2: the flexibility of a step and its copy, the matrix of their forces and its factor, and
/// the half of another factor.
const OF_CONTACTS: f64 = 4.5;

/// Seconds over m^3 of a case with m contacts: 5000 took 34 s.
const SECONDS: f64 = 2.7e-10;

impl StructureProblem {
    /// Reports a case whose metrics and figures keep more numbers of a motion than fit in memory.
    pub(crate) fn check_memory(&self, numbering: &Numbering, steps: f64) -> Option<Violation> {
        // Each metric and each channel that is drawn has a few quantities, or all of some kind.
        let most = self.of_history(numbering) + 8 * (self.metrics.len() + self.drawn.len());
        if steps * most as f64 <= MOST_NUMBERS {
            return None;
        }
        let kept = self.numbers(numbering, |_| true).len() + self.drawn_numbers(numbering).len();
        too_many(steps, kept, "in the metrics and figures")
    }

    /// Reports the contacts of a case whose matrices do not fit in memory. Those of parts that nothing connects have matrices of their own,
    /// but not in what is found for all contacts at once: equilibria, starts of rigid contacts and nodes without mass, and exact motions.
    pub(crate) fn check_contacts(&self, case: &Case) -> Option<Violation> {
        let contacts = &self.template.contacts;
        let fits = |m: f64| OF_CONTACTS * m * m <= MOST_NUMBERS;
        if fits(contacts.len() as f64) {
            return None;
        }
        let (structure, _) = self.structure(case, Model::Study).ok()?;
        let corrects = self.method(case).is_some_and(|method| method.corrects());
        let is_rigid = structure
            .contacts
            .iter()
            .any(|contact| contact.law.is_rigid());
        let at_once = is_rigid || structure.massless().contains(&true);
        let known = !self.template.at_rest.is_empty() || self.template.reference.is_some();
        let sizes = match corrects || at_once || known {
            true => vec![contacts.len()],
            false => sizes_of_blocks(&structure),
        };
        let squares: f64 = sizes.into_iter().map(|size| (size * size) as f64).sum();
        let m = squares.sqrt();
        if fits(m) {
            return None;
        }
        let (m, numbers) = (m.floor(), OF_CONTACTS * squares);
        let (at, path) = contacts.last()?.place.clone();
        let most = (MOST_NUMBERS / OF_CONTACTS).sqrt().floor();
        let gigabytes = 8e-9 * numbers;
        let minutes = (SECONDS * m * m * m / 60.0).ceil();
        Some(Violation {
            parameter: path.into(),
            message: format!(
                "{m} contacts, at most {most} are allowed: the forces of all contacts of a step are found together, which needs about {gigabytes:.1} GB, \
                 and {minutes} min or more; name fewer pairs"
            ),
            at: Some(at),
        })
    }

    /// Why the whole history of a completed case, of every node and contact, does not fit in memory; `None` if it does. Its metrics and
    /// figures may need less.
    pub fn history_fault(&self, case: &Case) -> Option<Violation> {
        let numbering = assemble::check(&self.template, case).ok()?;
        let steps = case.steps() as f64;
        too_many(steps, self.of_history(&numbering), "in the whole history")
    }

    /// Whether the motions of such cases, with so many recorded numbers, fit in memory side by side.
    pub(crate) fn fits_side_by_side(&self, ready: &Ready, numbers: usize) -> bool {
        let motion = ready.last as f64 * numbers as f64;
        let contacts = ready.structure.contacts.len() as f64;
        LANES as f64 * motion.max(OF_CONTACTS * contacts * contacts) <= MOST_NUMBERS
    }

    /// Numbers of a step of the whole history: u and v of nodes, u, v and a of supports, r, rdot and S of contacts.
    fn of_history(&self, numbering: &Numbering) -> usize {
        let template = &self.template;
        2 * numbering.nodes() + 3 * (template.supports.len() + template.contacts.len())
    }
}

fn too_many(steps: f64, numbers: usize, kept: &str) -> Option<Violation> {
    let fits = steps * numbers as f64 <= MOST_NUMBERS;
    (!fits).then(|| Violation {
        parameter: "dt".into(),
        message: format!(
            "gives {steps:.3e} steps of {numbers} numbers {kept}, at most {MOST_NUMBERS:.2e} numbers fit in memory"
        ),
        at: None,
    })
}
