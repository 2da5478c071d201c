//! Estimates the widths of typeset formulas.

use super::pieces::closing;

/// Returns the approximate width of a typeset formula, in characters.
#[must_use]
pub fn width_of(formula: &str) -> usize {
    let mut width = 0;
    let mut at = 0;
    while let Some(c) = formula[at..].chars().next() {
        let rest = &formula[at..];
        let (size, taken) = match c {
            '\\' => command(rest),
            // Signs between terms have a space on both sides, so they are three characters wide.
            '+' | '-' | '=' if rest[1..].starts_with(' ') && at > 0 => (3, 1),
            ' ' | '{' | '}' | '&' | '^' | '_' | '\n' => (0, c.len_utf8()),
            _ => (1, c.len_utf8()),
        };
        width += size;
        at += taken;
    }
    width
}

/// Returns the width of the command at the beginning of `rest`, and its length in bytes.
fn command(rest: &str) -> (usize, usize) {
    let letters = rest[1..].find(|c: char| !c.is_ascii_alphabetic()).map_or(rest.len(), |end| end + 1);
    let name = &rest[..letters];
    match name {
        "\\" => {
            // The commands `\,` and `\\` have no width; other commands such as `\{` have one
            // character.
            let sign = rest[1..].chars().next().map_or(0, char::len_utf8);
            (usize::from(!rest.starts_with("\\,") && !rest.starts_with("\\\\")), 1 + sign)
        }
        "\\frac" => {
            let above = letters + 1..closing(rest, letters + 1);
            let below = (above.end + 2).min(rest.len());
            let below = below..closing(rest, below);
            let size = width_of(&rest[above]).max(width_of(&rest[below.clone()]));
            (size, (below.end + 1).min(rest.len()))
        }
        "\\begin" => {
            let named = rest.find('}').map_or(rest.len(), |end| end + 1);
            let end = closing(rest, named);
            let size = rest[named..end].split("\\\\").map(width_of).max().unwrap_or(0);
            (size, rest[end..].find('}').map_or(rest.len(), |brace| end + brace + 1))
        }
        "\\left" | "\\right" | "\\mathit" | "\\mathrm" | "\\text" | "\\operatorname" | "\\widetilde"
        | "\\dot" | "\\widehat" | "\\displaystyle" => (0, letters),
        "\\quad" | "\\qquad" | "\\coloneqq" => (2, letters),
        _ => (1, letters),
    }
}
