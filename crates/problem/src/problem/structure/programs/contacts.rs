//! The contacts of a request.

use super::json::{numbers, object};
use super::request::Request;
use crate::contact::ContactKind;
use crate::contact::number::Usual;
use crate::contact::offer::Place;
use crate::problem::Violation;
use crate::problem::structure::parts::contact::{Contact, Normal, Pressing};
use crate::problem::structure::parts::contact_law::law_named;
use crate::system::loads::STANDARD_GRAVITY;
use crate::system::structure::PlaneRow;

impl Request<'_> {
    /// The contacts, those in a plane with both directions.
    pub(super) fn contacts(&self) -> Result<Vec<Vec<u8>>, String> {
        let given = &self.problem.template.contacts;
        let indexed = given.iter().enumerate();
        let first = indexed.filter(|(_, contact)| contact.row != Some(PlaneRow::Second));
        first.map(|(c, contact)| self.contact(c, contact)).collect()
    }

    fn contact(&self, c: usize, given: &Contact) -> Result<Vec<u8>, String> {
        let (structure, case) = (self.structure, &self.ready.case);
        let placed = &structure.contacts[c];
        let law = given.law.name(case);
        let in_plane = given.row == Some(PlaneRow::First);
        let normal = self.normal(given)?;
        let table = given.table(case).map_err(|broken| broken.message)?;
        let numbers_of_law = law_named(law).and_then(|law| law.at(Place::Structure));
        let mut found = Vec::new();
        for of_law in numbers_of_law.into_iter().flat_map(|offer| offer.numbers) {
            let value = given
                .value(of_law.key, case)
                .map_err(|broken| broken.message)?;
            let usual = match of_law.usual {
                Usual::Is(x) => Some(x),
                Usual::Needed | Usual::Follows(_) => None,
            };
            found.extend(value.or(usual).map(|x| (of_law.key, x)));
        }
        for key in ["limit", "nu", "pressure_exponent"] {
            let value = given.value(key, case).map_err(|broken| broken.message)?;
            if !found.iter().any(|known| known.0 == key) {
                found.extend(value.map(|x| (key, x)));
            }
        }
        let has_gap = given.gap.is_some() || placed.law.kind() != ContactKind::Friction;
        found.extend(has_gap.then_some(("gap", placed.gap)));
        let name = match in_plane {
            true => given.name.strip_suffix(".1").unwrap_or(&given.name),
            false => &given.name,
        };
        let mut text = Vec::new();
        object(&mut text, |members| {
            members.put("name", name);
            members.put("law", law);
            members.object("numbers", |members| {
                found.iter().for_each(|(key, x)| members.put(key, x));
                if !table.is_empty() {
                    members.put("table", table);
                }
            });
            match &normal {
                N::None => {}
                N::Constant(x) => members.put("N", x),
                N::Values(values) => members.add("N", |text| numbers(text, values, self.base64)),
                N::Contact(name) => members.object("N", |members| members.put("contact", name)),
            }
            let along = |c: usize| &structure.contacts[c].along;
            match in_plane {
                true => members.put("plane", [along(c), along(c + 1)]),
                false => members.put("along", along(c)),
            }
            let moved: Vec<(&str, f64)> = structure
                .supports
                .iter()
                .map(|support| {
                    let along = placed.along.iter();
                    let carried = along.map(|(node, x)| x * support.carried[*node]);
                    (&*support.name, support.gaps[c] - carried.sum::<f64>())
                })
                .filter(|(_, x)| *x != 0.0)
                .collect();
            if !moved.is_empty() {
                members.object("along_supports", |members| {
                    moved.iter().for_each(|(name, x)| members.put(name, x));
                });
            }
        });
        Ok(text)
    }

    /// The normal force of a contact.
    fn normal(&self, given: &Contact) -> Result<N, String> {
        let case = &self.ready.case;
        let metre = self.problem.template.metre;
        let steps = self.ready.last as usize;
        let unless_broken = |broken: Violation| broken.message;
        Ok(match &given.normal {
            None => N::None,
            Some(Normal::Constant(force)) => N::Constant(force.value(case).map_err(unless_broken)?),
            Some(Normal::Table(source)) => {
                let signal = source.signal(case, metre).map_err(unless_broken)?;
                N::Values(signal.at_steps(self.ready.dt, steps))
            }
            Some(Normal::Weight { weight, vertical }) => {
                let weight = weight.value(case).map_err(unless_broken)?;
                let (signal, scale) = vertical.in_case(case, metre).map_err(unless_broken)?;
                let factor = scale * metre / STANDARD_GRAVITY;
                let values = signal.at_steps(self.ready.dt, steps).into_iter();
                N::Values(values.map(|a| weight * (1.0 + factor * a)).collect())
            }
            Some(Normal::Parts(parts)) => match &parts[..] {
                [one] if matches!(one.part, Pressing::Contact(_)) => N::Contact(one.name.clone()),
                _ => {
                    return Err(format!(
                        "N of contact {} is the force of a spring or of several parts, which a request does not have; it has a number, a \
                         function of time, or one contact",
                        given.name
                    ));
                }
            },
        })
    }
}

/// A normal force in a request.
enum N {
    None,
    Constant(f64),
    /// At the instants.
    Values(Vec<f64>),
    /// The force of a contact.
    Contact(String),
}
