//! Builds quadratic fields ẋ = Q(x, x) + Bx + c from coefficients, and returns coefficients.

use kahan_syntax::rational::Rational;

use crate::field::Field;
use crate::poly::{Monomial, Polynomial};
use crate::subexpressions::FieldWithSubexpressions;
use crate::symbols::{Symbol, Symbols};
use crate::system::System;

/// A coefficient of a field, and the monomial that it multiplies.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coefficient {
    /// The index of the component.
    pub component: usize,
    /// The indices of the states in the monomial: none in a constant term, one in a linear term,
    /// and two in a quadratic term.
    pub states: [Option<usize>; 2],
    /// The index of the parameter in the monomial.
    pub parameter: Option<usize>,
    /// The value of the coefficient.
    pub value: Rational,
}

impl System {
    /// Returns the system with these terms and without claims.
    ///
    /// # Panics
    /// If the index of a component, a state or a parameter does not occur in `symbols`.
    #[must_use]
    pub fn of_coefficients(symbols: Symbols, coefficients: impl IntoIterator<Item = Coefficient>) -> System {
        let mut terms = vec![Vec::new(); symbols.dimension()];
        for Coefficient { component, states, parameter, value } in coefficients {
            let mut monomial = Monomial::one();
            let parameter = parameter.map(Symbol::Parameter);
            for symbol in states.into_iter().flatten().map(Symbol::State).chain(parameter) {
                monomial.multiply_by(symbols.variable(symbol), 1);
            }
            terms[component].push((monomial, value));
        }
        let component = |terms| Polynomial::from_terms(terms).into();
        let field = Field { components: terms.into_iter().map(component).collect(), symbols };
        let kept = FieldWithSubexpressions::of(&field);
        System::of(field, kept)
    }

    /// Returns the coefficients, ordered by component. Returns `None` for fields with a divisor, ε,
    /// or a product of parameters.
    #[must_use]
    pub fn coefficients(&self) -> Option<Vec<Coefficient>> {
        let symbols = &self.field.symbols;
        let mut coefficients = Vec::new();
        for (component, function) in self.field.components.iter().enumerate() {
            for (monomial, value) in function.as_polynomial()?.terms() {
                let (mut states, mut parameter) = (Vec::with_capacity(2), None);
                for &(variable, power) in monomial.powers() {
                    match symbols.symbol(variable) {
                        Symbol::State(state) => states.extend((0..power).map(|_| state)),
                        Symbol::Parameter(k) if power == 1 && parameter.is_none() => parameter = Some(k),
                        _ => return None,
                    }
                }
                let states = [states.first().copied(), states.get(1).copied()];
                coefficients.push(Coefficient { component, states, parameter, value: value.clone() });
            }
        }
        Some(coefficients)
    }
}
