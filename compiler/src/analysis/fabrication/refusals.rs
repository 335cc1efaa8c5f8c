//! Elements no board or plank can be made of, said at the setting that is in the way. Those that are only too large for the
//! raw boards or bars are told with their remedies, as requirements that fail are.

use super::Work;
use crate::diagnostic::{Code, Diagnostic};
use crate::fabricate::label::Label;
use crate::fabricate::panel::{PanelRefusal, RefusedPanel};
use crate::fabricate::plank::{PlankRefusal, RefusedPlank};
use crate::source::Span;

impl Work<'_> {
    pub(super) fn refused_panels(&mut self, refused: &[RefusedPanel]) {
        let large = |refusal: &&RefusedPanel| matches!(refusal.reason, PanelRefusal::TooLarge { .. });
        let eaten = |refusal: &&RefusedPanel| {
            matches!(refusal.reason, PanelRefusal::SideVanishes { .. } | PanelRefusal::NoCorner { .. })
        };
        let eaten_up: Vec<&RefusedPanel> = refused.iter().filter(eaten).collect();
        let others: Vec<&RefusedPanel> =
            refused.iter().filter(|refusal| !large(refusal) && !eaten(refusal)).collect();
        let edges = self.setting("edges").map_or(self.block.figure_span, |(_, _, span)| *span);
        for (group, span, hint) in [
            (eaten_up, edges, "use a thinner material, a lower level (larger boards), or `edges: square`"),
            (others, self.block.figure_span, "move the control points so that the quads there are convex"),
        ] {
            let named: Vec<(&Label, String)> =
                group.iter().map(|refusal| (&refusal.label, refusal.reason.to_string())).collect();
            self.refused_elements(&named, span, hint);
        }
    }

    pub(super) fn refused_planks(&mut self, refused: &[RefusedPlank]) {
        let place = |name: &str| self.setting(name).map_or(self.block.figure_span, |(_, _, span)| *span);
        let (section, figure) = (place("section"), self.block.figure_span);
        for (span, hint, is_meant) in [
            (
                section,
                "use a smaller depth, or a lower level: the planks get longer",
                cuts_cross as fn(&PlankRefusal) -> bool,
            ),
            (
                place("ends"),
                "let the curve turn less at the joint, or write `ends: square`; a plane is to cross the plank",
                too_steep,
            ),
            (
                place("gap"),
                "use a smaller gap, or a lower level; a plane is to cross the first or the last plank",
                nothing_left,
            ),
            (figure, "move the control points apart, or use a lower level", too_short),
        ] {
            let group = refused.iter().filter(|refusal| is_meant(&refusal.reason));
            let named: Vec<(&Label, String)> =
                group.map(|refusal| (&refusal.label, refusal.reason.to_string())).collect();
            self.refused_elements(&named, span, hint);
        }
    }

    fn refused_elements(&mut self, refused: &[(&Label, String)], span: Span, hint: &str) {
        let Some((label, reason)) = refused.first() else { return };
        let message = format!("{} ({}) cannot be made: {reason}", label.alias, label.address);
        let mut diagnostic = Diagnostic::new(Code::E0805, span, message).label("asked for here");
        if refused.len() > 1 {
            let others: Vec<&str> =
                refused[1..].iter().take(5).map(|(label, _)| label.alias.as_str()).collect();
            let more = if refused.len() > 6 { ", …" } else { "" };
            diagnostic =
                diagnostic.note(format!("and {} more: {}{more}", refused.len() - 1, others.join(", ")));
        }
        self.diagnostics.push(diagnostic.hint(hint));
    }
}

fn cuts_cross(reason: &PlankRefusal) -> bool {
    matches!(reason, PlankRefusal::CutsCross { .. })
}

fn too_steep(reason: &PlankRefusal) -> bool {
    matches!(reason, PlankRefusal::TooSteep { .. })
}

fn nothing_left(reason: &PlankRefusal) -> bool {
    matches!(reason, PlankRefusal::NothingLeft { .. })
}

fn too_short(reason: &PlankRefusal) -> bool {
    matches!(reason, PlankRefusal::TooShort { .. })
}
