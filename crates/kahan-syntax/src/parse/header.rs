//! Reads the header, `attributes [lift] visibility struct Name;` or `… struct Name { a, b }`.
//!
//! Parameters are names without types. Attributes stay tokens.

use crate::diagnostics::{Diagnostic, Diagnostics, Kind};
use crate::syntax::{Header, Name, WrittenTokens};
use crate::token::{Span, Token, TokenKind};

use super::Parsed;
use super::cursor::Cursor;

const LIFT_KEYWORD: &str = "lift";

pub(super) fn is_lift(cursor: &Cursor<'_>) -> bool {
    let is_keyword = cursor.is_punctuation(1, ';')
        || cursor.is_punctuation(1, '#')
        || matches!(cursor.identifier(1), Some("pub" | "struct"));
    cursor.identifier(0) == Some(LIFT_KEYWORD) && is_keyword
}

/// Reads the header, or `lift;` if there is no header. Sets `lift` to the position of the keyword.
pub(super) fn parse_header(
    cursor: &mut Cursor<'_>,
    lift: &mut Option<Span>,
    diagnostics: &mut Diagnostics,
) -> Option<Header> {
    if is_lift(cursor) && cursor.is_punctuation(1, ';') {
        *lift = Some(cursor.here());
        cursor.advance();
        cursor.advance();
        return None;
    }
    let names_a_type = cursor.identifier(1).is_some();
    let begins = is_lift(cursor)
        || cursor.is_punctuation(0, '#')
        || matches!(cursor.identifier(0), Some("pub" | "struct"))
        || (matches!(cursor.identifier(0), Some("enum" | "union" | "type")) && names_a_type);
    if !begins {
        return None;
    }
    match header(cursor, lift, diagnostics) {
        Ok(header) => Some(header),
        Err(diagnostic) => {
            diagnostics.push(diagnostic);
            skip_header(cursor);
            None
        }
    }
}

fn header(cursor: &mut Cursor<'_>, lift: &mut Option<Span>, diagnostics: &mut Diagnostics) -> Parsed<Header> {
    let mut attributes = attributes(cursor);
    if is_lift(cursor) {
        *lift = Some(cursor.here());
        cursor.advance();
        attributes.lines.extend(docs(cursor));
    }
    let mut visibility = WrittenTokens::default();
    if cursor.identifier(0) == Some("pub") {
        let start = cursor.here();
        cursor.advance();
        if cursor.is_open(0, '(') {
            cursor.skip_group();
        }
        visibility = WrittenTokens {
            lines: vec![cursor.written_since(start.first)],
            span: Some(start.to(cursor.behind())),
        };
        attributes.lines.extend(docs(cursor));
        if is_lift(cursor) {
            let wrong = "`lift` stands before the visibility";
            diagnostics.report(Kind::Header, cursor.here(), wrong, "write `lift pub struct Name`");
            *lift = Some(cursor.here());
            cursor.advance();
        }
    }
    if cursor.identifier(0) != Some("struct") {
        let wrong = cursor.missing(
            Kind::Header,
            cursor.here(),
            "`struct`",
            "a header reads `pub struct Name;` or `pub struct Name { mu, nu }`",
        );
        // Only if a name follows, as in `enum Name`, the header is read, so that the type exists.
        if cursor.identifier(0).is_none() || cursor.identifier(1).is_none() {
            return Err(wrong);
        }
        diagnostics.push(wrong);
    }
    cursor.advance();
    let name = cursor.expect_name("the name of the system").unwrap_or_else(|missing| {
        diagnostics.push(Diagnostic { kind: Kind::Header, ..missing });
        Name { text: "Nameless".to_owned(), span: cursor.here() }
    });
    let mut header = Header { attributes, visibility, name, parameters: Vec::new(), described: Vec::new() };
    if cursor.is_punctuation(0, '<') {
        let start = cursor.here();
        while !cursor.is_at_end()
            && !cursor.is_punctuation(0, '>')
            && !cursor.is_open(0, '{')
            && !cursor.is_punctuation(0, ';')
        {
            cursor.advance();
        }
        cursor.take('>');
        diagnostics.report(
            Kind::Header,
            header.name.span.to(start).to(cursor.behind()),
            format!("`{}` takes no type parameters: the macro adds the scalar type itself", header.name.text),
            format!("write `struct {} {{ … }}` with the names of the parameters only", header.name.text),
        );
    }
    if cursor.is_open(0, '{') {
        parameters(cursor, '}', &mut header, diagnostics);
        cursor.take(';');
    } else if !cursor.take(';') {
        diagnostics.push(missing_end(cursor, &header.name));
        if cursor.is_open(0, '(') {
            parameters(cursor, ')', &mut header, diagnostics);
            cursor.take(';');
        }
    }
    Ok(header)
}

