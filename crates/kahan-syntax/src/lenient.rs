//! Translates texts in the notation of books and other programs into the language of `kahan!`.
//!
//! For example, the text `x' = y, y' = -x**2` becomes the tokens of `xdot = y; ydot = -x^2;` with
//! their positions in the text. Mistakes stay in the tokens, and the parser reports them.

mod items;
mod left_side;
mod quantities;
mod right_side;
mod xpp;

use std::cell::OnceCell;
use std::collections::{HashMap, HashSet};
use std::ops::Range;

use crate::diagnostics::brief;
use crate::lexer::{Lexed, lex};
use crate::rational::Rational;
use crate::spelling::ON_TEXTS;
use crate::token::{Token, TokenKind};

use items::TextItem;
use xpp::Function;

/// A text as tokens of the language, together with the values that the text gives.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    /// The tokens of a block, each with the range of the text that it stands for.
    pub lexed: Lexed,
    /// Whether the text was in the language of `kahan!` already, so that nothing was translated.
    pub is_canonical: bool,
    /// The parameters to which the text gives a value, with these values.
    pub parameters: Vec<(String, Rational)>,
    /// The states to which the text gives an initial value, with these values.
    pub start: Vec<(String, Rational)>,
    /// Notes for the user about unusual interpretations.
    pub notes: Vec<String>,
}

impl Reading {
    /// Prints the tokens as text in the language of `kahan!`.
    #[must_use]
    pub fn canonical(&self) -> String {
        let mut text = String::new();
        for (place, token) in self.lexed.tokens.iter().enumerate() {
            token.docs.iter().for_each(|line| text.extend([line, "\n"]));
            let next = self.lexed.tokens.get(place + 1).map_or("", |next| &next.text);
            let space = match (&*token.text, next) {
                (";", _) => "\n",
                ("(", _) | (_, ";" | ")") => "",
                _ if token.touches_next => "",
                _ => " ",
            };
            text.extend([&*token.text, space]);
        }
        text.trim_end().to_owned()
    }
}

/// Translates a text. Mistakes become tokens that the parser reports.
///
/// ```
/// let read = kahan_syntax::lenient::read("par a=2\nx' = a*y\ny' = -x**2");
/// assert_eq!(read.canonical(), "xdot = a*y;\nydot = -x^2;");
/// assert_eq!(read.parameters, [("a".to_owned(), 2.into())]);
/// ```
#[must_use]
pub fn read(text: &str) -> Reading {
    let Lexed { tokens, ranges, is_of_others } = lex(text);
    let count = tokens.len();
    let mut reader = Reader { text, given: tokens.into_iter().zip(ranges).collect(), ..Reader::default() };
    // SymPy and Mathematica write a system of equations as a list in brackets.
    if matches!((reader.at(0), reader.at(count.saturating_sub(1))), ("[", "]") | ("{", "}")) {
        reader.given = reader.given[1..count - 1].to_vec();
    }
    match reader.reaction() {
        Some(mistake) => reader.out.push(mistake),
        None => reader.read(),
    }
    let Reader { out, mut read, .. } = reader;
    let is_there = |(token, range): &PlacedToken| text.get(range.clone()) == Some(&token.text);
    read.is_canonical = count == out.len() && !is_of_others && out.iter().all(is_there);
    (read.lexed.tokens, read.lexed.ranges) = out.into_iter().unzip();
    read
}

/// A token and its byte range in the text.
type PlacedToken = (Token, Range<usize>);

fn placed_token(text: &str, range: &Range<usize>) -> PlacedToken {
    let kind = text.chars().next().map_or(TokenKind::Identifier, TokenKind::beginning_with);
    (Token { kind, text: text.to_owned().into(), touches_next: false, docs: Box::default() }, range.clone())
}

fn mistake(range: &Range<usize>, message: impl Into<String>, help: impl Into<String>) -> PlacedToken {
    let (token, range) = placed_token("", range);
    (Token { kind: TokenKind::unreadable(message, help), ..token }, range)
}

