//! Elastic contacts in series with a damper, as springs behind which it is.

use super::AdaptiveFault;
use super::moving::braced::may_be_braced;
use crate::contact::ClippedLine;
use crate::exact::events::State;
use crate::system::structure::{Along, Chain, Structure};

/// Part of a start by which r and S/k of an elastic contact may differ.
const ROUND_OFF: f64 = 1e-12;

/// The contacts of a structure whose chains are dampers behind springs.
#[derive(Debug)]
pub struct Linked {
    elastic: Vec<Elastic>,
    values: [Vec<f64>; 4],
    slides: Option<String>,
}

/// A contact that has become a spring.
#[derive(Debug)]
struct Elastic {
    contact: usize,
    name: String,
    along: Along,
    stiffness: f64,
    limit: f64,
    /// The damper, and S over its S.
    damper: (usize, f64),
}

impl Linked {
    /// With the structure, in which what was elastic is among the springs, and a contact without force; `None` without chains, or with one
    /// that is no damper with elastic contacts that start unbent.
    pub fn new(given: &Structure) -> Option<(Structure, Linked)> {
        let mut structure = given.clone();
        let mut elastic = Vec::new();
        for chain in given.chains() {
            elastic.extend(of_chain(given, &chain)?);
        }
        for spring in &elastic {
            structure
                .stiffness
                .add_along(&spring.along, spring.stiffness);
            structure.contacts[spring.contact].along.clear();
            if let Some(force) = structure.preload.forces.get_mut(spring.contact) {
                *force = None;
            }
        }
        let values = [(); 4].map(|()| vec![0.0; given.contacts.len()]);
        let is_linked = !elastic.is_empty();
        let linked = Linked {
            elastic,
            values,
            slides: None,
        };
        is_linked.then_some((structure, linked))
    }

    /// The nodes of what was elastic, of which a state must have the rates.
    pub fn nodes(&self) -> impl Iterator<Item = usize> + '_ {
        let along = self.elastic.iter().flat_map(|spring| &spring.along);
        along.map(|(node, _)| *node)
    }

    /// A state with the contacts that were given.
    pub fn given<'a>(&'a mut self, state: &'a State) -> State<'a> {
        let quantities = [state.r, state.rate, state.force, state.slip];
        for (values, quantity) in self.values.iter_mut().zip(quantities) {
            values.copy_from_slice(quantity);
        }
        let [r, rate, force, slip] = &mut self.values;
        for spring in &self.elastic {
            let (damper, factor) = spring.damper;
            let s = factor * state.force[damper];
            if s.abs() >= spring.limit {
                self.slides.get_or_insert_with(|| spring.name.clone());
            }
            let rates = spring.along.iter().map(|(node, by)| by * state.v[*node]);
            (r[spring.contact], rate[spring.contact]) = (s / spring.stiffness, rates.sum());
            (force[spring.contact], slip[spring.contact]) = (s, 0.0);
        }
        State {
            u: state.u,
            v: state.v,
            r,
            rate,
            force,
            slip,
        }
    }

    /// What the motion says in the end.
    ///
    /// # Errors
    /// A contact that was taken as elastic slides.
    pub fn end(self) -> Result<(), AdaptiveFault> {
        let what = "slides in series with a damper";
        let fault = |name| Err(AdaptiveFault::Contact { name, what });
        self.slides.map_or(Ok(()), fault)
    }
}

/// The elastic contacts of a chain with one damper.
fn of_chain(given: &Structure, chain: &Chain) -> Option<Vec<Elastic>> {
    if chain.links.iter().any(|link| link.len() != 1) {
        return None;
    }
    let law = |contact: usize| &given.contacts[contact].law;
    let mut dampers = chain
        .members()
        .filter(|member| may_be_braced(law(member.contact)));
    let (Some(damper), None) = (dampers.next(), dampers.next()) else {
        return None;
    };
    let others = chain
        .members()
        .filter(|member| member.contact != damper.contact);
    let elastic = others.map(|member| {
        let contact = &given.contacts[member.contact];
        let Some(ClippedLine::Elastic { stiffness }) = contact.law.line() else {
            return None;
        };
        let limit = contact.law.limit()?;
        let is_constant = limit.varying.is_none() && limit.pressed_by.is_none();
        let r = given.relative(member.contact, &given.displacement);
        let s = given.preload.force(member.contact).unwrap_or(0.0);
        let is_unbent = (stiffness * r - s).abs() <= ROUND_OFF * s.abs();
        (is_constant && is_unbent && contact.gap == 0.0).then(|| Elastic {
            contact: member.contact,
            name: contact.name.clone(),
            along: contact.along.clone(),
            stiffness,
            limit: limit.at(0.0),
            damper: (damper.contact, member.sign * damper.sign),
        })
    });
    elastic.collect()
}
