//! Tests the folders that `kahan atlas` cannot use, and its help.

use std::fs;
use std::path::Path;

use crate::running::kahan;

fn refused(out: &Path) -> String {
    let output = kahan(&["atlas", "--out", &out.display().to_string()]);
    assert_eq!(output.status.code(), Some(2), "{output:?}");
    assert!(output.stdout.is_empty());
    String::from_utf8(output.stderr).expect("text")
}

#[test]
fn a_folder_that_cannot_be_used_is_refused_at_once_and_nothing_is_left_behind() {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("file");
    fs::write(&file, "kept").expect("a file");
    assert!(refused(&file).contains("it is a file"));
    assert!(refused(&file.join("below")).contains("cannot use the folder"));
    assert_eq!(fs::read_to_string(&file).expect("the file"), "kept");

    let taken = folder.path().join("taken");
    fs::create_dir_all(taken.join("index.html")).expect("a folder");
    assert!(refused(&taken).contains("it is a directory"));
    assert_eq!(fs::read_dir(&taken).expect("a folder").count(), 1, "something else was left there");
}

#[test]
fn the_command_explains_itself() {
    let help = kahan(&["atlas", "--help"]);
    let text = String::from_utf8(help.stdout).expect("text");
    assert!(help.status.success() && text.contains("Examples:") && text.contains("--out"), "{text}");
    assert_eq!(kahan(&["atlas"]).status.code(), Some(2));
}
