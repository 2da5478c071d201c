//! Formulas and mistakes as people read them: plain text, LaTeX, and source lines with a caret.

mod block;
mod claim;
mod formula;
mod notation;
mod report;

pub use block::macro_block;
pub use claim::{claim_statement, claim_text, condition_note, condition_statement, condition_text};
pub use formula::{Formulas, MatrixText};
pub use notation::Notation;
pub use report::report;
