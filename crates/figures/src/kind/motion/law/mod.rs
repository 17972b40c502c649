//! The laws of the cases: force over displacement or velocity.

mod loops;
mod papers;

use crate::FigureData;
use crate::kind::Draw;
use slipgap_contact::contact::{ClippedLine, ContactLaw};
use slipgap_drawing::layout::sheet::Sheet;
use slipgap_study::kinds::Law;

impl Draw for Law {
    fn sheet(&self, data: &FigureData) -> Sheet {
        let FigureData { study, cases, .. } = *data;
        let laws: Vec<Option<ContactLaw>> = cases
            .iter()
            .map(|shown| {
                study
                    .problem
                    .as_textbook()
                    .and_then(|textbook| textbook.contact_law(&shown.case()))
            })
            .collect();
        let softened = |law: &Option<ContactLaw>| match law {
            Some(law) => matches!(
                law.line(),
                Some(ClippedLine::Elastic { .. } | ClippedLine::Viscous { .. })
            ),
            None => true,
        };
        match laws.iter().all(softened) {
            true => papers::sheet(data),
            false => loops::sheet(data, &laws),
        }
    }
}
