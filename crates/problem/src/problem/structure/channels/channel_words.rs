//! Channels in words, for figures and captions: the one table of these words, and the sums of channels.

use super::channel::{Channel, Energy, Quantity, Term};
use super::names::Names;
use crate::problem::numbers::unit::Dimension;
use crate::system::structure::{Direction, Quantity as OfMotion};

/// Channels by their names, each with its words; `{}` is the node, contact, spring, element or support.
pub const WORDS: [(&str, &str); 25] = [
    ("NODE.u", "displacement of {}"),
    ("NODE.v", "velocity of {}"),
    ("NODE.a", "acceleration of {}"),
    ("NODE.a_abs", "absolute acceleration of {}"),
    ("CONTACT.r", "relative displacement of {}"),
    ("CONTACT.rdot", "relative velocity of {}"),
    ("CONTACT.S", "contact force of {}"),
    ("CONTACT.slip", "slip of {}"),
    ("CONTACT.limit", "friction limit of {}"),
    ("CONTACT.dissipated", "energy dissipated by {}"),
    ("SPRING.S", "force of {}"),
    ("BAR.3.S", "force of element {}"),
    ("MATRICES.FORCE", "{}"),
    ("ground", "ground acceleration"),
    ("ground.a", "ground acceleration"),
    ("ground.v", "ground velocity"),
    ("ground.u", "ground displacement"),
    ("base", "base force"),
    ("base.SUPPORT", "force of support {}"),
    ("energy.kinetic", "kinetic energy"),
    ("energy.elastic", "elastic energy"),
    ("energy.damping", "energy dissipated by damping"),
    ("energy.contacts", "energy dissipated by contacts"),
    ("energy.method", "energy taken by the method"),
    ("energy.input", "input energy"),
];

/// The words that a study gives its channels and contacts.
#[derive(Debug, Clone, Default)]
pub struct Shown {
    /// Channels, each with its words and, if given, its unit.
    pub channels: Vec<(Channel, [String; 2])>,
    /// Contacts, each with its words.
    pub contacts: Vec<(String, String)>,
}

/// The parts of a structure and the words that its study gives them.
#[derive(Debug, Clone, Copy)]
pub struct Words<'a> {
    /// The parts.
    pub names: &'a Names,
    /// The words.
    pub shown: &'a Shown,
}

/// A term of a channel in words.
#[derive(Debug, PartialEq)]
struct Phrase {
    /// With `{}` for what it is of.
    words: String,
    of: String,
}

impl Phrase {
    fn text(&self) -> String {
        self.words.replace("{}", &self.of)
    }
}

