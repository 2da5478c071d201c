//! Prints a diagnostic with the message, the source line with a caret, and the help.

use std::fmt::Write;
use std::ops::Range;

use kahan_syntax::diagnostics::Diagnostic;

/// Formats a diagnostic about `text` from `origin`. The `ranges` are the byte ranges of the tokens.
#[must_use]
pub fn report(diagnostic: &Diagnostic, text: &str, ranges: &[Range<usize>], origin: &str) -> String {
    let mut out = format!("error: {}\n", diagnostic.message);
    let first_range = range(diagnostic.span.first, text, ranges);
    let last_range = range(diagnostic.span.last, text, ranges);
    let line_start = text[..first_range.start].rfind('\n').map_or(0, |at| at + 1);
    let line_end = text[first_range.start..].find('\n').map_or(text.len(), |at| first_range.start + at);
    let [number, place] = place(diagnostic, text, ranges);
    let (line, column) = (&text[line_start..line_end], place - 1);
    let marked = &text[first_range.start..last_range.end.clamp(first_range.start, line_end)];
    let gutter = number.to_string();
    let (line, column) = shorten(line, column, WIDTH.saturating_sub(gutter.len() + 3));
    let margin = " ".repeat(gutter.len());
    // Tabs are kept, so the caret stands below the right column.
    let indent: String = line.chars().take(column).map(|c| if c == '\t' { '\t' } else { ' ' }).collect();
    let room = line.chars().count().saturating_sub(column).max(1);
    let carets = "^".repeat(marked.chars().count().clamp(1, room));
    let _ = writeln!(out, "{margin}--> {origin}:{number}:{place}");
    let _ = writeln!(out, "{margin} |");
    let _ = writeln!(out, "{gutter} | {line}");
    let _ = writeln!(out, "{margin} | {indent}{carets}");
    if !diagnostic.help.is_empty() {
        let _ = writeln!(out, "help: {}", diagnostic.help);
    }
    out
}

/// Returns the line and the column of the mistake, counted from 1.
#[must_use]
pub fn place(diagnostic: &Diagnostic, text: &str, ranges: &[Range<usize>]) -> [usize; 2] {
    let before = &text[..range(diagnostic.span.first, text, ranges).start];
    let line_start = before.rfind('\n').map_or(0, |at| at + 1);
    [before.matches('\n').count() + 1, before[line_start..].chars().count() + 1]
}

/// Returns the byte range of a token, or of the last token if the index is too large.
fn range(token: usize, text: &str, ranges: &[Range<usize>]) -> Range<usize> {
    let last = ranges.len().saturating_sub(1);
    ranges.get(token.min(last)).cloned().unwrap_or(text.len()..text.len())
}

/// The line with the caret is cut to this many columns.
const WIDTH: usize = 80;

fn shorten(line: &str, column: usize, width: usize) -> (String, usize) {
    let length = line.chars().count();
    if length <= width {
        return (line.to_owned(), column);
    }
    // Two columns are reserved for ellipses, and a third of the others for text before the mistake.
    let kept = width.saturating_sub(2);
    let start = column.saturating_sub(kept / 3).min(length - kept);
    let cut: String = line.chars().skip(start).take(kept).collect();
    let head = if start > 0 { "…" } else { "" };
    let tail = if start + kept < length { "…" } else { "" };
    (format!("{head}{cut}{tail}"), column - start + usize::from(start > 0))
}
