//! Writes statements in LaTeX.

mod call;

use kahan_algebra::rational::Rational;
use kahan_algebra::render::{Notation, Precedence};
use kahan_latex::Latex;

use super::{Formula, Item, Relation, Statement, parse};
use call::{FUNCTIONS, OPEN_ENDED, call};

/// A definition or a relation in LaTeX.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LatexItem {
    /// The left-hand side.
    pub left: String,
    /// The sign between the sides: `\coloneqq`, `=`, `\neq` or `\approx`.
    pub sign: &'static str,
    /// The right-hand side.
    pub right: String,
}

/// Returns the items of a statement in LaTeX, or a message if the text is not a statement.
pub fn latex_of(text: &str) -> Result<Vec<LatexItem>, String> {
    Ok(parse(text)?.items.iter().map(item).collect())
}

/// Returns each item of a statement as one formula.
pub(crate) fn statement_latex(statement: &Statement) -> Vec<String> {
    let written = statement.items.iter().map(item);
    written.map(|LatexItem { left, sign, right }| format!("{left} {sign} {right}")).collect()
}

fn item(item: &Item) -> LatexItem {
    match item {
        Item::Definition(definition) => {
            let parameters: Vec<Formula> = definition.parameters.iter().cloned().map(Formula::Name).collect();
            let left = if parameters.is_empty() {
                name(&definition.name)
            } else {
                write(&Formula::Call(definition.name.clone(), parameters)).0
            };
            LatexItem { left, sign: "\\coloneqq", right: write(&definition.body).0 }
        }
        Item::Relation { left, relation, right, digit } => {
            let decimals = digit.as_ref().filter(|_| *relation == Relation::Approximate);
            let number = decimals.zip(right.as_number()).and_then(|(digit, value)| decimal(&value, digit));
            let sign = match relation {
                Relation::Equal => "=",
                Relation::Different => "\\neq",
                Relation::Approximate => "\\approx",
            };
            LatexItem { left: write(left).0, sign, right: number.unwrap_or_else(|| write(right).0) }
        }
    }
}

/// Writes a number with k decimals, where `digit` is 10^(−k). Returns `None` if k is 0.
fn decimal(value: &Rational, digit: &Rational) -> Option<String> {
    let places = digit.denominator().to_string().len() - 1;
    let units = value.checked_div(digit).filter(|_| places > 0)?;
    let size = format!("{:0>width$}", units.numerator().magnitude().to_string(), width = places + 1);
    let (whole, fraction) = size.split_at(size.len() - places);
    Some(format!("{}{whole}.{fraction}", if units.is_negative() { "-" } else { "" }))
}

/// Writes a name: `H_eps` as H(ε), `H_hat` as Ĥ, `P12` with indices, and `detA` as det A.
fn name(text: &str) -> String {
    let written = |stem| Latex.name(stem);
    match (text.strip_suffix("_eps"), text.strip_suffix("_hat"), text.strip_prefix("det")) {
        (Some(stem), ..) => format!("{}(\\varepsilon)", written(stem)),
        (_, Some(stem), _) => format!("\\widehat{{{}}}", written(stem)),
        (.., Some(matrix @ ("A" | "J"))) => format!("\\det {matrix}"),
        _ => match text.split_once('_') {
            // For example, `C1_e7` is C₁ of the system E7.
            Some((stem, system)) if stem.ends_with(|c: char| c.is_ascii_digit()) => {
                format!("{{{}}}^{{\\text{{{system}}}}}", name(stem))
            }
            Some((stem, index)) => format!("{}_{{{}}}", name(stem), name(index)),
            None => written(text).replace("\\mathit{", "\\text{"),
        },
    }
}

fn enclosed(text: &str) -> String {
    let is_high = ["\\frac", "\\sum", "\\left", "\\begin"].iter().any(|high| text.contains(high));
    if is_high { format!("\\left({text}\\right)") } else { format!("({text})") }
}

fn at_least(formula: &Formula, level: Precedence) -> String {
    let (text, own) = write(formula);
    if own >= level { text } else { enclosed(&text) }
}

