//! The position of the parser in the list of tokens.

use std::cell::OnceCell;
use std::collections::HashMap;

use crate::diagnostics::{Diagnostic, Kind};
use crate::syntax::{ClaimKind, Name};
use crate::token::{Span, Token, TokenKind};

use super::Parsed;

pub(super) struct Cursor<'a> {
    tokens: &'a [Token],
    at: usize,
    /// The token that ends the current expression, besides `;`, `,` and closing brackets.
    pub(super) end: ExpressionEnd,
    /// The name of the index in a family `for i in …`. Names other than `i` are mistakes.
    pub(super) index: Option<&'a str>,
    pub(super) is_lifted: bool,
    /// For each name in the tokens, whether it occurs at least once without `=` directly after it.
    names: OnceCell<HashMap<&'a str, bool>>,
}

/// The token that ends an expression, in addition to `;`, `,` and closing brackets.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum ExpressionEnd {
    Semicolon,
    /// The first word of the next item. It may follow the conditions of a bracket without a `;`.
    Item,
    /// The sign `=`, on the left side of a relation after `when`.
    Equals,
    /// The word `by`, after the function of a drift.
    By,
    /// All punctuation except operators, in formulas outside blocks.
    Formula,
}

impl<'a> Cursor<'a> {
    pub(super) fn new(tokens: &'a [Token]) -> Self {
        let word = |token: &Token, text: &str| token.kind == TokenKind::Identifier && token.text == text;
        let has_sites = tokens.windows(3).any(|three| {
            word(&three[0], "for") && three[1].kind == TokenKind::Identifier && word(&three[2], "in")
        });
        Cursor {
            index: has_sites.then_some("i"),
            end: ExpressionEnd::Semicolon,
            ..Cursor::of_formulas(tokens)
        }
    }

    pub(super) fn of_formulas(tokens: &'a [Token]) -> Self {
        Cursor {
            tokens,
            at: 0,
            end: ExpressionEnd::Formula,
            index: None,
            is_lifted: false,
            names: OnceCell::new(),
        }
    }

