//! The rules that a case must keep: of its method, its measures of the ground, its measurements and its channels.

use crate::methods::Method;
use crate::problem::structure::StructureProblem;
use crate::problem::structure::channels::channel::Term;
use crate::problem::structure::given::node::Numbering;
use crate::problem::structure::metrics::metric::StructureMetric;
use crate::problem::structure::model::assemble::{self, Model};
use crate::problem::structure::model::massless;
use crate::problem::structure::parts::contact_law;
use crate::problem::structure::tables::history_columns;
use crate::problem::{Case, Violation, method};
use crate::solve::structure::{critical_fault, static_ratio_fault};

impl StructureProblem {
    /// Rigid impacts whose restitution the method of the case ignores.
    pub(crate) fn ignored_restitutions(&self, case: &Case) -> Vec<Violation> {
        let ignores = |method: &Method| !method.has_impulses();
        if !self.method(case).as_ref().is_some_and(ignores) {
            return Vec::new();
        }
        let mut parameters = self.schema.parameters.iter();
        let row = parameters.position(|parameter| parameter.name == method::PARAMETERS[0].name);
        let name = row.map_or("", |row| case.name_at(row));
        let contacts = self.template.contacts.iter();
        let rigid = contacts.filter_map(|contact| contact_law::restitution(contact, case));
        rigid
            .map(|(given, e)| given.violation(method::ignores_restitution(name, e)))
            .collect()
    }

    /// Contacts with a static limit above the kinetic one that the method or their nodes cannot have.
    pub(crate) fn static_ratio_rules(&self, case: &Case) -> Option<Violation> {
        let mut contacts = self.template.contacts.iter();
        if !contacts.any(|contact| contact.number("static_ratio").is_some()) {
            return None;
        }
        let method = self.method(case)?;
        let structure = assemble::outline(&self.template, case, Model::Study).ok()?;
        let (contact, why) = static_ratio_fault(&structure, &method)?;
        let contact = &self.template.contacts[contact];
        Some(contact.number("static_ratio")?.violation(why))
    }

    /// The rules of a method with a critical step.
    pub(crate) fn step_rules(&self, case: &Case, dt: f64) -> Option<Violation> {
        let method = self.method(case)?;
        if !method.has_critical_step() && !self.template.has_massless_nodes(case) {
            return None;
        }
        let (structure, _) = self.structure(case, Model::Study).ok()?;
        if let Some((node, why)) = massless::fault(&structure, &method) {
            let name = &structure.nodes[node].name;
            return Some(Violation {
                parameter: "structure".into(),
                message: format!("node {name} {why}"),
                at: self.template.place_of(name),
            });
        }
        let fault = critical_fault(&structure, &method, dt)?;
        Some(Violation {
            parameter: fault.parameter().into(),
            message: fault.to_string(),
            at: None,
        })
    }

    /// Every number of a measure of the ground is in its range.
    pub(crate) fn check_measures(&self, case: &Case) -> Vec<Violation> {
        let metrics = self.metrics.iter();
        let measure = |metric: &StructureMetric| {
            let ground = metric.ground.as_ref()?;
            ground.measure(metric.reduction, case).err()
        };
        metrics.filter_map(measure).collect()
    }

    /// Every window is within the motion.
    pub(crate) fn check_windows(&self, case: &Case, dt: f64, duration: f64) -> Vec<Violation> {
        let windows = self.metrics.iter().map(|metric| &metric.window);
        windows
            .filter_map(|window| window.check(case, dt, duration).err())
            .collect()
    }

    /// Every channel has its nodes in a case.
    pub(crate) fn check_channels(&self, numbering: &Numbering, case: &Case) -> Vec<Violation> {
        let metrics = self.metrics.iter();
        let of_metrics =
            metrics.filter_map(|metric| Some((metric.channel.as_ref()?, &metric.place)));
        let columns = self.drawn.iter();
        let drawn = columns.map(|drawn| (&drawn.channel, &drawn.place));
        let faults = of_metrics.chain(drawn).filter_map(|(channel, (at, path))| {
            let mut terms = channel.terms.iter();
            let fault = |(_, term): &(f64, Term)| {
                let massless = || history_columns::massless(*term, &self.template, case);
                term.number(numbering).err().or_else(massless)
            };
            let message = terms.find_map(fault)?;
            Some(Violation {
                parameter: path.clone().into(),
                message: format!("{}: {message}", channel.name),
                at: Some(*at),
            })
        });
        faults.collect()
    }
}
