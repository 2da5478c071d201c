//! The exact part of Kahan's method, from the text of a field to plans of the map.
//!
//! [`read`] turns tokens of the language of `kahan!` into a checked quadratic vector field.
//! [`check`] makes a [`system`] or a [`family`], and [`prove`] decides the claims. [`derive()`]
//! returns each [`plan`] for a system, by the code in [`derived`].
//!
//! The macro, maps at run time and the command all use [`Derived`]. This crate therefore writes no
//! code in a target language, and does not contain the scalars of `kahan-core`.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

// Each module uses only modules that are declared above it. A test checks the order.
pub mod prime_field;

pub mod poly;

pub mod rational_function;

pub mod symbols;

pub mod arithmetic;

pub mod field;

pub mod kahan;

pub mod subexpressions;

pub mod plan;

pub mod relations;

pub mod modified_integrals;

pub mod system;

pub mod coefficients;

pub mod variational;

pub mod elimination;

pub mod render;

pub mod family;

pub mod derived;

pub mod interpret;

pub mod specialise;

pub mod prove;

pub mod check;

pub use derived::{Derived, derive};
/// The modules of `kahan-syntax`, so that users of this crate need no second dependency.
pub use kahan_syntax::{diagnostics, lenient, lexer, parse, rational, syntax, table, token};

use check::{Broken, Checked};
use diagnostics::Diagnostics;
use prime_field::Shake256;
use syntax::Block;
use token::Token;

/// Parses and checks a block, and proves its claims.
#[must_use]
pub fn read(tokens: &[Token]) -> Checked {
    let mut diagnostics = Diagnostics::default();
    let block = parse::parse(tokens, &mut diagnostics);
    check_block(block, Some(tokens), diagnostics)
}

/// Parses and checks a block without proving its claims.
#[must_use]
pub fn read_unproved(tokens: &[Token]) -> Checked {
    let mut diagnostics = Diagnostics::default();
    let block = parse::parse(tokens, &mut diagnostics);
    check_block(block, None, diagnostics)
}

/// Parses and checks a text in the lenient notation without proving its claims. The tokens are
/// freed before the check to save memory.
#[must_use]
pub fn read_unproved_text(text: &str) -> Checked {
    let mut diagnostics = Diagnostics::default();
    let block = parse::parse(&lenient::read(text).lexed.tokens, &mut diagnostics);
    check_block(block, None, diagnostics)
}

/// Checks a syntax tree without proving its claims.
#[must_use]
pub fn check_unproved(block: Block) -> Checked {
    check_block(block, None, Diagnostics::default())
}

/// Checks a block. Claims are proved only if tokens are given.
fn check_block(block: Block, tokens: Option<&[Token]>, mut diagnostics: Diagnostics) -> Checked {
    let (stand_in, checked) = match &block.family {
        Some(head) => {
            let (stand_in, family) = check::check_family(&block, head, &mut diagnostics);
            if let Some(family) = family.as_ref().filter(|_| tokens.is_some()) {
                family::conserved::check_claims(family, &mut diagnostics);
            }
            (stand_in, family.map(Checked::Family))
        }
        None => {
            let (stand_in, system) = check::check_system(block, &mut diagnostics);
            // In a wrong field every claim may be wrong, so only the mistakes of the field are
            // reported.
            if let (Some(system), Some(tokens)) = (&system, tokens) {
                prove::check_claims(system, seed(tokens), &mut diagnostics);
            }
            (stand_in, system.map(Checked::System))
        }
    };
    let diagnostics = diagnostics.finish();
    match checked.filter(|_| diagnostics.is_empty()) {
        Some(checked) => checked,
        None => {
            assert!(!diagnostics.is_empty(), "whatever is not understood is reported");
            Checked::Broken(Broken { diagnostics, stand_in })
        }
    }
}

/// Returns the seed of the prover's random points, a cryptographic hash of the text. Builds are
/// therefore reproducible. The points can be influenced only by trying many texts.
#[must_use]
pub fn seed(tokens: &[Token]) -> [u8; 32] {
    let text: Vec<&str> = tokens.iter().map(|token| &*token.text).collect();
    Shake256::new(text.join(" ").as_bytes()).next_seed()
}
