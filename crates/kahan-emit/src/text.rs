//! Formats the expansion of a block as text.

use std::error::Error;
use std::fmt;

use proc_macro2::{LexError, TokenStream, TokenTree};
use quote::quote;

use super::expand;

const MOST_TOKENS: usize = 500_000;

/// An error that prevents returning an expansion as text.
#[derive(Debug)]
pub enum ExpansionTextError {
    /// The block contains text that is not a Rust token, for example `x²`.
    NotRust(LexError),
    /// The expansion has too many tokens to format.
    TooLong {
        /// The number of tokens.
        tokens: usize,
        /// The largest permitted number of tokens.
        most: usize,
    },
}

impl fmt::Display for ExpansionTextError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ExpansionTextError::NotRust(why) => {
                write!(f, "the text is not made of Rust's tokens, so no macro can read it: {why}")
            }
            ExpansionTextError::TooLong { tokens, most } => {
                write!(f, "the macro makes {tokens} tokens of this block, and at most {most} are shown")
            }
        }
    }
}

impl Error for ExpansionTextError {}

/// Returns the formatted expansion of `kahan! { block }`, in which `core` is the path of the core
/// crate. An expansion that is an expression is put into a function.
///
/// # Errors
/// If the block does not consist of Rust tokens, or if the expansion is too long.
pub fn text(core: &TokenStream, block: &str) -> Result<String, ExpansionTextError> {
    let expansion = expand(core, block.parse().map_err(ExpansionTextError::NotRust)?);
    let tokens = count(&expansion.tokens);
    if tokens > MOST_TOKENS {
        return Err(ExpansionTextError::TooLong { tokens, most: MOST_TOKENS });
    }
    Ok(formatted(&expansion.tokens))
}

fn count(tokens: &TokenStream) -> usize {
    let inside = |token| match token {
        TokenTree::Group(group) => 1 + count(&group.stream()),
        _ => 1,
    };
    tokens.clone().into_iter().map(inside).sum()
}

fn formatted(tokens: &TokenStream) -> String {
    let file = syn::parse2(tokens.clone())
        .or_else(|_| syn::parse2(quote! { fn scope() { let value = #tokens; } }))
        .expect("what the macro expands to is Rust");
    prettyplease::unparse(&file)
}
