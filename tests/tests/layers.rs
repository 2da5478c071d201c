//! Tests that the modules of a crate are layers: each uses only earlier modules. Test modules are
//! exempt.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use kahan_tests::sources::{root, rust_files};

/// A crate or module whose folders are layers.
struct Layered {
    folder: &'static str,
    name: &'static str,
    /// The module, and the names in its root file that all layers may use. `None` for a crate.
    module: Option<(&'static str, &'static [&'static str])>,
    /// The names of the layers from bottom to top. No layer may use files that are not listed.
    layers: &'static [&'static str],
}

const CORE: Layered = Layered {
    folder: "kahan-core",
    name: "kahan_core",
    module: None,
    layers: &[
        "scalar",
        "field",
        "step",
        "map",
        "composition",
        "ensemble",
        "dense",
        "supernodes",
        "observe",
        "lattice",
    ],
};

const DYNAMICS: Layered = Layered {
    folder: "crates/kahan-dynamics",
    name: "kahan_dynamics",
    module: None,
    layers: &["flow", "periodic", "scene"],
};

const SYNTAX: Layered = Layered {
    folder: "crates/kahan-syntax",
    name: "kahan_syntax",
    module: None,
    layers: &["rational", "table", "token", "spelling", "lexer", "syntax", "diagnostics", "parse", "lenient"],
};

const ALGEBRA: Layered = Layered {
    folder: "crates/kahan-algebra",
    name: "kahan_algebra",
    module: None,
    layers: &[
        "prime_field",
        "poly",
        "rational_function",
        "symbols",
        "arithmetic",
        "field",
        "kahan",
        "subexpressions",
        "plan",
        "relations",
        "modified_integrals",
        "system",
        "coefficients",
        "variational",
        "elimination",
        "render",
        "family",
        "derived",
        "interpret",
        "specialise",
        "prove",
        "check",
    ],
};

const PLAN: Layered = Layered {
    folder: "crates/kahan-algebra",
    name: "kahan_algebra",
    module: Some(("plan", &[])),
    layers: &[
        "operation",
        "builder",
        "horner",
        "subexpressions",
        "dense",
        "step",
        "descriptions",
        "writing",
        "accuracy",
        "forms",
        "choice",
    ],
};

const ALL: [Layered; 8] = [CORE, DYNAMICS, SYNTAX, ALGEBRA, PLAN, LIFT, DRAW, COMMAND];

const LIFT: Layered = Layered {
    folder: "crates/kahan-lift",
    name: "kahan_lift",
    module: None,
    layers: &[
        "laurent",
        "ring",
        "read",
        "table",
        "search",
        "equations",
        "linear",
        "energy",
        "quadratic",
        "embedding",
        "stability",
        "candidates",
        "choice",
        "names",
        "lift",
        "reembedding",
    ],
};

const COMMAND: Layered = Layered {
    folder: "crates/kahan-cli",
    name: "kahan_cli",
    module: None,
    layers: &["printing", "reading", "commands"],
};

const DRAW: Layered = Layered {
    folder: "crates/kahan-draw",
    name: "kahan_draw",
    module: None,
    layers: &["plot", "picture", "document", "answer"],
};

impl Layered {
    fn source(&self) -> PathBuf {
        root().join(self.folder).join("src").join(self.module.map_or("", |(module, _)| module))
    }

    fn root_file(&self) -> PathBuf {
        self.source().join(if self.module.is_some() { "mod.rs" } else { "lib.rs" })
    }

    fn exports(&self) -> BTreeMap<String, String> {
        let lib = code(&self.root_file());
        let exported = after(&lib, "pub use ").flat_map(paths);
        exported.filter_map(|path| Some((path.last()?.clone(), path.first()?.clone()))).collect()
    }

    fn files(&self, layer: &str) -> Vec<PathBuf> {
        let folder = self.source().join(layer);
        let mut found =
            if folder.exists() { rust_files(&folder, |name| name != "tests") } else { Vec::new() };
        found.retain(|file| !file.ends_with("tests.rs"));
        found.extend(Some(self.source().join(layer).with_extension("rs")).filter(|file| file.exists()));
        found
    }

    /// Returns the modules that a file uses, as paths from the crate's root or the layered module.
    fn needs(&self, file: &Path, text: &str) -> Vec<Vec<String>> {
        let module = file.strip_prefix(self.source()).expect("a file of the crate").with_extension("");
        let outer = self.module.map(|(module, _)| module);
        let mut module: Vec<&str> =
            outer.into_iter().chain(module.iter().filter_map(|name| name.to_str())).collect();
        if module.last() == Some(&"mod") {
            module.pop();
        }
        let own = format!("{}::", self.name);
        let mut needs: Vec<Vec<String>> =
            ["crate::", &own].iter().flat_map(|root| after(text, root)).flat_map(paths).collect();
        for path in after(text, "super::").flat_map(paths) {
            // Inline modules, in which `climbed` would be 1 too large, are not considered.
            let climbed = 1 + path.iter().take_while(|name| *name == "super").count();
            let rest = path.into_iter().skip(climbed - 1);
            let kept = module[..module.len().saturating_sub(climbed)].iter().map(|&name| name.to_owned());
            needs.push(kept.chain(rest).collect());
        }
        if let Some(outer) = outer {
            needs.retain(|path| path[0] == outer && path.len() > 1);
            needs.iter_mut().for_each(|path| drop(path.remove(0)));
        }
        needs
    }

