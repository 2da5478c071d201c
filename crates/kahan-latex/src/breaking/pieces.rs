//! Splits LaTeX formulas outside of all braces, parentheses and environments.

use std::ops::Range;

/// If a fraction comes first in a factor, returns the ranges of numerator and denominator. If
/// parentheses come first, returns the range inside them.
pub(super) fn group_insides(factor: &str) -> Option<Vec<Range<usize>>> {
    const FRACTION: &str = "\\frac{";
    const OPEN: &str = "\\left(";
    let mut depth = NestingDepth::default();
    for (at, _) in factor.char_indices() {
        let is_top = depth.is_top();
        depth.pass(&factor[at..]);
        if !is_top {
            continue;
        }
        if factor[at..].starts_with(FRACTION) {
            let above = at + FRACTION.len()..closing(factor, at + FRACTION.len());
            let below = above.end + 2;
            return Some(vec![above, below..closing(factor, below)]);
        }
        if factor[at..].starts_with(OPEN) {
            let start = at + OPEN.len();
            return Some(std::iter::once(start..closing(factor, start)).collect());
        }
    }
    None
}

/// Returns the position of the `}` or `\right` that ends the group whose contents begin at `start`.
pub(super) fn closing(text: &str, start: usize) -> usize {
    let mut depth = NestingDepth::default();
    for (at, _) in text[start..].char_indices() {
        depth.pass(&text[start + at..]);
        if depth.0 < 0 {
            return start + at;
        }
    }
    text.len()
}

/// The number of open braces, `\left` and environments, and whether the next character is escaped.
#[derive(Default)]
struct NestingDepth(i32, bool);

impl NestingDepth {
    fn is_top(&self) -> bool {
        self.0 == 0
    }

    /// Updates the depth by the first character of `rest`.
    fn pass(&mut self, rest: &str) {
        if std::mem::take(&mut self.1) {
            return;
        }
        self.1 = rest.starts_with("\\{") || rest.starts_with("\\}") || rest.starts_with("\\\\");
        if rest.starts_with('{') || is_command(rest, "\\left") || is_command(rest, "\\begin") {
            self.0 += 1;
        }
        if rest.starts_with('}') || is_command(rest, "\\right") || is_command(rest, "\\end") {
            self.0 -= 1;
        }
    }
}

/// Returns whether `rest` begins with a command of exactly this name.
fn is_command(rest: &str, name: &str) -> bool {
    rest.strip_prefix(name).is_some_and(|after| !after.starts_with(|c: char| c.is_ascii_alphabetic()))
}

/// Returns the terms of a sum. Each later term keeps its sign.
pub(super) fn terms(formula: &str) -> Vec<&str> {
    split(formula, |rest| rest.starts_with(" + ") || rest.starts_with(" - "))
}

/// Returns the factors of a product. The first factor keeps its sign.
pub(super) fn factors(term: &str) -> Vec<&str> {
    let glued = |before: &str, rest: &str| {
        // No break separates an accent, a function or `\cdot` from the next factor.
        let last = before.rsplit(' ').next().unwrap_or_default();
        matches!(last, "+" | "-" | "\\cdot" | "\\,")
            || last.starts_with("\\operatorname")
            || rest.starts_with(" {")
            || rest.starts_with(" \\,")
    };
    let mut pieces: Vec<&str> = Vec::new();
    let mut start = 0;
    let mut depth = NestingDepth::default();
    for (at, c) in term.char_indices() {
        if c == ' ' && depth.is_top() && !glued(&term[start..at], &term[at..]) {
            pieces.push(&term[start..at]);
            start = at + 1;
        }
        depth.pass(&term[at..]);
    }
    pieces.push(&term[start..]);
    pieces
}

pub(super) fn split(text: &str, begins: impl Fn(&str) -> bool) -> Vec<&str> {
    let mut pieces = Vec::new();
    let mut start = 0;
    let mut depth = NestingDepth::default();
    for (at, c) in text.char_indices() {
        if c == ' ' && depth.is_top() && at > 0 && begins(&text[at..]) {
            pieces.push(&text[start..at]);
            start = at + 1;
        }
        depth.pass(&text[at..]);
    }
    pieces.push(&text[start..]);
    pieces
}