#[derive(Default)]
struct Reader<'a> {
    text: &'a str,
    given: Vec<PlacedToken>,
    names: OnceCell<HashSet<String>>,
    /// The states. A state with an equation of order n has n − 1 further names, for its
    /// derivatives.
    states: HashMap<String, Vec<String>>,
    has_derivatives: bool,
    /// The formulas of auxiliary quantities, by name.
    quantities: HashMap<String, Vec<PlacedToken>>,
    functions: HashMap<String, Function>,
    /// The tokens given for each argument name of the function that is being expanded.
    arguments: HashMap<String, Vec<PlacedToken>>,
    /// The functions whose calls are being expanded, the outermost call first.
    calls: Vec<String>,
    depth: usize,
    /// The number of tokens that expansions have added so far.
    added: usize,
    out: Vec<PlacedToken>,
    read: Reading,
}

impl Reader<'_> {
    fn at(&self, place: usize) -> &str {
        self.given.get(place).map_or("", |(token, _)| &token.text)
    }

    fn is_name(&self, place: usize) -> bool {
        self.given.get(place).is_some_and(|(token, _)| token.kind == TokenKind::Identifier)
    }

    fn names_in(&self, tokens: Range<usize>) -> impl Iterator<Item = &str> {
        tokens.filter(|place| self.is_name(*place)).map(|place| self.at(place))
    }

    fn mentions(&self, name: &str) -> bool {
        let all = || self.names_in(0..self.given.len()).map(str::to_owned).collect();
        self.names.get_or_init(all).contains(name)
    }

    /// Returns whether the equations define a state or a derivative with this name.
    fn is_state(&self, name: &str) -> bool {
        self.states.contains_key(name)
    }

    fn bytes(&self, tokens: Range<usize>) -> Range<usize> {
        self.given[tokens.start].1.start..self.given[tokens.end - 1].1.end
    }

    fn has_header(&self) -> bool {
        matches!(self.at(0), "pub" | "struct" | "#")
    }

    fn note(&mut self, note: &str) {
        let note = brief(note);
        if !self.read.notes.contains(&note) {
            self.read.notes.push(note);
        }
    }

    fn reaction(&self) -> Option<PlacedToken> {
        let is_arrow =
            |pair: &[PlacedToken]| pair[0].0.text == "-" && pair[1].0.text == ">" && pair[0].0.touches_next;
        let place = self.given.windows(2).position(is_arrow)?;
        let help = format!(
            "write the rate of each species, as in `Adot = -k*A*B;`: {ON_TEXTS} shows how, also for Antimony and SBML"
        );
        let message = "`->` writes a reaction, and a field has equations";
        Some(mistake(&self.bytes(place..place + 2), message, help))
    }

    fn read(&mut self) {
        let items = self.items();
        self.name_derivatives(&items);
        let instead = self.read_quantities(&items);
        for (item, instead) in items.iter().zip(instead) {
            self.write(item, instead);
        }
        self.define_pi();
    }

    /// Gives the parameter `pi` its value, unless the text defines `pi` itself.
    fn define_pi(&mut self) {
        const PI: &str = "3.141592653589793";
        let is_read = self.is_state("pi") || self.quantities.contains_key("pi") || self.has_header();
        if is_read || !self.mentions("pi") || self.read.parameters.iter().any(|(name, _)| name == "pi") {
            return;
        }
        self.note(&format!("numbers are exact: pi is the parameter `pi` with the value {PI}"));
        let value = Rational::parse(PI).expect("digits");
        self.read.parameters.push(("pi".to_owned(), value));
    }

    /// Writes an item, or the tokens that replace it, followed by `;`.
    fn write(&mut self, TextItem { tokens, left, is_ended }: &TextItem, instead: Option<Vec<PlacedToken>>) {
        let is_bracket = self.at(tokens.start) == "bracket";
        let written = match (instead, left) {
            (Some(instead), _) if instead.is_empty() => return,
            (Some(instead), _) => instead,
            (None, Some(left)) if !left.is_value() => self.equation(tokens, left),
            (None, None) if let Some(refused) = self.unsupported_item(tokens) => vec![refused],
            _ => self.written(tokens.clone(), false),
        };
        self.out.extend(written);
        if *is_ended {
            self.out.push(self.given[tokens.end].clone());
        } else if let Some((last, range)) = self.out.last()
            && !is_bracket
            && !matches!(&*last.text, "{" | "}")
        {
            let end = placed_token(";", &(range.end..range.end));
            self.out.push(end);
        }
    }
}
