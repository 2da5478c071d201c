//! The language of the paper's formulas.
//!
//! A [`Statement`] consists of items between semicolons: definitions `name(a, b) := expr`,
//! equations `left = right`, inequations `left != right` between different functions, and
//! approximate equations `left ~ right`. Expressions have the operators of `kahan!`, general
//! exponents and calls. Calls of `next`, `back`, `on`, `f`, `Df`, `A`, `b`, `J`, `detA` and `detJ`
//! accept another system's name as first argument.
//!
//! # Calls
//! | call | meaning |
//! |---|---|
//! | `next(E)`, `back(E)` | E at the next, the previous point of the map |
//! | `on(E, a, b, c)` | E at the point (a, b, c) |
//! | `at(E, v, a)` | E with the name v replaced by a |
//! | `d(E, v)` | ∂E/∂v |
//! | `f(i)`, `Df(i,j)` | the field f(x), and its Jacobian matrix |
//! | `A(i,j)`, `b(i)` | A and b of the step A(x,ε)·x̃ = b(x,ε) |
//! | `J(i,j)`, `detA`, `detJ` | the Jacobian matrix J = ∂x̃/∂x, and determinants of A and J |
//! | `sum(j, a, b, E)` | the sum of E over j = a, …, b |
//! | `exp`, `sn`, `gamma`, … | elementary, Jacobi's `sn(u, k)`, Γ, ψ (`digamma`), theta functions |

mod atoms;
mod derivative;
mod inline;
mod latex;
mod mutate;
mod parse;
mod used_definitions;

pub use latex::{LatexItem, latex_of};
pub use mutate::mutations;
pub(crate) use {
    atoms::{has_functions, rationalise},
    inline::inline,
    latex::statement_latex,
    parse::parse,
    used_definitions::with_definitions,
};

use kahan_algebra::rational::Rational;

/// An expression in the language of the paper's formulas.
#[derive(Clone, Debug, PartialEq)]
pub enum Formula {
    /// An exact number.
    Number(Rational),
    /// The name of a state, a parameter, a definition or an independent variable, or `eps`.
    Name(String),
    /// A sum of terms; `true` marks subtracted terms.
    Sum(Vec<(bool, Formula)>),
    /// A product of factors; `true` marks divisors.
    Product(Vec<(bool, Formula)>),
    /// The negation −a.
    Negation(Box<Formula>),
    /// The power a^b.
    Power(Box<Formula>, Box<Formula>),
    /// A call with its name and arguments.
    Call(String, Vec<Formula>),
}

/// The relation between the two sides of an item.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// The sides are equal wherever both are defined.
    Equal,
    /// The sides are different functions.
    Different,
    /// The sides are equal in the digits written on the right.
    Approximate,
}

/// An item of a statement.
#[derive(Clone, Debug, PartialEq)]
pub enum Item {
    /// A definition `name(parameters) := body`.
    Definition(Definition),
    /// A relation between two sides, such as `left = right`.
    Relation {
        /// The left-hand side.
        left: Formula,
        /// The relation between the sides.
        relation: Relation,
        /// The right-hand side.
        right: Formula,
        /// One unit in the last written decimal place, if the right-hand side is a number.
        digit: Option<Rational>,
    },
}

/// A formula with a name, which other formulas may use.
#[derive(Clone, Debug, PartialEq)]
pub struct Definition {
    /// The name.
    pub name: String,
    /// The names of the parameters.
    pub parameters: Vec<String>,
    /// The formula that defines the name.
    pub body: Formula,
}

/// A parsed statement.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Statement {
    /// The items in order.
    pub items: Vec<Item>,
}

impl Formula {
    pub(crate) fn integer(n: i64) -> Self {
        Formula::Number(Rational::from(n))
    }

    pub(crate) fn call(name: &str, arguments: Vec<Formula>) -> Self {
        Formula::Call(name.to_owned(), arguments)
    }

    pub(crate) fn times(self, other: Formula) -> Self {
        Formula::Product(vec![(false, self), (false, other)])
    }

    pub(crate) fn over(self, other: Formula) -> Self {
        Formula::Product(vec![(false, self), (true, other)])
    }

    pub(crate) fn raised_to(self, exponent: i64) -> Self {
        Formula::Power(Box::new(self), Box::new(Formula::integer(exponent)))
    }

    /// Replaces each name or call by its `number`, if it has one. A name has no arguments.
    pub(crate) fn replaced(
        &self,
        number: &impl Fn(&str, &[Formula]) -> Result<Option<Rational>, String>,
    ) -> Result<Self, String> {
        let value = match self {
            Formula::Name(name) => number(name, &[])?,
            Formula::Call(name, arguments) => number(name, arguments)?,
            _ => None,
        };
        value.map_or_else(|| self.of_parts(&|part| part.replaced(number)), |value| Ok(Formula::Number(value)))
    }

    pub(crate) fn parts(&self) -> Vec<&Formula> {
        match self {
            Formula::Number(_) | Formula::Name(_) => Vec::new(),
            Formula::Negation(inner) => vec![inner],
            Formula::Sum(parts) | Formula::Product(parts) => parts.iter().map(|(_, part)| part).collect(),
            Formula::Power(base, exponent) => vec![base, exponent],
            Formula::Call(_, arguments) => arguments.iter().collect(),
        }
    }

    /// Returns the formula with each operand E replaced by `new(E)`.
    pub(crate) fn of_parts<E>(&self, new: &dyn Fn(&Formula) -> Result<Formula, E>) -> Result<Self, E> {
        let boxed = |part: &Formula| new(part).map(Box::new);
        let marked = |parts: &[(bool, Formula)]| -> Result<Vec<_>, E> {
            parts.iter().map(|(mark, part)| Ok((*mark, new(part)?))).collect()
        };
        Ok(match self {
            Formula::Number(_) | Formula::Name(_) => self.clone(),
            Formula::Negation(inner) => Formula::Negation(boxed(inner)?),
            Formula::Sum(terms) => Formula::Sum(marked(terms)?),
            Formula::Product(factors) => Formula::Product(marked(factors)?),
            Formula::Power(base, exponent) => Formula::Power(boxed(base)?, boxed(exponent)?),
            Formula::Call(name, arguments) => {
                Formula::Call(name.clone(), arguments.iter().map(new).collect::<Result<_, E>>()?)
            }
        })
    }

    pub(crate) fn is_number(&self, n: i64) -> bool {
        matches!(self, Formula::Number(value) if *value == Rational::from(n))
    }

    pub(crate) fn as_number(&self) -> Option<Rational> {
        match self {
            Formula::Number(value) => Some(value.clone()),
            Formula::Name(_) | Formula::Call(..) => None,
            Formula::Negation(inner) => Some(-&inner.as_number()?),
            Formula::Sum(terms) => terms.iter().try_fold(Rational::zero(), |sum, (negative, term)| {
                let value = term.as_number()?;
                Some(if *negative { &sum - &value } else { &sum + &value })
            }),
            Formula::Product(factors) => {
                factors.iter().try_fold(Rational::one(), |product, (divides, factor)| {
                    let value = factor.as_number()?;
                    if *divides { product.checked_div(&value) } else { Some(&product * &value) }
                })
            }
            Formula::Power(base, exponent) => {
                let exponent = exponent.as_number()?.as_i64()?;
                base.as_number()?.pow(i32::try_from(exponent).ok()?)
            }
        }
    }
}
