//! A law by a name of studies.

use crate::contact::number::Number;
use crate::contact::numbers::structure;
use crate::contact::{
    ClippedLine, ContactKind, ContactLaw, GivenLaw, GivenNumbers, LAWS, LawFault, WhichLaw,
};

/// A law by a name of studies: what pages and messages say of it, its numbers, and the law of these numbers.
#[derive(Debug, Clone, Copy)]
pub struct Offer {
    /// Its name.
    pub name: &'static str,
    /// Words of other programs for it, without capitals and hyphens.
    pub also: &'static [&'static str],
    /// In the friction oscillator; `None` if it is not offered there.
    pub oscillator: Option<In>,
    /// Between bars.
    pub bars: Option<In>,
    /// In structures. Those of the limit of friction are not among its numbers.
    pub structure: Option<In>,
    /// The law of its numbers in any of them, or the rule that they break.
    pub form: fn(&GivenNumbers) -> Result<Form, LawFault>,
}

impl Offer {
    /// A law that no problem offers yet.
    pub(in crate::contact) const fn new(
        name: &'static str,
        form: fn(&GivenNumbers) -> Result<Form, LawFault>,
    ) -> Offer {
        Offer {
            name,
            also: &[],
            oscillator: None,
            bars: None,
            structure: None,
            form,
        }
    }

    /// With words of other programs.
    pub(in crate::contact) const fn also(self, also: &'static [&'static str]) -> Offer {
        Offer { also, ..self }
    }

    /// Offered in the friction oscillator.
    pub(in crate::contact) const fn in_oscillator(
        self,
        meaning: &'static str,
        numbers: &'static [&'static Number],
    ) -> Offer {
        let oscillator = Some(In { meaning, numbers });
        Offer { oscillator, ..self }
    }

    /// Offered between bars.
    pub(in crate::contact) const fn between_bars(
        self,
        meaning: &'static str,
        numbers: &'static [&'static Number],
    ) -> Offer {
        let bars = Some(In { meaning, numbers });
        Offer { bars, ..self }
    }

    /// Offered in structures.
    pub(in crate::contact) const fn in_structures(
        self,
        meaning: &'static str,
        numbers: &'static [&'static Number],
    ) -> Offer {
        let structure = Some(In { meaning, numbers });
        Offer { structure, ..self }
    }
}

/// A law in a problem.
#[derive(Debug, Clone, Copy)]
pub struct In {
    /// One sentence for schema, pages and messages.
    pub meaning: &'static str,
    /// Its numbers.
    pub numbers: &'static [&'static Number],
}

/// A law of bars or structures, with what its numbers tell besides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Form {
    /// The law; of friction its limit follows that of the contact.
    pub given: GivenLaw,
    /// The target of the coefficient of restitution of an impact; 1 without damping, e of a rigid stop.
    pub restitution: f64,
    /// Of friction without compliance: the static limit over the kinetic one, >= 1.
    pub static_ratio: f64,
}

impl Form {
    /// The form of a law.
    pub fn of(law: impl Into<ContactLaw>) -> Form {
        Form::new(GivenLaw::Law(law.into()))
    }

    fn new(given: GivenLaw) -> Form {
        let restitution = match given.line() {
            Some(ClippedLine::Stop { restitution }) => restitution,
            _ => 1.0,
        };
        Form {
            given,
            restitution,
            static_ratio: 1.0,
        }
    }

    /// With a target of the coefficient of restitution.
    pub fn with_restitution(self, restitution: f64) -> Form {
        Form {
            restitution,
            ..self
        }
    }
}

impl From<ContactLaw> for Form {
    fn from(law: ContactLaw) -> Form {
        Form::of(law)
    }
}

impl From<ClippedLine> for Form {
    fn from(line: ClippedLine) -> Form {
        Form::new(GivenLaw::Line(line))
    }
}

/// An offer with what all names of a law share.
#[derive(Debug, Clone, Copy)]
pub struct Offered {
    /// The law.
    pub law: WhichLaw,
    /// What its contact can do.
    pub kind: ContactKind,
    /// Whether S follows from rdot alone.
    pub of_velocity: bool,
    /// Whether it slides in a plane.
    pub in_plane: bool,
    /// The offer.
    pub offer: &'static Offer,
}

/// The problems that offer laws.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// The friction oscillator.
    Oscillator,
    /// Two bars.
    Bars,
    /// Structures.
    Structure,
}

impl Offered {
    /// The law of this name in a problem.
    #[inline]
    pub fn named(place: Place, name: &str) -> Option<&'static Offered> {
        // Names of the tables: mostly the same memory.
        let is = |law: &&Offered| std::ptr::eq(law.offer.name, name) || law.offer.name == name;
        let mut offered = LAWS.iter().filter(|law| law.at(place).is_some());
        offered.find(is)
    }

    /// The law in a problem; `None` if it is not offered there.
    pub const fn at(&self, place: Place) -> Option<In> {
        match place {
            Place::Oscillator => self.offer.oscillator,
            Place::Bars => self.offer.bars,
            Place::Structure => self.offer.structure,
        }
    }

    /// Its numbers in structures, those of the limit of friction included.
    pub fn structure_numbers(&self) -> impl Iterator<Item = &'static Number> {
        let numbers = self.offer.structure.map_or(&[][..], |offer| offer.numbers);
        let limit = match self.kind {
            ContactKind::Friction => &structure::OF_LIMIT[..],
            ContactKind::Impact | ContactKind::Link => &[],
        };
        numbers.iter().chain(limit).copied()
    }

    /// Whether it has this number in structures.
    pub fn has(&self, key: &str) -> bool {
        self.structure_numbers().any(|number| number.key == key)
    }
}
