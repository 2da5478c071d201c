//! Golden expansions: a block and the Rust that it becomes, to be read in review like any code.
//!
//! `KAHAN_GOLDEN=overwrite cargo test -p kahan-emit` writes the files anew.

use std::fs;
use std::path::PathBuf;

/// The expansion of a block as text.
fn expansion(block: &str) -> String {
    crate::rust::text(&quote::quote!(::kahan_core), block).expect("the block is made of Rust tokens")
}

/// How a field is stepped, without its formulas: the implementations of these traits.
fn implementations(block: &str, traits: &[&str]) -> String {
    let mut file = syn::parse_file(&expansion(block)).expect("the expansion is Rust");
    let items = std::mem::take(&mut file.items).into_iter().flat_map(|item| match item {
        syn::Item::Const(syn::ItemConst { expr, .. }) => match *expr {
            syn::Expr::Block(body) => body.block.stmts,
            _ => Vec::new(),
        },
        _ => Vec::new(),
    });
    let wanted = items.filter_map(|statement| match statement {
        syn::Stmt::Item(syn::Item::Impl(item)) => Some(item),
        _ => None,
    });
    let wanted = wanted.filter(|item| {
        let name = item.trait_.as_ref().and_then(|(path, _)| path.segments.last());
        name.is_some_and(|name| traits.iter().any(|wanted| name.ident == wanted))
    });
    file.items = wanted.map(syn::Item::Impl).collect();
    prettyplease::unparse(&file)
}

fn check(name: &str) {
    check_text(name, expansion);
}

fn check_text(name: &str, text: impl Fn(&str) -> String) {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("src/golden");
    let block = fs::read_to_string(folder.join(format!("{name}.kahan"))).expect("the block is there");
    let expanded = text(&block);
    let path = folder.join(format!("{name}.expanded.rs"));
    if std::env::var("KAHAN_GOLDEN").is_ok_and(|mode| mode == "overwrite") {
        fs::write(&path, &expanded).expect("the folder can be written");
        return;
    }
    let golden = fs::read_to_string(&path).expect("the expansion is there");
    let differs = golden.lines().zip(expanded.lines()).position(|(golden, now)| golden != now);
    assert!(
        golden == expanded,
        "{name}: the expansion changed, first at line {}. If that is meant, write it anew with KAHAN_GOLDEN=overwrite.\n{expanded}",
        differs.map_or_else(|| golden.lines().count().min(expanded.lines().count()) + 1, |line| line + 1),
    );
}

#[test]
fn a_system_with_claims_expands_as_written_down() {
    check("e3");
}

#[test]
fn parameters_and_their_divisors_expand_as_written_down() {
    check("parameters");
}

#[test]
fn a_block_without_a_header_expands_to_a_value() {
    check("anonymous");
}

#[test]
fn a_broken_block_still_expands_to_its_type() {
    check("broken");
}

#[test]
fn a_field_beyond_the_budget_steps_by_elimination() {
    check_text("dense", |block| implementations(block, &["Named", "KahanMap", "Lift"]));
}

#[test]
fn expanding_twice_gives_the_same_tokens() {
    let block = "struct S { a } xdot = a*x*y; ydot = x - y/a; integral h = x - x + 1/x;";
    assert_eq!(expansion(block), expansion(block));
}
