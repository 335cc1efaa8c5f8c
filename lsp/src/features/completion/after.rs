//! Words that go on after a value or a name that is declared, and what follows the name of an ifs.

use ifs_compiler::hir::schema::SettingType;
use ifs_compiler::hir::types::{PointSpace, Type};
use ifs_compiler::syntax::TokenKind;

use super::place::block_kind;
use super::{Kind, Known, Offer, ifs};
use crate::features::tokens::Before;

/// Where an ifs lives.
pub(super) fn spaces(before: &Before<'_>) -> Vec<Offer> {
    let space = |label: &str, snippet: &str, detail: &str| word(label, snippet).detail(detail);
    if before.back(1) == Some(TokenKind::In) {
        let braces = if before.next == Some(TokenKind::OpenBrace) { "" } else { " {\n    $0\n}" };
        return ["plane", "space"].map(|word| space(word, &format!("{word}{braces}"), "")).to_vec();
    }
    vec![
        space("on", "on (${1:a, b})", "its control points"),
        space("in plane", "in plane", "an ifs of maps of the plane"),
        space("in space", "in space", "an ifs of maps of space"),
    ]
}

fn word(label: &str, snippet: &str) -> Offer {
    Offer::new(label, Kind::Keyword).snippet(snippet)
}

/// What is written in the innermost bracket, up to the word.
struct Part<'a> {
    known: &'a Known<'a>,
    before: &'a Before<'a>,
    tokens: Vec<usize>,
}

impl Part<'_> {
    fn kind(&self, at: usize) -> TokenKind {
        self.before.tokens[at].kind
    }

    fn has(&self, kind: TokenKind) -> bool {
        self.tokens.iter().any(|at| self.kind(*at) == kind)
    }

    fn has_word(&self, word: &str) -> bool {
        self.tokens.iter().any(|at| self.kind(*at) == TokenKind::Name && self.before.written(*at) == word)
    }

    fn first_word(&self) -> &str {
        self.tokens.first().map_or("", |at| self.before.written(*at))
    }

    /// The type of the whole value that ends before the word, where it is known.
    fn ty(&self) -> Option<&Type> {
        let from = self.before.tokens[*self.tokens.first()?].span;
        let end = self.before.tokens.last()?.span.end;
        let here = self
            .known
            .index()
            .types
            .iter()
            .filter(|(span, _)| span.file == from.file && from.start <= span.start && span.end == end);
        here.min_by_key(|(span, _)| span.start).map(|(_, ty)| ty)
    }
}

/// What goes on after a value, or after a name or a type that is declared.
pub(super) fn words(known: &Known<'_>) -> Vec<Offer> {
    let before = known.before;
    let part = Part { known, before, tokens: before.statement() };
    if let Some(only) = declaration(&part).or_else(|| running(&part)) {
        return only;
    }
    let mut offers = match branch(before) {
        Some(Branch::Then) => {
            let mut offers = vec![word("then", "then ")];
            offers.extend(logical(&part));
            return offers;
        }
        Some(Branch::Else) => vec![word("else", "else ")],
        None => Vec::new(),
    };
    match before.item() {
        Some(TokenKind::Param) if before.open.is_empty() && part.has(TokenKind::In) => return range(&part),
        Some(TokenKind::Param) if before.open.is_empty() => offers.extend(range(&part)),
        Some(TokenKind::Fabricate) if part.first_word() == "require" => return required(&part),
        Some(TokenKind::Fabricate) => offers.extend(second_side(&part)),
        _ => {}
    }
    offers.extend(moved(&part));
    offers.extend(placement(&part));
    offers.extend(clauses(&part));
    offers.extend(logical(&part));
    offers
}

/// What goes on after the name or the type of what is declared, before its sign.
fn declaration(part: &Part<'_>) -> Option<Vec<Offer>> {
    let first = part.tokens.iter().find(|at| part.kind(**at) != TokenKind::Pub)?;
    if part.has(TokenKind::Equals) {
        return None;
    }
    let last = part.before.back(1)?;
    let glued = part.before.tokens.last()?.span.end == part.before.word.start;
    let space = if glued { " " } else { "" };
    let sign = word("=", &format!("{space}= $0")).detail("its value").rank(1);
    let typed = word(":", ": ${1:Length} = $0").detail("its type").rank(2);
    let typed = |needed: bool| {
        if part.has(TokenKind::Colon) { None } else { Some(typed.clone().rank(u8::from(!needed) * 2)) }
    };
    Some(match (part.kind(*first), part.before.written(*first)) {
        (TokenKind::Fn, _) if part.has(TokenKind::Arrow) => vec![sign],
        (TokenKind::Fn, _) if last == TokenKind::CloseParenthesis => {
            vec![word("->", &format!("{space}-> ${{1:Length}} = $0")).detail("what it gives"), sign]
        }
        (TokenKind::Fn, _) => Vec::new(),
        (TokenKind::Param, _) => typed(true).map_or(vec![sign], |typed| vec![typed]),
        (TokenKind::Let | TokenKind::Figure, _) => typed(false).into_iter().chain([sign]).collect(),
        (TokenKind::Name, "boundary") => vec![sign],
        (TokenKind::Name, "transform") => {
            let family = word("[…]", "[${1:i} in ${2:0..3}] = $0").detail("a family of copies").rank(2);
            let family = Some(family).filter(|_| last == TokenKind::Name);
            [sign].into_iter().chain(family).collect()
        }
        _ => return None,
    })
}

