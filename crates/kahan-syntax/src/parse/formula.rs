//! Reads formulas outside blocks, with function calls and general exponents.
//!
//! The caller evaluates the formulas, and decides which functions exist.

use crate::diagnostics::{Diagnostic, Kind};
use crate::syntax::{Expr, ExprKind, FormulaSyntax, Name};
use crate::token::{Span, Token};

use super::block::equals;
use super::cursor::Cursor;
use super::expr::{Dialect, atom, in_parentheses, parse_expr, sum};
use super::{Parsed, error};

/// Reads a formula such as `1 + cos(2*pi*i/n)/2` or `x^y`.
///
/// # Errors
/// Returns the first mistake. Tokens after the formula are a mistake too.
///
/// ```
/// use kahan_syntax::{lexer::lex, parse::parse_formula};
///
/// assert!(parse_formula(&lex("1 + cos(2*x)^0.5").tokens).is_ok());
/// let mistake = parse_formula(&lex("1 + cos(2 x)").tokens).expect_err("no product");
/// assert!(mistake.help.contains("2*i"));
/// ```
pub fn parse_formula(tokens: &[Token]) -> Result<Expr<FormulaSyntax>, Diagnostic> {
    let mut cursor = Cursor::of_formulas(tokens);
    let formula = parse_expr(&mut cursor)?;
    check_end(&cursor)?;
    Ok(formula)
}

/// Reads a list of named formulas such as `x = 1; y = i/n;`. The list may be empty.
///
/// # Errors
/// Returns the first mistake.
pub fn parse_formulas(tokens: &[Token]) -> Result<Vec<(Name, Expr<FormulaSyntax>)>, Diagnostic> {
    let mut cursor = Cursor::of_formulas(tokens);
    let mut formulas = Vec::new();
    while !cursor.is_at_end() {
        let name = cursor.expect_name("a name, as in `x = 1`")?;
        equals(&mut cursor)?;
        formulas.push((name, parse_expr(&mut cursor)?));
        if !cursor.take(';') {
            check_end(&cursor)?;
        }
    }
    Ok(formulas)
}

fn check_end(cursor: &Cursor<'_>) -> Parsed<()> {
    if cursor.is_at_end() {
        return Ok(());
    }
    let help = if cursor.is_punctuation(0, '=') {
        "a formula has a value and no `=`: write `x` where it is to be 0, `x - y` for `x = y`"
    } else {
        "put an operator in between, as in `2*i`; formulas with names are separated by `;`"
    };
    error(Kind::Syntax, cursor.here(), "the formula should end here", help)
}

impl Dialect for FormulaSyntax {
    fn behind_name(cursor: &mut Cursor<'_>, name: &str, _: Span, depth: usize) -> Parsed<Option<Self>> {
        if !cursor.is_open(0, '(') {
            return Ok(None);
        }
        let arguments = in_parentheses(cursor, depth, |cursor, depth| {
            let mut arguments = vec![sum(cursor, depth)?];
            while cursor.take(',') {
                arguments.push(sum(cursor, depth)?);
            }
            Ok(arguments)
        })?;
        Ok(Some(FormulaSyntax::Call { function: name.to_owned(), arguments }))
    }

    /// Reads an exponent, which may have a sign: `2^-x` is 2^(−x).
    fn power(cursor: &mut Cursor<'_>, base: Expr<Self>, depth: usize) -> Parsed<ExprKind<Self>> {
        let sign = cursor.here();
        let is_negative = cursor.take('-');
        let mut exponent = atom(cursor, depth)?;
        if let ExprKind::Number(value) = &exponent.kind
            && let Some(size) = value.as_i64()
        {
            return Ok(ExprKind::Power(Box::new(base), if is_negative { -size } else { size }));
        }
        if is_negative {
            let span = sign.to(exponent.span);
            exponent = Expr { kind: ExprKind::Negation(Box::new(exponent)), span };
        }
        Ok(ExprKind::Special(FormulaSyntax::Power(Box::new([base, exponent]))))
    }
}

#[cfg(test)]
mod tests {
    use super::{parse_formula, parse_formulas};
    use crate::diagnostics::Kind;
    use crate::lexer::lex;
    use crate::syntax::{Expr, ExprKind, FormulaSyntax};

