//! Channels of a structure: a quantity of a node or of a contact over time, or a difference of such quantities.

use super::names::Names;
use super::node::{NodeRef, Numbering};
use crate::problem::unit::Dimension;

/// A sum of quantities, each with its sign.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// The text in the study, with single blanks.
    pub name: String,
    /// The quantities with +1 or -1.
    pub terms: Vec<(f64, Term)>,
}

/// A quantity over time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Term {
    /// u of a node.
    Displacement(NodeRef),
    /// u' of a node.
    Velocity(NodeRef),
    /// u'' of a support, or of the ground.
    Acceleration(NodeRef),
    /// A quantity of a contact, by its place in the list.
    Contact(usize, Quantity),
}

/// A quantity of a contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// r.
    Displacement,
    /// rdot.
    Velocity,
    /// S.
    Force,
    /// r - S/k of displacement-control, r of other laws.
    Slip,
    /// Friction limit.
    Limit,
}

/// Names of the quantities of a contact, each with its meaning.
pub const QUANTITIES: [(&str, &str); 5] = [
    ("r", "relative displacement u_J - u_I + gap"),
    ("rdot", "relative velocity"),
    ("S", "contact force; negative in an impact"),
    (
        "slip",
        "r - S/k of displacement-control, r of the other laws",
    ),
    ("limit", "friction limit"),
];

/// Most names in a message.
const MOST_NAMES: usize = 50;

const ALL: [Quantity; 5] = [
    Quantity::Displacement,
    Quantity::Velocity,
    Quantity::Force,
    Quantity::Slip,
    Quantity::Limit,
];

impl Channel {
    /// The channel of a text such as `g1.right - p2` or `gap12.S`.
    ///
    /// # Errors
    /// The first part that is no channel, and what is allowed.
    pub fn parse(text: &str, names: &Names) -> Result<Channel, String> {
        let (mut terms, mut shown) = (Vec::new(), String::new());
        let mut sign = 1.0;
        let mut expects_term = true;
        let spaced = text.replace('-', " - ").replace('+', " + ");
        for word in spaced.split_whitespace() {
            match (word, expects_term) {
                ("-" | "+", false) => {
                    sign = if word == "-" { -1.0 } else { 1.0 };
                    shown += &format!(" {word} ");
                    expects_term = true;
                }
                ("-" | "+", true) => return Err(format!("expected a channel before '{word}'")),
                (_, false) => return Err(format!("expected - or + before '{word}'")),
                (_, true) => {
                    terms.push((sign, Term::parse(word, names)?));
                    shown += word;
                    expects_term = false;
                }
            }
        }
        match expects_term {
            true => Err("expected a channel at the end".into()),
            false => Ok(Channel { name: shown, terms }),
        }
    }

    /// The quantities of a structure with this numbering.
    pub fn numbers<'a>(&'a self, numbering: &'a Numbering) -> impl Iterator<Item = Number> + 'a {
        let terms = self.terms.iter();
        terms.filter_map(|(_, term)| term.number(numbering).ok().flatten())
    }

    /// What it measures; by its first quantity.
    pub fn dimension(&self) -> Dimension {
        let first = self.terms.first();
        first.map_or(Dimension::Length, |(_, term)| term.dimension())
    }

    /// The one contact that the channel is about; `None` for nodes and for differences.
    pub fn contact(&self) -> Option<usize> {
        match self.terms[..] {
            [(_, Term::Contact(contact, _))] => Some(contact),
            _ => None,
        }
    }
}

impl Term {
    fn parse(word: &str, names: &Names) -> Result<Term, String> {
        if let Some((contact, quantity)) = word.rsplit_once('.')
            && let Some(contact) = names.contact(contact)
        {
            let place = QUANTITIES.iter().position(|known| known.0 == quantity);
            let all = QUANTITIES.map(|known| known.0).join(", ");
            let unknown = || format!("a contact has the channels {all}, got '{quantity}'");
            return place
                .map(|place| Term::Contact(contact, ALL[place]))
                .ok_or_else(unknown);
        }
        if names.contact(word).is_some() {
            return Err(format!(
                "'{word}' is a contact; name one of its channels, such as {word}.S"
            ));
        }
        if let Some(found) = names.node(word) {
            return Ok(Term::Displacement(found));
        }
        let of = |end: &str| names.node(word.strip_suffix(end)?);
        if let Some(found) = of(".u") {
            return Ok(Term::Displacement(found));
        }
        if let Some(found) = of(".v") {
            return Ok(Term::Velocity(found));
        }
        if let Some(found) = of(".a") {
            let name = word.strip_suffix(".a").unwrap_or(word);
            return match names.is_support(name) {
                true => Ok(Term::Acceleration(found)),
                false => Err(format!("only a support has an acceleration, got '{word}'")),
            };
        }
        if let Some(why) = names.why_no_dof(word) {
            return Err(format!("no channel '{word}': {why}"));
        }
        let bars = names
            .bars
            .iter()
            .map(|bar| format!("{bar}.left, {bar}.right"));
        let masses = names.masses.iter().cloned();
        let dofs = names.matrices.iter().map(|(name, imported)| {
            let first = imported.dofs.name(0);
            format!("{name}.{first} and the other dofs of {name}")
        });
        let contacts = names.contacts.iter().map(|contact| format!("{contact}.S"));
        let supports = names.supports.iter().map(|(name, _)| format!("{name}.u"));
        let known = masses.chain(bars).chain(dofs).chain(supports);
        let known = known.chain(contacts);
        let known: Vec<String> = known.take(MOST_NAMES).collect();
        Err(format!(
            "no node or contact '{word}'; channels are u and v of nodes and {} of contacts: {}",
            QUANTITIES.map(|known| known.0).join(", "),
            known.join(", ")
        ))
    }