fn missing_end(cursor: &Cursor<'_>, name: &Name) -> Diagnostic {
    let (span, help) = if cursor.is_open(0, '(') {
        (cursor.here(), format!("write `struct {} {{ mu, nu }}`: parameters have names", name.text))
    } else {
        (name.span.to(cursor.here()), format!("write `struct {};`", name.text))
    };
    let found = cursor.describe_next();
    Diagnostic::new(
        Kind::Header,
        span,
        format!("a header ends with `;` or its parameters, found {found}"),
        help,
    )
}

fn parameters(cursor: &mut Cursor<'_>, close: char, header: &mut Header, diagnostics: &mut Diagnostics) {
    cursor.advance();
    while cursor.peek(0).is_some_and(|token| !matches!(token.kind, TokenKind::Close(_))) {
        let described = attributes(cursor);
        let start = cursor.here();
        if cursor.identifier(0) == Some("pub") && cursor.identifier(1).is_some() {
            cursor.advance();
            diagnostics.report(Kind::Header, start, "a parameter is public as it is", "remove the `pub`");
        }
        match cursor.expect_name("the name of a parameter") {
            Ok(name) => {
                header.parameters.push(name);
                header.described.push(described);
            }
            Err(diagnostic) => {
                diagnostics.push(Diagnostic { kind: Kind::Header, ..diagnostic });
                skip_to_comma(cursor);
                continue;
            }
        }
        if !cursor.is_punctuation(0, ',') && !cursor.is_close(close) {
            let name = header.parameters.last().map_or(String::new(), |name| name.text.clone());
            let from = cursor.here();
            let (message, help) = if cursor.is_punctuation(0, ':') {
                (
                    format!(
                        "the parameter `{name}` carries a type: the macro gives it the scalar type itself"
                    ),
                    format!("write `{name}` alone"),
                )
            } else if cursor.is_punctuation(0, '=') {
                (
                    format!("the parameter `{name}` carries a value"),
                    format!("write `{name}` alone, or fix it by `const {name} = …;` after the header"),
                )
            } else {
                (
                    format!("expected `,` after the parameter `{name}`"),
                    "separate parameters by `,`".to_owned(),
                )
            };
            // If a comma is missing, the next name is still read as a parameter.
            if cursor.identifier(0).is_none() {
                skip_to_comma_or_end(cursor);
            }
            diagnostics.report(Kind::Header, start.to(from).to(cursor.behind()), message, help);
        }
        cursor.take(',');
    }
    if cursor.is_close(close) {
        cursor.advance();
    } else {
        let help = format!("write `{close}`");
        diagnostics.report(Kind::Header, cursor.here(), "the list of parameters is not closed", help);
    }
}

fn attributes(cursor: &mut Cursor<'_>) -> WrittenTokens {
    let (begin, mut lines) = (cursor.here(), docs(cursor));
    let mut span = None;
    while cursor.is_punctuation(0, '#') {
        let start = cursor.position();
        cursor.advance();
        cursor.take('!');
        if cursor.is_open(0, '[') {
            cursor.skip_group();
        }
        lines.push(cursor.written_since(start));
        lines.extend(docs(cursor));
        span = Some(begin.to(cursor.behind()));
    }
    WrittenTokens { lines, span }
}

fn docs(cursor: &Cursor<'_>) -> Vec<String> {
    cursor.peek(0).map_or_else(Vec::new, |token| token.docs.to_vec())
}

fn skip_to_comma(cursor: &mut Cursor<'_>) {
    skip_to_comma_or_end(cursor);
    cursor.take(',');
}

fn skip_to_comma_or_end(cursor: &mut Cursor<'_>) {
    let is_close = |token: &Token| matches!(token.kind, TokenKind::Close(_));
    cursor.skip_until(|cursor| cursor.is_punctuation(0, ',') || cursor.peek(0).is_some_and(is_close));
}

/// Skips a broken header, up to its end or the first item.
fn skip_header(cursor: &mut Cursor<'_>) {
    cursor.skip_until(|cursor| {
        cursor.begins_item(0) || cursor.is_open(0, '{') || cursor.is_punctuation(0, ';')
    });
    if cursor.is_open(0, '{') {
        cursor.skip_group();
    }
    cursor.take(';');
}
