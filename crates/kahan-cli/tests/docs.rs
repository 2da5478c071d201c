//! Tests the examples in the README and in the book in `docs/`.
//!
//! `console` blocks are run, `sh` blocks are not. `TRYCMD=overwrite docs/check` updates the texts.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use serde_json::Value;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2).expect("a workspace")
}

/// Returns the README and the pages of the book, relative to the root.
fn pages() -> Vec<PathBuf> {
    let mut pages = vec![PathBuf::from("README.md")];
    let mut folders = vec![PathBuf::from("docs")];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(root().join(&folder)).expect("a folder of ours") {
            let path = folder.join(entry.expect("an entry").file_name());
            if root().join(&path).is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "md") {
                pages.push(path);
            }
        }
    }
    pages
}

fn read(path: &Path) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

#[test]
#[ignore = "`docs/check` runs it with the release binary"]
fn the_examples_print_what_stands_in_them() {
    let command = PathBuf::from(env::var_os("KAHAN").expect("`docs/check` says where the command is"));
    let folder = tempfile::tempdir().expect("a folder");
    env::set_current_dir(&folder).expect("a folder of ours");
    fs::write("starts.csv", "x,y\n0.5,0.5\n1/3,1\n").expect("a folder of ours");
    let cases = trycmd::TestCases::new();
    cases.register_bin("kahan", command.as_path());
    for page in pages() {
        cases.case(root().join(page));
    }
    cases.run();
}

/// Unknown kinds of blocks fail the test, so that no example is skipped by mistake.
#[test]
fn every_block_is_of_a_known_kind() {
    let doctests = read(Path::new("tests/src/readmes.rs"));
    for page in pages() {
        let text = read(&page);
        let fences = text.lines().filter_map(|line| line.strip_prefix("```"));
        for kind in fences.step_by(2) {
            let known = ["console", "python", "rust", "sh", "text", "toml"].contains(&kind);
            assert!(known, "{}: a block of kind {kind:?}", page.display());
            let is_tested = doctests.contains(&format!("../../{}\"", page.display()));
            assert!(kind != "rust" || is_tested, "{} is not in tests/src/readmes.rs", page.display());
        }
    }
}

#[test]
fn every_command_has_its_help_in_the_reference() {
    let help = Command::new(env!("CARGO_BIN_EXE_kahan")).arg("--help").output().expect("the command runs");
    let help = String::from_utf8(help.stdout).expect("UTF-8");
    let reference = read(Path::new("docs/reference/commands.md"));
    let list = help.split_once("\n\nOptions:").expect("the options").0;
    let names = list.lines().filter_map(|line| line.strip_prefix("  ")?.split(' ').next());
    let names: Vec<&str> = names.collect();
    assert!(names.len() > 15, "{names:?}");
    for name in names {
        assert!(reference.contains(&format!("\n$ kahan help {name}\n")), "{name}");
    }
}

#[test]
fn the_objects_have_the_members_that_the_reference_lists() {
    let reference = read(Path::new("docs/reference/commands.md"));
    let mut count = 0;
    for row in reference.lines().filter(|line| line.starts_with("| `kahan ")) {
        let mut code = row.split('`').skip(1).step_by(2);
        let call = code.next().and_then(|call| call.strip_prefix("kahan ")).expect("a call");
        let output = Command::new(env!("CARGO_BIN_EXE_kahan")).args(call.split(' ')).output();
        let object: Value =
            serde_json::from_slice(&output.expect("the command runs").stdout).expect("an object");
        let members: Vec<&str> = object.as_object().expect("an object").keys().map(String::as_str).collect();
        assert_eq!(code.collect::<Vec<_>>(), members, "{call}");
        count += 1;
    }
    assert!(count > 10, "{count} calls");
}

#[test]
fn the_summary_names_every_page() {
    let summary = read(Path::new("docs/SUMMARY.md"));
    for page in pages().iter().filter_map(|page| page.strip_prefix("docs").ok()) {
        let is_named = summary.contains(&format!("]({})", page.display()));
        assert!(is_named || page.ends_with("SUMMARY.md"), "{}", page.display());
    }
}
