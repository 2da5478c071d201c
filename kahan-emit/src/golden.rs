//! Golden expansions: a block and the Rust that it becomes, to be read in review like any code.
//!
//! `KAHAN_GOLDEN=overwrite cargo test -p kahan-emit` writes the files anew.

use std::fs;
use std::path::PathBuf;

/// The expansion of a block as text.
fn expansion(block: &str) -> String {
    crate::rust::text(&quote::quote!(::kahan_core), block).expect("the block is made of Rust tokens")
}

fn check(name: &str) {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("src/golden");
    let block = fs::read_to_string(folder.join(format!("{name}.kahan"))).expect("the block is there");
    let expanded = expansion(&block);
    // What rustdoc shows of it has names for reading.
    assert!(!expanded.contains("__state") && !expanded.contains("__half_step"), "{name}");
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
    check("dense");
}

#[test]
fn expanding_twice_gives_the_same_tokens() {
    let block = "struct S { a } xdot = a*x*y; ydot = x - y/a; integral h = x - x + 1/x;";
    assert_eq!(expansion(block), expansion(block));
}
