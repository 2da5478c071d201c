//! Breaks long LaTeX formulas into lines.
//!
//! Sums break before signs, and products between factors. Wide fractions and parentheses break
//! inside, into the lines of an `aligned` environment. Widths are estimated in characters.

mod pieces;
#[cfg(test)]
mod tests;
mod width;

use pieces::{factors, group_insides, split, terms};
pub use width::width_of;

/// The length of a line on a usual page, in characters.
pub const PAGE_WIDTH: usize = 80;

/// Breaks a formula into lines of about `width` characters. A short formula stays unchanged.
#[must_use]
pub fn lines(formula: &str, width: usize) -> Vec<String> {
    if width_of(formula) <= width {
        return vec![formula.to_owned()];
    }
    let mut lines = Vec::new();
    let mut taken = 0;
    for term in terms(formula) {
        let size = width_of(term);
        if size > width {
            lines.extend(factors_in_lines(term, width));
            taken = width;
            continue;
        }
        match lines.last_mut() {
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

/// Returns the formula, as lines of an `aligned` environment if wider than `width` characters.
#[must_use]
pub fn boxed(formula: &str, width: usize) -> String {
    match &lines(formula, width)[..] {
        [one] => one.clone(),
        lines => format!("\\begin{{aligned}}\n& {}\n\\end{{aligned}}", lines.join(" \\\\\n& ")),
    }
}

/// Writes `left = right` as rows of an `aligned` environment. Continuation lines are indented.
#[must_use]
pub fn equation(left: &str, right: &str, width: usize) -> String {
    let room = width.saturating_sub(width_of(left) + 3).max(LEAST_WIDTH);
    format!("{left} &= {}", lines(right, room).join(" \\\\\n&\\quad "))
}

/// Writes a formula, or a relation such as `left = right`, as one displayed formula.
#[must_use]
pub fn display(formula: &str, width: usize) -> String {
    if width_of(formula) <= width {
        return formula.to_owned();
    }
    let sides = split(formula, |rest| RELATIONS.iter().any(|sign| rest.starts_with(sign)));
    let [left, right] = sides[..] else { return boxed(formula, width) };
    let (sign, right) = right.split_once(' ').unwrap_or(("", right));
    let rows = if width_of(left) * 3 <= width {
        let room = width.saturating_sub(width_of(left) + 3);
        format!("{left} &{sign} {}", lines(right, room).join(" \\\\\n&\\quad "))
    } else {
        let left = lines(left, width).join(" \\\\\n&\\quad ");
        let right = lines(right, width.saturating_sub(5)).join(" \\\\\n&\\qquad ");
        format!("& {left} \\\\\n&\\quad {sign} {right}")
    };
    format!("\\begin{{aligned}}\n{rows}\n\\end{{aligned}}")
}

const RELATIONS: [&str; 4] = [" = ", " \\coloneqq ", " \\neq ", " \\approx "];

/// Writes a matrix in the environment `name`, with entries broken to fit `width` characters.
#[must_use]
pub fn matrix(name: &str, rows: &[Vec<String>], width: usize) -> String {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let widths: Vec<usize> = (0..columns)
        .map(|column| rows.iter().filter_map(|row| row.get(column)).map(|cell| width_of(cell)).max())
        .map(Option::unwrap_or_default)
        .collect();
    let allowed = column_shares(&widths, width.saturating_sub(2 * columns));
    let row = |row: &Vec<String>| {
        let cells = row.iter().zip(&allowed).map(|(cell, &allowed)| boxed(cell, allowed));
        cells.collect::<Vec<_>>().join(" & ")
    };
    let rows: Vec<String> = rows.iter().map(row).collect();
    format!("\\begin{{{name}}}\n{}\n\\end{{{name}}}", rows.join(" \\\\\n"))
}

const LEAST_WIDTH: usize = 16;

/// Returns new column widths that add up to `width` if possible. Columns wider than some limit get
/// this limit, and the others keep their width.
fn column_shares(widths: &[usize], width: usize) -> Vec<usize> {
    let mut share = width;
    // The loop ends, because `share` decreases in every pass but the last.
    loop {
        let wide = widths.iter().filter(|&&one| one > share).count();
        let narrow: usize = widths.iter().filter(|&&one| one <= share).sum();
        let next = width.saturating_sub(narrow).checked_div(wide).unwrap_or(share).min(share);
        if next == share {
            return widths.iter().map(|&one| one.min(share.max(LEAST_WIDTH))).collect();
        }
        share = next;
    }
}

fn append(line: &mut String, piece: &str) {
    line.push(' ');
    line.push_str(piece);
}

/// Makes the factors of a wide term narrower, then breaks the term between its factors.
fn factors_in_lines(term: &str, width: usize) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    let mut taken = 0;
    for factor in factors(term) {
        let factor = break_factor(factor, width);
        let size = width_of(&factor);
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

/// Breaks the inside of the fraction or parenthesis in a wide factor.
fn break_factor(factor: &str, width: usize) -> String {
    if width_of(factor) <= width {
        return factor.to_owned();
    }
    let Some(insides) = group_insides(factor) else { return factor.to_owned() };
    let (Some(first), Some(last)) = (insides.first(), insides.last()) else { return factor.to_owned() };
    let around = width_of(&factor[..first.start]) + width_of(&factor[last.end..]);
    let room = width.saturating_sub(around).max(LEAST_WIDTH);
    let mut out = String::new();
    let mut at = 0;
    for inside in &insides {
        out.push_str(&factor[at..inside.start]);
        out.push_str(&boxed(&factor[inside.clone()], room));
        at = inside.end;
    }
    out + &factor[at..]
}
