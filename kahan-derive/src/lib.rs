//! The procedural macro behind `kahan_core::kahan!`: tokens to the front end, its result to Rust.
//!
//! Reading, checking and proving are `kahan-algebra`'s; `emit` writes the Rust. A crate of this type can export only
//! macros, so it holds nothing else.

mod emit;
#[cfg(test)]
mod golden;
mod tokens;

use std::time::Instant;

use proc_macro2::{Group, TokenStream, TokenTree};

/// Expands a block. The first token is `[path]`, the path of the crate that holds `__private`; `kahan_core::kahan!` puts
/// it there. With the environment variable `KAHAN_TIMING` set, the time of the expansion goes to standard error.
#[proc_macro]
pub fn kahan(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    let start = Instant::now();
    let (name, expansion) = expand(input.into());
    if std::env::var_os("KAHAN_TIMING").is_some() {
        eprintln!("kahan!: {name} expanded in {:.2} ms", start.elapsed().as_secs_f64() * 1e3);
    }
    expansion.into()
}

/// The pipeline: tokens in, the system's name and its Rust out.
fn expand(input: TokenStream) -> (String, TokenStream) {
    let (core, block) = split_path(input);
    let input = tokens::flatten(block.clone());
    let reading = kahan_algebra::read(&input.tokens);
    let expansion = emit::emit(&core, block, &reading, &input);
    (reading.system.name().to_owned(), expansion)
}

/// Splits off the leading `[path]`.
fn split_path(input: TokenStream) -> (TokenStream, TokenStream) {
    let mut trees = input.into_iter();
    let path = match trees.next() {
        Some(TokenTree::Group(group)) => Group::stream(&group),
        other => other.into_iter().collect(),
    };
    (path, trees.collect())
}