impl Words<'_> {
    /// A contact in words.
    pub fn contact(&self, name: &str) -> String {
        let mut titles = self.shown.contacts.iter();
        let title = titles.find(|pair| pair.0 == name);
        title.map_or(name, |pair| &pair.1).to_owned()
    }

    /// A channel in words, such as `displacement of g1.right relative to p2`.
    pub fn channel(&self, channel: &Channel) -> String {
        if let Some([words, _]) = self.given(channel) {
            return words.clone();
        }
        let mut terms: Vec<(&str, Phrase)> = Vec::new();
        let mut sign = "+";
        for word in channel.name.split(' ') {
            match word {
                "+" | "-" => sign = word,
                word => terms.push((sign, self.phrase(word))),
            }
        }
        match &terms[..] {
            [(_, one)] => one.text(),
            [("+", one), ("-", other)] if one.words == other.words && one.words.contains("{}") => {
                let both = format!("{} relative to {}", one.of, other.of);
                one.words.replace("{}", &both)
            }
            several => {
                let term = |(index, (sign, phrase)): (usize, &(&str, Phrase))| match index {
                    0 => phrase.text(),
                    _ => format!(" {} {}", sign.replace('-', "−"), phrase.text()),
                };
                several.iter().enumerate().map(term).collect()
            }
        }
    }

    /// What the study gives a channel: its words and its unit.
    fn given(&self, channel: &Channel) -> Option<&[String; 2]> {
        let mut channels = self.shown.channels.iter();
        let entry = channels.find(|pair| pair.0.terms == channel.terms)?;
        Some(&entry.1)
    }

    /// The unit of a channel, if the study gives it one or `of` knows that of its dimension.
    pub fn unit(
        &self,
        channel: &Channel,
        of: impl Fn(Dimension) -> Option<String>,
    ) -> Option<String> {
        match self.given(channel) {
            Some([_, unit]) if !unit.is_empty() => return Some(unit.clone()),
            _ => {}
        }
        let pieces = channel.name.split(' ');
        let mut words = pieces.filter(|word| !["+", "-"].contains(word));
        let unit = of(channel.dimension())?;
        // An angle has no length.
        Some(match words.all(|word| self.rotation(word).is_some()) {
            true => match (channel.dimension(), of(Dimension::Time)) {
                (Dimension::Velocity, Some(time)) => format!("rad/{time}"),
                (Dimension::Acceleration, Some(time)) => format!("rad/{time}2"),
                _ => "rad".to_owned(),
            },
            false => unit,
        })
    }

    /// The rotation of which a term is, with its node.
    fn rotation<'t>(&self, word: &'t str) -> Option<(&'t str, Direction)> {
        let word = word.split_once('*').map_or(word, |(_, word)| word);
        let node = self.node(word)?;
        let (base, direction) = node.rsplit_once('.')?;
        let direction = Direction::named(direction)?;
        (!Direction::TRANSLATIONS.contains(&direction)).then_some((base, direction))
    }

    /// The node of a term that is of a node.
    fn node<'t>(&self, word: &'t str) -> Option<&'t str> {
        if self.names.nodes(word).is_some() {
            return Some(word);
        }
        let (node, _) = word.rsplit_once('.')?;
        self.names.nodes(node).map(|_| node)
    }

    /// A term in words.
    fn phrase(&self, word: &str) -> Phrase {
        let plain = |words: &str, of: &str| Phrase {
            words: words.to_owned(),
            of: of.to_owned(),
        };
        let Ok(channel) = Channel::parse(word, self.names) else {
            return plain("{}", word);
        };
        if let Some([words, _]) = self.given(&channel) {
            return plain(words, "");
        }
        if let Some((factor, word)) = word.split_once('*') {
            let Phrase { words, of } = self.phrase(word);
            return plain(&format!("{factor} × {words}"), &of);
        }
        let Some((_, term)) = channel.terms.first() else {
            return plain("{}", word);
        };
        let row = WORDS.iter().find(|row| row.0 == key(*term));
        let words = row.map_or("{}", |row| row.1);
        let above = || word.rsplit_once('.').map_or(word, |(above, _)| above);
        match term {
            Term::Displacement(_)
            | Term::Velocity(_)
            | Term::Acceleration(_)
            | Term::Absolute(_) => self.of_node(words, self.node(word).unwrap_or(word)),
            Term::Contact(..) | Term::Energy(Energy::Contact(_)) => {
                self.of_contact(words, word, *term)
            }
            Term::Spring(_) => plain(words, above()),
            Term::Element(..) => {
                let (bar, element) = above().rsplit_once('.').unwrap_or_default();
                plain(words, &format!("{element} of {bar}"))
            }
            Term::Member(..) => {
                let (matrices, force) = word.split_once('.').unwrap_or_default();
                plain(words, &format!("{} of {matrices}", force.replace('_', " ")))
            }
            Term::Ground(direction, _) => self.in_direction(words, *direction, &self.names.ground),
            Term::Base(direction) => self.in_direction(words, *direction, &self.names.directions),
            Term::Reaction(_) => {
                let (_, support) = word.split_once('.').unwrap_or_default();
                self.of_node(words, support)
            }
            Term::Energy(_) => plain(words, ""),
        }
    }

    /// The words of a node, with the direction behind if its name has one.
    fn of_node(&self, words: &str, node: &str) -> Phrase {
        if let Some((base, direction)) = self.rotation(node) {
            let angular = words
                .replacen("displacement", "rotation", 1)
                .replacen("velocity", "angular velocity", 1)
                .replacen("acceleration", "angular acceleration", 1);
            let axis = direction.name().trim_start_matches('r');
            return Phrase {
                words: format!("{angular} about {axis}"),
                of: base.to_owned(),
            };
        }
        let split = node
            .rsplit_once('.')
            .filter(|(_, end)| Direction::named(end).is_some());
        match split {
            Some((base, direction)) => Phrase {
                words: format!("{words} in {direction}"),
                of: base.to_owned(),
            },
            None => Phrase {
                words: words.to_owned(),
                of: node.to_owned(),
            },
        }
    }

    /// The words of a contact; of one in a plane as a whole, or of one of its directions.
    fn of_contact(&self, words: &str, word: &str, term: Term) -> Phrase {
        let (rest, last) = word.rsplit_once('.').unwrap_or_default();
        if let Some((contact, _)) = rest.rsplit_once('.')
            && self.names.plane(contact).is_some()
            && ["1", "2"].contains(&last)
        {
            return Phrase {
                words: format!("{words} in direction {last}"),
                of: self.contact(contact),
            };
        }
        let is_length =
            matches!(term, Term::Contact(_, quantity) if quantity.of_direction().is_some());
        Phrase {
            words: match is_length {
                true => format!("resultant {words}"),
                false => words.to_owned(),
            },
            of: self.contact(rest),
        }
    }

    /// Words with the direction behind, if there are several.
    fn in_direction(&self, words: &str, direction: Direction, directions: &[Direction]) -> Phrase {
        Phrase {
            words: match directions.len() > 1 {
                true => format!("{words} in {}", direction.name()),
                false => words.to_owned(),
            },
            of: String::new(),
        }
    }
}

