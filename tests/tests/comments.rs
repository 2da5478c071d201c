//! Checks rules for comments: their openings, their widths, and the lengths of module heads.
//!
//! A reader meets one comment at a time, so no comment may open with a word such as `It` or
//! `These`. Files that are compared with generated code are exempt.

use std::fs;

use kahan_tests::sources::{root, rust_files};

/// Openings that refer to another comment or postpone the subject.
const OPENINGS: [&str; 14] = [
    "The same", "What", "Such", "As", "It", "So", "Whatever", "Why", "Those", "These", "When", "Where",
    "How", "Who",
];

/// The greatest width of a line of prose, in characters. Tables and examples may be wider.
const WIDTH: usize = 100;

/// The greatest number of lines before the first section, table or example of a module's head.
const HEAD: usize = 8;

/// Returns false for folders with builds, third-party code, or generated code.
fn is_written_here(folder: &str) -> bool {
    !folder.starts_with('.') && !["target", "expected", "golden", "node_modules"].contains(&folder)
}

/// Returns the text of a line that holds nothing but a comment.
fn comment(line: &str) -> Option<&str> {
    let text = line.trim_start().strip_prefix("//")?;
    Some(text.strip_prefix(['/', '!']).unwrap_or(text).trim())
}

/// Returns whether a comment begins with `opening` as whole words.
fn opens_with(text: &str, opening: &str) -> bool {
    text.strip_prefix(opening)
        .is_some_and(|rest| !rest.starts_with(|c: char| c.is_alphanumeric() || c == '_'))
}

/// Returns the violations of the rules in a file. Each has the number of the line and the fault.
fn violations(text: &str, is_root: bool) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let (mut inside, mut example) = (false, false);
    for (number, line) in (1..).zip(text.lines()) {
        let comment = comment(line);
        if let Some(text) = comment {
            let opening = OPENINGS.into_iter().find(|opening| opens_with(text, opening));
            found.extend(
                opening.filter(|_| !inside).map(|opening| (number, format!("opens with {opening:?}"))),
            );
            example ^= text.starts_with("```");
            let width = line.chars().count();
            let is_prose = !example && !text.starts_with('|');
            found.extend((width > WIDTH && is_prose).then(|| (number, format!("{width} characters wide"))));
        }
        inside = comment.is_some();
        example &= inside;
    }
    let head = text.lines().map_while(|line| line.strip_prefix("//!")).map(str::trim);
    let prose = head.take_while(|line| !["#", "|", "```"].iter().any(|other| line.starts_with(other)));
    let lines = prose.filter(|line| !line.is_empty()).count();
    found.extend((lines > HEAD && !is_root).then(|| (1, format!("the module's head has {lines} lines"))));
    found
}

#[test]
fn comments_keep_the_rules() {
    let files = rust_files(root(), is_written_here);
    assert!(files.len() > 1000, "only {} files were found", files.len());
    let shown = files.iter().flat_map(|file| {
        let text = fs::read_to_string(file).expect("a source file");
        let is_root = file.ends_with("lib.rs") || file.ends_with("main.rs");
        let file = file.strip_prefix(root()).expect("a file of the workspace").display();
        violations(&text, is_root).into_iter().map(move |(line, fault)| format!("{file}:{line}: {fault}"))
    });
    let shown: Vec<String> = shown.collect();
    assert!(shown.is_empty(), "{} comments break the rules:\n{}", shown.len(), shown.join("\n"));
}

#[test]
fn every_violation_is_found() {
    let wide = format!("// {}", "a".repeat(WIDTH));
    let head = "//! One line.\n".repeat(HEAD + 1);
    for text in ["/// The same with a point.", "    // It is added.\n", "//! What follows.", &wide, &head] {
        assert_eq!(violations(text, false).len(), 1, "{text}");
    }
    let accepted = [
        "/// Iterates.",
        "// Adds the step\n// So often.",
        "let s = \"// It is\";",
        "//! ```\n//! 1\n//! ```",
    ];
    for text in accepted {
        assert!(violations(text, false).is_empty(), "{text}");
    }
    assert!(violations(&head, true).is_empty());
}
