//! Derives the variational field, which extends a field by tangent vectors.
//!
//! For the derivative v = ∂x/∂a by a parameter a, the field ẋ = f(x) is extended by v̇ = f′(x)·v +
//! ∂f/∂a. Polarisation and differentiation commute, so the map becomes x ↦ x̃, v ↦ (∂x̃/∂x)·v +
//! ∂x̃/∂a. For a = ε, the time step changes as well, so f/ε + ∂f/∂ε replaces ∂f/∂a.

use crate::field::Field;
use crate::poly::Polynomial;
use crate::rational_function::RationalFunction;
pub use crate::subexpressions::Sensitivity;
use crate::symbols::Symbols;
use crate::system::System;

impl System {
    /// Returns the system for x and a tangent vector v, without claims. Names of v begin with `d`.
    #[must_use]
    pub fn variational(&self) -> System {
        self.sensitivities(&[Sensitivity::Start])
    }

    /// Returns the system for x and a vector of derivatives for each entry of `by`, without claims.
    /// Names of derivatives begin with `d`. For [`Sensitivity::Epsilon`], a last parameter is
    /// added, which stands for 1/ε.
    #[must_use]
    pub fn sensitivities(&self, by: &[Sensitivity]) -> System {
        let field = &self.field;
        let dimension = field.dimension();
        let symbols = field.symbols.with_tangents(by);
        let renamed = |polynomial: &Polynomial| {
            polynomial.map_variables(|variable| symbols.variable(field.symbols.symbol(variable)))
        };
        let moved = |function: &RationalFunction| function.map(renamed).expect("a divisor is not zero");
        let along = |(vector, by): (usize, Sensitivity), component: &RationalFunction| {
            let slopes = component.numerator().gradient(|variable| field.symbols.is_state(variable));
            let slopes = slopes.into_iter().map(|(state, slope)| {
                let tangent = symbols.state((vector + 1) * dimension + usize::from(state.0));
                &renamed(&slope) * &Polynomial::variable(tangent)
            });
            let slopes: Vec<Polynomial> = slopes.collect();
            let sum = Polynomial::sum_of(slopes.iter().map(|slope| (false, slope)));
            let sum = RationalFunction::new(sum, renamed(component.denominator())).expect("it divides above");
            match by {
                Sensitivity::Start => sum,
                Sensitivity::Parameter(k) => &sum + &moved(&component.derivative(field.symbols.parameter(k))),
                Sensitivity::Epsilon => {
                    let eps = field.symbols.epsilon();
                    let slope = &RationalFunction::variable(eps) * &component.derivative(eps);
                    let inverse = symbols.parameter(symbols.parameters.len() - 1);
                    &sum + &(&moved(&(component + &slope)) * &RationalFunction::variable(inverse))
                }
            }
        };
        let of_vector = |own: (usize, Sensitivity)| field.components.iter().map(move |one| along(own, one));
        let vectors = by.iter().copied().enumerate().flat_map(of_vector);
        let components = field.components.iter().map(moved).chain(vectors);
        let kept = self.kept.sensitivities(&field.symbols, &symbols, by);
        let field = Field { components: components.collect(), symbols: symbols.clone() };
        System { constants: self.constants.clone(), ..System::of(field, kept) }
    }
}

impl Symbols {
    fn with_tangents(&self, by: &[Sensitivity]) -> Symbols {
        let (mut states, mut parameters) = (self.states.clone(), self.parameters.clone());
        for state in by.iter().flat_map(|_| &self.states) {
            let mut name = format!("d{state}");
            while states.contains(&name) || parameters.contains(&name) {
                name.insert(0, 'd');
            }
            states.push(name);
        }
        if by.contains(&Sensitivity::Epsilon) {
            let mut name = "inverse_eps".to_owned();
            while states.contains(&name) || parameters.contains(&name) {
                name.push('_');
            }
            parameters.push(name);
        }
        Symbols { states, parameters }
    }
}

#[cfg(test)]
mod tests {
    use kahan_syntax::lexer::lex;

    use crate::render::{Notation, Text};

    #[test]
    fn tangents_are_carried_by_the_derivative() {
        let text = "xdot = a*x*dx + x^2/b; dxdot = (x - 3)/b;";
        let system = crate::read(&lex(text).tokens).system().expect("a system").variational();
        let symbols = &system.field.symbols;
        assert_eq!(symbols.states, ["x", "dx", "ddx", "dddx"]);
        let lines = system.field.components.iter().map(|component| {
            let [above, below] =
                [component.numerator(), component.denominator()].map(|of| Text.polynomial(symbols, of));
            format!("({above})/({below})")
        });
        assert_eq!(
            lines.collect::<Vec<_>>(),
            ["(x^2 + a*b*x*dx)/(b)", "(-3 + x)/(b)", "(2*x*ddx + a*b*x*dddx + a*b*dx*ddx)/(b)", "(ddx)/(b)"]
        );
    }
}
