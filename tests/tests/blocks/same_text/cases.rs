//! The compile-error cases as data. Comments and strings in the cases must not contain brackets,
//! because blocks are found by matching brackets.

use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

const FOLDER: &str = "macro/tests/compile_errors";

pub(super) struct CompileCase {
    /// The name of the case: `topic`, or `topic/name`.
    pub(super) name: String,
    pub(super) source: String,
    /// The byte range inside the brackets of each `kahan!`, in the order of the file.
    pub(super) blocks: Vec<Range<usize>>,
    pub(super) expected: String,
}

pub(super) fn compile_cases() -> Vec<CompileCase> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(FOLDER);
    let topics = entries(&root);
    let sources =
        topics.into_iter().flat_map(|topic| if topic.is_dir() { entries(&topic) } else { vec![topic] });
    let sources = sources.filter(|path| path.extension().is_some_and(|extension| extension == "rs"));
    sources
        .map(|path| {
            let source = read(&path);
            CompileCase {
                name: path.strip_prefix(&root).unwrap_or(&path).with_extension("").display().to_string(),
                blocks: blocks(&source),
                expected: read(&path.with_extension("stderr")),
                source,
            }
        })
        .collect()
}

impl CompileCase {
    pub(super) fn line_and_column(&self, byte: usize) -> (usize, usize) {
        let before = &self.source[..byte];
        let line = before.rsplit('\n').next().unwrap_or_default();
        (before.matches('\n').count() + 1, line.chars().count() + 1)
    }
}

fn blocks(source: &str) -> Vec<Range<usize>> {
    let starts = source.match_indices("kahan! {").map(|(at, opening)| at + opening.len());
    starts.map(|start| start..start + end_of_group(&source[start..])).collect()
}

fn end_of_group(text: &str) -> usize {
    let mut depth = 1;
    for (place, c) in text.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return place;
        }
    }
    text.len()
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("a readable folder").path()).collect();
    paths.sort();
    paths
}

fn read(path: &Path) -> String {
    fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}
