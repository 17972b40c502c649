//! Structures in studies: the key `structure`, the names of parameters, and the metrics and channels that a study uses.

mod contacts;
mod delays;
mod doubts;
mod identity;
pub(super) mod keys;
mod matrices;
pub(super) mod measured;
mod motions;
pub(super) mod named;
mod parts;
pub(super) mod programs;
pub(super) mod reading;
pub(super) mod recorded;
#[cfg(test)]
mod tests;

use super::source::faults::{Faults, quoted};
use super::source::folder::Folder;
use super::source::object::Object;
use super::source::tree::Node;
use super::value;
use crate::structure::reading::reader::{Reader, named};
use keys::STRUCTURE;
use measured::Given;
use parts::{damping, springs};
use slipgap_problem::problem::Problem;
use slipgap_problem::problem::structure::StructureProblem;
use slipgap_problem::problem::structure::channels::channel_words::{Shown, Words};
use slipgap_problem::problem::structure::channels::names::Names;
use slipgap_problem::problem::structure::metrics::unit_consistency;
use slipgap_problem::problem::structure::parts::template::{DampingStiffness, Reference, Template};
use slipgap_problem::problem::structure::tables::schema::{self, Named};
use std::collections::HashSet;
use std::sync::Arc;

/// The problem of the study at `root`, with records from `folder`; `None` if the structure has a fault. In a part of a study, unused
/// parameters are no fault.
pub(super) fn problem(
    root: &Object,
    (root_node, whole): (&Node, bool),
    folder: &Folder,
    faults: &mut Faults,
) -> Option<Arc<dyn Problem>> {
    let before = faults.count();
    let node = root.need("structure", "masses, bars, springs and contacts", faults)?;
    let choices = crate::structure::named::names::choices(node, root_node);
    let mut parameters = crate::structure::named::names::parameters(root_node, &choices, faults);
    let (no_names, not_shown) = (Names::default(), Shown::default());
    let no_words = Words {
        names: &no_names,
        shown: &not_shown,
    };
    let first = schema::schema(&parameters, &[], &[], ("", no_words));
    let object = Object::open(node, "structure", &STRUCTURE, faults)?;
    let mut taken = HashSet::new();
    let mut all_of = |key: &str, what: &str, faults: &mut Faults| match object.get(key) {
        Some(node) => named(node, &object.path(key), what, &mut taken, faults),
        None => Vec::new(),
    };
    let masses = parts::in_directions(all_of("masses", "mass", faults), faults);
    let bars = all_of("bars", "bar", faults);
    let of_matrices = all_of("matrices", "model", faults);
    let of_contacts = contacts::with_pressing(all_of("contacts", "contact", faults));
    let of_supports = all_of("supports", "support", faults);
    parts::check_spring_names(&object, &mut taken, faults);
    crate::structure::motions::supports::refuse_ground(&object, faults);
    let directions: Vec<_> = of_supports
        .iter()
        .map(|(name, node, _)| {
            (
                name.clone(),
                crate::structure::motions::supports::directions(node),
            )
        })
        .collect();
    if masses.is_empty() && bars.is_empty() && of_matrices.is_empty() && faults.count() == before {
        object.fault("has no node; give masses, bars or matrices", faults);
    }
    let (units, metre) = units(&object, node, faults);
    let name = |part: &crate::structure::reading::reader::Part| part.0.clone();
    let inner = contacts::inner_nodes(&of_contacts);
    let inner_names = inner.iter().map(|mass| mass.name.clone());
    let mut reader = Reader {
        names: Names::new(
            masses.iter().map(name).chain(inner_names).collect(),
            bars.iter().map(name).collect(),
            Vec::new(),
        )
        .with_supports(directions.clone()),
        units: units.clone(),
        metre,
        ..Reader::plain(root_node, &first.parameters, folder)
    };
    let before_matrices = faults.count();
    let imported = matrices::matrices(&of_matrices, &reader, faults);
    // Without their rows, every name of a node would be a fault of its own.
    if faults.count() > before_matrices {
        return None;
    }
    let (masses_named, bars_named) = (reader.names.masses, reader.names.bars);
    let named = imported
        .iter()
        .map(|matrices| (matrices.name.clone(), matrices.imported.clone()));
    reader.names = Names::new(masses_named, bars_named, named.collect()).with_supports(directions);
    let reader = reader;
    let modes = matrices::modes(&of_matrices, &reader, faults);
    let groups = object.items("springs", faults, |node, path, faults| {
        springs::springs(node, path, &reader, faults)
    });
    let springs: Vec<_> = groups.into_iter().flatten().collect();
    // Before the contacts, whose vertical motions may get its factor.
    let ground = crate::structure::motions::ground::ground(&object, &reader, faults);
    let mut template = Template {
        units,
        metre,
        masses: {
            let listed = parts::masses(&masses, &reader, faults);
            listed.into_iter().chain(inner).collect()
        },
        bars: parts::bars(&bars, &reader, faults),
        matrices: imported,
        rayleigh: damping::rayleigh(&object, &reader, faults).unwrap_or_default(),
        modal_damping: damping::modal_damping(&object, &reader, faults),
        damping_stiffness: object
            .choice("damping_stiffness", &STIFFNESSES, faults)
            .unwrap_or_default(),
        contacts: contacts::contacts(&of_contacts, &springs, &reader, faults),
        springs,
        loads: object.items("loads", faults, |node, path, faults| {
            crate::structure::motions::loads::load(node, path, &reader, faults)
        }),
        ground,
        supports: crate::structure::motions::supports::supports(&of_supports, &reader, faults),
        at_rest: parts::static_loads(&object, &reader, faults),
        gravity: parts::falling(&object, &reader, faults),
        start: parts::start(&object, &reader, faults),
        reference: object.choice("contacts_reference", &REFERENCES, faults),
        measured: None,
        sample: None,
        observed: false,
    };
    let decoded = template.contacts.iter().map(|contact| contact.name.clone());
    let mut contacts: Vec<String> = decoded.collect();
    // One with a fault is known all the same, so that it has one message.
    let part = |name: &str| {
        contacts
            .iter()
            .any(|contact| contact.split('.').next() == name.split('.').next())
    };
    let unread = of_contacts.iter().filter(|(name, ..)| !part(name));
    let faulty: Vec<String> = unread.map(|(name, ..)| name.clone()).collect();
    contacts.extend(faulty);
    let names = reader.names.clone().with_contacts(contacts);
    let known = names.with_structure(template.names());
    crate::structure::named::units::add(node, &template.units, &mut parameters);
    let named = (&mut parameters[..], &known);
    let shown = crate::structure::named::shown::shown(root, named, &reader, faults);
    let mut metrics = crate::structure::named::named_metrics::metrics(root, &known, faults);
    crate::structure::named::amounts::amounts(&mut metrics, &template, &reader, faults);
    let mut drawn = crate::structure::named::named_metrics::drawn(root, &known, faults);
    let measured = measured::decode(root, (&known, &template.units), &reader, &mut drawn, faults);
    match measured {
        Some(Given::Histories(histories)) => {
            template.measured = Some(delays::known(histories, root_node, reader.table));
        }
        Some(Given::Sample(sample)) => template.sample = Some(sample),
        None => {}
    }
    let of_tests = (template.measured.as_ref(), template.sample.as_ref());
    measured::report_not_measured(root, &metrics, of_tests, faults);
    let reduced = (&of_matrices[..], modes);
    matrices::reduce(&mut template, reduced, (&metrics, &drawn), &reader, faults);
    crate::structure::named::named_metrics::report_errors_without_reference(
        root,
        &drawn,
        template.reference.is_some(),
        faults,
    );
    let programs = programs::programs(root, &reader, &mut parameters, faults);
    let used = reader.used.borrow();
    let parameters: Vec<Named> = parameters
        .into_iter()
        .enumerate()
        .map(|(row, named)| Named {
            required: named.required || used.contains(&row),
            ..named
        })
        .collect();
    // A faulty value may be the one that contains the name.
    if whole && faults.count() == before {
        let in_metrics =
            |name: &str| crate::structure::named::named_metrics::names_parameter(root, name);
        crate::structure::named::names::report_unused(
            root_node,
            &parameters,
            &first.parameters,
            in_metrics,
            faults,
        );
    }
    let mut notes = crate::structure::motions::records::notes(&reader);
    notes.extend(crate::structure::reading::files::early_note(&reader));
    notes.extend(doubts::notes(&template, &reader.names, node));
    let given = root.get(keys::KEY.name).zip(template.measured.as_ref());
    let of_measured = given.map(|(node, measured)| (node, measured.delays));
    let set = template.set().map(|set| set.1);
    let identity = identity::identity(
        (node, root.get(programs::KEY.name)),
        (of_measured, set),
        &reader.records.borrow(),
    );
    let schema = schema::schema(
        &parameters,
        &metrics,
        &drawn,
        (
            &template.units,
            Words {
                names: &known,
                shown: &shown,
            },
        ),
    );
    (faults.count() == before).then(|| {
        Arc::new(StructureProblem::new(
            template, schema, metrics, drawn, identity, notes, programs,
        )) as _
    })
}

