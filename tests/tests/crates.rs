//! Compares dependencies of crates with ARCHITECTURE.md, and limits the sizes of builds.

use std::collections::hash_map::DefaultHasher;
use std::collections::{BTreeMap, BTreeSet};
use std::hash::{Hash, Hasher};
use std::mem::replace;
use std::process::Command;
use std::{env, fs};

use kahan_tests::sources::root;
use serde_json::Value;

/// Dependencies of the command, each with the only crates that may use it.
const OF_THE_COMMAND: [(&str, &[&str]); 5] = [
    ("clap", &["kahan-cli"]),
    ("indicatif", &["kahan-cli"]),
    ("tempfile", &["kahan-cli"]),
    ("maud", &["kahan-atlas", "kahan-cli", "kahan-draw"]),
    ("pulldown-latex", &["kahan-draw"]),
];

/// The greatest length of `cargo tree` for the catalog, in lines.
const CATALOG_TREE: usize = 45;

/// The largest number of compilation units that the README's first command may compile.
const FIRST_UNITS: usize = 60;

/// The packages that all programs and the Python wheel must compile identically.
const SHARED: [&str; 4] = ["kahan-core", "kahan-runtime", "kahan-systems", "kahan-paper"];

/// The names of crates whose speed is measured begin with one of these prefixes.
const TIMED: [&str; 6] =
    ["kahan-core", "kahan-dynamics", "kahan-jit", "kahan-study", "kahan-runtime", "kahan-bench"];

type Uses = BTreeMap<String, BTreeSet<String>>;

fn cargo(arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO"))
        .args(arguments)
        .arg("--offline")
        .current_dir(root())
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).expect("cargo writes UTF-8")
}

/// Returns the published crates with their dependencies. Dependencies of tests are left out.
fn of_cargo() -> Uses {
    let text = cargo(&["metadata", "--no-deps", "--format-version", "1"]);
    let metadata: Value = serde_json::from_str(&text).expect("cargo writes JSON");
    let name = |value: &Value| value["name"].as_str().expect("a name").to_owned();
    let packages = metadata["packages"].as_array().expect("packages").iter();
    // An unpublished package has an empty list of registries.
    let published = packages.filter(|package| package["publish"].is_null());
    let crates = published.map(|package| {
        let dependencies = package["dependencies"].as_array().expect("dependencies").iter();
        let used = dependencies.filter(|dependency| dependency["kind"] != "dev");
        (name(package), used.map(name).collect())
    });
    crates.collect()
}

fn cells(row: &str) -> impl Iterator<Item = &str> {
    row.trim_matches('|').split('|').map(str::trim)
}

fn quoted(text: &str) -> impl Iterator<Item = String> {
    text.split('`').skip(1).step_by(2).map(str::to_owned)
}

fn of_the_table() -> Uses {
    let text = fs::read_to_string(root().join("ARCHITECTURE.md")).expect("ARCHITECTURE.md");
    let mut rows = text.lines().skip_while(|line| cells(line).next() != Some("crate"));
    let header = rows.next().expect("a table of crates");
    let may_use = cells(header).position(|cell| cell == "may use").expect("a column of what may be used");
    let rows = rows.skip(1).take_while(|line| line.starts_with('|'));
    let crates = rows.map(|row| {
        let name = quoted(row).next().expect("a crate in the first cell");
        (name, quoted(cells(row).nth(may_use).expect("as many cells as the header has")).collect())
    });
    crates.collect()
}

#[test]
fn crates_use_those_that_architecture_md_names_and_no_others() {
    let (mut uses, table) = (of_cargo(), of_the_table());
    let ours: BTreeSet<String> = uses.keys().cloned().collect();
    for used in uses.values_mut() {
        used.retain(|name| ours.contains(name));
    }
    assert_eq!(uses, table, "what cargo says, and what ARCHITECTURE.md says");
}

#[test]
fn only_the_command_has_the_dependencies_of_a_command() {
    let uses = of_cargo();
    for (name, its_users) in OF_THE_COMMAND {
        let users: Vec<&str> =
            uses.iter().filter(|(_, used)| used.contains(name)).map(|(user, _)| user.as_str()).collect();
        assert_eq!(users, its_users, "{name}");
    }
}

#[test]
fn the_catalog_is_a_light_dependency() {
    let text = cargo(&["tree", "--package", "kahan-systems", "--edges", "normal", "--prefix", "none"]);
    let lines: BTreeSet<&str> = text.lines().collect();
    assert!(lines.len() <= CATALOG_TREE, "{} lines:\n{text}", lines.len());
    for (name, _) in OF_THE_COMMAND {
        assert!(!lines.iter().any(|line| line.split(' ').next() == Some(name)), "{name}:\n{text}");
    }
}

/// Returns each crate whose optimisation level a release or sweep profile sets, and the level.
fn levels(manifest: &str) -> Vec<(String, String)> {
    let text = fs::read_to_string(root().join(manifest)).expect("a manifest");
    let mut section = "";
    let mut found = Vec::new();
    for line in text.lines() {
        if let Some(name) = line.strip_prefix('[') {
            section = name.trim_end_matches(']');
        }
        let of_section = section.strip_prefix("profile.release").or(section.strip_prefix("profile.sweep"));
        let (Some(of_section), Some((key, value))) = (of_section, line.split_once('=')) else { continue };
        if let Some(key) = key.trim().strip_suffix("opt-level") {
            let of_section = of_section.trim_start_matches(".package").trim_matches(['.', '"']);
            let name = if key.is_empty() { of_section } else { key.trim_end_matches('.') };
            let name = if name.is_empty() { "*" } else { name };
            found.push((name.to_owned(), value.trim().to_owned()));
        }
    }
    found
}

