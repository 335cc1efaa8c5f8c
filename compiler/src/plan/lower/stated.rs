//! Boundaries and the joins that are stated of them: what their names stand for, and whether the joins hold.

use super::Lowering;
use super::places::{gap_words, place_words};
use crate::diagnostic::{Code, Diagnostic, Fix};
use crate::hir::evaluate::{InstanceBody, InstanceJoin, InstanceJoinPart};
use crate::hir::tree::ItemKind;
use crate::hir::value::{GermShape, Instance};
use crate::ifs::{
    Apart, Automaton, Boundary, End, Matrix, Side, State, StateId, Stated, StatedJoin, is_rounding,
    stated_join,
};
use crate::source::Span;

type Path = [InstanceJoinPart];

/// The most pieces of which each is offered.
const MOST_OFFERED: usize = 4;

impl Lowering<'_, '_> {
    /// The joins of an ifs without parameters are proved even where no figure uses it.
    pub(super) fn enter_stated(&mut self) {
        for (id, item) in self.hir.own_items() {
            let ItemKind::Ifs(ifs) = &item.kind else { continue };
            if ifs.parameters.is_empty() && !ifs.joins.is_empty() {
                self.failed |= self.state(&Instance { ifs: id, arguments: Vec::new() }).is_none();
            }
        }
    }

    /// The boundaries of a state; every ifs they name has been entered.
    pub(super) fn boundaries(&self, body: &InstanceBody) -> Option<Vec<Boundary>> {
        let boundary = |boundary: &crate::hir::evaluate::InstanceBoundary| {
            let target = self.states.find(&boundary.target)?;
            let matrix = Matrix::from_rows(boundary.rows.clone()).ok()?;
            Some(Boundary { name: boundary.name.clone(), target, matrix })
        };
        body.boundaries.iter().map(boundary).collect()
    }

    /// The joins that are stated of a state.
    fn joins_of(&self, state: usize) -> Vec<InstanceJoin> {
        let body = self.states.bodies.get(state).and_then(Option::as_ref);
        body.map_or(Vec::new(), |body| body.joins.clone())
    }

    /// Gives every state the joins that are stated of it; `None` after a report.
    pub(super) fn state_joins(&mut self, states: &mut [State]) -> Option<()> {
        let mut good = true;
        for place in 0..states.len() {
            for join in self.joins_of(place) {
                match (self.side(states, place, &join.left), self.side(states, place, &join.right)) {
                    (Ok(left), Ok(right)) => states[place].stated_joins.push(StatedJoin { left, right }),
                    (Err(diagnostic), _) | (_, Err(diagnostic)) => {
                        good = false;
                        if !self.diagnostics.contains(&diagnostic) {
                            self.diagnostics.push(*diagnostic);
                        }
                    }
                }
            }
        }
        good.then_some(())
    }

    /// What a path stands for: `left.end`, `branch[0].end`, `start`, `bottom.left`.
    fn side(&self, states: &[State], place: usize, path: &Path) -> Result<Side, Box<Diagnostic>> {
        let state = &states[place];
        let (first, second) = match path {
            [own] => (own, None),
            [first, second] => (first, Some(second)),
            _ => return Err(missing("", &state.name, "boundary", Span::default())),
        };
        let boundary = state.boundaries.iter().position(|boundary| boundary.name == first.name);
        if boundary.is_none()
            && let Some(second) = second
        {
            let transform = transform(state, first, "transform or boundary")?;
            let piece = state.transforms[transform].target.index();
            return self.side_of_piece(states, (transform, piece), second);
        }
        no_family(first)?;
        let Some(boundary) = boundary else {
            let end = end(&first.name).filter(|_| self.draws_segments(place));
            let none = || missing(&first.name, &state.name, "boundary", first.span);
            return end.map(Side::OwnEnd).ok_or_else(none);
        };
        let target = &states[state.boundaries[boundary].target.index()];
        let transform = match second {
            Some(second) => transform(target, second, "transform")?,
            None if target.transforms.len() == 1 => 0,
            None => return Err(Box::new(several(&first.name, first.span, target))),
        };
        Ok(Side::Own { boundary, transform })
    }