/// The units as the study writes them, and the unit of length in m.
fn units(object: &Object, structure: &Node, faults: &mut Faults) -> (String, f64) {
    let Some(node) = object.get("units") else {
        return (String::new(), 1.0);
    };
    let path = object.path("units");
    let Some(text) = value::text(node, &path, faults) else {
        return (String::new(), 1.0);
    };
    let names = text.split(',').map(str::trim);
    if names.filter(|name| !name.is_empty()).count() != 4 {
        let four = "the units of mass, force, length and time, as in \"t, kN, m, s\"";
        faults.must_be(node, &path, four);
        return (String::new(), 1.0);
    }
    if let Some(message) = unit_consistency::fault(&text) {
        faults.add(node.at, &path, message);
        return (String::new(), 1.0);
    }
    let metre = unit_consistency::metres(&text);
    let has_seconds = text.split(',').any(|unit| unit.trim() == "s");
    // Of other units, g and the accelerations of records are unknown.
    let needs_metre = ["record", "synthetic", "weight"];
    if (metre.is_none() || !has_seconds)
        && crate::structure::reading::given::has_key(structure, &needs_metre)
    {
        let message = format!(
            "records, synthetic motions and weights need a length in {} and a time in s, as in \"t, kN, m, s\", got {}",
            unit_consistency::lengths(),
            quoted(&text)
        );
        faults.add(node.at, &path, message);
    }
    (text, metre.unwrap_or(1.0))
}

const REFERENCES: [Reference; 2] = [Reference::Softened, Reference::Rigid];

const STIFFNESSES: [DampingStiffness; 2] =
    [DampingStiffness::WithoutContacts, DampingStiffness::Initial];
