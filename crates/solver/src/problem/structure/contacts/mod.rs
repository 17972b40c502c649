//! The law of a contact in a case.

mod friction;
mod impact;
mod limit;

use super::amount::Amount;
use super::template::Contact;
use crate::problem::choice::choice;
use crate::problem::{Case, Violation};
use crate::system::structure::Relation;

choice! {
    /// Law of a contact of a structure.
    pub enum LawName {
        Impact = "impact":
            "closes when r reaches 0; a spring k [I (7)], or rigid with restitution e",
        ImpactSpring = "impact-spring": "impact with the spring k [I (7)]",
        KelvinVoigt = "kelvin-voigt":
            "impact with the spring k and a dashpot that do not pull (Anagnostopoulos 1988)",
        Hertz = "hertz": "impact with the force k_h delta^1.5, delta = -r (Goldsmith 1960)",
        HertzDamp = "hertz-damp":
            "hertz with damping (Lankarani and Nikravesh 1990; Muthukumar and DesRoches 2006)",
        HuntCrossley = "hunt-crossley": "hertz with damping (Hunt and Crossley 1975)",
        Ye = "ye": "hertz with damping (Ye, Li and Zhu 2009)",
        Jankowski = "jankowski": "hertz with a dashpot while approaching (Jankowski 2005, 2006)",
        Rigid = "rigid": "impact without compliance, with restitution e (Moreau 1988, Jean 1999)",
        DisplacementControl = "displacement-control":
            "friction, elastic up to the displacement r^E, then sliding at the limit [F (9)]",
        VelocityControl = "velocity-control":
            "friction, viscous up to the velocity rdot^E, then at the limit [F (16)]",
        Coulomb = "coulomb": "friction without compliance: sticks below the limit, slides at it",
        Tanh = "tanh": "friction, limit times tanh(rdot/rdot^E)",
        Stribeck = "stribeck":
            "friction, viscous up to the static limit, which falls to the kinetic one with rdot (Stribeck 1902)",
        BoucWen = "bouc-wen":
            "friction, hysteretic; tends to displacement-control as the exponent rises (Wen 1976)",
        Dahl = "dahl":
            "friction, hysteretic, its stiffness falls towards the limit (Dahl 1968)",
        Lugre = "lugre":
            "friction, bristles with stiffness sigma0, damping sigma1 and viscosity sigma2 (Canudas de Wit et al. 1995)",
    }
}

impl LawName {
    /// Whether it is friction.
    pub fn is_friction(self) -> bool {
        use LawName::*;
        matches!(
            self,
            DisplacementControl
                | VelocityControl
                | Coulomb
                | Tanh
                | Stribeck
                | BoucWen
                | Dahl
                | Lugre
        )
    }
}

/// Keys of a contact with each law, besides law, between and gap.
pub const KEYS: [(&str, &[&str]); 17] = [
    ("impact", &["k", "e"]),
    ("impact-spring", &["k"]),
    ("kelvin-voigt", &["k", "restitution", "colliding_mass"]),
    ("hertz", &["k_h"]),
    ("hertz-damp", &["k_h", "restitution"]),
    ("hunt-crossley", &["k_h", "restitution"]),
    ("ye", &["k_h", "restitution"]),
    ("jankowski", &["k_h", "restitution", "colliding_mass"]),
    ("rigid", &["e"]),
    (
        "displacement-control",
        &["k", "rE", "limit", "nu", "N", "pressure_exponent"],
    ),
    (
        "velocity-control",
        &[
            "c",
            "rdotE",
            "nu_min",
            "nu_rate",
            "limit",
            "nu",
            "N",
            "pressure_exponent",
        ],
    ),
    ("coulomb", &["limit", "nu", "N", "pressure_exponent"]),
    (
        "tanh",
        &[
            "c",
            "rdotE",
            "nu_min",
            "nu_rate",
            "limit",
            "nu",
            "N",
            "pressure_exponent",
        ],
    ),
    (
        "stribeck",
        &[
            "c",
            "rdotE",
            "static_ratio",
            "stribeck_velocity",
            "limit",
            "nu",
            "N",
            "pressure_exponent",
        ],
    ),
    (
        "bouc-wen",
        &[
            "k",
            "rE",
            "exponent",
            "limit",
            "nu",
            "N",
            "pressure_exponent",
        ],
    ),
    (
        "dahl",
        &[
            "k",
            "rE",
            "exponent",
            "limit",
            "nu",
            "N",
            "pressure_exponent",
        ],
    ),
    (
        "lugre",
        &[
            "sigma0",
            "sigma1",
            "sigma2",
            "static_ratio",
            "stribeck_velocity",
            "limit",
            "nu",
            "N",
            "pressure_exponent",
        ],
    ),
];

/// The law of a contact in a case.
///
/// Without samples, sampled functions of time are only checked, and the limit is the one at rest.
///
/// # Errors
/// A number that the law needs is missing or out of its range.
pub fn relation(
    contact: &Contact,
    case: &Case,
    metre: f64,
    with_samples: bool,
) -> Result<Relation, Violation> {
    let name = contact.law.name(case);
    let Some(law) = LawName::parse(name) else {
        return Err(violation(contact, format!("no law \"{name}\"")));
    };
    let numbers = Numbers {
        contact,
        case,
        with_samples,
    };
    match law.is_friction() {
        true => friction::relation(law, numbers, metre),
        false => impact::relation(law, numbers),
    }
}

/// The restitution of a rigid impact in a case, with its place in the study; `None` for another law.
pub fn restitution<'a>(contact: &'a Contact, case: &Case) -> Option<(&'a Amount, f64)> {
    let given = contact.e.as_ref()?;
    let rigid = match LawName::parse(contact.law.name(case))? {
        LawName::Rigid => true,
        LawName::Impact => contact.k.is_none(),
        _ => false,
    };
    Some((given, given.value(case).ok()?)).filter(|_| rigid)
}

/// The numbers of a contact in a case.
#[derive(Clone, Copy)]
struct Numbers<'a> {
    contact: &'a Contact,
    case: &'a Case,
    with_samples: bool,
}

impl Numbers<'_> {
    /// A number, if the contact has it.
    fn given(self, amount: &Option<Amount>) -> Result<Option<f64>, Violation> {
        amount
            .as_ref()
            .map(|amount| amount.value(self.case))
            .transpose()
    }

    /// A number of the list of others, if the contact has it.
    fn other(self, key: &str) -> Result<Option<f64>, Violation> {
        let others = &self.contact.others;
        let amount = others.iter().find(|other| other.0 == key);
        amount
            .map(|(_, amount)| amount.value(self.case))
            .transpose()
    }

    /// A number of the list of others that the law needs.
    fn needed(self, key: &str) -> Result<f64, Violation> {
        let name = self.contact.law.name(self.case);
        let missing = || violation(self.contact, format!("{name} needs {key}"));
        self.other(key)?.ok_or_else(missing)
    }
}

/// A rule that a contact breaks.
pub fn violation(contact: &Contact, message: impl Into<String>) -> Violation {
    Violation {
        parameter: contact.place.1.clone().into(),
        message: message.into(),
        at: Some(contact.place.0),
    }
}