    /// Returns those paths of a file that lead to higher layers, and the number of all its paths.
    fn upward(&self, file: &Path, text: &str) -> (Vec<String>, usize) {
        let exports = self.exports();
        let rank = self.layers.iter().position(|layer| {
            let layer = self.source().join(layer);
            file.starts_with(&layer) || file == layer.with_extension("rs")
        });
        let rank = rank.expect("a file of a layer");
        let needs = self.needs(file, text);
        let folder = |path: &[String]| {
            let name = path[0].as_str();
            let is_layer = self.layers.contains(&name);
            if is_layer { name.to_owned() } else { exports.get(name).map_or(name, String::as_str).to_owned() }
        };
        let own = self.module.map_or(&[][..], |(_, own)| own);
        let is_below = |name: &str| self.layers[..=rank].contains(&name) || own.contains(&name);
        let upward = needs.iter().filter(|path| !is_below(&folder(path)));
        let shown =
            upward.map(|path| format!("{}: {}, of {}", file.display(), path.join("::"), folder(path)));
        (shown.collect(), needs.len())
    }
}

/// Returns a file's code, without comments and without the tests at its end.
fn code(path: &Path) -> String {
    let text = fs::read_to_string(path).expect("a file of the crate");
    let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default());
    lines.collect::<Vec<_>>().join("\n")
}

/// Returns the first two names of each path in a `use` tree or expression. Braces are expanded.
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

fn after<'a>(text: &'a str, word: &'a str) -> impl Iterator<Item = &'a str> {
    text.match_indices(word).filter_map(move |(place, _)| {
        let begins = !text[..place].ends_with(|c: char| c.is_alphanumeric() || c == '_' || c == '$');
        begins.then(|| &text[place + word.len()..])
    })
}

#[test]
fn a_layer_needs_those_below_it_only() {
    for (layered, least) in ALL.into_iter().zip([150, 10, 30, 300, 60, 40, 20, 150]) {
        let (mut upward, mut looked_at) = (Vec::new(), 0);
        for layer in layered.layers {
            let files = layered.files(layer);
            assert!(!files.is_empty(), "no folder {layer}");
            for file in files {
                let (found, count) = layered.upward(&file, &code(&file));
                upward.extend(found);
                looked_at += count;
            }
        }
        assert!(upward.is_empty(), "a layer needs what is above it:\n{}", upward.join("\n"));
        assert!(looked_at > least, "only {looked_at} paths were found in {}", layered.folder);
    }
}

#[test]
fn the_layers_are_the_folders() {
    for layered in ALL {
        let lib = code(&layered.root_file());
        let declared: Vec<&str> =
            after(&lib, "mod ").filter_map(|rest| rest.split([';', ' ']).next()).collect();
        assert_eq!(declared[..layered.layers.len()], *layered.layers);
        let folders =
            fs::read_dir(layered.source()).expect("the crate").map(|entry| entry.expect("an entry").path());
        let folders: Vec<PathBuf> =
            folders.filter(|path| path.is_dir() && !path.ends_with("tests")).collect();
        assert!(
            folders.iter().all(|path| layered.layers.iter().any(|layer| path.ends_with(layer))),
            "{folders:?}"
        );
    }
}

#[test]
fn every_way_up_is_found() {
    let ways_up = [
        (CORE, "scalar/float.rs", "use crate::ExtendScalars;"),
        (CORE, "scalar/float.rs", "use crate::{Constant,\n    ExtendScalars};"),
        (CORE, "scalar/float.rs", "use crate::{field::{linear::solve, QuadraticField}, Constant};"),
        (CORE, "scalar/float.rs", "use crate::*;"),
        (CORE, "scalar/float.rs", "fn f() { crate::prelude::vector![0.0]; }"),
        (CORE, "scalar/dd/mod.rs", "use super::super::map::KahanMap;"),
        (CORE, "scalar/dd/traits.rs", "use super::super::super::lattice::LatticeMap;"),
        (DYNAMICS, "flow/series.rs", "use crate::Scene;"),
        (CORE, "step/mod.rs", "impl super::KahanMap for S {}"),
        (CORE, "step/mod.rs", "use kahan_core::Orbit;"),
        (SYNTAX, "lexer.rs", "use crate::parse::parse;"),
        (ALGEBRA, "poly/gcd.rs", "use crate::plan::Plan;"),
        (ALGEBRA, "subexpressions.rs", "use crate::{field::Field, plan::Plan};"),
        (ALGEBRA, "plan/step/mod.rs", "use super::super::system::System;"),
        (PLAN, "step/mod.rs", "use crate::plan::forms::candidates;"),
        (PLAN, "writing/writer/reuse.rs", "use super::super::super::accuracy::Accuracy;"),
        (COMMAND, "printing/table.rs", "fn f(block: &super::super::reading::Block) {}"),
        (DRAW, "plot.rs", "use super::document::document;"),
        (COMMAND, "reading/source.rs", "use crate::{printing::columns, commands::verify::Verify};"),
    ];
    for (layered, file, text) in ways_up {
        let (upward, _) = layered.upward(&layered.source().join(file), text);
        assert!(!upward.is_empty(), "{text}");
    }
    let allowed = [
        (PLAN, "writing/plan_draft.rs", "use crate::plan::{Node, StepPlan}; use crate::poly::Variable;"),
        (CORE, "map/orbit/mod.rs", "use super::{KahanMap, at::KahanAt}; use crate::Scalar;"),
        (
            COMMAND,
            "commands/page/figures.rs",
            "use super::super::command_line::CommandLine; use crate::reading::Block;",
        ),
    ];
    for (layered, file, text) in allowed {
        let (upward, paths) = layered.upward(&layered.source().join(file), text);
        assert!(upward.is_empty() && paths > 1, "{text}: {upward:?}");
    }
}
