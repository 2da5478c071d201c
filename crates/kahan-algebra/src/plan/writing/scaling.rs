//! Distributes powers of ε over the states and parameters of each term. For example, ε²x²y may
//! become (εx)(εx)y.
//!
//! If εx is computed first, terms need no product with ε, and few prepared constants are rounded.
//! Scaled symbols such as εx are further variables, numbered after all symbols. Another variable is
//! the [inverse time step](crate::plan::forms::inverse) 1/(2ε).

use kahan_syntax::rational::Rational;

use crate::field::Field;
use crate::poly::{Monomial, Polynomial, Variable};

use kahan_program::cost::{DIVIDE, MULTIPLY};

const FIRST_COEFFICIENT: u16 = 1 << 15;
/// The variable that names 1/(2ε) in all forms.
pub(in crate::plan) const INVERSE_STEP: Variable = Variable(FIRST_COEFFICIENT - 1);
/// The estimated cycle in which the image of a state is ready, which includes a division.
const STATE_IMAGE_CYCLE: u32 = 2 * DIVIDE;

/// Whether the powers of ε in a term multiply its states first or its parameters first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::plan) enum ScalingPriority {
    /// States come first. If only some terms have parameters, the other terms can also use εx.
    States,
    /// Parameters come first. In εa₁x, the constant εa₁ is then prepared, and x stays as it is.
    Parameters,
}

/// The numbering of symbols, and of their products with ε, which are called scaled symbols.
#[derive(Clone, Debug)]
pub(in crate::plan) struct Scaling {
    states: usize,
    /// The number of unscaled symbols: states, parameters, ε, and second states.
    offset: u16,
    epsilon: Variable,
    first: ScalingPriority,
    /// Whether all constants of a term become one prepared constant, which is rounded twice.
    pub(in crate::plan) folds: bool,
}

impl Scaling {
    pub(in crate::plan) fn new(field: &Field, first: ScalingPriority) -> Self {
        let symbols = &field.symbols;
        let (states, parameters) = (symbols.states.len(), symbols.parameters.len());
        let offset = u16::try_from(2 * states + parameters + 1).expect("symbols are numbered by 16 bits");
        Scaling { states, offset, epsilon: symbols.epsilon(), first, folds: is_dissipative(field) }
    }

    pub(in crate::plan) fn states(&self) -> u16 {
        u16::try_from(self.states).expect("straight lines have few states")
    }

    pub(in crate::plan) fn epsilon(&self) -> Variable {
        self.epsilon
    }

    pub(in crate::plan) fn coefficient(&self, k: usize) -> Variable {
        Variable(FIRST_COEFFICIENT + u16::try_from(k).expect("few coefficients are gathered"))
    }

    pub(in crate::plan) fn scaled(&self, symbol: Variable) -> Variable {
        Variable(symbol.0 + self.offset)
    }

    pub(in crate::plan) fn unscaled(&self, variable: Variable) -> Option<Variable> {
        let is_scaled = variable.0 >= self.offset && variable.0 < INVERSE_STEP.0;
        if is_scaled { Some(Variable(variable.0 - self.offset)) } else { None }
    }

    /// Returns the cycle when a variable is ready. Returns `None` if it depends on no state.
    pub(in crate::plan) fn ready(&self, variable: Variable) -> Option<u32> {
        let Variable(index) = variable;
        if index >= INVERSE_STEP.0 {
            return None;
        }
        let (symbol, scaling) =
            if index >= self.offset { (index - self.offset, MULTIPLY) } else { (index, 0) };
        if (symbol as usize) < self.states {
            Some(scaling)
        } else if symbol > self.epsilon.0 {
            Some(STATE_IMAGE_CYCLE + scaling)
        } else {
            None
        }
    }

    /// Returns all distinct ways to multiply the powers of ε in a polynomial into the states and
    /// parameters of its terms.
    pub(in crate::plan) fn eps_distributions(&self, polynomial: &Polynomial) -> Vec<Polynomial> {
        if !polynomial.contains(self.epsilon) {
            return vec![polynomial.clone()];
        }
        let present = polynomial.variables().into_iter().map(|variable| usize::from(variable.0));
        let present: Vec<usize> = present.filter(|&index| index < self.states).collect();
        if present.is_empty() {
            return vec![self.scale(polynomial, &[])];
        }
        let mut ways: Vec<Polynomial> = Vec::new();
        for order in orders(&present) {
            let scaled = self.scale(polynomial, &order);
            if !ways.contains(&scaled) {
                ways.push(scaled);
            }
        }
        ways
    }

    pub(in crate::plan) fn scale_first(&self, polynomial: &Polynomial) -> Polynomial {
        self.scale(polynomial, &(0..self.states).collect::<Vec<_>>())
    }

