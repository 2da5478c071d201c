//! The claims of the paper, and the heights of its figures beside those of another program.

mod claims;
mod heights;

use std::sync::LazyLock;

use kahan_paper::Paper;

/// One for all tests, since it measures each orbit once.
fn paper() -> &'static Paper {
    static PAPER: LazyLock<Paper> = LazyLock::new(Paper::new);
    &PAPER
}
