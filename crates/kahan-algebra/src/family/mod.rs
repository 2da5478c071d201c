//! A family: equal equations at every site of a chain, for any number of sites.
//!
//! A checked family provides plans for one site ([`Lines`](crate::derived::Lines)), the plain
//! system of n sites ([`Family::at_sites`]), and invariants for every n ([`conserved`]).

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

/// A checked family of quadratic equations ẋᵢ = f(xᵢ₋ᵣ … xᵢ₊ᵣ).
#[derive(Clone, Debug)]
pub struct Family {
    /// The header, if the block has one.
    pub header: Option<Header>,
    /// Constants with their values, in order of declaration.
    pub constants: Vec<(String, Rational)>,
    /// The values beyond the ends of the chain.
    pub boundary: Boundary,
    /// The arrays, in order within a site.
    pub arrays: Vec<String>,
    /// The parameters of the chain.
    pub parameters: Vec<String>,
    /// The parameters of each site.
    pub site_parameters: Vec<String>,
    /// The largest offset of a neighbour, at least 1.
    pub reach: usize,
    /// The values of the stencil. States: arrays, site by site from −reach on. Parameters: those of
    /// the chain, then 2·reach + 1 values for each site parameter.
    pub symbols: Symbols,
    /// The field at site i, one component for each array.
    pub components: Vec<RationalFunction>,
    /// The field with the sums and divisors as written.
    pub kept: FieldWithSubexpressions,
    /// Linear integrals, as sums over all sites.
    pub integrals: Vec<SiteSum>,
    /// The Hamiltonian, as a sum over all sites.
    pub hamiltonian: Option<SiteSum>,
    /// The place of `for i in …`.
    pub span: Span,
}

/// A sum over all sites.
#[derive(Clone, Debug)]
pub struct SiteSum {
    /// The name of the sum.
    pub name: Name,
    /// The expression as written.
    pub written: Expr,
    /// The summand at site i.
    pub density: RationalFunction,
}

/// The meaning of a variable of a family.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// An array at the site `offset` from site i.
    State {
        /// The offset from site i.
        offset: i64,
        /// The index of the array.
        array: usize,
    },
    /// A parameter of the chain.
    Parameter(usize),
    /// A parameter of the site `offset` from site i.
    SiteParameter {
        /// The offset from site i.
        offset: i64,
        /// The index among the site parameters.
        index: usize,
    },
    /// ε, half the time step.
    Epsilon,
}

impl Family {
    /// Returns the type's name, or `field`.
    #[must_use]
    pub fn name(&self) -> &str {
        self.header.as_ref().map_or("field", |header| header.name.text.as_str())
    }

    /// Returns the number of arrays, which is the number of states at each site.
    #[must_use]
    pub fn block(&self) -> usize {
        self.arrays.len()
    }

    /// Returns the number of sites in the stencil: 2·reach + 1.
    #[must_use]
    pub fn stencil(&self) -> usize {
        2 * self.reach + 1
    }

    /// Returns the meaning of `variable`.
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

    /// Returns the index of an array's value among the states of the stencil.
    #[must_use]
    pub fn place(&self, offset: i64, array: usize) -> usize {
        (offset + self.reach as i64) as usize * self.block() + array
    }

    /// Returns the expanded equations: `x[i]dot = x[i]*x[i+1] - x[i]*x[i-1]`.
    pub fn equations(&self) -> impl Iterator<Item = String> {
        self.arrays
            .iter()
            .zip(&self.components)
            .map(|(array, component)| format!("{array}[i]dot = {}", Text.function(&self.symbols, component)))
    }

    /// Returns the indices of the states that the field of an array depends on.
    #[must_use]
    pub fn couplings(&self, array: usize) -> Vec<usize> {
        let numerator = self.components[array].numerator();
        let states = 0..self.symbols.states.len();
        states.filter(|&k| numerator.contains(self.symbols.state(k))).collect()
    }
}
