//! How the page names kinds of links and alignments.

use slipgap_drawing::layout::sheet::Anchor;
use slipgap_problem::problem::structure::described::scheme::picture::LinkKind;

/// How words are aligned.
pub fn align(anchor: Anchor) -> &'static str {
    match anchor {
        Anchor::Start => "left",
        Anchor::Middle => "center",
        Anchor::End => "right",
    }
}

/// The kind of a link in the page.
pub fn kind(kind: LinkKind) -> &'static str {
    match kind {
        LinkKind::Impact => "impact",
        LinkKind::Friction => "friction",
        LinkKind::Spring { elastic: false, .. } => "damper",
        LinkKind::Spring { viscous: false, .. } => "spring",
        LinkKind::Spring { .. } => "both",
    }
}
