//! Tables of words and numbers.

use maud::{Markup, Render, html};

/// The cells of a table, row by row: the first row has the headings of the columns, the first cell
/// of another says what that row is about.
pub type Rows = Vec<Vec<String>>;

/// A table of what an answer says. A page shows it with its caption; text has the rows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// What it is of.
    pub caption: &'static str,
    /// Its cells.
    pub rows: Rows,
}

impl Table {
    /// A table with these headings and rows below them.
    #[must_use]
    pub fn new<const N: usize>(
        caption: &'static str,
        headings: [&str; N],
        rows: impl IntoIterator<Item = Vec<String>>,
    ) -> Self {
        let headings = headings.map(str::to_owned).to_vec();
        Table { caption, rows: [headings].into_iter().chain(rows).collect() }
    }
}

impl Render for Table {
    fn render(&self) -> Markup {
        let Some((headings, body)) = self.rows.split_first() else { return html! {} };
        html! {
            div.scroll tabindex="0" {
                table.plain {
                    caption { (self.caption) }
                    thead { tr { @for heading in headings { th scope="col" { (heading) } } } }
                    tbody {
                        @for row in body {
                            tr {
                                @for (column, cell) in row.iter().enumerate() {
                                    @if column == 0 { th scope="row" { (cell) } } @else { td { (cell) } }
                                }
                            }
                        }
                    }
                }
            }
        }
    }
}
