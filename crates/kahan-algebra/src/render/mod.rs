//! Prints formulas as plain text, and mistakes as source lines with a caret.

mod block;
mod claim;
mod columns;
mod expression;
mod formula;
mod lines;
mod notation;
mod report;

pub use block::{block_lines, equation_lines, macro_block};
pub use claim::{claim_statement, claim_text, condition_note, condition_statement, condition_text};
pub use columns::{aligned, columns, shorten, widths};
pub use expression::{Precedence, at_least, expression_text, push_term, written};
pub use formula::{Formulas, MatrixText};
pub use lines::{folded, lines};
pub use notation::{Notation, Text};
pub use report::{place, report};
