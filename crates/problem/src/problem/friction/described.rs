//! The oscillator as a structure that a study describes, for programs of others.

use super::tables::{InitialSlip, rows};
use crate::problem::structure::parts::contact_law::written_numbers;
use crate::problem::{Case, Described};
use serde_json::json;

/// The structure of a completed case, with x, its velocity and the friction as channels.
///
/// # Errors
/// What a structure does not have.
pub fn described(case: &Case) -> Result<Described, String> {
    let slip = case.name_at(rows::INITIAL_SLIP);
    if let Some(InitialSlip::Pulled | InitialSlip::Sliding) = InitialSlip::parse(slip) {
        return Err(format!(
            "initial_slip {slip}: a structure starts without friction; allowed: unloaded"
        ));
    }
    let law = case.name_at(rows::LAW);
    let number = |key: &str| match key {
        "k" => case.at(rows::ALPHA).map(|alpha| 1.0 / alpha),
        "c" => case.at(rows::BETA).map(|beta| 1.0 / beta),
        _ => case.number(key),
    };
    let mut contact = written_numbers(law, number);
    let more = json!({ "between": ["ground", "x"], "law": law, "nu": 1, "N": 1 });
    contact.extend(more.as_object().cloned().unwrap_or_default());
    if let Some(ratio) = case.at(rows::NU_RATIO).filter(|ratio| *ratio < 1.0) {
        contact.insert("nu_min".into(), ratio.into());
        contact.insert("nu_rate".into(), case.number("nu_rate").into());
    }
    Ok(Described {
        structure: json!({
            "masses": { "x": 1 },
            "springs": [{ "between": ["ground", "x"], "k": 1 }],
            "contacts": { "friction": contact },
            "start": { "x": { "u": case.at(rows::X0) } },
        }),
        channels: ["x", "x.v", "friction.S"].map(str::to_owned).to_vec(),
    })
}
