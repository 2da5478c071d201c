//! Recognises notation of other languages next to an operand. Examples are calls, paths, indices,
//! products without `*`, and statements. Most mistakes propose the notation of this language.

use crate::diagnostics::Kind;
use crate::spelling::{LIFTS, NOT_QUADRATIC, ON_TEXTS, fresh};
use crate::syntax::{Expr, ExprKind};
use crate::token::{Span, Token, TokenKind};

use super::cursor::{Cursor, ExpressionEnd};
use super::{Parsed, error};

/// Reports that no operand follows the operator or `=` that was just read.
pub(super) fn missing_operand<T>(cursor: &Cursor<'_>) -> Parsed<T> {
    let found = cursor.describe_next();
    let before = cursor.behind();
    let ends = cursor
        .peek(0)
        .is_none_or(|token| matches!(token.kind, TokenKind::Punctuation(';' | ',') | TokenKind::Close(_)));
    if cursor.is_punctuation(0, '|') {
        let help = format!(
            "write a smooth function, or study each side of the corner; {ON_TEXTS} says what else can be done"
        );
        let message = "|x| has a corner: Kahan's method needs an analytic field";
        return error(Kind::NotAPolynomial, before.to(cursor.here()), message, help);
    }
    let (message, help) = if !ends {
        (format!("{found} begins no operand"), "write a number, a name or `(`")
    } else if cursor.before(1).is_some_and(|token| token.kind == TokenKind::Punctuation('=')) {
        (
            format!("the right-hand side is empty: expected an expression, found {found}"),
            "write an expression, `0` if it vanishes",
        )
    } else {
        (
            format!("an operand is missing: expected a number, a name or `(`, found {found}"),
            "write the operand, or remove the operator",
        )
    };
    error(Kind::Syntax, before.to(cursor.here()), message, help)
}

/// Checks that no call, path, field, method or index follows a name.
pub(super) fn check_plain_name(cursor: &mut Cursor<'_>, name: &str, span: Span) -> Parsed<()> {
    if is_statement(name) && cursor.is_open(0, '(') {
        return no_statement(span.to(cursor.skip_group()));
    }
    if cursor.is_open(0, '(') {
        let (group, arguments) = cursor.take_group();
        if let [time, _, ..] = arguments
            && time.text == "t"
        {
            let help = format!("a chain of states can stand for it: {ON_TEXTS} shows how");
            return error(Kind::NotAPolynomial, span.to(group), format!("`{name}(t …)` is a delay"), help);
        }
        let has_several =
            arguments.is_empty() || arguments.iter().any(|one| one.kind == TokenKind::Punctuation(','));
        let (message, help) = if is_function(name) || has_several {
            (
                format!("`{name}(…)` is a function call: fields here are polynomial, claims rational"),
                instead_of_call(cursor, name, arguments),
            )
        } else {
            let is_of_time = matches!(arguments, [time] if time.text == "t");
            let instead = if is_of_time {
                format!("write `{name}`")
            } else {
                format!("for a product write `{name}*(…)`")
            };
            (format!("`{name}(…)` reads as a function call"), instead)
        };
        return error(Kind::NotAPolynomial, span.to(group), message, help);
    }
    let is_path = cursor.is_pair(':', ':');
    let dotted = cursor.is_punctuation(0, '.').then(|| cursor.identifier(1)).flatten();
    if let Some(member) = dotted
        && cursor.is_open(2, '(')
    {
        let span = span.to(Span::token(cursor.position() + 1));
        let help = if matches!(member, "powi" | "pow" | "powf") {
            format!("write `{name}^2`")
        } else {
            "write the expression out; the field must be polynomial".to_owned()
        };
        return error(Kind::NotAPolynomial, span, format!("`{name}.{member}(…)` is a method call"), help);
    }
    if is_path || dotted.is_some() || cursor.is_open(0, '[') {
        return error_of_access(cursor, name, span);
    }
    Ok(())
}