/// After the name that runs through a list or a range, which must be said.
fn running(part: &Part<'_>) -> Option<Vec<Offer>> {
    let open = part.before.open.last().filter(|open| open.kind == TokenKind::OpenBracket)?;
    let before_open = |back: usize| open.at.checked_sub(back).map_or("", |at| part.before.written(at));
    let family = part.before.item() == Some(TokenKind::Ifs) && before_open(2) == "transform";
    let named = part.before.back(1) == Some(TokenKind::Name)
        && (part.before.back(2) == Some(TokenKind::For) || family && part.tokens.len() == 1);
    let through = || vec![word("in", "in ${1:0..3}").detail("what it runs through")];
    if named { Some(through()) } else { family.then(Vec::new) }
}

/// What an `if` still needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Branch {
    Then,
    Else,
}

/// What the innermost `if` of what is being written needs; one that picks from what a `for` runs through needs nothing.
pub(super) fn branch(before: &Before<'_>) -> Option<Branch> {
    let mut open = Vec::new();
    let mut runs = false;
    for at in before.statement() {
        match before.tokens[at].kind {
            TokenKind::For => runs = true,
            TokenKind::If if runs && before.value_ends(at) => {}
            TokenKind::If => open.push(Branch::Then),
            TokenKind::Then => {
                open.pop();
                open.push(Branch::Else);
            }
            TokenKind::Else => {
                open.pop();
            }
            _ => {}
        }
    }
    open.pop()
}

/// The range of a parameter and the step in it.
fn range(part: &Part<'_>) -> Vec<Offer> {
    let step = || word("step", "step ${1:100mm}").detail("the step between its values").rank(1);
    let ends = || word("in", "in ${1:4m} .. ${2:9m}").detail("the range it may be set in");
    match (part.has_word("step"), part.has(TokenKind::DotDot), part.has(TokenKind::In)) {
        (true, ..) => Vec::new(),
        (_, true, _) => vec![step()],
        (_, _, true) => vec![word("..", ".. $0").detail("the other end")],
        _ => vec![ends(), step()],
    }
}

/// What a requirement still needs after a value: of a range the other end.
fn required(part: &Part<'_>) -> Vec<Offer> {
    let half = part.has(TokenKind::In) && !part.has(TokenKind::DotDot);
    if half { vec![word("..", ".. $0").detail("the other end")] } else { Vec::new() }
}

/// The second side of a size in a block.
fn second_side(part: &Part<'_>) -> Option<Offer> {
    let size = SettingType::Of(Type::Size);
    let setting = block_kind(part.before)?.setting(part.first_word())?;
    let fits = setting.ty == size && part.before.open.len() == 1 && !part.has_word("by");
    fits.then(|| word("by", "by ").detail("the second side of a size"))
}

/// Where an ifs is placed, and how deep it goes.
fn placement(part: &Part<'_>) -> Vec<Offer> {
    let item = part.before.item();
    let ty = part.ty();
    let mut offers = Vec::new();
    let figures = matches!(item, Some(TokenKind::Figure | TokenKind::Let | TokenKind::Fn));
    let running = part.has(TokenKind::For);
    let levelled = part.has(TokenKind::At) || part.has_word("until");
    if running || levelled || ty.is_some_and(|ty| *ty != Type::Ifs && !ty.is_figure()) {
        return offers;
    }
    let moved = part.before.back(1) == Some(TokenKind::Itself)
        && ifs::space(part.before).is_some_and(|space| space != PointSpace::Control);
    let placed = part.has(TokenKind::On) || moved || ty.is_some_and(|ty| *ty != Type::Ifs);
    if (figures || item == Some(TokenKind::Ifs)) && !placed {
        offers.push(word("on", "on ($0)").detail("the points that an ifs is placed on").rank(1));
    }
    if figures {
        let until = "until ${1|edge,size,length|} <= ${2:600mm}";
        let each = "each until ${1:size} <= ${2:20mm}";
        offers.push(word("at level", "at level ${1:3}").detail("how deep it goes").rank(2));
        offers.push(word("until", until).detail("a level by size").rank(3));
        offers.push(word("each until", each).detail("every branch stops on its own").rank(4));
    }
    offers
}

/// What a map of a transform moves.
fn moved(part: &Part<'_>) -> Option<Offer> {
    let map = matches!(part.ty(), Some(Type::Map(_))) && part.first_word() == "transform";
    map.then(|| word("* self", "* self").detail("what the map moves"))
}

/// What makes a list of what stands in its brackets.
fn clauses(part: &Part<'_>) -> Vec<Offer> {
    let open = part.before.open.last().filter(|open| open.kind == TokenKind::OpenBracket);
    // Behind a value the brackets pick from it.
    if open.is_none_or(|open| part.before.value_ends(open.at)) {
        return Vec::new();
    }
    let each = word("for", "for ${1:i} in ${2:0..3}").detail("for each of a range or a list");
    let picked = word("if", "if $0").detail("only those").rank(1);
    if part.has(TokenKind::For) { vec![picked, each.rank(2)] } else { vec![each] }
}

/// Words between truths.
fn logical(part: &Part<'_>) -> Vec<Offer> {
    if part.ty().is_some_and(|ty| *ty != Type::Bool) {
        return Vec::new();
    }
    ["and", "or"].map(|name| word(name, &format!("{name} ")).rank(9)).to_vec()
}
