//! Files of numbers behind options: where they lie, and why they cannot be read.

use std::fs;
use std::path::Path;

use kahan_study::number_file::{Entry, Numbers};

use crate::printing::Refusal;

/// Whether a text names such a file.
pub(crate) fn is_number_file(text: &str) -> bool {
    let ending = Path::new(text).extension().and_then(|ending| ending.to_str());
    ending.is_some_and(|ending| ending == "npy" || ending == "csv")
}

/// Reads a file; `option` names it in the refusal.
pub(super) fn read<V: Entry>(path: &str, option: &str) -> Result<Numbers<V>, Refusal> {
    let refused = |why: String| Refusal::new(format!("{option}: cannot read the file {path}: {why}"));
    let bytes = fs::read(path).map_err(|error| refused(error.to_string()))?;
    Numbers::of(path, &bytes).map_err(refused)
}
