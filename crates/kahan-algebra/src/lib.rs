//! The exact front end of Kahan's method.
//!
//! In: tokens of the language of `kahan!`. Out: a checked quadratic vector field with a
//! verdict on every claim about its map ([`read`]), and every plan that evaluates it
//! ([`derive()`]). It must not know any target language, nor the scalars of `kahan-core`: the
//! macro, the maps made at run time and the command read the same [`Derived`].
//!
//! `kahan-syntax` makes a tree of the text; [`check`] makes a [`system`] or a [`family`] of it,
//! [`prove`] judges the claims, [`derived`] makes the [`plan`]s. The modules stand below from the
//! exact arithmetic upward.

#![cfg_attr(not(test), warn(clippy::disallowed_methods))]

// Each needs those before it only, which a test guards.
pub mod prime_field;

pub mod poly;

pub mod rational_function;

pub mod symbols;

pub mod arithmetic;

pub mod field;

pub mod kahan;

pub mod kept;

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
/// Who reads a field here needs no second crate for its text, its numbers and its mistakes.
pub use kahan_syntax::{diagnostics, lenient, lexer, parse, rational, syntax, table, token};

use check::{Broken, Checked};
use diagnostics::Diagnostics;
use prime_field::Shake256;
use syntax::Block;
use token::Token;

/// Reads a block: parse, check, prove.
#[must_use]
pub fn read(tokens: &[Token]) -> Checked {
    let mut diagnostics = Diagnostics::default();
    let block = parse::parse(tokens, &mut diagnostics);
    checked(block, Some(tokens), diagnostics)
}

/// Reads a block without a proof of its claims: parse, check.
#[must_use]
pub fn read_unproved(tokens: &[Token]) -> Checked {
    let mut diagnostics = Diagnostics::default();
    let block = parse::parse(tokens, &mut diagnostics);
    checked(block, None, diagnostics)
}

/// Reads a text without a proof of its claims: as people write it, parse, check. The tokens, which
/// take several times the memory of the text, are gone before the check.
#[must_use]
pub fn read_unproved_text(text: &str) -> Checked {
    let mut diagnostics = Diagnostics::default();
    let block = parse::parse(&lenient::read(text).lexed.tokens, &mut diagnostics);
    checked(block, None, diagnostics)
}

/// Checks a block that was put together, without a proof of its claims.
#[must_use]
pub fn check_unproved(block: Block) -> Checked {
    checked(block, None, Diagnostics::default())
}

/// Checks a block; proves its claims if it is given the tokens.
fn checked(block: Block, tokens: Option<&[Token]>, mut diagnostics: Diagnostics) -> Checked {
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
            // A wrong field makes every claim wrong: only its own mistakes are worth reporting.
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

/// The seed of the prover's points: a hash of the block's text, so that builds are reproducible,
/// and one that nobody can steer, so that no claim can be written for the points it is tested at.
#[must_use]
pub fn seed(tokens: &[Token]) -> [u8; 32] {
    let text: Vec<&str> = tokens.iter().map(|token| &*token.text).collect();
    Shake256::new(text.join(" ").as_bytes()).next_seed()
}
