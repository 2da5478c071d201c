//! Expressions as trees, and their text. Parentheses keep the structure of the tree.

use std::fmt;

/// An expression as a tree.
#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    /// A number, as the digits that are written.
    Literal(String),
    /// The name of a state or a parameter.
    Name(&'static str),
    /// The negation −a.
    Negated(Box<Tree>),
    /// The sum a + b + …. Negated terms are written with a minus.
    Sum(Vec<Tree>),
    /// The product a · b · ….
    Product(Vec<Tree>),
    /// The quotient a / b.
    Quotient(Box<Tree>, Box<Tree>),
    /// The power aⁿ.
    Power(Box<Tree>, u32),
}

pub(super) fn literal(digits: &str) -> Tree {
    Tree::Literal(digits.to_owned())
}

pub(super) fn negated(a: Tree) -> Tree {
    Tree::Negated(Box::new(a))
}

pub(super) fn quotient(a: Tree, b: Tree) -> Tree {
    Tree::Quotient(Box::new(a), Box::new(b))
}

pub(super) fn power(base: Tree, exponent: u32) -> Tree {
    Tree::Power(Box::new(base), exponent)
}

/// The precedence of an expression. Sums bind weakest, then products, powers and atoms.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Precedence {
    Sum,
    Product,
    Power,
    Atom,
}

impl Tree {
    fn level(&self) -> Precedence {
        match self {
            Tree::Literal(_) | Tree::Name(_) => Precedence::Atom,
            Tree::Negated(_) | Tree::Sum(_) => Precedence::Sum,
            Tree::Product(_) | Tree::Quotient(..) => Precedence::Product,
            Tree::Power(..) => Precedence::Power,
        }
    }
}

impl fmt::Display for Tree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let grouped = |f: &mut fmt::Formatter<'_>, tree: &Tree, least: Precedence| {
            if tree.level() < least { write!(f, "({tree})") } else { write!(f, "{tree}") }
        };
        match self {
            Tree::Literal(digits) => f.write_str(digits),
            Tree::Name(name) => f.write_str(name),
            Tree::Negated(a) => {
                f.write_str("-")?;
                grouped(f, a, Precedence::Product)
            }
            Tree::Sum(terms) => {
                for (index, term) in terms.iter().enumerate() {
                    let (sign, term, least) = match (index, term) {
                        (0, Tree::Negated(_) | Tree::Sum(_)) => ("", term, Precedence::Sum),
                        (0, _) => ("", term, Precedence::Product),
                        (_, Tree::Negated(a)) => (" - ", &**a, Precedence::Product),
                        _ => (" + ", term, Precedence::Product),
                    };
                    f.write_str(sign)?;
                    grouped(f, term, least)?;
                }
                Ok(())
            }
            Tree::Product(factors) => {
                for (index, factor) in factors.iter().enumerate() {
                    if index > 0 {
                        f.write_str("*")?;
                    }
                    // Only the first factor may be a quotient without parentheses: a/b*c is
                    // (a/b)·c.
                    let least = if index == 0 { Precedence::Product } else { Precedence::Power };
                    grouped(f, factor, least)?;
                }
                Ok(())
            }
            Tree::Quotient(a, b) => {
                grouped(f, a, Precedence::Product)?;
                f.write_str("/")?;
                grouped(f, b, Precedence::Power)
            }
            Tree::Power(base, exponent) => {
                grouped(f, base, Precedence::Atom)?;
                write!(f, "^{exponent}")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Tree::{Name, Product, Sum};
    use super::*;

    #[test]
    fn the_text_has_the_parentheses_that_it_needs_and_no_others() {
        let (x, y) = (|| Name("x"), || Name("y"));
        let texts = [
            (negated(power(x(), 2)), "-x^2"),
            (power(negated(x()), 2), "(-x)^2"),
            (Product(vec![quotient(literal("3"), literal("7")), x()]), "3/7*x"),
            (Product(vec![x(), quotient(x(), y())]), "x*(x/y)"),
            (quotient(x(), Product(vec![x(), y()])), "x/(x*y)"),
            (Sum(vec![x(), negated(Sum(vec![x(), y()]))]), "x - (x + y)"),
        ];
        for (tree, text) in texts {
            assert_eq!(tree.to_string(), text);
        }
    }
}
