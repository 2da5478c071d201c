//! Proves claims of `kahan!` blocks a second time.
//!
//! The macro proves claims modulo primes. This module repeats that proof. Unless it would be too
//! large, it also expands both sides over ℚ, which is an independent proof.

use kahan_algebra::lexer::lex;
use kahan_algebra::prove::{Verdict, prove_all, prove_by_normal_form};
use kahan_algebra::render::{claim_text, macro_block};
use kahan_algebra::syntax::ClaimKind;
use kahan_algebra::system::{Claim, System};
use kahan_algebra::token::TokenKind;
use kahan_algebra::{read_unproved, seed};

use super::claim::Outcome;
use super::formula::mutations;
use super::identity::Evidence;
use super::registry::outcome;

/// Decides one claim of a system, and returns the evidence in words.
#[must_use]
pub fn establish_block_claim(system: &System, claim: &Claim, seed: [u8; 32]) -> (Outcome, String) {
    let alone = System { claims: vec![claim.clone()], ..system.clone() };
    let failed = |why: &str| (Outcome::Failed, why.to_owned());
    let points = match prove_all(&alone, seed).remove(0) {
        Verdict::Proved(proof) => proof.points,
        Verdict::Refuted(refutation) => return failed(&refutation.describe(&system.field.symbols)),
        Verdict::Vacuous => return failed("it says nothing"),
        Verdict::NoMap => return failed("det A is 0 everywhere there: there is no map"),
        Verdict::Undefined => return failed("it divides by zero identically"),
        Verdict::TooLarge => return failed("its degree is too high to be proved"),
    };
    match prove_by_normal_form(system, claim) {
        Some(true) => outcome(&Evidence::NormalForm),
        None => outcome(&Evidence::Modular(points)),
        Some(false) => failed("the normal forms of its two sides differ"),
    }
}

pub(super) fn establish_statement(block: &str, statement: &str) -> (Outcome, String) {
    let text = format!("{}\n{statement}", field_of(block));
    let tokens = lex(&text).tokens;
    let system = match read_unproved(&tokens).system() {
        Ok(system) => system,
        Err(mistakes) => return (Outcome::Failed, mistakes[0].message.clone()),
    };
    match system.claims.last() {
        Some(claim) => establish_block_claim(&system, claim, seed(&tokens)),
        None => (Outcome::Failed, "it claims nothing".to_owned()),
    }
}

/// Changes one coefficient or sign of the claim at a time, until a changed claim is refuted.
/// Returns the number of tries and this claim. A try costs as much as [`establish_block_claim`].
#[must_use]
pub fn failing_mutation(system: &System, index: usize) -> (usize, Option<String>) {
    let before = System { claims: system.claims[..=index].to_vec(), ..system.clone() };
    let claim = claim_text(system, &system.claims[index]);
    let block = macro_block(&before);
    // The text before the claim holds the header, constants, equations and earlier claims.
    let Some(context) = block.strip_prefix("kahan! {").and_then(|block| block.split_once(&claim)) else {
        return (0, None);
    };
    let (body, condition) = claim.split_at(claim.find(" when ").unwrap_or(claim.len()));
    let raised = system.field.symbols.states.iter().flat_map(|state| {
        body.match_indices(" = ").map(move |(at, sign)| {
            let (left, right) = body.split_at(at + sign.len());
            format!("{left}{state} + {right}")
        })
    });
    let mut tried = 0;
    let failed = mutations(body).into_iter().chain(raised).find(|mutated| {
        let mutated = format!("{mutated}{condition}");
        let tokens = lex(&format!("{}{mutated}", context.0)).tokens;
        // A text that cannot be parsed is not a failing claim.
        let Ok(changed) = read_unproved(&tokens).system() else { return false };
        tried += 1;
        let claim = changed.claims.last();
        claim.is_some_and(|claim| establish_block_claim(&changed, claim, seed(&tokens)).0 == Outcome::Failed)
    });
    (tried, failed.map(|body| body + condition))
}

fn field_of(block: &str) -> &str {
    let lexed = lex(block);
    let begins_claim = |index: usize| {
        ClaimKind::of_keyword(&lexed.tokens[index].text).is_some()
            && lexed.tokens.get(index + 1).is_some_and(|next| next.kind == TokenKind::Identifier)
    };
    let end = (0..lexed.tokens.len()).find(|&index| begins_claim(index));
    end.map_or(block, |index| &block[..lexed.ranges[index].start])
}
