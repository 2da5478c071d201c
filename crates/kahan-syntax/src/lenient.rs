//! Texts as people write them, in the tokens of the language.
//!
//! In: a text, such as `x' = y, y' = -x**2`. Out: the tokens of `xdot = y; ydot = -x^2;`, each with
//! its place in the text, and what the language has no words for: values of parameters, first
//! values of states, notes. The one parser reads these tokens, and what means nothing is left to
//! it. A text in the language of `kahan!` keeps its tokens.

mod items;
mod left;
mod quantities;
mod right;
mod xpp;

use std::cell::OnceCell;
use std::collections::{HashMap, HashSet};
use std::ops::Range;

use crate::diagnostics::brief;
use crate::lexer::{Lexed, lex};
use crate::rational::Rational;
use crate::spelling::ON_TEXTS;
use crate::token::{Token, TokenKind};

use items::Item;
use xpp::Function;

/// A text in the tokens of the language, and what it says besides.
#[derive(Clone, Debug, Default)]
pub struct Reading {
    /// The tokens of a block, and where each of them, or what it stands for, is in the text.
    pub lexed: Lexed,
    /// Whether the text has these tokens itself, and Rust's comments.
    pub is_canonical: bool,
    /// The values that the text gives to parameters.
    pub parameters: Vec<(String, Rational)>,
    /// The first values that the text gives to states.
    pub start: Vec<(String, Rational)>,
    /// Notes on what was read in a way that its writer should know of.
    pub notes: Vec<String>,
}

impl Reading {
    /// The tokens as a text in the language of `kahan!`.
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

/// Reads a text leniently. Never fails: mistakes are left in the tokens, for the parser to report.
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
    // A list of equations, as SymPy prints it and Mathematica takes it.
    if matches!((reader.at(0), reader.at(count.saturating_sub(1))), ("[", "]") | ("{", "}")) {
        reader.given = reader.given[1..count - 1].to_vec();
    }
    match reader.reaction() {
        Some(mistake) => reader.out.push(mistake),
        None => reader.read(),
    }
    let Reader { out, mut read, .. } = reader;
    let is_there = |(token, range): &Placed| text.get(range.clone()) == Some(&token.text);
    read.is_canonical = count == out.len() && !is_of_others && out.iter().all(is_there);
    (read.lexed.tokens, read.lexed.ranges) = out.into_iter().unzip();
    read
}

/// A token, and where it, or what it stands for, is in the text.
type Placed = (Token, Range<usize>);

/// A token of the language.
fn placed(text: &str, range: &Range<usize>) -> Placed {
    let kind = text.chars().next().map_or(TokenKind::Identifier, TokenKind::beginning_with);
    (Token { kind, text: text.to_owned().into(), touches_next: false, docs: Box::default() }, range.clone())
}

/// A token that is a mistake.
fn mistake(range: &Range<usize>, message: impl Into<String>, help: impl Into<String>) -> Placed {
    let (token, range) = placed("", range);
    (Token { kind: TokenKind::unreadable(message, help), ..token }, range)
}

#[derive(Default)]
struct Reader<'a> {
    text: &'a str,
    given: Vec<Placed>,
    /// All names that stand in the text.
    names: OnceCell<HashSet<String>>,
    /// The states, each with the names of its derivatives up to the order of its equation.
    states: HashMap<String, Vec<String>>,
    /// Whether some of them have derivatives with names.
    has_derivatives: bool,
    /// The tokens of quantities that are no states, by name.
    quantities: HashMap<String, Vec<Placed>>,
    /// The functions that the text defines, by name.
    functions: HashMap<String, Function>,
    /// The tokens of the arguments of the innermost call, by name.
    arguments: HashMap<String, Vec<Placed>>,
    /// The functions whose calls are being replaced, outermost first.
    calls: Vec<String>,
    /// The number of calls within calls.
    depth: usize,
    /// How many tokens the quantities have added.
    added: usize,
    out: Vec<Placed>,
    read: Reading,
}

impl Reader<'_> {
    /// The text of a token, empty behind the last.
    fn at(&self, place: usize) -> &str {
        self.given.get(place).map_or("", |(token, _)| &token.text)
    }

    fn is_name(&self, place: usize) -> bool {
        self.given.get(place).is_some_and(|(token, _)| token.kind == TokenKind::Identifier)
    }

    /// The names among some tokens.
    fn names_in(&self, tokens: Range<usize>) -> impl Iterator<Item = &str> {
        tokens.filter(|place| self.is_name(*place)).map(|place| self.at(place))
    }

    /// Whether a name stands anywhere in the text.
    fn mentions(&self, name: &str) -> bool {
        let all = || self.names_in(0..self.given.len()).map(str::to_owned).collect();
        self.names.get_or_init(all).contains(name)
    }

    /// Whether the equations define a state, or a derivative, of this name.
    fn is_state(&self, name: &str) -> bool {
        self.states.contains_key(name)
    }

    /// The bytes of some tokens, at least one.
    fn bytes(&self, tokens: Range<usize>) -> Range<usize> {
        self.given[tokens.start].1.start..self.given[tokens.end - 1].1.end
    }

    /// Whether the text has a header, or attributes, in the language of `kahan!`.
    fn has_header(&self) -> bool {
        matches!(self.at(0), "pub" | "struct" | "#")
    }

    fn note(&mut self, note: &str) {
        let note = brief(note);
        if !self.read.notes.contains(&note) {
            self.read.notes.push(note);
        }
    }

    /// The mistake of a text that holds reactions.
    fn reaction(&self) -> Option<Placed> {
        let is_arrow =
            |pair: &[Placed]| pair[0].0.text == "-" && pair[1].0.text == ">" && pair[0].0.touches_next;
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
        self.give_pi();
    }

    /// A parameter `pi` that has no value is the number.
    fn give_pi(&mut self) {
        const PI: &str = "3.141592653589793";
        let is_read = self.is_state("pi") || self.quantities.contains_key("pi") || self.has_header();
        if is_read || !self.mentions("pi") || self.read.parameters.iter().any(|(name, _)| name == "pi") {
            return;
        }
        self.note(&format!("numbers are exact: pi is the parameter `pi` with the value {PI}"));
        let value = Rational::parse(PI).expect("digits");
        self.read.parameters.push(("pi".to_owned(), value));
    }

    /// Writes an item, or what stands in its place, and its end.
    fn write(&mut self, Item { tokens, left, is_ended }: &Item, instead: Option<Vec<Placed>>) {
        let is_bracket = self.at(tokens.start) == "bracket";
        let written = match (instead, left) {
            (Some(instead), _) if instead.is_empty() => return,
            (Some(instead), _) => instead,
            (None, Some(left)) if !left.is_value() => self.equation(tokens, left),
            (None, None) if let Some(refused) = self.refused(tokens) => vec![refused],
            _ => self.written(tokens.clone(), false),
        };
        self.out.extend(written);
        if *is_ended {
            self.out.push(self.given[tokens.end].clone());
        } else if let Some((last, range)) = self.out.last()
            && !is_bracket
            && !matches!(&*last.text, "{" | "}")
        {
            let end = placed(";", &(range.end..range.end));
            self.out.push(end);
        }
    }
}
