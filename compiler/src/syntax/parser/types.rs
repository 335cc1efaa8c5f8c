//! Types as they are written.

use super::Rule;
use super::expected::Expected;
use super::names::name;
use super::primitive::token;
use crate::syntax::ast::{TypeExpr, TypeExprKind};
use crate::syntax::token::TokenKind;
use chumsky::prelude::*;

/// `Length`, `[Point]`
pub(super) fn written_type<'s>() -> Rule<'s, TypeExpr> {
    recursive(|inner| {
        let named = name().map(|name| TypeExpr { span: name.span, kind: TypeExprKind::Name(name.text) });
        let list = inner
            .delimited_by(token(TokenKind::OpenBracket), token(TokenKind::CloseBracket))
            .map_with(|inner, e| TypeExpr { span: e.span(), kind: TypeExprKind::List(Box::new(inner)) });
        named.or(list).labelled(Expected::Type)
    })
    .boxed()
}