fn not_optimised(manifest: &str) -> Vec<String> {
    let levels = levels(manifest).into_iter();
    levels.filter(|(_, level)| level != "3").map(|(name, _)| name).collect()
}

/// Cargo compiles a dependency of the macro and the command twice unless its `opt-level` is set.
#[test]
fn what_the_macro_and_the_command_share_is_compiled_once() {
    let named = levels("Cargo.toml");
    let tree =
        cargo(&["tree", "--package=kahan-algebra", "--all-features", "--edges=normal", "--prefix=none"]);
    let used: BTreeSet<&str> = tree.lines().filter_map(|line| line.split(' ').next()).collect();
    assert!(used.contains("num-bigint") && used.contains("kahan-algebra"), "{tree}");
    for name in used {
        assert!(
            named.iter().any(|(known, _)| known == name),
            "the release profile names no level for {name}"
        );
    }
}

/// Returns the hash of a compilation unit: of its source, its settings, and the units that it uses.
fn hash(units: &[Value], linked: &[bool], index: usize, known: &mut [Option<u64>]) -> u64 {
    if let Some(known) = known[index] {
        return known;
    }
    let unit = &units[index];
    let mut hasher = DefaultHasher::new();
    for key in ["pkg_id", "target", "profile", "platform", "mode", "features"] {
        unit[key].to_string().hash(&mut hasher);
    }
    linked[index].hash(&mut hasher);
    for used in used_by(unit) {
        hash(units, linked, used, known).hash(&mut hasher);
    }
    *known[index].insert(hasher.finish())
}

fn units(call: &[&str]) -> BTreeSet<(String, u64)> {
    let output = Command::new(env!("CARGO"))
        .args(call)
        .args(["--locked", "--unit-graph", "-Z", "unstable-options"])
        // The graph of compilation units is an unstable feature of cargo.
        .env("RUSTC_BOOTSTRAP", "1")
        .current_dir(root())
        .output()
        .expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let graph: Value = serde_json::from_slice(&output.stdout).expect("cargo writes JSON");
    let units = graph["units"].as_array().expect("units");
    let linked = linked(&graph, units);
    let mut known = vec![None; units.len()];
    let name = |unit: &Value| {
        let id = unit["pkg_id"].as_str().expect("an identifier");
        // Cargo identifies a package by a text of the form `…/crates/kahan-core#0.1.0`. If the
        // folder has another name than the crate, it is `…/systems#kahan-systems@0.1.0`.
        let (path, version) = id.split_once('#').expect("a version");
        version.split_once('@').map_or(path.rsplit('/').next().unwrap_or(path), |(name, _)| name).to_owned()
    };
    (0..units.len()).map(|index| (name(&units[index]), hash(units, &linked, index, &mut known))).collect()
}

fn used_by(unit: &Value) -> impl Iterator<Item = usize> {
    let used = unit["dependencies"].as_array().expect("dependencies").iter();
    used.map(|used| used["index"].as_u64().and_then(|index| usize::try_from(index).ok()).expect("an index"))
}

/// Returns for each compilation unit whether a program links it. Others are used by macros and
/// build scripts only, which cargo compiles without link-time optimisation.
fn linked(graph: &Value, units: &[Value]) -> Vec<bool> {
    let mut linked = vec![false; units.len()];
    let mut left: Vec<usize> = graph["roots"]
        .as_array()
        .expect("roots")
        .iter()
        .map(|root| root.as_u64().and_then(|root| usize::try_from(root).ok()).expect("an index"))
        .collect();
    while let Some(index) = left.pop() {
        let kind = units[index]["target"]["kind"][0].as_str();
        if kind != Some("proc-macro") && kind != Some("custom-build") && !replace(&mut linked[index], true) {
            left.extend(used_by(&units[index]));
        }
    }
    linked
}

/// Cargo compiles a crate again for each set of features, so all programs need equal features.
#[test]
fn what_programs_and_the_wheel_share_is_compiled_once() {
    // `cargo run --release` builds one program, with the features of all default members.
    let first = units(&["build", "--release", "--bin=kahan-verify"]);
    assert!(first.len() <= FIRST_UNITS, "{} units: {first:?}", first.len());
    let command = units(&["build", "--release", "--package=kahan-cli"]);
    // maturin builds the wheel by this call.
    let wheel =
        units(&["rustc", "--release", "--package=kahan-python", "--lib", "--features=pyo3/extension-module"]);
    for name in SHARED {
        let of = |units: &BTreeSet<(String, u64)>| -> BTreeSet<u64> {
            units.iter().filter(|(package, _)| package == name).map(|(_, hash)| *hash).collect()
        };
        let one = of(&first);
        assert_eq!(one.len(), 1, "{name}");
        assert_eq!(one, of(&command), "{name} is compiled again for the command");
        assert_eq!(one, of(&wheel), "{name} is compiled again for the wheel");
    }
}

#[test]
fn the_tests_of_the_default_members_are_those_of_the_workspace() {
    let whole = units(&["test", "--workspace"]);
    let others: Vec<_> = units(&["test"]).into_iter().filter(|unit| !whole.contains(unit)).collect();
    assert!(others.is_empty(), "built otherwise with --workspace: {others:?}");
}

#[test]
fn what_is_timed_is_optimised() {
    // The command is not optimised, as it only reads and prints.
    assert!(not_optimised("Cargo.toml").contains(&"kahan-cli".to_owned()));
    for manifest in ["Cargo.toml", "benches/Cargo.toml"] {
        for name in not_optimised(manifest) {
            let is_timed = name == "*" || TIMED.iter().any(|timed| name.starts_with(timed));
            assert!(!is_timed, "{manifest} builds {name} without optimisation, which is timed");
        }
    }
}