    fn grouped(expr: &Expr<FormulaSyntax>) -> String {
        let list = |parts: Vec<String>| format!("({})", parts.join(" "));
        match &expr.kind {
            ExprKind::Number(value) => value.to_string(),
            ExprKind::Name(name) => name.clone(),
            ExprKind::Negation(inner) => format!("(-{})", grouped(inner)),
            ExprKind::Sum(terms) => {
                let sign = |negative| if negative { "-" } else { "+" };
                list(terms.iter().map(|term| sign(term.negative).to_owned() + &grouped(&term.expr)).collect())
            }
            ExprKind::Product(factors) => {
                let sign = |divides| if divides { "/" } else { "*" };
                list(factors.iter().map(|of| sign(of.divides).to_owned() + &grouped(&of.expr)).collect())
            }
            ExprKind::Power(base, exponent) => format!("({}^{exponent})", grouped(base)),
            ExprKind::Special(FormulaSyntax::Power(parts)) => {
                format!("({}^{})", grouped(&parts[0]), grouped(&parts[1]))
            }
            ExprKind::Special(FormulaSyntax::Call { function, arguments }) => {
                format!("{function}[{}]", arguments.iter().map(grouped).collect::<Vec<_>>().join(", "))
            }
        }
    }

    #[test]
    fn formulas_bind_as_the_language_does() {
        for (text, expected) in [
            ("-x^2*y", "(*(-(x^2)) *y)"),
            ("a - b/c*2 - -d", "(+a -(*b /c *2) -(-d))"),
            ("2^-1 + 2^(-1)", "(+(2^-1) +(2^(-1)))"),
            ("x^0.5*x^-y*x^2.0", "(*(x^1/2) *(x^(-y)) *(x^2))"),
            ("sin(x)^2", "(sin[x]^2)"),
            ("f(i, j - 1, g(2))/sum", "(*f[i, (+j -1), g[2]] /sum)"),
            ("x**2·y − ½*x³", "(+(*(x^2) *y) -(*(*1 /2) *(x^3)))"),
            ("1e99^1e99", &format!("(1{0}^1{0})", "0".repeat(99))),
        ] {
            let formula = parse_formula(&lex(text).tokens);
            assert_eq!(grouped(&formula.expect(text)), expected, "{text}");
        }
        let formulas = parse_formulas(&lex("x = f(1); y = x").tokens).expect("two");
        let written = formulas.iter().map(|(name, formula)| format!("{} {}", name.text, grouped(formula)));
        assert_eq!(written.collect::<Vec<_>>(), ["x f[1]", "y x"]);
    }

    #[test]
    fn formulas_nest_to_256_levels_and_are_as_long_as_one_likes() {
        for (open, first) in [("f(", 513), ("(", 256), ("-", 256), ("2^(", 770)] {
            let mistake = parse_formula(&lex(&open.repeat(10_000)).tokens).expect_err("too deep");
            assert_eq!((mistake.kind, mistake.span.first), (Kind::TooLarge, first), "{open}");
        }
        let nested = |levels| format!("{}1{}", "f(".repeat(levels), ")".repeat(levels));
        assert!(parse_formula(&lex(&nested(256)).tokens).is_ok());
        let long = vec!["f(x)*1"; 100_000].join(" - ");
        assert!(parse_formula(&lex(&long).tokens).is_ok());
    }

    #[test]
    fn mistakes_are_told_at_their_place() {
        let ends = "the formula should end here";
        for (text, place, message) in [
            ("", 0, "found the end of the formula"),
            ("1 +", 1, "found the end of the formula"),
            ("f()", 1, "an operand is missing"),
            ("f(1, )", 3, "an operand is missing"),
            ("f(1", 1, "this `(` is not closed"),
            ("f(1]", 1, "this `(` is not closed"),
            ("2 i", 0, "two operands stand side by side"),
            ("2i", 0, "a product needs its `*`"),
            ("1^2^x", 0, "`a^b^c` can be read in two ways"),
            ("1^x^2", 0, "`a^b^c` can be read in two ways"),
            ("1 = 2", 1, ends),
            ("1)", 1, ends),
            ("x.sin()", 1, ends),
            ("1;", 1, ends),
            ("1 \\ 2", 1, "no meaning in a field"),
        ] {
            let mistake = parse_formula(&lex(text).tokens).expect_err(text);
            assert_eq!(mistake.span.first, place, "{text}: {mistake}");
            assert!(mistake.message.contains(message), "{text}: {mistake}");
        }
        for (text, place, message) in [
            ("x", 0, "expected `=`"),
            ("= 1", 0, "expected a name"),
            ("3 = x", 0, "expected a name"),
            ("x = 1 y = 2", 2, "a `;` is missing before `y`"),
            ("x = 1, y = 2", 3, ends),
        ] {
            let mistake = parse_formulas(&lex(text).tokens).expect_err(text);
            assert_eq!(mistake.span.first, place, "{text}: {mistake}");
            assert!(mistake.message.contains(message), "{text}: {mistake}");
        }
    }
}