fn write(formula: &Formula) -> (String, Precedence) {
    match formula {
        Formula::Number(value) => {
            let level = if value.is_integer() { Precedence::Atom } else { Precedence::Product };
            (Latex.number(value), level)
        }
        Formula::Name(text) => (name(text), Precedence::Atom),
        Formula::Negation(inner) => (format!("-{}", at_least(inner, Precedence::Product)), Precedence::Sum),
        Formula::Sum(terms) => {
            let mut text = String::new();
            for (index, (negative, term)) in terms.iter().enumerate() {
                text.push_str(match (index, negative) {
                    (0, false) => "",
                    (_, false) => " + ",
                    (_, true) => " - ",
                });
                text.push_str(&at_least(
                    term,
                    if index == 0 && !negative { Precedence::Sum } else { Precedence::Product },
                ));
            }
            (text, Precedence::Sum)
        }
        Formula::Product(factors) if factors.iter().any(|(divides, _)| *divides) => {
            let negative = matches!(factors.first(), Some((false, Formula::Negation(_))));
            let side = |wanted: bool| {
                let mut chosen: Vec<&Formula> = factors
                    .iter()
                    .filter(|(divides, _)| *divides == wanted)
                    .map(|(_, factor)| factor)
                    .collect();
                if chosen.len() > 1 {
                    chosen.retain(|factor| !factor.is_number(1));
                }
                let level = if chosen.len() > 1 { Precedence::Product } else { Precedence::Sum };
                let written = chosen.iter().enumerate().map(|(index, factor)| match factor {
                    Formula::Negation(inner) if index == 0 && !wanted => at_least(inner, level),
                    _ => at_least(factor, level),
                });
                if chosen.is_empty() { "1".to_owned() } else { joined(written.collect()) }
            };
            let fraction = format!("\\frac{{{}}}{{{}}}", side(false), side(true));
            if negative { (format!("-{fraction}"), Precedence::Sum) } else { (fraction, Precedence::Product) }
        }
        Formula::Product(factors) => {
            let written = factors.iter().enumerate().map(|(index, (_, factor))| match factor {
                Formula::Negation(_) if index == 0 => write(factor).0,
                _ => at_least(factor, Precedence::Product),
            });
            let level = match factors.first() {
                Some((_, Formula::Negation(_))) => Precedence::Sum,
                _ => Precedence::Product,
            };
            (joined(written.collect()), level)
        }
        Formula::Power(base, exponent) => match &**base {
            // The exponent follows the function's name: sin²θ instead of (sin θ)².
            Formula::Call(function, arguments) if FUNCTIONS.contains(&function.as_str()) => {
                (call(function, arguments, &format!("^{{{}}}", write(exponent).0)), Precedence::Power)
            }
            // Other powers, such as N(n)² and x̃², need no parentheses.
            Formula::Call(function, arguments) if !OPEN_ENDED.contains(&function.as_str()) => (
                format!("{{{}}}^{{{}}}", call(function, arguments, ""), write(exponent).0),
                Precedence::Power,
            ),
            _ => {
                (format!("{}^{{{}}}", at_least(base, Precedence::Atom), write(exponent).0), Precedence::Power)
            }
        },
        Formula::Call(function, arguments) => (call(function, arguments, ""), Precedence::Power),
    }
}

fn joined(factors: Vec<String>) -> String {
    let mut text = String::new();
    for factor in factors {
        let digit = factor.starts_with(|c: char| c.is_ascii_digit()) || factor.starts_with("\\frac");
        if !text.is_empty() {
            let two_numbers = digit && text.ends_with(|c: char| c.is_ascii_digit() || c == '}');
            let word = ["\\text", "{\\operatorname"].iter().any(|start| factor.starts_with(start));
            text.push_str(match (two_numbers, word) {
                (true, _) => " \\cdot ",
                (false, true) => " \\, ",
                (false, false) => " ",
            });
        }
        text.push_str(&factor);
    }
    text
}

#[cfg(test)]
mod tests {
    use super::latex_of;

    fn latex(text: &str) -> String {
        let item = latex_of(text).expect("a statement").remove(0);
        format!("{} {} {}", item.left, item.sign, item.right)
    }

    #[test]
    fn numbers_stand_as_they_are_written() {
        assert_eq!(latex("h ~ 9.990"), "h \\approx 9.990");
        assert_eq!(latex("h ~ -0.05"), "h \\approx -0.05");
        assert_eq!(latex("h ~ 12"), "h \\approx 12");
        assert_eq!(latex("h = 1.5"), "h = \\frac{3}{2}");
    }

    #[test]
    fn a_factor_of_one_is_left_out() {
        assert_eq!(latex("K := 1/2*(x + y)"), "K \\coloneqq \\frac{x + y}{2}");
        assert_eq!(latex("c := 1/x"), "c \\coloneqq \\frac{1}{x}");
    }

    #[test]
    fn parentheses_are_as_high_as_they_must_be() {
        assert_eq!(latex("y*(x + y) = N(n)^2"), "y (x + y) = {N(n)}^{2}");
        assert_eq!(latex("y*(1 + 1/x) = 0"), "y \\left(1 + \\frac{1}{x}\\right) = 0");
        assert_eq!(latex("2*tanh(delta)^2 = 0"), "2 \\, {\\operatorname{tanh}}^{2}\\, \\delta = 0");
    }

    #[test]
    fn names_are_set_by_their_kind() {
        assert_eq!(latex("H_eps = H_hat"), "H(\\varepsilon) = \\widehat{H}");
        assert_eq!(latex("detA = slope(x, 1)"), "\\det A = \\text{slope}(x, 1)");
        assert_eq!(latex("sn_delta = C1_e7"), "\\text{sn}_{\\delta} = {C_{1}}^{\\text{e7}}");
        assert_eq!(latex("dot(x - y) = 0"), "\\frac{d}{dt}(x - y) = 0");
        assert_eq!(latex("dot(H) = next(x + y)"), "\\dot{H} = \\widetilde{(x + y)}");
        assert_eq!(latex("at(x, eps, 0) = 0"), "\\left.x\\right|_{\\varepsilon \\to 0} = 0");
    }
}
