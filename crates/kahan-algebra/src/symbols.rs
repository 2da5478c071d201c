//! Assigns variables to names: states, parameters, ε, then a second copy of the states.

use crate::poly::{Polynomial, Variable, gcd_all};

/// The names of states and parameters of a system.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Symbols {
    /// The names of the states in the order of the equations.
    pub states: Vec<String>,
    /// The names of the parameters in the order of the header.
    pub parameters: Vec<String>,
}

/// The meaning of a variable in a system.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Symbol {
    /// The state with this index.
    State(usize),
    /// The parameter with this index.
    Parameter(usize),
    /// The parameter ε, which is half the time step.
    Epsilon,
    /// The state with this index at the second point of a bilinear form.
    SecondState(usize),
}

impl Symbols {
    /// Returns the number of states.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.states.len()
    }

    /// Returns the number of variables. Each state has two, one for each point of a bilinear form.
    #[must_use]
    pub fn count(&self) -> usize {
        2 * self.states.len() + self.parameters.len() + 1
    }

    /// Returns the variable of a symbol.
    #[must_use]
    pub fn variable(&self, symbol: Symbol) -> Variable {
        let (states, parameters) = (self.states.len(), self.parameters.len());
        let index = match symbol {
            Symbol::State(i) => i,
            Symbol::Parameter(k) => states + k,
            Symbol::Epsilon => states + parameters,
            Symbol::SecondState(i) => states + parameters + 1 + i,
        };
        Variable(u16::try_from(index).expect("a block has fewer names than 16 bits can number"))
    }

    /// Returns the variable of state `i`.
    #[must_use]
    pub fn state(&self, i: usize) -> Variable {
        self.variable(Symbol::State(i))
    }

    /// Returns the variable of parameter `k`.
    #[must_use]
    pub fn parameter(&self, k: usize) -> Variable {
        self.variable(Symbol::Parameter(k))
    }

    /// Returns the variable of ε.
    #[must_use]
    pub fn epsilon(&self) -> Variable {
        self.variable(Symbol::Epsilon)
    }

    /// Returns the meaning of `variable`.
    #[must_use]
    pub fn symbol(&self, variable: Variable) -> Symbol {
        let index = usize::from(variable.0);
        let (states, parameters) = (self.states.len(), self.parameters.len());
        match index {
            i if i < states => Symbol::State(i),
            i if i < states + parameters => Symbol::Parameter(i - states),
            i if i == states + parameters => Symbol::Epsilon,
            i => Symbol::SecondState(i - states - parameters - 1),
        }
    }

    /// Returns whether `variable` is a state.
    #[must_use]
    pub fn is_state(&self, variable: Variable) -> bool {
        usize::from(variable.0) < self.states.len()
    }

    /// Returns the degree of a polynomial in the states.
    #[must_use]
    pub fn degree(&self, polynomial: &Polynomial) -> u32 {
        polynomial.degree_where(|variable| self.is_state(variable))
    }

    /// Returns whether a polynomial depends on a state.
    #[must_use]
    pub fn has_state(&self, polynomial: &Polynomial) -> bool {
        self.degree(polynomial) > 0
    }

    /// Divides a polynomial by the gcd of its coefficients, which may contain parameters but no
    /// states. Scales it to coprime integers with positive leading coefficient. 0 stays 0.
    #[must_use]
    pub fn primitive_part(&self, polynomial: &Polynomial) -> Polynomial {
        let groups = polynomial.group(|variable| self.is_state(variable));
        let content = gcd_all(groups.values());
        polynomial.checked_div(&content).unwrap_or_else(|| polynomial.clone()).primitive_part()
    }

    /// Returns the name of a variable. Second states get a prime.
    #[must_use]
    pub fn name(&self, variable: Variable) -> String {
        match self.symbol(variable) {
            Symbol::State(i) => self.states[i].clone(),
            Symbol::Parameter(k) => self.parameters[k].clone(),
            Symbol::Epsilon => "eps".to_owned(),
            Symbol::SecondState(i) => format!("{}'", self.states[i]),
        }
    }

    /// Returns the variable with this name.
    #[must_use]
    pub fn named(&self, name: &str) -> Option<Variable> {
        (0..self.count()).map(|index| Variable(index as u16)).find(|&variable| self.name(variable) == name)
    }
}
