//! Mutations: statements or `kahan!` blocks with one change: of a number, a sign, `*` or `/`, or a
//! factor 2 on a right-hand side.

use std::ops::Range;

use kahan_algebra::lexer::lex;
use kahan_algebra::token::{Token, TokenKind};

/// Returns all mutations of a text. A mutation increases one number by one in its last place, flips
/// one sign, doubles one right-hand side, or exchanges one `*` or `/` for the other.
#[must_use]
pub fn mutations(text: &str) -> Vec<String> {
    let lexed = lex(text);
    let tokens = &lexed.tokens;
    let replace = |range: &Range<usize>, with: &str| {
        let mut mutated = text.to_owned();
        mutated.replace_range(range.clone(), with);
        mutated
    };
    let mut numbers = Vec::new();
    let mut signs = Vec::new();
    let mut doubled = Vec::new();
    let mut inverted = Vec::new();
    for (index, (token, range)) in tokens.iter().zip(&lexed.ranges).enumerate() {
        match (&token.kind, &*token.text) {
            (TokenKind::Literal, literal) => {
                numbers.extend(incremented(literal).map(|next| replace(range, &next)));
            }
            (TokenKind::Punctuation('+'), _) => signs.push(replace(range, "-")),
            (TokenKind::Punctuation('-'), _) if is_binary(tokens, index) => signs.push(replace(range, "+")),
            (TokenKind::Punctuation('-'), _) => signs.push(replace(range, "")),
            (TokenKind::Punctuation('='), _) if !follows_bang(tokens, index) => {
                doubled.push(replace(range, "= 2*"));
            }
            (TokenKind::Punctuation('*'), _) => inverted.push(replace(range, "/")),
            (TokenKind::Punctuation('/'), _) => inverted.push(replace(range, "*")),
            (TokenKind::Punctuation('~'), _) => doubled.push(replace(range, "~ 2*")),
            _ => {}
        }
    }
    [numbers, signs, doubled, inverted].concat()
}

fn is_binary(tokens: &[Token], index: usize) -> bool {
    let before = index.checked_sub(1).map(|before| &tokens[before].kind);
    matches!(before, Some(TokenKind::Identifier | TokenKind::Literal | TokenKind::Close(_)))
}

fn follows_bang(tokens: &[Token], index: usize) -> bool {
    index > 0 && tokens[index - 1].text == "!"
}

/// Increases the last digit of a literal, for example `3` to `4`, `14.05` to `14.06`, `1e-3` to
/// `2e-3`.
fn incremented(literal: &str) -> Option<String> {
    let (mantissa, exponent) = match literal.split_once('e') {
        Some((mantissa, exponent)) => (mantissa, format!("e{exponent}")),
        None => (literal, String::new()),
    };
    let digits: Vec<char> = mantissa.chars().collect();
    let mut raised = Vec::new();
    let mut carry = true;
    for &c in digits.iter().rev() {
        raised.push(match (c, carry) {
            ('9', true) => '0',
            (c, true) if c.is_ascii_digit() => {
                carry = false;
                char::from_digit(c.to_digit(10)? + 1, 10)?
            }
            (c, _) => c,
        });
    }
    if carry {
        raised.push('1');
    }
    Some(raised.into_iter().rev().collect::<String>() + &exponent)
}
