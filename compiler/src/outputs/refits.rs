//! What in a block's `machine` and `fixing` would let boards that were refused be cut, as changes of the text: longer
//! flutes, fewer tabs, a thinner skin. Only calls that are written in the block are changed.

use crate::analysis::{Analysis, Fabrication};
use crate::diagnostic::Fix;
use crate::fabricate::toolpath::Refusal;
use crate::source::Span;
use crate::syntax::ast::{Argument, EntryKind, Expr, ExprKind, ItemKind};

/// The machines of the library whose cutter's flutes can be given.
const WITH_FLUTES: [&str; 3] = ["router3", "panel_router", "desktop_router"];

/// The change after which none of the boards is refused for what the first of them was refused for, lengths in whole
/// millimetres.
pub(super) fn refit(analysis: &Analysis, made: &Fabrication, refusals: &[&Refusal]) -> Option<Fix> {
    match refusals.first()? {
        Refusal::FluteTooShort { length, .. } => {
            let needed = refusals.iter().filter_map(|refusal| match refusal {
                Refusal::FluteTooShort { needed, .. } => Some(needed.ceil()),
                _ => None,
            });
            let needed = needed.fold(0.0, f64::max);
            let call = call(analysis, made, "machine", &WITH_FLUTES)?;
            let title = format!("take a cutter with flutes of {needed}mm instead of {length}mm");
            Some(call.with(Fix::titled(title), "flute", None, &format!("{needed}mm")))
        }
        Refusal::TabsDoNotFit { asked, .. } => {
            let fitting = refusals.iter().filter_map(|refusal| match refusal {
                Refusal::TabsDoNotFit { fitting, .. } => Some(*fitting),
                _ => None,
            });
            let fitting = fitting.min().filter(|fitting| *fitting > 0)?;
            let call = call(analysis, made, "fixing", &["tabs"])?;
            let title = format!("hold each board by {fitting} tabs instead of {asked}");
            Some(call.with(Fix::titled(title), "count", Some(0), &fitting.to_string()))
        }
        Refusal::SkinTooThick { skin, thickness } => {
            let call = call(analysis, made, "fixing", &["onion_skin"])?;
            let most = thickness / 2.0;
            let title = format!("leave a skin of {most}mm instead of {skin}mm");
            Some(call.with(Fix::titled(title), "thickness", Some(0), &format!("{most}mm")))
        }
        _ => None,
    }
}

/// A call as it is written.
struct Call<'a> {
    /// All of it, up to its closing bracket.
    span: Span,
    arguments: &'a [Argument],
}

impl Call<'_> {
    /// A fix that also gives an argument this value: in the place of the one it has, by name or by place, else behind the
    /// others.
    fn with(&self, fix: Fix, name: &str, place: Option<usize>, value: &str) -> Fix {
        let named =
            self.arguments.iter().find(|given| given.name.as_ref().is_some_and(|own| own.text == name));
        let placed = place.and_then(|place| self.arguments.get(place)).filter(|given| given.name.is_none());
        if let Some(given) = named.or(placed) {
            return fix.with(given.value.span, value);
        }
        match self.arguments.last() {
            Some(last) => fix.with(last.value.span.after(), format!(", {name}: {value}")),
            None => {
                let close = Span::new(self.span.file, self.span.end.saturating_sub(1), self.span.end);
                fix.with(close, format!("{name}: {value})"))
            }
        }
    }
}

/// The call of one of these functions that is the value of a setting of the block.
fn call<'a>(
    analysis: &'a Analysis,
    made: &Fabrication,
    setting: &str,
    functions: &[&str],
) -> Option<Call<'a>> {
    let (.., at) = made.settings.iter().find(|(name, ..)| *name == setting)?;
    let file = analysis.files.iter().find(|file| file.file == at.file)?;
    let blocks = file.parse.ast.items.iter().filter_map(|item| match &item.kind {
        ItemKind::Fabricate(block) => Some(block),
        _ => None,
    });
    let value: &Expr = blocks.flat_map(|block| &block.entries).find_map(|entry| match &entry.kind {
        EntryKind::Setting(name, value) if name.text == setting && value.span == *at => Some(value),
        _ => None,
    })?;
    let ExprKind::Call { callee, arguments } = &value.kind else { return None };
    let ExprKind::Name(name) = &callee.kind else { return None };
    functions.contains(&name.as_str()).then_some(Call { span: value.span, arguments })
}