    /// A boundary of the state that a transform continues with.
    fn side_of_piece(
        &self,
        states: &[State],
        (transform, piece): (usize, usize),
        part: &InstanceJoinPart,
    ) -> Result<Side, Box<Diagnostic>> {
        no_family(part)?;
        let name = &part.name;
        if let Some(boundary) = states[piece].boundaries.iter().position(|found| found.name == *name) {
            return Ok(Side::Piece { transform, boundary });
        }
        let end = end(name).filter(|_| self.draws_segments(piece));
        let end = end.ok_or_else(|| missing(name, &states[piece].name, "boundary", part.span))?;
        Ok(Side::PieceEnd { transform, end })
    }

    fn draws_segments(&self, state: usize) -> bool {
        let body = self.states.bodies.get(state).and_then(Option::as_ref);
        body.is_some_and(|body| body.germ.shape == GermShape::Segment)
    }

    /// Whether every stated join holds, reported where it does not.
    pub(super) fn check_stated(&mut self, automaton: &Automaton) -> bool {
        let mut good = true;
        for (place, state) in automaton.states().iter().enumerate() {
            let id = StateId(place as u32);
            let joins = self.joins_of(place);
            for (join, stated) in joins.iter().zip(&state.stated_joins) {
                let diagnostic = match stated_join(automaton, id, stated) {
                    Stated::Holds => continue,
                    Stated::Apart(apart) => self.apart(automaton, id, join, stated, &apart),
                    Stated::Unlike { level } => unlike(state, join, level),
                    Stated::Unproved { level } => unproved(state, join, level),
                };
                good &= diagnostic.code == Code::W0546;
                let said =
                    |other: &Diagnostic| other.code == diagnostic.code && other.span == diagnostic.span;
                if !self.diagnostics.iter().any(said) {
                    self.diagnostics.push(diagnostic);
                }
            }
        }
        good
    }

    fn apart(
        &self,
        automaton: &Automaton,
        id: StateId,
        join: &InstanceJoin,
        stated: &StatedJoin,
        apart: &Apart,
    ) -> Diagnostic {
        let state = automaton.state(id);
        let (left, right) = (path_text(&join.left), path_text(&join.right));
        let rows = [(&left, &apart.left_weights), (&right, &apart.right_weights)];
        let rows = rows.map(|(name, row)| format!("`{name}` lies at {}", place_words(state, row)));
        let gap = gap_words(state, [&apart.left_weights, &apart.right_weights]);
        let by = format!("at level {} they are {gap} apart", apart.level);
        let mut diagnostic = if is_rounding(automaton, id, &apart.left_weights, &apart.right_weights) {
            let message = format!(
                "`{left}` and `{right}` of `{}` are joined only to within rounding, not exactly",
                state.name
            );
            let note = format!("{by}, which rounding explains; deeper levels are not proved");
            Diagnostic::new(Code::W0546, join.span, message)
                .label("equal but for rounding")
                .note(note)
                .hint("numbers such as `sqrt(3)` are rounded; write both sides with the same `let`, and the join is exact")
        } else {
            let message = format!("the join of `{}` does not hold: `{left}` is not `{right}`", state.name);
            Diagnostic::new(Code::E0542, join.span, message)
                .label("stated here")
                .note(by)
                .hint(format!("give `{left}` and `{right}` the same points, in the same order"))
        };
        for (side, row) in [stated.left, stated.right].into_iter().zip(rows) {
            if let Some(span) = self.side_span(id, side) {
                diagnostic = diagnostic.also(span, row);
            }
        }
        diagnostic
    }

    /// Where the transform or boundary of a side is declared.
    fn side_span(&self, state: StateId, side: Side) -> Option<Span> {
        match side {
            Side::Piece { transform, .. } | Side::PieceEnd { transform, .. } => {
                self.transform_span(state, transform)
            }
            Side::Own { boundary, .. } => {
                let body = self.states.bodies.get(state.index())?.as_ref()?;
                body.boundaries.get(boundary).map(|boundary| boundary.name_span)
            }
            Side::OwnEnd(_) => self.germ_span(state),
        }
    }
}

fn missing(name: &str, of: &str, kind: &str, span: Span) -> Box<Diagnostic> {
    let message = format!("`{of}` has no {kind} `{name}`");
    Box::new(Diagnostic::new(Code::E0540, span, message).label("not declared"))
}

