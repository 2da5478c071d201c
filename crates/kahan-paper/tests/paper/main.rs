//! Tests the paper's claims, and the heights of its figures.

mod claims;
mod heights;

use std::sync::LazyLock;

use kahan_paper::Paper;

fn paper() -> &'static Paper {
    static PAPER: LazyLock<Paper> = LazyLock::new(Paper::new);
    &PAPER
}
