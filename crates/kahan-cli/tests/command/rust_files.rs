//! Tests `--file` with standard input, and with the blocks of a Rust file.

use std::io::Write;
use std::process::{Command, Stdio};

use crate::running::{answer, refusal, text};

const FILE: &str = r#"//! kahan! { wrong }
use kahan_core::prelude::*;

kahan! {
    pub struct First { a }
    xdot = a*y;
    ydot = -x;
}

mod inner {
    use kahan_core::prelude::*;
    kahan! {
        /// The second system of this file.
        pub struct Second;
        udot = v;
        vdot = u^2;
    }
}

fn main() {
    let field = kahan! { pdot = q; qdot = -p + p^2; };
    // kahan! { pub struct Third; }
    println!("kahan! {{ {:?}", field);
}
"#;

fn file(folder: &tempfile::TempDir, text: &str) -> String {
    let path = folder.path().join("blocks.rs");
    std::fs::write(&path, text).expect("a file");
    path.to_str().expect("text").to_owned()
}

#[test]
fn every_block_of_a_rust_file_can_be_reached() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, FILE);
    let shown = |block: &str| answer(&["show", "--file", &path, "--block", block, "--macro"]);
    for (block, equation) in [
        ("First", "xdot = a*y;"),
        ("Second", "udot = v;"),
        ("field", "qdot = -p + p^2;"),
        ("4", "xdot = a*y;"),
        ("12", "udot = v;"),
        ("21", "pdot = q;"),
    ] {
        assert!(shown(block).contains(equation), "{block}");
    }
    assert_eq!(answer(&["show", "--file", &path, "--struct", "Second", "--macro"]), shown("Second"));
    assert!(answer(&["verify", "--file", &path, "--block", "Second"]).contains("0 claims"));
}

#[test]
fn of_several_blocks_one_must_be_chosen() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, FILE);
    for arguments in [&["show", "--file", &path][..], &["show", "--file", &path, "--block", "Third"]] {
        let said = refusal(arguments);
        for part in ["First (line 4)", "Second (line 12)", "field (line 21)", "--block"] {
            assert!(said.contains(part), "{said}");
        }
    }
    let twice = format!("{FILE}\nmod twin {{ kahan! {{ struct First; sdot = s; }} }}\n");
    let path = file(&folder, &twice);
    assert!(refusal(&["show", "--file", &path, "--block", "First"]).contains("not one block"));
    assert!(answer(&["show", "--file", &path, "--block", "26", "--macro"]).contains("sdot = s;"));
    assert!(refusal(&["show", "e1", "--block", "First"]).contains("--file"));
}

#[test]
fn one_block_needs_no_name_and_mistakes_have_the_lines_of_the_file() {
    let folder = tempfile::tempdir().expect("a folder");
    let path = file(&folder, "fn f() {\n    let field = kahan! {\n        xdot = x^3;\n    };\n}\n");
    assert!(refusal(&["show", "--file", &path]).contains("blocks.rs:3:16"));
    let path = file(&folder, "xdot = y; ydot = x; // kahan! { }\n");
    assert!(answer(&["show", "--file", &path, "--macro"]).contains("ydot = x;"));
    assert!(refusal(&["show", "--file", &path, "--block", "S"]).contains("no call of `kahan!`"));
}

#[test]
fn a_dash_is_standard_input() {
    let run = |text_in: &str, arguments: &[&str]| {
        let mut child = Command::new(env!("CARGO_BIN_EXE_kahan"))
            .args(arguments)
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the command runs");
        child.stdin.take().expect("a pipe").write_all(text_in.as_bytes()).expect("it reads");
        child.wait_with_output().expect("it ends")
    };
    let field = "xdot = y; ydot = -x; integral H = x^2 + y^2;";
    let shown = run(field, &["show", "--file", "-", "--macro"]);
    assert_eq!(text(&shown.stdout), answer(&["show", "--field", field, "--macro"]));
    let verified = run(field, &["verify", "--file", "-", "--mutate"]);
    assert!(text(&verified.stdout).starts_with("1 claim mutated: 1 failed"), "{verified:?}");
    let chosen = run(FILE, &["show", "--file", "-", "--block", "Second", "--macro"]);
    assert!(text(&chosen.stdout).contains("udot = v;"));
    let wrong = run("xdot = x^3;", &["show", "--file", "-"]);
    assert_eq!(wrong.status.code(), Some(2));
    assert!(text(&wrong.stderr).contains("standard input:1:8"), "{}", text(&wrong.stderr));
}
