//! Tests that `kahan` without arguments shows how to begin.

use crate::running::{answer, shell, text};

/// Runs the suggested commands except `kahan verify`, which `crates/kahan-paper/tests` covers.
#[test]
fn the_command_alone_shows_lines_that_run() {
    let told = answer(&[]);
    assert!(told.lines().count() <= 12 && told.lines().all(|line| line.chars().count() <= 100), "{told}");
    let folder = tempfile::tempdir().expect("a folder");
    let lines: Vec<&str> = told.lines().filter_map(|line| line.strip_prefix("  ")).collect();
    assert_eq!(lines.len(), 6, "{told}");
    for line in lines.iter().filter(|line| !line.starts_with("kahan verify")) {
        let output = shell(line, folder.path());
        assert!(output.status.success(), "{line}: {}", text(&output.stderr));
    }
    assert!(folder.path().join("o.svg").exists() && folder.path().join("spring/index.html").exists());
}
