//! Tables of words, numbers and formulas.

use maud::{Markup, Render, html};

/// The rows of a table. The first row holds the headings of the columns. The first cell of every
/// other row is the heading of this row.
pub type Rows = Vec<Vec<String>>;

/// A table that shows an answer or a part of it. Text output omits the caption.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Table {
    /// The caption.
    pub caption: &'static str,
    /// The cells.
    pub rows: Rows,
}

impl Table {
    /// Makes a table of headings and the rows below them.
    #[must_use]
    pub fn new<'a>(
        caption: &'static str,
        headings: impl IntoIterator<Item = &'a str>,
        rows: impl IntoIterator<Item = Vec<String>>,
    ) -> Self {
        let headings = headings.into_iter().map(str::to_owned).collect();
        Table { caption, rows: [headings].into_iter().chain(rows).collect() }
    }
}

impl Render for Table {
    fn render(&self) -> Markup {
        let Some((headings, body)) = self.rows.split_first() else { return html! {} };
        table("plain", None, self.caption, headings, body)
    }
}

/// Writes a table of formulas with an anchor. The first cell of each row is its heading.
pub fn table_of_formulas(
    id: &str,
    caption: &str,
    headings: &[&str],
    rows: impl IntoIterator<Item = Vec<Markup>>,
) -> Markup {
    table("formulas", Some(id), caption, headings, &rows.into_iter().collect::<Vec<_>>())
}

fn table<C: Render>(
    class: &str,
    id: Option<&str>,
    caption: &str,
    headings: &[impl Render],
    rows: &[Vec<C>],
) -> Markup {
    html! {
        div.scroll tabindex="0" {
            table.(class) id=[id] {
                caption { (caption) }
                thead { tr { @for heading in headings { th scope="col" { (heading) } } } }
                tbody {
                    @for row in rows {
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
