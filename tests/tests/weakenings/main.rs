//! Mutation tests of code whose correctness is proved in comments. A weakening is a deliberate
//! mistake, which must make a test fail.
//!
//! `cargo test -p kahan-tests --test weakenings -- --ignored --nocapture every` tries all
//! weakenings in about twenty minutes, on a copy of the workspace in the target folder. With
//! `change` instead of `every`, it tries the weakenings of files changed since KAHAN_BASE, and four
//! weakenings of other files. KAHAN_WEAKENING=WORDS selects weakenings by name or file.

#![cfg(unix)]

mod list;
mod machine_code;
mod orbits;

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::os::unix::process::CommandExt;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use kahan_tests::sources::root;
use list::{WEAKENINGS, Weakening};
use machine_code::MACHINE_CODE;
use orbits::ORBITS;

const MINUTES: u64 = 1;

/// The number of weakenings that are tried in files that have not changed since `KAHAN_BASE`.
const OTHERS: usize = 4;

fn every() -> impl Iterator<Item = &'static Weakening> {
    WEAKENINGS.iter().chain(MACHINE_CODE).chain(ORBITS)
}

fn builds() -> PathBuf {
    let program = std::env::current_exe().expect("a program has a path");
    program.ancestors().nth(2).expect("it stands in target/debug/deps").to_owned()
}

fn folder() -> PathBuf {
    builds().with_file_name("weakenings").join("workspace")
}

/// Returns the folder for builds of the copy, apart from builds of the original crates.
fn target() -> PathBuf {
    folder().with_file_name("target")
}

fn copy_workspace() {
    let (made, found) = (folder(), folder().is_dir());
    let made = made.parent().expect("it was joined");
    if found {
        return update(root(), &folder());
    }
    // Rename the finished copy last, so that an interrupted copy is not used.
    let begun = made.with_extension("begun");
    let builds = builds();
    copy(root(), &begun.join("workspace"), &|path| !is_left_out(path));
    let (from, to) = (builds.as_path(), begun.join("target").join("debug"));
    copy(&from.join("deps"), &to.join("deps"), &|path| {
        path.extension().is_some_and(|kind| ["d", "rlib", "rmeta", "so"].iter().any(|known| kind == *known))
    });
    for name in [".fingerprint", "build"] {
        copy(&from.join(name), &to.join(name), &|_| true);
    }
    fs::rename(begun, made).expect("a folder can be renamed");
}

fn is_left_out(path: &Path) -> bool {
    path.file_name().is_some_and(|name| name == "target" || name == ".git")
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).expect("a folder can be read");
    entries.map(|entry| entry.expect("an entry").path()).collect()
}

fn copy(from: &Path, to: &Path, is_copied: &dyn Fn(&Path) -> bool) {
    fs::create_dir_all(to).expect("a folder can be made");
    for path in entries(from).into_iter().filter(|path| is_copied(path)) {
        let copied = to.join(path.file_name().expect("a name"));
        if path.is_dir() {
            copy(&path, &copied, is_copied);
        } else {
            fs::copy(&path, &copied).expect("a file can be copied");
            let time = path.metadata().and_then(|about| about.modified()).expect("a file has a time");
            let file = fs::File::options().append(true).open(&copied).expect("a copy can be opened");
            file.set_modified(time).expect("times can be set");
        }
    }
}

