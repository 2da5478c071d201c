//! Compares the expansions of blocks with golden files.
//!
//! The first file shows a whole expansion. Later files omit functions that equal functions shown
//! before. `KAHAN_GOLDEN=overwrite cargo test -p kahan-emit` writes the files.

use std::collections::BTreeSet;
use std::fs;
use std::path::PathBuf;

use kahan_emit::{expand, text};
use proc_macro2::TokenStream;
use quote::{ToTokens, quote};
use syn::{Block, Expr, ImplItem, Item, ItemImpl, Stmt};

/// The blocks, with the functions that each file shows. An empty list means all functions.
const BLOCKS: [(&str, &[&str]); 7] = [
    ("e3", &[]),
    ("parameters", &[]),
    ("anonymous", &["quotients", "prepare", "extend_scalars"]),
    ("broken", &["integrals", "prepare"]),
    // This field has more than eight variables and uses sparse elimination.
    ("coupled", &["slopes", "velocity", "field", "prepare", "jacobian", "try_prepared"]),
    ("family", &["sizes", "boundary", "constants", "field", "rows", "densities"]),
    ("lifted", &["embed", "project", "field", "E"]),
];

#[derive(Default)]
struct Shown(BTreeSet<String>);

impl Shown {
    /// Returns the expansion of `block`, without functions that earlier calls returned.
    fn rest(&mut self, block: &str, functions: &[&str]) -> String {
        let tokens = expand(&quote!(::kahan_core), block.parse().expect("Rust tokens")).tokens;
        if let Ok(mut value) = syn::parse2::<Block>(tokens.clone()) {
            self.take(&mut value, functions);
            return formatted(&quote!(fn scope() { let value = #value; }));
        }
        let mut items: Block = syn::parse2(quote!({ #tokens })).expect("what the macro expands to is Rust");
        self.take(&mut items, functions);
        let items = items.stmts;
        formatted(&quote!(#(#items)*))
    }

    fn take(&mut self, block: &mut Block, functions: &[&str]) {
        for statement in &mut block.stmts {
            if let Stmt::Item(Item::Const(constant)) = statement
                && let Expr::Block(body) = &mut *constant.expr
            {
                body.block.stmts.retain_mut(|statement| match statement {
                    Stmt::Item(Item::Impl(item)) => self.has_news(item, functions),
                    _ => true,
                });
            }
        }
    }

    fn has_news(&mut self, item: &mut ItemImpl, functions: &[&str]) -> bool {
        let name = item.self_ty.to_token_stream().to_string();
        let name = name.split(' ').next().unwrap_or_default().to_owned();
        let of = item.trait_.as_ref().and_then(|(path, _)| path.segments.last());
        let of = of.map_or_else(String::new, |of| of.ident.to_string());
        let mut is_new = |text: String| {
            let general = without_dimension(&text.replace(&name, "Self"));
            self.0.insert(format!("{of}: {general}"))
        };
        if item.items.is_empty() {
            return is_new(item.to_token_stream().to_string());
        }
        item.items.retain(|member| {
            let is_wanted = match member {
                ImplItem::Fn(function) => {
                    functions.is_empty() || functions.iter().any(|name| function.sig.ident == name)
                }
                _ => true,
            };
            is_wanted && is_new(member.to_token_stream().to_string())
        });
        !item.items.is_empty()
    }
}

fn formatted(tokens: &TokenStream) -> String {
    prettyplease::unparse(&syn::parse2(tokens.clone()).expect("what the macro expands to is Rust"))
}

fn without_dimension(text: &str) -> String {
    (1..10).fold(text.to_owned(), |text, n| {
        text.replace(&format!("SVector < T , {n} >"), "SVector < T , n >")
            .replace(&format!("SMatrix < T , {n} , {n} >"), "SMatrix < T , n , n >")
    })
}

#[test]
fn systems_expand_as_written_down() {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("golden");
    let overwrites = std::env::var("KAHAN_GOLDEN").is_ok_and(|mode| mode == "overwrite");
    let mut shown = Shown::default();
    for (name, functions) in BLOCKS {
        let block = fs::read_to_string(folder.join(format!("{name}.kahan"))).expect("the block is there");
        let expanded = shown.rest(&block, functions);
        let path = folder.join(format!("{name}.expanded.rs"));
        if overwrites {
            fs::write(&path, &expanded).expect("the folder can be written");
            continue;
        }
        let golden = fs::read_to_string(&path).expect("the expansion is there");
        let differs = golden.lines().zip(expanded.lines()).position(|(golden, now)| golden != now);
        assert!(
            golden == expanded,
            "{name}: the expansion changed, first at line {}. If that is meant, write it anew with KAHAN_GOLDEN=overwrite.\n{expanded}",
            differs.map_or_else(|| golden.lines().count().min(expanded.lines().count()) + 1, |line| line + 1),
        );
    }
}

#[test]
fn the_first_expansion_is_shown_whole() {
    let block = include_str!("../golden/e3.kahan");
    assert_eq!(Shown::default().rest(block, &[]), text(&quote!(::kahan_core), block).expect("Rust tokens"));
}

#[test]
fn expanding_twice_gives_the_same_tokens() {
    let block = "struct S { a } xdot = a*x*y; ydot = x - y/a; integral h = x - x + 1/x;";
    let expansion = || text(&quote!(::kahan_core), block).expect("Rust tokens");
    assert_eq!(expansion(), expansion());
}

#[test]
fn a_block_of_too_many_couplings_is_told_of_families() {
    for (n, is_refused) in [(200, false), (201, true)] {
        let ring: String =
            (0..n).map(|i| format!("x{i}dot = x{i}*(x{} - x{});", (i + 1) % n, (i + n - 1) % n)).collect();
        for block in [format!("struct Ring; {ring}"), ring] {
            let tokens =
                expand(&quote!(::kahan_core), block.parse().expect("Rust tokens")).tokens.to_string();
            assert_eq!(tokens.contains("compile_error"), is_refused, "{n}");
            assert_eq!(tokens.contains("as a family: `for i in periodic"), is_refused, "{n}");
        }
    }
}

/// Too many parameters would overflow the stack of rustc, so every kind of block refuses them.
#[test]
fn a_block_of_too_many_parameters_is_told_so() {
    for (count, is_refused) in [(2000, false), (2001, true)] {
        let sum = (0..count).map(|k| format!("a{k}")).collect::<Vec<_>>().join(" + ");
        for block in [
            format!("xdot = ({sum})*x;"),
            format!("for i in periodic {{ x[i]dot = ({sum})*x[i+1]; }}"),
            format!("xdot = ({sum})*x; ydot = y^3;"),
        ] {
            let tokens =
                expand(&quote!(::kahan_core), block.parse().expect("Rust tokens")).tokens.to_string();
            assert_eq!(tokens.contains("parameters are too many to compile"), is_refused, "{count}");
            assert_eq!(tokens.contains("derive"), !is_refused, "{count}");
        }
    }
}

#[test]
fn nothing_is_said_to_be_proved_of_a_block_with_mistakes() {
    let core = quote!(::kahan_core);
    for block in [
        "pub struct False; xdot = y; ydot = -x; integral H = x; density rho = x; bracket P { {x,y} = x; }",
        "/// Mine.\npub struct Broken { mu } xdot = mu*x^3; ydot = x; integral H = mu*x;",
        "pub struct Chain; for i in periodic { x[i]dot = x[i]*(x[i+1] - x[i-1]); } integral s = sum(2*x[i]); hamiltonian H = sum(x[i]^2);",
        "pub struct Nothing; integral H = x;",
    ] {
        let text = text(&core, block).expect("Rust tokens");
        assert!(
            text.contains("compile_error") && text.contains("nothing that the block claims is proved"),
            "{text}"
        );
        for word in ["Proved", "The integrals of motion", "The density", "An invariant", "Kahan's method"] {
            let documented =
                text.lines().any(|line| line.trim_start().starts_with("///") && line.contains(word));
            assert!(!documented, "{word}: {text}");
        }
    }
}
