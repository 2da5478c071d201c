//! Formulas and mistakes as people read them: plain text, LaTeX, and source lines with a caret.

mod block;
mod breaking;
mod claim;
mod formula;
mod lines;
mod name;
mod notation;
mod report;

pub use block::macro_block;
pub use breaking::{
    PAGE_WIDTH, latex_box, latex_display, latex_equation, latex_lines, latex_matrix, latex_width,
};
pub use claim::{
    Level, claim_statement, claim_text, condition_note, condition_statement, condition_text, expression_text,
};
pub use formula::{Formulas, MatrixText};
pub use lines::{folded, lines};
pub use notation::Notation;
pub use report::report;