/// The transform of a state that a part of a path names: one, or a member of a family; `kind` is what else it may be.
fn transform(state: &State, part: &InstanceJoinPart, kind: &str) -> Result<usize, Box<Diagnostic>> {
    let name = part.transform_name();
    if let Some(found) = state.transforms.iter().position(|transform| transform.name == name) {
        return Ok(found);
    }
    let family = format!("{}.", part.name);
    let of_family = state.transforms.iter().filter_map(|transform| transform.name.strip_prefix(&family));
    let members: Vec<&str> = of_family.collect();
    let shown: Vec<String> = members
        .iter()
        .enumerate()
        .filter(|(place, _)| *place < 2 || place + 1 == members.len())
        .map(|(place, member)| {
            let gap = if place > 2 { "… " } else { "" };
            format!("{gap}`{}[{member}]`", part.name)
        })
        .collect();
    let refused = |code: Code, message: String, label: &str, hint: String, instead: Vec<String>| {
        let fixes = instead.into_iter().map(|name| Fix::replacing(part.span, name)).collect();
        Err(Box::new(Diagnostic::new(code, part.span, message).label(label).ways(hint, fixes)))
    };
    let indexed =
        members.iter().take(MOST_OFFERED).map(|member| format!("{}[{member}]", part.name)).collect();
    let are = format!("there are {}", shown.join(", "));
    match part.member {
        _ if members.is_empty() && !state.transforms.iter().any(|transform| transform.name == part.name) => {
            Err(missing(&part.name, &state.name, kind, part.span))
        }
        Some(_) if members.is_empty() => {
            let message = format!("`{}` is one transform, not a family of them", part.name);
            refused(Code::E0540, message, "has no members", format!("write `{}`", part.name), Vec::new())
        }
        Some(_) => {
            let message = format!("the family `{}` of `{}` has no member `{part}`", part.name, state.name);
            refused(Code::E0540, message, "not there", are, Vec::new())
        }
        None => {
            let message =
                format!("`{}` is a family of {} transforms: which one is meant?", part.name, members.len());
            refused(Code::E0545, message, "more than one piece", are, indexed)
        }
    }
}

/// Refuses `[0]` after a boundary.
fn no_family(part: &InstanceJoinPart) -> Result<(), Box<Diagnostic>> {
    if part.member.is_none() {
        return Ok(());
    }
    let message = format!("`{}` is one boundary, not a family", part.name);
    let diagnostic = Diagnostic::new(Code::E0540, part.span, message).label("has no members");
    Err(Box::new(diagnostic.hint(format!("write `{}`", part.name))))
}

fn several(name: &str, span: Span, target: &State) -> Diagnostic {
    let message = format!(
        "the boundary `{name}` has {} pieces after one step: which one is meant?",
        target.transforms.len()
    );
    let names = || target.transforms.iter().map(|transform| format!("{name}.{}", transform.name));
    let shown: Vec<String> = names().map(|name| format!("`{name}`")).collect();
    let fixes = names().take(MOST_OFFERED).map(|name| Fix::replacing(span, name)).collect();
    Diagnostic::new(Code::E0545, span, message)
        .label("more than one piece")
        .ways(format!("name one: {}", shown.join(", ")), fixes)
}

fn unlike(state: &State, join: &InstanceJoin, level: u32) -> Diagnostic {
    let (left, right) = (path_text(&join.left), path_text(&join.right));
    let message =
        format!("`{left}` and `{right}` of `{}` cannot be joined: they are of different kinds", state.name);
    Diagnostic::new(Code::E0543, join.span, message)
        .label("not the same kind of thing")
        .note(format!(
            "at level {level} they draw different shapes, or are cut into different numbers of pieces"
        ))
        .hint("let both boundaries be the same ifs, on points that agree")
}

fn unproved(state: &State, join: &InstanceJoin, level: u32) -> Diagnostic {
    let (left, right) = (path_text(&join.left), path_text(&join.right));
    let message = format!("that `{left}` is `{right}` in `{}` could not be proved", state.name);
    Diagnostic::new(Code::E0544, join.span, message)
        .label("neither proved nor refuted")
        .note(format!("it holds at the first {level} levels; the proof takes too many steps"))
        .hint("use fewer points, or weights of shorter fractions")
}

fn path_text(path: &Path) -> String {
    path.iter().map(InstanceJoinPart::to_string).collect::<Vec<_>>().join(".")
}

fn end(name: &str) -> Option<End> {
    match name {
        "start" => Some(End::Start),
        "end" => Some(End::Finish),
        _ => None,
    }
}
