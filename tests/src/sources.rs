//! Finds the source files of the workspace, for tests that read them.

use std::fs;
use std::path::{Path, PathBuf};

/// Returns the folder of the workspace.
#[must_use]
pub fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the crate is part of a workspace")
}

/// Returns the Rust files below a folder, also in subfolders whose names `enter` accepts. Panics if
/// a folder cannot be read.
#[must_use]
pub fn rust_files(folder: &Path, enter: fn(&str) -> bool) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a readable folder") {
            let path = entry.expect("a readable entry").path();
            let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
            if path.is_dir() {
                folders.extend(enter(name).then_some(path));
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}