/// Makes one folder equal to another. Equal files keep their modification times, so that their
/// builds stay valid.
fn update(from: &Path, to: &Path) {
    fs::create_dir_all(to).expect("a folder can be made");
    for path in entries(to) {
        if path.file_name().is_some_and(|name| from.join(name).exists()) {
            continue;
        }
        let removed = if path.is_dir() { fs::remove_dir_all(path) } else { fs::remove_file(path) };
        removed.expect("what is no longer there can be removed");
    }
    for path in entries(from).into_iter().filter(|path| !is_left_out(path)) {
        let copied = to.join(path.file_name().expect("a name"));
        if path.is_dir() {
            update(&path, &copied);
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

/// Runs `cargo test` in the copy. Returns whether it succeeded, or `None` after the deadline.
fn cargo_test(words: &str, only_builds: bool, deadline: Option<Instant>) -> Option<bool> {
    let mut command = Command::new(env!("CARGO"));
    command.arg("test").args(words.split(' ').take_while(|word| *word != "--"));
    if only_builds {
        command.arg("--no-run");
    } else {
        let rest = words.split(' ').skip_while(|word| *word != "--");
        command.args(rest);
    }
    command.current_dir(folder()).env("CARGO_TARGET_DIR", target()).env("CARGO_INCREMENTAL", "1");
    command.stdout(Stdio::null()).stderr(Stdio::null());
    let Some(deadline) = deadline else { return Some(command.status().expect("cargo runs").success()) };
    let mut child = command.process_group(0).spawn().expect("cargo runs");
    loop {
        if let Some(status) = child.try_wait().expect("cargo ends") {
            return Some(status.success());
        }
        if Instant::now() >= deadline {
            end(&mut child);
            return None;
        }
        sleep(Duration::from_millis(50));
    }
}

fn end(cargo: &mut Child) {
    let group = format!("-{}", cargo.id());
    Command::new("kill").args(["-TERM", "--", &group]).status().expect("a group can be ended");
    cargo.wait().expect("it has been ended");
}

fn weakened(weakening: &Weakening) -> Result<String, String> {
    let text = fs::read_to_string(root().join(weakening.file)).map_err(|why| format!("{why}"))?;
    match text.matches(weakening.text).count() {
        1 => Ok(text.replacen(weakening.text, weakening.weaker, 1)),
        count => Err(format!("`{}` stands {count} times in {}", weakening.text, weakening.file)),
    }
}

fn git(words: &[&str]) -> String {
    let output = Command::new("git").args(words).current_dir(root()).output().expect("git runs");
    assert!(output.status.success(), "git {}: {}", words.join(" "), String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("paths and hashes are text").trim().to_owned()
}

/// Returns the weakenings of files changed since `KAHAN_BASE`, and four others.
fn chosen_by_the_change() -> Vec<&'static Weakening> {
    let head = git(&["rev-parse", "HEAD"]);
    let base = std::env::var("KAHAN_BASE").unwrap_or_else(|_| {
        let time: i64 = git(&["log", "-1", "--format=%ct"]).parse().expect("seconds");
        let before = format!("--before={}", time - 12 * 3600);
        git(&["rev-list", "-1", "--first-parent", &before, "HEAD"])
    });
    // Without a base all files are treated as changed.
    let changed = if base.is_empty() { git(&["ls-files"]) } else { git(&["diff", "--name-only", &base]) };
    let changed: BTreeSet<&str> = changed.lines().collect();
    let mut shuffled: Vec<&Weakening> = every().collect();
    shuffled.sort_by_key(|weakening| hash(&head, weakening.name));
    let (of_change, others): (Vec<_>, Vec<_>) =
        shuffled.into_iter().partition(|weakening| changed.contains(weakening.file));
    let tests = others.first().map(|weakening| weakening.tests);
    let others = others.into_iter().filter(|weakening| Some(weakening.tests) == tests).take(OTHERS);
    println!("{} of what changed since {base}, and {OTHERS} others", of_change.len());
    of_change.into_iter().chain(others).collect()
}

fn hash(commit: &str, name: &str) -> u64 {
    let mix = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3);
    commit.bytes().chain(name.bytes()).fold(0xcbf2_9ce4_8422_2325, mix)
}

/// Tries weakenings, grouped by their tests. Panics if a weakening makes no test fail.
fn try_all(chosen: &[&Weakening], deadline: Option<Instant>) {
    copy_workspace();
    // Changes to `kahan-algebra` come last, because each makes cargo recompile most crates.
    let mut chosen = chosen.to_vec();
    chosen.sort_by_key(|weakening| weakening.file.starts_with("crates/kahan-algebra/"));
    let mut commands: Vec<&str> = Vec::new();
    let mut groups: BTreeMap<&str, Vec<&Weakening>> = BTreeMap::new();
    for &weakening in &chosen {
        let group = groups.entry(weakening.tests).or_insert_with(|| {
            commands.push(weakening.tests);
            Vec::new()
        });
        group.push(weakening);
    }
    let (mut tried, mut survivors) = (0, Vec::new());
    'all: for command in commands {
        match cargo_test(command, false, deadline) {
            Some(passes) => assert!(passes, "cargo test {command}: fails as it stands"),
            None => break 'all,
        }
        for weakening in &groups[command] {
            let path = folder().join(weakening.file);
            let whole = fs::read(&path).expect("a file can be read");
            write(&path, weakened(weakening).expect("the weakening has its place").as_bytes());
            let compiles = cargo_test(command, true, deadline);
            let survives =
                compiles.and_then(
                    |compiles| {
                        if compiles { cargo_test(command, false, deadline) } else { Some(false) }
                    },
                );
            write(&path, &whole);
            let verdict = match (compiles, survives) {
                (_, None) | (None, _) => break 'all,
                (Some(false), _) => "does not compile",
                (Some(true), Some(true)) => "survives",
                (Some(true), Some(false)) => "fails",
            };
            println!("{verdict}: {}", weakening.name);
            tried += 1;
            if verdict != "fails" {
                survivors.push(weakening.name);
            }
        }
    }
    println!("{tried} of {} weakenings tried", chosen.len());
    assert!(survivors.is_empty(), "{}", survivors.join("; "));
}

/// Checks in every test run that the text of each weakening occurs in the code.
#[test]
fn every_weakening_has_its_place() {
    let errors: Vec<String> = every().filter_map(|weakening| weakened(weakening).err()).collect();
    assert!(errors.is_empty(), "{}", errors.join("\n"));
    let names: BTreeSet<&str> = every().map(|weakening| weakening.name).collect();
    assert_eq!(names.len(), every().count());
}

#[test]
#[ignore = "compiles parts of the workspace once for each weakening"]
fn every_weakening_fails_a_test() {
    let words = std::env::var("KAHAN_WEAKENING").unwrap_or_default();
    let is_chosen =
        |weakening: &&Weakening| weakening.name.contains(&words) || weakening.file.contains(&words);
    let chosen: Vec<&Weakening> = every().filter(is_chosen).collect();
    try_all(&chosen, None);
}

#[test]
#[ignore = "compiles parts of the workspace once for each weakening"]
fn weakenings_of_a_change_fail_a_test() {
    let deadline = Instant::now() + Duration::from_secs(60 * MINUTES);
    try_all(&chosen_by_the_change(), Some(deadline));
}
