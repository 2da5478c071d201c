//! The folders of `src` are layers, each of which needs those before it only.
//!
//! Every path that leaves a file is looked at, not only those of `use`: `crate::…` with whatever
//! stands in its braces, and `super::…` as far as it climbs. A name of the root is taken to the
//! folder that `lib.rs` re-exports it from. Tests may need what they like.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// From the bottom to the top. What lies beside the folders are doors, which need all of them and
/// which none of them needs.
const LAYERS: [&str; 8] = ["scalar", "field", "flow", "step", "map", "composition", "ensemble", "scene"];

fn source() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("src")
}

/// A file as code alone: no comments, no tests at its end.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a file of the crate");
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of the crate") {
        let path = entry.expect("an entry").path();
        if path.is_dir() && !path.ends_with("tests") {
            files(&path, found);
        } else if path.extension().is_some_and(|ending| ending == "rs") && !path.ends_with("tests.rs") {
            found.push(path);
        }
    }
}

/// The paths that a tree of `use` or an expression begins with, its braces multiplied out as far as
/// two names.
fn paths(tree: &str) -> Vec<Vec<String>> {
    let tree = tree.trim_start();
    let Some(inside) = tree.strip_prefix('{') else {
        let end = tree.find(|c: char| !(c.is_alphanumeric() || "_*".contains(c))).unwrap_or(tree.len());
        let (name, rest) = tree.split_at(end);
        let rest = rest.trim_start();
        let tails = rest.strip_prefix("::").filter(|tail| !tail.trim_start().starts_with('<')).map(paths);
        let tails = tails.filter(|tails| !tails.is_empty()).unwrap_or_else(|| vec![Vec::new()]);
        return tails.into_iter().map(|tail| [vec![name.to_owned()], tail].concat()).collect();
    };
    let (mut depth, mut start, mut all) = (0, 0, Vec::new());
    for (place, c) in inside.char_indices() {
        match c {
            '{' => depth += 1,
            ',' | '}' if depth == 0 => {
                let part = inside[start..place].trim();
                all.extend(if part.is_empty() { Vec::new() } else { paths(part) });
                start = place + 1;
                if c == '}' {
                    break;
                }
            }
            '}' => depth -= 1,
            _ => {}
        }
    }
    all
}

/// What follows each occurrence of `word` as a whole word.
fn after<'a>(text: &'a str, word: &'a str) -> impl Iterator<Item = &'a str> {
    text.match_indices(word).filter_map(move |(place, _)| {
        let begins = !text[..place].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '$');
        begins.then(|| &text[place + word.len()..])
    })
}

/// From the names of the root to the folders that they come from.
fn exports() -> BTreeMap<String, String> {
    let lib = code(&source().join("lib.rs"));
    let exported = after(&lib, "pub use ").flat_map(paths);
    exported.filter_map(|path| Some((path.last()?.clone(), path.first()?.clone()))).collect()
}

/// Where a path from the root leads: a folder, or what is not one.
fn folder_of<'a>(path: &'a [String], exports: &'a BTreeMap<String, String>) -> &'a str {
    let name = path[0].as_str();
    if LAYERS.contains(&name) { name } else { exports.get(name).map_or(name, String::as_str) }
}

/// The places that a file's paths lead to, each as a path from the root.
fn needs(file: &Path, text: &str) -> Vec<Vec<String>> {
    let module = file.strip_prefix(source()).expect("a file of the crate").with_extension("");
    let mut module: Vec<&str> = module.iter().filter_map(|name| name.to_str()).collect();
    if module.last() == Some(&"mod") {
        module.pop();
    }
    let mut needs: Vec<Vec<String>> =
        ["crate::", "kahan_core::"].iter().flat_map(|root| after(text, root)).flat_map(paths).collect();
    for path in after(text, "super::").flat_map(paths) {
        // Modules within a file only make this climb seem higher than it is.
        let climbed = 1 + path.iter().take_while(|name| *name == "super").count();
        let rest = path.into_iter().skip(climbed - 1);
        let kept = module[..module.len().saturating_sub(climbed)].iter().map(|&name| name.to_owned());
        needs.push(kept.chain(rest).collect());
    }
    needs
}

#[test]
fn a_layer_needs_those_below_it_only() {
    let exports = exports();
    let (mut upward, mut looked_at) = (Vec::new(), 0);
    for (rank, layer) in LAYERS.iter().enumerate() {
        let mut found = Vec::new();
        files(&source().join(layer), &mut found);
        assert!(!found.is_empty(), "no folder {layer}");
        for file in found {
            for path in needs(&file, &code(&file)) {
                let folder = folder_of(&path, &exports);
                looked_at += 1;
                if !LAYERS[..=rank].contains(&folder) {
                    upward.push(format!("{}: {}, of {folder}", file.display(), path.join("::")));
                }
            }
        }
    }
    assert!(upward.is_empty(), "a layer needs what is above it:\n{}", upward.join("\n"));
    assert!(looked_at > 200, "only {looked_at} paths were found");
}

/// `lib.rs` declares the layers in this order, and beside the folders there are doors only.
#[test]
fn the_layers_are_the_folders() {
    let lib = code(&source().join("lib.rs"));
    let declared: Vec<&str> = after(&lib, "mod ").filter_map(|rest| rest.split([';', ' ']).next()).collect();
    assert_eq!(declared[..LAYERS.len()], LAYERS);
    let folders = fs::read_dir(source()).expect("the crate").map(|entry| entry.expect("an entry").path());
    let folders: Vec<PathBuf> = folders.filter(|path| path.is_dir() && !path.ends_with("tests")).collect();
    assert!(folders.iter().all(|path| LAYERS.iter().any(|layer| path.ends_with(layer))), "{folders:?}");
}

#[test]
fn every_way_up_is_found() {
    let exports = exports();
    let ways_up = [
        ("scalar/float.rs", "use crate::Lift;"),
        ("scalar/float.rs", "use crate::{Constant,\n    Lift};"),
        ("scalar/float.rs", "use crate::{field::{linear::solve, QuadraticField}, Constant};"),
        ("scalar/float.rs", "use crate::*;"),
        ("scalar/float.rs", "fn f() { crate::prelude::vector![0.0]; }"),
        ("scalar/dd/mod.rs", "use super::super::map::KahanMap;"),
        ("scalar/dd/traits.rs", "use super::super::super::scene::Scene;"),
        ("step/mod.rs", "impl super::KahanMap for S {}"),
        ("step/mod.rs", "use kahan_core::Orbit;"),
    ];
    for (file, text) in ways_up {
        let file = source().join(file);
        let rank = LAYERS.iter().position(|layer| file.starts_with(source().join(layer))).expect("a layer");
        let is_up = |path: &Vec<String>| !LAYERS[..=rank].contains(&folder_of(path, &exports));
        assert!(needs(&file, text).iter().any(is_up), "{text}");
    }
    let allowed =
        needs(&source().join("map/orbit/mod.rs"), "use super::{KahanMap, at::KahanAt}; use crate::Scalar;");
    assert!(allowed.iter().all(|path| ["map", "scalar"].contains(&folder_of(path, &exports))), "{allowed:?}");
}
