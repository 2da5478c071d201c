//! Statements in LaTeX.

use kahan_algebra::render::Notation;

use super::{Formula, Item, Relation, Statement, parse};

/// How tightly an expression binds, for parentheses.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Level {
    Sum,
    Product,
    Power,
    Atom,
}

/// One item of a statement in LaTeX: a definition or a relation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LatexItem {
    /// The left-hand side: what is defined, or one side of a relation.
    pub left: String,
    /// `:=`, `=`, `\neq` or `\approx`.
    pub sign: &'static str,
    /// The right-hand side.
    pub right: String,
}

/// A statement in LaTeX, item by item, so that a table can show the right-hand side of a definition alone.
///
/// # Errors
/// What is wrong with the text.
pub fn latex_of(text: &str) -> Result<Vec<LatexItem>, String> {
    Ok(parse(text)?.items.iter().map(item).collect())
}

/// Every item of a statement as one formula.
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
            LatexItem { left, sign: ":=", right: write(&definition.body).0 }
        }
        Item::Relation { left, relation, right, .. } => {
            let sign = match relation {
                Relation::Equal => "=",
                Relation::Different => "\\neq",
                Relation::Approximate => "\\approx",
            };
            LatexItem { left: write(left).0, sign, right: write(right).0 }
        }
    }
}

/// A name; `H_eps` is H(ε), `H_hat` Ĥ, `P12` has indices.
fn name(text: &str) -> String {
    let written = |stem| Notation::Latex.name(stem);
    match (text.strip_suffix("_eps"), text.strip_suffix("_hat")) {
        (Some(stem), _) => format!("{}(\\varepsilon)", written(stem)),
        (_, Some(stem)) => format!("\\widehat{{{}}}", written(stem)),
        _ => written(text),
    }
}

fn at_least(formula: &Formula, level: Level) -> String {
    let (text, own) = write(formula);
    if own >= level { text } else { format!("\\left({text}\\right)") }
}

fn write(formula: &Formula) -> (String, Level) {
    match formula {
        Formula::Number(value) => {
            let level = if value.is_integer() { Level::Atom } else { Level::Product };
            (Notation::Latex.number(value), level)
        }
        Formula::Name(text) => (name(text), Level::Atom),
        Formula::Negation(inner) => (format!("-{}", at_least(inner, Level::Product)), Level::Sum),
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
                    if index == 0 && !negative { Level::Sum } else { Level::Product },
                ));
            }
            (text, Level::Sum)
        }
        Formula::Product(factors) if factors.iter().any(|(divides, _)| *divides) => {
            let negative = matches!(factors.first(), Some((false, Formula::Negation(_))));
            let side = |wanted: bool| {
                let chosen: Vec<&Formula> = factors
                    .iter()
                    .filter(|(divides, _)| *divides == wanted)
                    .map(|(_, factor)| factor)
                    .collect();
                let level = if chosen.len() > 1 { Level::Product } else { Level::Sum };
                let written = chosen.iter().enumerate().map(|(index, factor)| match factor {
                    Formula::Negation(inner) if index == 0 && !wanted => at_least(inner, level),
                    _ => at_least(factor, level),
                });
                if chosen.is_empty() { "1".to_owned() } else { joined(written.collect()) }
            };
            let fraction = format!("\\frac{{{}}}{{{}}}", side(false), side(true));
            if negative { (format!("-{fraction}"), Level::Sum) } else { (fraction, Level::Product) }
        }
        Formula::Product(factors) => {
            let written = factors.iter().enumerate().map(|(index, (_, factor))| match factor {
                Formula::Negation(_) if index == 0 => write(factor).0,
                _ => at_least(factor, Level::Product),
            });
            let level = match factors.first() {
                Some((_, Formula::Negation(_))) => Level::Sum,
                _ => Level::Product,
            };
            (joined(written.collect()), level)
        }
        Formula::Power(base, exponent) => match &**base {
            // sin²θ rather than (sin θ)².
            Formula::Call(function, arguments) if FUNCTIONS.contains(&function.as_str()) => {
                (call(function, arguments, &format!("^{{{}}}", write(exponent).0)), Level::Power)
            }
            _ => (format!("{}^{{{}}}", at_least(base, Level::Atom), write(exponent).0), Level::Power),
        },
        Formula::Call(function, arguments) => (call(function, arguments, ""), Level::Power),
    }
}

