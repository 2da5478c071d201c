//! Tables, labels and matrices that fit the screen.
//!
//! In a wide table, sentences are broken first. If this is not enough, it is split between columns,
//! or each row becomes a list. On a terminal, formulas break before a term. Words and numbers are
//! never broken.

#[cfg(test)]
mod tests;

use std::io::stdout;
use std::iter;
use std::ops::Range;

use kahan_algebra::render::{columns, lines, widths};
use kahan_draw::document::Rows;

const USUAL_WIDTH: usize = 80;
/// Terminals that are narrower are treated as if they had this width.
const LEAST_WIDTH: usize = 20;

pub(crate) fn screen_width() -> usize {
    terminal_width().unwrap_or(USUAL_WIDTH)
}

/// Returns the greatest width of a line: that of the terminal, but at most 100.
pub(crate) fn page_width() -> usize {
    const WIDEST: usize = 100;
    terminal_width().map_or(WIDEST, |width| width.min(WIDEST))
}

pub(crate) fn terminal_width() -> Option<usize> {
    let (terminal_size::Width(width), _) = terminal_size::terminal_size_of(stdout())?;
    Some(usize::from(width).max(LEAST_WIDTH))
}

fn length(text: &str) -> usize {
    text.chars().count()
}

fn longest_word(text: &str) -> usize {
    text.split(' ').map(length).max().unwrap_or(0)
}

fn largest(rows: &[Vec<String>], column: usize, size: fn(&str) -> usize) -> usize {
    rows.iter().filter_map(|row| row.get(column)).map(|cell| size(cell)).max().unwrap_or(0)
}

fn total(widths: &[usize]) -> usize {
    widths.iter().sum::<usize>() + 2 * widths.len().saturating_sub(1)
}

