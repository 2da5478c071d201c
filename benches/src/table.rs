//! Writes tables in Markdown, aligned so that they are readable as text.

use std::fmt;

/// Rows of text under headings. The first column is left-aligned, and the others are right-aligned.
pub(crate) struct Table {
    pub(crate) head: Vec<String>,
    pub(crate) rows: Vec<Vec<String>>,
}

impl Table {
    pub(crate) fn new(head: &[&str]) -> Self {
        Self { head: head.iter().map(|&title| title.to_owned()).collect(), rows: Vec::new() }
    }

    /// Adds a row. Panics unless the row has a cell for each column.
    pub(crate) fn push(&mut self, row: Vec<String>) {
        assert_eq!(row.len(), self.head.len(), "a row of {row:?}");
        self.rows.push(row);
    }
}

impl fmt::Display for Table {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let width = |column: usize| {
            let cells = std::iter::once(&self.head).chain(&self.rows);
            cells.map(|row| row[column].chars().count()).max().unwrap_or(0).max(3)
        };
        let widths: Vec<usize> = (0..self.head.len()).map(width).collect();
        let line = |f: &mut fmt::Formatter<'_>, row: &[String]| {
            for (column, (cell, &width)) in row.iter().zip(&widths).enumerate() {
                match column {
                    0 => write!(f, "| {cell:<width$} ")?,
                    _ => write!(f, "| {cell:>width$} ")?,
                }
            }
            writeln!(f, "|")
        };
        line(f, &self.head)?;
        for (column, &width) in widths.iter().enumerate() {
            write!(f, "|{:-<width$}{}", "", if column == 0 { "--" } else { "-:" })?;
        }
        writeln!(f, "|")?;
        self.rows.iter().try_for_each(|row| line(f, row))
    }
}

pub(crate) fn short(value: Option<f64>) -> String {
    match value {
        None => "–".to_owned(),
        Some(value) if !value.is_finite() => value.to_string(),
        Some(value) => {
            let digits = 2 - (value.abs().max(1e-9).log10().floor() as i32);
            format!("{value:.*}", digits.clamp(0, 9) as usize)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_is_markdown_with_aligned_columns() {
        let mut table = Table::new(&["who", "time"]);
        table.push(vec!["a".to_owned(), short(Some(12.345))]);
        table.push(vec!["long name".to_owned(), short(None)]);
        let text = "| who       | time |\n|-----------|-----:|\n| a         | 12.3 |\n| long name |    – |\n";
        assert_eq!(table.to_string(), text);
    }

    #[test]
    fn three_digits() {
        let text = [1234.5, 99.96, 9.5, 1.0, 0.01234].map(|value| short(Some(value)));
        assert_eq!(text, ["1234", "100.0", "9.50", "1.00", "0.0123"]);
    }
}
