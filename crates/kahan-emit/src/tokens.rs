//! Turns the compiler's tokens, or the text of an included file, into a flat list of tokens.

use std::ops::Range;

use kahan_algebra::lexer::{Lexed, lex};
use kahan_algebra::syntax::WrittenTokens;
use kahan_algebra::token::{Token, TokenKind};
use proc_macro2::{Delimiter, Group, Spacing, Span, TokenStream, TokenTree};

/// The text of an included file. The compiler does not know the positions of its tokens.
pub(crate) struct Source {
    pub(crate) text: String,
    pub(crate) ranges: Vec<Range<usize>>,
    pub(crate) origin: String,
}

pub(crate) struct FlatTokens {
    pub(crate) tokens: Vec<Token>,
    pub(crate) spans: Vec<Span>,
    /// For each token, the tree that begins there and the index of the tree's last token. At
    /// closing brackets it is `None`.
    trees: Vec<Option<(TokenTree, usize)>>,
    pub(crate) source: Option<Source>,
}

pub(crate) fn of_text(text: String, origin: String, span: Span) -> FlatTokens {
    let Lexed { tokens, ranges, .. } = lex(&text);
    let spans = vec![span; tokens.len()];
    FlatTokens { tokens, spans, trees: Vec::new(), source: Some(Source { text, ranges, origin }) }
}

/// Flattens a stream of tokens. An explicit stack replaces recursion.
pub(crate) fn flatten(stream: TokenStream) -> FlatTokens {
    let mut flat = FlatTokens { tokens: Vec::new(), spans: Vec::new(), trees: Vec::new(), source: None };
    let mut open: Vec<(proc_macro2::token_stream::IntoIter, Option<(Group, usize)>)> =
        vec![(stream.into_iter(), None)];
    while let Some((trees, _)) = open.last_mut() {
        match trees.next() {
            Some(TokenTree::Group(group)) => {
                let (opening, _) = brackets(&group);
                flat.push(TokenKind::Open(opening), opening.to_string(), group.span_open(), false);
                open.push((group.stream().into_iter(), Some((group, flat.trees.len()))));
                flat.trees.push(None);
            }
            Some(tree) => {
                flat.push_leaf(&tree);
                flat.trees.push(Some((tree, flat.trees.len())));
            }
            None => {
                if let Some((_, Some((group, opening)))) = open.pop() {
                    let (_, closing) = brackets(&group);
                    flat.push(TokenKind::Close(closing), closing.to_string(), group.span_close(), false);
                    flat.trees[opening] = Some((group.into(), flat.trees.len()));
                    flat.trees.push(None);
                }
            }
        }
    }
    flat
}

/// Returns a group's brackets; parentheses for a group without any, such as a captured `$e:expr`.
fn brackets(group: &Group) -> (char, char) {
    match group.delimiter() {
        Delimiter::Parenthesis | Delimiter::None => ('(', ')'),
        Delimiter::Bracket => ('[', ']'),
        Delimiter::Brace => ('{', '}'),
    }
}

impl FlatTokens {
    /// Returns the compiler's tokens for attributes or a visibility of a block.
    pub(crate) fn rust(&self, written: &WrittenTokens) -> TokenStream {
        match (&self.source, written.span) {
            (Some(_), _) => written.lines.join("\n").parse().unwrap_or_default(),
            (None, Some(span)) => self.slice(span),
            (None, None) => TokenStream::new(),
        }
    }

    /// Returns the compiler's tokens of a span, which must contain whole groups only.
    fn slice(&self, span: kahan_algebra::token::Span) -> TokenStream {
        let mut next = span.first;
        let trees = core::iter::from_fn(|| {
            let (tree, last) = self.trees.get(next).filter(|_| next <= span.last)?.as_ref()?;
            next = last + 1;
            Some(tree.clone())
        });
        trees.collect()
    }

    fn push(&mut self, kind: TokenKind, text: String, span: Span, touches_next: bool) {
        self.tokens.push(Token { kind, text: text.into(), touches_next, docs: Box::default() });
        self.spans.push(span);
    }

    fn push_leaf(&mut self, tree: &TokenTree) {
        match tree {
            TokenTree::Ident(ident) => {
                let text = ident.to_string();
                let text = text.strip_prefix("r#").map(str::to_owned).unwrap_or(text);
                self.push(TokenKind::Identifier, text, ident.span(), false);
            }
            TokenTree::Literal(literal) => {
                self.push(TokenKind::Literal, literal.to_string(), literal.span(), false);
            }
            TokenTree::Punct(punct) => self.push(
                TokenKind::Punctuation(punct.as_char()),
                punct.as_char().to_string(),
                punct.span(),
                punct.spacing() == Spacing::Joint,
            ),
            TokenTree::Group(_) => {}
        }
    }
}