pub(crate) fn with_headings<H: ToString>(
    headings: impl IntoIterator<Item = H>,
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Rows {
    let headings = headings.into_iter().map(|heading| heading.to_string()).collect();
    [headings].into_iter().chain(rows).collect()
}

/// Formats a table whose first row is the heading.
///
/// A table that is too wide is split, and each part repeats the first `keys` columns.
pub(crate) fn table(rows: &[Vec<String>], keys: usize) -> Vec<String> {
    table_within(rows, keys, screen_width())
}

fn table_within(rows: &[Vec<String>], keys: usize, width: usize) -> Vec<String> {
    let natural = widths(rows);
    if total(&natural) <= width {
        return rows.iter().map(|row| columns(row, &natural)).collect();
    }
    let compact = below_heading(rows);
    let half = compact.iter().map(|&width| if width > SENTENCE_WIDTH { width.div_ceil(2) } else { width });
    let half: Vec<usize> = half.collect();
    if let Some(narrower) = narrowed_widths(rows, &half, width) {
        return rows.iter().flat_map(|row| row_within(row, &narrower)).collect();
    }
    let Some(groups) = column_groups(rows, &compact, keys, width) else { return records(rows, width) };
    let parts = groups.into_iter().map(|group| {
        let pick = |row: &Vec<String>| -> Vec<String> {
            (0..keys).chain(group.clone()).filter_map(|column| row.get(column).cloned()).collect()
        };
        let part: Vec<Vec<String>> = rows.iter().map(pick).collect();
        let least = vec![0; part.first().map_or(0, Vec::len)];
        let fitting = narrowed_widths(&part, &least, width).unwrap_or_else(|| widths(&part));
        part.iter().flat_map(|row| row_within(row, &fitting)).collect()
    });
    below_each_other(parts)
}

fn below_each_other(groups: impl IntoIterator<Item = Vec<String>>) -> Vec<String> {
    groups.into_iter().collect::<Vec<_>>().join(&String::new())
}

/// Joins groups of lines into a text, with an empty line between two groups.
pub(crate) fn paragraphs(groups: impl IntoIterator<Item = Vec<String>>) -> String {
    below_each_other(groups).join("\n") + "\n"
}

/// Cells wider than this are regarded as sentences, which may be broken into lines.
const SENTENCE_WIDTH: usize = 24;

/// Returns the width that each column needs if its heading is broken after every word.
fn below_heading(rows: &[Vec<String>]) -> Vec<usize> {
    let Some((heading, rows)) = rows.split_first() else { return Vec::new() };
    let heading = heading.iter().enumerate();
    heading.map(|(column, name)| longest_word(name).max(largest(rows, column, length))).collect()
}

/// Narrows the widest columns until the total is `width`. No column becomes narrower than its
/// longest word, or than its entry in `least`. Returns `None` if the columns stay too wide.
fn narrowed_widths(rows: &[Vec<String>], least: &[usize], width: usize) -> Option<Vec<usize>> {
    let mut narrower = widths(rows);
    let least: Vec<usize> =
        least.iter().enumerate().map(|(k, &least)| largest(rows, k, longest_word).max(least)).collect();
    while total(&narrower) > width {
        let (widest, _) =
            narrower.iter().enumerate().filter(|&(k, &now)| now > least[k]).max_by_key(|&(_, &now)| now)?;
        narrower[widest] -= 1;
    }
    Some(narrower)
}

/// Groups the columns after the first `keys` so that each group fits; `None` if a column does not.
fn column_groups(
    rows: &[Vec<String>],
    natural: &[usize],
    keys: usize,
    width: usize,
) -> Option<Vec<Range<usize>>> {
    let keys_width = total(&natural[..keys.min(natural.len())]);
    let room = width.checked_sub(if keys == 0 { 0 } else { keys_width + 2 })?;
    let others = keys..natural.len();
    others
        .clone()
        .all(|column| largest(rows, column, longest_word) <= room)
        .then(|| side_by_side(others, natural, room))
}

/// Groups columns that fit side by side; each group has at least one column.
fn side_by_side(columns: Range<usize>, widths: &[usize], room: usize) -> Vec<Range<usize>> {
    let mut groups: Vec<Range<usize>> = Vec::new();
    for column in columns {
        match groups.last_mut() {
            Some(group) if total(&widths[group.start..=column]) <= room => group.end = column + 1,
            _ => groups.push(column..column + 1),
        }
    }
    groups
}

/// Formats a row. A cell that is wider than its column takes several lines.
fn row_within(row: &[String], widths: &[usize]) -> Vec<String> {
    let cells: Vec<Vec<String>> = row.iter().zip(widths).map(|(cell, &width)| lines(cell, width)).collect();
    let height = cells.iter().map(Vec::len).max().unwrap_or(0);
    let line = |line: usize| {
        let cells = cells.iter().map(|cell| cell.get(line).cloned().unwrap_or_default());
        columns(&cells.collect::<Vec<_>>(), widths)
    };
    (0..height).map(line).collect()
}

fn records(rows: &[Vec<String>], width: usize) -> Vec<String> {
    let Some((heading, rows)) = rows.split_first() else { return Vec::new() };
    let names = heading.iter().map(|name| length(name)).max().unwrap_or(0).min(width / 2);
    let record = |row: &Vec<String>| {
        let cells = heading.iter().zip(row);
        cells.flat_map(|(name, cell)| labelled_within(name, cell, names, width)).collect()
    };
    below_each_other(rows.iter().map(record))
}

/// Puts a text beside a label of width `room`, or below the label if the text does not fit there.
pub(crate) fn labelled(label: &str, text: &str, room: usize) -> Vec<String> {
    labelled_within(label, text, room, screen_width())
}

fn labelled_within(label: &str, text: &str, room: usize, width: usize) -> Vec<String> {
    let place = width.saturating_sub(room + 2);
    if longest_word(text) > place || length(label) > room && length(label) + 2 + length(text) > width {
        let below = lines(text, width.saturating_sub(2));
        return iter::once(label.to_owned()).chain(below.iter().map(|line| format!("  {line}"))).collect();
    }
    let texts = if length(label) > room { vec![text.to_owned()] } else { lines(text, place) };
    beside_label(label, texts, room)
}

pub(crate) fn beside_label(label: &str, lines: Vec<String>, room: usize) -> Vec<String> {
    let labels = iter::once(label).chain(iter::repeat(""));
    labels.zip(lines).map(|(label, line)| format!("{label:<room$}  {line}").trim_end().to_owned()).collect()
}

/// Breaks a line after commas at `width` characters, and indents the continuation lines.
pub(crate) fn after_commas(line: &str, width: usize) -> String {
    let mut out = String::with_capacity(line.len() + 16);
    let mut taken = 0;
    for cell in line.split_inclusive(',') {
        let length = length(cell.trim_end_matches('\n'));
        if taken > 0 && taken + length > width {
            out.push_str("\n  ");
            taken = 2;
        }
        out.push_str(cell);
        taken += length;
    }
    out
}

/// Formats a matrix between `left` and `right`. A row that is too wide breaks between entries.
pub(crate) fn matrix(rows: &[Vec<String>], left: char, right: char, width: usize) -> Vec<String> {
    const BRACKET_WIDTH: usize = 4;
    let widths = widths(rows);
    let room = width.saturating_sub(BRACKET_WIDTH);
    let groups = side_by_side(0..widths.len(), &widths, room);
    let last = groups.len().saturating_sub(1);
    let mut lines = Vec::new();
    for row in rows {
        for (index, group) in groups.iter().enumerate() {
            let cells: Vec<String> = group
                .clone()
                .filter_map(|column| {
                    let cell = row.get(column)?;
                    let gap = if widths[column] > room { 0 } else { widths[column] - length(cell) };
                    Some(" ".repeat(gap) + cell)
                })
                .collect();
            let before = if index == 0 { left } else { ' ' };
            let after = if index == last { format!(" {right}") } else { String::new() };
            lines.push(format!("{before} {}{after}", cells.join("  ")));
        }
    }
    lines
}
