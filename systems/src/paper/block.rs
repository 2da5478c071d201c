//! Claims of `kahan!` blocks, proved again from their text.
//!
//! The macro proves a claim modulo primes. Here a claim must pass that proof and a second one that shares no step with
//! it: both sides expanded over ℚ. Where the expansion would be too large, the first proof stands alone.

use kahan_algebra::diagnostics::Diagnostics;
use kahan_algebra::lexer::lex;
use kahan_algebra::prove::{ERROR_EXPONENT, Verdict, prove_all, prove_by_normal_form};
use kahan_algebra::system::{Claim, System};
use kahan_algebra::token::TokenKind;
use kahan_algebra::{check, parse, seed};

use super::claim::Outcome;

/// Decides one claim of a system, and says on what the decision rests. Costs milliseconds, a second at worst.
#[must_use]
pub fn establish_block_claim(system: &System, claim: &Claim, seed: u64) -> (Outcome, String) {
    let alone = System { claims: vec![claim.clone()], ..system.clone() };
    let failed = |why: &str| (Outcome::Failed, why.to_owned());
    let points = match prove_all(&alone, seed).pop().flatten() {
        Some(Verdict::Proved(proof)) => proof.points,
        Some(Verdict::Refuted(refutation)) => return failed(&refutation.describe(&system.field.symbols)),
        Some(Verdict::Vacuous) => return failed("it says nothing"),
        Some(Verdict::NoMap) => return failed("det A is 0 everywhere there: there is no map"),
        Some(Verdict::Undefined) => return failed("it divides by zero identically"),
        Some(Verdict::TooLarge) | None => return failed("its degree is too high to be proved"),
    };
    match prove_by_normal_form(system, claim) {
        Some(true) => (Outcome::Proved, "by normal forms over Q, and modulo primes".to_owned()),
        None => (
            Outcome::ProvedModP,
            format!("at {points} random points modulo primes, error < 2^-{ERROR_EXPONENT}"),
        ),
        Some(false) => failed("the normal forms of its two sides differ"),
    }
}

/// Decides the claim `statement` about the field of a block.
pub(super) fn establish_statement(block: &str, statement: &str) -> (Outcome, String) {
    let text = format!("{}\n{statement}", field_of(block));
    let tokens = lex(&text).tokens;
    let mut diagnostics = Diagnostics::default();
    let system = check::check(parse::parse(&tokens, &mut diagnostics), &mut diagnostics);
    if let Some(mistake) = diagnostics.finish().first() {
        return (Outcome::Failed, mistake.message.clone());
    }
    match system.claims.last() {
        Some(claim) => establish_block_claim(&system, claim, seed(&tokens)),
        None => (Outcome::Failed, "it claims nothing".to_owned()),
    }
}

/// The block without its claims.
fn field_of(block: &str) -> &str {
    let lexed = lex(block);
    let begins_claim = |index: usize| {
        matches!(lexed.tokens[index].text.as_str(), "integral" | "density" | "bracket")
            && lexed.tokens.get(index + 1).is_some_and(|next| next.kind == TokenKind::Identifier)
    };
    let end = (0..lexed.tokens.len()).find(|&index| begins_claim(index));
    end.map_or(block, |index| &block[..lexed.ranges[index].start])
}
