//! Selects the definitions that a statement needs.

use std::collections::BTreeSet;

use kahan_algebra::lexer::lex;
use kahan_algebra::token::TokenKind;

/// Puts those of the `definitions` that a statement uses in front of the statement.
pub(crate) fn with_definitions(definitions: &str, statement: &str) -> String {
    let pieces: Vec<&str> = definitions.split(';').map(str::trim).filter(|piece| !piece.is_empty()).collect();
    let own: BTreeSet<String> = statement.split(';').filter_map(defined_name).collect();
    let mut used = identifiers(statement);
    let mut kept = vec![false; pieces.len()];
    loop {
        let before = used.len();
        for (piece, kept) in pieces.iter().zip(&mut kept) {
            if !*kept && defined_name(piece).is_some_and(|name| used.contains(&name) && !own.contains(&name))
            {
                *kept = true;
                used.extend(identifiers(piece));
            }
        }
        if used.len() == before {
            break;
        }
    }
    let kept = pieces.iter().zip(kept).filter(|(_, kept)| *kept).map(|(piece, _)| *piece);
    kept.chain([statement]).collect::<Vec<_>>().join("; ")
}

/// Returns the name that a piece of text defines, if any.
fn defined_name(piece: &str) -> Option<String> {
    let (left, _) = piece.split_once(":=")?;
    identifier_tokens(left).into_iter().next()
}

fn identifiers(text: &str) -> BTreeSet<String> {
    identifier_tokens(text).into_iter().collect()
}

fn identifier_tokens(text: &str) -> Vec<String> {
    let tokens = lex(text).tokens.into_iter();
    tokens.filter(|token| token.kind == TokenKind::Identifier).map(|token| token.text.into_owned()).collect()
}

#[cfg(test)]
mod tests {
    use super::with_definitions;

    #[test]
    fn only_what_is_used_is_kept() {
        let definitions = "a := b + 1; c(n) := n; b := 2; d := a";
        assert_eq!(with_definitions(definitions, "a = 3"), "a := b + 1; b := 2; a = 3");
        assert_eq!(with_definitions(definitions, "c(2) = 2"), "c(n) := n; c(2) = 2");
        assert_eq!(with_definitions(definitions, "a := 3; d = 3"), "d := a; a := 3; d = 3");
    }
}
