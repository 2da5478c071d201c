//! Reads functions and directives of XPP files.

use std::collections::{HashMap, HashSet};
use std::ops::Range;

use crate::spelling::ON_TEXTS;
use crate::token::TokenKind;

use super::right_side::MOST_TOKENS;
use super::{PlacedToken, Reader, mistake, placed_token};

const MAX_CALL_DEPTH: usize = 64;

#[derive(Clone, Debug)]
pub(super) struct Function {
    pub(super) arguments: Vec<String>,
    pub(super) right: Range<usize>,
}

const REFUSED: [(&str, &str); 9] = [
    ("wiener", "makes the equations random, and a field is deterministic"),
    ("markov", "makes the equations random, and a field is deterministic"),
    ("global", "changes values at events, and an orbit follows one smooth field"),
    ("table", "gives a function by numbers, and a field has formulas"),
    ("bdry", "gives conditions at both ends, and an orbit has a start"),
    ("volterra", "is an equation with an integral over the past"),
    ("volt", "is an equation with an integral over the past"),
    ("solv", "is an algebraic equation: solve it for one of its names"),
    ("special", "is a sum over an array: write out its terms"),
];

const CALLS: [(&str, &str); 5] = [
    ("delay", "is a value of the past"),
    ("del_shft", "is a value of the past"),
    ("ran", "is random, and a field is deterministic"),
    ("normal", "is random, and a field is deterministic"),
    ("poisson", "is random, and a field is deterministic"),
];

impl Reader<'_> {
    /// Returns the end of the line that begins at the token `at`, if this line is a directive.
    pub(super) fn line_of_directive(&self, at: usize) -> Option<usize> {
        if at >= self.given.len() || !self.begins_line(at) {
            return None;
        }
        let is_argument = |at: usize| {
            !self.begins_line(at)
                && matches!(self.given[at].0.kind, TokenKind::Identifier | TokenKind::Literal)
        };
        let is_word = |(word, _): &(&str, &str)| *word == self.at(at) && is_argument(at + 1);
        let is_algebraic = self.at(at) == "0" && self.at(at + 1) == "=";
        let is_directive = matches!(self.at(at), "@" | "%") || is_algebraic || self.is_array(at);
        (is_directive || REFUSED.iter().any(is_word))
            .then(|| (at + 1..).find(|&end| self.begins_line(end)).expect("the text ends"))
    }

    fn is_array(&self, at: usize) -> bool {
        let is_number =
            |at: usize| self.given.get(at).is_some_and(|(token, _)| token.kind == TokenKind::Literal);
        self.is_name(at) && self.at(at + 1) == "[" && is_number(at + 2) && self.at(at + 3) == "."
    }

    pub(super) fn unsupported_item(&self, tokens: &Range<usize>) -> Option<PlacedToken> {
        let start = tokens.start;
        self.line_of_directive(start)?;
        let word = self.at(start);
        let message = match REFUSED.iter().find(|(known, _)| *known == word) {
            Some((_, reason)) => format!("`{word}` {reason}"),
            None if word == "0" => "`0 =` is an algebraic equation: solve it for one of its names".to_owned(),
            None => {
                let array = self.text[self.bytes(tokens.clone())].split(['\'', '=']).next();
                format!("`{}` makes copies of lines", array.unwrap_or(word).trim_end())
            }
        };
        Some(mistake(&self.bytes(tokens.clone()), message, format!("leave it out, or see {ON_TEXTS}")))
    }

    /// Returns argument names such as those in `(x, y)`, and the index of the next token.
    pub(super) fn argument_names(&self, at: usize) -> Option<(Vec<String>, usize)> {
        let mut names = Vec::new();
        let mut at = at;
        while matches!((names.len(), self.at(at)), (0, "(") | (1.., ",")) && self.is_name(at + 1) {
            names.push(self.at(at + 1).to_owned());
            at += 2;
        }
        (!names.is_empty() && self.at(at) == ")").then_some((names, at + 1))
    }

    /// Returns the names that some tokens use, directly or in functions that they call.
    pub(super) fn used_names(&self, tokens: &Range<usize>) -> HashSet<&str> {
        let (mut found, mut left) = (HashSet::new(), vec![tokens.clone()]);
        while let Some(tokens) = left.pop() {
            for name in self.names_in(tokens) {
                let function = self.functions.get(name).filter(|_| found.insert(name));
                left.extend(function.map(|function| function.right.clone()));
                found.insert(name);
            }
        }
        found
    }

    /// Replaces a function call by the function's formula, or by a token that the parser reports.
    /// Returns the index of the next token; `None` if no call begins at `at`.
    pub(super) fn write_call(
        &mut self,
        at: usize,
        in_equation: bool,
        out: &mut Vec<PlacedToken>,
    ) -> Option<usize> {
        if self.at(at + 1) != "(" || self.arguments.contains_key(self.at(at)) {
            return None;
        }
        let name = self.at(at).to_owned();
        let function = self.functions.get(&name).cloned();
        let reason = CALLS.iter().find(|(known, _)| *known == name).filter(|_| function.is_none());
        if let Some((_, reason)) = reason {
            let help = format!("{ON_TEXTS} says what can be done");
            out.push(mistake(&self.bytes(at..at + 1), format!("`{name}(…)` {reason}"), help));
            return Some(at + 1);
        }
        let Function { arguments, right } = function?;
        let (given, end) = self.call(at + 1)?;
        let range = self.bytes(at..end);
        const TOO_LARGE: &str = "with the formula of this function the field is too large";
        let wrong = if self.added > MOST_TOKENS || self.depth >= MAX_CALL_DEPTH {
            Some(TOO_LARGE.to_owned())
        } else if given.len() != arguments.len() {
            Some(format!("`{name}` has {} arguments, and {} stand here", arguments.len(), given.len()))
        } else if self.calls.contains(&name) {
            Some(format!("`{name}` is defined by itself"))
        } else {
            None
        };
        if let Some(message) = wrong {
            out.push(mistake(&range, message, "write the formula of the function with these arguments"));
            return Some(end);
        }
        self.depth += 1;
        let values = given.into_iter().map(|tokens| self.written(tokens, in_equation)).collect::<Vec<_>>();
        let own: HashMap<_, _> = arguments.into_iter().zip(values).collect();
        let outer = std::mem::replace(&mut self.arguments, own);
        self.calls.push(name);
        let formula = self.written(right, in_equation);
        self.calls.pop();
        self.depth -= 1;
        self.arguments = outer;
        self.added += formula.len();
        if self.added > MOST_TOKENS {
            out.push(mistake(&range, TOO_LARGE, "make it a state, or shorten it"));
            return Some(end);
        }
        out.push(placed_token("(", &range));
        out.extend(formula);
        out.push(placed_token(")", &range));
        Some(end)
    }

    /// Reads the call whose bracket is at `open`; returns its arguments and the next index.
    fn call(&self, open: usize) -> Option<(Vec<Range<usize>>, usize)> {
        let (mut depth, mut start, mut given) = (0, open + 1, Vec::new());
        for at in open..self.given.len() {
            match self.given[at].0.kind {
                TokenKind::Open(_) => depth += 1,
                TokenKind::Close(_) => depth -= 1,
                TokenKind::Punctuation(',') if depth == 1 => {
                    given.push(start..at);
                    start = at + 1;
                }
                _ => {}
            }
            if depth == 0 {
                given.push(start..at);
                return Some((given, at + 1));
            }
        }
        None
    }
}