    fn scale(&self, polynomial: &Polynomial, plain: &[usize]) -> Polynomial {
        if !polynomial.contains(self.epsilon) {
            return polynomial.clone();
        }
        polynomial.map_monomials(|monomial| Some(self.scale_term(monomial, plain)))
    }

    fn scale_term(&self, monomial: &Monomial, plain: &[usize]) -> Monomial {
        let mut powers_of_eps = monomial.exponent(self.epsilon);
        let mut result = Monomial::one();
        let is_state = |variable: Variable| usize::from(variable.0) < self.states;
        let states =
            plain.iter().rev().map(|&i| Variable(u16::try_from(i).expect("states are numbered by 16 bits")));
        let variables = monomial.powers().iter().map(|(variable, _)| *variable);
        let parameters = variables.filter(|v| !is_state(*v) && *v != self.epsilon && *v != INVERSE_STEP);
        let order: Vec<Variable> = match self.first {
            ScalingPriority::States => states.chain(parameters).collect(),
            ScalingPriority::Parameters => parameters.chain(states).collect(),
        };
        for variable in order {
            let exponent = monomial.exponent(variable);
            if exponent == 0 {
                continue;
            }
            let scaled = exponent.min(powers_of_eps);
            powers_of_eps -= scaled;
            result.multiply_by(variable, exponent - scaled);
            result.multiply_by(self.scaled(variable), scaled);
        }
        result.multiply_by(self.epsilon, powers_of_eps);
        result.multiply_by(INVERSE_STEP, monomial.exponent(INVERSE_STEP));
        result
    }
}

/// Returns whether div f is a nonzero constant. The field then contracts or expands all volumes at
/// the same rate, and drifts through rounded constants are of no concern.
fn is_dissipative(field: &Field) -> bool {
    let n = field.dimension();
    let slopes = (0..n).map(|i| field.components[i].numerator().derivative(field.symbols.state(i)));
    let divergence = slopes.fold(Polynomial::zero(), |sum, slope| &sum + &slope);
    field.denominators().all(Polynomial::is_one)
        && !divergence.is_zero()
        && !field.symbols.has_state(&divergence)
}

/// Returns all rotations of the list of states, as orders in which states are multiplied by ε.
fn orders(states: &[usize]) -> impl Iterator<Item = Vec<usize>> {
    (0..states.len()).map(|first| [&states[first..], &states[..first]].concat())
}

pub(in crate::plan) fn is_power_of_two(coefficient: &Rational) -> bool {
    coefficient
        .as_small_ratio()
        .is_some_and(|(p, q)| p.unsigned_abs().is_power_of_two() && q.unsigned_abs().is_power_of_two())
}

/// Returns the scalings to try. If the field has parameters, ε multiplies parameters first in one
/// scaling, and states first in the other.
pub(in crate::plan) fn scalings(field: &Field) -> Vec<Scaling> {
    let scaling = |first| Scaling::new(field, first);
    if field.symbols.parameters.is_empty() {
        vec![scaling(ScalingPriority::States)]
    } else {
        vec![scaling(ScalingPriority::Parameters), scaling(ScalingPriority::States)]
    }
}

/// Returns p/εᵏ as a polynomial in ε, h = 1/(2ε) and other symbols, where k is `power`.
pub(in crate::plan) fn over_eps(polynomial: &Polynomial, power: u32, epsilon: Variable) -> Polynomial {
    let divided = polynomial.terms().map(|(monomial, coefficient)| {
        let cancelled = monomial.exponent(epsilon).min(power);
        let rest = monomial.div(&Monomial::power(epsilon, cancelled)).expect("it has so many powers of ε");
        let scale = Rational::from(1 << (power - cancelled));
        (rest.mul(&Monomial::power(INVERSE_STEP, power - cancelled)), coefficient * &scale)
    });
    Polynomial::from_terms(divided)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn eps_cancels_as_far_as_a_term_has_it() {
        let [x, y, epsilon] = [0, 1, 2].map(|index| Polynomial::variable(Variable(index)));
        let h = Polynomial::variable(INVERSE_STEP);
        let times = |factor: i64, polynomial: &Polynomial| polynomial.scale(&Rational::from(factor));
        let xy = &x * &y;
        let d =
            &(&Polynomial::one() + &times(2, &(&epsilon * &x))) + &times(3, &(&(&epsilon * &epsilon) * &xy));
        let over_square = &(&times(4, &(&h * &h)) + &times(4, &(&h * &x))) + &times(3, &xy);
        assert_eq!(over_eps(&d, 2, Variable(2)), over_square);
        let over_one = &(&times(2, &h) + &times(2, &x)) + &times(3, &(&epsilon * &xy));
        assert_eq!(over_eps(&d, 1, Variable(2)), over_one);
        assert_eq!(over_eps(&d, 0, Variable(2)), d);
    }
}
