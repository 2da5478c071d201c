//! Tables of words and numbers.

use maud::{Markup, html};

/// A table whose first row are headings, and whose first column says what a row is about.
pub fn rows(caption: &str, rows: &[Vec<String>]) -> Markup {
    let Some((headings, body)) = rows.split_first() else { return html! {} };
    html! {
        div.scroll tabindex="0" {
            table.plain {
                caption { (caption) }
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
