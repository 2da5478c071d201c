//! Expressions as trees, with their text and their value.
//!
//! In: what a random field is made of. Out: text with the parentheses that the usual precedence
//! needs and no others, and the value at named numbers. The value of a literal is that of its
//! digits, read here and not by the front end.

use std::fmt;

use kahan_core::num_rational::BigRational;

use super::ratio;

/// An expression.
#[derive(Clone, Debug, PartialEq)]
pub enum Tree {
    /// Digits as they will be written.
    Literal(String),
    /// A state or a parameter.
    Name(&'static str),
    /// −a
    Negated(Box<Tree>),
    /// a + b + …; a negated term is written with a minus.
    Sum(Vec<Tree>),
    /// a · b · …
    Product(Vec<Tree>),
    /// a / b
    Quotient(Box<Tree>, Box<Tree>),
    /// aⁿ
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

/// How tightly a form binds: − and + least, then · and /, then powers, then what stands alone.
#[derive(Clone, Copy, PartialEq, PartialOrd)]
enum Level {
    Sum,
    Product,
    Power,
    Atom,
}

impl Tree {
    fn level(&self) -> Level {
        match self {
            Tree::Literal(_) | Tree::Name(_) => Level::Atom,
            Tree::Negated(_) | Tree::Sum(_) => Level::Sum,
            Tree::Product(_) | Tree::Quotient(..) => Level::Product,
            Tree::Power(..) => Level::Power,
        }
    }

    /// The value, where the names have these values.
    ///
    /// # Panics
    /// At an unknown name.
    #[must_use]
    pub fn value(&self, names: &[(&str, BigRational)]) -> BigRational {
        match self {
            Tree::Literal(digits) => decimal(digits),
            Tree::Name(name) => {
                let known = names.iter().find(|(known, _)| known == name);
                known.unwrap_or_else(|| panic!("no value for {name}")).1.clone()
            }
            Tree::Negated(a) => -a.value(names),
            Tree::Sum(terms) => terms.iter().fold(ratio(0, 1), |sum, term| sum + term.value(names)),
            Tree::Product(factors) => factors.iter().fold(ratio(1, 1), |product, f| product * f.value(names)),
            Tree::Quotient(a, b) => a.value(names) / b.value(names),
            Tree::Power(base, exponent) => {
                let base = base.value(names);
                (0..*exponent).fold(ratio(1, 1), |power, _| power * &base)
            }
        }
    }
}

/// The number that digits with a point, an exponent or underscores stand for.
fn decimal(text: &str) -> BigRational {
    let digits = text.replace('_', "");
    let (mantissa, exponent) = digits.split_once('e').unwrap_or((&digits, "0"));
    let (whole, fraction) = mantissa.split_once('.').unwrap_or((mantissa, ""));
    let exponent: i32 = exponent.parse().expect("an exponent");
    let number = format!("{whole}{fraction}").parse().expect("digits");
    BigRational::from_integer(number) * ratio(10, 1).pow(exponent - fraction.len() as i32)
}

impl fmt::Display for Tree {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let grouped = |f: &mut fmt::Formatter<'_>, tree: &Tree, least: Level| {
            if tree.level() < least { write!(f, "({tree})") } else { write!(f, "{tree}") }
        };
        match self {
            Tree::Literal(digits) => f.write_str(digits),
            Tree::Name(name) => f.write_str(name),
            Tree::Negated(a) => {
                f.write_str("-")?;
                grouped(f, a, Level::Product)
            }
            Tree::Sum(terms) => {
                for (index, term) in terms.iter().enumerate() {
                    let (sign, term, least) = match (index, term) {
                        (0, Tree::Negated(_) | Tree::Sum(_)) => ("", term, Level::Sum),
                        (0, _) => ("", term, Level::Product),
                        (_, Tree::Negated(a)) => (" - ", &**a, Level::Product),
                        _ => (" + ", term, Level::Product),
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
                    // A quotient may open a product: a/b*c is (a/b)·c. Elsewhere it needs
                    // parentheses.
                    let least = if index == 0 { Level::Product } else { Level::Power };
                    grouped(f, factor, least)?;
                }
                Ok(())
            }
            Tree::Quotient(a, b) => {
                grouped(f, a, Level::Product)?;
                f.write_str("/")?;
                grouped(f, b, Level::Power)
            }
            Tree::Power(base, exponent) => {
                grouped(f, base, Level::Atom)?;
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

    #[test]
    fn digits_mean_what_they_say() {
        assert_eq!(decimal("0.1"), ratio(1, 10));
        assert_eq!(decimal("1.5e-3"), ratio(3, 2000));
        assert_eq!(decimal("1_000"), ratio(1000, 1));
        assert_eq!(decimal("1e2"), ratio(100, 1));
    }
}
