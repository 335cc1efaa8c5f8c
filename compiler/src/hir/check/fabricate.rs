//! Fabricate blocks: the figure, settings by the program's table, requirements by its list of measures.

use super::scope::Symbol;
use super::units::placeholder;
use super::{Checker, Frame};
use crate::diagnostic::{Code, Diagnostic, Fix, closest};
use crate::hir::dimension::Dimension;
use crate::hir::index::Target;
use crate::hir::schema::{Measure, SchemaKind, Setting, SettingType};
use crate::hir::tree::{Expr, ExprKind, Fabricate, ItemId, ItemKind, Limit, Requirement, SettingValue};
use crate::hir::types::Type;
use crate::source::Span;
use crate::syntax::ast;

impl Checker<'_> {
    pub(super) fn fabricate(&mut self, block: &ast::Fabricate) {
        let figure = self.fabricated_figure(block);
        let kind = match block.kind.text.as_str() {
            "panels" => SchemaKind::Panels,
            "planks" => SchemaKind::Planks,
            _ => {
                let message = format!("no boards are made as `{}`", block.kind.text);
                self.unknown_word(Code::E0411, &block.kind, message, ["panels", "planks"].into_iter());
                return;
            }
        };
        let mut frame = Frame::new(0);
        let mut settings: Vec<SettingValue> = Vec::new();
        for entry in &block.entries {
            if let ast::EntryKind::Setting(name, value) = &entry.kind
                && let Some(setting) = self.setting(&mut frame, kind, name, value, &settings)
            {
                settings.push(setting);
            }
        }
        let broken = block.entries.iter().any(|entry| entry.kind == ast::EntryKind::Error);
        if !broken {
            self.required_settings(block, kind);
        }
        let material = settings.iter().find(|setting| setting.name == "material");
        let material = material.map_or(Type::Error, |setting| setting.value.ty.clone());
        let name = ast::Name { text: "material".to_owned(), span: block.kind.span };
        let mut frame = Frame::new(0);
        frame.declare(&name, material);
        let mut requirements = Vec::new();
        for entry in &block.entries {
            if let ast::EntryKind::Require(requirement) = &entry.kind
                && let Some(requirement) = self.requirement(&mut frame, kind, requirement, entry.span)
            {
                requirements.push(requirement);
            }
        }
        let Some(figure) = figure else { return };
        self.fabricates.push(Fabricate {
            figure,
            figure_span: block.figure.span,
            kind,
            kind_span: block.kind.span,
            settings,
            requirements,
            slots: frame.slots,
        });
    }

    fn fabricated_figure(&mut self, block: &ast::Fabricate) -> Option<ItemId> {
        let name = &block.figure;
        let id = match self.symbol(0, &name.text, name.span) {
            Some(Symbol::Item(id)) => id,
            Some(Symbol::Lost) => return None,
            _ => {
                self.unknown(&Frame::new(0), &name.text, name.span, "figure");
                return None;
            }
        };
        if !matches!(self.declared[id.0 as usize].item.kind, ast::ItemKind::Figure(_)) {
            let message = format!("`{}` is not a figure", name.text);
            let diagnostic =
                Diagnostic::new(Code::E0401, name.span, message).label("only a figure can be fabricated");
            let declared = self.items[id.0 as usize].name_span;
            self.report(diagnostic.also(declared, "declared here").hint("declare it with `figure … = …`"));
            return None;
        }
        if let Some(earlier) = self.fabricates.iter().find(|other| other.figure == id) {
            let message = format!("`{}` is fabricated twice", name.text);
            let diagnostic = Diagnostic::new(Code::E0803, name.span, message).label("fabricated again here");
            let diagnostic = diagnostic.also(earlier.figure_span, "first fabricated here");
            self.report(diagnostic.hint("one `fabricate` a figure: remove one, or declare a second figure"));
            return None;
        }
        match self.items[id.0 as usize].kind {
            ItemKind::Broken => None,
            _ => Some(id),
        }
    }

    fn required_settings(&mut self, block: &ast::Fabricate, kind: SchemaKind) {
        let given = |name: &str| {
            block.entries.iter().any(
                |entry| matches!(&entry.kind, ast::EntryKind::Setting(setting, _) if setting.text == name),
            )
        };
        let settings = kind.settings();
        // A misspelt setting is reported as such, not as missing too.
        let meant = |name: &str| {
            let known = settings.iter().map(|setting| setting.name);
            block.entries.iter().any(|entry| match &entry.kind {
                ast::EntryKind::Setting(setting, _) => closest(&setting.text, known.clone()) == Some(name),
                _ => false,
            })
        };
        let absent = |name: &str| !given(name) && !meant(name);
        let missing: Vec<_> =
            settings.iter().filter(|setting| setting.required && absent(setting.name)).collect();
        if missing.is_empty() {
            return;
        }
        let names: Vec<String> = missing.iter().map(|setting| format!("`{}`", setting.name)).collect();
        let message = format!("{} need {}", kind.name(), names.join(" and "));
        let mut diagnostic = Diagnostic::new(Code::E0403, block.kind.span, message)
            .label(format!("no {}", names.join(", no ")));
        let fix = self.settings_to_add(block, kind, &names, &missing);
        for (place, setting) in missing.iter().enumerate() {
            let hint = format!("add `{}: …`: {}", setting.name, setting.doc);
            let fix = fix.clone().filter(|_| place == 0);
            diagnostic = diagnostic.ways(hint, fix.into_iter().collect());
        }
        self.report(diagnostic);
    }

    /// Values to begin with for settings that must be given, before the first line of the block; with what must be
    /// imported for them.
    fn settings_to_add(
        &self,
        block: &ast::Fabricate,
        kind: SchemaKind,
        names: &[String],
        missing: &[&Setting],
    ) -> Option<Fix> {
        let first = block.entries.first()?.span;
        let (material, call) = match kind {
            SchemaKind::Panels => ("birch_plywood", "birch_plywood(12mm)"),
            _ => ("sawn_spruce", "sawn_spruce"),
        };
        let mut lines = String::new();
        let mut import = None;
        for setting in missing {
            let value = match setting.name {
                "material" => {
                    let known = self.modules[0].imports.contains_key(material);
                    import = (!known).then(|| self.to_import(0, "std.materials", material));
                    call.to_owned()
                }
                "section" => "120mm by 40mm".to_owned(),
                _ => match &setting.ty {
                    SettingType::Of(ty) => placeholder(ty)?,
                    SettingType::Library(_) => return None,
                },
            };
            lines += &format!("{}: {value}\n    ", setting.name);
        }
        let mut fix = Fix::titled(format!("add {} to begin with", names.join(" and ")));
        if let Some((at, text)) = import {
            fix = fix.with(at, text);
        }
        Some(fix.with(Span::new(first.file, first.start, first.start), lines))
    }

    /// One setting of a block; `None` after a report.
    pub(super) fn setting(
        &mut self,
        frame: &mut Frame,
        kind: SchemaKind,
        name: &ast::Name,
        value: &ast::Expr,
        earlier: &[SettingValue],
    ) -> Option<SettingValue> {
        let Some(setting) = kind.setting(&name.text) else {
            let known: Vec<&str> = kind.settings().iter().map(|setting| setting.name).collect();
            let message = format!("{} have no setting `{}`", kind.name(), name.text);
            self.unknown_word(Code::E0404, name, message, known.into_iter());
            return None;
        };
        if let Some(first) = earlier.iter().find(|other| other.name == setting.name) {
            let message = format!("`{}` is given twice", name.text);
            let diagnostic = Diagnostic::new(Code::E0405, name.span, message).label("given again");
            self.report(diagnostic.also(first.name_span, "first given here").hint("remove one of them"));
            return None;
        }
        self.refer(name.span, Target::Setting(kind, setting.name));
        let value = match &setting.ty {
            SettingType::Of(ty) => self.expect(frame, value, ty),
            SettingType::Library(record) => self.library_record(frame, record, value),
        };
        Some(SettingValue { name: setting.name, name_span: name.span, value })
    }

    fn library_record(&mut self, frame: &mut Frame, record: &str, value: &ast::Expr) -> Expr {
        let found = self.modules.iter().find_map(|scope| match scope.public.get(record) {
            Some(Symbol::Item(id)) if !scope.name.is_empty() => Some(*id),
            _ => None,
        });
        match found {
            Some(id) => self.expect(frame, value, &Type::Record(id)),
            None => self.expr(frame, value, None),
        }
    }

    fn requirement(
        &mut self,
        frame: &mut Frame,
        kind: SchemaKind,
        requirement: &ast::Requirement,
        span: Span,
    ) -> Option<Requirement> {
        let words = &requirement.measure;
        // What is no measure at all, the parser has said.
        let measure = Measure::named(&words.text)?;
        if !measure.applies_to(kind) {
            let message = format!("`{}` is no measure of {}", words.text, kind.name());
            let label = format!("not measured on {}", kind.name());
            let measures = Measure::ALL.iter().filter(|measure| measure.applies_to(kind));
            let measures: Vec<String> = measures.map(|measure| format!("`{}`", measure.words())).collect();
            let note = format!("{} have {}", kind.name(), measures.join(", "));
            self.report(Diagnostic::new(Code::E0806, words.span, message).label(label).note(note));
            return None;
        }
        self.refer(words.span, Target::Measure(measure));
        let limit = match &requirement.limit {
            ast::Limit::Compare(ast::Comparison::NotEqual, value) => {
                let message = format!("`{}` can be limited, but not kept from one value", words.text);
                let diagnostic = Diagnostic::new(Code::E0806, words.span.to(value.span), message);
                self.report(diagnostic.label("`!=` is no limit").hint("use `<=`, `>=`, or `in … .. …`"));
                return None;
            }
            ast::Limit::Compare(comparison, value) => {
                let least = matches!(comparison, ast::Comparison::AtLeast | ast::Comparison::Greater);
                Limit::Compare(*comparison, self.limit_value(frame, measure, value, least))
            }
            ast::Limit::Within(range) => {
                let [from, to] =
                    [&range.from, &range.to].map(|value| self.limit_value(frame, measure, value, false));
                Limit::Within(from, to)
            }
        };
        Some(Requirement { measure, span, measure_span: words.span, limit })
    }

    /// A number of the measure's dimension; for the least of bend radii also the two of a board.
    fn limit_value(&mut self, frame: &mut Frame, measure: Measure, value: &ast::Expr, least: bool) -> Expr {
        let expected = Type::Quantity(measure.dimension());
        let checked = self.expr(frame, value, Some(&expected));
        let radius = least && measure == Measure::BendRadius && self.is_radius(&checked.ty);
        if radius {
            return checked;
        }
        match checked.ty.dimension() {
            Some(found) if found != measure.dimension() => self.wrong_limit(measure, &checked),
            _ => self.convert(checked, &expected),
        }
    }

    /// A limit of another dimension, with an example of a right one.
    fn wrong_limit(&mut self, measure: Measure, value: &Expr) -> Expr {
        let needed = self.described(&Type::Quantity(measure.dimension()));
        let found = match &value.ty {
            Type::Int => self.described(&Type::Quantity(Dimension::NUMBER)),
            other => self.described(other),
        };
        let message = format!("`{}` is limited by {needed}, but this is {found}", measure.words());
        let diagnostic = Diagnostic::new(Code::E0401, value.span, message).label(found);
        self.report(diagnostic.hint(format!(
            "for example `require {} {}`",
            measure.words(),
            measure.example()
        )));
        Expr { kind: ExprKind::Error, ty: Type::Error, span: value.span }
    }

    /// Whether a record has the two radii of a board: across and along its grain.
    fn is_radius(&mut self, ty: &Type) -> bool {
        let Type::Record(id) = ty else { return false };
        self.ensure_checked(*id, self.items[id.0 as usize].name_span);
        let ItemKind::Record(fields) = &self.items[id.0 as usize].kind else { return false };
        let has = |name: &str| fields.iter().any(|field| field.name == name && field.ty == Type::LENGTH);
        has("across") && has("along")
    }
}
