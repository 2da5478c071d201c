//! Reads left-hand sides of equations and values in the notation of books and other programs.

use crate::lexer::{primes, starts_identifier};
use crate::spelling::without_dots;
use crate::token::TokenKind;

use super::Reader;

/// Orders of derivatives, each with its notations, separated by `|`.
///
/// `X` stands for the name of a state, with or without `(t)`. `′` stands for any number of primes,
/// and `Ẋ` for a name with dots above it.
const DERIVATIVES: [(usize, &str); 4] = [
    (1, "Xdot|dX / dt|d X / dt|der ( X )|D ( X )|diff ( X , t )|Derivative ( X , t )"),
    (1, "\\ dot { X }|\\ frac { dX } { dt }"),
    (2, "d ^ 2X / dt ^ 2|d ^ 2 X / dt ^ 2|diff ( X , t , t )|Derivative ( X , ( t , 2 ) )|\\ ddot { X }"),
    (0, "X ′|( X ) ′|Ẋ|X"),
];

const HIGHEST_ORDER: usize = 8;

const DECLARATION_KEYWORDS: [&str; 6] = ["par", "param", "params", "parameter", "parameters", "init"];
/// Words that declare values at the start of a line. Elsewhere they are ordinary names.
const AT_BEGINNINGS: [&str; 5] = ["p", "i", "number", "aux", "!"];

pub(super) struct Derivative {
    pub(super) name: String,
    /// The order of the derivative, which is 0 for the state itself.
    pub(super) order: usize,
    pub(super) end: usize,
}

pub(super) struct LeftSide {
    pub(super) of: Derivative,
    /// The names of arguments if the item defines a function; otherwise empty.
    pub(super) arguments: Vec<String>,
    /// Whether the item gives the value at time 0, as in `x(0) =`.
    pub(super) is_first: bool,
    /// Whether the equation is written `Eq(…, …)`.
    pub(super) is_in_call: bool,
    pub(super) is_declared: bool,
    pub(super) right: usize,
}

impl LeftSide {
    /// Returns whether the item gives a value; other items are differential equations.
    pub(super) fn is_value(&self) -> bool {
        self.of.order == 0 || self.is_first
    }
}

impl Reader<'_> {
    pub(super) fn left_side(&self, at: usize) -> Option<LeftSide> {
        let begins =
            || AT_BEGINNINGS.contains(&self.at(at)) && self.begins_line(at) && !self.begins_line(at + 1);
        let is_declared = (DECLARATION_KEYWORDS.contains(&self.at(at)) || begins()) && self.is_name(at + 1);
        let is_in_call = self.at(at) == "Eq" && self.at(at + 1) == "(";
        let of = self.derivative(at + usize::from(is_declared) + 2 * usize::from(is_in_call))?;
        let is_first = self.is_group(of.end, "0");
        let named = self.argument_names(of.end).filter(|_| of.order == 0 && !is_in_call);
        let (arguments, end) = named.unwrap_or((Vec::new(), of.end + if is_first { 3 } else { 0 }));
        let length = match self.at(end) {
            "=" if !is_in_call => 1 + usize::from(self.at(end + 1) == "=" && self.given[end].0.touches_next),
            "~" if !is_in_call => 1,
            "," if is_in_call => 1,
            _ => return None,
        };
        Some(LeftSide { of, arguments, is_first, is_in_call, is_declared, right: end + length })
    }

    pub(super) fn derivative(&self, at: usize) -> Option<Derivative> {
        let matching = |(order, patterns): &(usize, &str)| {
            patterns.split('|').find_map(|pattern| self.match_derivative(at, pattern, *order))
        };
        DERIVATIVES.iter().find_map(matching)
    }

    fn match_derivative(&self, mut at: usize, pattern: &str, mut order: usize) -> Option<Derivative> {
        let mut found = None;
        let time = |at: usize| if self.is_group(at, "t") { 3 } else { 0 };
        for piece in pattern.split(' ') {
            let (token, _) = self.given.get(at)?;
            at += 1;
            if piece == "′" {
                order += token.text.chars().map(primes).sum::<Option<usize>>()?;
            } else if piece == "Ẋ" {
                let (name, dots) = without_dots(&token.text)?;
                (found, order) = (Some(name), order + dots);
            } else if let Some((before, behind)) = piece.split_once('X') {
                let name = token.text.strip_prefix(before)?.strip_suffix(behind)?;
                let is_word = matches!(token.kind, TokenKind::Identifier | TokenKind::Literal);
                let name = is_word.then_some(name).filter(|name| name.starts_with(starts_identifier))?;
                found = Some(name.to_owned());
                at += time(at);
            } else if token.text != piece {
                return None;
            }
        }
        let name = found.filter(|_| order <= HIGHEST_ORDER)?;
        Some(Derivative { name, order, end: at + time(at) })
    }

    /// Returns whether the text `(inside)` or `[inside]` begins at token `at`.
    pub(super) fn is_group(&self, at: usize, inside: &str) -> bool {
        self.at(at + 1) == inside && matches!((self.at(at), self.at(at + 2)), ("(", ")") | ("[", "]"))
    }
}
