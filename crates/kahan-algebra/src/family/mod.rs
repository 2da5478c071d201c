//! A family: the same equations at every site of a chain, for any number of sites.
//!
//! In: a checked family. Out: its straight lines for one site ([`Lines`](crate::derived::Lines)),
//! the plain system of a chain of n sites ([`Family::at_sites`]), and what its map keeps whatever n
//! is ([`conserved`]).

pub mod conserved;
pub mod everywhere;
mod expand;
mod hamiltonian;
#[cfg(test)]
mod tests;

use kahan_syntax::rational::Rational;
use kahan_syntax::syntax::{Boundary, Expr, Header, Name};
use kahan_syntax::token::Span;

use crate::kept::Kept;
use crate::poly::Variable;
use crate::rational_function::RationalFunction;
use crate::render::{Notation, Text};
use crate::symbols::{Symbol, Symbols};

/// A family of quadratic equations ẋᵢ = f(xᵢ₋ᵣ … xᵢ₊ᵣ), checked.
#[derive(Clone, Debug)]
pub struct Family {
    /// The header, where the block has one.
    pub header: Option<Header>,
    /// Constants in the order of their declaration, evaluated.
    pub constants: Vec<(String, Rational)>,
    /// What lies beyond the ends of the chain.
    pub boundary: Boundary,
    /// The arrays, in their order within a site.
    pub arrays: Vec<String>,
    /// The parameters that a chain has.
    pub parameters: Vec<String>,
    /// The parameters that each site has.
    pub site_parameters: Vec<String>,
    /// The largest offset of a neighbour, at least 1.
    pub reach: usize,
    /// The values that a site sees: as states those of the arrays, site by site from −reach on;
    /// as parameters those of the chain, then for each parameter of a site its 2·reach + 1 values.
    pub symbols: Symbols,
    /// The field at site i, a component an array.
    pub components: Vec<RationalFunction>,
    /// The same with the sums and divisors that were written.
    pub kept: Kept,
    /// Linear integrals, as sums over all sites.
    pub integrals: Vec<SiteSum>,
    /// The Hamiltonian, as a sum over all sites.
    pub hamiltonian: Option<SiteSum>,
    /// Where `for i in …` stands.
    pub span: Span,
}

/// A sum over all sites.
#[derive(Clone, Debug)]
pub struct SiteSum {
    /// What it is called.
    pub name: Name,
    /// What was written.
    pub written: Expr,
    /// What is summed, at site i.
    pub density: RationalFunction,
}

/// What a variable of a family stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// An array at the site `offset` from site i.
    State {
        /// How far from site i.
        offset: i64,
        /// The index of the array.
        array: usize,
    },
    /// A parameter of the chain.
    Parameter(usize),
    /// A parameter of the site `offset` from site i.
    SiteParameter {
        /// How far from site i.
        offset: i64,
        /// The index among the parameters of a site.
        index: usize,
    },
    /// Half the time step.
    Epsilon,
}

impl Family {
    /// The type's name; `field` where it has none.
    #[must_use]
    pub fn name(&self) -> &str {
        self.header.as_ref().map_or("field", |header| header.name.text.as_str())
    }

    /// Arrays a site.
    #[must_use]
    pub fn block(&self) -> usize {
        self.arrays.len()
    }

    /// The sites that a site sees: 2·reach + 1.
    #[must_use]
    pub fn stencil(&self) -> usize {
        2 * self.reach + 1
    }

    /// What `variable` stands for.
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

    /// The place of an array's value among the states: site by site, arrays interleaved.
    #[must_use]
    pub fn place(&self, offset: i64, array: usize) -> usize {
        (offset + self.reach as i64) as usize * self.block() + array
    }

    /// The equations, expanded: `x[i]dot = x[i]*x[i+1] - x[i]*x[i-1]`.
    pub fn equations(&self) -> impl Iterator<Item = String> {
        self.arrays
            .iter()
            .zip(&self.components)
            .map(|(array, component)| format!("{array}[i]dot = {}", Text.function(&self.symbols, component)))
    }

    /// The places, among the states, of the values that the field of an array depends on.
    #[must_use]
    pub fn couplings(&self, array: usize) -> Vec<usize> {
        let numerator = self.components[array].numerator();
        let states = 0..self.symbols.states.len();
        states.filter(|&k| numerator.contains(self.symbols.state(k))).collect()
    }
}
