//! A family is a chain of sites with equal equations at every site.
//!
//! A checked family provides plans for one site ([`Lines`](crate::derived::Lines)), the system of n
//! sites ([`Family::at_sites`]), and proofs of its claims for every n ([`conserved`]).

pub mod conserved;
pub mod everywhere;
mod expand;
mod hamiltonian;
#[cfg(test)]
mod tests;

use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{Boundary, Expr, Header, Name};
use kahan_syntax::token::Span;

use crate::poly::Variable;
use crate::rational_function::RationalFunction;
use crate::render::{Notation, Text};
use crate::subexpressions::FieldWithSubexpressions;
use crate::symbols::{Symbol, Symbols};

/// A checked family of quadratic equations ẋᵢ = f(xᵢ₋ᵣ … xᵢ₊ᵣ) with r = `reach`.
#[derive(Clone, Debug)]
pub struct Family {
    /// The header of the block.
    pub header: Option<Header>,
    /// The constants with their values.
    pub constants: Vec<(String, Rational)>,
    /// The rule for values beyond the ends of the chain.
    pub boundary: Boundary,
    /// The names of the arrays of a site.
    pub arrays: Vec<String>,
    /// The names of the parameters that have one value for all sites.
    pub parameters: Vec<String>,
    /// The names of the parameters of each site.
    pub site_parameters: Vec<String>,
    /// The largest offset of a neighbour in the equations, and at least 1.
    pub reach: usize,
    /// Symbols for a site and `reach` neighbours on each side. States are ordered by site, then by
    /// array. After parameters of the chain come 2·reach + 1 values of each site parameter.
    pub symbols: Symbols,
    /// The field at site i by array.
    pub components: Vec<RationalFunction>,
    /// The field with its sums and divisors as written.
    pub kept: FieldWithSubexpressions,
    /// The linear integrals.
    pub integrals: Vec<SiteSum>,
    /// The Hamiltonian.
    pub hamiltonian: Option<SiteSum>,
    /// The place of `for i in …`.
    pub span: Span,
}

/// A sum over all sites.
#[derive(Clone, Debug)]
pub struct SiteSum {
    /// The name of the sum.
    pub name: Name,
    /// The expression of the sum as written.
    pub written: Expr,
    /// The summand for site i.
    pub density: RationalFunction,
}

/// A kind of variable in a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// The state of an array at a site.
    State {
        /// The offset from site i.
        offset: i64,
        /// The index of the array.
        array: usize,
    },
    /// The parameter of the chain with this index.
    Parameter(usize),
    /// A site parameter at a site.
    SiteParameter {
        /// The offset from site i.
        offset: i64,
        /// The index among the site parameters.
        index: usize,
    },
    /// The parameter ε, which is half the time step.
    Epsilon,
}

impl Family {
    /// Returns the name of the family's type, or `field` if the family has no name.
    #[must_use]
    pub fn name(&self) -> &str {
        self.header.as_ref().map_or("field", |header| header.name.text.as_str())
    }

    /// Returns the number of arrays.
    #[must_use]
    pub fn block(&self) -> usize {
        self.arrays.len()
    }

    /// Returns the number 2·reach + 1 of sites in the stencil.
    #[must_use]
    pub fn stencil(&self) -> usize {
        2 * self.reach + 1
    }

    /// Returns the kind of a variable with its site and index.
    #[must_use]
    pub fn role(&self, variable: Variable) -> Role {
        let offset = |place: usize| place as i64 - self.reach as i64;
        match self.symbols.symbol(variable) {
            Symbol::State(k) => Role::State { offset: offset(k / self.block()), array: k % self.block() },
            Symbol::Parameter(k) if k < self.parameters.len() => Role::Parameter(k),
            Symbol::Parameter(k) => {
                let k = k - self.parameters.len();
                Role::SiteParameter { offset: offset(k % self.stencil()), index: k / self.stencil() }
            }
            Symbol::Epsilon | Symbol::SecondState(_) => Role::Epsilon,
        }
    }

    /// Returns the index of an array's state among the states of the stencil.
    #[must_use]
    pub fn place(&self, offset: i64, array: usize) -> usize {
        (offset + self.reach as i64) as usize * self.block() + array
    }

    /// Returns the equations as text such as `x[i]dot = x[i]*x[i+1] - x[i]*x[i-1]`.
    pub fn equations(&self) -> impl Iterator<Item = String> {
        self.arrays
            .iter()
            .zip(&self.components)
            .map(|(array, component)| format!("{array}[i]dot = {}", Text.function(&self.symbols, component)))
    }

    /// Returns the indices of the states on which the field of an array depends.
    #[must_use]
    pub fn couplings(&self, array: usize) -> Vec<usize> {
        let numerator = self.components[array].numerator();
        let states = 0..self.symbols.states.len();
        states.filter(|&k| numerator.contains(self.symbols.state(k))).collect()
    }
}
