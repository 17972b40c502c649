//! The contact laws of bars and their parameters.

use super::tables::LAW;
use crate::contact::{
    ContactLaw, Hertz, HertzDamp, HuntCrossley, ImpactSpring, Jankowski, KelvinVoigt, Rigid, Ye,
};
use crate::methods::{MethodChoice, MethodKind};
use crate::problem::Case;
use crate::problem::choice::choice;
use crate::problem::parameter::{Default, Kind, Parameter, Range, Value, row_of};
use std::borrow::Cow::Borrowed;

choice! {
    /// Contact law of the bars.
    pub enum LawName {
        ImpactSpring = "impact-spring": "linear spring [I (7)]",
        KelvinVoigt = "kelvin-voigt":
            "linear spring and dashpot that do not pull (Anagnostopoulos 1988)",
        Hertz = "hertz": "spring with the force k_h delta^1.5 (Goldsmith 1960)",
        HertzDamp = "hertz-damp":
            "hertz with damping (Lankarani and Nikravesh 1990; Muthukumar and DesRoches 2006)",
        HuntCrossley = "hunt-crossley": "hertz with damping (Hunt and Crossley 1975)",
        Ye = "ye": "hertz with damping (Ye, Li and Zhu 2009)",
        Jankowski = "jankowski": "hertz with a dashpot while approaching (Jankowski 2005, 2006)",
        Rigid = "rigid":
            "without compliance: r >= 0 at the end of a step; with moreau-jean instead restitution of the ends, and an overlap may remain (Moreau 1988, Jean 1999)",
    }
}

impl LawName {
    /// The law of a case; `None` if it is not given.
    pub fn of(case: &Case) -> Option<LawName> {
        LawName::parse(case.name_at(LAW))
    }

    /// Whether the force rises as delta^1.5, so that `k_h` is a parameter.
    pub fn curved(self) -> bool {
        !matches!(
            self,
            LawName::ImpactSpring | LawName::KelvinVoigt | LawName::Rigid
        )
    }
}

/// Fills in the restitution of a law that has one.
pub(super) fn fill_restitution(case: &mut Case) {
    let row = LAW + rows::RESTITUTION;
    let default = match LawName::of(case) {
        None | Some(LawName::ImpactSpring | LawName::Hertz) => return,
        Some(LawName::Rigid) => 0.0,
        Some(_) => 1.0,
    };
    case.values[row] = case.values[row].or(Some(Value::Number(default)));
}

/// Parameters of the laws, after those of the bars in the table; the stiffness of the linear spring is among the latter.
pub(super) static PARAMETERS: [Parameter; 3] = [
    Parameter::new(
        ["law", "law", "1"],
        LawName::KIND,
        Default::Is(Value::Name("impact-spring")),
        "contact law",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["k_h", "*k*_h_", "force/length^1.5"],
        Kind::Number(Range::Positive),
        Default::Follows(Borrowed(
            "k_I^1.5/F0^0.5: the force F0 at the same overlap F0/k_I; exactly one of gamma, k_I, k_h is given",
        )),
        (
            "law",
            &["hertz", "hertz-damp", "hunt-crossley", "ye", "jankowski"],
        ),
        "stiffness of the laws with delta^1.5",
    )
    .with_column_if_given(),
    Parameter::only_for(
        ["restitution", "*e*", "1"],
        Kind::Number(Range::UpToOne),
        Default::Follows(Borrowed("1, or 0 for rigid")),
        (
            "law",
            &[
                "kelvin-voigt",
                "hertz-damp",
                "hunt-crossley",
                "ye",
                "jankowski",
                "rigid",
            ],
        ),
        "target of the coefficient of restitution of two rigid bodies, > 0; of rigid with moreau-jean that of the ends of the bars",
    )
    .with_heading("target_restitution")
    .with_column_if_given(),
];

/// Rows of the parameters in their table.
pub(super) mod rows {
    use super::{PARAMETERS, row_of};

    pub const K_H: usize = row_of(&PARAMETERS, "k_h");
    pub const RESTITUTION: usize = row_of(&PARAMETERS, "restitution");
}

/// The law of a case in its scales; `None` where a parameter is not given. A linear spring has this stiffness; `mass` is m1 m2/(m1 +
/// m2) of the whole bars.
///
/// The secant stiffness of a law with delta^1.5 is that of the linear spring at the overlap under the exact force F0, which is 1
/// here, so that k_h = k_I^1.5.
pub fn law(case: &Case, method: MethodChoice, stiffness: f64, mass: f64) -> Option<ContactLaw> {
    let e = || case.at(LAW + rows::RESTITUTION);
    let curved = stiffness * stiffness.sqrt();
    Some(match LawName::of(case)? {
        LawName::ImpactSpring => ContactLaw::ImpactSpring(ImpactSpring { stiffness }),
        LawName::KelvinVoigt => ContactLaw::KelvinVoigt(KelvinVoigt::new(stiffness, e()?, mass)),
        LawName::Hertz => ContactLaw::Hertz(Hertz { stiffness: curved }),
        LawName::HertzDamp => ContactLaw::HertzDamp(HertzDamp::new(curved, e()?)),
        LawName::HuntCrossley => ContactLaw::HuntCrossley(HuntCrossley::new(curved, e()?)),
        LawName::Ye => ContactLaw::Ye(Ye::new(curved, e()?)),
        LawName::Jankowski => ContactLaw::Jankowski(Jankowski::new(curved, e()?, mass)),
        LawName::Rigid => ContactLaw::Rigid(Rigid {
            restitution: e()?,
            impulses: method.kind() == MethodKind::MoreauJean,
        }),
    })
}