/// A product; a point where two numbers would run together.
fn joined(factors: Vec<String>) -> String {
    let mut text = String::new();
    for factor in factors {
        let digit = factor.starts_with(|c: char| c.is_ascii_digit()) || factor.starts_with("\\frac");
        if !text.is_empty() {
            text.push_str(if digit && text.ends_with(|c: char| c.is_ascii_digit() || c == '}') {
                " \\cdot "
            } else {
                " "
            });
        }
        text.push_str(&factor);
    }
    text
}

const FUNCTIONS: [&str; 14] =
    ["exp", "log", "sin", "cos", "tan", "sinh", "cosh", "tanh", "coth", "sech", "sn", "cn", "dn", "atanh"];

fn call(function: &str, arguments: &[Formula], power: &str) -> String {
    let written: Vec<String> = arguments.iter().map(|argument| write(argument).0).collect();
    let list = written.join(", ");
    match (function, arguments) {
        ("next", [inner]) => over("\\widetilde", inner),
        ("back", [inner]) => format!("\\left.{}\\right|_{{\\text{{previous point}}}}", write(inner).0),
        ("next", [system, inner]) => {
            format!("\\left.{}\\right|_{{\\text{{map }}{}}}", over("\\widetilde", inner), write(system).0)
        }
        ("d", [inner, Formula::Name(variable)]) => {
            format!("\\frac{{\\partial {}}}{{\\partial {}}}", at_least(inner, Level::Product), name(variable))
        }
        ("on", [inner, ..]) => format!("\\left.{}\\right|_{{({})}}", write(inner).0, written[1..].join(", ")),
        ("at", [inner, rest @ ..]) => {
            let replaced: Vec<String> = rest
                .chunks(2)
                .map(|pair| pair.iter().map(|part| write(part).0).collect::<Vec<_>>().join(" = "))
                .collect();
            format!("\\left.{}\\right|_{{{}}}", write(inner).0, replaced.join(",\\; "))
        }
        ("sum", [index, from, to, term]) => format!(
            "\\sum_{{{} = {}}}^{{{}}} {}",
            write(index).0,
            write(from).0,
            write(to).0,
            at_least(term, Level::Product)
        ),
        ("f" | "A" | "b" | "J", [indices @ .., _]) => {
            let system = indices.iter().take(1).any(|first| matches!(first, Formula::Name(_)));
            let (label, indices) = if system {
                (format!("^{{({})}}", written[0]), &written[1..])
            } else {
                (String::new(), &written[..])
            };
            format!("{function}{label}_{{{}}}", indices.join(""))
        }
        ("sqrt", _) => format!("\\sqrt{{{list}}}{power}"),
        ("abs", _) => format!("\\left|{list}\\right|{power}"),
        ("gamma", _) => format!("\\Gamma{power}\\left({list}\\right)"),
        ("digamma", _) => format!("\\psi{power}\\left({list}\\right)"),
        ("theta1" | "theta2" | "theta3" | "theta4", _) => {
            format!("\\vartheta_{{{}}}{power}\\left({list}\\right)", &function[5..])
        }
        ("exp", _) => format!("e^{{{list}}}"),
        ("sn" | "cn" | "dn", [argument, _]) => {
            format!("\\operatorname{{{function}}}{power}\\left({}\\right)", write(argument).0)
        }
        (_, _) if FUNCTIONS.contains(&function) => match arguments {
            [Formula::Name(_) | Formula::Number(_)] => format!("\\operatorname{{{function}}}{power} {list}"),
            _ => format!("\\operatorname{{{function}}}{power}\\left({list}\\right)"),
        },
        _ => format!("{}{power}\\left({list}\\right)", name(function)),
    }
}

fn over(accent: &str, inner: &Formula) -> String {
    match inner {
        Formula::Name(_) => format!("{accent}{{{}}}", write(inner).0),
        _ => format!("{accent}{{\\left({}\\right)}}", write(inner).0),
    }
}