    fn dimension(self) -> Dimension {
        match self {
            Term::Displacement(_) => Dimension::Length,
            Term::Velocity(_) => Dimension::Velocity,
            Term::Acceleration(_) => Dimension::Acceleration,
            Term::Contact(_, quantity) => match quantity {
                Quantity::Displacement | Quantity::Slip => Dimension::Length,
                Quantity::Velocity => Dimension::Velocity,
                Quantity::Force | Quantity::Limit => Dimension::Force,
            },
        }
    }

    /// The quantity of a structure with this numbering; `None` for the ground, which is always 0.
    ///
    /// # Errors
    /// A bar has no such inner node.
    pub fn number(self, numbering: &Numbering) -> Result<Option<Number>, String> {
        Ok(match self {
            Term::Displacement(node) => numbering.find(node)?.map(Number::Displacement),
            Term::Velocity(node) => numbering.find(node)?.map(Number::Velocity),
            Term::Acceleration(NodeRef::Support(support)) => Some(Number::Acceleration(support)),
            Term::Acceleration(_) => None,
            Term::Contact(contact, quantity) => Some(Number::Contact(contact, quantity)),
        })
    }
}

/// A quantity of a numbered structure.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Number {
    /// u of a node, or of a support after the nodes.
    Displacement(usize),
    /// u' of a node.
    Velocity(usize),
    /// u'' of a support that moves, by its place among them.
    Acceleration(usize),
    /// A quantity of a contact.
    Contact(usize, Quantity),
}

impl Number {
    /// The node whose motion it is; `None` for a contact.
    pub fn node(&self) -> Option<usize> {
        match self {
            Number::Displacement(node) | Number::Velocity(node) => Some(*node),
            Number::Acceleration(_) | Number::Contact(..) => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names() -> Names {
        let owned = |names: [&str; 2]| names.map(str::to_owned).to_vec();
        Names::new(owned(["p1", "p2"]), owned(["g1", "g2"]), Vec::new())
            .with_contacts(owned(["gap", "bearing"]))
    }

    #[test]
    fn channels_are_quantities_and_their_differences() {
        let channel = |text| Channel::parse(text, &names()).unwrap();
        let right = Term::Displacement(NodeRef::Right(0));
        let p2 = Term::Displacement(NodeRef::Mass(1));
        let difference = channel("g1.right-p2");
        assert_eq!(difference.terms, [(1.0, right), (-1.0, p2)]);
        assert_eq!(difference.name, "g1.right - p2");
        assert_eq!(difference, channel(" g1.right  -  p2 "));
        assert_eq!(channel("p2.u").terms, channel("p2").terms);
        let inner = Term::Velocity(NodeRef::Inner(1, 12));
        assert_eq!(channel("g2.12.v").terms, [(1.0, inner)]);
        assert_eq!(channel("g2.12.v").dimension(), Dimension::Velocity);
        let force = Term::Contact(0, Quantity::Force);
        assert_eq!(channel("gap.S").terms, [(1.0, force)]);
        assert_eq!(channel("gap.S").contact(), Some(0));
        assert_eq!(channel("gap.S - bearing.S").contact(), None);
    }

    #[test]
    fn what_is_no_channel_is_named() {
        for (text, part) in [
            ("", "at the end"),
            ("p1 -", "at the end"),
            ("- p1", "before '-'"),
            ("p1 p2", "before 'p2'"),
            ("gap", "'gap' is a contact"),
            ("gap.F", "got 'F'"),
            ("g1", "no node or contact 'g1'"),
            ("g1.03", "no node or contact 'g1.03'"),
        ] {
            let why = Channel::parse(text, &names()).unwrap_err();
            assert!(why.contains(part), "{text}: {why}");
        }
    }
}
