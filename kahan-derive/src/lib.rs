//! The procedural macros behind `kahan_core::kahan!` and `include_kahan!`.
//!
//! Each macro passes its tokens to `kahan-emit`, and returns the tokens generated there. A
//! proc-macro crate can export only macros, and therefore the generator of code is in `kahan-emit`.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

use std::time::Instant;

use kahan_emit::Expansion;
use proc_macro2::{Group, TokenStream, TokenTree};

/// Expands a block. The first token is `[path]`, the path of the crate that holds `__private`;
/// `kahan_core::kahan!` inserts this token. If the environment variable `KAHAN_TIMING` is set, the
/// macro prints the time of the expansion.
#[proc_macro]
pub fn kahan(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    timed(|| {
        let (core, block) = split_path(input.into());
        kahan_emit::expand(&core, block)
    })
}

fn timed(expand: impl FnOnce() -> Expansion) -> proc_macro::TokenStream {
    #[expect(clippy::disallowed_methods, reason = "`KAHAN_TIMING` asks for the time")]
    let start = Instant::now();
    let expansion = expand();
    if std::env::var_os("KAHAN_TIMING").is_some() {
        eprintln!("kahan!: {} expanded in {:.2} ms", expansion.name, start.elapsed().as_secs_f64() * 1e3);
    }
    expansion.tokens.into()
}

/// Expands the block in a file. The tokens are `[path]`, as in [`kahan!`](macro@kahan), and a
/// literal. The literal is the file's path, relative to the source file that contains the literal.
#[proc_macro]
pub fn include_kahan(input: proc_macro::TokenStream) -> proc_macro::TokenStream {
    timed(|| {
        let (core, file) = split_path(input.into());
        let literal = file.clone().into_iter().next();
        let beside = literal.and_then(|literal| literal.span().unwrap().local_file());
        kahan_emit::include(&core, file, beside.as_deref())
    })
}

fn split_path(input: TokenStream) -> (TokenStream, TokenStream) {
    let mut trees = input.into_iter();
    let path = match trees.next() {
        Some(TokenTree::Group(group)) => Group::stream(&group),
        other => other.into_iter().collect(),
    };
    (path, trees.collect())
}
