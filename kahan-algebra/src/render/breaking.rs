//! Long formulas in LaTeX, broken at their terms to fit a page.
//!
//! In: formulas as this crate writes them (terms between ` + ` and ` - `, factors between spaces). A sum breaks before a sign, a
//! product between its factors; a fraction and a parenthesis break inside, into an `aligned` of their own. Widths are
//! counted in characters of a page, about as an eye would; nothing here is typeset.

use std::ops::Range;

/// The characters of a line of text on a usual page.
pub const PAGE_WIDTH: usize = 80;

/// The formula in lines of about `width` characters; one that fits is left as it is.
#[must_use]
pub fn latex_lines(formula: &str, width: usize) -> Vec<String> {
    if latex_width(formula) <= width {
        return vec![formula.to_owned()];
    }
    let mut lines = Vec::new();
    let mut taken = 0;
    for term in terms(formula) {
        let size = latex_width(term);
        if size > width {
            lines.extend(factors_in_lines(term, width));
            // What follows a broken term begins a line.
            taken = width;
            continue;
        }
        match lines.last_mut() {
            // A sign between terms has a space on either side.
            Some(line) if taken + size + 2 <= width => {
                append(line, term);
                taken += size + 2;
            }
            _ => {
                lines.push(term.to_owned());
                taken = size;
            }
        }
    }
    lines
}

/// The formula as one box of about `width` characters: with several lines where it needs them.
#[must_use]
pub fn latex_box(formula: &str, width: usize) -> String {
    match &latex_lines(formula, width)[..] {
        [one] => one.clone(),
        lines => format!("\\begin{{aligned}}\n& {}\n\\end{{aligned}}", lines.join(" \\\\\n& ")),
    }
}

/// `left = right` as rows of an `aligned`; further lines are indented.
#[must_use]
pub fn latex_equation(left: &str, right: &str, width: usize) -> String {
    let room = width.saturating_sub(latex_width(left) + 3).max(NARROWEST);
    format!("{left} &= {}", latex_lines(right, room).join(" \\\\\n&\\quad "))
}

/// A formula with or without a relation (`left = right`), in as many lines as it needs, as one display.
#[must_use]
pub fn latex_display(formula: &str, width: usize) -> String {
    if latex_width(formula) <= width {
        return formula.to_owned();
    }
    let sides = split(formula, |rest| RELATIONS.iter().any(|sign| rest.starts_with(sign)));
    let [left, right] = sides[..] else { return latex_box(formula, width) };
    let (sign, right) = right.split_once(' ').unwrap_or(("", right));
    let rows = if latex_width(left) * 3 <= width {
        let room = width.saturating_sub(latex_width(left) + 3);
        format!("{left} &{sign} {}", latex_lines(right, room).join(" \\\\\n&\\quad "))
    } else {
        let left = latex_lines(left, width).join(" \\\\\n&\\quad ");
        let right = latex_lines(right, width.saturating_sub(5)).join(" \\\\\n&\\qquad ");
        format!("& {left} \\\\\n&\\quad {sign} {right}")
    };
    format!("\\begin{{aligned}}\n{rows}\n\\end{{aligned}}")
}

/// The signs between the sides of a statement.
const RELATIONS: [&str; 4] = [" = ", " \\coloneqq ", " \\neq ", " \\approx "];

/// A matrix in the environment `name`, with `width` characters for all columns; wide entries have several lines.
#[must_use]
pub fn latex_matrix(name: &str, rows: &[Vec<String>], width: usize) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns)
        .map(|column| rows.iter().filter_map(|row| row.get(column)).map(|cell| latex_width(cell)).max())
        .map(Option::unwrap_or_default)
        .collect();
    let allowed = shares(&widths, width.saturating_sub(2 * columns));
    let row = |row: &Vec<String>| {
        let cells = row.iter().zip(&allowed).map(|(cell, &allowed)| latex_box(cell, allowed));
        cells.collect::<Vec<_>>().join(" & ")
    };
    let rows: Vec<String> = rows.iter().map(row).collect();
    format!("\\begin{{{name}}}\n{}\n\\end{{{name}}}", rows.join(" \\\\\n"))
}

/// Less than this is no room for a formula.
const NARROWEST: usize = 16;

/// What each column may take of a width: those that are narrow what they need, the others equal shares of what is left.
fn shares(widths: &[usize], width: usize) -> Vec<usize> {
    let mut share = width;
    // As the share shrinks, fewer columns are within it: the sequence falls and ends.
    loop {
        let wide = widths.iter().filter(|&&one| one > share).count();
        let narrow: usize = widths.iter().filter(|&&one| one <= share).sum();
        let next = width.saturating_sub(narrow).checked_div(wide).unwrap_or(share).min(share);
        if next == share {
            return widths.iter().map(|&one| one.min(share.max(NARROWEST))).collect();
        }
        share = next;
    }
}