    fn names(&self) -> &HashMap<&'a str, bool> {
        self.names.get_or_init(|| {
            let mut names = HashMap::new();
            for (place, token) in self.tokens.iter().enumerate() {
                if token.kind == TokenKind::Identifier {
                    let next = self.tokens.get(place + 1).map(|next| &next.kind);
                    let is_used = next != Some(&TokenKind::Punctuation('='));
                    *names.entry(&*token.text).or_default() |= is_used;
                }
            }
            names
        })
    }

    pub(super) fn mentions(&self, name: &str) -> bool {
        self.names().contains_key(name)
    }

    /// Returns whether a name occurs at least once without `=` directly after it.
    pub(super) fn uses(&self, name: &str) -> bool {
        self.names().get(name).is_some_and(|is_used| *is_used)
    }

    pub(super) fn position(&self) -> usize {
        self.at
    }

    pub(super) fn written_since(&self, start: usize) -> String {
        let tokens = self.tokens[..self.at.min(self.tokens.len())].get(start..).unwrap_or_default();
        tokens.iter().enumerate().fold(String::new(), |line, (index, token)| {
            let is_apart = !token.touches_next && index + 1 < tokens.len();
            line + &token.text + if is_apart { " " } else { "" }
        })
    }

    pub(super) fn is_at_end(&self) -> bool {
        self.at >= self.tokens.len()
    }

    pub(super) fn peek(&self, ahead: usize) -> Option<&'a Token> {
        self.tokens.get(self.at + ahead)
    }

    /// Returns a token that was already read; `behind` = 1 returns the last one.
    pub(super) fn before(&self, behind: usize) -> Option<&'a Token> {
        self.tokens.get(self.at.checked_sub(behind)?)
    }

    pub(super) fn advance(&mut self) {
        self.at += 1;
    }

    /// Returns the span of the next token; at the end of the list, that of the last token.
    pub(super) fn here(&self) -> Span {
        Span::token(self.at.min(self.tokens.len().saturating_sub(1)))
    }

    pub(super) fn behind(&self) -> Span {
        Span::token(self.at.saturating_sub(1))
    }

    pub(super) fn identifier(&self, ahead: usize) -> Option<&'a str> {
        self.peek(ahead).filter(|token| token.kind == TokenKind::Identifier).map(|token| &*token.text)
    }

    pub(super) fn name(&self, ahead: usize) -> Option<Name> {
        let text = self.identifier(ahead)?.to_owned();
        Some(Name { text, span: Span::token(self.at + ahead) })
    }

    pub(super) fn is_punctuation(&self, ahead: usize, c: char) -> bool {
        self.peek(ahead).is_some_and(|token| token.kind == TokenKind::Punctuation(c))
    }

    pub(super) fn is_open(&self, ahead: usize, c: char) -> bool {
        self.peek(ahead).is_some_and(|token| token.kind == TokenKind::Open(c))
    }

    pub(super) fn is_close(&self, c: char) -> bool {
        self.peek(0).is_some_and(|token| token.kind == TokenKind::Close(c))
    }

    /// Returns whether the next two tokens are `first` and `second`, adjacent as in `**`.
    pub(super) fn is_pair(&self, first: char, second: char) -> bool {
        self.is_punctuation(0, first)
            && self.is_punctuation(1, second)
            && self.peek(0).is_some_and(|token| token.touches_next)
    }

    /// Reads the punctuation `c` if it is next, and returns whether `c` was read.
    pub(super) fn take(&mut self, c: char) -> bool {
        let found = self.is_punctuation(0, c);
        self.at += usize::from(found);
        found
    }

    /// Reads a name. If the next token is no name, reports that `what` was expected.
    pub(super) fn expect_name(&mut self, what: &str) -> Parsed<Name> {
        let missing = || self.missing(Kind::Syntax, self.here(), what, "write a name here");
        let name = self.name(0).ok_or_else(missing)?;
        self.advance();
        Ok(name)
    }

    pub(super) fn missing(&self, kind: Kind, span: Span, what: &str, help: impl Into<String>) -> Diagnostic {
        Diagnostic::new(kind, span, format!("expected {what}, found {}", self.describe_next()), help)
    }

    pub(super) fn describe_next(&self) -> String {
        let whole = if self.end == ExpressionEnd::Formula { "formula" } else { "block" };
        self.peek(0).map_or_else(|| format!("the end of the {whole}"), |token| format!("`{}`", token.text))
    }

    /// Returns whether an item such as `xdot =` or `bracket P {` begins `ahead` tokens from here.
    pub(super) fn begins_item(&self, ahead: usize) -> bool {
        let Some(word) = self.identifier(ahead) else { return false };
        if self.end == ExpressionEnd::Formula {
            return self.is_punctuation(ahead + 1, '=');
        }
        let equation = word.len() > 3 && word.ends_with("dot") && self.is_punctuation(ahead + 1, '=')
            || self.begins_equation_of_family(ahead)
            || (word == "for" && self.identifier(ahead + 2) == Some("in"));
        let named = self.identifier(ahead + 1).is_some()
            && (self.is_punctuation(ahead + 2, '=') || self.is_open(ahead + 2, '{'));
        let is_keyword = word == "const"
            || ClaimKind::of_keyword(word).is_some()
            || (self.index.is_some() && word == "hamiltonian");
        equation || (named && is_keyword)
    }

    fn begins_equation_of_family(&self, ahead: usize) -> bool {
        self.index.is_some() && self.is_open(ahead + 1, '[') && self.identifier(ahead + 4) == Some("dot")
    }

    /// Skips a broken item that began at `start`, up to its `;` or the next item.
    pub(super) fn skip_item(&mut self, start: usize) {
        self.skip_until(|cursor| cursor.is_punctuation(0, ';') || cursor.at > start && cursor.begins_item(0));
        self.take(';');
    }

    /// Skips tokens and bracketed groups, up to a token that satisfies `ends`.
    pub(super) fn skip_until(&mut self, ends: impl Fn(&Self) -> bool) {
        while !self.is_at_end() && !ends(self) {
            match self.peek(0).map(|token| &token.kind) {
                Some(TokenKind::Open(_)) => drop(self.skip_group()),
                _ => self.advance(),
            }
        }
    }

    /// Skips a bracketed group, or all tokens if the group is not closed. Returns the skipped span.
    pub(super) fn skip_group(&mut self) -> Span {
        let start = self.here();
        let mut depth = 0usize;
        while let Some(token) = self.peek(0) {
            self.advance();
            match token.kind {
                TokenKind::Open(_) => depth += 1,
                TokenKind::Close(_) => depth = depth.saturating_sub(1),
                _ => {}
            }
            if depth == 0 {
                break;
            }
        }
        start.to(self.behind())
    }

    /// Skips a bracketed group. Returns its span, and the tokens between its brackets.
    pub(super) fn take_group(&mut self) -> (Span, &'a [Token]) {
        let group = self.skip_group();
        let is_closed = matches!(self.tokens[group.last].kind, TokenKind::Close(_));
        let last = group.last + usize::from(!is_closed);
        (group, self.tokens.get(group.first + 1..last).unwrap_or_default())
    }

    pub(super) fn unreadable(&self) -> Option<Diagnostic> {
        match &self.peek(0)?.kind {
            TokenKind::Unreadable(why) => {
                Some(Diagnostic::new(Kind::Syntax, self.here(), why.message.clone(), why.help.clone()))
            }
            _ => None,
        }
    }
}
