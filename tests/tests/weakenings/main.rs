//! What is proved in comments, made weaker line by line: each weakening must fail a test.
//!
//! `cargo test -p kahan-tests --test weakenings -- --ignored --nocapture` copies the workspace
//! into the target folder, puts one weakening after the other into the copy, and runs the
//! tests that its line names. A text that does not stand in its file exactly once is an error, and
//! so is a copy that does not compile, or whose tests fail as it stands. It takes some twenty
//! minutes; with KAHAN_WEAKENING=WORDS in the environment it tries those alone whose names or files
//! hold these words.

mod list;
mod machine_code;
mod orbits;

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

use list::{WEAKENINGS, Weakening};
use machine_code::MACHINE_CODE;
use orbits::ORBITS;

/// All of them.
fn every() -> impl Iterator<Item = &'static Weakening> {
    WEAKENINGS.iter().chain(MACHINE_CODE).chain(ORBITS)
}

/// The workspace.
fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("the crate is part of a workspace").to_owned()
}

/// The folder of the copy, and that of its builds.
fn folders() -> (PathBuf, PathBuf) {
    let folder = root().join("target").join("weakenings");
    (folder.join("workspace"), folder.join("target"))
}

/// Copies a folder; files that are alike stay as they are, so that they are not compiled again.
fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder can be made");
    for entry in fs::read_dir(from).expect("a folder can be read") {
        let path = entry.expect("an entry").path();
        let name = path.file_name().expect("a name");
        if name == "target" || name == ".git" {
            continue;
        }
        let copied = to.join(name);
        if path.is_dir() {
            copy(&path, &copied);
        } else {
            write(&copied, &fs::read(&path).expect("a file can be read"));
        }
    }
}

fn write(path: &Path, bytes: &[u8]) {
    if fs::read(path).ok().as_deref() != Some(bytes) {
        fs::write(path, bytes).expect("a file can be written");
    }
}

/// Runs `cargo test` with these words in the copy; whether it succeeds.
fn cargo_test(words: &str, only_builds: bool) -> bool {
    let (copy, target) = folders();
    let mut command = Command::new(env!("CARGO"));
    command.arg("test").args(words.split(' ').take_while(|word| *word != "--"));
    if only_builds {
        command.arg("--no-run");
    } else {
        let rest = words.split(' ').skip_while(|word| *word != "--");
        command.args(rest);
    }
    command.current_dir(copy).env("CARGO_TARGET_DIR", target);
    command.stdout(Stdio::null()).stderr(Stdio::null());
    command.status().expect("cargo runs").success()
}

/// The file of the copy with the weakening in it.
fn weakened(weakening: &Weakening) -> Result<String, String> {
    let text = fs::read_to_string(root().join(weakening.file)).map_err(|why| format!("{why}"))?;
    match text.matches(weakening.text).count() {
        1 => Ok(text.replacen(weakening.text, weakening.weaker, 1)),
        count => Err(format!("`{}` stands {count} times in {}", weakening.text, weakening.file)),
    }
}

/// Part of every run, so that a change of the code takes its weakenings along.
#[test]
fn every_weakening_has_its_place() {
    let errors: Vec<String> = every().filter_map(|weakening| weakened(weakening).err()).collect();
    assert!(errors.is_empty(), "{}", errors.join("\n"));
    let names: BTreeSet<&str> = every().map(|weakening| weakening.name).collect();
    assert_eq!(names.len(), every().count());
}

#[test]
#[ignore = "compiles the workspace once for each weakening"]
fn every_weakening_fails_a_test() {
    let (folder, _) = folders();
    copy(&root(), &folder);
    let words = std::env::var("KAHAN_WEAKENING").unwrap_or_default();
    let is_chosen =
        |weakening: &&Weakening| weakening.name.contains(&words) || weakening.file.contains(&words);
    let chosen: Vec<&Weakening> = every().filter(is_chosen).collect();
    let commands: BTreeSet<&str> = chosen.iter().map(|weakening| weakening.tests).collect();
    for command in commands {
        assert!(cargo_test(command, false), "cargo test {command}: fails as it stands");
    }
    let mut survivors = Vec::new();
    for weakening in chosen {
        let path = folder.join(weakening.file);
        let whole = fs::read(&path).expect("a file can be read");
        write(&path, weakened(weakening).expect("the weakening has its place").as_bytes());
        let compiles = cargo_test(weakening.tests, true);
        let survives = compiles && cargo_test(weakening.tests, false);
        write(&path, &whole);
        let verdict = match (compiles, survives) {
            (false, _) => "does not compile",
            (true, true) => "survives",
            (true, false) => "fails",
        };
        println!("{verdict}: {}", weakening.name);
        if verdict != "fails" {
            survivors.push(weakening.name);
        }
    }
    assert!(survivors.is_empty(), "{}", survivors.join("; "));
}
