//! Splits the text into items, which are equations, values, claims and other statements. The end of
//! a line, or a comma, separates two items only if a new item begins after it. A directive
//! ends with its line.

use std::ops::Range;

use crate::syntax::ClaimKind;
use crate::token::TokenKind;

use super::Reader;
use super::left_side::LeftSide;

pub(super) struct TextItem {
    pub(super) tokens: Range<usize>,
    pub(super) left: Option<LeftSide>,
    pub(super) is_ended: bool,
}

impl Reader<'_> {
    /// Splits the text into items. The word `done` ends the text.
    pub(super) fn items(&self) -> Vec<TextItem> {
        let mut items = Vec::new();
        let mut at = 0;
        while at < self.given.len() && !self.is_done(at) {
            if let Some(end) = self.line_of_directive(at) {
                // A directive has no left side. Options of XPP (lines with `@`) are skipped.
                let left = None;
                items.extend((self.at(at) != "@").then_some(TextItem {
                    tokens: at..end,
                    left,
                    is_ended: false,
                }));
                at = end;
                continue;
            }
            let mut left = self.left_side(at);
            // In `par a=2, b=3` the keyword declares both.
            let is_listed =
                |item: &TextItem| !item.is_ended && item.left.as_ref().is_some_and(|left| left.is_declared);
            if let Some(left) = left.as_mut().filter(|left| left.is_value())
                && !self.begins_line(at)
                && items.last().is_some_and(is_listed)
            {
                left.is_declared = true;
            }
            let brackets = usize::from(left.as_ref().is_some_and(|left| left.is_in_call));
            let end = self.end_of(at, left.as_ref());
            let is_ended = brackets == 0 && self.at(end) == ";";
            items.push(TextItem { tokens: at..end, left, is_ended });
            at = end + brackets + usize::from(matches!(self.at(end + brackets), ";" | ","));
        }
        items
    }

    fn end_of(&self, start: usize, left: Option<&LeftSide>) -> usize {
        let word = self.at(start);
        let is_claim = left.is_none() && (ClaimKind::of_keyword(word).is_some() || word == "hamiltonian");
        let is_next = |at: usize| {
            // In a claim, `a = 1` is a condition after `when`, and begins no new item.
            let is_left =
                |left: LeftSide| !is_claim || left.of.order > 0 || left.is_first || left.is_declared;
            at == self.given.len()
                || self.left_side(at).is_some_and(is_left)
                || self.is_keyword(at)
                || self.line_of_directive(at).is_some()
                || self.is_done(at)
        };
        // Values may be separated by spaces, as in `a=1 b=2`.
        let is_value = left.is_some_and(LeftSide::is_value);
        let in_call = left.is_some_and(|left| left.is_in_call);
        let mut depth = usize::from(in_call);
        for at in left.map_or(start, |left| left.right)..self.given.len() {
            match self.given[at].0.kind {
                TokenKind::Punctuation(';') if depth == 0 => return at,
                TokenKind::Punctuation(',') if depth == 0 && at > start && is_next(at + 1) => return at,
                _ if depth == 0 && at > start && (is_value || self.begins_line(at)) && is_next(at) => {
                    return at;
                }
                TokenKind::Open('{') if depth == 0 && word == "for" => return at + 1,
                TokenKind::Open(_) => depth += 1,
                TokenKind::Close('}') if depth == 0 => return at + usize::from(at == start),
                TokenKind::Close(_) if depth == 1 && in_call => return at,
                TokenKind::Close(bracket) => {
                    depth = depth.saturating_sub(1);
                    let goes_on = matches!(self.at(at + 1), "when" | ";");
                    if depth == 0 && bracket == '}' && left.is_none() && !goes_on {
                        return at + 1;
                    }
                }
                _ => {}
            }
        }
        self.given.len()
    }

    /// Returns whether a token is the first of its line, or the end of the text.
    pub(super) fn begins_line(&self, place: usize) -> bool {
        if place == 0 || place == self.given.len() {
            return true;
        }
        let between = self.given[place - 1].1.end..self.given[place].1.start;
        self.text.get(between).is_some_and(|between| between.contains('\n'))
    }

    fn is_keyword(&self, at: usize) -> bool {
        let is_word =
            |word| matches!(word, "for" | "const" | "hamiltonian") || ClaimKind::of_keyword(word).is_some();
        self.is_name(at + 1) && is_word(self.at(at))
    }

    /// Returns whether `done` ends the text here: alone on its line, or as the last word.
    fn is_done(&self, at: usize) -> bool {
        self.at(at) == "done"
            && self.begins_line(at + 1)
            && (at + 1 == self.given.len() || self.begins_line(at))
    }
}
