//! Writes calls in LaTeX, such as functions, derivatives, points of the map, brackets, sums and
//! matrix entries.

use super::super::Formula;
use kahan_algebra::render::Precedence;

use super::{at_least, enclosed, name, write};

/// Functions whose names are operator names in LaTeX.
pub(super) const FUNCTIONS: [&str; 14] =
    ["exp", "log", "sin", "cos", "tan", "sinh", "cosh", "tanh", "coth", "sech", "sn", "cn", "dn", "atanh"];

/// Calls that are written without delimiters, so that a power of them needs parentheses.
pub(super) const OPEN_ENDED: [&str; 5] = ["back", "d", "on", "at", "sum"];

/// Writes a call. The function's name is followed by `power`, an exponent or an empty text.
pub(super) fn call(function: &str, arguments: &[Formula], power: &str) -> String {
    let written: Vec<String> = arguments.iter().map(|argument| write(argument).0).collect();
    let list = written.join(", ");
    match (function, arguments) {
        ("next", [inner]) => over("\\widetilde", inner),
        ("dot", [inner @ Formula::Name(_)]) => over("\\dot", inner),
        ("dot", [inner]) => format!("\\frac{{d}}{{dt}}{}", enclosed(&write(inner).0)),
        ("bracket", [.., left, right]) if arguments.len() == 5 => {
            let tensor = written[..3].join(", ");
            format!("\\left\\{{{}, {}\\right\\}}_{{{}}}", write(left).0, write(right).0, enclosed(&tensor))
        }
        ("back", [inner]) => format!("\\left.{}\\right|_{{\\text{{previous point}}}}", write(inner).0),
        ("next", [system, inner]) => {
            format!("\\left.{}\\right|_{{\\text{{map }}{}}}", over("\\widetilde", inner), write(system).0)
        }
        ("d", [inner, Formula::Name(variable)]) => {
            format!(
                "\\frac{{\\partial {}}}{{\\partial {}}}",
                at_least(inner, Precedence::Product),
                name(variable)
            )
        }
        ("on", [inner, ..]) => {
            format!("\\left.{}\\right|_{{{}}}", write(inner).0, enclosed(&written[1..].join(", ")))
        }
        ("at", [inner, rest @ ..]) => {
            let replaced: Vec<String> = rest
                .chunks(2)
                .map(|pair| pair.iter().map(|part| write(part).0).collect::<Vec<_>>().join(" \\to "))
                .collect();
            format!("\\left.{}\\right|_{{{}}}", write(inner).0, replaced.join(",\\; "))
        }
        ("sum", [index, from, to, term]) => format!(
            "\\sum_{{{} = {}}}^{{{}}} {}",
            write(index).0,
            write(from).0,
            write(to).0,
            at_least(term, Precedence::Product)
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
        ("gamma", _) => format!("\\Gamma{power}{}", enclosed(&list)),
        ("digamma", _) => format!("\\psi{power}{}", enclosed(&list)),
        ("theta1" | "theta2" | "theta3" | "theta4", _) => {
            format!("\\vartheta_{{{}}}{power}{}", &function[5..], enclosed(&list))
        }
        ("exp", _) => format!("e^{{{list}}}"),
        ("sn" | "cn" | "dn", [argument, _]) => {
            format!("{}{}", operator(function, power), enclosed(&write(argument).0))
        }
        (_, _) if FUNCTIONS.contains(&function) => match arguments {
            [Formula::Name(_) | Formula::Number(_)] if power.is_empty() => {
                format!("\\operatorname{{{function}}} {list}")
            }
            [Formula::Name(_) | Formula::Number(_)] => format!("{}\\, {list}", operator(function, power)),
            _ => format!("{}{}", operator(function, power), enclosed(&list)),
        },
        _ => format!("{}{power}{}", name(function), enclosed(&list)),
    }
}

fn operator(function: &str, power: &str) -> String {
    if power.is_empty() {
        format!("\\operatorname{{{function}}}")
    } else {
        format!("{{\\operatorname{{{function}}}}}{power}")
    }
}

fn over(accent: &str, inner: &Formula) -> String {
    match inner {
        Formula::Name(_) => format!("{accent}{{{}}}", write(inner).0),
        _ => format!("{accent}{{{}}}", enclosed(&write(inner).0)),
    }
}