fn append(line: &mut String, piece: &str) {
    line.push(' ');
    line.push_str(piece);
}

/// A term that is too wide, in lines: its factors made narrower and broken between.
fn factors_in_lines(term: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut taken = 0;
    for factor in factors(term) {
        let factor = narrowed(factor, width);
        let size = latex_width(&factor);
        match lines.last_mut() {
            Some(line) if taken + size <= width => append(line, &factor),
            Some(_) => {
                lines.push(format!("\\cdot {factor}"));
                taken = 2;
            }
            None => lines.push(factor),
        }
        taken += size;
    }
    lines
}

/// A factor with the inside of its fraction or parenthesis in several lines, if it is too wide.
fn narrowed(factor: &str, width: usize) -> String {
    if latex_width(factor) <= width {
        return factor.to_owned();
    }
    let Some(insides) = insides(factor) else { return factor.to_owned() };
    let (Some(first), Some(last)) = (insides.first(), insides.last()) else { return factor.to_owned() };
    let around = latex_width(&factor[..first.start]) + latex_width(&factor[last.end..]);
    let room = width.saturating_sub(around).max(NARROWEST);
    let mut out = String::new();
    let mut at = 0;
    for inside in &insides {
        out.push_str(&factor[at..inside.start]);
        out.push_str(&latex_box(&factor[inside.clone()], room));
        at = inside.end;
    }
    out + &factor[at..]
}

