//! Channels of a structure: a quantity over time, or a difference of such quantities.

pub(crate) mod describe;
mod find;
mod number;
mod term;

pub use describe::{OF_BASE, OF_ENERGY, OF_GROUND, OF_NODES, OF_SPRINGS, UNKNOWN};
pub use number::{Derived, Energy, Number};
pub use term::Term;

use super::names::Names;
use crate::problem::numbers::unit::Dimension;
use crate::problem::structure::given::node::Numbering;

/// A sum of quantities, each with its factor.
#[derive(Debug, Clone, PartialEq)]
pub struct Channel {
    /// The text in the study, with single blanks.
    pub name: String,
    /// The quantities with their factors: +1 or -1, those that the study writes, of tied dofs, and of forces of members.
    pub terms: Vec<(f64, Term)>,
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
    /// |r| of a contact in a plane, of which the place is that of the first direction; so are the next three.
    Distance,
    /// |rdot|.
    Speed,
    /// |S|.
    Size,
    /// |r - S/k|.
    SlipDistance,
}

impl Quantity {
    /// The quantity of a direction of which this is the length; `None` for a quantity of a direction.
    pub fn of_direction(self) -> Option<Quantity> {
        match self {
            Quantity::Distance => Some(Quantity::Displacement),
            Quantity::Speed => Some(Quantity::Velocity),
            Quantity::Size => Some(Quantity::Force),
            Quantity::SlipDistance => Some(Quantity::Slip),
            Quantity::Displacement
            | Quantity::Velocity
            | Quantity::Force
            | Quantity::Slip
            | Quantity::Limit => None,
        }
    }

    /// The length of this quantity of both directions of a contact in a plane; the limit is that of both.
    pub fn in_plane(self) -> Quantity {
        match self {
            Quantity::Displacement => Quantity::Distance,
            Quantity::Velocity => Quantity::Speed,
            Quantity::Force => Quantity::Size,
            Quantity::Slip => Quantity::SlipDistance,
            other @ (Quantity::Limit
            | Quantity::Distance
            | Quantity::Speed
            | Quantity::Size
            | Quantity::SlipDistance) => other,
        }
    }
}

