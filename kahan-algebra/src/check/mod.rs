//! Syntax to a checked system, one rule a function.
//!
//! Names first, then constants, equations and claims. What is broken is reported once and replaced
//! by something harmless (a zero right-hand side, a claim that is not proved), so that one mistake
//! makes one error and the emitter can always emit.

mod claims;
mod conditions;
mod constants;
mod entries;
mod equations;
mod expand;
mod family;
mod lower;
mod names;
mod outside;
mod spelling;
mod sums;

use crate::diagnostics::{Diagnostic, Diagnostics, Kind};
use crate::field::Field;
use crate::syntax::Block;
use crate::system::System;
use crate::token::Span;

use names::Scope;

pub use family::check_family;
pub use spelling::nearest;

/// The most equations of a block: 16 bits number its states, a second copy of them, and parameters.
const MOST_EQUATIONS: usize = 10_000;

/// The mistake of a family where a plain system is wanted.
#[must_use]
pub fn number_of_sites_wanted(span: Span) -> Diagnostic {
    Diagnostic::new(
        Kind::Empty,
        span,
        "a family of equations stands here, and the number of its sites is not known",
        "say how many there are: `--sites 8` in the command; in a program `kahan_runtime::Lattice` takes the family",
    )
}

/// Checks a block of plain equations.
#[must_use]
pub fn check(block: Block, diagnostics: &mut Diagnostics) -> System {
    if let Some(head) = &block.family {
        diagnostics.push(number_of_sites_wanted(head.span));
        return System::without_field(block.header);
    }
    if let Some(equation) = block.equations.get(MOST_EQUATIONS) {
        diagnostics.report(
            Kind::TooLarge,
            equation.state.span,
            format!("the block has more than {MOST_EQUATIONS} equations"),
            "write the equations of many sites once, as in `for i in periodic { x[i]dot = x[i+1]; }`",
        );
        return System::without_field(block.header);
    }
    if block.equations.is_empty() && diagnostics.is_empty() {
        diagnostics.report(
            Kind::Empty,
            Span::token(0),
            "the block holds no equation",
            "write one equation a state, as in `xdot = y*z;`",
        );
    }
    let before = diagnostics.len();
    let mut scope = Scope::new(&block, diagnostics);
    let constants = constants::evaluate(&block, &mut scope, diagnostics);
    let (components, kept) = equations::expand_all(&block, &mut scope, diagnostics);
    let is_field_sound = diagnostics.len() == before
        && block.misspelt_states.is_empty()
        && !block.equations.is_empty()
        && block.equations.iter().all(|equation| equation.value.is_some());
    let field = Field { symbols: scope.symbols.clone(), components };
    // Without a field there is nothing to claim of it.
    let claims = if block.equations.is_empty() {
        Vec::new()
    } else {
        claims::compile_all(&block, &field.components, &mut scope, diagnostics)
    };
    scope.report_unused(&block, diagnostics);
    let written = block.equations.into_iter().filter_map(|equation| equation.value).collect();
    System { header: block.header, constants, field, kept, written, is_field_sound, claims }
}