/// The arguments of the first fraction at the top, or what the first parentheses there enclose.
fn insides(factor: &str) -> Option<Vec<Range<usize>>> {
    const FRACTION: &str = "\\frac{";
    const OPEN: &str = "\\left(";
    let mut depth = Depth::default();
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

/// Where the group ends whose inside begins at `start`: at its `}` or `\right`.
fn closing(text: &str, start: usize) -> usize {
    let mut depth = Depth::default();
    for (at, _) in text[start..].char_indices() {
        depth.pass(&text[start + at..]);
        if depth.0 < 0 {
            return start + at;
        }
    }
    text.len()
}

/// How deep in groups a place is: braces, `\left … \right`, environments.
#[derive(Default)]
struct Depth(i32, bool);

impl Depth {
    fn is_top(&self) -> bool {
        self.0 == 0
    }

    /// Goes over the character that begins `rest`.
    fn pass(&mut self, rest: &str) {
        if std::mem::take(&mut self.1) {
            // `\{` is a sign, not a group.
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

/// Whether a command with this name begins here, and not one whose name is longer.
fn is_command(rest: &str, name: &str) -> bool {
    rest.strip_prefix(name).is_some_and(|after| !after.starts_with(|c: char| c.is_ascii_alphabetic()))
}

/// The terms of a sum, each but the first with its sign in front.
fn terms(formula: &str) -> Vec<&str> {
    split(formula, |rest| rest.starts_with(" + ") || rest.starts_with(" - "))
}

/// The factors of a product, the first with its sign.
fn factors(term: &str) -> Vec<&str> {
    let glued = |before: &str, rest: &str| {
        // What an accent or a function applies to, a point and what it multiplies, a space that is written out.
        let last = before.rsplit(' ').next().unwrap_or_default();
        matches!(last, "+" | "-" | "\\cdot" | "\\,")
            || last.starts_with("\\operatorname")
            || rest.starts_with(" {")
            || rest.starts_with(" \\,")
    };
    let mut pieces: Vec<&str> = Vec::new();
    let mut start = 0;
    let mut depth = Depth::default();
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

fn split(text: &str, begins: impl Fn(&str) -> bool) -> Vec<&str> {
    let mut pieces = Vec::new();
    let mut start = 0;
    let mut depth = Depth::default();
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

/// About how many characters wide a formula is when it is set.
#[must_use]
pub fn latex_width(formula: &str) -> usize {
    let mut width = 0;
    let mut at = 0;
    while let Some(c) = formula[at..].chars().next() {
        let rest = &formula[at..];
        let (size, taken) = match c {
            '\\' => command(rest),
            // Signs between terms have space on both sides.
            '+' | '-' | '=' if rest[1..].starts_with(' ') && at > 0 => (3, 1),
            ' ' | '{' | '}' | '&' | '^' | '_' | '\n' => (0, c.len_utf8()),
            _ => (1, c.len_utf8()),
        };
        width += size;
        at += taken;
    }
    width
}

/// The width of a command with its arguments, where these are not in a line, and how many bytes it has.
fn command(rest: &str) -> (usize, usize) {
    let letters = rest[1..].find(|c: char| !c.is_ascii_alphabetic()).map_or(rest.len(), |end| end + 1);
    let name = &rest[..letters];
    match name {
        "\\" => {
            // `\{` is one character, `\,` a narrow space, `\\` the end of a line.
            let sign = rest[1..].chars().next().map_or(0, char::len_utf8);
            (usize::from(!rest.starts_with("\\,") && !rest.starts_with("\\\\")), 1 + sign)
        }
        "\\frac" => {
            let above = letters + 1..closing(rest, letters + 1);
            let below = (above.end + 2).min(rest.len());
            let below = below..closing(rest, below);
            let size = latex_width(&rest[above]).max(latex_width(&rest[below.clone()]));
            (size, (below.end + 1).min(rest.len()))
        }
        "\\begin" => {
            let named = rest.find('}').map_or(rest.len(), |end| end + 1);
            let end = closing(rest, named);
            let size = rest[named..end].split("\\\\").map(latex_width).max().unwrap_or(0);
            (size, rest[end..].find('}').map_or(rest.len(), |brace| end + brace + 1))
        }
        "\\left" | "\\right" | "\\mathit" | "\\mathrm" | "\\text" | "\\operatorname" | "\\widetilde"
        | "\\dot" | "\\widehat" | "\\displaystyle" => (0, letters),
        "\\quad" | "\\qquad" | "\\coloneqq" => (2, letters),
        _ => (1, letters),
    }
}

#[cfg(test)]
mod tests {
    use super::{latex_box, latex_display, latex_equation, latex_lines, latex_matrix, latex_width};

    #[test]
    fn widths_are_about_what_the_eye_sees() {
        for (formula, width) in [
            ("x", 1),
            ("\\varepsilon x_{12}^{2}", 5),
            ("a + b", 5),
            ("-a", 2),
            ("\\frac{a + b}{c}", 5),
            ("\\left(a + b\\right)^{2}", 8),
            ("\\mathit{al}", 2),
            ("\\begin{aligned} & a + b \\\\ & c \\end{aligned} d", 6),
            ("\\{x,y\\}", 5),
        ] {
            assert_eq!(latex_width(formula), width, "{formula}");
        }
    }

    #[test]
    fn sums_break_before_a_sign_and_products_between_factors() {
        assert_eq!(latex_lines("a + b - c + d", 8), ["a + b", "- c + d"]);
        assert_eq!(latex_lines("aaaa bbbb cccc", 9), ["aaaa bbbb", "\\cdot cccc"]);
        assert_eq!(latex_lines("\\dot {x} y", 1), ["\\dot {x}", "\\cdot y"]);
        assert_eq!(latex_lines("a + b", 5), ["a + b"]);
    }

    #[test]
    fn fractions_and_parentheses_break_inside() {
        let sum = ["aaaaaaaa"; 4].join(" + ");
        let two = "\\begin{aligned}\n& aaaaaaaa + aaaaaaaa \\\\\n& + aaaaaaaa + aaaaaaaa\n\\end{aligned}";
        assert_eq!(latex_box(&sum, 24), two);
        assert_eq!(
            latex_lines(&format!("x + 2\\varepsilon\\,\\frac{{{sum}}}{{b}}"), 26),
            ["x".to_owned(), format!("+ 2\\varepsilon\\,\\frac{{{two}}}{{b}}")]
        );
        assert_eq!(
            latex_lines(&format!("b \\left({sum}\\right)^{{2}}"), 23),
            ["b".to_owned(), format!("\\cdot \\left({two}\\right)^{{2}}")]
        );
    }

    #[test]
    fn statements_break_at_their_relation() {
        let sum = ["aaaaaaaa"; 4].join(" + ");
        assert_eq!(latex_display("a = b", 10), "a = b");
        assert_eq!(
            latex_display(&format!("f = {sum}"), 25),
            "\\begin{aligned}\nf &= aaaaaaaa + aaaaaaaa \\\\\n&\\quad + aaaaaaaa + aaaaaaaa\n\\end{aligned}"
        );
        assert_eq!(
            latex_display(&format!("{sum} \\neq 0"), 28),
            "\\begin{aligned}\n& aaaaaaaa + aaaaaaaa \\\\\n&\\quad + aaaaaaaa + aaaaaaaa \\\\\n&\\quad \\neq 0\n\\end{aligned}"
        );
        assert!(latex_width(&latex_display(&sum, 25)) <= 25);
    }

    #[test]
    fn equations_and_matrices_stay_within_the_width() {
        let sum = ["aaaaaaaa"; 6].join(" - ");
        let equation = latex_equation("\\dot{x}", &sum, 40);
        assert_eq!(equation.matches("\\\\\n&\\quad - ").count(), 1, "{equation}");
        let rows = vec![vec!["1".to_owned(), sum.clone()], vec![sum, "0".to_owned()]];
        let matrix = latex_matrix("pmatrix", &rows, 60);
        assert!(latex_width(&matrix) <= 60, "{matrix}");
        assert_eq!(matrix.matches("\\begin{aligned}").count(), 2);
    }
}