/// Names of the quantities of a contact, each with its meaning; the last one is an energy.
pub const QUANTITIES: [(&str, &str); 6] = [
    ("r", "relative displacement u_J - u_I + gap"),
    ("rdot", "relative velocity"),
    ("S", "contact force; negative in an impact"),
    (
        "slip",
        "r - S/k of displacement-control, r of the other laws",
    ),
    ("limit", "friction limit"),
    (
        "dissipated",
        "energy that the contact dissipated since t = 0: the work of S less what it has stored since",
    ),
];

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
        let (mut sign, mut rest) = (1.0, text.trim_start());
        loop {
            let factor = factor(rest);
            if let Some((_, written)) = factor {
                shown += &format!("{}*", written.trim_end());
                rest = rest[written.len() + 1..].trim_start();
            }
            let end = rest.find(|c: char| c.is_whitespace() || "+-*".contains(c));
            let (word, after) = rest.split_at(end.unwrap_or(rest.len()));
            rest = after.trim_start();
            match (word, rest.chars().next()) {
                ("", Some(sign @ ('+' | '-'))) => {
                    return Err(format!("expected a channel before '{sign}'"));
                }
                ("", None) => return Err("expected a channel at the end".into()),
                ("", Some(_)) | (_, Some('*')) => {
                    return Err(format!(
                        "a factor is a number before a channel, as in 3*p1, got '{}'",
                        text.trim()
                    ));
                }
                _ => {}
            }
            let factor = sign * factor.map_or(1.0, |(factor, _)| factor);
            for (weight, term) in Term::parse(word, names)? {
                if let Some((_, first)) = terms.first() {
                    of_one_dimension(text, *first, term)?;
                }
                terms.push((factor * weight, term));
            }
            shown += word;
            let Some(operator) = rest.chars().next() else {
                return Ok(Channel { name: shown, terms });
            };
            sign = match operator {
                '-' => -1.0,
                '+' => 1.0,
                _ => {
                    let word = rest.split_whitespace().next().unwrap_or_default();
                    return Err(format!("expected - or + before '{word}'"));
                }
            };
            shown += &format!(" {operator} ");
            rest = rest[1..].trim_start();
        }
    }

    /// The quantities of a structure with this numbering.
    pub fn numbers<'a>(&'a self, numbering: &'a Numbering) -> impl Iterator<Item = Number> + 'a {
        let terms = self.terms.iter();
        let numbers = terms.filter_map(|(_, term)| term.number(numbering).ok().flatten());
        // Errors of a length are lengths of differences.
        numbers.flat_map(|number| {
            let both = number.directions().into_iter().flatten();
            std::iter::once(number).chain(both)
        })
    }

    /// The channels of both directions of which the channel is the length; `None` for other channels.
    pub fn by_direction(&self) -> Option<[Channel; 2]> {
        let [(1.0, Term::Contact(contact, quantity))] = self.terms[..] else {
            return None;
        };
        let component = quantity.of_direction()?;
        Some([0, 1].map(|direction| Channel {
            name: format!("{}.{}", self.name, direction + 1),
            terms: vec![(1.0, Term::Contact(contact + direction, component))],
        }))
    }

    /// What it measures; by its first quantity.
    pub fn dimension(&self) -> Dimension {
        let first = self.terms.first();
        first.map_or(Dimension::Length, |(_, term)| term.dimension())
    }

    /// Whether it needs more of a structure than its equations and its motion.
    pub fn is_derived(&self) -> bool {
        let derived = |(_, term): &(f64, Term)| term.is_derived();
        self.terms.iter().any(derived)
    }

    /// Whether it contains an energy, of which no exact motion says anything.
    pub fn has_energy(&self) -> bool {
        let energy = |(_, term): &(f64, Term)| matches!(term, Term::Energy(_));
        self.terms.iter().any(energy)
    }

    /// The one contact that the channel is about; `None` for nodes and for differences.
    pub fn contact(&self) -> Option<usize> {
        match self.terms[..] {
            [(_, Term::Contact(contact, _))] => Some(contact),
            _ => None,
        }
    }
}

/// The number with `*` behind it that a text begins with, and its text.
fn factor(text: &str) -> Option<(f64, &str)> {
    let (written, _) = text.split_once('*')?;
    let number: f64 = written.trim_end().parse().ok()?;
    let is_number = written.starts_with(|c: char| c.is_ascii_digit() || c == '.');
    (is_number && number.is_finite()).then_some((number, written))
}

/// A sum has quantities of one dimension.
fn of_one_dimension(text: &str, first: Term, term: Term) -> Result<(), String> {
    match first.dimension() == term.dimension() {
        true => Ok(()),
        false => Err(format!(
            "'{}' adds quantities of different dimensions: {} and {}",
            text.trim(),
            first.dimension().in_words(),
            term.dimension().in_words()
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::structure::given::node::NodeRef;

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
        let factors = channel("3 * g1.right-.5e-1*p2");
        assert_eq!(factors.terms, [(3.0, right), (-0.05, p2)]);
        assert_eq!(factors.name, "3*g1.right - .5e-1*p2");
        assert_eq!(channel(&factors.name), factors);
    }

    #[test]
    fn what_is_no_channel_is_named() {
        for (text, part) in [
            ("", "at the end"),
            ("p1 -", "at the end"),
            ("- p1", "before '-'"),
            ("p1 p2", "before 'p2'"),
            ("3 p1", "no node or contact '3'"),
            ("p1*3", "as in 3*p1, got 'p1*3'"),
            ("3*2*p1", "as in 3*p1"),
            ("p1 - inf*p2", "as in 3*p1"),
            ("3*", "at the end"),
            ("3* - p1", "before '-'"),
            ("2*p1 + gap.S", "a length and a force"),
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
