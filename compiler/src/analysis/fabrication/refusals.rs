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
        let named: Vec<(&Label, String)> = refused
            .iter()
            .filter(|refusal| !matches!(refusal.reason, PanelRefusal::TooLarge { .. }))
            .map(|refusal| (&refusal.label, refusal.reason.to_string()))
            .collect();
        let hint = "move the control points so that the quads there are convex";
        self.refused_elements(&named, self.block.figure_span, hint);
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
            (figure, "move the control points apart, or use a lower level", no_length),
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

fn no_length(reason: &PlankRefusal) -> bool {
    matches!(reason, PlankRefusal::NoLength)
}