/// Reports an access such as `self.mu`, `physics::RATE` or `mu[0]`, whose first name was read.
fn error_of_access<T>(cursor: &mut Cursor<'_>, name: &str, span: Span) -> Parsed<T> {
    let mut access = name.to_owned();
    let mut last = name;
    loop {
        let steps = if cursor.is_pair(':', ':') { 2 } else { usize::from(cursor.is_punctuation(0, '.')) };
        if let Some(member) = cursor.identifier(steps).filter(|_| steps > 0) {
            access.push_str(if steps == 2 { "::" } else { "." });
            access.push_str(member);
            last = member;
            (0..=steps).for_each(|_| cursor.advance());
        } else if cursor.is_open(0, '[') {
            access.push_str("[…]");
            cursor.skip_group();
        } else {
            break;
        }
    }
    let bound = last.to_lowercase();
    let message = format!("only plain names are read here, and `{access}` is a path, a field or an index");
    let help = format!(
        "bind it first: `let {bound} = {access};`, then write `{bound}`; in a system with a header, make it a \
         parameter"
    );
    error(Kind::NotAPolynomial, span.to(cursor.behind()), message, help)
}

const ANALYTIC_FUNCTIONS: &str = "sin cos tan cot sec csc asin acos atan atan2 sinh cosh tanh sech exp log ln log2 log10 sqrt cbrt pow erf gamma";
/// Names of analytic functions that `kahan lift` turns into states.
const LIFTABLE_FUNCTIONS: &str = "sin cos tan asin acos atan sinh cosh tanh exp log ln sqrt cbrt pow";
const NONANALYTIC_FUNCTIONS: &str =
    "abs heav flr sign sgn max min floor ceil round mod heaviside Heaviside piecewise";

pub(crate) fn is_function(name: &str) -> bool {
    [ANALYTIC_FUNCTIONS, NONANALYTIC_FUNCTIONS]
        .iter()
        .any(|names| names.split(' ').any(|known| known == name))
}

/// Proposes a replacement for a function call: a new state, or a constant.
fn instead_of_call(cursor: &Cursor<'_>, name: &str, arguments: &[Token]) -> String {
    if NONANALYTIC_FUNCTIONS.split(' ').any(|known| known == name) {
        return format!(
            "it is not analytic everywhere, and Kahan's method needs a field that is: {ON_TEXTS} says what can be done"
        );
    }
    let next = |place: usize| arguments.get(place + 1).map(|token| &token.kind);
    let is_state = |(place, token): (usize, &Token)| {
        token.kind == TokenKind::Identifier
            && (token.text == "t"
                || cursor.mentions(&format!("{}dot", token.text))
                || next(place) == Some(&TokenKind::Open('[')))
    };
    if cursor.is_lifted {
        return "a claim names the new variables of the lift, such as `cos_x`: `NEW_VARIABLES` lists them"
            .to_owned();
    }
    if arguments.iter().any(|token| token.kind == TokenKind::Open('[')) {
        return format!(
            "introduce a state of the sites for `{name}(…)`, such as `s[i]`, with an equation of its own that is quadratic: \
             {NOT_QUADRATIC} shows how"
        );
    }
    if arguments.iter().enumerate().any(is_state) {
        if LIFTABLE_FUNCTIONS.split(' ').any(|known| known == name) {
            return format!("{LIFTS}, with a state for `{name}(…)`: {NOT_QUADRATIC} shows how");
        }
        return format!(
            "introduce a state for `{name}(…)`, with an equation of its own that is quadratic: {NOT_QUADRATIC} shows how"
        );
    }
    let own = fresh(&["c", "k", "r"], |name| cursor.mentions(name));
    let number = match arguments {
        [one] if name == "sqrt" => one.text.replace('_', "").parse::<f64>().ok().map(f64::sqrt),
        _ => None,
    };
    match number.filter(|root| root.is_finite()) {
        Some(root) => format!("it is a number: write `const {own} = {root};` above, and `{own}` here"),
        None => format!(
            "it depends on no state: write a parameter for it, such as `{own}`, or `const {own} = …;` above"
        ),
    }
}

