//! The exact front end of Kahan's method.
//!
//! In: text or tokens of the language of `kahan!`. Out: a checked quadratic vector field with a
//! verdict on every claim about its map ([`read`]), and every plan that evaluates it
//! ([`derive()`]). It must not know any target language, nor the scalars of `kahan-core`: the
//! macro, the maps made at run time and the command read the same [`Derived`].
//!
//! Modules in reading order: [`token`], [`lexer`], [`syntax`], [`parse`], [`check`], [`field`],
//! [`system`], [`family`], [`kahan`], [`plan`], [`elimination`], [`derived`], [`relations`],
//! [`prove`], [`specialise`], [`interpret`], [`render`]; beneath them the exact arithmetic of
//! [`rational`], [`poly`] and [`rational_function`].

pub mod arithmetic;
pub mod check;
pub mod derived;
pub mod diagnostics;
pub mod elimination;
pub mod family;
pub mod field;
pub mod interpret;
pub mod kahan;
pub mod kept;
pub mod lexer;
pub mod parse;
pub mod plan;
pub mod poly;
pub mod prime_field;
pub mod prove;
pub mod rational;
pub mod rational_function;
pub mod relations;
pub mod render;
pub mod specialise;
pub mod symbols;
pub mod syntax;
pub mod system;
pub mod table;
pub mod token;
mod variational;

pub use derived::{Derived, derive};

use diagnostics::{Diagnostic, Diagnostics};
use family::Family;
use prime_field::Shake256;
use system::System;
use token::Token;

/// A block as read: the system, and what is wrong with it.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The system; what is broken in it is replaced by zeros, so that it can always be emitted.
    pub system: System,
    /// The family, where the block holds one instead of equations; the system is then empty.
    pub family: Option<Family>,
    /// The mistakes, in the order of their places; none means that every claim is proved.
    pub diagnostics: Vec<Diagnostic>,
}

/// Reads a block: parse, check, prove.
#[must_use]
pub fn read(tokens: &[Token]) -> Reading {
    let mut diagnostics = Diagnostics::default();
    let block = parse::parse(tokens, &mut diagnostics);
    if let Some(family) = check::check_family(&block, &mut diagnostics) {
        if family.is_sound {
            family::conserved::check_claims(&family, &mut diagnostics);
        }
        let system = System::without_field(block.header);
        return Reading { system, family: Some(family), diagnostics: diagnostics.finish() };
    }
    let system = check::check(block, &mut diagnostics);
    // A wrong field makes every claim wrong: only its own mistakes are worth reporting.
    if system.is_field_sound {
        prove::check_claims(&system, seed(tokens), &mut diagnostics);
    }
    Reading { system, family: None, diagnostics: diagnostics.finish() }
}

/// The seed of the prover's points: a hash of the block's text, so that builds are reproducible,
/// and one that nobody can steer, so that no claim can be written for the points it is tested at.
#[must_use]
pub fn seed(tokens: &[Token]) -> [u8; 32] {
    let text: Vec<&str> = tokens.iter().map(|token| token.text.as_str()).collect();
    Shake256::new(text.join(" ").as_bytes()).next_seed()
}