/// The key in [`WORDS`] of a term.
fn key(term: Term) -> &'static str {
    match term {
        Term::Displacement(_) => "NODE.u",
        Term::Velocity(_) => "NODE.v",
        Term::Acceleration(_) => "NODE.a",
        Term::Absolute(_) => "NODE.a_abs",
        Term::Contact(_, quantity) => match quantity {
            Quantity::Displacement | Quantity::Distance => "CONTACT.r",
            Quantity::Velocity | Quantity::Speed => "CONTACT.rdot",
            Quantity::Force | Quantity::Size => "CONTACT.S",
            Quantity::Slip | Quantity::SlipDistance => "CONTACT.slip",
            Quantity::Limit => "CONTACT.limit",
        },
        Term::Energy(energy) => match energy {
            Energy::Kinetic => "energy.kinetic",
            Energy::Elastic => "energy.elastic",
            Energy::Damping => "energy.damping",
            Energy::Contacts => "energy.contacts",
            Energy::Method => "energy.method",
            Energy::Input => "energy.input",
            Energy::Contact(_) => "CONTACT.dissipated",
        },
        Term::Spring(_) => "SPRING.S",
        Term::Element(..) => "BAR.3.S",
        Term::Member(..) => "MATRICES.FORCE",
        Term::Ground(_, OfMotion::Displacement) => "ground.u",
        Term::Ground(_, OfMotion::Velocity) => "ground.v",
        Term::Ground(_, OfMotion::Acceleration) => "ground",
        Term::Base(_) => "base",
        Term::Reaction(_) => "base.SUPPORT",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::problem::structure::channels::channel::{
        OF_BASE, OF_ENERGY, OF_GROUND, OF_NODES, OF_SPRINGS, QUANTITIES,
    };
    use crate::problem::structure::channels::names::StructureNames;

    fn owned(names: &[&str]) -> Vec<String> {
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    #[test]
    fn every_channel_of_the_pages_has_words() {
        let nodes = OF_NODES.map(|row| format!("NODE.{}", row.0));
        let contacts = QUANTITIES.map(|row| format!("CONTACT.{}", row.0));
        let rows = [&OF_SPRINGS[..], &OF_GROUND, &OF_BASE, &OF_ENERGY].concat();
        let others = rows.into_iter().map(|row| row.0.to_owned());
        for name in nodes.into_iter().chain(contacts).chain(others) {
            assert!(WORDS.iter().any(|row| row.0 == name), "{name}");
        }
    }

    #[test]
    fn channels_are_in_words() {
        let masses = owned(&["p1", "p2", "a.x", "a.y", "a.rz"]);
        let names = Names::new(masses, owned(&["g1"]), Vec::new())
            .with_supports(vec![("left".into(), [true, true, false])])
            .with_contacts(owned(&["gap", "disc.1", "disc.2"]))
            .with_structure(StructureNames {
                springs: vec![("storey".into(), 0)],
                planes: vec![("disc".into(), 1)],
                ground: vec![Direction::X, Direction::Y],
                directions: vec![Direction::X, Direction::Y],
            });
        let shown = Shown {
            channels: Vec::new(),
            contacts: vec![("disc".into(), "bearing A".into())],
        };
        let words = Words {
            names: &names,
            shown: &shown,
        };
        for (text, expected) in [
            ("p1", "displacement of p1"),
            ("p1.v", "velocity of p1"),
            ("g1.right-p2", "displacement of g1.right relative to p2"),
            ("a.x.a_abs", "absolute acceleration of a in x"),
            (
                "a.x - left",
                "displacement of a in x − displacement of left",
            ),
            ("a.y - left.y", "displacement of a relative to left in y"),
            ("a.rz", "rotation of a about z"),
            ("a.rz.v", "angular velocity of a about z"),
            ("gap.rdot", "relative velocity of gap"),
            (
                "gap.S + disc.S.2",
                "contact force of gap + contact force of bearing A in direction 2",
            ),
            ("disc.S", "resultant contact force of bearing A"),
            ("disc.limit", "friction limit of bearing A"),
            ("disc.dissipated", "energy dissipated by bearing A"),
            ("storey.S", "force of storey"),
            ("g1.3.S", "force of element 3 of g1"),
            ("ground.y", "ground acceleration in y"),
            ("ground.x.u", "ground displacement in x"),
            ("base.x", "base force in x"),
            ("base.left.y", "force of support left in y"),
            (
                "energy.input - energy.kinetic",
                "input energy − kinetic energy",
            ),
        ] {
            let channel = Channel::parse(text, &names).unwrap();
            assert_eq!(words.channel(&channel), expected, "{text}");
        }
        let metres = |_| Some("m".to_owned());
        let unit = |text| words.unit(&Channel::parse(text, &names).unwrap(), metres);
        assert_eq!(
            [unit("a.rz"), unit("a.x")],
            ["rad", "m"].map(|unit| Some(unit.to_owned()))
        );
    }
}
