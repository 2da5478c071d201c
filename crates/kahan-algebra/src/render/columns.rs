//! Lays out plain text in columns.

/// Returns the width of each column in characters.
#[must_use]
pub fn widths(rows: &[Vec<String>]) -> Vec<usize> {
    let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
    let width =
        |column: usize| rows.iter().filter_map(|row| row.get(column)).map(|cell| cell.chars().count()).max();
    (0..columns).map(|column| width(column).unwrap_or(0)).collect()
}

/// Pads the cells of a row to these widths and joins them with two spaces.
#[must_use]
pub fn columns(row: &[String], widths: &[usize]) -> String {
    let cells = row.iter().zip(widths).map(|(cell, &width)| {
        // Spaces are appended by hand, because a format string limits widths to 65 535.
        cell.clone() + &" ".repeat(width.saturating_sub(cell.chars().count()))
    });
    cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
}

/// Lays out rows in aligned columns.
///
/// ```
/// let rows = [["x", "2"], ["speed", "3"]].map(|row| row.map(str::to_owned).to_vec());
/// assert_eq!(kahan_algebra::render::aligned(&rows), ["x      2", "speed  3"]);
/// ```
#[must_use]
pub fn aligned(rows: &[Vec<String>]) -> Vec<String> {
    let widths = widths(rows);
    rows.iter().map(|row| columns(row, &widths)).collect()
}

/// Cuts a text to at most `width` characters, with `…` in place of the rest.
#[must_use]
pub fn shorten(text: &str, width: usize) -> String {
    if text.chars().count() <= width {
        return text.to_owned();
    }
    let kept: String = text.chars().take(width.saturating_sub(1)).collect();
    format!("{}…", kept.trim_end())
}
