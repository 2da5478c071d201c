//! Translates right-hand sides: expands auxiliary quantities, replaces roots such as `sqrt(2)` by
//! numbers or parameters, and reports products without `*`.

use std::ops::Range;

use crate::parse::{is_function, is_statement, product};
use crate::rational::Rational;
use crate::spelling::fresh;
use crate::token::{Token, TokenKind};

use super::left_side::{Derivative, LeftSide};
use super::{PlacedToken, Reader, mistake, placed_token};

pub(super) const MOST_TOKENS: usize = 200_000;

impl Reader<'_> {
    /// Writes an equation. An equation of order n becomes n first-order equations.
    pub(super) fn equation(&mut self, tokens: &Range<usize>, left: &LeftSide) -> Vec<PlacedToken> {
        let mut right = self.written(left.right..tokens.end, true);
        self.explain_products(&mut right);
        let Derivative { name, order, end } = &left.of;
        let [of_name, of_sign] = [tokens.start..*end, *end..left.right].map(|tokens| self.bytes(tokens));
        let mut out = vec![placed_token(&format!("{name}dot"), &of_name), placed_token("=", &of_sign)];
        for derivative in self.states.get(name).iter().flat_map(|chain| &chain[..order - 1]) {
            let next = format!("{derivative}dot");
            out.extend([derivative, ";", &next].map(|text| placed_token(text, &of_name)));
            out.push(placed_token("=", &of_sign));
        }
        out[0].0.docs.clone_from(&self.given[tokens.start].0.docs);
        out.extend(right);
        out
    }

    pub(super) fn written(&mut self, tokens: Range<usize>, in_equation: bool) -> Vec<PlacedToken> {
        let mut out: Vec<PlacedToken> = Vec::with_capacity(tokens.len());
        let mut at = tokens.start;
        while at < tokens.end {
            let own = if self.has_derivatives { self.named_derivative(at) } else { None };
            let is_sign = |(token, _): &PlacedToken| {
                matches!(token.kind, TokenKind::Punctuation(_) | TokenKind::Open(_))
            };
            let end = if let Some((name, end)) = own {
                out.push(placed_token(name, &self.bytes(at..end)));
                end
            } else if self.is_name(at) {
                self.write_name(at, in_equation, &mut out)
            } else if self.at(at) == "+" && out.last().is_none_or(is_sign) {
                at += 1;
                continue;
            } else {
                out.push(self.given[at].clone());
                at + 1
            };
            if let Some((last, _)) = out.last_mut() {
                last.touches_next = self.given[end - 1].0.touches_next;
            }
            at = end;
        }
        out
    }

    fn named_derivative(&self, at: usize) -> Option<(&str, usize)> {
        let Derivative { name, order, end } = self.derivative(at)?;
        Some((self.states.get(&name)?.get(order.checked_sub(1)?)?, end))
    }

    /// Writes a name or its replacement, and returns the index of the next token.
    fn write_name(&mut self, at: usize, in_equation: bool, out: &mut Vec<PlacedToken>) -> usize {
        if let Some(end) = self.write_call(at, in_equation, out) {
            return end;
        }
        let is_of_time = self.is_group(at + 1, "t") && !is_function(self.at(at));
        let end = at + if is_of_time { 4 } else { 1 };
        let range = self.bytes(at..end);
        let name = &*self.given[at].0.text;
        if let Some(quantity) = self.arguments.get(name).or_else(|| self.quantities.get(name)) {
            self.added += quantity.len();
            if self.added > MOST_TOKENS {
                let message = "with the formula of this name the field is too large";
                out.push(mistake(&range, message, "make it a state, or shorten it"));
            } else {
                out.push(placed_token("(", &range));
                out.extend_from_slice(quantity);
                out.push(placed_token(")", &range));
            }
            return end;
        }
        if in_equation && let Some(root) = self.root(at) {
            out.push(placed_token(&root, &self.bytes(at..at + 4)));
            return at + 4;
        }
        if is_of_time && !self.is_state(self.at(at)) {
            let name = self.at(at);
            self.note(&format!("`{name}(t)` is read as a parameter `{name}`: no equation defines it"));
        }
        out.push(self.given[at].clone());
        end
    }

    /// Returns the value of a root such as `sqrt(2)`; an irrational root becomes a parameter.
    fn root(&mut self, at: usize) -> Option<String> {
        let radicand = self.at(at + 2);
        let is_root = self.at(at) == "sqrt" && self.at(at + 1) == "(" && self.is_group(at + 1, radicand);
        let value = Rational::parse(radicand).filter(|_| is_root && !self.has_header())?;
        let root = value.to_f64().sqrt().to_string();
        let exact = Rational::parse(&root)?;
        if &exact * &exact == value {
            return Some(root);
        }
        let name = fresh(&[&format!("sqrt_{}", radicand.replace('.', "_"))], |name| self.mentions(name));
        if !self.read.parameters.iter().any(|(known, _)| *known == name) {
            self.note(&format!(
                "numbers are exact: sqrt({radicand}) is the parameter `{name}` with the value {root}"
            ));
            self.read.parameters.push((name.clone(), exact));
        }
        Some(name)
    }

    /// Marks products without `*` as mistakes. The right-hand side with `*` is the proposal.
    fn explain_products(&self, right: &mut [PlacedToken]) {
        let texts =
            |four: &[PlacedToken]| four.iter().map(|(token, _)| token.text.to_string()).collect::<Vec<_>>();
        let is_power = |four: &[PlacedToken]| {
            is_function(&four[0].0.text) && four[1].0.text == "^" && four[3].0.text == "("
        };
        if let Some(place) = right.windows(4).position(is_power) {
            let [name, _, power, _] = &texts(&right[place..place + 4])[..] else { return };
            let message = format!("`{name}^{power}(…)` is a power of a name, not of a value");
            right[place].0.kind = TokenKind::unreadable(message, format!("write `{name}(…)^{power}`"));
            return;
        }
        let (mut first, mut written, mut question) = (None, String::new(), String::new());
        for (place, (token, _)) in right.iter().enumerate() {
            let before = place.checked_sub(1).map(|before| &right[before].0);
            let is_call = before.is_some_and(|before| is_function(&before.text)) && token.text == "(";
            let is_other = matches!(token.kind, TokenKind::Unreadable(_)) || is_statement(&token.text);
            if is_call || is_other || token.text == "=" {
                return;
            }
            let is_joint = before.is_some_and(|before| are_side_by_side(before, token));
            let glued = product(&token.text).filter(|_| token.kind == TokenKind::Literal);
            if is_joint || glued.is_some() {
                first.get_or_insert(place);
            }
            let is_apart = !is_joint && before.is_some_and(|before| !before.touches_next);
            let (number, word) = glued.unwrap_or(("", &token.text));
            let letters = self.split_into_letters(word);
            if let Some(letters) = &letters {
                question = format!("; if `{word}` is one name, keep it for `{letters}`");
            }
            written.extend([if is_apart { " " } else { "" }, if is_joint { "*" } else { "" }, number]);
            written.extend([if number.is_empty() { "" } else { "*" }, letters.as_deref().unwrap_or(word)]);
        }
        if let Some((token, _)) = first.map(|first| &mut right[first]) {
            let message = format!("a product needs its `*`, also at `{}`", token.text);
            token.kind = TokenKind::unreadable(message, format!("write `{written}`{question}"));
        }
    }

    /// Splits a short undefined word into a product of letters, if at least one letter is a state.
    fn split_into_letters(&self, word: &str) -> Option<String> {
        let letters = || word.chars().map(String::from);
        let is_word = (2..=3).contains(&letters().count()) && word.chars().all(char::is_alphabetic);
        let is_product = is_word && letters().any(|letter| self.is_state(&letter)) && !self.is_state(word);
        let is_known = || self.read.parameters.iter().any(|(known, _)| known == word);
        (is_product && !is_known()).then(|| letters().collect::<Vec<_>>().join("*"))
    }
}

fn are_side_by_side(left: &Token, right: &Token) -> bool {
    use TokenKind::{Close, Identifier, Literal, Open};
    match (&left.kind, &right.kind) {
        (Identifier, Identifier | Literal) => left.text == "gamma" || !is_function(&left.text),
        (Literal | Close(')'), Identifier | Literal | Open('(')) => true,
        _ => false,
    }
}
