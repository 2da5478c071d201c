//! The expansion as text that one reads.

use proc_macro2::{LexError, TokenStream};
use quote::quote;

use super::expand;

/// What `kahan! { block }` expands to, formatted; a block without a header stands where an
/// expression may.
///
/// # Errors
/// Where the block is not made of Rust tokens, as `x²` is not.
pub fn text(core: &TokenStream, block: &str) -> Result<String, LexError> {
    Ok(formatted(&expand(core, block.parse()?).tokens))
}

/// Items as a file; a value stands in a function.
fn formatted(tokens: &TokenStream) -> String {
    let file = syn::parse2(tokens.clone())
        .or_else(|_| syn::parse2(quote! { fn scope() { let value = #tokens; } }))
        .expect("what the macro expands to is Rust");
    prettyplease::unparse(&file)
}