/// Returns whether the name is a keyword with which a Rust statement begins.
pub(crate) fn is_statement(name: &str) -> bool {
    matches!(name, "if" | "match" | "let" | "for" | "while")
}

fn no_statement<T>(span: Span) -> Parsed<T> {
    let message = "a formula has no conditions, loops or statements: Kahan's method is for smooth fields";
    let help = format!("write one polynomial that holds everywhere; {ON_TEXTS} says what else can be done");
    error(Kind::NotAPolynomial, span, message, help)
}

/// Checks that an operator, or the end of the expression, follows an operand.
pub(super) fn after_operand<X>(cursor: &Cursor<'_>, operand: Expr<X>) -> Parsed<Expr<X>> {
    let Some(token) = cursor.peek(0) else { return Ok(operand) };
    let span = operand.span.to(cursor.here());
    let name = if let ExprKind::Name(name) = &operand.kind { name.as_str() } else { "" };
    match &token.kind {
        TokenKind::Punctuation('+' | '-' | '*' | '/' | '^' | ';' | ',') | TokenKind::Close(_) => Ok(operand),
        TokenKind::Unreadable(_) => Ok(operand),
        // `equals` reads the `=` of a relation, and reports comparisons such as `==`.
        TokenKind::Punctuation('=' | '<' | '>' | '!') if cursor.end == ExpressionEnd::Equals => Ok(operand),
        TokenKind::Punctuation(_) if cursor.end == ExpressionEnd::Formula => Ok(operand),
        TokenKind::Identifier if token.text == "when" => Ok(operand),
        TokenKind::Identifier if token.text == "by" && cursor.end == ExpressionEnd::By => Ok(operand),
        TokenKind::Identifier if cursor.begins_item(0) && cursor.end == ExpressionEnd::Item => Ok(operand),
        TokenKind::Identifier if cursor.begins_item(0) => {
            let message = format!("a `;` is missing before `{}`", token.text);
            let help = format!("write `;` before `{}`", token.text);
            error(Kind::Syntax, cursor.behind().to(cursor.here()), message, help)
        }
        TokenKind::Identifier if is_statement(&token.text) || is_statement(name) => no_statement(span),
        TokenKind::Identifier | TokenKind::Literal | TokenKind::Open('(') => {
            let help = match token.kind {
                _ if cursor.end == ExpressionEnd::Formula => {
                    "write `2*i` for a product, and `sin(i)` for a function of `i`".to_owned()
                }
                TokenKind::Open(_) => "write `*` before `(`".to_owned(),
                _ if is_function(name) => format!("write `{name}(…)`: {NOT_QUADRATIC} has functions"),
                _ => format!("write `*` before `{}`", token.text),
            };
            error(Kind::Syntax, span, "two operands stand side by side: a product needs its `*`", help)
        }
        TokenKind::Open('[') if matches!(operand.kind, ExprKind::Number(_)) => {
            let help = "write the number alone, all quantities in units that fit each other";
            error(Kind::Syntax, span, "units are not read", help)
        }
        TokenKind::Punctuation('.') if matches!(operand.kind, ExprKind::Number(_)) => {
            let help = "write `2.0` for the number, and `2*x` for a product";
            error(Kind::Number, span, "a number ends before this point", help)
        }
        TokenKind::Punctuation('.') => {
            let method = cursor.identifier(1).unwrap_or("");
            let help = match method {
                "powi" | "pow" | "powf" => "write `(…)^2`",
                _ => "write the expression out; the field must be polynomial",
            };
            error(Kind::NotAPolynomial, span, format!("`.{method}` is a method call or a field"), help)
        }
        TokenKind::Punctuation('=') => {
            let help = "an equation has one `=`; if a new one begins here, write `;` before it";
            error(Kind::Syntax, span, "an `=` inside an expression", help)
        }
        TokenKind::Punctuation('<' | '>' | '?' | '&' | '|') => no_statement(span),
        _ => {
            let message = format!("`{}` is not an operator of the language", token.text);
            error(Kind::Syntax, cursor.here(), message, "the operators are `+`, `-`, `*`, `/` and `^`")
        }
    }
}
